// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the functions for many pairs of polygons share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "batch.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "task.hpp"

namespace gcv::capi {

// The shape of a polygon that pairs consist of, such as its outer ring.
template <class Shape>
using ShapeOf = std::shared_ptr<const Shape> (gcv_polygon::*)() const;

// Many pairs as the caller passes them, for sums or for no-fit polygons.
template <class Shape>
struct CallersPairs {
  const gcv_polygon* const* a;
  ShapeOf<Shape> shape_of_a;
  const gcv_polygon* const* b;
  ShapeOf<Shape> shape_of_b;
  const double* references;  // of no-fit polygons
  std::size_t count;
  bool are_no_fits;

  [[nodiscard]] PairNames names() const {
    return are_no_fits ? PairNames{"fixed", "moving", "reference"} : PairNames{"a", "b", ""};
  }
  void require_all() const {
    require(a, names().a);
    require(b, names().b);
    require_count(count, sizeof(Point), "count");
    if (are_no_fits) {
      require(references, "references");
    }
  }

  // A polygon that is NULL has no shape.
  [[nodiscard]] std::vector<SumPair<Shape>> read() const {
    const auto shape = [](const gcv_polygon* polygon, ShapeOf<Shape> shape_of) {
      return polygon == nullptr ? nullptr : (polygon->*shape_of)();
    };
    std::vector<SumPair<Shape>> pairs(count);
    for (std::size_t k = 0; k < count; ++k) {
      pairs[k] = {shape(a[k], shape_of_a), shape(b[k], shape_of_b), {0, 0}};
      if (are_no_fits) {
        pairs[k].shift = {references[2 * k], references[2 * k + 1]};
      }
    }
    return pairs;
  }
};

// The body of a function for many pairs. run(pairs, options, task, handles) computes the handles
// and gives the report. The caller gets them once all pairs were tried.
template <class Shape, class Handle, class Run>
void give_many(const CallersPairs<Shape>& pairs, const gcv_options* options, Handle** out,
               gcv_status* statuses, Run run) {
  if (pairs.count == 0) {
    return;
  }
  pairs.require_all();
  require(out, "out");
  require(statuses, "statuses");
  const gcv_options known = read_options(options);
  Task task(1, known.progress, known.progress_context);
  std::vector<std::unique_ptr<Handle>> handles(pairs.count);
  const BatchReport report = run(pairs.read(), known, task, handles);
  if (report.first_failure) {
    static_cast<void>(record(*report.first_failure));
  }
  std::transform(handles.begin(), handles.end(), out,
                 [](std::unique_ptr<Handle>& handle) { return handle.release(); });
  std::transform(report.statuses.begin(), report.statuses.end(), statuses,
                 [](Status status) { return static_cast<gcv_status>(status); });
}

}  // namespace gcv::capi

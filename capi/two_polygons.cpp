// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about two polygons: gcv_relation.
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "error.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "parallel.hpp"
#include "polygon_pair.hpp"
#include "relation.hpp"
#include "task.hpp"

namespace {

using gcv::Error;
using gcv::PlacedPair;
using gcv::Point;
using gcv::PolygonPair;
using gcv::Status;
using gcv::Tally;
using gcv::Task;
using gcv::capi::guarded;
using gcv::capi::read_options;
using gcv::capi::require;
using gcv::capi::threads_of;

// `count` vectors of the caller: x0 y0 x1 y1 ...
class Vectors {
 public:
  // Throws Error: not_finite, with the name and the number of the vector.
  Vectors(const double* xy, std::size_t count, const char* name) : xy_(xy) {
    for (std::size_t k = 0; k < count; ++k) {
      const Point p = (*this)[k];
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        throw Error(Status::not_finite, "%s: number %zu is (%g, %g), not finite", name, k, p.x,
                    p.y);
      }
    }
  }
  // With 0 in place of -0.
  Point operator[](std::size_t k) const { return {xy_[2 * k] + 0.0, xy_[2 * k + 1] + 0.0}; }

 private:
  const double* xy_;
};

// Writes answer(k, tally) to out[k] for each k below `count`, once all are known.
template <class Answer, class Result>
void give_answers(std::size_t count, const gcv_options& options, Result* out, Answer answer) {
  constexpr std::size_t block = 128;
  constexpr std::size_t few = 8;  // that need no memory of their own
  Task task(threads_of(options), options.progress, options.progress_context);
  task.begin(count);
  boost::container::small_vector<Result, few> results(count);
  gcv::for_each_in_parallel(
      (count + block - 1) / block, task.threads(),
      [&](std::size_t number) {
        Tally tally;
        const std::size_t first = number * block;
        const std::size_t end = std::min(count, first + block);
        for (std::size_t k = first; k < end; ++k) {
          results[k] = answer(k, tally);
        }
        task.advance(end - first);
      },
      [&] { task.watch(); });
  task.finish();
  std::copy(results.begin(), results.end(), out);
}

}  // namespace

gcv_status gcv_relation(const gcv_polygon* a, const gcv_polygon* b, const double* translations,
                        size_t count, const gcv_options* options, int8_t* out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    const gcv_options known = read_options(options);
    if (count == 0) {
      return;
    }
    require(translations, "translations");
    require(out, "out");
    const Vectors moves(translations, count, "translations");
    const PolygonPair pair(*a->polygon, *b->polygon);
    give_answers(count, known, out, [&](std::size_t k, Tally& tally) {
      return static_cast<std::int8_t>(relation(PlacedPair(pair, moves[k]), tally));
    });
  });
}

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The sums of many pairs of polygons, the pairs shared out over threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "boundary.hpp"
#include "error.hpp"
#include "minkowski_region.hpp"
#include "minkowski_sum.hpp"
#include "polygon.hpp"
#include "task.hpp"

namespace gcv {

// The two operands of a sum, and what is added to it. Outer faces are of two boundaries, regions of
// two polygons. A pair fails if an operand is null, or if the shift is not finite.
template <class Shape>
struct SumPair {
  std::shared_ptr<const Shape> a;
  std::shared_ptr<const Shape> b;
  Point shift;
};

// What the operands and the shift of all pairs are called in messages.
struct PairNames {
  const char* a;
  const char* b;
  const char* shift;
};

// Takes the result of a pair, given by its number: once for each pair that succeeds, from the
// thread that computed it. Where it throws, the pair fails.
template <class Result>
using TakeResult = std::function<void(std::size_t pair, Result&& result)>;

// What became of the pairs.
struct BatchReport {
  std::vector<Status> statuses;
  std::optional<Error> first_failure;  // of the smallest pair that failed; the message names it
};

// The outer faces of a + b + shift for all pairs. Each polygon is simplified once. Each pair is
// computed on one thread, which is what the task is to allow. Throws Error: cancelled.
BatchReport minkowski_sums(const std::vector<SumPair<Boundary>>& pairs, const PairNames& names,
                           const SumOptions& options, unsigned threads, Task& task,
                           const TakeResult<OuterFace>& take);

// The regions, likewise. Each pair simplifies its polygons.
BatchReport minkowski_sum_regions(const std::vector<SumPair<Polygon>>& pairs,
                                  const PairNames& names, const RegionOptions& options,
                                  unsigned threads, Task& task, const TakeResult<Region>& take);

}  // namespace gcv

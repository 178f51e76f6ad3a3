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
#include "minkowski_sum.hpp"
#include "task.hpp"

namespace gcv {

// The two operands of a sum. A polygon that is null makes its pair fail.
struct OperandPair {
  std::shared_ptr<const Boundary> a;
  std::shared_ptr<const Boundary> b;
};

// Takes the outer face of a pair, given by its number: once for each pair that succeeds, from the
// thread that computed it. Where it throws, the pair fails.
using TakeOuterFace = std::function<void(std::size_t pair, OuterFace&& face)>;

// What became of the pairs.
struct BatchReport {
  std::vector<Status> statuses;
  std::optional<Error> first_failure;  // of the smallest pair that failed; the message names it
};

// The outer faces of a + b for all pairs. Each polygon is simplified once. Each pair is computed
// on one thread, which is what the task is to allow. Throws Error: cancelled.
BatchReport minkowski_sums(const std::vector<OperandPair>& pairs, const SumOptions& options,
                           unsigned threads, Task& task, const TakeOuterFace& take);

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "boundary_trial.hpp"

#include "exact_region.hpp"

namespace gcv {

std::uint64_t first_long_search(const Operands& operands) {
  return 2 * estimated_cover_steps(operands.a, operands.b);
}

// It may take less than is estimated.
BoundaryTrial::BoundaryTrial(const Operands& operands)
    : next_(estimated_cover_steps(operands.a, operands.b) / 4) {}

std::int32_t BoundaryTrial::Attempt::report(void* context, std::uint64_t /*done*/,
                                            std::uint64_t /*all*/) {
  Attempt& attempt = *static_cast<Attempt*>(context);
  attempt.task.poll();
  attempt.is_given_up = attempt.reports_left == 0;
  --attempt.reports_left;
  return attempt.is_given_up ? 1 : 0;
}

}  // namespace gcv

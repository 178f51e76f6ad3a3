// SPDX-License-Identifier: LGPL-3.0-or-later
#include "task.hpp"

#include <algorithm>

#include "error.hpp"

namespace gcv {

void Task::advance(std::uint64_t steps) {
  const std::uint64_t done = done_ += steps;
  if (std::this_thread::get_id() == caller_ && done - reported_ >= portion) {
    reported_ = done;
    tell(estimate_);
  } else if (cancelled_) {
    tell(estimate_);
  }
}

void Task::tell(std::uint64_t estimate) {
  const std::uint64_t done = done_;
  if (!cancelled_ && report_ != nullptr && report_(context_, done, std::max(done, estimate)) != 0) {
    cancelled_ = true;
  }
  if (cancelled_) {
    throw Error(Status::cancelled, "the caller's progress function ended the computation");
  }
}

}  // namespace gcv

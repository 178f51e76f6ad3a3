// SPDX-License-Identifier: LGPL-3.0-or-later
#include "task.hpp"

#include <algorithm>
#include <cassert>

#include "error.hpp"

namespace gcv {

void Task::begin(std::uint64_t estimate) {
  estimate_ = estimate;
  tell(estimate_);
  check();
}

void Task::advance(std::uint64_t steps) {
  done_ += steps;
  if (std::this_thread::get_id() == caller_) {
    watch();
  }
  check();
}

void Task::watch() {
  if (done_ - reported_ >= steps_a_report_) {
    tell(estimate_);
  }
}

void Task::finish() {
  tell(done_);
  check();
}

void Task::tell(std::uint64_t estimate) {
  assert(std::this_thread::get_id() == caller_);
  reported_ = done_;
  if (!cancelled_ && report_ != nullptr &&
      report_(context_, reported_, std::max(reported_, estimate)) != 0) {
    cancelled_ = true;
  }
}

void Task::check() const {
  if (cancelled_) {
    throw Error(Status::cancelled, "the caller's progress function ended the computation");
  }
}

}  // namespace gcv

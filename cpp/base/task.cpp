// SPDX-License-Identifier: LGPL-3.0-or-later
#include "task.hpp"

#include <algorithm>
#include <cassert>

#include "error.hpp"

namespace gcv {

thread_local Task* CurrentTask::current_ = nullptr;

void Pace::poll() {
  if (Task* const task = CurrentTask::get()) {
    task->poll();
  }
}

void Task::begin(std::uint64_t estimate, std::uint64_t parts) {
  estimate_ = estimate;
  parts_ = parts;
  tell(estimate_);
  check();
}

void Task::advance(std::uint64_t steps, std::uint64_t parts) {
  if (std::this_thread::get_id() == caller_) {
    own_done_ += steps;
    own_parts_ += parts;
    watch();
  } else {
    others_done_ += steps;
    others_parts_ += parts;
  }
  check();
}

void Task::poll() {
  if (std::this_thread::get_id() == caller_) {
    tell(estimate());
  }
  check();
}

void Task::watch() {
  if (done() - reported_ >= steps_a_report_) {
    tell(estimate());
  }
}

// Few parts say little. Until the last report the end is not reached.
std::uint64_t Task::estimate() const {
  const std::uint64_t steps = done();
  const std::uint64_t parts = own_parts_ + others_parts_;
  std::uint64_t estimate = estimate_;
  if (parts_ > 0 && parts > parts_ / 32) {
    estimate = static_cast<std::uint64_t>(static_cast<double>(steps) * static_cast<double>(parts_) /
                                          static_cast<double>(parts));
  }
  const bool is_left = parts_ > 0 ? steps < estimate : steps <= estimate;
  return is_left ? estimate : steps + steps / 16 + 1;
}

void Task::finish() {
  tell(done());
  check();
}

void Task::tell(std::uint64_t estimate) {
  assert(std::this_thread::get_id() == caller_);
  reported_ = done();
  if (report_ == nullptr || cancelled_) {
    return;
  }
  // What the caller asks the library in between is no part of this task.
  const CurrentTask none(nullptr);
  if (report_(context_, reported_, std::max(reported_, estimate)) != 0) {
    cancelled_ = true;
  }
}

void Task::check() const {
  if (cancelled_) {
    throw Error(Status::cancelled, "the caller's progress function ended the computation");
  }
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One computation as its caller sees it. It holds the number of threads that the computation may
// use. It reports progress to the caller, who may cancel.
//
// What is prepared once for many computations, such as the indices of a polygon, is not told for
// which of them it is made. It polls the current task of its thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <utility>

namespace gcv {

class Task;

// Makes a task, or none, the current one of this thread for as long as it lives.
class CurrentTask {
 public:
  explicit CurrentTask(Task* task) : before_(std::exchange(current_, task)) {}
  CurrentTask(const CurrentTask&) = delete;
  CurrentTask& operator=(const CurrentTask&) = delete;
  ~CurrentTask() { current_ = before_; }

  static Task* get() { return current_; }

 private:
  static thread_local Task* current_;
  Task* before_;
};

class Task {
 public:
  // Gets the number of steps done and an estimate of the number of all steps. The estimate is never
  // below `done`. A result other than 0 cancels.
  using Report = std::int32_t (*)(void* context, std::uint64_t done, std::uint64_t estimate);

  // Work is done, and steps are reported, in portions of this size.
  static constexpr std::uint64_t portion = 2048;

  // A task on one thread that reports nothing. The current task stays what it is.
  Task() : current_(CurrentTask::get()) {}
  // `report` may be null. Only the thread that makes this object calls it, when at least so many
  // steps are done since the last time. It is the current task from now on.
  Task(unsigned threads, Report report, void* context, std::uint64_t steps_a_report = portion)
      : current_(this),
        threads_(threads),
        report_(report),
        context_(context),
        steps_a_report_(steps_a_report) {}

  [[nodiscard]] unsigned threads() const { return threads_; }

  // Counts steps, and parts of the work that these have done. Any thread may call it. Throws Error:
  // cancelled, on every thread once the caller has cancelled.
  void advance(std::uint64_t steps, std::uint64_t parts = 0);

  // Asks the caller whether to go on, where a step takes long. Any thread may call it. Throws
  // Error: cancelled.
  void poll();

  // Reports the steps of other threads. The calling thread calls it while it waits for them.
  void watch();

  // Makes the first report, with an estimate of the number of all steps. Throws Error: cancelled.
  // Where the work has parts of about the same size, the later reports estimate from those that are
  // done.
  void begin(std::uint64_t estimate, std::uint64_t parts = 0);

  // Makes the last report. Throws Error: cancelled.
  void finish();

 private:
  // For the calling thread alone.
  void tell(std::uint64_t estimate);
  [[nodiscard]] std::uint64_t estimate() const;
  [[nodiscard]] std::uint64_t done() const { return own_done_ + others_done_; }
  void check() const;

  CurrentTask current_;
  unsigned threads_ = 1;
  Report report_ = nullptr;
  void* context_ = nullptr;
  std::uint64_t steps_a_report_ = portion;
  std::uint64_t estimate_ = 0;
  std::uint64_t parts_ = 0;
  std::uint64_t reported_ = 0;
  std::thread::id caller_ = std::this_thread::get_id();
  // Steps, and parts of the work that they have done. Small sums show what an atomic addition
  // takes. So the calling thread counts its own apart.
  std::uint64_t own_done_ = 0;
  std::uint64_t own_parts_ = 0;
  std::atomic<std::uint64_t> others_done_{0};
  std::atomic<std::uint64_t> others_parts_{0};
  std::atomic<bool> cancelled_{false};
};

// Polls the current task, if there is one, each time that so many steps are done. A step takes some
// ten nanoseconds, or a few hundred.
class Pace {
 public:
  void step(std::uint64_t steps = 1) {
    done_ += steps;
    if (done_ >= steps_a_poll) {
      done_ = 0;
      poll();
    }
  }

 private:
  static constexpr std::uint64_t steps_a_poll = 1U << 15;
  static void poll();

  std::uint64_t done_ = 0;
};

}  // namespace gcv

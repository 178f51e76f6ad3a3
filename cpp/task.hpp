// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A computation as its caller sees it: how many threads it may use, and how far it is, told
// now and then to the caller, who may end it.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

namespace gcv {

class Task {
 public:
  // Gets the steps done and a guess of all steps, never less. Non-zero cancels.
  using Report = std::int32_t (*)(void* context, std::uint64_t done, std::uint64_t estimate);

  // Steps are counted in portions of this size.
  static constexpr std::uint64_t portion = 2048;

  // On one thread, without reports.
  Task() = default;
  // `report` may be null. It is called from the thread that makes this object alone.
  Task(unsigned threads, Report report, void* context, std::uint64_t estimate)
      : threads_(threads), report_(report), context_(context), estimate_(estimate) {}

  [[nodiscard]] unsigned threads() const { return threads_; }

  // Counts steps, from any thread. Throws Error: cancelled, also where another thread's call
  // found that out.
  void advance(std::uint64_t steps);

  // For the calling thread while it waits for others: reports what they did.
  void watch();

  // The first and the last report. Throws Error: cancelled.
  void begin();
  void finish();

 private:
  void tell(std::uint64_t estimate);
  void check() const;

  unsigned threads_ = 1;
  Report report_ = nullptr;
  void* context_ = nullptr;
  std::uint64_t estimate_ = 0;
  std::uint64_t reported_ = 0;
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<std::uint64_t> done_{0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace gcv

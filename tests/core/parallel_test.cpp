// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the calling thread of a team does when it has no more work.
#include "parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>

#include "error.hpp"
#include "task.hpp"

namespace gcv {
namespace {

bool comes_true(const std::atomic<bool>& flag) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!flag && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return flag;
}

// Two pieces of work. The other thread takes at least one, and calls other(); the calling thread
// gives it the time for that.
template <class Other, class Waiting>
void share_two(const Other& other, const Waiting& waiting) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> taken{false};
  const auto work = [&](std::size_t /*unused*/) {
    if (std::this_thread::get_id() == caller) {
      EXPECT_TRUE(comes_true(taken)) << "no other thread took any work";
    } else if (!taken.exchange(true)) {
      other();
    }
  };
  for_each_in_parallel(2, 2, work, waiting);
}

TEST(Parallel, CallerIsCalledWhileItWaits) {
  std::atomic<bool> called{false};
  const std::thread::id caller = std::this_thread::get_id();
  share_two([&] { EXPECT_TRUE(comes_true(called)); },
            [&] {
              EXPECT_EQ(std::this_thread::get_id(), caller);
              called = true;
            });
  EXPECT_TRUE(called);
}

// Steps of another thread reach the report, which ends that thread's work.
TEST(Parallel, OthersAreReportedAndCancelled) {
  struct Seen {
    std::atomic<bool> reported{false};
    std::thread::id thread;
    std::uint64_t done = 0;
  } seen;
  const auto report = [](void* context, std::uint64_t done, std::uint64_t) -> std::int32_t {
    auto& s = *static_cast<Seen*>(context);
    s.thread = std::this_thread::get_id();
    s.done = done;
    s.reported = true;
    return 1;
  };
  Task task(2, report, &seen);
  bool cancelled = false;
  const auto until_cancelled = [&] {
    task.advance(Task::portion);
    EXPECT_TRUE(comes_true(seen.reported));
    for (int k = 0; k < 10000; ++k) {  // the report has still to return
      task.advance(0);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  try {
    share_two(until_cancelled, [&] { task.watch(); });
  } catch (const Error& error) {
    cancelled = error.status() == Status::cancelled;
  }
  EXPECT_TRUE(cancelled);
  EXPECT_EQ(seen.thread, std::this_thread::get_id());
  EXPECT_EQ(seen.done, Task::portion);
}

}  // namespace
}  // namespace gcv

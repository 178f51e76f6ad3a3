// SPDX-License-Identifier: LGPL-3.0-or-later
#include "parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "task.hpp"

namespace gcv {

namespace {

class Team {
 public:
  Team(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), work_(work), task_(CurrentTask::get()), failed_(count) {}

  // The work of each thread.
  void run() noexcept {
    for (std::size_t k = next_++; k < count_; k = next_++) {
      try {
        work_(k);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (k < failed_) {
          failed_ = k;
          failure_ = std::current_exception();
        }
      }
    }
  }

  // The work of each thread except the calling one.
  void run_beside() noexcept {
    const CurrentTask current(task_);
    run();
    const std::lock_guard<std::mutex> lock(mutex_);
    ++ended_;
    one_ended_.notify_one();
  }

  // Returns when `others` threads have ended run_beside().
  void wait(std::size_t others, const std::function<void()>& waiting) {
    constexpr std::chrono::milliseconds interval(1);
    std::unique_lock<std::mutex> lock(mutex_);
    while (!one_ended_.wait_for(lock, interval, [&] { return ended_ == others; })) {
      lock.unlock();
      waiting();
      lock.lock();
    }
  }

  void rethrow() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  Task* task_;  // of the thread that makes this
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable one_ended_;
  std::size_t ended_ = 0;
  std::size_t failed_;
  std::exception_ptr failure_;
};

}  // namespace

unsigned available_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

void run_on_threads(std::size_t count, unsigned threads,
                    const std::function<void(std::size_t)>& work,
                    const std::function<void()>& waiting) {
  Team team(count, work);
  std::vector<std::thread> others;
  try {
    for (std::size_t k = 1; k < std::min<std::size_t>(threads, count); ++k) {
      others.emplace_back([&team] { team.run_beside(); });
    }
  } catch (const std::exception&) {
    // There are no more threads, or no more memory. The threads that exist do all the work.
  }
  team.run();
  team.wait(others.size(), waiting);
  for (std::thread& other : others) {
    other.join();
  }
  team.rethrow();
}

}  // namespace gcv

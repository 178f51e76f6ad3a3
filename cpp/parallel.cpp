// SPDX-License-Identifier: LGPL-3.0-or-later
#include "parallel.hpp"

#include <algorithm>
#include <mutex>
#include <thread>
#include <vector>

namespace gcv {

namespace {

class Team {
 public:
  Team(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), work_(work), failed_(count) {}

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

  void rethrow() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::size_t failed_;
  std::exception_ptr failure_;
};

}  // namespace

unsigned available_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

void run_on_threads(std::size_t count, unsigned threads,
                    const std::function<void(std::size_t)>& work) {
  Team team(count, work);
  std::vector<std::thread> others;
  try {
    for (std::size_t k = 1; k < std::min<std::size_t>(threads, count); ++k) {
      others.emplace_back([&team] { team.run(); });
    }
  } catch (const std::exception&) {
    // No more threads or no more memory: those that there are do all the work as well.
  }
  team.run();
  for (std::thread& other : others) {
    other.join();
  }
  team.rethrow();
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// When to find the whole boundary of what is free, in place of one search for each of many places.
// How long that takes shows when it is found. So it is begun, and given up where it takes longer
// than the searches would.
#pragma once

#include <atomic>
#include <cstdint>

#include "contributing_vertices.hpp"
#include "error.hpp"
#include "task.hpp"

namespace gcv {

// A search of so many steps is long: as a rule the boundary is found in the same time. It is begun
// then, and if it is given up, a search of four times as many steps. Deep in spiky stars of 4000
// vertices, and in combs of 400, the boundary takes a fifth of the time of one search.
[[nodiscard]] std::uint64_t first_long_search(const Operands& operands);

class BoundaryTrial {
 public:
  // How many steps it may take where a search has taken so many: 10 times the time, for a step of
  // it takes half of that of a search.
  static constexpr std::uint64_t most_for(std::uint64_t steps) { return 20 * steps; }

  explicit BoundaryTrial(const Operands& operands);

  // May it be begun with so many steps to spend? Any thread may ask.
  [[nodiscard]] bool may_begin(std::uint64_t steps) const { return steps >= next_; }

  // Calls find(task) with a task that asks the caller, but tells nothing of its own steps. False
  // if it has taken more than so many steps, and visits of witnesses. Throws Error: as find does.
  template <class Find>
  bool run(std::uint64_t steps, Task& task, Find find) {
    Attempt attempt{task, steps / steps_a_report + 1};
    try {
      Task own(1, &Attempt::report, &attempt, steps_a_report);
      find(own);
    } catch (const Error&) {
      if (!attempt.is_given_up) {
        throw;
      }
      next_ = 4 * steps;
      return false;
    }
    return true;
  }

 private:
  static constexpr std::uint64_t steps_a_report = 1U << 14;

  struct Attempt {
    Task& task;
    std::uint64_t reports_left;
    bool is_given_up = false;

    static std::int32_t report(void* context, std::uint64_t done, std::uint64_t all);
  };

  std::atomic<std::uint64_t> next_;  // with so many steps to spend
};

}  // namespace gcv

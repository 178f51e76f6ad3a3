// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Times of several ways to do the same, taken in turns, so that what else the machine does slows
// all of them down alike.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace gcv::bench {

double median(std::vector<double> values);

class Turns {
 public:
  // Rounds of one batch of each way, until they have taken so many seconds in all; three at
  // least, or one where that takes long.
  explicit Turns(const std::vector<std::function<void()>>& ways, double seconds = 0.3);

  // Of one run: the median of all rounds.
  [[nodiscard]] double milliseconds(std::size_t way) const;
  // The median of the ratios in each round.
  [[nodiscard]] double ratio(std::size_t way, std::size_t to) const;

 private:
  std::vector<std::vector<double>> rounds_;  // seconds of one run of each way, for each round
};

}  // namespace gcv::bench

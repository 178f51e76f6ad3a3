// SPDX-License-Identifier: LGPL-3.0-or-later
#include "turns.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace gcv::bench {

namespace {

constexpr double batch_seconds = 0.002;
constexpr double long_round_seconds = 0.5;
constexpr std::size_t fewest_rounds = 3;
constexpr std::size_t most_rounds = 101;

// Of this thread on its processor, whatever others have had of it.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds_of(const std::function<void()>& way, int runs) {
  const double begin = processor_seconds();
  for (int k = 0; k < runs; ++k) {
    way();
  }
  return (processor_seconds() - begin) / runs;
}

int runs_of_batch(double seconds) {
  return std::max(1, static_cast<int>(std::ceil(batch_seconds / seconds)));
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Turns::Turns(const std::vector<std::function<void()>>& ways, double seconds) {
  // The first round warms everything up, and tells how large batches have to be.
  std::vector<double> first;
  double spent = 0;
  for (const auto& way : ways) {
    first.push_back(seconds_of(way, 1));
    spent += first.back();
  }
  if (spent > long_round_seconds) {
    rounds_ = {first};
    return;
  }
  for (spent = 0;
       rounds_.size() < fewest_rounds || (spent < seconds && rounds_.size() < most_rounds);) {
    std::vector<double> round(ways.size());
    for (std::size_t k = 0; k < ways.size(); ++k) {
      // To and fro: no way always comes right after the same other one.
      const std::size_t way = rounds_.size() % 2 == 0 ? k : ways.size() - 1 - k;
      const int runs = runs_of_batch(first[way]);
      round[way] = seconds_of(ways[way], runs);
      spent += runs * round[way];
    }
    rounds_.push_back(round);
  }
}

double Turns::milliseconds(std::size_t way) const {
  std::vector<double> times;
  for (const auto& round : rounds_) {
    times.push_back(1000 * round[way]);
  }
  return median(times);
}

double Turns::ratio(std::size_t way, std::size_t to) const {
  std::vector<double> ratios;
  for (const auto& round : rounds_) {
    ratios.push_back(round[way] / round[to]);
  }
  return median(ratios);
}

}  // namespace gcv::bench

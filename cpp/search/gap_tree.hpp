// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "double_double.hpp"

namespace gcv {

// The difference of two doubles, exactly: its nearest double, and what that is off by. So the
// lexicographic order is that of the differences.
struct Gap {
  double hi;
  double lo;

  static Gap between(double from, double to) {
    const DoubleDouble number = two_sum(to, -from);
    return {number.hi, number.lo};
  }
  static Gap infinite() { return {infinity, 0}; }

  friend bool operator>(const Gap& p, const Gap& q) {
    return p.hi > q.hi || (p.hi == q.hi && p.lo > q.lo);
  }
};

// Finds the next gap in a row that is larger than a given one, in O(log n): a tree of maxima.
class GapTree {
 public:
  GapTree() = default;
  // The last gap is infinite.
  explicit GapTree(const std::vector<Gap>& gaps) {
    while (leaves_ < gaps.size()) {
      leaves_ *= 2;
    }
    most_.assign(2 * leaves_, Gap::infinite());
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      most_[leaves_ + k] = gaps[k];
    }
    for (std::size_t k = leaves_ - 1; k > 0; --k) {
      most_[k] = most_[2 * k] > most_[2 * k + 1] ? most_[2 * k] : most_[2 * k + 1];
    }
  }

  // The number of the first gap from the k-th on that is larger.
  [[nodiscard]] std::size_t first_above(std::size_t k, const Gap& gap) const {
    std::size_t node = leaves_ + k;
    while (!(most_[node] > gap)) {  // up to a subtree further on that has one
      while (node % 2 != 0) {
        node /= 2;
      }
      ++node;
    }
    while (node < leaves_) {
      node = most_[2 * node] > gap ? 2 * node : 2 * node + 1;
    }
    return node - leaves_;
  }

 private:
  std::size_t leaves_ = 1;
  std::vector<Gap> most_;  // of node 1, the root, and all others: those of k are 2k and 2k + 1
};

}  // namespace gcv

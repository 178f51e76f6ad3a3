// SPDX-License-Identifier: LGPL-3.0-or-later
#include "shortcuts.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "predicates.hpp"

namespace gcv {

Shortcuts::Shortcuts(const Boundary& ring, double tolerance, Rounding rounding)
    : ring_(ring),
      scaled_(ring.vertices),
      rounding_(rounding),
      allowed_at_first_(std::min(scaled_.scaled(tolerance), scaled_.extent())),
      allowed_(ring.size(), allowed_at_first_),
      corners_(three_corners()) {}

// Vertices that no segment replaces. So a triangle stays, however large the tolerance is, unless
// the triangle is too thin for doubles. The first one is there again as the last.
std::vector<Index> Shortcuts::three_corners() const {
  const Index far = ring_.lexicographic_max;
  Index widest = 0;
  double width = 0;
  for (Index i = 1; i < ring_.size(); ++i) {
    const double w =
        std::abs(cross(difference(scaled_[far], scaled_[0]), difference(scaled_[i], scaled_[0])));
    if (i != far && (widest == 0 || w > width)) {
      width = w;
      widest = i;
    }
  }
  return {0, std::min(far, widest), std::max(far, widest), ring_.size()};
}

NewBoundary Shortcuts::boundary() const {
  NewBoundary boundary;
  for (std::size_t k = 0; k + 1 < corners_.size(); ++k) {
    for (Index i = corners_[k]; i < corners_[k + 1];) {
      const Index j = end_of_chain(i, corners_[k + 1]);
      if (rounding_ == Rounding::nearest) {
        boundary.push_back(segment(i, j));
      } else {
        append_hull(i, j, boundary);
      }
      i = j;
    }
  }
  return boundary;
}

// A vertex j up to `limit` such that a segment can replace the chain from i to j. Steps double
// until one fails, then they halve: so each vertex is measured O(log n) times.
Index Shortcuts::end_of_chain(Index i, Index limit) const {
  Index good = i + 1;
  Index bad = limit + 1;
  while (good < limit && bad > limit) {
    const Index next = std::min(limit, good + (good - i));
    (fits(i, next) ? good : bad) = next;
  }
  while (bad - good > 1 && good < limit) {
    const Index middle = good + (bad - good) / 2;
    (fits(i, middle) ? good : bad) = middle;
  }
  return good;
}

// Is the chain near enough to the segment between its ends? Outward, the hull replaces the chain.
// The hull is as far out as the chain is, and has to be near the innermost point of the chain. Half
// of the tolerance is kept, about, for edges over dents and for caps.
bool Shortcuts::fits(Index i, Index j) const {
  double left = 0;
  double right = 0;
  double allowed = allowed_[i];
  for (Index k = i + 1; k < j; ++k) {
    allowed = std::min(allowed, allowed_[k]);
    const DistanceBound d = distance_bound(scaled_[k], scaled_[i], scaled_[j]);
    double& side = d.is_left ? left : right;
    side = std::max(side, d.bound);
    const double needed =
        rounding_ == Rounding::nearest ? std::max(left, right) : 2 * (left + right);
    if (!(needed <= allowed)) {
      return false;
    }
  }
  return true;
}

NewVertex Shortcuts::segment(Index i, Index j) const {
  assert(i < j && j <= ring_.size());
  double error = 0;
  for (Index k = i + 1; k < j; ++k) {
    error = std::max(error, distance_bound(scaled_[k], scaled_[i], scaled_[j]).bound);
  }
  return {vertex(i), i, i, error, *std::min_element(allowed_.data() + i, allowed_.data() + j)};
}

NewVertex Shortcuts::joined(const NewVertex& a, const NewVertex& b, Index end) const {
  const double height = distance_bound(scaled_[b.first], scaled_[a.first], scaled_[end]).bound;
  const double error =
      (std::max(a.error, b.error) + height) * (1 + std::numeric_limits<double>::epsilon());
  const double allowed = std::min(a.allowed, b.allowed);
  return error <= allowed ? NewVertex{a.point, a.first, a.first, error, allowed}
                          : segment(a.first, end);
}

// The outer hull of the chain from i to j, without j.
void Shortcuts::append_hull(Index i, Index j, NewBoundary& boundary) const {
  std::vector<Index> hull{i};
  Tally tally;
  for (Index k = i + 1; k <= j; ++k) {
    while (hull.size() > 1 &&
           orientation(vertex(hull[hull.size() - 2]), vertex(hull.back()), vertex(k), tally) <= 0) {
      hull.pop_back();
    }
    hull.push_back(k);
  }
  for (std::size_t h = 0; h + 1 < hull.size(); ++h) {
    append_hull_edge(hull[h], hull[h + 1], boundary);
  }
}

// The segment from i to j. Or the chain itself, if it is not all on the left of the segment or is
// too far from it: a chain that turns round can have such a hull.
void Shortcuts::append_hull_edge(Index i, Index j, NewBoundary& boundary) const {
  const NewVertex with_segment = segment(i, j);
  Tally tally;
  bool stands = with_segment.error <= with_segment.allowed;
  for (Index k = i + 1; stands && k < j; ++k) {
    stands = orientation(vertex(i), vertex(j), vertex(k), tally) >= 0;
  }
  if (stands) {
    boundary.push_back(with_segment);
    return;
  }
  for (Index k = i; k < j; ++k) {
    boundary.push_back(segment(k, k + 1));
  }
}

void Shortcuts::cut_tolerance(const NewBoundary& boundary, const std::vector<Index>& edges,
                              bool at_once) {
  const double least = at_once ? HUGE_VAL : allowed_at_first_ / 100;
  std::vector<std::uint8_t> is_cut(allowed_.size());
  for (const Index edge : edges) {
    const Index end = edge + 1 == boundary.size() ? ring_.size() : boundary[edge + 1].last;
    std::fill(is_cut.data() + boundary[edge].first, is_cut.data() + end, std::uint8_t{1});
  }
  for (std::size_t k = 0; k < allowed_.size(); ++k) {
    if (is_cut[k] != 0) {
      allowed_[k] = allowed_[k] / 4 < least ? 0 : allowed_[k] / 4;
    }
  }
}

}  // namespace gcv

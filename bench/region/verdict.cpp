// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verdict.hpp"

#include <algorithm>
#include <limits>

namespace gcv::bench {

namespace {

using invariants::Exact;
using invariants::Rational;

constexpr std::size_t most_lines = 24;

// Lines between the heights of vertices that follow each other.
std::vector<Rational> lines_through(const invariants::Ring& ring) {
  std::vector<Rational> heights;
  for (const Exact& p : ring) {
    heights.push_back(p.y);
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::vector<Rational> lines;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    lines.push_back((heights[k] + heights[k + 1]) / 2);
  }
  std::vector<Rational> chosen;
  for (const std::size_t k : invariants::sample(lines.size(), most_lines)) {
    chosen.push_back(lines[k]);
  }
  return chosen;
}

// Where a line without vertices crosses the ring, from left to right.
std::vector<Rational> crossings(const invariants::Ring& ring, const Rational& y) {
  std::vector<Rational> xs;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Exact& p = ring[k];
    const Exact& q = invariants::next(ring, k);
    if ((p.y < y) != (q.y < y)) {
      xs.push_back(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x));
    }
  }
  std::sort(xs.begin(), xs.end());
  return xs;
}

Rational squared_distance(const invariants::Ring& ring, const Exact& x) {
  Rational least = invariants::squared_distance(ring.back(), ring.front(), x);
  for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
    least = std::min(least, invariants::squared_distance(ring[k], ring[k + 1], x));
  }
  return least;
}

bool is_on_fit(const std::vector<ExactFit>& fits, const Exact& x) {
  return std::any_of(fits.begin(), fits.end(), [&](const ExactFit& fit) {
    return invariants::on_segment(fit.from, fit.to, x);
  });
}

}  // namespace

Exact point_well_inside(const invariants::Ring& ring) {
  Exact best = ring.front();
  Rational most = -1;
  for (const Rational& y : lines_through(ring)) {
    const std::vector<Rational> xs = crossings(ring, y);
    for (std::size_t k = 0; k + 1 < xs.size(); k += 2) {
      const Exact x{(xs[k] + xs[k + 1]) / 2, y};
      const Rational distance = squared_distance(ring, x);
      if (distance > most) {
        most = distance;
        best = x;
      }
    }
  }
  return best;
}

bool is_covered(const ExactWhole& whole, const Exact& x) {
  const auto outer = std::count_if(
      whole.outer.begin(), whole.outer.end(),
      [&](const invariants::Ring& ring) { return invariants::location(ring, x) > 0; });
  const auto holes = std::count_if(
      whole.holes.begin(), whole.holes.end(),
      [&](const invariants::Ring& ring) { return invariants::location(ring, x) >= 0; });
  return outer > holes;
}

FreePoints free_points(const ExactRegion& region) {
  FreePoints points;
  for (const invariants::Ring& hole : region.whole.holes) {
    points.in_holes.push_back(point_well_inside(hole));
  }
  for (const ExactFit& fit : region.fits) {
    points.of_fits.push_back({(fit.from.x + fit.to.x) / 2, (fit.from.y + fit.to.y) / 2});
  }
  return points;
}

Verdict verdict_of(const ExactWhole& answer, const ExactRegion& truth) {
  Verdict verdict;
  const FreePoints points = free_points(truth);
  for (const Exact& x : points.in_holes) {
    verdict.holes_lost += is_covered(answer, x) ? 1 : 0;
  }
  for (const Exact& x : points.of_fits) {
    verdict.fits_lost += is_covered(answer, x) ? 1 : 0;
  }
  return verdict;
}

std::vector<Exact> points_in_false_holes(const ExactWhole& answer, const ExactRegion& truth) {
  std::vector<Exact> points;
  for (const invariants::Ring& given : answer.holes) {
    const invariants::Ring hole = invariants::without_repetitions(given);
    if (hole.size() < 3 || invariants::twice_area(hole) == 0) {
      continue;
    }
    const Exact x = point_well_inside(hole);
    if (is_covered(truth.whole, x) && !is_on_fit(truth.fits, x) && !is_covered(answer, x)) {
      points.push_back(x);
    }
  }
  return points;
}

}  // namespace gcv::bench

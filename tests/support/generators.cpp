// SPDX-License-Identifier: LGPL-3.0-or-later
#include "generators.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <utility>

#include "predicates.hpp"
#include "simplicity.hpp"

namespace gcv::test {

namespace {

bool has_area(const Ring& ring) {
  Tally tally;
  return std::any_of(ring.begin() + 2, ring.end(),
                     [&](const Point& p) { return orientation(ring[0], ring[1], p, tally) != 0; });
}

bool has_spike(const Ring& ring) {
  Tally tally;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& p = ring[k];
    const Point& q = ring[(k + 1) % ring.size()];
    const Point& r = ring[(k + 2) % ring.size()];
    const double dot = (q.x - p.x) * (r.x - q.x) + (q.y - p.y) * (r.y - q.y);
    if (dot < 0 && orientation(p, q, r, tally) == 0) {
      return true;
    }
  }
  return false;
}

bool usable(const Ring& ring) { return has_area(ring) && !has_spike(ring) && !find_conflict(ring); }

}  // namespace

int uniform(Random& random, int low, int high) {
  const auto count = static_cast<std::uint64_t>(high - low) + 1;
  return low + static_cast<int>(random() % count);
}

Ring random_small_integer_polygon(Random& random, int vertices, int extent) {
  while (true) {
    std::set<std::pair<int, int>> places;
    while (static_cast<int>(places.size()) < vertices) {
      places.emplace(uniform(random, 0, extent), uniform(random, 0, extent));
    }
    Ring ring;
    for (const auto& [x, y] : places) {
      ring.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
    std::shuffle(ring.begin(), ring.end(), random);
    // Turning round the part between two edges that meet shortens the ring: it becomes
    // simple, or is given up.
    for (int tries = 0; tries < 10 * vertices; ++tries) {
      if (usable(ring)) {
        return ring;
      }
      const auto conflict = find_conflict(ring);
      if (!conflict) {
        break;
      }
      std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(conflict->first) + 1,
                   ring.begin() + static_cast<std::ptrdiff_t>(conflict->second) + 1);
    }
  }
}

Ring random_histogram(Random& random, int columns, int extent) {
  const bool ragged_base = uniform(random, 0, 1) == 1;
  Ring top;
  Ring base;
  int x = 0;
  for (int k = 0; k < columns; ++k) {
    const auto high = static_cast<double>(uniform(random, 1, extent));
    const auto low = static_cast<double>(ragged_base ? -uniform(random, 0, extent) : 0);
    const auto x0 = static_cast<double>(x);
    x += uniform(random, 1, 3);
    const auto x1 = static_cast<double>(x);
    top.insert(top.end(), {{x0, high}, {x1, high}});
    base.insert(base.end(), {{x0, low}, {x1, low}});
  }
  Ring ring = base;
  ring.insert(ring.end(), top.rbegin(), top.rend());
  return ring;
}

Ring random_spiky_star(Random& random, int vertices) {
  Ring ring;
  for (int k = 0; k < vertices; ++k) {
    const double jitter = uniform(random, 0, 999) / 1000.0;
    const double angle = 2 * std::numbers::pi * (k + 0.9 * jitter) / vertices;
    const double radius = (k % 2 == 0 ? 50 : 10) + uniform(random, 0, 1000) / 50.0;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

Ring block_with_slits(int slits, double width, double slant) {
  const double right = 5.0 * slits + 5;
  Ring ring{{0, 0}, {right, 0}, {right, 8}};
  for (int k = slits; k > 0; --k) {
    const double x = 4 * k + k / 7.0;
    ring.insert(ring.end(), {{x + width, 8}, {x + slant + width, 2}, {x + slant, 2}, {x, 8}});
  }
  ring.push_back({0, 8});
  return ring;
}

Ring negated(Ring ring) {
  for (Point& p : ring) {
    p = {0.0 - p.x, 0.0 - p.y};
  }
  return ring;
}

}  // namespace gcv::test

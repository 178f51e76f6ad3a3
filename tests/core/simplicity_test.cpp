// SPDX-License-Identifier: LGPL-3.0-or-later
#include "simplicity.hpp"

#include <gtest/gtest.h>

#include "generators.hpp"
#include "numbers.hpp"
#include "predicates.hpp"
#include "reference.hpp"

namespace gcv {
namespace {

using test::Random;
using test::Ring;

// Do the closed segments pq and rs have a point in common?
bool segments_meet(const Point& p, const Point& q, const Point& r, const Point& s) {
  Tally tally;
  const int a = orientation(p, q, r, tally);
  const int b = orientation(p, q, s, tally);
  const int c = orientation(r, s, p, tally);
  const int d = orientation(r, s, q, tally);
  if (a == 0 && b == 0) {
    return std::max(std::min(p.x, q.x), std::min(r.x, s.x)) <=
               std::min(std::max(p.x, q.x), std::max(r.x, s.x)) &&
           std::max(std::min(p.y, q.y), std::min(r.y, s.y)) <=
               std::min(std::max(p.y, q.y), std::max(r.y, s.y));
  }
  return a * b <= 0 && c * d <= 0;
}

bool conflicting(const Ring& ring, std::size_t i, std::size_t j) {
  const std::size_t n = ring.size();
  const Point& p = ring[i];
  const Point& q = ring[(i + 1) % n];
  const Point& r = ring[j];
  const Point& s = ring[(j + 1) % n];
  if ((i + 1) % n == j || (j + 1) % n == i) {  // neighbours: only where they overlap
    Tally tally;
    const Point& common = (i + 1) % n == j ? q : p;
    const Point& before = (i + 1) % n == j ? p : r;
    const Point& behind = (i + 1) % n == j ? s : q;
    return orientation(before, common, behind, tally) == 0 &&
           (common.x - before.x) * (behind.x - common.x) +
                   (common.y - before.y) * (behind.y - common.y) <
               0;
  }
  return segments_meet(p, q, r, s);
}

bool simple_by_all_pairs(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = i + 1; j < ring.size(); ++j) {
      if (conflicting(ring, i, j)) {
        return false;
      }
    }
  }
  return true;
}

bool has_repetition(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] == ring[(i + 1) % ring.size()]) {
      return true;
    }
  }
  return false;
}

TEST(Simplicity, AgreesWithAllPairsOnRandomRings) {
  Random random(11);
  int simple = 0;
  int not_simple = 0;
  for (int k = 0; k < 60000; ++k) {
    Ring ring;
    const int n = test::uniform(random, 3, 9);
    const int extent = test::uniform(random, 2, 9);
    for (int i = 0; i < n; ++i) {
      ring.push_back({static_cast<double>(test::uniform(random, 0, extent)),
                      static_cast<double>(test::uniform(random, 0, extent))});
    }
    if (has_repetition(ring)) {
      continue;
    }
    const bool expected = simple_by_all_pairs(ring);
    (expected ? simple : not_simple)++;
    const auto conflict = find_conflict(ring);
    ASSERT_EQ(!conflict, expected);
    if (conflict) {
      const bool same_start = ring[conflict->first] == ring[conflict->second];
      ASSERT_TRUE(same_start || conflicting(ring, conflict->first, conflict->second))
          << conflict->first << " " << conflict->second;
    }
  }
  EXPECT_GT(simple, 1000);
  EXPECT_GT(not_simple, 1000);
}

// A closed walk on a small grid, with long chains to the left, to the right, up and down.
Ring random_chains(Random& random) {
  Ring ring{{0, 0}};
  for (int chains = test::uniform(random, 2, 6); chains > 0; --chains) {
    const bool by_x = test::uniform(random, 0, 1) == 0;
    const int sign = test::uniform(random, 0, 1) == 0 ? 1 : -1;
    for (int edges = test::uniform(random, 1, 40); edges > 0; --edges) {
      const int along = sign * test::uniform(random, 0, 2);
      const int across = test::uniform(random, -2, 2);
      const Point& p = ring.back();
      const Point q{p.x + (by_x ? along : across), p.y + (by_x ? across : along)};
      if (!(q == p)) {
        ring.push_back(q);
      }
    }
  }
  while (ring.size() > 1 && ring.back() == ring.front()) {
    ring.pop_back();
  }
  return ring;
}

TEST(Simplicity, FindsAllConflictsOfLongChains) {
  Random random(12);
  std::size_t conflicts = 0;
  for (int k = 0; k < 3000; ++k) {
    const Ring ring = random_chains(random);
    if (ring.size() < 4) {
      continue;
    }
    std::vector<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      for (std::size_t j = i + 1; j < ring.size(); ++j) {
        if (conflicting(ring, i, j)) {
          expected.emplace_back(i, j);
        }
      }
    }
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (const Conflict& conflict : find_all_conflicts(ring)) {
      found.emplace_back(conflict.first, conflict.second);
    }
    ASSERT_EQ(found, expected);
    conflicts += found.size();
  }
  EXPECT_GT(conflicts, 50000U);
}

TEST(Simplicity, AgreesWithCgal) {
  Random random(12);
  for (int k = 0; k < 3000; ++k) {
    Ring ring = test::random_spiky_star(random, 3 + k % 30);
    if (k % 2 == 0) {  // put one vertex somewhere else
      ring[static_cast<std::size_t>(k) % ring.size()] = {test::uniform(random, -60, 60) / 1.0,
                                                         test::uniform(random, -60, 60) / 1.0};
    }
    if (!has_repetition(ring)) {
      ASSERT_EQ(!find_conflict(ring), reference::is_simple(ring));
    }
  }
}

TEST(Simplicity, LongZigzagIsFast) {
  Ring ring;
  const int n = 200000;
  for (int k = 0; k < n; ++k) {
    ring.push_back({k + (k % 2 == 0 ? 0.0 : 1e6), static_cast<double>(k)});
  }
  ring.push_back({-1e7, static_cast<double>(n)});
  EXPECT_FALSE(find_conflict(ring));
}

}  // namespace
}  // namespace gcv

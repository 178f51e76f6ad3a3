// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "distance.hpp"
#include "pair_search.hpp"
#include "placed_box.hpp"

namespace gcv {

namespace {

// The relation of two solids, if they are no further than a distance from each other.
std::optional<Relation> relation_within(const Solid& a, const Boundary& b, const Point& position,
                                        double distance, Tally& tally) {
  const PolygonPair pair(a.boundary, b);
  return relation_within(PlacedPair(pair, a.position, position), distance, tally);
}

// Puts pairs in order: by a with a count of each, where these are dense, then by b.
std::vector<ScenePair> sorted(std::vector<ScenePair> pairs) {
  if (pairs.empty()) {
    return pairs;
  }
  const auto [first, last] = std::minmax_element(
      pairs.begin(), pairs.end(), [](const ScenePair& p, const ScenePair& q) { return p.a < q.a; });
  const Id low = first->a;
  const Id range = last->a - low;
  if (range > 4 * pairs.size()) {
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }
  const auto place = [low](const ScenePair& pair) {
    return static_cast<std::size_t>(pair.a - low);
  };
  // Of each a. First their counts, then their starts, then their ends.
  std::vector<std::size_t> ends(place(*last) + 1, 0);
  for (const ScenePair& pair : pairs) {
    ++ends[place(pair)];
  }
  std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), std::size_t{0});
  std::vector<ScenePair> all(pairs.size());
  for (const ScenePair& pair : pairs) {
    all[ends[place(pair)]++] = pair;
  }
  std::size_t start = 0;
  for (const std::size_t end : ends) {
    std::sort(all.begin() + static_cast<std::ptrdiff_t>(start),
              all.begin() + static_cast<std::ptrdiff_t>(end));
    start = end;
  }
  return all;
}

// The pairs of an earlier list that are both unchanged, and others, in order.
std::vector<ScenePair> merged(const std::vector<ScenePair>& old, const Unchanged& unchanged,
                              const std::vector<ScenePair>& others) {
  std::vector<ScenePair> all;
  all.reserve(old.size() + others.size());
  auto other = others.begin();
  Id a = 0;
  bool has_a = false;  // is that one unchanged?
  for (const ScenePair& pair : old) {
    if (pair.a != a) {
      a = pair.a;
      has_a = unchanged.has(a);
    }
    if (has_a && unchanged.has(pair.b)) {
      for (; other != others.end() && *other < pair; ++other) {
        all.push_back(*other);
      }
      all.push_back(pair);
    }
  }
  all.insert(all.end(), other, others.end());
  return all;
}

}  // namespace

std::vector<ScenePair> near_solids(const Scene& scene, const Query& query, const Boundary& moving,
                                   const Point& position, double distance, Task& task) {
  std::vector<Solid> solids;
  if (const std::optional<Solid> container = scene.container();
      container && query.admits_container()) {
    solids.push_back(*container);
  }
  std::vector<std::uint32_t> slots;
  any_near(scene, query, widened_outwards(moved_outwards(moving.bounds, position), distance),
           [&](std::uint32_t slot) {
             slots.push_back(slot);
             return false;
           });
  std::sort(slots.begin(), slots.end());
  for (const std::uint32_t slot : slots) {
    solids.push_back(scene.solid(slot));
  }
  std::vector<std::optional<Relation>> relations(solids.size());
  task.begin(solids.size());
  for_each_in_parallel(
      solids.size(), task.threads(),
      [&](std::size_t k) {
        Tally tally;
        relations[k] = relation_within(solids[k], moving, position, distance, tally);
        task.advance(1);
      },
      [&] { task.watch(); });
  task.finish();
  std::vector<ScenePair> pairs;
  for (std::size_t k = 0; k < solids.size(); ++k) {
    if (relations[k]) {
      pairs.push_back({solids[k].id, 0, *relations[k]});
    }
  }
  return pairs;
}

PairList near_pairs(const Scene& scene, const Query& query, double distance,
                    const PairList* previous, Task& task) {
  PairList list{Snapshot(scene, query), distance, {}};
  const bool is_useful =
      previous != nullptr && previous->distance == distance && previous->snapshot.query == query;
  const Unchanged unchanged =
      is_useful ? Unchanged(scene, query, previous->snapshot) : Unchanged(scene);
  list.pairs =
      PairSearch(scene, query, unchanged, distance)
          .run<ScenePair>(task, [&](std::vector<ScenePair>& found, const Solid& a, const Solid& b) {
            Tally tally;
            if (const auto relation = relation_within(a, b.boundary, b.position, distance, tally)) {
              found.push_back({a.id, b.id, *relation});
            }
          });
  list.pairs = sorted(std::move(list.pairs));
  if (is_useful) {
    list.pairs = merged(previous->pairs, unchanged, list.pairs);
  }
  return list;
}

}  // namespace gcv

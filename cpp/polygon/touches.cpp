// SPDX-License-Identifier: LGPL-3.0-or-later
#include "touches.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "box.hpp"
#include "overlapping_pairs.hpp"
#include "predicates.hpp"
#include "ring_sweep.hpp"
#include "tally.hpp"

namespace gcv {

namespace {

class TouchSearch : public RingVisitor {
 public:
  explicit TouchSearch(Index size) : on_edges(size) {}

  std::vector<std::vector<Index>> on_edges;  // vertices of other rings on the inside of each edge
  std::vector<Index> shared;                 // vertices with others in the same point

  void pass(const Place& at) override {
    if (at.through != none) {
      std::vector<Index>& on = on_edges[at.through];
      on.insert(on.end(), at.vertices.begin(), at.vertices.end());
    }
    if (at.vertices.size() > 1) {
      shared.insert(shared.end(), at.vertices.begin(), at.vertices.end());
    }
  }
  void meet(Index /*below*/, Index /*above*/) override {}
};

// Do a few tests in a bounding volume hierarchy show that no ring touches another? They take a
// fraction of the time of the sweep.
bool are_soon_seen_apart(const PointVector& points, const RingLayout& layout) {
  constexpr std::uint64_t pairs_per_edge = 8;
  const Index n = layout.size();
  std::vector<Box> boxes(n);
  for (Index i = 0; i < n; ++i) {
    boxes[i] = box_of(points[i], points[layout.next(i)]);
  }
  Tally tally;
  const auto is_on = [&](Index edge, Index vertex) {
    const Point& p = points[vertex];
    return !are_apart(boxes[edge], box_of(p, p)) &&
           orientation(points[edge], points[layout.next(edge)], p, tally) == 0;
  };
  return OverlappingPairs(boxes).visit_some(pairs_per_edge * n, [&](std::size_t e, std::size_t f) {
    const auto i = static_cast<Index>(e);
    const auto j = static_cast<Index>(f);
    return layout.ring_of(i) == layout.ring_of(j) ||
           !(is_on(i, j) || is_on(i, layout.next(j)) || is_on(j, i) || is_on(j, layout.next(i)));
  });
}

}  // namespace

Touches::Touches(const PointVector& points, const RingLayout& layout) : size_(layout.size()) {
  if (layout.ring_count() == 1 || are_soon_seen_apart(points, layout)) {
    return;
  }
  const Index n = layout.size();
  TouchSearch search(n);
  Tally tally;
  sweep_over(points, layout, search, tally);
  const std::vector<std::vector<Index>>& on_edges = search.on_edges;

  std::vector<Index> vertices = std::move(search.shared);
  for (const std::vector<Index>& on : on_edges) {
    vertices.insert(vertices.end(), on.begin(), on.end());
  }
  if (vertices.empty()) {
    return;
  }
  const auto place = [&](Index i) { return points[i]; };
  std::sort(vertices.begin(), vertices.end(), [&](Index i, Index j) {
    return place(i) == place(j) ? i < j : lexicographically_less(place(i), place(j));
  });
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  at_.assign(n, none);
  on_.resize(n);
  for (const Index vertex : vertices) {
    if (all_.empty() || !(place(all_.back().vertices.front()) == place(vertex))) {
      all_.emplace_back();
    }
    Touch& touch = all_.back();
    touch.vertices.push_back(vertex);
    touch.leaving.push_back(vertex);
    touch.arriving.push_back(layout.previous(vertex));
    at_[vertex] = static_cast<Index>(all_.size() - 1);
  }
  for (Index edge = 0; edge < n; ++edge) {
    std::vector<Index>& on = on_[edge];
    for (const Index vertex : on_edges[edge]) {
      on.push_back(all_[at_[vertex]].vertices.front());
    }
    const Point& from = place(edge);
    const bool is_forwards = lexicographically_less(from, place(layout.next(edge)));
    std::sort(on.begin(), on.end(), [&](Index i, Index j) {
      return is_forwards ? lexicographically_less(place(i), place(j))
                         : lexicographically_less(place(j), place(i));
    });
    on.erase(std::unique(on.begin(), on.end()), on.end());
    for (const Index vertex : on) {
      Touch& touch = all_[at_[vertex]];
      touch.leaving.push_back(edge);
      touch.arriving.push_back(edge);
    }
  }
}

void Touches::add(const Touches& others, Index first) {
  if (others.empty()) {
    return;
  }
  if (empty()) {
    at_.assign(size_, none);
    on_.resize(size_);
  }
  const auto moved = [first](std::vector<Index> numbers) {
    for (Index& number : numbers) {
      number += first;
    }
    return numbers;
  };
  const auto known = static_cast<Index>(all_.size());
  for (const Touch& touch : others.all_) {
    all_.push_back({moved(touch.vertices), moved(touch.leaving), moved(touch.arriving)});
  }
  for (Index i = 0; i < others.size_; ++i) {
    at_[first + i] = others.at_[i] == none ? none : known + others.at_[i];
    on_[first + i] = moved(others.on_[i]);
  }
}

}  // namespace gcv

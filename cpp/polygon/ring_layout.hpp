// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How the vertices of several closed rings lie in one array, one ring after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gcv {

using Index = std::uint32_t;

class RingLayout {
 public:
  RingLayout() = default;
  // Of one ring.
  explicit RingLayout(Index size) : first_end_(size) {}

  // One more ring behind the others.
  void add(Index size) {
    if (ends_.empty()) {
      ends_.push_back(first_end_);
      rings_.assign(first_end_, 0);
    }
    rings_.resize(std::size_t{ends_.back()} + size, ring_count());
    ends_.push_back(ends_.back() + size);
  }

  [[nodiscard]] Index ring_count() const {
    return ends_.empty() ? 1 : static_cast<Index>(ends_.size());
  }
  // Of all vertices.
  [[nodiscard]] Index size() const { return ends_.empty() ? first_end_ : ends_.back(); }

  [[nodiscard]] Index begin(Index ring) const { return ring == 0 ? 0 : end(ring - 1); }
  [[nodiscard]] Index end(Index ring) const { return ends_.empty() ? first_end_ : ends_[ring]; }
  // The ring of a vertex.
  [[nodiscard]] Index ring_of(Index i) const { return i < first_end_ ? 0 : rings_[i]; }
  // Is it the first vertex of a ring behind others?
  [[nodiscard]] bool starts_another(Index i) const {
    return i >= first_end_ && begin(ring_of(i)) == i;
  }

  // The neighbours of a vertex on its ring.
  [[nodiscard]] Index next(Index i) const {
    if (i + 1 < first_end_) {
      return i + 1;
    }
    return i + 1 == first_end_ ? 0 : next_in_later_ring(i);
  }
  [[nodiscard]] Index previous(Index i) const {
    if (i == 0) {
      return first_end_ - 1;
    }
    return i < first_end_ ? i - 1 : previous_in_later_ring(i);
  }

  // Calls visit(i, next) for each vertex and the next one on its ring.
  template <class Visit>
  void for_each_edge(Visit visit) const {
    for (Index ring = 0; ring < ring_count(); ++ring) {
      const Index last = end(ring) - 1;
      for (Index i = begin(ring); i < last; ++i) {
        visit(i, i + 1);
      }
      visit(last, begin(ring));
    }
  }

  friend bool operator==(const RingLayout&, const RingLayout&) = default;

 private:
  // Apart from the code of the first ring, which is that of polygons without holes.
  [[nodiscard, gnu::cold]] Index next_in_later_ring(Index i) const;
  [[nodiscard, gnu::cold]] Index previous_in_later_ring(Index i) const;

  Index first_end_ = 0;
  std::vector<Index> ends_;   // of all rings, where there are several
  std::vector<Index> rings_;  // of all vertices, likewise
};

}  // namespace gcv

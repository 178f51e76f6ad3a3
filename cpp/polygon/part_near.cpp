// SPDX-License-Identifier: LGPL-3.0-or-later
#include "part_near.hpp"

#include <vector>

#include "predicates.hpp"

namespace gcv {

namespace {

// The sides of the box beyond which the point lies, as bits.
unsigned sides_beyond(const Box& box, const Point& p) {
  return (p.x < box.x0 ? 1U : 0U) | (p.x > box.x1 ? 2U : 0U) | (p.y < box.y0 ? 4U : 0U) |
         (p.y > box.y1 ? 8U : 0U);
}

// Appends the vertices of a ring without those between the ends of chains beyond one side of the
// box.
void add_ends_of_chains(const Boundary& boundary, Index ring, const Box& box,
                        std::vector<Index>& ends) {
  const Index begin = boundary.layout.begin(ring);
  const Index end = boundary.layout.end(ring);
  ends.push_back(begin);
  const unsigned first = sides_beyond(box, boundary.vertices[begin]);
  unsigned beyond = first;    // all of the chain from the last of the ends
  unsigned previous = first;  // the vertex before
  const auto step = [&](Index i, unsigned sides) {
    if ((beyond & sides) == 0 && ends.back() != i - 1) {
      ends.push_back(i - 1);
      beyond = previous;
    }
    beyond &= sides;
    if (beyond == 0 && i < end) {
      ends.push_back(i);
      beyond = sides;
    }
    previous = sides;
  };
  for (Index i = begin + 1; i < end; ++i) {
    step(i, sides_beyond(box, boundary.vertices[i]));
  }
  step(end, first);
}

// Some vertices of a boundary, ring after ring.
struct Kept {
  std::vector<Index> vertices;
  std::vector<Index> sizes;  // of the rings
};

// Of rings of a solid with holes all vertices, and of the first ring always some.
Kept kept_near(const Boundary& boundary, const Box& box) {
  const RingLayout& rings = boundary.layout;
  Kept kept;
  for (Index ring = 0; ring < rings.ring_count(); ++ring) {
    const std::size_t before = kept.vertices.size();
    add_ends_of_chains(boundary, ring, box, kept.vertices);
    const bool is_near = kept.vertices.size() - before > 2;
    if (!is_near || boundary.kind == Boundary::Kind::outer) {
      kept.vertices.resize(before);
      for (Index i = rings.begin(ring); (is_near || ring == 0) && i < rings.end(ring); ++i) {
        kept.vertices.push_back(i);
      }
    }
    if (kept.vertices.size() > before) {
      kept.sizes.push_back(static_cast<Index>(kept.vertices.size() - before));
    }
  }
  return kept;
}

}  // namespace

std::optional<Boundary> part_near(const Boundary& boundary, const Box& box) {
  const auto [kept, sizes] = kept_near(boundary, box);
  if (kept.size() > boundary.size() / 2) {
    return std::nullopt;
  }
  Boundary part;
  part.kind = boundary.kind;
  part.layout = RingLayout(sizes.front());
  for (std::size_t ring = 1; ring < sizes.size(); ++ring) {
    part.layout.add(sizes[ring]);
  }
  for (const Index i : kept) {
    part.vertices.push_back(boundary.vertices[i]);
    part.corners.push_back(boundary.corners[i]);
  }
  Tally tally;
  for (Index i = 0; i < part.size(); ++i) {
    const Index next = part.next(i);
    const Index previous = part.previous(i);
    if (kept[next] != boundary.next(kept[i]) || kept[i] != boundary.next(kept[previous])) {
      part.corners[i].convex =
          orientation(part.vertices[previous], part.vertices[i], part.vertices[next], tally) > 0;
    }
  }
  const bool are_solids = part.kind == Boundary::Kind::hole && sizes.size() > 1;
  for (Index ring = 0; are_solids && ring < sizes.size(); ++ring) {
    part.solids.push_back(ring);
  }
  return part;
}

}  // namespace gcv

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

// The vertices of a ring without those between the ends of chains beyond one side of the box.
std::vector<Index> ends_of_chains(const Boundary& boundary, Index ring, const Box& box) {
  const Index begin = boundary.layout.begin(ring);
  const Index end = boundary.layout.end(ring);
  std::vector<Index> ends{begin};
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
  return ends;
}

}  // namespace

std::optional<Boundary> part_near(const Boundary& boundary, const Box& box) {
  const RingLayout& rings = boundary.layout;
  const bool is_complement = boundary.kind == Boundary::Kind::hole;
  std::vector<Index> kept;
  std::vector<Index> sizes;
  for (Index ring = 0; ring < rings.ring_count(); ++ring) {
    std::vector<Index> ends = ends_of_chains(boundary, ring, box);
    const bool is_near = ends.size() > 2;
    if (!is_near && ring > 0) {
      continue;
    }
    if (!is_near || !is_complement) {
      ends.clear();
      for (Index i = rings.begin(ring); i < rings.end(ring); ++i) {
        ends.push_back(i);
      }
    }
    kept.insert(kept.end(), ends.begin(), ends.end());
    sizes.push_back(static_cast<Index>(ends.size()));
    if (kept.size() > boundary.size() / 2) {
      return std::nullopt;
    }
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
  for (Index ring = 0; is_complement && sizes.size() > 1 && ring < sizes.size(); ++ring) {
    part.solids.push_back(ring);
  }
  return part;
}

}  // namespace gcv

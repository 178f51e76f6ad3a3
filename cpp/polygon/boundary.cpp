// SPDX-License-Identifier: LGPL-3.0-or-later
#include "boundary.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "cycle.hpp"
#include "double_double.hpp"
#include "error.hpp"
#include "predicates.hpp"
#include "simplicity.hpp"
#include "task.hpp"

namespace gcv {

namespace {

// Without the closing vertex.
std::size_t open_size(const PointVector& boundary) {
  std::size_t count = boundary.size();
  while (count > 1 && boundary[count - 1] == boundary[0]) {
    --count;
  }
  return count;
}

// A boundary in preparation, without the closing vertex and repeated vertices. Of equal vertices in
// a row it has the last, because the edge behind the last leads on. Each point has the caller's
// number of the vertex and that of the edge behind it. The turn at a point is 1 for left, -1 for
// right, 0 for straight on or back.
struct Chain {
  struct Mark {
    Index vertex_number;
    Index edge_number;
    int turn;
  };
  PointVector points;
  boost::container::small_vector<Mark, 32> marks;

  Chain(PointVector boundary, const CallersNumbers& numbers)
      : points(std::move(boundary)), marks(open_size(points), boost::container::default_init) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const Point p = points[i];
      if (i + 1 < marks.size() && points[i + 1] == p) {
        continue;
      }
      // Adding 0 turns -0 into 0.
      points[kept] = {p.x + 0.0, p.y + 0.0};
      const auto number = static_cast<Index>(numbers.first + i);
      marks[kept++] = numbers.corners.empty() ? Mark{number, number, 0}
                                              : Mark{numbers.corners[i].vertex_number,
                                                     numbers.corners[i].edge_number, 0};
    }
    points.resize(kept);
    marks.resize(kept, boost::container::default_init);
  }
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return cyclic_next(i, size()); }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return cyclic_previous(i, size()); }
};

void check_finite(std::span<const Point> boundary, const CallersNumbers& numbers,
                  const char* name) {
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const Point& p = boundary[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      throw Error(
          Status::not_finite, "%s: the %s coordinate of vertex %zu is %g, not a finite number",
          name, std::isfinite(p.x) ? "y" : "x", numbers.first + i, std::isfinite(p.x) ? p.y : p.x);
    }
  }
}

void find_turns(Chain& chain) {
  Tally tally;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    chain.marks[i].turn = orientation(chain.points[chain.previous(i)], chain.points[i],
                                      chain.points[chain.next(i)], tally);
  }
}

bool all_collinear(const Chain& chain) {
  return std::all_of(chain.marks.begin(), chain.marks.end(),
                     [](const Chain::Mark& mark) { return mark.turn == 0; });
}

// Does the chain turn back at q? The points p, q, r must be collinear, and q must differ from p and
// r.
bool turns_back(const Point& p, const Point& q, const Point& r) {
  return p.x == q.x ? (p.y < q.y) != (q.y < r.y) : (p.x < q.x) != (q.x < r.x);
}

void check_simple(const Chain& chain, const Box& bounds, const char* name) {
  if (is_convex_ring(chain.points, [&](std::size_t i) { return chain.marks[i].turn; })) {
    return;
  }
  const auto conflict = find_conflict(chain.points, bounds);
  if (!conflict) {
    return;
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t before = chain.previous(i);
    const Point& q = chain.points[i];
    if (chain.marks[i].turn == 0 &&
        turns_back(chain.points[before], q, chain.points[chain.next(i)])) {
      throw Error(Status::not_simple,
                  "%s: edges %u and %u overlap: the ring turns back at vertex %u (%.17g, %.17g)",
                  name, chain.marks[before].edge_number, chain.marks[i].edge_number,
                  chain.marks[i].vertex_number, q.x, q.y);
    }
  }
  const Point& p = chain.points[conflict->first];
  const Point& q = chain.points[conflict->second];
  throw Error(Status::not_simple,
              "%s: edges %u and %u meet; they start at (%.17g, %.17g) and (%.17g, %.17g)", name,
              chain.marks[conflict->first].edge_number, chain.marks[conflict->second].edge_number,
              p.x, p.y, q.x, q.y);
}

// Takes the corners of a simple chain, from the lexicographically smallest one. Goes
// counter-clockwise, or clockwise for a hole. If that is against the given direction, the edge
// behind a corner is the edge that led to it. Of the caller's edges on one straight line, the last
// is then the first.
void take_corners(const Chain& chain, Boundary::Kind kind, Boundary& ring) {
  const std::size_t first = lexicographic_min(chain.points);
  const int left = chain.marks[first].turn;  // the turn at a smallest point is never 0
  const bool is_hole = kind == Boundary::Kind::hole;
  const bool forwards = (left > 0) != is_hole;
  const auto n = static_cast<std::size_t>(
      std::count_if(chain.marks.begin(), chain.marks.end(),
                    [](const Chain::Mark& mark) { return mark.turn != 0; }));
  ring.kind = kind;
  ring.layout = RingLayout(static_cast<Index>(n));
  ring.vertices.resize(n);
  ring.corners.resize(n);
  ring.is_convex = true;
  std::size_t corner = 0;
  std::size_t i = first;
  do {
    const std::size_t before = chain.previous(i);
    if (chain.marks[i].turn != 0) {
      const bool is_convex = (chain.marks[i].turn == left) != is_hole;
      ring.vertices[corner] = chain.points[i];
      ring.corners[corner] = {chain.marks[i].vertex_number,
                              chain.marks[forwards ? i : before].edge_number, is_convex};
      ring.is_convex = ring.is_convex && is_convex;
      ++corner;
    }
    i = forwards ? chain.next(i) : before;
  } while (i != first);
}

// Does the ring hold what boundary.hpp promises? Does not test simplicity, which would take longer.
[[maybe_unused]] bool is_normalised(const Boundary& ring) {
  return ring.vertices.size() >= 3 && ring.corners.size() == ring.vertices.size() &&
         ring.lexicographic_min == 0 && lexicographic_min(ring.vertices) == 0 &&
         is_counter_clockwise(ring.vertices) == (ring.kind == Boundary::Kind::outer);
}

}  // namespace

Boundary make_ring(PointVector boundary, const char* name, Boundary::Kind kind,
                   const CallersNumbers& numbers) {
  const std::size_t given = boundary.size();
  if (given > vertex_limit - numbers.first) {
    throw Error(Status::invalid_argument, "%s: %zu vertices are more than %zu", name,
                numbers.first + given, vertex_limit);
  }
  check_finite(boundary, numbers, name);
  Chain chain(std::move(boundary), numbers);
  if (chain.size() < 3) {
    throw Error(Status::degenerate,
                "%s: %zu distinct consecutive vertices of %zu, at least 3 are needed", name,
                chain.size(), given);
  }
  find_turns(chain);
  if (all_collinear(chain)) {
    throw Error(Status::degenerate, "%s: all %zu vertices lie on one line", name, given);
  }
  Boundary ring;
  ring.bounds = box_of(chain.points);
  check_simple(chain, ring.bounds, name);
  take_corners(chain, kind, ring);
  ring.lexicographic_max = static_cast<Index>(first_of(
      ring.vertices, [](const Point& p, const Point& q) { return lexicographically_less(q, p); }));
  assert(is_normalised(ring));
  return ring;
}

const LineDirections& Boundary::line_directions() const {
  return line_directions_.get([this] {
    if (mirror_ == nullptr) {
      return sort_line_directions(vertices, layout, is_convex);
    }
    LineDirections directions = mirror_->line_directions();
    for (LineDirections::Edge& edge : directions.edges) {
      edge.points_up = !edge.points_up;
    }
    return directions;
  });
}

EdgeChain Boundary::relative_chain() const {
  PointVector points(std::size_t{size()} + layout.ring_count());
  std::size_t place = 0;
  for (Index ring = 0; ring < layout.ring_count(); ++ring) {
    for (Index i = layout.begin(ring); i < layout.end(ring); ++i) {
      points[place++] = relative(i);
    }
    points[place++] = relative(layout.begin(ring));
  }
  return {std::move(points), layout};
}

const ChainIndex& Boundary::index() const {
  return index_.get([this] { return build_chain_index(relative_chain()); });
}

const ChainIndex& Boundary::search_index() const {
  const std::optional<ChainIndex>& on_curve =
      index_on_curve_.get([this] { return build_index_on_curve(index(), relative_chain()); });
  return on_curve ? *on_curve : index();
}

const Boundary::CoverIndex& Boundary::cover_index() const {
  return cover_index_.get([this] {
    return CoverIndex{build_chord_tree(relative_chain(), layout),
                      solids.empty() ? Touches(vertices, layout) : touches_of_solids(),
                      solid_boxes()};
  });
}

const ConvexPieces& Boundary::convex_pieces() const {
  if (!positions.empty()) {
    return joined_pieces_;
  }
  if (mirror_ != nullptr) {
    return mirror_->convex_pieces();
  }
  return convex_pieces_.get([this] {
    return kind == Kind::outer && layout.ring_count() == 1 ? find_convex_pieces(vertices)
                                                           : ConvexPieces();
  });
}

Touches Boundary::touches_of_solids() const {
  Touches all(size());
  for (Index solid = 0; solid < solids.size(); ++solid) {
    const Index end = solid_end(solid);
    if (end - solids[solid] > 1) {
      const Index first = layout.begin(solids[solid]);
      RingLayout rings(layout.end(solids[solid]) - first);
      for (Index ring = solids[solid] + 1; ring < end; ++ring) {
        rings.add(layout.end(ring) - layout.begin(ring));
      }
      const Point* const from = vertices.data() + first;
      all.add(Touches(PointVector(from, from + rings.size()), rings), first);
    }
  }
  return all;
}

BoxTree Boundary::solid_boxes() const {
  std::vector<Box> boxes;
  boxes.reserve(solids.size());
  for (const Index ring : solids) {
    Box box = empty_box;
    for (Index i = layout.begin(ring); i < layout.end(ring); ++i) {
      const Point p = relative(i);
      box = hull_of(box, box_of(p, p));
    }
    const bool is_outside = boxes.empty() && kind == Kind::hole;
    boxes.push_back(is_outside ? Box{-infinity, -infinity, infinity, infinity} : box);
  }
  return BoxTree(boxes);
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convex_sums.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "convex_pieces.hpp"
#include "part_boxes.hpp"

namespace gcv {

namespace {

// Sums beyond that are not computed: in large scenes with many pieces they would take more memory
// than all else. In blocks of four half-planes.
constexpr std::size_t half_planes_in_any_case = 1U << 16;
constexpr std::size_t half_planes_a_vertex = 4;

// The vertex that is furthest to the right of a direction. Another one is no error: then a
// half-plane is smaller.
Point furthest_right(const Boundary& boundary, std::span<const Index> piece, const Point& e) {
  Point furthest = boundary.relative(piece.front());
  for (const Index i : piece.subspan(1)) {
    const Point p = boundary.relative(i);
    if (e.x * (p.y - furthest.y) < e.y * (p.x - furthest.x)) {
      furthest = p;
    }
  }
  return furthest;
}

// The parameters of a line in a box.
template <class Range>
Range range_in(const Box& box, const RelativeLine& line) {
  Range range{-1, 2};
  const auto cut = [&](double from, double to, double origin, double d) {
    if (d != 0) {
      const double s = (from - origin) / d;
      const double t = (to - origin) / d;
      range = {std::max(range.from, std::min(s, t)), std::min(range.to, std::max(s, t))};
    }
  };
  cut(box.x0, box.x1, line.origin.x, line.dx);
  cut(box.y0, box.y1, line.origin.y, line.dy);
  return range;
}

}  // namespace

ConvexSums::ConvexSums(const Operands& operands, double slack, CoveredCells& cells)
    : operands_(operands), slack_(slack), cells_(cells) {
  if (operands.a.positions.empty() || operands.a.solids.empty() || !(slack < infinity)) {
    return;
  }
  const ConvexPieces& pieces = operands.b.convex_pieces();
  for (std::size_t k = 0; k < pieces.count(); ++k) {
    boxes_b_.push_back(box_of_piece(operands.b, pieces.piece(k)));
  }
  const Box bounds = operands.relative_bounds();
  parts_b_ = part_boxes(operands.b, static_cast<double>(operands.a.solids.size()) /
                                        (bounds.x1 - bounds.x0) / (bounds.y1 - bounds.y0));
  solids_.resize(operands.a.solids.size());
  most_half_planes_ =
      std::max(half_planes_in_any_case, half_planes_a_vertex * operands.a.vertices.size());
}

// Error bound, with uE as in witness.cpp: p is off by 3 and x by 6, so that x - p is off by 10, and
// e by 3. The roundings of the product are below 5 |e|, those of a parameter below 16 |e|. With the
// size D of the sum, all is below 31 |e| + 3 D. The slack is 64.
ConvexSums::HalfPlane ConvexSums::half_plane(const Point& p, const Point& e, double size) const {
  return {p, e,
          slack_ * (std::abs(e.x) + std::abs(e.y) + size) + std::numeric_limits<double>::min()};
}

ConvexSums::Span ConvexSums::add_half_planes(std::span<const HalfPlane> half_planes) {
  constexpr HalfPlane plane{{0, 0}, {0, 0}, -1};
  const auto first = static_cast<std::uint32_t>(half_planes_.size());
  for (std::size_t k = 0; k < half_planes.size(); k += SimdDouble::width) {
    HalfPlanes& four = half_planes_.emplace_back();
    for (std::size_t lane = 0; lane < SimdDouble::width; ++lane) {
      const HalfPlane& one = k + lane < half_planes.size() ? half_planes[k + lane] : plane;
      four.px[lane] = one.p.x;
      four.py[lane] = one.p.y;
      four.ex[lane] = one.e.x;
      four.ey[lane] = one.e.y;
      four.least[lane] = one.least;
    }
  }
  return {first, static_cast<std::uint32_t>(half_planes_.size())};
}

void ConvexSums::find_half_planes(const Boundary& one, std::span<const Index> piece,
                                  const Boundary& other, std::span<const Index> beside,
                                  double size) {
  Point from = one.relative(piece.back());
  for (const Index i : piece) {
    const Point to = one.relative(i);
    const Point e{to.x - from.x, to.y - from.y};
    const Point furthest = furthest_right(other, beside, e);
    found_.push_back(half_plane({from.x + furthest.x, from.y + furthest.y}, e, size));
    from = to;
  }
}

const ConvexSums::Span& ConvexSums::half_planes_of(Sums& sums, std::uint32_t lane) {
  Span& span = sums.half_planes[lane];
  if (span.first == unknown && half_planes_.size() < most_half_planes_) {
    const auto& [a, b, directions, focus] = operands_;
    const std::span<const Index> piece_a = a.convex_pieces().piece(sums.piece_a[lane]);
    const std::span<const Index> piece_b = b.convex_pieces().piece(sums.piece_b[lane]);
    const double size = extents_of(sums.boxes.box(lane));
    found_.clear();
    find_half_planes(a, piece_a, b, piece_b, size);
    find_half_planes(b, piece_b, a, piece_a, size);
    span = add_half_planes(found_);
  }
  return span;
}

void ConvexSums::add_sum(std::uint32_t count, const Box& box, std::uint32_t piece_a,
                         std::uint32_t piece_b, const Span& half_planes) {
  const std::uint32_t lane = count % SimdDouble::width;
  if (lane == 0) {
    sums_.emplace_back();
  }
  Sums& sums = sums_.back();
  sums.boxes.put(lane, box);
  sums.piece_a[lane] = piece_a;
  sums.piece_b[lane] = piece_b;
  sums.half_planes[lane] = half_planes;
  sums.lanes |= 1U << lane;
}

// Pieces are in the order of their solids, and so of their vertices.
void ConvexSums::add_sums_of_pieces(Index solid) {
  const Boundary& a = operands_.a;
  const ConvexPieces& pieces = a.convex_pieces();
  const Index first = a.layout.begin(a.solids[solid]);
  const Index end = a.layout.end(a.solid_end(solid) - 1);
  const auto from = std::partition_point(
      pieces.ends.begin(), pieces.ends.end(),
      [&](std::size_t piece_end) { return pieces.vertices[piece_end - 1] < first; });
  std::uint32_t count = 0;
  for (auto i = static_cast<std::uint32_t>(from - pieces.ends.begin());
       i < pieces.count() && pieces.piece(i).front() < end; ++i) {
    const Box box = box_of_piece(a, pieces.piece(i));
    for (std::uint32_t j = 0; j < boxes_b_.size(); ++j) {
      add_sum(count++, sum_of(box, boxes_b_[j]), i, j, {});
    }
  }
}

// The half-planes beyond the sides of the bounding box, and all of B.
void ConvexSums::add_what_is_beyond() {
  const Boundary& a = operands_.a;
  const Box hole = box_of(std::span<const Point>(a.relatives).first(a.layout.end(0)));
  const Box b = operands_.b.relative_bounds();
  const Point low{hole.x0 + b.x1, hole.y0 + b.y1};
  const Point high{hole.x1 + b.x0, hole.y1 + b.y0};
  const Box bounds = operands_.relative_bounds();
  const Box outer = widened(bounds, extents_of(bounds));
  std::uint32_t count = 0;
  const auto add = [&](const Box& box, const Point& p, const Point& e) {
    const HalfPlane beyond = half_plane(p, e, 0);
    add_sum(count++, box, 0, 0, add_half_planes({&beyond, 1}));
  };
  add({outer.x0, outer.y0, low.x, outer.y1}, low, {0, 1});
  add({high.x, outer.y0, outer.x1, outer.y1}, high, {0, -1});
  add({outer.x0, outer.y0, outer.x1, low.y}, low, {-1, 0});
  add({outer.x0, high.y, outer.x1, outer.y1}, high, {1, 0});
}

// The largest piece of a polygon is its first one.
void ConvexSums::add_cells(const Span& sums_of_solid) {
  for (std::uint32_t k = sums_of_solid.first; k < sums_of_solid.end; ++k) {
    for_each_lane(sums_[k].lanes, [&](std::uint32_t lane) {
      const std::uint32_t largest_a = sums_[sums_of_solid.first].piece_a[0];
      if (sums_[k].piece_a[lane] != largest_a && sums_[k].piece_b[lane] != 0) {
        return;
      }
      if (const Span& span = half_planes_of(sums_[k], lane); span.first != unknown) {
        cells_.add(std::span(half_planes_).subspan(span.first, span.end - span.first),
                   sums_[k].boxes.box(lane));
      }
    });
  }
}

const ConvexSums::Span& ConvexSums::sums_of(Index solid) {
  Span& span = solids_[solid];
  if (span.first == unknown) {
    span.first = static_cast<std::uint32_t>(sums_.size());
    if (solid == 0 && operands_.a.kind == Boundary::Kind::hole) {
      add_what_is_beyond();
    } else {
      add_sums_of_pieces(solid);
    }
    span.end = static_cast<std::uint32_t>(sums_.size());
    if (!cells_.empty()) {
      add_cells(span);
    }
  }
  return span;
}

template <class Lanes, class Test>
bool ConvexSums::any_of(Index solid, Lanes lanes_of, Test test) {
  const auto [first, end] = sums_of(solid);
  for (std::uint32_t k = first; k < end; ++k) {
    Sums& sums = sums_[k];
    if (any_lane(lanes_of(sums.boxes) & sums.lanes, [&](std::uint32_t lane) {
          const Span& half_planes = half_planes_of(sums, lane);
          return half_planes.first != unknown && test(half_planes, sums.boxes.box(lane));
        })) {
      return true;
    }
  }
  return false;
}

// Of the corners of the box, that counts which is furthest to the right of e.
bool ConvexSums::hold(const Box& box, const Span& half_planes) const {
  for (std::uint32_t n = half_planes.first; n < half_planes.end; ++n) {
    const HalfPlanes& four = half_planes_[n];
    const SimdDouble ex = SimdDouble::load(four.ex);
    const SimdDouble ey = SimdDouble::load(four.ey);
    const SimdDouble x = select(ey > 0, SimdDouble::of(box.x1), SimdDouble::of(box.x0));
    const SimdDouble y = select(ex > 0, SimdDouble::of(box.y0), SimdDouble::of(box.y1));
    const SimdDouble product =
        ex * (y - SimdDouble::load(four.py)) - ey * (x - SimdDouble::load(four.px));
    if ((product > SimdDouble::load(four.least)).bits() != SimdDouble::all) {
      return false;
    }
  }
  return true;
}

bool ConvexSums::hold(const Box& box) {
  if (is_empty()) {
    return false;
  }
  const Box b = operands_.b.relative_bounds();
  return operands_.a.cover_index().solids.any_around(
      {box.x0 - b.x0, box.y0 - b.y0, box.x1 - b.x1, box.y1 - b.y1}, [&](Index solid, const Box&) {
        return any_of(
            solid, [&](const auto& boxes) { return boxes.around(box); },
            [&](const Span& half_planes, const Box&) { return hold(box, half_planes); });
      });
}

ConvexSums::Range ConvexSums::cut(const RelativeLine& line, const Span& half_planes,
                                  const Range& range) const {
  const SimdDouble none = SimdDouble::of(infinity);
  const SimdDouble all = SimdDouble::of(-infinity);
  SimdDouble from = SimdDouble::of(range.from);
  SimdDouble to = SimdDouble::of(range.to);
  for (std::uint32_t n = half_planes.first; n < half_planes.end; ++n) {
    const HalfPlanes& four = half_planes_[n];
    const SimdDouble ex = SimdDouble::load(four.ex);
    const SimdDouble ey = SimdDouble::load(four.ey);
    const SimdDouble x = line.origin.x - SimdDouble::load(four.px);
    const SimdDouble y = line.origin.y - SimdDouble::load(four.py);
    const SimdDouble room = ex * y - ey * x - SimdDouble::load(four.least);
    const SimdDouble loss = line.dx * ey - line.dy * ex;  // of room, along the line
    const SimdDouble t = room * (1 / loss);
    // Without room at the start, the line comes in where it gains some, or never.
    const SimdDouble entry = select(loss < 0, select(room < 0, t, SimdDouble::of(0)), none);
    from = larger(from, select(room > 0, all, entry));
    to = smaller(to, select(loss > 0, t, none));
  }
  double first[SimdDouble::width];
  double last[SimdDouble::width];
  from.store(first);
  to.store(last);
  return {*std::max_element(std::begin(first), std::end(first)),
          *std::min_element(std::begin(last), std::end(last))};
}

// In the box of a sum, x - p is no longer than the bound for errors has it.
double ConvexSums::next_reach(const RelativeLine& line, double t) {
  const Point at = line.at(t);
  const Box place = box_of(at, at);
  double furthest = t;
  const auto go_on = [&](const Span& half_planes, const Box& box) {
    const auto in_box = range_in<Range>(box, line);
    const Range range = in_box.to > furthest ? cut(line, half_planes, in_box) : Range{1, 0};
    if (range.from < t && range.to > furthest) {
      furthest = range.to;
    }
    return false;
  };
  for (const Box& b : parts_b_) {
    operands_.a.cover_index().solids.for_each_near(
        {at.x - b.x1, at.y - b.y1, at.x - b.x0, at.y - b.y0}, [&](Index solid, const Box&) {
          any_of(
              solid, [&](const auto& boxes) { return boxes.around(place); }, go_on);
        });
  }
  return std::min(furthest, 1.0);
}

double ConvexSums::reach(const RelativeLine& line, double t, double least_progress) {
  while (t < 1) {
    const double next = next_reach(line, t);
    if (!(next > t + least_progress) && next < 1) {
      break;
    }
    t = next;
  }
  return t;
}

}  // namespace gcv

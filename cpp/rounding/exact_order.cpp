// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_order.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "exact_coordinates.hpp"
#include "exact_numbers.hpp"
#include "predicates.hpp"
#include "rounding.hpp"
#include "task.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// The number x / w * 2^exponent.
struct Fraction {
  BigInteger x;
  BigInteger w;
  int exponent;
};

int compare(Fraction p, Fraction q) {
  p.x *= q.w;
  q.x *= p.w;
  if (p.exponent > q.exponent) {
    p.x <<= p.exponent - q.exponent;
  } else {
    q.x <<= q.exponent - p.exponent;
  }
  return p.x.compare(q.x);
}

Fraction x_of(const ExactVertex& vertex) {
  auto p = vertex.homogeneous<BigInteger>();
  return {std::move(p.x), std::move(p.w), vertex.grid().exponent()};
}
Fraction y_of(const ExactVertex& vertex) {
  auto p = vertex.homogeneous<BigInteger>();
  return {std::move(p.y), std::move(p.w), vertex.grid().exponent()};
}
Fraction fraction(double x) {
  const Grid grid{Point{x, x}};
  return {grid.integer<BigInteger>(x), BigInteger(1), grid.exponent()};
}

// By the nearest doubles, unless these are equal and one is not exact.
std::optional<int> compare(const RoundedNumber& p, const RoundedNumber& q) {
  if (p.value != q.value || (p.exact && q.exact)) {
    return (p.value > q.value) - (p.value < q.value);
  }
  return std::nullopt;
}

}  // namespace

ExactOrder::Placed ExactOrder::placed(const RingVertex& vertex) const {
  return {vertex, rounded_vertex(a_, b_, vertex, shift_, tally_)};
}

// x or y, if it is a sum of doubles: that of a sum of vertices, x of a crossing with an upright
// edge, y of one with a level edge.
std::optional<ExactOrder::Sum> ExactOrder::sum_of(const RingVertex& v, double Point::*axis) const {
  if (!(shift_ == Point{0, 0})) {
    return std::nullopt;
  }
  if (v.is_sum()) {
    const SumPoint point = point_of(a_, b_, {v.i(), v.j()});
    return Sum{point.a.*axis, point.b.*axis, point.c.*axis};
  }
  for (const EdgeName& edge : {v.arriving(), v.leaving()}) {
    const SumEdge line = coordinates(a_, b_, edge);
    if (line.from.*axis == line.to.*axis) {
      return Sum{line.origin.a.*axis, line.origin.b.*axis, line.origin.c.*axis};
    }
  }
  return std::nullopt;
}

int ExactOrder::compare_exactly(const Placed& p, const Placed& q, double Point::*axis) const {
  const std::optional<Sum> x = sum_of(p.vertex, axis);
  const std::optional<Sum> y = x ? sum_of(q.vertex, axis) : std::nullopt;
  if (y) {
    return compare_sums(x->a, x->b, x->c, y->a, y->b, y->c, tally_);
  }
  ++tally_.rational;
  const auto fraction_of = [&](const Placed& v) {
    const ExactVertex exact(a_, b_, v.vertex, shift_);
    return axis == &Point::x ? x_of(exact) : y_of(exact);
  };
  return gcv::compare(fraction_of(p), fraction_of(q));
}

int ExactOrder::compare(const Placed& p, const Placed& q) const {
  std::optional<int> order = gcv::compare(p.nearest.x, q.nearest.x);
  if (!order) {
    order = compare_exactly(p, q, &Point::x);
  }
  if (*order != 0) {
    return *order;
  }
  order = gcv::compare(p.nearest.y, q.nearest.y);
  return order ? *order : compare_exactly(p, q, &Point::y);
}

int ExactOrder::compare(const Placed& p, const Point& q) const {
  const auto by_fractions = [&](auto coordinate, double x) {
    ++tally_.rational;
    return gcv::compare(coordinate(ExactVertex(a_, b_, p.vertex, shift_)), fraction(x));
  };
  std::optional<int> order = gcv::compare(p.nearest.x, RoundedNumber{q.x, true});
  if (!order) {
    order = by_fractions(x_of, q.x);
  }
  if (*order != 0) {
    return *order;
  }
  order = gcv::compare(p.nearest.y, RoundedNumber{q.y, true});
  return order ? *order : by_fractions(y_of, q.y);
}

Box ExactOrder::box_of_edge(const Placed& p, const Placed& q) {
  const auto near = [](const Placed& v) { return Point{v.nearest.x.value, v.nearest.y.value}; };
  const Box box = box_of(near(p), near(q));
  return {std::nextafter(box.x0, -infinity), std::nextafter(box.y0, -infinity),
          std::nextafter(box.x1, infinity), std::nextafter(box.y1, infinity)};
}

void ExactOrder::sort(std::vector<std::vector<RingVertex>>& rings) const {
  struct Entry {
    Placed first;
    std::vector<RingVertex> ring;
  };
  std::vector<Entry> entries;
  entries.reserve(rings.size());
  Pace pace;
  for (std::vector<RingVertex>& ring : rings) {
    pace.step(16 * std::uint64_t{ring.size()});
    std::size_t smallest = 0;
    Placed best = placed(ring.front());
    for (std::size_t k = 1; k < ring.size(); ++k) {
      const Placed other = placed(ring[k]);
      if (compare(other, best) < 0) {
        smallest = k;
        best = other;
      }
    }
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(smallest), ring.end());
    entries.push_back({best, std::move(ring)});
  }
  const auto is_before = [&](const Entry& p, const Entry& q) {
    pace.step(4);
    int order = compare(p.first, q.first);
    const std::size_t size = std::min(p.ring.size(), q.ring.size());
    for (std::size_t k = 1; order == 0 && k < size; ++k) {
      order = compare(p.ring[k], q.ring[k]);
    }
    return order != 0 ? order < 0 : p.ring.size() < q.ring.size();
  };
  std::sort(entries.begin(), entries.end(), is_before);
  for (std::size_t k = 0; k < rings.size(); ++k) {
    rings[k] = std::move(entries[k].ring);
  }
}

}  // namespace gcv

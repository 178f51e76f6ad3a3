// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_order.hpp"

#include <algorithm>

#include "exact_coordinates.hpp"
#include "exact_numbers.hpp"
#include "rounding.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// The sign of x / w 2^e - y / v 2^f.
int compare_fractions(BigInteger x, const BigInteger& w, int e, BigInteger y, const BigInteger& v,
                      int f) {
  x *= v;
  y *= w;
  if (e > f) {
    x <<= e - f;
  } else {
    y <<= f - e;
  }
  return x.compare(y);
}

}  // namespace

int ExactOrder::compare(const RingVertex& p, const RingVertex& q) const {
  const RoundedVertex near_p = rounded_vertex(operands_.a, operands_.b, p, {0, 0}, tally_);
  const RoundedVertex near_q = rounded_vertex(operands_.a, operands_.b, q, {0, 0}, tally_);
  std::optional<std::pair<ExactVertex, ExactVertex>> exact;
  const auto order = [&](const RoundedNumber& x, const RoundedNumber& y, auto coordinate) {
    if (x.value != y.value || (x.exact && y.exact)) {
      return (x.value > y.value) - (x.value < y.value);
    }
    if (!exact) {
      const auto vertex = [&](const RingVertex& v) {
        return ExactVertex(operands_.a, operands_.b, v, {0, 0});
      };
      exact.emplace(vertex(p), vertex(q));
    }
    ++tally_.rational;
    const auto first = exact->first.homogeneous<BigInteger>();
    const auto second = exact->second.homogeneous<BigInteger>();
    return compare_fractions(first.*coordinate, first.w, exact->first.grid().exponent(),
                             second.*coordinate, second.w, exact->second.grid().exponent());
  };
  const int by_x = order(near_p.x, near_q.x, &HomogeneousPoint<BigInteger>::x);
  return by_x != 0 ? by_x : order(near_p.y, near_q.y, &HomogeneousPoint<BigInteger>::y);
}

Box ExactOrder::box_of_edge(const RingVertex& p, const RingVertex& q) const {
  const auto nearest = [&](const RingVertex& v) {
    const RoundedVertex near = rounded_vertex(operands_.a, operands_.b, v, {0, 0}, tally_);
    return Point{near.x.value, near.y.value};
  };
  const Box box = box_of(nearest(p), nearest(q));
  return {-next_up(-box.x0), -next_up(-box.y0), next_up(box.x1), next_up(box.y1)};
}

bool ExactOrder::is_before(const std::vector<RingVertex>& p,
                           const std::vector<RingVertex>& q) const {
  for (std::size_t k = 0; k < std::min(p.size(), q.size()); ++k) {
    if (const int order = compare(p[k], q[k]); order != 0) {
      return order < 0;
    }
  }
  return p.size() < q.size();
}

void ExactOrder::begin_with_smallest(std::vector<RingVertex>& ring) const {
  const auto smallest = std::min_element(
      ring.begin(), ring.end(),
      [&](const RingVertex& p, const RingVertex& q) { return compare(p, q) < 0; });
  std::rotate(ring.begin(), smallest, ring.end());
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "local_superset.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcv {

namespace {

constexpr std::size_t few = 24;
constexpr std::size_t many = 96;
constexpr std::size_t too_many = 256;

// The mean size of the edges of both polygons.
double mean_edge_size(const Operands& operands) {
  double sum = 0;
  for (const Polygon* polygon : {&operands.a, &operands.b}) {
    for (Index i = 0; i < polygon->size(); ++i) {
      const Point& p = polygon->relative[i];
      const Point& q = polygon->relative[polygon->next(i)];
      sum += std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
    }
  }
  return sum / (static_cast<double>(operands.a.size()) + operands.b.size());
}

constexpr Box nowhere{0, 0, 0, 0};

}  // namespace

LocalSuperset::LocalSuperset(const ImplicitSuperset& superset, double slack)
    : superset_(superset),
      slack_(slack),
      reach_(4 * mean_edge_size(superset.operands())),
      window_(nowhere) {}

double LocalSuperset::tolerance_of(double dx, double dy) const {
  return (std::abs(dx) + std::abs(dy)) * slack_ + std::numeric_limits<double>::min();
}

bool LocalSuperset::gather(const Point& centre) {
  edges_.clear();
  ranks_.clear();
  x0_.clear();
  y0_.clear();
  x1_.clear();
  y1_.clear();
  const double reach = reach_;
  window_ = {centre.x - reach, centre.y - reach, centre.x + reach, centre.y + reach};
  const Box wide{window_.x0 - slack_, window_.y0 - slack_, window_.x1 + slack_,
                 window_.y1 + slack_};
  const Operands& operands = superset_.operands();
  const auto relative = [&](Index i, Index j) {
    const Point& p = operands.a.relative[i];
    const Point& q = operands.b.relative[j];
    return Point{p.x + q.x, p.y + q.y};
  };
  const auto outside = [&](double x0, double x1, double y0, double y1) {
    return x1 < wide.x0 || x0 > wide.x1 || y1 < wide.y0 || y0 > wide.y1;
  };
  superset_.search(
      {0, 2 * operands.directions.half_turn - 1},
      [&](const Box& a, const Box& b) {
        return edges_.size() <= too_many &&
               !outside(a.x0 + b.x0, a.x1 + b.x1, a.y0 + b.y0, a.y1 + b.y1);
      },
      [](const Box&, const Box&) { return 0.0; },
      [&](const PairEdge& e) {
        const bool translated = e.kind == PairEdge::translated;
        const Point p = relative(e.i, e.j);
        const Point q =
            translated ? relative(operands.a.next(e.i), e.j) : relative(e.i, operands.b.next(e.j));
        if (!outside(std::min(p.x, q.x), std::max(p.x, q.x), std::min(p.y, q.y),
                     std::max(p.y, q.y))) {
          edges_.push_back(e);
          ranks_.push_back(operands.rank(e));
          x0_.push_back(p.x);
          y0_.push_back(p.y);
          x1_.push_back(q.x);
          y1_.push_back(q.y);
        }
      });
  if (edges_.size() > too_many) {
    edges_.clear();
    window_ = nowhere;
    reach_ *= 0.25;
    return false;
  }
  if (edges_.size() > many) {
    reach_ *= 0.5;
  } else if (edges_.size() < few) {
    reach_ *= 1.5;
  }
  return true;
}

}  // namespace gcv

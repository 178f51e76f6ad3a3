// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Errors in the frame of the box, with u times the extents of both polygons, uE, as the
// unit. The sum of two line-swept spheres is off by 24 in both coordinates of the plane, so by 34
// here; its radius, since the unit vector is by 24 u too long at most, by 24; an end of a piece or
// of an edge is off by 5, so by 7 here; products and sums add less than 30. All that is below 128,
// which is `tolerance_`: the edges of the box are those that come as near to it, and each of them
// is near where it comes as near to a piece. Its smallest normal double covers underflow.
#include "ahead_cache.hpp"

#include <algorithm>
#include <cmath>

#include "vector.hpp"

namespace gcv {

namespace {

// How far the box goes ahead of the walk and behind it, in ways of its last block of places; and
// how far beyond the sides of that way, in swings: to the left, where the sum is, and to the right.
constexpr double box_ahead = 2;
constexpr double box_behind = 0.05;
constexpr double box_inside = 0.1;
constexpr double box_outside = 1;

constexpr double least_stretch = 0x1p-4;

// What a fill costs beside its search, and what it may cost at most. With a quarter of that, outer
// faces of dense combs in no direction of the axes take three to five times as long.
constexpr std::int64_t layout_cost = 64;
constexpr std::int64_t largest_cost = 65536;

// How many times its price a fill may cost, and how many fills may be saved for.
constexpr std::int64_t most_prices = 4;
constexpr std::int64_t most_saved = 8;

}  // namespace

std::int64_t CostBudget::most() const {
  const std::int64_t affordable = credit_ / share;
  return affordable < price_ ? 0 : std::min({affordable, most_prices * price_, largest_cost});
}

void CostBudget::spend(std::int64_t cost, bool is_filled) {
  spent_ += cost + layout_cost;
  credit_ -= std::min(credit_, share * (cost + layout_cost));
  price_ = is_filled ? std::max(cost + layout_cost, least_price) : 2 * price_;
  credit_ = std::min(credit_, share * most_saved * price_);
}

// The box, for a search in the trees.
class AheadCache::Place {
 public:
  explicit Place(const AheadCache& cache)
      : cache_(cache), bounds_(widened(cache.bounds_, cache.tolerance_)) {
    const auto corner = [&](double x, double y) {
      const Point& unit = cache.unit_;
      return Point{unit.x * x - unit.y * y, unit.y * x + unit.x * y};
    };
    box_ = widened(hull_of(box_of(corner(bounds_.x0, bounds_.y0), corner(bounds_.x1, bounds_.y1)),
                           box_of(corner(bounds_.x0, bounds_.y1), corner(bounds_.x1, bounds_.y0))),
                   cache.tolerance_);
  }

  [[nodiscard]] TreeProduct::Offsets offsets(const Box& box) const {
    return TreeProduct::offsets(box, cache_.unit_.x, cache_.unit_.y);
  }

  void cull(const TreeProduct::Block& block, const TreeProduct::Node& other,
            TreeProduct::Survivors& survivors) const {
    const auto [dx, dy] = cache_.unit_;
    const SweptSphereBlock& spheres = block.spheres;
    const SimdDouble x0 = SimdDouble::load(spheres.x0);
    const SimdDouble y0 = SimdDouble::load(spheres.y0);
    const SimdDouble x1 = SimdDouble::load(spheres.x1);
    const SimdDouble y1 = SimdDouble::load(spheres.y1);
    const SimdDouble radius = SimdDouble::load(spheres.radius);
    const SimdDouble from = dx * y0 - dy * x0;
    const SimdDouble to = dx * y1 - dy * x1;
    const SimdDouble lowest = smaller(from, to) - radius;
    const SimdDouble highest = larger(from, to) + radius;
    lowest.store(survivors.lowest);
    highest.store(survivors.highest);
    const DoubleMask off_sides = (lowest > bounds_.y1 - other.offsets.lowest) |
                                 (highest < bounds_.y0 - other.offsets.highest);
    const SimdDouble start = dx * x0 + dy * y0;
    const SimdDouble end = dx * x1 + dy * y1;
    const double other_start = cache_.in_frame(other.from).x;
    const double other_end = cache_.in_frame(other.to).x;
    const double most = bounds_.x1 - std::min(other_start, other_end) + other.radius;
    const double least = bounds_.x0 - std::max(other_start, other_end) - other.radius;
    const DoubleMask off_ends =
        (smaller(start, end) - radius > most) | (larger(start, end) + radius < least);
    const DoubleMask beyond = block.boxes.apart({box_.x0 - other.box.x1, box_.y0 - other.box.y1,
                                                 box_.x1 - other.box.x0, box_.y1 - other.box.y0});
    survivors.lanes = ~(off_sides | off_ends | beyond).bits() & SimdDouble::all;
  }

 private:
  const AheadCache& cache_;
  Box bounds_;
  Box box_{};
};

bool AheadCache::keep_up(const Point& place, VisitedPairs* met) {
  if (holds(place)) {
    return true;
  }
  if (is_filled_) {
    clear();
  }
  const std::int64_t most = budget_.most();
  if (most == 0 || count_ < 3 * least_places) {
    return false;
  }
  if (lay_out(place)) {
    gather(most, met);
  } else {
    clear();
    budget_.postpone();
  }
  return is_filled_;
}

double AheadCache::room(const Point& place, double dx, double dy) const {
  const Point p = in_frame(place);
  const Point d = in_frame({dx, dy});
  const auto steps = [](double step, double low, double high) {
    return step > 0 ? high / step : step < 0 ? low / step : infinity;
  };
  constexpr double a_bit_less = 1 - 0x1p-10;
  return a_bit_less * std::min(steps(d.x, bounds_.x0 - p.x, bounds_.x1 - p.x),
                               steps(d.y, bounds_.y0 - p.y, bounds_.y1 - p.y));
}

Point AheadCache::mean_place(std::size_t block, std::size_t back) const {
  Point sum{0, 0};
  for (std::size_t k = 0; k < block; ++k) {
    const Point& p = passed(back + k);
    sum = {sum.x + p.x, sum.y + p.y};
  }
  const auto size = static_cast<double>(block);
  return {sum.x / size, sum.y / size};
}

// The walk may swing to and fro, along spikes, by more than it gets ahead. Then the way from mean
// to mean is chance for the most part, and the walk is taken to go across its swing: along the axis
// on which its places spread least.
Point AheadCache::heading(std::size_t block, std::size_t back, const Point& before,
                          const Point& mean) const {
  const Point way{mean.x - before.x, mean.y - before.y};
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t k = 0; k < block; ++k) {
    const Point& p = passed(back + k);
    const double dx = p.x - mean.x;
    const double dy = p.y - mean.y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const auto size = static_cast<double>(block);
  const double half = (xx - yy) / 2;
  const double root = std::sqrt(half * half + xy * xy);
  const double most = (xx + yy) / 2 + root;  // of the squares along any axis
  if (!(most > size * (way.x * way.x + way.y * way.y))) {
    return unit_vector(way);
  }
  const Point swing = half > 0 ? Point{half + root, xy} : Point{xy, root - half};
  const Point across = unit_vector({-swing.y, swing.x});
  const bool is_ahead = across.x * way.x + across.y * way.y >= 0;
  return is_ahead ? across : Point{-across.x, -across.y};
}

// Lays out a box around the place. It turns as the walk has turned from each block of places to the
// next one. It is as wide as the swing of the walk. False where the walk goes nowhere, or where
// numbers overflow.
bool AheadCache::lay_out(const Point& place) {
  const std::size_t block = std::min(count_ / 3, most_places);
  const Point last = mean_place(block, 0);
  const Point middle = mean_place(block, block);
  const Point first = mean_place(block, 2 * block);
  const Point before = heading(block, block, first, middle);
  unit_ = heading(block, 0, middle, last);
  const double length = in_frame({last.x - middle.x, last.y - middle.y}).x;
  double right = 0;
  double left = 0;
  for (std::size_t k = 0; k < block; ++k) {
    const double y = in_frame(passed(k)).y - in_frame(last).y;
    right = std::min(right, y);
    left = std::max(left, y);
  }
  const double swing = left - right;
  const double cosine = before.x * unit_.x + before.y * unit_.y;
  const double sine = before.x * unit_.y - before.y * unit_.x;
  unit_ = {cosine * unit_.x - sine * unit_.y, cosine * unit_.y + sine * unit_.x};
  const double axis = in_frame(last).y;
  const Point p = in_frame(place);
  bounds_ = {p.x - box_behind * length, std::min(axis + right, p.y) - box_outside * swing,
             p.x + stretch_ * box_ahead * length, std::max(axis + left, p.y) + box_inside * swing};
  slab_length_ = (bounds_.x1 - bounds_.x0) / slab_count;
  slabs_per_length_ = 1 / slab_length_;
  constexpr double extents_per_tolerance = 0x1p46;
  return holds(place) && std::isfinite(slabs_per_length_) &&
         std::isfinite(16 * extents_per_tolerance * tolerance_);
}

void AheadCache::gather(std::int64_t most, VisitedPairs* met) {
  Place box(*this);
  std::int64_t pair_visits = 0;
  const std::int64_t node_visits = superset_.search(
      box,
      [&](Index i, Index j) {
        if (++pair_visits <= most / 2) {
          superset_.for_each_edge(i, j, [&](const PairEdge& edge) { add(edge); });
        }
      },
      met, most / 2);
  is_filled_ = node_visits <= most / 2 && pair_visits <= most / 2;
  budget_.spend(node_visits + pair_visits, is_filled_);
  if (is_filled_) {
    stretch_ = std::min(1.25 * stretch_, 1.0);
  } else {
    clear();
    stretch_ = std::max(stretch_ / 2, least_stretch);
  }
}

void AheadCache::clear() {
  is_filled_ = false;
  bounds_ = empty_box;
  for (Slab& slab : slabs_) {
    slab.blocks.clear();
    slab.size = 0;
  }
}

// Of an edge along one axis, the change of the other coordinate is infinite: then its whole box
// is taken.
void AheadCache::add(const PairEdge& edge) {
  const Point from = superset_.operands().relative_start(edge);
  const Point to = superset_.operands().relative_end(edge);
  const Point p = in_frame(from);
  const Point q = in_frame(to);
  const Box box = widened(box_of(p, q), tolerance_);
  if (are_apart(box, bounds_)) {
    return;
  }
  const double dx_by_dy = (q.x - p.x) / (q.y - p.y);
  double x0 = box.x0;
  double x1 = box.x1;
  if (std::isfinite(dx_by_dy)) {
    const double right = p.x + dx_by_dy * (bounds_.y0 - tolerance_ - p.y);
    const double left = p.x + dx_by_dy * (bounds_.y1 + tolerance_ - p.y);
    x0 = std::max(x0, std::min(right, left) - tolerance_);
    x1 = std::min(x1, std::max(right, left) + tolerance_);
  }
  const double dy_by_dx = (q.y - p.y) / (q.x - p.x);
  const int first = slab_of(x0);
  const int last = slab_of(x1);
  for (int k = first; k <= last; ++k) {
    Box part = box;
    if (first < last && std::isfinite(dy_by_dx)) {
      const double start = std::max(bounds_.x0 + k * slab_length_ - tolerance_, x0);
      const double end = std::min(bounds_.x0 + (k + 1) * slab_length_ + tolerance_, x1);
      const double y_start = p.y + dy_by_dx * (start - p.x);
      const double y_end = p.y + dy_by_dx * (end - p.x);
      part.y0 = std::max(box.y0, std::min(y_start, y_end) - tolerance_);
      part.y1 = std::min(box.y1, std::max(y_start, y_end) + tolerance_);
    }
    Slab& slab = slabs_[static_cast<std::size_t>(k)];
    const std::uint32_t lane = slab.size++ % width;
    if (lane == 0) {
      slab.blocks.emplace_back();
      for (std::uint32_t empty = 0; empty < width; ++empty) {
        slab.blocks.back().boxes.put(empty, empty_box);
      }
    }
    Block& block = slab.blocks.back();
    block.boxes.put(lane, part);
    block.segments.put(lane, from, to);
    block.edges[lane] = edge;
  }
}

}  // namespace gcv

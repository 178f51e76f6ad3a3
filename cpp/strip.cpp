// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Errors in the coordinates of the strip, with u times the extents of both polygons, uE, as the
// unit. The sum of two capsules is off by 24 in both coordinates of the plane, so by 34 here; its
// radius, since the unit vector is by 24 u too long at most, by 24; an end of a piece or of an edge
// is off by 5, so by 7 here; products and sums add less than 30. All that is below 128, which is
// `tolerance_`: the edges of a strip are those that come as near to it, and each of them is near
// where it comes as near to a piece. Its smallest normal double covers underflow.
#include "strip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcv {

namespace {

// How far a strip goes ahead of the walk and behind it, in ways of its last block of places, and
// how far beyond the sides of that way, in swings: to the left, where the sum is, and to the right.
constexpr double ahead = 2;
constexpr double behind = 0.05;
constexpr double inside = 0.1;
constexpr double outside = 1;

constexpr double least_stretch = 0x1p-4;

// What a strip costs beside its search, and what it may cost at most.
constexpr std::int64_t layout_cost = 64;
constexpr std::int64_t largest_cost = 16384;

// How many times its price a strip may cost, and how many strips may be saved for.
constexpr std::int64_t most_prices = 4;
constexpr std::int64_t most_saved = 8;

}  // namespace

std::int64_t StripFund::most() const {
  const std::int64_t affordable = credit_ / share;
  return affordable < price_ ? 0 : std::min({affordable, most_prices * price_, largest_cost});
}

void StripFund::spend(std::int64_t cost, bool is_gathered) {
  spent_ += cost + layout_cost;
  credit_ -= std::min(credit_, share * (cost + layout_cost));
  price_ = is_gathered ? std::max(cost + layout_cost, least_price) : 2 * price_;
  credit_ = std::min(credit_, share * most_saved * price_);
}

// A strip as a place to search.
class Strip::Place {
 public:
  explicit Place(const Strip& strip)
      : strip_(strip), bounds_(widened(strip.bounds_, strip.tolerance_)) {
    const auto corner = [&](double x, double y) {
      const Point& unit = strip.unit_;
      return Point{unit.x * x - unit.y * y, unit.y * x + unit.x * y};
    };
    box_ = widened(hull_of(box_of(corner(bounds_.x0, bounds_.y0), corner(bounds_.x1, bounds_.y1)),
                           box_of(corner(bounds_.x0, bounds_.y1), corner(bounds_.x1, bounds_.y0))),
                   strip.tolerance_);
  }

  [[nodiscard]] ImplicitSuperset::Offsets offsets(const Box& box) const {
    return ImplicitSuperset::offsets(box, strip_.unit_.x, strip_.unit_.y);
  }

  void look(const ImplicitSuperset::Block& block, const ImplicitSuperset::Node& other,
            ImplicitSuperset::Look& look) const {
    const auto [dx, dy] = strip_.unit_;
    const CapsuleBlock& capsules = block.capsules;
    const DoubleLanes x0 = DoubleLanes::load(capsules.x0);
    const DoubleLanes y0 = DoubleLanes::load(capsules.y0);
    const DoubleLanes x1 = DoubleLanes::load(capsules.x1);
    const DoubleLanes y1 = DoubleLanes::load(capsules.y1);
    const DoubleLanes radius = DoubleLanes::load(capsules.radius);
    const DoubleLanes from = dx * y0 - dy * x0;
    const DoubleLanes to = dx * y1 - dy * x1;
    const DoubleLanes lowest = smaller(from, to) - radius;
    const DoubleLanes highest = larger(from, to) + radius;
    lowest.store(look.lowest);
    highest.store(look.highest);
    const DoubleMask off_sides = (lowest > bounds_.y1 - other.offsets.lowest) |
                                 (highest < bounds_.y0 - other.offsets.highest);
    const DoubleLanes start = dx * x0 + dy * y0;
    const DoubleLanes end = dx * x1 + dy * y1;
    const double other_start = strip_.in_strip(other.from).x;
    const double other_end = strip_.in_strip(other.to).x;
    const double most = bounds_.x1 - std::min(other_start, other_end) + other.radius;
    const double least = bounds_.x0 - std::max(other_start, other_end) - other.radius;
    const DoubleMask off_ends =
        (smaller(start, end) - radius > most) | (larger(start, end) + radius < least);
    const DoubleMask beyond = block.boxes.apart({box_.x0 - other.box.x1, box_.y0 - other.box.y1,
                                                 box_.x1 - other.box.x0, box_.y1 - other.box.y0});
    look.lanes = ~(off_sides | off_ends | beyond).bits() & DoubleLanes::all;
  }

 private:
  const Strip& strip_;
  Box bounds_;
  Box box_{};
};

bool Strip::keep_up(const Point& place, PairsMet* met) {
  if (holds(place)) {
    return true;
  }
  if (is_gathered_) {
    clear();
  }
  const std::int64_t most = fund_.most();
  if (most == 0 || count_ < 3 * least_places) {
    return false;
  }
  if (lay_out(place)) {
    gather(most, met);
  } else {
    clear();
    fund_.postpone();
  }
  return is_gathered_;
}

double Strip::room(const Point& place, double dx, double dy) const {
  const Point p = in_strip(place);
  const Point d = in_strip({dx, dy});
  const auto steps = [](double step, double low, double high) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return step > 0 ? high / step : step < 0 ? low / step : infinity;
  };
  constexpr double a_bit_less = 1 - 0x1p-10;
  return a_bit_less * std::min(steps(d.x, bounds_.x0 - p.x, bounds_.x1 - p.x),
                               steps(d.y, bounds_.y0 - p.y, bounds_.y1 - p.y));
}

Point Strip::mean_place(std::size_t block, std::size_t back) const {
  Point sum{0, 0};
  for (std::size_t k = 0; k < block; ++k) {
    const Point& p = passed(back + k);
    sum = {sum.x + p.x, sum.y + p.y};
  }
  const auto size = static_cast<double>(block);
  return {sum.x / size, sum.y / size};
}

// Lays out a strip around the place: it turns as the walk has turned from each block of places to
// the next one, and is as wide as its swing. False where the walk goes nowhere, or where numbers
// overflow.
bool Strip::lay_out(const Point& place) {
  const std::size_t block = std::min(count_ / 3, most_places);
  const Point last = mean_place(block, 0);
  const Point middle = mean_place(block, block);
  const Point first = mean_place(block, 2 * block);
  const Point before = unit_vector({middle.x - first.x, middle.y - first.y});
  const Point way{last.x - middle.x, last.y - middle.y};
  unit_ = unit_vector(way);
  const double length = in_strip(way).x;
  double right = 0;
  double left = 0;
  for (std::size_t k = 0; k < block; ++k) {
    const double y = in_strip(passed(k)).y - in_strip(last).y;
    right = std::min(right, y);
    left = std::max(left, y);
  }
  const double swing = left - right;
  const double cosine = before.x * unit_.x + before.y * unit_.y;
  const double sine = before.x * unit_.y - before.y * unit_.x;
  unit_ = {cosine * unit_.x - sine * unit_.y, cosine * unit_.y + sine * unit_.x};
  const double axis = in_strip(last).y;
  const Point p = in_strip(place);
  bounds_ = {p.x - behind * length, std::min(axis + right, p.y) - outside * swing,
             p.x + stretch_ * ahead * length, std::max(axis + left, p.y) + inside * swing};
  slab_length_ = (bounds_.x1 - bounds_.x0) / slab_count;
  slabs_per_length_ = 1 / slab_length_;
  constexpr double extents_per_tolerance = 0x1p46;
  return holds(place) && std::isfinite(slabs_per_length_) &&
         std::isfinite(16 * extents_per_tolerance * tolerance_);
}

void Strip::gather(std::int64_t most, PairsMet* met) {
  Place strip(*this);
  std::int64_t visits = 0;
  const std::int64_t looks = superset_.search(
      strip,
      [&](Index i, Index j) {
        if (++visits <= most / 2) {
          superset_.for_each_edge(i, j, [&](const PairEdge& edge) { add(edge); });
        }
      },
      met, most / 2);
  is_gathered_ = looks <= most / 2 && visits <= most / 2;
  fund_.spend(looks + visits, is_gathered_);
  if (is_gathered_) {
    stretch_ = std::min(1.25 * stretch_, 1.0);
  } else {
    clear();
    stretch_ = std::max(stretch_ / 2, least_stretch);
  }
}

void Strip::clear() {
  is_gathered_ = false;
  bounds_ = empty_box;
  for (Slab& slab : slabs_) {
    slab.blocks.clear();
    slab.size = 0;
  }
}

// Of an edge along one axis, the change of the other coordinate is infinite: then its whole box
// is taken.
void Strip::add(const PairEdge& edge) {
  const Point from = superset_.operands().relative_start(edge);
  const Point to = superset_.operands().relative_end(edge);
  const Point p = in_strip(from);
  const Point q = in_strip(to);
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

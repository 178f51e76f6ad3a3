// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounding.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "box.hpp"
#include "double_double.hpp"
#include "double_double_rounding.hpp"
#include "error.hpp"
#include "exact_coordinates.hpp"
#include "parallel.hpp"
#include "repair.hpp"
#include "simplicity.hpp"
#include "snap_rounding.hpp"
#include "to_double.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// A sum of two doubles in each coordinate, rounded. Computes both coordinates at once.
class PlacedSum {
 public:
  PlacedSum(const Point& p, const Point& q) {
    const PairOfDoubles a{p.x, p.y};
    const PairOfDoubles b{q.x, q.y};
    sum_ = a + b;
    error_ = rounding_error(a, b, sum_);
  }

  // Is each coordinate exact, or rounded and smaller than the given size?
  [[nodiscard]] bool is_below(const Point& sizes) const {
    const PairOfMasks is_rounded = error_ != PairOfDoubles{0, 0};
    const auto size =
        std::bit_cast<PairOfDoubles>(std::bit_cast<PairOfMasks>(magnitude(sum_)) & is_rounded);
    return bits_of(less(size, PairOfDoubles{sizes.x, sizes.y})) == 3;
  }

  // False if a sum overflows, and maybe if it is next to the end of the range.
  [[nodiscard]] bool is_certain() const { return !std::isnan(error_[0]) && !std::isnan(error_[1]); }

  [[nodiscard]] Point place() const {
    const PairOfDoubles without_sign_of_zero = sum_ + PairOfDoubles{0, 0};
    return {without_sign_of_zero[0], without_sign_of_zero[1]};
  }

  [[nodiscard]] RoundedVertex rounded() const {
    const Point p = place();
    return {{p.x, error_[0] == 0}, {p.y, error_[1] == 0}};
  }

 private:
  PairOfDoubles sum_;
  PairOfDoubles error_;
};

constexpr double smallest_normal = std::numeric_limits<double>::min();

// The size of a number that was rounded, or the smallest normal one, which has rounding errors as
// large as all smaller ones have. 0 if the number is exact.
double size_if_rounded(const RoundedNumber& number) {
  return number.exact ? 0 : std::max(std::abs(number.value), smallest_normal);
}

// At least the rounding error of a number of that size.
double error_of_size(double size) {
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  return size == 0 ? 0 : size < 0x1p-1020 ? smallest : unit_in_last_place(size) / 2;
}

// The size from which on rounding errors are larger than `error`: the next power of two.
double next_size(double error) { return std::max(0x1p54 * error, smallest_normal); }

void check_finite(const ExactRing& ring, std::size_t k, const RoundedVertex& vertex) {
  const bool x_is_finite = std::isfinite(vertex.x.value);
  if (x_is_finite && std::isfinite(vertex.y.value)) {
    return;
  }
  // A crossing is named by the edge that leaves it.
  const RingVertex& v = ring.vertices[k];
  const Index i = v.is_sum() ? v.i() : v.leaving().i;
  const Index j = v.is_sum() ? v.j() : v.leaving().j;
  throw Error(Status::range,
              "the %s coordinate of vertex %zu of the result, %s vertex %u of %s + vertex %u of "
              "%s, is beyond the largest double",
              x_is_finite ? "y" : "x", k, v.is_sum() ? "the sum" : "on an edge from the sum",
              ring.a.ring->corners[i].vertex_number, ring.a.name,
              ring.b.ring->corners[j].vertex_number, ring.b.name);
}

bool has_repetitions(const PointVector& places) {
  return std::adjacent_find(places.begin(), places.end()) != places.end() ||
         places.front() == places.back();
}

// About the bounding box of the ring.
Box bounds_of(const ExactRing& ring) {
  const Box& a = ring.a.ring->bounds;
  const Box& b = ring.b.ring->bounds;
  const Point& shift = ring.shift;
  return {a.x0 + b.x0 + shift.x, a.y0 + b.y0 + shift.y, a.x1 + b.x1 + shift.x,
          a.y1 + b.y1 + shift.y};
}

// Is the ring through the points simple and counter-clockwise? Repeated points count once.
bool make_simple_ring(const PointVector& places, const Box& bounds, unsigned threads) {
  PointVector without_repetitions;
  std::span<const Point> ring = places;
  if (has_repetitions(places)) {
    without_repetitions = ring_through(places);
    ring = without_repetitions;
  }
  return ring.size() >= 3 && !find_conflict(ring, bounds, threads) && is_counter_clockwise(ring);
}

// The number of points of the first list that are not in the second. The lists may have any order.
std::uint64_t count_missing(const PointVector& points, PointVector others) {
  std::sort(others.begin(), others.end(), lexicographically_less);
  return static_cast<std::uint64_t>(
      std::count_if(points.begin(), points.end(), [&](const Point& p) {
        return !std::binary_search(others.begin(), others.end(), p, lexicographically_less);
      }));
}

}  // namespace

// Not inlined into the loop over all vertices, because few vertices need it.
[[gnu::noinline]] RoundedVertex rounded_vertex(const Boundary& a, const Boundary& b,
                                               const RingVertex& v, const Point& shift,
                                               Tally& tally) {
  const std::optional<RoundedVertex> in_doubles =
      v.is_sum() ? rounded_sum(point_of(a, b, {v.i(), v.j()}), shift)
                 : rounded_crossing(coordinates(a, b, v.arriving()), coordinates(a, b, v.leaving()),
                                    shift);
  if (in_doubles) {
    ++tally.filtered;
    return *in_doubles;
  }
  const ExactVertex vertex(a, b, v, shift);
  const int exponent = vertex.grid().exponent();
  return with_integers(rounding_bits(vertex.bits()), tally, [&]<class Integer>() {
    const auto p = vertex.homogeneous<Integer>();
    return RoundedVertex{nearest_double(p.x, p.w, exponent), nearest_double(p.y, p.w, exponent)};
  });
}

PointVector ring_through(PointVector places) {
  places.erase(std::unique(places.begin(), places.end()), places.end());
  while (places.size() > 1 && places.back() == places.front()) {
    places.pop_back();
  }
  const auto first = static_cast<std::ptrdiff_t>(lexicographic_min(places));
  std::rotate(places.begin(), places.begin() + first, places.end());
  return places;
}

Placement place_nearest(const ExactRing& ring, Task& task, Tally& tally, std::uint64_t parts) {
  struct Portion {
    double error_bound = 0;
    Point sizes{smallest_normal,
                smallest_normal};  // from which on errors are larger than `error_bound`
    Tally tally;

    void add(const RoundedVertex& vertex) {
      const double x = size_if_rounded(vertex.x);
      const double y = size_if_rounded(vertex.y);
      if (x >= sizes.x || y >= sizes.y) {
        const Point errors{error_of_size(x), error_of_size(y)};
        const double bound = length_bound(errors.x, errors.y);
        if (bound > error_bound) {
          error_bound = bound;
          sizes = {next_size(errors.x), next_size(errors.y)};
        }
      }
    }
  };
  Placement placement;
  placement.places.resize(ring.size());
  boost::container::small_vector<Portion, 1> portions((ring.size() + Task::portion - 1) /
                                                      Task::portion);
  const Boundary& a = *ring.a.ring;
  const Boundary& b = *ring.b.ring;
  const bool is_unshifted = ring.shift == Point{0, 0} && a.positions.empty();
  const auto place_portion = [&](std::size_t number) {
    Portion& portion = portions[number];
    const std::size_t first = number * Task::portion;
    const std::size_t last = std::min<std::size_t>(first + Task::portion, ring.size());
    for (std::size_t k = first; k < last; ++k) {
      const RingVertex& v = ring.vertices[k];
      if (is_unshifted && v.is_sum()) {
        const PlacedSum sum(a.vertices[v.i()], b.vertices[v.j()]);
        const bool is_below = sum.is_below(portion.sizes);
        if (is_below || sum.is_certain()) {
          placement.places[k] = sum.place();
          ++portion.tally.filtered;
          if (!is_below) {
            portion.add(sum.rounded());
          }
          continue;
        }
      }
      const RoundedVertex vertex = rounded_vertex(a, b, v, ring.shift, portion.tally);
      check_finite(ring, k, vertex);
      placement.places[k] = {vertex.x.value, vertex.y.value};
      portion.add(vertex);
    }
    task.advance(last - first, parts * last / ring.size() - parts * first / ring.size());
  };
  for_each_in_parallel(portions.size(), task.threads(), place_portion, [&] { task.watch(); });
  for (const Portion& portion : portions) {
    placement.error_bound = std::max(placement.error_bound, portion.error_bound);
    tally += portion.tally;
  }
  return placement;
}

bool make_simple(const ExactRing& ring, Placement& placement, Task& task, Tally& tally) {
  // If no vertex was rounded, the ring is the exact ring, which is simple.
  if (placement.error_bound == 0 ||
      make_simple_ring(placement.places, bounds_of(ring), task.threads())) {
    return true;
  }
  std::optional<PointVector> separated = separate(ring, placement.places, tally);
  if (!separated) {
    return false;
  }
  double furthest = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& p = placement.places[k];
    const Point& q = (*separated)[k];
    if (!(p == q)) {
      ++placement.repaired;
      furthest = std::max(furthest, length_bound(q.x - p.x, q.y - p.y));
    }
  }
  placement.places = std::move(*separated);
  placement.error_bound = sum_bound(furthest, placement.error_bound);
  return true;
}

// If vertices move by at most d, each point of the ring moves by at most d. So both rings are
// within the largest error of a vertex of each other.
RoundedRing round_to_nearest(const ExactRing& ring, Task& task, Tally& tally, std::uint64_t parts) {
  Placement placement = place_nearest(ring, task, tally, parts);
  if (make_simple(ring, placement, task, tally)) {
    return {ring_through(std::move(placement.places)), placement.error_bound, placement.repaired};
  }
  const std::optional<SnapRoundedRing> snapped = snap_round(ring_through(placement.places), tally);
  if (!snapped) {
    throw Error(Status::range, "the outer face is too small for doubles: rounding leaves no area");
  }
  RoundedRing rounded;
  rounded.vertices = ring_through(snapped->vertices);
  rounded.error_bound = sum_bound(snapped->error_bound, placement.error_bound);
  rounded.vertices_repaired = count_missing(placement.places, rounded.vertices) +
                              count_missing(rounded.vertices, placement.places);
  return rounded;
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What holds of the region of any two polygons, and of the places of one inside the other.
#include <gcv/gcv.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact_geometry.hpp"
#include "exact_pieces.hpp"
#include "exact_vertices.hpp"
#include "frame.hpp"
#include "handles.hpp"
#include "invariants.hpp"

namespace gcv::invariants {

namespace {

struct Part {
  std::int32_t kind;
  std::uint32_t polygon;
  Ring points;

  [[nodiscard]] bool is_ring() const { return kind <= GCV_PART_HOLE; }
  friend bool operator==(const Part&, const Part&) = default;
};

using Parts = std::vector<Part>;

struct Region {
  std::unique_ptr<gcv_region, Destroy> handle;
  Parts exact;
  Parts returned;
  std::vector<std::size_t> exact_part;  // of the first vertex of each returned part
  double error_bound = 0;
  std::uint64_t repaired = 0;
  std::uint64_t dropped = 0;
};

// The parts with their points, which follow one another.
Parts parts_of(const gcv_region* region,
               gcv_status (*get)(const gcv_region*, gcv_region_part*, std::size_t, std::size_t*),
               const Ring& points) {
  std::size_t count = 0;
  require(get(region, nullptr, 0, &count), "the number of parts");
  std::vector<gcv_region_part> parts(count);
  require(get(region, parts.data(), count, &count), "the parts");
  Parts result;
  std::size_t first = 0;
  for (const gcv_region_part& part : parts) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    first += part.vertex_count;
    if (first > points.size()) {
      throw Failure(GCV_OK, "There are fewer vertices than the parts have");
    }
    result.push_back({part.kind, part.polygon,
                      Ring(begin, points.begin() + static_cast<std::ptrdiff_t>(first))});
  }
  if (first != points.size()) {
    throw Failure(GCV_OK, "There are more vertices than the parts have");
  }
  return result;
}

Ring exact_points(const gcv_region* region) {
  std::size_t count = 0;
  require(gcv_region_edge_sources(region, nullptr, 0, &count), "the number of exact vertices");
  return invariants::exact_points(
      count, [&](auto... arguments) { return gcv_region_exact_vertex(region, arguments...); });
}

Region read(gcv_region* handle) {
  Region region;
  region.handle.reset(handle);
  region.exact = parts_of(handle, gcv_region_exact_parts, exact_points(handle));
  std::size_t count = 0;
  require(gcv_region_vertices(handle, nullptr, 0, &count), "the number of vertices");
  Polygon returned(count + 1);
  require(gcv_region_vertices(handle, returned.front().data(), count, &count), "the vertices");
  returned.pop_back();
  std::vector<std::uint64_t> indices(count);
  require(gcv_region_exact_indices(handle, indices.data(), count, &count), "the exact indices");
  require(gcv_region_error_bound(handle, &region.error_bound), "the error bound");
  if (!all_finite(returned) || !std::isfinite(region.error_bound)) {
    throw Failure(GCV_OK, "A returned number is not finite");
  }
  region.returned = parts_of(handle, gcv_region_parts, exact(returned));
  std::vector<std::size_t> part_of_vertex;
  for (std::size_t k = 0; k < region.exact.size(); ++k) {
    part_of_vertex.insert(part_of_vertex.end(), region.exact[k].points.size(), k);
  }
  std::size_t first = 0;
  for (const Part& part : region.returned) {
    region.exact_part.push_back(part_of_vertex.at(indices[first]));
    first += part.points.size();
  }
  gcv_stats stats{};
  stats.struct_size = sizeof stats;
  require(gcv_region_stats(handle, &stats), "the statistics");
  region.repaired = stats.vertices_repaired;
  region.dropped = stats.parts_dropped;
  return region;
}

gcv_options rounding_options(std::int32_t rounding) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = rounding;
  return options;
}

Region sum(const Polygon& a, const Polygon& b, std::int32_t rounding = GCV_ROUND_NEAREST) {
  const gcv_options options = rounding_options(rounding);
  gcv_region* region = nullptr;
  require(gcv_minkowski_sum_region(make(a).get(), make(b).get(), &options, &region), "the region");
  return read(region);
}

Region fit(const Polygon& container, const Polygon& moving,
           std::int32_t rounding = GCV_ROUND_NEAREST) {
  const gcv_options options = rounding_options(rounding);
  const double origin[2] = {0, 0};
  gcv_region* region = nullptr;
  require(
      gcv_inner_fit_region(make(container).get(), make(moving).get(), origin, &options, &region),
      "the inner fit");
  return read(region);
}

Polygon transformed(Polygon polygon, const std::function<Point(const Point&)>& f) {
  std::transform(polygon.begin(), polygon.end(), polygon.begin(), f);
  return polygon;
}

Polygon reflected(const Polygon& polygon) {
  return transformed(polygon, [](const Point& p) { return Point{0 - p[0], 0 - p[1]}; });
}

// In the order that the contract gives to parts.
Parts in_order(Parts parts) {
  struct Whole {
    Part outer;
    Parts holes;
  };
  const auto less = [](const Part& p, const Part& q) { return p.points < q.points; };
  std::vector<Whole> polygons;
  Parts fits;
  for (Part& part : parts) {
    if (part.is_ring()) {
      part.points = canonical(part.points);
    } else if (part.points.back() < part.points.front()) {
      std::reverse(part.points.begin(), part.points.end());
    }
    if (part.kind == GCV_PART_OUTER) {
      polygons.push_back({std::move(part), {}});
    } else if (part.kind == GCV_PART_HOLE) {
      polygons.at(polygons.size() - 1).holes.push_back(std::move(part));
    } else {
      fits.push_back(std::move(part));
    }
  }
  std::sort(polygons.begin(), polygons.end(),
            [&](const Whole& p, const Whole& q) { return less(p.outer, q.outer); });
  std::sort(fits.begin(), fits.end(), [](const Part& p, const Part& q) {
    return std::tie(p.kind, p.points) < std::tie(q.kind, q.points);
  });
  Parts result;
  for (std::uint32_t k = 0; k < polygons.size(); ++k) {
    Whole& whole = polygons[k];
    std::sort(whole.holes.begin(), whole.holes.end(), less);
    whole.outer.polygon = k;
    result.push_back(std::move(whole.outer));
    for (Part& hole : whole.holes) {
      hole.polygon = k;
      result.push_back(std::move(hole));
    }
  }
  result.insert(result.end(), fits.begin(), fits.end());
  return result;
}

Parts transformed(Parts parts, const std::function<Exact(const Exact&)>& f, bool mirrors) {
  for (Part& part : parts) {
    std::transform(part.points.begin(), part.points.end(), part.points.begin(), f);
    if (mirrors && part.is_ring()) {
      std::reverse(part.points.begin(), part.points.end());
    }
  }
  return in_order(std::move(parts));
}

// 1 inside, 0 on a ring, a segment or a point, -1 outside.
int location(const Parts& parts, const Exact& x) {
  int where = -1;
  for (const Part& part : parts) {
    const Ring& p = part.points;
    if (part.is_ring()) {
      const int in_ring = location(p, x);
      if (in_ring == 0) {
        return 0;
      }
      if (in_ring > 0) {
        where = part.kind == GCV_PART_OUTER ? 1 : -1;
      }
    } else if (p.size() == 1 ? p[0] == x : on_segment(p[0], p[1], x)) {
      return 0;
    }
  }
  return where;
}

std::string text(std::size_t k) { return std::to_string(k); }

Rational power_of_two(unsigned halvings) {
  return Rational(1) / Rational(boost::multiprecision::mpz_int(1) << halvings);
}

// One region: of a sum, or of an inner fit.
class Check {
 public:
  // What is known of a position: is it free, and do the polygons touch there?
  struct Position {
    bool is_free;
    bool touches;
  };
  using Judge = std::function<Position(const Exact&)>;
  using Compute = std::function<Region(const Polygon&, const Polygon&, std::int32_t)>;

  Check(const Polygon& a, const Polygon& b, const Effort& effort, bool is_sum, Compute compute,
        Judge judge)
      : a_(a),
        b_(b),
        effort_(effort),
        is_sum_(is_sum),
        compute_(std::move(compute)),
        judge_(std::move(judge)) {}

  std::vector<std::string> run() {
    try {
      region_ = compute_(a_, b_, GCV_ROUND_NEAREST);
      well_formed();
      outer_face_comes_first();
      rings_bound_what_is_free();
      fits_are_tight();
      places();
      well_formed_returned(region_);
      nearest_doubles();
      error_bound(region_);
      follows_transformations();
    } catch (const Failure& failure) {
      note(failure, "");
    }
    if (effort_.outward) {
      try {
        safe_side();
      } catch (const Failure& failure) {
        note(failure, " rounded to the safe side");
      }
    }
    return std::move(broken_);
  }

  [[nodiscard]] const Parts& exact_parts() const { return region_.exact; }

 private:
  void broken(const std::string& sentence) {
    broken_.push_back((is_sum_ ? "Region: " : "Inner fit: ") + sentence);
  }
  void note(const Failure& failure, const std::string& how) {
    if (failure.status != GCV_ERR_RANGE || !effort_.may_be_out_of_range) {
      broken("The library fails" + how + ": " + failure.what());
    }
  }

  [[nodiscard]] std::size_t samples(std::size_t edges) const {
    return std::max<std::size_t>(4, effort_.work / edges);
  }
  [[nodiscard]] std::size_t edges() const {
    std::size_t count = a_.size() + b_.size();
    for (const Part& part : region_.exact) {
      count += part.points.size();
    }
    return count;
  }

  void well_formed() {
    const Parts& parts = region_.exact;
    if (!(in_order(parts) == parts)) {
      broken("The exact parts are not in their order.");
    }
    if (is_sum_ && (parts.empty() || parts.front().kind != GCV_PART_OUTER ||
                    std::count_if(parts.begin(), parts.end(), [](const Part& part) {
                      return part.kind == GCV_PART_OUTER;
                    }) != 1)) {
      broken("There is not one polygon.");
    }
    for (const Part& part : parts) {
      const Ring& ring = part.points;
      if (!part.is_ring()) {
        if (ring.size() != (part.kind == GCV_PART_SEGMENT ? 2U : 1U) ||
            part.polygon != 0xffffffffU) {
          broken("A segment or a point is none.");
        }
        continue;
      }
      const int turn = part.kind == GCV_PART_OUTER ? 1 : -1;
      if (ring.size() < 3 || orientation(ring.back(), ring[0], ring[1]) * turn <= 0) {
        broken("A ring goes round the wrong way.");
      }
      for (std::size_t k = 0; k < ring.size(); ++k) {
        if (orientation(previous(ring, k), ring[k], next(ring, k)) == 0) {
          broken("A ring has a collinear vertex.");
        }
      }
    }
    well_formed_rings(parts, "exact");
  }

  // No ring meets itself, no two cross, and what is in a polygon is in it.
  void well_formed_rings(const Parts& parts, const std::string& name) {
    Ring from;
    Ring to;
    std::vector<std::size_t> part_of;
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (!parts[k].is_ring()) {
        continue;
      }
      const Ring& ring = parts[k].points;
      if (ring.size() < 3 || find_meeting(ring)) {
        broken("Part " + text(k) + " of the " + name + " parts meets itself.");
        return;
      }
      for (std::size_t i = 0; i < ring.size(); ++i) {
        from.push_back(ring[i]);
        to.push_back(next(ring, i));
        part_of.push_back(k);
        boxes.push_back(box(from.back(), to.back()));
      }
    }
    for_each_overlap(boxes, boxes, [&](std::size_t i, std::size_t j) {
      const bool cross = i < j && segments_cross(from[i], to[i], from[j], to[j]);
      if (cross) {
        broken("Parts " + text(part_of[i]) + " and " + text(part_of[j]) + " of the " + name +
               " parts cross.");
      }
      return !cross;
    });
    for (const std::size_t k : sample(parts.size(), samples(from.size() + 1))) {
      for (std::size_t l = 0; l < parts.size() && parts[k].is_ring(); ++l) {
        if (k != l && parts[l].is_ring() && !may_lie(parts[k], parts[l])) {
          broken("Parts " + text(k) + " and " + text(l) + " of the " + name +
                 " parts lie as they may not.");
          return;
        }
      }
    }
  }

  // Outer rings of two polygons: beside each other, or one in a hole of the other one.
  static bool may_lie(const Part& p, const Part& q) {
    if (p.polygon != q.polygon) {
      return p.kind != GCV_PART_OUTER || q.kind != GCV_PART_OUTER ||
             !interiors_overlap(p.points, q.points) || lies_in(p.points, q.points) ||
             lies_in(q.points, p.points);
    }
    if (p.kind == GCV_PART_OUTER || q.kind == GCV_PART_OUTER) {
      return p.kind == GCV_PART_OUTER ? lies_in(q.points, p.points) : lies_in(p.points, q.points);
    }
    return !interiors_overlap(p.points, q.points);
  }

  void outer_face_comes_first() {
    if (!is_sum_) {
      return;
    }
    gcv_outer_face* face = nullptr;
    require(gcv_minkowski_sum(make(a_).get(), make(b_).get(), nullptr, &face), "the sum");
    const std::unique_ptr<gcv_outer_face, Destroy> owner(face);
    if (!(exact_ring(face) == region_.exact.front().points) ||
        !(exact(vertices(gcv_outer_face_vertices, face)) == region_.returned.front().points)) {
      broken("The first ring is not the outer face.");
    }
  }

  // For rings of the exact parts: where they pass the polygons touch; on one side all is free, on
  // the other one nothing.
  void rings_bound_what_is_free() {
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (std::size_t k = 0; k < region_.exact.size(); ++k) {
      for (std::size_t i = 0; region_.exact[k].is_ring() && i < region_.exact[k].points.size();
           ++i) {
        all.emplace_back(k, i);
      }
    }
    for (const std::size_t number : sample(all.size(), samples(edges()))) {
      const auto& [k, i] = all[number];
      const Ring& ring = region_.exact[k].points;
      const std::string where = "edge " + text(i) + " of part " + text(k);
      if (!is_tight(ring[i])) {
        broken("The polygons do not just touch at the start of " + where + ".");
        return;
      }
      const Exact along = next(ring, i) - ring[i];
      const Exact middle = ring[i] + Rational(509, 1021) * along;
      if (!is_tight(middle)) {
        broken("The polygons do not just touch on " + where + ".");
        return;
      }
      const Exact left{Rational(0) - along.y, along.x};
      const Exact free = is_sum_ ? Rational(-1) * left : left;
      if (!judge_(middle + reach(middle, free, k, i) / 2 * free).is_free) {
        broken("Points on the free side of " + where + " are not free.");
        return;
      }
      if (!is_closed(middle, Rational(-1) * free)) {
        broken("Points on the other side of " + where + " are free.");
        return;
      }
    }
  }

  // Free, and so that the polygons touch.
  [[nodiscard]] bool is_tight(const Exact& x) const {
    const Position position = judge_(x);
    return position.is_free && position.touches;
  }

  // Are points close to x in that direction not free? Nobody knows how close.
  [[nodiscard]] bool is_closed(const Exact& x, const Exact& direction) const {
    for (const unsigned halvings : {64U, 256U, 1024U, 4096U}) {
      if (!judge_(x + power_of_two(halvings) * direction).is_free) {
        return true;
      }
    }
    return false;
  }

  void fits_are_tight() {
    Parts fits;
    std::copy_if(region_.exact.begin(), region_.exact.end(), std::back_inserter(fits),
                 [](const Part& part) { return !part.is_ring(); });
    for (const std::size_t k : sample(fits.size(), samples(edges()))) {
      const Ring& p = fits[k].points;
      const bool is_point = p.size() == 1;
      const Exact x = is_point ? p[0] : p[0] + Rational(509, 1021) * (p[1] - p[0]);
      const Exact along = is_point ? Exact{1, Rational(3, 7)} : p[1] - p[0];
      const Exact across{Rational(0) - along.y, along.x};
      const bool is_alone =
          is_closed(x, across) && is_closed(x, Rational(-1) * across) &&
          (!is_point || (is_closed(x, along) && is_closed(x, Rational(-1) * along)));
      if (!is_tight(x) || !is_tight(p.front()) || !is_tight(p.back()) || !is_alone) {
        broken((is_point ? "Point " : "Segment ") + text(k) + " of the fits is no exact fit.");
        return;
      }
    }
  }

  // The least t > 0 for which x + t direction is on a ring; at most 1. x is on edge i of part k.
  [[nodiscard]] Rational reach(const Exact& x, const Exact& direction, std::size_t k,
                               std::size_t i) const {
    Rational least = 1;
    for (std::size_t l = 0; l < region_.exact.size(); ++l) {
      const Ring& ring = region_.exact[l].points;
      for (std::size_t j = 0; region_.exact[l].is_ring() && j < ring.size(); ++j) {
        const Exact along = next(ring, j) - ring[j];
        const Rational slope = cross(direction, along);
        if ((l == k && j == i) ||
            sign(cross(direction, ring[j] - x)) * sign(cross(direction, next(ring, j) - x)) > 0) {
          continue;
        }
        const Rational t = slope == 0 ? dot(ring[j] - x, direction) / dot(direction, direction)
                                      : cross(ring[j] - x, along) / slope;
        if (t > 0 && t < least) {
          least = t;
        }
      }
    }
    return least;
  }

  // Doubles on and near all parts.
  void places() {
    Polygon points;
    for (const Parts* parts : {&region_.exact, &region_.returned}) {
      for (const std::size_t k : sample(parts->size(), samples(edges()))) {
        const Ring& p = (*parts)[k].points;
        for (const std::size_t i : sample(p.size(), 4)) {
          points.push_back(nearest(p[i]));
          points.push_back(nearest(Rational(1, 2) * (p[i] + next(p, i))));
          points.push_back(nearest(Rational(1, 2) * (p[i] + p[(i + 2) % p.size()])));
        }
      }
    }
    std::erase_if(points, [](const Point& p) { return !all_finite({p}); });
    if (points.empty()) {
      return;
    }
    std::vector<std::int8_t> where(points.size());
    require(
        gcv_region_locate(region_.handle.get(), points.front().data(), points.size(), where.data()),
        "the places of points");
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (where[k] != location(region_.exact, exact(points[k]))) {
        broken("A point is not where the library says: " + wkt({points[k]}));
        return;
      }
    }
  }

  void well_formed_returned(const Region& region) {
    well_formed_rings(region.returned, "returned");
    std::uint32_t polygons = 0;
    for (const Part& part : region.returned) {
      polygons += part.kind == GCV_PART_OUTER ? 1U : 0U;
    }
    for (std::uint32_t k = 0; k < polygons; ++k) {
      gcv_polygon* polygon = nullptr;
      require(gcv_region_polygon(region.handle.get(), k, &polygon), "a returned polygon");
      gcv_polygon_destroy(polygon);
    }
  }

  void nearest_doubles() {
    if (region_.repaired != 0 || region_.dropped != 0) {
      return;
    }
    for (std::size_t k = 0; k < region_.returned.size(); ++k) {
      Polygon rounded;
      for (const Exact& p : region_.exact[region_.exact_part[k]].points) {
        rounded.push_back(nearest(p));
      }
      if (rounded.size() > 1) {
        rounded = without_repetitions(rounded);
      }
      const Part& part = region_.returned[k];
      if (part.is_ring() && !(exact(canonical(rounded)) == canonical(part.points))) {
        broken("Nothing was repaired, but part " + text(k) + " has not the nearest doubles.");
        return;
      }
    }
  }

  static bool is_near(const Exact& x, const Parts& parts, double distance) {
    const Rational d(distance);
    return std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
      const Ring& p = part.points;
      for (std::size_t k = 0; k < p.size(); ++k) {
        const Exact offset = x - p[k];
        if (dot(offset, offset) <= d * d ||
            (p.size() > 1 && squared_distance(p[k], next(p, k), x) <= d * d)) {
          return true;
        }
      }
      return false;
    });
  }

  void error_bound(const Region& region) {
    const auto are_near = [&](const Parts& parts, const Parts& others) {
      for (const std::size_t k : sample(parts.size(), samples(edges()))) {
        for (const std::size_t i : sample(parts[k].points.size(), samples(edges()))) {
          if (!is_near(parts[k].points[i], others, region.error_bound)) {
            return false;
          }
        }
      }
      return true;
    };
    if (!are_near(region.returned, region.exact)) {
      broken("A returned vertex is further from the exact parts than the error bound says.");
    }
    if (region.dropped == 0 && !are_near(region.exact, region.returned)) {
      broken("An exact vertex is further from the returned parts than the error bound says.");
    }
  }

  // A sum contains the exact one, an inner fit lies in the exact one. Fits are exact.
  void safe_side() {
    const Region region = compute_(a_, b_, GCV_ROUND_OUTWARD);
    if (!(region.exact == region_.exact)) {
      broken("The exact parts depend on the rounding.");
    }
    well_formed_returned(region);
    error_bound(region);
    for (const std::size_t k : sample(region.returned.size(), samples(edges()))) {
      const Part& part = region.returned[k];
      const Part& exact_one = region.exact[region.exact_part[k]];
      if (!part.is_ring()) {
        if (std::find(region.exact.begin(), region.exact.end(), part) == region.exact.end()) {
          broken("Rounded to the safe side, a segment or a point is not exact.");
        }
      } else if (!is_on_safe_side(part, exact_one)) {
        broken("Rounded to the safe side, part " + text(k) + " is on the wrong side.");
      }
    }
  }

  // Growing can cut off a part of what is outside: a hole that was none.
  [[nodiscard]] bool is_on_safe_side(const Part& part, const Part& exact_one) const {
    if (is_sum_ && part.kind == GCV_PART_HOLE && exact_one.kind == GCV_PART_OUTER) {
      return !interiors_overlap(part.points, exact_one.points);
    }
    return is_sum_ == (part.kind == GCV_PART_OUTER) ? lies_in(exact_one.points, part.points)
                                                    : lies_in(part.points, exact_one.points);
  }

  void follows_transformations() {
    if (is_sum_ && !(sum(b_, a_).exact == region_.exact)) {
      broken("b + a is not a + b.");
    }
    if (a_.size() * b_.size() > effort_.work) {
      return;
    }
    mirrored([](const auto& p) { return std::pair(0 - p.first, p.second); }, "a reflection");
    mirrored([](const auto& p) { return std::pair(p.second, p.first); }, "an exchange of the axes");
    for (const int exponent : {37, -61}) {
      scaled(exponent);
    }
    moved();
  }

  // `f` maps pairs of numbers of any kind.
  template <class Map>
  void mirrored(Map f, const char* what) {
    const auto of_doubles = [&](const Point& p) {
      const auto [x, y] = f(std::pair(p[0], p[1]));
      return Point{x, y};
    };
    const auto of_fractions = [&](const Exact& p) {
      const auto [x, y] = f(std::pair(p.x, p.y));
      return Exact{x, y};
    };
    const Region other =
        compute_(transformed(a_, of_doubles), transformed(b_, of_doubles), GCV_ROUND_NEAREST);
    if (!(other.exact == transformed(region_.exact, of_fractions, true))) {
      broken(std::string("It does not follow ") + what + ".");
    }
  }

  void scaled(int exponent) {
    const auto of_doubles = [&](const Point& p) {
      return Point{std::ldexp(p[0], exponent), std::ldexp(p[1], exponent)};
    };
    const Rational factor = exponent < 0 ? power_of_two(static_cast<unsigned>(-exponent))
                                         : 1 / power_of_two(static_cast<unsigned>(exponent));
    const auto is_exact = [&](const Polygon& polygon) {
      return std::all_of(polygon.begin(), polygon.end(), [&](const Point& p) {
        const Point q = of_doubles(p);
        return all_finite({q}) && exact(q) == factor * exact(p);
      });
    };
    if (!is_exact(a_) || !is_exact(b_)) {
      return;
    }
    try {
      const Region other =
          compute_(transformed(a_, of_doubles), transformed(b_, of_doubles), GCV_ROUND_NEAREST);
      if (!(other.exact == transformed(
                               region_.exact, [&](const Exact& p) { return factor * p; }, false))) {
        broken("It does not scale by 2^" + std::to_string(exponent) + ".");
      }
    } catch (const Failure& failure) {
      if (failure.status != GCV_ERR_RANGE) {
        note(failure, " scaled");
      }
    }
  }

  // The first polygon, to where its first vertex is the origin, if that is exact.
  void moved() {
    const Point by{0 - a_[0][0], 0 - a_[0][1]};
    const auto of_doubles = [&](const Point& p) { return Point{p[0] + by[0], p[1] + by[1]}; };
    const Polygon other = transformed(a_, of_doubles);
    const Exact t = exact(by);
    for (std::size_t k = 0; k < a_.size(); ++k) {
      if (!all_finite({other[k]}) || !(exact(other[k]) == exact(a_[k]) + t)) {
        return;
      }
    }
    try {
      if (!(compute_(other, b_, GCV_ROUND_NEAREST).exact ==
            transformed(
                region_.exact, [&](const Exact& p) { return p + t; }, false))) {
        broken("It does not move with a.");
      }
    } catch (const Failure& failure) {
      if (failure.status != GCV_ERR_RANGE) {
        note(failure, " translated");
      }
    }
  }

  const Polygon& a_;
  const Polygon& b_;
  const Effort& effort_;
  bool is_sum_;
  Compute compute_;
  Judge judge_;
  Region region_;
  std::vector<std::string> broken_;
};

// `of` moved to x.
Ring placed(const Ring& of, const Exact& x) {
  Ring ring;
  for (const Exact& p : of) {
    ring.push_back(x + p);
  }
  return ring;
}

bool boundaries_meet(const Ring& p, const Ring& q) {
  bool meet = false;
  for_each_overlap(edge_boxes(p), edge_boxes(q), [&](std::size_t i, std::size_t j) {
    meet = segments_meet(p[i], next(p, i), q[j], next(q, j));
    return !meet;
  });
  return meet;
}

// What the inner fit is for a hole in a block: holes and fits of the no-fit region.
std::vector<std::string> broken_frame(const Polygon& container, const Polygon& moving,
                                      const Parts& fits) {
  const PolygonHandle frame = frame_of(container, moving);
  const double origin[2] = {0, 0};
  gcv_region* handle = nullptr;
  if (frame == nullptr ||
      gcv_no_fit_region(frame.get(), make(moving).get(), origin, nullptr, &handle) != GCV_OK) {
    return {};
  }
  const Region region = read(handle);
  Parts parts;
  for (const Part& part : region.exact) {
    if (part.kind == GCV_PART_HOLE) {
      Ring ring = part.points;
      std::reverse(ring.begin(), ring.end());
      parts.push_back({GCV_PART_OUTER, 0, std::move(ring)});
    } else if (!part.is_ring()) {
      parts.push_back(part);
    }
  }
  if (in_order(std::move(parts)) == fits) {
    return {};
  }
  return {"The inner fit is not what a block with the container as its hole leaves free."};
}

}  // namespace

std::vector<std::string> broken_region_invariants(const Polygon& a, const Polygon& b,
                                                  const Effort& effort) {
  const Ring fixed = without_repetitions(exact(a));
  const Ring moving = without_repetitions(exact(reflected(b)));
  const std::vector<Box> boxes = edge_boxes(fixed);
  const auto judge = [&](const Exact& x) {
    const Ring ring = placed(moving, x);
    if (!polygons_meet(fixed, boxes, ring)) {
      return Check::Position{true, false};
    }
    return Check::Position{!interiors_overlap(fixed, ring), true};
  };
  return Check(a, b, effort, true, sum, judge).run();
}

std::vector<std::string> broken_fit_invariants(const Polygon& container, const Polygon& moving,
                                               const Effort& effort) {
  const Ring outside = without_repetitions(exact(container));
  const Ring inside = without_repetitions(exact(moving));
  const auto judge = [&](const Exact& x) {
    const Ring ring = placed(inside, x);
    return Check::Position{lies_in(ring, outside), boundaries_meet(ring, outside)};
  };
  Check check(container, moving, effort, false, fit, judge);
  std::vector<std::string> broken = check.run();
  const std::vector<std::string> of_frame = broken_frame(container, moving, check.exact_parts());
  broken.insert(broken.end(), of_frame.begin(), of_frame.end());
  return broken;
}

}  // namespace gcv::invariants

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "invariants.hpp"

#include <gcv/gcv.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "exact_geometry.hpp"
#include "exact_vertices.hpp"
#include "handles.hpp"

namespace gcv::invariants {

namespace {

struct Sum {
  Ring exact;
  Polygon returned;
  std::vector<gcv_edge_source> sources;
  double error_bound = 0;
  double area = 0;
  std::uint64_t repaired = 0;
  Polygon as_polygon;
};

Sum sum(const Polygon& a, const Polygon& b, std::int32_t rounding = GCV_ROUND_NEAREST) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = rounding;
  gcv_outer_face* handle = nullptr;
  require(gcv_minkowski_sum(make(a).get(), make(b).get(), &options, &handle), "the sum");
  const std::unique_ptr<gcv_outer_face, Destroy> face(handle);
  Sum s;
  s.exact = exact_ring(handle);
  s.returned = vertices(gcv_outer_face_vertices, face.get());
  std::size_t edges = 0;
  require(gcv_outer_face_edge_sources(handle, nullptr, 0, &edges), "the number of sources");
  s.sources.resize(edges);
  require(gcv_outer_face_edge_sources(handle, s.sources.data(), edges, &edges), "the sources");
  require(gcv_outer_face_error_bound(handle, &s.error_bound), "the error bound");
  if (!all_finite(s.returned) || !std::isfinite(s.error_bound)) {
    throw Failure(GCV_OK, "A returned number is not finite");
  }
  if (gcv_outer_face_area(handle, &s.area) != GCV_OK) {
    s.area = HUGE_VAL;
  }
  gcv_stats stats{};
  stats.struct_size = sizeof stats;
  require(gcv_outer_face_stats(handle, &stats), "the statistics");
  s.repaired = stats.vertices_repaired;
  gcv_polygon* polygon = nullptr;
  require(gcv_outer_face_polygon(handle, &polygon), "the returned ring as a polygon");
  s.as_polygon = vertices(gcv_polygon_vertices, PolygonHandle(polygon).get());
  return s;
}

// ------------------------------------------------------------------ the caller's numbers --

// A polygon counter-clockwise, without repeated and without collinear vertices, and where
// its vertices and edges come from.
struct Normalised {
  Ring ring;
  std::vector<std::size_t> vertex;  // the corner that stands for the caller's number, or size
  std::vector<std::size_t> edge;
};

Normalised normalise(const Polygon& polygon) {
  Ring given = exact(polygon);
  while (given.size() > 1 && given.back() == given.front()) {
    given.pop_back();  // a closing vertex counts as vertex 0
  }
  const std::size_t n = given.size();
  const bool clockwise = twice_area(given) < 0;
  std::vector<std::size_t> order;  // the last of each run of repeated vertices
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = clockwise ? n - 1 - k : k;
    if (!(given[i] == given[(clockwise ? i + n - 1 : i + 1) % n])) {
      order.push_back(i);
    }
  }
  Normalised normalised{{}, std::vector<std::size_t>(n, n), std::vector<std::size_t>(n, n)};
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    if (orientation(given[previous(order, k)], given[i], given[next(order, k)]) != 0) {
      std::size_t last = i;  // of the run, as passed
      while (last + 1 < n && given[last + 1] == given[last]) {
        ++last;
      }
      normalised.vertex[last] = normalised.ring.size();
      normalised.edge[clockwise ? (i + n - 1) % n : i] = normalised.ring.size();
      normalised.ring.push_back(given[i]);
    }
  }
  return normalised;
}

// The paper's Definition 1: does vertex k contribute to edges of this direction?
bool contributes(const Ring& ring, std::size_t k, const Exact& direction) {
  const Exact in = ring[k] - previous(ring, k);
  const Exact out = next(ring, k) - ring[k];
  return sign(cross(in, out)) > 0 && sign(cross(in, direction)) >= 0 &&
         sign(cross(direction, out)) >= 0;
}

// --------------------------------------------------------------------------- the checks --

std::string text(std::size_t k) { return std::to_string(k); }

class Check {
 public:
  Check(const Polygon& a, const Polygon& b, const Effort& effort)
      : given_a_(a), given_b_(b), effort_(effort) {}

  std::vector<std::string> run() {
    try {
      sum_ = sum(given_a_, given_b_);
      a_ = normalise(given_a_);
      b_ = normalise(given_b_);
      normalised_polygons();
      well_formed_exact_ring();
      sources_are_true();
      hulls_add();
      brunn_minkowski();
      vertex_sums_are_inside();
      sides_of_edges();
      well_formed_returned_ring(sum_, "the returned ring");
      nearest_doubles();
      error_bound(sum_, "the error bound");
      commutes();
      if (given_a_.size() + given_b_.size() <= effort_.work) {
        translates();
        scales();
        reflects();
      }
    } catch (const Failure& failure) {
      note(failure, "a + b");
    }
    if (effort_.outward) {
      try {
        outward();
      } catch (const Failure& failure) {
        note(failure, "a + b rounded outward");
      }
    }
    return std::move(broken_);
  }

 private:
  void broken(const std::string& sentence) { broken_.push_back(sentence); }

  void note(const Failure& failure, const std::string& of) {
    if (failure.status != GCV_ERR_RANGE || !effort_.may_be_out_of_range) {
      broken("The library fails on " + of + ": " + failure.what());
    }
  }

  // How many samples may be taken, each of which looks at so many edges.
  [[nodiscard]] std::size_t samples(std::size_t edges) const {
    return std::max<std::size_t>(4, effort_.work / edges);
  }

  void normalised_polygons() {
    for (const auto& [given, own] : {std::pair{&given_a_, &a_}, std::pair{&given_b_, &b_}}) {
      if (exact(vertices(gcv_polygon_vertices, make(*given).get())) != canonical(own->ring)) {
        broken("The normalised ring of a polygon is not what the contract says.");
      }
    }
  }

  void well_formed_exact_ring() {
    const Ring& ring = sum_.exact;
    if (!(canonical(ring) == ring)) {
      broken("The exact ring does not start at its smallest vertex.");
    }
    if (orientation(ring.back(), ring[0], ring[1]) <= 0) {
      broken("The exact ring is not counter-clockwise.");
    }
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (orientation(previous(ring, k), ring[k], next(ring, k)) == 0) {
        broken("Vertex " + text(k) + " of the exact ring is collinear with its neighbours.");
        break;
      }
    }
    if (const auto edges = find_meeting(ring)) {
      broken("Edges " + text(edges->first) + " and " + text(edges->second) +
             " of the exact ring meet.");
    }
  }

  void sources_are_true() {
    if (sum_.sources.size() != sum_.exact.size()) {
      broken("There is not one source for each edge of the exact ring.");
      return;
    }
    for (const std::size_t k : sample(sum_.exact.size(), effort_.work)) {
      if (!source_is_true(sum_.sources[k], sum_.exact[k], next(sum_.exact, k))) {
        const gcv_edge_source& s = sum_.sources[k];
        broken("The source of edge " + text(k) + ", of kind " + std::to_string(s.kind) + ", a " +
               text(s.a) + ", b " + text(s.b) + ", is not true.");
        return;
      }
    }
  }

  // Does the ring edge from p to q start on the superset edge that the source names, and
  // go along it?
  [[nodiscard]] bool source_is_true(const gcv_edge_source& s, const Exact& p,
                                    const Exact& q) const {
    const bool a_is_edge = s.kind != GCV_EDGE_CORNER;
    const bool b_is_edge = s.kind != GCV_EDGE_TRANSLATED;
    const Ring& a = a_.ring;
    const Ring& b = b_.ring;
    if (s.kind < GCV_EDGE_TRANSLATED || s.kind > GCV_EDGE_TRANSLATED_CORNER ||
        s.a >= given_a_.size() || s.b >= given_b_.size()) {
      return false;
    }
    const std::size_t i = (a_is_edge ? a_.edge : a_.vertex)[s.a];
    const std::size_t j = (b_is_edge ? b_.edge : b_.vertex)[s.b];
    if (i >= a.size() || j >= b.size()) {
      return false;
    }
    const Exact along_a = next(a, i) - a[i];
    const Exact along_b = next(b, j) - b[j];
    const bool is_superset_edge =
        !a_is_edge   ? contributes(a, i, along_b)
        : !b_is_edge ? contributes(b, j, along_a)
                     : sign(cross(along_a, along_b)) == 0 && sign(dot(along_a, along_b)) > 0;
    const Exact from = a[i] + b[j];
    const Exact to = (a_is_edge ? next(a, i) : a[i]) + (b_is_edge ? next(b, j) : b[j]);
    return is_superset_edge && on_segment(from, to, p) && !(p == to) &&
           orientation(from, to, q) == 0 && sign(dot(to - from, q - p)) > 0;
  }

  void hulls_add() {
    if (!(hull(sum_.exact) == sum_of_hulls(hull(a_.ring), hull(b_.ring)))) {
      broken("The hull of the sum is not the sum of the hulls.");
    }
  }

  // sqrt(s) >= sqrt(a) + sqrt(b), squared twice.
  void brunn_minkowski() {
    const Rational a = twice_area(a_.ring);
    const Rational b = twice_area(b_.ring);
    const Ring& ring = sum_.exact;
    const Rational rest = (ring.size() < 100 ? twice_area(ring) : twice_area_bound(ring)) - a - b;
    if (rest < 0 || rest * rest < 4 * a * b) {
      broken("The sum is smaller than Brunn and Minkowski allow.");
    }
  }

  void vertex_sums_are_inside() {
    const std::size_t m = b_.ring.size();
    for (const std::size_t k : sample(a_.ring.size() * m, samples(sum_.exact.size()))) {
      if (location(sum_.exact, a_.ring[k / m] + b_.ring[k % m]) < 0) {
        broken("The sum of a vertex of a and one of b lies outside the exact ring: corners " +
               text(k / m) + " and " + text(k % m) + ".");
        return;
      }
    }
  }

  // x is in a + b where x - b meets a: an independent test for points beside the ring.
  void sides_of_edges() {
    const std::vector<Box> boxes = edge_boxes(a_.ring);
    const auto in_sum = [&](const Exact& x) {
      Ring reflected;
      for (const Exact& p : b_.ring) {
        reflected.push_back(x - p);
      }
      return polygons_meet(a_.ring, boxes, reflected);
    };
    const std::size_t edges = a_.ring.size() + b_.ring.size() + sum_.exact.size();
    for (const std::size_t k : sample(sum_.exact.size(), samples(edges))) {
      // Not the very middle, where by symmetry a hole may touch the ring.
      const Exact along = next(sum_.exact, k) - sum_.exact[k];
      const Exact middle = sum_.exact[k] + Rational(509, 1021) * along;
      const Exact outward{along.y, -along.x};
      if (in_sum(middle + reach(middle, outward, k) / 2 * outward)) {
        broken("A point just outside edge " + text(k) + " of the exact ring is not free.");
        return;
      }
      // A hole may be near, though nobody knows how near.
      const Exact inward = (reach(middle, Rational(-1) * outward, k) * Rational(-1)) * outward;
      const bool inside_is_solid = [&] {
        for (const unsigned shift : {64U, 256U, 1024U, 4096U}) {
          const Rational nearness(1, boost::multiprecision::mpz_int(1) << shift);
          if (in_sum(middle + nearness * inward)) {
            return true;
          }
        }
        return false;
      }();
      if (!inside_is_solid) {
        broken("The points just inside edge " + text(k) + " of the exact ring are free.");
        return;
      }
    }
  }

  // The least t > 0 for which x + t direction is on the exact ring; at most 1. x is on
  // edge k.
  [[nodiscard]] Rational reach(const Exact& x, const Exact& direction, std::size_t k) const {
    const Ring& ring = sum_.exact;
    Rational least = 1;
    std::vector<int> sides;
    for (const Exact& p : ring) {
      sides.push_back(sign(cross(direction, p - x)));
    }
    for (std::size_t l = 0; l < ring.size(); ++l) {
      if (l == k || sides[l] * next(sides, l) > 0) {
        continue;
      }
      const Exact& p = ring[l];
      const Exact along = next(ring, l) - p;
      const Rational slope = cross(direction, along);
      // An edge on the ray begins or ends in vertices that its neighbours have too.
      const Rational t = slope == 0 ? dot(p - x, direction) / dot(direction, direction)
                                    : cross(p - x, along) / slope;
      if (t > 0 && t < least) {
        least = t;
      }
    }
    return least;
  }

  void well_formed_returned_ring(const Sum& s, const std::string& name) {
    const Ring ring = exact(s.returned);
    if (ring.size() < 3 || canonical(s.returned) != s.returned) {
      broken(name + " does not start at its smallest vertex.");
      return;
    }
    Ring corners;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (orientation(previous(ring, k), ring[k], next(ring, k)) != 0) {
        corners.push_back(ring[k]);
      }
    }
    if (const auto edges = find_meeting(ring)) {
      broken("Edges " + text(edges->first) + " and " + text(edges->second) + " of " + name +
             " meet.");
    } else if (orientation(corners.back(), corners[0], corners[1]) <= 0) {
      broken(name + " is not counter-clockwise.");
    }
    if (!(exact(s.as_polygon) == corners)) {
      broken(name + " as a polygon has not the same corners.");
    }
    const Rational area = twice_area(ring) / 2;
    if (std::isfinite(s.area) ? nearest(area) != s.area
                              : area <= Rational(std::numeric_limits<double>::max())) {
      broken("The area of " + name + " is not correctly rounded.");
    }
  }

  void nearest_doubles() {
    Polygon rounded;
    for (const Exact& p : sum_.exact) {
      rounded.push_back(nearest(p));
    }
    if (sum_.repaired == 0) {
      if (canonical(without_repetitions(rounded)) != sum_.returned) {
        broken("Nothing was repaired, but a returned coordinate is not the nearest double.");
      }
      return;
    }
    const std::set<Point> places(rounded.begin(), rounded.end());
    const auto moved = std::count_if(sum_.returned.begin(), sum_.returned.end(),
                                     [&](const Point& p) { return !places.contains(p); });
    if (static_cast<std::uint64_t>(moved) > sum_.repaired) {
      broken("More vertices are not the nearest doubles than the statistics say.");
    }
  }

  void error_bound(const Sum& s, const std::string& name) {
    const Ring returned = exact(s.returned);
    if (!all_near(s.exact, returned, s.error_bound)) {
      broken("A vertex of the exact ring is further away than " + name + " says.");
    }
    if (!all_near(returned, s.exact, s.error_bound)) {
      broken("A returned vertex is further from the exact ring than " + name + " says.");
    }
  }

  void commutes() {
    if (!(sum(given_b_, given_a_).exact == sum_.exact)) {
      broken("b + a is not a + b.");
    }
  }

  static Polygon transformed(Polygon polygon, const std::function<Point(const Point&)>& f) {
    std::transform(polygon.begin(), polygon.end(), polygon.begin(), f);
    return polygon;
  }

  // By the first of some vectors for which all sums are doubles, if there is one.
  void translates() {
    double size = 0;
    for (const Point& p : given_a_) {
      size = std::max({size, std::abs(p[0]), std::abs(p[1])});
    }
    std::vector<Point> vectors{{-given_a_[0][0], -given_a_[0][1]}, {size, -size}};
    for (const int exponent : {1, -3, -10, -30, -50}) {
      const double step = std::ldexp(1.0, std::ilogb(size) + exponent);
      vectors.push_back({3 * step, -5 * step});
    }
    for (const Point& v : vectors) {
      if (!all_finite({v})) {
        continue;
      }
      const Exact t = exact(v);
      const Polygon moved = transformed(given_a_, [&](const Point& p) {
        return Point{p[0] + v[0], p[1] + v[1]};
      });
      const bool is_exact =
          all_finite(moved) &&
          std::equal(given_a_.begin(), given_a_.end(), moved.begin(),
                     [&](const Point& p, const Point& q) { return exact(p) + t == exact(q); });
      if ((v[0] == 0 && v[1] == 0) || !is_exact) {
        continue;
      }
      Ring expected = sum_.exact;
      std::transform(expected.begin(), expected.end(), expected.begin(),
                     [&](const Exact& p) { return p + t; });
      try {
        if (!(sum(moved, given_b_).exact == expected)) {
          broken("The sum does not move with a.");
        }
      } catch (const Failure& failure) {
        if (failure.status != GCV_ERR_RANGE) {
          note(failure, "a translated + b");
        }
      }
      return;
    }
  }

  void scales() {
    for (const int exponent : {37, -61}) {
      const auto in_range = [&](double x) {
        return x == 0 || (std::isnormal(x) && std::isnormal(std::ldexp(x, exponent)));
      };
      const auto all_in_range = [&](const Polygon& polygon) {
        return std::all_of(polygon.begin(), polygon.end(),
                           [&](const Point& p) { return in_range(p[0]) && in_range(p[1]); });
      };
      const bool none_is_lost =
          std::all_of(sum_.exact.begin(), sum_.exact.end(), [&](const Exact& p) {
            return (p.x == 0 || nearest(p.x) != 0) && (p.y == 0 || nearest(p.y) != 0);
          });
      if (!none_is_lost || !all_in_range(given_a_) || !all_in_range(given_b_) ||
          !all_in_range(sum_.returned)) {
        continue;
      }
      const auto scaled = [&](const Polygon& polygon) {
        return transformed(polygon, [&](const Point& p) {
          return Point{std::ldexp(p[0], exponent), std::ldexp(p[1], exponent)};
        });
      };
      if (sum(scaled(given_a_), scaled(given_b_)).returned != scaled(sum_.returned)) {
        broken("The returned ring does not scale by 2^" + std::to_string(exponent) + ".");
      }
    }
  }

  void reflects() {
    const auto mirrored = [&](const auto& f, const auto& g, const char* what) {
      Ring expected = sum_.exact;
      std::transform(expected.begin(), expected.end(), expected.begin(), g);
      std::reverse(expected.begin(), expected.end());
      if (!(sum(transformed(given_a_, f), transformed(given_b_, f)).exact == canonical(expected))) {
        broken(std::string("The sum does not follow ") + what + ".");
      }
    };
    mirrored(
        [](const Point& p) {
          return Point{-p[0], p[1]};
        },
        [](const Exact& p) {
          return Exact{-p.x, p.y};
        },
        "a reflection");
    mirrored(
        [](const Point& p) {
          return Point{p[1], p[0]};
        },
        [](const Exact& p) {
          return Exact{p.y, p.x};
        },
        "an exchange of the axes");
  }

  void outward() {
    const Sum s = sum(given_a_, given_b_, GCV_ROUND_OUTWARD);
    well_formed_returned_ring(s, "the ring rounded outward");
    error_bound(s, "the error bound of rounding outward");
    const Ring returned = exact(s.returned);
    for (const std::size_t k : sample(s.exact.size(), samples(returned.size()))) {
      if (location(returned, s.exact[k]) < 0) {
        broken("Exact vertex " + text(k) + " lies outside the ring rounded outward.");
        break;
      }
    }
    for (const std::size_t k : sample(returned.size(), samples(s.exact.size()))) {
      if (location(s.exact, returned[k]) > 0) {
        broken("Vertex " + text(k) + " of the ring rounded outward lies inside the exact one.");
        break;
      }
    }
    for_each_overlap(edge_boxes(s.exact), edge_boxes(returned), [&](std::size_t i, std::size_t j) {
      const bool cross =
          segments_cross(s.exact[i], next(s.exact, i), returned[j], next(returned, j));
      if (cross) {
        broken("Edge " + text(j) + " of the ring rounded outward crosses exact edge " + text(i) +
               ".");
      }
      return !cross;
    });
  }

  const Polygon& given_a_;
  const Polygon& given_b_;
  const Effort& effort_;
  Sum sum_;
  Normalised a_;
  Normalised b_;
  std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> broken_invariants(const Polygon& a, const Polygon& b,
                                           const Effort& effort) {
  return Check(a, b, effort).run();
}

bool is_simple(const Polygon& ring) { return ring.size() > 2 && !find_meeting(exact(ring)); }

Rounded rounded_sum(const Polygon& a, const Polygon& b) {
  Sum s = sum(a, b);
  Rounded rounded{{}, std::move(s.returned), s.error_bound};
  for (const Exact& p : s.exact) {
    rounded.naive.push_back(nearest(p));
  }
  rounded.naive = without_repetitions(rounded.naive);
  return rounded;
}

std::string wkt(const Polygon& ring) {
  if (ring.empty()) {
    return "POLYGON EMPTY";
  }
  std::string text = "POLYGON ((";
  for (std::size_t k = 0; k <= ring.size(); ++k) {
    char vertex[64];
    const Point& p = ring[k % ring.size()];
    std::snprintf(vertex, sizeof vertex, "%s%.17g %.17g", k == 0 ? "" : ", ", p[0], p[1]);
    text += vertex;
  }
  return text + "))";
}

}  // namespace gcv::invariants

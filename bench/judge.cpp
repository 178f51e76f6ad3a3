// SPDX-License-Identifier: LGPL-3.0-or-later
#include "judge.hpp"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <gcv/gcv.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>

#include "systems/cgal.hpp"

namespace gcv::bench {

namespace {

using Rational = Kernel::FT::ET;
using DoubleKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using DoublePoints = std::vector<DoubleKernel::Point_2>;

constexpr double most_resolutions = 10;  // of the error where nothing is lost

struct Fraction {
  Rational x;
  Rational y;
};

void check(gcv_status status) {
  if (status != GCV_OK) {
    throw std::runtime_error(gcv_last_error_message());
  }
}

template <class Handle>
using Owned = std::unique_ptr<Handle, void (*)(Handle*)>;

Owned<gcv_polygon> make_handle(const Ring& ring) {
  gcv_polygon* polygon = nullptr;
  check(gcv_polygon_create(&ring.data()->x, ring.size(), 0, &polygon));
  return {polygon, gcv_polygon_destroy};
}

std::vector<Fraction> exact_ring(const Ring& a, const Ring& b) {
  gcv_outer_face* sum = nullptr;
  check(gcv_minkowski_sum(make_handle(a).get(), make_handle(b).get(), nullptr, &sum));
  const Owned<gcv_outer_face> face(sum, gcv_outer_face_destroy);
  std::size_t count = 0;
  check(gcv_outer_face_exact_vertex_count(sum, &count));
  std::vector<Fraction> ring;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t length = 0;  // with the final NUL
    check(gcv_outer_face_exact_vertex(sum, k, nullptr, 0, &length));
    std::string text(length, ' ');
    check(gcv_outer_face_exact_vertex(sum, k, text.data(), length, &length));
    text.pop_back();
    const std::size_t space = text.find(' ');
    ring.push_back({Rational(text.substr(0, space)), Rational(text.substr(space + 1))});
  }
  return ring;
}

// Three doubles hold more digits than binary128.
Wide to_wide(Rational x) {
  Wide sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double part = CGAL::to_double(x);
    sum += part;
    x -= Rational(part);
  }
  return sum;
}

std::optional<Ring> as_doubles(const std::vector<Fraction>& ring) {
  Ring doubles;
  for (const auto& [x, y] : ring) {
    doubles.push_back({CGAL::to_double(x), CGAL::to_double(y)});
    if (Rational(doubles.back().x) != x || Rational(doubles.back().y) != y) {
      return std::nullopt;
    }
  }
  return doubles;
}

DoublePoints to_points(const Ring& ring) {
  DoublePoints points;
  for (const Point& p : ring) {
    points.emplace_back(p.x, p.y);
  }
  return points;
}

// Without collinear vertices, from the lexicographically smallest.
Ring canonical(const Ring& ring) {
  const DoublePoints points = to_points(ring);
  const std::size_t n = ring.size();
  Ring corners;
  for (std::size_t k = 0; k < n; ++k) {
    if (!CGAL::collinear(points[(k + n - 1) % n], points[k], points[(k + 1) % n])) {
      corners.push_back(ring[k]);
    }
  }
  std::rotate(corners.begin(),
              std::min_element(corners.begin(), corners.end(), lexicographically_less),
              corners.end());
  return corners;
}

double unit_in_the_last_place(const Ring& ring) {
  double largest = 0;
  for (const Point& p : ring) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  return std::nextafter(largest, HUGE_VAL) - largest;
}

}  // namespace

struct Judge::Exact {
  std::vector<Fraction> ring;
  std::optional<Ring> doubles;  // where each coordinate is one
  CgalPolygon polygon;
  Point origin;  // which wide coordinates are relative to
  WideRing wide;

  // Does the region contain the exact one? A vertex outside says no; else nothing must be
  // left of the exact region without the other.
  [[nodiscard]] bool is_within(const DoublePoints& points) const {
    CgalPolygon region;
    for (const auto& p : points) {
      region.push_back(Kernel::Point_2(p.x(), p.y()));
    }
    if (region.is_clockwise_oriented()) {
      region.reverse_orientation();
    }
    const std::size_t step = polygon.size() / 64 + 1;
    for (std::size_t k = 0; k < polygon.size(); k += step) {
      if (region.has_on_unbounded_side(polygon[k])) {
        return false;
      }
    }
    std::vector<CGAL::Polygon_with_holes_2<Kernel>> rest;
    CGAL::difference(polygon, region, std::back_inserter(rest));
    return rest.empty();
  }
};

Judge::Judge(const Ring& a, const Ring& b) : exact_(std::make_unique<Exact>()) {
  exact_->ring = exact_ring(a, b);
  exact_->doubles = as_doubles(exact_->ring);
  exact_->origin = {CGAL::to_double(exact_->ring[0].x), CGAL::to_double(exact_->ring[0].y)};
  const Rational x0(exact_->origin.x);
  const Rational y0(exact_->origin.y);
  for (const auto& [x, y] : exact_->ring) {
    exact_->polygon.push_back(Kernel::Point_2(Kernel::FT(x), Kernel::FT(y)));
    exact_->wide.push_back({to_wide(x - x0), to_wide(y - y0)});
  }
}

Judge::~Judge() = default;

std::size_t Judge::exact_vertices() const { return exact_->ring.size(); }

Verdict Judge::judge(const Ring& returned, double resolution, std::size_t corners) const {
  Ring ring;
  std::unique_copy(returned.begin(), returned.end(), std::back_inserter(ring));
  while (ring.size() > 1 && ring.front() == ring.back()) {
    ring.pop_back();
  }
  if (ring.size() < 3 || !std::all_of(ring.begin(), ring.end(), [](const Point& p) {
        return std::isfinite(p.x) && std::isfinite(p.y);
      })) {
    throw std::runtime_error("no ring");
  }
  WideRing wide;
  for (const Point& p : ring) {
    wide.push_back({Wide(p.x) - exact_->origin.x, Wide(p.y) - exact_->origin.y});
  }
  Verdict verdict;
  const bool is_exact = exact_->doubles && canonical(ring) == *exact_->doubles;
  verdict.error = is_exact ? Bounds{0, 0} : hausdorff_distance(wide, exact_->wide);
  const double finest = std::max(resolution, unit_in_the_last_place(ring));
  verdict.is_complete = verdict.error.lower <= most_resolutions * finest &&
                        (corners == 0 || corners == exact_->ring.size());
  const DoublePoints points = to_points(ring);
  verdict.is_simple = CGAL::is_simple_2(points.begin(), points.end(), DoubleKernel());
  if (verdict.is_simple) {
    verdict.is_counter_clockwise =
        CGAL::orientation_2(points.begin(), points.end(), DoubleKernel()) == CGAL::COUNTERCLOCKWISE;
    verdict.contains_exact = is_exact || exact_->is_within(points);
  }
  return verdict;
}

double diameter(const Ring& ring) {
  const DoublePoints points = to_points(ring);
  DoublePoints hull;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  double largest = 0;
  for (const auto& p : hull) {
    for (const auto& q : hull) {
      largest = std::max(largest, std::hypot(p.x() - q.x(), p.y() - q.y()));
    }
  }
  return largest;
}

}  // namespace gcv::bench

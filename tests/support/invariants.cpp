// SPDX-License-Identifier: LGPL-3.0-or-later
#include "invariants.hpp"

#include <gcv/gcv.h>

#include <algorithm>
#include <bit>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace gcv::invariants {

namespace {

using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

// ------------------------------------------------------------------- exact geometry --

struct Exact {
  Rational x;
  Rational y;
};

using Ring = std::vector<Exact>;

bool operator==(const Exact& p, const Exact& q) { return p.x == q.x && p.y == q.y; }
bool operator<(const Exact& p, const Exact& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }
Exact operator+(const Exact& p, const Exact& q) { return {p.x + q.x, p.y + q.y}; }
Exact operator-(const Exact& p, const Exact& q) { return {p.x - q.x, p.y - q.y}; }
Exact operator*(const Rational& t, const Exact& p) { return {t * p.x, t * p.y}; }

Rational cross(const Exact& p, const Exact& q) { return p.x * q.y - p.y * q.x; }
Rational dot(const Exact& p, const Exact& q) { return p.x * q.x + p.y * q.y; }
int sign(const Rational& x) { return x.sign(); }

// Above 0: r lies left of the line from p to q.
int orientation(const Exact& p, const Exact& q, const Exact& r) {
  return sign(cross(q - p, r - p));
}

template <typename Vector>
const auto& next(const Vector& ring, std::size_t k) {
  return ring[k + 1 == ring.size() ? 0 : k + 1];
}
template <typename Vector>
const auto& previous(const Vector& ring, std::size_t k) {
  return ring[k == 0 ? ring.size() - 1 : k - 1];
}

Exact exact(const Point& p) { return {Rational(p[0]), Rational(p[1])}; }

Ring exact(const Polygon& polygon) {
  Ring ring;
  for (const Point& p : polygon) {
    ring.push_back(exact(p));
  }
  return ring;
}

// Doubles close below and above x.
double below(const Rational& x) {
  const double towards_zero = mpq_get_d(x.backend().data());
  return std::nextafter(std::nextafter(towards_zero, -HUGE_VAL), -HUGE_VAL);
}
double above(const Rational& x) { return -below(-x); }

// The double nearest to x, ties to even.
double nearest(const Rational& x) {
  double best = below(x);
  for (int k = 0; k < 4; ++k) {
    const double candidate = std::nextafter(best, HUGE_VAL);
    if (!std::isfinite(candidate)) {
      break;
    }
    const Rational gain = abs(x - Rational(best)) - abs(x - Rational(candidate));
    if (gain < 0 || (gain == 0 && std::bit_cast<std::uint64_t>(best) % 2 == 0)) {
      break;
    }
    best = candidate;
  }
  return best == 0 ? 0 : best;
}

Point nearest(const Exact& p) { return {nearest(p.x), nearest(p.y)}; }

// From the lexicographically smallest vertex.
template <typename Vector>
Vector canonical(Vector ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

template <typename Vector>
Vector without_repetitions(const Vector& ring) {
  Vector distinct;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (!(ring[k] == next(ring, k))) {
      distinct.push_back(ring[k]);
    }
  }
  return distinct;
}

Rational twice_area(const Ring& ring) {
  Rational sum = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    sum += cross(ring[k] - ring[0], ring[k + 1] - ring[0]);
  }
  return sum;
}

// An upper bound on it. Fractions with unlike denominators do not add up cheaply: each is
// rounded up first, to 2^-256 of the largest.
Rational twice_area_bound(const Ring& ring) {
  using boost::multiprecision::mpz_int;
  std::vector<Rational> terms;
  Rational largest = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    terms.push_back(cross(ring[k] - ring[0], ring[k + 1] - ring[0]));
    largest = std::max<Rational>(largest, abs(terms.back()));
  }
  const Rational unit = largest / Rational(mpz_int(1) << 256);
  mpz_int units = 0;
  for (const Rational& term : terms) {
    const Rational quotient = term / unit;
    units += mpz_int(numerator(quotient) / denominator(quotient)) + 1;
  }
  return Rational(units) * unit;
}

bool between(const Exact& p, const Exact& q, const Exact& x) {
  return !(std::max(p, q) < x) && !(x < std::min(p, q));
}

bool on_segment(const Exact& p, const Exact& q, const Exact& x) {
  return orientation(p, q, x) == 0 && between(p, q, x);
}

bool segments_meet(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
  const int c_side = orientation(a, b, c);
  const int d_side = orientation(a, b, d);
  if (c_side == 0 && d_side == 0) {
    return between(a, b, c) || between(a, b, d) || between(c, d, a);
  }
  return c_side * d_side <= 0 && orientation(c, d, a) * orientation(c, d, b) <= 0;
}

bool segments_cross(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

Rational squared_distance(const Exact& p, const Exact& q, const Exact& x) {
  const Exact along = q - p;
  const Exact to_x = x - p;
  const Rational t = dot(to_x, along) / dot(along, along);
  const Exact rest = to_x - std::clamp<Rational>(t, 0, 1) * along;
  return dot(rest, rest);
}

// 1 inside, 0 on the ring, -1 outside.
int location(const Ring& ring, const Exact& x) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Exact& p = ring[k];
    const Exact& q = next(ring, k);
    if ((p.y <= x.y) != (q.y <= x.y)) {
      const int side = orientation(p, q, x);
      if (side == 0) {
        return 0;
      }
      inside ^= (side > 0) == (p.y < q.y);
    } else if (p == x || (p.y == x.y && q.y == x.y && between(p, q, x))) {
      return 0;
    }
  }
  return inside ? 1 : -1;
}

// Counter-clockwise, from the smallest point, without collinear ones.
Ring hull(Ring points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto chain = [](auto first, auto last) {
    Ring half;
    for (; first != last; ++first) {
      while (half.size() > 1 && orientation(half.end()[-2], half.back(), *first) <= 0) {
        half.pop_back();
      }
      half.push_back(*first);
    }
    half.pop_back();
    return half;
  };
  Ring ring = chain(points.begin(), points.end());
  const Ring upper = chain(points.rbegin(), points.rend());
  ring.insert(ring.end(), upper.begin(), upper.end());
  return ring;
}

Ring sum_of_hulls(const Ring& a, const Ring& b) {
  Ring sum;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    sum.push_back(a[i % a.size()] + b[j % b.size()]);
    int turn = i == a.size() ? -1 : 1;
    if (i < a.size() && j < b.size()) {
      turn = sign(cross(next(a, i) - a[i], next(b, j) - b[j]));
    }
    i += turn >= 0 ? 1 : 0;
    j += turn <= 0 ? 1 : 0;
  }
  return sum;
}

// ------------------------------------------------------------------------- box pairs --

struct Box {
  std::array<double, 2> low;
  std::array<double, 2> high;
};

Box box(const Exact& p, const Exact& q) {
  const auto& [x0, x1] = std::minmax(p.x, q.x);
  const auto& [y0, y1] = std::minmax(p.y, q.y);
  return {{below(x0), below(y0)}, {above(x1), above(y1)}};
}

std::vector<Box> edge_boxes(const Ring& ring) {
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    boxes.push_back(box(ring[k], next(ring, k)));
  }
  return boxes;
}

// Calls visit(i, j) for all boxes p[i] and q[j] that overlap, until it returns false. A
// sweep along the axis on which the boxes are shorter.
void for_each_overlap(const std::vector<Box>& p, const std::vector<Box>& q,
                      const std::function<bool(std::size_t, std::size_t)>& visit) {
  std::array<double, 2> length{};
  for (const auto* boxes : {&p, &q}) {
    for (const Box& b : *boxes) {
      length[0] += b.high[0] / 4 - b.low[0] / 4;
      length[1] += b.high[1] / 4 - b.low[1] / 4;
    }
  }
  const std::size_t axis = length[1] < length[0] ? 1 : 0;
  struct Side {
    const std::vector<Box>& boxes;
    std::vector<std::size_t> order;
    std::vector<std::size_t> active;
    std::size_t begun = 0;
  };
  std::array<Side, 2> sides{Side{p, {}, {}}, Side{q, {}, {}}};
  for (Side& side : sides) {
    for (std::size_t k = 0; k < side.boxes.size(); ++k) {
      side.order.push_back(k);
    }
    std::sort(side.order.begin(), side.order.end(), [&](std::size_t k, std::size_t l) {
      return side.boxes[k].low[axis] < side.boxes[l].low[axis];
    });
  }
  const auto start = [&](const Side& side) {
    return side.begun == side.order.size() ? HUGE_VAL
                                           : side.boxes[side.order[side.begun]].low[axis];
  };
  while (sides[0].begun < p.size() || sides[1].begun < q.size()) {
    const std::size_t s = start(sides[1]) < start(sides[0]) ? 1 : 0;
    Side& mine = sides[s];
    Side& other = sides[1 - s];
    const std::size_t k = mine.order[mine.begun++];
    const Box& b = mine.boxes[k];
    std::erase_if(other.active,
                  [&](std::size_t l) { return other.boxes[l].high[axis] < b.low[axis]; });
    for (const std::size_t l : other.active) {
      const Box& c = other.boxes[l];
      if (b.low[1 - axis] <= c.high[1 - axis] && c.low[1 - axis] <= b.high[1 - axis] &&
          !(s == 0 ? visit(k, l) : visit(l, k))) {
        return;
      }
    }
    mine.active.push_back(k);
  }
}

// Two edges that meet where they should not.
std::optional<std::pair<std::size_t, std::size_t>> find_meeting(const Ring& ring) {
  std::optional<std::pair<std::size_t, std::size_t>> found;
  const auto folds_back = [&](std::size_t k) {
    const Exact in = next(ring, k) - ring[k];
    const Exact out = next(ring, (k + 1) % ring.size()) - next(ring, k);
    return sign(cross(in, out)) == 0 && sign(dot(in, out)) <= 0;
  };
  const std::vector<Box> boxes = edge_boxes(ring);
  for_each_overlap(boxes, boxes, [&](std::size_t i, std::size_t j) {
    const bool meet = j == (i + 1) % ring.size()
                          ? folds_back(i)
                          : i + 1 < j && (i != 0 || j + 1 != ring.size()) &&
                                segments_meet(ring[i], next(ring, i), ring[j], next(ring, j));
    if (meet) {
      found = {i, j};
    }
    return !meet;
  });
  return found;
}

bool polygons_meet(const Ring& a, const std::vector<Box>& boxes_of_a, const Ring& b) {
  bool meet = false;
  for_each_overlap(boxes_of_a, edge_boxes(b), [&](std::size_t i, std::size_t j) {
    meet = segments_meet(a[i], next(a, i), b[j], next(b, j));
    return !meet;
  });
  return meet || location(a, b[0]) >= 0 || location(b, a[0]) >= 0;
}

// --------------------------------------------------------------------- the C interface --

struct Destroy {
  void operator()(gcv_polygon* polygon) const { gcv_polygon_destroy(polygon); }
  void operator()(gcv_outer_face* face) const { gcv_outer_face_destroy(face); }
};

using PolygonHandle = std::unique_ptr<gcv_polygon, Destroy>;

// Failures of the library that end a check.
struct Failure : std::runtime_error {
  Failure(gcv_status code, const std::string& what)
      : std::runtime_error(what + ": " + gcv_status_name(code) + ", " + gcv_last_error_message()),
        status(code) {}
  gcv_status status;
};

void require(gcv_status status, const char* what) {
  if (status != GCV_OK) {
    throw Failure(status, what);
  }
}

template <typename Handle>
Polygon vertices(gcv_status (*get)(const Handle*, double*, std::size_t, std::size_t*),
                 const Handle* handle) {
  std::size_t count = 0;
  require(get(handle, nullptr, 0, &count), "the number of vertices");
  Polygon polygon(count);
  require(get(handle, polygon.front().data(), count, &count), "the vertices");
  return polygon;
}

PolygonHandle make(const Polygon& polygon) {
  gcv_polygon* handle = nullptr;
  const double* const xy = polygon.empty() ? nullptr : polygon.front().data();
  require(gcv_polygon_create(xy, polygon.size(), 0, &handle), "a polygon");
  return PolygonHandle(handle);
}

bool all_finite(const Polygon& polygon) {
  return std::all_of(polygon.begin(), polygon.end(),
                     [](const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); });
}

struct Sum {
  Ring exact;
  Polygon returned;
  std::vector<gcv_edge_source> sources;
  double error_bound = 0;
  double area = 0;
  std::uint64_t repaired = 0;
  Polygon as_polygon;
};

Ring exact_ring(const gcv_outer_face* face) {
  std::size_t count = 0;
  require(gcv_outer_face_exact_vertex_count(face, &count), "the number of exact vertices");
  Ring ring;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t length = 0;
    require(gcv_outer_face_exact_vertex(face, k, nullptr, 0, &length), "a length");
    std::string text(length, ' ');
    require(gcv_outer_face_exact_vertex(face, k, text.data(), length, &length), "an exact vertex");
    const std::size_t space = text.find(' ');
    ring.push_back(
        {Rational(text.substr(0, space)), Rational(text.substr(space + 1, length - space - 2))});
  }
  return ring;
}

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

// `count` of the numbers below `total`, evenly spread.
std::vector<std::size_t> sample(std::size_t total, std::size_t count) {
  std::vector<std::size_t> numbers;
  const double step = std::max(1.0, static_cast<double>(total) / static_cast<double>(count + 1));
  for (double x = 0; x < static_cast<double>(total); x += step) {
    numbers.push_back(static_cast<std::size_t>(x));
  }
  return numbers;
}

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

  // Are all the points within the distance of the ring?
  static bool all_near(const Ring& points, const Ring& ring, double distance) {
    const Rational d(distance);
    std::vector<Box> boxes;
    for (const Exact& p : points) {
      boxes.push_back({{below(p.x - d), below(p.y - d)}, {above(p.x + d), above(p.y + d)}});
    }
    std::vector<bool> near(points.size());
    for_each_overlap(boxes, edge_boxes(ring), [&](std::size_t i, std::size_t k) {
      near[i] = near[i] || squared_distance(ring[k], next(ring, k), points[i]) <= d * d;
      return true;
    });
    return std::find(near.begin(), near.end(), false) == near.end();
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

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_reference.hpp"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Rational_traits.h>

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cfloat>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace gcv::reference {

namespace {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using Wide = __int128;

// ---- Vectors. Numbers are Integer, Wide, or Rational.

template <class N>
struct Vector {
  N x;
  N y;

  friend bool operator==(const Vector& p, const Vector& q) { return p.x == q.x && p.y == q.y; }
  friend bool operator>(const Vector& p, const Vector& q) { return q < p; }
  friend bool operator<(const Vector& p, const Vector& q) {
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  }
  friend Vector operator+(const Vector& p, const Vector& q) { return {p.x + q.x, p.y + q.y}; }
  friend Vector operator-(const Vector& p, const Vector& q) { return {p.x - q.x, p.y - q.y}; }
  friend Vector operator-(const Vector& p) { return {-p.x, -p.y}; }
  friend Vector operator*(const N& t, const Vector& p) { return {t * p.x, t * p.y}; }
};

template <class N>
N cross(const Vector<N>& p, const Vector<N>& q) {
  return p.x * q.y - p.y * q.x;
}
template <class N>
N dot(const Vector<N>& p, const Vector<N>& q) {
  return p.x * q.x + p.y * q.y;
}
template <class N>
bool on_open_segment(const Vector<N>& x, const Vector<N>& p, const Vector<N>& q) {
  return cross(q - p, x - p) == 0 && dot(x - p, q - x) > 0;
}

// ---- Sectors: open sets of directions, from `first` counter-clockwise to `last`.

using Direction = Vector<Integer>;
struct Sector {
  Direction first;
  Direction last;
};

// The quarter of directions, counted from d: d itself, left of d, opposite to d, right of d.
int quarter(const Direction& d, const Direction& e) {
  const Integer c = cross(d, e);
  return c > 0 ? 1 : c < 0 ? 3 : dot(d, e) > 0 ? 0 : 2;
}

// Turning counter-clockwise from d, is e met before f?
bool met_before(const Direction& d, const Direction& e, const Direction& f) {
  const int qe = quarter(d, e);
  const int qf = quarter(d, f);
  return qe != qf ? qe < qf : cross(e, f) > 0;
}

// Two arcs overlap if one of them begins inside the other, or both begin together.
bool overlap(const Sector& s, const Sector& t) {
  return met_before(s.first, t.first, s.last) || met_before(t.first, s.first, t.last);
}

Sector reflected(const Sector& s) { return {-s.first, -s.last}; }
Sector left_of(const Direction& d) { return {d, -d}; }

// ---- Solids: closed regions whose boundary is made of rings.

using ExactRing = std::vector<Vector<Integer>>;

// Without repeated and collinear vertices.
ExactRing cleaned(ExactRing ring) {
  for (std::size_t k = 0; k < ring.size();) {
    const std::size_t n = ring.size();
    const auto& p = ring[(k + n - 1) % n];
    const auto& q = ring[(k + 1) % n];
    if (cross(ring[k] - p, q - ring[k]) == 0) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;
    } else {
      ++k;
    }
  }
  return ring;
}

Integer twice_area(const ExactRing& ring) {
  Integer area = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    area += cross(ring[k], ring[(k + 1) % ring.size()]);
  }
  return area;
}

struct Solid {
  struct Edge {
    std::size_t from;
    std::size_t to;
  };

  // Each vertex once, also where rings touch.
  std::vector<Vector<Integer>> vertices;
  // The solid is left of each edge. Edges are cut where another ring touches them.
  std::vector<Edge> edges;
  // Where the solid is, seen from each vertex.
  std::vector<std::vector<Sector>> sectors;
  bool is_unbounded;

  [[nodiscard]] Direction direction(const Edge& e) const {
    return vertices[e.to] - vertices[e.from];
  }
};

// The polygon, or what is not in the polygon.
Solid make_solid(const std::vector<ExactRing>& rings, bool complement) {
  Solid solid;
  solid.is_unbounded = complement;
  std::map<Vector<Integer>, std::size_t> index;
  std::vector<ExactRing> turned;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    ExactRing ring = cleaned(rings[k]);
    const bool counter_clockwise = (k == 0) != complement;
    if ((twice_area(ring) > 0) != counter_clockwise) {
      std::reverse(ring.begin(), ring.end());
    }
    for (const auto& p : ring) {
      if (index.emplace(p, solid.vertices.size()).second) {
        solid.vertices.push_back(p);
      }
    }
    turned.push_back(std::move(ring));
  }
  for (const ExactRing& ring : turned) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto& p = ring[k];
      const auto& q = ring[(k + 1) % ring.size()];
      ExactRing places{p, q};
      for (const auto& x : solid.vertices) {
        if (on_open_segment(x, p, q)) {
          places.push_back(x);
        }
      }
      std::sort(places.begin(), places.end(),
                [&](const auto& x, const auto& y) { return dot(y - x, q - p) > 0; });
      for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        solid.edges.push_back({index[places[i]], index[places[i + 1]]});
      }
    }
  }
  // The solid begins left of an edge out of the vertex, and ends at the next edge into it.
  solid.sectors.resize(solid.vertices.size());
  for (const auto& out : solid.edges) {
    const Direction first = solid.direction(out);
    std::optional<Direction> last;
    for (const auto& in : solid.edges) {
      if (in.to == out.from) {
        const Direction back = -solid.direction(in);
        if (!last || met_before(first, back, *last)) {
          last = back;
        }
      }
    }
    solid.sectors[out.from].push_back({first, last.value()});
  }
  return solid;
}

// ---- Overlaps: do A and x - B have a common inner point? Exact for all x.

template <class N>
struct Homogeneous {
  N x;
  N y;
  N w;  // above 0
};

// Why the three questions of covers() suffice. If A and x - B have a common inner point, then the
// set of such points is open, and bounded, for B is. Follow its boundary: pieces of edges of A and
// of x - B which have it on their left. A piece ends where two edges cross properly (the first
// question), or where a vertex of one lies on an edge or vertex of the other. There the solid
// sectors of the two overlap (the second). If neither happens, the piece is an edge, its ends are
// inside the other solid (the third). On the other hand, each yes shows a common inner point: edges
// are cut at all vertices, so both solids are half-planes where edges cross properly.
template <class N>
struct Overlaps {
  struct Edge {
    Vector<N> from;
    Vector<N> to;
  };
  struct Side {
    std::vector<Vector<N>> vertices;
    std::vector<Edge> edges;
    bool is_unbounded;
  };
  struct Parallelogram {  // counter-clockwise: a corner, two sides, the area
    Vector<N> corner;
    Vector<N> u;
    Vector<N> v;
    N area;
  };

  Side a;
  Side b;
  std::vector<Parallelogram> crossings;  // of edges that are not parallel
  std::vector<Edge> slides;  // where a vertex of one and an edge of the other touch and overlap
  std::vector<Vector<N>> meetings;  // where two vertices touch and the solids overlap

  // Is x / w on the edge, without its ends?
  static bool on_open_edge(const Vector<N>& x, const N& w, const Edge& e) {
    const Vector<N> d = e.to - e.from;
    const Vector<N> y = x - w * e.from;
    return cross(d, y) == 0 && dot(d, y) > 0 && dot(d, w * e.to - x) > 0;
  }

  // Is x / w strictly inside the solid?
  static bool strictly_inside(const Side& side, const Vector<N>& x, const N& w) {
    bool inside = side.is_unbounded;
    for (const Edge& e : side.edges) {
      const Vector<N> p = w * e.from;
      const Vector<N> q = w * e.to;
      if (x == p || on_open_edge(x, w, e)) {
        return false;
      }
      if ((p.y > x.y) != (q.y > x.y)) {
        const bool to_the_left = cross(e.to - e.from, x - p) > 0;
        inside = inside != (to_the_left == (q.y > p.y));
      }
    }
    return inside;
  }

  [[nodiscard]] bool covers(const Homogeneous<N>& place) const {
    const N& w = place.w;
    const Vector<N> x{place.x, place.y};
    for (const Parallelogram& p : crossings) {
      const Vector<N> d = x - w * p.corner;
      const N s = cross(d, p.v);
      if (s <= 0 || s >= w * p.area) {
        continue;
      }
      const N t = cross(p.u, d);
      if (t > 0 && t < w * p.area) {
        return true;
      }
    }
    for (const Edge& e : slides) {
      if (on_open_edge(x, w, e)) {
        return true;
      }
    }
    for (const Vector<N>& p : meetings) {
      if (x == w * p) {
        return true;
      }
    }
    for (const Vector<N>& q : b.vertices) {
      if (strictly_inside(a, x - w * q, w)) {
        return true;
      }
    }
    for (const Vector<N>& p : a.vertices) {
      if (strictly_inside(b, x - w * p, w)) {
        return true;
      }
    }
    return false;
  }
};

Overlaps<Integer> make_overlaps(const Solid& a, const Solid& b) {
  Overlaps<Integer> result;
  const auto side = [](const Solid& solid) {
    Overlaps<Integer>::Side s{solid.vertices, {}, solid.is_unbounded};
    for (const auto& e : solid.edges) {
      s.edges.push_back({solid.vertices[e.from], solid.vertices[e.to]});
    }
    return s;
  };
  result.a = side(a);
  result.b = side(b);
  for (const auto& e : a.edges) {
    for (const auto& f : b.edges) {
      Direction u = a.direction(e);
      Direction v = b.direction(f);
      const Integer area = cross(u, v);
      if (area < 0) {
        std::swap(u, v);
      }
      if (area != 0) {
        result.crossings.push_back({a.vertices[e.from] + b.vertices[f.from], u, v, abs(area)});
      }
    }
  }
  const auto any_overlap = [](const std::vector<Sector>& of_a, const std::vector<Sector>& of_b) {
    return std::any_of(of_a.begin(), of_a.end(), [&](const Sector& s) {
      return std::any_of(of_b.begin(), of_b.end(),
                         [&](const Sector& t) { return overlap(s, reflected(t)); });
    });
  };
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    for (const auto& f : b.edges) {
      if (any_overlap(a.sectors[i], {left_of(b.direction(f))})) {
        result.slides.push_back(
            {a.vertices[i] + b.vertices[f.from], a.vertices[i] + b.vertices[f.to]});
      }
    }
    for (std::size_t j = 0; j < b.vertices.size(); ++j) {
      if (any_overlap(a.sectors[i], b.sectors[j])) {
        result.meetings.push_back(a.vertices[i] + b.vertices[j]);
      }
    }
  }
  for (std::size_t j = 0; j < b.vertices.size(); ++j) {
    for (const auto& e : a.edges) {
      if (any_overlap({left_of(a.direction(e))}, b.sectors[j])) {
        result.slides.push_back(
            {a.vertices[e.from] + b.vertices[j], a.vertices[e.to] + b.vertices[j]});
      }
    }
  }
  return result;
}

Vector<Wide> wide(const Vector<Integer>& p) {
  return {p.x.convert_to<std::int64_t>(), p.y.convert_to<std::int64_t>()};
}

Overlaps<Wide> wide(const Overlaps<Integer>& from) {
  Overlaps<Wide> result;
  const auto edge = [](const auto& e) { return Overlaps<Wide>::Edge{wide(e.from), wide(e.to)}; };
  const auto side = [&](const auto& s) {
    Overlaps<Wide>::Side to{{}, {}, s.is_unbounded};
    for (const auto& p : s.vertices) {
      to.vertices.push_back(wide(p));
    }
    for (const auto& e : s.edges) {
      to.edges.push_back(edge(e));
    }
    return to;
  };
  result.a = side(from.a);
  result.b = side(from.b);
  for (const auto& p : from.crossings) {
    const Vector<Wide> u = wide(p.u);
    const Vector<Wide> v = wide(p.v);
    result.crossings.push_back({wide(p.corner), u, v, cross(u, v)});
  }
  for (const auto& e : from.slides) {
    result.slides.push_back(edge(e));
  }
  for (const auto& p : from.meetings) {
    result.meetings.push_back(wide(p));
  }
  return result;
}

// Below 2 to the power of what?
int bits(const Integer& n) { return n == 0 ? 0 : static_cast<int>(msb(abs(n))) + 1; }

// ---- Places

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;

// CGAL's fractions, whichever of the classes around GMP's it uses.
template <class Fraction>
auto* gmp(Fraction& x) {
  if constexpr (requires { x.get_mpq_t(); }) {
    return x.get_mpq_t();
  } else {
    return x.backend().data();
  }
}

Rational rational(const Kernel::FT& x) {
  Rational result;
  mpq_set(result.backend().data(), gmp(x.exact()));
  return result;
}

Kernel::FT exact_number(const Rational& x) {
  std::decay_t<decltype(Kernel::FT().exact())> result;
  mpq_set(gmp(result), x.backend().data());
  return Kernel::FT(result);
}

// A place, and about where it is.
struct About {
  double x;
  double y;
  double error;
};

About about(const ExactPoint& p) {
  const auto [x0, x1] = CGAL::to_interval(p.x());
  const auto [y0, y1] = CGAL::to_interval(p.y());
  return {x0 + (x1 - x0) / 2, y0 + (y1 - y0) / 2, std::max(x1 - x0, y1 - y0)};
}

// All coordinates of the solids are below 2 to this power.
int bits(const Solid& a, const Solid& b) {
  int most = 0;
  for (const Solid* solid : {&a, &b}) {
    for (const auto& p : solid->vertices) {
      most = std::max({most, bits(p.x), bits(p.y)});
    }
  }
  return most;
}

// Asks whether places are in the open sum. Solids are 2^bits times as large as places are, with the
// bits of their largest coordinate. So all coordinates of places are small.
class OpenSum {
 public:
  OpenSum(const Solid& a, const Solid& b) : exact_(make_overlaps(a, b)), bits_(bits(a, b)) {
    if (bits_ < 60) {
      wide_ = wide(exact_);
    }
    const auto vector = [&](const auto& p) { return Vector<double>{rounded(p.x), rounded(p.y)}; };
    for (const auto& p : exact_.crossings) {
      const auto u = vector(p.u);
      const auto v = vector(p.v);
      rounded_.push_back({vector(p.corner), u, v, cross(u, v)});
    }
  }

  // Where edges are sure to cross; else unknown.
  bool surely_covers(const About& place) {
    // All coordinates are at most 2, rounded by an ulp or two.
    const double error = 64 * place.error + 1024 * DBL_EPSILON;
    const std::size_t n = rounded_.size();
    for (std::size_t k = 0; k < n; ++k) {
      const auto& p = rounded_[(last_ + k) % n];
      const Vector<double> d{place.x - p.corner.x, place.y - p.corner.y};
      const double s = cross(d, p.v);
      const double t = cross(p.u, d);
      if (s > error && t > error && p.area - s > error && p.area - t > error) {
        last_ = (last_ + k) % n;
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool covers(const Rational& x, const Rational& y) const {
    const Integer dx = denominator(x);
    const Integer dy = denominator(y);
    const Integer w = lcm(dx, dy);
    return covers({Integer((numerator(x) << bits_) * (w / dx)),
                   Integer((numerator(y) << bits_) * (w / dy)), w});
  }

  [[nodiscard]] bool covers(const Homogeneous<Integer>& place) const {
    const int xy = std::max(bits(place.x), bits(place.y));
    const int w = bits(place.w);
    if (wide_ && std::max(xy, w) < 63 && std::max(xy, w + bits_ + 1) + bits_ + 5 < 126) {
      return wide_->covers({place.x.convert_to<std::int64_t>(), place.y.convert_to<std::int64_t>(),
                            place.w.convert_to<std::int64_t>()});
    }
    return exact_.covers(place);
  }

 private:
  Overlaps<Integer> exact_;
  std::optional<Overlaps<Wide>> wide_;
  std::vector<Overlaps<double>::Parallelogram> rounded_;
  int bits_;
  std::size_t last_ = 0;

  [[nodiscard]] double rounded(const Integer& n) const {
    const int dropped = std::max(bits(n) - 64, 0);
    return std::ldexp(Integer(n >> static_cast<unsigned>(dropped)).convert_to<double>(),
                      dropped - bits_);
  }
};

// ---- The arrangement

using Traits = CGAL::Arr_segment_traits_2<Kernel>;
struct Mark {
  bool covered = false;   // in the open sum?
  bool visited = false;   // of halfedges
  std::size_t index = 0;  // of faces
};
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_extended_dcel<Traits, Mark, Mark, Mark>>;
using Halfedge = Arrangement::Halfedge_handle;
using Vertex = Arrangement::Vertex_handle;
using Face = Arrangement::Face_handle;

struct Span {
  Vector<Integer> from;
  Vector<Integer> to;
};

// All sums of an edge of one and a vertex of the other. Spans of one line that overlap are joined.
// This loses no vertex: other edges end where they end.
std::vector<Span> all_sums(const Solid& a, const Solid& b) {
  std::map<std::tuple<Integer, Integer, Integer>, std::vector<Span>> lines;
  const auto add = [&](const Solid& with_edges, const Solid& with_vertices) {
    for (const auto& e : with_edges.edges) {
      Direction d = with_edges.direction(e);
      const bool forward = d > Direction{0, 0};
      const Integer g = gcd(d.x, d.y);
      d = {d.x / g, d.y / g};
      if (!forward) {
        d = -d;
      }
      for (const auto& v : with_vertices.vertices) {
        const auto p = with_edges.vertices[forward ? e.from : e.to] + v;
        const auto q = with_edges.vertices[forward ? e.to : e.from] + v;
        lines[{d.x, d.y, cross(d, p)}].push_back({p, q});
      }
    }
  };
  add(a, b);
  add(b, a);
  std::vector<Span> joined;
  for (auto& [line, spans] : lines) {
    std::sort(spans.begin(), spans.end(),
              [](const Span& s, const Span& t) { return s.from < t.from; });
    joined.push_back(spans.front());
    for (const Span& s : spans) {
      if (joined.back().to < s.from) {
        joined.push_back(s);
      } else if (joined.back().to < s.to) {
        joined.back().to = s.to;
      }
    }
  }
  return joined;
}

ExactPoint point(const Vector<Integer>& p, int scale) {
  const auto coordinate = [&](const Integer& n) {
    if (bits(n) <= 53 && scale < 1000) {
      return Kernel::FT(std::ldexp(n.convert_to<double>(), -scale));
    }
    return exact_number(Rational(n, Integer(1) << scale));
  };
  return {coordinate(p.x), coordinate(p.y)};
}

// Is the point strictly left of all edges of the face? Then it is inside.
bool is_left_of_all_edges(const ExactPoint& p, const Face& face) {
  const auto first = face->outer_ccb();
  auto edge = first;
  do {
    if (!CGAL::left_turn(edge->source()->point(), edge->target()->point(), p)) {
      return false;
    }
  } while (++edge != first);
  return true;
}

// From the middle of one of its edges half the way to the first other edge on its left.
ExactPoint left_of_an_edge(const Face& face) {
  using V = Vector<Kernel::FT>;
  std::vector<std::pair<V, V>> edges;
  const auto add = [&](auto first) {
    auto edge = first;
    do {
      const ExactPoint& p = edge->source()->point();
      const ExactPoint& q = edge->target()->point();
      edges.emplace_back(V{p.x(), p.y()}, V{q.x(), q.y()});
    } while (++edge != first);
  };
  add(face->outer_ccb());
  for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end(); ++hole) {
    add(*hole);
  }
  const auto [p, q] = edges.front();
  const V middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
  const V left{p.y - q.y, q.x - p.x};
  std::optional<Kernel::FT> nearest;
  const auto hit = [&](const Kernel::FT& t) {
    if (t > 0 && (!nearest || t < *nearest)) {
      nearest = t;
    }
  };
  for (const auto& [r, s] : edges) {
    const Kernel::FT side_of_r = cross(left, r - middle);
    const Kernel::FT side_of_s = cross(left, s - middle);
    if (side_of_r == 0) {
      hit(dot(left, r - middle) / dot(left, left));
    }
    if (side_of_s == 0) {
      hit(dot(left, s - middle) / dot(left, left));
    }
    if ((side_of_r < 0 && side_of_s > 0) || (side_of_r > 0 && side_of_s < 0)) {
      hit(cross(r - middle, s - r) / cross(left, s - r));
    }
  }
  const Kernel::FT half_way = nearest.value() / 2;
  return {middle.x + half_way * left.x, middle.y + half_way * left.y};
}

// A point inside a bounded face: the middle of its corners if it can be, for that is soon found,
// and sooner in doubles.
ExactPoint inner_point(const Face& face) {
  if (face->inner_ccbs_begin() == face->inner_ccbs_end()) {
    double rounded_x = 0;
    double rounded_y = 0;
    Kernel::FT x = 0;
    Kernel::FT y = 0;
    int count = 0;
    const auto first = face->outer_ccb();
    auto edge = first;
    do {
      const ExactPoint& p = edge->target()->point();
      rounded_x += CGAL::to_double(p.x());
      rounded_y += CGAL::to_double(p.y());
      x += p.x();
      y += p.y();
      ++count;
    } while (++edge != first);
    if (std::isfinite(rounded_x) && std::isfinite(rounded_y)) {
      const ExactPoint middle(rounded_x / count, rounded_y / count);
      if (is_left_of_all_edges(middle, face)) {
        return middle;
      }
    }
    const ExactPoint middle(x / count, y / count);
    if (count == 3 || is_left_of_all_edges(middle, face)) {
      return middle;
    }
  }
  return left_of_an_edge(face);
}

// ---- Regions

using PointRing = std::vector<ExactPoint>;

bool less(const PointRing& r, const PointRing& s) {
  return std::lexicographical_compare(r.begin(), r.end(), s.begin(), s.end(),
                                      [](const ExactPoint& p, const ExactPoint& q) {
                                        return CGAL::lexicographically_xy_smaller(p, q);
                                      });
}

// Without its collinear vertices, from its smallest vertex.
PointRing canonical(const PointRing& points) {
  PointRing corners;
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!CGAL::collinear(points[(k + n - 1) % n], points[k], points[(k + 1) % n])) {
      corners.push_back(points[k]);
    }
  }
  std::rotate(corners.begin(),
              std::min_element(corners.begin(), corners.end(),
                               [](const ExactPoint& p, const ExactPoint& q) {
                                 return CGAL::lexicographically_xy_smaller(p, q);
                               }),
              corners.end());
  return corners;
}

class Region {
 public:
  // The region is the closure of the open sum, or what is not in the open sum.
  Region(const Solid& a, const Solid& b, bool is_sum)
      : open_sum_(a, b), bits_(bits(a, b)), is_sum_(is_sum) {
    std::vector<Traits::X_monotone_curve_2> segments;
    for (const Span& s : all_sums(a, b)) {
      segments.emplace_back(point(s.from, bits_), point(s.to, bits_));
    }
    CGAL::insert(arrangement_, segments.begin(), segments.end());
    classify();
  }

  // The solids are 2^scale times as large as the parts.
  std::vector<RegionPart> parts(int scale, const Point& shift) {
    std::vector<RegionPart> result;
    const Rational unit(Integer(1) << bits_, Integer(1) << scale);
    const auto put = [&](int kind, std::uint32_t polygon, const PointRing& points) {
      RegionPart part{kind, polygon, {}};
      for (const ExactPoint& p : points) {
        const Rational x = unit * rational(p.x()) + Rational(shift.x);
        const Rational y = unit * rational(p.y()) + Rational(shift.y);
        part.vertices.push_back(fraction(x) + " " + fraction(y));
      }
      result.push_back(std::move(part));
    };
    std::uint32_t number = 0;
    for (const Polygon& polygon : polygons()) {
      put(1, number, polygon.outer);
      for (const PointRing& hole : polygon.holes) {
        put(2, number, hole);
      }
      ++number;
    }
    for (const PointRing& s : segments()) {
      put(3, 0xffffffff, s);
    }
    for (const PointRing& p : points()) {
      put(4, 0xffffffff, p);
    }
    return result;
  }

 private:
  struct Polygon {
    PointRing outer;
    std::vector<PointRing> holes;
  };

  Arrangement arrangement_;
  OpenSum open_sum_;
  int bits_;
  bool is_sum_;

  static std::string fraction(const Rational& x) {
    return numerator(x).str() + "/" + denominator(x).str();
  }

  bool covers(const ExactPoint& p) {
    return open_sum_.surely_covers(about(p)) || open_sum_.covers(rational(p.x()), rational(p.y()));
  }

  bool covers(const Face& face) {
    return face->is_unbounded() ? !is_sum_ : covers(inner_point(face));
  }

  // What touches something that is not covered is not covered itself, for the sum is open.
  void classify() {
    std::size_t count = 0;
    for (Face face : arrangement_.face_handles()) {
      face->data() = {covers(face), false, count++};
    }
    for (Halfedge edge : arrangement_.edge_handles()) {
      const bool covered = edge->face()->data().covered && edge->twin()->face()->data().covered &&
                           covers(CGAL::midpoint(edge->source()->point(), edge->target()->point()));
      edge->data().covered = edge->twin()->data().covered = covered;
    }
    for (Vertex vertex : arrangement_.vertex_handles()) {
      bool covered = true;
      const auto first = vertex->incident_halfedges();
      auto edge = first;
      do {
        covered = covered && edge->data().covered;
      } while (++edge != first);
      vertex->data().covered = covered && covers(vertex->point());
    }
  }

  bool in_region(const Face& face) const { return face->data().covered == is_sum_; }

  // Has it the inside of the region on its left and not on its right?
  bool on_ring(const Halfedge& edge) const {
    return in_region(edge->face()) && !in_region(edge->twin()->face());
  }
  static bool on_segment(const Halfedge& edge) {
    return !edge->data().covered && edge->face()->data().covered &&
           edge->twin()->face()->data().covered;
  }
  bool on_ring(const Vertex& vertex) const {
    const auto first = vertex->incident_halfedges();
    auto edge = first;
    do {
      if (in_region(edge->face()) != in_region(edge->twin()->face())) {
        return true;
      }
    } while (++edge != first);
    return false;
  }

  // Faces of the inside of the region: faces of the arrangement and the edges between them.
  std::vector<std::size_t> inner_faces() {
    std::vector<std::size_t> parent(arrangement_.number_of_faces());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t k) {
      while (parent[k] != k) {
        k = parent[k] = parent[parent[k]];
      }
      return k;
    };
    for (Halfedge edge : arrangement_.edge_handles()) {
      if (in_region(edge->face()) && in_region(edge->twin()->face())) {
        parent[root(edge->face()->data().index)] = root(edge->twin()->face()->data().index);
      }
    }
    for (std::size_t k = 0; k < parent.size(); ++k) {
      parent[k] = root(k);
    }
    return parent;
  }

  // The closed walk along the boundary of one inner face.
  std::vector<Vertex> walk(Halfedge edge) {
    std::vector<Vertex> vertices;
    while (!edge->data().visited) {
      edge->data().visited = true;
      vertices.push_back(edge->target());
      edge = edge->next();
      while (!on_ring(edge)) {
        edge = edge->twin()->next();
      }
    }
    return vertices;
  }

  // The walk, cut wherever it comes to a vertex again.
  static std::vector<PointRing> simple_rings(const std::vector<Vertex>& walk) {
    std::vector<PointRing> rings;
    std::vector<Vertex> open;
    const auto close = [&](std::vector<Vertex>::iterator from) {
      PointRing ring;
      std::transform(from, open.end(), std::back_inserter(ring),
                     [](const Vertex& v) { return v->point(); });
      rings.push_back(canonical(ring));
      open.erase(from, open.end());
    };
    for (const Vertex& v : walk) {
      const auto earlier = std::find(open.begin(), open.end(), v);
      if (earlier != open.end()) {
        close(earlier);
      }
      open.push_back(v);
    }
    close(open.begin());
    return rings;
  }

  // Canonical rings turn at their smallest vertex.
  static bool is_counter_clockwise(const PointRing& ring) {
    return CGAL::left_turn(ring.back(), ring[0], ring[1]);
  }

  std::vector<Polygon> polygons() {
    const std::vector<std::size_t> inner_face = inner_faces();
    std::map<std::size_t, Polygon> by_face;
    for (Halfedge edge : arrangement_.halfedge_handles()) {
      if (edge->data().visited || !on_ring(edge)) {
        continue;
      }
      Polygon& polygon = by_face[inner_face[edge->face()->data().index]];
      for (PointRing& ring : simple_rings(walk(edge))) {
        if (!is_counter_clockwise(ring)) {
          polygon.holes.push_back(std::move(ring));
        } else if (polygon.outer.empty()) {
          polygon.outer = std::move(ring);
        } else {
          throw std::logic_error("a face with two outer rings");
        }
      }
    }
    std::vector<Polygon> result;
    for (auto& [face, polygon] : by_face) {
      if (polygon.outer.empty()) {
        throw std::logic_error("a face without an outer ring");
      }
      std::sort(polygon.holes.begin(), polygon.holes.end(), less);
      result.push_back(std::move(polygon));
    }
    std::sort(result.begin(), result.end(),
              [](const Polygon& p, const Polygon& q) { return less(p.outer, q.outer); });
    return result;
  }

  // The next edge of the same segment, if the segment goes on where this one ends.
  std::optional<Halfedge> straight_on(const Halfedge& edge) const {
    const Vertex vertex = edge->target();
    if (on_ring(vertex)) {
      return std::nullopt;
    }
    const ExactPoint& p = edge->source()->point();
    const ExactPoint& q = vertex->point();
    const auto first = vertex->incident_halfedges();
    auto other = first;
    do {
      const ExactPoint& r = other->source()->point();
      if (on_segment(other->twin()) && CGAL::collinear(p, q, r) &&
          CGAL::collinear_are_strictly_ordered_along_line(p, q, r)) {
        return other->twin();
      }
    } while (++other != first);
    return std::nullopt;
  }

  std::vector<PointRing> segments() {
    std::vector<PointRing> result;
    for (Halfedge edge : arrangement_.halfedge_handles()) {
      if (!on_segment(edge) || edge->direction() != CGAL::ARR_LEFT_TO_RIGHT ||
          straight_on(edge->twin())) {
        continue;
      }
      Halfedge last = edge;
      while (const auto next = straight_on(last)) {
        last = *next;
      }
      result.push_back({edge->source()->point(), last->target()->point()});
    }
    std::sort(result.begin(), result.end(), less);
    return result;
  }

  std::vector<PointRing> points() {
    std::vector<PointRing> result;
    for (Vertex vertex : arrangement_.vertex_handles()) {
      bool alone = !vertex->data().covered;
      const auto first = vertex->incident_halfedges();
      auto edge = first;
      do {
        alone = alone && edge->data().covered;
      } while (++edge != first);
      if (alone) {
        result.push_back({vertex->point()});
      }
    }
    std::sort(result.begin(), result.end(), less);
    return result;
  }
};

// ---- Operands, scaled to integers

// How often a coordinate must be doubled to be an integer.
int binary_places(double x) {
  int places = 0;
  if (x != 0) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    places = 53 - exponent - __builtin_ctzll(static_cast<unsigned long long>(mantissa));
  }
  return std::max(places, 0);
}

int binary_places(const Rings& rings) {
  int places = 0;
  for (const PointVector& ring : rings) {
    for (const Point& p : ring) {
      places = std::max({places, binary_places(p.x), binary_places(p.y)});
    }
  }
  return places;
}

std::vector<ExactRing> scaled(const Rings& rings, int scale, int sign) {
  const auto coordinate = [&](double x) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const int shift = exponent - 53 + scale;
    const Integer n = sign * mantissa;
    return shift >= 0 ? Integer(n << shift) : Integer(n / (Integer(1) << -shift));
  };
  std::vector<ExactRing> result;
  for (const PointVector& ring : rings) {
    ExactRing exact;
    for (const Point& p : ring) {
      exact.push_back({coordinate(p.x), coordinate(p.y)});
    }
    result.push_back(std::move(exact));
  }
  return result;
}

}  // namespace

std::vector<RegionPart> sum_region(const Rings& a, const Rings& b, const Point& shift) {
  const int scale = std::max(binary_places(a), binary_places(b));
  const Solid solid_a = make_solid(scaled(a, scale, 1), false);
  const Solid solid_b = make_solid(scaled(b, scale, 1), false);
  return Region(solid_a, solid_b, true).parts(scale, shift);
}

// A part at t lies in the container if it does not overlap what is not in the container. So t is
// not in the open sum of that and the reflected part.
std::vector<RegionPart> inner_fit_region(const Rings& container, const Rings& moving,
                                         const Point& reference) {
  const int scale = std::max(binary_places(container), binary_places(moving));
  const Solid outside = make_solid(scaled(container, scale, 1), true);
  const Solid reflected = make_solid(scaled(moving, scale, -1), false);
  return Region(outside, reflected, false).parts(scale, reference);
}

std::string text(const std::vector<RegionPart>& region) {
  constexpr const char* names[] = {"outer", "hole", "segment", "point"};
  std::string result;
  for (const RegionPart& part : region) {
    result += names[part.kind - 1];
    if (part.kind <= 2) {
      result += " " + std::to_string(part.polygon);
    }
    const char* separator = ": ";
    for (const std::string& vertex : part.vertices) {
      result += separator + vertex;
      separator = ", ";
    }
    result += "\n";
  }
  return result;
}

}  // namespace gcv::reference

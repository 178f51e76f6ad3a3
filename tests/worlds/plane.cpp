// SPDX-License-Identifier: LGPL-3.0-or-later
#include "plane.hpp"

#include <algorithm>
#include <numeric>

namespace worlds {
namespace {

bool is_between(Point p, Point a, Point b) {
  return cross(b - a, p - a) == 0 && dot(p - a, p - b) <= 0;
}

// Have two closed segments a point in common?
bool touch(Edge e, Edge f) {
  const auto sign = [](Int n) { return (n > 0) - (n < 0); };
  const Point d = e.to - e.from;
  const Point g = f.to - f.from;
  if (sign(cross(d, f.from - e.from)) * sign(cross(d, f.to - e.from)) < 0 &&
      sign(cross(g, e.from - f.from)) * sign(cross(g, e.to - f.from)) < 0) {
    return true;
  }
  return is_between(f.from, e.from, e.to) || is_between(f.to, e.from, e.to) ||
         is_between(e.from, f.from, f.to) || is_between(e.to, f.from, f.to);
}

// Have two segments more than a point in common?
bool overlap(Edge e, Edge f) {
  const Point d = e.to - e.from;
  if (cross(d, f.to - f.from) != 0 || cross(d, f.from - e.from) != 0) {
    return false;
  }
  const Int length = dot(d, d);
  const Int from = dot(d, f.from - e.from);
  const Int to = dot(d, f.to - e.from);
  return std::max(from, to) > 0 && std::min(from, to) < length;
}

bool separates(Edge line, const Convex& from) {
  return std::all_of(from.begin(), from.end(),
                     [&](Point p) { return cross(line.to - line.from, p - line.from) <= 0; });
}

// All triangles of three of the points whose interiors no edge meets and that are inside the
// polygon, or outside of it; but none that overlaps one before it. Of what is left there is always
// one more: a triangulation has the points as its vertices.
std::vector<Convex> triangles(const std::vector<Point>& points, const Polygon& polygon,
                              bool inside) {
  std::vector<Convex> found;
  const std::vector<Edge> all = edges(polygon);
  for (const Point& a : points) {
    for (const Point& b : points) {
      for (const Point& c : points) {
        if (!(a < b && a < c && cross(b - a, c - a) > 0)) {
          continue;
        }
        const Convex t{a, b, c};
        if (std::any_of(found.begin(), found.end(), [&](const Convex& f) { return meet(f, t); }) ||
            std::any_of(all.begin(), all.end(), [&](Edge e) {
              return meet({e.from, e.to}, t);
            })) {
          continue;
        }
        Polygon thrice = polygon;
        for (Ring& ring : thrice) {
          std::transform(ring.begin(), ring.end(), ring.begin(), [](Point p) { return 3 * p; });
        }
        if (is_inside(thrice, a + b + c) == inside) {
          found.push_back(t);
        }
      }
    }
  }
  return found;
}

bool is_upright(const Polygon& polygon) {
  const std::vector<Edge> all = edges(polygon);
  return std::all_of(all.begin(), all.end(),
                     [](Edge e) { return e.from.x == e.to.x || e.from.y == e.to.y; });
}

Convex box(Point low, Point high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

// What of the box of an upright polygon is inside, or outside of it, cut at the heights of all
// vertices.
std::vector<Convex> rectangles(const std::vector<Point>& points, const Polygon& polygon,
                               bool inside) {
  std::vector<Int> heights;
  for (const Point& p : points) {
    heights.push_back(p.y);
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  const auto [low, high] = bounds(points);
  std::vector<Convex> found;
  for (std::size_t k = 1; k < heights.size(); ++k) {
    const Int bottom = heights[k - 1];
    const Int top = heights[k];
    std::vector<Int> walls;
    if (!inside) {
      walls = {low.x, high.x};
    }
    for (const Edge& e : edges(polygon)) {
      if (std::min(e.from.y, e.to.y) <= bottom && std::max(e.from.y, e.to.y) >= top) {
        walls.push_back(e.from.x);
      }
    }
    std::sort(walls.begin(), walls.end());
    for (std::size_t i = 0; i < walls.size(); i += 2) {
      if (walls[i] < walls[i + 1]) {
        found.push_back(box({walls[i], bottom}, {walls[i + 1], top}));
      }
    }
  }
  return found;
}

std::vector<Point> vertices(const Polygon& polygon) {
  std::vector<Point> points;
  for (const Ring& ring : polygon) {
    points.insert(points.end(), ring.begin(), ring.end());
  }
  return points;
}

}  // namespace

std::pair<Point, Point> bounds(const std::vector<Point>& points) {
  Point low = points[0];
  Point high = points[0];
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low, high};
}

Point primitive(Point direction) {
  const Int g = std::gcd(direction.x, direction.y);
  return {direction.x / g, direction.y / g};
}

std::vector<Edge> edges(const Polygon& polygon) {
  std::vector<Edge> all;
  for (const Ring& ring : polygon) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      all.push_back({ring[k], ring[(k + 1) % ring.size()]});
    }
  }
  return all;
}

Wide twice_area(const Ring& ring) {
  Wide sum = 0;
  for (const Edge& e : edges({ring})) {
    sum += Wide{e.from.x} * e.to.y - Wide{e.from.y} * e.to.x;
  }
  return sum;
}

bool is_inside(const Polygon& polygon, Point p) {
  bool inside = false;
  for (const Edge& e : edges(polygon)) {
    if ((e.from.y > p.y) != (e.to.y > p.y)) {
      const Point d = e.to - e.from;
      const Point to = p - e.from;
      const Wide side = Wide{d.x} * to.y - Wide{d.y} * to.x;
      inside ^= (side > 0) == (d.y > 0);
    }
  }
  return inside;
}

bool is_simple(const Ring& ring) {
  const std::vector<Edge> all = edges({ring});
  const std::size_t n = all.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Edge& next = all[(i + 1) % n];
    if (cross(all[i].to - all[i].from, next.to - next.from) == 0) {
      return false;
    }
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n != i && touch(all[i], all[j])) {
        return false;
      }
    }
  }
  return n > 2;
}

bool is_valid(const Polygon& polygon) {
  const Polygon outer{polygon[0]};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const Edge& e : edges({polygon[i]})) {
        for (const Edge& f : edges({polygon[j]})) {
          if (overlap(e, f)) {
            return false;
          }
        }
      }
    }
    for (const Convex& t : i == 0 ? std::vector<Convex>{} : inner_pieces({polygon[i]})) {
      std::vector<Convex> around = outer_pieces(outer);
      for (const Convex& piece : surroundings(outer)) {
        around.push_back(piece);
      }
      const auto hits = [&](const Convex& piece) { return meet(piece, t); };
      if (std::any_of(around.begin(), around.end(), hits)) {
        return false;
      }
      for (std::size_t j = 1; j < i; ++j) {
        const std::vector<Convex> other = inner_pieces({polygon[j]});
        if (std::any_of(other.begin(), other.end(), hits)) {
          return false;
        }
      }
    }
  }
  return true;
}

bool meet(const Convex& a, const Convex& b) {
  for (const Edge& e : edges({a})) {
    if (separates(e, b)) {
      return false;
    }
  }
  for (const Edge& e : edges({b})) {
    if (separates(e, a)) {
      return false;
    }
  }
  return true;
}

std::vector<Convex> inner_pieces(const Polygon& polygon) {
  const std::vector<Point> points = vertices(polygon);
  return is_upright(polygon) ? rectangles(points, polygon, true) : triangles(points, polygon, true);
}

std::vector<Convex> outer_pieces(const Polygon& polygon) {
  std::vector<Point> points = vertices(polygon);
  if (is_upright(polygon)) {
    return rectangles(points, polygon, false);
  }
  const auto [low, high] = bounds(points);
  for (const Point& corner : box(low, high)) {
    if (std::find(points.begin(), points.end(), corner) == points.end()) {
      points.push_back(corner);
    }
  }
  return triangles(points, polygon, false);
}

std::vector<Convex> surroundings(const Polygon& polygon) {
  constexpr Int kReach = 16;
  const auto [low, high] = bounds(polygon[0]);
  const Point far_low = low - Point{kReach, kReach};
  const Point far_high = high + Point{kReach, kReach};
  return {box(far_low, {low.x, far_high.y}), box({high.x, far_low.y}, far_high),
          box({low.x, far_low.y}, {high.x, low.y}), box({low.x, high.y}, {high.x, far_high.y})};
}

Polygon reflected(const Polygon& polygon) {
  Polygon result = polygon;
  for (Ring& ring : result) {
    std::transform(ring.begin(), ring.end(), ring.begin(), [](Point p) { return -p; });
  }
  return result;
}

Polygon moved(const Polygon& polygon, Point by) {
  Polygon result = polygon;
  for (Ring& ring : result) {
    std::transform(ring.begin(), ring.end(), ring.begin(), [&](Point p) { return p + by; });
  }
  return result;
}

std::string text(const Polygon& polygon) {
  std::string result = "POLYGON (";
  for (const Ring& ring : polygon) {
    result += &ring == polygon.data() ? "(" : ", (";
    for (const Point& p : ring) {
      result += std::to_string(p.x) + " " + std::to_string(p.y) + ", ";
    }
    result += std::to_string(ring[0].x) + " " + std::to_string(ring[0].y) + ")";
  }
  return result + ")";
}

}  // namespace worlds

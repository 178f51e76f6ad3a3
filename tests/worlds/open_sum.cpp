// SPDX-License-Identifier: LGPL-3.0-or-later
#include "open_sum.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace worlds {
namespace {

Convex convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  Convex hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

void OpenSum::add(const std::vector<Convex>& a, const std::vector<Convex>& b) {
  for (const Convex& p : a) {
    for (const Convex& q : b) {
      std::vector<Point> sums;
      for (const Point& u : p) {
        for (const Point& v : q) {
          sums.push_back(u + v);
        }
      }
      pieces_.push_back(convex_hull(sums));
      std::vector<Line>& lines = lines_.emplace_back();
      for (const Edge& e : edges({pieces_.back()})) {
        const Point direction = primitive(e.to - e.from);
        if (std::max(std::abs(direction.x), std::abs(direction.y)) > kLongest) {
          throw std::logic_error("A direction is too long for the unit.");
        }
        lines.push_back({kUnit * e.from, direction});
      }
    }
  }
}

void OpenSum::add(const OpenSum& other) {
  pieces_.insert(pieces_.end(), other.pieces_.begin(), other.pieces_.end());
  lines_.insert(lines_.end(), other.lines_.begin(), other.lines_.end());
}

bool OpenSum::holds(Point place) const {
  return std::any_of(lines_.begin(), lines_.end(), [&](const auto& lines) {
    return std::all_of(lines.begin(), lines.end(),
                       [&](const Line& l) { return l.side(place) > 0; });
  });
}

bool OpenSum::reaches(Point place) const {
  return std::any_of(lines_.begin(), lines_.end(), [&](const auto& lines) {
    return std::all_of(lines.begin(), lines.end(),
                       [&](const Line& l) { return l.side(place) >= 0; });
  });
}

OpenSum::Sides OpenSum::sides(Point middle, Point direction) const {
  Sides result{false, false, false};
  for (const std::vector<Line>& lines : lines_) {
    Sides piece{true, true, true};
    for (const Line& line : lines) {
      const Int side = line.side(middle);
      if (side < 0) {
        piece = {false, false, false};
        break;
      }
      if (side == 0) {
        const bool same = dot(line.direction, direction) > 0;
        piece = {piece.left && same, false, piece.right && !same};
      }
    }
    result = {result.left || piece.left, result.on || piece.on, result.right || piece.right};
    if (result.on) {
      break;
    }
  }
  return result;
}

std::vector<Segment> OpenSum::segments() const {
  std::vector<Segment> all;
  for (const Convex& piece : pieces_) {
    for (const Edge& e : edges({piece})) {
      const auto [from, to] = std::minmax(e.from, e.to);
      const Point d = to - from;
      all.push_back({from, primitive(d), std::gcd(d.x, d.y)});
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Fraction OpenSum::squared_distance(Point halves) const {
  if (reaches(kUnit / 2 * halves)) {
    return {0, 1};
  }
  Fraction least{1, 0};
  for (const Convex& piece : pieces_) {
    Point from = halves - 2 * piece.back();
    for (const Point& vertex : piece) {
      const Point to = halves - 2 * vertex;
      const Point twice = from - to;
      if (dot(from, twice) > 0 && dot(to, twice) < 0) {
        const Int n = cross(twice, from);
        least = std::min(least, reduced(n * n, 4 * dot(twice, twice)));
      } else {
        least = std::min(least, reduced(dot(to, to), 4));
      }
      from = to;
    }
  }
  return least;
}

}  // namespace worlds

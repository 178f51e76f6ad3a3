// SPDX-License-Identifier: LGPL-3.0-or-later
#include "parts.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

#include "arrangement.hpp"

namespace worlds {
namespace {

// A ring that visits no place twice, and a place on one of its edges that is on no other ring.
struct Loop {
  Ring ring;
  Point sample;
};

Point middle(const SmallEdge& e) { return {(e.from.x + e.to.x) / 2, (e.from.y + e.to.y) / 2}; }

// Turning clockwise from straight back, is direction a met before b?
bool is_met_before(Point back, Point a, Point b) {
  const bool a_is_late = cross(back, a) >= 0;
  const bool b_is_late = cross(back, b) >= 0;
  return a_is_late != b_is_late ? b_is_late : cross(a, b) < 0;
}

// The loops of edges that have the face on their left, sorted.
std::vector<Loop> loops(const std::vector<SmallEdge>& directed) {
  std::vector<Loop> found;
  std::vector<bool> used(directed.size(), false);
  for (std::size_t start = 0; start < directed.size(); ++start) {
    // The places on the way, each with the edge that leaves it.
    std::vector<std::size_t> way;
    std::size_t at = start;
    while (!used[at]) {
      used[at] = true;
      way.push_back(at);
      const SmallEdge& e = directed[at];
      const auto revisited = std::find_if(way.begin(), way.end(),
                                          [&](std::size_t k) { return directed[k].from == e.to; });
      if (revisited != way.end()) {
        Loop& loop = found.emplace_back();
        loop.sample = middle(directed[*revisited]);
        std::transform(revisited, way.end(), std::back_inserter(loop.ring),
                       [&](std::size_t k) { return directed[k].from; });
        way.erase(revisited, way.end());
      }
      std::size_t next = directed.size();
      for (auto k = std::lower_bound(directed.begin(), directed.end(), SmallEdge{e.to, {}, {}},
                                     [](const auto&a, const auto&b) { return a.from < b.from; });
           k != directed.end() && k->from == e.to; ++k) {
        if (next == directed.size() ||
            is_met_before(-e.direction, k->direction, directed[next].direction)) {
          next = static_cast<std::size_t>(k - directed.begin());
        }
      }
      if (next == directed.size()) {
        throw std::logic_error("A boundary ends.");
      }
      at = next;
    }
  }
  return found;
}

// From its smallest vertex on, without vertices that are no corners.
Ring normalised(const Ring& ring) {
  Ring corners;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point in = ring[k] - ring[(k + n - 1) % n];
    const Point out = ring[(k + 1) % n] - ring[k];
    if (Wide{in.x} * out.y != Wide{in.y} * out.x) {
      corners.push_back(ring[k]);
    }
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<Parts::Face> faces(const std::vector<SmallEdge>& directed) {
  std::vector<Parts::Face> found;
  std::vector<Loop> holes;
  for (const Loop& loop : loops(directed)) {
    if (twice_area(loop.ring) > 0) {
      found.push_back({normalised(loop.ring), {}});
    } else {
      holes.push_back(loop);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.outer < b.outer; });
  for (const Loop& hole : holes) {
    Parts::Face* around = nullptr;
    for (Parts::Face& face : found) {
      if (is_inside({face.outer}, hole.sample) &&
          (around == nullptr || twice_area(face.outer) < twice_area(around->outer))) {
        around = &face;
      }
    }
    if (around != nullptr) {
      around->holes.push_back(normalised(hole.ring));
    }
  }
  for (Parts::Face& face : found) {
    std::sort(face.holes.begin(), face.holes.end());
  }
  return found;
}

// Joins edges that go straight on, but not where they meet a ring.
std::vector<Edge> joined(const std::vector<SmallEdge>& fits, const std::vector<Point>& on_rings) {
  std::vector<Edge> segments;
  for (const SmallEdge& fit : fits) {
    const auto goes_on = [&](Point at, auto matches) {
      return std::binary_search(on_rings.begin(), on_rings.end(), at)
                 ? fits.end()
                 : std::find_if(fits.begin(), fits.end(), matches);
    };
    const auto before = goes_on(fit.from, [&](const SmallEdge& e) {
      return e.to == fit.from && e.direction == fit.direction;
    });
    if (before != fits.end()) {
      continue;
    }
    Point to = fit.to;
    for (;;) {
      const auto after = goes_on(
          to, [&](const SmallEdge& e) { return e.from == to && e.direction == fit.direction; });
      if (after == fits.end()) {
        break;
      }
      to = after->to;
    }
    segments.push_back({fit.from, to});
  }
  std::sort(segments.begin(), segments.end(), [](const Edge& a, const Edge& b) {
    return std::pair{a.from, a.to} < std::pair{b.from, b.to};
  });
  return segments;
}

void sort_once(std::vector<Point>& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

std::string text(Point place) {
  return text(reduced(place.x, kUnit)) + " " + text(reduced(place.y, kUnit));
}

std::string line(const std::string& kind, const std::vector<Point>& vertices) {
  std::string result = "  " + kind + ":";
  for (const Point& p : vertices) {
    result += " (" + text(p) + ")";
  }
  return result + "\n";
}

}  // namespace

Parts parts(const OpenSum& sum, Shown shown) {
  std::vector<SmallEdge> directed;
  std::vector<SmallEdge> fits;
  std::vector<Point> on_rings;
  std::vector<Point> on_fits;
  std::vector<Point> all;
  for (const SmallEdge& e : arrange(sum.segments())) {
    all.insert(all.end(), {e.from, e.to});
    const OpenSum::Sides sides = sum.sides(middle(e), e.direction);
    if (sides.left != sides.right) {
      const bool forward = sides.left == (shown == Shown::sum);
      directed.push_back(forward ? e : SmallEdge{e.to, e.from, -e.direction});
      on_rings.insert(on_rings.end(), {e.from, e.to});
    } else if (sides.left && !sides.on) {
      fits.push_back(e);
      on_fits.insert(on_fits.end(), {e.from, e.to});
    }
  }
  for (std::vector<Point>* points : {&all, &on_rings, &on_fits}) {
    sort_once(*points);
  }
  std::sort(directed.begin(), directed.end());
  Parts result{faces(directed), joined(fits, on_rings), {}};
  for (const Point& p : all) {
    if (!std::binary_search(on_rings.begin(), on_rings.end(), p) &&
        !std::binary_search(on_fits.begin(), on_fits.end(), p) && !sum.holds(p)) {
      result.points.push_back(p);
    }
  }
  return result;
}

std::string text(const Parts& parts) {
  std::string result;
  for (const Parts::Face& face : parts.faces) {
    result += line("outer ring", face.outer);
    for (const Ring& hole : face.holes) {
      result += line("hole", hole);
    }
  }
  for (const Edge& e : parts.segments) {
    result += line("segment", {e.from, e.to});
  }
  for (const Point& p : parts.points) {
    result += line("point", {p});
  }
  return result;
}

std::string outer_face_text(const Parts& parts) {
  return line("outer ring", parts.faces.at(0).outer);
}

Fraction Way::square() const { return reduced(x * x + y * y, denominator * denominator); }

std::optional<Way> shortest_way(const Parts& parts, Point halves) {
  const Point place = kUnit / 2 * halves;
  std::optional<Way> best;
  const auto offer = [&](Way way) {
    const auto is_better = [&] {
      const auto order = way.square() <=> best->square();
      const std::pair scaled{way.x * best->denominator, way.y * best->denominator};
      const std::pair best_scaled{best->x * way.denominator, best->y * way.denominator};
      return order < 0 || (order == 0 && scaled < best_scaled);
    };
    if (!best || is_better()) {
      best = way;
    }
  };
  const auto offer_place = [&](Point to) {
    const Point d = to - place;
    const Int g = std::gcd(std::gcd(d.x, d.y), kUnit);
    offer({d.x / g, d.y / g, kUnit / g});
  };
  const auto offer_edge = [&](Point from, Point to) {
    offer_place(from);
    const Point d = primitive(to - from);
    if (dot(d, place - from) > 0 && dot(d, to - place) > 0) {
      // Twice the side of the line on which the place is, in units.
      const Int side = cross(d, place - from) / (kUnit / 2);
      offer({side * d.y, -side * d.x, 2 * dot(d, d)});
    }
  };
  for (const Parts::Face& face : parts.faces) {
    Polygon rings = face.holes;
    rings.push_back(face.outer);
    for (const Edge& e : edges(rings)) {
      offer_edge(e.from, e.to);
    }
  }
  for (const Edge& e : parts.segments) {
    offer_edge(e.from, e.to);
    offer_place(e.to);
  }
  for (const Point& p : parts.points) {
    offer_place(p);
  }
  return best;
}

}  // namespace worlds

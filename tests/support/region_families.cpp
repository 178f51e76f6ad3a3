// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "simplicity.hpp"

namespace gcv::test {

namespace {

bool one_in(Random& random, int count) { return uniform(random, 1, count) == 1; }

// Half of the shifts are 0.
Point random_shift(Random& random) {
  if (one_in(random, 2)) {
    return {0, 0};
  }
  return {uniform(random, -12, 12) / 4.0, uniform(random, -12, 12) / 4.0};
}

Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// In the order in which C++ evaluates them everywhere: arguments of a call are in none.
std::pair<int, int> two(Random& random, int low, int high) {
  const int first = uniform(random, low, high);
  return {first, uniform(random, low, high)};
}

// Sides of 1 to `most`.
Ring random_rectangle(Random& random, int most) {
  const auto [width, height] = two(random, 1, most);
  return rectangle(0, 0, width, height);
}

Ring random_polygon(Random& random, int fewest, int most, int extent) {
  return random_small_integer_polygon(random, uniform(random, fewest, most), extent);
}

Ring moved(Ring ring, double dx, double dy) {
  for (Point& p : ring) {
    p = {p.x + dx, p.y + dy};
  }
  return ring;
}

// In one of three cases half or a quarter as large, so that there is more room.
void shrink_some(Random& random, Rings& rings) {
  if (!one_in(random, 3)) {
    return;
  }
  const double scale = one_in(random, 2) ? 0.5 : 0.25;
  for (Ring& ring : rings) {
    for (Point& p : ring) {
      p = {scale * p.x, scale * p.y};
    }
  }
}

// ---- Rings of small integers. Cross products of such, and of halves, are exact in doubles.

double cross(const Point& o, const Point& p, const Point& q) {
  return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

bool on_edge(const Point& x, const Point& p, const Point& q) {
  return cross(p, q, x) == 0 && std::min(p.x, q.x) <= x.x && x.x <= std::max(p.x, q.x) &&
         std::min(p.y, q.y) <= x.y && x.y <= std::max(p.y, q.y);
}

bool cross_properly(const Point& p, const Point& q, const Point& r, const Point& s) {
  const auto apart = [](double c, double d) { return (c < 0 && d > 0) || (c > 0 && d < 0); };
  return apart(cross(p, q, r), cross(p, q, s)) && apart(cross(r, s, p), cross(r, s, q));
}

// 1 inside, 0 on the ring, -1 outside.
int side(const Ring& ring, const Point& x) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& p = ring[k];
    const Point& q = ring[(k + 1) % ring.size()];
    if (on_edge(x, p, q)) {
      return 0;
    }
    if ((p.y > x.y) != (q.y > x.y)) {
      inside = inside != ((cross(p, q, x) > 0) == (q.y > p.y));
    }
  }
  return inside ? 1 : -1;
}

// Is the ring, but for single points, on that side of the other ring?
bool is_on_side(const Ring& ring, int wanted, const Ring& other) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& p = ring[k];
    const Point& q = ring[(k + 1) % ring.size()];
    Ring places{p, q};
    for (std::size_t i = 0; i < other.size(); ++i) {
      const Point& r = other[i];
      if (cross_properly(p, q, r, other[(i + 1) % other.size()])) {
        return false;
      }
      if (on_edge(r, p, q)) {
        places.push_back(r);
      }
    }
    std::sort(places.begin(), places.end(), lexicographically_less);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const Point middle{(places[i].x + places[i + 1].x) / 2, (places[i].y + places[i + 1].y) / 2};
      if (!(places[i] == places[i + 1]) && side(other, middle) != wanted) {
        return false;
      }
    }
  }
  return true;
}

bool touch(const Ring& ring, const Ring& other) {
  const auto touches = [](const Ring& r, const Ring& s) {
    return std::any_of(r.begin(), r.end(), [&](const Point& p) { return side(s, p) == 0; });
  };
  return touches(ring, other) || touches(other, ring);
}

bool any_touch(const Rings& rings) {
  for (std::size_t k = 0; k < rings.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (touch(rings[i], rings[k])) {
        return true;
      }
    }
  }
  return false;
}

bool fits_as_hole(const Ring& hole, const Rings& rings) {
  return std::all_of(rings.begin(), rings.end(), [&](const Ring& ring) {
    return &ring == &rings.front() ? is_on_side(hole, 1, ring)
                                   : is_on_side(hole, -1, ring) && is_on_side(ring, -1, hole);
  });
}

Ring random_small_part(Random& random) {
  switch (uniform(random, 0, 3)) {
    case 0:
      return random_small_integer_polygon(random, 3, uniform(random, 1, 3));
    case 1:
      return random_polygon(random, 4, 5, 3);
    case 2:
      return {{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    default:
      return random_rectangle(random, 3);
  }
}

// Tries some random holes. They may touch one another and the outer ring.
void add_random_holes(Random& random, Rings& rings, int most) {
  double extent = 0;
  for (const Point& p : rings.front()) {
    extent = std::max({extent, p.x, p.y});
  }
  const int size = static_cast<int>(extent);
  for (int tries = 0; tries < 40 && static_cast<int>(rings.size()) <= most; ++tries) {
    Ring hole = one_in(random, 2)
                    ? random_small_part(random)
                    : random_polygon(random, 3, 5, uniform(random, 2, std::max(2, size - 1)));
    const auto [dx, dy] = two(random, 0, size - 1);
    hole = moved(hole, dx, dy);
    if (fits_as_hole(hole, rings)) {
      rings.push_back(hole);
    }
  }
}

Rings random_with_holes(Random& random, int least_extent, int most_extent, int most_holes) {
  const int extent = uniform(random, least_extent, most_extent);
  Rings rings;
  rings.push_back(one_in(random, 2) ? random_polygon(random, 3, 6, extent)
                                    : rectangle(0, 0, extent, uniform(random, 3, extent)));
  add_random_holes(random, rings, uniform(random, 1, most_holes));
  for (Ring& ring : rings) {
    if (one_in(random, 4)) {
      std::reverse(ring.begin(), ring.end());
    }
  }
  return rings;
}

// ---- Unions of the cells of a grid

struct Cells {
  int columns;
  int rows;
  std::set<std::pair<int, int>> filled;

  [[nodiscard]] bool has(int i, int j) const { return filled.contains({i, j}); }
};

// Grid lines at integers, `low` to `high` apart.
std::vector<double> random_lines(Random& random, int cells, int low, int high) {
  std::vector<double> lines{0};
  for (int k = 0; k < cells; ++k) {
    lines.push_back(lines.back() + uniform(random, low, high));
  }
  return lines;
}

// The rings of a union of cells: the outer one first if the cells hang together by their sides.
// Where two cells meet only in a corner, rings touch there.
Rings rings_of(const Cells& cells, const std::vector<double>& xs, const std::vector<double>& ys) {
  using Place = std::pair<int, int>;
  std::map<Place, std::vector<Place>> next;
  for (const auto& [i, j] : cells.filled) {
    const std::array<Place, 4> corners{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
    const std::array<bool, 4> closed{cells.has(i, j - 1), cells.has(i + 1, j), cells.has(i, j + 1),
                                     cells.has(i - 1, j)};
    for (std::size_t k = 0; k < 4; ++k) {
      if (!closed[k]) {
        next[corners[k]].push_back(corners[(k + 1) % 4]);
      }
    }
  }
  const auto turn = [](const Place& p, const Place& q, const Place& r) {
    return (q.first - p.first) * (r.second - q.second) -
           (q.second - p.second) * (r.first - q.first);
  };
  Rings rings;
  std::size_t outer = 0;
  const auto add = [&](const std::vector<Place>& walk) {
    Ring ring;
    const std::size_t n = walk.size();
    const auto first =
        static_cast<std::size_t>(std::min_element(walk.begin(), walk.end()) - walk.begin());
    if (turn(walk[(first + n - 1) % n], walk[first], walk[(first + 1) % n]) > 0) {
      outer = rings.size();
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (turn(walk[(k + n - 1) % n], walk[k], walk[(k + 1) % n]) != 0) {
        ring.push_back({xs[static_cast<std::size_t>(walk[k].first)],
                        ys[static_cast<std::size_t>(walk[k].second)]});
      }
    }
    rings.push_back(ring);
  };
  // Walk round the cells, to the left where two meet in a corner. Cut wherever the walk comes to a
  // place again.
  while (!next.empty()) {
    std::vector<Place> walk{next.begin()->first};
    for (std::optional<Place> from; next.contains(walk.back());) {
      const Place at = walk.back();
      auto& ways = next[at];
      auto way = ways.begin();
      if (from && ways.size() > 1 && turn(*from, at, ways[1]) > 0) {
        ++way;
      }
      from = at;
      const Place to = *way;
      ways.erase(way);
      if (ways.empty()) {
        next.erase(at);
      }
      const auto earlier = std::find(walk.begin(), walk.end(), to);
      if (earlier != walk.end()) {
        add({earlier, walk.end()});
        walk.erase(earlier, walk.end());
      }
      walk.push_back(to);
    }
  }
  std::swap(rings[0], rings[outer]);
  return rings;
}

// Cells that hang together by their sides.
Cells random_cells(Random& random, int columns, int rows) {
  Cells cells{columns, rows, {}};
  const int column = uniform(random, 0, columns - 1);
  cells.filled.emplace(column, uniform(random, 0, rows - 1));
  const int count = columns * rows * uniform(random, 60, 90) / 100;
  while (static_cast<int>(cells.filled.size()) < count) {
    const int i = uniform(random, 0, columns - 1);
    const int j = uniform(random, 0, rows - 1);
    if (cells.has(i - 1, j) || cells.has(i + 1, j) || cells.has(i, j - 1) || cells.has(i, j + 1)) {
      cells.filled.emplace(i, j);
    }
  }
  return cells;
}

Rings random_cell_polygon(Random& random, int most_lines) {
  const int columns = uniform(random, 3, most_lines);
  const int rows = uniform(random, 3, most_lines);
  const auto xs = random_lines(random, columns, 1, 2);
  const auto ys = random_lines(random, rows, 1, 2);
  return rings_of(random_cells(random, columns, rows), xs, ys);
}

// Rooms at even places, doors between them at odd ones, so that exactly one way leads from room to
// room.
Cells random_corridors(Random& random, int columns, int rows) {
  Cells cells{2 * columns - 1, 2 * rows - 1, {}};
  std::vector<std::pair<int, int>> way{
      {2 * uniform(random, 0, columns - 1), 2 * uniform(random, 0, rows - 1)}};
  cells.filled.insert(way.front());
  while (!way.empty()) {
    const auto [i, j] = way.back();
    std::vector<std::pair<int, int>> steps;
    for (const auto& [di, dj] :
         {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)}) {
      const int to_i = i + 2 * di;
      const int to_j = j + 2 * dj;
      if (to_i >= 0 && to_i < cells.columns && to_j >= 0 && to_j < cells.rows &&
          !cells.has(to_i, to_j)) {
        steps.emplace_back(di, dj);
      }
    }
    if (steps.empty()) {
      way.pop_back();
      continue;
    }
    const auto [di, dj] =
        steps[static_cast<std::size_t>(uniform(random, 0, static_cast<int>(steps.size()) - 1))];
    cells.filled.emplace(i + di, j + dj);
    cells.filled.emplace(i + 2 * di, j + 2 * dj);
    way.emplace_back(i + 2 * di, j + 2 * dj);
  }
  return cells;
}

// All cells of a frame round the grid and of the grid, but these.
Cells block_around(const Cells& cells) {
  Cells block{cells.columns + 2, cells.rows + 2, {}};
  for (int i = 0; i < block.columns; ++i) {
    for (int j = 0; j < block.rows; ++j) {
      if (!cells.has(i - 1, j - 1)) {
        block.filled.emplace(i, j);
      }
    }
  }
  return block;
}

// ---- Exact fits: a fixed polygon, and another that lies as if fitted in, with the same vertices

struct Fit {
  Ring fixed;
  Ring part;
};

RegionCase no_fit(Random& random, const Fit& fit) {
  return {{fit.fixed}, {negated(fit.part)}, false, random_shift(random)};
}

// A back from y = 0 down, teeth up from it, between x positions 0, 1, 2, ... of the list: a tooth
// in every second gap, beginning with the one from `first`.
Ring comb(const std::vector<double>& xs, std::size_t first, double back, double height) {
  Ring ring{{xs.front(), -back}, {xs.back(), -back}};
  Ring top{{xs.front(), 0}};
  for (std::size_t k = first; k + 1 < xs.size(); k += 2) {
    top.insert(top.end(), {{xs[k], 0}, {xs[k], height}, {xs[k + 1], height}, {xs[k + 1], 0}});
  }
  top.push_back({xs.back(), 0});
  top.erase(std::unique(top.begin(), top.end()), top.end());
  // At the ends a tooth is flush with the back.
  const auto tidy = [](Ring& r) {
    Ring kept;
    for (std::size_t k = 0; k < r.size(); ++k) {
      const Point& p = r[(k + r.size() - 1) % r.size()];
      const Point& q = r[(k + 1) % r.size()];
      if (cross(p, r[k], q) != 0) {
        kept.push_back(r[k]);
      }
    }
    r = kept;
  };
  ring.insert(ring.end(), top.rbegin(), top.rend());
  tidy(ring);
  return ring;
}

// Teeth of one comb between those of the other, which hangs from above.
Fit random_meshing_combs(Random& random) {
  const auto xs = random_lines(random, uniform(random, 2, 6), 1, 2);
  const double height = uniform(random, 1, 3);
  Fit fit{comb(xs, 0, 1, height), comb(xs, 1, uniform(random, 1, 2), height)};
  for (Point& p : fit.part) {
    p.y = height - p.y;
  }
  return fit;
}

// A slot from the top of a block, in steps: depths ascend downwards, widths are of any kind.
Fit random_key_and_lock(Random& random) {
  const int steps = uniform(random, 1, 3);
  std::vector<double> left;
  std::vector<double> right;
  for (int k = 0; k < steps; ++k) {
    left.push_back(-uniform(random, 1, 3));
    right.push_back(uniform(random, 1, 3));
  }
  const auto ys = random_lines(random, steps, 1, 2);
  const auto at = [](const auto& list, int k) { return list[static_cast<std::size_t>(k)]; };
  Ring slot;  // from the top on the left round the bottom to the top on the right
  for (int k = 0; k < steps; ++k) {
    slot.insert(slot.end(), {{at(left, k), -at(ys, k)}, {at(left, k), -at(ys, k + 1)}});
  }
  for (int k = steps - 1; k >= 0; --k) {
    slot.insert(slot.end(), {{at(right, k), -at(ys, k + 1)}, {at(right, k), -at(ys, k)}});
  }
  slot.erase(std::unique(slot.begin(), slot.end()), slot.end());
  Fit fit{{{-4, 0}, {-4, -ys.back() - 1}, {4, -ys.back() - 1}, {4, 0}}, slot};
  fit.fixed.insert(fit.fixed.end(), slot.rbegin(), slot.rend());
  if (one_in(random, 2)) {  // a handle, wider or not than the slot is at its top
    const double x0 = -uniform(random, 1, 4);
    const double x1 = uniform(random, 1, 4);
    fit.part.insert(fit.part.end(), {{x1, 0}, {x1, 1}, {x0, 1}, {x0, 0}});
    fit.part.erase(std::unique(fit.part.begin(), fit.part.end()), fit.part.end());
    if (fit.part.front() == fit.part.back()) {
      fit.part.pop_back();
    }
  }
  return fit;
}

// The pocket is from (0, 0) to (width, height), the mouth in the wall above it.
Fit random_pocket(Random& random) {
  const double width = uniform(random, 1, 4);
  const double height = uniform(random, 1, 4);
  const double x0 = uniform(random, 0, static_cast<int>(width) - 1);
  const double x1 = uniform(random, static_cast<int>(x0) + 1, static_cast<int>(width));
  const double wall = uniform(random, 1, 2);
  Fit fit;
  fit.fixed = {{-wall, -wall},
               {width + wall, -wall},
               {width + wall, height + wall},
               {x1, height + wall},
               {x1, height},
               {width, height},
               {width, 0},
               {0, 0},
               {0, height},
               {x0, height},
               {x0, height + wall},
               {-wall, height + wall}};
  // Where the mouth is as wide as the pocket, its corners are no corners.
  fit.fixed.erase(std::unique(fit.fixed.begin(), fit.fixed.end()), fit.fixed.end());
  fit.part = one_in(random, 2) ? rectangle(0, 0, width, height)
                               : rectangle(x0, 0, x1, height + wall * uniform(random, 0, 1));
  return fit;
}

bool is_ring(const Ring& ring) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (ring[k] == ring[(k + 1) % ring.size()]) {
      return false;
    }
  }
  return ring.size() >= 3 && !find_conflict(ring);
}

Fit random_jigsaw(Random& random) {
  while (true) {
    const int width = uniform(random, 2, 8);
    const int height = uniform(random, 1, 6);
    const auto across = [&] { return static_cast<double>(uniform(random, 1, width - 1)); };
    Ring cut{{across(), 0}};
    if (one_in(random, 2)) {  // a tab, most often wider than its neck
      const double neck = across();
      const double end = across();
      const double wider = uniform(random, 0, 3) / 4.0;
      cut = {{neck, 0},        {neck, 1}, {end, 1 - wider},
             {end, 2 + wider}, {neck, 2}, {neck, static_cast<double>(height)}};
    } else {
      for (int k = uniform(random, 0, 6); k > 0; --k) {
        cut.push_back({across(), uniform(random, 1, 2 * height - 1) / 2.0});
      }
      cut.push_back({across(), static_cast<double>(height)});
    }
    Fit fit{{{0, 0}}, {{static_cast<double>(width), 0}}};
    for (Ring* ring : {&fit.fixed, &fit.part}) {
      const double x = ring->front().x;
      ring->insert(ring->end(), cut.begin(), cut.end());
      ring->push_back({x, static_cast<double>(height)});
    }
    if (is_ring(fit.fixed) && is_ring(fit.part)) {
      if (one_in(random, 2)) {
        std::swap(fit.fixed, fit.part);
      }
      return fit;
    }
  }
}

// ---- Holes that touch

// A rectangle and a hole with its corners on three or four sides of the rectangle, or on two: the
// inside falls apart. Now and then several such, one beside the other.
Rings random_fallen_apart(Random& random) {
  const int count = uniform(random, 1, 2);
  const auto [width, height] = two(random, 2, 4);
  const auto w = static_cast<double>(width);
  const auto h = static_cast<double>(height);
  Rings rings{rectangle(0, 0, w * count, h)};
  for (int k = 0; k < count; ++k) {
    Ring hole{{static_cast<double>(uniform(random, 1, width - 1)), 0},
              {w, static_cast<double>(uniform(random, 1, height - 1))},
              {static_cast<double>(uniform(random, 1, width - 1)), h},
              {0, static_cast<double>(uniform(random, 1, height - 1))}};
    if (one_in(random, 2)) {
      hole.erase(hole.begin() + uniform(random, 0, 3));
    }
    hole = moved(hole, w * k, 0);
    if (fits_as_hole(hole, rings)) {
      rings.push_back(hole);
    }
  }
  if (one_in(random, 3)) {
    add_random_holes(random, rings, static_cast<int>(rings.size()));
  }
  return rings;
}

Rings random_touching(Random& random) {
  while (true) {
    Rings rings;
    switch (uniform(random, 0, 2)) {
      case 0:
        rings = random_fallen_apart(random);
        break;
      case 1:
        rings = random_cell_polygon(random, 4);
        break;
      default:
        rings = random_with_holes(random, 4, 6, 3);
    }
    if (any_touch(rings)) {
      return rings;
    }
  }
}

// As wide as two vertices are apart in x, as high as two are in y.
Ring rectangle_between_vertices(Random& random, const Rings& rings) {
  Ring all;
  for (const Ring& ring : rings) {
    all.insert(all.end(), ring.begin(), ring.end());
  }
  const auto distance = [&](double Point::*coordinate) {
    const auto [i, j] = two(random, 0, static_cast<int>(all.size()) - 1);
    const double d = std::abs(all[static_cast<std::size_t>(i)].*coordinate -
                              all[static_cast<std::size_t>(j)].*coordinate);
    return d > 0 ? d : 1;
  };
  const double width = distance(&Point::x);
  const double height = distance(&Point::y);
  return rectangle(0, 0, width, one_in(random, 2) ? 1 : height);
}

}  // namespace

Rings negated(const Rings& rings) {
  Rings result;
  for (const Ring& ring : rings) {
    result.push_back(negated(ring));
  }
  return result;
}

RegionCase small_integers(Random& random) {
  const int extent = uniform(random, 2, 8);
  const Ring a = random_small_integer_polygon(random, uniform(random, 3, 8), extent);
  Ring b =
      one_in(random, 3) ? a : random_small_integer_polygon(random, uniform(random, 3, 7), extent);
  if (one_in(random, 2)) {
    b = negated(b);
  }
  return {{a}, {b}, false, random_shift(random)};
}

RegionCase histograms(Random& random) {
  const Ring a = random_histogram(random, uniform(random, 1, 5), 4);
  Ring b = one_in(random, 4) ? a : random_histogram(random, uniform(random, 1, 4), 4);
  if (!one_in(random, 3)) {
    b = negated(b);
  }
  return {{a}, {b}, false, random_shift(random)};
}

RegionCase mazes(Random& random) {
  const int columns = uniform(random, 2, 3);
  Cells cells = random_corridors(random, columns, uniform(random, 1, 3));
  const Ring part = random_rectangle(random, 2);
  const int kind = uniform(random, 0, 3);
  if (kind >= 2) {  // 2: a hole of a block, 3: open to the outside
    cells = block_around(cells);
    if (kind == 3) {
      cells.filled.erase({1 + 2 * uniform(random, 0, (cells.columns - 3) / 2), 0});
    }
  }
  const auto xs = random_lines(random, cells.columns, 1, 2);
  const auto ys = random_lines(random, cells.rows, 1, 2);
  const Rings rings = rings_of(cells, xs, ys);
  if (kind <= 1) {
    return {rings, {part}, true, random_shift(random)};
  }
  return {rings, {negated(part)}, false, random_shift(random)};
}

RegionCase combs(Random& random) {
  Fit fit = random_meshing_combs(random);
  if (one_in(random, 3)) {  // another comb, some teeth of which may fit
    fit.part = random_meshing_combs(random).part;
  }
  if (one_in(random, 4)) {  // a little narrower than the gaps
    for (Point& p : fit.part) {
      p.x *= 1 - 1.0 / 64;
    }
  }
  return no_fit(random, fit);
}

RegionCase c_shapes(Random& random) {
  Fit fit = random_pocket(random);
  if (one_in(random, 4)) {
    fit.part = random_rectangle(random, 4);
  }
  return no_fit(random, fit);
}

RegionCase keys_and_locks(Random& random) { return no_fit(random, random_key_and_lock(random)); }

RegionCase jigsaws(Random& random) { return no_fit(random, random_jigsaw(random)); }

RegionCase turned_fits(Random& random) {
  while (true) {
    Fit fit;
    switch (uniform(random, 0, 3)) {
      case 0:
        fit = random_meshing_combs(random);
        break;
      case 1:
        fit = random_key_and_lock(random);
        break;
      case 2:
        fit = random_pocket(random);
        break;
      default:
        fit = random_jigsaw(random);
    }
    // The cosine and the sine of an angle up to a quarter turn. Without their last bits, all
    // products and sums are exact: a turn that keeps every tie.
    const double t = uniform(random, 1, 999) / 1000.0;
    double cosine = (1 - t * t) / (1 + t * t);
    double sine = 2 * t / (1 + t * t);
    if (one_in(random, 4)) {
      cosine = std::round(cosine * 1024) / 1024;
      sine = std::round(sine * 1024) / 1024;
    }
    for (Ring* ring : {&fit.fixed, &fit.part}) {
      for (Point& p : *ring) {
        p = {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
      }
    }
    if (is_ring(fit.fixed) && is_ring(fit.part)) {
      return no_fit(random, fit);
    }
  }
}

RegionCase containers(Random& random) {
  Rings container;
  switch (uniform(random, 0, 4)) {
    case 0:
      container = {random_histogram(random, uniform(random, 2, 5), 5)};
      break;
    case 1:
      container = random_with_holes(random, 5, 8, 2);
      break;
    case 2: {  // islands with room round them
      const auto [width, height] = two(random, 6, 12);
      container = {rectangle(0, 0, width, height)};
      add_random_holes(random, container, uniform(random, 1, 3));
      Rings moving{random_small_part(random)};
      shrink_some(random, moving);
      return {container, moving, true, random_shift(random)};
    }
    default: {
      const int extent = uniform(random, 3, 10);
      container = {random_polygon(random, 3, 9, extent)};
    }
  }
  Rings moving{one_in(random, 2) ? rectangle_between_vertices(random, container)
                                 : random_small_part(random)};
  shrink_some(random, moving);
  return {container, moving, true, random_shift(random)};
}

RegionCase holes_that_touch(Random& random) {
  const Rings a = random_touching(random);
  const bool inner_fit = one_in(random, 2);
  Rings b;
  switch (uniform(random, 0, 4)) {
    case 0:
      b = random_touching(random);
      break;
    case 1:
      b = a;
      break;
    case 2:
      b = {rectangle_between_vertices(random, a)};
      break;
    default:
      b = {one_in(random, 2) ? random_small_part(random) : random_rectangle(random, 1)};
  }
  shrink_some(random, b);
  if (!inner_fit && one_in(random, 2)) {
    b = negated(b);
  }
  return {a, b, inner_fit, random_shift(random)};
}

RegionCase with_holes(Random& random) {
  const auto polygon = [&](int least_extent, int most_extent) {
    return one_in(random, 3) ? random_cell_polygon(random, 4)
                             : random_with_holes(random, least_extent, most_extent, 3);
  };
  const Rings a = polygon(4, 8);
  const bool inner_fit = one_in(random, 3);
  Rings b;
  switch (uniform(random, 0, 3)) {
    case 0:
      b = polygon(3, 3);
      break;
    case 1:  // just what fits in the last hole
      b = {a.back()};
      break;
    case 2:
      b = {rectangle_between_vertices(random, a)};
      break;
    default:
      b = {one_in(random, 2) ? random_small_part(random) : random_polygon(random, 3, 4, 1)};
  }
  shrink_some(random, b);
  if (!inner_fit) {
    b = negated(b);
  }
  return {a, b, inner_fit, random_shift(random)};
}

std::span<const RegionFamily> region_families() {
  static constexpr std::array<RegionFamily, 11> families{{
      {"small integers", small_integers},
      {"histograms", histograms},
      {"mazes", mazes},
      {"combs", combs},
      {"C shapes", c_shapes},
      {"keys and locks", keys_and_locks},
      {"jigsaws", jigsaws},
      {"turned fits", turned_fits},
      {"containers", containers},
      {"holes that touch", holes_that_touch},
      {"with holes", with_holes},
  }};
  return families;
}

}  // namespace gcv::test

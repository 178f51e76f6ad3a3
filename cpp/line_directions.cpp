// SPDX-License-Identifier: LGPL-3.0-or-later
#include "line_directions.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "direction_key.hpp"
#include "polygon.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

class LineSorter {
 public:
  explicit LineSorter(const Polygon& polygon) : polygon_(polygon) {}

  // By keys first. Where some of those are too near each other, exactly.
  LineDirections run() {
    take_lines();
    if (polygon_.is_convex) {
      merge_halves();
    } else {
      std::sort(lines_.begin(), lines_.end(),
                [](const Line& e, const Line& f) { return e.key > f.key; });
    }
    if (!number_lines()) {
      take_lines();
      std::stable_sort(lines_.begin(), lines_.end(), Before{this});
      number_lines();
    }
    return std::move(directions_);
  }

 private:
  using Line = LineDirections::Line;

  // One for each edge.
  void take_lines() {
    lines_.resize(polygon_.size());
    edges_.resize(polygon_.size());
    for (Index i = 0; i < polygon_.size(); ++i) {
      const Point& p = polygon_.vertices[i];
      const Point& q = polygon_.vertices[polygon_.next(i)];
      const bool up = points_up(p, q);
      edges_[i].points_up = up;
      lines_[i] = {up ? direction_key(p, q) : direction_key(q, p), i};
    }
  }

  // 1 where e comes before f, 0 where they are parallel.
  int compare(const Line& e, const Line& f) {
    if (const int order = compare_keys(e.key, f.key)) {
      return order;
    }
    const int sense = edges_[e.edge].points_up == edges_[f.edge].points_up ? 1 : -1;
    return sense * turn(polygon_.vertices[e.edge], polygon_.vertices[polygon_.next(e.edge)],
                        polygon_.vertices[f.edge], polygon_.vertices[polygon_.next(f.edge)],
                        tally_);
  }

  struct Before {
    LineSorter* sorter;
    bool operator()(const Line& e, const Line& f) const { return sorter->compare(e, f) > 0; }
  };

  // Of a convex polygon, the edges that point up are in order, and those that point down.
  void merge_halves() {
    const auto is_up = [this](const Line& e) { return edges_[e.edge].points_up; };
    const auto up = std::find_if(lines_.begin(), lines_.end(), [&](const Line& e) {
      return is_up(e) && !edges_[polygon_.previous(e.edge)].points_up;
    });
    std::rotate(lines_.begin(), up, lines_.end());
    const auto down = std::find_if_not(lines_.begin(), lines_.end(), is_up);
    std::inplace_merge(lines_.begin(), down, lines_.end(), Before{this});
  }

  // Of parallel lines, the one of the first edge stays. False where they are not in order.
  bool number_lines() {
    Index last = 0;
    edges_[lines_.front().edge].line = 0;
    for (const Line& line : std::span(lines_).subspan(1)) {
      const int order = compare(lines_[last], line);
      if (order > 0) {
        lines_[++last] = line;
      } else if (order < 0) {
        return false;
      } else if (line.edge < lines_[last].edge) {
        lines_[last] = line;
      }
      edges_[line.edge].line = last;
    }
    lines_.resize(std::size_t{last} + 1);
    return true;
  }

  const Polygon& polygon_;
  LineDirections directions_;
  Buffer<Line>& lines_ = directions_.lines;
  Buffer<LineDirections::Edge>& edges_ = directions_.edges;
  Tally tally_;
};

}  // namespace

LineDirections sort_line_directions(const Polygon& polygon) { return LineSorter(polygon).run(); }

}  // namespace gcv

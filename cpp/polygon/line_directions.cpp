// SPDX-License-Identifier: LGPL-3.0-or-later
#include "line_directions.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

#include "direction_key.hpp"
#include "predicates.hpp"
#include "task.hpp"

namespace gcv {

namespace {

class LineSorter {
 public:
  LineSorter(std::span<const Point> ring, const RingLayout& layout, bool is_convex)
      : vertices_(ring), layout_(layout), is_convex_(is_convex) {}

  // Sorts by keys. If some keys are too close to each other, sorts again exactly.
  LineDirections run() {
    take_lines();
    if (is_convex_) {
      merge_halves();
    } else {
      sort_by_keys();
    }
    if (!number_lines()) {
      take_lines();
      std::stable_sort(lines_.begin(), lines_.end(), Before{this});
      [[maybe_unused]] const bool in_order = number_lines();
      assert(in_order);
    }
    assert(lines_.size() >= 2 && lines_.size() <= edges_.size());
    return std::move(directions_);
  }

 private:
  using Line = LineDirections::Line;

  [[nodiscard]] Index next(Index i) const { return layout_.next(i); }
  [[nodiscard]] Index previous(Index i) const { return layout_.previous(i); }

  // Makes one line for each edge.
  void take_lines() {
    lines_.resize(vertices_.size());
    edges_.resize(vertices_.size());
    layout_.for_each_edge([&](Index i, Index next) {
      const Point& p = vertices_[i];
      const Point& q = vertices_[next];
      const bool up = points_up(p, q);
      edges_[i].points_up = up;
      lines_[i] = {up ? direction_key(p, q) : direction_key(q, p), i};
    });
  }

  // 1 if e comes before f, -1 if f comes before e, 0 if they are parallel.
  int compare(const Line& e, const Line& f) {
    if (const int order = compare_keys(e.key, f.key)) {
      return order;
    }
    const int sense = edges_[e.edge].points_up == edges_[f.edge].points_up ? 1 : -1;
    return sense * turn(vertices_[e.edge], vertices_[next(e.edge)], vertices_[f.edge],
                        vertices_[next(f.edge)], tally_);
  }

  struct Before {
    LineSorter* sorter;
    bool operator()(const Line& e, const Line& f) const {
      sorter->pace_.step();
      return sorter->compare(e, f) > 0;
    }
  };

  // A few are sorted before anyone could cancel.
  void sort_by_keys() {
    constexpr std::size_t few = 10000;
    const auto before = [](const Line& e, const Line& f) { return e.key > f.key; };
    if (lines_.size() <= few) {
      std::sort(lines_.begin(), lines_.end(), before);
    } else {
      std::sort(lines_.begin(), lines_.end(), [&](const Line& e, const Line& f) {
        pace_.step();
        return before(e, f);
      });
    }
  }

  // For convex polygons only. The edges that point up are in order already, and so are the edges
  // that point down.
  void merge_halves() {
    const auto is_up = [this](const Line& e) { return edges_[e.edge].points_up; };
    const auto up = std::find_if(lines_.begin(), lines_.end(), [&](const Line& e) {
      return is_up(e) && !edges_[previous(e.edge)].points_up;
    });
    std::rotate(lines_.begin(), up, lines_.end());
    const auto down = std::find_if_not(lines_.begin(), lines_.end(), is_up);
    std::inplace_merge(lines_.begin(), down, lines_.end(), Before{this});
  }

  // Of parallel lines, keeps that of the first edge. Returns false if the lines are not in order.
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

  std::span<const Point> vertices_;
  const RingLayout& layout_;
  bool is_convex_;
  LineDirections directions_;
  Buffer<Line>& lines_ = directions_.lines;
  Buffer<LineDirections::Edge>& edges_ = directions_.edges;
  Tally tally_;
  Pace pace_;
};

}  // namespace

LineDirections sort_line_directions(std::span<const Point> vertices, const RingLayout& layout,
                                    bool is_convex) {
  return LineSorter(vertices, layout, is_convex).run();
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One step of a walk: how the boundary leaves a superset edge s.
//
// 1. Every boundary point of A + B lies on a superset edge, and every superset edge lies in A + B
//    (a closed set).
// 2. A superset edge, directed as its source edge, has the sum on its left wherever it is on the
//    boundary.
// 3. So, walking along s with the free side on the right, the boundary leaves s at the first point,
//    strictly ahead, in which a superset edge goes to the right: one that ends strictly right of s
//    and starts left of it or on it. In such a point, turning from the way back counter-clockwise
//    through the free side, the first ray that a superset edge takes belongs to the boundary. An
//    edge that arrives there would have the sum on the free side, so the ray leaves. Of all edges
//    that leave, the most clockwise one is the next.
// 4. Where s ends first, the same holds in its end, for edges that go straight on or left. The slit
//    of an exact fit, whose two walls lie on each other, has the sum on both sides. It is a left
//    turn there, and stays closed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>

#include "box.hpp"
#include "place.hpp"
#include "stretch.hpp"

namespace gcv {

// Search: turn(e, f, tally) is the sign of the turn from one superset edge to another, 0 for
// opposite ones too; way(s, e, tally) says how e leaves s.
template <class Search>
class Step {
 public:
  // Each step begins in `place`.
  Step(const Operands& operands, const Search& search, const Place& place, double slack,
       Tally& tally)
      : operands_(operands), search_(search), from_(place), slack_(slack), tally_(tally) {}

  // Sets out along s, which ends in a sum of two vertices.
  void set_out(const PairEdge& s) {
    line_ = Line::of(operands_, s);
    origin_ = operands_.relative_start(s);
    go_to(end_of(operands_, s), 1);
  }
  // The same where other edges of the direction of s continue it: they end in `end`, at that
  // parameter on s.
  void go_to(const VertexSum& end, double length) {
    end_ = end;
    length_ = length;
    to_ = length == 1 ? relative_on(1) : operands_.relative(end.i, end.j);
    event_.reset();
    onwards_.reset();
  }

  [[nodiscard]] const Line& line() const { return line_; }
  [[nodiscard]] const VertexSum& end() const { return end_; }
  // The first event of the edges considered so far, and if there is none, the edge that goes on
  // from the end.
  [[nodiscard]] const std::optional<Event>& event() const { return event_; }
  [[nodiscard]] const std::optional<PairEdge>& onwards() const { return onwards_; }

  [[nodiscard]] Stretch stretch() const {
    const Point from = from_.is_sum ? operands_.relative(from_.sum.i, from_.sum.j)
                                    : relative_on(clamped(from_.parameter.lo));
    return {line_.at, origin_, from, to_, length_};
  }

  // Takes the edge into account. Is it the event now?
  bool consider(const PairEdge& e) {
    const Way way = search_.way(line_.edge, e, tally_);
    if (way == Way::right) {
      return consider_event(e);
    }
    if (way == Way::onwards && !event_ && !(end_of(operands_, e) == end_) && comes_near_end(e)) {
      consider_onwards(e);
    }
    return false;
  }
  // The parameter on s up to which edges still matter.
  [[nodiscard]] double limit() const {
    return event_ ? clamped(event_->place.parameter.hi) : length_;
  }

  // How many edges were looked at exactly.
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }

  // Of edges on one line, in the same direction, the one that reaches furthest is walked; of
  // those, the first by kind and indices, so that the order of the search tells nothing.
  bool is_preferred(const Line& e, const Line& f) {
    const int order = compare_along(f.at, operands_.end(f.edge), operands_.end(e.edge));
    const auto key = [](const Line& t) { return std::tuple(t.edge.kind, t.edge.i, t.edge.j); };
    return order > 0 || (order == 0 && key(e) < key(f));
  }

 private:
  [[nodiscard]] double clamped(double parameter) const {
    return std::min(std::max(parameter, 0.0), length_);
  }

  // A point on the line of s in relative coordinates.
  [[nodiscard]] Point relative_on(double parameter) const {
    return {origin_.x + parameter * line_.at.dx, origin_.y + parameter * line_.at.dy};
  }

  // On which side of the line lies the sum of two vertices? Where it is an end of the edge, the
  // indices say so.
  int side_of_sum(const Line& line, const VertexSum& line_end, const VertexSum& sum) {
    if (sum == start_of(line.edge) || sum == line_end) {
      ++tally_.filtered;
      return 0;
    }
    return side(line.at, operands_.point(sum), tally_);
  }
  int side_of_sum(const Line& line, const VertexSum& sum) {
    return side_of_sum(line, end_of(operands_, line.edge), sum);
  }

  // The sign of the way from p to q along the edge, for points on its line.
  int compare_along(const SumEdge& e, const SumPoint& p, const SumPoint& q) {
    if (e.from.x != e.to.x) {
      const int order = compare_x(q, p, tally_);
      return e.from.x < e.to.x ? order : -order;
    }
    const int order = compare_y(q, p, tally_);
    return e.from.y < e.to.y ? order : -order;
  }

  // Takes e for the event if it leaves s earlier than that, or in the same point more clockwise
  // (fact 3).
  bool consider_event(const PairEdge& e) {
    ++candidates_;
    if (side_of_sum(line_, end_, end_of(operands_, e)) >= 0) {
      return false;
    }
    const int start_side = side_of_sum(line_, end_, start_of(e));
    if (start_side < 0) {
      return false;
    }
    const Line t = Line::of(operands_, e);
    Event event{t, {start_side == 0, start_of(e), e, crossing_parameter(line_.at, t.at)}};
    if (!is_ahead(event) || !precedes(event)) {
      return false;
    }
    event_ = event;
    return true;
  }

  // Takes e for the edge that goes on from the end of s if it passes through that, or starts
  // there, and is the most clockwise one so far; of those in one direction, the one that reaches
  // furthest (fact 4).
  void consider_onwards(const PairEdge& e) {
    ++candidates_;
    if (onwards_) {
      const int left = search_.turn(*onwards_, e, tally_);
      if (left > 0 ||
          (left == 0 && !is_preferred(Line::of(operands_, e), Line::of(operands_, *onwards_)))) {
        return;
      }
    }
    if (start_of(e) == end_ || passes_through_end(Line::of(operands_, e))) {
      onwards_ = e;
    }
  }

  // Can the edge pass through the end of s?
  [[nodiscard]] bool comes_near_end(const PairEdge& e) const {
    const Box box = box_of(operands_.relative_start(e), operands_.relative_end(e));
    return !are_apart(widened(box, slack_), box_of(to_, to_));
  }

  // Does t hold the end of s, its own end excepted?
  bool passes_through_end(const Line& t) {
    const SumPoint q = operands_.point(end_);
    return side_of_sum(t, end_) == 0 && compare_along(t.at, t.at.origin, q) >= 0 &&
           compare_along(t.at, q, operands_.end(t.edge)) > 0;
  }

  // Is the event strictly beyond the place where the step begins? An event edge t goes from left
  // to right, so a point p of s before the event lies on the right of t. A point beyond the place
  // lies on the side of the crossing edge that s goes to.
  bool is_ahead(const Event& event) {
    if (from_.is_sum) {
      return side_of_sum(event.line, from_.sum) < 0;
    }
    const Line r = Line::of(operands_, from_.crossing);
    if (event.place.is_sum) {
      return side_of_sum(r, event.place.sum) == search_.turn(r.edge, line_.edge, tally_);
    }
    return compare_parameters(event.place.parameter, event.line, from_.parameter, r) > 0;
  }

  int compare_parameters(const Interval& pt, const Line& t, const Interval& pr, const Line& r) {
    if (const int order = order_of(pt, pr); order != 0) {
      ++tally_.filtered;
      return order;
    }
    return compare_crossings(line_.at, t.at, r.at, tally_);
  }

  // Does the event come before the best one so far, or, in the same point, is it more clockwise or
  // longer? Without a best one: does it come before the end of s, or there? In a tie the event
  // takes a place that is known as a sum of two vertices.
  bool precedes(Event& event) {
    if (!event_) {
      const int order = side_of_sum(event.line, end_);
      if (order == 0 && !event.place.is_sum) {
        event.place.become(end_);
      }
      return order >= 0;
    }
    const int order = compare_to_best(event);
    if (order != 0) {
      return order < 0;
    }
    if (event.place.is_sum) {
      event_->place.become(event.place.sum);
    } else if (event_->place.is_sum) {
      event.place.become(event_->place.sum);
    }
    const int right = search_.turn(event.line.edge, event_->line.edge, tally_);
    return right > 0 || (right == 0 && is_preferred(event.line, event_->line));
  }

  int compare_to_best(const Event& event) {
    const Place& best = event_->place;
    if (best.is_sum) {
      return -side_of_sum(event.line, best.sum);
    }
    if (event.place.is_sum) {
      return side_of_sum(event_->line, event.place.sum);
    }
    return compare_parameters(event.place.parameter, event.line, best.parameter, event_->line);
  }

  const Operands& operands_;
  const Search& search_;
  const Place& from_;
  double slack_;
  Tally& tally_;
  std::uint64_t candidates_ = 0;

  Line line_;        // s
  Point origin_{};   // its start in relative coordinates
  VertexSum end_{};  // its end, or that of the edges which continue it
  Point to_{};       // the same in relative coordinates
  double length_ = 1;
  std::optional<Event> event_;
  std::optional<PairEdge> onwards_;
};

}  // namespace gcv

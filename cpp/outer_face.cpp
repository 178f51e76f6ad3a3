// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Facts that the walk rests on.
//
// 1. Every boundary point of A + B lies on a superset edge, and every superset edge lies
//    in A + B (a closed set).
// 2. A superset edge, directed as its source edge, has the sum on its left wherever it is
//    on the boundary.
// 3. So, walking counter-clockwise along s, the right side of s is free, and the boundary
//    leaves s at the first point, strictly ahead, in which a superset edge goes to the
//    right: one that ends strictly right of s and starts left of it or on it. In such a
//    point, turning from the way back counter-clockwise through the free side, the first
//    ray that a superset edge takes belongs to the boundary; an edge that arrives there
//    would have the sum on the free side, so the ray leaves: of all edges that leave, the
//    most clockwise one is the next.
// 4. Where s ends first, the same holds in its end, for edges that go straight on or left.
//    The slit of an exact fit, whose two walls lie on each other, has the sum on both
//    sides; it is a left turn there, and stays closed.
// 5. The walk starts in lexmin(A) + lexmin(B), which is the sum of those two vertices
//    alone, and ends there: the interior of A + B is connected, so the boundary of the
//    unbounded face is one ring that visits no point twice.
#include "outer_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "convex_sum.hpp"
#include "error.hpp"
#include "hull.hpp"
#include "implicit_superset.hpp"
#include "local_superset.hpp"
#include "parallel.hpp"

namespace gcv {

namespace {

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

// A point on a superset edge: the sum of the vertices i and j, or else the crossing with
// `crossing`, whose parameter on the edge is enclosed by `parameter`.
struct Place {
  bool is_sum;
  Index i;
  Index j;
  PairEdge crossing;
  Interval parameter;
};

// A superset edge with its coordinates.
struct Line {
  PairEdge edge;
  SumEdge at;
};

struct Event {
  Line line;  // the edge that leaves there
  Place place;
};

// How a walk along an edge goes on: at the first event, else at its end.
struct Step {
  std::optional<Event> event;
  std::optional<Line> onwards;
};

double clamp_to_unit(double parameter) { return std::min(std::max(parameter, 0.0), 1.0); }

// A piece of an edge s, from `from` to `to` in relative coordinates, as a place to search.
//
// With u times the extents of both polygons, uE, as the unit: a box side is off by 2, an end
// of the piece by 5. Of the offset from the line of s, times |dx| + |dy|: the end of a chain
// is off by 1, its radius by 8, `origin` by 2, and the products and sums of all add 20.
// `slack` is 64. The smallest normal double covers underflow. Where anything overflows,
// nothing is dropped.
class Piece {
 public:
  Piece(const SumEdge& s, const Point& origin, const Point& from, const Point& to, double slack)
      : dx_(s.dx),
        dy_(s.dy),
        length_(length_bound(s.dx, s.dy)),
        offset_(s.dx * origin.y - s.dy * origin.x),
        tolerance_(offset_tolerance(s.dx, s.dy, slack)),
        slack_(slack),
        margin_(margin(slack)),
        from_(from),
        to_(to) {
    shorten(to);
  }

  void shorten(const Point& to) {
    to_ = to;
    const Box box = box_of(from_, to);
    box_ = {box.x0 - slack_, box.y0 - slack_, box.x1 + slack_, box.y1 + slack_};
  }

  [[nodiscard]] ImplicitSuperset::Offsets offsets(const Box& box) const {
    return {dx_ * (dx_ > 0 ? box.y0 : box.y1) - dy_ * (dy_ > 0 ? box.x1 : box.x0),
            dx_ * (dx_ > 0 ? box.y1 : box.y0) - dy_ * (dy_ > 0 ? box.x0 : box.x1)};
  }

  // The lanes that reach the box of the piece, and the line of s or both of its sides.
  void look(const ImplicitSuperset::Block& block, const ImplicitSuperset::Node& other,
            ImplicitSuperset::Look& look) const {
    const CapsuleBlock& capsules = block.capsules;
    for (unsigned k = 0; k <= ChainTree::width; ++k) {
      look.offset[k] = dx_ * capsules.y[k] - dy_ * capsules.x[k];
    }
    const Lanes from = Lanes::load(look.offset);
    const Lanes to = Lanes::load(look.offset + 1);
    const Lanes radius = length_ * Lanes::load(capsules.radius);
    const Lanes lowest = smaller(from, to) - radius;
    const Lanes highest = larger(from, to) + radius;
    lowest.store(look.lowest);
    highest.store(look.highest);
    const unsigned apart = ((highest < offset_ - tolerance_ - other.offsets.highest) |
                            (lowest > offset_ + tolerance_ - other.offsets.lowest))
                               .bits();
    look.lanes = overlapping(block.boxes, {box_.x0 - other.box.x1, box_.y0 - other.box.y1,
                                           box_.x1 - other.box.x0, box_.y1 - other.box.y0}) &
                 ~apart;
    if (look.lanes != 0 && other.radius == 0) {
      look.lanes &= ~(apart_along_chains(capsules, other) | apart_along(capsules, other)).bits();
    }
  }

  // Those whose chains, as segments, cross the line of s earlier come first.
  template <class Visit>
  void order(const ImplicitSuperset::Look& look, const ImplicitSuperset::Block& block,
             const ImplicitSuperset::Node& other, Visit visit) const {
    if ((look.lanes & (look.lanes - 1)) == 0) {
      for_each_lane(look.lanes, visit);
      return;
    }
    const double middle = offset_ - (other.offsets.lowest + other.offsets.highest) / 2;
    const CapsuleBlock& capsules = block.capsules;
    double key[ChainTree::width];
    std::uint32_t lane[ChainTree::width];
    unsigned count = 0;
    for_each_lane(look.lanes, [&](std::uint32_t k) {
      const double fraction = (middle - look.offset[k]) / (look.offset[k + 1] - look.offset[k]);
      const double t = fraction > 0 ? std::min(fraction, 1.0) : 0.0;
      const double along = dx_ * (capsules.x[k] + t * (capsules.x[k + 1] - capsules.x[k])) +
                           dy_ * (capsules.y[k] + t * (capsules.y[k + 1] - capsules.y[k]));
      unsigned place = count++;
      for (; place > 0 && along < key[place - 1]; --place) {
        key[place] = key[place - 1];
        lane[place] = lane[place - 1];
      }
      key[place] = along;
      lane[place] = k;
    });
    for (unsigned k = 0; k < count; ++k) {
      visit(lane[k]);
    }
  }

 private:
  // Twice the slack; infinite where the offset of a point from a chain can overflow.
  static double margin(double slack) {
    const double extents = 0x1p48 * slack;
    return extents * extents <= std::numeric_limits<double>::max()
               ? 2 * slack
               : std::numeric_limits<double>::infinity();
  }

  // Lanes whose sums with the other node lie beside the piece, seen along their chains.
  [[nodiscard]] LaneMask apart_along_chains(const CapsuleBlock& capsules,
                                            const ImplicitSuperset::Node& other) const {
    const Lanes x = Lanes::load(capsules.x);
    const Lanes y = Lanes::load(capsules.y);
    const Lanes dx = Lanes::load(capsules.x + 1) - x;
    const Lanes dy = Lanes::load(capsules.y + 1) - y;
    const auto offset = [&](const Point& p) { return p.y * dx - p.x * dy; };
    const Lanes chain = dx * y - dy * x;
    const Lanes first = offset(other.from);
    const Lanes second = offset(other.to);
    const Lanes begin = offset(from_) - chain;
    const Lanes end = offset(to_) - chain;
    const Lanes reach =
        (Lanes::load(capsules.radius) + (other.radius + margin_)) * (magnitude(dx) + magnitude(dy));
    return (larger(first, second) + reach < smaller(begin, end)) |
           (smaller(first, second) - reach > larger(begin, end));
  }

  // The same, seen along the chain of the other node.
  [[nodiscard]] LaneMask apart_along(const CapsuleBlock& capsules,
                                     const ImplicitSuperset::Node& other) const {
    const double dx = other.to.x - other.from.x;
    const double dy = other.to.y - other.from.y;
    const auto offset = [&](const Point& p) { return dx * p.y - dy * p.x; };
    const double chain = offset(other.from);
    const double begin = offset(from_) - chain;
    const double end = offset(to_) - chain;
    const Lanes first = dx * Lanes::load(capsules.y) - dy * Lanes::load(capsules.x);
    const Lanes second = dx * Lanes::load(capsules.y + 1) - dy * Lanes::load(capsules.x + 1);
    const double size = std::abs(dx) + std::abs(dy);
    const Lanes reach = size * (Lanes::load(capsules.radius) + (other.radius + margin_)) +
                        std::numeric_limits<double>::min();
    return (larger(first, second) + reach < std::min(begin, end)) |
           (smaller(first, second) - reach > std::max(begin, end));
  }

  double dx_;
  double dy_;
  double length_;
  double offset_;  // of the line of s, from the relative origin
  double tolerance_;
  double slack_;
  double margin_;  // infinite where an offset can overflow
  Point from_;
  Point to_;
  Box box_{};
};

// A walk from one vertex of the hull to the next, and the edge that it arrived by.
struct Arc {
  Walk walk;
  PairEdge last;
  Tally tally;
};

// Moves the elements to the end of the list.
template <class Element>
void append(std::vector<Element>& list, std::vector<Element>& elements) {
  if (list.empty()) {
    list = std::move(elements);
  } else {
    list.insert(list.end(), elements.begin(), elements.end());
    elements = {};
  }
}

double slack_of(const Operands& operands) {
  const Box& a = operands.a.bounds;
  const Box& b = operands.b.bounds;
  const double extents = ((a.x1 - a.x0) + (a.y1 - a.y0)) + ((b.x1 - b.x0) + (b.y1 - b.y0));
  return 64 * unit_roundoff * extents + std::numeric_limits<double>::min();
}

// A walk from one vertex of the convex hull of the sum to another. Such a vertex is on the
// outer face, and the sum of two vertices in one way only: no superset edge passes through
// it, so the walk leaves it along one that starts there, and arrives by the end of another.
class Walker {
 public:
  Walker(const ImplicitSuperset& superset, double slack, Task& task)
      : operands_(superset.operands()),
        directions_(operands_.directions),
        superset_(superset),
        slack_(slack),
        local_(superset, slack),
        task_(task) {}

  // The first vertex has no arriving edge yet: it is that of the walk that ends there.
  Arc run(const HullVertex& first, const HullVertex& last) {
    const std::size_t guess = std::min<std::size_t>(operands_.a.size() + operands_.b.size(), 4096);
    walk_.vertices.reserve(guess);
    walk_.leaving.reserve(guess);
    walk_.arriving.reserve(guess);
    Place place = sum_place(first.i, first.j);
    Line line = line_of(first_edge(first.i, first.j));
    append(place, line, line);
    while (true) {
      count_step();
      const Step step = next_step(line, place);
      Line next;
      if (step.event) {
        place = step.event->place;
        next = step.event->line;
      } else {
        place = end_of(line.edge);
        if (place.i == last.i && place.j == last.j) {
          break;
        }
        if (!step.onwards) {
          throw Error(Status::internal,
                      "no superset edge leads on from vertex %u of a + vertex %u of b",
                      operands_.a.vertex_number[place.i], operands_.b.vertex_number[place.j]);
        }
        next = *step.onwards;
      }
      if (!place.is_sum) {  // from now on, seen from the next edge
        place.crossing = line.edge;
        place.parameter = crossing_parameter(next.at, line.at);
      }
      if (operands_.rank(next.edge) != operands_.rank(line.edge)) {
        append(place, line, next);
      }
      line = next;
    }
    task_.advance(walk_.steps % Task::portion);
    return {std::move(walk_), line.edge, tally_};
  }

 private:
  void append(const Place& place, const Line& arriving, const Line& leaving) {
    walk_.vertices.push_back({place.is_sum, place.i, place.j});
    walk_.arriving.push_back(arriving.edge);
    walk_.leaving.push_back(leaving.edge);
  }

  // One face of an arrangement of N segments has almost N edges at most, up to a factor
  // that no real N brings above 64. A walk beyond that has lost its way.
  void count_step() {
    if (++walk_.steps % Task::portion != 0) {
      return;
    }
    task_.advance(Task::portion);
    const double segments = 2.0 * operands_.a.size() * operands_.b.size();
    if (static_cast<double>(walk_.steps) > 64 * segments) {
      throw Error(Status::internal, "the walk along the outer face does not end");
    }
  }

  [[nodiscard]] Line line_of(const PairEdge& e) const {
    return {e, coordinates(operands_.a, operands_.b, e)};
  }

  static Place sum_place(Index i, Index j) { return {true, i, j, {}, {}}; }

  [[nodiscard]] Place end_of(const PairEdge& e) const {
    return e.kind == PairEdge::translated ? sum_place(operands_.a.next(e.i), e.j)
                                          : sum_place(e.i, operands_.b.next(e.j));
  }

  [[nodiscard]] SumPoint point(Index i, Index j) const {
    return {operands_.a.vertices[i], operands_.b.vertices[j]};
  }
  [[nodiscard]] SumPoint end_point(const PairEdge& e) const {
    const Place end = end_of(e);
    return point(end.i, end.j);
  }

  // On which side of the line lies the sum of the vertices i and j? Where it is an end of
  // the edge, the indices say so.
  int side_of_sum(const Line& line, Index i, Index j) {
    const Place end = end_of(line.edge);
    if ((i == line.edge.i && j == line.edge.j) || (i == end.i && j == end.j)) {
      ++tally_.filtered;
      return 0;
    }
    return side(line.at, point(i, j), tally_);
  }

  // The sign of the way from p to q along the edge, for points on its line.
  int compare_along(const SumEdge& e, const SumPoint& p, const SumPoint& q) {
    if (e.from.x != e.to.x) {
      const int order = compare_sums(q.a.x, q.b.x, p.a.x, p.b.x, tally_);
      return e.from.x < e.to.x ? order : -order;
    }
    const int order = compare_sums(q.a.y, q.b.y, p.a.y, p.b.y, tally_);
    return e.from.y < e.to.y ? order : -order;
  }

  // Of edges on one line, in the same direction, the one that reaches furthest is walked;
  // of those, the first by kind and indices, so that the order of the search tells nothing.
  bool preferred(const Line& e, const Line& f) {
    const int order = compare_along(f.at, end_point(f.edge), end_point(e.edge));
    const auto key = [](const Line& t) { return std::tuple(t.edge.kind, t.edge.i, t.edge.j); };
    return order > 0 || (order == 0 && key(e) < key(f));
  }

  // Of the two edges that start in lexmin(A) + lexmin(B), the more clockwise one.
  PairEdge first_edge(Index i, Index j) {
    const PairEdge translated{PairEdge::translated, i, j};
    const PairEdge corner{PairEdge::corner, i, j};
    const Rank angle = directions_.angle(operands_.rank(translated), operands_.rank(corner));
    if (angle == 0) {
      return preferred(line_of(translated), line_of(corner)) ? translated : corner;
    }
    return angle < directions_.half_turn ? translated : corner;
  }

  // The sum of the vertices i and j in relative coordinates.
  [[nodiscard]] Point relative(Index i, Index j) const {
    const Point& p = operands_.a.relative[i];
    const Point& q = operands_.b.relative[j];
    return {p.x + q.x, p.y + q.y};
  }

  // A point on the line in relative coordinates.
  [[nodiscard]] Point relative_on(const Line& s, double parameter) const {
    const Point origin = relative(s.edge.i, s.edge.j);
    return {origin.x + parameter * s.at.dx, origin.y + parameter * s.at.dy};
  }

  // A place on s in relative coordinates, not beyond its exact position.
  [[nodiscard]] Point relative_position(const Line& s, const Place& place) const {
    return place.is_sum ? relative(place.i, place.j)
                        : relative_on(s, clamp_to_unit(place.parameter.lo));
  }

  // How the boundary leaves s, beyond `place`.
  Step next_step(const Line& s, const Place& place) {
    const Point from = relative_position(s, place);
    const Point end = relative_on(s, 1);
    const double length = std::max(std::abs(end.x - from.x), std::abs(end.y - from.y));
    if (local_.covers(from, end) || (length < local_.reach() && local_.gather(from, end))) {
      Step step;
      const Point origin = relative(s.edge.i, s.edge.j);
      local_.for_each_near(origin, s.at.dx, s.at.dy, end,
                           [&](const PairEdge& e) { consider(s, place, end, e, step); });
      return step;
    }
    return search_step(s, place, from, end);
  }

  // The same without the help of what is near the last steps. The first piece of s that is
  // searched is about as long as the last of these steps were, each other one four times as long
  // as the one before.
  Step search_step(const Line& s, const Place& place, Point from, const Point& end) {
    const Point origin = relative(s.edge.i, s.edge.j);
    const double start = parameter_on(s, origin, from);
    const double size = std::max(std::abs(s.at.dx), std::abs(s.at.dy));
    double parameter = start;
    double stride = std::max(0x1p-4, stride_ / size);  // also where numbers have overflowed
    Step step;
    while (true) {
      const double limit = step.event ? clamp_to_unit(step.event->place.parameter.hi) : 1;
      const bool is_last = !(parameter + stride < limit);
      parameter = is_last ? limit : parameter + stride;
      const Point to = parameter < 1 ? relative_on(s, parameter) : end;
      Piece piece(s.at, origin, from, to, slack_);
      superset_.search(piece, [&](Index i, Index j) {
        superset_.for_each_edge(i, j, [&](const PairEdge& e) {
          if (consider(s, place, end, e, step) && step.event->place.parameter.hi < parameter) {
            piece.shorten(relative_on(s, clamp_to_unit(step.event->place.parameter.hi)));
          }
        });
      });
      if (is_last || (step.event && step.event->place.parameter.hi <= parameter)) {
        break;
      }
      from = to;
      stride *= 4;
    }
    const double way = (step.event ? clamp_to_unit(step.event->place.parameter.hi) : 1) - start;
    stride_ = std::min(2 * way * size, 4 * stride_);
    return step;
  }

  // Does the boundary leave s along e, of all edges so far? True where e is the first event.
  bool consider(const Line& s, const Place& place, const Point& end, const PairEdge& e,
                Step& step) {
    const Rank angle = directions_.angle(operands_.rank(s.edge), operands_.rank(e));
    if (angle > directions_.half_turn) {
      return consider_event(s, place, e, step.event);
    }
    if (angle < directions_.half_turn && !step.event && comes_near(e, end)) {
      consider_onwards(s, e, step.onwards);
    }
    return false;
  }

  // The parameter on s of a point of s, about.
  [[nodiscard]] static double parameter_on(const Line& s, const Point& origin, const Point& p) {
    const bool by_x = std::abs(s.at.dx) >= std::abs(s.at.dy);
    return clamp_to_unit(by_x ? (p.x - origin.x) / s.at.dx : (p.y - origin.y) / s.at.dy);
  }

  // The first point on s, beyond `place`, in which an edge leaves to the right (fact 3),
  // and the most clockwise of those that do: is it e?
  bool consider_event(const Line& s, const Place& place, const PairEdge& e,
                      std::optional<Event>& best) {
    ++walk_.candidates;
    const Place end = end_of(e);
    if (side_of_sum(s, end.i, end.j) >= 0) {
      return false;
    }
    const int start_side = side_of_sum(s, e.i, e.j);
    if (start_side < 0) {
      return false;
    }
    const Line t = line_of(e);
    Event event{t, {start_side == 0, e.i, e.j, e, crossing_parameter(s.at, t.at)}};
    if (!is_ahead(s, place, event) || !precedes(s, event, best)) {
      return false;
    }
    best = event;
    return true;
  }

  // The most clockwise of the edges that pass through the end of s, or start there, and
  // go straight on or left (fact 4); of those in one direction, the one that reaches
  // furthest: is it e?
  void consider_onwards(const Line& s, const PairEdge& e, std::optional<Line>& best) {
    ++walk_.candidates;
    const Rank rank = operands_.rank(s.edge);
    const auto angle = [&](const Line& t) {
      return directions_.angle(rank, operands_.rank(t.edge));
    };
    const Line t = line_of(e);
    if (best && angle(t) > angle(*best)) {
      return;
    }
    if (leaves(t, end_of(s.edge)) && (!best || angle(t) < angle(*best) || preferred(t, *best))) {
      best = t;
    }
  }

  // Can the edge pass through p?
  [[nodiscard]] bool comes_near(const PairEdge& e, const Point& p) const {
    const Place end = end_of(e);
    const Box box = box_of(relative(e.i, e.j), relative(end.i, end.j));
    return !(p.x < box.x0 - slack_ || p.x > box.x1 + slack_ || p.y < box.y0 - slack_ ||
             p.y > box.y1 + slack_);
  }

  // Is the event strictly beyond the place on s? An event edge t goes from left to right,
  // so a point p of s before the event lies on the right of t. The edge that crosses s in
  // the place goes from right to left: s leaves it to the right.
  bool is_ahead(const Line& s, const Place& place, const Event& event) {
    if (place.is_sum) {
      return side_of_sum(event.line, place.i, place.j) < 0;
    }
    const Line r = line_of(place.crossing);
    if (event.place.is_sum) {
      return side_of_sum(r, event.place.i, event.place.j) < 0;
    }
    return compare_parameters(s, event.place.parameter, event.line, place.parameter, r) > 0;
  }

  int compare_parameters(const Line& s, const Interval& pt, const Line& t, const Interval& pr,
                         const Line& r) {
    if (pt.hi < pr.lo || pt.lo > pr.hi) {
      ++tally_.filtered;
      return pt.hi < pr.lo ? -1 : 1;
    }
    return compare_crossings(s.at, t.at, r.at, tally_);
  }

  // Does the event come before the best one so far, or, in the same point, is it more
  // clockwise or longer? Without a best one: does it come before the end of s, or there?
  // In a tie the event takes a place that is known as a sum of two vertices.
  bool precedes(const Line& s, Event& event, std::optional<Event>& best) {
    if (!best) {
      const Place end = end_of(s.edge);
      const int order = side_of_sum(event.line, end.i, end.j);
      if (order == 0 && !event.place.is_sum) {
        take_sum(event.place, end);
      }
      return order >= 0;
    }
    const int order = compare_events(s, event, *best);
    if (order != 0) {
      return order < 0;
    }
    if (event.place.is_sum) {
      take_sum(best->place, event.place);
    } else if (best->place.is_sum) {
      take_sum(event.place, best->place);
    }
    const Rank rank = operands_.rank(s.edge);
    const Rank angle = directions_.angle(rank, operands_.rank(event.line.edge));
    const Rank best_angle = directions_.angle(rank, operands_.rank(best->line.edge));
    return angle < best_angle || (angle == best_angle && preferred(event.line, best->line));
  }

  static void take_sum(Place& place, const Place& sum) {
    place.is_sum = true;
    place.i = sum.i;
    place.j = sum.j;
  }

  int compare_events(const Line& s, const Event& event, const Event& best) {
    if (best.place.is_sum) {
      return -side_of_sum(event.line, best.place.i, best.place.j);
    }
    if (event.place.is_sum) {
      return side_of_sum(best.line, event.place.i, event.place.j);
    }
    return compare_parameters(s, event.place.parameter, event.line, best.place.parameter,
                              best.line);
  }

  // Does t pass through the sum of two vertices, or start there?
  bool leaves(const Line& t, const Place& sum) {
    if (t.edge.i == sum.i && t.edge.j == sum.j) {
      return true;
    }
    const SumPoint q = point(sum.i, sum.j);
    return side_of_sum(t, sum.i, sum.j) == 0 && compare_along(t.at, t.at.origin, q) >= 0 &&
           compare_along(t.at, q, end_point(t.edge)) > 0;
  }

  const Operands& operands_;
  const Directions& directions_;
  const ImplicitSuperset& superset_;
  double slack_;
  LocalSuperset local_;
  double stride_ = std::numeric_limits<double>::infinity();  // twice the last steps
  Task& task_;
  Tally tally_;
  Walk walk_;
};

// The ring of the arcs.
Walk join(std::vector<Arc> arcs, Tally& tally) {
  Walk walk;
  const PairEdge* arriving = &arcs.back().last;
  for (Arc& arc : arcs) {
    arc.walk.arriving.front() = *arriving;
    arriving = &arc.last;
    append(walk.vertices, arc.walk.vertices);
    append(walk.arriving, arc.walk.arriving);
    append(walk.leaving, arc.walk.leaving);
    walk.steps += arc.walk.steps;
    walk.candidates += arc.walk.candidates;
    tally += arc.tally;
  }
  return walk;
}

}  // namespace

Walk walk_outer_face(const Operands& operands, Task& task, Tally& tally) {
  if (operands.a.is_convex && operands.b.is_convex) {
    return merge_convex(operands);
  }
  const ImplicitSuperset superset(operands);
  const double slack = slack_of(operands);
  const std::vector<HullVertex> starts = hull_vertices(operands.a, operands.b, task.threads());
  std::vector<Arc> arcs(starts.size());
  for_each_in_parallel(arcs.size(), task.threads(), [&](std::size_t k) {
    arcs[k] = Walker(superset, slack, task).run(starts[k], starts[(k + 1) % starts.size()]);
  });
  return join(std::move(arcs), tally);
}

}  // namespace gcv

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
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "convex_sum.hpp"
#include "convolution_cycle.hpp"
#include "doubled.hpp"
#include "error.hpp"
#include "hull.hpp"
#include "implicit_superset.hpp"
#include "local_superset.hpp"
#include "parallel.hpp"
#include "piece.hpp"
#include "strip.hpp"
#include "superset_tree.hpp"

namespace gcv {

namespace {

// The sum of two vertices.
struct VertexSum {
  Index i;
  Index j;

  friend bool operator==(const VertexSum&, const VertexSum&) = default;
};

// A point on a superset edge: the sum of two vertices, or else the crossing with `crossing`, whose
// parameter on the edge is enclosed by `parameter`.
struct Place {
  bool is_sum;
  VertexSum sum;
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

double clamp_to_unit(double parameter) { return std::min(std::max(parameter, 0.0), 1.0); }

// A walk from one vertex of the hull to the next, and the edge that it arrived by.
struct Arc {
  Walk walk;
  EdgeName last;
  Tally tally;
};

// The superset in one of three forms: as a cycle, where that can be; in a tree, where it is small;
// or else implicit. So it is, too, where edges are too short for the grid of the tree, or repeated
// chains prevail, so that too many edges coincide.
class Superset {
 public:
  // Without a cycle, the directions are known.
  Superset(const Operands& operands, std::optional<ConvolutionCycle> cycle)
      : operands_(operands), cycle_(std::move(cycle)) {
    if (cycle_) {
      return;
    }
    const CoarseGrid grid(operands);
    std::optional<RankedEdges> ranked;
    // At least: a vertex contributes to every edge.
    std::uint64_t size = std::uint64_t{operands.a.size()} + operands.b.size();
    if (size <= SupersetTree::most_edges && grid.is_fine_enough(operands)) {
      ranked.emplace(operands.directions);
      size = count_superset(operands, *ranked);
    }
    const bool is_small = ranked && size <= SupersetTree::most_edges;
    RepeatedChains chains;
    if (!is_small || chains_can_prevail(operands)) {
      chains = find_repeated_chains(operands);
    }
    if (is_small && !chains.prevail) {
      tree_.emplace(operands, grid, *ranked, size);
    } else {
      implicit_.emplace(operands, std::move(chains));
    }
  }

  [[nodiscard]] const Operands& operands() const { return operands_; }
  [[nodiscard]] const std::optional<ConvolutionCycle>& cycle() const { return cycle_; }
  [[nodiscard]] const std::optional<SupersetTree>& tree() const { return tree_; }
  [[nodiscard]] const std::optional<ImplicitSuperset>& implicit() const { return implicit_; }

 private:
  const Operands& operands_;
  std::optional<ConvolutionCycle> cycle_;
  std::optional<SupersetTree> tree_;
  std::optional<ImplicitSuperset> implicit_;
};

// A walk from one vertex of the convex hull of the sum to another. Such a vertex is on the
// outer face, and the sum of two vertices in one way only: no superset edge passes through
// it, so the walk leaves it along one that starts there, and arrives by the end of another.
class Walker {
 public:
  Walker(const Superset& superset, double slack, Task& task)
      : operands_(superset.operands()),
        directions_(operands_.directions),
        superset_(superset),
        slack_(slack),
        task_(task) {
    if (superset.implicit()) {
      if (superset.implicit()->has_repeated_chains()) {
        met_ = std::make_unique<PairsMet>();
      }
      local_.emplace(*superset.implicit(), slack);
      strip_.emplace(*superset.implicit(), slack);
    }
  }

  // The first vertex has no arriving edge yet: it is that of the walk that ends there.
  Arc run(const HullVertex& first, const HullVertex& last) {
    const std::size_t vertices = std::size_t{operands_.a.size()} + operands_.b.size();
    walk_.vertices.reserve(std::min<std::size_t>(vertices + vertices / 4, 4096));
    PairEdge next = first_edge(first.i, first.j);
    EdgeName arriving = next;
    bool turns = true;
    stop_at({first.i, first.j});
    while (true) {
      if (turns) {
        walk_.vertices.push_back(place_.is_sum
                                     ? RingVertex::sum(place_.sum.i, place_.sum.j, arriving, next)
                                     : RingVertex::crossing(arriving, next));
      }
      count_step();
      if (const std::optional<Index> onwards = only_way_on()) {
        const EdgeName& edge = superset_.cycle()->edge(*onwards);
        line_.edge = next;
        stop_at({edge.i, edge.j});
        if (place_.sum == VertexSum{last.i, last.j}) {
          break;
        }
        arriving = next;
        turns = !superset_.cycle()->goes_straight_on(*onwards);
        next = unranked(edge);
        continue;
      }
      set_out(next);
      find_step();
      if (event_) {
        next = event_->line.edge;
        place_ = event_->place;
        if (!place_.is_sum) {  // from now on, seen from the next edge
          place_.crossing = line_.edge;
          place_.parameter = crossing_parameter(event_->line.at, line_.at);
        }
      } else if (end_sum_ == VertexSum{last.i, last.j}) {
        break;
      } else if (onwards_) {
        next = *onwards_;
        stop_at(end_sum_);
      } else {
        throw Error(Status::internal,
                    "no superset edge leads on from vertex %u of a + vertex %u of b",
                    operands_.a.corners[end_sum_.i].vertex_number,
                    operands_.b.corners[end_sum_.j].vertex_number);
      }
      arriving = line_.edge;
      turns = turn_between(line_.edge, next) != 0;
    }
    task_.advance(walk_.steps % Task::portion);
    return {std::move(walk_), line_.edge, tally_};
  }

 private:
  void stop_at(const VertexSum& sum) {
    place_.is_sum = true;
    place_.sum = sum;
  }

  // Goes on along an edge, from the place.
  void set_out(const PairEdge& edge) {
    line_ = line_of(edge);
    end_sum_ = end_of(edge);
    end_ = relative_on(line_, 1);
    event_.reset();
    onwards_.reset();
  }

  // Where the superset is a cycle, and no edges come near s but its neighbours: the one behind it,
  // which the walk is on then.
  std::optional<Index> only_way_on() {
    const auto& cycle = superset_.cycle();
    const std::optional<Index> next = cycle ? cycle->only_way_on(number_) : std::nullopt;
    if (next) {
      ++walk_.candidates;
      number_ = *next;
    }
    return next;
  }

  // Where the superset is a cycle, directions have no ranks.
  static PairEdge unranked(const EdgeName& edge) { return {edge, 0}; }

  // The sign of the turn from one edge to another, 1 to the left; 0 for opposite ones too.
  int turn_between(const PairEdge& e, const PairEdge& f) {
    if (superset_.cycle()) {
      const auto [e_from, e_to] = operands_.source(e);
      const auto [f_from, f_to] = operands_.source(f);
      return turn(e_from, e_to, f_from, f_to, tally_);
    }
    const Rank angle = directions_.angle(e.rank, f.rank);
    return angle == 0 || angle == directions_.half_turn ? 0
           : angle < directions_.half_turn              ? 1
                                                        : -1;
  }

  // Are parallel edges opposite to each other?
  [[nodiscard]] bool are_opposite(const EdgeName& e, const EdgeName& f) const {
    const auto [e_from, e_to] = operands_.source(e);
    const auto [f_from, f_to] = operands_.source(f);
    return points_up(e_from, e_to) != points_up(f_from, f_to);
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

  [[nodiscard]] VertexSum end_of(const PairEdge& e) const {
    return e.kind == PairEdge::translated ? VertexSum{operands_.a.next(e.i), e.j}
                                          : VertexSum{e.i, operands_.b.next(e.j)};
  }

  [[nodiscard]] SumPoint point(const VertexSum& sum) const {
    return {operands_.a.vertices[sum.i], operands_.b.vertices[sum.j]};
  }

  // On which side of the line lies the sum of two vertices? Where it is an end of the edge, the
  // indices say so.
  int side_of_sum(const Line& line, const VertexSum& line_end, const VertexSum& sum) {
    if (sum == VertexSum{line.edge.i, line.edge.j} || sum == line_end) {
      ++tally_.filtered;
      return 0;
    }
    return side(line.at, point(sum), tally_);
  }
  int side_of_sum(const Line& line, const VertexSum& sum) {
    return side_of_sum(line, end_of(line.edge), sum);
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
    const int order = compare_along(f.at, operands_.end(f.edge), operands_.end(e.edge));
    const auto key = [](const Line& t) { return std::tuple(t.edge.kind, t.edge.i, t.edge.j); };
    return order > 0 || (order == 0 && key(e) < key(f));
  }

  // Of the two edges that start in lexmin(A) + lexmin(B), the more clockwise one.
  PairEdge first_edge(Index i, Index j) {
    if (const auto& cycle = superset_.cycle()) {
      number_ = cycle->first_from(i, j);
      return unranked(cycle->edge(number_));
    }
    const PairEdge translated = operands_.translated(i, j);
    const PairEdge corner = operands_.corner(i, j);
    const int turn = turn_between(translated, corner);
    if (turn == 0) {
      return preferred(line_of(translated), line_of(corner)) ? translated : corner;
    }
    return turn > 0 ? translated : corner;
  }

  // A point on the line in relative coordinates.
  [[nodiscard]] Point relative_on(const Line& s, double parameter) const {
    const Point origin = operands_.relative_start(s.edge);
    return {origin.x + parameter * s.at.dx, origin.y + parameter * s.at.dy};
  }

  // The place on s in relative coordinates, not beyond its exact position.
  [[nodiscard]] Point relative_position() const {
    return place_.is_sum ? operands_.relative(place_.sum.i, place_.sum.j)
                         : relative_on(line_, clamp_to_unit(place_.parameter.lo));
  }

  // How the boundary leaves s, beyond the place.
  void find_step() {
    if (superset_.cycle()) {
      find_step_in_cycle(*superset_.cycle());
      return;
    }
    const Point from = relative_position();
    if (!superset_.tree()) {
      find_step_by_pieces(from);
      return;
    }
    SupersetTree::Piece piece(*superset_.tree(), line_.at, from, end_);
    search(1, piece, [&](const auto& visit) { superset_.tree()->search(piece, visit); });
  }

  // The same where the superset is a cycle.
  void find_step_in_cycle(const ConvolutionCycle& cycle) {
    Index next = number_;
    const auto consider_number = [&](Index number) {
      if (consider_unranked(cycle.edge(number))) {
        next = number;
      }
    };
    for (const Index number : cycle.near(number_)) {
      consider_number(number);
    }
    if (const std::optional<Index> number = cycle.next(number_)) {
      consider_number(*number);
    }
    number_ = next;
  }

  // The same where the superset is implicit. The whole of s is searched where few steps fit into a
  // window; else its first piece is about as long as the last of such searches went, and each other
  // one four times as long as the one before. A piece that leaves the strip is cut there.
  void find_step_by_pieces(Point from) {
    strip_->pass(from);
    if (!strip_->is_gathered() && search_window(from, end_)) {
      strip_->fund().add_window();
      return;
    }
    const Point origin = operands_.relative_start(line_.edge);
    const double start = parameter_of(origin, from);
    const double size = std::max(std::abs(line_.at.dx), std::abs(line_.at.dy));
    double parameter = start;
    double stride = std::max(0x1p-4, stride_ / size);  // also where numbers have overflowed
    while (true) {
      const double limit = event_ ? clamp_to_unit(event_->place.parameter.hi) : 1;
      double next = parameter + stride < limit ? parameter + stride : limit;
      if (strip_->keep_up(from, met())) {
        const double room = strip_->room(from, line_.at.dx, line_.at.dy);
        if (room < next - parameter && room > (next - parameter) / 4) {
          next = parameter + room;
        }
      }
      const Point to = next < 1 ? relative_on(line_, next) : end_;
      search_piece(next, Piece(line_.at, origin, from, to, slack_));
      if (!(next < limit) || (event_ && event_->place.parameter.hi <= next)) {
        break;
      }
      from = relative_on(line_, next);
      parameter = next;
      stride *= 4;
    }
    const double way = (event_ ? clamp_to_unit(event_->place.parameter.hi) : 1) - start;
    stride_ = std::min(2 * way * size, 4 * stride_);
  }

  // Considers the edges that have a point in the piece of s, which ends in the parameter: by the
  // strip, where it holds the piece, by a window or in the whole superset.
  void search_piece(double parameter, Piece piece) {
    if (strip_->holds(piece.from()) && strip_->holds(piece.to())) {
      search(parameter, piece, [&](const auto& visit) { strip_->search(piece, visit); });
    } else if (!search_window(piece.from(), piece.to())) {
      const ImplicitSuperset& implicit = *superset_.implicit();
      search(parameter, piece, [&](const auto& visit) {
        std::int64_t visits = 0;
        const std::int64_t looks = implicit.search(
            piece,
            [&](Index i, Index j) {
              ++visits;
              implicit.for_each_edge(i, j, visit);
            },
            met());
        strip_->fund().add_search(looks + visits);
      });
    }
  }

  [[nodiscard]] PairsMet* met() { return met_ && met_->is_of_use() ? met_.get() : nullptr; }

  // Considers the edges that have a point in the piece of s, if a window holds them: that of the
  // last steps, or else a new one. False where it is too long for that.
  bool search_window(const Point& from, const Point& to) {
    const double length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    if (!local_->covers(from, to) &&
        !(length < local_->reach() && local_->gather(from, to, met()))) {
      return false;
    }
    local_->for_each_near(operands_.relative_start(line_.edge), line_.at.dx, line_.at.dy, from, to,
                          [&](const PairEdge& e) { consider(e); });
    return true;
  }

  // Considers the edges that have a point in the piece of s up to the parameter: in_superset(visit)
  // calls visit(edge) for them. The piece ends with the first event.
  template <class Piece, class InSuperset>
  void search(double parameter, Piece& piece, InSuperset in_superset) {
    in_superset([&](const PairEdge& e) {
      if (consider(e) && event_ && event_->place.parameter.hi < parameter) {
        piece.shorten(relative_on(line_, clamp_to_unit(event_->place.parameter.hi)));
      }
    });
  }

  // Does the boundary leave s along e, of all edges so far?
  bool consider(const PairEdge& e) {
    const Rank angle = directions_.angle(line_.edge.rank, e.rank);
    if (angle > directions_.half_turn) {
      return consider_event(e);
    }
    return angle < directions_.half_turn && can_lead_onwards(e) && consider_onwards(e);
  }

  // The same where the superset is a cycle.
  bool consider_unranked(const EdgeName& name) {
    const PairEdge e = unranked(name);
    const int turn = turn_between(line_.edge, e);
    if (turn < 0) {
      return consider_event(e);
    }
    return can_lead_onwards(e) && !(turn == 0 && are_opposite(line_.edge, e)) &&
           consider_onwards(e);
  }

  // May the edge, which does not turn right, be the one behind the end of s?
  [[nodiscard]] bool can_lead_onwards(const PairEdge& e) const {
    return !event_ && !(end_of(e) == end_sum_) && comes_near_end(e);
  }

  // The parameter on s of a point of s, about.
  [[nodiscard]] double parameter_of(const Point& origin, const Point& p) const {
    const SumEdge& s = line_.at;
    const bool by_x = std::abs(s.dx) >= std::abs(s.dy);
    return clamp_to_unit(by_x ? (p.x - origin.x) / s.dx : (p.y - origin.y) / s.dy);
  }

  // The first point on s, beyond the place, in which an edge leaves to the right (fact 3),
  // and the most clockwise of those that do: is it e?
  bool consider_event(const PairEdge& e) {
    ++walk_.candidates;
    if (side_of_sum(line_, end_sum_, end_of(e)) >= 0) {
      return false;
    }
    const VertexSum start{e.i, e.j};
    const int start_side = side_of_sum(line_, end_sum_, start);
    if (start_side < 0) {
      return false;
    }
    const Line t = line_of(e);
    Event event{t, {start_side == 0, start, e, crossing_parameter(line_.at, t.at)}};
    if (!is_ahead(event) || !precedes(event)) {
      return false;
    }
    event_ = event;
    return true;
  }

  // The most clockwise of the edges that pass through the end of s, or start there, and
  // go straight on or left (fact 4); of those in one direction, the one that reaches
  // furthest: is it e?
  bool consider_onwards(const PairEdge& e) {
    ++walk_.candidates;
    if (onwards_) {
      const int left = turn_between(*onwards_, e);
      if (left > 0 || (left == 0 && !preferred(line_of(e), line_of(*onwards_)))) {
        return false;
      }
    }
    if (!starts_in(e, end_sum_) && !passes_through(line_of(e), end_sum_)) {
      return false;
    }
    onwards_ = e;
    return true;
  }

  // Can the edge pass through the end of s?
  [[nodiscard]] bool comes_near_end(const PairEdge& e) const {
    const Box box = box_of(operands_.relative_start(e), operands_.relative_end(e));
    return !are_apart(widened(box, slack_), box_of(end_, end_));
  }

  // Is the event strictly beyond the place on s? An event edge t goes from left to right,
  // so a point p of s before the event lies on the right of t. The edge that crosses s in
  // the place goes from right to left: s leaves it to the right.
  bool is_ahead(const Event& event) {
    if (place_.is_sum) {
      return side_of_sum(event.line, place_.sum) < 0;
    }
    const Line r = line_of(place_.crossing);
    if (event.place.is_sum) {
      return side_of_sum(r, event.place.sum) < 0;
    }
    return compare_parameters(event.place.parameter, event.line, place_.parameter, r) > 0;
  }

  int compare_parameters(const Interval& pt, const Line& t, const Interval& pr, const Line& r) {
    if (pt.hi < pr.lo || pt.lo > pr.hi) {
      ++tally_.filtered;
      return pt.hi < pr.lo ? -1 : 1;
    }
    return compare_crossings(line_.at, t.at, r.at, tally_);
  }

  // Does the event come before the best one so far, or, in the same point, is it more
  // clockwise or longer? Without a best one: does it come before the end of s, or there?
  // In a tie the event takes a place that is known as a sum of two vertices.
  bool precedes(Event& event) {
    if (!event_) {
      const int order = side_of_sum(event.line, end_sum_);
      if (order == 0 && !event.place.is_sum) {
        take_sum(event.place, end_sum_);
      }
      return order >= 0;
    }
    const int order = compare_to_best(event);
    if (order != 0) {
      return order < 0;
    }
    if (event.place.is_sum) {
      take_sum(event_->place, event.place.sum);
    } else if (event_->place.is_sum) {
      take_sum(event.place, event_->place.sum);
    }
    const int right = turn_between(event.line.edge, event_->line.edge);
    return right > 0 || (right == 0 && preferred(event.line, event_->line));
  }

  static void take_sum(Place& place, const VertexSum& sum) {
    place.is_sum = true;
    place.sum = sum;
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

  [[nodiscard]] static bool starts_in(const PairEdge& e, const VertexSum& sum) {
    return sum == VertexSum{e.i, e.j};
  }

  // Does t hold the sum of two vertices, its end excepted?
  bool passes_through(const Line& t, const VertexSum& sum) {
    const SumPoint q = point(sum);
    return side_of_sum(t, sum) == 0 && compare_along(t.at, t.at.origin, q) >= 0 &&
           compare_along(t.at, q, operands_.end(t.edge)) > 0;
  }

  const Operands& operands_;
  const Directions& directions_;
  const Superset& superset_;
  double slack_;
  std::unique_ptr<PairsMet> met_;                            // where chains are repeated
  std::optional<LocalSuperset> local_;                       // where the superset is implicit
  std::optional<Strip> strip_;                               // likewise
  double stride_ = std::numeric_limits<double>::infinity();  // twice the last steps
  Task& task_;
  Tally tally_;
  Walk walk_;

  // The edge that the walk is on, s, and the place that it has come to.
  Line line_;
  Index number_ = 0;  // of s, where the superset is a cycle
  Place place_;
  VertexSum end_sum_;  // the end of s
  Point end_;          // the same in relative coordinates
  // How the walk goes on, of the edges so far: at the first event, else at the end of s.
  std::optional<Event> event_;
  std::optional<PairEdge> onwards_;
};

// The ring of the arcs.
Walk join(std::vector<Arc> arcs, Tally& tally) {
  const EdgeName* arriving = &arcs.back().last;
  std::size_t size = 0;
  for (Arc& arc : arcs) {
    arc.walk.vertices.front().arrive_by(*arriving);
    arriving = &arc.last;
    size += arc.walk.vertices.size();
    tally += arc.tally;
  }
  Walk walk = std::move(arcs.front().walk);
  walk.vertices.reserve(size);
  for (std::size_t k = 1; k < arcs.size(); ++k) {
    const Walk& part = arcs[k].walk;
    walk.vertices.insert(walk.vertices.end(), part.vertices.begin(), part.vertices.end());
    walk.steps += part.steps;
    walk.candidates += part.candidates;
  }
  return walk;
}

}  // namespace

Walk walk_outer_face(const Polygon& a, const Polygon& b, Task& task, Tally& tally) {
  if (a.is_convex && b.is_convex) {
    return merge_convex(a, b, tally);
  }
  std::optional<ConvolutionCycle> cycle = ConvolutionCycle::find({a, b, {}}, tally);
  const Operands operands{a, b, cycle ? Directions{} : merge_directions(a, b, tally)};
  const Superset superset(operands, std::move(cycle));
  const double slack = slack_of(operands);
  const std::vector<HullVertex> starts = hull_vertices(a, b, task.threads());
  std::vector<Arc> arcs(starts.size());
  const auto walk_arc = [&](std::size_t k) {
    arcs[k] = Walker(superset, slack, task).run(starts[k], starts[(k + 1) % starts.size()]);
  };
  for_each_in_parallel(arcs.size(), task.threads(), walk_arc, [&] { task.watch(); });
  Walk walk = join(std::move(arcs), tally);
  walk.chains_are_repeated = superset.implicit() && superset.implicit()->has_repeated_chains();
  return walk;
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "chord_tree.hpp"
#include "contributing_vertices.hpp"
#include "convex_sums.hpp"
#include "covered_cells.hpp"
#include "edges_below.hpp"
#include "equal_chains.hpp"
#include "sectors.hpp"
#include "turned_boxes.hpp"
#include "witness.hpp"

namespace gcv {

// Searches both polygons' trees for witnesses of a superset edge, and for the pairs of edges near a
// place on it. Goes along the edge, from its start. What is ahead waits until it is reached: the
// sums of pairs of nodes, and witnesses that were met early.
class WitnessSearch {
 public:
  explicit WitnessSearch(const Operands& operands);

  // Sets out along a line, from its start. Without sums of convex pieces, a pair of edges near the
  // place that is reached covers it, as a rule.
  void begin(const RelativeLine& line, bool with_sums = true);
  // Does it reach places by sums of convex pieces?
  [[nodiscard]] bool uses_sums() const { return uses_sums_; }

  // How far from t on the line lies in the open sum: a parameter up to 1, itself in the open sum.
  // t itself if no witness holds it, or none much more; or where there are many pairs of edges near
  // it and none is found soon. Goes no further once it is beyond `until`. t never goes back.
  double reach(double t, double until = 1);

  struct Pair {
    Index i;
    Index j;
  };
  // Sets out to all pairs of edges, one of each polygon, whose sums may hold a point of the line
  // with a parameter from `from` to `to`. These never go back. Of pairs with equal sums, their
  // solid sides and the edges before them the same, too, some are left out, but not the first.
  void approach(double from, double to);
  // The same up to a later parameter, without those pairs that were given.
  void approach_further(double to);
  // Of these pairs, first searches for those in the last witness: the parallelogram that the line
  // leaves where that ends is one of them, as a rule.
  void prefer_last_witness();
  // The next of these pairs, which is searched for when it is asked for: if wanted, and most chains
  // have equal ones, where the line is long near nodes first.
  std::optional<Pair> next_pair(bool longest_first = false);
  // The next one that was found without that, if there is one.
  std::optional<Pair> next_found_pair();
  // Begins with a line, and finds all such pairs. Leaves out none.
  std::vector<Pair> all_pairs_near(const RelativeLine& line, double from, double to);

  // Calls visit(edge) for the superset edges in focus, before merging, whose direction is in the
  // half-plane that begins with a rank: from that on counter-clockwise, without the opposite rank.
  // Passes over those that lie in witnesses that were found until then, and over some, but not
  // the first, of those that coincide and have the same solid sides. Calls pass(pairs) after
  // each step with the number of pairs of edges that it is done with; in all, that is all of them.
  template <class Visit, class Pass>
  void for_each_uncovered_edge(Rank first, Visit visit, Pass pass);

  // Do covered cells hold a box in relative coordinates, or does the last witness, or one of the
  // sums of convex pieces?
  [[nodiscard]] bool covers(const Box& box) {
    return (!recent_.empty() && last().holds(box)) || cells_.hold(box) || sums_.hold(box);
  }

  [[nodiscard]] double slack() const { return slack_; }
  // How many nodes were expanded on the way along lines.
  [[nodiscard]] std::uint64_t visits() const { return visits_; }

 private:
  struct Nodes {
    ChordTree::Node a;
    ChordTree::Node b;
  };
  static constexpr Nodes roots{ChordTree::root, ChordTree::root};

  // The parameters of a line from one to another.
  struct Range {
    double from;
    double to;
  };

  // The children of the larger node, beside the other one.
  struct Family {
    const ChordTree::Block& children;
    std::uint32_t number;  // of the block
    const ChordTree::Block& of_other;
    ChordTree::Node other;
    bool is_of_a;

    [[nodiscard]] Nodes nodes(std::uint32_t lane) const {
      const ChordTree::Node child = ChordTree::node(number, lane);
      return is_of_a ? Nodes{child, other} : Nodes{other, child};
    }
  };
  [[nodiscard]] Family family(const Nodes& nodes) const;

  // Where the line is near the sums of the children with the other node, and what these cover of
  // it.
  struct Ranges {
    double near_from[ChordTree::width];
    double near_to[ChordTree::width];
    double covered_from[ChordTree::width];
    double covered_to[ChordTree::width];
  };
  [[nodiscard]] Ranges ranges(const Family& family) const;

  // Nodes near a part of the line.
  struct Waiting {
    Range near;
    Nodes nodes;
    [[nodiscard]] double first() const { return near.from; }
  };
  // What a witness covers.
  struct Cover {
    Range covered;
    Nodes nodes;
    [[nodiscard]] double first() const { return covered.from; }
  };
  struct NearPair {
    Range near;
    Pair pair;
  };
  // Puts the children of nodes that come near the line from `from` on where they belong: in the
  // queue, if this is before `to`.
  void expand(const Nodes& nodes, double from, double to);
  // The same for nodes in the queue.
  void expand_first(double from, double to) { expand_if_near(queue_[next_++], from, to); }
  void expand_last(double from, double to) {
    const Waiting last = queue_.back();
    queue_.pop_back();
    expand_if_near(last, from, to);
  }
  void expand_if_near(Waiting waiting, double from, double to) {
    if (!(waiting.near.to < from)) {
      expand(waiting.nodes, from, to);
    }
  }
  // Of the last of these, puts the one that is near the line for longest in the last place.
  void put_longest_last();
  // Moves the nodes that come near the line before that to the queue.
  void activate(double to);

  [[nodiscard]] bool are_edges(const Nodes& nodes) const {
    return a_.is_edge(nodes.a) && b_.is_edge(nodes.b);
  }
  [[nodiscard]] Witness witness(const Nodes& nodes) const {
    return {Chord::of(a_, nodes.a), Chord::of(b_, nodes.b), slack_};
  }

  // How far the witnesses that were met reach from t; t if none reaches `least`.
  double met_reach(double t, double least);
  const Operands& operands_;
  const ChordTree& a_;
  const ChordTree& b_;
  double slack_;
  TurnedBoxes turned_;

  RelativeLine line_{};
  Point turned_origin_{};  // of the line
  Point turned_way_{};
  std::vector<Waiting> queue_;    // what is near the place on the line that was reached
  std::size_t next_ = 0;          // in the queue
  std::vector<Waiting> waiting_;  // a heap: the one that comes near first is in front
  std::vector<Cover> covers_;     // likewise
  std::vector<NearPair> near_pairs_;
  std::size_t met_on_borders_ = 0;  // pairs of edges near the place that do not cover it
  Range approached_{};              // a part of the line
  std::size_t next_near_ = 0;       // of the near pairs

  [[nodiscard]] static EqualNodes equal_nodes(const Operands& operands);
  // Has an equal pair been met? From now on it has.
  [[nodiscard]] bool meet_again(const Nodes& nodes, VisitedPairs& visited) const;
  EqualNodes equal_;
  std::optional<VisitedPairs> met_;  // on the line, where many are equal
  bool leaves_out_ = true;

  std::uint64_t visits_ = 0;

  // Was the witness of the nodes added to the cells a short time ago? Lines side by side end in the
  // same ones: where edges are long, half of the time went into that.
  bool was_added(const Nodes& nodes);
  static constexpr std::uint32_t kept_additions = 1U << 12;

  CoveredCells cells_;
  std::vector<Nodes> added_;  // by their hashes
  ConvexSums sums_;
  bool uses_sums_ = false;
  // The last witnesses that were found: those of lines side by side are often the same. Without
  // them, regions of coasts take 1.1 to 1.25 times as long.
  void keep(const Witness& witness);
  // How far they reach from t; t if none reaches `least`.
  [[nodiscard]] double recent_reach(double t, double least) const;
  static constexpr std::size_t most_recent = 4;
  std::vector<Witness> recent_;
  std::size_t kept_ = 0;  // of all, up to now
  [[nodiscard]] const Witness& last() const { return recent_[(kept_ - 1) % most_recent]; }
  Nodes last_nodes_{};  // of that
};

template <class Visit, class Pass>
void WitnessSearch::for_each_uncovered_edge(Rank first, Visit visit, Pass pass) {
  const Directions& directions = operands_.directions;
  const Rank half = directions.half_turn;
  const Sectors wanted = sectors_of(directions, first, (first + half - 1) % (2 * half));
  const auto below_a = all_edges_below(a_, operands_.a, directions.rank_a, directions);
  const auto below_b = all_edges_below(b_, operands_.b, directions.rank_b, directions);
  const auto visit_edge = [&](const PairEdge& edge, bool contributes) {
    if (contributes && directions.angle(first, edge.rank) < half) {
      visit(edge);
    }
  };
  std::optional<VisitedPairs> visited;
  if (equal_.prevail) {
    visited.emplace();
  }
  std::vector<Nodes> stack{roots};
  while (!stack.empty()) {
    const Nodes nodes = stack.back();
    stack.pop_back();
    const EdgesBelow& a = below_a[nodes.a];
    const EdgesBelow& b = below_b[nodes.b];
    const Box box = sum_of(a_.box(nodes.a), b_.box(nodes.b));
    if (have_superset_edges(a, b, wanted) && !operands_.is_out_of_focus(box) && !covers(box) &&
        !(visited && meet_again(nodes, *visited))) {
      if (!are_edges(nodes)) {
        const Family children = family(nodes);
        for (std::uint32_t lane = ChordTree::width; lane-- > 0;) {
          if ((children.children.lanes >> lane & 1U) != 0) {
            stack.push_back(children.nodes(lane));
          }
        }
        pass(std::uint64_t{0});
        continue;
      }
      const Index i = a_.below(nodes.a);
      const Index j = b_.below(nodes.b);
      const PairEdge translated = operands_.translated(i, j);
      const PairEdge corner = operands_.corner(i, j);
      visit_edge(translated, operands_.b_contributes(j, translated.rank));
      visit_edge(corner, operands_.a_contributes(i, corner.rank));
    }
    pass(std::uint64_t{a.size} * b.size);
  }
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The one way to search the superset: which superset edges have a point in common with a stretch
// of the line of an edge, the near ones first? choose.cpp says how it is done for which operands.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "ahead_cache.hpp"
#include "choose.hpp"
#include "contributing_vertices.hpp"
#include "line.hpp"
#include "piece.hpp"
#include "place_cache.hpp"
#include "stretch.hpp"
#include "table.hpp"
#include "tree_product.hpp"

namespace gcv {

// The search of one walk: the superset, and what was found near the places that the walk has
// passed.
class Search {
 public:
  explicit Search(const SearchableSuperset& superset);

  // The sign of the turn from e to f, 1 to the left; 0 for opposite ones too.
  int turn(const PairEdge& e, const PairEdge& f, Tally& /*tally*/) const {
    const Directions& directions = operands_.directions;
    const Rank angle = directions.angle(e.rank, f.rank);
    return angle == 0 || angle == directions.half_turn ? 0 : angle < directions.half_turn ? 1 : -1;
  }
  [[nodiscard]] Way way(const PairEdge& s, const PairEdge& e, Tally& /*tally*/) const {
    const Directions& directions = operands_.directions;
    const Rank angle = directions.angle(s.rank, e.rank);
    return angle > directions.half_turn   ? Way::right
           : angle < directions.half_turn ? Way::onwards
                                          : Way::back;
  }

  // The two that start in a vertex of the hull of the sum.
  [[nodiscard]] std::pair<PairEdge, PairEdge> edges_from(Index i, Index j) const {
    return {operands_.translated(i, j), operands_.corner(i, j)};
  }

  void follow(const PairEdge& /*edge*/) {}

  // Nothing is known without a search.
  struct Successor {
    const EdgeName& edge;
    bool is_straight;
  };
  static std::optional<Successor> only_way_on() { return std::nullopt; }

  // Other edges of the direction of s may lead on without a gap, from a place on s where the walk
  // goes straight on.
  struct Continuation {
    VertexSum end;
    double length;  // its parameter on s
  };
  // Where to. Nothing where the edges are too few to ask.
  std::optional<Continuation> continued(const PairEdge& s, const VertexSum& place);

  // Calls step.consider(edge) for superset edges, among them all that have a point in common with
  // the stretch of the step, as far as step.limit(), which falls where these calls return true.
  template <class Step>
  void find(Step& step) {
    const Stretch stretch = step.stretch();
    const std::uint64_t before = step.candidates();
    if (is_continued_) {
      find_along_line(stretch, step);
    } else if (superset_.table()) {
      SupersetTable::Piece piece(*superset_.table(), stretch.s, stretch.from, stretch.to);
      search(stretch, stretch.length, piece, step,
             [&](const auto& visit) { superset_.table()->search(piece, visit); });
    } else {
      find_by_pieces(stretch, step);
    }
    last_candidates_ = step.candidates() - before;
  }

 private:
  // The whole stretch is searched where few steps fit into the place cache. Else its first piece is
  // about as long as the last of such searches went, and each other one four times as long as the
  // one before. A piece that leaves the cache ahead is cut there.
  template <class Step>
  void find_by_pieces(const Stretch& stretch, Step& step) {
    Point from = stretch.from;
    ahead_->pass(from);
    if (!ahead_->is_filled() && search_near(stretch, from, stretch.to, step)) {
      ahead_->budget().add_near();
      return;
    }
    const double start = stretch.parameter_of(from);
    const double size = std::max(std::abs(stretch.s.dx), std::abs(stretch.s.dy));
    double parameter = start;
    double stride = std::max(0x1p-4, stride_ / size);  // also where numbers have overflowed
    while (true) {
      const double limit = step.limit();
      double next = parameter + stride < limit ? parameter + stride : limit;
      if (ahead_->keep_up(from, visited())) {
        const double edge = parameter + ahead_->room(from, stretch.s.dx, stretch.s.dy);
        if (edge < next && edge - parameter > (next - parameter) / 4) {
          next = edge;
        }
      }
      search_piece(stretch, next,
                   Piece(stretch.s, stretch.origin, from, stretch.at(next), superset_.slack()),
                   step);
      if (!(next < limit) || step.limit() <= next) {
        break;
      }
      from = stretch.at(next);
      parameter = next;
      stride *= 4;
    }
    stride_ = std::min(2 * (step.limit() - start) * size, 4 * stride_);
  }

  // First the edges that leave the line to the right; where there are none, those at its end.
  template <class Step>
  void find_along_line(const Stretch& stretch, Step& step) {
    is_continued_ = false;
    const TreeProduct& product = *superset_.product();
    const auto search_in = [&](auto place) {
      search(stretch, stretch.length, place, step, [&](const auto& visit) {
        product.search(
            place, [&](Index i, Index j) { product.for_each_edge(i, j, visit); }, visited());
      });
    };
    const double slack = superset_.slack();
    search_in(LineSearch::Place(*line_,
                                Piece(stretch.s, stretch.origin, stretch.from, stretch.to, slack)));
    if (!step.event()) {
      search_in(Piece(stretch.s, stretch.origin, stretch.to, stretch.to, slack));
    }
  }

  // Visits the edges that have a point in the piece of the stretch, which ends in the parameter: by
  // the cache ahead, where it holds the piece, by the place cache or in the whole superset.
  template <class Step>
  void search_piece(const Stretch& stretch, double parameter, Piece piece, Step& step) {
    if (ahead_->holds(piece.from()) && ahead_->holds(piece.to())) {
      search(stretch, parameter, piece, step,
             [&](const auto& visit) { ahead_->search(piece, visit); });
    } else if (!search_near(stretch, piece.from(), piece.to(), step)) {
      const TreeProduct& product = *superset_.product();
      search(stretch, parameter, piece, step, [&](const auto& visit) {
        std::int64_t pair_visits = 0;
        const std::int64_t node_visits = product.search(
            piece,
            [&](Index i, Index j) {
              ++pair_visits;
              product.for_each_edge(i, j, visit);
            },
            visited());
        ahead_->budget().add_search(node_visits + pair_visits);
      });
    }
  }

  [[nodiscard]] VisitedPairs* visited() {
    return visited_ && visited_->is_of_use(limits::chains_a_repeated_one) ? visited_.get()
                                                                          : nullptr;
  }

  // Visits the edges that have a point in the piece of the stretch, if the place cache holds them,
  // or can. False where the piece is too long for that.
  template <class Step>
  bool search_near(const Stretch& stretch, const Point& from, const Point& to, Step& step) {
    const double length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    if (!near_->covers(from, to) &&
        !(length < near_->reach() && near_->gather(from, to, visited()))) {
      return false;
    }
    near_->for_each_near(stretch.origin, stretch.s.dx, stretch.s.dy, from, to,
                         [&](const PairEdge& e) { step.consider(e); });
    return true;
  }

  // in_superset(visit) calls visit(edge) for the edges that have a point in the piece of the
  // stretch up to the parameter. The piece is shortened to what still matters.
  template <class Place, class Step, class InSuperset>
  static void search(const Stretch& stretch, double parameter, Place& piece, Step& step,
                     InSuperset in_superset) {
    in_superset([&](const PairEdge& e) {
      if (step.consider(e) && step.limit() < parameter) {
        piece.shorten(stretch.at(step.limit()));
      }
    });
  }

  const SearchableSuperset& superset_;
  const Operands& operands_;
  std::unique_ptr<VisitedPairs> visited_;  // where chains are equal
  std::optional<PlaceCache> near_;         // without a table
  std::optional<AheadCache> ahead_;        // likewise
  double stride_ = infinity;               // twice the last steps
  std::optional<LineSearch> line_;         // where the walk went straight on past many edges
  std::uint64_t straight_cost_ = 0;        // of what the walk has met while it did
  std::uint64_t last_candidates_ = 0;      // of the last step
  bool is_continued_ = false;              // the next step goes along the line
};

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convex_pieces.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "cycle.hpp"
#include "error.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// To cut larger rings takes longer than pieces save.
constexpr std::size_t most_ring_vertices = 32;
// Smaller ones cover little that these do not.
constexpr std::size_t most_pieces = 4;

using Piece = std::vector<Index>;

// Cuts ears off, those with the shortest diagonals first, until the rest is convex. Then takes
// diagonals away again where what is on both sides of them is convex together, the last one first:
// Hertel and Mehlhorn, 1983.
class Cutting {
 public:
  explicit Cutting(std::span<const Point> ring) : ring_(ring), rest_(ring.size()) {
    std::iota(rest_.begin(), rest_.end(), Index{0});
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      turns_.push_back(turn_at(rest_, k));
    }
  }

  std::vector<Piece> pieces() {
    while (std::any_of(turns_.begin(), turns_.end(), [](int turn) { return turn < 0; })) {
      cut_ear();
    }
    pieces_.push_back(std::move(rest_));
    for (; !diagonals_.empty(); diagonals_.pop_back()) {
      take_away(diagonals_.back());
    }
    return std::move(pieces_);
  }

 private:
  struct Diagonal {
    Index from;
    Index to;
  };

  int turn(Index p, Index q, Index r) { return orientation(ring_[p], ring_[q], ring_[r], tally_); }
  int turn_at(const Piece& piece, std::size_t k) {
    return turn(piece[cyclic_previous(k, piece.size())], piece[k],
                piece[cyclic_next(k, piece.size())]);
  }
  // That an ear at the vertex k of the rest leaves.
  [[nodiscard]] Diagonal diagonal(std::size_t k) const {
    return {rest_[cyclic_previous(k, rest_.size())], rest_[cyclic_next(k, rest_.size())]};
  }

  // If vertices of the rest are in the triangle, one of them is not convex.
  bool is_ear(std::size_t k) {
    const auto [p, r] = diagonal(k);
    const Index q = rest_[k];
    for (std::size_t other = 0; other < rest_.size(); ++other) {
      const Index v = rest_[other];
      if (turns_[other] <= 0 && v != p && v != r && turn(p, q, v) >= 0 && turn(q, r, v) >= 0 &&
          turn(r, p, v) >= 0) {
        return false;
      }
    }
    return true;
  }

  void cut_ear() {
    std::size_t ear = rest_.size();
    double least = 0;
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      const auto [from, to] = diagonal(k);
      const double x = ring_[to].x - ring_[from].x;
      const double y = ring_[to].y - ring_[from].y;
      const double squared = x * x + y * y;
      if (turns_[k] > 0 && (ear == rest_.size() || squared < least) && is_ear(k)) {
        ear = k;
        least = squared;
      }
    }
    if (ear == rest_.size()) {
      throw Error(Status::internal, "a ring that is not convex has no ear");
    }
    const Diagonal cut = diagonal(ear);
    pieces_.push_back({cut.from, rest_[ear], cut.to});
    diagonals_.push_back(cut);
    rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
    turns_.erase(turns_.begin() + static_cast<std::ptrdiff_t>(ear));
    for (const std::size_t k : {cyclic_previous(ear, rest_.size()), ear % rest_.size()}) {
      turns_[k] = turn_at(rest_, k);
    }
  }

  // The piece on the left of a diagonal: turned round, so that the diagonal leads from its last
  // vertex to its first one.
  std::size_t piece_along(const Diagonal& diagonal) {
    const auto [from, to] = diagonal;
    for (std::size_t n = 0;; ++n) {
      Piece& piece = pieces_[n];
      const auto first = std::find(piece.begin(), piece.end(), to);
      if (first != piece.end() && (first == piece.begin() ? piece.back() : *(first - 1)) == from) {
        std::rotate(piece.begin(), first, piece.end());
        return n;
      }
    }
  }

  void take_away(const Diagonal& diagonal) {
    const std::size_t left = piece_along(diagonal);
    const std::size_t right = piece_along({diagonal.to, diagonal.from});
    Piece both = pieces_[left];
    both.insert(both.end(), pieces_[right].begin() + 1, pieces_[right].end() - 1);
    if (turn_at(both, 0) >= 0 && turn_at(both, pieces_[left].size() - 1) >= 0) {
      pieces_[left] = std::move(both);
      pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(right));
    }
  }

  std::span<const Point> ring_;
  Piece rest_;
  std::vector<int> turns_;  // at the vertices of the rest
  std::vector<Piece> pieces_;
  std::vector<Diagonal> diagonals_;
  Tally tally_;
};

double area_of(std::span<const Point> ring, const Piece& piece) {
  const Point& o = ring[piece.front()];
  double twice = 0;
  for (std::size_t k = 2; k < piece.size(); ++k) {
    const Point& p = ring[piece[k - 1]];
    const Point& q = ring[piece[k]];
    twice += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return twice / 2;
}

}  // namespace

void ConvexPieces::add(std::span<const Index> piece) {
  vertices.insert(vertices.end(), piece.begin(), piece.end());
  ends.push_back(vertices.size());
}

void ConvexPieces::add(const ConvexPieces& other, Index first) {
  const std::size_t before = vertices.size();
  std::transform(other.vertices.begin(), other.vertices.end(), std::back_inserter(vertices),
                 [&](Index vertex) { return first + vertex; });
  std::transform(other.ends.begin(), other.ends.end(), std::back_inserter(ends),
                 [&](std::size_t end) { return before + end; });
}

ConvexPieces find_convex_pieces(std::span<const Point> ring) {
  ConvexPieces result;
  if (ring.size() > most_ring_vertices) {
    return result;
  }
  const std::vector<Piece> pieces = Cutting(ring).pieces();
  std::vector<std::pair<double, std::size_t>> by_area;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    by_area.emplace_back(-area_of(ring, pieces[k]), k);
  }
  std::sort(by_area.begin(), by_area.end());
  for (std::size_t k = 0; k < std::min(most_pieces, by_area.size()); ++k) {
    result.add(pieces[by_area[k].second]);
  }
  return result;
}

}  // namespace gcv

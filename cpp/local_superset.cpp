// SPDX-License-Identifier: LGPL-3.0-or-later
#include "local_superset.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcv {

namespace {

constexpr std::size_t few = 16;
constexpr std::size_t many = 48;
constexpr std::size_t too_many = 192;

// Blocks that a search may look at before it gives up.
constexpr std::int64_t most_looks = 600;

// How far the band goes to the left of the walk, beside how far it goes along.
constexpr double depth = 0.25;

}  // namespace

// A window without what lies left of a line, as a place to search. The bounds of the errors
// are those of piece.hpp.
class LocalSuperset::Band {
 public:
  Band(const Box& box, double dx, double dy, double leftmost)
      : box_(box), dx_(dx), dy_(dy), length_(length_bound(dx, dy)), leftmost_(leftmost) {}

  [[nodiscard]] ImplicitSuperset::Offsets offsets(const Box& box) const {
    return ImplicitSuperset::offsets(box, dx_, dy_);
  }

  void look(const ImplicitSuperset::Block& block, const ImplicitSuperset::Node& other,
            ImplicitSuperset::Look& look) const {
    const CapsuleBlock& capsules = block.capsules;
    const DoubleLanes from =
        dx_ * DoubleLanes::load(capsules.y0) - dy_ * DoubleLanes::load(capsules.x0);
    const DoubleLanes to =
        dx_ * DoubleLanes::load(capsules.y1) - dy_ * DoubleLanes::load(capsules.x1);
    const DoubleLanes lowest = smaller(from, to) - length_ * DoubleLanes::load(capsules.radius);
    lowest.store(look.lowest);
    lowest.store(look.highest);  // which no band asks for
    const DoubleMask beyond = block.boxes.apart({box_.x0 - other.box.x1, box_.y0 - other.box.y1,
                                                 box_.x1 - other.box.x0, box_.y1 - other.box.y0});
    look.lanes = ~(beyond | (lowest > leftmost_ - other.offsets.lowest)).bits() & DoubleLanes::all;
  }

 private:
  Box box_;
  double dx_;
  double dy_;
  double length_;
  double leftmost_;
};

LocalSuperset::LocalSuperset(const ImplicitSuperset& superset, double slack)
    : superset_(superset),
      slack_(slack),
      reach_(4 * superset.mean_edge_size()),
      window_(empty_box) {}

void LocalSuperset::clear() {
  edges_.clear();
  boxes_.clear();
  window_ = empty_box;
}

void LocalSuperset::add(const PairEdge& edge, const Box& wide) {
  const Operands& operands = superset_.operands();
  const Point p = operands.relative_start(edge);
  const Point q = operands.relative_end(edge);
  const Box box = box_of(p, q);
  if (are_apart(box, wide)) {
    return;
  }
  const auto lane = static_cast<std::uint32_t>(edges_.size() % width);
  if (lane == 0) {
    boxes_.emplace_back();
    for (std::uint32_t k = 0; k < width; ++k) {
      boxes_.back().put(k, empty_box);
    }
  }
  boxes_.back().put(lane, box);
  edges_.push_back({edge, p, q});
}

bool LocalSuperset::gather(const Point& from, const Point& to, PairsMet* met) {
  clear();
  dx_ = to.x - from.x;
  dy_ = to.y - from.y;
  const double size = std::max(std::abs(dx_), std::abs(dy_));
  if (!(size > 0)) {
    return false;
  }
  const double ahead = 0.5 * reach_;
  const Point centre{from.x + ahead * (dx_ / size), from.y + ahead * (dy_ / size)};
  const Box window{centre.x - reach_, centre.y - reach_, centre.x + reach_, centre.y + reach_};
  leftmost_ = dx_ * from.y - dy_ * from.x + depth * reach_ * length_bound(dx_, dy_) +
              std::numeric_limits<double>::min();
  const Box wide = widened(window, slack_);
  Band band(wide, dx_, dy_, leftmost_ + offset_tolerance(dx_, dy_, slack_));
  const std::int64_t looks = superset_.search(
      band,
      [&](Index i, Index j) {
        if (edges_.size() <= too_many) {
          superset_.for_each_edge(i, j, [&](const PairEdge& edge) { add(edge, wide); });
        }
      },
      met, most_looks);
  if (edges_.size() > too_many || looks > most_looks) {
    clear();
    reach_ *= 0.25;
    return false;
  }
  window_ = window;
  if (!covers(from, to)) {  // numbers have overflowed
    clear();
    return false;
  }
  if (edges_.size() > many) {
    reach_ *= 0.7;
  } else if (edges_.size() < few) {
    reach_ *= 1.4;
  }
  return true;
}

}  // namespace gcv

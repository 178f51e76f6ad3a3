// SPDX-License-Identifier: LGPL-3.0-or-later
#include "place_cache.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vector.hpp"

namespace gcv {

namespace {

constexpr std::size_t few = 16;
constexpr std::size_t many = 48;
constexpr std::size_t too_many = 192;

// Nodes that a search may visit before it gives up.
constexpr std::int64_t most_visits = 600;

// How far the band goes to the left of the walk, beside how far it goes along.
constexpr double place_depth = 0.25;

}  // namespace

// A box without what lies left of a line, for a search in the trees. The bounds of the errors
// are those of piece.hpp.
class PlaceCache::Band {
 public:
  Band(const Box& box, double dx, double dy, double leftmost)
      : box_(box), dx_(dx), dy_(dy), length_(length_bound(dx, dy)), leftmost_(leftmost) {}

  [[nodiscard]] TreeProduct::Offsets offsets(const Box& box) const {
    return TreeProduct::offsets(box, dx_, dy_);
  }

  void cull(const TreeProduct::Block& block, const TreeProduct::Node& other,
            TreeProduct::Survivors& survivors) const {
    const SweptSphereBlock& spheres = block.spheres;
    const SimdDouble from = dx_ * SimdDouble::load(spheres.y0) - dy_ * SimdDouble::load(spheres.x0);
    const SimdDouble to = dx_ * SimdDouble::load(spheres.y1) - dy_ * SimdDouble::load(spheres.x1);
    const SimdDouble lowest = smaller(from, to) - length_ * SimdDouble::load(spheres.radius);
    lowest.store(survivors.lowest);
    lowest.store(survivors.highest);  // which no band asks for
    const DoubleMask beyond = block.boxes.apart({box_.x0 - other.box.x1, box_.y0 - other.box.y1,
                                                 box_.x1 - other.box.x0, box_.y1 - other.box.y0});
    survivors.lanes =
        ~(beyond | (lowest > leftmost_ - other.offsets.lowest)).bits() & SimdDouble::all;
  }

 private:
  Box box_;
  double dx_;
  double dy_;
  double length_;
  double leftmost_;
};

PlaceCache::PlaceCache(const TreeProduct& superset, double slack)
    : superset_(superset),
      slack_(slack),
      reach_(4 * superset.mean_edge_size()),
      bounds_(empty_box) {}

void PlaceCache::clear() {
  edges_.clear();
  boxes_.clear();
  bounds_ = empty_box;
}

void PlaceCache::add(const PairEdge& edge, const Box& wide) {
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

bool PlaceCache::gather(const Point& from, const Point& to, VisitedPairs* met) {
  clear();
  dx_ = to.x - from.x;
  dy_ = to.y - from.y;
  const double size = std::max(std::abs(dx_), std::abs(dy_));
  if (!(size > 0)) {
    return false;
  }
  const double ahead = 0.5 * reach_;
  const Point centre{from.x + ahead * (dx_ / size), from.y + ahead * (dy_ / size)};
  const Box bounds{centre.x - reach_, centre.y - reach_, centre.x + reach_, centre.y + reach_};
  leftmost_ = dx_ * from.y - dy_ * from.x + place_depth * reach_ * length_bound(dx_, dy_) +
              std::numeric_limits<double>::min();
  const Box wide = widened(bounds, slack_);
  Band band(wide, dx_, dy_, leftmost_ + offset_tolerance(dx_, dy_, slack_));
  const std::int64_t node_visits = superset_.search(
      band,
      [&](Index i, Index j) {
        if (edges_.size() <= too_many) {
          superset_.for_each_edge(i, j, [&](const PairEdge& edge) { add(edge, wide); });
        }
      },
      met, most_visits);
  if (edges_.size() > too_many || node_visits > most_visits) {
    clear();
    reach_ *= 0.25;
    return false;
  }
  bounds_ = bounds;
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

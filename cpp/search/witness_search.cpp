// SPDX-License-Identifier: LGPL-3.0-or-later
#include "witness_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "box.hpp"
#include "limits.hpp"
#include "tree_product.hpp"

namespace gcv {

namespace {

// The least progress along a line that a witness is taken for.
constexpr double least_progress = 0x1p-20;

// A witness is looked for in so many nodes in their order first: they are large, and their
// witnesses reach far. After these, one small one is looked for, depth first. Else it would take
// all pairs of teeth that are near a place between two combs.
constexpr std::size_t largest_nodes = 8;
// Of so many of the last nodes the one that is near the line for longest comes first.
constexpr std::size_t last_nodes = 4;
// A search ends that meets more pairs of edges than that and no witness, or takes more nodes. It
// ends sooner where more pairs are near the place and do not cover it than the four of the vertices
// that make it: it lies on the borders of many parallelograms, and their contacts tell sooner. At
// the very end of a line only the large nodes are searched: it ends on the border of the sum, as a
// rule.
constexpr std::size_t most_new_pairs = 8;
constexpr std::size_t most_on_borders = 4;
constexpr std::size_t most_nodes = 64;

// For heaps with the first in front. A total order, so that every standard library has the same.
constexpr auto comes_later = [](const auto& p, const auto& q) {
  if (p.first() != q.first()) {
    return p.first() > q.first();
  }
  return p.nodes.a != q.nodes.a ? p.nodes.a > q.nodes.a : p.nodes.b > q.nodes.b;
};

// Infinite where squares of extents are beyond the largest double: then nothing is certain.
double slack_in_range(const Operands& operands) {
  const double slack = slack_of(operands);
  const double extents = 0x1p48 * slack;
  return extents * extents <= std::numeric_limits<double>::max() ? slack : infinity;
}

}  // namespace

WitnessSearch::WitnessSearch(const Operands& operands)
    : operands_(operands),
      a_(operands.a.cover_index().chords),
      b_(operands.b.cover_index().chords),
      slack_(slack_in_range(operands)),
      turned_(a_, b_),
      equal_(equal_nodes(operands)),
      met_(equal_.exist() ? std::optional(VisitedPairs{}) : std::nullopt),
      cells_(operands, slack_),
      sums_(operands, slack_, cells_) {}

// Where rings of a polygon touch, the solid has more sides in a point than those of two edges.
EqualNodes WitnessSearch::equal_nodes(const Operands& operands) {
  const bool touch =
      !operands.a.cover_index().touches.empty() || !operands.b.cover_index().touches.empty();
  return touch ? EqualNodes{} : find_equal_nodes(operands);
}

bool WitnessSearch::meet_again(const Nodes& nodes, VisitedPairs& visited) const {
  if (!equal_.prevail && !visited.is_of_use(limits::nodes_a_repeated_one)) {
    return false;
  }
  const EqualNodes::Node& a = equal_.a[nodes.a];
  const EqualNodes::Node& b = equal_.b[nodes.b];
  return visited.meet(a.number, b.number, operands_.point({a.first, b.first}));
}

WitnessSearch::Family WitnessSearch::family(const Nodes& nodes) const {
  const bool of_a = a_.extent(nodes.a) >= b_.extent(nodes.b);
  const std::uint32_t number = of_a ? a_.below(nodes.a) : b_.below(nodes.b);
  return of_a ? Family{a_.blocks[number], number, b_.block_of(nodes.b), nodes.b, true}
              : Family{b_.blocks[number], number, a_.block_of(nodes.a), nodes.a, false};
}

void WitnessSearch::begin(const RelativeLine& line, bool with_sums) {
  uses_sums_ = with_sums && !sums_.is_empty();
  line_ = line;
  turned_origin_ = turned_.turned(line.origin);
  turned_way_ = turned_.turned({line.dx, line.dy});
  queue_.assign(1, Waiting{{-2, 2}, roots});
  next_ = 0;
  waiting_.clear();
  covers_.clear();
  near_pairs_.clear();
  next_near_ = 0;
  leaves_out_ = true;
  if (met_) {
    met_->clear();
  }
}

bool WitnessSearch::was_added(const Nodes& nodes) {
  if (added_.empty()) {
    constexpr ChordTree::Node none = std::numeric_limits<ChordTree::Node>::max();
    added_.resize(kept_additions, {none, none});
  }
  const std::uint32_t hash = (nodes.a * 0x9e3779b1U) ^ (nodes.b * 0x85ebca6bU);
  Nodes& kept = added_[(hash >> 16) % kept_additions];
  const bool is_kept = kept.a == nodes.a && kept.b == nodes.b;
  kept = nodes;
  return is_kept;
}

void WitnessSearch::keep(const Witness& witness) {
  if (recent_.size() < most_recent) {
    recent_.push_back(witness);
  } else {
    recent_[kept_ % most_recent] = witness;
  }
  ++kept_;
}

double WitnessSearch::recent_reach(double t, double least) const {
  for (std::size_t k = 1; k <= recent_.size(); ++k) {
    const double end = recent_[(kept_ - k) % most_recent].reach(line_, t);
    if (end >= least) {
      return end;
    }
  }
  return t;
}

double WitnessSearch::met_reach(double t, double least) {
  double end = t;
  while (!covers_.empty() && covers_.front().covered.from <= t) {
    const Cover cover = covers_.front();
    std::pop_heap(covers_.begin(), covers_.end(), comes_later);
    covers_.pop_back();
    if (cover.covered.to >= least && cover.covered.to > end) {
      end = std::min(cover.covered.to, 1.0);
      last_nodes_ = cover.nodes;
      keep(witness(cover.nodes));
      if (!cells_.empty() && !was_added(last_nodes_)) {
        cells_.add(last());
      }
    }
  }
  return end;
}

void WitnessSearch::activate(double to) {
  while (!waiting_.empty() && waiting_.front().near.from <= to) {
    queue_.push_back(waiting_.front());
    std::pop_heap(waiting_.begin(), waiting_.end(), comes_later);
    waiting_.pop_back();
  }
}

void WitnessSearch::expand(const Nodes& nodes, double from, double to) {
  ++visits_;
  const Family children = family(nodes);
  const Ranges all = ranges(children);
  const bool other_is_edge = children.of_other.extent[ChordTree::lane_of(children.other)] < 0;
  for_each_lane(children.children.lanes, [&](std::uint32_t lane) {
    const Range near{all.near_from[lane], all.near_to[lane]};
    if (near.from > near.to || near.to < from || near.from > 1) {
      return;
    }
    const Nodes child = children.nodes(lane);
    if (met_ && leaves_out_ && meet_again(child, *met_)) {
      return;
    }
    const Range covered{all.covered_from[lane], all.covered_to[lane]};
    const bool covers = covered.from < covered.to && covered.to > from && covered.from < 1;
    if (covers) {
      covers_.push_back({covered, child});
      std::push_heap(covers_.begin(), covers_.end(), comes_later);
    }
    if (other_is_edge && children.children.extent[lane] < 0) {
      near_pairs_.push_back({near, {a_.below(child.a), b_.below(child.b)}});
      if (!(near.from > to) && !(covers && covered.from <= from)) {
        ++met_on_borders_;
      }
    } else if (near.from > to) {
      waiting_.push_back({near, child});
      std::push_heap(waiting_.begin(), waiting_.end(), comes_later);
    } else {
      queue_.push_back({near, child});
    }
  });
}

void WitnessSearch::put_longest_last() {
  const std::size_t last = queue_.size() - 1;
  for (std::size_t k = queue_.size() - std::min(queue_.size() - next_, last_nodes); k < last; ++k) {
    if (queue_[k].near.to > queue_[last].near.to) {
      std::swap(queue_[k], queue_[last]);
    }
  }
}

double WitnessSearch::reach(double t, double until) {
  double tried = -1;  // where recent witnesses were
  while (t < until) {
    const double least = std::min(1.0, t + least_progress);
    double end = cells_.reach(line_, t);
    if (end < least && uses_sums_) {
      end = sums_.reach(line_, t, least_progress);
    }
    if (end < least) {
      end = met_reach(t, least);
    }
    if (end < least && t > tried) {
      end = recent_reach(t, least);
      tried = t;
    }
    if (end > t) {
      t = end;
      continue;
    }
    activate(t);
    met_on_borders_ = 0;
    const std::size_t most_pairs = near_pairs_.size() + most_new_pairs;
    for (std::size_t k = 0;
         next_ < queue_.size() && !(!covers_.empty() && covers_.front().covered.from <= t); ++k) {
      if (k < largest_nodes) {
        expand_first(t, t);
      } else if (least < 1 && met_on_borders_ <= most_on_borders &&
                 near_pairs_.size() <= most_pairs && k < most_nodes) {
        put_longest_last();
        expand_last(t, t);
      } else {
        return t;
      }
    }
    if (next_ == queue_.size()) {
      queue_.clear();
      next_ = 0;
      if (covers_.empty() || covers_.front().covered.from > t) {
        break;
      }
    }
  }
  return t;
}

void WitnessSearch::approach(double from, double to) {
  activate(to);
  near_pairs_.erase(std::remove_if(near_pairs_.begin(), near_pairs_.end(),
                                   [&](const NearPair& p) { return p.near.to < from; }),
                    near_pairs_.end());
  approached_ = {from, to};
  next_near_ = 0;
}

void WitnessSearch::approach_further(double to) {
  next_near_ = 0;
  for (NearPair& p : near_pairs_) {
    if (!(p.near.from > approached_.to)) {
      std::swap(p, near_pairs_[next_near_++]);
    }
  }
  activate(to);
  approached_.to = to;
}

void WitnessSearch::prefer_last_witness() {
  for (std::size_t k = next_; k < queue_.size(); ++k) {
    if (queue_[k].nodes.a == last_nodes_.a && queue_[k].nodes.b == last_nodes_.b) {
      std::swap(queue_[k], queue_.back());
    }
  }
}

std::optional<WitnessSearch::Pair> WitnessSearch::next_found_pair() {
  while (next_near_ < near_pairs_.size()) {
    const NearPair& found = near_pairs_[next_near_++];
    if (!(found.near.from > approached_.to)) {
      return found.pair;
    }
  }
  return std::nullopt;
}

std::optional<WitnessSearch::Pair> WitnessSearch::next_pair(bool longest_first) {
  while (true) {
    if (const std::optional<Pair> found = next_found_pair()) {
      return found;
    }
    if (next_ == queue_.size()) {
      queue_.clear();
      next_ = 0;
      return std::nullopt;
    }
    if (longest_first && equal_.prevail) {
      put_longest_last();
    }
    expand_last(approached_.from, approached_.to);
  }
}

std::vector<WitnessSearch::Pair> WitnessSearch::all_pairs_near(const RelativeLine& line,
                                                               double from, double to) {
  begin(line);
  leaves_out_ = false;
  approach(from, to);
  std::vector<Pair> pairs;
  while (const std::optional<Pair> pair = next_pair()) {
    pairs.push_back(*pair);
  }
  return pairs;
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "locate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "predicates.hpp"
#include "ring_predicates.hpp"

namespace gcv {

namespace {

std::uint32_t priority(std::uint32_t edge) {
  std::uint32_t hash = edge * 0x9e3779b9U;
  hash = (hash ^ (hash >> 15U)) * 0x85ebca6bU;
  return hash ^ (hash >> 13U);
}

}  // namespace

RegionLocator::RegionLocator(const ExactRegion& region) : region_(region) {
  Tally tally;
  const ExactOrder order(*region.a.ring, *region.b.ring, region.shift, tally);
  vertices_.reserve(region.vertices.size());
  for (const RingVertex& vertex : region.vertices) {
    vertices_.push_back(order.placed(vertex));
  }
  for (const RegionPart& part : region.parts) {
    if (part.kind == PartKind::segment) {
      add_segment(part);
    } else if (part.kind == PartKind::point) {
      points_.push_back(static_cast<std::uint32_t>(part.first));
    } else {
      for (std::size_t k = part.first; k < part.end(); ++k) {
        const auto from = static_cast<std::uint32_t>(k);
        const auto to = static_cast<std::uint32_t>(k + 1 < part.end() ? k + 1 : part.first);
        const bool goes_up = order.compare(vertices_[from], vertices_[to]) < 0;
        edges_.push_back({goes_up ? from : to, goes_up ? to : from, region.vertices[k].leaving(),
                          goes_up != region.against_edges, goes_up});
      }
    }
  }
  sweep();
}

void RegionLocator::add_segment(const RegionPart& part) {
  const auto low = static_cast<std::uint32_t>(part.first);
  const auto x = [&](std::uint32_t k) { return vertices_[k].nearest.x.value; };
  const double high = std::nextafter(x(low + 1), infinity);
  const double furthest = spans_.empty() ? high : std::max(high, spans_.back().furthest);
  spans_.push_back({low, std::nextafter(x(low), -infinity), high, furthest,
                    region_.vertices[part.first].leaving()});
}

void RegionLocator::sweep() {
  Tally tally;
  const ExactOrder order(*region_.a.ring, *region_.b.ring, region_.shift, tally);
  const auto sorted_by = [&](auto end) {
    std::vector<std::uint32_t> edges(edges_.size());
    std::iota(edges.begin(), edges.end(), 0U);
    std::sort(edges.begin(), edges.end(), [&](std::uint32_t e, std::uint32_t f) {
      return order.compare(vertices_[edges_[e].*end], vertices_[edges_[f].*end]) < 0;
    });
    return edges;
  };
  const std::vector<std::uint32_t> beginning = sorted_by(&Edge::low);
  const std::vector<std::uint32_t> ending = sorted_by(&Edge::high);
  auto next_end = ending.begin();
  Node root = nothing;
  // A corner where edges end and none begin is the last one.
  for (auto next = beginning.begin(); next_end != ending.end();) {
    const std::uint32_t end_corner = edges_[*next_end].high;
    std::uint32_t corner = end_corner;
    if (next != beginning.end() &&
        order.compare(vertices_[edges_[*next].low], vertices_[end_corner]) < 0) {
      corner = edges_[*next].low;
    }
    const auto is_here = [&](std::uint32_t vertex) {
      return vertex == corner || order.compare(vertices_[vertex], vertices_[corner]) == 0;
    };
    for (; next_end != ending.end() && is_here(edges_[*next_end].high); ++next_end) {
      root = erase(root, *next_end);
    }
    for (; next != beginning.end() && is_here(edges_[*next].low); ++next) {
      root = insert(root, *next);
    }
    versions_.push_back({corner, root});
  }
  assert(root == nothing);
}

int RegionLocator::side_of(const Edge& edge, const RingVertex& v) const {
  Tally tally;
  const Boundary& a = *region_.a.ring;
  const Boundary& b = *region_.b.ring;
  const int side = side_of_vertex(a, b, coordinates(a, b, edge.line), v, tally);
  return edge.line_goes_up ? side : -side;
}

bool RegionLocator::is_above(std::uint32_t e, std::uint32_t f, bool begins) const {
  const Edge& edge = edges_[e];
  const Edge& other = edges_[f];
  const std::uint32_t corner = begins ? other.low : other.high;
  if (corner != edge.low && corner != edge.high) {
    if (const int side = side_of(edge, region_.vertices[corner]); side != 0) {
      return side > 0;
    }
  }
  Tally tally;
  const SumEdge s = coordinates(*region_.a.ring, *region_.b.ring, edge.line);
  const SumEdge t = coordinates(*region_.a.ring, *region_.b.ring, other.line);
  const int turn = gcv::turn(s.from, s.to, t.from, t.to, tally);
  const bool is_left = (edge.line_goes_up == other.line_goes_up ? turn : -turn) > 0;
  return is_left == begins;
}

RegionLocator::Node RegionLocator::copy(std::uint32_t edge, Node below, Node above) {
  nodes_.push_back({edge, below, above});
  return static_cast<Node>(nodes_.size() - 1);
}

RegionLocator::Split RegionLocator::split(Node tree, std::uint32_t edge) {
  if (tree == nothing) {
    return {nothing, nothing};
  }
  const TreeNode node = nodes_[tree];
  if (is_above(node.edge, edge, true)) {
    const Split rest = split(node.above, edge);
    return {copy(node.edge, node.below, rest.below), rest.above};
  }
  const Split rest = split(node.below, edge);
  return {rest.below, copy(node.edge, rest.above, node.above)};
}

RegionLocator::Node RegionLocator::merge(Node below, Node above) {
  if (below == nothing || above == nothing) {
    return below == nothing ? above : below;
  }
  const TreeNode p = nodes_[below];
  const TreeNode q = nodes_[above];
  if (priority(p.edge) > priority(q.edge)) {
    return copy(p.edge, p.below, merge(p.above, above));
  }
  return copy(q.edge, merge(below, q.below), q.above);
}

RegionLocator::Node RegionLocator::insert(Node tree, std::uint32_t edge) {
  const Split parts = split(tree, edge);
  return merge(merge(parts.below, copy(edge, nothing, nothing)), parts.above);
}

RegionLocator::Node RegionLocator::erase(Node tree, std::uint32_t edge) {
  assert(tree != nothing);
  const TreeNode node = nodes_[tree];
  if (node.edge == edge) {
    return merge(node.below, node.above);
  }
  return is_above(node.edge, edge, false) ? copy(node.edge, node.below, erase(node.above, edge))
                                          : copy(node.edge, erase(node.below, edge), node.above);
}

int RegionLocator::side_of(const EdgeName& line, const Point& p) const {
  Tally tally;
  return side(coordinates(*region_.a.ring, *region_.b.ring, line),
              {p, {0.0 - region_.shift.x, 0.0 - region_.shift.y}}, tally);
}

bool RegionLocator::is_on_fit(const Point& p) const {
  Tally tally;
  const ExactOrder order(*region_.a.ring, *region_.b.ring, region_.shift, tally);
  const auto point = std::lower_bound(
      points_.begin(), points_.end(), p,
      [&](std::uint32_t k, const Point& q) { return order.compare(vertices_[k], q) < 0; });
  if (point != points_.end() && order.compare(vertices_[*point], p) == 0) {
    return true;
  }
  auto span = std::upper_bound(spans_.begin(), spans_.end(), p.x,
                               [](double x, const Span& s) { return x < s.x_low; });
  while (span != spans_.begin() && std::prev(span)->furthest >= p.x) {
    --span;
    if (p.x <= span->x_high && side_of(span->line, p) == 0 &&
        order.compare(vertices_[span->low], p) <= 0 &&
        order.compare(vertices_[span->low + 1], p) >= 0) {
      return true;
    }
  }
  return false;
}

int RegionLocator::locate(const Point& p) const {
  if (is_on_fit(p)) {
    return 0;
  }
  Tally tally;
  const ExactOrder order(*region_.a.ring, *region_.b.ring, region_.shift, tally);
  const auto after = std::upper_bound(versions_.begin(), versions_.end(), p,
                                      [&](const Point& q, const Version& version) {
                                        return order.compare(vertices_[version.corner], q) > 0;
                                      });
  bool is_inside = false;
  if (after != versions_.begin()) {
    const Version& version = *std::prev(after);
    if (order.compare(vertices_[version.corner], p) == 0) {
      return 0;
    }
    for (Node node = version.root; node != nothing;) {
      const Edge& edge = edges_[nodes_[node].edge];
      const int side = side_of(edge.line, p);
      if (side == 0) {
        return 0;
      }
      const bool is_above = (side > 0) == edge.line_goes_up;
      if (is_above) {
        is_inside = edge.solid_is_above;
      }
      node = is_above ? nodes_[node].above : nodes_[node].below;
    }
  }
  return is_inside ? 1 : -1;
}

}  // namespace gcv

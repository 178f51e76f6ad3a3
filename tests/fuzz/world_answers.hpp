// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the library says of small polygons, in doubles, and whether it says the same again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "world_variants.hpp"

namespace gcv::fuzz {

struct Part {
  std::int32_t kind;
  std::vector<Point> vertices;
  auto operator<=>(const Part&) const = default;
};
using Parts = std::vector<Part>;

// The same set has the same order.
inline Parts sorted(Parts parts) {
  for (auto& [kind, vertices] : parts) {
    const auto smallest = std::min_element(vertices.begin(), vertices.end());
    std::rotate(vertices.begin(), smallest, vertices.end());
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

// Parts as they are without a variant. A reflection runs through rings the other way.
inline Parts back(const Variant& variant, const std::vector<double>& xy,
                  const std::vector<gcv_region_part>& layout) {
  const int s = variant.symmetry;
  const bool is_reflection = ((s & 1) + (s >> 1 & 1) + (s >> 2 & 1)) % 2 != 0;
  Parts parts;
  std::size_t at = 0;
  for (const gcv_region_part& part : layout) {
    std::vector<Point>& vertices = parts.emplace_back(Part{part.kind, {}}).vertices;
    for (std::uint64_t k = 0; k < part.vertex_count; ++k, ++at) {
      vertices.push_back(variant.back(xy[2 * at], xy[2 * at + 1]));
    }
    if (is_reflection) {
      std::reverse(vertices.begin(), vertices.end());
    }
  }
  return parts;
}

inline Parts parts(const gcv_region& region, const Variant& variant) {
  std::size_t count = 0;
  worlds::check(gcv_region_parts(&region, nullptr, 0, &count));
  std::vector<gcv_region_part> layout(count);
  worlds::check(gcv_region_parts(&region, layout.data(), count, &count));
  worlds::check(gcv_region_vertices(&region, nullptr, 0, &count));
  std::vector<double> xy(2 * count);
  worlds::check(gcv_region_vertices(&region, xy.data(), count, &count));
  return back(variant, xy, layout);
}

inline Parts parts(const gcv_outer_face& face, const Variant& variant) {
  std::size_t count = 0;
  worlds::check(gcv_outer_face_vertex_count(&face, &count));
  std::vector<double> xy(2 * count);
  worlds::check(gcv_outer_face_vertices(&face, xy.data(), count, &count));
  return back(variant, xy, {{GCV_PART_OUTER, 0, count}});
}

// The places, and motions from them, that questions are about, in halves of units.
struct Places {
  std::vector<WorldPoint> at;
  std::vector<WorldPoint> motions;

  static Places read(Input& input, WorldPoint low, WorldPoint high) {
    constexpr std::size_t count = 6;
    const auto between = [&](Int from, Int to) {
      return from + static_cast<Int>(input.below(static_cast<std::size_t>(to - from + 1)));
    };
    Places places;
    for (std::size_t k = 0; k < count; ++k) {
      places.at.push_back({between(low.x, high.x), between(low.y, high.y)});
    }
    for (std::size_t k = 0; k < 2; ++k) {
      places.motions.push_back({between(-9, 9), between(-9, 9)});
    }
    return places;
  }
};

// The places in doubles.
inline std::vector<double> doubles(const Places& places, const Variant& variant) {
  std::vector<double> xy;
  for (const WorldPoint& halves : places.at) {
    variant.append_place(halves, xy);
  }
  return xy;
}

// What one input asks, beside the relation: not everything, for speed.
enum class Theme { regions, fits, distances, ways };
constexpr Theme themes[]{Theme::regions, Theme::fits, Theme::distances, Theme::ways};

// What is not asked is empty.
struct Answers {
  // The region of the sum, or what a scene leaves free; the outer face; the inner fit.
  Parts region;
  Parts face;
  Parts fit;
  double region_area = 0;
  double face_area = 0;
  std::vector<std::int8_t> located;
  std::vector<std::int8_t> in_fit;
  std::vector<std::int8_t> relation;
  std::vector<gcv_separation> distance;
  std::vector<gcv_escape> escape;
  std::vector<gcv_impact> impact;
};

inline std::vector<std::int8_t> locate(const gcv_region& region, const std::vector<double>& xy) {
  std::vector<std::int8_t> located(xy.size() / 2);
  worlds::check(gcv_region_locate(&region, xy.data(), located.size(), located.data()));
  return located;
}

// Asks a subject at places; of ways out, at the first two. `cast` is called as gcv_cast, from the
// translations on.
template <class Cast>
void ask(const worlds::Subject& subject, const Places& places, const Variant& variant, Theme theme,
         Cast cast, Answers& answers) {
  std::vector<double> xy = doubles(places, variant);
  std::vector<double> motions;
  for (const WorldPoint& motion : places.motions) {
    const WorldPoint p = variant.of_halves(motion);
    motions.insert(motions.end(), {variant.number(p.x) / 2, variant.number(p.y) / 2});
  }
  answers.relation = subject.relation(xy);
  if (theme == Theme::distances) {
    answers.distance = subject.distance(xy);
    answers.impact.resize(places.motions.size());
    worlds::check(
        cast(xy.data(), motions.data(), answers.impact.size(), nullptr, answers.impact.data()));
  } else if (theme == Theme::ways) {
    constexpr std::size_t count = 2;
    xy.resize(2 * count);
    answers.escape = subject.penetration(xy);
  }
  const auto scale = [&](double& length) { length = std::ldexp(length, -variant.exponent); };
  const auto turn_back = [&](double* p) {
    const Point q = variant.back(p[0], p[1]);
    std::copy(q.begin(), q.end(), p);
  };
  const auto contact_back = [&](gcv_contact& contact) {
    scale(contact.gap);
    turn_back(contact.on_a);
    turn_back(contact.on_b);
  };
  for (gcv_separation& answer : answers.distance) {
    scale(answer.distance);
    contact_back(answer.nearest);
  }
  for (gcv_escape& answer : answers.escape) {
    scale(answer.depth);
    turn_back(answer.translation);
    turn_back(answer.position);
    contact_back(answer.contact);
  }
  for (gcv_impact& answer : answers.impact) {
    turn_back(answer.position);
    contact_back(answer.contact);
  }
}

inline bool same_vector(const double* p, const double* q) { return p[0] == q[0] && p[1] == q[1]; }

// Compares the answers to a question with those in a variant.
class Comparison {
 public:
  explicit Comparison(const Variant& variant)
      : is_turned_(variant.symmetry != 0 || variant.exchanged),
        is_moved_(variant.shift != WorldPoint{} || variant.moving_shift != WorldPoint{}),
        is_apart_(variant.shift != variant.moving_shift),
        is_renumbered_(variant.respelled || variant.exchanged),
        is_exchanged_(variant.exchanged) {}

  // What differs; or nothing.
  [[nodiscard]] const char* difference(const Answers& x, const Answers& y) const {
    const auto all = [](const auto& a, const auto& b, auto same) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
    };
    return !same_parts(x.region, y.region)               ? "the region"
           : !same_parts(x.face, y.face)                 ? "the outer face"
           : !is_exchanged_ && !same_parts(x.fit, y.fit) ? "the inner fit"
           : x.located != y.located                      ? "where places lie in the region"
           : !is_exchanged_ && x.in_fit != y.in_fit      ? "where places lie in the inner fit"
           : x.relation != y.relation                    ? "the relation"
           : !all(x.distance, y.distance, [&](auto& a, auto& b) { return same(a, b); })
               ? "the distance"
           : !all(x.escape, y.escape, [&](auto& a, auto& b) { return same(a, b); }) ? "the way out"
           : !all(x.impact, y.impact, [&](auto& a, auto& b) { return same(a, b); }) ? "the motion"
                                                                                    : nullptr;
  }

 private:
  bool is_turned_;
  bool is_moved_;
  bool is_apart_;
  bool is_renumbered_;
  bool is_exchanged_;

  [[nodiscard]] bool same_parts(const Parts& x, const Parts& y) const {
    return is_turned_ ? sorted(x) == sorted(y) : x == y;
  }

  // Which of several contacts is given depends on the numbers of the vertices alone.
  [[nodiscard]] bool same(const gcv_contact& x, const gcv_contact& y) const {
    return x.gap == y.gap &&
           (is_renumbered_ || std::tie(x.kind, x.a, x.b, x.id_a, x.id_b) ==
                                  std::tie(y.kind, y.a, y.b, y.id_a, y.id_b)) &&
           (is_renumbered_ || is_moved_ ||
            (same_vector(x.on_a, y.on_a) && same_vector(x.on_b, y.on_b)));
  }

  [[nodiscard]] bool same(const gcv_separation& x, const gcv_separation& y) const {
    return x.distance == y.distance && x.relation == y.relation && same(x.nearest, y.nearest);
  }

  // Of several shortest ways the one that is given depends on the axes; the position in doubles, on
  // how far they are from the origin.
  [[nodiscard]] bool same(const gcv_escape& x, const gcv_escape& y) const {
    return x.depth == y.depth &&
           (is_turned_ ||
            (same_vector(x.translation, y.translation) && same(x.contact, y.contact))) &&
           (is_turned_ || is_apart_ ||
            (x.relation == y.relation && same_vector(x.position, y.position)));
  }

  [[nodiscard]] bool same(const gcv_impact& x, const gcv_impact& y) const {
    return x.hit == y.hit && x.time == y.time &&
           (is_turned_ || is_apart_ ||
            (x.relation == y.relation && same_vector(x.position, y.position) &&
             same(x.contact, y.contact)));
  }
};

}  // namespace gcv::fuzz

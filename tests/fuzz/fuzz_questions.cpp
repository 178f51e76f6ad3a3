// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> two polygons with holes, on a small grid or anywhere among the doubles, with
// translations and motions -> the questions about them. The answers must go together: with A and B
// exchanged, for half of a motion, within a smaller distance, one by one. Those about few vertices
// must be right by the definitions, in fractions.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact_list_checks.hpp"
#include "escape_checks.hpp"
#include "question_polygons.hpp"

namespace {

using gcv::fuzz::cast;
using gcv::fuzz::check;
using gcv::fuzz::check_contact_lists;
using gcv::fuzz::check_depth_between;
using gcv::fuzz::check_penetration;
using gcv::fuzz::distance;
using gcv::fuzz::Input;
using gcv::fuzz::is_finite;
using gcv::fuzz::is_none;
using gcv::fuzz::length_above;
using gcv::fuzz::make;
using gcv::fuzz::minus;
using gcv::fuzz::Motion;
using gcv::fuzz::negated;
using gcv::fuzz::Pair;
using gcv::fuzz::penetration;
using gcv::fuzz::Placement;
using gcv::fuzz::Point;
using gcv::fuzz::read_polygon;
using gcv::fuzz::read_vector;
using gcv::fuzz::relation;
using gcv::fuzz::Ring;
using gcv::fuzz::Rings;
using gcv::fuzz::same_bytes;
using gcv::fuzz::succeeds;
using gcv::fuzz::text;
using gcv::test::Points;
using gcv::test::text_of;

// -------------------------------------------------------------- what must hold of it --

void check_relation(const Pair& pair, const Point& t, const std::string& where) {
  const int here = relation(pair.a.get(), pair.b.get(), t);
  check(here >= GCV_OVERLAPPING && here <= GCV_APART, "no relation" + where);
  check(here == relation(pair.b.get(), pair.a.get(), negated(t)),
        "another relation with a and b exchanged" + where);
}

void check_distance(const Pair& pair, const Point& t, const std::string& where) {
  const auto here = distance(pair.a.get(), pair.b.get(), t);
  const int lie = relation(pair.a.get(), pair.b.get(), t);
  if (!here) {
    check(lie == GCV_APART, "a distance out of range, but no distance" + where);
    return;
  }
  check(here->relation == lie, "another relation from gcv_distance" + where);
  check(is_none(here->nearest) == (lie != GCV_APART), "a nearest contact or not?" + where);
  check(here->distance >= 0 && here->distance == here->nearest.gap, "no distance" + where);
  const auto exchanged = distance(pair.b.get(), pair.a.get(), negated(t));
  check(!exchanged || exchanged->distance == here->distance,
        "another distance with a and b exchanged" + where);
}

// No distance changes by more than the way between two translations.
void check_way_between(const Pair& pair, const Point& s, const Point& t) {
  const auto from = distance(pair.a.get(), pair.b.get(), s);
  const auto to = distance(pair.a.get(), pair.b.get(), t);
  if (from && to) {
    const double way = length_above(minus(s, t));
    check(from->distance <= (to->distance + way) * (1 + 0x1p-50) &&
              to->distance <= (from->distance + way) * (1 + 0x1p-50),
          "a distance that changes too much, from " + text_of(s) + " to " + text_of(t) + pair.text);
  }
}

// Is p + q a sum of doubles without rounding?
bool adds_exactly(double p, double q) {
  const double sum = p + q;
  const double part = sum - p;
  return std::isfinite(sum) && std::isfinite(part) && (p - (sum - part)) + (q - part) == 0;
}

void check_miss(const Motion& motion, const gcv_impact& impact, const std::string& where) {
  check(impact.time == 1 && is_none(impact.contact), "a miss that hits" + where);
  const auto& [t, way] = motion;
  if (adds_exactly(t[0], way[0]) && adds_exactly(t[1], way[1])) {
    check(impact.position[0] == t[0] + way[0] && impact.position[1] == t[1] + way[1],
          "a miss that ends elsewhere" + where);
    check(impact.relation != GCV_OVERLAPPING, "a miss that ends in an overlap" + where);
  }
}

void check_hit(const Pair& pair, const Motion& motion, const gcv_impact& impact,
               const std::string& where) {
  const bool starts_inside =
      relation(pair.a.get(), pair.b.get(), motion.translation) == GCV_OVERLAPPING;
  check(is_none(impact.contact) == starts_inside, "a contact or not?" + where);
  check(!starts_inside || impact.time == 0, "an overlap at the start that comes later" + where);
  check(impact.contact.gap == 0, "a hit with a gap" + where);
  const auto start = distance(pair.a.get(), pair.b.get(), motion.translation);
  if (start && impact.time >= std::numeric_limits<double>::min()) {
    check(start->distance <= impact.time * length_above(motion.way) * (1 + 0x1p-50) +
                                 std::numeric_limits<double>::denorm_min(),
          "a hit before the distance is covered" + where);
  }
}

// Half of a motion leads to the same hit at twice the time, or not so far.
void check_half(const Pair& pair, const Motion& motion, const gcv_impact& whole,
                const std::string& where) {
  const Motion half{motion.translation, {motion.way[0] / 2, motion.way[1] / 2}};
  const auto impact = half.way[0] * 2 == motion.way[0] && half.way[1] * 2 == motion.way[1]
                          ? cast(pair.a.get(), pair.b.get(), half)
                          : std::nullopt;
  if (!impact) {
    return;
  }
  if (whole.hit == 0 || whole.time >= 0.5) {
    check(impact->hit == 0, "half of the motion hits" + where);
    return;
  }
  gcv_impact expected = whole;
  expected.time *= 2;
  if (whole.time < std::numeric_limits<double>::min()) {  // was rounded more
    expected.time = impact->time;
  }
  check(same_bytes(*impact, expected), "half of the motion hits elsewhere" + where);
}

void check_cast(const Pair& pair, const Motion& motion, const std::string& where) {
  const auto impact = cast(pair.a.get(), pair.b.get(), motion);
  if (!impact) {
    return;
  }
  check(impact->time >= 0 && impact->time <= 1, "a time out of range" + where);
  check(impact->relation ==
            relation(pair.a.get(), pair.b.get(), {impact->position[0], impact->position[1]}),
        "another relation at the position" + where);
  if (impact->hit == 0) {
    check_miss(motion, *impact, where);
  } else {
    check(impact->hit == 1, "neither a hit nor a miss" + where);
    check_hit(pair, motion, *impact, where);
  }
  check_half(pair, motion, *impact, where);
  const auto exchanged =
      cast(pair.b.get(), pair.a.get(), {negated(motion.translation), negated(motion.way)});
  check(!exchanged || (exchanged->hit == impact->hit && exchanged->time == impact->time),
        "another impact with a and b exchanged" + where);
}

// All at once, or none.
template <class Result, class One, class All>
void check_all(const Pair& pair, const std::vector<Motion>& motions, One one, All all) {
  std::vector<Result> expected;
  for (const Motion& motion : motions) {
    if (const auto result = one(motion)) {
      expected.push_back(*result);
    }
  }
  std::vector<Result> out(motions.size());
  const gcv_status status = all(out.data());
  const bool well = succeeds("a question", status, {GCV_ERR_RANGE});
  check(well == (expected.size() == motions.size()), "all at once, or not?" + pair.text);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    check(same_bytes(out[k], well ? expected[k] : Result{}),
          "other answers all at once" + motions[k].text() + pair.text);
  }
}

void check_all_at_once(const Pair& pair, const std::vector<Motion>& motions,
                       const Points& translations, const Points& ways, std::uint64_t leave_out) {
  const gcv_polygon* const a = pair.a.get();
  const gcv_polygon* const b = pair.b.get();
  const double* const t = translations.front().data();
  const std::size_t count = translations.size();
  check_all<gcv_separation>(
      pair, motions, [&](const Motion& motion) { return distance(a, b, motion.translation); },
      [&](gcv_separation* out) { return gcv_distance(a, b, t, count, nullptr, out); });
  check_all<gcv_impact>(
      pair, motions, [&](const Motion& motion) { return cast(a, b, motion); },
      [&](gcv_impact* out) { return gcv_cast(a, b, t, ways.front().data(), count, nullptr, out); });
  gcv_options options = GCV_OPTIONS_INIT;
  options.leave_out = leave_out;
  check_all<gcv_escape>(
      pair, motions,
      [&](const Motion& motion) { return penetration(a, b, motion.translation, leave_out); },
      [&](gcv_escape* out) { return gcv_penetration(a, b, t, count, &options, out); });
}

// How far a motion leads; at most the largest double.
double length_of(const Point& way) {
  return std::min(std::hypot(way[0], way[1]), std::numeric_limits<double>::max());
}

std::size_t vertex_count(const Rings& rings) {
  std::size_t count = 0;
  for (const Ring& ring : rings) {
    count += ring.size();
  }
  return count;
}

// By the definitions.
void check_answers(const Rings& a, const Rings& b, const Points& translations, const Points& ways,
                   double slope, const std::string& where) {
  const gcv::test::ContactPair pair(a, b);
  gcv::test::ContactCounts counts;
  const auto expect_none = [&](const gcv::test::Messages& messages) {
    for (const std::string& message : messages) {
      gcv::fuzz::fail(message + where);
    }
  };
  expect_none(check_relations(pair, translations, counts));
  expect_none(check_distances(pair, translations, counts));
  expect_none(check_casts(pair, translations, ways, counts));
  for (std::size_t k = 0; k < translations.size(); ++k) {
    for (const double distance : {0.0, length_of(ways[k])}) {
      expect_none(check_contacts(pair, translations[k], distance, slope, counts));
    }
  }
  constexpr std::size_t few = 8;  // the shortest way out takes long
  if (vertex_count(a) <= few && vertex_count(b) <= few) {
    expect_none(check_escapes(pair, translations, counts));
  }
}

// ------------------------------------------------------------------------- an input --

void check_refused(const Pair& pair, const Motion& motion) {
  const auto& [t, way] = motion;
  gcv_impact out{};
  const gcv_status status =
      gcv_cast(pair.a.get(), pair.b.get(), t.data(), way.data(), 1, nullptr, &out);
  check(status == GCV_ERR_NOT_FINITE, "a motion that is not finite" + motion.text());
}

void check_case(Input& input, const Rings& a, const Rings& b, int exponent) {
  const Pair pair{make(a), make(b), "\na:" + text(a) + "\nb:" + text(b),
                  a.size() > 1 && b.size() > 1};
  if (!pair.a || !pair.b) {
    return;
  }
  std::vector<Motion> motions;
  Points translations;
  Points ways;
  for (std::size_t count = 1 + input.below(4); count > 0; --count) {
    const Point t = read_vector(input, a, b, exponent);
    const Motion motion{t, read_vector(input, a, b, exponent)};
    if (!is_finite(motion.translation) || !is_finite(motion.way)) {
      check_refused(pair, motion);
      continue;
    }
    motions.push_back(motion);
    translations.push_back(motion.translation);
    ways.push_back(motion.way);
  }
  const double slope = input.one_of({0x1p-52, 0.0, 0.125, 1.0, 3.0, 1e300});
  const std::uint64_t leave_out = input.below(4);
  for (const Motion& motion : motions) {
    const std::string where = motion.text() + pair.text;
    check_relation(pair, motion.translation, where);
    check_distance(pair, motion.translation, where);
    check_cast(pair, motion, where);
    check_way_between(pair, motions.front().translation, motion.translation);
    check_penetration(pair, motion.translation, where);
    check_depth_between(pair, motions.front().translation, motion.translation);
    check_contact_lists(pair, motion.translation, length_of(motion.way), slope, where);
  }
  if (motions.empty()) {
    return;
  }
  check_all_at_once(pair, motions, translations, ways, leave_out);
  constexpr std::size_t most_pairs_of_vertices = 150;
  if (vertex_count(a) * vertex_count(b) <= most_pairs_of_vertices) {
    check_answers(a, b, translations, ways, slope, pair.text);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  Placement placement;
  const Rings a = read_polygon(input, placement);
  const Rings b = read_polygon(input, placement);
  check_case(input, a, b, placement.exponent);
  return 0;
}

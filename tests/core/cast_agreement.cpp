// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_cast against the reference; positions of doubles.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "contact_agreement.hpp"
#include "correct_rounding.hpp"

namespace gcv::test {

namespace {

using invariants::exact;
using reference::Exact;
using reference::Rational;

// The doubles at most two units in the last place from the exact number, which has a nearest one.
std::vector<double> doubles_near(const Rational& exact) {
  const double largest = std::numeric_limits<double>::max();
  double x = mpq_get_d(exact.backend().data());  // rounded towards 0
  for (int k = 0; k < 3 && x > -largest; ++k) {
    x = std::nextafter(x, -HUGE_VAL);
  }
  std::vector<double> near;
  for (int k = 0; k < 8 && x <= largest; ++k, x = std::nextafter(x, HUGE_VAL)) {
    const double high = std::nextafter(x, HUGE_VAL);
    const double low = std::nextafter(x, -HUGE_VAL);
    if (-invariants::exactly_above(-low) <= exact && exact <= invariants::exactly_above(high)) {
      near.push_back(x == 0 ? 0 : x);
    }
  }
  return near;
}

std::string impact_difference(const ContactPair& pair, const gcv_impact& got,
                              const reference::Impact& wanted, const Exact& start,
                              const Exact& motion, ContactCounts& counts) {
  if (got.hit != (wanted.hit ? 1 : 0)) {
    return "hit " + std::to_string(got.hit) + ", not at " + wanted.time.str();
  }
  if (!invariants::is_rounded_down(got.time, wanted.time)) {
    return "time " + text_of(got.time) + ", not " + wanted.time.str() + " rounded down";
  }
  if (wanted.time > 0 &&
      reference::overlap(pair.exact_a, moved(pair.exact_b, start + Rational(got.time) * motion))) {
    return "overlap at time " + text_of(got.time);
  }
  const std::string contact =
      contact_difference(got.contact, wanted_contact(got.contact, wanted.entered));
  return contact.empty() ? position_difference(pair, got.position, got.relation,
                                               start + wanted.time * motion, counts)
                         : contact;
}

}  // namespace

// The smallest one. Of the names of a contact where rings touch, the one that the library chose,
// else the largest.
const reference::Contact* wanted_contact(const gcv_contact& got,
                                         const reference::EnteredContacts& entered) {
  const reference::Contact* smallest = nullptr;
  const auto take = [&](const reference::Contact& c) {
    if (smallest == nullptr || c.feature < smallest->feature) {
      smallest = &c;
    }
  };
  if (!entered.contacts.empty()) {
    take(entered.contacts.front());
  }
  for (const std::vector<reference::Contact>& names : entered.where_rings_touch) {
    const auto chosen = std::find_if(names.begin(), names.end(), [&](const reference::Contact& c) {
      return c.feature == reference::Feature{got.kind, got.a, got.b};
    });
    take(chosen != names.end() ? *chosen : names.back());
  }
  return smallest;
}

std::string position_difference(const RelationAt& relation_at, const double position[2],
                                int relation, const Exact& exact_place, ContactCounts& counts) {
  const std::vector<double> xs = doubles_near(exact_place.x);
  const std::vector<double> ys = doubles_near(exact_place.y);
  const Point got{position[0], position[1]};
  const auto is_among = [](const std::vector<double>& near, double x) {
    return std::find(near.begin(), near.end(), x) != near.end();
  };
  const std::string place = "position " + text_of(got) + ": ";
  if (!is_among(xs, got[0]) || !is_among(ys, got[1])) {
    return place + "not within 2 ulps of " + exact_place.x.str() + " " + exact_place.y.str();
  }
  const std::string wrong_relation = relation_difference(relation, relation_at(exact(got)));
  if (!wrong_relation.empty()) {
    return place + wrong_relation;
  }
  if (relation != reference::overlapping) {
    return "";
  }
  ++counts.not_free;
  if (!are_nearest(position, exact_place)) {
    return place + "overlaps, but is not the nearest";
  }
  for (const double x : xs) {
    for (const double y : ys) {
      if (relation_at(exact(Point{x, y})) != reference::overlapping) {
        return place + "overlaps, " + text_of(Point{x, y}) + " does not";
      }
    }
  }
  return "";
}

std::string position_difference(const ContactPair& pair, const double position[2], int relation,
                                const Exact& exact_place, ContactCounts& counts) {
  const auto relation_at = [&](const Exact& t) {
    return reference::relation(pair.exact_a, moved(pair.exact_b, t));
  };
  return position_difference(relation_at, position, relation, exact_place, counts);
}

Messages check_casts(const ContactPair& pair, const Points& translations, const Points& motions,
                     ContactCounts& counts) {
  // Those in range, all at once.
  Points in_range;
  Points their_motions;
  std::vector<reference::Impact> expected;
  Messages messages;
  for (std::size_t k = 0; k < translations.size(); ++k) {
    const Exact start = exact(translations[k]);
    const Exact motion = exact(motions[k]);
    const reference::Impact wanted =
        reference::impact(pair.exact_a, moved(pair.exact_b, start), motion);
    std::size_t& count = !wanted.hit              ? counts.misses
                         : wanted.entered.empty() ? counts.starts_inside
                                                  : counts.hits;
    ++count;
    if (!is_out_of_range(start + wanted.time * motion)) {
      in_range.push_back(translations[k]);
      their_motions.push_back(motions[k]);
      expected.push_back(wanted);
      continue;
    }
    ++counts.out_of_range;
    gcv_impact unused;
    if (gcv_cast(pair.a.get(), pair.b.get(), translations[k].data(), motions[k].data(), 1, nullptr,
                 &unused) != GCV_ERR_RANGE) {
      report(messages, translations[k], motions[k], "an impact, not GCV_ERR_RANGE");
    }
  }
  const std::size_t count = expected.size();
  if (count == 0) {
    return messages;
  }
  std::vector<gcv_impact> got(count);
  invariants::require(gcv_cast(pair.a.get(), pair.b.get(), in_range.front().data(),
                               their_motions.front().data(), count, nullptr, got.data()),
                      "casts");
  std::vector<gcv_impact> swapped(count);
  // Where b lies may be in range in one place and out of range in the other.
  const bool is_swapped =
      gcv_cast(pair.b.get(), pair.a.get(), negated(in_range).front().data(),
               negated(their_motions).front().data(), count, nullptr, swapped.data()) == GCV_OK;
  for (std::size_t k = 0; k < count; ++k) {
    const Point& t = in_range[k];
    if (is_swapped && (swapped[k].hit != got[k].hit || swapped[k].time != got[k].time)) {
      report(messages, t, their_motions[k], "another time with a and b exchanged");
    }
    report(messages, t, their_motions[k],
           impact_difference(pair, got[k], expected[k], exact(t), exact(their_motions[k]), counts));
  }
  return messages;
}

}  // namespace gcv::test

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "contact_agreement.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "correct_rounding.hpp"

namespace gcv::test {

namespace {

using invariants::exact;
using invariants::is_near_quotient;
using invariants::is_nearest;
using invariants::is_nearest_root;
using reference::Exact;
using reference::Rational;

std::string record_text(const gcv_contact& c) {
  std::string text = "of " + std::to_string(c.id_a) + ", " + std::to_string(c.id_b) + ": " +
                     std::to_string(c.kind) + ":" + std::to_string(c.a) + "," +
                     std::to_string(c.b) + " gap " + text_of(c.gap);
  for (const auto& [name, p] :
       {std::pair("normal", c.normal), std::pair("on_a", c.on_a), std::pair("on_b", c.on_b)}) {
    text += std::string(" ") + name + " " + text_of(p[0]) + " " + text_of(p[1]);
  }
  return text;
}

std::string feature_text(const reference::Feature& f) {
  return std::to_string(f.kind) + ":" + std::to_string(f.a) + "," + std::to_string(f.b);
}

void count_relation(int relation, ContactCounts& counts) {
  std::size_t& count = relation == reference::apart      ? counts.apart
                       : relation == reference::touching ? counts.touching
                                                         : counts.overlapping;
  ++count;
}

std::string separation_difference(const gcv_separation& got, const reference::Separation& wanted) {
  const std::string relation = relation_difference(got.relation, wanted.relation);
  if (!relation.empty()) {
    return relation;
  }
  if (!is_nearest_root(got.distance, wanted.squared_distance)) {
    return "distance " + text_of(got.distance) + " is not the nearest to the root of " +
           wanted.squared_distance.str();
  }
  if (got.reserved != 0) {
    return "reserved is not 0";
  }
  return contact_difference(got.nearest, wanted.nearest ? &*wanted.nearest : nullptr);
}

}  // namespace

ContactPair::ContactPair(const reference::Rings& a_rings, const reference::Rings& b_rings)
    : a(made(a_rings)),
      b(made(b_rings)),
      exact_a(reference::make_solid(a_rings)),
      exact_b(reference::make_solid(b_rings)) {}

invariants::PolygonHandle made(const reference::Rings& rings) {
  Points points;
  std::vector<std::size_t> sizes;
  for (const invariants::Polygon& ring : rings) {
    points.insert(points.end(), ring.begin(), ring.end());
    sizes.push_back(ring.size());
  }
  gcv_polygon* polygon = nullptr;
  invariants::require(
      gcv_polygon_create_rings(points.front().data(), sizes.data(), sizes.size(), 0, &polygon),
      "a polygon");
  return invariants::PolygonHandle(polygon);
}

std::string text_of(double x) {
  char text[40];
  static_cast<void>(std::snprintf(text, sizeof text, "%.17g", x));
  return text;
}

std::string text_of(const Point& p) { return text_of(p[0]) + " " + text_of(p[1]); }

void report(Messages& messages, const Point& translation, const std::string& what) {
  if (!what.empty()) {
    messages.push_back("t " + text_of(translation) + ": " + what);
  }
}

void report(Messages& messages, const Point& translation, const Point& motion,
            const std::string& what) {
  if (!what.empty()) {
    messages.push_back("t " + text_of(translation) + ", motion " + text_of(motion) + ": " + what);
  }
}

std::string relation_difference(int got, int wanted) {
  return got == wanted ? "" : "relation " + std::to_string(got) + ", not " + std::to_string(wanted);
}

bool are_nearest(const double got[2], const Exact& wanted) {
  return is_nearest(got[0], wanted.x) && is_nearest(got[1], wanted.y);
}

Points negated(Points points) {
  for (Point& p : points) {
    p = {0.0 - p[0], 0.0 - p[1]};
  }
  return points;
}

bool is_out_of_range(const reference::Exact& p) {
  return invariants::overflows(p.x) || invariants::overflows(p.y);
}

bool is_out_of_range(const reference::Contact& contact) {
  return invariants::root_overflows(contact.squared_gap) || is_out_of_range(contact.on_a) ||
         is_out_of_range(contact.on_b);
}

std::string contact_difference(const gcv_contact& got, const reference::Contact* wanted,
                               const Ids& ids) {
  if (wanted == nullptr) {
    gcv_contact none{};
    none.id_a = ids.a;
    none.id_b = ids.b;
    return std::memcmp(&got, &none, sizeof got) == 0 ? "" : "a contact: " + record_text(got);
  }
  const reference::Feature feature{got.kind, got.a, got.b};
  const Rational squared_length = dot(wanted->normal, wanted->normal);
  const bool deep = wanted->is_deep && wanted->squared_gap != 0;
  std::string wrong;
  if (feature != wanted->feature) {
    wrong = "the feature";
  } else if (!is_nearest_root(deep ? 0.0 - got.gap : got.gap, wanted->squared_gap)) {
    wrong = "the gap, by the square " + wanted->squared_gap.str();
  } else if (!is_near_quotient(got.normal[0], wanted->normal.x, squared_length) ||
             !is_near_quotient(got.normal[1], wanted->normal.y, squared_length)) {
    wrong = "the normal, not along " + wanted->normal.x.str() + " " + wanted->normal.y.str();
  } else if (!are_nearest(got.on_a, wanted->on_a)) {
    wrong = "on_a, not " + wanted->on_a.x.str() + " " + wanted->on_a.y.str();
  } else if (!are_nearest(got.on_b, wanted->on_b)) {
    wrong = "on_b, not " + wanted->on_b.x.str() + " " + wanted->on_b.y.str();
  } else if (got.reserved != 0 || Ids{got.id_a, got.id_b} != ids) {
    wrong = "reserved or an id";
  }
  return wrong.empty() ? ""
                       : "contact " + record_text(got) + ": wrong is " + wrong + "; wanted is " +
                             feature_text(wanted->feature);
}

Messages check_relations(const ContactPair& pair, const Points& translations,
                         ContactCounts& counts) {
  const std::size_t count = translations.size();
  std::vector<std::int8_t> got(count);
  std::vector<std::int8_t> swapped(count);
  invariants::require(gcv_relation(pair.a.get(), pair.b.get(), translations.front().data(), count,
                                   nullptr, got.data()),
                      "relations");
  invariants::require(gcv_relation(pair.b.get(), pair.a.get(), negated(translations).front().data(),
                                   count, nullptr, swapped.data()),
                      "swapped relations");
  Messages messages;
  for (std::size_t k = 0; k < count; ++k) {
    const int wanted =
        reference::relation(pair.exact_a, moved(pair.exact_b, exact(translations[k])));
    count_relation(wanted, counts);
    report(messages, translations[k], relation_difference(got[k], wanted));
    if (swapped[k] != got[k]) {
      report(messages, translations[k], "another relation with a and b exchanged");
    }
  }
  return messages;
}

Messages check_distances(const ContactPair& pair, const Points& translations,
                         ContactCounts& counts) {
  // Those in range, all at once.
  Points in_range;
  std::vector<reference::Separation> expected;
  Messages messages;
  for (const Point& t : translations) {
    const reference::Separation wanted =
        reference::separation(pair.exact_a, moved(pair.exact_b, exact(t)));
    if (!wanted.nearest || !is_out_of_range(*wanted.nearest)) {
      in_range.push_back(t);
      expected.push_back(wanted);
      continue;
    }
    ++counts.out_of_range;
    gcv_separation unused;
    if (gcv_distance(pair.a.get(), pair.b.get(), t.data(), 1, nullptr, &unused) != GCV_ERR_RANGE) {
      report(messages, t, "a distance, not GCV_ERR_RANGE");
    }
  }
  const std::size_t count = expected.size();
  if (count == 0) {
    return messages;
  }
  std::vector<gcv_separation> got(count);
  std::vector<gcv_separation> swapped(count);
  invariants::require(
      gcv_distance(pair.a.get(), pair.b.get(), in_range.front().data(), count, nullptr, got.data()),
      "distances");
  // Where b lies may be in range in one place and out of range in the other.
  const bool is_swapped = gcv_distance(pair.b.get(), pair.a.get(), negated(in_range).front().data(),
                                       count, nullptr, swapped.data()) == GCV_OK;
  for (std::size_t k = 0; k < count; ++k) {
    const Point& t = in_range[k];
    report(messages, t, separation_difference(got[k], expected[k]));
    if (is_swapped && (swapped[k].distance != got[k].distance)) {
      report(messages, t, "another distance with a and b exchanged");
    }
  }
  return messages;
}

}  // namespace gcv::test

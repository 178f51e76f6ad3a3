// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What must hold of lists of contacts, whatever the polygons are.
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "question_pair.hpp"

namespace gcv::fuzz {

using Contacts = std::vector<gcv_contact>;

// None beyond the largest double.
inline std::optional<Contacts> contacts(const gcv_polygon* a, const gcv_polygon* b, const Point& t,
                                        double distance, double slope) {
  gcv_contact_list* list = nullptr;
  const gcv_status status = gcv_contacts(a, b, t.data(), distance, slope, nullptr, &list);
  if (!succeeds("gcv_contacts", status, {GCV_ERR_RANGE})) {
    return std::nullopt;
  }
  const ContactList owner(list);
  std::size_t count = 0;
  succeeds("their number", gcv_contact_list_contacts(list, nullptr, 0, &count));
  Contacts result(count + 1);
  succeeds("the contacts", gcv_contact_list_contacts(list, result.data(), count, &count));
  result.resize(count);
  std::vector<std::uint64_t> previous(count + 1);
  succeeds("the indices", gcv_contact_list_previous(list, previous.data(), count, &count));
  previous.resize(count);
  check(std::all_of(previous.begin(), previous.end(),
                    [](std::uint64_t index) { return index == UINT64_MAX; }),
        "an index in no list");
  return result;
}

inline auto order_of(const gcv_contact& c) { return std::tuple(std::abs(c.gap), c.kind, c.a, c.b); }

inline bool is_before(const gcv_contact& c, const gcv_contact& d) {
  return order_of(c) < order_of(d);
}

inline void check_list(const Contacts& list, double distance, const std::string& where) {
  for (const gcv_contact& c : list) {
    check(c.kind >= GCV_CONTACT_EDGE_VERTEX && c.kind <= GCV_CONTACT_VERTEX_VERTEX &&
              c.reserved == 0 && c.id_a == 0 && c.id_b == 0,
          "no contact" + where);
    check(std::abs(c.gap) <= distance, "a contact beyond the distance" + where);
    check(c.gap >= 0 || c.kind != GCV_CONTACT_VERTEX_VERTEX, "two vertices with a gap < 0" + where);
    const double length = std::hypot(c.normal[0], c.normal[1]);
    check(std::abs(length - 1) < 0x1p-50 ||
              (length == 0 && c.gap == 0 && c.kind == GCV_CONTACT_VERTEX_VERTEX),
          "a normal that is no unit vector" + where);
  }
  check(std::adjacent_find(list.begin(), list.end(),
                           [](const gcv_contact& c, const gcv_contact& d) {
                             return !is_before(c, d);
                           }) == list.end(),
        "contacts out of order" + where);
}

// Are all contacts of the first list in the second one? None is in what is out of range.
inline void check_is_part(const std::optional<Contacts>& part, const std::optional<Contacts>& list,
                          const std::string& where) {
  check(part || !list, "fewer contacts out of range" + where);
  if (!part || !list) {
    return;
  }
  std::size_t k = 0;
  for (const gcv_contact& c : *part) {
    while (k < list->size() && is_before((*list)[k], c)) {
      ++k;
    }
    check(k < list->size() && same_bytes((*list)[k], c), "a contact has gone" + where);
  }
}

// The same contacts, seen from the other side.
inline void check_exchanged(const Contacts& list, Contacts exchanged, const std::string& where) {
  for (gcv_contact& c : exchanged) {
    std::swap(c.a, c.b);
    c.kind = c.kind == GCV_CONTACT_VERTEX_VERTEX
                 ? c.kind
                 : GCV_CONTACT_EDGE_VERTEX + GCV_CONTACT_VERTEX_EDGE - c.kind;
  }
  std::sort(exchanged.begin(), exchanged.end(), is_before);
  const bool are_same = std::equal(list.begin(), list.end(), exchanged.begin(), exchanged.end(),
                                   [](const gcv_contact& c, const gcv_contact& d) {
                                     return c.kind == d.kind && c.a == d.a && c.b == d.b &&
                                            c.gap == d.gap && c.normal[0] == 0 - d.normal[0] &&
                                            c.normal[1] == 0 - d.normal[1];
                                   });
  check(are_same, "other contacts with a and b exchanged" + where);
}

// Lists within 0 and the distance, without and with the slope.
inline void check_contact_lists(const Pair& pair, const Point& t, double distance, double slope,
                                const std::string& place) {
  const std::string where =
      "\ndistance: " + text_of(distance) + ", slope: " + text_of(slope) + place;
  const auto within = [&](double d, double s) {
    const auto list = contacts(pair.a.get(), pair.b.get(), t, d, s);
    if (list) {
      check_list(*list, d, where);
      const auto exchanged = contacts(pair.b.get(), pair.a.get(), negated(t), d, s);
      if (exchanged) {
        check_exchanged(*list, *exchanged, where);
      }
    }
    return list;
  };
  const auto touching = within(0, 0);
  const auto nearly_touching = within(0, slope);
  const auto near = within(distance, 0);
  const auto nearly_near = within(distance, slope);
  check_is_part(touching, near, where);
  check_is_part(touching, nearly_touching, where);
  check_is_part(near, nearly_near, where);
  check_is_part(nearly_touching, nearly_near, where);
  // In one point where rings of both polygons touch, there may be none.
  check(pair.have_holes || !touching || !touching->empty() ||
            relation(pair.a.get(), pair.b.get(), t) != GCV_TOUCHING,
        "polygons that touch without a contact" + where);
}

}  // namespace gcv::fuzz

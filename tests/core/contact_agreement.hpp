// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The C functions for two polygons against the reference. Each check gives a sentence for every
// difference, with the place as a caller would pass it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "contact_reference.hpp"
#include "handles.hpp"
#include "motion_reference.hpp"

namespace gcv::test {

using invariants::Point;
using Points = std::vector<Point>;
using Messages = std::vector<std::string>;

// Two polygons for both sides.
struct ContactPair {
  invariants::PolygonHandle a;
  invariants::PolygonHandle b;
  reference::Solid exact_a;
  reference::Solid exact_b;

  // Throws invariants::Failure where a polygon is not valid.
  ContactPair(const reference::Rings& a_rings, const reference::Rings& b_rings);
};

// How often something was met.
struct ContactCounts {
  std::size_t apart = 0;
  std::size_t touching = 0;
  std::size_t overlapping = 0;
  std::size_t hits = 0;
  std::size_t misses = 0;
  std::size_t starts_inside = 0;
  std::size_t not_free = 0;  // positions without a free one near them
  std::size_t out_of_range = 0;
  std::size_t listed = 0;  // contacts in lists
};

Messages check_relations(const ContactPair& pair, const Points& translations,
                         ContactCounts& counts);
Messages check_distances(const ContactPair& pair, const Points& translations,
                         ContactCounts& counts);
Messages check_casts(const ContactPair& pair, const Points& translations, const Points& motions,
                     ContactCounts& counts);
Messages check_escapes(const ContactPair& pair, const Points& translations, ContactCounts& counts);
// The contacts at one translation.
Messages check_contacts(const ContactPair& pair, const Point& translation, double distance,
                        double slope, ContactCounts& counts);

// ---- What the checks consist of

Points negated(Points points);

std::string text_of(double x);
std::string text_of(const Point& p);

// Adds "translation, motion: what" to the messages, unless `what` is "".
void report(Messages& messages, const Point& translation, const std::string& what);
void report(Messages& messages, const Point& translation, const Point& motion,
            const std::string& what);

std::string relation_difference(int got, int wanted);
bool are_nearest(const double got[2], const reference::Exact& wanted);

// Of a contact: 0 for polygons that are in no scene.
struct Ids {
  std::uint64_t a = 0;
  std::uint64_t b = 0;

  friend bool operator==(const Ids&, const Ids&) = default;
};

// What is wrong with the record of that contact: "" if nothing.
std::string contact_difference(const gcv_contact& got, const reference::Contact* wanted,
                               const Ids& ids = {});

// The handle of a polygon. Throws invariants::Failure where it is not valid.
invariants::PolygonHandle made(const reference::Rings& rings);

// How polygons lie at an exact translation.
using RelationAt = std::function<int(const reference::Exact&)>;

// Is it a position for that exact translation: within two units in the last place; with the
// relation there; free if that can be? "" if so.
std::string position_difference(const RelationAt& relation_at, const double position[2],
                                int relation, const reference::Exact& exact, ContactCounts& counts);
std::string position_difference(const ContactPair& pair, const double position[2], int relation,
                                const reference::Exact& exact, ContactCounts& counts);

// The contact that a cast is to name, NULL for none.
const reference::Contact* wanted_contact(const gcv_contact& got,
                                         const reference::EnteredContacts& entered);

// What a list is to have.
struct ListedContact {
  Ids ids;
  reference::Contact contact;
};

// What is wrong with the list: "" if nothing.
std::string list_difference(const std::vector<gcv_contact>& got,
                            const std::vector<ListedContact>& wanted);

// Has a number of the contact, or a coordinate, no double?
bool is_out_of_range(const reference::Contact& contact);
bool is_out_of_range(const reference::Exact& p);

}  // namespace gcv::test

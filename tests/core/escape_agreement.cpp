// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_penetration against the reference.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "contact_agreement.hpp"
#include "correct_rounding.hpp"
#include "motion_reference.hpp"

namespace gcv::test {

namespace {

using reference::Exact;

// The smallest pair of an edge and a vertex that touch there.
std::optional<reference::Contact> contact_on_the_way(const ContactPair& pair, const Exact& place) {
  std::optional<reference::Contact> first;
  for (const reference::Contact& c : contacts(pair.exact_a, moved(pair.exact_b, place), 0, 0)) {
    if (c.feature.kind != reference::vertex_vertex && (!first || c.feature < first->feature)) {
      first = c;
    }
  }
  return first;
}

std::string escape_difference(const ContactPair& pair, const gcv_escape& got, const Exact& start,
                              const Exact& wanted, ContactCounts& counts) {
  if (!invariants::is_nearest_root(got.depth, dot(wanted, wanted))) {
    return "depth " + text_of(got.depth) + " is not the nearest to the length of " +
           wanted.x.str() + " " + wanted.y.str();
  }
  if (!are_nearest(got.translation, wanted)) {
    return "translation " + text_of(Point{got.translation[0], got.translation[1]}) + ", not " +
           wanted.x.str() + " " + wanted.y.str();
  }
  if (got.reserved != 0) {
    return "reserved";
  }
  const std::optional<reference::Contact> contact =
      wanted == Exact{0, 0} ? std::nullopt : contact_on_the_way(pair, start + wanted);
  const std::string difference = contact_difference(got.contact, contact ? &*contact : nullptr);
  return difference.empty()
             ? position_difference(pair, got.position, got.relation, start + wanted, counts)
             : difference;
}

}  // namespace

Messages check_escapes(const ContactPair& pair, const Points& translations, ContactCounts& counts) {
  // Those in range, all at once.
  Points in_range;
  std::vector<Exact> expected;
  Messages messages;
  for (const Point& t : translations) {
    const Exact start = invariants::exact(t);
    const Exact wanted = reference::escape(pair.exact_a, moved(pair.exact_b, start));
    if (!invariants::root_overflows(dot(wanted, wanted)) && !is_out_of_range(wanted) &&
        !is_out_of_range(start + wanted)) {
      in_range.push_back(t);
      expected.push_back(wanted);
      continue;
    }
    ++counts.out_of_range;
    gcv_escape unused;
    if (gcv_penetration(pair.a.get(), pair.b.get(), t.data(), 1, nullptr, &unused) !=
        GCV_ERR_RANGE) {
      report(messages, t, "an escape, not GCV_ERR_RANGE");
    }
  }
  const std::size_t count = expected.size();
  if (count == 0) {
    return messages;
  }
  std::vector<gcv_escape> got(count);
  invariants::require(gcv_penetration(pair.a.get(), pair.b.get(), in_range.front().data(), count,
                                      nullptr, got.data()),
                      "escapes");
  for (std::size_t k = 0; k < count; ++k) {
    counts.overlapping += expected[k] == Exact{0, 0} ? 0 : 1;
    report(messages, in_range[k],
           escape_difference(pair, got[k], invariants::exact(in_range[k]), expected[k], counts));
  }
  return messages;
}

}  // namespace gcv::test

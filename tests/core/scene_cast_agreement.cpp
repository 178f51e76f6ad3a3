// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_scene_cast against the reference.
#include <algorithm>

#include "correct_rounding.hpp"
#include "scene_agreement.hpp"

namespace gcv::test {

namespace {

using invariants::exact;
using reference::Exact;
using reference::Rational;

// What is hit first: of several, the first. Id 0 for nothing.
struct FirstHit {
  std::uint64_t id = 0;
  reference::Impact impact{false, 1, {}};
};

// All places on the way of the motion are in its box.
PlacedSolid with_its_way(const PlacedSolid& start, const Exact& motion) {
  PlacedSolid swept = start;
  swept.box->low = {start.box->low.x + std::min<Rational>(motion.x, 0),
                    start.box->low.y + std::min<Rational>(motion.y, 0)};
  swept.box->high = {start.box->high.x + std::max<Rational>(motion.x, 0),
                     start.box->high.y + std::max<Rational>(motion.y, 0)};
  return swept;
}

FirstHit first_hit_of(const PlacedSolids& solids, const PlacedSolid& start, const Exact& motion,
                      SceneCounts& counts) {
  const PlacedSolid swept = with_its_way(start, motion);
  FirstHit first;
  for (const PlacedSolid* solid : solids) {
    if (squared_box_gap(*solid, swept) > 0) {
      continue;
    }
    const reference::Impact impact = reference::impact(solid->solid, start.solid, motion);
    if (impact.hit && first.id != 0 && impact.time == first.impact.time) {
      ++counts.ties;
    }
    if (impact.hit && (first.id == 0 || impact.time < first.impact.time)) {
      first = {solid->id, impact};
    }
  }
  return first;
}

std::string hit_difference(const gcv_impact& got, const FirstHit& wanted) {
  if (got.hit != (wanted.impact.hit ? 1 : 0)) {
    return "hit " + std::to_string(got.hit) + ", not " + std::to_string(wanted.id) + " at " +
           wanted.impact.time.str();
  }
  if (!invariants::is_rounded_down(got.time, wanted.impact.time)) {
    return "time " + text_of(got.time) + ", not " + wanted.impact.time.str() + " rounded down";
  }
  return contact_difference(got.contact, wanted_contact(got.contact, wanted.impact.entered),
                            {wanted.id, 0});
}

}  // namespace

Messages check_scene_casts(const CheckedScene& scene, const MovingPolygon& moving,
                           const Points& positions, const Points& motions, const gcv_query* query,
                           SceneCounts& counts) {
  const PlacedSolids solids = asked_solids(scene, query);
  const RelationAt relation_at = [&](const Exact& t) {
    return relation_to_all(solids, moved_there(moving, t));
  };
  Messages messages;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const Exact start = exact(positions[k]);
    const Exact motion = exact(motions[k]);
    const FirstHit wanted = first_hit_of(solids, moved_there(moving, start), motion, counts);
    std::size_t& count = !wanted.impact.hit              ? counts.contacts.misses
                         : wanted.impact.entered.empty() ? counts.contacts.starts_inside
                                                         : counts.contacts.hits;
    ++count;
    gcv_impact got;
    const gcv_status status = gcv_scene_cast(scene.handle, moving.handle, positions[k].data(),
                                             motions[k].data(), 1, query, nullptr, &got);
    const Exact end = start + wanted.impact.time * motion;
    const reference::Contact* const contact = wanted_contact({}, wanted.impact.entered);
    if (is_out_of_range(end) || (contact != nullptr && is_out_of_range(*contact))) {
      ++counts.contacts.out_of_range;
      report(messages, positions[k], motions[k],
             status == GCV_ERR_RANGE ? "" : "an impact, not GCV_ERR_RANGE");
      continue;
    }
    if (status == GCV_ERR_RANGE) {
      report(messages, positions[k], motions[k], "an impact out of range");
      continue;
    }
    invariants::require(status, "a cast");
    std::string wrong = hit_difference(got, wanted);
    if (wrong.empty() && wanted.impact.time > 0 &&
        relation_at(start + Rational(got.time) * motion) == reference::overlapping) {
      wrong = "overlap at time " + text_of(got.time);
    }
    report(messages, positions[k], motions[k],
           wrong.empty()
               ? position_difference(relation_at, got.position, got.relation, end, counts.contacts)
               : wrong);
  }
  return messages;
}

}  // namespace gcv::test

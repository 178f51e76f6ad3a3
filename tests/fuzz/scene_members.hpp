// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a scene must answer, from the answers about two polygons: for members whose positions have
// doubles as differences, and without a container.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "../core/scene_answers.hpp"
#include "question_pair.hpp"

namespace gcv::fuzz {

// Is p - q a double?
inline bool subtracts_exactly(double p, double q) {
  const double difference = p - q;
  const double part = difference - p;
  return std::isfinite(difference) && std::isfinite(part) &&
         (p - (difference - part)) - (q + part) == 0;
}

// The position of a member, or of a moving polygon as seen from it.
struct PlacedMember {
  test::Id id;
  const gcv_polygon* polygon;
  Point position;
};

class MembersAlone {
 public:
  // None if some difference is no double.
  static std::optional<MembersAlone> at(const std::vector<PlacedMember>& members,
                                        const gcv_polygon* moving, const Point& position) {
    MembersAlone result(moving);
    for (const PlacedMember& member : members) {
      for (const std::size_t k : {0U, 1U}) {
        if (!subtracts_exactly(position[k], member.position[k])) {
          return std::nullopt;
        }
      }
      result.members_.push_back({member.id, member.polygon, minus(position, member.position)});
    }
    return result;
  }

  [[nodiscard]] int relation() const {
    int least = GCV_APART;
    for (const PlacedMember& member : members_) {
      least = std::min(least, fuzz::relation(member.polygon, moving_, member.position));
    }
    return least;
  }

  void check_distance(const gcv_separation& got, const std::string& where) const {
    double least = HUGE_VAL;
    for (const PlacedMember& member : members_) {
      const auto alone = distance(member.polygon, moving_, member.position);
      if (!alone) {
        return;
      }
      least = std::min(least, alone->distance);
    }
    check(got.distance == least, "a distance that is not the least" + where);
    const PlacedMember* const nearest = find(got.nearest.id_a);
    check((nearest == nullptr) == members_.empty(), "the nearest one is none" + where);
    if (nearest == nullptr) {
      check(is_none(got.nearest), "a contact with nothing" + where);
      return;
    }
    const auto alone = distance(nearest->polygon, moving_, nearest->position);
    check(alone && alone->distance == least && same_feature(alone->nearest, got.nearest),
          "another contact of the nearest one" + where);
    const test::Id first = first_met();
    check(first == 0 || first == nearest->id, "not the smallest id" + where);
    check(is_first_of_its_kind(*nearest), "the nearest one is not the first" + where);
  }

  void check_cast(const gcv_impact& got, const Point& motion, const std::string& where) const {
    double first = 1;
    bool hit = false;
    for (const PlacedMember& member : members_) {
      const auto alone = cast(member.polygon, moving_, {member.position, motion});
      if (!alone) {
        return;
      }
      hit = hit || alone->hit == 1;
      first = std::min(first, alone->time);
    }
    check(got.hit == (hit ? 1 : 0) && got.time == first, "another hit" + where);
    const PlacedMember* const met = find(got.contact.id_a);
    check((met == nullptr) == !hit, "what is hit is none" + where);
    if (met != nullptr) {
      const auto alone = cast(met->polygon, moving_, {met->position, motion});
      check(alone && alone->hit == 1 && alone->time == first &&
                same_feature(alone->contact, got.contact),
            "another contact of what is hit" + where);
      check(is_first_of_its_kind(*met), "what is hit is not the first" + where);
    }
  }

 private:
  explicit MembersAlone(const gcv_polygon* moving) : moving_(moving) {}

  [[nodiscard]] const PlacedMember* find(test::Id id) const {
    for (const PlacedMember& member : members_) {
      if (member.id == id) {
        return &member;
      }
    }
    return nullptr;
  }

  // Is there no member with a smaller id that is the same at the same place?
  [[nodiscard]] bool is_first_of_its_kind(const PlacedMember& member) const {
    return std::none_of(members_.begin(), members_.end(), [&](const PlacedMember& other) {
      return other.id < member.id && other.polygon == member.polygon &&
             other.position == member.position;
    });
  }

  // The smallest id of those that touch or overlap, or 0.
  [[nodiscard]] test::Id first_met() const {
    for (const PlacedMember& member : members_) {
      if (fuzz::relation(member.polygon, moving_, member.position) != GCV_APART) {
        return member.id;
      }
    }
    return 0;
  }

  static bool same_feature(const gcv_contact& c, const gcv_contact& d) {
    return std::tie(c.kind, c.a, c.b, c.gap, c.normal[0], c.normal[1]) ==
           std::tie(d.kind, d.a, d.b, d.gap, d.normal[0], d.normal[1]);
  }

  const gcv_polygon* moving_;
  std::vector<PlacedMember> members_;  // by id, with positions of the moving one
};

}  // namespace gcv::fuzz

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "near_contacts.hpp"
#include "pair_search.hpp"

namespace gcv {

namespace {

// What tells the contacts of a list apart.
auto name_of(const SceneContact& c) {
  return std::tuple(c.a, c.b, c.contact.kind, c.contact.a, c.contact.b);
}
bool is_before(const SceneContact& p, const SceneContact& q) {
  const double gap_p = std::abs(p.contact.gap);
  const double gap_q = std::abs(q.contact.gap);
  return gap_p != gap_q ? gap_p < gap_q : name_of(p) < name_of(q);
}

// Finds contacts of a list by their names.
class ContactsByName {
 public:
  // Leaves out those for which is_known(contact) is true.
  template <class IsKnown>
  ContactsByName(const std::vector<SceneContact>& contacts, IsKnown is_known)
      : contacts_(contacts) {
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      if (!is_known(contacts[k])) {
        indices_.push_back(k);
      }
    }
    std::sort(indices_.begin(), indices_.end(), [&](std::size_t p, std::size_t q) {
      return name_of(contacts_[p]) < name_of(contacts_[q]);
    });
  }

  // The index of the contact of that name, or no_previous.
  [[nodiscard]] std::uint64_t find(const SceneContact& contact) const {
    const auto found = std::lower_bound(
        indices_.begin(), indices_.end(), contact,
        [&](std::size_t k, const SceneContact& c) { return name_of(contacts_[k]) < name_of(c); });
    return found != indices_.end() && name_of(contacts_[*found]) == name_of(contact) ? *found
                                                                                     : no_previous;
  }

 private:
  const std::vector<SceneContact>& contacts_;
  std::vector<std::size_t> indices_;
};

// The contacts of pairs of which one has changed.
std::vector<SceneContact> fresh_contacts(const Scene& scene, const Query& query, double distance,
                                         double slope, const Unchanged& unchanged, Task& task) {
  auto contacts =
      PairSearch(scene, query, unchanged, distance)
          .run<SceneContact>(task, [&](std::vector<SceneContact>& found, const Solid& a,
                                       const Solid& b) {
            const PolygonPair pair(a.boundary, b.boundary);
            Task uncounted;
            Tally tally;
            for (const Contact& contact : near_contacts(PlacedPair(pair, a.position, b.position),
                                                        distance, slope, uncounted, tally)) {
              found.push_back({a.id, b.id, contact});
            }
          });
  std::sort(contacts.begin(), contacts.end(), is_before);
  return contacts;
}

}  // namespace

SceneContactList scene_contacts(const Scene& scene, const Query& query, double distance,
                                double slope, const SceneContactList* previous, Task& task) {
  const bool is_useful = previous != nullptr && previous->distance == distance &&
                         previous->slope == slope && previous->snapshot.query == query;
  const Unchanged unchanged =
      is_useful ? Unchanged(scene, query, previous->snapshot) : Unchanged(scene);
  SceneContactList list{Snapshot(scene, query), distance, slope, {}, {}};
  std::vector<SceneContact> fresh = fresh_contacts(scene, query, distance, slope, unchanged, task);
  if (previous == nullptr) {
    list.contacts = std::move(fresh);
    list.previous.assign(list.contacts.size(), no_previous);
    return list;
  }
  const auto is_kept = [&](const SceneContact& c) {
    return unchanged.has(c.a) && unchanged.has(c.b);
  };
  const std::vector<SceneContact>& old = previous->contacts;
  const ContactsByName changed(old, is_kept);
  list.contacts.reserve(old.size() + fresh.size());
  list.previous.reserve(old.size() + fresh.size());
  auto next = fresh.begin();
  const auto take_fresh = [&] {
    list.previous.push_back(changed.find(*next));
    list.contacts.push_back(*next++);
  };
  for (std::size_t k = 0; k < old.size(); ++k) {
    if (!is_kept(old[k])) {
      continue;
    }
    while (next != fresh.end() && is_before(*next, old[k])) {
      take_fresh();
    }
    list.contacts.push_back(old[k]);
    list.previous.push_back(k);
  }
  while (next != fresh.end()) {
    take_fresh();
  }
  return list;
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Lists of pairs and contacts: gcv_contacts, gcv_scene_near, gcv_scene_pairs, gcv_scene_contacts,
// and what they are read with.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "contacts.hpp"
#include "error.hpp"
#include "fill.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "near_contacts.hpp"
#include "options.hpp"
#include "query.hpp"
#include "scene_queries.hpp"
#include "task.hpp"

using gcv::Error;
using gcv::PairList;
using gcv::PlacedPair;
using gcv::PolygonPair;
using gcv::Query;
using gcv::SceneContact;
using gcv::SceneContactList;
using gcv::ScenePair;
using gcv::Status;
using gcv::Tally;
using gcv::Task;
using gcv::capi::fill;
using gcv::capi::guarded;
using gcv::capi::is_out_of_range;
using gcv::capi::public_contact;
using gcv::capi::read_exact_options;
using gcv::capi::read_options;
using gcv::capi::read_query;
using gcv::capi::require;
using gcv::capi::require_size;
using gcv::capi::threads_of;
using gcv::capi::Vectors;

namespace {

// Makes the handle. Throws Error: range.
gcv_contact_list* new_list(SceneContactList list) {
  for (const SceneContact& contact : list.contacts) {
    if (is_out_of_range(contact.contact)) {
      throw Error(Status::range, "a contact: a distance or a point is beyond the largest double");
    }
  }
  return std::make_unique<gcv_contact_list>(std::move(list)).release();
}

// The list of a handle that may be NULL. Throws Error: invalid_argument for one of another scene.
template <class Handle>
auto list_of(const Handle* previous, const gcv_scene* scene) -> decltype(&previous->list) {
  if (previous == nullptr) {
    return nullptr;
  }
  if (previous->list.snapshot.family != scene->scene.family()) {
    throw Error(Status::invalid_argument,
                "previous is no such list of this scene, nor of one that it was copied from or to");
  }
  return &previous->list;
}

}  // namespace

gcv_status gcv_contacts(const gcv_polygon* a, const gcv_polygon* b, const double t[2],
                        double distance, double slope, const gcv_options* options,
                        gcv_contact_list** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(t, "t");
    require(out, "out");
    const gcv_options given = read_options(options);
    const Vectors translation(t, 1, "translation");
    require_size(distance, "distance");
    require_size(slope, "slope");
    const PolygonPair pair(*a->polygon, *b->polygon);
    Task task(1, given.progress, given.progress_context);
    task.begin(std::uint64_t{pair.a.boundary.size()} + pair.b.boundary.size());
    Tally tally;
    SceneContactList list{{}, distance, slope, {}, {}};
    const std::vector<gcv::Contact> contacts =
        near_contacts(PlacedPair(pair, translation[0]), distance, slope, task, tally);
    list.contacts.reserve(contacts.size());
    for (const gcv::Contact& contact : contacts) {
      list.contacts.push_back({0, 0, contact});
    }
    task.poll();
    list.previous.assign(list.contacts.size(), gcv::no_previous);
    std::unique_ptr<gcv_contact_list> result(new_list(std::move(list)));
    task.finish();
    *out = result.release();
  });
}

gcv_status gcv_scene_contacts(const gcv_scene* scene, const gcv_contact_list* previous,
                              double distance, double slope, const gcv_query* query,
                              const gcv_options* options, gcv_contact_list** out) {
  return guarded([&] {
    require(scene, "scene");
    require(out, "out");
    const gcv_options given = read_exact_options(options, "scenes");
    const Query asked = read_query(query);
    require_size(distance, "distance");
    require_size(slope, "slope");
    Task task(threads_of(given), given.progress, given.progress_context);
    *out = new_list(
        scene_contacts(scene->scene, asked, distance, slope, list_of(previous, scene), task));
  });
}

void gcv_contact_list_destroy(gcv_contact_list* list) { delete list; }

gcv_status gcv_contact_list_contacts(const gcv_contact_list* list, gcv_contact* out,
                                     size_t capacity, size_t* required) {
  return guarded([&] {
    require(list, "list");
    const std::vector<SceneContact>& contacts = list->list.contacts;
    fill(contacts.size(), "contacts", "out", out, capacity, required, [&](gcv_contact* to) {
      std::transform(contacts.begin(), contacts.end(), to,
                     [](const SceneContact& c) { return public_contact(c.contact, c.a, c.b); });
    });
  });
}

gcv_status gcv_contact_list_previous(const gcv_contact_list* list, uint64_t* out, size_t capacity,
                                     size_t* required) {
  return guarded([&] {
    require(list, "list");
    const std::vector<std::uint64_t>& previous = list->list.previous;
    fill(previous.size(), "indices", "out", out, capacity, required,
         [&](std::uint64_t* to) { std::copy(previous.begin(), previous.end(), to); });
  });
}

gcv_status gcv_scene_near(const gcv_scene* scene, const gcv_polygon* moving,
                          const double position[2], double distance, const gcv_query* query,
                          const gcv_options* options, gcv_pair_list** out) {
  return guarded([&] {
    require(scene, "scene");
    require(moving, "moving");
    require(position, "position");
    require(out, "out");
    const gcv_options given = read_exact_options(options, "scenes");
    const Query asked = read_query(query);
    const Vectors place(position, 1, "position");
    require_size(distance, "distance");
    Task task(threads_of(given), given.progress, given.progress_context);
    PairList list{
        {},
        distance,
        near_solids(scene->scene, asked, moving->polygon->boundary(), place[0], distance, task)};
    *out = std::make_unique<gcv_pair_list>(std::move(list)).release();
  });
}

gcv_status gcv_scene_pairs(const gcv_scene* scene, const gcv_pair_list* previous, double distance,
                           const gcv_query* query, const gcv_options* options,
                           gcv_pair_list** out) {
  return guarded([&] {
    require(scene, "scene");
    require(out, "out");
    const gcv_options given = read_exact_options(options, "scenes");
    const Query asked = read_query(query);
    require_size(distance, "distance");
    Task task(threads_of(given), given.progress, given.progress_context);
    *out = std::make_unique<gcv_pair_list>(
               near_pairs(scene->scene, asked, distance, list_of(previous, scene), task))
               .release();
  });
}

void gcv_pair_list_destroy(gcv_pair_list* list) { delete list; }

gcv_status gcv_pair_list_pairs(const gcv_pair_list* list, gcv_pair* out, size_t capacity,
                               size_t* required) {
  return guarded([&] {
    require(list, "list");
    const std::vector<ScenePair>& pairs = list->list.pairs;
    fill(pairs.size(), "pairs", "out", out, capacity, required, [&](gcv_pair* to) {
      std::transform(pairs.begin(), pairs.end(), to, [](const ScenePair& p) {
        return gcv_pair{p.a, p.b, static_cast<std::int32_t>(p.relation), 0};
      });
    });
  });
}

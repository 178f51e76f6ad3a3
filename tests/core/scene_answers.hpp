// SPDX-License-Identifier: LGPL-3.0-or-later
//
// All that a scene says, byte by byte, with names in place of ids: the same for all scenes that
// have the same members.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact_agreement.hpp"

namespace gcv::test {

using Id = std::uint64_t;

struct Asked {
  const gcv_polygon* moving;
  Points positions;
  Points motions;
  std::uint32_t layers;
  std::vector<Id> ignored;
  double distance;
  double slope;
};

template <class Element>
void append(std::string& bytes, const Element& element) {
  bytes.append(reinterpret_cast<const char*>(&element), sizeof element);
}

template <class Handle>
using Owner = std::unique_ptr<Handle, invariants::Destroy>;

// The answer, or that there is none in range.
template <class Handle, class Call>
Owner<Handle> list_of(std::string& bytes, Call call) {
  Handle* list = nullptr;
  const gcv_status status = call(&list);
  if (status != GCV_ERR_RANGE) {
    invariants::require(status, "a list");
  }
  append(bytes, status);
  return Owner<Handle>(list);
}

inline Points vertices_of(const gcv_region* region) {
  std::size_t count = 0;
  invariants::require(gcv_region_vertices(region, nullptr, 0, &count), "their number");
  Points vertices(count + 1);
  invariants::require(gcv_region_vertices(region, vertices.front().data(), count, &count),
                      "vertices");
  vertices.resize(count);
  return vertices;
}

// Of the ids of a scene: the same for all scenes that have the same members.
using Name = std::map<Id, Id>;

inline Id name_of(const Name& names, Id id) {
  const auto there = names.find(id);
  return there == names.end() ? id : there->second;
}

inline std::string bytes_of(const gcv_pair_list* list, const Name& names) {
  std::string bytes;
  for (gcv_pair pair : invariants::elements(gcv_pair_list_pairs, list)) {
    pair.a = name_of(names, pair.a);
    pair.b = name_of(names, pair.b);
    append(bytes, pair);
  }
  return bytes;
}

inline void rename(gcv_contact& contact, const Name& names) {
  contact.id_a = name_of(names, contact.id_a);
  contact.id_b = name_of(names, contact.id_b);
}

inline std::string bytes_of(const gcv_contact_list* list, const Name& names) {
  std::string bytes;
  for (gcv_contact contact : invariants::elements(gcv_contact_list_contacts, list)) {
    rename(contact, names);
    append(bytes, contact);
  }
  return bytes;
}

class Asker {
 public:
  // `names` are those of the scene's ids; those to ignore are names, too, of any members.
  Asker(const gcv_scene* scene, const Asked& asked, const Name& names)
      : scene_(scene), asked_(asked), names_(names) {
    for (const Id name : asked.ignored) {
      const auto same = std::find_if(names.begin(), names.end(),
                                     [&](const auto& id) { return id.second == name; });
      const Id unknown = name == 1 ? 1 : UINT64_MAX - name;
      ignored_.push_back(same == names.end() ? unknown : same->first);
    }
    query_.layers = asked.layers;
    query_.ignore = ignored_.data();
    query_.ignore_count = ignored_.size();
  }

  // Everything but lists of the scene alone.
  [[nodiscard]] std::string about_moving() const {
    std::string bytes;
    for (std::size_t k = 0; k < asked_.positions.size(); ++k) {
      append_place(k, bytes);
    }
    const auto near = list_of<gcv_pair_list>(bytes, [&](gcv_pair_list** out) {
      return gcv_scene_near(scene_, asked_.moving, asked_.positions.front().data(), asked_.distance,
                            &query_, nullptr, out);
    });
    return bytes + bytes_of(near.get(), names_) + bests();
  }
  // The vertices of the free region in the container, and whose edges they are.
  [[nodiscard]] std::string free_region() const {
    std::string bytes;
    gcv_region* out = nullptr;
    append(bytes, gcv_scene_free_region(scene_, asked_.moving, nullptr, &query_, nullptr, &out));
    const Owner<gcv_region> region(out);
    if (region) {
      for (const Point& vertex : vertices_of(region.get())) {
        append(bytes, vertex);
      }
      for (const Id id : invariants::elements(gcv_region_edge_owners, region.get())) {
        append(bytes, name_of(names_, id));
      }
    }
    return bytes;
  }
  // Best positions, with fits and without.
  [[nodiscard]] std::string bests() const {
    std::string bytes;
    for (const Point& direction : Points{{-1, 0}, {0.25, 1}}) {
      for (const std::uint64_t leave_out : {std::uint64_t{0}, std::uint64_t{GCV_LEAVE_OUT_FITS}}) {
        append(bytes, best(direction, leave_out));
      }
    }
    return bytes;
  }
  struct Best {
    gcv_status status;
    std::int32_t found;
    Point position;
  };
  [[nodiscard]] Best best(const Point& direction, std::uint64_t leave_out) const {
    gcv_options options = GCV_OPTIONS_INIT;
    options.leave_out = leave_out;
    Best result{GCV_OK, 0, {0, 0}};
    result.status = gcv_scene_best(scene_, asked_.moving, direction.data(), &query_, &options,
                                   result.position.data(), &result.found);
    return result;
  }

  [[nodiscard]] std::string pairs(const gcv_pair_list* previous, Owner<gcv_pair_list>& out) const {
    std::string bytes;
    out = list_of<gcv_pair_list>(bytes, [&](gcv_pair_list** list) {
      return gcv_scene_pairs(scene_, previous, asked_.distance, &query_, nullptr, list);
    });
    return bytes + bytes_of(out.get(), names_);
  }

  [[nodiscard]] std::string contacts(const gcv_contact_list* previous,
                                     Owner<gcv_contact_list>& out) const {
    std::string bytes;
    out = list_of<gcv_contact_list>(bytes, [&](gcv_contact_list** list) {
      return gcv_scene_contacts(scene_, previous, asked_.distance, asked_.slope, &query_, nullptr,
                                list);
    });
    return out ? bytes + bytes_of(out.get(), names_) : bytes;
  }

 private:
  void append_place(std::size_t k, std::string& bytes) const {
    const double* const position = asked_.positions[k].data();
    std::int8_t relation = 77;
    invariants::require(
        gcv_scene_relation(scene_, asked_.moving, position, 1, &query_, nullptr, &relation),
        "a relation");
    append(bytes, relation);
    gcv_separation separation{};
    append(bytes,
           gcv_scene_distance(scene_, asked_.moving, position, 1, &query_, nullptr, &separation));
    rename(separation.nearest, names_);
    append(bytes, separation);
    gcv_impact impact{};
    append(bytes, gcv_scene_cast(scene_, asked_.moving, position, asked_.motions[k].data(), 1,
                                 &query_, nullptr, &impact));
    rename(impact.contact, names_);
    append(bytes, impact);
  }

  const gcv_scene* scene_;
  const Asked& asked_;
  const Name& names_;
  std::vector<Id> ignored_;
  gcv_query query_ GCV_QUERY_INIT;
};

// ---- Scenes and what they must consist of

struct Member {
  std::size_t shape;
  Point position;
  std::uint32_t layers;
};

// What a scene must consist of.
struct Members {
  std::map<Id, Member> by_id;
  Id last = 1;  // id that was given
  std::optional<std::size_t> container;
};

inline invariants::SceneHandle new_scene() {
  gcv_scene* scene = nullptr;
  invariants::require(gcv_scene_create(&scene), "a scene");
  return invariants::SceneHandle(scene);
}

// The same members in a new scene; the names of its ids are the ids in the changed one.
inline invariants::SceneHandle made_afresh(const Members& members,
                                           const std::vector<invariants::PolygonHandle>& shapes,
                                           Name& names) {
  invariants::SceneHandle scene = new_scene();
  for (const auto& [name, member] : members.by_id) {
    const gcv_polygon* const polygon = shapes[member.shape].get();
    Id id = 0;
    invariants::require(gcv_scene_add(scene.get(), &polygon, member.position.data(), 1, &id),
                        "a member");
    invariants::require(gcv_scene_set_layers(scene.get(), &id, &member.layers, 1), "layers");
    names[id] = name;
  }
  if (members.container) {
    invariants::require(gcv_scene_set_container(scene.get(), shapes[*members.container].get()),
                        "a container");
  }
  return scene;
}

struct EarlierLists {
  Owner<gcv_pair_list> pairs;
  Owner<gcv_contact_list> contacts;
};

// Lists with earlier ones are as without, and as in the scene that was made afresh. Gives them,
// too.
inline std::string list_difference(const Asker& asker, const Asker& fresh,
                                   const EarlierLists& earlier, EarlierLists& lists) {
  EarlierLists unused;
  EarlierLists with;
  const std::string pairs = fresh.pairs(nullptr, unused.pairs);
  if (asker.pairs(nullptr, unused.pairs) != pairs) {
    return "other pairs";
  }
  if (asker.pairs(earlier.pairs.get(), with.pairs) != pairs) {
    return "other pairs with an earlier list";
  }
  const std::string contacts = fresh.contacts(nullptr, unused.contacts);
  if (asker.contacts(nullptr, unused.contacts) != contacts) {
    return "other contacts";
  }
  if (asker.contacts(earlier.contacts.get(), with.contacts) != contacts) {
    return "other contacts with an earlier list";
  }
  lists.pairs = std::move(with.pairs);
  if (with.contacts) {
    lists.contacts = std::move(with.contacts);
  }
  return "";
}

// What the scene answers otherwise than one that is made afresh: "" if nothing. Gives new lists.
inline std::string difference(const gcv_scene* scene, const Members& members,
                              const std::vector<invariants::PolygonHandle>& shapes,
                              const Asked& asked, const EarlierLists& earlier,
                              EarlierLists& lists) {
  Name same;
  std::vector<Id> ids;
  for (const auto& [id, member] : members.by_id) {
    same[id] = id;
    ids.push_back(id);
  }
  Name names;
  const invariants::SceneHandle fresh = made_afresh(members, shapes, names);
  const Asker asker(scene, asked, same);
  const Asker fresh_asker(fresh.get(), asked, names);
  if (invariants::elements(gcv_scene_ids, scene) != ids) {
    return "other members";
  }
  if (asker.about_moving() != fresh_asker.about_moving()) {
    return "another answer about the moving polygon";
  }
  return list_difference(asker, fresh_asker, earlier, lists);
}

}  // namespace gcv::test

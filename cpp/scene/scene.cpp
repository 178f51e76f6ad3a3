// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene.hpp"

#include <algorithm>
#include <atomic>
#include <cinttypes>
#include <utility>

#include "error.hpp"
#include "placed_box.hpp"

namespace gcv {

namespace {

Box box_of(const Polygon& polygon, const Point& position) {
  return moved_outwards(polygon.outer.bounds, position);
}

}  // namespace

std::uint64_t next_stamp() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

Scene::Scene() : family_(next_stamp()) {}

void Scene::set_container(const Polygon* container) {
  container_ = container == nullptr
                   ? nullptr
                   : std::make_shared<const Boundary>(container->boundary().complement());
  container_stamp_ = next_stamp();
  forget();
}

Id Scene::add(std::vector<std::shared_ptr<const Polygon>> polygons,
              std::span<const Point> positions) {
  const Id first = next_id_;
  if (polygons.empty()) {
    return first;
  }
  tidy();
  if (polygons.size() > BoxForest::no_slot - members_.size()) {
    throw Error(Status::invalid_argument, "%zu members are too many",
                members_.size() + polygons.size());
  }
  const auto first_slot = static_cast<std::uint32_t>(members_.size());
  const auto slots = static_cast<std::uint32_t>(members_.size() + polygons.size());
  std::vector<BoxForest::Change> changes(polygons.size());
  for (std::uint32_t k = 0; k < polygons.size(); ++k) {
    changes[k] = {first_slot + k, box_of(*polygons[k], positions[k])};
  }
  if (members_.capacity() < slots) {
    members_.reserve(std::max<std::size_t>(slots, members_.size() + members_.size() / 2));
  }
  BoxForest::Prepared prepared = boxes_.prepare(changes, slots);
  boxes_.apply(prepared);
  const std::uint64_t stamp = next_stamp();
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    members_.push_back({next_id_++, std::move(polygons[k]), positions[k], stamp, all_layers});
  }
  size_ += polygons.size();
  kept_solids_.clear();
  return first;
}

void Scene::set(std::span<const Id> ids, std::span<const std::shared_ptr<const Polygon>> polygons,
                std::span<const Point> positions) {
  if (polygons.empty() && positions.empty()) {
    static_cast<void>(named(ids));
    return;
  }
  tidy();
  const std::vector<Named> all = named(ids);
  std::vector<BoxForest::Change> changes;
  changes.reserve(all.size());
  for (const auto& [slot, k] : all) {
    const Polygon& polygon = polygons.empty() ? *members_[slot].polygon : *polygons[k];
    changes.push_back(
        {slot, box_of(polygon, positions.empty() ? members_[slot].position : positions[k])});
  }
  BoxForest::Prepared prepared =
      boxes_.prepare(changes, static_cast<std::uint32_t>(members_.size()));
  boxes_.apply(prepared);
  const std::uint64_t stamp = next_stamp();
  for (const auto& [slot, k] : all) {
    Member& member = members_[slot];
    member.polygon = polygons.empty() ? member.polygon : polygons[k];
    member.position = positions.empty() ? member.position : positions[k];
    member.stamp = stamp;
  }
  forget();
}

void Scene::set_layers(std::span<const Id> ids, std::span<const std::uint32_t> layers) {
  const std::uint64_t stamp = next_stamp();
  for (const auto& [slot, k] : named(ids)) {
    members_[slot].layers = layers[k];
    members_[slot].stamp = stamp;
  }
  forget();
}

void Scene::remove(std::span<const Id> ids) {
  if (ids.empty()) {
    return;
  }
  tidy();
  const std::vector<Named> all = named(ids);
  std::vector<BoxForest::Change> changes;
  changes.reserve(all.size());
  for (const Named& name : all) {
    changes.push_back({name.slot, empty_box});
  }
  BoxForest::Prepared prepared =
      boxes_.prepare(changes, static_cast<std::uint32_t>(members_.size()));
  boxes_.apply(prepared);
  for (const Named& name : all) {
    members_[name.slot].polygon = nullptr;
  }
  size_ -= all.size();
  forget();
}

// Removed members are dropped when they are more than those that are there. The order stays.
void Scene::tidy() {
  if (members_.size() > 2 * size_) {
    std::vector<std::uint32_t> to(members_.size(), 0);
    std::uint32_t count = 0;
    for (std::size_t slot = 0; slot < members_.size(); ++slot) {
      if (members_[slot].polygon != nullptr) {
        to[slot] = count++;
      }
    }
    std::erase_if(members_, [](const Member& member) { return member.polygon == nullptr; });
    boxes_.renumber(to, count);
  }
  boxes_.tidy();
}

std::optional<std::uint32_t> Scene::find(Id id) const {
  const auto found = std::lower_bound(members_.begin(), members_.end(), id,
                                      [](const Member& member, Id i) { return member.id < i; });
  if (found == members_.end() || found->id != id || found->polygon == nullptr) {
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(found - members_.begin());
}

std::vector<Scene::Named> Scene::named(std::span<const Id> ids) const {
  std::vector<Named> all;
  all.reserve(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const std::optional<std::uint32_t> slot = find(ids[k]);
    if (!slot) {
      throw Error(Status::invalid_argument, "ids: number %zu is %" PRIu64 ", %s", k, ids[k],
                  ids[k] == container_id ? "the container's, not that of a member"
                                         : "not that of a member");
    }
    all.push_back({*slot, k});
  }
  const auto is_before = [](const Named& p, const Named& q) {
    return p.slot != q.slot ? p.slot < q.slot : p.number < q.number;
  };
  if (!std::is_sorted(all.begin(), all.end(), is_before)) {
    std::sort(all.begin(), all.end(), is_before);
  }
  const auto twice = std::adjacent_find(
      all.begin(), all.end(), [](const Named& p, const Named& q) { return p.slot == q.slot; });
  if (twice != all.end()) {
    throw Error(Status::invalid_argument, "ids: number %zu is %" PRIu64 ", as number %zu is",
                (twice + 1)->number, ids[twice->number], twice->number);
  }
  return all;
}

const Member& Scene::member(Id id) const {
  const std::optional<std::uint32_t> slot = find(id);
  if (!slot) {
    throw Error(
        Status::invalid_argument, "id is %" PRIu64 ", %s", id,
        id == container_id ? "the container's, not that of a member" : "not that of a member");
  }
  return members_[*slot];
}

std::vector<Point> Scene::positions(std::span<const Id> ids) const {
  std::vector<Point> positions(ids.size());
  for (const auto& [slot, k] : named(ids)) {
    positions[k] = members_[slot].position;
  }
  return positions;
}

std::optional<Solid> Scene::container() const {
  return container_ == nullptr ? std::nullopt
                               : std::optional(Solid{container_id, *container_, {0, 0}});
}

std::size_t Scene::bytes() const {
  return members_.capacity() * sizeof(Member) + boxes_.bytes() + known_bests_.bytes();
}

}  // namespace gcv

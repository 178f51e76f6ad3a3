// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pairs of solids of a scene whose boxes are near each other, shared by the threads of a task.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "parallel.hpp"
#include "placed_box.hpp"
#include "query.hpp"
#include "snapshot.hpp"
#include "task.hpp"

namespace gcv {

class PairSearch {
 public:
  // Leaves out pairs of solids that are both unchanged.
  PairSearch(const Scene& scene, const Query& query, const Unchanged& unchanged, double distance)
      : scene_(scene), query_(query), unchanged_(unchanged), distance_(distance) {
    for (std::uint32_t slot = 0; slot < scene.members().size(); ++slot) {
      if (query.admits(scene.members()[slot])) {
        all_.push_back(slot);
        if (!unchanged.has_slot(slot)) {
          changed_.push_back(slot);
        }
      }
    }
  }

  // Calls visit(results, a, b) for pairs of solids, at least for those that are no further than the
  // distance, each once, with a.id < b.id. `results` is a vector of one thread. Returns all
  // results. If nothing is unchanged, they are in the order of the pairs; they always are in the
  // same one, whatever the threads. Members are the steps of the task. Throws Error: cancelled.
  template <class Result, class Visit>
  [[nodiscard]] std::vector<Result> run(Task& task, Visit visit) const {
    const std::optional<Solid> container =
        query_.admits_container() ? scene_.container() : std::nullopt;
    const Slots& beside_container = unchanged_.has_container() ? changed_ : all_;
    const std::size_t container_blocks = container ? blocks_of(beside_container) : 0;
    const std::size_t blocks = container_blocks + blocks_of(changed_);
    std::vector<std::vector<Result>> results(blocks);
    task.begin(blocks * slots_a_block);
    for_each_in_parallel(
        blocks, task.threads(),
        [&](std::size_t block) {
          task.advance(0);  // other threads go on after one that was cancelled
          std::vector<Result>& found = results[block];
          if (block < container_blocks) {
            for (const std::uint32_t slot : part(beside_container, block)) {
              visit(found, *container, scene_.solid(slot));
            }
          } else {
            visit_members(part(changed_, block - container_blocks),
                          [&](const Solid& a, const Solid& b) { visit(found, a, b); });
          }
          task.advance(slots_a_block);
        },
        [&] { task.watch(); });
    task.finish();
    std::vector<Result> all;
    for (const std::vector<Result>& found : results) {
      all.insert(all.end(), found.begin(), found.end());
    }
    return all;
  }

 private:
  using Slots = std::vector<std::uint32_t>;
  static constexpr std::size_t slots_a_block = 256;

  static std::size_t blocks_of(const Slots& slots) {
    return (slots.size() + slots_a_block - 1) / slots_a_block;
  }
  static std::span<const std::uint32_t> part(const Slots& slots, std::size_t block) {
    const std::size_t first = block * slots_a_block;
    return std::span(slots).subspan(first, std::min(slots_a_block, slots.size() - first));
  }

  template <class Visit>
  void visit_members(std::span<const std::uint32_t> slots, Visit visit) const {
    Slots others;  // near one of them
    for (const std::uint32_t slot : slots) {
      const Solid solid = scene_.solid(slot);
      const Box box =
          widened_outwards(moved_outwards(solid.boundary.bounds, solid.position), distance_);
      others.clear();
      any_near(scene_, query_, box, [&](std::uint32_t other) {
        if (other > slot || (other < slot && unchanged_.has_slot(other))) {
          others.push_back(other);
        }
        return false;
      });
      std::sort(others.begin(), others.end());
      for (const std::uint32_t other : others) {
        if (other > slot) {
          visit(solid, scene_.solid(other));
        } else {
          visit(scene_.solid(other), solid);
        }
      }
    }
  }

  const Scene& scene_;
  const Query& query_;
  const Unchanged& unchanged_;
  const double distance_;
  Slots all_;  // that the query admits
  Slots changed_;
};

}  // namespace gcv

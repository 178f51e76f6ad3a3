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
      : scene_(scene),
        distance_(distance),
        container_(query.admits_container() ? scene.container() : std::nullopt),
        container_is_changed_(!unchanged.has_container()),
        kinds_(scene.members().size(), Kind::left_out) {
    for (std::uint32_t slot = 0; slot < kinds_.size(); ++slot) {
      if (query.admits(scene.members()[slot])) {
        all_.push_back(slot);
        if (unchanged.has_slot(slot)) {
          kinds_[slot] = Kind::unchanged;
        } else {
          kinds_[slot] = Kind::changed;
          changed_.push_back(slot);
        }
      }
    }
  }

  // Calls visit(results, a, b) for pairs of solids, at least for those that are no further than the
  // distance, each once, with a.id < b.id. `results` is a vector of one thread. Returns all
  // results, in the same order for any number of threads. Blocks of members are the steps of the
  // task. Throws Error: cancelled.
  template <class Result, class Visit>
  [[nodiscard]] std::vector<Result> run(Task& task, Visit visit) const {
    // Where few members have changed, each of them looks for those near it. Else all pairs of boxes
    // are looked for at once.
    const bool are_few = changed_.size() < all_.size() / 2;
    const std::vector<BoxForest::Part> parts =
        are_few ? std::vector<BoxForest::Part>() : scene_.boxes().parts();
    const Slots& beside_container = container_is_changed_ ? all_ : changed_;
    const std::size_t container_blocks = container_ ? blocks_of(beside_container) : 0;
    const std::size_t blocks = container_blocks + (are_few ? blocks_of(changed_) : parts.size());
    std::vector<std::vector<Result>> results(blocks);
    task.begin(blocks * slots_a_block);
    for_each_in_parallel(
        blocks, task.threads(),
        [&](std::size_t block) {
          task.advance(0);  // other threads go on after one that was cancelled
          const auto visit_solids = [&](const Solid& a, const Solid& b) {
            visit(results[block], a, b);
          };
          if (block < container_blocks) {
            for (const std::uint32_t slot : block_of(beside_container, block)) {
              visit_solids(*container_, scene_.solid(slot));
            }
          } else if (are_few) {
            visit_near(block_of(changed_, block - container_blocks), visit_solids);
          } else {
            visit_part(parts[block - container_blocks], visit_solids);
          }
          task.advance(slots_a_block);
        },
        [&] { task.watch(); });
    task.finish();
    std::size_t count = 0;
    for (const std::vector<Result>& found : results) {
      count += found.size();
    }
    std::vector<Result> all;
    all.reserve(count);
    for (const std::vector<Result>& found : results) {
      all.insert(all.end(), found.begin(), found.end());
    }
    return all;
  }

 private:
  using Slots = std::vector<std::uint32_t>;
  static constexpr std::size_t slots_a_block = 256;

  enum class Kind : std::uint8_t { left_out, unchanged, changed };

  static std::size_t blocks_of(const Slots& slots) {
    return (slots.size() + slots_a_block - 1) / slots_a_block;
  }
  static std::span<const std::uint32_t> block_of(const Slots& slots, std::size_t block) {
    const std::size_t first = block * slots_a_block;
    return std::span(slots).subspan(first, std::min(slots_a_block, slots.size() - first));
  }

  template <class Visit>
  void visit_in_order(std::uint32_t p, std::uint32_t q, Visit visit) const {
    visit(scene_.solid(std::min(p, q)), scene_.solid(std::max(p, q)));
  }
  // The pairs of some changed members; of two changed ones those with a later member.
  template <class Visit>
  void visit_near(std::span<const std::uint32_t> slots, Visit visit) const {
    for (const std::uint32_t slot : slots) {
      const Solid solid = scene_.solid(slot);
      const Box box =
          widened_outwards(moved_outwards(solid.boundary.bounds, solid.position), distance_);
      const auto visit_other = [&](std::uint32_t other) {
        if (kinds_[other] == Kind::unchanged || (kinds_[other] == Kind::changed && other > slot)) {
          visit_in_order(slot, other, visit);
        }
        return false;
      };
      NearBoxes search(box, visit_other);
      scene_.boxes().search(search);
    }
  }
  template <class Visit>
  void visit_part(const BoxForest::Part& part, Visit visit) const {
    scene_.boxes().visit_pairs(part, distance_, [&](std::uint32_t p, std::uint32_t q) {
      if (kinds_[p] != Kind::left_out && kinds_[q] != Kind::left_out &&
          (kinds_[p] == Kind::changed || kinds_[q] == Kind::changed)) {
        visit_in_order(p, q, visit);
      }
    });
  }

  const Scene& scene_;
  const double distance_;
  const std::optional<Solid> container_;
  const bool container_is_changed_;
  std::vector<Kind> kinds_;  // of each slot
  Slots all_;                // that the query admits
  Slots changed_;
};

}  // namespace gcv

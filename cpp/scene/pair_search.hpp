// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pairs of solids of a scene whose boxes are near each other, shared by the threads of a task.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler.hpp"
#include "parallel.hpp"
#include "placed_box.hpp"
#include "query.hpp"
#include "snapshot.hpp"
#include "task.hpp"

namespace gcv {

// Pairs of members that wait for a visit, while what it reads of their polygons is fetched.
template <class Visit>
class PairQueue {
 public:
  PairQueue(const Scene& scene, Visit& visit) : scene_(scene), visit_(visit) {}

  void add(std::uint32_t p, std::uint32_t q) {
    if (count_ == pairs_.size()) {
      visit_all();
    }
    pairs_[count_++] = {std::min(p, q), std::max(p, q)};
    for (const std::uint32_t slot : {p, q}) {
      const Polygon& polygon = *scene_.members()[slot].polygon;
      prefetch(&polygon.outer.vertices);
      prefetch(&polygon.outer.bounds.x0);
      prefetch(&polygon.outer.bounds.y1);
      prefetch(&polygon.holes);
    }
  }
  void visit_all() {
    constexpr std::size_t ahead = 8;
    for (std::size_t k = 0; k < count_ + ahead; ++k) {
      if (k < count_) {
        prefetch(scene_.solid(pairs_[k].p).boundary.vertices.data());
        prefetch(scene_.solid(pairs_[k].q).boundary.vertices.data());
      }
      if (k >= ahead) {
        const Pair& pair = pairs_[k - ahead];
        visit_(scene_.solid(pair.p), scene_.solid(pair.q));
      }
    }
    count_ = 0;
  }

 private:
  struct Pair {
    std::uint32_t p;
    std::uint32_t q;
  };

  const Scene& scene_;
  Visit& visit_;
  std::array<Pair, 128> pairs_;
  std::size_t count_ = 0;
};

class PairSearch {
 public:
  // Leaves out pairs of solids that are both unchanged.
  PairSearch(const Scene& scene, const Query& query, const Unchanged& unchanged, double distance)
      : scene_(scene),
        query_(query),
        unchanged_(unchanged),
        distance_(distance),
        container_(query.admits_container() ? scene.container() : std::nullopt),
        changed_(slots([&](std::uint32_t slot) { return !unchanged.has_slot(slot); })) {}

  // Calls visit(results, a, b) for pairs of solids, at least for those that are no further than the
  // distance, each once, with a.id < b.id. `results` is a vector of one thread. Returns all
  // results, in the same order for any number of threads. Blocks of members are the steps of the
  // task. Throws Error: cancelled.
  template <class Result, class Visit>
  [[nodiscard]] std::vector<Result> run(Task& task, Visit visit) const {
    // Where few members have changed, each of them looks for those near it. Else all pairs of boxes
    // are looked for at once.
    const bool are_few = changed_.size() < scene_.size() / 2;
    const std::vector<BoxForest::Part> parts =
        are_few ? std::vector<BoxForest::Part>() : scene_.boxes().parts();
    const Slots beside_container = !container_                  ? Slots()
                                   : unchanged_.has_container() ? changed_
                                                                : slots([](auto) { return true; });
    const std::size_t container_blocks = blocks_of(beside_container);
    const std::size_t blocks = container_blocks + (are_few ? blocks_of(changed_) : parts.size());
    std::vector<std::vector<Result>> results(blocks);
    task.begin(blocks * slots_a_block);
    for_each_in_parallel(
        blocks, task.threads(),
        [&](std::size_t block) {
          task.advance(0);  // other threads go on after one that was cancelled
          Pace pace;
          const auto visit_solids = [&](const Solid& a, const Solid& b) {
            pace.step(16 + (std::uint64_t{a.boundary.size()} + b.boundary.size()) / 2);
            visit(results[block], a, b);
          };
          if (block < container_blocks) {
            for (const std::uint32_t slot : block_of(beside_container, block)) {
              visit_solids(*container_, scene_.solid(slot));
            }
          } else {
            PairQueue queue(scene_, visit_solids);
            if (are_few) {
              add_near(block_of(changed_, block - container_blocks), queue);
            } else {
              add_part(parts[block - container_blocks], queue);
            }
            queue.visit_all();
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
  static constexpr std::size_t slots_a_block = 64;

  // Those that the query admits, of which is_wanted(slot) is true.
  template <class IsWanted>
  [[nodiscard]] Slots slots(IsWanted is_wanted) const {
    Slots found;
    for (std::uint32_t slot = 0; slot < scene_.members().size(); ++slot) {
      if (is_wanted(slot) && is_admitted(slot)) {
        found.push_back(slot);
      }
    }
    return found;
  }
  [[nodiscard]] bool is_admitted(std::uint32_t slot) const {
    return unchanged_.has_slot(slot) || query_.admits(scene_.members()[slot]);
  }

  static std::size_t blocks_of(const Slots& slots) {
    return (slots.size() + slots_a_block - 1) / slots_a_block;
  }
  static std::span<const std::uint32_t> block_of(const Slots& slots, std::size_t block) {
    const std::size_t first = block * slots_a_block;
    return std::span(slots).subspan(first, std::min(slots_a_block, slots.size() - first));
  }

  // Adds the pairs of some changed members; of two changed ones those with a later member.
  template <class Queue>
  void add_near(std::span<const std::uint32_t> slots, Queue& queue) const {
    for (const std::uint32_t slot : slots) {
      const Solid solid = scene_.solid(slot);
      const Box box =
          widened_outwards(moved_outwards(solid.boundary.bounds, solid.position), distance_);
      const auto add_other = [&](std::uint32_t other) {
        if ((other > slot || unchanged_.has_slot(other)) && is_admitted(other)) {
          queue.add(slot, other);
        }
        return false;
      };
      NearBoxes search(box, add_other);
      scene_.boxes().search(search);
    }
  }
  template <class Queue>
  void add_part(const BoxForest::Part& part, Queue& queue) const {
    scene_.boxes().visit_pairs(part, distance_, [&](std::uint32_t p, std::uint32_t q) {
      if (!(unchanged_.has_slot(p) && unchanged_.has_slot(q)) && is_admitted(p) && is_admitted(q)) {
        queue.add(p, q);
      }
    });
  }

  const Scene& scene_;
  const Query& query_;
  const Unchanged& unchanged_;
  const double distance_;
  const std::optional<Solid> container_;
  const Slots changed_;  // of those that the query admits
};

}  // namespace gcv

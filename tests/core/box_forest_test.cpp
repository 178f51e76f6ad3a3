// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The forest over boxes against a list of them: what searches and pairs find, after changes of all
// kinds.
#include "box_forest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "box.hpp"
#include "pair_descent.hpp"
#include "polygon.hpp"
#include "scene.hpp"

namespace gcv {
namespace {

using Slot = BoxForest::Slot;

// Numbers below a limit.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(engine_() % limit); }

 private:
  std::mt19937 engine_;
};

bool is_empty(const Box& box) { return box.x0 > box.x1; }

// A forest, and the same boxes in a list.
class Pair {
 public:
  explicit Pair(double unit) : unit_(unit) {}

  void change(std::map<Slot, Box> boxes) {
    forest_.tidy();
    std::vector<BoxForest::Change> changes;
    for (const auto& [slot, box] : boxes) {
      changes.push_back({slot, box});
      boxes_.resize(std::max<std::size_t>(boxes_.size(), slot + 1), empty_box);
      boxes_[slot] = box;
    }
    BoxForest::Prepared prepared = forest_.prepare(changes, static_cast<Slot>(boxes_.size()));
    forest_.apply(prepared);
  }

  // Drops the slots without a box.
  void renumber() {
    std::vector<Slot> to(boxes_.size(), 0);
    Slot count = 0;
    for (Slot slot = 0; slot < boxes_.size(); ++slot) {
      if (!is_empty(boxes_[slot])) {
        to[slot] = count++;
      }
    }
    std::erase_if(boxes_, is_empty);
    forest_.renumber(to, count);
  }

  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }
  [[nodiscard]] Box random_box(Random& random, double size) const {
    const auto number = [&](double limit) {
      return std::floor(limit * (random.below(1024) / 1024.0));
    };
    const double x = number(40);
    const double y = number(40);
    return {unit_ * x, unit_ * y, unit_ * (x + 1 + number(size)), unit_ * (y + 1 + number(size))};
  }

  // Compares what is found with the list. Pairs of boxes that are near each other are found once.
  void check(const Box& place, double distance) const {
    std::vector<Slot> expected;
    std::vector<std::pair<Slot, Slot>> expected_pairs;
    for (Slot p = 0; p < boxes_.size(); ++p) {
      if (!is_empty(boxes_[p]) && !are_apart(boxes_[p], place)) {
        expected.push_back(p);
      }
      for (Slot q = p + 1; q < boxes_.size(); ++q) {
        if (!is_empty(boxes_[p]) && !is_empty(boxes_[q]) &&
            !are_apart(widened(boxes_[p], distance), boxes_[q])) {
          expected_pairs.emplace_back(p, q);
        }
      }
    }
    EXPECT_EQ(found(place), expected);
    EXPECT_EQ(pairs(distance), expected_pairs);
  }

 private:
  struct Collector {
    template <class Visit>
    bool any_child(const ChainTree::Block& block, Visit visit) {
      for_each_lane(block.overlapping(box) & children_of(block), visit);
      return false;
    }
    bool meet(Slot slot) {
      slots.push_back(slot);
      return false;
    }

    Box box;
    std::vector<Slot> slots = {};
  };

  [[nodiscard]] std::vector<Slot> found(const Box& box) const {
    Collector collector{box};
    forest_.search(collector);
    std::sort(collector.slots.begin(), collector.slots.end());
    return collector.slots;
  }
  [[nodiscard]] std::vector<std::pair<Slot, Slot>> pairs(double distance) const {
    std::vector<std::pair<Slot, Slot>> result;
    for (const BoxForest::Part& part : forest_.parts()) {
      forest_.visit_pairs(part, distance, [&](Slot p, Slot q) {
        result.emplace_back(std::min(p, q), std::max(p, q));
      });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  double unit_;
  BoxForest forest_;
  std::vector<Box> boxes_;
};

class BoxForests : public testing::TestWithParam<double> {};

TEST_P(BoxForests, HaveTheBoxesOfAListAfterChanges) {
  Random random(1);
  const double unit = GetParam();
  for (int round = 0; round < 20; ++round) {
    Pair pair(unit);
    for (int step = 0; step < 60; ++step) {
      std::map<Slot, Box> boxes;
      const auto count = static_cast<Slot>(pair.boxes().size());
      const std::uint32_t size = random.below(8) == 0 ? random.below(200) : random.below(6);
      for (Slot k = 0; k < size; ++k) {
        const std::uint32_t kind = random.below(4);
        const Slot old = count == 0 ? 0 : random.below(count);
        if (kind == 0 || count == 0) {
          boxes[count + k] = pair.random_box(random, 4);
        } else if (kind == 1) {
          boxes[old] = empty_box;
        } else if (!is_empty(pair.boxes()[old])) {
          // Far, or a little beside.
          const Box& box = pair.boxes()[old];
          boxes[old] = kind == 2 ? pair.random_box(random, 30)
                                 : Box{box.x0 + unit, box.y0, box.x1 + unit, box.y1 + unit};
        }
      }
      pair.change(boxes);
      if (random.below(8) == 0) {
        pair.renumber();
      }
      pair.check(pair.random_box(random, 10), unit * random.below(3));
    }
  }
}

// Parts of many nodes, and trees of all sizes.
TEST_P(BoxForests, HaveAllPairsOfManyBoxes) {
  Random random(2);
  Pair pair(GetParam());
  for (const Slot size : {3000U, 700U, 100U, 9U, 1U}) {
    std::map<Slot, Box> boxes;
    const auto first = static_cast<Slot>(pair.boxes().size());
    for (Slot k = 0; k < size; ++k) {
      boxes[first + k] = pair.random_box(random, 2);
    }
    pair.change(boxes);
    pair.check(pair.random_box(random, 10), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Units, BoxForests, testing::Values(1.0, 0x1p-1060, 0x1p1015));

// Beside what the polygons take.
TEST(Scene, TakesFewBytesAMember) {
  constexpr std::size_t count = 100000;
  const auto polygon =
      std::make_shared<const Polygon>(PointVector{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "polygon");
  const std::vector<std::shared_ptr<const Polygon>> polygons(count, polygon);
  std::vector<Point> positions;
  for (std::size_t k = 0; k < count; ++k) {
    positions.push_back({static_cast<double>(k % 317), static_cast<double>(k / 317)});
  }
  Scene scene;
  scene.add(polygons, positions);
  EXPECT_LT(scene.bytes(), 120 * count);
  // One after the other, they may take more.
  Scene other;
  for (std::size_t k = 0; k < count; ++k) {
    other.add({polygon}, std::span(positions).subspan(k, 1));
  }
  EXPECT_LT(other.bytes(), 160 * count);
}

}  // namespace
}  // namespace gcv

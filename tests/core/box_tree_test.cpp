// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boxes near a box, and around it, beside a loop over all of them.
#include "box_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "generators.hpp"

namespace gcv {
namespace {

using test::Random;

Box random_box(Random& random, int most) {
  const auto low = [&] { return static_cast<double>(test::uniform(random, 0, 100)); };
  const auto size = [&] { return static_cast<double>(test::uniform(random, 0, most)); };
  const double x = low();
  const double y = low();
  return {x, y, x + size(), y + size()};
}

std::vector<std::uint32_t> near_in(const BoxTree& tree, const Box& box) {
  std::vector<std::uint32_t> found;
  tree.for_each_near(box, [&](std::uint32_t k, const Box&) { found.push_back(k); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::uint32_t> around_in(const BoxTree& tree, const Box& box) {
  std::vector<std::uint32_t> found;
  EXPECT_FALSE(tree.any_around(box, [&](std::uint32_t k, const Box&) {
    found.push_back(k);
    return false;
  }));
  std::sort(found.begin(), found.end());
  return found;
}

template <class Test>
std::vector<std::uint32_t> all_of(const std::vector<Box>& boxes, Test test) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    if (test(boxes[k])) {
      found.push_back(k);
    }
  }
  return found;
}

TEST(BoxTree, FindsWhatALoopFinds) {
  Random random(411);
  std::size_t near = 0;
  std::size_t around = 0;
  for (int count = 0; count < 260; count = count < 30 ? count + 1 : 2 * count) {
    std::vector<Box> boxes;
    for (int k = 0; k < count; ++k) {
      boxes.push_back(random_box(random, 30));
    }
    const BoxTree tree(boxes);
    for (int k = 0; k < 50; ++k) {
      const Box box = random_box(random, 8);
      const auto expected_near = all_of(boxes, [&](const Box& b) { return !are_apart(b, box); });
      const auto expected_around = all_of(boxes, [&](const Box& b) {
        return b.x0 <= box.x0 && b.y0 <= box.y0 && b.x1 >= box.x1 && b.y1 >= box.y1;
      });
      ASSERT_EQ(near_in(tree, box), expected_near);
      ASSERT_EQ(around_in(tree, box), expected_around);
      near += expected_near.size();
      around += expected_around.size();
      if (!expected_around.empty()) {
        const std::uint32_t last = expected_around.back();
        ASSERT_TRUE(tree.any_around(box, [&](std::uint32_t n, const Box& b) {
          return n == last && b.x0 == boxes[n].x0 && b.y1 == boxes[n].y1;
        }));
      }
    }
  }
  EXPECT_GT(near, 1000U);
  EXPECT_GT(around, 500U);
}

TEST(BoxTree, TakesWhatIsNotANumberForThePlane) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Box> boxes(40, Box{0, 0, 1, 1});
  boxes[17] = {0, nan, 1, 1};
  boxes[3] = {nan, nan, nan, nan};
  const BoxTree tree(boxes);
  EXPECT_EQ(near_in(tree, {50, 50, 51, 51}), (std::vector<std::uint32_t>{3, 17}));
  EXPECT_EQ(around_in(tree, {-9, 50, 51, 51}), (std::vector<std::uint32_t>{3, 17}));
}

}  // namespace
}  // namespace gcv

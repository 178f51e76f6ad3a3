// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is known of real pairs, those of the paper among them. The polygons are not part of the
// project: where they are missing, every test here is skipped.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "agreement.hpp"
#include "boundary.hpp"
#include "data.hpp"
#include "minkowski_sum.hpp"
#include "task.hpp"

namespace gcv {
namespace {

class RealPairs : public testing::Test {
 protected:
  void SetUp() override {
    const auto directory = test::data_directory();
    if (!directory) {
      GTEST_SKIP() << "no polygon data: set GCV_DATA_DIR";
    }
    pairs_ = test::read_pairs(*directory);
  }

  // Checks a size of each pair that it is known of.
  template <class SizeOf>
  void expect(const std::map<std::string, std::size_t>& sizes, SizeOf size_of) {
    std::size_t found = 0;
    for (const test::NamedPair& pair : pairs_) {
      if (const auto size = sizes.find(pair.name); size != sizes.end()) {
        EXPECT_EQ(size_of(make_ring(pair.a, "a"), make_ring(pair.b, "b")), size->second)
            << pair.name;
        ++found;
      }
    }
    EXPECT_EQ(found, sizes.size());
  }

  std::vector<test::NamedPair> pairs_;
};

TEST_F(RealPairs, SupersetsHaveThePapersCounts) {
  expect({{"stars", 371}, {"comb", 80}, {"fork", 331}, {"knife", 211}},
         [](const Boundary& a, const Boundary& b) { return superset(a, b).size(); });
}

TEST_F(RealPairs, OuterFacesHaveTheKnownSizes) {
  expect({{"fork", 178}, {"monkey-heron", 974}}, [](const Boundary& a, const Boundary& b) {
    Task task;
    return minkowski_sum({std::make_shared<Boundary>(a), "a"}, {std::make_shared<Boundary>(b), "b"},
                         {0, 0}, Rounding::nearest, task)
        .exact.size();
  });
}

TEST_F(RealPairs, AgreeWithTheReference) {
  int compared = 0;
  for (const test::NamedPair& pair : pairs_) {
    if (pair.a.size() < 300 && pair.b.size() < 300) {
      SCOPED_TRACE(pair.name);
      reference::expect_agreement(pair.a, pair.b);
      ++compared;
    }
  }
  std::printf("%d real pairs\n", compared);
  EXPECT_GE(compared, 15);
}

}  // namespace
}  // namespace gcv

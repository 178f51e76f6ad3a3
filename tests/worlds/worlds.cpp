// SPDX-License-Identifier: LGPL-3.0-or-later
//
// worlds SHARD OF [FAMILY...]: compares one of OF shares of the families with the definitions: of
// those that are named, or of those that are usual. Prints a line for each: its name, cases,
// answers, differences, and seconds of a core.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "catalogue.hpp"
#include "compare.hpp"

namespace {

using namespace worlds;

// Samples.
constexpr std::uint64_t kFigures = 20'000;
constexpr std::uint64_t kHoles = 20'000;
constexpr std::uint64_t kScenes = 2'000;

struct Shard {
  std::uint64_t number;
  std::uint64_t of;
  [[nodiscard]] bool has(std::uint64_t k) const { return k % of == number; }
};

void compare_all(const Shard& shard, int grid, int corners, Report& report) {
  const Catalogue catalogue(grid, corners);
  std::deque<Operand> operands;
  for (const Ring& ring : catalogue.rings()) {
    operands.emplace_back(Polygon{ring});
  }
  std::uint64_t number = 0;
  visit_pairs(catalogue.images(), [&](std::size_t i, std::size_t j) {
    if (shard.has(number++)) {
      compare_pair(operands[i], operands[j], report);
    }
  });
}

void compare_squares(const Shard& shard, int box, int other_box, Report& report) {
  const SquareFigures a(box);
  const SquareFigures b(other_box);
  std::uint64_t number = 0;
  visit_pairs(a.images, b.images, [&](std::size_t i, std::size_t j) {
    if (shard.has(number++)) {
      compare_pair(Operand(a.figures[i]), Operand(b.figures[j]), report);
    }
  });
}

void compare_figures(const Shard& shard, Report& report) {
  for (std::uint64_t k = shard.number; k < kFigures; k += shard.of) {
    Random random(k);
    const Figure a = random_figure(random, 4);
    compare_pair(Operand(a), Operand(random_figure(random, k % 8 == 0 ? 3 : 2)), report);
  }
}

// Twice as large.
Polygon doubled(Polygon polygon) {
  for (Ring& ring : polygon) {
    for (Point& p : ring) {
      p = 2 * p;
    }
  }
  return polygon;
}

void compare_refused(const std::vector<Polygon>& refused, Report& report) {
  for (const Polygon& polygon : refused) {
    Owner<gcv_polygon> handle;
    const gcv_status status = make_polygon(polygon, handle);
    report.add_answers(1);
    if (status != GCV_ERR_NOT_SIMPLE) {
      report.differ("making a polygon", "  " + text(polygon) + "\n",
                    std::string("  ") + gcv_status_name(status) + "\n", "  GCV_ERR_NOT_SIMPLE\n");
    }
  }
}

void compare_holes(const Shard& shard, Report& report) {
  for (std::uint64_t k = shard.number; k < kHoles; k += shard.of) {
    Random random(k);
    const Sample a = random_polygon(random, 5, 2);
    const Sample b = random_polygon(random, k % 2 == 0 ? 2 : 3, 1);
    compare_refused(a.refused, report);
    compare_refused(b.refused, report);
    compare_pair(Operand(doubled(a.polygon)), Operand(b.polygon), report);
  }
}

void compare_scenes(const Shard& shard, Report& report) {
  for (std::uint64_t k = shard.number; k < kScenes; k += shard.of) {
    Random random(k);
    const Operand container(doubled(random_polygon(random, 5, k % 2 == 0 ? 0 : 1).polygon));
    const auto small = [&] { return Operand({random_ring(random, 3, 6)}); };
    const auto position = [&] { return Point{random.below(7), random.below(7)}; };
    const std::array<Operand, 3> members{small(), small(), small()};
    const std::array<Point, 3> positions{position(), position(), position()};
    compare_scene(container, members, positions, small(), report);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: worlds SHARD OF [FAMILY...]\n");
    return 2;
  }
  const Shard shard{std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10)};
  const std::vector<std::string> named(argv + 3, argv + argc);
  struct Family {
    std::string name;
    bool is_usual;
    std::function<void(Report&)> compare;
  };
  const auto all = [&](int grid, int corners) {
    return [&, grid, corners](Report& report) { compare_all(shard, grid, corners, report); };
  };
  const auto squares = [&](int box, int other) {
    return [&, box, other](Report& report) { compare_squares(shard, box, other, report); };
  };
  const std::array families{
      Family{"all_3x3", true, all(3, 9)},
      Family{"four_corners_4x4", true, all(4, 4)},
      Family{"squares_4x4_2x2", true, squares(4, 2)},
      Family{"figures", true, [&](Report& report) { compare_figures(shard, report); }},
      Family{"holes", true, [&](Report& report) { compare_holes(shard, report); }},
      Family{"scenes", true, [&](Report& report) { compare_scenes(shard, report); }},
      Family{"four_corners_5x5", false, all(5, 4)},
      Family{"five_corners_4x4", false, all(4, 5)},
      Family{"squares_4x4_3x3", false, squares(4, 3)}};
  bool agrees = true;
  for (const Family& family : families) {
    if (named.empty() ? !family.is_usual
                      : std::find(named.begin(), named.end(), family.name) == named.end()) {
      continue;
    }
    const std::clock_t start = std::clock();
    Report report;
    family.compare(report);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("%s %zu %zu %zu %.1f\n", family.name.c_str(), report.cases(), report.answers(),
                report.differences(), seconds);
    std::fflush(stdout);
    agrees &= report.differences() == 0;
  }
  return agrees ? 0 : 1;
}

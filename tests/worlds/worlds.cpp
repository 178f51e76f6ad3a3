// SPDX-License-Identifier: LGPL-3.0-or-later
//
// worlds SHARD OF: compares one of OF shares of all small pairs, and of the samples, with the
// definitions. Prints a line for each family: its name, cases, answers, differences and seconds.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <functional>
#include <string>

#include "catalogue.hpp"
#include "compare.hpp"

namespace {

using namespace worlds;

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
  catalogue.visit_pairs([&](std::size_t i, std::size_t j) {
    if (shard.has(number++)) {
      compare_pair(operands[i], operands[j], report);
    }
  });
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

constexpr std::uint64_t kHoles = 20000;
constexpr std::uint64_t kScenes = 2000;

void compare_holes(const Shard& shard, Report& report) {
  for (std::uint64_t k = shard.number; k < kHoles; k += shard.of) {
    Random random(k);
    const Sample a = random_polygon(random, 5, 2);
    const Sample b = random_polygon(random, 4, k % 2 == 0 ? 0 : 1);
    compare_refused(a.refused, report);
    compare_refused(b.refused, report);
    compare_pair(Operand(a.polygon), Operand(b.polygon), report);
  }
}

void compare_scenes(const Shard& shard, Report& report) {
  for (std::uint64_t k = shard.number; k < kScenes; k += shard.of) {
    Random random(k);
    Polygon container = random_polygon(random, 5, k % 2 == 0 ? 0 : 1).polygon;
    for (Ring& ring : container) {
      for (Point& p : ring) {
        p = 2 * p;
      }
    }
    const auto small = [&] { return Operand({random_ring(random, 3, 6)}); };
    const auto position = [&] { return Point{random.below(7), random.below(7)}; };
    const std::array<Operand, 3> members{small(), small(), small()};
    const std::array<Point, 3> positions{position(), position(), position()};
    compare_scene(Operand(container), members, positions, small(), report);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: worlds SHARD OF\n");
    return 2;
  }
  const Shard shard{std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10)};
  struct Family {
    const char* name;
    std::function<void(Report&)> compare;
  };
  const std::array families{
      Family{"four_corners_4x4", [&](Report& report) { compare_all(shard, 4, 4, report); }},
      Family{"all_3x3", [&](Report& report) { compare_all(shard, 3, 9, report); }},
      Family{"holes", [&](Report& report) { compare_holes(shard, report); }},
      Family{"scenes", [&](Report& report) { compare_scenes(shard, report); }}};
  bool agrees = true;
  for (const Family& family : families) {
    const std::clock_t start = std::clock();
    Report report;
    family.compare(report);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("%s %zu %zu %zu %.1f\n", family.name, report.cases(), report.answers(),
                report.differences(), seconds);
    std::fflush(stdout);
    agrees &= report.differences() == 0;
  }
  return agrees ? 0 : 1;
}

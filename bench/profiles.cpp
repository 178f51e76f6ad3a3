// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_profiles outer-face|region SET PAIR REPETITIONS
//
// So many sums of a pair, from doubles to doubles on one thread, for bench/profiles to count the
// instructions of. The sets are those of gcv_compare. Prints how many predicates one sum has taken:
// those that doubles decide, those in numbers of fixed width, and those in larger ones.
#include <cstddef>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "libgcv_handles.hpp"
#include "sets.hpp"

namespace gcv::bench {
namespace {

Rings find_pair(const std::string& set_name, const std::string& pair_name) {
  for (const Set& set : all_sets(false)) {
    for (const Pair& pair : set.pairs) {
      if (set.name == set_name && pair.name == pair_name) {
        const Rings rings = pair.make();
        return {tidy(rings.first), tidy(rings.second)};
      }
    }
  }
  throw std::invalid_argument("no such pair: " + set_name + ", " + pair_name);
}

// Makes a sum by the functions of outer faces or of regions, and copies its vertices out.
template <class Result>
gcv_stats cost_of_sum(gcv_status (*sum)(const gcv_polygon*, const gcv_polygon*, const gcv_options*,
                                        Result**),
                      gcv_status (*copy)(const Result*, double*, std::size_t, std::size_t*),
                      gcv_status (*stats_of)(const Result*, gcv_stats*), const gcv_polygon* a,
                      const gcv_polygon* b) {
  Result* out = nullptr;
  check(sum(a, b, nullptr, &out));
  const Owned<Result> result(out);
  std::size_t count = 0;
  check(copy(out, nullptr, 0, &count));
  PointVector vertices(count);
  check(copy(out, &vertices.data()->x, count, &count));
  gcv_stats stats{};
  stats.struct_size = sizeof stats;
  check(stats_of(out, &stats));
  return stats;
}

void run(const std::vector<std::string>& arguments) {
  const bool is_region = arguments.at(0) == "region";
  const auto [ring_a, ring_b] = find_pair(arguments.at(1), arguments.at(2));
  gcv_stats stats{};
  for (int k = std::stoi(arguments.at(3)); k > 0; --k) {
    const auto a = make_polygon(ring_a);
    const auto b = make_polygon(ring_b);
    stats = is_region ? cost_of_sum(gcv_minkowski_sum_region, gcv_region_vertices, gcv_region_stats,
                                    a.get(), b.get())
                      : cost_of_sum(gcv_minkowski_sum, gcv_outer_face_vertices,
                                    gcv_outer_face_stats, a.get(), b.get());
  }
  std::printf("%llu %llu %llu\n", static_cast<unsigned long long>(stats.predicates_filtered),
              static_cast<unsigned long long>(stats.predicates_fixed_width),
              static_cast<unsigned long long>(stats.predicates_rational));
}

}  // namespace
}  // namespace gcv::bench

int main(int argc, char** argv) {
  try {
    gcv::bench::run({argv + 1, argv + argc});
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "gcv_profiles: %s\n", exception.what());
    return 1;
  }
  return 0;
}

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_profiles outer-face|region SET PAIR REPETITIONS
//
// So many sums of a pair, from doubles to doubles on one thread, for bench/profiles to count the
// instructions of. The sets are those of gcv_compare. Prints how many predicates one sum has taken:
// those that doubles decide, those in numbers of fixed width, and those in larger ones.
#include <cstdio>
#include <cstdlib>
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

gcv_stats empty_stats() {
  gcv_stats stats{};
  stats.struct_size = sizeof stats;
  return stats;
}

gcv_stats sum_outer_face(const gcv_polygon* a, const gcv_polygon* b) {
  gcv_outer_face* out = nullptr;
  check(gcv_minkowski_sum(a, b, nullptr, &out));
  const Owned<gcv_outer_face> face(out);
  std::size_t count = 0;
  check(gcv_outer_face_vertex_count(out, &count));
  PointVector ring(count);
  check(gcv_outer_face_vertices(out, &ring.data()->x, count, &count));
  gcv_stats stats = empty_stats();
  check(gcv_outer_face_stats(out, &stats));
  return stats;
}

gcv_stats sum_region(const gcv_polygon* a, const gcv_polygon* b) {
  gcv_region* out = nullptr;
  check(gcv_minkowski_sum_region(a, b, nullptr, &out));
  const Owned<gcv_region> region(out);
  std::size_t count = 0;
  check(gcv_region_vertices(out, nullptr, 0, &count));
  PointVector vertices(count);
  check(gcv_region_vertices(out, &vertices.data()->x, count, &count));
  gcv_stats stats = empty_stats();
  check(gcv_region_stats(out, &stats));
  return stats;
}

void run(const std::vector<std::string>& arguments) {
  const bool is_region = arguments.at(0) == "region";
  const auto [ring_a, ring_b] = find_pair(arguments.at(1), arguments.at(2));
  gcv_stats stats{};
  for (int k = std::stoi(arguments.at(3)); k > 0; --k) {
    const auto a = make_polygon(ring_a);
    const auto b = make_polygon(ring_b);
    stats = (is_region ? sum_region : sum_outer_face)(a.get(), b.get());
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

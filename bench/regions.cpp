// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Times whole regions beside outer faces and beside CGAL's reduced convolution, which gives holes
// too, but no exact fits. One thread. Prints a table; docs/PERFORMANCE.md has it.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "data.hpp"
#include "gcv/gcv.h"
#include "generators.hpp"
#include "rounding.hpp"
#include "shapes.hpp"
#include "simplicity.hpp"
#include "systems/system.hpp"

namespace gcv::bench {
namespace {

using Clock = std::chrono::steady_clock;

// Without repeated vertices, counter-clockwise, as CGAL takes it.
Ring tidied(const Ring& ring) {
  Ring result = ring_through(ring);
  if (!is_counter_clockwise(result)) {
    std::reverse(result.begin(), result.end());
  }
  return result;
}

// The median of at least one run, as many as half a second takes.
template <class Run>
double milliseconds(Run run) {
  std::vector<double> times;
  double sum = 0;
  do {
    const auto begin = Clock::now();
    run();
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    sum += times.back();
  } while (sum < 500 && times.size() < 101);
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                   times.end());
  return times[times.size() / 2];
}

void check(gcv_status status) {
  if (status != GCV_OK) {
    std::fprintf(stderr, "%s\n", gcv_last_error_message());
    std::exit(1);
  }
}

struct Polygons {
  Polygons(const Ring& ring_a, const Ring& ring_b) {
    check(gcv_polygon_create(&ring_a.front().x, ring_a.size(), 0, &a));
    check(gcv_polygon_create(&ring_b.front().x, ring_b.size(), 0, &b));
  }
  Polygons(const Polygons&) = delete;
  Polygons& operator=(const Polygons&) = delete;
  ~Polygons() {
    gcv_polygon_destroy(a);
    gcv_polygon_destroy(b);
  }
  gcv_polygon* a = nullptr;
  gcv_polygon* b = nullptr;
};

void sum_outer_face(const Ring& a, const Ring& b) {
  const Polygons polygons(a, b);
  gcv_outer_face* face = nullptr;
  check(gcv_minkowski_sum(polygons.a, polygons.b, nullptr, &face));
  gcv_outer_face_destroy(face);
}

struct Counts {
  std::size_t holes = 0;
  std::size_t fits = 0;
};

Counts sum_region(const Ring& a, const Ring& b) {
  const Polygons polygons(a, b);
  gcv_region* region = nullptr;
  check(gcv_minkowski_sum_region(polygons.a, polygons.b, nullptr, &region));
  std::size_t count = 0;
  check(gcv_region_exact_parts(region, nullptr, 0, &count));
  std::vector<gcv_region_part> parts(count);
  check(gcv_region_exact_parts(region, parts.data(), count, &count));
  gcv_region_destroy(region);
  Counts counts;
  for (const gcv_region_part& part : parts) {
    counts.holes += part.kind == GCV_PART_HOLE ? 1 : 0;
    counts.fits += part.kind > GCV_PART_HOLE ? 1 : 0;
  }
  return counts;
}

void measure(const std::string& name, const Ring& a, const Ring& b, bool with_cgal) {
  const double outer = milliseconds([&] { sum_outer_face(a, b); });
  Counts counts;
  const double region = milliseconds([&] { counts = sum_region(a, b); });
  std::printf("| %s | %zu / %zu | %zu | %zu | %.4g | %.4g | %.3g |", name.c_str(), a.size(),
              b.size(), counts.holes, counts.fits, outer, region, region / outer);
  if (with_cgal) {
    const double cgal =
        milliseconds([&] { static_cast<void>(cgal_reduced_convolution(a, b).run()); });
    std::printf(" %.4g | %.3g |\n", cgal, cgal / region);
  } else {
    std::printf(" - | - |\n");
  }
  std::fflush(stdout);
}

void run() {
  std::puts(
      "| pair | A / B | holes | fits | outer face ms | region ms | region : outer face | "
      "CGAL reduced convolution ms | CGAL : region |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
  if (const auto directory = test::data_directory()) {
    for (const test::NamedPair& pair : test::read_pairs(*directory)) {
      measure(pair.name, tidied(pair.a), tidied(pair.b),
              static_cast<double>(pair.a.size()) * static_cast<double>(pair.b.size()) < 2e6);
    }
  } else {
    std::fputs("The real pairs are left out: their folder is not there.\n", stderr);
  }
  for (const int n : {100, 300, 1000, 3000, 10000, 100000}) {
    test::Random random(static_cast<std::uint64_t>(n));
    const Ring a = coast(random, n);
    const Ring b = coast(random, n);
    measure("coasts", a, b, n <= 1000);
  }
}

}  // namespace
}  // namespace gcv::bench

int main() { gcv::bench::run(); }

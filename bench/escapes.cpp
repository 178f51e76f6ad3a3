// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_escapes [SECONDS]
//
// Ways out of random overlaps of the pairs of pairs.txt, beside the whole region with a search for
// the nearest point on it. One thread, each in turns for SECONDS, 0.5 by default. Prints a table in
// Markdown.
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "contact/handle.hpp"
#include "data.hpp"
#include "region/nearest.hpp"
#include "region/overlaps.hpp"
#include "region/turns.hpp"
#include "sets.hpp"

namespace gcv::bench {
namespace {

Owned<gcv_region> region_of(const gcv_polygon* a, const gcv_polygon* b) {
  const double origin[2] = {0, 0};
  gcv_region* region = nullptr;
  check(gcv_no_fit_region(a, b, origin, nullptr, &region));
  return Owned<gcv_region>(region);
}

// The vertices of each part.
std::vector<PointVector> parts_of(const gcv_region* region) {
  std::size_t count = 0;
  check(gcv_region_parts(region, nullptr, 0, &count));
  std::vector<gcv_region_part> parts(count);
  check(gcv_region_parts(region, parts.data(), count, &count));
  check(gcv_region_vertices(region, nullptr, 0, &count));
  PointVector vertices(count);
  check(gcv_region_vertices(region, &vertices.front().x, count, &count));
  std::vector<PointVector> result;
  auto first = vertices.begin();
  for (const gcv_region_part& part : parts) {
    const auto last = first + static_cast<std::ptrdiff_t>(part.vertex_count);
    result.emplace_back(first, last);
    first = last;
  }
  return result;
}

constexpr std::size_t places_a_call = 200;

struct Ratios {
  double alone;
  double many;
};

Ratios print_row(const Pair& pair, double seconds) {
  const auto [ring_a, ring_b] = pair.make();
  const Owned<gcv_polygon> a = make_polygon(ring_a);
  const Owned<gcv_polygon> b = make_polygon(ring_b);
  const PointVector places = overlaps(a.get(), b.get(), places_a_call);
  std::vector<gcv_escape> escapes(places.size());
  std::vector<double> depths(places.size());
  std::size_t next = 0;
  const auto one_more = [&] { return next = (next + 1) % places.size(); };
  const Turns turns(
      {[&] {
         const std::size_t k = one_more();
         depths[k] = nearest_point(parts_of(region_of(a.get(), b.get()).get()), places[k]).distance;
       },
       [&] {
         const std::size_t k = one_more();
         check(gcv_penetration(a.get(), b.get(), &places[k].x, 1, nullptr, &escapes[k]));
       },
       [&] {
         check(gcv_penetration(a.get(), b.get(), &places.front().x, places.size(), nullptr,
                               escapes.data()));
       }},
      seconds);
  const auto count = static_cast<double>(places.size());
  const Ratios ratios{turns.ratio(0, 1), count * turns.ratio(0, 2)};
  std::printf("| %s | %zu / %zu | %.3g | %.3g | %.3g | %.2g | %.3g |\n", pair.name.c_str(),
              ring_a.size(), ring_b.size(), 1000 * turns.milliseconds(0),
              1000 * turns.milliseconds(1), 1000 * turns.milliseconds(2) / count, ratios.alone,
              ratios.many);
  std::fflush(stdout);
  return ratios;
}

int run(double seconds) {
  const auto directory = test::data_directory();
  if (!directory) {
    std::fprintf(stderr, "gcv_escapes: there is no polygon data: set GCV_DATA_DIR\n");
    return 1;
  }
  std::printf(
      "Microseconds of a way out. Alone: one place a call; %zu: so many a call.\n\n"
      "| pair | A / B | region and search | alone | %zu | region : alone | region : %zu |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
      places_a_call, places_a_call, places_a_call);
  for (const Set& set : blocks_of_pairs(*directory)) {
    std::vector<double> alone;
    std::vector<double> many;
    for (const Pair& pair : set.pairs) {
      const Ratios ratios = print_row(pair, seconds);
      alone.push_back(ratios.alone);
      many.push_back(ratios.many);
    }
    std::printf("| *%s, median* | | | | | %.2g | %.3g |\n", set.name.c_str(), median(alone),
                median(many));
  }
  return 0;
}

}  // namespace
}  // namespace gcv::bench

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::strtod(argv[1], nullptr) : 0.5;
  if (argc > 2 || !(seconds > 0)) {
    std::fprintf(stderr, "usage: gcv_escapes [SECONDS]\n");
    return 2;
  }
  return gcv::bench::run(seconds);
}

// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "apart.hpp"
#include "families.hpp"
#include "placements.hpp"
#include "systems/whole.hpp"
#include "tables.hpp"
#include "text.hpp"
#include "turns.hpp"

namespace gcv::bench {

namespace {

constexpr double limit = 10;        // seconds for one position
constexpr double comparable = 1.5;  // times as many vertices, at most

struct Timed {
  double ratio = 0;  // to the time of the pair as it is
  double milliseconds = 0;
  double vertices = 0;
};

// Both in turns, so that positions compare even on a machine that is busy.
Outcome timed(const Rings& as_is, const Rings& placed) {
  return run_apart(limit, [&] {
    const Ring a = tidy(as_is.first);
    const Ring b = tidy(as_is.second);
    const Ring c = tidy(placed.first);
    const Ring d = tidy(placed.second);
    const RegionSize size = libgcv_region_size(c, d);
    const Turns turns({[&] { libgcv_region(a, b); }, [&] { libgcv_region(c, d); }}, 0.1);
    const Timed result{turns.ratio(1, 0), turns.milliseconds(1),
                       static_cast<double>(size.vertices)};
    std::string bytes(sizeof result, '\0');
    std::memcpy(bytes.data(), &result, sizeof result);
    return bytes;
  });
}

struct Spread {
  double ratio = 1;
  std::string slowest = "-";
  std::string quickest = "-";
};

struct Place {
  std::string name;
  Timed timed;
};

Spread spread_of(const std::vector<Place>& places) {
  Spread spread;
  for (const Place& p : places) {
    for (const Place& q : places) {
      const double ratio = p.timed.ratio / q.timed.ratio;
      const auto [few, many] = std::minmax(p.timed.vertices, q.timed.vertices);
      if (many <= comparable * few && ratio > spread.ratio) {
        spread = {ratio, p.name, q.name};
      }
    }
  }
  return spread;
}

void print_row(const Pair& pair) {
  static const std::vector<std::string> left_out{"far", "turned", "1/16", "16"};
  const Rings rings = pair.make();
  std::vector<Place> places;
  std::string failure;
  for (const Placement& placement : placements()) {
    if (contains(left_out, placement.name) || !failure.empty()) {
      continue;
    }
    const Outcome outcome = timed(rings, placement.apply(rings));
    if (outcome.failure.empty()) {
      Timed result;
      std::memcpy(&result, outcome.bytes.data(), sizeof result);
      places.push_back({placement.name, result});
    } else if (outcome.is_cut_off) {  // others are not polygons any more, or have no sum in doubles
      failure = placement.name + ": " + outcome.failure;
    }
  }
  const Spread spread = spread_of(places);
  std::printf("| %s | %zu / %zu |", pair.name.c_str(), tidy(rings.first).size(),
              tidy(rings.second).size());
  if (places.empty()) {
    std::printf(" - | - | - | - | %s |\n", failure.c_str());
  } else {
    const auto [fewest, most] = std::minmax_element(
        places.begin(), places.end(),
        [](const Place& p, const Place& q) { return p.timed.vertices < q.timed.vertices; });
    std::printf(" %.0f - %.0f | %.3g | %.3g | %s : %s | %s |\n", fewest->timed.vertices,
                most->timed.vertices, places.front().timed.milliseconds, spread.ratio,
                spread.slowest.c_str(), spread.quickest.c_str(), failure.c_str());
  }
  std::fflush(stdout);
}

}  // namespace

void print_positions(bool quick) {
  std::puts(
      "| pair | A / B | vertices of the region | as is ms | spread | slowest : quickest | given up "
      "|\n| --- | ---: | ---: | ---: | ---: | --- | --- |");
  for (const Set& set : families(true)) {
    if (set.is_on_demand) {
      continue;
    }
    for (const Pair& pair : set.pairs) {
      print_row(pair);
      if (quick) {
        break;
      }
    }
  }
  std::puts("");
}

}  // namespace gcv::bench

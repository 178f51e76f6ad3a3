// SPDX-License-Identifier: LGPL-3.0-or-later
#include "sets.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include "data.hpp"
#include "hard/shapes.hpp"
#include "shapes.hpp"

namespace gcv::bench {

namespace {

using test::random_histogram;
using test::random_spiky_star;
using test::uniform;

std::string size_name(int n) { return std::to_string(n) + " x " + std::to_string(n); }

// Two polygons of each size, from one generator.
template <class Make>
Set of_sizes(const char* name, const std::vector<int>& sizes, Make make) {
  Set set{.name = name, .grows = true};
  for (const int n : sizes) {
    set.pairs.push_back({size_name(n), [n, make] {
                           Random random(static_cast<std::uint64_t>(n));
                           Ring a = make(random, n);
                           return Rings{std::move(a), make(random, n)};
                         }});
  }
  return set;
}

Rings coasts(int n, int m) {
  Random random(static_cast<std::uint64_t>(n));
  Ring a = coast(random, n);
  return {std::move(a), coast(random, m)};
}

Rings spiky_stars(int n) {
  Random random(static_cast<std::uint64_t>(n));
  Ring a = random_spiky_star(random, n);
  return {std::move(a), random_spiky_star(random, n)};
}

Rings twice(const Ring& ring) { return {ring, ring}; }

// Shapes that cost more than their size tells; the first one is what they are compared to.
Set hostile() {
  return {.name = "hostile",
          .pairs = {{"coasts 10000 x 10000", [] { return coasts(10000, 10000); }},
                    {"comb of 250 teeth, with itself", [] { return twice(comb(250)); }},
                    {"comb of 250 uneven teeth, with itself",
                     [] {
                       Random random(250);
                       return twice(uneven_comb(random, 250));
                     }},
                    {"comb of 2500 teeth, turned",
                     [] {
                       return Rings{comb(2500), quarter_turned(comb(2500))};
                     }},
                    {"Koch curves 3072 x 3072", [] { return twice(koch(5)); }},
                    {"spiky stars 1000 x 1000", [] { return spiky_stars(1000); }},
                    {"spiky stars 10000 x 10000", [] { return spiky_stars(10000); }},
                    {"regular 10000-gons",
                     [] {
                       return Rings{regular(10000, 100), regular(10000, 70)};
                     }},
                    {"zigzag of 500, with itself", [] { return twice(zigzag(500)); }},
                    {"zigzag of 500, turned",
                     [] {
                       return Rings{zigzag(500), quarter_turned(zigzag(500))};
                     }},
                    {"spiral of 100 turns + small square",
                     [] {
                       return Rings{spiral(100), regular(4, 0.5)};
                     }},
                    {"spiral of 100 turns, with itself", [] { return twice(spiral(100)); }},
                    {"coasts 100000 x 4", [] { return coasts(100000, 4); }},
                    {"coasts 10000 x 10000, one scaled by 1/1000",
                     [] {
                       auto [a, b] = coasts(10000, 10000);
                       return Rings{a, scaled(b, 0.001)};
                     }},
                    {"coast 10000 and its reflection",
                     [] {
                       const Ring a = coasts(10000, 4).first;
                       return Rings{a, test::negated(a)};
                     }},
                    {"coasts 10000 x 10000, 10^9 away",
                     [] {
                       auto [a, b] = coasts(10000, 10000);
                       return Rings{moved(a, 1e9, -1e9), moved(b, -3e9, 2e9)};
                     }}},
          .for_all_peers = false,
          .most_vertex_pairs_for_peers = 5e5};
}

// The paper's pairs, and others of each kind: what the table of docs/METHOD.md is about.
Set method(std::vector<Pair> pairs) {
  const auto add = [&](const char* name, const std::function<Rings()>& make) {
    pairs.push_back({name, make});
  };
  add("coasts 100 x 100", [] { return coasts(100, 100); });
  add("coasts 400 x 200", [] { return coasts(400, 200); });
  add("spiky stars 30 x 30", [] { return spiky_stars(30); });
  add("spiky stars 100 x 100", [] { return spiky_stars(100); });
  add("histograms 100 x 100", [] {
    Random random(100);
    Ring a = random_histogram(random, 50, 20);
    return Rings{std::move(a), random_histogram(random, 50, 20)};
  });
  add("comb of 25 teeth, with itself", [] { return twice(comb(25)); });
  add("comb of 25 teeth, turned", [] { return Rings{comb(25), quarter_turned(comb(25))}; });
  add("Koch curves 48 x 48", [] { return twice(koch(2)); });
  add("coast 100 x convex 12", [] {
    Random random(12);
    Ring a = coast(random, 100);
    return Rings{std::move(a), scaled(random_convex(random, 12), 0.1)};
  });
  add("convex 100 x 100", [] {
    Random random(100);
    Ring a = random_convex(random, 100);
    return Rings{std::move(a), random_convex(random, 100)};
  });
  add("regular 300-gons", [] { return Rings{regular(300, 100), regular(300, 70)}; });
  return {.name = "method", .pairs = std::move(pairs), .is_on_demand = true};
}

std::vector<int> up_to(int most, std::vector<int> sizes) {
  std::erase_if(sizes, [&](int n) { return n > most; });
  return sizes;
}

Ring to_ring(const hard::Polygon& polygon) {
  Ring ring;
  for (const auto& [x, y] : polygon) {
    ring.push_back({x, y});
  }
  return ring;
}

// The pairs of pairs.txt with these names, in their order.
std::vector<Pair> named_pairs(const std::filesystem::path& directory,
                              const std::vector<std::string>& names) {
  std::vector<Pair> pairs;
  for (const std::string& name : names) {
    for (const Set& block : blocks_of_pairs(directory)) {
      std::copy_if(block.pairs.begin(), block.pairs.end(), std::back_inserter(pairs),
                   [&](const Pair& pair) { return pair.name == name; });
    }
  }
  return pairs;
}

Pair far_away(const Pair& pair) {
  return {pair.name + ", 10^9 away", [make = pair.make] {
            const auto [a, b] = make();
            return Rings{moved(a, 1e9 + 1 / 3.0, -1e9 / 7), moved(b, -3e9 / 7, 2e9 + 1 / 3.0)};
          }};
}

}  // namespace

std::vector<Set> all_sets(bool quick) {
  std::vector<Set> sets;
  std::vector<Pair> of_the_paper;
  if (const auto directory = test::data_directory()) {
    sets = blocks_of_pairs(*directory);
    of_the_paper = sets.front().pairs;
    sets.push_back(nesting(*directory, quick ? 40 : 200));
  } else {
    std::fputs("no data: neither GCV_DATA_DIR nor ../shared/data; going on without\n", stderr);
  }
  const int most = quick ? 10000 : 1000000;
  const std::vector<int> powers{100, 1000, 10000, 100000, 1000000};
  sets.push_back(of_sizes("coasts", up_to(most, powers), coast));
  sets.push_back(of_sizes("spiky stars", {10, 30, 60, 100, 200}, random_spiky_star));
  sets.push_back(of_sizes("rectilinear", {10, 30, 100, 300}, [](Random& random, int n) {
    return random_histogram(random, n / 2, 20);
  }));
  sets.push_back(of_sizes("convex", {8, 100, 1000, 10000}, random_convex));
  sets.push_back(tiny_pairs(quick ? 5 : 20));
  sets.push_back(hostile());
  sets.push_back(method(std::move(of_the_paper)));
  return sets;
}

std::vector<Pair> accuracy_pairs(bool quick) {
  std::vector<Pair> pairs;
  if (const auto directory = test::data_directory()) {
    pairs = named_pairs(*directory, {"fork", "stars", "~monkey", "gardeyn5"});
    pairs.push_back(far_away(pairs.at(0)));
  } else {
    std::fputs("no data: neither GCV_DATA_DIR nor ../shared/data; going on without\n", stderr);
  }
  const int n = quick ? 1000 : 10000;
  pairs.push_back({"coasts " + size_name(n), [n] { return coasts(n, n); }});
  // Nearest doubles alone make its walls cross, and a pocket lies behind them.
  pairs.push_back({"rotated slot", rotated_slots(15).back().make});
  pairs.push_back({"needles", [] { return Rings{needles(12), test::negated(needles(9))}; }});
  pairs.push_back({"histograms 100 x 100", [] {
                     Random random(100);
                     Ring a = random_histogram(random, 50, 20);
                     return Rings{std::move(a), random_histogram(random, 50, 20)};
                   }});
  pairs.push_back({"tiny", tiny_pairs(1).pairs.front().make});
  return pairs;
}

std::vector<Pair> rotated_slots(int count) {
  std::vector<Pair> pairs;
  Random random(51);
  for (int k = 0; k < count; ++k) {
    const auto [block, part] = hard::rotated_slot(random, k);
    pairs.push_back({"slot " + std::to_string(k), [a = to_ring(block), b = to_ring(part)] {
                       return Rings{a, b};
                     }});
  }
  return pairs;
}

}  // namespace gcv::bench

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "families.hpp"

#include <cstdint>
#include <cstdio>
#include <utility>

#include "data.hpp"
#include "shapes.hpp"

namespace gcv::bench {

namespace {

using test::random_histogram;
using test::random_spiky_star;

std::string sizes(int n) { return std::to_string(n) + " x " + std::to_string(n); }

Pair twice(const std::string& name, const std::function<Ring()>& make) {
  return {name, [make] {
            Ring a = make();
            return Rings{a, a};
          }};
}

// Two polygons from one generator.
template <class Make>
Pair drawn(const std::string& name, int seed, Make make) {
  return {name, [seed, make] {
            Random random(static_cast<std::uint64_t>(seed));
            Ring a = make(random);
            return Rings{std::move(a), make(random)};
          }};
}

// The polygon and a small one with up to 8 vertices.
Pair with_small(const std::string& name, double size, const std::function<Ring()>& make) {
  return {name + " + small", [make, size] {
            Random random(8);
            return Rings{make(), scaled(tiny(random), size / 200)};
          }};
}

// All pairs, from small to large.
std::vector<Set> all_families() {
  std::vector<Set> result{
      {.name = "coasts"},      {.name = "combs"},        {.name = "uneven combs"},
      {.name = "zigzags"},     {.name = "koch"},         {.name = "spiky stars"},
      {.name = "spirals"},     {.name = "plates"},       {.name = "regular"},
      {.name = "histograms"},  {.name = "mazes"},        {.name = "hilbert"},
      {.name = "gears"},       {.name = "saws"},         {.name = "needles"},
      {.name = "hairbrushes"}, {.name = "forked trees"}, {.name = "sunbursts"},
      {.name = "wires"},       {.name = "slanting"},     {.name = "mouths"},
      {.name = "divided"}};
  const auto add = [&](const char* family, Pair pair) {
    for (Set& set : result) {
      if (set.name == family) {
        set.pairs.push_back(std::move(pair));
      }
    }
  };
  for (const int n : {1000, 10000}) {
    add("coasts", {"coasts " + sizes(n), [n] { return reference_coasts(n, 0); }});
    add("spiky stars",
        drawn("spiky stars " + sizes(n), n, [n](Random& r) { return random_spiky_star(r, n); }));
    add("histograms", drawn("histograms " + sizes(n), n,
                            [n](Random& r) { return random_histogram(r, n / 2, n / 5); }));
  }
  for (const int n : {250, 2500}) {
    const std::string name = "comb of " + std::to_string(n) + " teeth";
    add("combs", twice(name, [n] { return comb(n); }));
    add("combs", twice("high " + name, [n] { return comb(n, 0.5, 1000); }));
  }
  for (const int n : {250, 1000}) {
    add("uneven combs", twice("comb of " + std::to_string(n) + " uneven teeth", [n] {
          Random random(static_cast<std::uint64_t>(n));
          return uneven_comb(random, n);
        }));
    add("gears", {"gears of " + std::to_string(n) + " and fewer teeth", [n] {
                    return Rings{gear(n), gear(n - n / 5)};
                  }});
    add("saws", twice("saw of " + std::to_string(n) + " teeth", [n] { return saw(n); }));
    add("needles", {"needles " + std::to_string(n), [n] {
                      return Rings{needles(n), test::negated(needles(n - n / 4))};
                    }});
    add("wires", drawn("wires of " + std::to_string(n) + " steps", n,
                       [n](Random& r) { return wire(r, n); }));
    add("hairbrushes", drawn("hairbrushes of " + std::to_string(n) + " bristles", n,
                             [n](Random& r) { return hairbrush(r, n); }));
  }
  for (const int n : {500, 2500}) {
    add("zigzags", twice("zigzag of " + std::to_string(n), [n] { return zigzag(n); }));
  }
  add("koch", twice("Koch curves 768 x 768", [] { return koch(4); }));
  add("koch", twice("Koch curves 3072 x 3072", [] { return koch(5); }));
  for (const int n : {100, 500}) {
    const std::string name = "spiral of " + std::to_string(n) + " turns";
    add("spirals", with_small(name, 0.7, [n] { return spiral(n); }));
    add("spirals", twice(name, [n] { return spiral(n); }));
  }
  // Long edges in no direction of the axes.
  for (const int n : {250, 2500}) {
    const auto add_slanting = [&](const std::string& name, const std::function<Ring()>& make) {
      add("slanting", with_small("slanting " + name, 0.4, [make] { return slanting(make()); }));
    };
    add_slanting("comb of " + std::to_string(n) + " teeth", [n] { return comb(n, 1, 2 * n); });
    add_slanting("zigzag of " + std::to_string(n), [n] { return zigzag(n, n); });
    add_slanting("spiral of " + std::to_string(n) + " turns", [n] { return spiral(n); });
  }
  // A disc that lies over the mouths of half of the gaps at once.
  for (const int n : {250, 1000}) {
    add("mouths", {"comb of " + std::to_string(n) + " teeth + disc", [n] {
                     return Rings{comb(n, 1, 4 * n), regular(40, n / 2.0)};
                   }});
  }
  // Edges that lie in one line but for roundings.
  for (const int n : {30, 120}) {
    add("divided", twice("square of " + std::to_string(n) + " points a side",
                         [n] { return divided_square(n); }));
  }
  for (const int n : {20, 50}) {
    const std::string name = "plate of " + sizes(n) + " holes";
    add("plates", with_small(name, 0.5, [n] { return plate(n); }));
    add("plates", twice(name, [n] { return plate(n); }));
  }
  add("regular", {"regular 1000-gons", [] {
                    return Rings{regular(1000, 100), regular(1000, 70)};
                  }});
  add("regular", {"regular 10000-gons", [] {
                    return Rings{regular(10000, 100), regular(10000, 70)};
                  }});
  for (const int n : {20, 50}) {
    add("mazes",
        drawn("mazes of " + sizes(n) + " cells", n, [n](Random& r) { return maze(r, n); }));
  }
  for (const int level : {4, 6}) {
    const std::string name = "Hilbert curve of " + sizes(1 << level) + " cells";
    add("hilbert", with_small(name, 0.4, [level] { return hilbert(level); }));
    add("hilbert", twice(name, [level] { return hilbert(level); }));
  }
  for (const int levels : {8, 11}) {
    add("forked trees", drawn("forked trees of " + std::to_string(1 << levels) + " leaves", levels,
                              [levels](Random& r) { return forked_tree(r, levels); }));
  }
  for (const int arms : {24, 96}) {
    add("sunbursts", {"sunbursts of " + std::to_string(arms) + " and fewer arms", [arms] {
                        return Rings{sunburst(arms, 20), sunburst(arms - 5, 20)};
                      }});
  }
  return result;
}

// A quick run leaves out every pair of more vertices than that.
constexpr std::size_t most_quick_vertices = 2100;

void leave_out_large(Set& set) {
  std::erase_if(set.pairs, [](const Pair& pair) {
    const Rings rings = pair.make();
    return rings.first.size() + rings.second.size() > most_quick_vertices;
  });
}

}  // namespace

std::vector<Set> families(bool quick) {
  std::vector<Set> result;
  if (const auto directory = test::data_directory()) {
    result.push_back(blocks_of_pairs(*directory).at(0));
    result.push_back(nesting(*directory, quick ? 3 : 12));
  } else {
    std::fputs(
        "skipped: the families paper and nesting, for want of data: neither GCV_DATA_DIR nor "
        "../shared/data\n",
        stderr);
  }
  for (Set& set : all_families()) {
    result.push_back(std::move(set));
  }
  for (Set& set : result) {
    if (quick) {
      leave_out_large(set);
    }
  }
  result.push_back(tiny_pairs(20));
  result.back().is_on_demand = true;
  return result;
}

Rings reference_coasts(int n, int seed) {
  Random random(static_cast<std::uint64_t>(n + seed));
  Ring a = coast(random, n);
  return {std::move(a), coast(random, n)};
}

}  // namespace gcv::bench

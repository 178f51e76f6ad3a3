// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "data.hpp"
#include "families.hpp"
#include "gcv/gcv.h"
#include "generators.hpp"
#include "sets.hpp"
#include "systems/whole.hpp"
#include "turns.hpp"

namespace gcv::bench {

namespace {

constexpr std::uint64_t leave_out_all = GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS;

double vertex_pairs(const Ring& a, const Ring& b) {
  return static_cast<double>(a.size()) * static_cast<double>(b.size());
}

void print_row(const std::string& name, const Ring& a, const Ring& b, bool with_cgal) {
  std::vector<std::function<void()>> ways{[&] { libgcv_outer_face(a, b); },
                                          [&] { libgcv_region(a, b); }};
  if (with_cgal) {
    ways.emplace_back([&] { static_cast<void>(cgal_reduced_whole(a, b)); });
  }
  const Turns turns(ways);
  const RegionSize size = libgcv_region_size(a, b);
  std::printf("| %s | %zu / %zu | %zu | %zu | %.3g | %.3g | %.3g |", name.c_str(), a.size(),
              b.size(), size.holes, size.fits, turns.milliseconds(0), turns.milliseconds(1),
              turns.ratio(1, 0));
  if (with_cgal) {
    std::printf(" %.3g | %.3g |\n", turns.milliseconds(2), turns.ratio(2, 1));
  } else {
    std::puts(" - | - |");
  }
  std::fflush(stdout);
}

// The ratios of the pairs of a set.
struct Sample {
  struct Worst {
    std::string pair;
    double cgal;
  };
  std::vector<double> cgal;      // CGAL : region
  std::vector<double> outer;     // region : outer face
  std::vector<double> left_out;  // region with everything left out : outer face
  std::vector<Worst> slowest;    // beside CGAL
};

Sample measured(const Set& set, double seconds) {
  constexpr double most_vertex_pairs = 1e4;  // CGAL is slow, and the tables of pairs have it
  Sample sample;
  for (const Pair& pair : set.pairs) {
    const Rings rings = pair.make();
    const Ring a = tidy(rings.first);
    const Ring b = tidy(rings.second);
    std::vector<std::function<void()>> ways{[&] { libgcv_outer_face(a, b); },
                                            [&] { libgcv_region(a, b); },
                                            [&] { libgcv_region(a, b, leave_out_all); }};
    const bool with_cgal = vertex_pairs(a, b) < most_vertex_pairs;
    if (with_cgal) {
      ways.emplace_back([&] { static_cast<void>(cgal_reduced_whole(a, b)); });
    }
    const Turns turns(ways, seconds);
    sample.outer.push_back(turns.ratio(1, 0));
    sample.left_out.push_back(turns.ratio(2, 0));
    if (with_cgal) {
      sample.cgal.push_back(turns.ratio(3, 1));
      sample.slowest.push_back({pair.name, sample.cgal.back()});
    }
  }
  std::sort(sample.slowest.begin(), sample.slowest.end(),
            [](const auto& p, const auto& q) { return p.cgal < q.cgal; });
  return sample;
}

double geometric_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) {
    sum += std::log(value);
  }
  return std::exp(sum / static_cast<double>(values.size()));
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

void print_sample(const Set& set, double seconds) {
  const Sample s = measured(set, seconds);
  std::printf("| %s | %zu |", set.name.c_str(), s.outer.size());
  if (s.cgal.empty()) {
    std::printf(" - | - | - |");
  } else {
    std::printf(" %.3g | %.3g | %.3g, %s |", median(s.cgal), geometric_mean(s.cgal),
                s.slowest.front().cgal, s.slowest.front().pair.c_str());
  }
  std::printf(" %.3g | %.3g | %.3f | %.3f | %.3f |\n", median(s.outer), largest(s.outer),
              median(s.left_out), geometric_mean(s.left_out), largest(s.left_out));
  std::fflush(stdout);
}

Set coasts(bool quick) {
  Set set{.name = "coasts of 1,000 and 10,000"};
  for (const int n : quick ? std::vector<int>{1000} : std::vector<int>{1000, 10000}) {
    for (const int seed : {0, 1}) {
      set.pairs.push_back({std::to_string(n), [n, seed] { return reference_coasts(n, seed); }});
    }
  }
  return set;
}

std::vector<Set> samples(bool quick) {
  std::vector<Set> sets;
  if (const auto directory = test::data_directory()) {
    Set parts = nesting(*directory, quick ? 30 : 300);
    parts.name = "parts of nesting instances, no-fit regions";
    for (Pair& pair : parts.pairs) {
      pair.make = [make = pair.make] {
        const auto [a, b] = make();
        return Rings{a, test::negated(b)};
      };
    }
    sets.push_back(parts);
    const std::vector<Set> blocks = blocks_of_pairs(*directory);
    sets.push_back({.name = "the paper's pairs", .pairs = blocks.at(0).pairs});
    sets.push_back({.name = "real pairs", .pairs = blocks.at(1).pairs});
  } else {
    std::fputs("The real pairs are left out: their folder is not there.\n", stderr);
  }
  sets.push_back(random_small_pairs(quick ? 20 : 200));
  sets.push_back(coasts(quick));
  return sets;
}

}  // namespace

void print_pairs(bool quick) {
  std::puts(
      "| pair | A / B | holes | fits | outer face ms | region ms | region : outer face | "
      "CGAL reduced convolution ms | CGAL : region |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
  const double most_vertex_pairs = quick ? 8000 : 2e6;
  if (const auto directory = test::data_directory()) {
    for (const Set& set : blocks_of_pairs(*directory)) {
      for (const Pair& pair : set.pairs) {
        const Rings rings = pair.make();
        const Ring a = tidy(rings.first);
        const Ring b = tidy(rings.second);
        print_row(pair.name, a, b, vertex_pairs(a, b) < most_vertex_pairs);
      }
    }
  } else {
    std::fputs("The real pairs are left out: their folder is not there.\n", stderr);
  }
  for (const int n : {100, 300, 1000, 3000}) {
    const auto [a, b] = reference_coasts(n, 0);
    print_row("coasts", a, b, vertex_pairs(a, b) < most_vertex_pairs);
  }
  std::puts("");
}

void print_samples(bool quick) {
  std::puts(
      "| set | pairs | CGAL : region, median | geometric mean | worst | region : outer face, "
      "median | worst | all left out : outer face, median | geometric mean | worst |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
  for (const Set& set : samples(quick)) {
    print_sample(set, 0.15);
  }
  std::puts("");
}

void print_growth(bool quick) {
  std::puts(
      "| coasts | vertices of the region | holes | region ms | µs a vertex | outer face ms | "
      "µs a vertex | cover ms | µs a vertex | that : log2 n |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
  for (const int n : quick ? std::vector<int>{1000} : std::vector<int>{1000, 10000, 100000}) {
    const auto [a, b] = reference_coasts(n, 0);
    const Turns turns(
        {[&a = a, &b = b] { libgcv_outer_face(a, b); }, [&a = a, &b = b] { libgcv_region(a, b); }},
        1);
    const RegionSize size = libgcv_region_size(a, b);
    const auto vertices = static_cast<double>(size.vertices);
    const double outer = turns.milliseconds(0);
    const double region = turns.milliseconds(1);
    const double cover = region - outer;
    std::printf("| %d / %d | %zu | %zu | %.4g | %.3g | %.4g | %.3g | %.4g | %.3g | %.3g |\n", n, n,
                size.vertices, size.holes, region, 1000 * region / vertices, outer,
                1000 * outer / vertices, cover, 1000 * cover / vertices,
                1000 * cover / vertices / std::log2(n));
    std::fflush(stdout);
  }
  std::puts("");
}

}  // namespace gcv::bench

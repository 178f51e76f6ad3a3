// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_positions --library FILE [--versus FILE] [--quick] [--families NAME,...]
//               [--positions NAME,...] [--rounds N] [--limit SECONDS]
//
// Times the sums of the pairs of all families in all positions, by one libgcv or by two in
// turns, each run in a process of its own. Writes one line of JSON for each pair in each
// position, those of the coasts that the others are compared to first.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "families.hpp"
#include "measure.hpp"
#include "placements.hpp"
#include "simplicity.hpp"
#include "text.hpp"

namespace gcv::bench {

namespace {

constexpr double once_is_enough = 1;   // seconds: a run as long as that has one round
constexpr double enough_in_all = 0.2;  // seconds of one process
constexpr int most_cut_off = 3;        // a pair that is cut off so often is given up
constexpr int reference_seeds = 3;

struct Options {
  std::string library;
  std::string versus;
  bool quick = false;
  std::vector<std::string> families;   // or pairs; all, if none are named
  std::vector<std::string> positions;  // likewise
  int rounds = 2;
  double limit = 20;
};

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const auto value = [&] { return arguments.at(++k); };
    if (arguments[k] == "--library") {
      options.library = value();
    } else if (arguments[k] == "--versus") {
      options.versus = value();
    } else if (arguments[k] == "--quick") {
      options.quick = true;
    } else if (arguments[k] == "--families") {
      options.families = split(value());
    } else if (arguments[k] == "--positions") {
      options.positions = split(value());
    } else if (arguments[k] == "--rounds") {
      options.rounds = std::stoi(value());
    } else if (arguments[k] == "--limit") {
      options.limit = std::stod(value());
    } else {
      throw std::invalid_argument("unknown argument: " + arguments[k]);
    }
  }
  if (options.library.empty()) {
    throw std::invalid_argument("--library is missing");
  }
  return options;
}

// One library on one pair, cold or prepared: the least of all rounds.
struct Best {
  std::optional<double> seconds;
  std::size_t vertices = 0;
  std::string failure;
  bool is_cut_off = false;

  void add(const Measurement& measurement) {
    if (!measurement.failure.empty()) {
      failure = measurement.failure;
      is_cut_off = measurement.is_cut_off;
    } else {
      seconds = std::min(seconds.value_or(measurement.seconds), measurement.seconds);
      vertices = measurement.vertices;
    }
  }

  [[nodiscard]] bool is_over() const {
    return !failure.empty() || seconds.value_or(0) > once_is_enough;
  }

  [[nodiscard]] std::string json() const {
    if (!failure.empty()) {
      return "{\"failure\": " + quoted(failure) +
             ", \"is_cut_off\": " + (is_cut_off ? "true" : "false") + "}";
    }
    char text[80];
    std::snprintf(text, sizeof text, "{\"ms\": %.6g, \"vertices\": %zu}", 1000 * seconds.value(),
                  vertices);
    return text;
  }
};

class Positions {
 public:
  explicit Positions(Options options) : options_(std::move(options)) {
    add_systems("library", options_.library);
    if (!options_.versus.empty()) {
      add_systems("versus", options_.versus);
    }
  }

  void run() {
    std::vector<std::pair<std::string, Pair>> chosen;
    std::size_t most = 0;
    for (const Set& set : families(options_.quick)) {
      for (const Pair& pair : set.pairs) {
        const bool is_wanted =
            options_.families.empty()
                ? !set.is_on_demand
                : contains(options_.families, set.name) || contains(options_.families, pair.name);
        if (is_wanted) {
          chosen.emplace_back(set.name, pair);
          const Rings rings = pair.make();
          most = std::max(most, rings.first.size() + rings.second.size());
        }
      }
    }
    if (chosen.empty()) {
      throw std::invalid_argument("no such family");
    }
    run_references(most);
    for (const auto& [family, pair] : chosen) {
      run(family, pair);
    }
  }

 private:
  void add_systems(const std::string& name, const std::string& file) {
    systems_.push_back({name + " cold", Role::libgcv, 0, libgcv_cold(file.c_str())});
    systems_.push_back({name + " prepared", Role::libgcv, 0, libgcv_prepared(file.c_str())});
  }

  // Coasts of all sizes up to the largest pair, and those that some bars are about.
  void run_references(std::size_t most_vertices) const {
    std::vector<int> sizes{10000};
    for (int n = 4; sizes.back() * 2U < most_vertices || sizes.size() == 1; n *= 2) {
      sizes.push_back(n);
    }
    std::sort(sizes.begin(), sizes.end());
    for (const int n : sizes) {
      for (int seed = 0; seed < reference_seeds; ++seed) {
        run_at("reference", std::to_string(n), "as is", reference_coasts(n, seed));
      }
    }
  }

  void run(const std::string& family, const Pair& pair) const {
    const Rings rings = pair.make();
    int cut_off = 0;
    for (const Placement& placement : placements()) {
      if (options_.positions.empty() || contains(options_.positions, placement.name)) {
        cut_off += cut_off < most_cut_off &&
                           run_at(family, pair.name, placement.name, placement.apply(rings))
                       ? 1
                       : 0;
      }
    }
  }

  // Was the first library cut off?
  bool run_at(const std::string& family, const std::string& pair, const std::string& position,
              const Rings& rings) const {
    const Ring a = tidy(rings.first);
    const Ring b = tidy(rings.second);
    std::vector<Best> results(systems_.size());
    const bool is_simple = !find_conflict(a) && !find_conflict(b);
    for (int round = 0; round < options_.rounds && is_simple; ++round) {
      for (std::size_t k = 0; k < systems_.size(); ++k) {
        // What is cut off cold is prepared, too.
        if (k % 2 == 1 && !results[k - 1].failure.empty()) {
          results[k] = results[k - 1];
        } else if (!results[k].is_over()) {
          results[k].add(measure(systems_[k], a, b, {options_.limit, true, false, enough_in_all}));
        }
      }
    }
    std::string json;
    for (std::size_t k = 0; k < systems_.size() && is_simple; ++k) {
      json += (k == 0 ? "" : ", ") + quoted(systems_[k].name) + ": " + results[k].json();
    }
    std::printf(
        "{\"family\": %s, \"pair\": %s, \"position\": %s, \"a\": %zu, \"b\": %zu, "
        "\"is_simple\": %s, \"results\": {%s}}\n",
        quoted(family).c_str(), quoted(pair).c_str(), quoted(position).c_str(), a.size(), b.size(),
        is_simple ? "true" : "false", json.c_str());
    std::fflush(stdout);
    return results[0].is_cut_off;
  }

  Options options_;
  std::vector<System> systems_;
};

}  // namespace

}  // namespace gcv::bench

int main(int argc, char** argv) {
  try {
    gcv::bench::Positions(gcv::bench::parse({argv + 1, argv + argc})).run();
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "gcv_positions: %s\n", exception.what());
    return 1;
  }
  return 0;
}

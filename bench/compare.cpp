// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_compare [--quick] [--rounds N] [--limit SECONDS] [--sets NAME,...]
//             [--systems NAME,...]
//
// Measures all systems on the pairs of the sets, side by side: in every round each system
// runs once on each pair of a set, in a process of its own. Writes one line of JSON for each pair.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "boundary.hpp"
#include "measure.hpp"
#include "sets.hpp"
#include "superset_sizes.hpp"
#include "text.hpp"

namespace gcv::bench {

namespace {

constexpr double once_is_enough = 2;  // seconds: a run as long as that has one round

struct Options {
  bool quick = false;
  int rounds = 5;
  double limit = 60;
  std::vector<std::string> sets;     // all, if none are named
  std::vector<std::string> systems;  // likewise
};

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const auto value = [&] { return arguments.at(++k); };
    if (arguments[k] == "--quick") {
      options.quick = true;
    } else if (arguments[k] == "--rounds") {
      options.rounds = std::stoi(value());
    } else if (arguments[k] == "--limit") {
      options.limit = std::stod(value());
    } else if (arguments[k] == "--sets") {
      options.sets = split(value());
    } else if (arguments[k] == "--systems") {
      options.systems = split(value());
    } else {
      throw std::invalid_argument("unknown argument: " + arguments[k]);
    }
  }
  return options;
}

std::string described(const Ring& ring) {
  const gcv::Boundary polygon = make_ring(ring, "polygon");
  const auto reflex =
      std::count_if(polygon.corners.begin(), polygon.corners.end(),
                    [](const gcv::Boundary::Corner& corner) { return !corner.convex; });
  return "{\"vertices\": " + std::to_string(ring.size()) +
         ", \"reflex\": " + std::to_string(reflex) + "}";
}

std::string sizes_json(const Ring& a, const Ring& b) {
  const SupersetSizes sizes = superset_sizes(a, b);
  return "\"supersets\": {\"all_pairs\": " + std::to_string(sizes.all_pairs) +
         ", \"full_convolution\": " + std::to_string(sizes.full_convolution) +
         ", \"convolution_cycles\": " + std::to_string(sizes.convolution_cycles) +
         ", \"reduced_convolution\": " + std::to_string(sizes.reduced_convolution) +
         ", \"gcv\": " + std::to_string(sizes.gcv) + "}, ";
}

std::string milliseconds(double seconds) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", 1000 * seconds);
  return text;
}

// All measurements of one system on one pair.
struct Series {
  Measurement last;
  std::vector<double> seconds;

  void add(const Measurement& measurement) {
    last = measurement;
    if (measurement.failure.empty()) {
      seconds.push_back(measurement.seconds);
    }
  }

  [[nodiscard]] bool is_empty() const { return seconds.empty() && last.failure.empty(); }
  [[nodiscard]] bool is_over() const {
    return !last.failure.empty() || (!seconds.empty() && seconds.back() > once_is_enough);
  }

  [[nodiscard]] std::string json() const {
    if (!last.failure.empty()) {
      return "{\"failure\": " + quoted(last.failure) + "}";
    }
    std::string rounds;
    for (const double s : seconds) {
      rounds += (rounds.empty() ? "" : ", ") + milliseconds(s);
    }
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    char text[400];
    std::snprintf(text, sizeof text,
                  "\"vertices\": %zu, \"exact_vertices\": %zu, \"area\": %.12g, "
                  "\"peak_bytes\": %zu, \"superset_edges\": %zu, \"superset_ms\": %.6g}",
                  last.vertices, last.observation.exact_vertices, last.area, last.peak_bytes,
                  last.observation.superset_edges, 1000 * last.observation.superset_seconds);
    return "{\"ms\": " + milliseconds(sorted[sorted.size() / 2]) + ", \"rounds_ms\": [" + rounds +
           "], " + text;
  }
};

// One pair of a set, and what has been measured on it.
struct Trial {
  std::string name;
  Ring a;
  Ring b;
  std::vector<Series> results;  // of each system
};

class Comparison {
 public:
  explicit Comparison(Options options) : options_(std::move(options)), systems_(systems()) {}

  void run() {
    for (const Set& set : all_sets(options_.quick)) {
      if (options_.sets.empty() ? !set.is_on_demand : contains(options_.sets, set.name)) {
        run(set);
      }
    }
  }

 private:
  void run(const Set& set) {
    std::vector<Trial> trials;
    for (const Pair& pair : set.pairs) {
      auto [a, b] = pair.make();
      trials.push_back({pair.name, tidy(a), tidy(b), std::vector<Series>(systems_.size())});
    }
    std::vector<std::uint8_t> is_cut_off(systems_.size());
    for (int round = 0; round < options_.rounds; ++round) {
      for (Trial& trial : trials) {
        for (std::size_t k = 0; k < systems_.size(); ++k) {
          Series& series = trial.results[k];
          // In a set that grows, what was cut off is not tried on larger pairs.
          if (series.is_over() || (set.grows && is_cut_off[k] != 0) ||
              !is_tried(systems_[k], set, trial)) {
            continue;
          }
          series.add(measure(systems_[k], trial.a, trial.b, {options_.limit}));
          is_cut_off[k] |= series.last.is_cut_off ? 1U : 0U;
        }
      }
    }
    for (const Trial& trial : trials) {
      print(set, trial);
    }
  }

  [[nodiscard]] bool is_tried(const System& system, const Set& set, const Trial& trial) const {
    const double vertex_pairs =
        static_cast<double>(trial.a.size()) * static_cast<double>(trial.b.size());
    const bool is_asked = options_.systems.empty() || contains(options_.systems, system.name);
    const bool is_invited =
        system.role == Role::libgcv ||
        ((set.for_all_peers || system.role == Role::principal_peer) &&
         vertex_pairs <= std::min(system.most_vertex_pairs, set.most_vertex_pairs_for_peers));
    return is_asked && is_invited;
  }

  void print(const Set& set, const Trial& trial) const {
    std::string json;
    for (std::size_t k = 0; k < systems_.size(); ++k) {
      if (!trial.results[k].is_empty()) {
        json +=
            (json.empty() ? "" : ", ") + quoted(systems_[k].name) + ": " + trial.results[k].json();
      }
    }
    const std::string sizes = set.is_on_demand ? sizes_json(trial.a, trial.b) : "";
    std::printf("{\"set\": %s, \"pair\": %s, \"a\": %s, \"b\": %s, %s\"results\": {%s}}\n",
                quoted(set.name).c_str(), quoted(trial.name).c_str(), described(trial.a).c_str(),
                described(trial.b).c_str(), sizes.c_str(), json.c_str());
    std::fflush(stdout);
  }

  Options options_;
  std::vector<System> systems_;
};

}  // namespace

}  // namespace gcv::bench

int main(int argc, char** argv) {
  try {
    gcv::bench::Comparison(gcv::bench::parse({argv + 1, argv + argc})).run();
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "gcv_compare: %s\n", exception.what());
    return 1;
  }
  return 0;
}

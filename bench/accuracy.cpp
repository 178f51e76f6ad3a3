// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_accuracy [--quick] [--rounds N] [--limit SECONDS] [--slots N] [--pairs NAME;...]
//
// Time against error: runs each system on each pair, at each of its settings, and judges
// what it returns. Writes one line of JSON for each pair, and one for the slots.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "judge.hpp"
#include "measure.hpp"
#include "sets.hpp"
#include "text.hpp"

namespace gcv::bench {

namespace {

constexpr double once_is_enough = 2;  // seconds: a run as long as that has one round
constexpr double least_lost = 1e-9;   // of the diameter: smaller pockets do not count

struct Options {
  bool quick = false;
  int rounds = 3;
  double limit = 20;
  int slots = 2000;
  std::vector<std::string> pairs;  // all, if none are named
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
    } else if (arguments[k] == "--slots") {
      options.slots = std::stoi(value());
    } else if (arguments[k] == "--pairs") {
      options.pairs = split(value(), ';');
    } else {
      throw std::invalid_argument("unknown argument: " + arguments[k]);
    }
  }
  return options;
}

// A system at one setting.
struct Method {
  std::string setting;
  double resolution;  // in input units; 0 where it is that of doubles
  System system;      // of the same name at each of its settings
};

Prepare on_grid(Job (*job)(const Ring&, const Ring&, double), double cells_per_unit) {
  return [job, cells_per_unit](const Ring& a, const Ring& b) { return job(a, b, cells_per_unit); };
}

std::string power_of_ten(int exponent) { return "10^" + std::to_string(exponent); }

// All methods, for a sum of that diameter. Of a system, the settings that tell most come
// first: where one takes long, later ones are left out. Decimal grids have so many digits
// behind the power of ten that is next above the diameter: round numbers stay what they are.
std::vector<Method> methods(const Ring& a, const Ring& b, double diameter, bool quick) {
  std::vector<Method> result;
  const auto add = [&](const char* name, const std::string& setting, double resolution,
                       Prepare prepare) {
    constexpr double any = std::numeric_limits<double>::infinity();
    result.push_back({setting, resolution, {name, Role::peer, any, std::move(prepare)}});
  };
  const auto add_with_tolerances = [&](const char* name, const auto& prepare) {
    add(name, "exact", 0, prepare(0));
    for (int k = quick ? 2 : 1; k <= 12; k += quick ? 5 : 1) {
      const double tolerance = std::pow(10, -k) * diameter;
      add(name, "tolerance " + power_of_ten(-k), tolerance, prepare(tolerance));
    }
  };
  for (const auto& [name, outward] :
       {std::pair("libgcv, nearest", false), std::pair("libgcv, outward", true)}) {
    add_with_tolerances(name, [outward = outward](double tolerance) {
      return libgcv_cold(GCV_LIBRARY, {outward, tolerance});
    });
  }
  add_with_tolerances("libgcv, prepared", [](double tolerance) {
    return libgcv_prepared(GCV_LIBRARY, {false, tolerance});
  });
  add("libgcv, plain doubles", "doubles", 0, libgcv_cold(GCV_PLAIN_LIBRARY));
  add("CGAL reduced convolution", "exact", 0, cgal_reduced_convolution);
  add("SFCGAL", "exact", 0, sfcgal);
  for (const int k :
       quick ? std::vector{6, 9, 12} : std::vector{6, 2, 12, 4, 9, 3, 5, 7, 8, 10, 11}) {
    const double cells = std::pow(10, k - std::ceil(std::log10(diameter)));
    add("Clipper", std::to_string(k) + " digits", 1 / cells, on_grid(clipper, cells));
  }
  for (const int bits : quick ? std::vector{22, 31} : std::vector{31, 16, 22, 28, 19, 25}) {
    const double cells = cells_per_unit(a, b, bits);
    add("Boost.Polygon", std::to_string(bits) + " bits", 1 / cells, on_grid(boost_polygon, cells));
  }
  return result;
}

// All measurements of one method on one pair.
struct Series {
  Measurement result;  // of the first round, or a failure
  std::vector<double> seconds;

  void add(Measurement measurement) {
    const bool has_failed = !measurement.failure.empty();
    if (!has_failed) {
      seconds.push_back(measurement.seconds);
    }
    if (has_failed || seconds.size() == 1) {
      result = std::move(measurement);
    }
  }

  [[nodiscard]] bool is_over() const {
    return !result.failure.empty() || (!seconds.empty() && seconds.back() > once_is_enough);
  }
};

// The library's ring in doubles, whose diameter is the unit of all errors.
Ring usual_ring(const Ring& a, const Ring& b, double limit) {
  const System libgcv{"libgcv", Role::libgcv, 0, libgcv_cold(GCV_LIBRARY)};
  Measurement measurement = measure(libgcv, a, b, {limit, false, true});
  if (!measurement.failure.empty()) {
    throw std::runtime_error("libgcv: " + measurement.failure);
  }
  return std::move(measurement.ring);
}

// Rounds of all methods. A system that has had the limit of time at its settings so far is
// not tried at further ones.
std::vector<Series> run(const std::vector<Method>& methods, const Ring& a, const Ring& b,
                        const Options& options) {
  std::vector<Series> results(methods.size());
  std::map<std::string, double> spent;
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const System& system = methods[k].system;
      if (results[k].is_over()) {
        continue;
      }
      if (round == 0 && spent[system.name] > options.limit) {
        results[k].result.failure = "not tried";
        continue;
      }
      const auto start = std::chrono::steady_clock::now();
      results[k].add(measure(system, a, b, {options.limit, true, round == 0}));
      spent[system.name] +=
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  }
  return results;
}

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[500];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

// Throws where there is no ring.
Verdict judged(const Method& method, const Measurement& measurement, const Judge& judge,
               double diameter) {
  if (!measurement.failure.empty()) {
    throw std::runtime_error(measurement.failure);
  }
  const double resolution = std::max(method.resolution, least_lost / 10 * diameter);
  const std::size_t corners = method.resolution == 0 ? measurement.observation.exact_vertices : 0;
  return judge.judge(measurement.ring, resolution, corners);
}

// Is the error within the bound that libgcv gives? With a tolerance that is one between
// regions, not between rings.
bool is_within_bound(const Method& method, const Measurement& measurement, const Verdict& verdict) {
  return !method.system.name.starts_with("libgcv") || method.resolution > 0 ||
         verdict.error.lower <= measurement.observation.error_bound;
}

const char* json(bool value) { return value ? "true" : "false"; }

std::string json(const Method& method, Series& series, const Judge& judge, double diameter) {
  const std::string head = "{\"system\": " + quoted(method.system.name) +
                           ", \"setting\": " + quoted(method.setting) +
                           formatted(", \"resolution\": %.6g, ", method.resolution / diameter);
  try {
    const Verdict verdict = judged(method, series.result, judge, diameter);
    std::sort(series.seconds.begin(), series.seconds.end());
    return head +
           formatted(
               "\"ms\": %.6g, \"rounds\": %zu, \"vertices\": %zu, \"error\": [%.17g, %.17g], "
               "\"simple\": %s, \"counter_clockwise\": %s, \"complete\": %s, "
               "\"contains\": %s, \"within_bound\": %s}",
               1000 * series.seconds[series.seconds.size() / 2], series.seconds.size(),
               series.result.vertices, verdict.error.lower / diameter,
               verdict.error.upper / diameter, json(verdict.is_simple),
               json(verdict.is_counter_clockwise), json(verdict.is_complete),
               json(verdict.contains_exact), json(is_within_bound(method, series.result, verdict)));
  } catch (const std::exception& exception) {
    return head + "\"failure\": " + quoted(exception.what()) + "}";
  }
}

void report(const Pair& pair, const Options& options) {
  const auto [raw_a, raw_b] = pair.make();
  const Ring a = tidy(raw_a);
  const Ring b = tidy(raw_b);
  const double size = diameter(usual_ring(a, b, options.limit));
  const std::vector<Method> tried = methods(a, b, size, options.quick);
  std::vector<Series> results = run(tried, a, b, options);
  const Judge judge(a, b);
  std::printf(
      "{\"pair\": %s, \"a\": %zu, \"b\": %zu, \"exact_vertices\": %zu, "
      "\"diameter\": %.6g, \"results\": [",
      quoted(pair.name).c_str(), a.size(), b.size(), judge.exact_vertices(), size);
  for (std::size_t k = 0; k < tried.size(); ++k) {
    std::printf("%s%s", k == 0 ? "" : ", ", json(tried[k], results[k], judge, size).c_str());
  }
  std::printf("]}\n");
  std::fflush(stdout);
}

// What became of a method on many sums.
struct Count {
  int no_result = 0;
  int not_simple = 0;
  int incomplete = 0;
  int wrong = 0;  // any of these, or clockwise
  int containing = 0;
  int beyond_bound = 0;      // of libgcv's own
  double largest_error = 0;  // a bound, in diameters

  void add(const Verdict& verdict, bool is_within_bound, double diameter) {
    not_simple += verdict.is_simple ? 0 : 1;
    incomplete += verdict.is_complete ? 0 : 1;
    wrong += verdict.is_right() ? 0 : 1;
    containing += verdict.contains_exact ? 1 : 0;
    beyond_bound += is_within_bound ? 0 : 1;
    largest_error = std::max(largest_error, verdict.error.upper / diameter);
  }
};

void report_slots(const Options& options) {
  std::vector<std::pair<Method, Count>> counts;
  for (const Pair& pair : rotated_slots(options.slots)) {
    const auto [raw_a, raw_b] = pair.make();
    const Ring a = tidy(raw_a);
    const Ring b = tidy(raw_b);
    const double size = diameter(usual_ring(a, b, options.limit));
    const Judge judge(a, b);
    const std::vector<Method> tried = methods(a, b, size, true);
    for (std::size_t k = 0; k < tried.size(); ++k) {
      if (counts.size() <= k) {
        counts.push_back({tried[k], {}});
      }
      Count& count = counts[k].second;
      const Measurement measurement = measure(tried[k].system, a, b, {options.limit, false, true});
      try {
        const Verdict verdict = judged(tried[k], measurement, judge, size);
        count.add(verdict, is_within_bound(tried[k], measurement, verdict), size);
      } catch (const std::exception&) {
        ++count.no_result;
        ++count.wrong;
      }
    }
  }
  std::printf("{\"slots\": %d, \"results\": [", options.slots);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const auto& [method, count] = counts[k];
    std::printf(
        "%s{\"system\": %s, \"setting\": %s, \"no_result\": %d, \"not_simple\": %d, "
        "\"incomplete\": %d, \"wrong\": %d, \"containing\": %d, \"beyond_bound\": %d, "
        "\"largest_error\": %.6g}",
        k == 0 ? "" : ", ", quoted(method.system.name).c_str(), quoted(method.setting).c_str(),
        count.no_result, count.not_simple, count.incomplete, count.wrong, count.containing,
        count.beyond_bound, count.largest_error);
  }
  std::printf("]}\n");
}

void run(const Options& options) {
  for (const Pair& pair : accuracy_pairs(options.quick)) {
    if (options.pairs.empty() || contains(options.pairs, pair.name)) {
      report(pair, options);
    }
  }
  if (options.slots > 0) {
    report_slots(options);
  }
}

}  // namespace

}  // namespace gcv::bench

int main(int argc, char** argv) {
  try {
    gcv::bench::run(gcv::bench::parse({argv + 1, argv + argc}));
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "gcv_accuracy: %s\n", exception.what());
    return 1;
  }
  return 0;
}

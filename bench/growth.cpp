// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_growth [LARGEST]
//
// How far outer faces reach: coasts of every roughness, from 1,000 to LARGEST vertices each,
// 1000000 by default. Prints two tables in Markdown: how the time grows, and what the largest take.
// By the wall clock, each size in a process of its own.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "apart.hpp"
#include "libgcv_handles.hpp"
#include "region/turns.hpp"
#include "shapes.hpp"

namespace gcv::bench {
namespace {

constexpr double limit = 600;  // seconds of one process
constexpr double enough_seconds = 1;
constexpr std::size_t fewest_runs = 3;

struct Coast {
  const char* name;
  std::function<Ring(Random&, int)> make;
};

Coast rough(const char* name, double hurst) {
  return {name, [hurst](Random& random, int n) { return rough_coast(random, n, hurst); }};
}

std::vector<Coast> all_coasts() {
  return {rough("Hurst 0.3", 0.3),
          rough("Hurst 0.6", 0.6),
          rough("Hurst 0.9", 0.9),
          {"as in bench/run", coast}};
}

double milliseconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - begin;
  return elapsed.count();
}

// The medians of some runs of each way, which take turns.
std::vector<double> medians(const std::vector<std::function<void()>>& ways) {
  std::vector<std::vector<double>> times(ways.size());
  double spent = 0;
  while (times[0].size() < fewest_runs || spent < 1000 * enough_seconds) {
    for (std::size_t k = 0; k < ways.size(); ++k) {
      times[k].push_back(milliseconds_of(ways[k]));
      spent += times[k].back();
    }
  }
  std::vector<double> result(ways.size());
  std::transform(times.begin(), times.end(), result.begin(), median);
  return result;
}

// Resident in this process, now.
std::size_t resident_bytes() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

Owned<gcv_outer_face> sum(const gcv_polygon* a, const gcv_polygon* b, int threads) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = threads;
  gcv_outer_face* face = nullptr;
  check(gcv_minkowski_sum(a, b, &options, &face));
  return Owned<gcv_outer_face>(face);
}

std::vector<Point> copied(const gcv_outer_face* face) {
  std::size_t count = 0;
  check(gcv_outer_face_vertex_count(face, &count));
  std::vector<Point> ring(count);
  check(gcv_outer_face_vertices(face, &ring.data()->x, count, &count));
  return ring;
}

struct Costs {
  std::size_t vertices;  // of the outer face
  std::size_t bytes;     // that it takes at most, beside the input
  double whole_ms;       // from doubles to doubles
  double create_ms;      // of the first polygon
  double one_thread_ms;  // of the sum alone
  double two_threads_ms;
};

Costs costs_of(const Coast& coast, int n) {
  Random random(static_cast<std::uint64_t>(n));
  const Ring ring_a = coast.make(random, n);
  const Ring ring_b = coast.make(random, n);
  Costs costs{};
  const std::size_t before = resident_bytes();
  const auto whole = [&] {
    const auto a = make_polygon(ring_a);
    const auto b = make_polygon(ring_b);
    costs.vertices = copied(sum(a.get(), b.get(), 1).get()).size();
  };
  whole();
  costs.bytes = peak_bytes() - before;
  const auto a = make_polygon(ring_a);
  const auto b = make_polygon(ring_b);
  const std::vector<double> times =
      medians({whole, [&] { make_polygon(ring_a); }, [&] { sum(a.get(), b.get(), 1); },
               [&] { sum(a.get(), b.get(), 2); }});
  costs.whole_ms = times[0];
  costs.create_ms = times[1];
  costs.one_thread_ms = times[2];
  costs.two_threads_ms = times[3];
  return costs;
}

Costs costs_apart(const Coast& coast, int n) {
  const Outcome outcome = run_apart(limit, [&] { return to_bytes(costs_of(coast, n)); });
  if (!outcome.failure.empty()) {
    throw std::runtime_error(std::string(coast.name) + ", " + std::to_string(n) + ": " +
                             outcome.failure);
  }
  return from_bytes<Costs>(outcome.bytes);
}

void print_tables(int largest) {
  std::puts(
      "| coasts | vertices | outer face | ms | µs a vertex | that : at 1000 |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: |");
  std::string largest_ones;
  for (const Coast& coast : all_coasts()) {
    double first = 0;
    for (int n = 1000; n <= largest; n *= 10) {
      const Costs costs = costs_apart(coast, n);
      const double each = 1000 * costs.whole_ms / static_cast<double>(costs.vertices);
      first = n == 1000 ? each : first;
      std::printf("| %s | %d | %zu | %.3g | %.3g | %.2f |\n", coast.name, n, costs.vertices,
                  costs.whole_ms, each, each / first);
      std::fflush(stdout);
      if (n > largest / 10) {
        char line[200];
        std::snprintf(line, sizeof line, "| %s | %.0f | %.0f | %.0f | %.0f | %.2f | %.0f |\n",
                      coast.name, costs.create_ms, costs.whole_ms, costs.one_thread_ms,
                      costs.two_threads_ms, costs.one_thread_ms / costs.two_threads_ms,
                      static_cast<double>(costs.bytes) / (2 * n));
        largest_ones += line;
      }
    }
  }
  std::printf(
      "\n| the largest coasts | one polygon ms | all ms | sum ms | on two threads ms | "
      "times as fast | bytes a vertex |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n%s",
      largest_ones.c_str());
}

}  // namespace
}  // namespace gcv::bench

int main(int argc, char** argv) {
  try {
    const int largest = argc > 1 ? std::atoi(argv[1]) : 1000000;
    if (largest < 1000) {
      throw std::invalid_argument("LARGEST is no number from 1000 on");
    }
    gcv::bench::print_tables(largest);
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "gcv_growth: %s\n", exception.what());
    return 1;
  }
  return 0;
}

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "measure.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <string>
#include <type_traits>

#include "apart.hpp"

namespace gcv::bench {

namespace {

constexpr double enough_seconds = 0.1;  // a run as long as that is measured once
constexpr int batches = 5;
constexpr double batch_seconds = 0.002;

// All measures of one run.
struct Report {
  double seconds;
  std::size_t vertices;
  double area;
  std::size_t peak_bytes;
  Observation observation;
};
static_assert(std::is_trivially_copyable_v<Report>);

double seconds_of(const Job& job, int runs, Ring& ring) {
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < runs; ++k) {
    ring = job.run();
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / runs;
}

// What this process has had of the processor: coarse, but free of what others have had.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double area_of(const Ring& ring) {
  double twice = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& o = ring[0];
    const Point& p = ring[k];
    const Point& q = ring[(k + 1) % ring.size()];
    twice += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return std::abs(twice) / 2;
}

Report run(const System& system, const Ring& a, const Ring& b, const Demand& demand, Ring& ring) {
  const Job job = system.prepare(a, b);
  Report report{};
  const double before = processor_seconds();
  report.seconds = seconds_of(job, 1, ring);
  if (report.seconds >= enough_seconds) {
    report.seconds = processor_seconds() - before;
  } else if (demand.is_timed) {
    double spent = report.seconds;
    // The first batch is too small: the first run has had to warm everything up.
    for (int batch = 0; batch <= batches && spent < demand.most_seconds; ++batch) {
      const int runs = static_cast<int>(std::ceil(batch_seconds / report.seconds));
      const double seconds = seconds_of(job, runs, ring);
      spent += runs * seconds;
      report.seconds = std::min(report.seconds, seconds);
    }
  }
  report.vertices = ring.size();
  report.area = area_of(ring);
  report.observation = job.observe();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  report.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  return report;
}

// What comes back: the measures, and the ring behind them where it is wanted.
std::string to_bytes(const Report& report, const Ring& ring) {
  std::string bytes(sizeof report + ring.size() * sizeof(Point), '\0');
  std::memcpy(bytes.data(), &report, sizeof report);
  if (!ring.empty()) {
    std::memcpy(bytes.data() + sizeof report, ring.data(), ring.size() * sizeof(Point));
  }
  return bytes;
}

}  // namespace

Measurement measure(const System& system, const Ring& a, const Ring& b, const Demand& demand) {
  const Outcome outcome = run_apart(demand.limit, [&] {
    Ring ring;
    const Report report = run(system, a, b, demand, ring);
    return to_bytes(report, demand.wants_ring ? ring : Ring{});
  });
  Measurement result;
  result.failure = outcome.failure;
  result.is_cut_off = outcome.is_cut_off;
  if (!outcome.failure.empty()) {
    return result;
  }
  Report report{};
  std::memcpy(&report, outcome.bytes.data(), sizeof report);
  result.seconds = report.seconds;
  result.vertices = report.vertices;
  result.area = report.area;
  result.peak_bytes = report.peak_bytes;
  result.observation = report.observation;
  result.ring.resize((outcome.bytes.size() - sizeof report) / sizeof(Point));
  if (!result.ring.empty()) {
    std::memcpy(result.ring.data(), outcome.bytes.data() + sizeof report,
                result.ring.size() * sizeof(Point));
  }
  return result;
}

}  // namespace gcv::bench

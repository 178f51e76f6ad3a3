// SPDX-License-Identifier: LGPL-3.0-or-later
#include "measure.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <system_error>
#include <type_traits>
#include <utility>

namespace gcv::bench {

namespace {

constexpr double enough_seconds = 0.1;  // a run as long as that is measured once
constexpr int batches = 5;
constexpr double batch_seconds = 0.002;
constexpr rlim_t most_memory = rlim_t{12} << 30;

// What comes through the pipe: a failure or all the rest; the ring behind it, if wanted.
struct Report {
  double seconds;
  std::size_t vertices;
  double area;
  std::size_t peak_bytes;
  Observation observation;
  std::array<char, 200> failure;
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

Report run_caught(const System& system, const Ring& a, const Ring& b, const Demand& demand,
                  Ring& ring) {
  Report report{};
  try {
    report = run(system, a, b, demand, ring);
  } catch (const std::exception& exception) {
    ring.clear();
    std::snprintf(report.failure.data(), report.failure.size(), "error: %s", exception.what());
  }
  return report;
}

bool write_all(int out, const void* data, std::size_t bytes) {
  const char* next = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t written = write(out, next, bytes);
    if (written <= 0) {
      return false;
    }
    next += written;
    bytes -= static_cast<std::size_t>(written);
  }
  return true;
}

bool read_all(int in, void* data, std::size_t bytes) {
  char* next = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t got = read(in, next, bytes);
    if (got <= 0) {
      return false;
    }
    next += got;
    bytes -= static_cast<std::size_t>(got);
  }
  return true;
}

[[noreturn]] void child(const System& system, const Ring& a, const Ring& b, const Demand& demand,
                        int out) {
  const rlimit memory{most_memory, most_memory};
  setrlimit(RLIMIT_AS, &memory);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const auto seconds = static_cast<rlim_t>(std::ceil(demand.limit));
  const rlimit time{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &time);
  Ring ring;
  const Report report = run_caught(system, a, b, demand, ring);
  const bool is_written =
      write_all(out, &report, sizeof report) &&
      (!demand.wants_ring || write_all(out, ring.data(), ring.size() * sizeof(Point)));
  _exit(is_written ? 0 : 1);
}

Measurement failed(int status, double limit) {
  Measurement result;
  char text[64];
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    result.is_cut_off = true;
    std::snprintf(text, sizeof text, "> %.0f s", limit);
  } else if (WIFSIGNALED(status)) {
    std::snprintf(text, sizeof text, "crash: %s", strsignal(WTERMSIG(status)));
  } else {
    std::snprintf(text, sizeof text, "exit status %d", WEXITSTATUS(status));
  }
  result.failure = text;
  return result;
}

}  // namespace

Measurement measure(const System& system, const Ring& a, const Ring& b, const Demand& demand) {
  int ends[2];
  if (pipe(ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  const pid_t process = fork();
  if (process < 0) {
    throw std::system_error(errno, std::generic_category(), "fork");
  }
  if (process == 0) {
    child(system, a, b, demand, ends[1]);
  }
  close(ends[1]);
  Report report{};
  bool is_complete = read_all(ends[0], &report, sizeof report);
  Ring ring(is_complete && demand.wants_ring ? report.vertices : 0);
  is_complete = is_complete && read_all(ends[0], ring.data(), ring.size() * sizeof(Point));
  close(ends[0]);
  int status = 0;
  waitpid(process, &status, 0);
  if (!is_complete) {
    return failed(status, demand.limit);
  }
  return {report.seconds,     report.vertices,       report.area, report.peak_bytes,
          report.observation, report.failure.data(), false,       std::move(ring)};
}

}  // namespace gcv::bench

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// libgcv alone, through its C interface: the parts of a sum and the whole of it.
#include <benchmark/benchmark.h>
#include <gcv/gcv.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "data.hpp"
#include "shapes.hpp"

namespace {

using gcv::test::Random;
using gcv::test::Ring;

struct Pair {
  Ring a;
  Ring b;
};

template <class Make>
Pair pair_of(int n, Make make) {
  Random random(static_cast<std::uint64_t>(n));
  Ring a = make(random, n);
  return {std::move(a), make(random, n)};
}

void check(gcv_status status) {
  if (status != GCV_OK) {
    throw std::runtime_error(gcv_last_error_message());
  }
}

using PolygonHandle = std::unique_ptr<gcv_polygon, decltype(&gcv_polygon_destroy)>;
using FaceHandle = std::unique_ptr<gcv_outer_face, decltype(&gcv_outer_face_destroy)>;

PolygonHandle create(const Ring& ring) {
  gcv_polygon* polygon = nullptr;
  check(gcv_polygon_create(&ring.data()->x, ring.size(), 0, &polygon));
  return {polygon, gcv_polygon_destroy};
}

FaceHandle sum(const PolygonHandle& a, const PolygonHandle& b, int threads = 1) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = threads;
  gcv_outer_face* face = nullptr;
  check(gcv_minkowski_sum(a.get(), b.get(), &options, &face));
  return {face, gcv_outer_face_destroy};
}

Ring copied(const FaceHandle& face) {
  std::size_t count = 0;
  check(gcv_outer_face_vertex_count(face.get(), &count));
  Ring ring(count);
  check(gcv_outer_face_vertices(face.get(), &ring.data()->x, count, &count));
  return ring;
}

void bench_create(benchmark::State& state, const Pair& pair) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(create(pair.a));
  }
}

void bench_sum_cold(benchmark::State& state, const Pair& pair) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(sum(create(pair.a), create(pair.b)));
  }
}

void bench_sum_prepared(benchmark::State& state, const Pair& pair) {
  const PolygonHandle a = create(pair.a);
  const PolygonHandle b = create(pair.b);
  for (auto _ : state) {
    benchmark::DoNotOptimize(sum(a, b));
  }
}

void bench_sum_and_copy(benchmark::State& state, const Pair& pair) {
  const PolygonHandle a = create(pair.a);
  const PolygonHandle b = create(pair.b);
  std::size_t vertices = 0;
  for (auto _ : state) {
    const Ring ring = copied(sum(a, b));
    vertices = ring.size();
    benchmark::DoNotOptimize(ring.data());
  }
  state.counters["vertices"] = static_cast<double>(vertices);
}

// By the wall clock, for the benchmark's argument as the number of threads.
void bench_threads(benchmark::State& state, const Pair& pair) {
  const PolygonHandle a = create(pair.a);
  const PolygonHandle b = create(pair.b);
  for (auto _ : state) {
    benchmark::DoNotOptimize(sum(a, b, static_cast<int>(state.range(0))));
  }
}

// As many sums at once, each on a thread of its own: where two take longer than one, so much is the
// machine's, and not to be had by sharing one sum out.
void bench_copies(benchmark::State& state, const Pair& pair) {
  const PolygonHandle a = create(pair.a);
  const PolygonHandle b = create(pair.b);
  for (auto _ : state) {
    std::vector<std::jthread> copies;
    for (std::int64_t k = 0; k < state.range(0); ++k) {
      copies.emplace_back([&] { benchmark::DoNotOptimize(sum(a, b)); });
    }
  }
}

void add(const std::string& name, const Pair& pair) {
  const auto with = [&](const char* part, auto* function) {
    benchmark::RegisterBenchmark((name + "/" + part).c_str(), [pair,
                                                               function](benchmark::State& state) {
      function(state, pair);
    })->Unit(benchmark::kMicrosecond);
  };
  with("create", bench_create);
  with("sum_cold", bench_sum_cold);
  with("sum_prepared", bench_sum_prepared);
  with("sum_and_copy", bench_sum_and_copy);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gcv;
  add("tiny", pair_of(8, [](Random& random, int) { return bench::tiny(random); }));
  add("convex_8", pair_of(8, bench::random_convex));
  add("convex_1000", pair_of(1000, bench::random_convex));
  add("stars_40", pair_of(40, test::random_spiky_star));
  if (const auto data = test::data_directory()) {
    add("fork", {test::read_polygon(*data / "cgal/fork_a.wkt"),
                 test::read_polygon(*data / "cgal/fork_b.wkt")});
  }
  add("combs_9", {bench::comb(9), bench::quarter_turned(bench::comb(9))});
  add("coasts_100", pair_of(100, bench::coast));
  add("coasts_10000", pair_of(10000, bench::coast));
  const Pair coasts = pair_of(100000, bench::coast);
  const auto add_one_and_two = [&](const char* name, auto* function) {
    benchmark::RegisterBenchmark(
        name, [coasts, function](benchmark::State& state) { function(state, coasts); })
        ->Arg(1)
        ->Arg(2)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  add_one_and_two("coasts_100000/threads", bench_threads);
  add_one_and_two("coasts_100000/copies", bench_copies);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

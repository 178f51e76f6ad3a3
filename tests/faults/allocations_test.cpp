// SPDX-License-Identifier: LGPL-3.0-or-later
//
// For every call that takes memory, and for every n: the n-th allocation fails, alone or with
// all after it. The call says so, writes nothing, gives back what it took, and does the same
// as ever once there is memory again. What GMP takes never fails, but must be given back too. No
// threads are given, so that all allocations come in the same order.
#include <gmp.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <new>
#include <utility>

#include "pairs.hpp"
#include "questions.hpp"
#include "refused_threads.hpp"

// ------------------------------------------------------------- the program's operator new --

namespace {

constexpr long never = std::numeric_limits<long>::max();

long live = 0;             // blocks that were taken and not given back
long until_fault = never;  // allocations that go well
long faults_left = 0;      // allocations that fail after these
bool failed = false;
bool failed_loudly = false;  // in an allocation that throws

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  if (until_fault > 0) {
    --until_fault;
  } else if (faults_left > 0) {
    --faults_left;
    failed = true;
    return nullptr;
  }
  // aligned_alloc takes multiples of the alignment.
  const std::size_t rounded = (std::max<std::size_t>(size, 1) + alignment - 1) & ~(alignment - 1);
  void* const block = rounded < size ? nullptr : std::aligned_alloc(alignment, rounded);
  live += block != nullptr ? 1 : 0;
  return block;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  void* const block = allocate(size, alignment);
  if (block == nullptr) {
    failed_loudly = true;
    throw std::bad_alloc();
  }
  return block;
}

void release(void* block) noexcept {
  live -= block != nullptr ? 1 : 0;
  std::free(block);
}

constexpr std::size_t plain = __STDCPP_DEFAULT_NEW_ALIGNMENT__;
using Alignment = std::align_val_t;
using Quiet = std::nothrow_t;

std::size_t bytes(Alignment alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

void* operator new(std::size_t n) { return allocate_or_throw(n, plain); }
void* operator new[](std::size_t n) { return allocate_or_throw(n, plain); }
void* operator new(std::size_t n, Alignment a) { return allocate_or_throw(n, bytes(a)); }
void* operator new[](std::size_t n, Alignment a) { return allocate_or_throw(n, bytes(a)); }
void* operator new(std::size_t n, const Quiet&) noexcept { return allocate(n, plain); }
void* operator new[](std::size_t n, const Quiet&) noexcept { return allocate(n, plain); }
void* operator new(std::size_t n, Alignment a, const Quiet&) noexcept {
  return allocate(n, bytes(a));
}
void* operator new[](std::size_t n, Alignment a, const Quiet&) noexcept {
  return allocate(n, bytes(a));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, Alignment) noexcept { release(block); }
void operator delete[](void* block, Alignment) noexcept { release(block); }
void operator delete(void* block, std::size_t, Alignment) noexcept { release(block); }
void operator delete[](void* block, std::size_t, Alignment) noexcept { release(block); }
void operator delete(void* block, const Quiet&) noexcept { release(block); }
void operator delete[](void* block, const Quiet&) noexcept { release(block); }
void operator delete(void* block, Alignment, const Quiet&) noexcept { release(block); }
void operator delete[](void* block, Alignment, const Quiet&) noexcept { release(block); }

namespace {

void count_memory_of_gmp() {
  mp_set_memory_functions(
      [](std::size_t size) {
        ++live;
        return std::malloc(size);
      },
      [](void* block, std::size_t, std::size_t size) { return std::realloc(block, size); },
      [](void* block, std::size_t) { release(block); });
}

// --------------------------------------------------------------------------- the attempts --

using gcv::faults::check;
using gcv::faults::Owner;

struct Faults {
  long first = never;  // the number of the allocation that fails, from 0
  long count = 0;
};

// Runs the call while the faults are there.
template <class Call>
gcv_status run(const Faults& faults, Call call) {
  failed = failed_loudly = false;
  until_fault = faults.first;
  faults_left = faults.count;
  const gcv_status status = call();
  until_fault = never;
  faults_left = 0;
  return status;
}

struct Outcome {
  gcv_status status;
  bool untouched;  // the output
  std::string transcript;
};

using Attempt = std::function<Outcome(const Faults&)>;

// call(&out) gives a handle.
template <class Handle, class Call>
Attempt handle(Call call) {
  return [call](const Faults& faults) {
    static char nothing;
    Handle* out = reinterpret_cast<Handle*>(&nothing);
    const gcv_status status = run(faults, [&] { return call(&out); });
    const Owner<Handle> owner(status == GCV_OK ? out : nullptr);
    return Outcome{status, out == reinterpret_cast<Handle*>(&nothing),
                   owner ? gcv::faults::transcript(out) : ""};
  };
}

// call(text, capacity, &required) gives text.
template <class Call>
Attempt text(Call call) {
  return [call](const Faults& faults) {
    constexpr std::size_t capacity = 4096;
    const std::string untouched(capacity, '?');
    std::string out = untouched;
    std::size_t required = 0;
    const gcv_status status = run(faults, [&] { return call(out.data(), capacity, &required); });
    return Outcome{status, out == untouched, out};
  };
}

enum class Threads { one, many };

// Gives the number of allocations that the attempt takes.
long starve(const std::string& name, const Attempt& attempt, long faults_at_once,
            const Outcome& expected, Threads threads) {
  for (long n = 0;; ++n) {
    const std::string where = name + ", allocation " + std::to_string(n);
    const long live_before = live;
    {
      const Outcome outcome = attempt({n, faults_at_once});
      const bool well = outcome.status == GCV_OK;
      if (!failed) {
        check(well && outcome.transcript == expected.transcript, where, " is one too many");
        return n;
      }
      // Who asks politely may go on without, and who asks for a thread.
      check(well ? !failed_loudly || threads == Threads::many : outcome.status == GCV_ERR_NO_MEMORY,
            where + " gave ", gcv_status_name(outcome.status));
      check(well ? outcome.transcript == expected.transcript : outcome.untouched, where,
            " gave a wrong result");
    }
    check(live == live_before, where, " leaks");
    check(attempt({}).transcript == expected.transcript, where, " changes later results");
    check(live == live_before, where, " leaks later");
  }
}

void starve(const std::string& name, const Attempt& attempt, Threads threads = Threads::one) {
  const Outcome expected = attempt({});
  check(expected.status == GCV_OK && !expected.untouched, name, " does nothing");
  const long allocations = starve(name, attempt, 1, expected, threads);
  starve(name + ", and all later ones", attempt, never, expected, threads);
  check(allocations > 0, name, " takes no memory");
  std::printf("%s: %ld allocations\n", name.c_str(), allocations);
}

Attempt simplified(const gcv_polygon* polygon, double tolerance, std::int32_t rounding) {
  return handle<gcv_polygon>([=](gcv_polygon** out) {
    double bound = -1;
    const gcv_status status = gcv_polygon_simplified(polygon, tolerance, rounding, out, &bound);
    check(status == GCV_OK ? bound >= 0 : bound == -1, "gcv_polygon_simplified",
          " gave a wrong bound");
    return status;
  });
}

void starve_sums(const gcv::faults::Pair& pair) {
  static constexpr double point[] = {0.5, -0.25};
  const gcv_polygon* const a = pair.a.get();
  const gcv_polygon* const b = pair.b.get();
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    const gcv_options options = gcv::faults::options(rounding);
    const auto name = [&](const char* function) {
      return std::string(function) + " of " + pair.name + ", rounding " + std::to_string(rounding);
    };
    starve(name("gcv_minkowski_sum"), handle<gcv_outer_face>([=](gcv_outer_face** out) {
             return gcv_minkowski_sum(a, b, &options, out);
           }));
    starve(name("gcv_no_fit_polygon"), handle<gcv_outer_face>([=](gcv_outer_face** out) {
             return gcv_no_fit_polygon(a, b, point, &options, out);
           }));
    starve(name("gcv_entrance_block"), handle<gcv_outer_face>([=](gcv_outer_face** out) {
             return gcv_entrance_block(a, b, point, &options, out);
           }));
    const gcv_options within = gcv::faults::options(rounding, pair.tolerance);
    starve(name("gcv_no_fit_polygon within a tolerance"),
           handle<gcv_outer_face>([=](gcv_outer_face** out) {
             return gcv_no_fit_polygon(a, b, point, &within, out);
           }));
    starve(name("gcv_polygon_simplified"), simplified(a, pair.tolerance, rounding));
  }
}

void starve_regions(const gcv::faults::Pair& pair) {
  static constexpr double point[] = {0.5, -0.25};
  const gcv_polygon* const a = pair.a.get();
  const gcv_polygon* const b = pair.b.get();
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    const gcv_options options = gcv::faults::options(rounding);
    const std::string of =
        std::string(" of ") + pair.name + ", rounding " + std::to_string(rounding);
    starve("gcv_minkowski_sum_region" + of, handle<gcv_region>([=](gcv_region** out) {
             return gcv_minkowski_sum_region(a, b, &options, out);
           }));
    starve("gcv_no_fit_region" + of, handle<gcv_region>([=](gcv_region** out) {
             return gcv_no_fit_region(a, b, point, &options, out);
           }));
    starve("gcv_inner_fit_region" + of, handle<gcv_region>([=](gcv_region** out) {
             return gcv_inner_fit_region(a, b, point, &options, out);
           }));
  }
  const Owner<gcv_region> owner = gcv::faults::made<gcv_region>(
      [=](gcv_region** out) { return gcv_minkowski_sum_region(a, b, nullptr, out); });
  const gcv_region* const region = owner.get();
  const std::string of = std::string(" of ") + pair.name;
  starve("gcv_region_wkt" + of, text([=](char* out, std::size_t capacity, std::size_t* required) {
           return gcv_region_wkt(region, out, capacity, required);
         }));
  starve("gcv_region_fits_wkt" + of,
         text([=](char* out, std::size_t capacity, std::size_t* required) {
           return gcv_region_fits_wkt(region, out, capacity, required);
         }));
  starve("gcv_region_polygon" + of, handle<gcv_polygon>([=](gcv_polygon** out) {
           return gcv_region_polygon(region, 0, out);
         }));
}

void starve_all_of(const gcv::faults::Pair& pair) {
  const std::string of = std::string(" of ") + pair.name;
  const gcv_polygon* const a = pair.a.get();
  const gcv_polygon* const b = pair.b.get();
  const Owner<gcv_outer_face> owner = gcv::faults::made<gcv_outer_face>(
      [=](gcv_outer_face** out) { return gcv_minkowski_sum(a, b, nullptr, out); });
  const gcv_outer_face* const face = owner.get();
  starve_sums(pair);
  starve_regions(pair);
  starve("gcv_outer_face_exact_vertex" + of,
         text([=](char* out, std::size_t capacity, std::size_t* required) {
           return gcv_outer_face_exact_vertex(face, 1, out, capacity, required);
         }));
  starve("gcv_outer_face_wkt" + of,
         text([=](char* out, std::size_t capacity, std::size_t* required) {
           return gcv_outer_face_wkt(face, out, capacity, required);
         }));
  starve("gcv_outer_face_polygon" + of,
         handle<gcv_polygon>([=](gcv_polygon** out) { return gcv_outer_face_polygon(face, out); }));
  starve("gcv_superset_create" + of,
         handle<gcv_superset>([=](gcv_superset** out) { return gcv_superset_create(a, b, out); }));
}

// The polygons are new: the call prepares them. Once it has failed, the same ones must do.
Attempt answers(std::size_t pair_number, const gcv::faults::Question& question, std::size_t count,
                std::size_t near, Threads threads = Threads::one) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = threads == Threads::many ? 3 : 1;
  const auto attempt = [=](const Faults& faults, const std::string& expected) {
    const gcv::faults::Pair pair = std::move(gcv::faults::pairs()[pair_number]);
    const gcv::faults::Places places = gcv::faults::places_of(pair, count, near);
    const std::string untouched(count * question.answer_size, '?');
    std::string out = untouched;
    const gcv_status status =
        run(faults, [&] { return question.ask(pair, places, &options, out.data()); });
    check(status == GCV_OK || gcv::faults::answers(question, pair, places, nullptr) == expected,
          question.name, " answers otherwise once it has failed");
    return Outcome{status, out == untouched, out};
  };
  const std::string expected = attempt({}, "").transcript;
  return [=](const Faults& faults) { return attempt(faults, expected); };
}

// Few answers need no memory of their own. With many, threads are asked for.
void starve_questions(std::size_t pair_number, const char* pair_name) {
  constexpr std::size_t few = 6;
  constexpr std::size_t many = 140;
  for (const gcv::faults::Question& question : gcv::faults::questions) {
    const std::string of = std::string(question.name) + " of " + pair_name;
    const std::size_t near = question.takes_memory ? few : many;
    starve(of + " in few places", answers(pair_number, question, few, few));
    starve(of + " in many places", answers(pair_number, question, many, near));
    gcv::faults::threads_refused = 0;
    starve(of + " in many places on threads",
           answers(pair_number, question, many, near, Threads::many), Threads::many);
    check(gcv::faults::threads_refused > 0, of, " asks for no threads");
  }
}

// The polygons are new here too, and there again once the call has failed.
void starve_contacts(std::size_t pair_number, const char* pair_name) {
  constexpr std::size_t few = 4;
  for (std::size_t place = 0; place < few; ++place) {
    const auto attempt = [=](const Faults& faults, const std::string& expected) {
      const gcv::faults::Pair pair = std::move(gcv::faults::pairs()[pair_number]);
      const gcv::faults::Places places = gcv::faults::places_of(pair, few);
      const auto call = [&](gcv_contact_list** out) {
        return gcv::faults::contacts_at(pair, places, place, out);
      };
      const Outcome outcome = handle<gcv_contact_list>(call)(faults);
      check(
          outcome.status == GCV_OK ||
              gcv::faults::transcript(gcv::faults::made<gcv_contact_list>(call).get()) == expected,
          "gcv_contacts", " gives others once it has failed");
      return outcome;
    };
    const std::string expected = attempt({}, "").transcript;
    starve(std::string("gcv_contacts of ") + pair_name + ", place " + std::to_string(place),
           [=](const Faults& faults) { return attempt(faults, expected); });
  }
}

// Two holes in a square, which touch.
constexpr double plate_xy[] = {0, 0, 4, 0, 4, 4, 0, 4, 1, 1, 2, 1, 1, 2, 2, 1, 3, 1, 3, 2};
constexpr std::size_t plate_sizes[] = {4, 3, 3};

// Gives the last one alone, where there are all.
gcv_status create_last_of_many(gcv_polygon** out) {
  constexpr std::size_t count = std::size(plate_sizes);
  gcv_polygon* polygons[count] = {};
  gcv_status statuses[count] = {};
  gcv_status status = gcv_polygon_create_many(plate_xy, plate_sizes, count, 0, polygons, statuses);
  for (std::size_t k = 0; k < count; ++k) {
    check((polygons[k] != nullptr) == (status == GCV_OK && statuses[k] == GCV_OK),
          "gcv_polygon_create_many", " gave a polygon or not");
  }
  for (const gcv_status other : statuses) {
    status = status == GCV_OK ? other : status;
  }
  if (status == GCV_OK) {
    *out = std::exchange(polygons[count - 1], nullptr);
  }
  for (gcv_polygon* const polygon : polygons) {
    gcv_polygon_destroy(polygon);
  }
  return status;
}

void starve_polygons() {
  static constexpr double xy[] = {0, 0, 1, 0, 4, 0, 4, 0, 4, 4, 2, 3, 0, 4};
  static constexpr std::string_view wkt =
      "POLYGON ((0 0, 4 0, 4 4, 2 3, 0 4, 0 0), (1 1, 2 1, 1 2), (3 1, 3 2, 2 2))";
  starve("gcv_polygon_create", handle<gcv_polygon>([](gcv_polygon** out) {
           return gcv_polygon_create(xy, std::size(xy) / 2, 0, out);
         }));
  starve("gcv_polygon_create_rings", handle<gcv_polygon>([](gcv_polygon** out) {
           return gcv_polygon_create_rings(plate_xy, plate_sizes, std::size(plate_sizes), 0, out);
         }));
  starve("gcv_polygon_create_many", handle<gcv_polygon>(create_last_of_many));
  starve("gcv_polygon_create_disc", handle<gcv_polygon>([](gcv_polygon** out) {
           return gcv_polygon_create_disc(xy, 1, 0.01, GCV_ROUND_OUTWARD, out);
         }));
  // Integers of more than 512 bits, for which GMP has to ask for memory.
  const Owner<gcv_polygon> plate = gcv::faults::read(wkt);
  for (const double tiny : {0.0, 0x1p-1074}) {
    starve("gcv_polygon_affine", handle<gcv_polygon>([&](gcv_polygon** out) {
             const double m[6] = {0.6, -0.8, tiny, 0.8, 0.6, -tiny};
             return gcv_polygon_affine(plate.get(), m, out);
           }));
  }
  starve("gcv_polygon_create_wkt", handle<gcv_polygon>([](gcv_polygon** out) {
           return gcv_polygon_create_wkt(wkt.data(), wkt.size(), out);
         }));
  // The tolerance has to be cut along the walls of the slit; outward, two vertices below become
  // one.
  const Owner<gcv_polygon> fork = gcv::faults::read(
      "POLYGON ((0 0, 3 -0.2, 5 -0.2, 8 0, 8 8, 4.5 8, 4.7 5, 4.5 2, 4 2, 4.6 5, 4 8, 0 8))");
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    starve("gcv_polygon_simplified of a fork, rounding " + std::to_string(rounding),
           simplified(fork.get(), 0.5, rounding));
    starve("gcv_polygon_simplified of a plate, rounding " + std::to_string(rounding),
           simplified(plate.get(), 0.5, rounding));
  }
}

}  // namespace

int main() {
  count_memory_of_gmp();
  starve_polygons();
  bool repaired = false;
  bool rational = false;
  const std::vector<gcv::faults::Pair> pairs = gcv::faults::pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const gcv::faults::Pair& pair = pairs[k];
    starve_all_of(pair);
    starve_questions(k, pair.name);
    starve_contacts(k, pair.name);
    const Owner<gcv_outer_face> face = gcv::faults::made<gcv_outer_face>([&](gcv_outer_face** out) {
      return gcv_minkowski_sum(pair.a.get(), pair.b.get(), nullptr, out);
    });
    const gcv_stats stats = gcv::faults::stats(face.get());
    repaired = repaired || stats.vertices_repaired > 0;
    rational = rational || stats.predicates_rational > 0;
  }
  check(repaired, "no pair had to be repaired");
  check(rational, "no pair took more than 512 bits");
}

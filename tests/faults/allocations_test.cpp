// SPDX-License-Identifier: LGPL-3.0-or-later
//
// For every call that takes memory, and for every n: the n-th allocation fails, alone or with
// all after it. The call says so, writes nothing, gives back what it took, and does the same
// as ever once there is memory again. No threads are given, so that all allocations come in the
// same order. Numbers take no memory, whatever their size.
#include <utility>

#include "attempts.hpp"
#include "questions.hpp"
#include "refused_threads.hpp"

namespace {

using gcv::faults::Attempt;
using gcv::faults::check;
using gcv::faults::Faults;
using gcv::faults::handle;
using gcv::faults::Outcome;
using gcv::faults::Owner;
using gcv::faults::run;
using gcv::faults::starve;
using gcv::faults::text;
using gcv::faults::Threads;

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
  std::size_t length = 0;
  gcv::faults::require(gcv_outer_face_exact_vertex(face, 1, nullptr, 0, &length));
  if (length > sizeof(std::string)) {  // shorter texts need no memory
    starve("gcv_outer_face_exact_vertex" + of,
           text([=](char* out, std::size_t capacity, std::size_t* required) {
             return gcv_outer_face_exact_vertex(face, 1, out, capacity, required);
           }));
  }
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

// Few answers need no memory of their own, nor do relations and distances of small convex polygons.
// With many, threads are asked for.
void starve_questions(std::size_t pair_number, const char* pair_name) {
  constexpr std::size_t few = 6;
  constexpr std::size_t many = 140;
  for (const gcv::faults::Question& question : gcv::faults::questions) {
    const std::string of = std::string(question.name) + " of " + pair_name;
    const std::size_t near = question.takes_memory ? few : many;
    if (of != "gcv_relation of convex" && of != "gcv_distance of convex") {
      starve(of + " in few places", answers(pair_number, question, few, few));
    }
    starve(of + " in many places", answers(pair_number, question, many, near));
    gcv::faults::threads_refused = 0;
    starve(of + " in many places on threads",
           answers(pair_number, question, many, near, Threads::many), Threads::many);
    check(gcv::faults::threads_refused > 0, of, " asks for no threads");
  }
}

// Once the polygons are prepared, distances take no memory: not even with numbers of all
// magnitudes.
void check_numbers(const gcv::faults::Pair& pair) {
  constexpr std::size_t few = 6;
  const gcv::faults::Question& distance = gcv::faults::questions[1];
  const gcv::faults::Places places = gcv::faults::places_of(pair, few);
  const std::string before = gcv::faults::answers(distance, pair, places, nullptr);
  std::string out = before;
  gcv::faults::until_fault = gcv::faults::never;
  gcv::faults::require(distance.ask(pair, places, nullptr, out.data()));
  check(gcv::faults::until_fault == gcv::faults::never, pair.name, ": a distance takes memory");
  check(out == before, pair.name, ": another distance");
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
  // Integers of more than 512 bits.
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
  starve_polygons();
  bool repaired = false;
  bool rational = false;
  const std::vector<gcv::faults::Pair> pairs = gcv::faults::pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const gcv::faults::Pair& pair = pairs[k];
    starve_all_of(pair);
    starve_questions(k, pair.name);
    starve_contacts(k, pair.name);
    check_numbers(pair);
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

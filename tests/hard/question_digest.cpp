// SPDX-License-Identifier: LGPL-3.0-or-later
#include "question_digest.hpp"

#include <gcv/gcv.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "digest.hpp"
#include "region_digest.hpp"
#include "region_operands.hpp"
#include "shapes.hpp"

namespace gcv::hard {

namespace {

using invariants::PolygonHandle;

struct SceneDestroy {
  void operator()(gcv_scene* scene) const { gcv_scene_destroy(scene); }
};

// Translations and motions from there.
struct Places {
  Polygon translations;
  Polygon motions;
};

// Vertices of the no-fit region; of the no-fit polygon where there are too many superset edges.
// None where they are beyond the largest double.
Polygon no_fit_vertices(const gcv_polygon* a, const gcv_polygon* moving, bool is_region) {
  const double origin[2] = {0, 0};
  if (is_region) {
    gcv_region* region = nullptr;
    const gcv_status status = gcv_no_fit_region(a, moving, origin, nullptr, &region);
    const std::unique_ptr<gcv_region, invariants::Destroy> owner(region);
    return status == GCV_OK ? invariants::vertices(gcv_region_vertices, owner.get()) : Polygon{};
  }
  gcv_outer_face* face = nullptr;
  const gcv_status status = gcv_no_fit_polygon(a, moving, origin, nullptr, &face);
  const std::unique_ptr<gcv_outer_face, invariants::Destroy> owner(face);
  return status == GCV_OK ? invariants::vertices(gcv_outer_face_vertices, owner.get()) : Polygon{};
}

// Some of the vertices, evenly spread.
Places places_at(const Polygon& vertices, std::size_t most) {
  const std::size_t step = vertices.size() / most + 1;
  Places places;
  for (std::size_t k = 0; k < vertices.size(); k += step) {
    places.translations.push_back(vertices[k]);
  }
  const std::size_t count = places.translations.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Point& from = places.translations[k];
    const Point& to = places.translations[(k + 1) % count];
    const Point way{to[0] - from[0], to[1] - from[1]};
    const bool is_finite = std::isfinite(way[0]) && std::isfinite(way[1]);
    places.motions.push_back(is_finite ? way : Point{0, 0});
  }
  return places;
}

// Adds what ask(first, count, threads, out) answers, on one thread and on several. Where there is
// no answer for all at once, each alone.
template <class Answer, class Ask>
void add_answers(Digest& digest, std::size_t count, Ask ask) {
  for (const std::int32_t threads : {1, 3}) {
    std::vector<Answer> answers(count);
    const gcv_status status = ask(std::size_t{0}, count, threads, answers.data());
    digest.add(&status, sizeof status);
    for (std::size_t k = 0; status != GCV_OK && k < count; ++k) {
      const gcv_status alone = ask(k, std::size_t{1}, threads, &answers[k]);
      digest.add(&alone, sizeof alone);
    }
    digest.add(answers);
  }
}

void add_questions(Digest& digest, const gcv_polygon* a, const gcv_polygon* moving,
                   const Places& places) {
  const std::size_t count = places.translations.size();
  if (count == 0) {
    return;
  }
  gcv_options options = GCV_OPTIONS_INIT;
  const auto with = [&](std::int32_t threads) {
    options.threads = threads;
    return &options;
  };
  const auto from = [&](std::size_t first) { return places.translations[first].data(); };
  add_answers<std::int8_t>(
      digest, count,
      [&](std::size_t first, std::size_t number, std::int32_t threads, std::int8_t* out) {
        return gcv_relation(a, moving, from(first), number, with(threads), out);
      });
  add_answers<gcv_separation>(
      digest, count,
      [&](std::size_t first, std::size_t number, std::int32_t threads, gcv_separation* out) {
        return gcv_distance(a, moving, from(first), number, with(threads), out);
      });
  add_answers<gcv_impact>(
      digest, count,
      [&](std::size_t first, std::size_t number, std::int32_t threads, gcv_impact* out) {
        return gcv_cast(a, moving, from(first), places.motions[first].data(), number, with(threads),
                        out);
      });
}

Polygon middles_of_motions(const Places& places) {
  Polygon middles = places.translations;
  for (std::size_t k = 0; k < middles.size(); ++k) {
    middles[k][0] += places.motions[k][0] / 2;
    middles[k][1] += places.motions[k][1] / 2;
  }
  return middles;
}

// Ways out from the middle of each motion, with all parts and with fits or holes left out.
void add_ways_out(Digest& digest, const gcv_polygon* a, const gcv_polygon* moving,
                  const Places& places) {
  const Polygon middles = middles_of_motions(places);
  gcv_options options = GCV_OPTIONS_INIT;
  for (const int leave_out : {0, int{GCV_LEAVE_OUT_FITS}, int{GCV_LEAVE_OUT_HOLES}}) {
    options.leave_out = static_cast<std::uint64_t>(leave_out);
    add_answers<gcv_escape>(
        digest, middles.size(),
        [&](std::size_t first, std::size_t number, std::int32_t threads, gcv_escape* out) {
          options.threads = threads;
          return gcv_penetration(a, moving, middles[first].data(), number, &options, out);
        });
  }
}

void add_contacts_of(Digest& digest, const gcv_contact_list* list) {
  std::size_t count = 0;
  bool read = gcv_contact_list_contacts(list, nullptr, 0, &count) == GCV_OK;
  std::vector<gcv_contact> contacts(count);
  read = read && gcv_contact_list_contacts(list, contacts.data(), count, &count) == GCV_OK;
  digest.add(&read, sizeof read);
  digest.add(contacts);
}

// Contacts within a small part of each motion, with and without a slope.
void add_contacts(Digest& digest, const gcv_polygon* a, const gcv_polygon* moving,
                  const Places& places) {
  for (std::size_t k = 0; k < places.translations.size(); ++k) {
    const Point& way = places.motions[k];
    const double distance = std::max(std::abs(way[0]), std::abs(way[1])) / 1024;
    for (const double slope : {0.0, 0x1p-40}) {
      gcv_contact_list* list = nullptr;
      const gcv_status status =
          gcv_contacts(a, moving, places.translations[k].data(), distance, slope, nullptr, &list);
      digest.add(&status, sizeof status);
      add_contacts_of(digest, list);
      gcv_contact_list_destroy(list);
    }
  }
}

void add_pairs_of(Digest& digest, const gcv_pair_list* list) {
  std::size_t count = 0;
  bool read = gcv_pair_list_pairs(list, nullptr, 0, &count) == GCV_OK;
  std::vector<gcv_pair> pairs(count);
  read = read && gcv_pair_list_pairs(list, pairs.data(), count, &count) == GCV_OK;
  digest.add(&read, sizeof read);
  digest.add(pairs);
}

// A as the container and as a member, the polygon that moves at all places, some of them taken out
// again.
struct Scene {
  Scene(Digest& digest, const gcv_polygon* a, const gcv_polygon* moving, const Polygon& positions)
      : ids(positions.size()) {
    gcv_scene* scene = nullptr;
    gcv_status status = gcv_scene_create(&scene);
    handle.reset(scene);
    const double origin[2] = {0, 0};
    std::uint64_t id = 0;
    const std::vector<const gcv_polygon*> members(ids.size(), moving);
    for (const gcv_status step :
         {gcv_scene_set_container(scene, a), gcv_scene_add(scene, &a, origin, 1, &id),
          gcv_scene_add(scene, members.data(), positions.front().data(), ids.size(), ids.data()),
          gcv_scene_remove(scene, ids.data(), ids.size() / 3)}) {
      status = status == GCV_OK ? step : status;
    }
    digest.add(&status, sizeof status);
  }

  std::unique_ptr<gcv_scene, SceneDestroy> handle;
  std::vector<std::uint64_t> ids;
};

// Lists of what is near in a scene, and the polygon that moves asked about in between. On one
// thread and on several.
void add_scene(Digest& digest, const gcv_polygon* a, const gcv_polygon* moving,
               const Places& places) {
  const std::size_t count = places.translations.size();
  if (count == 0) {
    return;
  }
  const Scene made(digest, a, moving, places.translations);
  const gcv_scene* const scene = made.handle.get();
  gcv_status status = GCV_OK;
  const Point& way = places.motions.front();
  const double distance = std::max(std::abs(way[0]), std::abs(way[1])) / 1024;
  gcv_options options = GCV_OPTIONS_INIT;
  for (const std::int32_t threads : {1, 3}) {
    options.threads = threads;
    gcv_pair_list* pairs = nullptr;
    gcv_contact_list* contacts = nullptr;
    status = gcv_scene_pairs(scene, nullptr, distance, nullptr, &options, &pairs);
    digest.add(&status, sizeof status);
    add_pairs_of(digest, pairs);
    status = gcv_scene_contacts(scene, nullptr, distance, 0, nullptr, &options, &contacts);
    digest.add(&status, sizeof status);
    add_contacts_of(digest, contacts);
    gcv_contact_list_destroy(contacts);
    gcv_pair_list_destroy(pairs);
  }
  gcv_query query = GCV_QUERY_INIT;
  query.ignore = &made.ids.back();
  query.ignore_count = 1;
  const auto from = [&](std::size_t first) { return places.translations[first].data(); };
  const auto with = [&](std::int32_t threads) {
    options.threads = threads;
    return &options;
  };
  add_answers<gcv_separation>(
      digest, count,
      [&](std::size_t first, std::size_t number, std::int32_t threads, gcv_separation* out) {
        return gcv_scene_distance(scene, moving, from(first), number, &query, with(threads), out);
      });
  add_answers<gcv_impact>(
      digest, count,
      [&](std::size_t first, std::size_t number, std::int32_t threads, gcv_impact* out) {
        return gcv_scene_cast(scene, moving, from(first), places.motions[first].data(), number,
                              &query, with(threads), out);
      });
}

// What is free in a scene, without the member A: in the container and in a window, furthest in four
// directions, and nearest to the middles of motions.
void add_free_positions(Digest& digest, const gcv_polygon* a, const gcv_polygon* moving,
                        const Places& places) {
  if (places.translations.empty()) {
    return;
  }
  const Scene made(digest, a, moving, places.translations);
  const gcv_scene* const scene = made.handle.get();
  const std::uint64_t first_id = 2;
  gcv_query query = GCV_QUERY_INIT;
  query.ignore = &first_id;
  query.ignore_count = 1;
  double box[4] = {0, 0, 0, 0};
  const gcv_status status = gcv_polygon_bounds(a, box);
  digest.add(&status, sizeof status);
  const double window[4] = {box[0], box[1], box[0] / 2 + box[2] / 2, box[1] / 2 + box[3] / 2};
  const double* const everywhere = nullptr;
  for (const double* const bounds : {everywhere, window}) {
    add_regions(digest, [&](const gcv_options* options, gcv_region** out) {
      return gcv_scene_free_region(scene, moving, bounds, &query, options, out);
    });
  }
  for (const Point& direction : {Point{-1, 0}, {0, -1}, {1, 0x1p-30}, {3, 4}}) {
    Point position{0, 0};
    std::int32_t found = 0;
    const gcv_status best =
        gcv_scene_best(scene, moving, direction.data(), &query, nullptr, position.data(), &found);
    digest.add(&best, sizeof best);
    digest.add(&found, sizeof found);
    digest.add(position.data(), sizeof position);
  }
  const Polygon middles = middles_of_motions(places);
  gcv_options options = GCV_OPTIONS_INIT;
  add_answers<gcv_escape>(
      digest, middles.size(),
      [&](std::size_t first, std::size_t number, std::int32_t threads, gcv_escape* out) {
        options.threads = threads;
        return gcv_scene_penetration(scene, moving, middles[first].data(), number, &query, &options,
                                     out);
      });
}

// Pairs with few superset edges, or the first one.
struct Chosen {
  explicit Chosen(const Pairs& all) : pairs(region_pairs(all, 10)), are_small(!pairs.empty()) {
    if (!are_small) {
      pairs = {all.front()};
    }
  }
  Pairs pairs;
  bool are_small;
};

// Calls add(digest, a, moving, places) for each pair, for that many places at most.
template <class Add>
std::uint64_t digest_of_pairs(const Pairs& pairs, std::size_t most_places, Add add) {
  const Chosen chosen(pairs);
  Digest digest;
  for (const Pair& pair : chosen.pairs) {
    const PolygonHandle a = invariants::make(pair.a);
    const PolygonHandle moving = invariants::make(negated(pair.b));
    add(digest, a.get(), moving.get(),
        places_at(no_fit_vertices(a.get(), moving.get(), chosen.are_small), most_places));
  }
  return digest.value();
}

}  // namespace

std::uint64_t digest_of_questions(const Pairs& pairs) {
  constexpr std::size_t most_places = 150;  // more than one thread takes at once
  return digest_of_pairs(pairs, most_places, add_questions);
}

std::uint64_t digest_of_overlaps(const Pairs& pairs) {
  constexpr std::size_t most_places = 20;
  return digest_of_pairs(
      pairs, most_places,
      [](Digest& digest, const gcv_polygon* a, const gcv_polygon* moving, const Places& places) {
        add_ways_out(digest, a, moving, places);
        add_contacts(digest, a, moving, places);
      });
}

std::uint64_t digest_of_scenes(const Pairs& pairs) {
  constexpr std::size_t most_places = 12;
  return digest_of_pairs(pairs, most_places, add_scene);
}

std::uint64_t digest_of_free_positions(const Pairs& pairs) {
  constexpr std::size_t most_pairs = 3;
  constexpr std::size_t most_places = 4;
  const Pairs small = region_pairs(pairs, most_pairs);
  return small.empty() ? 0 : digest_of_pairs(small, most_places, add_free_positions);
}

}  // namespace gcv::hard

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The questions about a pair of polygons, at places all around and in contact, and the answers,
// byte by byte.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pairs.hpp"

namespace gcv::faults {

// Translations of the second polygon and motions from there.
struct Places {
  std::vector<Vertex> translations;
  std::vector<Vertex> motions;

  [[nodiscard]] std::size_t count() const { return translations.size(); }
  [[nodiscard]] const double* xy() const { return &translations.front().x; }
  [[nodiscard]] const double* motions_xy() const { return &motions.front().x; }
};

inline std::vector<Vertex> vertices_of(const gcv_polygon* polygon) {
  std::size_t count = 0;
  require(gcv_polygon_vertices(polygon, nullptr, 0, &count));
  std::vector<Vertex> vertices(count);
  require(gcv_polygon_vertices(polygon, &vertices.front().x, count, &count));
  return vertices;
}

// In contact, and in steps through both boxes; from number `near` on beyond them. Each motion leads
// to the place before.
inline Places places_of(const Pair& pair, std::size_t count, std::size_t near) {
  const std::vector<Vertex> a = vertices_of(pair.a.get());
  const std::vector<Vertex> b = vertices_of(pair.b.get());
  double a_box[4];
  double b_box[4];
  require(gcv_polygon_bounds(pair.a.get(), a_box));
  require(gcv_polygon_bounds(pair.b.get(), b_box));
  const Vertex low{a_box[0] - b_box[2], a_box[1] - b_box[3]};
  const Vertex high{a_box[2] - b_box[0], a_box[3] - b_box[1]};
  const auto step = [](std::size_t k, std::size_t prime) {
    return static_cast<double>(k % prime) / static_cast<double>(prime - 1) * 1.5 - 0.25;
  };
  Places places;
  for (std::size_t k = 0; k < count; ++k) {
    const Vertex& p = a[k % a.size()];
    const Vertex& q = b[k / a.size() % b.size()];
    const Vertex t = k >= near    ? Vertex{high.x + (high.x - low.x), high.y}
                     : k % 2 == 0 ? Vertex{p.x - q.x, p.y - q.y}
                                  : Vertex{low.x + step(k, 13) * (high.x - low.x),
                                           low.y + step(k, 11) * (high.y - low.y)};
    const Vertex before = k == 0 ? Vertex{0, 0} : places.translations.back();
    places.translations.push_back(t);
    places.motions.push_back({before.x - t.x, before.y - t.y});
  }
  return places;
}

inline Places places_of(const Pair& pair, std::size_t count) {
  return places_of(pair, count, count);
}

struct Question {
  const char* name;
  std::size_t answer_size;
  bool takes_memory;  // at every place where they overlap
  gcv_status (*ask)(const Pair& pair, const Places& places, const gcv_options* options, void* out);
};

inline constexpr Question questions[] = {
    {"gcv_relation", sizeof(std::int8_t), false,
     [](const Pair& pair, const Places& places, const gcv_options* options, void* out) {
       return gcv_relation(pair.a.get(), pair.b.get(), places.xy(), places.count(), options,
                           static_cast<std::int8_t*>(out));
     }},
    {"gcv_distance", sizeof(gcv_separation), false,
     [](const Pair& pair, const Places& places, const gcv_options* options, void* out) {
       return gcv_distance(pair.a.get(), pair.b.get(), places.xy(), places.count(), options,
                           static_cast<gcv_separation*>(out));
     }},
    {"gcv_cast", sizeof(gcv_impact), false,
     [](const Pair& pair, const Places& places, const gcv_options* options, void* out) {
       return gcv_cast(pair.a.get(), pair.b.get(), places.xy(), places.motions_xy(), places.count(),
                       options, static_cast<gcv_impact*>(out));
     }},
    {"gcv_penetration", sizeof(gcv_escape), true,
     [](const Pair& pair, const Places& places, const gcv_options* options, void* out) {
       return gcv_penetration(pair.a.get(), pair.b.get(), places.xy(), places.count(), options,
                              static_cast<gcv_escape*>(out));
     }},
    {"gcv_penetration without holes and fits", sizeof(gcv_escape), true,
     [](const Pair& pair, const Places& places, const gcv_options* options, void* out) {
       gcv_options without = options == nullptr ? gcv_options GCV_OPTIONS_INIT : *options;
       without.leave_out = GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS;
       return gcv_penetration(pair.a.get(), pair.b.get(), places.xy(), places.count(), &without,
                              static_cast<gcv_escape*>(out));
     }},
};

inline std::string answers(const Question& question, const Pair& pair, const Places& places,
                           const gcv_options* options) {
  std::string bytes(places.count() * question.answer_size, '?');
  require(question.ask(pair, places, options, bytes.data()));
  return bytes;
}

// The contacts at place k, within the length of the motion there.
inline gcv_status contacts_at(const Pair& pair, const Places& places, std::size_t k,
                              gcv_contact_list** out) {
  const Vertex& way = places.motions[k];
  constexpr double slope = 0.125;
  return gcv_contacts(pair.a.get(), pair.b.get(), &places.translations[k].x,
                      std::hypot(way.x, way.y), slope, nullptr, out);
}

}  // namespace gcv::faults

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "library.hpp"

#include <array>
#include <stdexcept>

namespace worlds {
namespace {

// Any of the functions that give the text of a vertex.
template <class Handle, class Function>
std::string vertex(const Handle& handle, std::size_t index, Function exact_vertex) {
  std::array<char, 128> buffer{};
  std::size_t required = 0;
  check(exact_vertex(&handle, index, buffer.data(), buffer.size(), &required));
  return " (" + std::string(buffer.data()) + ")";
}

// One answer for each place.
template <class Answer, class Ask>
std::vector<Answer> ask(const std::vector<double>& places, Ask question) {
  std::vector<Answer> answers(places.size() / 2);
  check(question(places.data(), answers.size(), answers.data()));
  return answers;
}

}  // namespace

void check(gcv_status status) {
  if (status != GCV_OK) {
    throw std::runtime_error(gcv_status_name(status) + std::string(": ") +
                             gcv_last_error_message());
  }
}

gcv_status make_polygon(const Polygon& polygon, Owner<gcv_polygon>& out) {
  std::vector<double> xy;
  std::vector<std::size_t> sizes;
  for (const Ring& ring : polygon) {
    sizes.push_back(ring.size());
    for (const Point& p : ring) {
      xy.insert(xy.end(), {static_cast<double>(p.x), static_cast<double>(p.y)});
    }
  }
  gcv_polygon* handle = nullptr;
  const gcv_status status =
      gcv_polygon_create_rings(xy.data(), sizes.data(), sizes.size(), 0, &handle);
  out.reset(handle);
  return status;
}

Owner<gcv_polygon> make_polygon(const Polygon& polygon) {
  Owner<gcv_polygon> out;
  check(make_polygon(polygon, out));
  return out;
}

std::string text(const gcv_region& region) {
  static const std::array<std::string, 5> kinds{"", "outer ring", "hole", "segment", "point"};
  std::size_t count = 0;
  check(gcv_region_exact_parts(&region, nullptr, 0, &count));
  std::vector<gcv_region_part> parts(count);
  check(gcv_region_exact_parts(&region, parts.data(), count, &count));
  std::string result;
  std::size_t index = 0;
  std::uint32_t polygons = 0;
  for (const gcv_region_part& part : parts) {
    polygons += part.kind == GCV_PART_OUTER ? 1 : 0;
    const bool is_ring = part.kind <= GCV_PART_HOLE;
    if (part.polygon != (is_ring ? polygons - 1 : UINT32_MAX)) {
      result += "  of polygon " + std::to_string(part.polygon) + ":\n";
    }
    result += "  " + kinds.at(static_cast<std::size_t>(part.kind)) + ":";
    for (std::uint64_t k = 0; k < part.vertex_count; ++k) {
      result += vertex(region, index++, gcv_region_exact_vertex);
    }
    result += "\n";
  }
  return result;
}

std::string text(const gcv_outer_face& face) {
  std::size_t count = 0;
  check(gcv_outer_face_exact_vertex_count(&face, &count));
  std::string result = "  outer ring:";
  for (std::size_t k = 0; k < count; ++k) {
    result += vertex(face, k, gcv_outer_face_exact_vertex);
  }
  return result + "\n";
}

std::vector<std::int8_t> PairSubject::relation(const std::vector<double>& places) const {
  return ask<std::int8_t>(places, [&](const double* xy, std::size_t count, auto* out) {
    return gcv_relation(&a_, &b_, xy, count, nullptr, out);
  });
}

std::vector<gcv_separation> PairSubject::distance(const std::vector<double>& places) const {
  return ask<gcv_separation>(places, [&](const double* xy, std::size_t count, auto* out) {
    return gcv_distance(&a_, &b_, xy, count, nullptr, out);
  });
}

std::vector<gcv_escape> PairSubject::penetration(const std::vector<double>& places) const {
  return ask<gcv_escape>(places, [&](const double* xy, std::size_t count, auto* out) {
    return gcv_penetration(&a_, &b_, xy, count, nullptr, out);
  });
}

std::vector<std::int8_t> SceneSubject::relation(const std::vector<double>& places) const {
  return ask<std::int8_t>(places, [&](const double* xy, std::size_t count, auto* out) {
    return gcv_scene_relation(&scene_, &moving_, xy, count, nullptr, nullptr, out);
  });
}

std::vector<gcv_separation> SceneSubject::distance(const std::vector<double>& places) const {
  return ask<gcv_separation>(places, [&](const double* xy, std::size_t count, auto* out) {
    return gcv_scene_distance(&scene_, &moving_, xy, count, nullptr, nullptr, out);
  });
}

std::vector<gcv_escape> SceneSubject::penetration(const std::vector<double>& places) const {
  return ask<gcv_escape>(places, [&](const double* xy, std::size_t count, auto* out) {
    return gcv_scene_penetration(&scene_, &moving_, xy, count, nullptr, nullptr, out);
  });
}

}  // namespace worlds

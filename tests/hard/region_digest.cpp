// SPDX-License-Identifier: LGPL-3.0-or-later
#include "region_digest.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gcv::hard {

namespace {

// All elements of a list of the library's, or none where it cannot be read.
template <class Element, class Get>
std::vector<Element> list(const gcv_region* region, Get get) {
  std::size_t count = 0;
  if (get(region, nullptr, 0, &count) != GCV_OK) {
    return {};
  }
  std::vector<Element> elements(count);
  return get(region, elements.data(), count, &count) == GCV_OK ? elements : std::vector<Element>{};
}

void add_parts(Digest& digest, const std::vector<gcv_region_part>& parts) {
  for (const gcv_region_part& part : parts) {
    digest.add(&part.kind, sizeof part.kind);
    digest.add(&part.polygon, sizeof part.polygon);
    digest.add(&part.vertex_count, sizeof part.vertex_count);
  }
}

gcv_status vertices_of(const gcv_region* region, std::array<double, 2>* out, std::size_t capacity,
                       std::size_t* required) {
  return gcv_region_vertices(region, out == nullptr ? nullptr : out->data(), capacity, required);
}

void add_exact_parts(Digest& digest, const gcv_region* region) {
  add_parts(digest, list<gcv_region_part>(region, gcv_region_exact_parts));
  const auto sources = list<gcv_edge_source>(region, gcv_region_edge_sources);
  digest.add(sources);
  std::string text;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    std::size_t length = 0;
    bool read = gcv_region_exact_vertex(region, k, nullptr, 0, &length) == GCV_OK;
    text.resize(length);
    read = read && gcv_region_exact_vertex(region, k, text.data(), length, &length) == GCV_OK;
    digest.add(&read, sizeof read);
    digest.add(text.data(), text.size());
  }
}

void add_rounded_parts(Digest& digest, const gcv_region* region) {
  add_parts(digest, list<gcv_region_part>(region, gcv_region_parts));
  const auto vertices = list<std::array<double, 2>>(region, vertices_of);
  digest.add(vertices);
  digest.add(list<std::uint64_t>(region, gcv_region_exact_indices));
  std::vector<std::int8_t> places(vertices.size());
  bool read = vertices.empty() || gcv_region_locate(region, vertices.front().data(),
                                                    vertices.size(), places.data()) == GCV_OK;
  digest.add(places);
  double bound = 0;
  gcv_stats stats = {};
  stats.struct_size = sizeof stats;
  read = read && gcv_region_error_bound(region, &bound) == GCV_OK;
  read = read && gcv_region_stats(region, &stats) == GCV_OK;
  digest.add(&read, sizeof read);
  digest.add(&bound, sizeof bound);
  digest.add(&stats.vertices_repaired, sizeof stats.vertices_repaired);
  digest.add(&stats.parts_dropped, sizeof stats.parts_dropped);
}

}  // namespace

void add_regions(Digest& digest, const ComputeRegion& compute) {
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    gcv_options options = GCV_OPTIONS_INIT;
    options.rounding = rounding;
    gcv_region* region = nullptr;
    const gcv_status status = compute(&options, &region);
    digest.add(&status, sizeof status);
    if (status == GCV_OK) {
      if (rounding == GCV_ROUND_NEAREST) {
        add_exact_parts(digest, region);
      }
      add_rounded_parts(digest, region);
    }
    gcv_region_destroy(region);
  }
}

}  // namespace gcv::hard

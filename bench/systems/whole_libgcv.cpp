// SPDX-License-Identifier: LGPL-3.0-or-later
#include "libgcv_handles.hpp"
#include "whole.hpp"

namespace gcv::bench {

namespace {

Owned<gcv_region> make_region(const Ring& a, const Ring& b, std::uint64_t leave_out) {
  const auto p = make_polygon(a);
  const auto q = make_polygon(b);
  gcv_options options = GCV_OPTIONS_INIT;
  options.leave_out = leave_out;
  gcv_region* region = nullptr;
  check(gcv_minkowski_sum_region(p.get(), q.get(), &options, &region));
  return Owned<gcv_region>(region);
}

void copy_out(const gcv_region* region) {
  std::size_t count = 0;
  check(gcv_region_parts(region, nullptr, 0, &count));
  std::vector<gcv_region_part> parts(count);
  check(gcv_region_parts(region, parts.data(), count, &count));
  check(gcv_region_vertices(region, nullptr, 0, &count));
  Ring vertices(count);
  check(gcv_region_vertices(region, &vertices.data()->x, count, &count));
}

std::vector<gcv_region_part> exact_parts(const gcv_region* region) {
  std::size_t count = 0;
  check(gcv_region_exact_parts(region, nullptr, 0, &count));
  std::vector<gcv_region_part> parts(count);
  check(gcv_region_exact_parts(region, parts.data(), count, &count));
  return parts;
}

invariants::Exact exact_vertex(const gcv_region* region, std::size_t index) {
  std::size_t length = 0;
  check(gcv_region_exact_vertex(region, index, nullptr, 0, &length));
  std::string text(length, '\0');
  check(gcv_region_exact_vertex(region, index, text.data(), length, &length));
  text.pop_back();
  const std::size_t space = text.find(' ');
  return {invariants::Rational(text.substr(0, space)),
          invariants::Rational(text.substr(space + 1))};
}

}  // namespace

void libgcv_outer_face(const Ring& a, const Ring& b) {
  const auto p = make_polygon(a);
  const auto q = make_polygon(b);
  gcv_outer_face* sum = nullptr;
  check(gcv_minkowski_sum(p.get(), q.get(), nullptr, &sum));
  const Owned<gcv_outer_face> face(sum);
  std::size_t count = 0;
  check(gcv_outer_face_vertex_count(sum, &count));
  Ring vertices(count);
  check(gcv_outer_face_vertices(sum, &vertices.data()->x, count, &count));
}

void libgcv_region(const Ring& a, const Ring& b, std::uint64_t leave_out) {
  copy_out(make_region(a, b, leave_out).get());
}

RegionSize libgcv_region_size(const Ring& a, const Ring& b) {
  const auto region = make_region(a, b, 0);
  RegionSize size;
  for (const gcv_region_part& part : exact_parts(region.get())) {
    size.holes += part.kind == GCV_PART_HOLE ? 1 : 0;
    size.fits += part.kind > GCV_PART_HOLE ? 1 : 0;
    size.vertices += part.vertex_count;
  }
  return size;
}

ExactRegion libgcv_exact_region(const Ring& a, const Ring& b) {
  const auto region = make_region(a, b, 0);
  ExactRegion result;
  std::size_t next = 0;
  for (const gcv_region_part& part : exact_parts(region.get())) {
    invariants::Ring vertices;
    for (std::uint64_t k = 0; k < part.vertex_count; ++k) {
      vertices.push_back(exact_vertex(region.get(), next++));
    }
    if (part.kind == GCV_PART_OUTER) {
      result.whole.outer.push_back(vertices);
    } else if (part.kind == GCV_PART_HOLE) {
      result.whole.holes.push_back(vertices);
    } else {
      result.fits.push_back({vertices.front(), vertices.back()});
    }
  }
  return result;
}

}  // namespace gcv::bench

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Checks at compile time that what crosses the C boundary has the same values and layout on both
// sides, and the layout that programs were compiled with. There is no code here.
#include <cstddef>
#include <cstdint>

#include "error.hpp"
#include "gcv/gcv.h"
#include "point.hpp"
#include "region.hpp"
#include "simplification.hpp"
#include "superset.hpp"

namespace gcv::capi {

namespace {

constexpr bool is_same(gcv_status status, Status core) {
  return status == static_cast<gcv_status>(core);
}
static_assert(is_same(GCV_OK, Status::ok));
static_assert(is_same(GCV_ERR_NULL_ARGUMENT, Status::null_argument));
static_assert(is_same(GCV_ERR_INVALID_ARGUMENT, Status::invalid_argument));
static_assert(is_same(GCV_ERR_NOT_FINITE, Status::not_finite));
static_assert(is_same(GCV_ERR_DEGENERATE, Status::degenerate));
static_assert(is_same(GCV_ERR_NOT_SIMPLE, Status::not_simple));
static_assert(is_same(GCV_ERR_BUFFER_TOO_SMALL, Status::buffer_too_small));
static_assert(is_same(GCV_ERR_RANGE, Status::range));
static_assert(is_same(GCV_ERR_PARSE, Status::parse));
static_assert(is_same(GCV_ERR_NO_MEMORY, Status::no_memory));
static_assert(is_same(GCV_ERR_CANCELLED, Status::cancelled));
static_assert(is_same(GCV_ERR_INTERNAL, Status::internal));

constexpr bool is_same(std::int32_t rounding, Rounding core) {
  return rounding == static_cast<std::int32_t>(core);
}
static_assert(is_same(GCV_ROUND_NEAREST, Rounding::nearest));
static_assert(is_same(GCV_ROUND_OUTWARD, Rounding::outward));

constexpr bool is_same(std::int32_t kind, EdgeKind core) {
  return kind == static_cast<std::int32_t>(core);
}
static_assert(is_same(GCV_EDGE_TRANSLATED, EdgeKind::translated));
static_assert(is_same(GCV_EDGE_CORNER, EdgeKind::corner));
static_assert(is_same(GCV_EDGE_TRANSLATED_CORNER, EdgeKind::translated_corner));

constexpr bool is_same(std::int32_t kind, PartKind core) {
  return kind == static_cast<std::int32_t>(core);
}
static_assert(is_same(GCV_PART_OUTER, PartKind::outer));
static_assert(is_same(GCV_PART_HOLE, PartKind::hole));
static_assert(is_same(GCV_PART_SEGMENT, PartKind::segment));
static_assert(is_same(GCV_PART_POINT, PartKind::point));
static_assert(RegionPart::no_polygon == UINT32_MAX);

// Vertices are copied as bytes.
static_assert(sizeof(Point) == 2 * sizeof(double));
static_assert(offsetof(Point, x) == 0);
static_assert(offsetof(Point, y) == sizeof(double));
static_assert(sizeof(double) == 8);

// The alignment of 64-bit numbers in structs is 8. On some 32-bit machines it is 4.
struct Of64Bits {
  std::uint64_t number;
};
struct OfDouble {
  double number;
};
constexpr std::size_t alignment = alignof(Of64Bits);
constexpr std::size_t pointer = sizeof(void*);
static_assert(alignment == 8 || (alignment == 4 && pointer == 4));
static_assert(alignof(OfDouble) == alignment);
static_assert(pointer == 4 || pointer == 8);

// The first multiple of `unit` that is at least `size`.
constexpr std::size_t up(std::size_t size, std::size_t unit) {
  return (size + unit - 1) / unit * unit;
}

static_assert(offsetof(gcv_options, struct_size) == 0);
static_assert(offsetof(gcv_options, rounding) == 4);
static_assert(offsetof(gcv_options, tolerance) == 8);
static_assert(offsetof(gcv_options, threads) == 16);
static_assert(offsetof(gcv_options, progress) == (pointer == 8 ? 24 : 20));
static_assert(offsetof(gcv_options, progress_context) == (pointer == 8 ? 32 : 24));
// 0.1.0 had as many bytes as there are before leave_out.
static_assert(offsetof(gcv_options, leave_out) == (pointer == 8 ? 40 : up(28, alignment)));
static_assert(sizeof(gcv_options) == offsetof(gcv_options, leave_out) + 8);

static_assert(offsetof(gcv_edge_source, kind) == 0);
static_assert(offsetof(gcv_edge_source, a) == 4);
static_assert(offsetof(gcv_edge_source, b) == 8);
static_assert(sizeof(gcv_edge_source) == 12);

static_assert(offsetof(gcv_superset_edge, x0) == 0);
static_assert(offsetof(gcv_superset_edge, y0) == 8);
static_assert(offsetof(gcv_superset_edge, x1) == 16);
static_assert(offsetof(gcv_superset_edge, y1) == 24);
static_assert(offsetof(gcv_superset_edge, source) == 32);
static_assert(sizeof(gcv_superset_edge) == up(44, alignment));

static_assert(offsetof(gcv_stats, struct_size) == 0);
static_assert(offsetof(gcv_stats, walk_steps) == alignment);
static_assert(offsetof(gcv_stats, candidate_edges) == alignment + 8);
static_assert(offsetof(gcv_stats, predicates_filtered) == alignment + 16);
static_assert(offsetof(gcv_stats, predicates_fixed_width) == alignment + 24);
static_assert(offsetof(gcv_stats, predicates_rational) == alignment + 32);
static_assert(offsetof(gcv_stats, vertices_repaired) == alignment + 40);
static_assert(offsetof(gcv_stats, parts_dropped) == alignment + 48);  // the size in 0.1.0
static_assert(sizeof(gcv_stats) == alignment + 56);

static_assert(offsetof(gcv_region_part, kind) == 0);
static_assert(offsetof(gcv_region_part, polygon) == 4);
static_assert(offsetof(gcv_region_part, vertex_count) == 8);
static_assert(sizeof(gcv_region_part) == 16);

}  // namespace

}  // namespace gcv::capi

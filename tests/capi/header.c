/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The header alone, in C and in C++: every function has the type, every struct the layout
 * and every name the value that programs are compiled with. Compiled, never run.
 */
#include <gcv/gcv.h>

#define HOLDS(name, condition) typedef char name[(condition) ? 1 : -1]

HOLDS(statuses, GCV_OK == 0 && GCV_ERR_NULL_ARGUMENT == 1 && GCV_ERR_INVALID_ARGUMENT == 2 &&
                    GCV_ERR_NOT_FINITE == 3 && GCV_ERR_DEGENERATE == 4 && GCV_ERR_NOT_SIMPLE == 5 &&
                    GCV_ERR_BUFFER_TOO_SMALL == 6 && GCV_ERR_RANGE == 7 && GCV_ERR_PARSE == 8 &&
                    GCV_ERR_NO_MEMORY == 9 && GCV_ERR_CANCELLED == 11 && GCV_ERR_INTERNAL == 100);
HOLDS(roundings, GCV_ROUND_NEAREST == 0 && GCV_ROUND_OUTWARD == 1);
HOLDS(kinds, GCV_EDGE_TRANSLATED == 1 && GCV_EDGE_CORNER == 2 && GCV_EDGE_TRANSLATED_CORNER == 3);
HOLDS(left_out, GCV_LEAVE_OUT_HOLES == 1 && GCV_LEAVE_OUT_FITS == 2);
HOLDS(part_kinds,
      GCV_PART_OUTER == 1 && GCV_PART_HOLE == 2 && GCV_PART_SEGMENT == 3 && GCV_PART_POINT == 4);
HOLDS(places, GCV_INSIDE == 1 && GCV_BOUNDARY == 0 && GCV_OUTSIDE == -1);

HOLDS(options_layout,
      sizeof(gcv_options) == 48 && offsetof(gcv_options, struct_size) == 0 &&
          offsetof(gcv_options, rounding) == 4 && offsetof(gcv_options, tolerance) == 8 &&
          offsetof(gcv_options, threads) == 16 && offsetof(gcv_options, progress) == 24 &&
          offsetof(gcv_options, progress_context) == 32 && offsetof(gcv_options, leave_out) == 40);
HOLDS(source_layout, sizeof(gcv_edge_source) == 12 && offsetof(gcv_edge_source, kind) == 0 &&
                         offsetof(gcv_edge_source, a) == 4 && offsetof(gcv_edge_source, b) == 8);
HOLDS(edge_layout,
      sizeof(gcv_superset_edge) == 48 && offsetof(gcv_superset_edge, x0) == 0 &&
          offsetof(gcv_superset_edge, y0) == 8 && offsetof(gcv_superset_edge, x1) == 16 &&
          offsetof(gcv_superset_edge, y1) == 24 && offsetof(gcv_superset_edge, source) == 32);
HOLDS(stats_layout,
      sizeof(gcv_stats) == 64 && offsetof(gcv_stats, struct_size) == 0 &&
          offsetof(gcv_stats, walk_steps) == 8 && offsetof(gcv_stats, candidate_edges) == 16 &&
          offsetof(gcv_stats, predicates_filtered) == 24 &&
          offsetof(gcv_stats, predicates_fixed_width) == 32 &&
          offsetof(gcv_stats, predicates_rational) == 40 &&
          offsetof(gcv_stats, vertices_repaired) == 48 && offsetof(gcv_stats, parts_dropped) == 56);
HOLDS(part_layout, sizeof(gcv_region_part) == 16 && offsetof(gcv_region_part, kind) == 0 &&
                       offsetof(gcv_region_part, polygon) == 4 &&
                       offsetof(gcv_region_part, vertex_count) == 8);

extern const gcv_options options;
const gcv_options options = GCV_OPTIONS_INIT;

#define FUNCTION(name, result, ...)                      \
  extern result (*const pointer_to_##name)(__VA_ARGS__); \
  result (*const pointer_to_##name)(__VA_ARGS__) = gcv_##name

FUNCTION(version_number, uint32_t, void);
FUNCTION(version_string, const char *, void);
FUNCTION(status_name, const char *, int32_t);
FUNCTION(last_error_message, const char *, void);
FUNCTION(polygon_create, int32_t, const double *, size_t, size_t, gcv_polygon **);
FUNCTION(polygon_create_wkt, int32_t, const char *, size_t, gcv_polygon **);
FUNCTION(polygon_create_rings, int32_t, const double *, const size_t *, size_t, size_t,
         gcv_polygon **);
FUNCTION(polygon_create_many, int32_t, const double *, const size_t *, size_t, size_t,
         gcv_polygon **, gcv_status *);
FUNCTION(polygon_create_disc, int32_t, const double *, double, double, int32_t, gcv_polygon **);
FUNCTION(polygon_affine, int32_t, const gcv_polygon *, const double *, gcv_polygon **);
FUNCTION(polygon_destroy, void, gcv_polygon *);
FUNCTION(polygon_ring_count, int32_t, const gcv_polygon *, size_t *);
FUNCTION(polygon_ring, int32_t, const gcv_polygon *, size_t, double *, size_t, size_t *);
FUNCTION(polygon_vertex_count, int32_t, const gcv_polygon *, size_t *);
FUNCTION(polygon_vertices, int32_t, const gcv_polygon *, double *, size_t, size_t *);
FUNCTION(polygon_area, int32_t, const gcv_polygon *, double *);
FUNCTION(polygon_bounds, int32_t, const gcv_polygon *, double *);
FUNCTION(polygon_simplified, int32_t, const gcv_polygon *, double, int32_t, gcv_polygon **,
         double *);
FUNCTION(options_init, void, gcv_options *);
FUNCTION(options_init_size, void, gcv_options *, uint32_t);
FUNCTION(minkowski_sum, int32_t, const gcv_polygon *, const gcv_polygon *, const gcv_options *,
         gcv_outer_face **);
FUNCTION(minkowski_sum_many, int32_t, const gcv_polygon *const *, const gcv_polygon *const *,
         size_t, const gcv_options *, gcv_outer_face **, gcv_status *);
FUNCTION(no_fit_polygon, int32_t, const gcv_polygon *, const gcv_polygon *, const double *,
         const gcv_options *, gcv_outer_face **);
FUNCTION(entrance_block, int32_t, const gcv_polygon *, const gcv_polygon *, const double *,
         const gcv_options *, gcv_outer_face **);
FUNCTION(no_fit_polygon_many, int32_t, const gcv_polygon *const *, const gcv_polygon *const *,
         const double *, size_t, const gcv_options *, gcv_outer_face **, gcv_status *);
FUNCTION(outer_face_destroy, void, gcv_outer_face *);
FUNCTION(outer_face_vertex_count, int32_t, const gcv_outer_face *, size_t *);
FUNCTION(outer_face_vertices, int32_t, const gcv_outer_face *, double *, size_t, size_t *);
FUNCTION(outer_face_exact_vertex_count, int32_t, const gcv_outer_face *, size_t *);
FUNCTION(outer_face_exact_vertex, int32_t, const gcv_outer_face *, size_t, char *, size_t,
         size_t *);
FUNCTION(outer_face_edge_sources, int32_t, const gcv_outer_face *, gcv_edge_source *, size_t,
         size_t *);
FUNCTION(outer_face_exact_indices, int32_t, const gcv_outer_face *, uint64_t *, size_t, size_t *);
FUNCTION(outer_face_error_bound, int32_t, const gcv_outer_face *, double *);
FUNCTION(outer_face_area, int32_t, const gcv_outer_face *, double *);
FUNCTION(outer_face_wkt, int32_t, const gcv_outer_face *, char *, size_t, size_t *);
FUNCTION(outer_face_polygon, int32_t, const gcv_outer_face *, gcv_polygon **);
FUNCTION(outer_face_stats, int32_t, const gcv_outer_face *, gcv_stats *);
FUNCTION(minkowski_sum_region, int32_t, const gcv_polygon *, const gcv_polygon *,
         const gcv_options *, gcv_region **);
FUNCTION(no_fit_region, int32_t, const gcv_polygon *, const gcv_polygon *, const double *,
         const gcv_options *, gcv_region **);
FUNCTION(entrance_region, int32_t, const gcv_polygon *, const gcv_polygon *, const double *,
         const gcv_options *, gcv_region **);
FUNCTION(inner_fit_region, int32_t, const gcv_polygon *, const gcv_polygon *, const double *,
         const gcv_options *, gcv_region **);
FUNCTION(minkowski_sum_region_many, int32_t, const gcv_polygon *const *, const gcv_polygon *const *,
         size_t, const gcv_options *, gcv_region **, gcv_status *);
FUNCTION(no_fit_region_many, int32_t, const gcv_polygon *const *, const gcv_polygon *const *,
         const double *, size_t, const gcv_options *, gcv_region **, gcv_status *);
FUNCTION(region_destroy, void, gcv_region *);
FUNCTION(region_parts, int32_t, const gcv_region *, gcv_region_part *, size_t, size_t *);
FUNCTION(region_vertices, int32_t, const gcv_region *, double *, size_t, size_t *);
FUNCTION(region_exact_parts, int32_t, const gcv_region *, gcv_region_part *, size_t, size_t *);
FUNCTION(region_exact_vertex, int32_t, const gcv_region *, size_t, char *, size_t, size_t *);
FUNCTION(region_exact_indices, int32_t, const gcv_region *, uint64_t *, size_t, size_t *);
FUNCTION(region_edge_sources, int32_t, const gcv_region *, gcv_edge_source *, size_t, size_t *);
FUNCTION(region_edge_owners, int32_t, const gcv_region *, uint64_t *, size_t, size_t *);
FUNCTION(region_area, int32_t, const gcv_region *, double *);
FUNCTION(region_error_bound, int32_t, const gcv_region *, double *);
FUNCTION(region_wkt, int32_t, const gcv_region *, char *, size_t, size_t *);
FUNCTION(region_fits_wkt, int32_t, const gcv_region *, char *, size_t, size_t *);
FUNCTION(region_polygon, int32_t, const gcv_region *, size_t, gcv_polygon **);
FUNCTION(region_locate, int32_t, const gcv_region *, const double *, size_t, int8_t *);
FUNCTION(region_stats, int32_t, const gcv_region *, gcv_stats *);
FUNCTION(superset_create, int32_t, const gcv_polygon *, const gcv_polygon *, gcv_superset **);
FUNCTION(superset_destroy, void, gcv_superset *);
FUNCTION(superset_edges, int32_t, const gcv_superset *, gcv_superset_edge *, size_t, size_t *);

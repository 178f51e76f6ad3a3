/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * A record of all that the library says about some polygons, byte by byte: whatever the
 * thread and its floating-point environment, two records must be equal.
 */
#ifndef GCV_TESTS_CAPI_RECORD_H
#define GCV_TESTS_CAPI_RECORD_H

#include <math.h>
#include <stdlib.h>

#include "handles.h"

struct record {
  size_t size;
  unsigned char bytes[1 << 20];
};

static inline void put(struct record *record, const void *bytes, size_t size) {
  if (size > sizeof record->bytes - record->size) abort();
  memcpy(record->bytes + record->size, bytes, size);
  record->size += size;
}

/* Gives whether the call went well; else, records why it did not. */
static inline int put_status(struct record *record, gcv_status status) {
  put(record, &status, sizeof status);
  if (status != GCV_OK) {
    put(record, gcv_last_error_message(), strlen(gcv_last_error_message()));
  }
  return status == GCV_OK;
}

static inline void put_polygon(struct record *record, const gcv_polygon *polygon) {
  double xy[2 * MOST_VERTICES], area, bounds[4];
  size_t count, rings = 0, k;
  if (put_status(record, gcv_polygon_vertices(polygon, xy, MOST_VERTICES, &count))) {
    put(record, xy, count * 2 * sizeof *xy);
  }
  if (put_status(record, gcv_polygon_ring_count(polygon, &rings)))
    put(record, &rings, sizeof rings);
  for (k = 0; k <= rings; ++k) { /* one too many is an error to be recorded */
    if (put_status(record, gcv_polygon_ring(polygon, k, xy, MOST_VERTICES, &count))) {
      put(record, xy, count * 2 * sizeof *xy);
    }
  }
  if (put_status(record, gcv_polygon_area(polygon, &area))) put(record, &area, sizeof area);
  if (put_status(record, gcv_polygon_bounds(polygon, bounds))) put(record, bounds, sizeof bounds);
}

static inline void put_face(struct record *record, const gcv_outer_face *face) {
  double xy[2 * MOST_VERTICES], area, bound;
  gcv_edge_source sources[MOST_VERTICES];
  uint64_t indices[MOST_VERTICES];
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 0};
  gcv_polygon *polygon = NULL;
  char text[MOST_TEXT];
  size_t count, size, k;
  if (put_status(record, gcv_outer_face_vertices(face, xy, MOST_VERTICES, &count))) {
    put(record, xy, count * 2 * sizeof *xy);
  }
  if (put_status(record, gcv_outer_face_edge_sources(face, sources, MOST_VERTICES, &count))) {
    put(record, sources, count * sizeof *sources);
  }
  for (k = 0; k <= count; ++k) { /* one too many is an error to be recorded */
    if (put_status(record, gcv_outer_face_exact_vertex(face, k, text, sizeof text, &size))) {
      put(record, text, size);
    }
  }
  if (put_status(record, gcv_outer_face_exact_indices(face, indices, MOST_VERTICES, &count))) {
    put(record, indices, count * sizeof *indices);
  }
  if (put_status(record, gcv_outer_face_area(face, &area))) put(record, &area, sizeof area);
  if (put_status(record, gcv_outer_face_error_bound(face, &bound))) {
    put(record, &bound, sizeof bound);
  }
  if (put_status(record, gcv_outer_face_wkt(face, text, sizeof text, &size))) {
    put(record, text, size);
  }
  if (put_status(record, gcv_outer_face_stats(face, &stats))) {
    put(record, &stats.walk_steps, 7 * sizeof stats.walk_steps);
  }
  if (put_status(record, gcv_outer_face_polygon(face, &polygon))) put_polygon(record, polygon);
  gcv_polygon_destroy(polygon);
}

/* What is the same for vertices, edges, and parts in doubles and exactly. */
static inline void put_region_lists(struct record *record, const gcv_region *region) {
  gcv_region_part parts[MOST_VERTICES];
  gcv_edge_source sources[2 * MOST_VERTICES];
  uint64_t numbers[2 * MOST_VERTICES];
  char text[MOST_TEXT];
  size_t count = 0, size, k;
  if (put_status(record, gcv_region_parts(region, parts, MOST_VERTICES, &count))) {
    put(record, parts, count * sizeof *parts);
  }
  if (put_status(record, gcv_region_exact_parts(region, parts, MOST_VERTICES, &count))) {
    put(record, parts, count * sizeof *parts);
  }
  if (put_status(record, gcv_region_exact_indices(region, numbers, 2 * MOST_VERTICES, &count))) {
    put(record, numbers, count * sizeof *numbers);
  }
  if (put_status(record, gcv_region_edge_owners(region, numbers, 2 * MOST_VERTICES, &count))) {
    put(record, numbers, count * sizeof *numbers);
  }
  if (put_status(record, gcv_region_edge_sources(region, sources, 2 * MOST_VERTICES, &count))) {
    put(record, sources, count * sizeof *sources);
  }
  for (k = 0; k <= count; ++k) { /* one too many is an error to be recorded */
    if (put_status(record, gcv_region_exact_vertex(region, k, text, sizeof text, &size))) {
      put(record, text, size);
    }
  }
}

static inline void put_region(struct record *record, const gcv_region *region) {
  double xy[4 * MOST_VERTICES], area, bound;
  int8_t places[2 * MOST_VERTICES];
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 0};
  gcv_polygon *polygon = NULL;
  char text[2 * MOST_TEXT];
  size_t count, size;
  put_region_lists(record, region);
  if (put_status(record, gcv_region_vertices(region, xy, 2 * MOST_VERTICES, &count))) {
    put(record, xy, count * 2 * sizeof *xy);
    if (put_status(record, gcv_region_locate(region, xy, count, places))) {
      put(record, places, count);
    }
  }
  if (put_status(record, gcv_region_area(region, &area))) put(record, &area, sizeof area);
  if (put_status(record, gcv_region_error_bound(region, &bound))) {
    put(record, &bound, sizeof bound);
  }
  if (put_status(record, gcv_region_wkt(region, text, sizeof text, &size))) put(record, text, size);
  if (put_status(record, gcv_region_fits_wkt(region, text, sizeof text, &size))) {
    put(record, text, size);
  }
  if (put_status(record, gcv_region_stats(region, &stats))) {
    put(record, &stats.walk_steps, 7 * sizeof stats.walk_steps);
  }
  if (put_status(record, gcv_region_polygon(region, 0, &polygon))) put_polygon(record, polygon);
  gcv_polygon_destroy(polygon);
}

static inline void put_superset(struct record *record, const gcv_superset *superset) {
  gcv_superset_edge edges[2 * MOST_VERTICES];
  size_t count, k;
  if (!put_status(record, gcv_superset_edges(superset, edges, 2 * MOST_VERTICES, &count))) return;
  for (k = 0; k < count; ++k) {
    put(record, &edges[k].x0, 4 * sizeof(double));
    put(record, &edges[k].source, sizeof edges[k].source);
  }
}

static inline void put_simplified(struct record *record, const gcv_polygon *polygon,
                                  double tolerance, int32_t rounding) {
  gcv_polygon *out = NULL;
  double bound;
  if (put_status(record, gcv_polygon_simplified(polygon, tolerance, rounding, &out, &bound))) {
    put_polygon(record, out);
    put(record, &bound, sizeof bound);
  }
  gcv_polygon_destroy(out);
}

/* The polygon turned by maps that round, and one that is beyond all doubles for some. */
static inline void put_images(struct record *record, const gcv_polygon *polygon) {
  static const double maps[][6] = {{0.6, -0.8, 0.1, 0.8, 0.6, -1e9}, {0, 1e10, 0, 1e-10, 0, 1}};
  size_t k;
  for (k = 0; k < sizeof maps / sizeof *maps; ++k) {
    gcv_polygon *image = NULL;
    if (put_status(record, gcv_polygon_affine(polygon, maps[k], &image))) {
      put_polygon(record, image);
    }
    gcv_polygon_destroy(image);
  }
}

static inline void put_regions(struct record *record, const gcv_polygon *a, const gcv_polygon *b,
                               double tolerance, int32_t rounding) {
  const double point[2] = {0.1, -1e-9};
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *region = NULL;
  options.tolerance = tolerance;
  options.rounding = rounding;
  if (put_status(record, gcv_minkowski_sum_region(a, b, &options, &region))) {
    put_region(record, region);
  }
  gcv_region_destroy(region);
  region = NULL;
  if (put_status(record, gcv_no_fit_region(a, b, point, &options, &region))) {
    put_region(record, region);
  }
  gcv_region_destroy(region);
  region = NULL;
  if (put_status(record, gcv_entrance_region(a, b, point, &options, &region))) {
    put_region(record, region);
  }
  gcv_region_destroy(region);
  region = NULL;
  if (put_status(record, gcv_inner_fit_region(a, b, point, &options, &region))) {
    put_region(record, region);
  }
  gcv_region_destroy(region);
}

/* Discs, polygons with holes, and many at once. */
static inline void put_others(struct record *record) {
  static const double xy[] = {0, 0, 3, 0.1, 0, 3, 0.1, 0.1, 1, 0.3, 0.3, 1, 0.1, 0.1};
  static const size_t sizes[] = {3, 4}, many[] = {3, 2, 2};
  const double centre[2] = {0.1, -1e5};
  gcv_polygon *polygons[4] = {NULL, NULL, NULL, NULL};
  gcv_status statuses[3];
  size_t k;
  int32_t rounding;
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    if (put_status(record, gcv_polygon_create_disc(centre, 0.7, 1e-2, rounding, polygons))) {
      put_polygon(record, polygons[0]);
    }
    gcv_polygon_destroy(polygons[0]);
    polygons[0] = NULL;
  }
  if (put_status(record, gcv_polygon_create_many(xy, many, 3, 0, polygons, statuses))) {
    put(record, gcv_last_error_message(), strlen(gcv_last_error_message()));
    put(record, statuses, sizeof statuses);
  }
  if (put_status(record, gcv_polygon_create_rings(xy, sizes, 2, 0, &polygons[3]))) {
    put_polygon(record, polygons[3]);
    put_images(record, polygons[3]);
    put_regions(record, polygons[3], polygons[3], 0, GCV_ROUND_NEAREST);
    put_regions(record, polygons[3], polygons[0], 0, GCV_ROUND_OUTWARD);
  }
  for (k = 0; k < 4; ++k) gcv_polygon_destroy(polygons[k]);
}

static inline void put_sums(struct record *record, const gcv_polygon *a, const gcv_polygon *b,
                            double tolerance, int32_t rounding) {
  const double point[2] = {0.1, -1e-9};
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_outer_face *face = NULL;
  options.tolerance = tolerance;
  options.rounding = rounding;
  if (put_status(record, gcv_minkowski_sum(a, b, &options, &face))) put_face(record, face);
  gcv_outer_face_destroy(face);
  face = NULL;
  if (put_status(record, gcv_no_fit_polygon(a, b, point, &options, &face))) put_face(record, face);
  gcv_outer_face_destroy(face);
  face = NULL;
  if (put_status(record, gcv_entrance_block(a, b, point, &options, &face))) put_face(record, face);
  gcv_outer_face_destroy(face);
}

/* With sums within the tolerance, too. */
static inline void put_pair(struct record *record, const gcv_polygon *a, const gcv_polygon *b,
                            double tolerance) {
  gcv_superset *superset = NULL;
  int32_t rounding;
  put_polygon(record, a);
  put_polygon(record, b);
  put_images(record, a);
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    put_sums(record, a, b, 0, rounding);
    put_sums(record, a, b, tolerance, rounding);
    put_regions(record, a, b, 0, rounding);
    put_regions(record, a, b, tolerance, rounding);
    put_simplified(record, a, tolerance, rounding);
    put_simplified(record, b, tolerance, rounding);
  }
  if (put_status(record, gcv_superset_create(a, b, &superset))) put_superset(record, superset);
  gcv_superset_destroy(superset);
}

/* Pairs of polygons: of integers, of fractions, of subnormal numbers, of numbers whose
 * sums overflow, of numbers of all sizes, and with a slit that rounding would close. And
 * tolerances within which there are vertices to leave out. */
enum { PAIRS = 6 };
static const char *const pair_texts[PAIRS][2] = {
    {"POLYGON ((0 0, 4 4, 2 3, 0 4))", "POLYGON ((0 0, 3 3, 0 2))"},
    {"POLYGON ((0.1 0.2, 0.7 0.1, 1.3 0.4, 0.9 0.6, 1.1 1.7, 0.6 0.7, 0.2 1.1, 0.3 0.5))",
     "POLYGON ((0.3 0, 0.8 0.3, 0.1 0.9, 0.35 0.4))"},
    {"POLYGON ((0 0, 2e-323 2e-323, 1e-323 1.5e-323, 0 2e-323))",
     "POLYGON ((0 0, 1.5e-323 1.5e-323, 0 1e-323))"},
    {"POLYGON ((0 0, 1.7e308 1.7e308, 1e308 1.6e308, 0 1.7e308))",
     "POLYGON ((0 0, 3e307 3e307, 0 2e307))"},
    {"POLYGON ((-1e100 1e-300, 3 -1e-310, 1e17 1, 5e15 1e30))",
     "POLYGON ((0 0, 1e-200 1e-200, 1 1e-308, 1e9 1e-9, 0.1 1e5))"},
    {"POLYGON ((18014398509481984 0, 18014398509482000 0, 18014398509482000 16, "
     "18014398509481992 16, 18014398509481992 8, 18014398509481988 8, 18014398509481988 16, "
     "18014398509481984 16))",
     "POLYGON ((0 0, 2 0, 2 1, 0 1))"},
};

static const double pair_tolerances[PAIRS] = {4, 0.5, 2e-323, 1e308, 1e30, 8};

static inline gcv_status pair_polygon(int pair, int which, gcv_polygon **polygon) {
  const char *text = pair_texts[pair][which];
  return gcv_polygon_create_wkt(text, strlen(text), polygon);
}

/* What the library makes of input that it refuses. */
static inline void put_refusals(struct record *record) {
  const double bow_tie[] = {0, 0, 0.2, 0.2, 0.2, 0, 0, 0.2}, bad[] = {0, 0, 1, NAN, INFINITY, 1};
  const double apart[] = {0, 0, 0.2, 0.1, 0, 0.3, 1, 1, 1.1, 1, 1, 1.1};
  const size_t sizes[] = {3, 3};
  gcv_polygon *polygon = NULL;
  put_status(record, gcv_polygon_create(bow_tie, 4, 0, &polygon));
  put_status(record, gcv_polygon_create(bad, 3, 0, &polygon));
  put_status(record, gcv_polygon_create(bad, 2, 0, &polygon));
  put_status(record, gcv_polygon_create_wkt("POLYGON ((1e999 0))", 19, &polygon));
  put_status(record, gcv_polygon_create_rings(apart, sizes, 2, 0, &polygon));
  put_status(record, gcv_polygon_create_disc(apart, 0.1, 1e-300, GCV_ROUND_NEAREST, &polygon));
  gcv_polygon_destroy(polygon);
}

#endif

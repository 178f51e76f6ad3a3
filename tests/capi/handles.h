/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Short ways to make polygons and sums, and to compare rings with what they should be.
 */
#ifndef GCV_TESTS_CAPI_HANDLES_H
#define GCV_TESTS_CAPI_HANDLES_H

#include "check.h"

enum { MOST_VERTICES = 64, MOST_TEXT = 2048 };

/* The numbers x0, y0, x1, y1, ... as a pointer and a number of vertices. */
#define RING(...) \
  (const double[]){__VA_ARGS__}, sizeof((const double[]){__VA_ARGS__}) / (2 * sizeof(double))
#define POLYGON(...) polygon_of(RING(__VA_ARGS__))

static inline gcv_polygon *polygon_of(const double *xy, size_t count) {
  gcv_polygon *polygon = NULL;
  CHECK_OK(gcv_polygon_create(xy, count, 0, &polygon));
  return polygon;
}

static inline gcv_outer_face *sum_of(const gcv_polygon *a, const gcv_polygon *b) {
  gcv_outer_face *face = NULL;
  CHECK_OK(gcv_minkowski_sum(a, b, NULL, &face));
  return face;
}

/* Are the two rings equal, bit by bit? */
static inline int same_ring(const double *xy, size_t count, const double *expected,
                            size_t expected_count) {
  size_t i;
  if (count == expected_count && memcmp(xy, expected, count * 2 * sizeof *xy) == 0) return 1;
  fprintf(stderr, "the ring is");
  for (i = 0; i < 2 * count; ++i) fprintf(stderr, " %.17g", xy[i]);
  fprintf(stderr, "\n");
  return 0;
}

static inline int polygon_is(const gcv_polygon *polygon, const double *expected, size_t count) {
  double xy[2 * MOST_VERTICES] = {0};
  size_t required = 0, counted = 0;
  CHECK_OK(gcv_polygon_vertex_count(polygon, &counted));
  CHECK_OK(gcv_polygon_vertices(polygon, xy, MOST_VERTICES, &required));
  return counted == required && same_ring(xy, required, expected, count);
}

static inline int face_is(const gcv_outer_face *face, const double *expected, size_t count) {
  double xy[2 * MOST_VERTICES] = {0};
  size_t required = 0, counted = 0;
  CHECK_OK(gcv_outer_face_vertex_count(face, &counted));
  CHECK_OK(gcv_outer_face_vertices(face, xy, MOST_VERTICES, &required));
  return counted == required && same_ring(xy, required, expected, count);
}

/* The exact ring against "p/q r/s, p/q r/s, ...". */
static inline int exact_ring_is(const gcv_outer_face *face, const char *expected) {
  char text[MOST_TEXT] = "";
  size_t count = 0, required = 0, length = 0, i;
  CHECK_OK(gcv_outer_face_exact_vertex_count(face, &count));
  for (i = 0; i < count; ++i) {
    if (i > 0) length += (size_t)sprintf(text + length, ", ");
    if (!CHECK_OK(gcv_outer_face_exact_vertex(face, i, text + length, sizeof text - 2 - length,
                                              &required))) {
      return 0;
    }
    length += required - 1;
  }
  if (strcmp(text, expected) == 0) return 1;
  fprintf(stderr, "the exact ring is %s\n", text);
  return 0;
}

#endif

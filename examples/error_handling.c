/*
 * error_handling.c - each kind of bad input, the status it gives, and the message.
 *
 * A program decides by the status; the message is for people. It belongs to the calling
 * thread and stays until the next failure there, so print or copy it at once.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include <gcv/gcv.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Prints what a call came to, and says whether it is what was expected. */
static bool show(const char *what, gcv_status expected, gcv_status status) {
  printf("%s\n  %s: %s\n", what, gcv_status_name(status),
         status == GCV_OK ? "" : gcv_last_error_message());
  return status == expected;
}

/* A polygon that must not be accepted: on failure *out is not written to. */
static bool show_ring(const char *what, gcv_status expected, const double *xy, size_t count) {
  gcv_polygon *polygon = NULL;
  bool as_expected = show(what, expected, gcv_polygon_create(xy, count, 0, &polygon));
  return as_expected && polygon == NULL;
}

static bool show_wkt(const char *what, gcv_status expected, const char *text) {
  gcv_polygon *polygon = NULL;
  bool as_expected = show(what, expected, gcv_polygon_create_wkt(text, strlen(text), &polygon));
  return as_expected && polygon == NULL;
}

static bool bad_polygons(void) {
  const double nan_ring[] = {0, 0, 1, 0, 1, NAN};
  const double infinite_ring[] = {0, 0, INFINITY, 0, 1, 1};
  const double line[] = {0, 0, 1, 1, 2, 2, 3, 3};
  const double bow_tie[] = {0, 0, 2, 2, 2, 0, 0, 2};
  const double touching[] = {0, 0, 4, 0, 4, 3, 2, 0, 0, 3};
  gcv_polygon *polygon = NULL;

  bool ok = show_ring("a coordinate that is not a number", GCV_ERR_NOT_FINITE, nan_ring, 3);
  ok &= show_ring("an infinite coordinate", GCV_ERR_NOT_FINITE, infinite_ring, 3);
  ok &= show_ring("vertices on one line", GCV_ERR_DEGENERATE, line, 4);
  ok &= show_ring("a ring that crosses itself", GCV_ERR_NOT_SIMPLE, bow_tie, 4);
  ok &= show_ring("a ring that touches itself", GCV_ERR_NOT_SIMPLE, touching, 5);
  ok &= show_ring("no vertices at all", GCV_ERR_NULL_ARGUMENT, NULL, 0);
  ok &= show("a stride of 8 bytes", GCV_ERR_INVALID_ARGUMENT,
             gcv_polygon_create(bow_tie, 3, 8, &polygon));
  ok &= show_wkt("text that is no polygon", GCV_ERR_PARSE, "POINT (1 2)");
  ok &= show_wkt("text that ends too early", GCV_ERR_PARSE, "POLYGON ((0 0, 1 0, 1");
  ok &= show_wkt("an empty polygon", GCV_ERR_DEGENERATE, "POLYGON EMPTY");
  ok &=
      show_wkt("a number beyond all doubles", GCV_ERR_NOT_FINITE, "POLYGON ((0 0, 1e999 0, 0 1))");
  return ok;
}

static bool bad_sums(const gcv_polygon *huge, const gcv_polygon *triangle) {
  gcv_outer_face *face = NULL;
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = 42;
  const double reference[2] = {NAN, 0};

  bool ok = show("a polygon that is NULL", GCV_ERR_NULL_ARGUMENT,
                 gcv_minkowski_sum(triangle, NULL, NULL, &face));
  ok &= show("an unknown rounding", GCV_ERR_INVALID_ARGUMENT,
             gcv_minkowski_sum(triangle, triangle, &options, &face));
  ok &= show("a sum beyond all doubles", GCV_ERR_RANGE, gcv_minkowski_sum(huge, huge, NULL, &face));
  ok &= show("a reference point that is not a number", GCV_ERR_NOT_FINITE,
             gcv_no_fit_polygon(triangle, triangle, reference, NULL, &face));
  return ok && face == NULL;
}

static bool bad_buffers(const gcv_outer_face *face) {
  double xy[2];
  char text[64];
  size_t required;
  bool ok = show("a buffer for one vertex", GCV_ERR_BUFFER_TOO_SMALL,
                 gcv_outer_face_vertices(face, xy, 1, &required));
  printf("  (it would take %zu)\n", required);
  ok &= show("an index past the end", GCV_ERR_INVALID_ARGUMENT,
             gcv_outer_face_exact_vertex(face, 1000, text, sizeof text, &required));
  return ok;
}

int main(void) {
  const double triangle_xy[] = {0, 0, 1, 0, 0, 1};
  const double huge_xy[] = {1e308, 0, 1.5e308, 0, 1.5e308, 1e308};
  gcv_polygon *triangle = NULL, *huge = NULL;
  gcv_outer_face *face = NULL;

  bool ok = gcv_polygon_create(triangle_xy, 3, 0, &triangle) == GCV_OK &&
            gcv_polygon_create(huge_xy, 3, 0, &huge) == GCV_OK &&
            gcv_minkowski_sum(triangle, triangle, NULL, &face) == GCV_OK;
  ok = ok && bad_polygons();
  ok = ok && bad_sums(huge, triangle);
  ok = ok && bad_buffers(face);

  /* Destroying NULL is allowed, so one way out does for every failure. */
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(huge);
  gcv_polygon_destroy(triangle);
  puts(ok ? "all as expected" : "not as expected");
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Polygons with fewer vertices, and sums within a tolerance.
 */
#include <float.h>
#include <math.h>

#include "handles.h"

static gcv_polygon *simplified(const gcv_polygon *polygon, double tolerance, int32_t rounding,
                               double *bound) {
  gcv_polygon *out = NULL;
  CHECK_OK(gcv_polygon_simplified(polygon, tolerance, rounding, &out, bound));
  return out;
}

/* A square with a bump of 1/8 on its lower side and a dent of 1/8 in its upper one. */
static gcv_polygon *bumpy(void) {
  return POLYGON(0, 0, 1, 0, 2, -0.125, 3, 0, 4, 0, 4, 4, 3, 4, 2, 3.875, 1, 4, 0, 4);
}

static void nearest_leaves_vertices_out(void) {
  gcv_polygon *polygon = bumpy(), *square;
  double bound = -1;
  square = simplified(polygon, 0.125, GCV_ROUND_NEAREST, &bound);
  CHECK(bound >= 0 && bound <= 0.125);
  gcv_polygon_destroy(square);
  square = simplified(polygon, 0.2, GCV_ROUND_NEAREST, &bound);
  CHECK(polygon_is(square, RING(0, 0, 4, 0, 4, 4, 0, 4)));
  CHECK(bound >= 0.125 && bound <= 0.125 * (1 + 1e-12));
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(polygon);
}

/* Outward, the dent is closed; the bump stays, or edges are lengthened around it. */
static void outward_contains(void) {
  gcv_polygon *polygon = bumpy(), *around;
  double bound = -1, area = 0, box[4] = {0}, box_around[4] = {0};
  size_t count = 0;
  around = simplified(polygon, 0.2, GCV_ROUND_OUTWARD, &bound);
  CHECK(bound > 0 && bound <= 0.2);
  CHECK_OK(gcv_polygon_vertex_count(around, &count));
  CHECK(count < 10);
  CHECK_OK(gcv_polygon_area(around, &area));
  CHECK(area >= 16.125);
  CHECK_OK(gcv_polygon_bounds(polygon, box));
  CHECK_OK(gcv_polygon_bounds(around, box_around));
  CHECK(box_around[0] <= box[0] && box_around[1] <= box[1]);
  CHECK(box_around[2] >= box[2] && box_around[3] >= box[3]);
  gcv_polygon_destroy(around);
  gcv_polygon_destroy(polygon);
}

/* A circle of 1,000 points within 1/100: as few as 23 of a regular polygon would do. */
static void circle(void) {
  enum { POINTS = 1000 };
  double xy[2 * POINTS], bound = -1;
  int32_t rounding;
  size_t i, count = 0;
  gcv_polygon *round, *coarse;
  for (i = 0; i < POINTS; ++i) {
    xy[2 * i] = cos(6.283185307179586 * (double)i / POINTS);
    xy[2 * i + 1] = sin(6.283185307179586 * (double)i / POINTS);
  }
  round = polygon_of(xy, POINTS);
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    coarse = simplified(round, 0.01, rounding, &bound);
    CHECK_OK(gcv_polygon_vertex_count(coarse, &count));
    CHECK(count <= 26);
    gcv_polygon_destroy(coarse);
  }
  gcv_polygon_destroy(round);
}

static void nothing_to_leave_out(void) {
  const double tolerances[] = {0, 0x1p-1074, 1e-300, 0.01};
  gcv_polygon *polygon = bumpy(), *same;
  size_t i;
  for (i = 0; i < 4; ++i) {
    double bound = -1;
    same = simplified(polygon, tolerances[i], GCV_ROUND_NEAREST, &bound);
    CHECK(bound == 0);
    CHECK(polygon_is(same,
                     RING(0, 0, 1, 0, 2, -0.125, 3, 0, 4, 0, 4, 4, 3, 4, 2, 3.875, 1, 4, 0, 4)));
    gcv_polygon_destroy(same);
  }
  gcv_polygon_destroy(polygon);
}

/* However large the tolerance, something is left. */
static void everything_may_go(void) {
  gcv_polygon *polygon = bumpy(), *out;
  double bound = -1, area = 0;
  int32_t rounding;
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    out = simplified(polygon, DBL_MAX, rounding, &bound);
    CHECK(bound <= 6);
    CHECK_OK(gcv_polygon_area(out, &area));
    CHECK(area > 0);
    gcv_polygon_destroy(out);
  }
  gcv_polygon_destroy(polygon);
}

/* Walls closer than the tolerance stay apart. */
static void slit(void) {
  gcv_polygon *fork =
      POLYGON(0, 0, 8, 0, 8, 8, 4.25, 8, 4.2, 5, 4.25, 2, 4, 2, 4.05, 5, 4, 8, 0, 8);
  gcv_polygon *out;
  double bound = -1;
  int32_t rounding;
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    out = simplified(fork, 0.5, rounding, &bound);
    CHECK(bound <= 0.5);
    gcv_polygon_destroy(out);
  }
  gcv_polygon_destroy(fork);
}

static void wrong_arguments(void) {
  const double wrong[] = {-1, -0x1p-1074, NAN, INFINITY, -INFINITY};
  gcv_polygon *polygon = bumpy(), *out = NULL;
  gcv_outer_face *face = NULL;
  gcv_options options = GCV_OPTIONS_INIT;
  double bound = -1;
  size_t i;
  for (i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    CHECK_STATUS(GCV_ERR_INVALID_ARGUMENT,
                 gcv_polygon_simplified(polygon, wrong[i], GCV_ROUND_NEAREST, &out, &bound));
    CHECK(strstr(gcv_last_error_message(), "tolerance is") == gcv_last_error_message());
    options.tolerance = wrong[i];
    CHECK_STATUS(GCV_ERR_INVALID_ARGUMENT, gcv_minkowski_sum(polygon, polygon, &options, &face));
    CHECK(strstr(gcv_last_error_message(), "options: tolerance is") == gcv_last_error_message());
  }
  CHECK_STATUS(GCV_ERR_INVALID_ARGUMENT, gcv_polygon_simplified(polygon, 1, 2, &out, &bound));
  CHECK(strstr(gcv_last_error_message(), "rounding is 2") == gcv_last_error_message());
  CHECK(out == NULL && face == NULL && bound == -1);
  gcv_polygon_destroy(polygon);
}

/* Half of the tolerance for each polygon; the bound says what was used of it. */
static void sums(void) {
  gcv_polygon *polygon = bumpy(), *unit = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  gcv_outer_face *face = NULL, *same[2] = {NULL, NULL};
  const gcv_polygon *a[2], *b[2];
  gcv_status statuses[2] = {-1, -1};
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_edge_source sources[4];
  double bound = -1;
  size_t required = 0;
  options.tolerance = 0.1;
  CHECK_OK(gcv_minkowski_sum(polygon, unit, &options, &face));
  CHECK_OK(gcv_outer_face_error_bound(face, &bound));
  CHECK(bound == 0);
  gcv_outer_face_destroy(face);
  options.tolerance = 0.4;
  CHECK_OK(gcv_minkowski_sum(polygon, unit, &options, &face));
  CHECK(face_is(face, RING(0, 0, 5, 0, 5, 5, 0, 5)));
  CHECK_OK(gcv_outer_face_error_bound(face, &bound));
  CHECK(bound >= 0.125 && bound <= 0.125 * (1 + 1e-12));
  CHECK_OK(gcv_outer_face_edge_sources(face, sources, 4, &required));
  CHECK(sources[0].kind == GCV_EDGE_TRANSLATED_CORNER && sources[0].a == 0);
  CHECK(sources[2].kind == GCV_EDGE_TRANSLATED_CORNER && sources[2].a == 5);
  gcv_outer_face_destroy(face);

  a[0] = a[1] = polygon;
  b[0] = unit;
  b[1] = polygon;
  CHECK_OK(gcv_minkowski_sum_many(a, b, 2, &options, same, statuses));
  CHECK(face_is(same[0], RING(0, 0, 5, 0, 5, 5, 0, 5)));
  CHECK(face_is(same[1], RING(0, 0, 8, 0, 8, 8, 0, 8)));
  gcv_outer_face_destroy(same[0]);
  gcv_outer_face_destroy(same[1]);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(polygon);
}

int main(void) {
  nearest_leaves_vertices_out();
  outward_contains();
  circle();
  nothing_to_leave_out();
  everything_may_go();
  slit();
  wrong_arguments();
  sums();
  return check_failures != 0;
}

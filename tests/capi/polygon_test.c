/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Polygons from arrays: what is accepted and how it is normalised, what is refused, and
 * areas and bounds. simplicity_test.c has the rings that meet themselves.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "handles.h"

/* However its boundary is given, this is the polygon (0 0, 4 0, 4 3, 2 1, 0 3). */
static void is_the_crown(const double *xy, size_t count) {
  gcv_polygon *polygon = polygon_of(xy, count);
  CHECK(polygon_is(polygon, RING(0, 0, 4, 0, 4, 3, 2, 1, 0, 3)));
  gcv_polygon_destroy(polygon);
}

static void normalisation(void) {
  is_the_crown(RING(0, 0, 4, 0, 4, 3, 2, 1, 0, 3));
  is_the_crown(RING(2, 1, 0, 3, 0, 0, 4, 0, 4, 3));                   /* another start */
  is_the_crown(RING(0, 3, 2, 1, 4, 3, 4, 0, 0, 0));                   /* clockwise */
  is_the_crown(RING(0, 0, 4, 0, 4, 3, 2, 1, 0, 3, 0, 0));             /* closed */
  is_the_crown(RING(2, 1, 4, 3, 4, 0, 0, 0, 0, 3, 2, 1, 2, 1));       /* closed twice */
  is_the_crown(RING(0, 0, 0, 0, 0, 0, 4, 0, 4, 3, 4, 3, 2, 1, 0, 3)); /* repeated */
  is_the_crown(RING(1, 0, 4, 0, 4, 2, 4, 3, 2, 1, 1, 2, 0, 3, 0, 0)); /* collinear */
  is_the_crown(RING(1, 0, 1, 0, 0, 0, 0, 3, 2, 1, 2, 1, 4, 3, 4, 0, 3, 0, 1, 0));
  is_the_crown(RING(-0.0, -0.0, 4, -0.0, 4, 3, 2, 1, -0.0, 3));
}

/* n vertices of the crown, one every `stride` bytes after `offset`, between NaNs, and not
 * a byte behind the last one. */
static void strided(size_t stride, size_t offset) {
  const double crown[] = {0, 0, 4, 0, 4, 3, 2, 1, 0, 3};
  const size_t step = stride == 0 ? 16 : stride, size = offset + 4 * step + 16;
  unsigned char *bytes = malloc(size);
  gcv_polygon *polygon = NULL;
  size_t k;
  if (bytes == NULL) abort();
  memset(bytes, 0xff, size);
  for (k = 0; k < 5; ++k) memcpy(bytes + offset + k * step, crown + 2 * k, 16);
  CHECK_OK(gcv_polygon_create((const double *)(const void *)(bytes + offset), 5, stride, &polygon));
  free(bytes);
  CHECK(polygon_is(polygon, crown, 5));
  gcv_polygon_destroy(polygon);
}

/* Vertices of a negative stride, or of one that leads beyond all memory, are nowhere. */
static void strides(void) {
  const size_t good[] = {0, 16, 17, 24, 40};
  const size_t huge[] = {(size_t)-16, (size_t)PTRDIFF_MAX + 1, (size_t)PTRDIFF_MAX / 2};
  const double xy[] = {0, 0, 1, 0, 0, 1};
  gcv_polygon *polygon = NULL;
  size_t k, stride;
  for (k = 0; k < sizeof good / sizeof *good; ++k) {
    strided(good[k], 0);
    strided(good[k], 1);
  }
  for (stride = 1; stride < 16; ++stride) {
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "stride", gcv_polygon_create(xy, 3, stride, &polygon));
  }
  for (k = 0; k < sizeof huge / sizeof *huge; ++k) {
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "vertex_count is 3: with stride_bytes ",
                  gcv_polygon_create(xy, 3, huge[k], &polygon));
  }
  CHECK(polygon == NULL);
}

static void huge_counts(void) {
  const size_t counts[] = {(size_t)1 << 31, SIZE_MAX / 16 + 4, SIZE_MAX};
  const double xy[] = {0, 0, 1, 0, 0, 1};
  gcv_polygon *polygon = NULL;
  size_t k;
  for (k = 0; k < sizeof counts / sizeof *counts; ++k) {
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "count",
                  gcv_polygon_create(xy, counts[k], 0, &polygon));
  }
  CHECK(polygon == NULL);
}

static void not_finite(void) {
  const double bad[] = {NAN, INFINITY, -INFINITY};
  gcv_polygon *polygon = NULL;
  char vertex[32];
  size_t k, position;
  for (k = 0; k < 3; ++k) {
    for (position = 0; position < 8; ++position) {
      double xy[] = {0, 0, 1, 0, 1, 1, 0, 1};
      xy[position] = bad[k];
      snprintf(vertex, sizeof vertex, "vertex %d ", (int)position / 2);
      CHECK_REFUSED(GCV_ERR_NOT_FINITE, vertex, gcv_polygon_create(xy, 4, 0, &polygon));
      CHECK(strstr(gcv_last_error_message(), position % 2 == 0 ? " x " : " y ") != NULL);
    }
  }
  CHECK(polygon == NULL);
}

static void degenerate(const double *xy, size_t count) {
  gcv_polygon *polygon = NULL;
  CHECK_STATUS(GCV_ERR_DEGENERATE, gcv_polygon_create(xy, count, 0, &polygon));
  CHECK(polygon == NULL);
}

static void degenerate_kinds(void) {
  const double nothing[1] = {0};
  degenerate(nothing, 0);
  degenerate(RING(1, 2));
  degenerate(RING(1, 2, 3, 4));
  degenerate(RING(1, 2, 3, 4, 1, 2));
  degenerate(RING(1, 2, 1, 2, 1, 2, 1, 2));
  degenerate(RING(0.0, 0.0, -0.0, 0.0, 0.0, -0.0));
  degenerate(RING(0, 0, 1, 2, 2, 4, 3, 6));
  degenerate(RING(0, 0, 2, 4, 1, 2, 3, 6, -1, -2));
  degenerate(RING(0, 0, 2, 0, 0, 0, 5, 0, 1, 0));
  degenerate(RING(0, 0, 0, 1, 0, DBL_MAX));
  degenerate(RING(0, 0, 0x1p-1074, 0x1p-1074, 1, 1));
}

/* Shapes that the smallest and the largest doubles make. */
static void extremes(void) {
  const double tiny[] = {0, 0, 0x1p-1074, 0, 0, 0x1p-1074};
  const double huge[] = {-1e308, -1e308, 1e308, -1e308, 1e308, 1e308, 0, -1e307};
  const double mixed[] = {-DBL_MAX, 0, 0, -0x1p-1074, DBL_MAX, 0};
  gcv_polygon *polygon = POLYGON(0, 0, 0, 0x1p-1074, 0x1p-1074, 0);
  CHECK(polygon_is(polygon, tiny, 3));
  gcv_polygon_destroy(polygon);
  polygon = polygon_of(huge, 4);
  CHECK(polygon_is(polygon, huge, 4));
  gcv_polygon_destroy(polygon);
  polygon = polygon_of(mixed, 3);
  CHECK(polygon_is(polygon, mixed, 3));
  gcv_polygon_destroy(polygon);
}

static void area_is(double expected, const double *xy, size_t count) {
  gcv_polygon *polygon = polygon_of(xy, count);
  double area = -1;
  CHECK_OK(gcv_polygon_area(polygon, &area));
  if (!CHECK(area == expected)) fprintf(stderr, "%a is not %a\n", area, expected);
  gcv_polygon_destroy(polygon);
}

static void areas(void) {
  gcv_polygon *polygon;
  double area = -1;

  area_is(1, RING(0, 0, 1, 0, 1, 1, 0, 1));
  area_is(8, RING(0, 3, 2, 1, 4, 3, 4, 0, 0, 0));

  /* Far from the origin, where the shoelace formula in doubles gives 0, or 7e13. */
  area_is(0.5, RING(1e15, 1e15, 1e15 + 1, 1e15, 1e15, 1e15 + 1));
  area_is(0.234375, RING(1e15, -1e15, 1e15 + 0.125, -1e15 + 0.5, 1e15 + 0.375, -1e15 + 1,
                         1e15 - 0.25, -1e15 + 0.75));
  area_is(5.4140625,
          RING(1e15 + 0.125, 1e15 + 0.25, 1e15 + 3, 1e15 + 0.5, 1e15 + 1.375, 1e15 + 4.125));

  /* In doubles, 0.195: one unit in the last place too much. */
  area_is(0x1.8f5c28f5c28f5p-3, RING(0.1, 0.2, 0.7, 0.3, 0.4, 0.9));

  /* Ties between two doubles, 2^53 + 1 and 2^53 + 3, go to the even neighbour. */
  area_is(0x1p53, RING(0, 0, 321, 0, 321, 28059810762433, 0, 28059810762433));
  area_is(0x1p53 + 4, RING(0, 0, 5, 0, 5, 1801439850948199, 0, 1801439850948199));

  /* 2^-1074 is the smallest double; half of it is a tie, and goes to 0. */
  area_is(0x1p-1074, RING(0, 0, 0x1p-537, 0, 0x1p-537, 0x1p-537, 0, 0x1p-537));
  area_is(0x1p-1074, RING(0, 0, 0x1p-537, 0, 0, 0x1.0000000000001p-537));
  area_is(0, RING(0, 0, 0x1p-537, 0, 0, 0x1p-537));
  area_is(0, RING(0, 0, 1e-200, 0, 1e-200, 1e-200, 0, 1e-200));

  /* Half the sum of the parallel sides, by the height: first DBL_MAX, then the tie
   * between it and 2^1024. */
  area_is(DBL_MAX, RING(0, 0, 0x1p53, 0, 0x1p53 - 2, 0x1p971, 0, 0x1p971));
  polygon = POLYGON(0, 0, 0x1p53, 0, 0x1p53 - 1, 0x1p971, 0, 0x1p971);
  CHECK_STATUS(GCV_ERR_RANGE, gcv_polygon_area(polygon, &area));
  gcv_polygon_destroy(polygon);
  polygon = POLYGON(0, 0, 1e200, 0, 1e200, 1e200, 0, 1e200);
  CHECK_STATUS(GCV_ERR_RANGE, gcv_polygon_area(polygon, &area));
  gcv_polygon_destroy(polygon);
  CHECK(area == -1);
}

static void bounds_are(double x0, double y0, double x1, double y1, const double *xy, size_t count) {
  gcv_polygon *polygon = polygon_of(xy, count);
  double box[4] = {NAN, NAN, NAN, NAN};
  CHECK_OK(gcv_polygon_bounds(polygon, box));
  CHECK(box[0] == x0 && box[1] == y0 && box[2] == x1 && box[3] == y1);
  gcv_polygon_destroy(polygon);
}

static void bounds(void) {
  bounds_are(0, 0, 4, 3, RING(0, 3, 2, 1, 4, 3, 4, 0, 0, 0));
  bounds_are(-2, -0.1, 0.3, 7, RING(-2, 5, 0.3, -0.1, 0, 7));
  bounds_are(-DBL_MAX, -0x1p-1074, DBL_MAX, 0, RING(-DBL_MAX, 0, 0, -0x1p-1074, DBL_MAX, 0));
}

int main(void) {
  normalisation();
  strides();
  huge_counts();
  not_finite();
  degenerate_kinds();
  extremes();
  areas();
  bounds();
  return check_failures != 0;
}

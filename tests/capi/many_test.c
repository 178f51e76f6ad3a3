/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Many polygons at once: each is what gcv_polygon_create makes of its vertices.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "record.h"

enum { MANY = 9 };

/* Good ones, and one of every kind of refusal. */
static const size_t sizes[MANY] = {4, 3, 4, 0, 3, 5, 2, 4, 3};
static const double xy[] = {
    0, 0, 4, 4, 2, 3, 0, 4,           /* a dart */
    0, 0, 0, 2, 3, 3,                 /* a wedge, clockwise */
    0, 0, 1, 1, 1, 0, 0, 1,           /* a bow tie */
                                      /* nothing */
    0, 0, 1, NAN, 0, 1,               /* no number */
    1, 1, 5, 1, 5, 5, 1, 5, 1, 1,     /* a square, closed */
    0, 0, 1, 1,                       /* a line */
    0, 0, 1, 0, 2, 0, 3, 0,           /* another */
    0, 0, 0x1p-1074, 0, 0, 0x1p-1074, /* the smallest triangle */
};

static const gcv_status expected[MANY] = {GCV_OK,
                                          GCV_OK,
                                          GCV_ERR_NOT_SIMPLE,
                                          GCV_ERR_DEGENERATE,
                                          GCV_ERR_NOT_FINITE,
                                          GCV_OK,
                                          GCV_ERR_DEGENERATE,
                                          GCV_ERR_DEGENERATE,
                                          GCV_OK};

static char nowhere;
#define UNTOUCHED ((gcv_polygon *)(void *)&nowhere)

/* Polygons and statuses before and after a call, with one more behind them. */
struct outputs {
  gcv_polygon *polygons[MANY + 1];
  gcv_status statuses[MANY + 1];
};

static struct outputs untouched(void) {
  struct outputs outputs;
  size_t k;
  for (k = 0; k <= MANY; ++k) {
    outputs.polygons[k] = UNTOUCHED;
    outputs.statuses[k] = -4711;
  }
  return outputs;
}

static int untouched_from(const struct outputs *outputs, size_t first) {
  size_t k;
  for (k = first; k <= MANY; ++k) {
    if (outputs->polygons[k] != UNTOUCHED || outputs->statuses[k] != -4711) return 0;
  }
  return 1;
}

static void each_is_as_alone(const struct outputs *outputs) {
  static struct record among, alone;
  const double *vertices = xy;
  size_t k;
  for (k = 0; k < MANY; vertices += 2 * sizes[k], ++k) {
    gcv_polygon *polygon = NULL;
    CHECK_STATUS(expected[k], gcv_polygon_create(vertices, sizes[k], 0, &polygon));
    CHECK(outputs->statuses[k] == expected[k]);
    CHECK((outputs->polygons[k] != NULL) == (expected[k] == GCV_OK));
    among.size = alone.size = 0;
    if (polygon != NULL && outputs->polygons[k] != NULL) {
      put_pair(&among, outputs->polygons[k], outputs->polygons[0], 1);
      put_pair(&alone, polygon, outputs->polygons[0], 1);
    }
    CHECK(among.size == alone.size && memcmp(among.bytes, alone.bytes, alone.size) == 0);
    gcv_polygon_destroy(polygon);
  }
}

static void end(struct outputs *outputs) {
  size_t k;
  for (k = 0; k < MANY; ++k) gcv_polygon_destroy(outputs->polygons[k]);
}

static void all_kinds(void) {
  struct outputs outputs = untouched();
  CHECK_OK(gcv_polygon_create_many(xy, sizes, MANY, 0, outputs.polygons, outputs.statuses));
  /* The message is about the first failure. */
  CHECK(strstr(gcv_last_error_message(), "polygon 2: ") != NULL);
  CHECK(strstr(gcv_last_error_message(), "edges 0 and 2 meet") != NULL);
  CHECK(untouched_from(&outputs, MANY));
  each_is_as_alone(&outputs);
  end(&outputs);
}

static void messages(void) {
  struct outputs outputs = untouched();
  const char *message;
  /* Without a failure, the message stays that of an earlier one. */
  CHECK_STATUS(GCV_ERR_NULL_ARGUMENT, gcv_polygon_area(NULL, NULL));
  CHECK_OK(gcv_polygon_create_many(xy, sizes, 2, 0, outputs.polygons, outputs.statuses));
  message = gcv_last_error_message();
  CHECK(strcmp(message, "polygon is NULL") == 0);
  CHECK(outputs.statuses[0] == GCV_OK && outputs.statuses[1] == GCV_OK);
  CHECK(untouched_from(&outputs, 2));
  gcv_polygon_destroy(outputs.polygons[0]);
  gcv_polygon_destroy(outputs.polygons[1]);
  /* The first of the polygons is number 0, and so is the first of its vertices. */
  outputs = untouched();
  CHECK_OK(
      gcv_polygon_create_many(xy + 2 * 11, sizes + 4, 1, 0, outputs.polygons, outputs.statuses));
  CHECK(strncmp(gcv_last_error_message(), "polygon 0: ", 11) == 0);
  CHECK(strstr(gcv_last_error_message(), "polygon: ") == NULL);
  CHECK(strstr(gcv_last_error_message(), "y coordinate of vertex 1 is ") != NULL);
  CHECK(outputs.polygons[0] == NULL && outputs.statuses[0] == GCV_ERR_NOT_FINITE);
  CHECK(untouched_from(&outputs, 1));
}

/* All vertices, one every `stride` bytes after `offset`, between NaNs, and not a byte behind. */
static void strided(size_t stride, size_t offset) {
  const size_t count = sizeof xy / 16, step = stride == 0 ? 16 : stride;
  const size_t size = offset + (count - 1) * step + 16;
  struct outputs outputs = untouched();
  unsigned char *bytes = malloc(size);
  size_t k;
  if (bytes == NULL) abort();
  memset(bytes, 0xff, size);
  for (k = 0; k < count; ++k) memcpy(bytes + offset + k * step, xy + 2 * k, 16);
  CHECK_OK(gcv_polygon_create_many((const double *)(const void *)(bytes + offset), sizes, MANY,
                                   stride, outputs.polygons, outputs.statuses));
  free(bytes);
  each_is_as_alone(&outputs);
  end(&outputs);
}

static void strides(void) {
  const size_t good[] = {0, 16, 17, 24, 40};
  struct outputs outputs = untouched();
  size_t k, stride;
  for (k = 0; k < sizeof good / sizeof *good; ++k) {
    strided(good[k], 0);
    strided(good[k], 1);
  }
  for (stride = 1; stride < 16; ++stride) {
    CHECK_REFUSED(
        GCV_ERR_INVALID_ARGUMENT, "stride",
        gcv_polygon_create_many(xy, sizes, MANY, stride, outputs.polygons, outputs.statuses));
  }
  CHECK(untouched_from(&outputs, 0));
}

static void of_none(void) {
  struct outputs outputs = untouched();
  CHECK_OK(gcv_polygon_create_many(NULL, NULL, 0, 0, NULL, NULL));
  CHECK_OK(gcv_polygon_create_many(xy, sizes, 0, 3, outputs.polygons, outputs.statuses));
  CHECK(untouched_from(&outputs, 0));
}

static void null_pointers(void) {
  struct outputs outputs = untouched();
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "xy",
                gcv_polygon_create_many(NULL, sizes, 1, 0, outputs.polygons, outputs.statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "sizes",
                gcv_polygon_create_many(xy, NULL, 1, 0, outputs.polygons, outputs.statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "out",
                gcv_polygon_create_many(xy, sizes, 1, 0, NULL, outputs.statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "statuses",
                gcv_polygon_create_many(xy, sizes, 1, 0, outputs.polygons, NULL));
  CHECK(untouched_from(&outputs, 0));
}

/* A polygon of too many vertices is one that fails; more than memory can hold are no list. */
static void huge_sizes(void) {
  const size_t too_many[] = {3, (size_t)1 << 31};
  const size_t beyond[][3] = {{SIZE_MAX, 3, 3},
                              {3, SIZE_MAX - 2, 3},
                              {3, 3, SIZE_MAX / 16},
                              {SIZE_MAX / 32, SIZE_MAX / 32, 3}};
  struct outputs outputs = untouched();
  size_t k;
  if (sizeof(size_t) > 4) { /* else, they are more than memory can hold */
    CHECK_OK(gcv_polygon_create_many(xy + 8, too_many, 2, 0, outputs.polygons, outputs.statuses));
    CHECK(outputs.statuses[0] == GCV_OK && outputs.statuses[1] == GCV_ERR_INVALID_ARGUMENT);
    CHECK(outputs.polygons[0] != NULL && outputs.polygons[1] == NULL);
    CHECK(strstr(gcv_last_error_message(), "polygon 1: ") != NULL);
    gcv_polygon_destroy(outputs.polygons[0]);
  }

  outputs = untouched();
  for (k = 0; k < sizeof beyond / sizeof *beyond; ++k) {
    CHECK_REFUSED(
        GCV_ERR_INVALID_ARGUMENT, "sizes",
        gcv_polygon_create_many(xy + 8, beyond[k], 3, 0, outputs.polygons, outputs.statuses));
  }
  CHECK(untouched_from(&outputs, 0));
}

/* Thousands, of which every fifth is none. */
static void thousands(void) {
  enum { COUNT = 5000 };
  static double vertices[COUNT * 6];
  static size_t counts[COUNT];
  static gcv_polygon *polygons[COUNT];
  static gcv_status statuses[COUNT];
  size_t k;
  for (k = 0; k < COUNT; ++k) {
    double *to = vertices + 6 * k;
    const double x = (double)k;
    counts[k] = 3;
    to[0] = x;
    to[2] = x + 1;
    to[5] = k % 5 == 3 ? 0 : 1;
    to[4] = x;
  }
  CHECK_OK(gcv_polygon_create_many(vertices, counts, COUNT, 0, polygons, statuses));
  CHECK(strstr(gcv_last_error_message(), "polygon 3: ") != NULL);
  for (k = 0; k < COUNT; ++k) {
    const int is_none = k % 5 == 3;
    CHECK(statuses[k] == (is_none ? GCV_ERR_DEGENERATE : GCV_OK));
    CHECK((polygons[k] == NULL) == is_none);
    if (!is_none) {
      const double x = (double)k;
      CHECK(polygon_is(polygons[k], RING(x, 0, x + 1, 0, x, 1)));
    }
    gcv_polygon_destroy(polygons[k]);
  }
}

int main(void) {
  all_kinds();
  messages();
  strides();
  of_none();
  null_pointers();
  huge_sizes();
  thousands();
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Polygons with holes: normalised rings, the caller's numbers through all rings, arguments that
 * are refused, and outer faces, which holes never change.
 */
#include <stdint.h>

#include "record.h"
#include "rings.h"

/* A square with two holes, each ring closed and with vertices to drop; and so that numbers count
 * through them: the outer ring has the vertices 0 to 6, the first hole 7 to 12, the other one 13 to
 * 17. */
static const struct rings plate = {
    3, {7, 6, 5}, {8, 0, 8, 8, 8, 8, 0, 8, 0, 4, -0.0, -0.0, 8, 0, /* counter-clockwise */
                   1, 1, 2, 1, 3, 1, 3, 3, 1, 3, 1,    1,          /* counter-clockwise */
                   6, 6, 5, 6, 5, 7, 6, 7, 6, 6}};                 /* clockwise */

static const struct rings clockwise_crossing = {
    2, {4, 4}, {0, 0, 0, 10, 10, 10, 10, 0, -1, 1, 1, 1, 1, 2, -1, 2}};
static const struct rings hole_outside = {
    2, {4, 4}, {0, 0, 10, 0, 10, 10, 0, 10, 21, 21, 20, 21, 20, 20, 21, 20}};

static void normalised(void) {
  gcv_polygon *polygon = polygon_of_rings(&plate);
  double area = -1, bounds[4];
  size_t count = 0;
  CHECK_OK(gcv_polygon_ring_count(polygon, &count));
  CHECK(count == 3);
  CHECK(ring_is(polygon, 0, RING(0, 0, 8, 0, 8, 8, 0, 8)));
  CHECK(polygon_is(polygon, RING(0, 0, 8, 0, 8, 8, 0, 8)));
  CHECK(ring_is(polygon, 1, RING(1, 1, 1, 3, 3, 3, 3, 1)));
  CHECK(ring_is(polygon, 2, RING(5, 6, 5, 7, 6, 7, 6, 6)));
  CHECK_OK(gcv_polygon_area(polygon, &area));
  CHECK(area == 64 - 4 - 1);
  CHECK_OK(gcv_polygon_bounds(polygon, bounds));
  CHECK(bounds[0] == 0 && bounds[1] == 0 && bounds[2] == 8 && bounds[3] == 8);
  gcv_polygon_destroy(polygon);

  polygon = POLYGON(0, 0, 1, 0, 0, 1);
  CHECK_OK(gcv_polygon_ring_count(polygon, &count));
  CHECK(count == 1);
  CHECK(ring_is(polygon, 0, RING(0, 0, 1, 0, 0, 1)));
  gcv_polygon_destroy(polygon);
}

static void ring_numbers(void) {
  const size_t beyond[] = {3, 4, SIZE_MAX};
  gcv_polygon *polygon = polygon_of_rings(&plate);
  size_t k, required = 4711;
  double xy[8] = {-1};
  for (k = 0; k < sizeof beyond / sizeof *beyond; ++k) {
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ring is ",
                  gcv_polygon_ring(polygon, beyond[k], xy, 4, &required));
  }
  CHECK(xy[0] == -1 && required == 4711);
  gcv_polygon_destroy(polygon);
}

/* A slip of what the holes take away would show in the last place. */
static void areas(void) {
  static const struct rings thin = {
      2, {4, 4}, {0, 0, 0x1p53, 0, 0x1p53, 1, 0, 1, 2, 0.25, 4, 0.25, 4, 0.75, 2, 0.75}};
  static const struct rings huge = {2,
                                    {4, 4},
                                    {0, 0, 0x1p512, 0, 0x1p512, 0x1p512, 0, 0x1p512, 0, 0x1p511,
                                     0x1p511, 0, 0x1p512, 0x1p511, 0x1p511, 0x1p512}};
  gcv_polygon *polygon = polygon_of_rings(&thin);
  double area = -1;
  CHECK_OK(gcv_polygon_area(polygon, &area));
  CHECK(area == 0x1p53 - 1);
  gcv_polygon_destroy(polygon);

  /* The square is beyond the largest double, what is left of it is not. */
  polygon = polygon_of_rings(&huge);
  CHECK_OK(gcv_polygon_area(polygon, &area));
  CHECK(area == 0x1p1023);
  gcv_polygon_destroy(polygon);
}

static void messages(void) {
  struct rings rings = plate;
  gcv_polygon *polygon = NULL;
  size_t k;
  char part[96];

  /* A NaN in every place. */
  for (k = 0; k < 36; ++k) {
    const size_t vertex = k / 2, ring = vertex < 7 ? 0 : vertex < 13 ? 1 : 2;
    rings = plate;
    rings.xy[k] = k % 3 == 0 ? NAN : k % 3 == 1 ? INFINITY : -INFINITY;
    snprintf(part, sizeof part, "ring %d: the %c coordinate of vertex %d is ", (int)ring,
             k % 2 == 0 ? 'x' : 'y', (int)vertex);
    CHECK_REFUSED(GCV_ERR_NOT_FINITE, part, create_rings(&rings, &polygon));
  }

  /* In text as well, vertices are numbered through all rings. */
  {
    static const char text[] = "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 1 2, 2 nan))";
    CHECK_REFUSED(GCV_ERR_NOT_FINITE, "nan in vertex 6 of ring 1 ",
                  gcv_polygon_create_wkt(text, sizeof text - 1, &polygon));
  }

  /* Vertex 10 of the first hole into the other one. */
  rings = plate;
  rings.xy[20] = 5.5;
  rings.xy[21] = 6.5;
  CHECK_REFUSED(GCV_ERR_NOT_SIMPLE, "rings 1 and 2 cross", create_rings(&rings, &polygon));

  /* The last vertex of the other hole outside: its edges 15 and 16 cross the wall, edge 2. */
  rings = plate;
  rings.xy[32] = 6.5;
  rings.xy[33] = 9;
  CHECK_REFUSED(GCV_ERR_NOT_SIMPLE, "rings 0 and 2 cross: edges 2 and 1",
                create_rings(&rings, &polygon));

  /* Against the caller's direction, too, a vertex has its own number and place: the outer ring is
   * clockwise, and so is the hole that the message names by its smallest vertex. */
  CHECK_REFUSED(GCV_ERR_NOT_SIMPLE,
                "edges 0 and 4 meet; they have an end in vertex 1 (0, 10) and in vertex 5 (1, 1)",
                create_rings(&clockwise_crossing, &polygon));
  CHECK_REFUSED(GCV_ERR_NOT_SIMPLE, "lies outside ring 0: edge 5 has an end in vertex 6 (20, 20)",
                create_rings(&hole_outside, &polygon));

  /* Rings that meet themselves. */
  rings = plate;
  rings.xy[30] = 5.25; /* vertex 15 */
  rings.xy[31] = 5;
  rings.xy[32] = 5.75; /* vertex 16 */
  rings.xy[33] = 7;
  CHECK_REFUSED(GCV_ERR_NOT_SIMPLE, "ring 2: edges 13 and 15 meet", create_rings(&rings, &polygon));
  rings = plate;
  rings.xy[8] = 9; /* vertex 4 */
  CHECK_REFUSED(GCV_ERR_NOT_SIMPLE, "ring 0: edges ", create_rings(&rings, &polygon));

  /* Holes of no area. */
  rings = plate;
  rings.xy[20] = 5; /* vertex 10 onto the line of the hole's other ones */
  rings.xy[21] = 1;
  rings.xy[22] = 4;
  rings.xy[23] = 1;
  CHECK_REFUSED(GCV_ERR_DEGENERATE, "ring 1: all 6 vertices", create_rings(&rings, &polygon));
  rings = plate;
  rings.sizes[2] = 2;
  CHECK_REFUSED(GCV_ERR_DEGENERATE, "ring 2: 2 distinct", create_rings(&rings, &polygon));
  rings.sizes[2] = 0;
  CHECK_REFUSED(GCV_ERR_DEGENERATE, "ring 2: 0 distinct", create_rings(&rings, &polygon));
  rings.sizes[0] = 2;
  CHECK_REFUSED(GCV_ERR_DEGENERATE, "ring 0: ", create_rings(&rings, &polygon));
  CHECK(polygon == NULL);
}

/* Without other rings, there are no numbers of rings. */
static void one_ring(void) {
  struct rings bow_tie = {1, {4}, {0, 0, 1, 1, 1, 0, 0, 1}};
  gcv_polygon *polygon = NULL;
  CHECK_REFUSED(GCV_ERR_NOT_SIMPLE, "polygon: edges 0 and 2", create_rings(&bow_tie, &polygon));
  bow_tie.count = 0;
  CHECK_REFUSED(GCV_ERR_DEGENERATE, "ring_count is 0", create_rings(&bow_tie, &polygon));
  CHECK(polygon == NULL);
}

static void huge_sizes(void) {
  const size_t limit = ((size_t)1 << 31) - 1;
  struct rings rings = plate;
  gcv_polygon *polygon = NULL;
  size_t k;
  for (k = 0; k < 3; ++k) {
    rings = plate;
    rings.sizes[k] = SIZE_MAX;
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ring_sizes", create_rings(&rings, &polygon));
    rings.sizes[k] = limit + 1;
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ring_sizes", create_rings(&rings, &polygon));
    rings.sizes[k] = limit - 17 + plate.sizes[k]; /* one too many together */
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ring_sizes", create_rings(&rings, &polygon));
  }
  for (k = 0; k < 3; ++k) rings.sizes[k] = SIZE_MAX / 3 + 7; /* more than 0 where it wraps */
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ring_sizes", create_rings(&rings, &polygon));
  CHECK(polygon == NULL);
}

/* All vertices, one every `stride` bytes after `offset`, between NaNs, and not a byte behind. */
static void strided(size_t stride, size_t offset) {
  const size_t step = stride == 0 ? 16 : stride, size = offset + 17 * step + 16;
  unsigned char *bytes = malloc(size);
  gcv_polygon *polygon = NULL;
  size_t k;
  if (bytes == NULL) abort();
  memset(bytes, 0xff, size);
  for (k = 0; k < 18; ++k) memcpy(bytes + offset + k * step, plate.xy + 2 * k, 16);
  CHECK_OK(gcv_polygon_create_rings((const double *)(const void *)(bytes + offset), plate.sizes, 3,
                                    stride, &polygon));
  free(bytes);
  CHECK(ring_is(polygon, 0, RING(0, 0, 8, 0, 8, 8, 0, 8)));
  CHECK(ring_is(polygon, 1, RING(1, 1, 1, 3, 3, 3, 3, 1)));
  CHECK(ring_is(polygon, 2, RING(5, 6, 5, 7, 6, 7, 6, 6)));
  gcv_polygon_destroy(polygon);
}

static void strides(void) {
  const size_t good[] = {0, 16, 17, 24, 40};
  const size_t huge[] = {(size_t)-16, (size_t)PTRDIFF_MAX + 1, (size_t)PTRDIFF_MAX / 17};
  gcv_polygon *polygon = NULL;
  size_t k, stride;
  for (k = 0; k < sizeof good / sizeof *good; ++k) {
    strided(good[k], 0);
    strided(good[k], 1);
  }
  for (stride = 1; stride < 16; ++stride) {
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "stride",
                  gcv_polygon_create_rings(plate.xy, plate.sizes, 3, stride, &polygon));
  }
  for (k = 0; k < sizeof huge / sizeof *huge; ++k) {
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ring_sizes: with stride_bytes ",
                  gcv_polygon_create_rings(plate.xy, plate.sizes, 3, huge[k], &polygon));
  }
  CHECK(polygon == NULL);
}

/* The dart and its holes, from another vertex and clockwise; all that sums of it say. */
static const struct rings dart = {
    3, {5, 4, 3}, {2,   3, 4, 4,   0,   0,   0,   4, 2, 3, /* closed, clockwise */
                   0.5, 1, 1, 1.5, 0.5, 1.5, 0.5, 1,       /* closed */
                   0,   3, 1, 2.5, 2,   3}};               /* touches twice */

static void put_all_sums(struct record *record, const gcv_polygon *a, const gcv_polygon *b) {
  int32_t rounding;
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    put_sums(record, a, b, 0, rounding);
    put_sums(record, b, a, 0, rounding);
    put_sums(record, a, b, 1, rounding);
  }
}

static void holes_change_no_outer_face(void) {
  static struct record with, without;
  gcv_polygon *holed = polygon_of_rings(&dart), *whole = polygon_of(dart.xy, dart.sizes[0]);
  gcv_polygon *wedge = POLYGON(0, 0, 3, 3, 0.1, 2);
  put_all_sums(&with, holed, wedge);
  put_all_sums(&without, whole, wedge);
  put_all_sums(&with, holed, holed);
  put_all_sums(&without, whole, whole);
  CHECK(with.size > 5000 && with.size == without.size);
  CHECK(memcmp(with.bytes, without.bytes, with.size) == 0);
  gcv_polygon_destroy(wedge);
  gcv_polygon_destroy(whole);
  gcv_polygon_destroy(holed);
}

/* The edges of the dart in its sum with a wedge; compare source_test.c. */
static void sources(void) {
  static const gcv_edge_source expected[] = {
      {GCV_EDGE_TRANSLATED_CORNER, 1, 0}, {GCV_EDGE_CORNER, 1, 1},
      {GCV_EDGE_TRANSLATED, 3, 1},        {GCV_EDGE_CORNER, 3, 1},
      {GCV_EDGE_TRANSLATED_CORNER, 2, 2},
  };
  gcv_polygon *polygon = polygon_of_rings(&dart), *wedge = POLYGON(0, 0, 3, 3, 0, 2);
  gcv_outer_face *face = sum_of(polygon, wedge);
  gcv_edge_source found[5];
  size_t required = 0, k;
  CHECK_OK(gcv_outer_face_edge_sources(face, found, 5, &required));
  CHECK(required == 5);
  for (k = 0; k < 5; ++k) {
    if (!CHECK(memcmp(&found[k], &expected[k], sizeof *found) == 0)) {
      fprintf(stderr, "  %d: {%d, %u, %u}\n", (int)k, (int)found[k].kind, found[k].a, found[k].b);
    }
  }
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(wedge);
  gcv_polygon_destroy(polygon);
}

static void from_wkt(void) {
  static const char text[] =
      "POLYGON ((8 0, 8 8, 0 8, 0 0, 8 0), (1 1, 3 1, 3 3, 1 3), "
      "(6 6, 5 6, 5 7, 6 7, 6 6))";
  static const char crossing[] =
      "POLYGON ((8 0, 8 8, 0 8, 0 0, 8 0), (1 1, 3 1, 3 3, 1 3, 1 1), "
      "(7 6, 9 6, 9 7))";
  gcv_polygon *polygon = NULL;
  CHECK_OK(gcv_polygon_create_wkt(text, sizeof text - 1, &polygon));
  CHECK(ring_is(polygon, 0, RING(0, 0, 8, 0, 8, 8, 0, 8)));
  CHECK(ring_is(polygon, 1, RING(1, 1, 1, 3, 3, 3, 3, 1)));
  CHECK(ring_is(polygon, 2, RING(5, 6, 5, 7, 6, 7, 6, 6)));
  gcv_polygon_destroy(polygon);
  polygon = NULL;
  CHECK_REFUSED(GCV_ERR_NOT_SIMPLE, "rings 0 and 2 cross: edges 0 and 1",
                gcv_polygon_create_wkt(crossing, sizeof crossing - 1, &polygon));
  CHECK(polygon == NULL);
}

int main(void) {
  normalised();
  ring_numbers();
  areas();
  messages();
  one_ring();
  huge_sizes();
  strides();
  holes_change_no_outer_face();
  sources();
  from_wkt();
  return check_failures != 0;
}

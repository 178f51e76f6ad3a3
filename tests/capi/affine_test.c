/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Polygons moved, turned, reflected and scaled: what is exact, what is rounded, what is refused,
 * and whose numbers stay. affine_test.cpp of the core has numbers of all sizes.
 */
#include <float.h>

#include "rings.h"

#define MAP(...) ((const double[6]){__VA_ARGS__})

static gcv_polygon *mapped(const gcv_polygon *polygon, const double *m) {
  gcv_polygon *out = NULL;
  CHECK_OK(gcv_polygon_affine(polygon, m, &out));
  return out;
}

/* The image is the polygon of these vertices. */
static void maps_to(const gcv_polygon *polygon, const double *m, const double *xy, size_t count) {
  gcv_polygon *image = mapped(polygon, m), *expected = polygon_of(xy, count);
  double vertices[2 * MOST_VERTICES];
  size_t required = 0;
  CHECK_OK(gcv_polygon_vertices(expected, vertices, MOST_VERTICES, &required));
  CHECK(required == count);
  if (!CHECK(image != NULL && polygon_is(image, vertices, count))) {
    fprintf(stderr, "  by %g %g %g %g %g %g\n", m[0], m[1], m[2], m[3], m[4], m[5]);
  }
  gcv_polygon_destroy(expected);
  gcv_polygon_destroy(image);
}

static void refuses(gcv_status status, const char *part, const gcv_polygon *polygon,
                    const double *m) {
  gcv_polygon *out = NULL;
  CHECK_REFUSED(status, part, gcv_polygon_affine(polygon, m, &out));
  CHECK(out == NULL);
}

static gcv_polygon *dart;

static void exact_maps(void) {
  const double tiny = 0x1p-1074;
  gcv_polygon *extreme = POLYGON(-DBL_MAX, tiny, 1, -DBL_MAX, DBL_MAX, 0x0.fffffffffffffp-1022);
  maps_to(dart, MAP(1, 0, 0, 0, 1, 0), RING(0, 0, 4, 4, 2, 3, 0, 4));
  maps_to(dart, MAP(1, -0.0, -0.0, -0.0, 1, -0.0), RING(0, 0, 4, 4, 2, 3, 0, 4));
  maps_to(dart, MAP(0, -1, 0, 1, 0, 0), RING(0, 0, -4, 4, -3, 2, -4, 0));
  maps_to(dart, MAP(-1, 0, 0, 0, -1, 0), RING(0, 0, -4, -4, -2, -3, 0, -4));
  maps_to(dart, MAP(0, 1, 0, -1, 0, 0), RING(0, 0, 4, -4, 3, -2, 4, 0));
  maps_to(dart, MAP(-1, 0, 0, 0, 1, 0), RING(0, 0, -4, 4, -2, 3, 0, 4));
  maps_to(dart, MAP(1, 0, 0, 0, -1, 0), RING(0, 0, 4, -4, 2, -3, 0, -4));
  maps_to(dart, MAP(0, 1, 0, 1, 0, 0), RING(0, 0, 4, 4, 3, 2, 4, 0));
  maps_to(dart, MAP(1, 0, 7, 0, 1, -9), RING(7, -9, 11, -5, 9, -6, 7, -5));
  maps_to(dart, MAP(1, 2, 0, -3, 1, 0), RING(0, 0, 12, -8, 8, -3, 8, 4));
  maps_to(dart, MAP(tiny, 0, 0, 0, 0x1p1021, 0),
          RING(0, 0, 4 * tiny, 0x1p1023, 2 * tiny, 0x1.8p1022, 0, 0x1p1023));
  maps_to(extreme, MAP(1, 0, 0, 0, 1, 0),
          RING(-DBL_MAX, tiny, 1, -DBL_MAX, DBL_MAX, 0x0.fffffffffffffp-1022));
  maps_to(extreme, MAP(0, -1, 0, 1, 0, 0),
          RING(-tiny, -DBL_MAX, DBL_MAX, 1, -0x0.fffffffffffffp-1022, DBL_MAX));
  maps_to(extreme, MAP(0.5, 0, 0, 0, -0.5, 0),
          RING(-DBL_MAX / 2, 0, 0.5, DBL_MAX / 2, DBL_MAX / 2, -0x1p-1023));
  gcv_polygon_destroy(extreme);
}

/* One rounding, to nearest, ties to even: 2^53 + 1 goes down, 2^53 + 3 up, and less than half of
 * the smallest double counts as well. */
static void rounded_maps(void) {
  const double big = 0x1p53, tiny = 0x1p-1074;
  gcv_polygon *square = POLYGON(1, 1, 3, 1, 3, 3, 1, 3);
  gcv_polygon *large =
      POLYGON(0x1p950, 0x1p950, 0x1p950 + 0x1p898, 0x1p950, 0x1p950, 0x1p950 + 0x1p898);
  maps_to(square, MAP(1, 0, big, 0, 1, big),
          RING(big, big, big + 4, big, big + 4, big + 4, big, big + 4));
  maps_to(square, MAP(1, 0, -big, 0, 1, -big),
          RING(-big + 1, -big + 1, -big + 3, -big + 1, -big + 3, -big + 3, -big + 1, -big + 3));
  maps_to(square, MAP(1, tiny, big, 0, 1, 0), RING(big + 2, 1, big + 4, 1, big + 4, 3, big + 2, 3));
  maps_to(square, MAP(1, -tiny, big, 0, 1, 0), RING(big, 1, big + 2, 1, big + 2, 3, big, 3));
  /* The products overflow, their sum does not. */
  maps_to(large, MAP(0x1p100, -0x1p100, 3, 0, 0x1p-950, 0),
          RING(3, 1, 0x1p998, 1, -0x1p998, 1 + 0x1p-52));
  gcv_polygon_destroy(large);
  gcv_polygon_destroy(square);
}

/* Against sums that long doubles hold exactly, and then round once. */
static void random_maps(void) {
  const double none[6] = {0};
  uint64_t state = 1;
  int k, made = 0;
  for (k = 0; k < 20000; ++k) {
    double m[6], xy[6], expected[6];
    gcv_polygon *polygon = NULL, *image = NULL, *direct = NULL;
    int i;
    for (i = 0; i < 12; ++i) {
      const int bits = i % 3 == 2 && i < 6 ? 53 : k % 2 == 0 ? 4 : 27; /* two products: 55 bits */
      state = state * 6364136223846793005U + 1442695040888963407U;
      *(i < 6 ? &m[i] : &xy[i - 6]) =
          ldexp((double)(int64_t)(state >> (64 - bits)), i % 3 == 2 && i < 6 ? k % 7 : 0) *
          ((state & 1024) != 0 ? -1 : 1);
    }
    for (i = 0; i < 6; ++i) {
      const double *row = i % 2 == 0 ? m : m + 3, *p = xy + i / 2 * 2;
      expected[i] = (double)((long double)row[0] * p[0] + (long double)row[1] * p[1] + row[2]);
    }
    if (gcv_polygon_create(xy, 3, 0, &polygon) == GCV_OK) {
      const gcv_status status = gcv_polygon_create(expected, 3, 0, &direct);
      CHECK_STATUS(status, gcv_polygon_affine(polygon, m, &image));
      if (status == GCV_OK && image != NULL) {
        ++made;
        if (!CHECK(gcv_polygon_vertices(direct, xy, 3, &(size_t){0}) == GCV_OK &&
                   polygon_is(image, xy, 3))) {
          fprintf(stderr, "  %d\n", k);
        }
      }
    }
    gcv_polygon_destroy(polygon);
    gcv_polygon_destroy(image);
    gcv_polygon_destroy(direct);
  }
  CHECK(made > 10000);
  refuses(GCV_ERR_DEGENERATE, "", dart, none);
}

static void refusals(void) {
  gcv_polygon *slit = POLYGON(0, 0, 8, 0, 8, 8, 4, 0.25, 0, 8),
              *far = POLYGON(0, 0, DBL_MAX, 0, 0, 1);
  char part[64];
  int k;
  for (k = 0; k < 6; ++k) {
    double m[6] = {1, 0, 0, 0, 1, 0};
    snprintf(part, sizeof part, "m[%d] is ", k);
    m[k] = NAN;
    refuses(GCV_ERR_NOT_FINITE, part, dart, m);
    m[k] = INFINITY;
    refuses(GCV_ERR_NOT_FINITE, part, dart, m);
    m[k] = -INFINITY;
    refuses(GCV_ERR_NOT_FINITE, part, dart, m);
  }
  /* Beyond the largest double by the rounding alone, and by far. */
  maps_to(far, MAP(1, 0, 0x1p969, 0, 1, 0), RING(0x1p969, 0, DBL_MAX, 0, 0x1p969, 1));
  refuses(GCV_ERR_RANGE, "the x coordinate of vertex 1 is", far, MAP(1, 0, 0x1p970, 0, 1, 0));
  refuses(GCV_ERR_RANGE, "the x coordinate of vertex 1 is", far, MAP(2, 0, 0, 0, 1, 0));
  refuses(GCV_ERR_RANGE, "the y coordinate of vertex 1 is", far, MAP(0, 1, 0, DBL_MAX, 0, 0));
  refuses(GCV_ERR_RANGE, "the x coordinate of vertex 1 is", dart,
          MAP(DBL_MAX, DBL_MAX, 0, 0, 1, 0));
  refuses(GCV_ERR_RANGE, "the x coordinate of vertex 1 is", far, MAP(-1, 0, -DBL_MAX, 0, 1, 0));
  /* Onto a line or a point, by the map or by the roundings. */
  refuses(GCV_ERR_DEGENERATE, "", dart, MAP(1, 0, 0, 1, 0, 0));
  refuses(GCV_ERR_DEGENERATE, "", dart, MAP(1, 2, 3, 2, 4, 6));
  refuses(GCV_ERR_DEGENERATE, "", dart, MAP(0, 0, 5, 0, 1, 0));
  refuses(GCV_ERR_DEGENERATE, "", dart, MAP(1, 0, 0x1p56, 0, 1, 0x1p56));
  refuses(GCV_ERR_DEGENERATE, "", dart, MAP(0x1p-1074, 0, 0, 0, 0x1p-1074, 1));
  /* The tip of the slit comes to lie on the edge below. */
  maps_to(slit, MAP(1, 0, 0, 0, 1, 0x1p50),
          RING(0, 0x1p50, 8, 0x1p50, 8, 0x1p50 + 8, 4, 0x1p50 + 0.25, 0, 0x1p50 + 8));
  refuses(GCV_ERR_NOT_SIMPLE, "edges 0 and 3 meet", slit, MAP(1, 0, 0, 0, 1, 0x1p51));
  gcv_polygon_destroy(far);
  gcv_polygon_destroy(slit);
}

static int by_source(const void *p, const void *q) { return memcmp(p, q, sizeof(gcv_edge_source)); }

static size_t sorted_sources(const gcv_polygon *a, const gcv_polygon *b, gcv_edge_source *sources) {
  gcv_outer_face *face = sum_of(a, b);
  size_t count = 0;
  CHECK_OK(gcv_outer_face_edge_sources(face, sources, MOST_VERTICES, &count));
  qsort(sources, count, sizeof *sources, by_source);
  gcv_outer_face_destroy(face);
  return count;
}

/* Edges of the sum of the images come from the same edges and vertices, by reflections too. */
static void numbers_stay(const double *xy, size_t count) {
  static const double maps[][6] = {{1, 0, 0, 0, 1, 0},  {0, -1, 0, 1, 0, 0},  {-1, 0, 0, 0, -1, 0},
                                   {0, 1, 0, -1, 0, 0}, {-1, 0, 0, 0, 1, 0},  {1, 0, 0, 0, -1, 0},
                                   {0, 1, 0, 1, 0, 0},  {0, -1, 0, -1, 0, 0}, {2, 1, 3, 1, 3, -4},
                                   {1, 2, 0, 3, 1, 0}};
  gcv_polygon *a = polygon_of(xy, count), *b = POLYGON(5, 1, 0, 0, 0, 0, 1, 3);
  gcv_edge_source expected[MOST_VERTICES], found[MOST_VERTICES];
  const size_t edges = sorted_sources(a, b, expected);
  size_t k;
  for (k = 0; k < sizeof maps / sizeof *maps; ++k) {
    gcv_polygon *of_a = mapped(a, maps[k]), *of_b = mapped(b, maps[k]);
    if (!CHECK(sorted_sources(of_a, of_b, found) == edges &&
               memcmp(found, expected, edges * sizeof *found) == 0)) {
      fprintf(stderr, "  by map %d, of %d vertices\n", (int)k, (int)count);
    }
    gcv_polygon_destroy(of_a);
    gcv_polygon_destroy(of_b);
  }
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

static void numbers(void) {
  const struct rings plate = {
      2, {6, 5}, {8, 0, 8, 8, 0, 8, 0, 8, 0, 0, 8, 0, 1, 1, 1, 1, 5, 1, 1, 5, 1, 1}};
  gcv_polygon *polygon = polygon_of_rings(&plate), *turned;
  numbers_stay(RING(0, 0, 4, 4, 2, 3, 0, 4));
  numbers_stay(RING(2, 3, 4, 4, 0, 0, 0, 4, 2, 3));                     /* clockwise, closed */
  numbers_stay(RING(0, 0, 0, 0, 4, 4, 4, 4, 2, 3, 0, 4, 0, 4));         /* repeated */
  numbers_stay(RING(1, 1, 2, 2, 4, 4, 2, 3, 1, 3.5, 0, 4, 0, 2, 0, 0)); /* collinear */
  numbers_stay(RING(0, 0, 0, 2, 0, 4, 1, 3.5, 2, 3, 4, 4, 2, 2, 1, 1)); /* both, clockwise */
  /* The numbers in messages are those that the polygon was created with. */
  turned = mapped(polygon, MAP(0, 1, 0, 1, 0, 0));
  refuses(GCV_ERR_RANGE, "the mapped polygon: ring 0: the x coordinate of vertex 3 ", turned,
          MAP(0x1p1021, 0, 0, 0, 1, 0));
  refuses(GCV_ERR_NOT_SIMPLE,
          "rings 0 and 1 cross, overlap, or touch from the wrong side: edges 4 and 9 ", turned,
          MAP(0, 1, 0, 1, 0, 0x1p54));
  gcv_polygon_destroy(turned);
  gcv_polygon_destroy(polygon);
}

static void holes(void) {
  const struct rings plate = {
      3, {4, 3, 4}, {0, 0, 8, 0, 8, 8, 0, 8, 1, 1, 3, 1, 1, 2, 4, 4, 6, 3, 8, 4, 6, 5}};
  gcv_polygon *polygon = polygon_of_rings(&plate), *image = mapped(polygon, MAP(0, 2, 0, 1, 0, -1));
  double area = 0;
  CHECK(ring_is(image, 0, RING(0, -1, 16, -1, 16, 7, 0, 7)));
  CHECK(ring_is(image, 1, RING(2, 0, 2, 2, 4, 0)));
  CHECK(ring_is(image, 2, RING(6, 5, 8, 7, 10, 5, 8, 3)));
  CHECK_OK(gcv_polygon_area(image, &area));
  CHECK(area == 2 * (64 - 1 - 4));
  gcv_polygon_destroy(image);
  /* All of the first hole comes to lie on the wall. */
  refuses(GCV_ERR_DEGENERATE, "ring 1: ", polygon, MAP(1, 0, 0x1p55, 0, 1, 0));
  gcv_polygon_destroy(polygon);
}

int main(void) {
  dart = POLYGON(0, 0, 4, 4, 2, 3, 0, 4);
  exact_maps();
  rounded_maps();
  random_maps();
  refusals();
  numbers();
  holes();
  gcv_polygon_destroy(dart);
  return check_failures != 0;
}

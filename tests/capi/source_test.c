/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Which edges of the input an edge of the sum comes from, in the caller's numbers. All
 * sums here are that of the dart (0 0, 4 4, 2 3, 0 4) and the wedge (0 0, 3 3, 0 2), with
 * the ring (0 0, 7 7, 23/5 31/5, 3 7, 0 6). The edges of that come from
 *   0  the dart's edge to (4, 4) and the wedge's to (3, 3), of one direction,
 *   1  the wedge's edge from (3, 3), at the dart's (4, 4),
 *   2  the dart's edge to (0, 4), at the wedge's (3, 3),
 *   3  the wedge's edge from (3, 3), at the dart's (0, 4),
 *   4  the dart's edge from (0, 4) and the wedge's from (0, 2), of one direction.
 */
#include "handles.h"

enum { EDGES = 5 };

static const gcv_edge_source by_normalised_numbers[EDGES] = {
    {GCV_EDGE_TRANSLATED_CORNER, 0, 0}, {GCV_EDGE_CORNER, 1, 1},
    {GCV_EDGE_TRANSLATED, 2, 1},        {GCV_EDGE_CORNER, 3, 1},
    {GCV_EDGE_TRANSLATED_CORNER, 3, 2},
};

/* The sources as they are with the dart's numbers of them in place of 0 1 2 3 3, and the
 * wedge's in place of 0 1 1 1 2. */
static int sources_are(const gcv_outer_face *face, const uint32_t *of_dart,
                       const uint32_t *of_wedge, int dart_is_b) {
  gcv_edge_source sources[EDGES];
  size_t required = 0;
  int k, right = 1;
  if (!CHECK_OK(gcv_outer_face_edge_sources(face, sources, EDGES, &required))) return 0;
  if (!CHECK(required == EDGES)) return 0;
  for (k = 0; k < EDGES; ++k) {
    const int kind = by_normalised_numbers[k].kind;
    const int swapped = kind == GCV_EDGE_TRANSLATED_CORNER ? kind
                        : kind == GCV_EDGE_CORNER          ? GCV_EDGE_TRANSLATED
                                                           : GCV_EDGE_CORNER;
    const gcv_edge_source expected = {dart_is_b ? swapped : kind,
                                      dart_is_b ? of_wedge[k] : of_dart[k],
                                      dart_is_b ? of_dart[k] : of_wedge[k]};
    if (memcmp(&sources[k], &expected, sizeof expected) != 0) {
      fprintf(stderr, "edge %d comes from {%d, %u, %u}, not from {%d, %u, %u}\n", k,
              (int)sources[k].kind, sources[k].a, sources[k].b, (int)expected.kind, expected.a,
              expected.b);
      right = 0;
    }
  }
  return right;
}

struct numbered {
  size_t count;
  double xy[24];
  uint32_t number[EDGES];
};

static const struct numbered darts[] = {
    {4, {0, 0, 4, 4, 2, 3, 0, 4}, {0, 1, 2, 3, 3}},
    /* from another vertex, and closed */
    {5, {2, 3, 0, 4, 0, 0, 4, 4, 2, 3}, {2, 3, 0, 1, 1}},
    {5, {4, 4, 2, 3, 0, 4, 0, 0, 4, 4}, {3, 0, 1, 2, 2}},
    /* clockwise, and closed */
    {4, {0, 0, 0, 4, 2, 3, 4, 4}, {3, 3, 1, 1, 0}},
    {5, {4, 4, 0, 0, 0, 4, 2, 3, 4, 4}, {0, 0, 2, 2, 1}},
    /* collinear vertices: edges 7, 0 and 1 are one, so are 3 and 4, and 5 and 6 */
    {8, {1, 1, 2, 2, 4, 4, 2, 3, 1, 3.5, 0, 4, 0, 2, 0, 0}, {7, 2, 3, 5, 5}},
    /* the same, clockwise */
    {8, {0, 0, 0, 2, 0, 4, 1, 3.5, 2, 3, 4, 4, 2, 2, 1, 1}, {7, 5, 3, 2, 1}},
    /* repeated vertices: the last number counts */
    {7, {0, 0, 0, 0, 4, 4, 4, 4, 2, 3, 0, 4, 0, 4}, {1, 3, 4, 6, 6}},
    {7, {0, 4, 0, 4, 2, 3, 4, 4, 4, 4, 0, 0, 0, 0}, {4, 4, 1, 1, 6}},
    /* repeated and collinear, and closed */
    {11, {0, 0, 1, 1, 2, 2, 4, 4, 4, 4, 2, 3, 1, 3.5, 0, 4, 0, 4, 0, 2, 0, 0}, {0, 4, 5, 8, 8}},
    {11, {0, 0, 0, 2, 0, 4, 0, 4, 1, 3.5, 2, 3, 4, 4, 4, 4, 2, 2, 1, 1, 0, 0}, {9, 7, 4, 3, 1}},
};

static const struct numbered wedges[] = {
    {3, {0, 0, 3, 3, 0, 2}, {0, 1, 1, 1, 2}},
    {3, {0, 2, 3, 3, 0, 0}, {1, 0, 1, 0, 2}},
    {4, {3, 3, 0, 2, 0, 0, 3, 3}, {2, 0, 0, 0, 1}},
    {5, {1, 1, 3, 3, 3, 3, 0, 2, 0, 0}, {4, 2, 2, 2, 3}},
};

static gcv_polygon *reflection_of(const struct numbered *numbered) {
  double xy[24];
  size_t k;
  for (k = 0; k < 2 * numbered->count; ++k) xy[k] = -numbered->xy[k];
  return polygon_of(xy, numbered->count);
}

static void numbers(const struct numbered *dart_numbers, const struct numbered *wedge_numbers) {
  const double origin[2] = {0, 0};
  gcv_polygon *dart = polygon_of(dart_numbers->xy, dart_numbers->count);
  gcv_polygon *wedge = polygon_of(wedge_numbers->xy, wedge_numbers->count);
  gcv_polygon *minus_wedge = reflection_of(wedge_numbers);
  gcv_outer_face *faces[4] = {sum_of(dart, wedge), sum_of(wedge, dart), NULL, NULL};
  int k, right = 1;
  CHECK_OK(gcv_no_fit_polygon(dart, minus_wedge, origin, NULL, &faces[2]));
  CHECK_OK(gcv_entrance_block(minus_wedge, dart, origin, NULL, &faces[3]));
  for (k = 0; k < 4; ++k) {
    CHECK(exact_ring_is(faces[k], "0/1 0/1, 7/1 7/1, 23/5 31/5, 3/1 7/1, 0/1 6/1"));
    right = right &&
            CHECK(sources_are(faces[k], dart_numbers->number, wedge_numbers->number, k % 2 == 1));
    gcv_outer_face_destroy(faces[k]);
  }
  if (!right) {
    fprintf(stderr, "  by a dart of %d vertices, the first at (%g, %g), and a wedge of %d\n",
            (int)dart_numbers->count, dart_numbers->xy[0], dart_numbers->xy[1],
            (int)wedge_numbers->count);
  }
  gcv_polygon_destroy(minus_wedge);
  gcv_polygon_destroy(wedge);
  gcv_polygon_destroy(dart);
}

/* In a further sum, numbers are those of gcv_outer_face_vertices. */
static void numbers_of_a_face(void) {
  gcv_polygon *square = POLYGON(5, 5, 6, 5, 6, 6, 5, 6), *tilted = POLYGON(0, 0, 4, 1, 1, 2);
  gcv_outer_face *first = sum_of(square, square), *second;
  gcv_polygon *again = NULL;
  gcv_edge_source sources[7];
  static const gcv_edge_source expected[7] = {{GCV_EDGE_TRANSLATED, 0, 0}, {GCV_EDGE_CORNER, 1, 0},
                                              {GCV_EDGE_TRANSLATED, 1, 1}, {GCV_EDGE_CORNER, 2, 1},
                                              {GCV_EDGE_TRANSLATED, 2, 2}, {GCV_EDGE_CORNER, 3, 2},
                                              {GCV_EDGE_TRANSLATED, 3, 0}};
  size_t required = 0, k;
  CHECK_OK(gcv_outer_face_polygon(first, &again));
  gcv_outer_face_destroy(first);
  second = sum_of(again, tilted);
  CHECK_OK(gcv_outer_face_edge_sources(second, sources, 7, &required));
  CHECK(required == 7);
  for (k = 0; k < required; ++k) CHECK(memcmp(&sources[k], &expected[k], sizeof *sources) == 0);
  gcv_outer_face_destroy(second);
  gcv_polygon_destroy(again);
  gcv_polygon_destroy(tilted);
  gcv_polygon_destroy(square);
}

int main(void) {
  size_t i, j;
  CHECK(GCV_EDGE_TRANSLATED == 1 && GCV_EDGE_CORNER == 2 && GCV_EDGE_TRANSLATED_CORNER == 3);
  for (i = 0; i < sizeof darts / sizeof *darts; ++i) {
    for (j = 0; j < sizeof wedges / sizeof *wedges; ++j) numbers(&darts[i], &wedges[j]);
  }
  numbers_of_a_face();
  return check_failures != 0;
}

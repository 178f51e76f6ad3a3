/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Polygons with holes: how rings may lie, however they are passed, turned and scaled. For
 * messages and numbers see ring_numbers_test.c.
 */
#include "rings.h"

/* In a square of 8, other than where they say so. */
#define SQUARE 0, 0, 8, 0, 8, 8, 0, 8
/* With a notch from above. */
#define NOTCHED 0, 0, 8, 0, 8, 8, 4, 5, 0, 8

struct accepted {
  const char *name;
  double area;
  struct rings rings;
};

static const struct accepted accepted_cases[] = {
    {"no hole", 64, {1, {4}, {SQUARE}}},
    {"a hole", 63, {2, {4, 4}, {SQUARE, 3, 3, 4, 3, 4, 4, 3, 4}}},
    {"many holes", 61.5, {5, {4, 3, 3, 3, 4}, {SQUARE, 1, 1, 2, 1, 1, 2, 1, 6, 2, 6, 1, 7, 6,
                                               1,      7, 1, 7, 2, 5, 5, 6, 5, 6, 6, 5, 6}}},
    {"a corner on an edge", 62, {2, {4, 3}, {SQUARE, 0, 4, 2, 3, 2, 5}}},
    {"a corner on a vertex on the edge",
     62,
     {2, {5, 3}, {0, 0, 8, 0, 8, 8, 0, 8, 0, 4, 0, 4, 2, 3, 2, 5}}},
    {"a corner in a corner", 62.5, {2, {4, 3}, {SQUARE, 0, 0, 2, 1, 1, 2}}},
    {"a corner in every corner",
     24,
     {2, {4, 8}, {SQUARE, 0, 0, 4, 1, 8, 0, 7, 4, 8, 8, 5, 5, 0, 8, 1, 4}}},
    {"an edge at a reflex corner", 40, {2, {5, 4}, {NOTCHED, 2, 2, 6, 2, 6, 5, 2, 5}}},
    {"a corner at a reflex corner", 48, {2, {5, 3}, {NOTCHED, 4, 5, 2, 3, 6, 3}}},
    {"a vertex on an edge at a reflex corner",
     40,
     {2, {5, 5}, {NOTCHED, 2, 2, 6, 2, 6, 5, 4, 5, 2, 5}}},
    {"a reflex corner of the hole at a reflex corner",
     46,
     {2, {5, 4}, {NOTCHED, 2, 5, 4, 2, 6, 5.25, 4, 5}}},
    {"from wall to wall", 56, {2, {4, 4}, {SQUARE, 0, 4, 4, 3, 8, 4, 4, 5}}},
    {"two corners on one edge", 60, {2, {4, 4}, {SQUARE, 2, 0, 4, 2, 6, 0, 4, 4}}},
    {"a diamond that leaves four parts", 32, {2, {4, 4}, {SQUARE, 4, 0, 8, 4, 4, 8, 0, 4}}},
    {"corner to corner", 56, {3, {4, 3, 3}, {SQUARE, 2, 2, 6, 2, 4, 4, 2, 6, 4, 4, 6, 6}}},
    {"corner to edge", 50, {3, {4, 4, 3}, {SQUARE, 1, 1, 7, 1, 7, 2, 1, 2, 4, 2, 6, 6, 2, 6}}},
    {"a corner in a reflex corner",
     56.5,
     {3, {4, 4, 3}, {SQUARE, 1, 4, 4, 2, 7, 4, 4, 3, 3, 6, 4, 3, 6, 6}}},
    {"three in a point",
     56.5,
     {4, {4, 3, 3, 3}, {SQUARE, 4, 4, 6, 3, 6, 5, 4, 4, 3, 7, 5, 7, 4, 4, 2, 5, 2, 2.5}}},
    {"two round an island",
     52,
     {3, {4, 4, 4}, {SQUARE, 1, 4, 4, 1, 7, 4, 4, 3, 1, 4, 4, 7, 7, 4, 4, 5}}},
    {"a hole in an island", 57.5, {4, {4, 4, 4, 3}, {SQUARE, 1, 4, 4, 1, 7, 4, 4, 2, 1, 4, 4,
                                                     7,      7, 4, 4, 6, 4, 3, 5, 4, 4, 4}}},
    {"a hole that touches an island's shore",
     56.5,
     {4, {4, 4, 4, 4}, {SQUARE, 1, 4, 4, 1, 7, 4,   4, 2, 1, 4,   4, 7,
                        7,      4, 4, 6, 4, 2, 4.5, 4, 4, 5, 3.5, 4}}},
    {"a chain from wall to wall", 57.5, {4, {4, 4, 4, 4}, {SQUARE, 0, 4, 1.5, 3,  3, 4, 1.5, 5, 3,
                                                           4,      4, 3, 5,   4,  4, 5, 5,   4, 6.5,
                                                           3.5,    8, 4, 6.5, 4.5}}},
    {"a hole right above and below another", 61, {4, {4, 4, 4, 4}, {SQUARE, 3, 1, 4, 1, 4, 2, 3, 2,
                                                                    3,      3, 4, 3, 4, 4, 3, 4, 3,
                                                                    5,      4, 5, 4, 6, 3, 6}}},
    {"a hole in the arm of another",
     49.5,
     {3, {4, 6, 3}, {SQUARE, 1, 1, 7, 1, 7, 2, 3, 2, 3, 6, 1, 6, 5, 4, 6, 4, 6, 5}}},
};

struct refused {
  const char *name;
  const char *part; /* of the message, for the rings as they are */
  struct rings rings;
};

static const struct refused refused_cases[] = {
    {"crosses the wall",
     "rings 0 and 1 cross: edges 1 and ",
     {2, {4, 3}, {SQUARE, 6, 3, 10, 4, 6, 5}}},
    {"crosses a hole",
     "rings 1 and 2 cross: edges ",
     {3, {4, 4, 4}, {SQUARE, 1, 1, 5, 1, 5, 4, 1, 4, 2, 2, 7, 2, 7, 3, 2, 3}}},
    {"holes like a cross",
     "rings 1 and 2 cross: edges ",
     {3, {4, 4, 4}, {SQUARE, 1, 3, 7, 3, 7, 5, 1, 5, 3, 1, 5, 1, 5, 7, 3, 7}}},
    {"outside",
     "ring 1, a hole, lies outside ring 0: edge ",
     {2, {4, 3}, {SQUARE, 9, 3, 11, 4, 9, 5}}},
    {"outside, below",
     "ring 1, a hole, lies outside ring 0",
     {2, {4, 3}, {SQUARE, 3, -3, 5, -3, 4, -1}}},
    {"outside, above",
     "ring 1, a hole, lies outside ring 0",
     {2, {4, 3}, {SQUARE, 3, 9, 5, 9, 4, 11}}},
    {"outside, in a notch",
     "ring 1, a hole, lies outside ring 0",
     {2, {5, 3}, {NOTCHED, 3, 7, 5, 7, 4, 6}}},
    {"round the outer ring", "outside", {2, {4, 4}, {SQUARE, -1, -1, 9, -1, 9, 9, -1, 9}}},
    {"in a hole", "inside", {3, {4, 4, 3}, {SQUARE, 1, 1, 7, 1, 7, 7, 1, 7, 3, 3, 5, 3, 4, 5}}},
    {"round a hole", "inside", {3, {4, 3, 4}, {SQUARE, 3, 3, 5, 3, 4, 5, 1, 1, 7, 1, 7, 7, 1, 7}}},
    {"two in a hole, one on the other",
     "inside",
     {4, {4, 4, 3, 3}, {SQUARE, 1, 1, 7, 1, 7, 7, 1, 7, 3, 3, 5, 3, 4, 4, 3, 5, 4, 4, 5, 5}}},
    {"in a hole that touches the wall",
     "inside",
     {3, {4, 4, 3}, {SQUARE, 0, 4, 4, 1, 8, 4, 4, 7, 3, 4, 5, 3, 5, 5}}},
    {"two that begin in one point, in a hole",
     "inside",
     {4, {4, 4, 3, 3}, {SQUARE, 1, 1, 7, 1, 7, 7, 1, 7, 3, 4, 5, 2, 5, 3, 3, 4, 5, 5, 5, 6}}},
    {"two that begin in one point, outside",
     "outside ring 0",
     {3, {4, 3, 3}, {SQUARE, 9, 4, 11, 2, 11, 3, 9, 4, 11, 5, 11, 6}}},
    {"as the outer ring", "rings 0 and 1", {2, {4, 4}, {SQUARE, SQUARE}}},
    {"the same hole twice",
     "rings 1 and 2",
     {3, {4, 3, 3}, {SQUARE, 3, 3, 5, 3, 4, 5, 3, 3, 5, 3, 4, 5}}},
    {"an edge on the wall",
     "rings 0 and 1 cross, overlap, or touch",
     {2, {4, 4}, {SQUARE, 6, 3, 8, 3, 8, 5, 6, 5}}},
    {"an edge on part of the wall from its end",
     "rings 0 and 1",
     {2, {4, 3}, {SQUARE, 4, 0, 8, 0, 6, 2}}},
    {"an edge on all of the wall", "rings 0 and 1", {2, {4, 3}, {SQUARE, 0, 0, 8, 0, 4, 4}}},
    {"an edge on the wall from outside",
     "rings 0 and 1",
     {2, {4, 4}, {SQUARE, 8, 3, 9, 3, 9, 5, 8, 5}}},
    {"an edge on a hole",
     "rings 1 and 2",
     {3, {4, 4, 4}, {SQUARE, 2, 2, 4, 2, 4, 4, 2, 4, 4, 3, 6, 3, 6, 5, 4, 5}}},
    {"an edge on a hole from inside",
     "rings 1 and 2",
     {3, {4, 4, 4}, {SQUARE, 2, 2, 6, 2, 6, 6, 2, 6, 4, 3, 6, 3, 6, 5, 4, 5}}},
    {"an edge on the same edge of a hole",
     "rings 1 and 2",
     {3, {4, 3, 3}, {SQUARE, 2, 4, 6, 4, 4, 6, 2, 4, 6, 4, 4, 2}}},
    {"edges that overlap in collinear pieces",
     "rings 0 and 1",
     {2, {5, 5}, {0, 0, 4, 0, 8, 0, 8, 8, 0, 8, 2, 0, 3, 0, 5, 0, 6, 0, 4, 3}}},
    {"crosses the wall by a corner",
     "rings 0 and 1",
     {2, {4, 4}, {SQUARE, 8, 4, 10, 5, 7, 7, 6, 5}}},
    {"crosses the wall by two corners on it",
     "rings 0 and 1",
     {2, {4, 4}, {SQUARE, 8, 3, 10, 4, 8, 5, 6, 4}}},
    {"crosses a corner of the wall by a corner",
     "rings 0 and 1",
     {2, {4, 4}, {SQUARE, 8, 8, 9, 6, 7, 4, 5, 7}}},
    {"crosses a corner of the wall by an edge",
     "rings 0 and 1",
     {2, {5, 3}, {NOTCHED, 3, 7, 5, 3, 3, 3}}},
    {"cuts a corner off by its corners",
     "rings 0 and 1",
     {2, {4, 4}, {SQUARE, 8, 4, 4, 8, 9, 9, 9, 8}}},
    {"crosses a hole by a corner",
     "rings 1 and 2",
     {3, {4, 4, 4}, {SQUARE, 2, 2, 4, 2, 4, 4, 2, 4, 4, 3, 6, 3, 3, 6, 3, 3.5}}},
    {"crosses a hole by corners only",
     "rings 1 and 2",
     {3, {4, 4, 4}, {SQUARE, 2, 4, 4, 2, 6, 4, 4, 6, 4, 4, 6, 4, 7, 6, 4, 6}}},
    {"touches a corner from outside", "rings 0 and 1", {2, {4, 3}, {SQUARE, 8, 8, 10, 9, 9, 10}}},
    {"touches the wall from outside", "rings 0 and 1", {2, {4, 3}, {SQUARE, 8, 4, 10, 3, 10, 5}}},
    {"touches a reflex corner from outside",
     "rings 0 and 1",
     {2, {5, 3}, {NOTCHED, 4, 5, 5, 7, 3, 7}}},
    {"round the outer ring, touches its corner",
     "rings 0 and 1",
     {2, {4, 4}, {SQUARE, 8, 8, -1, 9, -1, -1, 9, -1}}},
    {"round the outer ring, its edge at a corner",
     "rings 0 and 1",
     {2, {4, 3}, {SQUARE, 20, -4, -4, 20, -4, -4}}},
    {"touches a hole from inside",
     "rings 1 and 2",
     {3, {4, 4, 3}, {SQUARE, 2, 2, 6, 2, 6, 6, 2, 6, 2, 4, 4, 3, 4, 5}}},
    {"touches a hole's corner from inside",
     "rings 1 and 2",
     {3, {4, 4, 3}, {SQUARE, 2, 2, 6, 2, 6, 6, 2, 6, 2, 2, 4, 3, 3, 4}}},
    {"a diamond in a hole",
     "rings 1 and 2",
     {3, {4, 4, 4}, {SQUARE, 2, 2, 6, 2, 6, 6, 2, 6, 4, 2, 6, 4, 4, 6, 2, 4}}},
    {"on a hole and outside",
     "rings 0 and 2",
     {3, {4, 3, 3}, {SQUARE, 8, 4, 6, 3, 6, 5, 8, 4, 10, 3, 10, 5}}},
    {"a hole that lies well and one that does not",
     "ring 2, a hole, lies outside ring 0: edge 7",
     {3, {4, 3, 3}, {SQUARE, 3, 3, 5, 3, 4, 5, 9, 3, 9, 5, 11, 4}}},
};

/* In all the ways: expected are the rings, or none. */
static int stays(const struct rings *rings, const gcv_polygon *expected) {
  const size_t ways = (size_t)1 << rings->count;
  size_t shift, way, k;
  for (shift = 0; shift < 3; ++shift) {
    for (way = 0; way < 2 * ways; ++way) {
      const struct rings other =
          passed_otherwise(rings, shift, (unsigned)(way / 2), (int)(way % 2));
      gcv_polygon *polygon = NULL;
      int same = create_rings(&other, &polygon) == (expected ? GCV_OK : GCV_ERR_NOT_SIMPLE);
      for (k = 0; same && expected && k < rings->count; ++k) {
        double xy[2 * MOST_VERTICES];
        size_t count = 0;
        CHECK_OK(gcv_polygon_ring(expected, k, xy, MOST_VERTICES, &count));
        same = ring_is(polygon, k, xy, count);
      }
      gcv_polygon_destroy(polygon);
      if (!CHECK(same)) return 0;
    }
  }
  return 1;
}

/* Simplified, no hole is lost, and the rings lie as they may; outward, nothing is taken away. */
static int simplifies(const gcv_polygon *polygon, double area) {
  static const double tolerances[] = {0, 0.125, 0.5, 1, 3};
  size_t k, ring, count = 0;
  int32_t rounding;
  CHECK_OK(gcv_polygon_ring_count(polygon, &count));
  for (k = 0; k < sizeof tolerances / sizeof *tolerances; ++k) {
    for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
      gcv_polygon *simple = NULL, *again = NULL;
      struct rings rings = {0, {0}, {0}};
      double *to = rings.xy, of_simple = -1, bound = -1;
      CHECK_OK(gcv_polygon_simplified(polygon, tolerances[k], rounding, &simple, &bound));
      CHECK(bound >= 0 && bound <= tolerances[k]);
      CHECK_OK(gcv_polygon_ring_count(simple, &rings.count));
      if (!CHECK(rings.count == count)) return 0;
      for (ring = 0; ring < count; ++ring) {
        CHECK_OK(gcv_polygon_ring(simple, ring, to, MOST_VERTICES / 2, &rings.sizes[ring]));
        to += 2 * rings.sizes[ring];
      }
      if (!CHECK_OK(create_rings(&rings, &again))) return 0;
      CHECK_OK(gcv_polygon_area(simple, &of_simple));
      gcv_polygon_destroy(again);
      gcv_polygon_destroy(simple);
      if (!CHECK(rounding == GCV_ROUND_NEAREST || of_simple >= area)) return 0;
    }
  }
  return 1;
}

static const int exponents[] = {0, -1060, -30, 1000};

static void accept(const struct accepted *accepted) {
  int symmetry;
  size_t e, count = 0;
  for (symmetry = 0; symmetry < 8; ++symmetry) {
    for (e = 0; e < sizeof exponents / sizeof *exponents; ++e) {
      const struct rings rings = seen_otherwise(&accepted->rings, symmetry, exponents[e]);
      gcv_polygon *polygon = polygon_of_rings(&rings);
      double area = -1;
      int right = polygon != NULL && stays(&rings, polygon);
      CHECK_OK(gcv_polygon_ring_count(polygon, &count));
      CHECK(count == rings.count);
      if (exponents[e] == 0) {
        CHECK_OK(gcv_polygon_area(polygon, &area));
        right = CHECK(area == accepted->area) && right;
        right = simplifies(polygon, area) && right;
      }
      if (!right) {
        fprintf(stderr, "  %s, %d, 2^%d, area %g\n", accepted->name, symmetry, exponents[e], area);
      }
      gcv_polygon_destroy(polygon);
    }
  }
}

static void refuse(const struct refused *refused) {
  gcv_polygon *polygon = NULL;
  int symmetry, right = CHECK_REFUSED(GCV_ERR_NOT_SIMPLE, refused->part,
                                      create_rings(&refused->rings, &polygon));
  size_t e;
  for (symmetry = 0; right && symmetry < 8; ++symmetry) {
    for (e = 0; e < sizeof exponents / sizeof *exponents; ++e) {
      const struct rings rings = seen_otherwise(&refused->rings, symmetry, exponents[e]);
      right = right && stays(&rings, NULL);
    }
  }
  CHECK(polygon == NULL);
  if (!right) fprintf(stderr, "  %s\n", refused->name);
}

int main(void) {
  size_t k;
  for (k = 0; k < sizeof accepted_cases / sizeof *accepted_cases; ++k) accept(&accepted_cases[k]);
  for (k = 0; k < sizeof refused_cases / sizeof *refused_cases; ++k) refuse(&refused_cases[k]);
  return check_failures != 0;
}

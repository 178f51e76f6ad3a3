/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Regions of sums, no-fit regions and entrance regions, worked out by hand.
 */
#include "record.h"
#include "regions.h"

static int parts_are(const gcv_region *region, const gcv_region_part *expected, size_t count) {
  gcv_region_part parts[MOST_PARTS], exact[MOST_PARTS];
  size_t required = 0, exact_required = 0;
  CHECK_OK(gcv_region_parts(region, parts, MOST_PARTS, &required));
  CHECK_OK(gcv_region_exact_parts(region, exact, MOST_PARTS, &exact_required));
  return required == count && exact_required == count &&
         memcmp(parts, expected, count * sizeof *parts) == 0 &&
         memcmp(exact, expected, count * sizeof *exact) == 0;
}

static int vertices_are(const gcv_region *region, const double *expected, size_t count) {
  double xy[2 * MOST_VERTICES] = {0};
  size_t required = 0;
  CHECK_OK(gcv_region_vertices(region, xy, MOST_VERTICES, &required));
  return same_ring(xy, required, expected, count);
}

static double area_of(const gcv_region *region) {
  double area = -1;
  CHECK_OK(gcv_region_area(region, &area));
  return area;
}

static double error_bound_of(const gcv_region *region) {
  double bound = -1;
  CHECK_OK(gcv_region_error_bound(region, &bound));
  return bound;
}

static void all_readers(void) {
  static const gcv_region_part parts[] = {{GCV_PART_OUTER, 0, 4}, {GCV_PART_HOLE, 0, 4}};
  static const uint32_t edges_of_a[] = {0, 1, 2, 3, 7, 6, 5, 4};
  gcv_polygon *a = polygon_of_rings(&frame), *b = SQUARE(1), *polygon = NULL;
  gcv_region *region = region_of_sum(a, b);
  gcv_edge_source found[8];
  uint64_t indices[8], owners[8];
  size_t required = 0, k;
  gcv_polygon_destroy(a); /* regions do not depend on what they are made of */
  gcv_polygon_destroy(b);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 5/1 0/1, 5/1 5/1, 0/1 5/1; "
                        "hole 2/1 2/1, 2/1 3/1, 3/1 3/1, 3/1 2/1"));
  CHECK(parts_are(region, parts, 2));
  CHECK(vertices_are(region, RING(0, 0, 5, 0, 5, 5, 0, 5, 2, 2, 2, 3, 3, 3, 3, 2)));
  CHECK(region_is(region, "MULTIPOLYGON (((0 0, 5 0, 5 5, 0 5, 0 0), (2 2, 2 3, 3 3, 3 2, 2 2)))",
                  "GEOMETRYCOLLECTION EMPTY"));
  CHECK(area_of(region) == 24 && error_bound_of(region) == 0);
  CHECK_OK(gcv_region_exact_indices(region, indices, 8, &required));
  CHECK(required == 8);
  for (k = 0; k < 8; ++k) CHECK(indices[k] == k);
  memset(owners, 0xff, sizeof owners);
  CHECK_OK(gcv_region_edge_owners(region, owners, 8, &required));
  CHECK(required == 8);
  for (k = 0; k < 8; ++k) CHECK(owners[k] == 0);
  CHECK_OK(gcv_region_edge_sources(region, found, 8, &required));
  CHECK(required == 8);
  for (k = 0; k < 8; ++k) {
    CHECK(found[k].a == edges_of_a[k]);
    CHECK(found[k].kind == GCV_EDGE_TRANSLATED_CORNER ||
          (k > 3 && found[k].kind == GCV_EDGE_TRANSLATED));
    CHECK(k > 3 || found[k].b == k);
  }

  CHECK_OK(gcv_region_polygon(region, 0, &polygon));
  CHECK(ring_is(polygon, 0, RING(0, 0, 5, 0, 5, 5, 0, 5)));
  CHECK(ring_is(polygon, 1, RING(2, 2, 2, 3, 3, 3, 3, 2)));
  gcv_polygon_destroy(polygon);
  polygon = NULL;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "polygon is 1, the region has 1 polygons",
                gcv_region_polygon(region, 1, &polygon));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "polygon",
                gcv_region_polygon(region, SIZE_MAX, &polygon));
  CHECK(polygon == NULL);
  gcv_region_destroy(region);
}

/* The region of B + A is that of A + B. */
static void swapped(void) {
  gcv_polygon *a = polygon_of_rings(&plate), *b = polygon_of_rings(&frame), *c = SQUARE(1);
  gcv_region *ab = region_of_sum(a, b), *ba = region_of_sum(b, a), *ca = region_of_sum(c, a);
  /* A hole of 2 x 2 is too small for a frame. */
  CHECK(exact_region_is(ab, "outer 0/1 0/1, 10/1 0/1, 10/1 10/1, 0/1 10/1"));
  CHECK(exact_region_is(ba, "outer 0/1 0/1, 10/1 0/1, 10/1 10/1, 0/1 10/1"));
  CHECK(exact_region_is(ca,
                        "outer 0/1 0/1, 7/1 0/1, 7/1 7/1, 0/1 7/1; "
                        "hole 3/1 3/1, 3/1 4/1, 4/1 4/1, 4/1 3/1"));
  gcv_region_destroy(ab);
  gcv_region_destroy(ba);
  gcv_region_destroy(ca);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(c);
}

/* A peg as wide as the slot goes in along a segment, which ends on the ring. A peg as large as the
 * hole fits there in one point. Neither has an edge behind it at its end. */
static void exact_fits(void) {
  static const gcv_region_part slot_parts[] = {{GCV_PART_OUTER, 0, 4},
                                               {GCV_PART_SEGMENT, UINT32_MAX, 2}};
  static const gcv_region_part hole_parts[] = {{GCV_PART_OUTER, 0, 4},
                                               {GCV_PART_POINT, UINT32_MAX, 1}};
  static const gcv_edge_source none = {0, 0, 0};
  gcv_polygon *slotted = POLYGON(SLOTTED), *holed = polygon_of_rings(&plate), *peg = SQUARE(2);
  gcv_region *slot = no_fit_region(slotted, peg, 0, GCV_ROUND_NEAREST);
  gcv_region *hole = no_fit_region(holed, peg, 0, GCV_ROUND_NEAREST);
  gcv_edge_source sources[6];
  uint64_t owners[6];
  size_t required = 0;
  CHECK(exact_region_is(slot,
                        "outer -2/1 -2/1, 6/1 -2/1, 6/1 6/1, -2/1 6/1; segment 2/1 2/1, 2/1 6/1"));
  CHECK(parts_are(slot, slot_parts, 2));
  CHECK(region_is(slot, "MULTIPOLYGON (((-2 -2, 6 -2, 6 6, -2 6, -2 -2)))",
                  "GEOMETRYCOLLECTION (LINESTRING (2 2, 2 6))"));
  CHECK(vertices_are(slot, RING(-2, -2, 6, -2, 6, 6, -2, 6, 2, 2, 2, 6)));
  CHECK_OK(gcv_region_edge_sources(slot, sources, 6, &required));
  CHECK(required == 6 && sources[4].kind != 0 && memcmp(&sources[5], &none, sizeof none) == 0);
  CHECK_OK(gcv_region_edge_owners(slot, owners, 6, &required));
  CHECK(required == 6 && owners[5] == 0);
  CHECK(area_of(slot) == 64);

  CHECK(exact_region_is(hole, "outer -2/1 -2/1, 6/1 -2/1, 6/1 6/1, -2/1 6/1; point 2/1 2/1"));
  CHECK(parts_are(hole, hole_parts, 2));
  CHECK(region_is(hole, "MULTIPOLYGON (((-2 -2, 6 -2, 6 6, -2 6, -2 -2)))",
                  "GEOMETRYCOLLECTION (POINT (2 2))"));
  CHECK_OK(gcv_region_edge_sources(hole, sources, 6, &required));
  CHECK(required == 5 && memcmp(&sources[4], &none, sizeof none) == 0);
  gcv_region_destroy(slot);
  gcv_region_destroy(hole);
  gcv_polygon_destroy(slotted);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(peg);
}

/* Five holes, passed in no order: free space, a segment that lies, two points, and one that the
 * square does not fit in. */
static void order(void) {
  static const struct rings sieve = {
      6, {4, 4, 4, 4, 4, 4}, {0, 0, 20, 0, 20, 9,  0,  9,  13, 5,  15, 5,  15, 7, 13, 7, 1,  5, 5,
                              5, 5, 8,  1, 8,  13, 1,  15, 1,  15, 3,  13, 3,  1, 1,  4, 1,  4, 4,
                              1, 4, 7,  2, 11, 2,  11, 4,  7,  4,  17, 1,  18, 1, 18, 8, 17, 8}};
  static const gcv_region_part parts[] = {
      {GCV_PART_OUTER, 0, 4},          {GCV_PART_HOLE, 0, 4},
      {GCV_PART_HOLE, 0, 4},           {GCV_PART_SEGMENT, UINT32_MAX, 2},
      {GCV_PART_POINT, UINT32_MAX, 1}, {GCV_PART_POINT, UINT32_MAX, 1}};
  gcv_polygon *a = polygon_of_rings(&sieve), *b = SQUARE(2);
  gcv_region *region = no_fit_region(a, b, 0, GCV_ROUND_NEAREST);
  CHECK(parts_are(region, parts, 6));
  CHECK(region_is(region,
                  "MULTIPOLYGON (((-2 -2, 20 -2, 20 9, -2 9, -2 -2), (1 1, 1 2, 2 2, 2 1, 1 1), "
                  "(1 5, 1 6, 3 6, 3 5, 1 5)))",
                  "GEOMETRYCOLLECTION (LINESTRING (7 2, 9 2), POINT (13 1), POINT (13 5))"));
  gcv_region_destroy(region);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

/* Before a tip, the diamond can go up and down: two holes touch there, in the smallest vertex of
 * both. The next vertices tell which comes first. */
static void order_of_touching_holes(void) {
  static const struct rings mouth = {
      2, {4, 6}, {-2, -9, 6, -9, 6, 11, -2, 11, 0, 1, 4, -7, 4, 0.5, 2, 1, 4, 1.5, 4, 9}};
  gcv_polygon *a = polygon_of_rings(&mouth), *diamond = POLYGON(1, 0, 2, 1, 1, 2, 0, 1);
  gcv_region *region = no_fit_region(a, diamond, 0, GCV_ROUND_NEAREST);
  CHECK(exact_region_is(region,
                        "outer -4/1 -10/1, -3/1 -11/1, 5/1 -11/1, 6/1 -10/1, 6/1 10/1, 5/1 11/1, "
                        "-3/1 11/1, -4/1 10/1; "
                        "hole 0/1 0/1, 1/1 -1/1, 2/1 -5/4, 2/1 -4/1; "
                        "hole 0/1 0/1, 2/1 4/1, 2/1 5/4, 1/1 1/1"));
  gcv_region_destroy(region);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(diamond);
}

static void left_out(void) {
  static const struct rings both = {
      3, {4, 4, 4}, {0, 0, 9, 0, 9, 5, 0, 5, 1, 1, 4, 1, 4, 4, 1, 4, 5, 1, 7, 1, 7, 3, 5, 3}};
  static const char outer[] = "outer -2/1 -2/1, 9/1 -2/1, 9/1 5/1, -2/1 5/1";
  gcv_polygon *a = polygon_of_rings(&both), *b = SQUARE(2);
  uint64_t leave_out;
  for (leave_out = 0; leave_out < 4; ++leave_out) {
    char expected[MOST_TEXT];
    gcv_region *region = no_fit_region(a, b, leave_out, GCV_ROUND_NEAREST);
    sprintf(
        expected, "%s%s%s", outer,
        (leave_out & GCV_LEAVE_OUT_HOLES) != 0 ? "" : "; hole 1/1 1/1, 1/1 2/1, 2/1 2/1, 2/1 1/1",
        (leave_out & GCV_LEAVE_OUT_FITS) != 0 ? "" : "; point 5/1 1/1");
    CHECK(exact_region_is(region, expected));
    gcv_region_destroy(region);
  }
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

/* Two holes at one even number beyond 2^53, which their vertices are rounded to. */
static void holes_at_one_double(void) {
  static const struct rings holes = {
      3, {4, 4, 4}, {0,     0,   12,    0,   12,  4, 0,     4, 8.125, 1,   9.375, 1,
                     9.375, 2.5, 8.125, 2.5, 9.5, 1, 10.75, 1, 10.75, 2.5, 9.5,   2.5}};
  const double x = 0x1p53 - 8;
  gcv_region_part parts[MOST_PARTS];
  size_t count = 0;
  gcv_polygon *a = POLYGON(x, 0, x + 1, 0, x + 1, 1, x, 1), *b = polygon_of_rings(&holes);
  gcv_region *region = region_of_sum(a, b);
  CHECK_OK(gcv_region_exact_parts(region, parts, MOST_PARTS, &count));
  CHECK(count == 3);
  gcv_region_destroy(region);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

/* The walk along the outer face counts as it does alone, and what is found inside counts too. */
static void counts(void) {
  gcv_stats of_face = {sizeof of_face, 0, 0, 0, 0, 0, 0, 0}, of_outer = of_face, of_all = of_face;
  gcv_polygon *a = polygon_of_rings(&frame), *b = SQUARE(1);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_outer_face *face = NULL;
  gcv_region *outer = NULL, *all = region_of_sum(a, b);
  options.leave_out = GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS;
  CHECK_OK(gcv_minkowski_sum(a, b, NULL, &face));
  CHECK_OK(gcv_minkowski_sum_region(a, b, &options, &outer));
  CHECK_OK(gcv_outer_face_stats(face, &of_face));
  CHECK_OK(gcv_region_stats(outer, &of_outer));
  CHECK_OK(gcv_region_stats(all, &of_all));
  CHECK(of_outer.walk_steps == of_face.walk_steps);
  CHECK(of_outer.candidate_edges == of_face.candidate_edges);
  CHECK(of_all.walk_steps >= of_outer.walk_steps + 4 && of_all.walk_steps < 1000);
  CHECK(of_all.candidate_edges > of_outer.candidate_edges && of_all.candidate_edges < 1000);
  CHECK(of_all.predicates_filtered > of_outer.predicates_filtered);
  CHECK(of_all.predicates_filtered < 10000 && of_all.predicates_rational == 0);
  gcv_outer_face_destroy(face);
  gcv_region_destroy(outer);
  gcv_region_destroy(all);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

/* B + (-A) + a0 is the no-fit region of B and A. The reference point is added exactly. */
static void references(void) {
  const double point[2] = {10, -1};
  gcv_polygon *a = SQUARE(1), *b = polygon_of_rings(&frame);
  gcv_region *no_fit = NULL, *entrance = NULL;
  CHECK_OK(gcv_no_fit_region(b, a, point, NULL, &no_fit));
  CHECK_OK(gcv_entrance_region(a, b, point, NULL, &entrance));
  CHECK(exact_region_is(no_fit,
                        "outer 9/1 -2/1, 14/1 -2/1, 14/1 3/1, 9/1 3/1; "
                        "hole 11/1 0/1, 11/1 1/1, 12/1 1/1, 12/1 0/1"));
  CHECK(exact_region_is(entrance,
                        "outer 9/1 -2/1, 14/1 -2/1, 14/1 3/1, 9/1 3/1; "
                        "hole 11/1 0/1, 11/1 1/1, 12/1 1/1, 12/1 0/1"));
  gcv_region_destroy(no_fit);
  gcv_region_destroy(entrance);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

static void bad_references(void) {
  static const double bad[][2] = {{NAN, 0}, {0, NAN}, {INFINITY, 0}, {0, -INFINITY}};
  gcv_polygon *square = SQUARE(1);
  gcv_region *region = NULL;
  size_t k;
  for (k = 0; k < sizeof bad / sizeof *bad; ++k) {
    CHECK_REFUSED(GCV_ERR_NOT_FINITE, "reference",
                  gcv_no_fit_region(square, square, bad[k], NULL, &region));
    CHECK_REFUSED(GCV_ERR_NOT_FINITE, "a0",
                  gcv_entrance_region(square, square, bad[k], NULL, &region));
    CHECK_REFUSED(GCV_ERR_NOT_FINITE, "reference",
                  gcv_inner_fit_region(square, square, bad[k], NULL, &region));
  }
  CHECK(region == NULL);
  gcv_polygon_destroy(square);
}

/* Outwards, a hole shrinks and a fit goes unless doubles show it. */
static void roundings(void) {
  const double tenth[2] = {0.1, 0};
  gcv_polygon *holed = polygon_of_rings(&plate), *peg = SQUARE(2), *small = SQUARE(1);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *region = NULL;
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 77};
  CHECK_OK(gcv_no_fit_region(holed, peg, tenth, &options, &region));
  CHECK(region_is(region, "MULTIPOLYGON (((-1.9 -2, 6.1 -2, 6.1 6, -1.9 6, -1.9 -2)))",
                  "GEOMETRYCOLLECTION (POINT (2.1 2))"));
  CHECK_OK(gcv_region_stats(region, &stats));
  CHECK(stats.parts_dropped == 0 && stats.vertices_repaired == 0);
  CHECK(error_bound_of(region) > 0 && error_bound_of(region) < 1e-15);
  gcv_region_destroy(region);
  options.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_no_fit_region(holed, peg, tenth, &options, &region));
  CHECK_OK(gcv_region_stats(region, &stats));
  CHECK(stats.parts_dropped == 1);
  CHECK(error_bound_of(region) > 0);
  {
    gcv_region_part parts[MOST_PARTS];
    size_t required = 0;
    CHECK_OK(gcv_region_parts(region, parts, MOST_PARTS, &required));
    CHECK(required == 1);
    CHECK_OK(gcv_region_exact_parts(region, parts, MOST_PARTS, &required));
    CHECK(required == 2);
  }
  gcv_region_destroy(region);
  CHECK_OK(gcv_no_fit_region(holed, small, tenth, &options, &region));
  CHECK(area_of(region) > 49 - 1 && area_of(region) < 48.0001);
  gcv_region_destroy(region);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(peg);
  gcv_polygon_destroy(small);
}

/* Far away, the two ends of a short edge fall together, and so do those of a short segment. */
static void vertices_that_fall_together(void) {
  static const struct rings short_parts = {
      2,
      {5, 4},
      {0, 0, 4096, 0, 4096, 4095, 4095, 4096, 0, 4096, 512, 512, 769, 512, 769, 768, 512, 768}};
  static const uint64_t expected[] = {0, 1, 2, 4, 5};
  const double far[2] = {0x1p60, 0x1p60};
  gcv_polygon *fixed = polygon_of_rings(&short_parts), *moving = SQUARE(256);
  gcv_region *region = NULL;
  gcv_region_part parts[MOST_PARTS];
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 77};
  uint64_t indices[8];
  size_t required = 0;
  CHECK_OK(gcv_no_fit_region(fixed, moving, far, NULL, &region));
  CHECK_OK(gcv_region_exact_parts(region, parts, MOST_PARTS, &required));
  CHECK(required == 2 && parts[0].vertex_count == 5 && parts[1].kind == GCV_PART_SEGMENT);
  CHECK_OK(gcv_region_parts(region, parts, MOST_PARTS, &required));
  CHECK(required == 2 && parts[0].vertex_count == 4 && parts[1].kind == GCV_PART_POINT);
  CHECK_OK(gcv_region_exact_indices(region, indices, 8, &required));
  CHECK(required == 5 && memcmp(indices, expected, sizeof expected) == 0);
  CHECK_OK(gcv_region_stats(region, &stats));
  CHECK(stats.vertices_repaired == 0 && stats.parts_dropped == 0);
  gcv_region_destroy(region);
  gcv_polygon_destroy(fixed);
  gcv_polygon_destroy(moving);
}

/* The returned polygon goes on as an operand. */
static void regions_go_on(void) {
  gcv_polygon *a = polygon_of_rings(&frame), *b = SQUARE(0.5), *polygon = NULL;
  gcv_region *first = region_of_sum(a, b), *second;
  CHECK_OK(gcv_region_polygon(first, 0, &polygon));
  second = region_of_sum(polygon, b);
  CHECK(exact_region_is(second,
                        "outer 0/1 0/1, 5/1 0/1, 5/1 5/1, 0/1 5/1; "
                        "hole 2/1 2/1, 2/1 3/1, 3/1 3/1, 3/1 2/1"));
  gcv_region_destroy(first);
  gcv_region_destroy(second);
  gcv_polygon_destroy(polygon);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

static void out_of_range(void) {
  gcv_polygon *right = POLYGON(1.7e308, 0, 1.7e308, 1, 1.6e308, 0);
  gcv_polygon *wide = POLYGON(0, 0, 1e200, 0, 1e200, 1e200, 0, 1e200);
  gcv_region *region = NULL;
  double area = -1;
  CHECK_STATUS(GCV_ERR_RANGE, gcv_minkowski_sum_region(right, right, NULL, &region));
  CHECK(region == NULL);
  region = region_of_sum(wide, wide);
  CHECK_STATUS(GCV_ERR_RANGE, gcv_region_area(region, &area));
  CHECK(area == -1);
  gcv_region_destroy(region);
  gcv_polygon_destroy(wide);
  gcv_polygon_destroy(right);
}

/* The outer ring of a region is the ring of the outer face, vertex for vertex. */
static void outer_rings(void) {
  int pair;
  int32_t rounding;
  for (pair = 0; pair < 2 * PAIRS; ++pair) {
    for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
      gcv_options options = GCV_OPTIONS_INIT;
      gcv_polygon *a = NULL, *b = NULL;
      gcv_outer_face *face = NULL;
      gcv_region *region = NULL;
      double ring[2 * MOST_VERTICES], xy[2 * MOST_VERTICES];
      char text[MOST_TEXT], exact[MOST_TEXT];
      size_t count = 0, required = 0, k;
      options.rounding = rounding;
      CHECK_OK(pair_polygon(pair % PAIRS, 0, &a));
      CHECK_OK(pair_polygon(pair < PAIRS ? pair : 1, 1, &b));
      if (gcv_minkowski_sum(a, b, &options, &face) == GCV_OK) {
        CHECK_OK(gcv_minkowski_sum_region(a, b, &options, &region));
        CHECK_OK(gcv_outer_face_vertices(face, ring, MOST_VERTICES, &count));
        CHECK_OK(gcv_region_vertices(region, xy, MOST_VERTICES, &required));
        CHECK(required >= count && same_ring(xy, count, ring, count));
        CHECK_OK(gcv_outer_face_exact_vertex_count(face, &count));
        for (k = 0; k < count; ++k) {
          CHECK_OK(gcv_outer_face_exact_vertex(face, k, exact, sizeof exact, &required));
          CHECK_OK(gcv_region_exact_vertex(region, k, text, sizeof text, &required));
          CHECK(strcmp(text, exact) == 0);
        }
      } else {
        CHECK_STATUS(GCV_ERR_RANGE, gcv_minkowski_sum_region(a, b, &options, &region));
        CHECK(region == NULL);
      }
      gcv_outer_face_destroy(face);
      gcv_region_destroy(region);
      gcv_polygon_destroy(a);
      gcv_polygon_destroy(b);
    }
  }
}

/* The reflection of a polygon with a hole, within a tolerance so small that nothing changes. */
static void tolerance_of_a_reflection(void) {
  static const struct rings room = {2, {4, 4}, {0, 0, 9, 0, 9, 9, 0, 9, 2, 2, 7, 2, 7, 7, 2, 7}};
  static const double r[2] = {0, 0};
  gcv_polygon *fixed = POLYGON(0, 0, 1, 0, 0, 1), *moving = polygon_of_rings(&room);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *exact = NULL, *near = NULL;
  options.tolerance = 1e-9;
  CHECK_OK(gcv_no_fit_region(fixed, moving, r, NULL, &exact));
  CHECK_OK(gcv_no_fit_region(fixed, moving, r, &options, &near));
  CHECK(area_of(exact) == 83.5 && area_of(near) == 83.5);
  gcv_region_destroy(exact);
  gcv_region_destroy(near);
  CHECK_OK(gcv_entrance_region(moving, moving, r, NULL, &exact));
  CHECK_OK(gcv_entrance_region(moving, moving, r, &options, &near));
  CHECK(area_of(exact) == area_of(near));
  gcv_region_destroy(exact);
  gcv_region_destroy(near);
  gcv_polygon_destroy(fixed);
  gcv_polygon_destroy(moving);
}

int main(void) {
  all_readers();
  swapped();
  exact_fits();
  order();
  order_of_touching_holes();
  left_out();
  holes_at_one_double();
  counts();
  references();
  bad_references();
  roundings();
  vertices_that_fall_together();
  regions_go_on();
  out_of_range();
  outer_rings();
  tolerance_of_a_reflection();
  return check_failures != 0;
}

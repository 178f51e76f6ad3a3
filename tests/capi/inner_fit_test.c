/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Inner-fit regions, worked out by hand.
 */
#include "regions.h"

static const double origin[2] = {0, 0};

static gcv_region *inner_fit(const gcv_polygon *container, const gcv_polygon *moving,
                             const gcv_options *options) {
  gcv_region *region = NULL;
  CHECK_OK(gcv_inner_fit_region(container, moving, origin, options, &region));
  return region;
}

/* The region, for polygons that it ends. */
static int inner_fit_is(gcv_polygon *container, gcv_polygon *moving, const char *expected) {
  gcv_region *region = inner_fit(container, moving, NULL);
  const int is = exact_region_is(region, expected);
  gcv_region_destroy(region);
  gcv_polygon_destroy(container);
  gcv_polygon_destroy(moving);
  return is;
}

static void in_a_box(void) {
  CHECK(inner_fit_is(POLYGON(0, 0, 6, 0, 6, 4, 0, 4), SQUARE(1),
                     "outer 0/1 0/1, 5/1 0/1, 5/1 3/1, 0/1 3/1"));
  CHECK(inner_fit_is(POLYGON(0, 0, 6, 0, 6, 4, 0, 4), POLYGON(0, 0, 1, 0, 0, 1),
                     "outer 0/1 0/1, 5/1 0/1, 5/1 3/1, 0/1 3/1"));
  /* as high as the box, as large as it, and larger */
  CHECK(inner_fit_is(POLYGON(0, 0, 6, 0, 6, 4, 0, 4), SQUARE(4), "segment 0/1 0/1, 2/1 0/1"));
  CHECK(inner_fit_is(SQUARE(4), SQUARE(4), "point 0/1 0/1"));
  CHECK(inner_fit_is(SQUARE(4), POLYGON(0, 0, 5, 0, 5, 1, 0, 1), "empty"));
  /* Of one shape, and turned: the triangle fits only where it came from. */
  CHECK(inner_fit_is(POLYGON(0, 0, 5, 1, 2, 3), POLYGON(1, 1, 6, 2, 3, 4), "point -1/1 -1/1"));
  CHECK(inner_fit_is(POLYGON(0, 0, 5, 1, 2, 3), POLYGON(0, 0, -5, -1, -2, -3), "empty"));
}

/* Holes of the container are solid: what goes round them is a hole of the region. */
static void around_holes(void) {
  static const struct rings pond = {2, {4, 3}, {0, 0, 9, 0, 9, 9, 0, 9, 4, 4, 5, 4, 4, 5}};
  static const struct rings wide = {2, {4, 4}, {0, 0, 6, 0, 6, 6, 0, 6, 2, 2, 4, 2, 4, 4, 2, 4}};
  CHECK(inner_fit_is(polygon_of_rings(&pond), SQUARE(1),
                     "outer 0/1 0/1, 8/1 0/1, 8/1 8/1, 0/1 8/1; "
                     "hole 3/1 3/1, 3/1 5/1, 4/1 5/1, 5/1 4/1, 5/1 3/1"));
  /* All round it there is just room: a ring of four segments. */
  CHECK(inner_fit_is(polygon_of_rings(&wide), SQUARE(2),
                     "segment 0/1 0/1, 0/1 4/1; segment 0/1 0/1, 4/1 0/1; "
                     "segment 0/1 4/1, 4/1 4/1; segment 4/1 0/1, 4/1 4/1"));
}

/* A container of two rooms: two polygons, joined by a corridor that just fits. */
static void rooms(void) {
  static const gcv_region_part parts[] = {
      {GCV_PART_OUTER, 0, 4}, {GCV_PART_OUTER, 1, 4}, {GCV_PART_SEGMENT, UINT32_MAX, 2}};
  gcv_polygon *two =
      POLYGON(0, 0, 4, 0, 4, 1, 6, 1, 6, 0, 10, 0, 10, 4, 6, 4, 6, 3, 4, 3, 4, 4, 0, 4);
  gcv_polygon *square = SQUARE(2), *polygon = NULL;
  gcv_region *region = inner_fit(two, square, NULL);
  gcv_region_part found[MOST_PARTS];
  gcv_options options = GCV_OPTIONS_INIT;
  double area = -1;
  size_t required = 0;
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 2/1 0/1, 2/1 2/1, 0/1 2/1; "
                        "outer 6/1 0/1, 8/1 0/1, 8/1 2/1, 6/1 2/1; segment 2/1 1/1, 6/1 1/1"));
  CHECK(region_is(region, "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((6 0, 8 0, 8 2, 6 2, 6 0)))",
                  "GEOMETRYCOLLECTION (LINESTRING (2 1, 6 1))"));
  CHECK_OK(gcv_region_parts(region, found, MOST_PARTS, &required));
  CHECK(required == 3 && memcmp(found, parts, sizeof parts) == 0);
  CHECK_OK(gcv_region_area(region, &area));
  CHECK(area == 8);
  CHECK_OK(gcv_region_polygon(region, 1, &polygon));
  CHECK(polygon_is(polygon, RING(6, 0, 8, 0, 8, 2, 6, 2)));
  gcv_polygon_destroy(polygon);
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "the region has 2 polygons",
                gcv_region_polygon(region, 2, &polygon));
  gcv_region_destroy(region);

  options.leave_out = GCV_LEAVE_OUT_FITS;
  region = inner_fit(two, square, &options);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 2/1 0/1, 2/1 2/1, 0/1 2/1; "
                        "outer 6/1 0/1, 8/1 0/1, 8/1 2/1, 6/1 2/1"));
  gcv_region_destroy(region);
  gcv_polygon_destroy(two);
  gcv_polygon_destroy(square);
}

/* Polygons that touch in the smallest vertex of both come in the order of what follows: see
 * region_test.c for the same positions as holes. */
static void order_of_touching_polygons(void) {
  CHECK(inner_fit_is(POLYGON(0, 1, 4, -7, 4, 0.5, 2, 1, 4, 1.5, 4, 9),
                     POLYGON(1, 0, 2, 1, 1, 2, 0, 1),
                     "outer 0/1 0/1, 1/1 1/1, 2/1 5/4, 2/1 4/1; "
                     "outer 0/1 0/1, 2/1 -4/1, 2/1 -5/4, 1/1 -1/1"));
}

/* Segments that cross are not cut. They are cut where they meet a ring. */
static void crossing_segments(void) {
  CHECK(
      inner_fit_is(POLYGON(0, 2, 2, 2, 2, 0, 4, 0, 4, 2, 6, 2, 6, 4, 4, 4, 4, 6, 2, 6, 2, 4, 0, 4),
                   SQUARE(2), "segment 0/1 2/1, 4/1 2/1; segment 2/1 0/1, 2/1 4/1"));
  CHECK(inner_fit_is(POLYGON(0, 1, 3, 1, 3, 0, 6, 0, 6, 1, 9, 1, 9, 3, 0, 3), SQUARE(2),
                     "outer 3/1 0/1, 4/1 0/1, 4/1 1/1, 3/1 1/1; "
                     "segment 0/1 1/1, 3/1 1/1; segment 4/1 1/1, 7/1 1/1"));
}

/* Nothing there is a result, which all functions read. */
static void empty(void) {
  gcv_polygon *container = SQUARE(1), *moving = SQUARE(2), *polygon = NULL;
  gcv_region *region = inner_fit(container, moving, NULL);
  gcv_region_part part = {-1, 77, 77};
  gcv_edge_source source = {-1, 77, 77};
  gcv_stats stats = {sizeof stats, 77, 77, 77, 77, 77, 77, 77};
  double xy[2] = {77, 77}, area = -1, bound = -1;
  uint64_t number = 77;
  size_t required = 77;
  CHECK(exact_region_is(region, "empty"));
  CHECK(region_is(region, "MULTIPOLYGON EMPTY", "GEOMETRYCOLLECTION EMPTY"));
  CHECK_OK(gcv_region_parts(region, &part, 1, &required));
  CHECK(required == 0 && part.kind == -1);
  CHECK_OK(gcv_region_vertices(region, xy, 1, &required));
  CHECK(required == 0 && xy[0] == 77);
  CHECK_OK(gcv_region_exact_indices(region, &number, 1, &required));
  CHECK(required == 0);
  CHECK_OK(gcv_region_edge_owners(region, &number, 1, &required));
  CHECK(required == 0 && number == 77);
  CHECK_OK(gcv_region_edge_sources(region, &source, 1, &required));
  CHECK(required == 0 && source.kind == -1);
  CHECK_OK(gcv_region_edge_sources(region, NULL, 0, &required));
  CHECK_OK(gcv_region_area(region, &area));
  CHECK_OK(gcv_region_error_bound(region, &bound));
  CHECK(area == 0 && bound == 0);
  CHECK_OK(gcv_region_stats(region, &stats));
  CHECK(stats.vertices_repaired == 0 && stats.parts_dropped == 0);
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "polygon is 0, the region has 0 polygons",
                gcv_region_polygon(region, 0, &polygon));
  CHECK(polygon == NULL);
  gcv_region_destroy(region);
  gcv_polygon_destroy(container);
  gcv_polygon_destroy(moving);
}

/* In the sources, a is in the container and b in `moving`, in the caller's numbers. */
static void sources(void) {
  gcv_polygon *container = POLYGON(6, 4, 0, 4, 0, 0, 6, 0),
              *moving = POLYGON(1, 1, 0, 1, 0, 0, 1, 0);
  gcv_region *region = inner_fit(container, moving, NULL);
  gcv_edge_source found[4];
  size_t required = 0, k;
  CHECK(exact_region_is(region, "outer 0/1 0/1, 5/1 0/1, 5/1 3/1, 0/1 3/1"));
  CHECK_OK(gcv_region_edge_sources(region, found, 4, &required));
  CHECK(required == 4);
  for (k = 0; k < 4; ++k) {
    CHECK(found[k].kind == GCV_EDGE_TRANSLATED || found[k].kind == GCV_EDGE_TRANSLATED_CORNER);
    CHECK(found[k].a == (k + 2) % 4 && found[k].b < 4);
  }
  gcv_region_destroy(region);
  gcv_polygon_destroy(container);
  gcv_polygon_destroy(moving);
}

static void refused_options(void) {
  gcv_polygon *container = SQUARE(4), *moving = SQUARE(1);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *region = NULL;
  uint64_t leave_out;
  options.tolerance = 0x1p-1074;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "tolerance",
                gcv_inner_fit_region(container, moving, origin, &options, &region));
  options.tolerance = 0;
  for (leave_out = GCV_LEAVE_OUT_HOLES; leave_out < 4; leave_out += 2) {
    options.leave_out = leave_out;
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "GCV_LEAVE_OUT_HOLES",
                  gcv_inner_fit_region(container, moving, origin, &options, &region));
  }
  CHECK(region == NULL);
  gcv_polygon_destroy(container);
  gcv_polygon_destroy(moving);
}

/* Outwards, what is placed by the region lies in the container: the region shrinks. */
static void roundings(void) {
  const double tenth[2] = {0.1, 0.1};
  gcv_polygon *container = POLYGON(0, 0, 1, 0.1, 0.7, 0.9), *moving = SQUARE(0.125);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *nearest = NULL, *outward = NULL;
  double xy[2 * MOST_VERTICES], area = 0, outward_area = 0;
  int8_t places[MOST_VERTICES];
  size_t count = 0, k;
  CHECK_OK(gcv_inner_fit_region(container, moving, tenth, &options, &nearest));
  options.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_inner_fit_region(container, moving, tenth, &options, &outward));
  CHECK_OK(gcv_region_area(nearest, &area));
  CHECK_OK(gcv_region_area(outward, &outward_area));
  CHECK(area > 0.1 && outward_area > 0.1 && outward_area <= area * (1 + 1e-12));
  CHECK_OK(gcv_region_vertices(outward, xy, MOST_VERTICES, &count));
  CHECK_OK(gcv_region_locate(outward, xy, count, places));
  CHECK(count == 3);
  for (k = 0; k < count; ++k) CHECK(places[k] != GCV_OUTSIDE);
  gcv_region_destroy(nearest);
  gcv_region_destroy(outward);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(container);
}

/* The one part of an inner fit is a segment that doubles do not show. The error bound. */
static double bound_without(const gcv_polygon *container, const gcv_polygon *moving, double x) {
  const double reference[2] = {x, 0};
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *region = NULL;
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 77};
  double bound = -1;
  size_t required = 77;
  options.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_inner_fit_region(container, moving, reference, &options, &region));
  CHECK_OK(gcv_region_parts(region, NULL, 0, &required));
  CHECK(required == 0);
  CHECK_OK(gcv_region_stats(region, &stats));
  CHECK(stats.parts_dropped == 1);
  CHECK_OK(gcv_region_error_bound(region, &bound));
  gcv_region_destroy(region);
  return bound;
}

/* It counts with its length; infinitely where that is beyond the largest double. */
static void lost_fit(void) {
  gcv_polygon *container = POLYGON(1, 0, 3, 0, 3, 6, 1, 6), *moving = SQUARE(2);
  gcv_polygon *wide = POLYGON(1e308, 0, 1.5e308, 0, 1.5e308, 6, 1e308, 6);
  gcv_polygon *high = POLYGON(0, 0, 1, 0, 1, 6, 0, 6);
  const double bound = bound_without(container, moving, 0.1);
  CHECK(bound >= 4 && bound < 4.0001);
  CHECK(bound_without(wide, high, 1.5e308) == INFINITY);
  gcv_polygon_destroy(container);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(wide);
  gcv_polygon_destroy(high);
}

/* The one position is no double. */
static void position_between_doubles(void) {
  const double reference[2] = {0x1p-60, 1};
  gcv_polygon *container = POLYGON(1, 0, 3, 0, 3, 2, 1, 2), *moving = SQUARE(2);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *nearest = NULL, *outward = NULL;
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 0};
  CHECK_OK(gcv_inner_fit_region(container, moving, reference, &options, &nearest));
  options.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_inner_fit_region(container, moving, reference, &options, &outward));
  CHECK(region_is(nearest, "MULTIPOLYGON EMPTY", "GEOMETRYCOLLECTION (POINT (1 1))"));
  CHECK(region_is(outward, "MULTIPOLYGON EMPTY", "GEOMETRYCOLLECTION EMPTY"));
  CHECK_OK(gcv_region_stats(outward, &stats));
  CHECK(stats.parts_dropped == 1);
  gcv_region_destroy(nearest);
  gcv_region_destroy(outward);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(container);
}

/* A room, and a corridor that is wider than the square by the roundings of its vertices. Inward,
 * the corridor is dropped, and the room stays. */
static void corridor_of_an_ulp(void) {
  gcv_polygon *container =
      POLYGON(-5.444268600082189, 8.124456688601008, 0.5557313999178101, 0.12445668860100756,
              8.55573139991781, 6.124456688601008, 6.15573139991781, 9.324456688601007,
              14.15573139991781, 15.324456688601007, 12.355731399917811, 17.72445668860101,
              4.35573139991781, 11.724456688601007, 2.5557313999178106, 14.124456688601008);
  gcv_polygon *moving =
      POLYGON(-1.2442686000821899, 2.5244566886010076, 0.5557313999178101, 0.12445668860100756,
              2.95573139991781, 1.9244566886010075, 1.1557313999178103, 4.324456688601008);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_stats stats;
  gcv_region *region;
  double area = 0;
  options.rounding = GCV_ROUND_OUTWARD;
  region = inner_fit(container, moving, &options);
  CHECK_OK(gcv_region_area(region, &area));
  CHECK(area > 48.999 && area <= 49);
  memset(&stats, 0, sizeof stats);
  stats.struct_size = sizeof stats;
  CHECK_OK(gcv_region_stats(region, &stats));
  CHECK(stats.parts_dropped == 1);
  gcv_region_destroy(region);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(container);
}

/* What rounding outward leaves nothing of counts with its extents: here all, 98 wide and 59 high.
 */
static void extents_of_what_is_dropped(void) {
  const double reference[2] = {0x1p56 + 62848, -0x1p56};
  gcv_polygon *container =
      POLYGON(-24, -20, -29, -22, -42, -13, -44, 13, -6, 7, -19, 35, -2, 26, 3, 35, 54, -11, 47,
              -27, 34, -22, 33, -26, 13, -18, 10, -15, 9, -28, 5, -39);
  gcv_polygon *bar = POLYGON(0, 0, 0, -1, -5, -1, -5, 0);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *region = NULL;
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 0};
  double bound = 0;
  size_t count = 9;
  options.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_inner_fit_region(container, bar, reference, &options, &region));
  CHECK_OK(gcv_region_vertices(region, NULL, 0, &count));
  CHECK_OK(gcv_region_stats(region, &stats));
  CHECK_OK(gcv_region_error_bound(region, &bound));
  CHECK(count == 0 && stats.parts_dropped == 1 && bound >= 114.459469933257);
  gcv_region_destroy(region);
  gcv_polygon_destroy(container);
  gcv_polygon_destroy(bar);
}

int main(void) {
  in_a_box();
  around_holes();
  rooms();
  order_of_touching_polygons();
  crossing_segments();
  empty();
  sources();
  refused_options();
  roundings();
  lost_fit();
  position_between_doubles();
  corridor_of_an_ulp();
  extents_of_what_is_dropped();
  return check_failures != 0;
}

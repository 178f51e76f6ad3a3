/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Free regions in windows, worked out by hand; what is refused; coordinates that are no doubles.
 */
#include "free_regions.h"

/* What lies in the window is cut, and what is not there is not looked at. */
static void windows_without_a_container(void) {
  static const gcv_edge_source none = {0, 0, 0};
  gcv_polygon *unit = SQUARE(1), *square = SQUARE(2), *triangle = POLYGON(0, 0, 1, 0, 0, 1);
  gcv_scene *scene = new_scene();
  gcv_region *region;
  gcv_edge_source sources[8];
  size_t required = 0, k;
  CHECK(free_is(scene, unit, WINDOW(-3, 2, 5, 2.5), NULL,
                "outer -3/1 2/1, 5/1 2/1, 5/1 5/2, -3/1 5/2"));
  add(scene, square, 0, 0);
  region = free_region(scene, unit, WINDOW(-5, -5, 5, 5), NULL);
  CHECK(exact_region_is(region,
                        "outer -5/1 -5/1, 5/1 -5/1, 5/1 5/1, -5/1 5/1; "
                        "hole -1/1 -1/1, -1/1 2/1, 2/1 2/1, 2/1 -1/1"));
  CHECK(OWNERS_ARE(region, 0, 0, 0, 0, 2, 2, 2, 2));
  CHECK_OK(gcv_region_edge_sources(region, sources, 8, &required));
  CHECK(required == 8);
  for (k = 0; k < 8; ++k) CHECK((k < 4) == (memcmp(&sources[k], &none, sizeof none) == 0));
  gcv_region_destroy(region);
  /* Across the border, and through all of the window. */
  region = free_region(scene, unit, WINDOW(0, 0, 5, 5), NULL);
  CHECK(exact_region_is(region, "outer 0/1 2/1, 2/1 2/1, 2/1 0/1, 5/1 0/1, 5/1 5/1, 0/1 5/1"));
  CHECK(OWNERS_ARE(region, 2, 2, 0, 0, 0, 0));
  gcv_region_destroy(region);
  region = free_region(scene, unit, WINDOW(-2, 0, 3, 1), NULL);
  CHECK(exact_region_is(region,
                        "outer -2/1 0/1, -1/1 0/1, -1/1 1/1, -2/1 1/1; "
                        "outer 2/1 0/1, 3/1 0/1, 3/1 1/1, 2/1 1/1"));
  CHECK(OWNERS_ARE(region, 0, 2, 0, 0, 0, 0, 0, 2));
  gcv_region_destroy(region);
  /* Where the polygon overlaps the member everywhere, but for the border. */
  CHECK(free_is(scene, unit, WINDOW(0, 0, 1, 1), NULL, "empty"));
  CHECK(free_is(scene, unit, WINDOW(-1, -1, 2, 2), NULL, "empty"));
  /* All around, touching it. */
  CHECK(free_is(scene, unit, WINDOW(2, -1, 3, 2), NULL,
                "outer 2/1 -1/1, 3/1 -1/1, 3/1 2/1, 2/1 2/1"));
  /* A window has sides along the axes, whatever moves. */
  region = free_region(scene, triangle, WINDOW(-2, -2, 1, 1), NULL);
  CHECK(exact_region_is(
      region, "outer -2/1 -2/1, 1/1 -2/1, 1/1 -1/1, 0/1 -1/1, -1/1 0/1, -1/1 1/1, -2/1 1/1"));
  CHECK(OWNERS_ARE(region, 0, 0, 2, 2, 2, 0, 0));
  gcv_region_destroy(region);
  CHECK(free_is(scene, triangle, WINDOW(-2, -0.0, -0.0, 1), NULL,
                "outer -2/1 0/1, -1/1 0/1, -1/1 1/1, -2/1 1/1"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(triangle);
}

static void windows_in_a_container(void) {
  gcv_polygon *room = SQUARE(10), *unit = SQUARE(1), *square = SQUARE(2);
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  add(scene, square, 4, 4);
  region = free_region(scene, unit, WINDOW(5, 5, 20, 20), NULL);
  CHECK(exact_region_is(region, "outer 5/1 6/1, 6/1 6/1, 6/1 5/1, 9/1 5/1, 9/1 9/1, 5/1 9/1"));
  CHECK(OWNERS_ARE(region, 2, 2, 0, 1, 1, 0));
  gcv_region_destroy(region);
  region = free_region(scene, unit, WINDOW(1, 1, 2, 2), NULL);
  CHECK(exact_region_is(region, "outer 1/1 1/1, 2/1 1/1, 2/1 2/1, 1/1 2/1"));
  CHECK(OWNERS_ARE(region, 0, 0, 0, 0));
  gcv_region_destroy(region);
  region = free_region(scene, unit, WINDOW(-1e9, -1e9, 1e9, 1e9), NULL);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1; "
                        "hole 3/1 3/1, 3/1 6/1, 6/1 6/1, 6/1 3/1"));
  CHECK(OWNERS_ARE(region, 1, 1, 1, 1, 2, 2, 2, 2));
  gcv_region_destroy(region);
  /* Outside, beside what is free, and in its corner. */
  CHECK(free_is(scene, unit, WINDOW(10, 0, 20, 9), NULL, "empty"));
  CHECK(free_is(scene, unit, WINDOW(9, 0, 20, 9), NULL, "empty"));
  CHECK(free_is(scene, unit, WINDOW(9, 9, 20, 20), NULL, "empty"));
  CHECK(free_is(scene, unit, WINDOW(-1e300, -1e300, -1, -1), NULL, "empty"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* Two rooms and a corridor at y = 1 that just fits, from 2 to 6. */
static void segments_in_windows(void) {
  static const char *const rooms_above =
      "outer 1/1 1/1, 2/1 1/1, 2/1 2/1, 1/1 2/1; "
      "outer 6/1 1/1, 7/1 1/1, 7/1 2/1, 6/1 2/1; segment 2/1 1/1, 6/1 1/1";
  static const char *const rooms_below =
      "outer 1/1 0/1, 2/1 0/1, 2/1 1/1, 1/1 1/1; "
      "outer 6/1 0/1, 7/1 0/1, 7/1 1/1, 6/1 1/1; segment 2/1 1/1, 6/1 1/1";
  gcv_polygon *rooms =
      POLYGON(0, 0, 4, 0, 4, 1, 6, 1, 6, 0, 10, 0, 10, 4, 6, 4, 6, 3, 4, 3, 4, 4, 0, 4);
  gcv_polygon *square = SQUARE(2);
  gcv_scene *scene = scene_in(rooms);
  gcv_region *region;
  /* On the border. */
  CHECK(free_is(scene, square, WINDOW(1, 1, 7, 5), NULL, rooms_above));
  CHECK(free_is(scene, square, WINDOW(1, -1, 7, 1), NULL, rooms_below));
  CHECK(free_is(scene, square, WINDOW(3, 1, 5, 2), NULL, "segment 3/1 1/1, 5/1 1/1"));
  CHECK(free_is(scene, square, WINDOW(3, 0, 5, 1), NULL, "segment 3/1 1/1, 5/1 1/1"));
  CHECK(free_is(scene, square, WINDOW(3, 1.5, 5, 2), NULL, "empty"));
  /* Cut by it. */
  region = free_region(scene, square, WINDOW(3, 0, 5, 3), NULL);
  CHECK(exact_region_is(region, "segment 3/1 1/1, 5/1 1/1"));
  CHECK(OWNERS_ARE(region, 1, 0));
  gcv_region_destroy(region);
  CHECK(free_is(scene, square, WINDOW(4, 0.5, 7, 9), NULL,
                "outer 6/1 1/2, 7/1 1/2, 7/1 2/1, 6/1 2/1; segment 4/1 1/1, 6/1 1/1"));
  /* Where it ends on the border, the room beside it is not there. */
  CHECK(free_is(scene, square, WINDOW(2, 0, 4, 2), NULL, "segment 2/1 1/1, 4/1 1/1"));
  CHECK(
      free_is(scene, square, WINDOW(0, 0, 2, 2), NULL, "outer 0/1 0/1, 2/1 0/1, 2/1 2/1, 0/1 2/1"));
  /* Where it ends in a corner of the window, which is one of a ring, there is no point besides. */
  CHECK(
      free_is(scene, square, WINDOW(0, 1, 2, 3), NULL, "outer 0/1 1/1, 2/1 1/1, 2/1 2/1, 0/1 2/1"));
  CHECK(free_is(scene, square, WINDOW(0, -1, 2, 1), NULL,
                "outer 0/1 0/1, 2/1 0/1, 2/1 1/1, 0/1 1/1"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(rooms);
  gcv_polygon_destroy(square);
}

/* What a window has of a segment can be a point. */
static void points_in_windows(void) {
  gcv_polygon *level = POLYGON(0, 0, 6, 0, 6, 4, 0, 4), *block = SQUARE(4);
  gcv_polygon *slanted = POLYGON(0, 0, 1, -1, 5, 3, 4, 4),
              *diamond = POLYGON(0, 0, 1, -1, 2, 0, 1, 1);
  gcv_polygon *holed = polygon_of_rings(&frame), *square = SQUARE(2);
  gcv_scene *scene = scene_in(level);
  gcv_region *region;
  CHECK(free_is(scene, block, WINDOW(-1, -1, 5, 5), NULL, "segment 0/1 0/1, 2/1 0/1"));
  region = free_region(scene, block, WINDOW(2, -1, 5, 3), NULL);
  CHECK(exact_region_is(region, "point 2/1 0/1"));
  CHECK(OWNERS_ARE(region, 0));
  gcv_region_destroy(region);
  CHECK(free_is(scene, block, WINDOW(2, 0, 3, 1), NULL, "point 2/1 0/1"));
  CHECK(free_is(scene, block, WINDOW(-1, -1, 0, 0), NULL, "point 0/1 0/1"));
  CHECK(free_is(scene, block, WINDOW(1, 0x1p-1074, 2, 1), NULL, "empty"));
  CHECK_OK(gcv_scene_set_container(scene, slanted));
  CHECK(free_is(scene, diamond, WINDOW(-1, -1, 5, 5), NULL, "segment 0/1 0/1, 3/1 3/1"));
  CHECK(free_is(scene, diamond, WINDOW(1, 0, 2, 3), NULL, "segment 1/1 1/1, 2/1 2/1"));
  CHECK(free_is(scene, diamond, WINDOW(2, 0, 4, 2), NULL, "point 2/1 2/1"));
  CHECK(free_is(scene, diamond, WINDOW(0, 2, 2, 4), NULL, "point 2/1 2/1"));
  CHECK(free_is(scene, diamond, WINDOW(2.5, 0, 4, 2), NULL, "empty"));
  /* In the hole of a member. */
  CHECK_OK(gcv_scene_set_container(scene, NULL));
  add(scene, holed, 10, 10);
  CHECK(free_is(scene, square, WINDOW(10, 10, 12, 12), NULL, "point 11/1 11/1"));
  CHECK(free_is(scene, square, WINDOW(11, 11, 12, 12), NULL, "point 11/1 11/1"));
  CHECK(free_is(scene, square, WINDOW(9, 10, 11, 12), NULL, "point 11/1 11/1"));
  CHECK(free_is(scene, square, WINDOW(11.5, 11, 12, 12), NULL, "empty"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(level);
  gcv_polygon_destroy(block);
  gcv_polygon_destroy(slanted);
  gcv_polygon_destroy(diamond);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(square);
}

/* Two corridors that cross, in a window with one on its border and the crossing in its corner: of
 * the other one there is that point, which is none of its own. */
static void crossing_in_a_corner(void) {
  gcv_polygon *cross =
      POLYGON(0, 2, 2, 2, 2, 0, 4, 0, 4, 2, 6, 2, 6, 4, 4, 4, 4, 6, 2, 6, 2, 4, 0, 4);
  gcv_polygon *square = SQUARE(2);
  gcv_scene *scene = scene_in(cross);
  CHECK(free_is(scene, square, WINDOW(-1, -1, 9, 9), NULL,
                "segment 0/1 2/1, 4/1 2/1; segment 2/1 0/1, 2/1 4/1"));
  CHECK(free_is(scene, square, WINDOW(2, -1, 3, 2), NULL,
                "segment 2/1 0/1, 2/1 2/1; segment 2/1 2/1, 3/1 2/1"));
  CHECK(free_is(scene, square, WINDOW(1, 2, 3, 3), NULL,
                "segment 1/1 2/1, 3/1 2/1; segment 2/1 2/1, 2/1 3/1"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(cross);
  gcv_polygon_destroy(square);
}

/* Between members, and between a member and the border, which is no obstacle. */
static void gaps_at_the_border(void) {
  gcv_polygon *unit = SQUARE(1), *square = SQUARE(2);
  gcv_scene *scene = new_scene();
  gcv_region *region;
  add(scene, square, 0, 0);
  add(scene, square, 3, 0);
  region = free_region(scene, unit, WINDOW(-5, 0, 9, 1), NULL);
  CHECK(exact_region_is(region,
                        "outer -5/1 0/1, -1/1 0/1, -1/1 1/1, -5/1 1/1; "
                        "outer 5/1 0/1, 9/1 0/1, 9/1 1/1, 5/1 1/1; segment 2/1 0/1, 2/1 1/1"));
  CHECK(OWNERS_ARE(region, 0, 2, 0, 0, 0, 0, 0, 3, 2, 0) ||
        OWNERS_ARE(region, 0, 2, 0, 0, 0, 0, 0, 3, 3, 0));
  gcv_region_destroy(region);
  CHECK(free_is(scene, unit, WINDOW(2, 0, 4, 1), NULL, "segment 2/1 0/1, 2/1 1/1"));
  CHECK(free_is(scene, unit, WINDOW(0, 0, 2, 1), NULL, "segment 2/1 0/1, 2/1 1/1"));
  CHECK(free_is(scene, unit, WINDOW(2.5, 0, 4, 1), NULL, "empty"));
  CHECK(free_is(scene, unit, WINDOW(5, 0, 6, 1), NULL, "outer 5/1 0/1, 6/1 0/1, 6/1 1/1, 5/1 1/1"));
  CHECK(free_is(scene, unit, WINDOW(4.5, 0, 5, 1), NULL, "empty"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* Sums of vertices and positions that are no doubles: 0.1 + 0.2, and beyond 2^53. */
static void coordinates_that_are_no_doubles(void) {
  const double tenth = 0.1, even = 0x1p53;
  gcv_polygon *unit = SQUARE(1), *beside = POLYGON(tenth, 0, 1, 0, 1, 1, tenth, 1);
  gcv_polygon *before = POLYGON(0, 0, 0.25, 0, 0.25, 1, 0, 1);
  gcv_scene *scene = new_scene();
  add(scene, beside, 0.2, 0);
  CHECK(free_is(scene, before, WINDOW(0, 0, 0.5, 0.5), NULL,
                "outer 0/1 0/1, 1801439850948199/36028797018963968 0/1, "
                "1801439850948199/36028797018963968 1/2, 0/1 1/2"));
  /* It ends at 2^53 + 1. */
  add(scene, unit, even, 50);
  CHECK(free_is(scene, unit, WINDOW(even, 50, even + 4, 50.5), NULL,
                "outer 9007199254740993/1 50/1, 9007199254740996/1 50/1, 9007199254740996/1 101/2, "
                "9007199254740993/1 101/2"));
  /* Two that are 1 apart there, at a place that is no double. */
  add(scene, unit, even + 2, 50);
  CHECK(free_is(scene, unit, WINDOW(even, 50, even + 2, 50.5), NULL,
                "segment 9007199254740993/1 50/1, 9007199254740993/1 101/2"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(beside);
  gcv_polygon_destroy(before);
}

/* Outwards, what is placed by the region is free: it shrinks. */
static void roundings(void) {
  gcv_polygon *member = POLYGON(0, 0, 1, 0.1, 0.7, 0.9),
              *moving = POLYGON(0, 0, 0.3, 0.1, 0.1, 0.2);
  gcv_scene *scene = new_scene();
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *nearest = free_region(scene, moving, WINDOW(-1, -1, 2, 2), NULL), *outward = NULL;
  double xy[2 * MOST_VERTICES], area = 0, outward_area = 0;
  int8_t places[MOST_VERTICES];
  size_t count = 0, k;
  gcv_region_destroy(nearest);
  add(scene, member, 0.1, 0.3);
  nearest = free_region(scene, moving, WINDOW(-1, -1, 2, 2), NULL);
  options.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_scene_free_region(scene, moving, WINDOW(-1, -1, 2, 2), NULL, &options, &outward));
  CHECK_OK(gcv_region_area(nearest, &area));
  CHECK_OK(gcv_region_area(outward, &outward_area));
  CHECK(area > 8 && area < 9 && outward_area < area && outward_area > area - 1e-12);
  CHECK_OK(gcv_region_vertices(outward, xy, MOST_VERTICES, &count));
  CHECK(count >= 8);
  CHECK_OK(gcv_region_locate(nearest, xy, count, places));
  for (k = 0; k < count; ++k) CHECK(places[k] != GCV_OUTSIDE);
  CHECK_OK(gcv_scene_relation(scene, moving, xy, count, NULL, NULL, places));
  for (k = 0; k < count; ++k) CHECK(places[k] != GCV_OVERLAPPING);
  gcv_region_destroy(nearest);
  gcv_region_destroy(outward);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(member);
  gcv_polygon_destroy(moving);
}

struct bad_window {
  double numbers[4];
  gcv_status status;
  const char *message;
};

static void refused_windows(void) {
  static const struct bad_window bad[] = {
      {{0, 0, 0, 1}, GCV_ERR_INVALID_ARGUMENT, "window: xmin is 0, not less than xmax, 0"},
      {{0, 1, 1, 1}, GCV_ERR_INVALID_ARGUMENT, "window: ymin is 1, not less than ymax, 1"},
      {{2, 0, 1, 1}, GCV_ERR_INVALID_ARGUMENT, "window: xmin is 2, not less than xmax, 1"},
      {{0, 9, 1, 3}, GCV_ERR_INVALID_ARGUMENT, "window: ymin is 9, not less than ymax, 3"},
      {{-0.0, 0, 0, 1}, GCV_ERR_INVALID_ARGUMENT, "xmin"},
      {{NAN, 0, 1, 1}, GCV_ERR_NOT_FINITE, "window: xmin is"},
      {{0, NAN, 1, 1}, GCV_ERR_NOT_FINITE, "window: ymin is"},
      {{0, 0, INFINITY, 1}, GCV_ERR_NOT_FINITE, "window: xmax is inf"},
      {{0, -INFINITY, 1, 1}, GCV_ERR_NOT_FINITE, "window: ymin is -inf"},
      {{0, 0, 1, NAN}, GCV_ERR_NOT_FINITE, "window: ymax is"},
      {{-1.7e308, 0, 1.7e308, 1}, GCV_ERR_RANGE, "window"},
  };
  gcv_polygon *room = SQUARE(10), *unit = SQUARE(1);
  gcv_scene *scene = new_scene();
  gcv_region *region = NULL;
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_query query = GCV_QUERY_INIT;
  size_t k;
  int is_contained;
  add(scene, unit, 3, 3);
  for (is_contained = 0; is_contained < 2; ++is_contained) {
    for (k = 0; k < sizeof bad / sizeof *bad; ++k) {
      CHECK_REFUSED(bad[k].status, bad[k].message,
                    gcv_scene_free_region(scene, unit, bad[k].numbers, NULL, NULL, &region));
    }
    CHECK_OK(gcv_scene_set_container(scene, room));
  }
  options.tolerance = 0x1p-1074;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "tolerance",
                gcv_scene_free_region(scene, unit, NULL, NULL, &options, &region));
  options.tolerance = 0;
  for (options.leave_out = GCV_LEAVE_OUT_HOLES; options.leave_out < 4; options.leave_out += 2) {
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "GCV_LEAVE_OUT_HOLES",
                  gcv_scene_free_region(scene, unit, NULL, NULL, &options, &region));
  }
  options.leave_out = 4;
  CHECK_STATUS(GCV_ERR_INVALID_ARGUMENT,
               gcv_scene_free_region(scene, unit, NULL, NULL, &options, &region));
  query.struct_size = 0;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_free_region(scene, unit, NULL, &query, NULL, &region));
  CHECK(region == NULL);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
}

/* Segments and points can be left out, holes cannot. */
static void fits_left_out(void) {
  gcv_polygon *unit = SQUARE(1), *square = SQUARE(2);
  gcv_scene *scene = new_scene();
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *region = NULL;
  add(scene, square, 0, 0);
  add(scene, square, 3, 0);
  options.leave_out = GCV_LEAVE_OUT_FITS;
  CHECK_OK(gcv_scene_free_region(scene, unit, WINDOW(-2, -2, 9, 9), NULL, &options, &region));
  CHECK(exact_region_is(region,
                        "outer -2/1 -2/1, 9/1 -2/1, 9/1 9/1, -2/1 9/1; "
                        "hole -1/1 -1/1, -1/1 2/1, 5/1 2/1, 5/1 -1/1"));
  gcv_region_destroy(region);
  CHECK_OK(gcv_scene_free_region(scene, unit, WINDOW(2, 0, 4, 1), NULL, &options, &region));
  CHECK(exact_region_is(region, "empty"));
  gcv_region_destroy(region);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* A box that is rounded outward reaches a member that the polygon in the window does not. */
static void member_out_of_reach(void) {
  gcv_polygon *moving = POLYGON(3, 0, 7, 0, 10, 3, 10, 7, 7, 10, 3, 10, 0, 7, 0, 3),
              *member = POLYGON(7, 5, 8, 5, 10, 7, 10, 8, 8, 10, 7, 10, 5, 8, 5, 7);
  gcv_scene *scene = new_scene();
  gcv_region *region;
  double area = 0;
  add(scene, member, 0x1p54 + 20, 0x1p55 + 16);
  region =
      free_region(scene, moving, WINDOW(0x1p54 - 2, 0x1p55 - 24, 0x1p54 + 12, 0x1p55 + 8), NULL);
  CHECK_OK(gcv_region_area(region, &area));
  CHECK(area == 14 * 32);
  gcv_region_destroy(region);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(member);
}

int main(void) {
  windows_without_a_container();
  windows_in_a_container();
  segments_in_windows();
  points_in_windows();
  crossing_in_a_corner();
  gaps_at_the_border();
  coordinates_that_are_no_doubles();
  roundings();
  refused_windows();
  fits_left_out();
  member_out_of_reach();
  return check_failures != 0;
}

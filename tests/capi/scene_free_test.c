/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Free regions of scenes, worked out by hand. Those in windows have a file of their own.
 */
#include "free_regions.h"

/* A container from (0, 0), 10 x 10. */
#define ROOM SQUARE(10)

/* Without members, the free region is the inner fit, for polygons that it ends. */
static int is_the_inner_fit(gcv_polygon *container, gcv_polygon *moving, const char *expected) {
  const double origin[2] = {0, 0};
  gcv_scene *scene = scene_in(container);
  gcv_region *region = free_region(scene, moving, NULL, NULL), *fit = NULL;
  char text[MOST_REGION_TEXT] = "", fits[MOST_REGION_TEXT] = "";
  size_t required = 0;
  int is;
  CHECK_OK(gcv_inner_fit_region(container, moving, origin, NULL, &fit));
  CHECK_OK(gcv_region_wkt(fit, text, sizeof text, &required));
  CHECK_OK(gcv_region_fits_wkt(fit, fits, sizeof fits, &required));
  is = exact_region_is(fit, expected) && exact_region_is(region, expected) &&
       region_is(region, text, fits);
  gcv_region_destroy(region);
  gcv_region_destroy(fit);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(container);
  gcv_polygon_destroy(moving);
  return is;
}

static void containers_alone(void) {
  static const struct rings pond = {2, {4, 3}, {0, 0, 9, 0, 9, 9, 0, 9, 4, 4, 5, 4, 4, 5}};
  CHECK(is_the_inner_fit(POLYGON(0, 0, 6, 0, 6, 4, 0, 4), SQUARE(1),
                         "outer 0/1 0/1, 5/1 0/1, 5/1 3/1, 0/1 3/1"));
  CHECK(is_the_inner_fit(POLYGON(0, 0, 6, 0, 6, 4, 0, 4), SQUARE(4), "segment 0/1 0/1, 2/1 0/1"));
  CHECK(is_the_inner_fit(POLYGON(0, 0, 5, 1, 2, 3), POLYGON(1, 1, 6, 2, 3, 4), "point -1/1 -1/1"));
  CHECK(is_the_inner_fit(SQUARE(4), SQUARE(5), "empty"));
  CHECK(is_the_inner_fit(polygon_of_rings(&pond), SQUARE(1),
                         "outer 0/1 0/1, 8/1 0/1, 8/1 8/1, 0/1 8/1; "
                         "hole 3/1 3/1, 3/1 5/1, 4/1 5/1, 5/1 4/1, 5/1 3/1"));
  CHECK(is_the_inner_fit(
      POLYGON(0, 0, 4, 0, 4, 1, 6, 1, 6, 0, 10, 0, 10, 4, 6, 4, 6, 3, 4, 3, 4, 4, 0, 4), SQUARE(2),
      "outer 0/1 0/1, 2/1 0/1, 2/1 2/1, 0/1 2/1; "
      "outer 6/1 0/1, 8/1 0/1, 8/1 2/1, 6/1 2/1; segment 2/1 1/1, 6/1 1/1"));
}

/* A member in the middle is a hole, one at the wall a notch, one across the room cuts it. */
static void members_in_a_room(void) {
  gcv_polygon *room = ROOM, *unit = SQUARE(1), *square = SQUARE(2),
              *wall = POLYGON(0, 0, 10, 0, 10, 1, 0, 1);
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  const uint64_t two = 2;
  CHECK(add(scene, square, 4, 4) == 2);
  region = free_region(scene, unit, NULL, NULL);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1; "
                        "hole 3/1 3/1, 3/1 6/1, 6/1 6/1, 6/1 3/1"));
  CHECK(OWNERS_ARE(region, 1, 1, 1, 1, 2, 2, 2, 2));
  gcv_region_destroy(region);
  move(scene, 2, 0, 4);
  region = free_region(scene, unit, NULL, NULL);
  CHECK(exact_region_is(
      region, "outer 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1, 0/1 6/1, 2/1 6/1, 2/1 3/1, 0/1 3/1"));
  CHECK(OWNERS_ARE(region, 1, 1, 1, 1, 2, 2, 2, 1));
  gcv_region_destroy(region);
  CHECK(add(scene, wall, 0, 6) == 3);
  CHECK_OK(gcv_scene_remove(scene, &two, 1));
  region = free_region(scene, unit, NULL, NULL);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 9/1 0/1, 9/1 5/1, 0/1 5/1; "
                        "outer 0/1 7/1, 9/1 7/1, 9/1 9/1, 0/1 9/1"));
  CHECK(OWNERS_ARE(region, 1, 1, 3, 1, 3, 1, 1, 1));
  gcv_region_destroy(region);
  /* As high as what is left above it, below it, and higher. */
  move(scene, 3, 0, 7);
  CHECK(free_is(scene, square, NULL, NULL,
                "outer 0/1 0/1, 8/1 0/1, 8/1 5/1, 0/1 5/1; segment 0/1 8/1, 8/1 8/1"));
  move(scene, 3, 0, 8);
  CHECK(free_is(scene, square, NULL, NULL, "outer 0/1 0/1, 8/1 0/1, 8/1 6/1, 0/1 6/1"));
  CHECK(free_is(scene, room, NULL, NULL, "empty"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(wall);
}

/* Of those with the same polygon in the same place, one is looked at: whichever is there. */
static void members_in_one_place(void) {
  static const char *const both =
      "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; hole 3/1 3/1, 3/1 6/1, 6/1 6/1, 6/1 3/1; "
      "hole 9/1 3/1, 9/1 6/1, 12/1 6/1, 12/1 3/1";
  gcv_polygon *room = SQUARE(20), *unit = SQUARE(1), *square = SQUARE(2);
  gcv_scene *scene = scene_in(room);
  const uint64_t two = 2;
  add(scene, square, 4, 4);
  add(scene, square, 4, 4);
  add(scene, square, 4, 4);
  CHECK(free_is(scene, unit, NULL, NULL,
                "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                "hole 3/1 3/1, 3/1 6/1, 6/1 6/1, 6/1 3/1"));
  move(scene, 3, 10, 4);
  CHECK(free_is(scene, unit, NULL, NULL, both));
  CHECK_OK(gcv_scene_remove(scene, &two, 1));
  CHECK(free_is(scene, unit, NULL, NULL, both));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* Members that stick out of the container, lie outside of it, or cover it. */
static void members_across_the_container(void) {
  gcv_polygon *room = ROOM, *square = SQUARE(2), *block = SQUARE(4), *large = SQUARE(30);
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  add(scene, block, 8, 3);
  region = free_region(scene, square, NULL, NULL);
  CHECK(exact_region_is(
      region, "outer 0/1 0/1, 8/1 0/1, 8/1 1/1, 6/1 1/1, 6/1 7/1, 8/1 7/1, 8/1 8/1, 0/1 8/1"));
  CHECK(OWNERS_ARE(region, 1, 1, 2, 2, 2, 1, 1, 1));
  gcv_region_destroy(region);
  move(scene, 2, 10, 3);
  CHECK(free_is(scene, square, NULL, NULL, "outer 0/1 0/1, 8/1 0/1, 8/1 8/1, 0/1 8/1"));
  move(scene, 2, 1e300, -1e300);
  CHECK(free_is(scene, square, NULL, NULL, "outer 0/1 0/1, 8/1 0/1, 8/1 8/1, 0/1 8/1"));
  add(scene, large, -10, -10);
  CHECK(free_is(scene, square, NULL, NULL, "empty"));
  /* All but a strip that is as wide as the polygon. */
  move(scene, 3, 2, -10);
  CHECK(free_is(scene, square, NULL, NULL, "segment 0/1 0/1, 0/1 8/1"));
  /* All but a corner that is as large as it. */
  add(scene, large, -10, 2);
  CHECK(free_is(scene, square, NULL, NULL, "point 0/1 0/1"));
  move(scene, 4, -10, 0x1.fffffffffffffp0);
  CHECK(free_is(scene, square, NULL, NULL, "empty"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(block);
  gcv_polygon_destroy(large);
}

/* Between members: a gap as wide as the polygon is a segment, one as large as it a point. */
static void exact_fits_between_members(void) {
  gcv_polygon *room = SQUARE(20), *unit = SQUARE(1), *square = SQUARE(2);
  gcv_polygon *level = POLYGON(0, 0, 2, 0, 2, 1, 0, 1), *upright = POLYGON(0, 0, 1, 0, 1, 2, 0, 2);
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  add(scene, square, 5, 5);
  add(scene, square, 8, 5);
  region = free_region(scene, unit, NULL, NULL);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                        "hole 4/1 4/1, 4/1 7/1, 10/1 7/1, 10/1 4/1; segment 7/1 4/1, 7/1 7/1"));
  gcv_region_destroy(region);
  /* They touch, and overlap: nothing is between them. */
  move(scene, 3, 7, 5);
  CHECK(free_is(scene, unit, NULL, NULL,
                "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                "hole 4/1 4/1, 4/1 7/1, 9/1 7/1, 9/1 4/1"));
  move(scene, 3, 6, 5);
  CHECK(free_is(scene, unit, NULL, NULL,
                "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                "hole 4/1 4/1, 4/1 7/1, 8/1 7/1, 8/1 4/1"));
  /* From the wall, as far as the polygon is wide. */
  move(scene, 3, 17, 5);
  region = free_region(scene, unit, NULL, NULL);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 19/1 0/1, 19/1 4/1, 16/1 4/1, 16/1 7/1, 19/1 7/1, "
                        "19/1 19/1, 0/1 19/1; hole 4/1 4/1, 4/1 7/1, 7/1 7/1, 7/1 4/1; "
                        "segment 19/1 4/1, 19/1 7/1"));
  gcv_region_destroy(region);
  gcv_scene_destroy(scene);
  /* Four round a place of 1 x 1, each touching two others. */
  scene = scene_in(room);
  add(scene, level, 9, 9);
  add(scene, upright, 11, 9);
  add(scene, level, 10, 11);
  add(scene, upright, 9, 10);
  CHECK(free_is(scene, unit, NULL, NULL,
                "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                "hole 8/1 8/1, 8/1 12/1, 12/1 12/1, 12/1 8/1; point 10/1 10/1"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(level);
  gcv_polygon_destroy(upright);
}

/* The hole of a member is a place for what goes in, unless another member is there. */
static void holes_of_members(void) {
  const double height = 0x1.0000000000001p1;
  gcv_polygon *room = SQUARE(20), *holed = polygon_of_rings(&frame), *unit = SQUARE(1);
  gcv_polygon *square = SQUARE(2), *higher = POLYGON(0, 0, 2, 0, 2, height, 0, height);
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  add(scene, holed, 10, 10);
  region = free_region(scene, unit, NULL, NULL);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                        "hole 9/1 9/1, 9/1 14/1, 14/1 14/1, 14/1 9/1; "
                        "outer 11/1 11/1, 12/1 11/1, 12/1 12/1, 11/1 12/1"));
  CHECK(OWNERS_ARE(region, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2));
  gcv_region_destroy(region);
  region = free_region(scene, square, NULL, NULL);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 18/1 0/1, 18/1 18/1, 0/1 18/1; "
                        "hole 8/1 8/1, 8/1 14/1, 14/1 14/1, 14/1 8/1; point 11/1 11/1"));
  CHECK(OWNERS_ARE(region, 1, 1, 1, 1, 2, 2, 2, 2, 0));
  gcv_region_destroy(region);
  CHECK(free_is(scene, higher, NULL, NULL,
                "outer 0/1 0/1, 18/1 0/1, 18/1 40532396646334463/2251799813685248, "
                "0/1 40532396646334463/2251799813685248; "
                "hole 8/1 18014398509481983/2251799813685248, 8/1 14/1, 14/1 14/1, "
                "14/1 18014398509481983/2251799813685248"));
  /* In the hole, on it, and in a corner of it. */
  add(scene, square, 11, 11);
  CHECK(free_is(scene, unit, NULL, NULL,
                "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                "hole 9/1 9/1, 9/1 14/1, 14/1 14/1, 14/1 9/1"));
  move(scene, 3, 10, 11);
  region = free_region(scene, unit, NULL, NULL);
  CHECK(
      exact_region_is(region,
                      "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                      "hole 9/1 9/1, 9/1 14/1, 14/1 14/1, 14/1 9/1; segment 12/1 11/1, 12/1 12/1"));
  gcv_region_destroy(region);
  move(scene, 3, 10, 10);
  CHECK(free_is(scene, unit, NULL, NULL,
                "outer 0/1 0/1, 19/1 0/1, 19/1 19/1, 0/1 19/1; "
                "hole 9/1 9/1, 9/1 14/1, 14/1 14/1, 14/1 9/1; "
                "segment 11/1 12/1, 12/1 12/1; segment 12/1 11/1, 12/1 12/1"));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(higher);
}

/* Layers and ignored ids choose the members, and ids that are not there do no harm. */
/* What a member takes touches the border of what is free, in the middle of an edge of which one end
 * is rounded. It stays a hole, or a bay where what is taken grows. */
static void holes_that_touch_rounded_edges(void) {
  gcv_polygon *room = POLYGON(19, 3, 0, 22, 0, 1), *moving = SQUARE(2);
  gcv_polygon *member = POLYGON(0, 0, 2, 0, 2, 5, 1, 5, 1, 4, 0, 4);
  gcv_scene *scene = scene_in(room);
  const double points[4] = {5, 5, 1, 8};
  const int32_t roundings[2] = {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD};
  add(scene, member, 6, 5);
  for (int k = 0; k < 2; ++k) {
    gcv_options options = GCV_OPTIONS_INIT;
    gcv_region *region = NULL;
    int8_t locations[2];
    double error = INFINITY;
    size_t parts = 0;
    options.rounding = roundings[k];
    CHECK_OK(gcv_scene_free_region(scene, moving, NULL, NULL, &options, &region));
    CHECK_OK(gcv_region_parts(region, NULL, 0, &parts));
    CHECK_OK(gcv_region_error_bound(region, &error));
    CHECK(parts == (k == 0 ? 2 : 1));
    CHECK(error < 1e-12);
    CHECK_OK(gcv_region_locate(region, points, 2, locations));
    CHECK(locations[0] == GCV_OUTSIDE && locations[1] == GCV_INSIDE);
    gcv_region_destroy(region);
  }
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(member);
}

static void queries(void) {
  static const char *const both =
      "outer 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1; hole 1/1 1/1, 1/1 4/1, 4/1 4/1, 4/1 1/1; "
      "hole 5/1 5/1, 5/1 8/1, 8/1 8/1, 8/1 5/1";
  static const char *const first =
      "outer 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1; hole 1/1 1/1, 1/1 4/1, 4/1 4/1, 4/1 1/1";
  static const char *const second =
      "outer 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1; hole 5/1 5/1, 5/1 8/1, 8/1 8/1, 8/1 5/1";
  static const char *const none = "outer 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1";
  gcv_polygon *room = ROOM, *unit = SQUARE(1), *square = SQUARE(2);
  gcv_scene *scene = scene_in(room);
  const uint64_t ids[] = {2, 3}, ignore[] = {4711, 3, 0, 3, 2}, container = 1;
  const uint32_t layers[] = {1, 6};
  gcv_query query = GCV_QUERY_INIT;
  gcv_region *region = NULL;
  add(scene, square, 2, 2);
  add(scene, square, 6, 6);
  CHECK_OK(gcv_scene_set_layers(scene, ids, layers, 2));
  CHECK(free_is(scene, unit, NULL, NULL, both));
  CHECK(free_is(scene, unit, NULL, &query, both));
  query.layers = 1;
  CHECK(free_is(scene, unit, NULL, &query, first));
  query.layers = 12;
  CHECK(free_is(scene, unit, NULL, &query, second));
  query.layers = 16;
  CHECK(free_is(scene, unit, NULL, &query, none));
  query.layers = UINT32_MAX;
  query.ignore = ignore;
  query.ignore_count = 4;
  CHECK(free_is(scene, unit, NULL, &query, first));
  query.ignore_count = 5;
  CHECK(free_is(scene, unit, NULL, &query, none));
  /* Without the container there must be a window. */
  query.ignore = &container;
  query.ignore_count = 1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "no container",
                gcv_scene_free_region(scene, unit, NULL, &query, NULL, &region));
  CHECK(free_is(scene, unit, WINDOW(-2, -2, 5, 3), &query,
                "outer -2/1 -2/1, 5/1 -2/1, 5/1 3/1, 4/1 3/1, 4/1 1/1, 1/1 1/1, 1/1 3/1, "
                "-2/1 3/1"));
  query.layers = 0;
  query.ignore_count = 0;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "no container",
                gcv_scene_free_region(scene, unit, NULL, &query, NULL, &region));
  CHECK(free_is(scene, unit, WINDOW(-2, -2, 5, 3), &query,
                "outer -2/1 -2/1, 5/1 -2/1, 5/1 3/1, -2/1 3/1"));
  CHECK_OK(gcv_scene_set_container(scene, NULL));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "no container",
                gcv_scene_free_region(scene, unit, NULL, NULL, NULL, &region));
  CHECK(region == NULL);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* In the sources, a is in the member or the container and b in the polygon, in the caller's
 * numbers: here all rings begin elsewhere, and some are clockwise. */
static void sources(void) {
  gcv_polygon *room = POLYGON(10, 10, 0, 10, 0, 0, 10, 0);
  gcv_polygon *square = POLYGON(2, 0, 0, 0, 0, 2, 2, 2), *unit = POLYGON(1, 1, 0, 1, 0, 0, 1, 0);
  static const uint32_t edges[] = {2, 3, 0, 1, 1, 2, 3, 0};
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  gcv_edge_source found[8];
  size_t required = 0, k;
  add(scene, square, 4, 4);
  region = free_region(scene, unit, NULL, NULL);
  CHECK(exact_region_is(region,
                        "outer 0/1 0/1, 9/1 0/1, 9/1 9/1, 0/1 9/1; "
                        "hole 3/1 3/1, 3/1 6/1, 6/1 6/1, 6/1 3/1"));
  CHECK_OK(gcv_region_edge_sources(region, found, 8, &required));
  CHECK(required == 8);
  for (k = 0; k < 8; ++k) {
    CHECK(found[k].a == edges[k] && found[k].b < 4);
    CHECK(found[k].kind == GCV_EDGE_TRANSLATED_CORNER ||
          (k < 4 && found[k].kind == GCV_EDGE_TRANSLATED));
    CHECK(k < 4 || found[k].b == (k - 4 == 3 ? 0 : 3 - (k - 4)));
  }
  gcv_region_destroy(region);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(unit);
}

/* A fit along a line, of several members one after the other, is cut where it meets the corners of
 * rings. Each piece is named by a member that makes it. */
static void owners_of_cut_segments(void) {
  gcv_polygon *room = POLYGON(9, -7, 14, 3, 2, 9), *moving = POLYGON(-5, -1, -3, -2, -4, 1);
  gcv_polygon *members[3] = {POLYGON(7, -1, 9, -2, 10, 0), POLYGON(5, 3, 9, 1, 6, 0),
                             POLYGON(10, 0, 11, 2, 9, 3)};
  const double at[3][2] = {{-2, 1}, {-2, 3}, {0, 0}};
  double vertices[64];
  uint64_t owners[32];
  size_t count = 0, k, found = 0;
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  for (k = 0; k < 3; ++k) {
    add(scene, members[k], at[k][0], at[k][1]);
    gcv_polygon_destroy(members[k]);
  }
  region = free_region(scene, moving, NULL, NULL);
  CHECK_OK(gcv_region_vertices(region, vertices, 32, &count));
  CHECK_OK(gcv_region_edge_owners(region, owners, 32, &count));
  for (k = 0; k + 1 < count; ++k) {
    const double *const p = vertices + 2 * k;
    if (p[0] == 12 && p[1] == 5 && p[2] == 16 && p[3] == 3) {
      ++found;
      CHECK(owners[k] == 4);
    }
  }
  CHECK(found == 1);
  gcv_region_destroy(region);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(moving);
}

int main(void) {
  containers_alone();
  members_in_a_room();
  members_in_one_place();
  members_across_the_container();
  exact_fits_between_members();
  holes_of_members();
  holes_that_touch_rounded_edges();
  queries();
  sources();
  owners_of_cut_segments();
  return check_failures != 0;
}

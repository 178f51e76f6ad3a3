/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The furthest free positions in scenes, worked out by hand.
 */
#include "free_regions.h"

static int best_is(const gcv_scene *scene, const gcv_polygon *moving, double dx, double dy,
                   const gcv_query *query, double x, double y) {
  const double direction[2] = {dx, dy};
  double out[2] = {77, 77};
  int32_t found = 77;
  CHECK_OK(gcv_scene_best(scene, moving, direction, query, NULL, out, &found));
  if (found == 1 && out[0] == x && out[1] == y) return 1;
  fprintf(stderr, "towards %g %g: found %d, %.17g %.17g\n", dx, dy, (int)found, out[0], out[1]);
  return 0;
}

static int has_no_best(const gcv_scene *scene, const gcv_polygon *moving,
                       const gcv_options *options) {
  const double direction[2] = {-1, 0};
  double out[2] = {77, 77};
  int32_t found = 77;
  CHECK_OK(gcv_scene_best(scene, moving, direction, NULL, options, out, &found));
  return found == 0 && out[0] == 0 && out[1] == 0;
}

/* Of several that are as far, the lexicographically smallest. */
static void in_a_square(void) {
  gcv_polygon *room = SQUARE(10), *unit = SQUARE(1), *square = SQUARE(2);
  gcv_scene *scene = scene_in(room);
  CHECK(best_is(scene, unit, -1, 0, NULL, 0, 0));
  CHECK(best_is(scene, unit, 0, -1, NULL, 0, 0));
  CHECK(best_is(scene, unit, 1, 0, NULL, 9, 0));
  CHECK(best_is(scene, unit, 0, 1, NULL, 0, 9));
  CHECK(best_is(scene, unit, 1, 1, NULL, 9, 9));
  CHECK(best_is(scene, unit, -1, 3, NULL, 0, 9));
  CHECK(best_is(scene, unit, -0x1p-1074, -0.0, NULL, 0, 0));
  CHECK(best_is(scene, unit, 1e308, -1e-308, NULL, 9, 0));
  CHECK(best_is(scene, unit, 1e308, 1e-308, NULL, 9, 9));
  /* In the corner, on the way, and along a side. */
  add(scene, square, 0, 0);
  CHECK(best_is(scene, unit, -1, 0, NULL, 0, 2));
  CHECK(best_is(scene, unit, 0, -1, NULL, 2, 0));
  CHECK(best_is(scene, unit, -1, -1, NULL, 0, 2));
  CHECK(best_is(scene, unit, -2, -1, NULL, 0, 2));
  CHECK(best_is(scene, unit, -1, -2, NULL, 2, 0));
  add(scene, square, 8, 8);
  CHECK(best_is(scene, unit, 1, 1, NULL, 7, 9));
  CHECK(best_is(scene, unit, 2, 1, NULL, 9, 7));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* Bottom-left: six squares fill the room, and there is no place for a seventh. */
static void one_after_another(void) {
  static const double places[6][2] = {{0, 0}, {0, 2}, {2, 0}, {2, 2}, {4, 0}, {4, 2}};
  gcv_polygon *room = POLYGON(0, 0, 6, 0, 6, 4, 0, 4), *square = SQUARE(2), *unit = SQUARE(1);
  gcv_scene *scene = scene_in(room);
  const uint64_t four = 4;
  size_t k;
  for (k = 0; k < 6; ++k) {
    CHECK(best_is(scene, square, -1, 0, NULL, places[k][0], places[k][1]));
    add(scene, square, places[k][0], places[k][1]);
  }
  /* Also when asked again, and not when one has gone. */
  for (k = 0; k < 2; ++k) {
    CHECK(has_no_best(scene, square, NULL));
    CHECK(has_no_best(scene, unit, NULL));
  }
  CHECK_OK(gcv_scene_remove(scene, &four, 1));
  CHECK(best_is(scene, square, -1, 0, NULL, 2, 0));
  CHECK(best_is(scene, square, 1, 1, NULL, 2, 0));
  CHECK(best_is(scene, unit, 1, 1, NULL, 3, 1));
  CHECK(has_no_best(scene, room, NULL));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(unit);
}

/* Directions whose products are no doubles, and what is far from the last answer, though as far in
 * the direction, nearly. */
static void tiny_directions(void) {
  static const double sizes[] = {1, 0x1p-1040};
  size_t k;
  for (k = 0; k < sizeof sizes / sizeof *sizes; ++k) {
    const double u = 0x1p-6 * sizes[k];
    gcv_polygon *room = SQUARE(31 * u), *small = SQUARE(2 * u), *corner = SQUARE(20 * u);
    gcv_polygon *beside = POLYGON(0, 0, 6 * u, 0, 6 * u, 19 * u, 0, 19 * u);
    gcv_polygon *above = POLYGON(0, 0, 31 * u, 0, 31 * u, 11 * u, 0, 11 * u);
    gcv_scene *scene = scene_in(room);
    add(scene, corner, 0, 0);
    add(scene, beside, 20 * u, 0);
    CHECK(best_is(scene, small, -0x1p-1074, -0x1p-1074, NULL, 0, 20 * u));
    add(scene, above, 0, 20 * u);
    CHECK(best_is(scene, small, -0x1p-1074, -0x1p-1074, NULL, 26 * u, 0));
    gcv_scene_destroy(scene);
    gcv_polygon_destroy(room);
    gcv_polygon_destroy(small);
    gcv_polygon_destroy(corner);
    gcv_polygon_destroy(beside);
    gcv_polygon_destroy(above);
  }
}

/* Segments and points are free, unless they are left out. */
static void exact_fits(void) {
  gcv_polygon *room = SQUARE(4), *square = SQUARE(2), *level = POLYGON(0, 0, 4, 0, 4, 1, 0, 1);
  gcv_polygon *big_room = SQUARE(20), *holed = polygon_of_rings(&frame);
  gcv_scene *scene = scene_in(room);
  gcv_options options = GCV_OPTIONS_INIT;
  const uint64_t three = 3;
  const double direction[2] = {3, 1};
  double out[2];
  int32_t found = 77;
  options.leave_out = GCV_LEAVE_OUT_FITS;
  CHECK(best_is(scene, room, -1, 0, NULL, 0, 0));
  CHECK(has_no_best(scene, room, &options));
  add(scene, level, 0, 2);
  CHECK(best_is(scene, square, -1, 0, NULL, 0, 0));
  CHECK(best_is(scene, square, 1, 0, NULL, 2, 0));
  CHECK(best_is(scene, square, 0, 1, NULL, 0, 0));
  CHECK(has_no_best(scene, square, &options));
  /* In the hole of a member, which is further than all other places; but for a moment. */
  CHECK_OK(gcv_scene_set_container(scene, big_room));
  move(scene, 2, 17, 0);
  add(scene, holed, 17, 17);
  CHECK(best_is(scene, square, 3, 1, NULL, 18, 18));
  CHECK_OK(gcv_scene_best(scene, square, direction, NULL, &options, out, &found));
  CHECK(found == 1 && out[0] == 18 && out[1] == 15);
  CHECK_OK(gcv_scene_remove(scene, &three, 1));
  CHECK(best_is(scene, square, 3, 1, NULL, 18, 18));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(level);
  gcv_polygon_destroy(big_room);
  gcv_polygon_destroy(holed);
}

static void queries(void) {
  gcv_polygon *room = SQUARE(10), *unit = SQUARE(1), *square = SQUARE(2);
  gcv_scene *scene = scene_in(room);
  const uint64_t two = 2, ignore[] = {3, 77, 2};
  const uint32_t layer = 4;
  gcv_query query = GCV_QUERY_INIT;
  add(scene, square, 0, 0);
  add(scene, square, 0, 2);
  CHECK_OK(gcv_scene_set_layers(scene, &two, &layer, 1));
  query.ignore = ignore;
  CHECK(best_is(scene, unit, -1, 0, &query, 0, 4));
  query.layers = 8;
  CHECK(best_is(scene, unit, -1, 0, &query, 0, 0));
  query.layers = 4;
  CHECK(best_is(scene, unit, -1, 0, &query, 0, 4));
  query.ignore_count = 1;
  CHECK(best_is(scene, unit, -1, 0, &query, 0, 2));
  query.ignore_count = 3;
  CHECK(best_is(scene, unit, -1, 0, &query, 0, 0));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* Where the exact position is no double, one near it is free; or there is none. */
static void positions_between_doubles(void) {
  const double step = 0x1p-52, off = 0x1p-60, left[2] = {-1, 0};
  const uint64_t two = 2;
  gcv_polygon *room = POLYGON(0.3, 0, 9, 0, 9, 9, 0.3, 9),
              *moving = POLYGON(0.1, 0, 1, 0, 1, 1, 0.1, 1);
  gcv_polygon *tiny_room = POLYGON(1, 0, 1 + step, 0, 1 + step, 1, 1, 1);
  gcv_polygon *tiny = POLYGON(off, 0, step + off, 0, step + off, 1, off, 1);
  gcv_scene *scene = scene_in(room);
  double out[2] = {77, 77};
  int32_t found = 77;
  int8_t relation = 77;
  CHECK_OK(gcv_scene_best(scene, moving, left, NULL, NULL, out, &found));
  CHECK(found == 1 && fabs(out[0] - 0.2) <= 0x1p-53 && out[1] == 0);
  CHECK_OK(gcv_scene_relation(scene, moving, out, 1, NULL, NULL, &relation));
  CHECK(relation == GCV_TOUCHING);
  /* Behind a member that ends at 0.3 + 0.2 + 1. */
  add(scene, moving, 0.2, 0);
  CHECK_OK(gcv_scene_best(scene, moving, left, NULL, NULL, out, &found));
  CHECK(found == 1 && fabs(out[0] - 0.2) <= 0x1p-53 && out[1] == 1);
  CHECK_OK(gcv_scene_relation(scene, moving, out, 1, NULL, NULL, &relation));
  CHECK(relation == GCV_TOUCHING);
  CHECK_OK(gcv_scene_set_container(scene, tiny_room));
  CHECK(has_no_best(scene, moving, NULL));
  CHECK(has_no_best(scene, tiny, NULL)); /* the member is there */
  CHECK_OK(gcv_scene_remove(scene, &two, 1));
  CHECK(best_is(scene, tiny, -1, 0, NULL, 1, 0));
  out[0] = 1;
  out[1] = 0;
  CHECK_OK(gcv_scene_relation(scene, tiny, out, 1, NULL, NULL, &relation));
  CHECK(relation == GCV_OVERLAPPING);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(tiny_room);
  gcv_polygon_destroy(tiny);
}

/* A hole that the square just fits, at 0.1 + 1, which no double is: what is furthest else, and the
 * nearest double where there is nothing else. */
static void fits_between_doubles(void) {
  static const double rings[16] = {0, 0, 6, 0, 6, 6, 0, 6, 1, 1, 5, 1, 5, 5, 1, 5};
  static const size_t sizes[2] = {4, 4};
  gcv_polygon *sheet = POLYGON(0, 0.1, 20, 0.1, 20, 20, 0, 20), *square = SQUARE(4);
  gcv_polygon *narrow = POLYGON(0, 0.1, 7, 0.1, 7, 7, 0, 7), *washer = NULL;
  const double position[2] = {1, 0.1 + 1};
  int8_t relation = 77;
  gcv_scene *scene = scene_in(sheet);
  CHECK_OK(gcv_polygon_create_rings(rings, sizes, 2, 0, &washer));
  add(scene, washer, 0, 0.1);
  CHECK(best_is(scene, square, -1, -1, NULL, 0, 0x1.8666666666667p2));
  CHECK_OK(gcv_scene_set_container(scene, narrow));
  CHECK(best_is(scene, square, -1, -1, NULL, position[0], position[1]));
  CHECK_OK(gcv_scene_relation(scene, square, position, 1, NULL, NULL, &relation));
  CHECK(relation == GCV_OVERLAPPING);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(sheet);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(narrow);
  gcv_polygon_destroy(washer);
}

/* A bar fits a slanted slot. It slides up to a wall, where no doubles show it, from (0, 0). */
static void slides_between_doubles(void) {
  gcv_polygon *slot = POLYGON(0, 0, 2018, 14, 2018, 15, 0, 1);
  gcv_polygon *bar = POLYGON(0, 0, 1009, 7, 1009, 8, 0, 1);
  gcv_polygon *wall = POLYGON(1509, 5, 1600, 5, 1600, 20, 1509, 20);
  gcv_scene *scene = scene_in(slot);
  CHECK(best_is(scene, bar, 1, 0, NULL, 1009, 7));
  add(scene, wall, 0, 0);
  CHECK(best_is(scene, bar, 1, 0, NULL, 0, 0));
  CHECK(best_is(scene, bar, -1, 0, NULL, 0, 0));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(slot);
  gcv_polygon_destroy(bar);
  gcv_polygon_destroy(wall);
}

/* A slot over a room, wider than the part by less than the gaps between doubles: no double shows
 * that it fits. Where the slot widens, doubles near its end do. */
static void passes_over_slivers(void) {
  gcv_polygon *room = POLYGON(0, 0, 10, 0, 10, 2, 0.2, 2, 0.2, 5, 0.1, 5, 0.1, 2, 0, 2);
  gcv_polygon *part = POLYGON(-1, 0, -0.9, 0, -0.9, 1, -1, 1);
  gcv_polygon *wedge = POLYGON(0.1, 0, 0.2, 0, 2.7, 5, 7, 5, 7, 6, 0.1, 6);
  gcv_polygon *flat = POLYGON(-1, 0, -0.9, 0, -0.9, 0.1, -1, 0.1);
  gcv_scene *scene = scene_in(room);
  const double down[2] = {0, -1};
  double out[2] = {77, 77};
  int32_t found = 77;
  int8_t relation = 77;
  CHECK(best_is(scene, part, 0, 1, NULL, 1, 1));
  CHECK(best_is(scene, part, 0, -1, NULL, 1, 0));
  CHECK_OK(gcv_scene_set_container(scene, wedge));
  CHECK_OK(gcv_scene_best(scene, flat, down, NULL, NULL, out, &found));
  CHECK(found == 1 && out[0] == 1.1 && out[1] > 0 && out[1] < 1e-15);
  CHECK_OK(gcv_scene_relation(scene, flat, out, 1, NULL, NULL, &relation));
  CHECK(relation != GCV_OVERLAPPING);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(part);
  gcv_polygon_destroy(wedge);
  gcv_polygon_destroy(flat);
}

static void what_is_refused(void) {
  static const double directions[][2] = {{0, 0}, {-0.0, 0}, {NAN, 1}, {1, INFINITY}};
  const uint64_t one = 1;
  const double left[2] = {-1, 0};
  gcv_polygon *room = SQUARE(10), *unit = SQUARE(1);
  gcv_polygon *far_room = POLYGON(1.6e308, 0, 1.7e308, 0, 1.7e308, 1e307, 1.6e308, 1e307);
  gcv_polygon *distant = POLYGON(-1.7e308, 0, -1.69e308, 0, -1.7e308, 1e306);
  gcv_scene *scene = new_scene();
  gcv_query query = GCV_QUERY_INIT;
  gcv_options options = GCV_OPTIONS_INIT;
  double out[2] = {77, 78};
  int32_t found = 79;
  size_t k;
#define BEST(moving, direction, query, options) \
  gcv_scene_best(scene, moving, direction, query, options, out, &found)
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "container", BEST(unit, left, NULL, NULL));
  CHECK_OK(gcv_scene_set_container(scene, room));
  for (k = 0; k < sizeof directions / sizeof *directions; ++k) {
    CHECK_REFUSED(k < 2 ? GCV_ERR_INVALID_ARGUMENT : GCV_ERR_NOT_FINITE, "direction",
                  BEST(unit, directions[k], NULL, NULL));
  }
  query.layers = 0;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "container", BEST(unit, left, &query, NULL));
  query.layers = UINT32_MAX;
  query.ignore = &one;
  query.ignore_count = 1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "container", BEST(unit, left, &query, NULL));
  query.struct_size = 0;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size", BEST(unit, left, &query, NULL));
  options.tolerance = 1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "tolerance", BEST(unit, left, NULL, &options));
  options.tolerance = 0;
  options.leave_out = GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "GCV_LEAVE_OUT_HOLES", BEST(unit, left, NULL, &options));
  CHECK_OK(gcv_scene_set_container(scene, far_room));
  for (k = 0; k < 2; ++k) CHECK_STATUS(GCV_ERR_RANGE, BEST(distant, left, NULL, NULL));
#undef BEST
  CHECK(out[0] == 77 && out[1] == 78 && found == 79);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(far_room);
  gcv_polygon_destroy(distant);
}

int main(void) {
  in_a_square();
  one_after_another();
  tiny_directions();
  exact_fits();
  queries();
  positions_between_doubles();
  fits_between_doubles();
  slides_between_doubles();
  passes_over_slivers();
  what_is_refused();
  return check_failures != 0;
}

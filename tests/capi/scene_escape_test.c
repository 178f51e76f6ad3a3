/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Ways out of overlaps in scenes, worked out by hand.
 */
#include "free_regions.h"

static gcv_escape escape_at(const gcv_scene *scene, const gcv_polygon *moving, double x, double y,
                            const gcv_query *query) {
  const double position[2] = {x, y};
  gcv_escape escape;
  memset(&escape, 0xff, sizeof escape);
  CHECK_OK(gcv_scene_penetration(scene, moving, position, 1, query, NULL, &escape));
  return escape;
}

static const gcv_contact no_contact;

static int is_none(const gcv_contact *contact) {
  return memcmp(contact, &no_contact, sizeof no_contact) == 0;
}

/* The way out leads by (vx, vy) to where the polygon touches that member. All numbers are exact. */
static int leads(const gcv_scene *scene, const gcv_polygon *moving, double x, double y,
                 const gcv_query *query, double vx, double vy, uint64_t id) {
  const gcv_escape e = escape_at(scene, moving, x, y, query);
  if (e.depth == hypot(vx, vy) && e.translation[0] == vx && e.translation[1] == vy &&
      e.position[0] == x + vx && e.position[1] == y + vy && e.relation == GCV_TOUCHING &&
      e.reserved == 0 && e.contact.id_a == id && e.contact.id_b == 0 && e.contact.gap == 0 &&
      (e.contact.kind == GCV_CONTACT_EDGE_VERTEX || e.contact.kind == GCV_CONTACT_VERTEX_EDGE)) {
    return 1;
  }
  fprintf(stderr, "from %g %g: depth %.17g, by %.17g %.17g to %.17g %.17g, relation %d, id %d\n", x,
          y, e.depth, e.translation[0], e.translation[1], e.position[0], e.position[1],
          (int)e.relation, (int)e.contact.id_a);
  return 0;
}

/* It is free there already. */
static int stays(const gcv_scene *scene, const gcv_polygon *moving, double x, double y,
                 const gcv_query *query, int relation) {
  const gcv_escape e = escape_at(scene, moving, x, y, query);
  return e.depth == 0 && e.translation[0] == 0 && e.translation[1] == 0 && e.position[0] == x &&
         e.position[1] == y && e.relation == relation && e.reserved == 0 && is_none(&e.contact);
}

static int is_stuck(const gcv_scene *scene, const gcv_polygon *moving, double x, double y,
                    const gcv_query *query) {
  const gcv_escape e = escape_at(scene, moving, x, y, query);
  return e.depth == INFINITY && e.translation[0] == 0 && e.translation[1] == 0 &&
         e.position[0] == x && e.position[1] == y && e.relation == GCV_OVERLAPPING &&
         e.reserved == 0 && is_none(&e.contact);
}

static void out_of_members(void) {
  gcv_polygon *unit = SQUARE(1), *square = SQUARE(2), *holed = polygon_of_rings(&frame);
  gcv_scene *scene = new_scene();
  gcv_escape e;
  CHECK(stays(scene, unit, 3, -4, NULL, GCV_APART));
  add(scene, square, 4, 4);
  CHECK(stays(scene, unit, 1, 1, NULL, GCV_APART));
  CHECK(stays(scene, unit, 3, 4.5, NULL, GCV_TOUCHING));
  CHECK(leads(scene, unit, 5, 5.25, NULL, 0, 0.75, 2));
  e = escape_at(scene, unit, 5, 5.25, NULL);
  CHECK(e.contact.kind == GCV_CONTACT_EDGE_VERTEX && e.contact.a == 2 && e.contact.b == 0);
  CHECK(e.contact.normal[0] == 0 && e.contact.normal[1] == 1);
  CHECK(e.contact.on_a[0] == 5 && e.contact.on_a[1] == 6);
  CHECK(e.contact.on_b[0] == 5 && e.contact.on_b[1] == 6);
  /* Of four that are as near, the lexicographically smallest. */
  CHECK(leads(scene, unit, 4.5, 4.5, NULL, -1.5, 0, 2));
  /* Out of two that overlap, at once. Of both that it touches, the smaller id. */
  add(scene, square, 5, 4);
  CHECK(leads(scene, unit, 4.25, 4.5, NULL, -1.25, 0, 2));
  CHECK(leads(scene, unit, 6, 4.5, NULL, 1, 0, 3));
  CHECK(leads(scene, unit, 5, 5.5, NULL, 0, 0.5, 2));
  CHECK(leads(scene, unit, 6.5, 5.75, NULL, 0, 0.25, 3));
  move(scene, 2, 7, 4);
  CHECK(leads(scene, unit, 6.5, 5.75, NULL, 0, 0.25, 2));
  /* Into an exact fit between them. */
  move(scene, 2, 8, 4);
  CHECK(leads(scene, unit, 6.75, 4.5, NULL, 0.25, 0, 2));
  CHECK(leads(scene, unit, 7.125, 4.5, NULL, -0.125, 0, 2));
  CHECK(stays(scene, unit, 7, 4.5, NULL, GCV_TOUCHING));
  /* Into the hole of a member. */
  add(scene, holed, 20, 20);
  CHECK(leads(scene, unit, 20.75, 21.5, NULL, 0.25, 0, 4));
  CHECK(leads(scene, square, 20.75, 21, NULL, 0.25, 0, 4));
  CHECK(leads(scene, unit, 20.75, 22.25, NULL, 0.25, -0.25, 4));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(holed);
}

static void into_containers(void) {
  gcv_polygon *room = SQUARE(10), *unit = SQUARE(1), *square = SQUARE(2), *large = SQUARE(11);
  gcv_scene *scene = scene_in(room);
  CHECK(stays(scene, unit, 9, 5, NULL, GCV_TOUCHING));
  CHECK(leads(scene, unit, 9.5, 5, NULL, -0.5, 0, 1));
  CHECK(leads(scene, unit, -3, -4, NULL, 3, 4, 1));
  CHECK(escape_at(scene, unit, 0x1p80, 4, NULL).depth == 0x1p80);
  CHECK(escape_at(scene, unit, 0x1p80, 4, NULL).position[0] == 9);
  CHECK(escape_at(scene, unit, 0x1p80, 4, NULL).relation == GCV_TOUCHING);
  CHECK(leads(scene, room, 3, 4, NULL, -3, -4, 1));
  CHECK(is_stuck(scene, large, 0, 0, NULL));
  CHECK(is_stuck(scene, large, 1e300, -5, NULL));
  /* A member at the wall, where the polygon overlaps both. */
  add(scene, square, 8, 4);
  CHECK(leads(scene, unit, 9.5, 5.5, NULL, -0.5, 0.5, 1));
  CHECK(leads(scene, unit, 8, 5.5, NULL, 0, 0.5, 2));
  /* Members that leave nothing free, and then a little. */
  add(scene, large, -1, -1);
  CHECK(is_stuck(scene, unit, 3, 3, NULL));
  CHECK(is_stuck(scene, unit, -30, 3, NULL));
  move(scene, 3, 1, -1);
  CHECK(leads(scene, unit, 3, 3, NULL, -3, 0, 1));
  CHECK(is_stuck(scene, square, 3, 3, NULL));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(large);
}

/* From many positions the ways lead to segments and points that were found once. What is touched at
 * the end of a segment is found from the edge that it begins with, which may be far behind. */
static void to_the_ends_of_segments(void) {
  gcv_polygon *room = POLYGON(0, 0, 4, 0, 4, 6, 0, 6);
  gcv_polygon *moving = POLYGON(0, 0, 2, 0, 2, 1, 0, 1);
  gcv_polygon *members[4] = {POLYGON(3, 1, 0, 0, 1, 2), POLYGON(0, 0, 1, 0, 1, 1),
                             POLYGON(0, 0, 4, 0, 4, 3, 3, 3, 3, 1, 1, 1, 1, 3, 0, 3),
                             POLYGON(2, 0, 1, 2, 1, 1)};
  const double at[4][2] = {{2, 0}, {2, 0}, {2, 3}, {1, 0}};
  enum { count = 16 };
  double positions[2 * count];
  gcv_escape ways[count];
  gcv_scene *scene = scene_in(room);
  for (int k = 0; k < 4; ++k) {
    add(scene, members[k], at[k][0], at[k][1]);
    gcv_polygon_destroy(members[k]);
  }
  for (int k = 0; k < count; ++k) {
    positions[2 * k] = k % 3 - 1;
    positions[2 * k + 1] = k % 2 == 0 ? 8 : -3;
  }
  CHECK_OK(gcv_scene_penetration(scene, moving, positions, count, NULL, NULL, ways));
  for (int k = 0; k < count; ++k) {
    const gcv_escape alone = escape_at(scene, moving, positions[2 * k], positions[2 * k + 1], NULL);
    CHECK(ways[k].position[0] == 0 && ways[k].position[1] == (k % 2 == 0 ? 5 : 0));
    CHECK(ways[k].contact.kind != 0 && ways[k].contact.id_a != 0);
    CHECK(memcmp(&ways[k], &alone, sizeof alone) == 0);
  }
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(moving);
}

static void queries_and_options(void) {
  gcv_polygon *room = SQUARE(10), *unit = SQUARE(1), *square = SQUARE(2);
  gcv_scene *scene = scene_in(room);
  const uint64_t two = 2, three = 3, ignore[] = {3, 1};
  const uint32_t layer = 4;
  const double origin[2] = {1, 1};
  gcv_query query = GCV_QUERY_INIT;
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_escape e;
  add(scene, square, 0, 0);
  add(scene, square, 0, 2);
  CHECK_OK(gcv_scene_set_layers(scene, &three, &layer, 1));
  query.ignore = ignore;
  CHECK(leads(scene, unit, 0, 1.5, &query, 2, 0, 2));
  query.layers = 3;
  CHECK(leads(scene, unit, 0, 1.5, &query, 0, 0.5, 1));
  query.layers = UINT32_MAX;
  query.ignore_count = 1;
  CHECK(leads(scene, unit, 0, 1.5, &query, 0, 0.5, 1));
  query.ignore_count = 2;
  CHECK(leads(scene, unit, 0, 1.5, &query, 0, 0.5, 2));
  CHECK(leads(scene, unit, 0, 0.25, &query, -1, 0, 2));
  CHECK(stays(scene, unit, -5, 0.25, &query, GCV_APART));
  query.layers = 0;
  CHECK(stays(scene, unit, 0, 0, &query, GCV_APART));
  /* Without fits, the room is too small for itself. */
  query.layers = 2;
  query.ignore = &two;
  query.ignore_count = 1;
  CHECK(leads(scene, room, 1, 1, &query, -1, -1, 1));
  options.leave_out = GCV_LEAVE_OUT_FITS;
  CHECK_OK(gcv_scene_penetration(scene, room, origin, 1, &query, &options, &e));
  CHECK(e.depth == INFINITY && e.relation == GCV_OVERLAPPING && e.position[0] == 1);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* A member alone is as a polygon, and many positions are as one. */
static void as_two_polygons(void) {
  enum { SIDE = 23, COUNT = SIDE * SIDE };
  static double positions[2 * COUNT];
  static gcv_escape alone[COUNT], in_scene[COUNT], by_threads[COUNT];
  gcv_polygon *holed = polygon_of_rings(&plate), *moving = POLYGON(0, 0, 1.5, 0.25, 2, 2, 0.25, 1);
  gcv_scene *scene = new_scene();
  gcv_options options = GCV_OPTIONS_INIT;
  size_t k;
  add(scene, holed, 0, 0);
  for (k = 0; k < COUNT; ++k) {
    positions[2 * k] = (double)(k % SIDE) * 0.4 - 2;
    positions[2 * k + 1] = (double)(k / SIDE) * 0.4 - 2;
  }
  CHECK_OK(gcv_penetration(holed, moving, positions, COUNT, NULL, alone));
  for (k = 0; k < COUNT; ++k) {
    if (alone[k].contact.kind != 0) alone[k].contact.id_a = 2;
    CHECK_OK(gcv_scene_penetration(scene, moving, positions + 2 * k, 1, NULL, NULL, in_scene + k));
  }
  CHECK(memcmp(alone, in_scene, sizeof alone) == 0);
  options.threads = 3;
  CHECK_OK(gcv_scene_penetration(scene, moving, positions, COUNT, NULL, &options, by_threads));
  CHECK(memcmp(alone, by_threads, sizeof alone) == 0);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(moving);
}

/* Sums of vertices and positions that are no doubles. */
static void coordinates_that_are_no_doubles(void) {
  const double even = 0x1p53;
  gcv_polygon *unit = SQUARE(1), *beside = POLYGON(0.1, 0, 1, 0, 1, 1, 0.1, 1);
  gcv_polygon *wall = POLYGON(-4, 0, 1, 0, 1, 100, -4, 100);
  gcv_scene *scene = new_scene();
  gcv_escape e;
  int8_t relation = 77;
  add(scene, beside, 0.2, 0);
  e = escape_at(scene, unit, -0.5, 0.25, NULL);
  CHECK(fabs(e.depth - 0.2) < 1e-15 && e.translation[0] == -e.depth && e.translation[1] == 0);
  CHECK(fabs(e.position[0] + 0.7) < 1e-15 && e.position[1] == 0.25);
  CHECK(e.relation != GCV_OVERLAPPING && e.contact.id_a == 2);
  CHECK_OK(gcv_scene_relation(scene, unit, e.position, 1, NULL, NULL, &relation));
  CHECK(relation == e.relation);
  /* An exact fit at 2^53 + 1. No double is free there. */
  add(scene, wall, even, 50);
  add(scene, wall, even + 6, 50);
  e = escape_at(scene, unit, even, 70, NULL);
  CHECK(e.depth == 1 && e.translation[0] == 1 && e.translation[1] == 0 && e.position[1] == 70);
  CHECK(e.position[0] == even || e.position[0] == even + 2);
  CHECK(e.relation == GCV_OVERLAPPING && e.contact.id_a == 3 && e.contact.gap == 0);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(beside);
  gcv_polygon_destroy(wall);
}

/* Searches cannot take these at another scale: it loses the small coordinates. They tell which way
 * is the shortest. */
static void tiny_beside_huge(void) {
  const double size = 0x1p600, tiny = 0x1p-1000;
  const double from[4][2] = {{tiny, 0}, {-tiny, 0}, {0, tiny}, {0, -tiny}};
  const double to[4][2] = {{size, 0}, {-size, 0}, {0, size}, {0, -size}};
  gcv_polygon *huge = SQUARE(size);
  gcv_escape ways[4];
  gcv_scene *scene = new_scene();
  add(scene, huge, 0, 0);
  CHECK_OK(gcv_penetration(huge, huge, &from[0][0], 4, NULL, ways));
  for (int k = 0; k < 4; ++k) {
    const gcv_escape e = escape_at(scene, huge, from[k][0], from[k][1], NULL);
    CHECK(memcmp(e.translation, to[k], sizeof to[k]) == 0);
    CHECK(memcmp(ways[k].translation, to[k], sizeof to[k]) == 0);
    CHECK(e.contact.id_a == 2 && e.contact.a == ways[k].contact.a);
  }
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(huge);
}

static void what_is_refused(void) {
  static const double good[] = {0, 0, 0, 0}, bad[] = {0, 0, 0, NAN}, far[] = {50, 50, 1, 1};
  gcv_polygon *unit = SQUARE(1);
  gcv_polygon *huge =
      POLYGON(-1.7e308, -1.7e308, 1.7e308, -1.7e308, 1.7e308, 1.7e308, -1.7e308, 1.7e308);
  gcv_scene *scene = new_scene(), *large = new_scene();
  gcv_query query = GCV_QUERY_INIT;
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_escape e[2];
  add(scene, unit, 0, 0);
  add(large, huge, 0, 0);
  e[0].depth = e[1].depth = 77;
  CHECK_OK(gcv_scene_penetration(scene, unit, NULL, 0, NULL, NULL, NULL));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "positions: number 1",
                gcv_scene_penetration(scene, unit, bad, 2, NULL, NULL, e));
  CHECK_REFUSED(GCV_ERR_RANGE, "positions: number 0",
                gcv_scene_penetration(large, huge, far, 2, NULL, NULL, e));
  query.struct_size = 0;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_penetration(scene, unit, good, 2, &query, NULL, e));
  query.struct_size = sizeof query;
  query.ignore_count = 1;
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "ignore",
                gcv_scene_penetration(scene, unit, good, 2, &query, NULL, e));
  options.tolerance = 1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "tolerance",
                gcv_scene_penetration(scene, unit, good, 2, NULL, &options, e));
  options.tolerance = 0;
  options.leave_out = GCV_LEAVE_OUT_HOLES;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "GCV_LEAVE_OUT_HOLES",
                gcv_scene_penetration(scene, unit, good, 2, NULL, &options, e));
  options.leave_out = 0;
  options.threads = -1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "threads",
                gcv_scene_penetration(scene, unit, good, 2, NULL, &options, e));
  CHECK(e[0].depth == 77 && e[1].depth == 77);
  gcv_scene_destroy(scene);
  gcv_scene_destroy(large);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(huge);
}

int main(void) {
  out_of_members();
  into_containers();
  to_the_ends_of_segments();
  queries_and_options();
  as_two_polygons();
  coordinates_that_are_no_doubles();
  tiny_beside_huge();
  what_is_refused();
  return check_failures != 0;
}

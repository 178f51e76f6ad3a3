/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * What a scene says of a polygon at positions: gcv_scene_relation, gcv_scene_distance,
 * gcv_scene_cast, on cases by hand.
 */
#include "regions.h"
#include "scenes.h"

static const gcv_contact no_contact;

/* The contact of nothing but an id. */
static int is_id(const gcv_contact *contact, uint64_t id) {
  gcv_contact expected = no_contact;
  expected.id_a = id;
  return memcmp(contact, &expected, sizeof expected) == 0;
}

/* One position: the relation, the distance, and the id that it is from. All functions agree. */
static int lies(const gcv_scene *scene, const gcv_polygon *moving, double x, double y,
                const gcv_query *query, int expected, double distance, uint64_t id) {
  const double position[2] = {x, y};
  int8_t relation = 77;
  gcv_separation s;
  CHECK_OK(gcv_scene_relation(scene, moving, position, 1, query, NULL, &relation));
  CHECK_OK(gcv_scene_distance(scene, moving, position, 1, query, NULL, &s));
  if (relation == expected && s.relation == expected && s.distance == distance &&
      s.nearest.id_a == id && s.nearest.id_b == 0 && s.reserved == 0 &&
      s.nearest.gap == (id == 0 ? 0 : distance) &&
      (s.nearest.kind != 0) == (expected == GCV_APART && id != 0) &&
      (s.nearest.kind != 0 || is_id(&s.nearest, id))) {
    return 1;
  }
  fprintf(stderr, "at %g %g: relations %d %d, distance %.17g, id %d\n", x, y, relation,
          (int)s.relation, s.distance, (int)s.nearest.id_a);
  return 0;
}

static void members_with_a_hole(void) {
  gcv_polygon *square = SQUARE(2), *holed = polygon_of_rings(&frame), *unit = SQUARE(1);
  gcv_scene *scene = new_scene();
  CHECK(add(scene, square, 0, 0) == 2);
  CHECK(add(scene, square, 6, 0) == 3);
  CHECK(add(scene, holed, 0, 6) == 4); /* its hole is from (1, 7) to (3, 9) */
  CHECK(lies(scene, unit, 2, 0, NULL, GCV_TOUCHING, 0, 2));
  CHECK(lies(scene, unit, 3, 0, NULL, GCV_APART, 1, 2));
  CHECK(lies(scene, unit, 4, 0, NULL, GCV_APART, 1, 3));
  CHECK(lies(scene, unit, 3.5, 0, NULL, GCV_APART, 1.5, 2));
  CHECK(lies(scene, unit, 1, 1, NULL, GCV_OVERLAPPING, 0, 2));
  CHECK(lies(scene, unit, 1.75, 7.5, NULL, GCV_APART, 0.25, 4));
  CHECK(lies(scene, unit, 1, 7, NULL, GCV_TOUCHING, 0, 4));
  CHECK(lies(scene, square, 1, 7, NULL, GCV_TOUCHING, 0, 4));
  CHECK(lies(scene, square, 1, 0x1.c000000000001p2, NULL, GCV_OVERLAPPING, 0, 4));
  CHECK(lies(scene, unit, 0, 5.5, NULL, GCV_OVERLAPPING, 0, 4));
  /* Between the first square and the frame: it touches both. */
  move(scene, 4, 0, 3);
  CHECK(lies(scene, unit, 0, 2, NULL, GCV_TOUCHING, 0, 2));
  CHECK(lies(scene, unit, -0.5, 2.5, NULL, GCV_OVERLAPPING, 0, 4));
  /* It touches the smaller id, and overlaps the larger one. */
  move(scene, 4, 0, 2.5);
  CHECK(lies(scene, unit, 0, 2, NULL, GCV_OVERLAPPING, 0, 2));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(square);
}

/* The contact is that of two polygons, where the member is. */
static void contacts_of_distances(void) {
  gcv_polygon *square = SQUARE(2), *unit = SQUARE(1);
  gcv_scene *scene = new_scene();
  const double position[] = {13, 10.5, 15, 16};
  gcv_separation s[2];
  add(scene, square, 30, 0);
  add(scene, square, 10, 10);
  CHECK_OK(gcv_scene_distance(scene, unit, position, 2, NULL, NULL, s));
  CHECK(s[0].distance == 1 && s[0].nearest.id_a == 3);
  CHECK(s[0].nearest.kind == GCV_CONTACT_EDGE_VERTEX && s[0].nearest.a == 1 && s[0].nearest.b == 0);
  CHECK(s[0].nearest.normal[0] == 1 && s[0].nearest.normal[1] == 0);
  CHECK(s[0].nearest.on_a[0] == 12 && s[0].nearest.on_a[1] == 10.5);
  CHECK(s[0].nearest.on_b[0] == 13 && s[0].nearest.on_b[1] == 10.5);
  CHECK(s[1].distance == 5 && s[1].nearest.id_a == 3);
  CHECK(s[1].nearest.kind == GCV_CONTACT_VERTEX_VERTEX && s[1].nearest.a == 2 &&
        s[1].nearest.b == 0);
  CHECK(s[1].nearest.on_a[0] == 12 && s[1].nearest.on_a[1] == 12);
  CHECK(s[1].nearest.on_b[0] == 15 && s[1].nearest.on_b[1] == 16);
  CHECK(s[1].nearest.reserved == 0);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

/* A room of 10 x 10 with a pillar from (4, 4) to (6, 6). */
static const struct rings room_with_pillar = {
    2, {4, 4}, {0, 0, 10, 0, 10, 10, 0, 10, 4, 4, 6, 4, 6, 6, 4, 6}};

static void containers(void) {
  static const double start[] = {1, 1}, motion[] = {10, 0};
  gcv_polygon *room = polygon_of_rings(&room_with_pillar), *unit = SQUARE(1), *square = SQUARE(2);
  gcv_polygon *small_room = SQUARE(3);
  gcv_scene *scene = new_scene();
  gcv_query query = GCV_QUERY_INIT;
  const uint64_t one = 1;
  const double near_pillar[] = {2, 2};
  gcv_impact impact;
  gcv_separation s;
  CHECK_OK(gcv_scene_set_container(scene, room));
  CHECK(lies(scene, unit, 0, 3, NULL, GCV_TOUCHING, 0, 1));
  CHECK(lies(scene, unit, 1, 1.5, NULL, GCV_APART, 1, 1));
  CHECK(lies(scene, unit, -0.5, 1, NULL, GCV_OVERLAPPING, 0, 1));
  CHECK(lies(scene, unit, 20, 20, NULL, GCV_OVERLAPPING, 0, 1));
  CHECK(lies(scene, unit, -1, 1, NULL, GCV_OVERLAPPING, 0, 1));
  CHECK(lies(scene, unit, 4.5, 4.5, NULL, GCV_OVERLAPPING, 0, 1));
  CHECK(lies(scene, square, 4, 4, NULL, GCV_OVERLAPPING, 0, 1));
  CHECK(lies(scene, unit, 3, 4, NULL, GCV_TOUCHING, 0, 1));
  CHECK(lies(scene, unit, 3, 3, NULL, GCV_TOUCHING, 0, 1));
  CHECK(lies(scene, unit, 2.5, 4, NULL, GCV_APART, 0.5, 1));
  CHECK(lies(scene, room, 0, 0, NULL, GCV_TOUCHING, 0, 1));
  CHECK_OK(gcv_scene_distance(scene, unit, near_pillar, 1, NULL, NULL, &s));
  CHECK(fabs(s.distance * s.distance - 2) < 1e-13 && s.nearest.id_a == 1);
  CHECK(s.nearest.kind == GCV_CONTACT_VERTEX_VERTEX && s.nearest.a == 4 && s.nearest.b == 2);
  CHECK(s.nearest.on_a[0] == 4 && s.nearest.on_b[0] == 3);
  CHECK_OK(gcv_scene_cast(scene, unit, start, motion, 1, NULL, NULL, &impact));
  CHECK(impact.hit == 1 && impact.time < 0.8 && impact.time > 0.79999999);
  CHECK(impact.position[0] == 9 && impact.position[1] == 1 && impact.relation == GCV_TOUCHING);
  CHECK(impact.contact.id_a == 1 && impact.contact.kind == GCV_CONTACT_EDGE_VERTEX);
  CHECK(impact.contact.a == 1 && impact.contact.b == 1 && impact.contact.normal[0] == -1);
  CHECK(impact.contact.on_a[0] == 10 && impact.contact.on_b[1] == 1);
  /* Without it, and with another one in its place. */
  query.ignore = &one;
  query.ignore_count = 1;
  CHECK(lies(scene, unit, 20, 20, &query, GCV_APART, HUGE_VAL, 0));
  query.ignore_count = 0;
  query.layers = 0;
  CHECK(lies(scene, unit, 20, 20, &query, GCV_APART, HUGE_VAL, 0));
  query.layers = 0x80000000U;
  CHECK(lies(scene, unit, 20, 20, &query, GCV_OVERLAPPING, 0, 1));
  CHECK_OK(gcv_scene_set_container(scene, small_room));
  CHECK(lies(scene, unit, 3, 0, NULL, GCV_OVERLAPPING, 0, 1));
  CHECK(lies(scene, unit, 2, 0, NULL, GCV_TOUCHING, 0, 1));
  CHECK_OK(gcv_scene_set_container(scene, NULL));
  CHECK(lies(scene, unit, 3, 0, NULL, GCV_APART, HUGE_VAL, 0));
  CHECK_OK(gcv_scene_set_container(scene, NULL));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(small_room);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(square);
}

static void nothing_there(void) {
  static const double positions[] = {1, 2, -3, 0.5}, motions[] = {10, -1, 0, 0};
  gcv_polygon *unit = SQUARE(1);
  gcv_scene *scene = new_scene();
  gcv_impact impacts[2];
  gcv_query query = GCV_QUERY_INIT;
  int k;
  CHECK(lies(scene, unit, 0, 0, NULL, GCV_APART, HUGE_VAL, 0));
  add(scene, unit, 1, 2);
  query.layers = 0;
  CHECK(lies(scene, unit, 1, 2, &query, GCV_APART, HUGE_VAL, 0));
  CHECK_OK(gcv_scene_cast(scene, unit, positions, motions, 2, &query, NULL, impacts));
  for (k = 0; k < 2; ++k) {
    CHECK(impacts[k].hit == 0 && impacts[k].time == 1 && impacts[k].relation == GCV_APART);
    CHECK(impacts[k].position[0] == positions[2 * k] + motions[2 * k]);
    CHECK(impacts[k].position[1] == positions[2 * k + 1] + motions[2 * k + 1]);
    CHECK(is_id(&impacts[k].contact, 0));
  }
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
}

static void ignored_members(void) {
  gcv_polygon *unit = SQUARE(1);
  gcv_scene *scene = new_scene();
  const uint64_t ignore[] = {4, 4711, 2, 2, 0, UINT64_MAX};
  gcv_query query = GCV_QUERY_INIT;
  add(scene, unit, 0, 0);
  add(scene, unit, 5, 0);
  add(scene, unit, 0.5, 0);
  query.ignore = ignore;
  CHECK(lies(scene, unit, 0, 0, &query, GCV_OVERLAPPING, 0, 2));
  query.ignore_count = 1;
  CHECK(lies(scene, unit, 0.25, 0, &query, GCV_OVERLAPPING, 0, 2));
  query.ignore_count = 6;
  CHECK(lies(scene, unit, 0.25, 0, &query, GCV_APART, 3.75, 3));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
}

struct case_of_cast {
  double start[2], motion[2];
  int32_t hit;
  double time;
  int32_t relation;
  uint64_t id;
  int32_t kind; /* of the contact */
};

/* Units at (4, 0) and (6, 2), (2, 2), and one that overlaps the last one. */
static void casts(void) {
  static const struct case_of_cast cases[] = {
      {{0, 0}, {4, 0}, 1, 0.75, GCV_TOUCHING, 2, GCV_CONTACT_VERTEX_VERTEX},
      {{0, 0}, {3, 0}, 0, 1, GCV_TOUCHING, 0, 0},
      {{0, 1}, {16, 0}, 0, 1, GCV_APART, 0, 0}, /* it slides along both */
      {{0, 0.5}, {-1, 0}, 0, 1, GCV_APART, 0, 0},
      {{2.25, 2}, {4, 0}, 1, 0, GCV_OVERLAPPING, 4, 0},
      {{3.25, 2.25}, {4, 0}, 1, 0, GCV_OVERLAPPING, 5, 0},
      {{4, 2}, {1, 0}, 0, 1, GCV_TOUCHING, 0, 0},
      {{4, 1.25}, {0, -1}, 1, 0.25, GCV_TOUCHING, 2, GCV_CONTACT_VERTEX_VERTEX},
      /* It enters both at once. */
      {{0, 4}, {4, -2}, 1, 0.5, GCV_TOUCHING, 4, GCV_CONTACT_VERTEX_VERTEX},
      /* It touches the smaller id, which it enters at once, and overlaps the larger one. */
      {{1, 2.75}, {1, 0}, 1, 0, GCV_OVERLAPPING, 4, GCV_CONTACT_EDGE_VERTEX},
  };
  gcv_polygon *unit = SQUARE(1);
  gcv_scene *scene = new_scene();
  size_t k;
  add(scene, unit, 4, 0);
  add(scene, unit, 6, 2);
  add(scene, unit, 2, 2);
  add(scene, unit, 2.5, 2);
  for (k = 0; k < sizeof cases / sizeof *cases; ++k) {
    const struct case_of_cast *c = &cases[k];
    gcv_impact impact;
    if (k == 9) add(scene, unit, 0.25, 3.5);
    CHECK_OK(gcv_scene_cast(scene, unit, c->start, c->motion, 1, NULL, NULL, &impact));
    if (!CHECK(impact.hit == c->hit && impact.time == c->time && impact.relation == c->relation &&
               impact.contact.id_a == c->id && impact.contact.kind == c->kind)) {
      fprintf(stderr, "case %d: hit %d at %.17g, relation %d, id %d, kind %d\n", (int)k, impact.hit,
              impact.time, impact.relation, (int)impact.contact.id_a, impact.contact.kind);
    }
    CHECK(impact.position[0] == c->start[0] + c->time * c->motion[0]);
    CHECK(impact.position[1] == c->start[1] + c->time * c->motion[1]);
    CHECK(c->kind != 0 || is_id(&impact.contact, c->id));
    CHECK(impact.contact.id_b == 0 && impact.contact.gap == 0);
  }
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
}

/* Two at the same time: the smaller id, whichever was moved there last. */
static void hits_at_the_same_time(void) {
  static const double start[] = {0, 0.5}, motion[] = {8, 0};
  gcv_polygon *unit = SQUARE(1);
  gcv_scene *scene = new_scene();
  gcv_impact impact;
  add(scene, unit, 9, 9);
  add(scene, unit, 5, 1);
  add(scene, unit, 5, 0);
  CHECK_OK(gcv_scene_cast(scene, unit, start, motion, 1, NULL, NULL, &impact));
  CHECK(impact.hit == 1 && impact.time == 0.5 && impact.contact.id_a == 3);
  CHECK(impact.relation == GCV_TOUCHING && impact.position[0] == 4);
  move(scene, 2, 5, -0.25);
  CHECK_OK(gcv_scene_cast(scene, unit, start, motion, 1, NULL, NULL, &impact));
  CHECK(impact.hit == 1 && impact.time == 0.5 && impact.contact.id_a == 2);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
}

/* Sums of vertices and positions that are no doubles: rounded, they would lie otherwise. */
static void coordinates_that_are_no_doubles(void) {
  const double tenth = 0.1, far = 1e16, even = 0x1p53;
  gcv_polygon *unit = SQUARE(1), *thin = POLYGON(0, 0, 0.1, 0, 0.1, 1, 0, 1);
  gcv_polygon *beside = POLYGON(tenth, 0, 1, 0, 1, 1, tenth, 1);
  gcv_polygon *before = POLYGON(0x1.9999999999999p-4, 0, 1, 0, 1, 1, 0x1.9999999999999p-4, 1);
  gcv_polygon *behind = POLYGON(0x1.999999999999bp-4, 0, 1, 0, 1, 1, 0x1.999999999999bp-4, 1);
  gcv_polygon *half = POLYGON(-0.5, 0, 0, 0, 0, 1, -0.5, 1);
  gcv_polygon *more = POLYGON(-1.5, 0, 0, 0, 0, 1, -1.5, 1);
  gcv_polygon *distant = POLYGON(1e16, 0, 1e16 + 2, 0, 1e16 + 2, 2, 1e16, 2);
  gcv_scene *scene = new_scene();
  add(scene, thin, far, 0);
  CHECK(lies(scene, beside, far, 0, NULL, GCV_TOUCHING, 0, 2));
  CHECK(lies(scene, before, far, 0, NULL, GCV_OVERLAPPING, 0, 2));
  CHECK(lies(scene, behind, far, 0, NULL, GCV_APART, 0x1p-56, 2));
  add(scene, unit, even, 50); /* it ends at 2^53 + 1 */
  CHECK(lies(scene, half, even + 2, 50, NULL, GCV_APART, 0.5, 3));
  CHECK(lies(scene, more, even + 2, 50, NULL, GCV_OVERLAPPING, 0, 3));
  /* Far away, and back again. */
  add(scene, distant, -far, -50);
  CHECK(lies(scene, unit, 2, -50, NULL, GCV_TOUCHING, 0, 4));
  CHECK(lies(scene, unit, 2.0000000000000004, -50, NULL, GCV_APART, 0x1p-51, 4));
  CHECK(lies(scene, unit, -1, -50, NULL, GCV_TOUCHING, 0, 4));
  CHECK(lies(scene, unit, -0.9999999999999999, -50, NULL, GCV_OVERLAPPING, 0, 4));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(thin);
  gcv_polygon_destroy(beside);
  gcv_polygon_destroy(before);
  gcv_polygon_destroy(behind);
  gcv_polygon_destroy(half);
  gcv_polygon_destroy(more);
  gcv_polygon_destroy(distant);
}

static void what_is_refused(void) {
  const double bad[] = {0, 0, 1, NAN}, good[] = {0, 0, 0, 0}, far[] = {0, 0, 1.7e308, 0};
  gcv_polygon *square = SQUARE(2), *distant = POLYGON(-1.7e308, 0, -1.6e308, 0, -1.7e308, 1e307);
  gcv_scene *scene = new_scene();
  gcv_query query = GCV_QUERY_INIT;
  gcv_options options = GCV_OPTIONS_INIT;
  int8_t relation[2] = {77, 77};
  gcv_separation separation[2];
  gcv_impact impact[2];
  separation[0].distance = impact[0].time = 77;
  CHECK_OK(gcv_scene_relation(scene, square, NULL, 0, NULL, NULL, NULL));
  CHECK_OK(gcv_scene_distance(scene, square, NULL, 0, NULL, NULL, NULL));
  CHECK_OK(gcv_scene_cast(scene, square, NULL, NULL, 0, NULL, NULL, NULL));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "positions: number 1",
                gcv_scene_relation(scene, square, bad, 2, NULL, NULL, relation));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "positions: number 1",
                gcv_scene_distance(scene, square, bad, 2, NULL, NULL, separation));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "positions: number 1",
                gcv_scene_cast(scene, square, bad, good, 2, NULL, NULL, impact));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "motions: number 1",
                gcv_scene_cast(scene, square, good, bad, 2, NULL, NULL, impact));
  add(scene, distant, 0, 0);
  CHECK_REFUSED(GCV_ERR_RANGE, "positions: number 1",
                gcv_scene_distance(scene, square, far, 2, NULL, NULL, separation));
  CHECK_OK(gcv_scene_relation(scene, square, far, 2, NULL, NULL, relation));
  CHECK(relation[0] == GCV_APART && relation[1] == GCV_APART);
  relation[0] = 77;
  query.struct_size = 0;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_relation(scene, square, good, 2, &query, NULL, relation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_distance(scene, square, good, 2, &query, NULL, separation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_cast(scene, square, good, good, 2, &query, NULL, impact));
  query.struct_size = sizeof query;
  query.ignore_count = 1;
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "ignore",
                gcv_scene_relation(scene, square, good, 2, &query, NULL, relation));
  options.threads = -1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "threads",
                gcv_scene_relation(scene, square, good, 2, NULL, &options, relation));
  CHECK(relation[0] == 77 && separation[0].distance == 77 && impact[0].time == 77);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(distant);
}

/* Queries of a later version, of which this library knows all that is set, or not. */
static void later_queries(void) {
  struct {
    gcv_query known;
    unsigned char later[16];
  } query = {GCV_QUERY_INIT, {0}};
  const double place[] = {0, 0};
  const uint64_t two = 2;
  gcv_polygon *square = SQUARE(2);
  gcv_scene *scene = new_scene();
  int8_t relation = 77;
  add(scene, square, 1, 1);
  query.known.struct_size = sizeof query;
  CHECK_OK(gcv_scene_relation(scene, square, place, 1, &query.known, NULL, &relation));
  CHECK(relation == GCV_OVERLAPPING);
  query.known.ignore = &two;
  query.known.ignore_count = 1;
  CHECK_OK(gcv_scene_relation(scene, square, place, 1, &query.known, NULL, &relation));
  CHECK(relation == GCV_APART);
  query.later[15] = 1;
  relation = 77;
  CHECK_STATUS(GCV_ERR_INVALID_ARGUMENT,
               gcv_scene_relation(scene, square, place, 1, &query.known, NULL, &relation));
  query.known.struct_size = sizeof query.known - 1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_relation(scene, square, place, 1, &query.known, NULL, &relation));
  CHECK(relation == 77);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
}

/* What is beyond the largest double does not matter where something else is nearer. */
static void only_the_nearest_must_be_in_range(void) {
  gcv_polygon *unit = SQUARE(1);
  gcv_scene *scene = new_scene();
  gcv_polygon *distant = POLYGON(-1.7e308, 0, -1.6e308, 0, -1.7e308, 1e307);
  add(scene, distant, -1e308, 0);
  add(scene, unit, 3, 0);
  CHECK(lies(scene, unit, 0, 0, NULL, GCV_APART, 2, 3));
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(distant);
}

int main(void) {
  members_with_a_hole();
  contacts_of_distances();
  containers();
  nothing_there();
  ignored_members();
  casts();
  hits_at_the_same_time();
  coordinates_that_are_no_doubles();
  what_is_refused();
  later_queries();
  only_the_nearest_must_be_in_range();
  return check_failures != 0;
}

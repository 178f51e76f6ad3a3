/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Scenes and their members: ids, changes, copies, and what is refused.
 */
#include "regions.h"
#include "scenes.h"

static struct record before;

static void remember(const gcv_scene *scene) {
  before.size = 0;
  put_scene(&before, scene);
}

/* The call is refused: the message has both parts, and the scene is as it was. */
#define CHANGE_REFUSED(status, part, other_part, scene, call)    \
  do {                                                           \
    remember(scene);                                             \
    CHECK_REFUSED(status, part, call);                           \
    CHECK(strstr(gcv_last_error_message(), other_part) != NULL); \
    CHECK(scene_is(scene, &before));                             \
  } while (0)

static void ids_are_never_used_again(void) {
  static const double positions[] = {0, 0, 3, 0};
  gcv_polygon *square = SQUARE(1);
  const gcv_polygon *both[2];
  gcv_scene *scene = new_scene();
  uint64_t ids[3] = {0}, gone[] = {2, 4, 5};
  size_t required = 77;
  both[0] = both[1] = square;
  CHECK_OK(gcv_scene_ids(scene, NULL, 0, &required));
  CHECK(required == 0);
  CHECK_OK(gcv_scene_ids(scene, ids, 1, &required));
  CHECK(required == 0 && ids[0] == 0);
  CHECK_OK(gcv_scene_add(scene, both, positions, 2, ids));
  CHECK(ids[0] == 2 && ids[1] == 3);
  CHECK(add(scene, square, 6, 0) == 4);
  CHECK_OK(gcv_scene_remove(scene, ids + 1, 1));
  CHECK(IDS_ARE(scene, 2, 4));
  CHECK(add(scene, square, 3, 0) == 5);
  CHECK(IDS_ARE(scene, 2, 4, 5));
  ids[0] = 77;
  CHECK_STATUS(GCV_ERR_BUFFER_TOO_SMALL, gcv_scene_ids(scene, ids, 2, &required));
  CHECK(required == 3 && ids[0] == 77);
  CHECK_OK(gcv_scene_ids(scene, NULL, 0, &required));
  CHECK(required == 3);
  CHECK_OK(gcv_scene_remove(scene, gone, 3));
  CHECK_OK(gcv_scene_ids(scene, NULL, 0, &required));
  CHECK(required == 0);
  CHECK(add(scene, square, 0, 0) == 6);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
}

static void copies_go_on_with_the_same_ids(void) {
  gcv_polygon *square = SQUARE(2), *room = SQUARE(20);
  gcv_scene *scene = new_scene(), *copy = NULL, *copy_of_copy = NULL;
  uint64_t two = 2, three = 3;
  const uint32_t layer = 2;
  add(scene, square, 0, 0);
  add(scene, square, 3, 0);
  CHECK_OK(gcv_scene_set_container(scene, room));
  CHECK_OK(gcv_scene_set_layers(scene, &two, &layer, 1));
  CHECK_OK(gcv_scene_remove(scene, &three, 1));
  remember(scene);
  CHECK_OK(gcv_scene_copy(scene, &copy));
  CHECK(scene_is(copy, &before));
  CHECK(add(scene, square, 5, 5) == 4);
  CHECK(scene_is(copy, &before));
  CHECK(add(copy, square, 6, 6) == 4);
  CHECK(IDS_ARE(scene, 2, 4) && IDS_ARE(copy, 2, 4));
  CHECK_OK(gcv_scene_remove(copy, &two, 1));
  CHECK(IDS_ARE(scene, 2, 4) && IDS_ARE(copy, 4));
  CHECK_OK(gcv_scene_set_container(copy, NULL));
  remember(copy);
  CHECK_OK(gcv_scene_copy(copy, &copy_of_copy));
  gcv_scene_destroy(scene);
  gcv_scene_destroy(copy);
  CHECK(scene_is(copy_of_copy, &before));
  CHECK(add(copy_of_copy, square, 0, 0) == 5);
  gcv_scene_destroy(copy_of_copy);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(room);
}

/* Of an empty scene, too. */
static void copies_of_nothing(void) {
  gcv_scene *scene = new_scene(), *copy = NULL;
  gcv_polygon *square = SQUARE(1);
  CHECK_OK(gcv_scene_copy(scene, &copy));
  CHECK(add(scene, square, 0, 0) == 2);
  CHECK(add(copy, square, 0, 0) == 2);
  gcv_scene_destroy(copy);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
}

/* Members 2, 4 and 5, and a container. */
static gcv_scene *scene_of_three(const gcv_polygon *square, const gcv_polygon *room) {
  gcv_scene *scene = new_scene();
  uint64_t three = 3;
  CHECK(add(scene, square, 0, 0) == 2 && add(scene, square, 4, 0) == 3);
  CHECK(add(scene, square, 1, 5) == 4 && add(scene, square, 2, 1) == 5);
  CHECK_OK(gcv_scene_remove(scene, &three, 1));
  CHECK_OK(gcv_scene_set_container(scene, room));
  return scene;
}

struct bad_ids {
  uint64_t ids[3];
  const char *number, *id; /* parts of the message */
};

static void ids_that_are_refused(void) {
  static const struct bad_ids cases[] = {{{2, 4711, 5}, "number 1", "4711"}, /* unknown */
                                         {{2, 5, 6}, "number 2", "6"},       /* the next one */
                                         {{3, 2, 4}, "number 0", "3"},       /* removed */
                                         {{2, 4, 1}, "number 2", "1"},       /* the container */
                                         {{5, 0, 2}, "number 1", "0"},       /* of none */
                                         {{4, 5, 4}, "number 2", "4"},       /* given twice */
                                         {{5, 5, 2}, "number 1", "5"},
                                         {{UINT64_MAX, 5, 2}, "number 0", "18446744073709551615"}};
  static const double positions[] = {8, 8, 9, 9, 7, 7};
  static const uint32_t layers[] = {1, 2, 4};
  gcv_polygon *square = SQUARE(2), *other = SQUARE(1), *room = SQUARE(20);
  const gcv_polygon *polygons[3];
  gcv_scene *scene = scene_of_three(square, room);
  gcv_polygon *out = NULL;
  size_t k;
  polygons[0] = polygons[1] = polygons[2] = other;
  for (k = 0; k < sizeof cases / sizeof *cases; ++k) {
    const uint64_t *ids = cases[k].ids;
    const char *number = cases[k].number, *id = cases[k].id;
    double xy[6] = {77, 77, 77, 77, 77, 77};
    CHANGE_REFUSED(GCV_ERR_INVALID_ARGUMENT, number, id, scene,
                   gcv_scene_set(scene, ids, polygons, positions, 3));
    CHANGE_REFUSED(GCV_ERR_INVALID_ARGUMENT, number, id, scene,
                   gcv_scene_set(scene, ids, NULL, NULL, 3));
    CHANGE_REFUSED(GCV_ERR_INVALID_ARGUMENT, number, id, scene,
                   gcv_scene_set(scene, ids, NULL, positions, 3));
    CHANGE_REFUSED(GCV_ERR_INVALID_ARGUMENT, number, id, scene,
                   gcv_scene_set_layers(scene, ids, layers, 3));
    CHANGE_REFUSED(GCV_ERR_INVALID_ARGUMENT, number, id, scene, gcv_scene_remove(scene, ids, 3));
    CHANGE_REFUSED(GCV_ERR_INVALID_ARGUMENT, number, id, scene,
                   gcv_scene_positions(scene, ids, 3, xy));
    CHECK(xy[0] == 77 && xy[5] == 77);
  }
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "4711", gcv_scene_polygon(scene, 4711, &out));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "3", gcv_scene_polygon(scene, 3, &out));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "1", gcv_scene_polygon(scene, 1, &out));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "0", gcv_scene_polygon(scene, 0, &out));
  CHECK(out == NULL && add(scene, square, 0, 0) == 6);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(other);
  gcv_polygon_destroy(room);
}

/* And that no id is lost by what is refused. */
static void arguments_that_are_refused(void) {
  static const double bad[][6] = {
      {0, 0, NAN, 0, 1, 1}, {0, 0, 0, INFINITY, 1, 1}, {9, 9, 1, -INFINITY, NAN, 1}};
  const double good[6] = {0, 0, 1, 1, 2, 2};
  gcv_polygon *square = SQUARE(2), *room = SQUARE(20);
  const gcv_polygon *polygons[3], *holey[3];
  gcv_scene *scene = scene_of_three(square, room);
  const uint64_t members[] = {5, 2, 4};
  uint64_t ids[3] = {77, 77, 77};
  size_t k;
  polygons[0] = polygons[1] = polygons[2] = holey[0] = holey[2] = square;
  holey[1] = NULL;
  for (k = 0; k < 3; ++k) {
    CHANGE_REFUSED(GCV_ERR_NOT_FINITE, "positions", "number 1", scene,
                   gcv_scene_add(scene, polygons, bad[k], 3, ids));
    CHANGE_REFUSED(GCV_ERR_NOT_FINITE, "positions", "number 1", scene,
                   gcv_scene_set(scene, members, NULL, bad[k], 3));
    CHANGE_REFUSED(GCV_ERR_NOT_FINITE, "positions", "number 1", scene,
                   gcv_scene_set(scene, members, polygons, bad[k], 3));
  }
  CHANGE_REFUSED(GCV_ERR_NULL_ARGUMENT, "polygons", "number 1", scene,
                 gcv_scene_set(scene, members, holey, NULL, 3));
  CHANGE_REFUSED(GCV_ERR_NULL_ARGUMENT, "polygons", "number 1", scene,
                 gcv_scene_set(scene, members, holey, good, 3));
  CHANGE_REFUSED(GCV_ERR_NULL_ARGUMENT, "polygons", "number 1", scene,
                 gcv_scene_add(scene, holey, good, 3, ids));
  CHECK(ids[0] == 77 && ids[1] == 77 && ids[2] == 77);
  CHECK(add(scene, square, 0, 0) == 6);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(room);
}

/* Nothing is read. */
static void no_members(void) {
  gcv_polygon *square = SQUARE(2), *room = SQUARE(20);
  gcv_scene *scene = scene_of_three(square, room);
  remember(scene);
  CHECK_OK(gcv_scene_add(scene, NULL, NULL, 0, NULL));
  CHECK_OK(gcv_scene_set(scene, NULL, NULL, NULL, 0));
  CHECK_OK(gcv_scene_set_layers(scene, NULL, NULL, 0));
  CHECK_OK(gcv_scene_remove(scene, NULL, 0));
  CHECK_OK(gcv_scene_positions(scene, NULL, 0, NULL));
  CHECK(scene_is(scene, &before));
  CHECK(add(scene, square, 0, 0) == 6);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(room);
}

static void what_set_keeps(void) {
  static const double positions[] = {7, 8, -1, 0.5};
  gcv_polygon *square = SQUARE(2), *other = POLYGON(0, 0, 3, 0, 0, 3), *room = SQUARE(20);
  gcv_polygon *out = NULL;
  const gcv_polygon *polygons[2];
  gcv_scene *scene = scene_of_three(square, room);
  const uint64_t ids[] = {5, 2}, all[] = {2, 4, 5};
  double xy[6];
  polygons[0] = other;
  polygons[1] = square;
  remember(scene);
  CHECK_OK(gcv_scene_set(scene, ids, NULL, NULL, 2));
  CHECK(scene_is(scene, &before));
  CHECK_OK(gcv_scene_set(scene, ids, NULL, positions, 2));
  CHECK_OK(gcv_scene_positions(scene, all, 3, xy));
  CHECK(same_ring(xy, 3, RING(-1, 0.5, 1, 5, 7, 8)));
  CHECK_OK(gcv_scene_set(scene, ids, polygons, NULL, 2));
  CHECK_OK(gcv_scene_positions(scene, ids, 2, xy));
  CHECK(same_ring(xy, 2, RING(7, 8, -1, 0.5)));
  CHECK_OK(gcv_scene_polygon(scene, 5, &out));
  CHECK(polygon_is(out, RING(0, 0, 3, 0, 0, 3)));
  gcv_polygon_destroy(out);
  CHECK_OK(gcv_scene_polygon(scene, 2, &out));
  CHECK(polygon_is(out, RING(0, 0, 2, 0, 2, 2, 0, 2)));
  gcv_polygon_destroy(out);
  /* Both at once, and to places where others were. */
  polygons[0] = square;
  polygons[1] = other;
  CHECK_OK(gcv_scene_set(scene, ids, polygons, positions + 2, 1));
  CHECK_OK(gcv_scene_set(scene, ids + 1, polygons + 1, positions, 1));
  CHECK_OK(gcv_scene_positions(scene, all, 3, xy));
  CHECK(same_ring(xy, 3, RING(7, 8, 1, 5, -1, 0.5)));
  CHECK_OK(gcv_scene_polygon(scene, 2, &out));
  CHECK(polygon_is(out, RING(0, 0, 3, 0, 0, 3)));
  gcv_polygon_destroy(out);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(other);
  gcv_polygon_destroy(room);
}

/* The scene keeps polygons whose handles have ended, with their holes and numbers. */
static void polygons_may_be_destroyed(void) {
  gcv_polygon *holed = polygon_of_rings(&frame), *square = SQUARE(1), *room = SQUARE(9),
              *out = NULL;
  const double place[] = {1.25, 1.5};
  gcv_scene *scene = new_scene();
  gcv_separation s;
  size_t rings = 0;
  uint64_t id = add(scene, holed, 0, 0);
  add(scene, holed, 4, 0);
  CHECK_OK(gcv_scene_set_container(scene, room));
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(room);
  CHECK_OK(gcv_scene_distance(scene, square, place, 1, NULL, NULL, &s));
  CHECK(s.relation == GCV_APART && s.distance == 0.25 && s.nearest.id_a == 2);
  CHECK_OK(gcv_scene_polygon(scene, id, &out));
  CHECK_OK(gcv_scene_remove(scene, &id, 1));
  gcv_scene_destroy(scene);
  CHECK_OK(gcv_polygon_ring_count(out, &rings));
  CHECK(rings == 2);
  CHECK(ring_is(out, 1, RING(1, 1, 1, 3, 3, 3, 3, 1)));
  gcv_polygon_destroy(out);
  gcv_polygon_destroy(square);
}

/* A member that has ended does not come back with the next one. */
static void layers_are_those_of_the_member(void) {
  gcv_polygon *square = SQUARE(2);
  gcv_scene *scene = new_scene();
  gcv_query query = GCV_QUERY_INIT;
  const double place[] = {0.5, 0.5};
  const uint32_t layers[] = {2, 0};
  uint64_t ids[2];
  int8_t relation = 77;
  ids[0] = add(scene, square, 0, 0);
  ids[1] = add(scene, square, 1, 0);
  query.layers = 1;
  CHECK_OK(gcv_scene_set_layers(scene, ids, layers, 2));
  CHECK_OK(gcv_scene_relation(scene, square, place, 1, &query, NULL, &relation));
  CHECK(relation == GCV_APART);
  move(scene, ids[0], 0.25, 0);
  CHECK_OK(gcv_scene_relation(scene, square, place, 1, &query, NULL, &relation));
  CHECK(relation == GCV_APART);
  query.layers = 6;
  CHECK_OK(gcv_scene_relation(scene, square, place, 1, &query, NULL, &relation));
  CHECK(relation == GCV_OVERLAPPING);
  CHECK_OK(gcv_scene_remove(scene, ids, 1));
  query.layers = UINT32_MAX; /* the other one is in no layer */
  CHECK_OK(gcv_scene_relation(scene, square, place, 1, &query, NULL, &relation));
  CHECK(relation == GCV_APART);
  CHECK_OK(gcv_scene_relation(scene, square, place, 1, NULL, NULL, &relation));
  CHECK(relation == GCV_APART);
  CHECK(add(scene, square, 0, 0) == 4);
  query.layers = 1;
  CHECK_OK(gcv_scene_relation(scene, square, place, 1, &query, NULL, &relation));
  CHECK(relation == GCV_OVERLAPPING);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
}

int main(void) {
  ids_are_never_used_again();
  copies_go_on_with_the_same_ids();
  copies_of_nothing();
  ids_that_are_refused();
  arguments_that_are_refused();
  no_members();
  what_set_keeps();
  polygons_may_be_destroyed();
  layers_are_those_of_the_member();
  return check_failures != 0;
}

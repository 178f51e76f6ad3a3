/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Lists of a scene: gcv_scene_near, gcv_scene_pairs, gcv_scene_contacts, and earlier lists.
 */
#include "regions.h"
#include "scenes.h"

static int pair_is(const gcv_pair *pair, uint64_t a, uint64_t b, int relation) {
  return pair->a == a && pair->b == b && pair->relation == relation && pair->reserved == 0;
}

/* Units at 0, 1, 3 and 2.5 on a line, the last one after the third. */
static gcv_scene *scene_in_line(const gcv_polygon *unit) {
  gcv_scene *scene = new_scene();
  CHECK(add(scene, unit, 0, 0) == 2 && add(scene, unit, 1, 0) == 3);
  CHECK(add(scene, unit, 3, 0) == 4 && add(scene, unit, 2.5, 0) == 5);
  return scene;
}

static size_t pairs_within(const gcv_scene *scene, double distance, const gcv_query *query,
                           gcv_pair *pairs) {
  gcv_pair_list *list = NULL;
  CHECK_OK(gcv_scene_pairs(scene, NULL, distance, query, NULL, &list));
  return take_pairs(list, pairs);
}

static void pairs_by_hand(void) {
  gcv_polygon *unit = SQUARE(1), *room = SQUARE(4);
  gcv_scene *scene = scene_in_line(unit);
  gcv_query query = GCV_QUERY_INIT;
  const uint64_t ignore[] = {4, 2}, four = 4;
  const uint32_t layer = 2;
  gcv_pair p[MOST_PAIRS];
  CHECK(pairs_within(scene, 0, NULL, p) == 2);
  CHECK(pair_is(&p[0], 2, 3, GCV_TOUCHING) && pair_is(&p[1], 4, 5, GCV_OVERLAPPING));
  CHECK(pairs_within(scene, 0.5, NULL, p) == 3);
  CHECK(pair_is(&p[0], 2, 3, GCV_TOUCHING) && pair_is(&p[1], 3, 5, GCV_APART));
  CHECK(pair_is(&p[2], 4, 5, GCV_OVERLAPPING));
  CHECK(pairs_within(scene, 0x1.fffffffffffffp-2, NULL, p) == 2);
  CHECK(pairs_within(scene, 2, NULL, p) == 6);
  CHECK(pair_is(&p[0], 2, 3, 0) && pair_is(&p[1], 2, 4, 1) && pair_is(&p[2], 2, 5, 1));
  CHECK(pair_is(&p[3], 3, 4, 1) && pair_is(&p[4], 3, 5, 1) && pair_is(&p[5], 4, 5, -1));
  CHECK(pairs_within(scene, 1.7e308, NULL, p) == 6);
  /* With a container, that touches the outer ones; one sticks out later. */
  CHECK_OK(gcv_scene_set_container(scene, room));
  CHECK(pairs_within(scene, 0, NULL, p) == 6);
  CHECK(pair_is(&p[0], 1, 2, 0) && pair_is(&p[1], 1, 3, 0) && pair_is(&p[2], 1, 4, 0));
  CHECK(pair_is(&p[3], 1, 5, 0) && pair_is(&p[4], 2, 3, 0));
  move(scene, 5, 2.5, -0.25);
  move(scene, 3, 1, 1);
  CHECK(pairs_within(scene, 0, NULL, p) == 5);
  CHECK(pair_is(&p[0], 1, 2, 0) && pair_is(&p[1], 1, 4, 0) && pair_is(&p[2], 1, 5, -1));
  CHECK(pair_is(&p[3], 2, 3, 0) && pair_is(&p[4], 4, 5, -1));
  query.ignore = ignore;
  query.ignore_count = 2;
  CHECK(pairs_within(scene, 0, &query, p) == 1 && pair_is(&p[0], 1, 5, -1));
  query.ignore_count = 0;
  query.layers = 2;
  CHECK(pairs_within(scene, 0, &query, p) == 5);
  CHECK_OK(gcv_scene_set_layers(scene, &four, &layer, 1));
  query.layers = 1;
  CHECK(pairs_within(scene, 0, &query, p) == 3 && pair_is(&p[1], 1, 5, -1));
  query.layers = 0;
  CHECK(pairs_within(scene, 5, &query, p) == 0);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(room);
}

static size_t near_by(const gcv_scene *scene, const gcv_polygon *moving, double x, double y,
                      double distance, gcv_pair *pairs) {
  const double position[2] = {x, y};
  gcv_pair_list *list = NULL;
  CHECK_OK(gcv_scene_near(scene, moving, position, distance, NULL, NULL, &list));
  return take_pairs(list, pairs);
}

static void near_by_hand(void) {
  gcv_polygon *unit = SQUARE(1), *room = SQUARE(4), *holed = polygon_of_rings(&frame);
  gcv_scene *scene = scene_in_line(unit);
  gcv_pair p[MOST_PAIRS];
  CHECK(near_by(scene, unit, 2, 1, 0, p) == 3);
  CHECK(pair_is(&p[0], 3, 0, 0) && pair_is(&p[1], 4, 0, 0) && pair_is(&p[2], 5, 0, 0));
  CHECK(near_by(scene, unit, 3.25, 0.5, 1.25, p) == 3);
  CHECK(pair_is(&p[0], 3, 0, 1) && pair_is(&p[1], 4, 0, -1) && pair_is(&p[2], 5, 0, -1));
  CHECK(near_by(scene, unit, 3.25, 0.5, 1.2499999999999998, p) == 2);
  /* Its corner is 5 off the corner of the last one. */
  CHECK(near_by(scene, unit, 7, 5, 4.999999999999999, p) == 0);
  CHECK(near_by(scene, unit, 7, 5, 5, p) == 1 && pair_is(&p[0], 4, 0, 1));
  CHECK_OK(gcv_scene_set_container(scene, room));
  CHECK(near_by(scene, unit, 1, 2.5, 0.5, p) == 1 && pair_is(&p[0], 1, 0, 1));
  CHECK(near_by(scene, unit, 1, 2.5, 0.25, p) == 0);
  CHECK(near_by(scene, unit, 50, 50, 1, p) == 1 && pair_is(&p[0], 1, 0, -1));
  /* In its hole. */
  add(scene, holed, 0, 0);
  CHECK(near_by(scene, unit, 1.5, 1.5, 0.5, p) == 3);
  CHECK(pair_is(&p[0], 3, 0, 1) && pair_is(&p[1], 5, 0, 1) && pair_is(&p[2], 6, 0, 1));
  CHECK(near_by(scene, unit, 1.5, 1.5, 0.25, p) == 0);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(room);
}

static int contact_is(const gcv_contact *c, uint64_t id_a, uint64_t id_b, int kind, uint32_t a,
                      uint32_t b, double gap) {
  return c->id_a == id_a && c->id_b == id_b && c->kind == kind && c->a == a && c->b == b &&
         c->gap == gap && c->reserved == 0;
}

static void contacts_by_hand(void) {
  static gcv_contact c[MOST_CONTACTS];
  gcv_polygon *unit = SQUARE(1), *room = SQUARE(4);
  gcv_scene *scene = new_scene();
  gcv_contact_list *list = NULL;
  uint64_t previous[8];
  size_t count = 0;
  add(scene, unit, 0.25, 0.125); /* on it lies the next one */
  add(scene, unit, 0.75, 1.125);
  CHECK_OK(gcv_scene_contacts(scene, NULL, 0, 0, NULL, NULL, &list));
  CHECK(get_contacts(list, c) == 2);
  CHECK(contact_is(&c[0], 2, 3, GCV_CONTACT_EDGE_VERTEX, 2, 0, 0));
  CHECK(contact_is(&c[1], 2, 3, GCV_CONTACT_VERTEX_EDGE, 2, 0, 0));
  CHECK(c[0].normal[0] == 0 && c[0].normal[1] == 1 && c[0].on_a[0] == 0.75 &&
        c[0].on_b[1] == 1.125);
  CHECK_OK(gcv_contact_list_previous(list, previous, 8, &count));
  CHECK(count == 2 && previous[0] == UINT64_MAX && previous[1] == UINT64_MAX);
  gcv_contact_list_destroy(list);
  /* The container is below and beside the first. */
  list = NULL;
  CHECK_OK(gcv_scene_set_container(scene, room));
  CHECK_OK(gcv_scene_contacts(scene, NULL, 0.25, 0, NULL, NULL, &list));
  CHECK(get_contacts(list, c) == 6);
  CHECK(contact_is(&c[0], 2, 3, GCV_CONTACT_EDGE_VERTEX, 2, 0, 0));
  CHECK(contact_is(&c[2], 1, 2, GCV_CONTACT_EDGE_VERTEX, 0, 0, 0.125));
  CHECK(contact_is(&c[3], 1, 2, GCV_CONTACT_EDGE_VERTEX, 0, 1, 0.125));
  CHECK(contact_is(&c[4], 1, 2, GCV_CONTACT_EDGE_VERTEX, 3, 0, 0.25));
  CHECK(contact_is(&c[5], 1, 2, GCV_CONTACT_EDGE_VERTEX, 3, 3, 0.25));
  CHECK(c[2].normal[0] == 0 && c[2].normal[1] == 1 && c[4].normal[0] == 1);
  CHECK(c[2].on_a[0] == 0.25 && c[2].on_a[1] == 0 && c[2].on_b[1] == 0.125);
  gcv_contact_list_destroy(list);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(room);
}

static void buffers(void) {
  gcv_polygon *unit = SQUARE(1);
  gcv_scene *scene = scene_in_line(unit);
  gcv_pair_list *list = NULL;
  gcv_pair pair = {77, 77, 77, 77};
  size_t required = 0;
  CHECK_OK(gcv_scene_pairs(scene, NULL, 0, NULL, NULL, &list));
  gcv_scene_destroy(scene);
  CHECK_OK(gcv_pair_list_pairs(list, NULL, 0, &required));
  CHECK(required == 2);
  required = 0;
  CHECK_STATUS(GCV_ERR_BUFFER_TOO_SMALL, gcv_pair_list_pairs(list, &pair, 1, &required));
  CHECK(required == 2 && pair.a == 77);
  gcv_pair_list_destroy(list);
  gcv_polygon_destroy(unit);
}

static void what_is_refused(void) {
  const double good[] = {0, 0}, bad[] = {0, NAN};
  gcv_polygon *unit = SQUARE(1);
  gcv_scene *scene = scene_in_line(unit), *other = scene_in_line(unit);
  gcv_pair_list *out = NULL, *of_other = NULL, *near = NULL;
  gcv_contact_list *contacts = NULL, *contacts_of_other = NULL;
  gcv_query query = GCV_QUERY_INIT;
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "position",
                gcv_scene_near(scene, unit, bad, 1, NULL, NULL, &out));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "distance",
                gcv_scene_near(scene, unit, good, NAN, NULL, NULL, &out));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "distance",
                gcv_scene_near(scene, unit, good, -1, NULL, NULL, &out));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "distance",
                gcv_scene_pairs(scene, NULL, INFINITY, NULL, NULL, &out));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "distance",
                gcv_scene_pairs(scene, NULL, -5e-324, NULL, NULL, &out));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "distance",
                gcv_scene_contacts(scene, NULL, NAN, 0, NULL, NULL, &contacts));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "distance",
                gcv_scene_contacts(scene, NULL, -1, 0, NULL, NULL, &contacts));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "slope",
                gcv_scene_contacts(scene, NULL, 0, INFINITY, NULL, NULL, &contacts));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "slope",
                gcv_scene_contacts(scene, NULL, 0, -1, NULL, NULL, &contacts));
  query.struct_size = 8;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_near(scene, unit, good, 1, &query, NULL, &out));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_pairs(scene, NULL, 1, &query, NULL, &out));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                gcv_scene_contacts(scene, NULL, 1, 0, &query, NULL, &contacts));
  /* Lists of a scene that only looks the same, of one polygon in it, and of two polygons. */
  CHECK_OK(gcv_scene_pairs(other, NULL, 1, NULL, NULL, &of_other));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "previous",
                gcv_scene_pairs(scene, of_other, 1, NULL, NULL, &out));
  CHECK_OK(gcv_scene_near(scene, unit, good, 1, NULL, NULL, &near));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "previous",
                gcv_scene_pairs(scene, near, 1, NULL, NULL, &out));
  CHECK_OK(gcv_scene_contacts(other, NULL, 1, 0, NULL, NULL, &contacts_of_other));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "previous",
                gcv_scene_contacts(scene, contacts_of_other, 1, 0, NULL, NULL, &contacts));
  gcv_contact_list_destroy(contacts_of_other);
  CHECK_OK(gcv_contacts(unit, unit, good, 0, 0, NULL, &contacts_of_other));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "previous",
                gcv_scene_contacts(scene, contacts_of_other, 1, 0, NULL, NULL, &contacts));
  CHECK(out == NULL && contacts == NULL);
  gcv_contact_list_destroy(contacts_of_other);
  gcv_pair_list_destroy(of_other);
  gcv_pair_list_destroy(near);
  gcv_scene_destroy(scene);
  gcv_scene_destroy(other);
  gcv_polygon_destroy(unit);
}

/* Lists of copies go both ways, and outlive their scene. */
static void lists_of_copies(void) {
  gcv_polygon *unit = SQUARE(1);
  gcv_scene *scene = scene_in_line(unit), *copy = NULL, *copy_of_copy = NULL;
  gcv_pair_list *first = NULL, *second = NULL, *third = NULL;
  gcv_pair p[MOST_PAIRS];
  CHECK_OK(gcv_scene_pairs(scene, NULL, 0, NULL, NULL, &first));
  CHECK_OK(gcv_scene_copy(scene, &copy));
  /* Both go on by themselves: the same id is another member in each. */
  add(scene, unit, 4, 0);
  add(copy, unit, 1.5, 1);
  CHECK_OK(gcv_scene_pairs(scene, first, 0, NULL, NULL, &second));
  gcv_scene_destroy(scene);
  CHECK_OK(gcv_scene_copy(copy, &copy_of_copy));
  CHECK_OK(gcv_scene_pairs(copy, second, 0, NULL, NULL, &third));
  gcv_pair_list_destroy(second);
  CHECK(take_pairs(third, p) == 4);
  CHECK(pair_is(&p[0], 2, 3, 0) && pair_is(&p[1], 3, 6, 0) && pair_is(&p[2], 4, 5, -1));
  CHECK(pair_is(&p[3], 5, 6, 0));
  move(copy, 3, -1, 0);
  second = third = NULL;
  CHECK_OK(gcv_scene_pairs(copy, first, 0, NULL, NULL, &second));
  CHECK_OK(gcv_scene_pairs(copy_of_copy, second, 0, NULL, NULL, &third));
  CHECK(take_pairs(second, p) == 3 && pair_is(&p[0], 2, 3, 0) && pair_is(&p[2], 5, 6, 0));
  CHECK(take_pairs(third, p) == 4 && pair_is(&p[1], 3, 6, 0));
  gcv_pair_list_destroy(first);
  gcv_scene_destroy(copy);
  gcv_scene_destroy(copy_of_copy);
  gcv_polygon_destroy(unit);
}

/* ------------------------------------------------------------------ random changes -- */

static uint64_t state = 1;

/* 0, ..., count - 1. */
static unsigned below(unsigned count) {
  state = state * 6364136223846793005U + 1442695040888963407U;
  return (unsigned)(state >> 33) % count;
}

enum { SHAPES = 4 };

/* Its id; 0 where there is none. */
static uint64_t any_member(const gcv_scene *scene) {
  uint64_t ids[MOST_MEMBERS];
  size_t count = 0;
  CHECK_OK(gcv_scene_ids(scene, ids, MOST_MEMBERS, &count));
  return count == 0 ? 0 : ids[below((unsigned)count)];
}

static void change(gcv_scene *scene, gcv_polygon *const *shapes) {
  const double x = below(33) / 4.0 - 4, y = below(33) / 4.0 - 4;
  const double position[2] = {x, y};
  const gcv_polygon *shape = shapes[below(SHAPES)];
  const uint32_t layers = below(4);
  const uint64_t id = any_member(scene);
  uint64_t new_id;
  size_t count = 0;
  CHECK_OK(gcv_scene_ids(scene, NULL, 0, &count));
  switch (count == 0 ? 0 : below(7)) {
    case 0:
    case 1:
      if (count < 10) CHECK_OK(gcv_scene_add(scene, &shape, position, 1, &new_id));
      break;
    case 2:
      CHECK_OK(gcv_scene_remove(scene, &id, 1));
      break;
    case 3:
      CHECK_OK(gcv_scene_set(scene, &id, &shape, NULL, 1));
      break;
    case 4:
      CHECK_OK(gcv_scene_set_layers(scene, &id, &layers, 1));
      break;
    case 5:
      CHECK_OK(gcv_scene_set_container(scene, below(3) == 0 ? NULL : shapes[below(SHAPES)]));
      break;
    default:
      CHECK_OK(gcv_scene_set(scene, &id, NULL, position, 1));
  }
}

static int same_contact(const gcv_contact *c, const gcv_contact *d) {
  return c->id_a == d->id_a && c->id_b == d->id_b && c->kind == d->kind && c->a == d->a &&
         c->b == d->b;
}

static uint64_t index_of(const gcv_contact *contact, const gcv_contact *list, size_t count) {
  size_t k;
  for (k = 0; k < count; ++k) {
    if (same_contact(contact, &list[k])) return k;
  }
  return UINT64_MAX;
}

/* The list with the earlier one is as without, and every contact has its index. Gives the new
 * list, and ends the earlier one. */
static gcv_contact_list *next_contacts(const gcv_scene *scene, gcv_contact_list *previous,
                                       double distance, double slope, const gcv_query *query) {
  static gcv_contact before[MOST_CONTACTS], with[MOST_CONTACTS], without[MOST_CONTACTS];
  static uint64_t indices[MOST_CONTACTS];
  gcv_contact_list *list = NULL, *list_without = NULL;
  size_t count_before = previous == NULL ? 0 : get_contacts(previous, before), count, required, k;
  CHECK_OK(gcv_scene_contacts(scene, previous, distance, slope, query, NULL, &list));
  CHECK_OK(gcv_scene_contacts(scene, NULL, distance, slope, query, NULL, &list_without));
  count = get_contacts(list, with);
  CHECK(count == get_contacts(list_without, without));
  CHECK(memcmp(with, without, count * sizeof *with) == 0);
  CHECK_OK(gcv_contact_list_previous(list, indices, MOST_CONTACTS, &required));
  CHECK(required == count);
  for (k = 0; k < count; ++k) {
    if (!CHECK(indices[k] == index_of(&with[k], before, count_before))) break;
  }
  CHECK_OK(gcv_contact_list_previous(list_without, indices, MOST_CONTACTS, &required));
  for (k = 0; k < count; ++k) {
    if (!CHECK(indices[k] == UINT64_MAX)) break;
  }
  gcv_contact_list_destroy(list_without);
  gcv_contact_list_destroy(previous);
  return list;
}

/* Gives the new list, and ends the earlier one. */
static gcv_pair_list *next_pairs(const gcv_scene *scene, gcv_pair_list *previous, double distance,
                                 const gcv_query *query) {
  gcv_pair with[MOST_PAIRS], without[MOST_PAIRS];
  gcv_pair_list *list = NULL, *list_without = NULL;
  size_t count = 0;
  CHECK_OK(gcv_scene_pairs(scene, previous, distance, query, NULL, &list));
  CHECK_OK(gcv_scene_pairs(scene, NULL, distance, query, NULL, &list_without));
  CHECK_OK(gcv_pair_list_pairs(list, with, MOST_PAIRS, &count));
  CHECK(count == take_pairs(list_without, without));
  CHECK(memcmp(with, without, count * sizeof *with) == 0);
  gcv_pair_list_destroy(previous);
  return list;
}

/* Most lists have the distance and the query of the one before. Now and then the scene is changed
 * for a copy of it. */
static void random_changes(void) {
  gcv_polygon *shapes[SHAPES];
  gcv_scene *scene = new_scene(), *copy = NULL;
  gcv_contact_list *contacts = NULL;
  gcv_pair_list *pairs = NULL;
  gcv_query query = GCV_QUERY_INIT;
  uint64_t ignore[2] = {3, 1};
  double distance = 0.5, slope = 0;
  int round, k;
  shapes[0] = SQUARE(1);
  shapes[1] = POLYGON(0, 0, 2, 0, 0, 2);
  shapes[2] = polygon_of_rings(&frame);
  shapes[3] = POLYGON(-4, -4, 8, -4, 8, 8, -4, 8);
  query.ignore = ignore;
  for (round = 0; round < 400; ++round) {
    for (k = (int)below(4); k > 0; --k) change(scene, shapes);
    if (below(8) == 0) {
      distance = below(9) / 4.0;
      slope = below(2) / 8.0;
      query.layers = below(3) == 0 ? 1 + below(3) : UINT32_MAX;
      query.ignore_count = below(3);
      ignore[0] = 2 + below(8);
    }
    if (below(16) == 0) {
      CHECK_OK(gcv_scene_copy(scene, &copy));
      gcv_scene_destroy(scene);
      scene = copy;
    }
    contacts = next_contacts(scene, contacts, distance, slope, &query);
    pairs = next_pairs(scene, pairs, distance, below(8) == 0 ? NULL : &query);
    if (check_failures > 0) {
      fprintf(stderr, "after %d rounds\n", round);
      break;
    }
  }
  gcv_contact_list_destroy(contacts);
  gcv_pair_list_destroy(pairs);
  gcv_scene_destroy(scene);
  for (k = 0; k < SHAPES; ++k) gcv_polygon_destroy(shapes[k]);
}

int main(void) {
  pairs_by_hand();
  near_by_hand();
  contacts_by_hand();
  buffers();
  what_is_refused();
  lists_of_copies();
  random_changes();
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Short ways to make scenes, and a record of all that there is to know of one, byte by byte.
 */
#ifndef GCV_TESTS_CAPI_SCENES_H
#define GCV_TESTS_CAPI_SCENES_H

#include "record.h"

enum { MOST_MEMBERS = 32, MOST_PAIRS = 512, MOST_CONTACTS = 8192 };

static inline gcv_scene *new_scene(void) {
  gcv_scene *scene = NULL;
  CHECK_OK(gcv_scene_create(&scene));
  return scene;
}

/* Gives its id. */
static inline uint64_t add(gcv_scene *scene, const gcv_polygon *polygon, double x, double y) {
  const double position[2] = {x, y};
  uint64_t id = 0;
  CHECK_OK(gcv_scene_add(scene, &polygon, position, 1, &id));
  return id;
}

static inline void move(gcv_scene *scene, uint64_t id, double x, double y) {
  const double position[2] = {x, y};
  CHECK_OK(gcv_scene_set(scene, &id, NULL, position, 1));
}

/* Are these the ids, no more and no fewer? */
static inline int ids_are(const gcv_scene *scene, const uint64_t *expected, size_t count) {
  uint64_t ids[MOST_MEMBERS] = {0};
  size_t required = 0;
  CHECK_OK(gcv_scene_ids(scene, ids, MOST_MEMBERS, &required));
  return required == count && memcmp(ids, expected, count * sizeof *ids) == 0;
}
#define IDS_ARE(scene, ...)                       \
  ids_are(scene, (const uint64_t[]){__VA_ARGS__}, \
          sizeof((const uint64_t[]){__VA_ARGS__}) / sizeof(uint64_t))

/* The pairs of a list, which is ended: their number. */
static inline size_t take_pairs(gcv_pair_list *list, gcv_pair *pairs) {
  size_t count = 0;
  CHECK_OK(gcv_pair_list_pairs(list, pairs, MOST_PAIRS, &count));
  gcv_pair_list_destroy(list);
  return count;
}

/* The contacts of a list: their number. */
static inline size_t get_contacts(const gcv_contact_list *list, gcv_contact *contacts) {
  size_t count = 0;
  CHECK_OK(gcv_contact_list_contacts(list, contacts, MOST_CONTACTS, &count));
  return count;
}

static inline void put_pairs(struct record *record, const gcv_pair_list *list) {
  gcv_pair pairs[MOST_PAIRS];
  size_t count = 0;
  if (put_status(record, gcv_pair_list_pairs(list, pairs, MOST_PAIRS, &count))) {
    put(record, pairs, count * sizeof *pairs);
  }
}

static inline void put_contacts(struct record *record, const gcv_contact_list *list) {
  gcv_contact *contacts = malloc(MOST_CONTACTS * sizeof *contacts);
  size_t count = 0;
  if (contacts == NULL) abort();
  if (put_status(record, gcv_contact_list_contacts(list, contacts, MOST_CONTACTS, &count))) {
    put(record, contacts, count * sizeof *contacts);
  }
  free(contacts);
}

static inline void put_members(struct record *record, const gcv_scene *scene) {
  uint64_t ids[MOST_MEMBERS];
  double xy[2 * MOST_MEMBERS];
  size_t count = 0, k;
  if (!put_status(record, gcv_scene_ids(scene, ids, MOST_MEMBERS, &count))) return;
  put(record, ids, count * sizeof *ids);
  if (put_status(record, gcv_scene_positions(scene, ids, count, xy))) {
    put(record, xy, count * 2 * sizeof *xy);
  }
  for (k = 0; k < count; ++k) {
    gcv_polygon *polygon = NULL;
    if (put_status(record, gcv_scene_polygon(scene, ids[k], &polygon))) {
      put_polygon(record, polygon);
    }
    gcv_polygon_destroy(polygon);
  }
}

/* Where the polygon is free, with one query. Without a container there is no best position. */
static inline void put_free(struct record *record, const gcv_scene *scene,
                            const gcv_polygon *moving, const gcv_query *query) {
  static const double places[] = {0, 0, 3, 0.1, -7, 2, 1e9, 0.3};
  static const double window[] = {-10, -10, 10, 9.9}, direction[] = {-1, 0.25};
  gcv_region *region = NULL;
  gcv_escape escapes[4];
  double best[2];
  int32_t found = 0;
  if (put_status(record, gcv_scene_free_region(scene, moving, window, query, NULL, &region))) {
    put_region(record, region);
  }
  gcv_region_destroy(region);
  if (put_status(record, gcv_scene_best(scene, moving, direction, query, NULL, best, &found))) {
    put(record, best, sizeof best);
    put(record, &found, sizeof found);
  }
  if (put_status(record, gcv_scene_penetration(scene, moving, places, 4, query, NULL, escapes))) {
    put(record, escapes, sizeof escapes);
  }
}

/* What the scene answers about itself and about a polygon, with one query. */
static inline void put_answers(struct record *record, const gcv_scene *scene,
                               const gcv_polygon *moving, const gcv_query *query) {
  static const double places[] = {0, 0, 3, 0.1, -7, 2, 1e16, 0.3};
  static const double motions[] = {9, 1, -5, 0, 20, 0.5, -1, 4};
  int8_t relations[4];
  gcv_separation separations[4];
  gcv_impact impacts[4];
  gcv_pair_list *pairs = NULL, *near = NULL;
  gcv_contact_list *contacts = NULL;
  if (put_status(record, gcv_scene_relation(scene, moving, places, 4, query, NULL, relations))) {
    put(record, relations, sizeof relations);
  }
  if (put_status(record, gcv_scene_distance(scene, moving, places, 4, query, NULL, separations))) {
    put(record, separations, sizeof separations);
  }
  if (put_status(record, gcv_scene_cast(scene, moving, places, motions, 4, query, NULL, impacts))) {
    put(record, impacts, sizeof impacts);
  }
  if (put_status(record, gcv_scene_near(scene, moving, places, 5, query, NULL, &near))) {
    put_pairs(record, near);
  }
  if (put_status(record, gcv_scene_pairs(scene, NULL, 100, query, NULL, &pairs))) {
    put_pairs(record, pairs);
  }
  if (put_status(record, gcv_scene_contacts(scene, NULL, 1, 0.125, query, NULL, &contacts))) {
    put_contacts(record, contacts);
  }
  put_free(record, scene, moving, query);
  gcv_pair_list_destroy(near);
  gcv_pair_list_destroy(pairs);
  gcv_contact_list_destroy(contacts);
}

/* Layers show in the answers. */
static inline void put_scene(struct record *record, const gcv_scene *scene) {
  static const double xy[] = {0, 0, 1, 0, 0.5, 1.5};
  gcv_query query = GCV_QUERY_INIT;
  gcv_polygon *moving = NULL;
  put_members(record, scene);
  if (put_status(record, gcv_polygon_create(xy, 3, 0, &moving))) {
    put_answers(record, scene, moving, NULL);
    for (query.layers = 1; query.layers <= 4; query.layers *= 2) {
      put_answers(record, scene, moving, &query);
    }
  }
  gcv_polygon_destroy(moving);
}

/* Is the scene as the record has it? */
static inline int scene_is(const gcv_scene *scene, const struct record *expected) {
  static struct record now;
  now.size = 0;
  put_scene(&now, scene);
  return now.size == expected->size && memcmp(now.bytes, expected->bytes, now.size) == 0;
}

#endif

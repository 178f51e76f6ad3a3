/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Eight threads share const handles, and all compute the same bits.
 */
#include <pthread.h>

#include "scenes.h"

enum { THREADS = 8, ROUNDS = 2 };

static gcv_polygon *polygons[PAIRS][2];
static gcv_outer_face *shared_face;
static gcv_region *shared_region;
static gcv_scene *shared_scene;

static void put_everything(struct record *record) {
  int pair;
  for (pair = 0; pair < PAIRS; ++pair) {
    put_pair(record, polygons[pair][0], polygons[pair][1], pair_tolerances[pair]);
  }
  put_face(record, shared_face);
  put_region(record, shared_region);
  put_scene(record, shared_scene);
  put_others(record);
  put_refusals(record);
}

/* Members that touch, overlap and contain others, at places where they have no doubles. */
static gcv_scene *scene_of_all(void) {
  static const double positions[] = {0, 0, 0.1, 2, 4, 0, -3, 1, 3, 0.5, 1e16, 0};
  static const uint32_t layers[] = {1, 3};
  static const uint64_t ids[] = {3, 4};
  const gcv_polygon *members[6];
  uint64_t new_ids[6];
  gcv_polygon *room = POLYGON(-20, -20, 20, -20, 20.1, 20, -20, 20);
  gcv_scene *scene = new_scene();
  int k;
  for (k = 0; k < 6; ++k) members[k] = polygons[k < 4 ? k % 2 : 2][k / 2 % 2];
  CHECK_OK(gcv_scene_add(scene, members, positions, 6, new_ids));
  CHECK_OK(gcv_scene_set_layers(scene, ids, layers, 2));
  CHECK_OK(gcv_scene_set_container(scene, room));
  gcv_polygon_destroy(room);
  return scene;
}

static void *work(void *argument) {
  struct record *records = argument;
  int round;
  for (round = 0; round < ROUNDS; ++round) put_everything(&records[round]);
  return NULL;
}

int main(void) {
  static struct record reference, records[THREADS][ROUNDS];
  pthread_t threads[THREADS];
  int pair, k, round;
  for (pair = 0; pair < PAIRS; ++pair) {
    CHECK_OK(pair_polygon(pair, 0, &polygons[pair][0]));
    CHECK_OK(pair_polygon(pair, 1, &polygons[pair][1]));
  }
  shared_face = sum_of(polygons[1][0], polygons[1][1]);
  CHECK_OK(gcv_minkowski_sum_region(polygons[1][0], polygons[1][1], NULL, &shared_region));
  shared_scene = scene_of_all();
  put_everything(&reference);
  CHECK(reference.size > 10000);
  /* New ones, so that the threads are the first to ask them. */
  gcv_scene_destroy(shared_scene);
  shared_scene = scene_of_all();
  gcv_region_destroy(shared_region);
  CHECK_OK(gcv_minkowski_sum_region(polygons[1][0], polygons[1][1], NULL, &shared_region));

  for (k = 0; k < THREADS; ++k) {
    if (!CHECK(pthread_create(&threads[k], NULL, work, records[k]) == 0)) return 1;
  }
  for (k = 0; k < THREADS; ++k) {
    CHECK(pthread_join(threads[k], NULL) == 0);
    for (round = 0; round < ROUNDS; ++round) {
      CHECK(records[k][round].size == reference.size &&
            memcmp(records[k][round].bytes, reference.bytes, reference.size) == 0);
    }
  }

  gcv_outer_face_destroy(shared_face);
  gcv_region_destroy(shared_region);
  gcv_scene_destroy(shared_scene);
  for (pair = 0; pair < PAIRS; ++pair) {
    gcv_polygon_destroy(polygons[pair][0]);
    gcv_polygon_destroy(polygons[pair][1]);
  }
  return check_failures != 0;
}

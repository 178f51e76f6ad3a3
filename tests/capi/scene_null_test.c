/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * NULL for every pointer of every function of scenes, one by one: refused by a message that names
 * the parameter, and with no output touched.
 */
#include "null.h"

static void changes(const gcv_polygon *polygon) {
  const double xy[2] = {0, 0};
  const uint32_t layers = 1;
  uint64_t id = 77;
  double out_xy[2] = {UNTOUCHED, UNTOUCHED};
  size_t required = 0;
  gcv_scene *out = UNTOUCHED_HANDLE, *scene = NULL;
  gcv_polygon *out_polygon = UNTOUCHED_HANDLE;
  REFUSES("out", gcv_scene_create(NULL));
  CHECK_OK(gcv_scene_create(&scene));
  REFUSES("scene", gcv_scene_copy(NULL, &out));
  REFUSES("out", gcv_scene_copy(scene, NULL));
  REFUSES("scene", gcv_scene_set_container(NULL, polygon));
  REFUSES("scene", gcv_scene_set_container(NULL, NULL));
  REFUSES("scene", gcv_scene_add(NULL, &polygon, xy, 1, &id));
  REFUSES("scene", gcv_scene_add(NULL, NULL, NULL, 0, NULL));
  REFUSES("polygons", gcv_scene_add(scene, NULL, xy, 1, &id));
  REFUSES("positions", gcv_scene_add(scene, &polygon, NULL, 1, &id));
  REFUSES("ids", gcv_scene_add(scene, &polygon, xy, 1, NULL));
  CHECK_OK(gcv_scene_ids(scene, NULL, 0, &required));
  CHECK(required == 0 && id == 77);
  CHECK_OK(gcv_scene_add(scene, &polygon, xy, 1, &id));
  CHECK(id == 2);
  REFUSES("scene", gcv_scene_set(NULL, &id, &polygon, xy, 1));
  REFUSES("scene", gcv_scene_set(NULL, NULL, NULL, NULL, 0));
  REFUSES("ids", gcv_scene_set(scene, NULL, &polygon, xy, 1));
  REFUSES("ids", gcv_scene_set(scene, NULL, NULL, NULL, 1));
  REFUSES("scene", gcv_scene_set_layers(NULL, &id, &layers, 1));
  REFUSES("ids", gcv_scene_set_layers(scene, NULL, &layers, 1));
  REFUSES("layers", gcv_scene_set_layers(scene, &id, NULL, 1));
  REFUSES("scene", gcv_scene_remove(NULL, &id, 1));
  REFUSES("ids", gcv_scene_remove(scene, NULL, 1));
  REFUSES("scene", gcv_scene_ids(NULL, &id, 1, &required));
  REFUSES("required", gcv_scene_ids(scene, &id, 1, NULL));
  REFUSES("ids", gcv_scene_ids(scene, NULL, 1, &required));
  REFUSES("scene", gcv_scene_positions(NULL, &id, 1, out_xy));
  REFUSES("ids", gcv_scene_positions(scene, NULL, 1, out_xy));
  REFUSES("xy", gcv_scene_positions(scene, &id, 1, NULL));
  REFUSES("scene", gcv_scene_polygon(NULL, 2, &out_polygon));
  REFUSES("out", gcv_scene_polygon(scene, 2, NULL));
  CHECK(out == UNTOUCHED_HANDLE && out_polygon == UNTOUCHED_HANDLE && out_xy[0] == UNTOUCHED);
  gcv_scene_destroy(scene);
}

static void questions(const gcv_polygon *polygon) {
  const double xy[2] = {0, 0};
  int8_t relation = 77;
  gcv_separation separation = {0};
  gcv_impact impact = {0};
  gcv_pair_list *pairs = UNTOUCHED_HANDLE;
  gcv_contact_list *contacts = UNTOUCHED_HANDLE;
  gcv_pair pair = {77, 0, 0, 0};
  gcv_scene *scene = NULL;
  size_t required = 0;
  separation.distance = impact.time = UNTOUCHED;
  CHECK_OK(gcv_scene_create(&scene));
  REFUSES("scene", gcv_scene_relation(NULL, polygon, xy, 1, NULL, NULL, &relation));
  REFUSES("moving", gcv_scene_relation(scene, NULL, xy, 1, NULL, NULL, &relation));
  REFUSES("positions", gcv_scene_relation(scene, polygon, NULL, 1, NULL, NULL, &relation));
  REFUSES("out", gcv_scene_relation(scene, polygon, xy, 1, NULL, NULL, NULL));
  REFUSES("scene", gcv_scene_distance(NULL, polygon, xy, 0, NULL, NULL, &separation));
  REFUSES("moving", gcv_scene_distance(scene, NULL, xy, 1, NULL, NULL, &separation));
  REFUSES("positions", gcv_scene_distance(scene, polygon, NULL, 1, NULL, NULL, &separation));
  REFUSES("out", gcv_scene_distance(scene, polygon, xy, 1, NULL, NULL, NULL));
  REFUSES("scene", gcv_scene_cast(NULL, polygon, xy, xy, 1, NULL, NULL, &impact));
  REFUSES("moving", gcv_scene_cast(scene, NULL, xy, xy, 0, NULL, NULL, &impact));
  REFUSES("positions", gcv_scene_cast(scene, polygon, NULL, xy, 1, NULL, NULL, &impact));
  REFUSES("motions", gcv_scene_cast(scene, polygon, xy, NULL, 1, NULL, NULL, &impact));
  REFUSES("out", gcv_scene_cast(scene, polygon, xy, xy, 1, NULL, NULL, NULL));
  REFUSES("scene", gcv_scene_near(NULL, polygon, xy, 1, NULL, NULL, &pairs));
  REFUSES("moving", gcv_scene_near(scene, NULL, xy, 1, NULL, NULL, &pairs));
  REFUSES("position", gcv_scene_near(scene, polygon, NULL, 1, NULL, NULL, &pairs));
  REFUSES("out", gcv_scene_near(scene, polygon, xy, 1, NULL, NULL, NULL));
  REFUSES("scene", gcv_scene_pairs(NULL, NULL, 1, NULL, NULL, &pairs));
  REFUSES("out", gcv_scene_pairs(scene, NULL, 1, NULL, NULL, NULL));
  REFUSES("scene", gcv_scene_contacts(NULL, NULL, 1, 0, NULL, NULL, &contacts));
  REFUSES("out", gcv_scene_contacts(scene, NULL, 1, 0, NULL, NULL, NULL));
  CHECK(relation == 77 && separation.distance == UNTOUCHED && impact.time == UNTOUCHED);
  CHECK(pairs == UNTOUCHED_HANDLE && contacts == UNTOUCHED_HANDLE);
  CHECK_OK(gcv_scene_pairs(scene, NULL, 1, NULL, NULL, &pairs));
  REFUSES("list", gcv_pair_list_pairs(NULL, &pair, 1, &required));
  REFUSES("required", gcv_pair_list_pairs(pairs, &pair, 1, NULL));
  REFUSES("out", gcv_pair_list_pairs(pairs, NULL, 1, &required));
  CHECK(pair.a == 77);
  gcv_pair_list_destroy(pairs);
  gcv_scene_destroy(scene);
}

static void free_positions(const gcv_polygon *polygon) {
  const double xy[2] = {1, 0};
  gcv_scene *scene = NULL;
  gcv_region *region = UNTOUCHED_HANDLE;
  gcv_escape escape = {0};
  double best[2] = {UNTOUCHED, UNTOUCHED};
  int32_t found = 77;
  escape.depth = UNTOUCHED;
  CHECK_OK(gcv_scene_create(&scene));
  CHECK_OK(gcv_scene_set_container(scene, polygon));
  REFUSES("scene", gcv_scene_free_region(NULL, polygon, NULL, NULL, NULL, &region));
  REFUSES("moving", gcv_scene_free_region(scene, NULL, NULL, NULL, NULL, &region));
  REFUSES("out", gcv_scene_free_region(scene, polygon, NULL, NULL, NULL, NULL));
  REFUSES("scene", gcv_scene_best(NULL, polygon, xy, NULL, NULL, best, &found));
  REFUSES("moving", gcv_scene_best(scene, NULL, xy, NULL, NULL, best, &found));
  REFUSES("direction", gcv_scene_best(scene, polygon, NULL, NULL, NULL, best, &found));
  REFUSES("out", gcv_scene_best(scene, polygon, xy, NULL, NULL, NULL, &found));
  REFUSES("found", gcv_scene_best(scene, polygon, xy, NULL, NULL, best, NULL));
  REFUSES("scene", gcv_scene_penetration(NULL, polygon, xy, 0, NULL, NULL, &escape));
  REFUSES("moving", gcv_scene_penetration(scene, NULL, xy, 1, NULL, NULL, &escape));
  REFUSES("positions", gcv_scene_penetration(scene, polygon, NULL, 1, NULL, NULL, &escape));
  REFUSES("out", gcv_scene_penetration(scene, polygon, xy, 1, NULL, NULL, NULL));
  CHECK(region == UNTOUCHED_HANDLE && escape.depth == UNTOUCHED && found == 77);
  CHECK(best[0] == UNTOUCHED && best[1] == UNTOUCHED);
  gcv_scene_destroy(scene);
}

static void allowed(const gcv_polygon *polygon) {
  gcv_scene *scene = NULL;
  gcv_scene_destroy(NULL);
  gcv_pair_list_destroy(NULL);
  CHECK_OK(gcv_scene_create(&scene));
  CHECK_OK(gcv_scene_relation(scene, polygon, NULL, 0, NULL, NULL, NULL));
  CHECK_OK(gcv_scene_distance(scene, polygon, NULL, 0, NULL, NULL, NULL));
  CHECK_OK(gcv_scene_cast(scene, polygon, NULL, NULL, 0, NULL, NULL, NULL));
  CHECK_OK(gcv_scene_penetration(scene, polygon, NULL, 0, NULL, NULL, NULL));
  CHECK(strcmp(gcv_last_error_message(), "") == 0);
  gcv_scene_destroy(scene);
}

int main(void) {
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  allowed(square);
  changes(square);
  questions(square);
  free_positions(square);
  gcv_polygon_destroy(square);
  return check_failures != 0;
}

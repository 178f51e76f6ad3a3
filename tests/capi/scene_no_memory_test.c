/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Every function of scenes that takes memory, without it.
 */
#include "starve.h"

#if GCV_STARVES

static const double xy[] = {0, 0, 4, 4, 2, 3, 0, 4, 1, 2, 2, 2.5, 1, 3}, point[2] = {0.5, 0.25};
static const double point_pair[4] = {0.5, 0.25, 0.1, 0};
static const double small[] = {0, 0, 0.25, 0, 0, 0.125};
static const size_t sizes[] = {4, 3};
static gcv_polygon *polygon, *holed, *fraction, *tiny, *new_polygon;
static gcv_scene *scene, *new_scene;
static gcv_region *new_region;
static gcv_pair_list *new_pairs;
static gcv_contact_list *new_contacts;
static gcv_escape escapes[2];
static double best[2];
static int32_t found;

static gcv_status create(void) { return gcv_scene_create(&new_scene); }
static gcv_status copy(void) { return gcv_scene_copy(scene, &new_scene); }
static gcv_status polygon_of_member(void) { return gcv_scene_polygon(scene, 2, &new_polygon); }
/* Of a copy, which keeps what it has taken. */
static gcv_status changes(void) {
  static const uint64_t ids[] = {3, 2};
  static const uint32_t layers[] = {1, 6};
  const gcv_polygon *polygons[2];
  uint64_t new_ids[2];
  gcv_scene *copy = NULL;
  gcv_status status = gcv_scene_copy(scene, &copy);
  polygons[0] = holed;
  polygons[1] = polygon;
  if (status == GCV_OK) status = gcv_scene_add(copy, polygons, point_pair, 2, new_ids);
  if (status == GCV_OK) status = gcv_scene_set(copy, ids, polygons, point_pair, 2);
  if (status == GCV_OK) status = gcv_scene_set_layers(copy, ids, layers, 2);
  if (status == GCV_OK) status = gcv_scene_set_container(copy, holed);
  if (status == GCV_OK) status = gcv_scene_remove(copy, ids, 2);
  gcv_scene_destroy(copy);
  return status;
}
static gcv_status relation(void) {
  int8_t relations[2];
  return gcv_scene_relation(scene, holed, point_pair, 2, NULL, NULL, relations);
}
static gcv_status distance(void) {
  gcv_separation separations[2];
  return gcv_scene_distance(scene, holed, point_pair, 2, NULL, NULL, separations);
}
static gcv_status cast(void) {
  gcv_impact impacts[2];
  return gcv_scene_cast(scene, holed, point_pair, point_pair, 2, NULL, NULL, impacts);
}
static gcv_status near(void) {
  return gcv_scene_near(scene, holed, point, 5, NULL, NULL, &new_pairs);
}
static gcv_status pairs(void) { return gcv_scene_pairs(scene, NULL, 5, NULL, NULL, &new_pairs); }
static gcv_status contacts(void) {
  return gcv_scene_contacts(scene, NULL, 5, 0.5, NULL, NULL, &new_contacts);
}
static gcv_status free_region(void) {
  return gcv_scene_free_region(scene, tiny, NULL, NULL, NULL, &new_region);
}
static gcv_status free_region_in_a_window(void) {
  static const double window[4] = {-1, -2, 3, 2.5};
  static const uint64_t container = 1;
  gcv_query query = GCV_QUERY_INIT;
  query.ignore = &container;
  query.ignore_count = 1;
  return gcv_scene_free_region(scene, tiny, window, &query, NULL, &new_region);
}
/* With a polygon of its own, which keeps its reflection to its end. */
static gcv_status free_region_afresh(void) {
  gcv_polygon *moving = NULL;
  gcv_status status = gcv_polygon_create(small, 3, 0, &moving);
  if (status == GCV_OK) {
    status = gcv_scene_free_region(scene, moving, NULL, NULL, NULL, &new_region);
  }
  gcv_polygon_destroy(moving);
  return status;
}
static gcv_status best_position(void) {
  return gcv_scene_best(scene, tiny, point, NULL, NULL, best, &found);
}
static gcv_status penetration(void) {
  static const double places[4] = {0.5, 0.25, 0.125, 0};
  return gcv_scene_penetration(scene, tiny, places, 2, NULL, NULL, escapes);
}

static int outputs_are_untouched(void) {
  return new_polygon == NULL && new_scene == NULL && new_region == NULL && new_pairs == NULL &&
         new_contacts == NULL && found == 77 && best[0] == 77 && escapes[0].depth == 77;
}

static void forget_outputs(void) {
  gcv_polygon_destroy(new_polygon);
  gcv_scene_destroy(new_scene);
  gcv_region_destroy(new_region);
  gcv_pair_list_destroy(new_pairs);
  gcv_contact_list_destroy(new_contacts);
  new_polygon = NULL;
  new_scene = NULL;
  new_region = NULL;
  new_pairs = NULL;
  new_contacts = NULL;
  found = 77;
  best[0] = escapes[0].depth = 77;
}

/* Members at two places, in a container. Its polygons have what is prepared for questions, and so
 * has the one that they are about. */
static void make_scene(void) {
  const gcv_polygon *polygons[2];
  uint64_t ids[2];
  polygons[0] = polygon;
  polygons[1] = fraction;
  CHECK_OK(gcv_scene_create(&scene));
  CHECK_OK(gcv_scene_add(scene, polygons, point_pair, 2, ids));
  CHECK_OK(gcv_scene_set_container(scene, holed));
  CHECK_OK(relation());
  CHECK_OK(distance());
  CHECK_OK(cast());
  CHECK_OK(contacts());
  CHECK_OK(free_region());
  CHECK_OK(best_position());
  CHECK_OK(penetration());
  forget_outputs();
}

int main(void) {
  polygon = polygon_of(xy, 4);
  CHECK_OK(gcv_polygon_create_rings(xy, sizes, 2, 0, &holed));
  fraction = POLYGON(0.1, 0, 1, 0.2, 0.3, 1);
  tiny = polygon_of(small, 3);
  make_scene();
  starve_in_child("gcv_scene_create", create);
  starve_in_child("gcv_scene_copy", copy);
  starve_in_child("gcv_scene_add and other changes", changes);
  starve_in_child("gcv_scene_polygon", polygon_of_member);
  starve_in_child("gcv_scene_free_region", free_region);
  starve_in_child("gcv_scene_free_region, in a window", free_region_in_a_window);
  starve_in_child("gcv_scene_free_region, of a new polygon", free_region_afresh);
  starve_in_child("gcv_scene_best", best_position);
  starve_in_child("gcv_scene_penetration", penetration);
  starve_in_child("gcv_scene_near", near);
  starve_in_child("gcv_scene_pairs", pairs);
  starve_in_child("gcv_scene_contacts", contacts);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(tiny);
  gcv_polygon_destroy(fraction);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(polygon);
  return check_failures != 0;
}

#else

int main(void) { return skip(); }

#endif

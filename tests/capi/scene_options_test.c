/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Options of the functions of scenes: a tolerance and the leaving out of holes would make obstacles
 * free, so all of them refuse both, and write nothing.
 */
#include "regions.h"
#include "scenes.h"

static void refused(const char *part, const gcv_options *options) {
  const double position[2] = {3, 3}, motion[2] = {1, 0}, down[2] = {0, -1};
  gcv_polygon *polygon = SQUARE(2);
  gcv_scene *scene = new_scene();
  gcv_separation separation, separation_before;
  gcv_impact impact, impact_before;
  gcv_escape escape, escape_before;
  gcv_contact_list *contacts = NULL;
  gcv_pair_list *pairs = NULL;
  gcv_region *region = NULL;
  double best[2] = {-7, -7};
  int32_t found = -7;
  int8_t relation = 77;
  add(scene, polygon, 0, 0);
  memset(&separation, 0xa5, sizeof separation);
  memset(&impact, 0xa5, sizeof impact);
  memset(&escape, 0xa5, sizeof escape);
  separation_before = separation;
  impact_before = impact;
  escape_before = escape;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_relation(scene, polygon, position, 1, NULL, options, &relation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_distance(scene, polygon, position, 1, NULL, options, &separation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_cast(scene, polygon, position, motion, 1, NULL, options, &impact));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_penetration(scene, polygon, position, 1, NULL, options, &escape));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_near(scene, polygon, position, 1, NULL, options, &pairs));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_pairs(scene, NULL, 1, NULL, options, &pairs));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_contacts(scene, NULL, 1, 0, NULL, options, &contacts));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_free_region(scene, polygon, NULL, NULL, options, &region));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, part,
                gcv_scene_best(scene, polygon, down, NULL, options, best, &found));
  CHECK(relation == 77 && found == -7 && best[0] == -7 && best[1] == -7);
  CHECK(memcmp(&separation, &separation_before, sizeof separation) == 0);
  CHECK(memcmp(&impact, &impact_before, sizeof impact) == 0);
  CHECK(memcmp(&escape, &escape_before, sizeof escape) == 0);
  CHECK(pairs == NULL && contacts == NULL && region == NULL);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(polygon);
}

int main(void) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.tolerance = 0x1p-60;
  refused("tolerance", &options);
  options = (gcv_options)GCV_OPTIONS_INIT;
  options.leave_out = GCV_LEAVE_OUT_HOLES;
  refused("GCV_LEAVE_OUT_HOLES", &options);
  options.leave_out = GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS;
  refused("GCV_LEAVE_OUT_HOLES", &options);
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Counts that no array can have: each function says so before it reads a number, and writes
 * nothing.
 */
#include "regions.h"

static const double good[4] = {0, 0, 1, 1};

static void of_polygons(size_t count) {
  const size_t sizes[2] = {3, 3};
  gcv_polygon *polygon = NULL;
  gcv_status status = 77;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ring_sizes",
                gcv_polygon_create_rings(good, sizes, count, 0, &polygon));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "sizes",
                gcv_polygon_create_many(good, sizes, count, 0, &polygon, &status));
  CHECK(polygon == NULL && status == 77);
}

static void of_pairs(size_t count) {
  gcv_polygon *square = SQUARE(2);
  const gcv_polygon *one[1];
  gcv_outer_face *face = NULL;
  gcv_region *region = NULL;
  gcv_status status = 77;
  one[0] = square;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "count",
                gcv_minkowski_sum_many(one, one, count, NULL, &face, &status));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "count",
                gcv_no_fit_polygon_many(one, one, good, count, NULL, &face, &status));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "count",
                gcv_minkowski_sum_region_many(one, one, count, NULL, &region, &status));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "count",
                gcv_no_fit_region_many(one, one, good, count, NULL, &region, &status));
  CHECK(face == NULL && region == NULL && status == 77);
  gcv_polygon_destroy(square);
}

/* Arrays of translations could be so long, arrays of results could not. */
static void of_results(void) {
  gcv_polygon *square = SQUARE(2);
  gcv_scene *scene = NULL;
  gcv_separation separation;
  gcv_impact impact;
  gcv_escape escape;
  const size_t separations = PTRDIFF_MAX / sizeof separation + 1;
  const size_t impacts = PTRDIFF_MAX / sizeof impact + 1;
  const size_t escapes = PTRDIFF_MAX / sizeof escape + 1;
  CHECK_OK(gcv_scene_create(&scene));
  separation.distance = impact.time = escape.depth = 77;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "translations",
                gcv_distance(square, square, good, separations, NULL, &separation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "array",
                gcv_cast(square, square, good, good, impacts, NULL, &impact));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "translations",
                gcv_penetration(square, square, good, escapes, NULL, &escape));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "positions",
                gcv_scene_distance(scene, square, good, separations, NULL, NULL, &separation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "array",
                gcv_scene_cast(scene, square, good, good, impacts, NULL, NULL, &impact));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "positions",
                gcv_scene_penetration(scene, square, good, escapes, NULL, NULL, &escape));
  CHECK(separation.distance == 77 && impact.time == 77 && escape.depth == 77);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
}

static void of_text(size_t length) {
  gcv_polygon *polygon = NULL;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "length",
                gcv_polygon_create_wkt("POLYGON ((0 0, 1 0, 0 1))", length, &polygon));
  CHECK(polygon == NULL);
}

static void of_points(size_t count) {
  gcv_polygon *square = SQUARE(2);
  gcv_region *region = NULL;
  int8_t place = 77;
  CHECK_OK(gcv_minkowski_sum_region(square, square, NULL, &region));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "xy", gcv_region_locate(region, good, count, &place));
  CHECK(place == 77);
  gcv_region_destroy(region);
  gcv_polygon_destroy(square);
}

static void of_translations(size_t count) {
  gcv_polygon *square = SQUARE(2);
  int8_t relation = 77;
  gcv_separation separation;
  gcv_impact impact;
  gcv_escape escape;
  separation.distance = impact.time = escape.depth = 77;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "translations",
                gcv_relation(square, square, good, count, NULL, &relation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "translations",
                gcv_distance(square, square, good, count, NULL, &separation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "array",
                gcv_cast(square, square, good, good, count, NULL, &impact));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "translations",
                gcv_penetration(square, square, good, count, NULL, &escape));
  CHECK(relation == 77 && separation.distance == 77 && impact.time == 77 && escape.depth == 77);
  gcv_polygon_destroy(square);
}

static void of_scenes(size_t count) {
  gcv_polygon *square = SQUARE(2);
  const gcv_polygon *one[1];
  const uint64_t ids[2] = {2, 3};
  const uint32_t layers[2] = {1, 1};
  uint64_t id = 77;
  double xy[2] = {77, 77};
  int8_t relation = 77;
  gcv_query query = GCV_QUERY_INIT;
  gcv_scene *scene = NULL;
  one[0] = square;
  query.ignore = ids;
  query.ignore_count = count;
  CHECK_OK(gcv_scene_create(&scene));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "positions", gcv_scene_add(scene, one, good, count, &id));
  CHECK(id == 77);
  CHECK_OK(gcv_scene_add(scene, one, good, 1, &id));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ids", gcv_scene_set(scene, ids, one, good, count));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ids", gcv_scene_set_layers(scene, ids, layers, count));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ids", gcv_scene_remove(scene, ids, count));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "ids", gcv_scene_positions(scene, ids, count, xy));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "positions",
                gcv_scene_relation(scene, square, good, count, NULL, NULL, &relation));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "query: ignore",
                gcv_scene_relation(scene, square, good, 1, &query, NULL, &relation));
  CHECK(xy[0] == 77 && relation == 77);
  CHECK_OK(gcv_scene_positions(scene, ids, 1, xy));
  CHECK(id == 2 && xy[0] == 0 && xy[1] == 0);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
}

int main(void) {
  const size_t counts[] = {SIZE_MAX, SIZE_MAX / 16 + 1};
  size_t k;
  for (k = 0; k < sizeof counts / sizeof *counts; ++k) {
    of_polygons(counts[k]);
    of_text(counts[k] | ((size_t)PTRDIFF_MAX + 1));
    of_pairs(counts[k]);
    of_points(counts[k]);
    of_translations(counts[k]);
    of_scenes(counts[k]);
  }
  of_results();
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Every function that takes memory, but for those of scenes, without it.
 */
#include "starve.h"

#if GCV_STARVES

static const double xy[] = {0, 0, 4, 4, 2, 3, 0, 4, 1, 2, 2, 2.5, 1, 3}, point[2] = {0.5, 0.25};
static const double point_pair[4] = {0.5, 0.25, 0.1, 0};
static const size_t sizes[] = {4, 3};
static gcv_polygon *polygon, *holed, *fraction, *new_polygon;
static gcv_outer_face *face, *face_of_fractions, *new_face;
static gcv_superset *new_superset;
static gcv_region *region, *region_of_fractions, *new_region;
static char text[256];
static size_t required;

static gcv_status create(void) { return gcv_polygon_create(xy, 4, 0, &new_polygon); }
static gcv_status create_rings(void) {
  return gcv_polygon_create_rings(xy, sizes, 2, 0, &new_polygon);
}
static gcv_status disc(void) {
  return gcv_polygon_create_disc(point, 2, 0.01, GCV_ROUND_OUTWARD, &new_polygon);
}
static gcv_status affine(void) {
  static const double turn[6] = {0.6, -0.8, 1, 0.8, 0.6, 2};
  return gcv_polygon_affine(holed, turn, &new_polygon);
}
static gcv_status simplified_holes(void) {
  double bound;
  return gcv_polygon_simplified(holed, 0.1, GCV_ROUND_OUTWARD, &new_polygon, &bound);
}
/* Polygons that fail alone do so by their statuses. */
static gcv_status create_many(void) {
  gcv_polygon *polygons[2] = {NULL, NULL};
  gcv_status statuses[2] = {GCV_OK, GCV_OK};
  gcv_status status = gcv_polygon_create_many(xy, sizes, 2, 0, polygons, statuses);
  int k;
  for (k = 0; k < 2; ++k) {
    CHECK((polygons[k] != NULL) == (status == GCV_OK && statuses[k] == GCV_OK));
    gcv_polygon_destroy(polygons[k]);
    if (status == GCV_OK) status = statuses[k];
  }
  return status;
}
static gcv_status create_wkt(void) {
  return gcv_polygon_create_wkt("POLYGON ((0 0, 4 0, 0 3), (1 1, 2 1, 1 2))", 42, &new_polygon);
}
static gcv_status simplified(void) {
  double bound;
  return gcv_polygon_simplified(polygon, 2, GCV_ROUND_OUTWARD, &new_polygon, &bound);
}
static gcv_status sum(void) { return gcv_minkowski_sum(polygon, polygon, NULL, &new_face); }
static gcv_status outward_sum(void) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = GCV_ROUND_OUTWARD;
  return gcv_minkowski_sum(fraction, polygon, &options, &new_face);
}
static gcv_status sum_within(void) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.tolerance = 2;
  return gcv_minkowski_sum(polygon, polygon, &options, &new_face);
}
/* With a polygon of their own, which keeps its reflection to its end. */
static gcv_status no_fit(void) {
  gcv_polygon *moving = NULL;
  gcv_status status = gcv_polygon_create(xy, 4, 0, &moving);
  if (status == GCV_OK) status = gcv_no_fit_polygon(polygon, moving, point, NULL, &new_face);
  gcv_polygon_destroy(moving);
  return status;
}
static gcv_status entrance(void) {
  gcv_polygon *a = NULL;
  gcv_status status = gcv_polygon_create(xy, 4, 0, &a);
  if (status == GCV_OK) status = gcv_entrance_block(a, polygon, point, NULL, &new_face);
  gcv_polygon_destroy(a);
  return status;
}
static gcv_status exact_vertex(void) {
  return gcv_outer_face_exact_vertex(face_of_fractions, 0, text, sizeof text, &required);
}
static gcv_status wkt(void) { return gcv_outer_face_wkt(face, text, sizeof text, &required); }
static gcv_status edge_sources(void) {
  static gcv_edge_source sources[16];
  return gcv_outer_face_edge_sources(face, sources, 16, &required);
}
static gcv_status face_polygon(void) { return gcv_outer_face_polygon(face, &new_polygon); }
static gcv_status sum_region(void) {
  return gcv_minkowski_sum_region(holed, polygon, NULL, &new_region);
}
static gcv_status outward_sum_region(void) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = GCV_ROUND_OUTWARD;
  options.tolerance = 0.25;
  return gcv_minkowski_sum_region(holed, fraction, &options, &new_region);
}
static gcv_status no_fit_region(void) {
  gcv_polygon *moving = NULL;
  gcv_status status = gcv_polygon_create_rings(xy, sizes, 2, 0, &moving);
  if (status == GCV_OK) status = gcv_no_fit_region(holed, moving, point, NULL, &new_region);
  gcv_polygon_destroy(moving);
  return status;
}
static gcv_status entrance_region(void) {
  gcv_polygon *a = NULL;
  gcv_status status = gcv_polygon_create(xy, 4, 0, &a);
  if (status == GCV_OK) status = gcv_entrance_region(a, holed, point, NULL, &new_region);
  gcv_polygon_destroy(a);
  return status;
}
static gcv_status inner_fit_region(void) {
  static const double tiny[] = {0, 0, 0.25, 0, 0, 0.125};
  gcv_polygon *moving = NULL;
  gcv_status status = gcv_polygon_create(tiny, 3, 0, &moving);
  if (status == GCV_OK) status = gcv_inner_fit_region(holed, moving, point, NULL, &new_region);
  gcv_polygon_destroy(moving);
  return status;
}
/* Pairs that fail alone do so by their statuses. */
static gcv_status region_many(void) {
  gcv_polygon *own = NULL;
  const gcv_polygon *fixed[2], *moving[2];
  gcv_region *regions[2] = {NULL, NULL};
  gcv_status statuses[2] = {GCV_OK, GCV_OK}, status;
  int k;
  status = gcv_polygon_create_rings(xy, sizes, 2, 0, &own);
  if (status != GCV_OK) return status;
  fixed[0] = fixed[1] = holed;
  moving[0] = moving[1] = own;
  status = gcv_no_fit_region_many(fixed, moving, point_pair, 2, NULL, regions, statuses);
  for (k = 0; k < 2; ++k) {
    CHECK((regions[k] != NULL) == (status == GCV_OK && statuses[k] == GCV_OK));
    gcv_region_destroy(regions[k]);
    if (status == GCV_OK) status = statuses[k];
  }
  gcv_polygon_destroy(own);
  return status;
}
/* With a region of its own, which keeps what it locates by to its end. */
static gcv_status locate(void) {
  gcv_region *own = NULL;
  int8_t place;
  gcv_status status = gcv_minkowski_sum_region(holed, polygon, NULL, &own);
  if (status == GCV_OK) status = gcv_region_locate(own, point, 1, &place);
  gcv_region_destroy(own);
  return status;
}
static gcv_status region_exact_vertex(void) {
  return gcv_region_exact_vertex(region_of_fractions, 0, text, sizeof text, &required);
}
static gcv_status region_wkt(void) { return gcv_region_wkt(region, text, sizeof text, &required); }
static gcv_status region_fits_wkt(void) {
  return gcv_region_fits_wkt(region, text, sizeof text, &required);
}
static gcv_status region_sources(void) {
  static gcv_edge_source sources[64];
  return gcv_region_edge_sources(region, sources, 64, &required);
}
static gcv_status region_polygon(void) { return gcv_region_polygon(region, 0, &new_polygon); }
static gcv_status exact_indices(void) {
  static uint64_t indices[64];
  return gcv_outer_face_exact_indices(face, indices, 64, &required);
}
static gcv_status superset(void) { return gcv_superset_create(polygon, polygon, &new_superset); }

static int outputs_are_untouched(void) {
  return new_polygon == NULL && new_face == NULL && new_superset == NULL && new_region == NULL &&
         text[0] == '\0';
}

static void forget_outputs(void) {
  gcv_polygon_destroy(new_polygon);
  gcv_outer_face_destroy(new_face);
  gcv_superset_destroy(new_superset);
  gcv_region_destroy(new_region);
  new_polygon = NULL;
  new_face = NULL;
  new_superset = NULL;
  new_region = NULL;
  text[0] = '\0';
}

/* The functions that do not know GCV_ERR_NO_MEMORY need none. */
static void frugal_functions(void) {
  double number, bounds[4], vertices[64];
  gcv_region_part parts[16];
  uint64_t numbers[32];
  size_t count;
  gcv_superset_edge edges[64];
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 0};
  CHECK_OK(superset());
  allowed = 0;
  CHECK_OK(gcv_polygon_vertex_count(polygon, &count));
  CHECK_OK(gcv_polygon_vertices(polygon, vertices, 16, &count));
  CHECK_OK(gcv_polygon_ring_count(holed, &count));
  CHECK_OK(gcv_polygon_ring(holed, 1, vertices, 16, &count));
  CHECK_OK(gcv_polygon_area(holed, &number));
  CHECK_OK(gcv_polygon_bounds(polygon, bounds));
  CHECK_OK(gcv_outer_face_vertex_count(face, &count));
  CHECK_OK(gcv_outer_face_vertices(face, vertices, 16, &count));
  CHECK_OK(gcv_outer_face_exact_vertex_count(face, &count));
  CHECK_OK(gcv_outer_face_error_bound(face, &number));
  CHECK_OK(gcv_outer_face_area(face, &number));
  CHECK_OK(gcv_outer_face_stats(face, &stats));
  CHECK_OK(gcv_superset_edges(new_superset, edges, 64, &count));
  CHECK_OK(gcv_region_parts(region, parts, 16, &count));
  CHECK_OK(gcv_region_vertices(region, vertices, 32, &count));
  CHECK_OK(gcv_region_exact_parts(region, parts, 16, &count));
  CHECK_OK(gcv_region_exact_indices(region, numbers, 32, &count));
  CHECK_OK(gcv_region_edge_owners(region, numbers, 32, &count));
  CHECK_OK(gcv_region_area(region, &number));
  CHECK_OK(gcv_region_error_bound(region, &number));
  CHECK_OK(gcv_region_stats(region, &stats));
  CHECK_OK(gcv_region_locate(region, NULL, 0, NULL));
  CHECK_STATUS(GCV_ERR_NULL_ARGUMENT, gcv_polygon_area(NULL, &number));
  allowed = -1;
  forget_outputs();
}

int main(void) {
  polygon = polygon_of(xy, 4);
  CHECK_OK(gcv_polygon_create_rings(xy, sizes, 2, 0, &holed));
  fraction = POLYGON(0.1, 0, 1, 0.2, 0.3, 1);
  face = sum_of(polygon, polygon);
  CHECK_OK(gcv_minkowski_sum_region(holed, polygon, NULL, &region));
  face_of_fractions = sum_of(polygon, fraction);
  CHECK_OK(gcv_minkowski_sum_region(holed, fraction, NULL, &region_of_fractions));
  CHECK_OK(outward_sum_region()); /* polygons keep what they have prepared for sums */
  forget_outputs();
  starve_in_child("gcv_polygon_create", create);
  starve_in_child("gcv_polygon_create_wkt", create_wkt);
  starve_in_child("gcv_polygon_create_rings", create_rings);
  starve_in_child("gcv_polygon_create_many", create_many);
  starve_in_child("gcv_polygon_create_disc", disc);
  starve_in_child("gcv_polygon_affine", affine);
  starve_in_child("gcv_polygon_simplified", simplified);
  starve_in_child("gcv_polygon_simplified, with a hole", simplified_holes);
  starve_in_child("gcv_minkowski_sum", sum);
  starve_in_child("gcv_minkowski_sum, outward", outward_sum);
  starve_in_child("gcv_minkowski_sum, within a tolerance", sum_within);
  starve_in_child("gcv_no_fit_polygon", no_fit);
  starve_in_child("gcv_entrance_block", entrance);
  starve_in_child("gcv_outer_face_exact_vertex", exact_vertex);
  starve_in_child("gcv_outer_face_wkt", wkt);
  starve_in_child("gcv_outer_face_edge_sources", edge_sources);
  starve_in_child("gcv_outer_face_polygon", face_polygon);
  starve_in_child("gcv_outer_face_exact_indices", exact_indices);
  starve_in_child("gcv_superset_create", superset);
  starve_in_child("gcv_minkowski_sum_region", sum_region);
  starve_in_child("gcv_minkowski_sum_region, outward", outward_sum_region);
  starve_in_child("gcv_no_fit_region", no_fit_region);
  starve_in_child("gcv_entrance_region", entrance_region);
  starve_in_child("gcv_inner_fit_region", inner_fit_region);
  starve_in_child("gcv_no_fit_region_many", region_many);
  starve_in_child("gcv_region_locate", locate);
  starve_in_child("gcv_region_exact_vertex", region_exact_vertex);
  starve_in_child("gcv_region_wkt", region_wkt);
  starve_in_child("gcv_region_fits_wkt", region_fits_wkt);
  starve_in_child("gcv_region_edge_sources", region_sources);
  starve_in_child("gcv_region_polygon", region_polygon);
  frugal_functions();
  gcv_region_destroy(region_of_fractions);
  gcv_region_destroy(region);
  gcv_outer_face_destroy(face_of_fractions);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(fraction);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(polygon);
  return check_failures != 0;
}

#else

int main(void) { return skip(); }

#endif

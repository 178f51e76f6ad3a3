/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * NULL for every pointer of every function, one by one: refused by a message that names
 * the parameter, and with no output touched. Those of scenes have a file of their own.
 */
#include "null.h"

static void polygons(const gcv_polygon *polygon) {
  const double xy[] = {0, 0, 1, 0, 0, 1}, identity[6] = {1, 0, 0, 0, 1, 0};
  const size_t three = 3;
  gcv_status status = UNTOUCHED_STATUS;
  gcv_polygon *out = UNTOUCHED_HANDLE;
  double vertices[6] = {UNTOUCHED}, area = UNTOUCHED, bounds[4] = {UNTOUCHED};
  size_t count = UNTOUCHED_COUNT, required = 0;

  REFUSES("xy", gcv_polygon_create(NULL, 3, 0, &out));
  REFUSES("xy", gcv_polygon_create(NULL, 0, 0, &out));
  REFUSES("out", gcv_polygon_create(xy, 3, 0, NULL));
  REFUSES("text", gcv_polygon_create_wkt(NULL, 5, &out));
  REFUSES("text", gcv_polygon_create_wkt(NULL, 0, &out));
  REFUSES("out", gcv_polygon_create_wkt("POLYGON ((0 0, 1 0, 0 1))", 25, NULL));
  REFUSES("xy", gcv_polygon_create_rings(NULL, &three, 1, 0, &out));
  REFUSES("xy", gcv_polygon_create_rings(NULL, &three, 0, 0, &out));
  REFUSES("ring_sizes", gcv_polygon_create_rings(xy, NULL, 1, 0, &out));
  REFUSES("ring_sizes", gcv_polygon_create_rings(xy, NULL, 0, 0, &out));
  REFUSES("out", gcv_polygon_create_rings(xy, &three, 1, 0, NULL));
  REFUSES("xy", gcv_polygon_create_many(NULL, &three, 1, 0, &out, &status));
  REFUSES("sizes", gcv_polygon_create_many(xy, NULL, 1, 0, &out, &status));
  REFUSES("out", gcv_polygon_create_many(xy, &three, 1, 0, NULL, &status));
  REFUSES("statuses", gcv_polygon_create_many(xy, &three, 1, 0, &out, NULL));
  REFUSES("centre", gcv_polygon_create_disc(NULL, 1, 0.1, GCV_ROUND_NEAREST, &out));
  REFUSES("out", gcv_polygon_create_disc(xy, 1, 0.1, GCV_ROUND_NEAREST, NULL));
  REFUSES("polygon", gcv_polygon_affine(NULL, identity, &out));
  REFUSES("m", gcv_polygon_affine(polygon, NULL, &out));
  REFUSES("out", gcv_polygon_affine(polygon, identity, NULL));
  REFUSES("polygon", gcv_polygon_ring_count(NULL, &count));
  REFUSES("out", gcv_polygon_ring_count(polygon, NULL));
  REFUSES("polygon", gcv_polygon_ring(NULL, 0, vertices, 3, &required));
  REFUSES("required", gcv_polygon_ring(polygon, 0, vertices, 3, NULL));
  REFUSES("required", gcv_polygon_ring(polygon, 0, NULL, 0, NULL));
  REFUSES("polygon", gcv_polygon_vertex_count(NULL, &count));
  REFUSES("out", gcv_polygon_vertex_count(polygon, NULL));
  REFUSES("polygon", gcv_polygon_vertices(NULL, vertices, 3, &required));
  REFUSES("required", gcv_polygon_vertices(polygon, vertices, 3, NULL));
  REFUSES("required", gcv_polygon_vertices(polygon, NULL, 0, NULL));
  REFUSES("polygon", gcv_polygon_area(NULL, &area));
  REFUSES("out", gcv_polygon_area(polygon, NULL));
  REFUSES("polygon", gcv_polygon_bounds(NULL, bounds));
  REFUSES("out", gcv_polygon_bounds(polygon, NULL));
  REFUSES("polygon", gcv_polygon_simplified(NULL, 1, GCV_ROUND_NEAREST, &out, &area));
  REFUSES("out", gcv_polygon_simplified(polygon, 1, GCV_ROUND_NEAREST, NULL, &area));
  REFUSES("error_bound", gcv_polygon_simplified(polygon, 1, GCV_ROUND_NEAREST, &out, NULL));

  CHECK(out == UNTOUCHED_HANDLE && count == UNTOUCHED_COUNT && status == UNTOUCHED_STATUS);
  CHECK(vertices[0] == UNTOUCHED && area == UNTOUCHED && bounds[0] == UNTOUCHED);
}

static void sums(const gcv_polygon *a, const gcv_polygon *b) {
  const double point[2] = {0, 0};
  gcv_outer_face *out = UNTOUCHED_HANDLE;
  gcv_superset *superset = UNTOUCHED_HANDLE;

  REFUSES("a", gcv_minkowski_sum(NULL, b, NULL, &out));
  REFUSES("b", gcv_minkowski_sum(a, NULL, NULL, &out));
  REFUSES("out", gcv_minkowski_sum(a, b, NULL, NULL));
  REFUSES("fixed", gcv_no_fit_polygon(NULL, b, point, NULL, &out));
  REFUSES("moving", gcv_no_fit_polygon(a, NULL, point, NULL, &out));
  REFUSES("reference", gcv_no_fit_polygon(a, b, NULL, NULL, &out));
  REFUSES("out", gcv_no_fit_polygon(a, b, point, NULL, NULL));
  REFUSES("a", gcv_entrance_block(NULL, b, point, NULL, &out));
  REFUSES("b", gcv_entrance_block(a, NULL, point, NULL, &out));
  REFUSES("a0", gcv_entrance_block(a, b, NULL, NULL, &out));
  REFUSES("out", gcv_entrance_block(a, b, point, NULL, NULL));
  REFUSES("a", gcv_superset_create(NULL, b, &superset));
  REFUSES("b", gcv_superset_create(a, NULL, &superset));
  REFUSES("out", gcv_superset_create(a, b, NULL));

  CHECK(out == UNTOUCHED_HANDLE && superset == UNTOUCHED_HANDLE);
}

static void faces(const gcv_outer_face *face) {
  double xy[8] = {UNTOUCHED}, number = UNTOUCHED;
  size_t count = UNTOUCHED_COUNT, required = 0;
  char text[256] = "untouched";
  gcv_edge_source sources[4] = {{-1, 0, 0}};
  gcv_polygon *polygon = UNTOUCHED_HANDLE;
  gcv_stats stats = {sizeof(gcv_stats), 77, 0, 0, 0, 0, 0, 0};
  uint64_t index = UNTOUCHED_COUNT;

  REFUSES("face", gcv_outer_face_vertex_count(NULL, &count));
  REFUSES("out", gcv_outer_face_vertex_count(face, NULL));
  REFUSES("face", gcv_outer_face_vertices(NULL, xy, 4, &required));
  REFUSES("required", gcv_outer_face_vertices(face, xy, 4, NULL));
  REFUSES("face", gcv_outer_face_exact_vertex_count(NULL, &count));
  REFUSES("out", gcv_outer_face_exact_vertex_count(face, NULL));
  REFUSES("face", gcv_outer_face_exact_vertex(NULL, 0, text, sizeof text, &required));
  REFUSES("required", gcv_outer_face_exact_vertex(face, 0, text, sizeof text, NULL));
  REFUSES("face", gcv_outer_face_edge_sources(NULL, sources, 4, &required));
  REFUSES("required", gcv_outer_face_edge_sources(face, sources, 4, NULL));
  REFUSES("face", gcv_outer_face_exact_indices(NULL, &index, 1, &required));
  REFUSES("required", gcv_outer_face_exact_indices(face, &index, 1, NULL));
  REFUSES("face", gcv_outer_face_error_bound(NULL, &number));
  REFUSES("out", gcv_outer_face_error_bound(face, NULL));
  REFUSES("face", gcv_outer_face_area(NULL, &number));
  REFUSES("out", gcv_outer_face_area(face, NULL));
  REFUSES("face", gcv_outer_face_wkt(NULL, text, sizeof text, &required));
  REFUSES("required", gcv_outer_face_wkt(face, text, sizeof text, NULL));
  REFUSES("face", gcv_outer_face_polygon(NULL, &polygon));
  REFUSES("out", gcv_outer_face_polygon(face, NULL));
  REFUSES("face", gcv_outer_face_stats(NULL, &stats));
  REFUSES("out", gcv_outer_face_stats(face, NULL));

  CHECK(xy[0] == UNTOUCHED && number == UNTOUCHED && count == UNTOUCHED_COUNT);
  CHECK(strcmp(text, "untouched") == 0 && sources[0].kind == -1 && stats.walk_steps == 77);
  CHECK(polygon == UNTOUCHED_HANDLE && index == UNTOUCHED_COUNT);
}

static void region_sums(const gcv_polygon *a, const gcv_polygon *b) {
  const double point[2] = {0, 0};
  gcv_region *out = UNTOUCHED_HANDLE;
  gcv_outer_face *face = UNTOUCHED_HANDLE;
  gcv_status status = UNTOUCHED_STATUS;

  REFUSES("a", gcv_minkowski_sum_region(NULL, b, NULL, &out));
  REFUSES("b", gcv_minkowski_sum_region(a, NULL, NULL, &out));
  REFUSES("out", gcv_minkowski_sum_region(a, b, NULL, NULL));
  REFUSES("fixed", gcv_no_fit_region(NULL, b, point, NULL, &out));
  REFUSES("moving", gcv_no_fit_region(a, NULL, point, NULL, &out));
  REFUSES("reference", gcv_no_fit_region(a, b, NULL, NULL, &out));
  REFUSES("out", gcv_no_fit_region(a, b, point, NULL, NULL));
  REFUSES("a", gcv_entrance_region(NULL, b, point, NULL, &out));
  REFUSES("b", gcv_entrance_region(a, NULL, point, NULL, &out));
  REFUSES("a0", gcv_entrance_region(a, b, NULL, NULL, &out));
  REFUSES("out", gcv_entrance_region(a, b, point, NULL, NULL));
  REFUSES("container", gcv_inner_fit_region(NULL, b, point, NULL, &out));
  REFUSES("moving", gcv_inner_fit_region(a, NULL, point, NULL, &out));
  REFUSES("reference", gcv_inner_fit_region(a, b, NULL, NULL, &out));
  REFUSES("out", gcv_inner_fit_region(a, b, point, NULL, NULL));
  REFUSES("a", gcv_minkowski_sum_region_many(NULL, &b, 1, NULL, &out, &status));
  REFUSES("b", gcv_minkowski_sum_region_many(&a, NULL, 1, NULL, &out, &status));
  REFUSES("out", gcv_minkowski_sum_region_many(&a, &b, 1, NULL, NULL, &status));
  REFUSES("statuses", gcv_minkowski_sum_region_many(&a, &b, 1, NULL, &out, NULL));
  REFUSES("fixed", gcv_no_fit_region_many(NULL, &b, point, 1, NULL, &out, &status));
  REFUSES("moving", gcv_no_fit_region_many(&a, NULL, point, 1, NULL, &out, &status));
  REFUSES("references", gcv_no_fit_region_many(&a, &b, NULL, 1, NULL, &out, &status));
  REFUSES("out", gcv_no_fit_region_many(&a, &b, point, 1, NULL, NULL, &status));
  REFUSES("statuses", gcv_no_fit_region_many(&a, &b, point, 1, NULL, &out, NULL));
  REFUSES("fixed", gcv_no_fit_polygon_many(NULL, &b, point, 1, NULL, &face, &status));
  REFUSES("moving", gcv_no_fit_polygon_many(&a, NULL, point, 1, NULL, &face, &status));
  REFUSES("references", gcv_no_fit_polygon_many(&a, &b, NULL, 1, NULL, &face, &status));
  REFUSES("out", gcv_no_fit_polygon_many(&a, &b, point, 1, NULL, NULL, &status));
  REFUSES("statuses", gcv_no_fit_polygon_many(&a, &b, point, 1, NULL, &face, NULL));

  CHECK(out == UNTOUCHED_HANDLE && face == UNTOUCHED_HANDLE && status == UNTOUCHED_STATUS);
}

static void regions(const gcv_region *region) {
  double xy[8] = {UNTOUCHED}, number = UNTOUCHED;
  size_t required = 0;
  char text[256] = "untouched";
  gcv_region_part part = {-1, 0, 0};
  gcv_edge_source source = {-1, 0, 0};
  uint64_t index = UNTOUCHED_COUNT;
  int8_t place = 77;
  gcv_polygon *polygon = UNTOUCHED_HANDLE;
  gcv_stats stats = {sizeof(gcv_stats), 77, 0, 0, 0, 0, 0, 0};

  REFUSES("region", gcv_region_parts(NULL, &part, 1, &required));
  REFUSES("required", gcv_region_parts(region, &part, 1, NULL));
  REFUSES("region", gcv_region_vertices(NULL, xy, 4, &required));
  REFUSES("required", gcv_region_vertices(region, xy, 4, NULL));
  REFUSES("region", gcv_region_exact_parts(NULL, &part, 1, &required));
  REFUSES("required", gcv_region_exact_parts(region, &part, 1, NULL));
  REFUSES("region", gcv_region_exact_vertex(NULL, 0, text, sizeof text, &required));
  REFUSES("required", gcv_region_exact_vertex(region, 0, text, sizeof text, NULL));
  REFUSES("region", gcv_region_exact_indices(NULL, &index, 1, &required));
  REFUSES("required", gcv_region_exact_indices(region, &index, 1, NULL));
  REFUSES("region", gcv_region_edge_sources(NULL, &source, 1, &required));
  REFUSES("required", gcv_region_edge_sources(region, &source, 1, NULL));
  REFUSES("region", gcv_region_edge_owners(NULL, &index, 1, &required));
  REFUSES("required", gcv_region_edge_owners(region, &index, 1, NULL));
  REFUSES("region", gcv_region_area(NULL, &number));
  REFUSES("out", gcv_region_area(region, NULL));
  REFUSES("region", gcv_region_error_bound(NULL, &number));
  REFUSES("out", gcv_region_error_bound(region, NULL));
  REFUSES("region", gcv_region_wkt(NULL, text, sizeof text, &required));
  REFUSES("required", gcv_region_wkt(region, text, sizeof text, NULL));
  REFUSES("region", gcv_region_fits_wkt(NULL, text, sizeof text, &required));
  REFUSES("required", gcv_region_fits_wkt(region, text, sizeof text, NULL));
  REFUSES("region", gcv_region_polygon(NULL, 0, &polygon));
  REFUSES("out", gcv_region_polygon(region, 0, NULL));
  REFUSES("region", gcv_region_locate(NULL, xy, 1, &place));
  REFUSES("region", gcv_region_locate(NULL, xy, 0, &place));
  REFUSES("xy", gcv_region_locate(region, NULL, 1, &place));
  REFUSES("out", gcv_region_locate(region, xy, 1, NULL));
  REFUSES("region", gcv_region_stats(NULL, &stats));
  REFUSES("out", gcv_region_stats(region, NULL));

  CHECK(xy[0] == UNTOUCHED && number == UNTOUCHED && index == UNTOUCHED_COUNT && place == 77);
  CHECK(strcmp(text, "untouched") == 0 && stats.walk_steps == 77);
  CHECK(part.kind == -1 && source.kind == -1 && polygon == UNTOUCHED_HANDLE);
}

static void two_polygons(const gcv_polygon *a) {
  const double xy[2] = {0, 0};
  int8_t relation = 77;
  gcv_separation separation = {0};
  gcv_impact impact = {0};
  gcv_escape escape = {0};
  separation.distance = impact.time = escape.depth = UNTOUCHED;
  REFUSES("a", gcv_relation(NULL, a, xy, 1, NULL, &relation));
  REFUSES("b", gcv_relation(a, NULL, xy, 1, NULL, &relation));
  REFUSES("translations", gcv_relation(a, a, NULL, 1, NULL, &relation));
  REFUSES("out", gcv_relation(a, a, xy, 1, NULL, NULL));
  REFUSES("a", gcv_distance(NULL, a, xy, 0, NULL, &separation));
  REFUSES("b", gcv_distance(a, NULL, xy, 1, NULL, &separation));
  REFUSES("translations", gcv_distance(a, a, NULL, 1, NULL, &separation));
  REFUSES("out", gcv_distance(a, a, xy, 1, NULL, NULL));
  REFUSES("a", gcv_cast(NULL, a, xy, xy, 1, NULL, &impact));
  REFUSES("b", gcv_cast(a, NULL, xy, xy, 0, NULL, &impact));
  REFUSES("translations", gcv_cast(a, a, NULL, xy, 1, NULL, &impact));
  REFUSES("motions", gcv_cast(a, a, xy, NULL, 1, NULL, &impact));
  REFUSES("out", gcv_cast(a, a, xy, xy, 1, NULL, NULL));
  REFUSES("a", gcv_penetration(NULL, a, xy, 1, NULL, &escape));
  REFUSES("b", gcv_penetration(a, NULL, xy, 0, NULL, &escape));
  REFUSES("translations", gcv_penetration(a, a, NULL, 1, NULL, &escape));
  REFUSES("out", gcv_penetration(a, a, xy, 1, NULL, NULL));
  CHECK(escape.depth == UNTOUCHED);
  CHECK(relation == 77 && separation.distance == UNTOUCHED && impact.time == UNTOUCHED);
}

static void contact_lists(const gcv_polygon *a) {
  const double t[2] = {1, 0};
  gcv_contact_list *list = UNTOUCHED_HANDLE;
  gcv_contact contacts[8] = {{0}};
  uint64_t previous[8] = {77};
  size_t required = 0;
  contacts[0].gap = UNTOUCHED;
  REFUSES("a", gcv_contacts(NULL, a, t, 0, 0, NULL, &list));
  REFUSES("b", gcv_contacts(a, NULL, t, 0, 0, NULL, &list));
  REFUSES("t", gcv_contacts(a, a, NULL, 0, 0, NULL, &list));
  REFUSES("out", gcv_contacts(a, a, t, 0, 0, NULL, NULL));
  CHECK(list == UNTOUCHED_HANDLE);
  CHECK_OK(gcv_contacts(a, a, t, 0, 0, NULL, &list));
  REFUSES("list", gcv_contact_list_contacts(NULL, contacts, 8, &required));
  REFUSES("required", gcv_contact_list_contacts(list, contacts, 8, NULL));
  REFUSES("list", gcv_contact_list_previous(NULL, previous, 8, &required));
  REFUSES("required", gcv_contact_list_previous(list, previous, 8, NULL));
  CHECK(contacts[0].gap == UNTOUCHED && previous[0] == 77);
  gcv_contact_list_destroy(list);
}

static void supersets(const gcv_superset *superset) {
  gcv_superset_edge edges[8] = {{0}};
  size_t required = 0;
  edges[0].x0 = UNTOUCHED;
  REFUSES("superset", gcv_superset_edges(NULL, edges, 8, &required));
  REFUSES("required", gcv_superset_edges(superset, edges, 8, NULL));
  CHECK(edges[0].x0 == UNTOUCHED);
}

static void allowed(void) {
  gcv_options_init(NULL);
  gcv_options_init_size(NULL, sizeof(gcv_options));
  CHECK_OK(gcv_polygon_create_many(NULL, NULL, 0, 0, NULL, NULL));
  CHECK_OK(gcv_minkowski_sum_region_many(NULL, NULL, 0, NULL, NULL, NULL));
  CHECK_OK(gcv_no_fit_region_many(NULL, NULL, NULL, 0, NULL, NULL, NULL));
  CHECK_OK(gcv_no_fit_polygon_many(NULL, NULL, NULL, 0, NULL, NULL, NULL));
  gcv_polygon_destroy(NULL);
  gcv_outer_face_destroy(NULL);
  gcv_superset_destroy(NULL);
  gcv_region_destroy(NULL);
  gcv_contact_list_destroy(NULL);
  CHECK(strcmp(gcv_last_error_message(), "") == 0);
}

int main(void) {
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  gcv_outer_face *face = sum_of(square, square);
  gcv_superset *superset = NULL;
  gcv_region *region = NULL;
  CHECK_OK(gcv_superset_create(square, square, &superset));
  CHECK_OK(gcv_minkowski_sum_region(square, square, NULL, &region));

  allowed();
  polygons(square);
  sums(square, square);
  faces(face);
  two_polygons(square);
  contact_lists(square);
  supersets(superset);
  region_sums(square, square);
  regions(region);

  gcv_region_destroy(region);
  gcv_superset_destroy(superset);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(square);
  return check_failures != 0;
}

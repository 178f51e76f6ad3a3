/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The buffer contract at the head of gcv.h, for every function that fills a buffer.
 */
#include <stdlib.h>

#include "regions.h"

typedef gcv_status fill(const void *handle, void *out, size_t capacity, size_t *required);

static gcv_status polygon_vertices(const void *handle, void *out, size_t capacity,
                                   size_t *required) {
  return gcv_polygon_vertices(handle, out, capacity, required);
}
static gcv_status outer_ring(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_polygon_ring(handle, 0, out, capacity, required);
}
static gcv_status hole(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_polygon_ring(handle, 1, out, capacity, required);
}
static gcv_status face_vertices(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_outer_face_vertices(handle, out, capacity, required);
}
static gcv_status exact_vertex(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_outer_face_exact_vertex(handle, 2, out, capacity, required);
}
static gcv_status edge_sources(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_outer_face_edge_sources(handle, out, capacity, required);
}
static gcv_status wkt(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_outer_face_wkt(handle, out, capacity, required);
}
static gcv_status superset_edges(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_superset_edges(handle, out, capacity, required);
}
static gcv_status region_parts(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_region_parts(handle, out, capacity, required);
}
static gcv_status region_vertices(const void *handle, void *out, size_t capacity,
                                  size_t *required) {
  return gcv_region_vertices(handle, out, capacity, required);
}
static gcv_status region_exact_parts(const void *handle, void *out, size_t capacity,
                                     size_t *required) {
  return gcv_region_exact_parts(handle, out, capacity, required);
}
static gcv_status region_exact_vertex(const void *handle, void *out, size_t capacity,
                                      size_t *required) {
  return gcv_region_exact_vertex(handle, 2, out, capacity, required);
}
static gcv_status region_exact_indices(const void *handle, void *out, size_t capacity,
                                       size_t *required) {
  return gcv_region_exact_indices(handle, out, capacity, required);
}
static gcv_status region_edge_sources(const void *handle, void *out, size_t capacity,
                                      size_t *required) {
  return gcv_region_edge_sources(handle, out, capacity, required);
}
static gcv_status region_edge_owners(const void *handle, void *out, size_t capacity,
                                     size_t *required) {
  return gcv_region_edge_owners(handle, out, capacity, required);
}
static gcv_status region_wkt(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_region_wkt(handle, out, capacity, required);
}
static gcv_status region_fits_wkt(const void *handle, void *out, size_t capacity,
                                  size_t *required) {
  return gcv_region_fits_wkt(handle, out, capacity, required);
}
static gcv_status exact_indices(const void *handle, void *out, size_t capacity, size_t *required) {
  return gcv_outer_face_exact_indices(handle, out, capacity, required);
}

enum { SENTINEL = 0xa5 };

static int untouched(const unsigned char *from, const unsigned char *to) {
  while (from != to && *from == SENTINEL) ++from;
  return from == to;
}

/* Asks for the contents with room for `spare` elements more than there are, in a block of
 * exactly that size. The caller frees the block. */
static unsigned char *filled(fill *call, const void *handle, size_t count, size_t spare,
                             size_t element_size) {
  const size_t size = (count + spare) * element_size;
  unsigned char *out = malloc(size);
  size_t required = 0;
  if (out == NULL) abort();
  memset(out, SENTINEL, size);
  CHECK_OK(call(handle, out, count + spare, &required));
  CHECK(required == count);
  CHECK(!untouched(out, out + count * element_size));
  CHECK(untouched(out + count * element_size, out + size));
  return out;
}

static void follows_contract(const char *name, fill *call, const void *handle, size_t count,
                             size_t element_size) {
  const int failures_before = check_failures;
  unsigned char out[4096], *exact, *larger;
  size_t required = 0, capacity;
  const size_t too_small[] = {0, 1, count - 1};
  size_t k;

  CHECK_OK(call(handle, NULL, 0, &required));
  CHECK(required == count);

  memset(out, SENTINEL, sizeof out);
  for (k = 0; k < sizeof too_small / sizeof *too_small; ++k) {
    capacity = too_small[k];
    required = 0;
    CHECK_STATUS(GCV_ERR_BUFFER_TOO_SMALL, call(handle, out, capacity, &required));
    CHECK(required == count);
    CHECK(untouched(out, out + sizeof out));
  }
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "NULL", call(handle, NULL, 1, &required));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "NULL", call(handle, NULL, count, &required));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "NULL", call(handle, NULL, SIZE_MAX, &required));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "required", call(handle, out, count, NULL));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "required", call(handle, NULL, 0, NULL));
  CHECK(untouched(out, out + sizeof out));

  exact = filled(call, handle, count, 0, element_size);
  larger = filled(call, handle, count, 3, element_size);
  CHECK(memcmp(exact, larger, count * element_size) == 0);
  if (element_size == 1) CHECK(memchr(exact, '\0', count) == exact + count - 1);
  free(exact);
  free(larger);
  if (check_failures != failures_before) fprintf(stderr, "  by %s\n", name);
}

/* Of a ring and a segment. */
static void regions(void) {
  static const char fits[] = "GEOMETRYCOLLECTION (LINESTRING (2 2, 2 6))";
  static const char polygons[] = "MULTIPOLYGON (((-2 -2, 6 -2, 6 6, -2 6, -2 -2)))";
  gcv_polygon *slotted = POLYGON(SLOTTED), *peg = SQUARE(2);
  gcv_region *region = no_fit_region(slotted, peg, 0, GCV_ROUND_NEAREST);
  follows_contract("region_parts", region_parts, region, 2, sizeof(gcv_region_part));
  follows_contract("region_vertices", region_vertices, region, 6, 2 * sizeof(double));
  follows_contract("region_exact_parts", region_exact_parts, region, 2, sizeof(gcv_region_part));
  follows_contract("region_exact_vertex", region_exact_vertex, region, sizeof "6/1 6/1", 1);
  follows_contract("region_exact_indices", region_exact_indices, region, 6, sizeof(uint64_t));
  follows_contract("region_edge_sources", region_edge_sources, region, 6, sizeof(gcv_edge_source));
  follows_contract("region_edge_owners", region_edge_owners, region, 6, sizeof(uint64_t));
  follows_contract("region_wkt", region_wkt, region, sizeof polygons, 1);
  follows_contract("region_fits_wkt", region_fits_wkt, region, sizeof fits, 1);
  gcv_region_destroy(region);
  gcv_polygon_destroy(slotted);
  gcv_polygon_destroy(peg);
}

int main(void) {
  const double xy[] = {0, 0, 4, 4, 2, 3, 0, 4, 1, 2, 2, 2.5, 1, 3};
  const size_t sizes[] = {4, 3};
  gcv_polygon *dart = POLYGON(0, 0, 4, 4, 2, 3, 0, 4), *holed = NULL;
  gcv_polygon *triangle = POLYGON(0, 0, 3, 3, 0, 2);
  gcv_outer_face *face = sum_of(dart, triangle);
  gcv_superset *superset = NULL;
  CHECK_OK(gcv_superset_create(dart, triangle, &superset));
  CHECK_OK(gcv_polygon_create_rings(xy, sizes, 2, 0, &holed));

  follows_contract("polygon_vertices", polygon_vertices, dart, 4, 2 * sizeof(double));
  follows_contract("outer_ring", outer_ring, holed, 4, 2 * sizeof(double));
  follows_contract("hole", hole, holed, 3, 2 * sizeof(double));
  follows_contract("face_vertices", face_vertices, face, 5, 2 * sizeof(double));
  follows_contract("exact_vertex", exact_vertex, face, sizeof "23/5 31/5", 1);
  follows_contract("edge_sources", edge_sources, face, 5, sizeof(gcv_edge_source));
  follows_contract("wkt", wkt, face, sizeof "POLYGON ((0 0, 7 7, 4.6 6.2, 3 7, 0 6, 0 0))", 1);
  follows_contract("superset_edges", superset_edges, superset, 6, sizeof(gcv_superset_edge));

  follows_contract("exact_indices", exact_indices, face, 5, sizeof(uint64_t));
  regions();

  gcv_superset_destroy(superset);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(triangle);
  gcv_polygon_destroy(holed);
  gcv_polygon_destroy(dart);
  return check_failures != 0;
}

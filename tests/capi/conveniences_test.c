/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The conveniences of gcvx.h: what they give is what gcv.h gives; files that cannot be read;
 * memory that runs out at every allocation in turn.
 */
#include <stdlib.h>

/* How many allocations may still succeed; below 0: all. */
static int allocations_left = -1;

static void *scarce_realloc(void *memory, size_t size) {
  if (allocations_left == 0) return NULL;
  if (allocations_left > 0) --allocations_left;
  return realloc(memory, size);
}

#define malloc(size) scarce_realloc(NULL, size)
#define realloc scarce_realloc
#include <gcv/gcvx.h>
#undef malloc
#undef realloc

#include "handles.h"

static const char *const FILE_NAME = "conveniences_test.wkt";

/* Calls with no memory, then with memory. */
#define CHECK_ALLOCATED(call)            \
  do {                                   \
    allocations_left = 0;                \
    CHECK_STATUS(GCVX_ERR_SYSTEM, call); \
    allocations_left = -1;               \
    CHECK_OK(call);                      \
  } while (0)

static void arrays_and_texts(void) {
  gcv_polygon *a = POLYGON(0, 0, 8, 0, 8, 6, 3, 1, 0, 7), *b = POLYGON(0, 0, 1, 0, 0, 1);
  gcv_outer_face *face = sum_of(a, b);
  gcv_superset *superset = NULL;
  gcv_edge_source *sources = NULL, expected_sources[MOST_VERTICES];
  gcv_superset_edge *edges = NULL, expected_edges[MOST_VERTICES];
  uint64_t *indices = NULL;
  double *xy = NULL;
  char *text = NULL, expected[MOST_TEXT];
  size_t count = 0, required = 0;
  CHECK_OK(gcv_superset_create(a, b, &superset));

  CHECK_ALLOCATED(gcvx_polygon_vertices(a, &xy, &count));
  CHECK(polygon_is(a, xy, count));
  free(xy);

  CHECK_ALLOCATED(gcvx_polygon_ring(a, 0, &xy, &count));
  CHECK(polygon_is(a, xy, count));
  free(xy);

  CHECK_ALLOCATED(gcvx_outer_face_vertices(face, &xy, &count));
  CHECK(face_is(face, xy, count));
  free(xy);

  CHECK_ALLOCATED(gcvx_outer_face_edge_sources(face, &sources, &count));
  CHECK_OK(gcv_outer_face_edge_sources(face, expected_sources, MOST_VERTICES, &required));
  CHECK(count == required && memcmp(sources, expected_sources, count * sizeof *sources) == 0);
  free(sources);

  CHECK_ALLOCATED(gcvx_outer_face_exact_indices(face, &indices, &count));
  CHECK(count == required && indices[4] == 4);
  free(indices);

  CHECK_ALLOCATED(gcvx_superset_edges(superset, &edges, &count));
  CHECK_OK(gcv_superset_edges(superset, expected_edges, MOST_VERTICES, &required));
  CHECK(count == required && memcmp(edges, expected_edges, 4 * sizeof(double)) == 0);
  CHECK(edges[count - 1].source.kind == expected_edges[count - 1].source.kind);
  free(edges);

  CHECK_ALLOCATED(gcvx_outer_face_wkt(face, &text));
  CHECK_OK(gcv_outer_face_wkt(face, expected, MOST_TEXT, &required));
  CHECK(strcmp(text, expected) == 0);
  free(text);

  CHECK_ALLOCATED(gcvx_outer_face_exact_vertex(face, 4, &text));
  CHECK(strcmp(text, "10/3 7/3") == 0);
  free(text);

  gcv_superset_destroy(superset);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

static void regions(void) {
  const double origin[2] = {0, 0};
  gcv_polygon *small = POLYGON(0, 0, 2, 0, 2, 2, 0, 2), *large = POLYGON(0, 0, 4, 0, 4, 2, 0, 2);
  gcv_region *region = NULL, *empty = NULL;
  gcv_region_part *parts = NULL;
  gcv_edge_source *sources = NULL;
  uint64_t *indices = NULL;
  double *xy = NULL;
  char *text = NULL;
  size_t count = 0;
  CHECK_OK(gcv_inner_fit_region(large, small, origin, NULL, &region));
  CHECK_OK(gcv_inner_fit_region(small, large, origin, NULL, &empty));
  CHECK_ALLOCATED(gcvx_region_parts(region, &parts, &count));
  CHECK(count == 1 && parts[0].kind == GCV_PART_SEGMENT && parts[0].vertex_count == 2);
  free(parts);
  CHECK_ALLOCATED(gcvx_region_vertices(region, &xy, &count));
  CHECK(same_ring(xy, count, RING(0, 0, 2, 0)));
  free(xy);
  CHECK_ALLOCATED(gcvx_region_exact_parts(region, &parts, &count));
  CHECK(count == 1 && parts[0].kind == GCV_PART_SEGMENT && parts[0].vertex_count == 2);
  free(parts);
  CHECK_ALLOCATED(gcvx_region_edge_sources(region, &sources, &count));
  CHECK(count == 2 && sources[0].kind != 0 && sources[1].kind == 0);
  free(sources);
  CHECK_ALLOCATED(gcvx_region_exact_indices(region, &indices, &count));
  CHECK(count == 2 && indices[0] == 0 && indices[1] == 1);
  free(indices);
  CHECK_ALLOCATED(gcvx_region_edge_owners(region, &indices, &count));
  CHECK(count == 2 && indices[0] == 0 && indices[1] == 0);
  free(indices);
  CHECK_ALLOCATED(gcvx_region_exact_vertex(region, 1, &text));
  CHECK(strcmp(text, "2/1 0/1") == 0);
  free(text);
  CHECK_ALLOCATED(gcvx_region_wkt(region, &text));
  CHECK(strcmp(text, "MULTIPOLYGON EMPTY") == 0);
  free(text);
  CHECK_ALLOCATED(gcvx_region_fits_wkt(region, &text));
  CHECK(strcmp(text, "GEOMETRYCOLLECTION (LINESTRING (0 0, 2 0))") == 0);
  free(text);
  CHECK_ALLOCATED(gcvx_region_parts(empty, &parts, &count));
  CHECK(count == 0 && parts != NULL);
  free(parts);
  CHECK_ALLOCATED(gcvx_region_vertices(empty, &xy, &count));
  CHECK(count == 0 && xy != NULL);
  free(xy);
  gcv_region_destroy(region);
  gcv_region_destroy(empty);
  gcv_polygon_destroy(small);
  gcv_polygon_destroy(large);
}

static void scenes(void) {
  const double positions[] = {0, 0, 1, 0, 5, 0};
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  const gcv_polygon *const squares[] = {square, square, square};
  gcv_scene *scene = NULL;
  gcv_pair_list *near = NULL, *nothing_near = NULL;
  gcv_contact_list *before = NULL, *list = NULL, *nothing = NULL;
  gcv_pair *pairs = NULL;
  gcv_contact *contacts = NULL, expected[MOST_VERTICES];
  uint64_t ids[3], *numbers = NULL;
  size_t count = 0, required = 0;
  CHECK_OK(gcv_scene_create(&scene));
  CHECK_ALLOCATED(gcvx_scene_ids(scene, &numbers, &count));
  CHECK(count == 0 && numbers != NULL);
  free(numbers);
  CHECK_OK(gcv_scene_pairs(scene, NULL, 0, NULL, NULL, &nothing_near));
  CHECK_OK(gcv_scene_contacts(scene, NULL, 0, 0, NULL, NULL, &nothing));
  CHECK_OK(gcv_scene_add(scene, squares, positions, 3, ids));
  CHECK_OK(gcv_scene_pairs(scene, NULL, 0, NULL, NULL, &near));
  CHECK_OK(gcv_scene_contacts(scene, NULL, 0, 0, NULL, NULL, &before));
  CHECK_OK(gcv_scene_contacts(scene, before, 0, 0, NULL, NULL, &list));

  CHECK_ALLOCATED(gcvx_scene_ids(scene, &numbers, &count));
  CHECK(count == 3 && memcmp(numbers, ids, sizeof ids) == 0);
  free(numbers);
  CHECK_ALLOCATED(gcvx_pair_list_pairs(near, &pairs, &count));
  CHECK(count == 1 && pairs[0].a == ids[0] && pairs[0].b == ids[1]);
  free(pairs);
  CHECK_ALLOCATED(gcvx_contact_list_contacts(list, &contacts, &count));
  CHECK_OK(gcv_contact_list_contacts(list, expected, MOST_VERTICES, &required));
  CHECK(count > 0 && count == required &&
        memcmp(contacts, expected, count * sizeof *expected) == 0);
  free(contacts);
  CHECK_ALLOCATED(gcvx_contact_list_previous(list, &numbers, &count));
  CHECK(count == required && numbers[0] == 0 && numbers[count - 1] == count - 1);
  free(numbers);

  CHECK_ALLOCATED(gcvx_pair_list_pairs(nothing_near, &pairs, &count));
  CHECK(count == 0 && pairs != NULL);
  free(pairs);
  CHECK_ALLOCATED(gcvx_contact_list_contacts(nothing, &contacts, &count));
  CHECK(count == 0 && contacts != NULL);
  free(contacts);
  CHECK_ALLOCATED(gcvx_contact_list_previous(nothing, &numbers, &count));
  CHECK(count == 0 && numbers != NULL);
  free(numbers);

  gcv_contact_list_destroy(nothing);
  gcv_contact_list_destroy(list);
  gcv_contact_list_destroy(before);
  gcv_pair_list_destroy(near);
  gcv_pair_list_destroy(nothing_near);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(square);
}

static void refused(void) {
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  gcv_outer_face *face = sum_of(square, square);
  uint64_t *ids = NULL;
  gcv_pair *pairs = NULL;
  gcv_contact *contacts = NULL;
  double *xy = NULL;
  char *text = NULL;
  size_t count = 7;
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "", gcvx_polygon_vertices(NULL, &xy, &count));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "", gcvx_polygon_ring(square, 1, &xy, &count));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "", gcvx_scene_ids(NULL, &ids, &count));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "", gcvx_pair_list_pairs(NULL, &pairs, &count));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "", gcvx_contact_list_contacts(NULL, &contacts, &count));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "", gcvx_contact_list_previous(NULL, &ids, &count));
  CHECK(ids == NULL && pairs == NULL && contacts == NULL);
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "", gcvx_outer_face_exact_vertex(face, 4, &text));
  CHECK(xy == NULL && count == 7 && text == NULL);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(square);
}

static int write_file(const char *text, size_t length) {
  FILE *file = fopen(FILE_NAME, "wb");
  const int written = file != NULL && fwrite(text, 1, length, file) == length;
  return file != NULL && fclose(file) == 0 && written;
}

static void files(void) {
  enum { BLANKS = 10000 };
  static char text[BLANKS + 64];
  const char square[] = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))";
  gcv_polygon *polygon = NULL;
  int k;
  CHECK(write_file(square, sizeof square - 1));
  CHECK_OK(gcvx_polygon_read_wkt(FILE_NAME, &polygon));
  CHECK(polygon_is(polygon, RING(0, 0, 1, 0, 1, 1, 0, 1)));
  gcv_polygon_destroy(polygon);

  /* More than one read; three allocations. */
  memset(text, ' ', BLANKS);
  strcpy(text + BLANKS, square);
  CHECK(write_file(text, strlen(text)));
  for (k = 0; k < 3; ++k) {
    polygon = NULL;
    allocations_left = k;
    CHECK_STATUS(GCVX_ERR_SYSTEM, gcvx_polygon_read_wkt(FILE_NAME, &polygon));
    CHECK(polygon == NULL);
  }
  allocations_left = 3;
  CHECK_OK(gcvx_polygon_read_wkt(FILE_NAME, &polygon));
  CHECK(allocations_left == 0);
  allocations_left = -1;
  CHECK(polygon_is(polygon, RING(0, 0, 1, 0, 1, 1, 0, 1)));
  gcv_polygon_destroy(polygon);

  polygon = NULL;
  CHECK(write_file("", 0));
  CHECK_REFUSED(GCV_ERR_PARSE, "", gcvx_polygon_read_wkt(FILE_NAME, &polygon));
  errno = 0;
  CHECK_STATUS(GCVX_ERR_SYSTEM, gcvx_polygon_read_wkt(".", &polygon));
  CHECK((errno == EISDIR || errno == EACCES));
  CHECK(remove(FILE_NAME) == 0);
  CHECK_STATUS(GCVX_ERR_SYSTEM, gcvx_polygon_read_wkt(FILE_NAME, &polygon));
  CHECK(errno == ENOENT && polygon == NULL);
}

static void messages(void) {
  char text[GCVX_MESSAGE_SIZE], expected[GCVX_MESSAGE_SIZE];
  gcv_polygon *none = NULL;
  const gcv_status status = gcv_polygon_create_wkt("POLYGON", 7, &none);
  sprintf(expected, "GCV_ERR_PARSE: %s", gcv_last_error_message());
  CHECK(strcmp(gcvx_message(status, text), expected) == 0);
  CHECK(strcmp(gcvx_message(GCV_OK, text), "GCV_OK") == 0);
  errno = ENOENT;
  sprintf(expected, "GCVX_ERR_SYSTEM: %s", strerror(ENOENT));
  CHECK(strcmp(gcvx_message(GCVX_ERR_SYSTEM, text), expected) == 0);
}

int main(void) {
  arrays_and_texts();
  regions();
  scenes();
  refused();
  files();
  messages();
  return check_failures != 0;
}

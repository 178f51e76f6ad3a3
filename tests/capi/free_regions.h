/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Free regions of scenes, and in comparison with what they should be.
 */
#ifndef GCV_TESTS_CAPI_FREE_REGIONS_H
#define GCV_TESTS_CAPI_FREE_REGIONS_H

#include "regions.h"
#include "scenes.h"

/* A window as the four numbers. */
#define WINDOW(...) ((const double[4]){__VA_ARGS__})

static inline gcv_scene *scene_in(const gcv_polygon *container) {
  gcv_scene *scene = new_scene();
  CHECK_OK(gcv_scene_set_container(scene, container));
  return scene;
}

static inline gcv_region *free_region(const gcv_scene *scene, const gcv_polygon *moving,
                                      const double *window, const gcv_query *query) {
  gcv_region *region = NULL;
  CHECK_OK(gcv_scene_free_region(scene, moving, window, query, NULL, &region));
  return region;
}

static inline int free_is(const gcv_scene *scene, const gcv_polygon *moving, const double *window,
                          const gcv_query *query, const char *expected) {
  gcv_region *region = free_region(scene, moving, window, query);
  const int is = exact_region_is(region, expected);
  gcv_region_destroy(region);
  return is;
}

/* Are these the owners of the edges, no more and no fewer? */
static inline int owners_are(const gcv_region *region, const uint64_t *expected, size_t count) {
  uint64_t owners[MOST_VERTICES] = {0};
  size_t required = 0, k;
  CHECK_OK(gcv_region_edge_owners(region, owners, MOST_VERTICES, &required));
  if (required == count && memcmp(owners, expected, count * sizeof *owners) == 0) return 1;
  fprintf(stderr, "the owners are");
  for (k = 0; k < required; ++k) fprintf(stderr, " %d", (int)owners[k]);
  fprintf(stderr, "\n");
  return 0;
}
#define OWNERS_ARE(region, ...)                       \
  owners_are(region, (const uint64_t[]){__VA_ARGS__}, \
             sizeof((const uint64_t[]){__VA_ARGS__}) / sizeof(uint64_t))

#endif

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Each edge of a region is named by edges that make it: where many superset edges coincide, and
 * where rings that touch themselves are cut.
 */
#include "free_regions.h"

enum { TEETH = 19, LONG_TOOTH = 7, COMB_VERTICES = 4 * TEETH, MOST = 512 };

/* Teeth downwards, as wide as the gaps; one of them is longer. */
static void make_comb(double *xy) {
  size_t k = 0;
  int tooth;
  for (tooth = 0; tooth < TEETH; ++tooth) {
    const double x = 2 * tooth, tip = tooth == LONG_TOOTH ? -3 : -2;
    const double corners[8] = {x, tip, x + 1, tip, x + 1, -1, x + 2, -1};
    memcpy(xy + k, corners, sizeof corners);
    k += 8;
  }
  xy[k - 4] = 2 * TEETH - 1;
  xy[k - 3] = 0;
  xy[k - 2] = 0;
  xy[k - 1] = 0;
}

/* From where to where the sum of the edges goes, along an axis. */
static void range_of_source(const double *xy, const gcv_edge_source *source, size_t axis,
                            double *range) {
  const uint32_t next_a = source->kind == GCV_EDGE_CORNER ? source->a : source->a + 1;
  const uint32_t next_b = source->kind == GCV_EDGE_TRANSLATED ? source->b : source->b + 1;
  const double p = xy[2 * source->a + axis] + xy[2 * source->b + axis];
  const double q =
      xy[2 * (next_a % COMB_VERTICES) + axis] + xy[2 * (next_b % COMB_VERTICES) + axis];
  range[0] = p < q ? p : q;
  range[1] = p < q ? q : p;
}

static void segments_of_equal_combs(void) {
  double xy[2 * COMB_VERTICES], ends[2 * MOST];
  gcv_region_part parts[MOST];
  gcv_edge_source sources[MOST];
  gcv_polygon *comb = NULL;
  gcv_region *region;
  size_t part_count = 0, count = 0, vertex = 0, segments = 0, k;
  make_comb(xy);
  CHECK_OK(gcv_polygon_create(xy, COMB_VERTICES, 0, &comb));
  region = region_of_sum(comb, comb);
  CHECK_OK(gcv_region_parts(region, parts, MOST, &part_count));
  CHECK_OK(gcv_region_vertices(region, ends, MOST, &count));
  CHECK_OK(gcv_region_edge_sources(region, sources, MOST, &count));
  for (k = 0; k < part_count; vertex += parts[k++].vertex_count) {
    const double *const p = ends + 2 * vertex;
    const size_t axis = p[0] == p[2] ? 1 : 0;
    double along[2], across[2];
    if (parts[k].kind != GCV_PART_SEGMENT) continue;
    ++segments;
    range_of_source(xy, sources + vertex, axis, along);
    range_of_source(xy, sources + vertex, 1 - axis, across);
    CHECK(across[0] == p[1 - axis] && across[1] == p[1 - axis]);
    CHECK(along[0] <= p[axis] && p[axis] < along[1]);
  }
  CHECK(segments > 30);
  gcv_region_destroy(region);
  gcv_polygon_destroy(comb);
}

/* Three holes of free positions, each of which touches the next one in a corner. */
static void rings_that_are_cut(void) {
  gcv_polygon *room = POLYGON(0, 0, 6, 0, 6, 12, 0, 12), *moving = POLYGON(-1, 0, 0, -1, 0, 0);
  gcv_polygon *triangle = POLYGON(3, 0, 4, 0, 3, 1);
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  CHECK(add(scene, triangle, 0, 5) == 2);
  CHECK(add(scene, triangle, 0, 3) == 3);
  CHECK(add(scene, triangle, 0, 7) == 4);
  region = free_region(scene, moving, NULL, NULL);
  CHECK(exact_region_is(region,
                        "outer 1/1 1/1, 6/1 1/1, 6/1 12/1, 1/1 12/1; "
                        "hole 3/1 3/1, 3/1 5/1, 5/1 3/1; hole 3/1 5/1, 3/1 7/1, 5/1 5/1; "
                        "hole 3/1 7/1, 3/1 9/1, 5/1 7/1"));
  CHECK(OWNERS_ARE(region, 1, 1, 1, 1, 3, 3, 3, 2, 2, 2, 4, 4, 4));
  gcv_region_destroy(region);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(triangle);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(moving);
}

int main(void) {
  segments_of_equal_combs();
  rings_that_are_cut();
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Combs of hundreds of teeth, and a scene of a hundred members: what is looked for in other ways
 * than in small inputs, with answers that are worked out by hand.
 */
#include <math.h>

#include "free_regions.h"

enum { TEETH = 200, VERTICES = 4 * TEETH, HEIGHT = 7, ROWS = 10 };

/* Teeth of width 1, a gap of 1 between them, on a floor from -1 to 0. */
static gcv_polygon *comb(void) {
  double xy[2 * VERTICES];
  double *at = xy;
  gcv_polygon *polygon = NULL;
  int k;
#define PUT(x, y) (*at++ = (x), *at++ = (y))
  PUT(0, -1);
  PUT(2 * TEETH - 1, -1);
  for (k = TEETH - 1; k >= 0; --k) {
    PUT(2 * k + 1, HEIGHT);
    PUT(2 * k, HEIGHT);
    if (k > 0) {
      PUT(2 * k, 0);
      PUT(2 * k - 1, 0);
    }
  }
#undef PUT
  CHECK(at == xy + 2 * VERTICES);
  CHECK_OK(gcv_polygon_create(xy, VERTICES, 0, &polygon));
  return polygon;
}

static gcv_polygon *placed(const gcv_polygon *polygon, double xx, double xy, double yx, double yy) {
  const double matrix[6] = {xx, xy, 0, yx, yy, 0};
  gcv_polygon *out = NULL;
  CHECK_OK(gcv_polygon_affine(polygon, matrix, &out));
  return out;
}

static double area_of_sum(const gcv_polygon *a, const gcv_polygon *b) {
  gcv_outer_face *face = NULL;
  double area = 0;
  CHECK_OK(gcv_minkowski_sum(a, b, NULL, &face));
  CHECK_OK(gcv_outer_face_area(face, &area));
  gcv_outer_face_destroy(face);
  return area;
}

/* Two teeth are as wide as the way to the next two: all is covered but the lines between. */
static void a_comb_with_itself(void) {
  gcv_polygon *a = comb();
  gcv_region *region = NULL;
  size_t parts = 0;
  double area = 0;
  CHECK(area_of_sum(a, a) == (4 * TEETH - 2) * (2 * HEIGHT + 2.0));
  CHECK_OK(gcv_minkowski_sum_region(a, a, NULL, &region));
  CHECK_OK(gcv_region_parts(region, NULL, 0, &parts));
  CHECK(parts == 1 + (2 * TEETH - 2));
  CHECK_OK(gcv_region_area(region, &area));
  CHECK(area == (4 * TEETH - 2) * (2 * HEIGHT + 2.0));
  gcv_region_destroy(region);
  gcv_polygon_destroy(a);
}

static void combs_in_all_positions(void) {
  static const double positions[][4] = {{0, -1, 1, 0}, {-1, 0, 0, -1}, {0, 1, -1, 0}, {-1, 0, 0, 1},
                                        {1, 0, 0, -1}, {0, 1, 1, 0},   {0, -1, -1, 0}};
  gcv_polygon *a = comb();
  size_t k;
  for (k = 0; k < sizeof positions / sizeof *positions; ++k) {
    const double *m = positions[k];
    gcv_polygon *b = placed(a, m[0], m[1], m[2], m[3]);
    gcv_polygon *c = placed(b, m[0], m[2], m[1], m[3]), *d = placed(a, m[0], m[2], m[1], m[3]);
    /* A + M A, exchanged, and turned back by the inverse of M. */
    const double area = area_of_sum(a, b);
    CHECK(area_of_sum(b, a) == area);
    CHECK(area_of_sum(d, c) == area);
    gcv_polygon_destroy(b);
    gcv_polygon_destroy(c);
    gcv_polygon_destroy(d);
  }
  gcv_polygon_destroy(a);
}

/* Unit squares, 2 apart, in a room whose walls are 2 from them. */
static void a_scene_of_a_hundred(void) {
  gcv_polygon *room = SQUARE(3 * ROWS + 2), *unit = SQUARE(1);
  gcv_scene *scene = scene_in(room);
  gcv_region *region;
  gcv_pair_list *list = NULL;
  const double place[2] = {0, 0};
  gcv_escape escape;
  size_t parts = 0, pairs = 0;
  int x, y;
  for (y = 0; y < ROWS; ++y) {
    for (x = 0; x < ROWS; ++x) add(scene, unit, 3 * x + 2, 3 * y + 2);
  }
  region = free_region(scene, unit, NULL, NULL);
  CHECK_OK(gcv_region_parts(region, NULL, 0, &parts));
  CHECK(parts == 1 + ROWS * ROWS);
  gcv_region_destroy(region);
  CHECK_OK(gcv_scene_pairs(scene, NULL, 2, NULL, NULL, &list));
  CHECK_OK(gcv_pair_list_pairs(list, NULL, 0, &pairs));
  CHECK(pairs == 2 * ROWS * (ROWS - 1) + 4 * (ROWS - 1));
  gcv_pair_list_destroy(list);
  CHECK_OK(gcv_scene_penetration(scene, room, place, 1, NULL, NULL, &escape));
  CHECK(escape.depth == (double)INFINITY);
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(room);
  gcv_polygon_destroy(unit);
}

int main(void) {
  a_comb_with_itself();
  combs_in_all_positions();
  a_scene_of_a_hundred();
  return check_failures != 0;
}

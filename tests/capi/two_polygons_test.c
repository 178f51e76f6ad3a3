/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Two polygons: gcv_relation, gcv_distance, gcv_cast.
 */
#include <math.h>

#include "regions.h"

enum { COUNT = 5 };

/* A square of side 2 left of another one, further and further in. */
static const double translations[2 * COUNT] = {5, 1, 2, 0, 0x1.fffffffffffffp0, 0, 0, 0, 6, 7};

static void relations_and_distances(void) {
  static const int8_t relations[COUNT] = {1, 0, -1, -1, 1};
  static const double distances[COUNT] = {3, 0, 0, 0, 0};
  gcv_polygon *square = SQUARE(2);
  int8_t out[COUNT];
  gcv_separation separations[COUNT];
  size_t k;
  CHECK_OK(gcv_relation(square, square, NULL, 0, NULL, NULL));
  CHECK_OK(gcv_distance(square, square, NULL, 0, NULL, NULL));
  CHECK_OK(gcv_relation(square, square, translations, COUNT, NULL, out));
  CHECK_OK(gcv_distance(square, square, translations, COUNT, NULL, separations));
  for (k = 0; k < COUNT; ++k) {
    const gcv_separation *s = &separations[k];
    CHECK(out[k] == relations[k] && s->relation == relations[k] && s->reserved == 0);
    CHECK(k == COUNT - 1 || s->distance == distances[k]);
    CHECK(s->nearest.gap == s->distance);
    CHECK((s->nearest.kind == 0) == (relations[k] != GCV_APART));
  }
  /* From (2, 2) to (6, 7). */
  CHECK(fabs(separations[4].distance * separations[4].distance - 41) < 1e-13);
  CHECK(separations[4].nearest.kind == GCV_CONTACT_VERTEX_VERTEX);
  CHECK(separations[4].nearest.a == 2 && separations[4].nearest.b == 0);
  /* Of two edges that face each other, the smallest numbers. */
  CHECK(separations[0].nearest.kind == GCV_CONTACT_EDGE_VERTEX);
  CHECK(separations[0].nearest.a == 1 && separations[0].nearest.b == 0);
  CHECK(separations[0].nearest.normal[0] == 1 && separations[0].nearest.normal[1] == 0);
  CHECK(separations[0].nearest.on_a[0] == 2 && separations[0].nearest.on_b[0] == 5);
  gcv_polygon_destroy(square);
}

static void casts(void) {
  static const double starts[] = {5, 0, 5, 0, 5, 2, 5, 0, 0, 0};
  static const double motions[] = {-4, 0, -3, 0, -9, 0, 0, 0, 1, 0};
  static const int32_t hits[] = {1, 0, 0, 0, 1};
  static const double times[] = {0.75, 1, 1, 1, 0};
  gcv_polygon *square = SQUARE(2);
  gcv_impact impacts[COUNT];
  size_t k;
  CHECK_OK(gcv_cast(square, square, NULL, NULL, 0, NULL, NULL));
  CHECK_OK(gcv_cast(square, square, starts, motions, COUNT, NULL, impacts));
  for (k = 0; k < COUNT; ++k) {
    CHECK(impacts[k].hit == hits[k] && impacts[k].time == times[k]);
    CHECK((impacts[k].contact.kind != 0) == (k == 0));
  }
  CHECK(impacts[0].position[0] == 2 && impacts[0].position[1] == 0);
  CHECK(impacts[0].relation == GCV_TOUCHING && impacts[4].relation == GCV_OVERLAPPING);
  CHECK(impacts[0].contact.gap == 0 && impacts[0].contact.kind == GCV_CONTACT_VERTEX_VERTEX);
  CHECK(impacts[2].relation == GCV_APART && impacts[1].relation == GCV_TOUCHING);
  gcv_polygon_destroy(square);
}

static void refusals(void) {
  const double bad[] = {0, 0, 1, NAN}, far[] = {0, 0, 1.7e308, 0}, good[] = {0, 0, 0, 0};
  const double corner[] = {-1.7e308, 0, -1.6e308, 0, -1.7e308, 1e307};
  gcv_polygon *square = SQUARE(2), *distant = NULL;
  int8_t relation[2] = {77, 77};
  gcv_separation separation[2];
  gcv_impact impact[2];
  separation[0].distance = impact[0].time = 77;
  CHECK_OK(gcv_polygon_create(corner, 3, 0, &distant));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "translations: number 1",
                gcv_relation(square, square, bad, 2, NULL, relation));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "translations: number 1",
                gcv_distance(square, square, bad, 2, NULL, separation));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "motions: number 1",
                gcv_cast(square, square, good, bad, 2, NULL, impact));
  CHECK_REFUSED(GCV_ERR_RANGE, "translations: number 1",
                gcv_distance(distant, square, far, 2, NULL, separation));
  CHECK(relation[0] == 77 && separation[0].distance == 77 && impact[0].time == 77);
  CHECK_OK(gcv_relation(distant, square, far, 2, NULL, relation));
  CHECK(relation[0] == GCV_APART && relation[1] == GCV_APART);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(distant);
}

int main(void) {
  relations_and_distances();
  casts();
  refusals();
  return check_failures != 0;
}

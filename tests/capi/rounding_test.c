/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * From the exact ring to doubles, nearest or outward, and the bound on the error.
 */
#include <math.h>

#include "handles.h"

static double error_bound_of(const gcv_outer_face *face) {
  double bound = -1;
  CHECK_OK(gcv_outer_face_error_bound(face, &bound));
  return bound;
}

/* The vertex (23/5, 31/5) is the one that is no pair of doubles. Its x, rounded, is off
 * by 2/5 of 2^-50, its y by 1/5 of that; 2^-50 is also the unit in the last place of both. */
static void crossing(void) {
  gcv_polygon *dart = POLYGON(0, 0, 4, 4, 2, 3, 0, 4), *wedge = POLYGON(0, 0, 3, 3, 0, 2);
  gcv_outer_face *face = sum_of(dart, wedge);
  double area = 0;
  CHECK(face_is(face, RING(0, 0, 7, 7, 0x1.2666666666666p+2, 0x1.8cccccccccccdp+2, 3, 7, 0, 6)));
  CHECK(error_bound_of(face) >= hypot(0.4, 0.2) * 0x1p-50);
  CHECK(error_bound_of(face) <= 0.7071068 * 0x1p-50);
  CHECK_OK(gcv_outer_face_area(face, &area));
  CHECK(area == 21.4);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(wedge);
  gcv_polygon_destroy(dart);
}

/* 0.1 + 0.2 is no double, as everybody knows. */
static void sums_of_doubles(void) {
  gcv_polygon *a = POLYGON(0.1, 0, 1, 0, 1, 1), *b = POLYGON(0.2, 0, 1, 0, 1, 1);
  gcv_outer_face *face = sum_of(a, b);
  CHECK(exact_ring_is(face,
                      "10808639105689191/36028797018963968 0/1, 2/1 0/1, 2/1 2/1, "
                      "39631676720860365/36028797018963968 1/1"));
  CHECK(face_is(face, RING(0x1.3333333333334p-2, 0, 2, 0, 2, 2, 0x1.199999999999ap+0, 1)));
  CHECK(error_bound_of(face) > 0);
  CHECK(error_bound_of(face) <= 0.5 * 0x1p-52);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
}

/* The exact x of the right side is 1 + 2^-53 + 2^-53. In doubles, 1 + 2^-53 is 1. */
static void reference_is_added_exactly(void) {
  const double reference[2] = {0x1p-53, 0};
  gcv_polygon *unit = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  gcv_polygon *thin = POLYGON(-0x1p-53, 0, 0, 0, 0, 1, -0x1p-53, 1);
  gcv_outer_face *face = NULL;
  CHECK(1 + 0x1p-53 + 0x1p-53 != 1 + (0x1p-53 + 0x1p-53));
  CHECK_OK(gcv_no_fit_polygon(unit, thin, reference, NULL, &face));
  CHECK(face_is(face, RING(0x1p-53, -1, 1 + 0x1p-52, -1, 1 + 0x1p-52, 1, 0x1p-53, 1)));
  CHECK(error_bound_of(face) == 0);
  gcv_outer_face_destroy(face);
  CHECK_OK(gcv_entrance_block(thin, unit, reference, NULL, &face));
  CHECK(face_is(face, RING(0x1p-53, -1, 1 + 0x1p-52, -1, 1 + 0x1p-52, 1, 0x1p-53, 1)));
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(thin);
  gcv_polygon_destroy(unit);
}

static void subnormal(void) {
  gcv_polygon *tiny = POLYGON(0, 0, 0x1p-1074, 0, 0, 0x1p-1074);
  gcv_outer_face *face = sum_of(tiny, tiny);
  CHECK(face_is(face, RING(0, 0, 0x1p-1073, 0, 0, 0x1p-1073)));
  CHECK(error_bound_of(face) == 0);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(tiny);
}

/* At 2^54, doubles are 4 apart. A slit from 4 to 8 there, narrowed by 1, goes from 5 to 8,
 * and to the nearest doubles from 4 to 8. Narrowed by 2, it goes from 6 to 8, and to the
 * nearest doubles from 8 to 8: to keep it open, vertices have to move further. */
static void closing_slit(void) {
  const double at = 0x1p54, origin[2] = {0, 0};
  gcv_options outward = GCV_OPTIONS_INIT;
  gcv_polygon *fork =
      POLYGON(at, 0, at + 16, 0, at + 16, 16, at + 8, 16, at + 8, 8, at + 4, 8, at + 4, 16, at, 16);
  gcv_polygon *one = POLYGON(-1, -1, 0, -1, 0, 0, -1, 0), *two = POLYGON(0, 0, 2, 0, 2, 1, 0, 1);
  gcv_polygon *simple = NULL;
  gcv_outer_face *face = NULL;
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 0};
  double xy[2 * MOST_VERTICES] = {0};
  size_t count = 0, k;

  CHECK_OK(gcv_no_fit_polygon(fork, one, origin, NULL, &face));
  CHECK(face_is(face, RING(at, 0, at + 16, 0, at + 16, 17, at + 8, 17, at + 8, 9, at + 4, 9, at + 4,
                           17, at, 17)));
  CHECK(error_bound_of(face) >= 1 && error_bound_of(face) <= 0.7071068 * 4);
  CHECK_OK(gcv_outer_face_stats(face, &stats));
  CHECK(stats.vertices_repaired == 0);
  gcv_outer_face_destroy(face);

  face = sum_of(fork, two);
  CHECK_OK(gcv_outer_face_vertices(face, xy, MOST_VERTICES, &count));
  for (k = 0; k < count && xy[2 * k + 1] != 9; ++k) continue;
  CHECK(k < count); /* the bottom of the slit */
  CHECK_OK(gcv_outer_face_polygon(face, &simple));
  CHECK(error_bound_of(face) >= 2 && error_bound_of(face) <= 4 * 8);
  CHECK_OK(gcv_outer_face_stats(face, &stats));
  CHECK(stats.vertices_repaired > 0);
  gcv_outer_face_destroy(face);

  /* Outward, it closes, which changes the ring by as much as the slit is deep. */
  outward.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_minkowski_sum(fork, two, &outward, &face));
  CHECK_OK(gcv_outer_face_vertices(face, xy, MOST_VERTICES, &count));
  for (k = 0; k < count; ++k) CHECK(xy[2 * k + 1] <= 0 || xy[2 * k + 1] >= 17);
  CHECK(error_bound_of(face) >= 8);
  gcv_outer_face_destroy(face);

  gcv_polygon_destroy(simple);
  gcv_polygon_destroy(two);
  gcv_polygon_destroy(one);
  gcv_polygon_destroy(fork);
}

/* The box has corners (x0, 0) and (2, 2), where the largest double below x0 is 0x1.3...3p-2. */
static void contains_the_box(gcv_outer_face *face) {
  gcv_polygon *ring = NULL;
  double box[4] = {0}, area = 0;
  CHECK_OK(gcv_outer_face_polygon(face, &ring));
  CHECK_OK(gcv_polygon_bounds(ring, box));
  CHECK(box[0] <= 0x1.3333333333333p-2 && box[1] <= 0 && box[2] >= 2 && box[3] >= 2);
  CHECK_OK(gcv_outer_face_area(face, &area));
  CHECK(area >= 3.4);
  CHECK(error_bound_of(face) >= 0x1.3333333333333p-2 - box[0] && error_bound_of(face) <= 0x1p-44);
  gcv_polygon_destroy(ring);
  gcv_outer_face_destroy(face);
}

static void outward(void) {
  const double origin[2] = {0, 0};
  gcv_polygon *a = POLYGON(0.1, 0, 1, 0, 1, 1, 0.1, 1), *b = POLYGON(0.2, 0, 1, 0, 1, 1, 0.2, 1);
  gcv_polygon *minus_b = POLYGON(-0.2, 0, -1, 0, -1, -1, -0.2, -1);
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_outer_face *face = sum_of(a, b);
  CHECK(face_is(face, RING(0x1.3333333333334p-2, 0, 2, 0, 2, 2, 0x1.3333333333334p-2, 2)));
  gcv_outer_face_destroy(face);

  options.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_minkowski_sum(a, b, &options, &face));
  contains_the_box(face);
  CHECK_OK(gcv_no_fit_polygon(a, minus_b, origin, &options, &face));
  contains_the_box(face);
  CHECK_OK(gcv_entrance_block(minus_b, a, origin, &options, &face));
  contains_the_box(face);

  /* What doubles can say is not moved. */
  CHECK_OK(gcv_minkowski_sum(square, square, &options, &face));
  CHECK(face_is(face, RING(0, 0, 2, 0, 2, 2, 0, 2)));
  CHECK(error_bound_of(face) == 0);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(minus_b);
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
}

/* At 1e10, doubles are 2e-6 apart, so that a triangle of 1e-10 is a point there. */
static void too_small(void) {
  const double far[2] = {1e10, 1e10};
  gcv_polygon *tiny = POLYGON(0, 0, 1e-10, 0, 0, 1e-10);
  gcv_outer_face *face = NULL;
  CHECK_STATUS(GCV_ERR_RANGE, gcv_no_fit_polygon(tiny, tiny, far, NULL, &face));
  CHECK_STATUS(GCV_ERR_RANGE, gcv_entrance_block(tiny, tiny, far, NULL, &face));
  CHECK(face == NULL);
  gcv_polygon_destroy(tiny);
}

int main(void) {
  crossing();
  sums_of_doubles();
  reference_is_added_exactly();
  subnormal();
  closing_slit();
  outward();
  too_small();
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Where points lie in the exact region: gcv_region_locate.
 */
#include "regions.h"

static void locate(void) {
  static const double xy[] = {0,
                              0, /* inside */
                              -2,
                              0,
                              6,
                              6,
                              2,
                              2,
                              2,
                              3,
                              2,
                              0x1.8p1 + 0x1p-51, /* boundary */
                              2,
                              0x1.8p2,
                              0x1.8p2,
                              -2,
                              -3,
                              0,
                              2,
                              6.5,
                              1e308,
                              -1e308,
                              2,
                              0x1.fffffffffffffp0,
                              0x1.0000000000001p1,
                              3,
                              -0.0,
                              -0.0};
  static const int8_t places[] = {1, 0, 0, 0, 0, 0, 0, 0, -1, -1, -1, 1, 1, 1};
  enum { COUNT = sizeof places };
  const double bad[] = {0, 0, 1, 1, 2, NAN, 3, 3}, infinite[] = {-INFINITY, 0};
  gcv_polygon *slotted = POLYGON(SLOTTED), *peg = SQUARE(2);
  gcv_region *region = no_fit_region(slotted, peg, 0, GCV_ROUND_NEAREST);
  int8_t out[COUNT + 1];
  size_t k;
  memset(out, 77, sizeof out);
  CHECK_OK(gcv_region_locate(region, NULL, 0, NULL));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "y coordinate of point 2 is ",
                gcv_region_locate(region, bad, 4, out));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "x coordinate of point 0 is ",
                gcv_region_locate(region, infinite, 1, out));
  for (k = 0; k <= COUNT; ++k) CHECK(out[k] == 77);
  CHECK_OK(gcv_region_locate(region, xy, COUNT, out));
  for (k = 0; k < COUNT; ++k) {
    if (!CHECK(out[k] == places[k])) fprintf(stderr, "  point %zu: %d\n", k, out[k]);
  }
  CHECK(out[COUNT] == 77);
  gcv_region_destroy(region);
  gcv_polygon_destroy(slotted);
  gcv_polygon_destroy(peg);
}

/* Against a hole, and with a vertex that is no double. */
static void locate_in_holes(void) {
  static const double xy[] = {2.5, 2.5, 2, 2.5, 2, 2, 1.5, 2.5, 3, 3, 5, 5, 5.5, 5};
  static const int8_t places[] = {-1, 0, 0, 1, 0, 0, -1};
  /* In doubles (23/5, 31/5) is not the vertex, but lies on the edge behind it. */
  const double fifths[] = {4.6, 6.2, 4.6, 6.2 + 0x1p-50, 4.6, 6.2 - 0x1p-50, 4, 6};
  static const int8_t fifths_places[] = {0, -1, 1, 1};
  gcv_polygon *a = polygon_of_rings(&frame), *b = SQUARE(1);
  gcv_polygon *dart = POLYGON(0, 0, 4, 4, 2, 3, 0, 4), *wedge = POLYGON(0, 0, 3, 3, 0, 2);
  gcv_region *region = region_of_sum(a, b), *notched = region_of_sum(dart, wedge);
  int8_t out[7] = {77, 77, 77, 77, 77, 77, 77};
  CHECK_OK(gcv_region_locate(region, xy, 7, out));
  CHECK(memcmp(out, places, sizeof places) == 0);
  CHECK_OK(gcv_region_locate(notched, fifths, 4, out));
  CHECK(memcmp(out, fifths_places, sizeof fifths_places) == 0);
  gcv_region_destroy(region);
  gcv_region_destroy(notched);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(dart);
  gcv_polygon_destroy(wedge);
}

/* Nothing is inside of an empty region. */
static void locate_in_nothing(void) {
  const double origin[2] = {0, 0};
  gcv_polygon *container = SQUARE(1), *large = SQUARE(2);
  gcv_region *region = NULL;
  int8_t out = 77;
  CHECK_OK(gcv_inner_fit_region(container, large, origin, NULL, &region));
  CHECK_OK(gcv_region_locate(region, origin, 1, &out));
  CHECK(out == GCV_OUTSIDE);
  gcv_region_destroy(region);
  gcv_polygon_destroy(container);
  gcv_polygon_destroy(large);
}

int main(void) {
  locate();
  locate_in_holes();
  locate_in_nothing();
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Polygons in place of discs: what is refused, how many vertices there are, and what is seen
 * from the centre. disc_test.cpp of the core certifies the distances in fractions.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "handles.h"

enum { MOST = 1 << 15 };

/* A disc and its vertices. */
struct disc {
  size_t count;
  double xy[2 * MOST];
};

static void read_disc(struct disc *disc, double x, double y, double radius, double tolerance,
                      int32_t rounding) {
  const double centre[2] = {x, y};
  gcv_polygon *polygon = NULL;
  disc->count = 0;
  if (CHECK_OK(gcv_polygon_create_disc(centre, radius, tolerance, rounding, &polygon))) {
    CHECK_OK(gcv_polygon_vertices(polygon, disc->xy, MOST, &disc->count));
  } else {
    fprintf(stderr, "  centre %a %a, radius %a, tolerance %a\n", x, y, radius, tolerance);
  }
  gcv_polygon_destroy(polygon);
}

/* Within the tolerance, as far as long doubles can tell: they are off by some of their units, at
 * this scale. Vertices are on or outside the circle, edges on or inside of it. */
static int is_near(const struct disc *disc, double x, double y, double radius, double tolerance,
                   int32_t rounding) {
  const long double slack =
      64 * LDBL_EPSILON * (fabsl((long double)x) + fabsl((long double)y) + radius);
  const long double most = (long double)radius + tolerance + slack;
  const long double least =
      (long double)radius - (rounding == GCV_ROUND_OUTWARD ? 0 : tolerance) - slack;
  size_t k;
  for (k = 0; k < disc->count; ++k) {
    const double *p = disc->xy + 2 * k, *q = disc->xy + 2 * ((k + 1) % disc->count);
    const long double px = (long double)p[0] - x, py = (long double)p[1] - y;
    const long double qx = (long double)q[0] - x, qy = (long double)q[1] - y;
    const long double edge = hypotl(qx - px, qy - py);
    if (hypotl(px, py) > most || (px * qy - py * qx) < least * edge) return 0;
  }
  return 1;
}

/* Fewer than twice as many vertices as it takes: those of a polygon all of whose edges lie
 * between the two circles. Some units of the last place are for roundings; with no more than
 * those, nothing is promised. */
static int is_frugal(const struct disc *disc, double x, double y, double radius, double tolerance,
                     int32_t rounding) {
  const double size = fabs(x) + fabs(y) + 2 * radius;
  const double rest = tolerance - 16 * fmax(DBL_EPSILON * size, 0x1p-1074);
  const int outward = rounding == GCV_ROUND_OUTWARD;
  /* Of half the angle of an edge: the tangent of its half. */
  const double least = outward ? radius : radius - rest;
  const double squared_tangent = (outward ? rest : 2 * rest) / (radius + rest + least);
  const double needed = acos(-1) / (2 * atan(sqrt(squared_tangent)));
  return rest <= 0 || disc->count == 4 || (double)disc->count < 2 * needed * (1 + 1e-9);
}

static struct disc disc;

static void good(double x, double y, double radius, double tolerance) {
  int32_t rounding;
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    read_disc(&disc, x, y, radius, tolerance, rounding);
    if (!CHECK(disc.count >= 4) || !CHECK(is_near(&disc, x, y, radius, tolerance, rounding)) ||
        !CHECK(is_frugal(&disc, x, y, radius, tolerance, rounding))) {
      fprintf(stderr, "  centre %a %a, radius %a, tolerance %a, rounding %d: %d vertices\n", x, y,
              radius, tolerance, (int)rounding, (int)disc.count);
    }
  }
}

static void all_sizes(void) {
  static const double centres[][2] = {
      {0, 0}, {3, -4}, {0.1, 0.7}, {1e6, 1e-6}, {-1e-3, 12345.678}, {-0.0, 0x1p-1074}};
  static const double radii[] = {1, 0.1, 100, 3.3e5, 1e-3};
  size_t i, j;
  int k;
  for (i = 0; i < sizeof centres / sizeof *centres; ++i) {
    for (j = 0; j < sizeof radii / sizeof *radii; ++j) {
      const double size = fabs(centres[i][0]) + fabs(centres[i][1]) + radii[j];
      for (k = -2; k < 20; ++k) {
        const double tolerance = ldexp(radii[j], -k) * (1 + 0.01 * k);
        if (tolerance > 64 * DBL_EPSILON * size)
          good(centres[i][0], centres[i][1], radii[j], tolerance);
      }
    }
  }
}

/* The same at all scales. */
static void all_scales(void) {
  static const int exponents[] = {-1000, -300, 300, 1000, 1020};
  static struct disc at_one;
  size_t k, i;
  int32_t rounding;
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    read_disc(&at_one, 0.75, -0.5, 1.25, 1e-3, rounding);
    for (k = 0; k < sizeof exponents / sizeof *exponents; ++k) {
      const int e = exponents[k];
      read_disc(&disc, ldexp(0.75, e), ldexp(-0.5, e), ldexp(1.25, e), ldexp(1e-3, e), rounding);
      CHECK(disc.count == at_one.count);
      for (i = 0; i < 2 * disc.count; ++i) CHECK(disc.xy[i] == ldexp(at_one.xy[i], e));
    }
  }
}

/* Of few units of the last place, the smallest double among them. */
static void few_units(void) {
  const double tiny = 0x1p-1074;
  int k;
  for (k = 1; k < 40; ++k) good(0, 0, k * tiny, 8 * tiny);
  for (k = 1; k < 40; ++k) good(k * tiny, -3 * tiny, 0x1p-1050, (20 + k) * tiny);
  good(0x1p53, -0x1p53, 100, 16);
  good(0x1p53, -0x1p53, 2, 16);
  good(1, 1, 1, 32 * DBL_EPSILON * 0x1p20);
  /* Discs that are smaller than the units: squares round the centre. */
  good(1e308, 0, 1e290, 1e294);
  good(0x1p60, 0x1p60, 1, 0x1p12);
  good(0x1p60 - 256, 3, 0x1p-1074, 0x1p12);
  good(-1e300, 1e300, 1e307, 1e306);
}

static int turned_is_there(const struct disc *d, const double *p) {
  size_t k;
  for (k = 0; k < d->count; ++k) {
    if (d->xy[2 * k] == -p[1] && d->xy[2 * k + 1] == p[0]) return 1;
  }
  return 0;
}

static void quarter_turns(void) {
  static const double radii[] = {1, 0.1, 1e100, 3e-310, 0x1p-1074};
  size_t j, k;
  int32_t rounding;
  for (rounding = GCV_ROUND_NEAREST; rounding <= GCV_ROUND_OUTWARD; ++rounding) {
    for (j = 0; j < sizeof radii / sizeof *radii; ++j) {
      const double r = radii[j], tolerance = fmax(r / 1e4, 16 * 0x1p-1074);
      read_disc(&disc, 0, 0, r, tolerance, rounding);
      CHECK(disc.count % 4 == 0);
      for (k = 0; k < disc.count; ++k) CHECK(turned_is_there(&disc, disc.xy + 2 * k));
    }
  }
  /* And elsewhere, where the centre has no finer digits. */
  read_disc(&disc, 96, -96, 10, 1e-3, GCV_ROUND_OUTWARD);
  for (k = 0; k < disc.count; ++k) {
    disc.xy[2 * k] -= 96;
    disc.xy[2 * k + 1] += 96;
  }
  for (k = 0; k < disc.count; ++k) CHECK(turned_is_there(&disc, disc.xy + 2 * k));
}

static void is_refused(gcv_status status, const char *part, double x, double y, double radius,
                       double tolerance, int32_t rounding) {
  const double centre[2] = {x, y};
  gcv_polygon *out = NULL;
  CHECK_REFUSED(status, part, gcv_polygon_create_disc(centre, radius, tolerance, rounding, &out));
  CHECK(out == NULL);
}

static void refusals(void) {
  static const double bad[] = {NAN, INFINITY, -INFINITY};
  static const double not_above[] = {0, -0.0, -1, -0x1p-1074, -DBL_MAX};
  static const int32_t roundings[] = {-1, 2, INT32_MAX, INT32_MIN};
  size_t k;
  int32_t r;
  for (k = 0; k < 3; ++k) {
    is_refused(GCV_ERR_NOT_FINITE, "the x coordinate of the centre", bad[k], 0, 1, 0.1, 0);
    is_refused(GCV_ERR_NOT_FINITE, "the y coordinate of the centre", 0, bad[k], 1, 0.1, 1);
    is_refused(GCV_ERR_NOT_FINITE, "radius", 0, 0, bad[k], 0.1, 0);
    is_refused(GCV_ERR_INVALID_ARGUMENT, "tolerance", 0, 0, 1, bad[k], 0);
  }
  for (k = 0; k < sizeof not_above / sizeof *not_above; ++k) {
    is_refused(GCV_ERR_INVALID_ARGUMENT, "radius", 0, 0, not_above[k], 0.1, 0);
    is_refused(GCV_ERR_INVALID_ARGUMENT, "tolerance", 0, 0, 1, not_above[k], 0);
  }
  for (k = 0; k < sizeof roundings / sizeof *roundings; ++k) {
    is_refused(GCV_ERR_INVALID_ARGUMENT, "rounding", 0, 0, 1, 0.1, roundings[k]);
  }
  for (r = GCV_ROUND_NEAREST; r <= GCV_ROUND_OUTWARD; ++r) {
    is_refused(GCV_ERR_INVALID_ARGUMENT, "too small for doubles", 0, 0, 1, 1e-16, r);
    is_refused(GCV_ERR_INVALID_ARGUMENT, "too small for doubles", 0, 0, 1, 0x1p-1074, r);
    is_refused(GCV_ERR_INVALID_ARGUMENT, "too small for doubles", 0x1p53, 0, 1, 0.25, r);
    is_refused(GCV_ERR_INVALID_ARGUMENT, "too small for doubles", 1e308, 0, 1, 1e-3, r);
    /* Where the vertices of so many would fall together, which is said before they are made. */
    is_refused(GCV_ERR_INVALID_ARGUMENT, "too small for doubles", 0x1p60, 0, 700, 0x1.0004p9, r);
    is_refused(GCV_ERR_RANGE, "too near the largest double", 0, 0, DBL_MAX, 1, r);
    is_refused(GCV_ERR_RANGE, "too near the largest double", DBL_MAX, 0, DBL_MAX, 1e300, r);
    is_refused(GCV_ERR_RANGE, "too near the largest double", 0, -DBL_MAX, 1e307, 1e300, r);
  }
}

/* In a sum, as clearances are made. */
static void clearance(void) {
  gcv_polygon *part = POLYGON(0, 0, 10, 0, 10, 5, 0, 5), *round = NULL;
  const double origin[2] = {0, 0};
  gcv_outer_face *face;
  double area = 0, bounds[4];
  CHECK_OK(gcv_polygon_create_disc(origin, 2, 0.01, GCV_ROUND_OUTWARD, &round));
  face = sum_of(part, round);
  CHECK_OK(gcv_outer_face_area(face, &area));
  CHECK(area >= 50 + 2 * 30 + 4 * acos(-1) && area <= 50 + 2.01 * 30 + 2.01 * 2.01 * acos(-1));
  CHECK_OK(gcv_polygon_bounds(round, bounds));
  CHECK(bounds[0] <= -2 && bounds[1] <= -2 && bounds[2] >= 2 && bounds[3] >= 2);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(round);
  gcv_polygon_destroy(part);
}

int main(void) {
  all_sizes();
  all_scales();
  few_units();
  quarter_turns();
  refusals();
  clearance();
  return check_failures != 0;
}

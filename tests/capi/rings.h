/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Polygons of several rings, in all the ways in which the same rings can be passed.
 */
#ifndef GCV_TESTS_CAPI_RINGS_H
#define GCV_TESTS_CAPI_RINGS_H

#include <math.h>
#include <stdlib.h>

#include "handles.h"

enum { MOST_RINGS = 8 };

/* The vertices of all rings, and how many each one has. */
struct rings {
  size_t count;
  size_t sizes[MOST_RINGS];
  double xy[2 * MOST_VERTICES];
};

static inline gcv_status create_rings(const struct rings *rings, gcv_polygon **out) {
  return gcv_polygon_create_rings(rings->xy, rings->sizes, rings->count, 0, out);
}

static inline gcv_polygon *polygon_of_rings(const struct rings *rings) {
  gcv_polygon *polygon = NULL;
  CHECK_OK(create_rings(rings, &polygon));
  return polygon;
}

static inline int ring_is(const gcv_polygon *polygon, size_t ring, const double *expected,
                          size_t count) {
  double xy[2 * MOST_VERTICES] = {0};
  size_t required = 0;
  CHECK_OK(gcv_polygon_ring(polygon, ring, xy, MOST_VERTICES, &required));
  return same_ring(xy, required, expected, count);
}

/* The rings from vertex `shift` of each on, ring k the other way round where bit k of `reversed`
 * is set, and closed or not. */
static inline struct rings passed_otherwise(const struct rings *rings, size_t shift,
                                            unsigned reversed, int closed) {
  struct rings other = {0, {0}, {0}};
  const double *xy = rings->xy;
  double *to = other.xy;
  size_t k, i;
  other.count = rings->count;
  for (k = 0; k < rings->count; ++k) {
    const size_t n = rings->sizes[k];
    other.sizes[k] = n + (closed ? 1 : 0);
    for (i = 0; i < other.sizes[k]; ++i) {
      const size_t forwards = (shift + i) % n;
      const size_t from = (reversed >> k & 1U) != 0 ? n - 1 - forwards : forwards;
      *to++ = xy[2 * from];
      *to++ = xy[2 * from + 1];
    }
    xy += 2 * n;
  }
  return other;
}

/* One of the eight maps of a square onto itself, and then in another unit. */
static inline struct rings seen_otherwise(const struct rings *rings, int symmetry, int exponent) {
  struct rings other = *rings;
  size_t vertices = 0, k;
  for (k = 0; k < rings->count; ++k) vertices += rings->sizes[k];
  for (k = 0; k < vertices; ++k) {
    const double x = rings->xy[2 * k] * ((symmetry & 1) != 0 ? -1 : 1);
    const double y = rings->xy[2 * k + 1] * ((symmetry & 2) != 0 ? -1 : 1);
    other.xy[2 * k] = ldexp((symmetry & 4) != 0 ? y : x, exponent);
    other.xy[2 * k + 1] = ldexp((symmetry & 4) != 0 ? x : y, exponent);
  }
  return other;
}

#endif

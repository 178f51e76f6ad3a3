/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Which rings are refused, and do the two edges that the message names meet? Decided once
 * more here, by testing every pair of edges in small integers.
 */
#include <stdint.h>

#include "handles.h"

enum { MOST = 24 };

struct point {
  int64_t x, y;
};

/* A ring without repeated vertices. Edge i joins points i and i+1; `number` is the
 * caller's number of it. */
struct ring {
  size_t size;
  struct point point[MOST];
  unsigned number[MOST];
};

static int equal(struct point p, struct point q) { return p.x == q.x && p.y == q.y; }

static int64_t cross(struct point p, struct point q, struct point r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

static int64_t dot(struct point p, struct point q, struct point r) {
  return (q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y);
}

static int side(struct point p, struct point q, struct point r) {
  const int64_t c = cross(p, q, r);
  return (c > 0) - (c < 0);
}

static int on_segment(struct point p, struct point q, struct point r) {
  return cross(p, q, r) == 0 && dot(r, p, q) <= 0;
}

static int segments_meet(struct point p, struct point q, struct point r, struct point s) {
  return (side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0) ||
         on_segment(p, q, r) || on_segment(p, q, s) || on_segment(r, s, p) || on_segment(r, s, q);
}

/* Do edges i and j meet, other than as neighbours in their common vertex? */
static int conflict(const struct ring *ring, size_t i, size_t j) {
  const struct point *point = ring->point;
  const size_t i1 = (i + 1) % ring->size, j1 = (j + 1) % ring->size;
  if (i1 == j)
    return cross(point[i], point[j], point[j1]) == 0 && dot(point[j], point[i], point[j1]) > 0;
  if (j1 == i)
    return cross(point[j], point[i], point[i1]) == 0 && dot(point[i], point[j], point[i1]) > 0;
  return segments_meet(point[i], point[i1], point[j], point[j1]);
}

static struct ring ring_of(const struct point *points, size_t count) {
  struct ring ring = {0};
  size_t k;
  for (k = 0; k < count; ++k) {
    if (equal(points[k], points[(k + 1) % count])) continue;
    ring.point[ring.size] = points[k];
    ring.number[ring.size++] = (unsigned)k;
  }
  return ring;
}

static gcv_status expected_status(const struct ring *ring) {
  size_t i, j;
  int collinear = 1;
  for (i = 2; i < ring->size; ++i) {
    if (cross(ring->point[0], ring->point[1], ring->point[i]) != 0) collinear = 0;
  }
  if (collinear) return GCV_ERR_DEGENERATE;
  for (i = 0; i < ring->size; ++i) {
    for (j = i + 1; j < ring->size; ++j) {
      if (conflict(ring, i, j)) return GCV_ERR_NOT_SIMPLE;
    }
  }
  return GCV_OK;
}

/* The place of the caller's edge in the ring, or the ring's size. */
static size_t find_edge(const struct ring *ring, unsigned number) {
  size_t k = 0;
  while (k < ring->size && ring->number[k] != number) ++k;
  return k;
}

static int message_is_right(const struct ring *ring) {
  const char *at = strstr(gcv_last_error_message(), "edges ");
  unsigned e = 0, f = 0;
  size_t i, j;
  if (at == NULL || sscanf(at, "edges %u and %u", &e, &f) != 2) return 0;
  i = find_edge(ring, e);
  j = find_edge(ring, f);
  return i < ring->size && j < ring->size && i != j && conflict(ring, i, j);
}

/* The ring (x * scale + shift, y * scale) gets the status that its shape deserves. */
static gcv_status classify(const struct point *points, size_t count, double scale, double shift) {
  const struct ring ring = ring_of(points, count);
  const gcv_status expected = expected_status(&ring);
  double xy[2 * MOST];
  gcv_polygon *polygon = NULL;
  size_t k;
  int as_expected;
  for (k = 0; k < count; ++k) {
    xy[2 * k] = (double)points[k].x * scale + shift;
    xy[2 * k + 1] = (double)points[k].y * scale;
  }
  as_expected = CHECK_STATUS(expected, gcv_polygon_create(xy, count, 0, &polygon));
  if (expected == GCV_ERR_NOT_SIMPLE) as_expected = as_expected && CHECK(message_is_right(&ring));
  CHECK((polygon != NULL) == (expected == GCV_OK));
  gcv_polygon_destroy(polygon);
  if (!as_expected) {
    fprintf(stderr, "  the ring, times %g:", scale);
    for (k = 0; k < count; ++k) fprintf(stderr, " (%d, %d)", (int)points[k].x, (int)points[k].y);
    fprintf(stderr, "\n");
  }
  return expected;
}

#define NOT_SIMPLE(...)                                                                 \
  CHECK(classify((const struct point[]){__VA_ARGS__},                                   \
                 sizeof((const struct point[]){__VA_ARGS__}) / sizeof(struct point), 1, \
                 0) == GCV_ERR_NOT_SIMPLE)

static void kinds(void) {
  NOT_SIMPLE({0, 0}, {2, 2}, {2, 0}, {0, 2});                 /* bow-tie */
  NOT_SIMPLE({0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4});         /* vertex on an edge */
  NOT_SIMPLE({0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}); /* vertex met twice */
  NOT_SIMPLE({0, 0}, {4, 0}, {4, 4}, {6, 6}, {4, 4}, {0, 4}); /* spike */
  NOT_SIMPLE({0, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4});         /* turning back */
  NOT_SIMPLE({0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 6}, {0, 2}); /* and at the end */
  NOT_SIMPLE({0, 0}, {6, 0}, {6, 3}, {5, 0}, {1, 0}, {0, 3}); /* overlapping edges */
  NOT_SIMPLE({0, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}, {5, 5}, {7, 5}, {5, 7}); /* two loops */
  NOT_SIMPLE({0, 0}, {2, 0}, {1, 2}, {0, 0}, {2, 0}, {1, 2});                 /* twice round */
  NOT_SIMPLE({0, 0}, {0, 0}, {1, 1}, {2, 2}, {2, 2}, {2, 0}, {2, 0}, {0, 2}, {0, 0});
}

/* Random rings on few points meet themselves in every way. The scales take the exact
 * arithmetic through its range; products with them are exact. */
static void random_rings(void) {
  static const double scales[] = {1, 0x1p-1074, 0x1p1020, 0.375};
  uint64_t state = 1;
  unsigned seen[3] = {0, 0, 0};
  int round;
  for (round = 0; round < 20000; ++round) {
    struct point points[9];
    size_t count, k;
    gcv_status status;
    state = state * 6364136223846793005u + 1442695040888963407u;
    count = 3 + (size_t)(state >> 33) % 7;
    for (k = 0; k < count; ++k) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      points[k].x = (int64_t)(state >> 33) % 5;
      points[k].y = (int64_t)(state >> 43) % 4;
    }
    status = classify(points, count, scales[round % 4], round % 8 == 4 ? 0x1p51 : 0);
    ++seen[status == GCV_OK ? 0 : status == GCV_ERR_DEGENERATE ? 1 : 2];
  }
  CHECK(seen[0] > 1000 && seen[1] > 100 && seen[2] > 1000);
}

int main(void) {
  kinds();
  random_rings();
  return check_failures != 0;
}

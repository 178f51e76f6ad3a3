/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The explicit superset: its edges, worked out by hand from the paper's definitions, and
 * their order.
 */
#include "handles.h"

enum { MOST_EDGES = 16 };

static void edges_are(const gcv_polygon *a, const gcv_polygon *b, const gcv_superset_edge *expected,
                      size_t count) {
  gcv_superset *superset = NULL;
  gcv_superset_edge edges[MOST_EDGES];
  size_t required = 0, k, byte;
  memset(edges, 0xa5, sizeof edges);
  CHECK_OK(gcv_superset_create(a, b, &superset));
  CHECK_OK(gcv_superset_edges(superset, edges, MOST_EDGES, &required));
  CHECK(required == count);
  for (k = 0; k < count; ++k) {
    const gcv_superset_edge *e = &edges[k], *f = &expected[k];
    if (!CHECK(e->x0 == f->x0 && e->y0 == f->y0 && e->x1 == f->x1 && e->y1 == f->y1) ||
        !CHECK(memcmp(&e->source, &f->source, sizeof e->source) == 0)) {
      fprintf(stderr, "  edge %d is {%g, %g, %g, %g, {%d, %u, %u}}\n", (int)k, e->x0, e->y0, e->x1,
              e->y1, (int)e->source.kind, e->source.a, e->source.b);
    }
    for (byte = offsetof(gcv_superset_edge, source) + sizeof e->source; byte < sizeof *e; ++byte) {
      CHECK(((const unsigned char *)e)[byte] == 0); /* no byte is left to chance */
    }
  }
  gcv_superset_destroy(superset);
}

#define EDGES(...)                          \
  (const gcv_superset_edge[]){__VA_ARGS__}, \
      sizeof((const gcv_superset_edge[]){__VA_ARGS__}) / sizeof(gcv_superset_edge)

/* Four pairs of edges of one direction, all merged. */
static void squares(void) {
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  edges_are(square, square,
            EDGES({0, 0, 2, 0, {3, 0, 0}}, {2, 0, 2, 2, {3, 1, 1}}, {2, 2, 0, 2, {3, 2, 2}},
                  {0, 2, 0, 0, {3, 3, 3}}));
  gcv_polygon_destroy(square);
}

/* No two directions alike: one translated and one corner edge for each edge. */
static void triangles(void) {
  gcv_polygon *triangle = POLYGON(0, 0, 2, 0, 0, 1), *turned = POLYGON(0, 0, -2, 0, 0, -1);
  edges_are(triangle, turned,
            EDGES({0, -1, 2, -1, {1, 0, 2}}, {2, 0, 0, 1, {1, 1, 0}}, {-2, 1, -2, 0, {1, 2, 1}},
                  {-2, 0, 0, -1, {2, 0, 1}}, {2, -1, 2, 0, {2, 1, 2}}, {0, 1, -2, 1, {2, 2, 0}}));
  gcv_polygon_destroy(triangle);
  gcv_polygon_destroy(turned);
}

/* All three kinds. The order is that of the normalised ring, whatever the numbers. */
static void kinds(void) {
  gcv_polygon *dart = POLYGON(0, 0, 4, 4, 2, 3, 0, 4), *wedge = POLYGON(0, 0, 3, 3, 0, 2);
  gcv_polygon *clockwise = POLYGON(0, 0, 0, 4, 2, 3, 4, 4);
  edges_are(dart, wedge,
            EDGES({4, 6, 2, 5, {1, 1, 2}}, {5, 6, 3, 7, {1, 2, 1}}, {7, 7, 4, 6, {2, 1, 1}},
                  {3, 7, 0, 6, {2, 3, 1}}, {0, 0, 7, 7, {3, 0, 0}}, {0, 6, 0, 0, {3, 3, 2}}));
  edges_are(clockwise, wedge,
            EDGES({4, 6, 2, 5, {1, 2, 2}}, {5, 6, 3, 7, {1, 1, 1}}, {7, 7, 4, 6, {2, 3, 1}},
                  {3, 7, 0, 6, {2, 1, 1}}, {0, 0, 7, 7, {3, 3, 0}}, {0, 6, 0, 0, {3, 0, 2}}));
  gcv_polygon_destroy(clockwise);
  gcv_polygon_destroy(wedge);
  gcv_polygon_destroy(dart);
}

/* Translated-corner edges in all three cases: of the two edges to the left at y = 1, only
 * the starts are convex (case 2, as long as the longer one); of the two upwards at x = 1,
 * only the ends (case 3); all others are case 1. */
static void cases(void) {
  gcv_polygon *a = POLYGON(0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2);
  gcv_polygon *b = POLYGON(0, 0, 4, 0, 4, 1, 1, 1, 1, 3, 0, 3);
  edges_are(a, b,
            EDGES({0, 0, 6, 0, {3, 0, 0}}, {6, 0, 6, 2, {3, 1, 1}}, {3, 1, 3, 4, {3, 1, 3}},
                  {6, 2, 3, 2, {3, 2, 2}}, {3, 4, 1, 4, {3, 2, 4}}, {5, 1, 5, 3, {3, 3, 1}},
                  {2, 3, 2, 5, {3, 3, 3}}, {5, 3, 1, 3, {3, 4, 2}}, {2, 5, 0, 5, {3, 4, 4}},
                  {0, 5, 0, 0, {3, 5, 5}}));
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
}

static void rounded(void) {
  gcv_polygon *a = POLYGON(0.1, 0, 1, 0, 1, 1), *b = POLYGON(0.2, 0, 1, 0, 1, 1);
  const double x = 0x1.3333333333334p-2, y = 0x1.199999999999ap+0; /* 0.1 + 0.2, 0.1 + 1 */
  edges_are(a, b,
            EDGES({2, 2, y, 1, {1, 2, 2}}, {y, 1, x, 0, {2, 0, 2}}, {x, 0, 2, 0, {3, 0, 0}},
                  {2, 0, 2, 2, {3, 1, 1}}));
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
}

int main(void) {
  squares();
  triangles();
  kinds();
  cases();
  rounded();
  return check_failures != 0;
}

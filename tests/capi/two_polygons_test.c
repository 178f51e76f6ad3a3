/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Two polygons: gcv_relation, gcv_distance, gcv_cast, gcv_penetration, gcv_contacts.
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

/* Boundaries that meet in vertices and along edges with a common end alone. Inside of such an edge
 * a reflex vertex of the other polygon begins to overlap. */
static void overlap_along_edges_with_a_common_end(void) {
  static const double here[] = {0, 0};
  int8_t out[2] = {77, 77};
  gcv_polygon *a = POLYGON(8, 6, 5, 3, 3, 0, 0, 0, 0, -5, 12, -5, 12, 6);
  gcv_polygon *b = POLYGON(0, 0, 6, 0, 6, 4, 8, 6, 8, 12, 0, 12);
  CHECK_OK(gcv_relation(a, b, here, 1, NULL, &out[0]));
  CHECK_OK(gcv_relation(b, a, here, 1, NULL, &out[1]));
  CHECK(out[0] == GCV_OVERLAPPING && out[1] == GCV_OVERLAPPING);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
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

/* A U with a slot of width 2, and a square of side 2 that fits into it exactly. */
static void escapes(void) {
  static const double starts[] = {0.25, -1.75, 0, 0, 9, 9, 2.25, 3};
  static const double depths[] = {0.25, 2, 0, 0.25};
  static const double ways[] = {0, -0.25, -2, 0, 0, 0, -0.25, 0};
  gcv_polygon *square = SQUARE(2), *u = POLYGON(0, 0, 6, 0, 6, 6, 4, 6, 4, 2, 2, 2, 2, 6, 0, 6);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_escape escapes[4], other;
  size_t k;
  CHECK_OK(gcv_penetration(u, square, NULL, 0, NULL, NULL));
  CHECK_OK(gcv_penetration(u, square, starts, 4, NULL, escapes));
  for (k = 0; k < 4; ++k) {
    const gcv_escape *e = &escapes[k];
    CHECK(e->depth == depths[k] && e->reserved == 0);
    CHECK(e->translation[0] == ways[2 * k] && e->translation[1] == ways[2 * k + 1]);
    CHECK(e->position[0] == starts[2 * k] + ways[2 * k]);
    CHECK(e->position[1] == starts[2 * k + 1] + ways[2 * k + 1]);
    CHECK(e->relation == (k == 2 ? GCV_APART : GCV_TOUCHING));
    CHECK((e->contact.kind == 0) == (k == 2) && e->contact.gap == 0);
  }
  /* In the slot, at (2, 3): the edge from (4, 6) to (4, 2) and the vertex (2, 0) of the square. */
  CHECK(escapes[3].contact.kind == GCV_CONTACT_EDGE_VERTEX);
  CHECK(escapes[3].contact.a == 3 && escapes[3].contact.b == 1);
  CHECK(escapes[3].contact.normal[0] == -1 && escapes[3].contact.normal[1] == 0);
  CHECK(escapes[3].contact.on_a[0] == 4 && escapes[3].contact.on_b[1] == 3);
  options.leave_out = GCV_LEAVE_OUT_FITS;
  CHECK_OK(gcv_penetration(u, square, starts + 6, 1, &options, &other));
  CHECK(other.depth == 3 && other.translation[0] == 0 && other.translation[1] == 3);
  options.tolerance = 1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "options: tolerance is 1;",
                gcv_penetration(u, square, starts, 0, &options, &other));
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(u);
}

/* A square of side 1 in a square hole of side 4, nearer to the hole than to the outside, and the
 * other way round. */
static void escapes_with_holes_left_out(void) {
  static const double xy[] = {0, 0, 8, 0, 8, 8, 0, 8, 2, 2, 6, 2, 6, 6, 2, 6};
  static const size_t sizes[] = {4, 4};
  static const double starts[] = {1.5, 4, 0.25, 4, 3, 3};
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_polygon *square = SQUARE(1), *room = NULL;
  gcv_escape e[3];
  CHECK_OK(gcv_polygon_create_rings(xy, sizes, 2, 0, &room));
  CHECK_OK(gcv_penetration(room, square, starts, 3, NULL, e));
  CHECK(e[0].depth == 0.5 && e[1].depth == 1.25 && e[2].depth == 0);
  CHECK(e[0].translation[0] == 0.5 && e[1].translation[0] == -1.25);
  options.leave_out = GCV_LEAVE_OUT_HOLES;
  CHECK_OK(gcv_penetration(room, square, starts, 3, &options, e));
  CHECK(e[0].depth == 2.5 && e[0].translation[0] == -2.5 && e[1].depth == 1.25);
  CHECK(e[2].depth == 0 && e[2].relation == GCV_APART);
  options.leave_out = GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS;
  CHECK_OK(gcv_penetration(room, square, starts, 3, &options, e));
  CHECK(e[0].depth == 2.5 && e[0].position[0] == -1 && e[0].position[1] == 4);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(room);
}

/* The outer ring goes on along the line of the edge that it leaves by. */
static void escape_beyond_the_end_of_an_edge(void) {
  static const double t[] = {3.875, 0.9};
  gcv_polygon *hook = POLYGON(0, 0, 0, 7, 3, 7, 3, 1, 4, 1, 4, 0);
  gcv_polygon *small = POLYGON(0, 0, 0.0068359375, 0.0009765625, 0.001953125, 0);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_escape e;
  options.leave_out = GCV_LEAVE_OUT_HOLES;
  CHECK_OK(gcv_penetration(hook, small, t, 1, &options, &e));
  CHECK(e.position[0] == 3.875 && e.position[1] == 1 && e.relation == GCV_TOUCHING);
  CHECK(e.contact.kind == GCV_CONTACT_EDGE_VERTEX && e.contact.a == 3 && e.contact.b == 0);
  gcv_polygon_destroy(hook);
  gcv_polygon_destroy(small);
}

/* An edge that is level but for the smallest double, beside 24 others. */
static void escape_from_a_nearly_level_edge(void) {
  static const double t[] = {0, 0};
  gcv_polygon *a = POLYGON(0, 0, 7, 7, 8, 7, 5, 4, 6, 4, 2, 0);
  gcv_polygon *comb = POLYGON(0, 5e-324, 0, 15, 41, .5, 42, .5, 42, 7, 43, 7, 43, .5, 44, .5, 44,
                              16, 45, 16, 45, .5, 46, .5, 46, 7, 47, 7, 47, .5, 48, .5, 48, 15, 49,
                              15, 49, .5, 50, .5, 50, 7, 51, 7, 51, .5, 52, .5, 52, 0);
  gcv_escape e;
  CHECK_OK(gcv_penetration(a, comb, t, 1, NULL, &e));
  CHECK(e.depth == 7 && e.position[0] == 0 && e.position[1] == 7);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(comb);
}

/* Two squares of side 2 whose faces share a part: its two ends. */
static void contacts(void) {
  static const double t[] = {2, 1}, above[] = {0.5, 2.25}, deep[] = {1.75, 1};
  gcv_polygon *square = SQUARE(2);
  gcv_contact_list *list = NULL;
  gcv_contact out[8];
  uint64_t previous[8];
  size_t required = 0;
  CHECK_OK(gcv_contacts(square, square, t, 0, 0, NULL, &list));
  CHECK_OK(gcv_contact_list_contacts(list, NULL, 0, &required));
  CHECK(required == 2);
  CHECK(gcv_contact_list_contacts(list, out, 1, &required) == GCV_ERR_BUFFER_TOO_SMALL);
  CHECK_OK(gcv_contact_list_contacts(list, out, 8, &required));
  CHECK(out[0].kind == GCV_CONTACT_EDGE_VERTEX && out[0].a == 1 && out[0].b == 0);
  CHECK(out[1].kind == GCV_CONTACT_VERTEX_EDGE && out[1].a == 2 && out[1].b == 3);
  CHECK(out[0].gap == 0 && out[0].normal[0] == 1 && out[0].normal[1] == 0);
  CHECK(out[0].on_a[0] == 2 && out[0].on_a[1] == 1 && out[1].on_b[1] == 2);
  CHECK(out[0].id_a == 0 && out[0].id_b == 0 && out[0].reserved == 0);
  CHECK_OK(gcv_contact_list_previous(list, previous, 8, &required));
  CHECK(required == 2 && previous[0] == UINT64_MAX && previous[1] == UINT64_MAX);
  gcv_contact_list_destroy(list);
  CHECK_OK(gcv_contacts(square, square, above, 0.125, 3, NULL, &list));
  CHECK_OK(gcv_contact_list_contacts(list, out, 8, &required));
  CHECK(required == 0);
  gcv_contact_list_destroy(list);
  CHECK_OK(gcv_contacts(square, square, deep, 0.25, 0, NULL, &list));
  CHECK_OK(gcv_contact_list_contacts(list, out, 8, &required));
  CHECK(required == 2 && out[0].gap == -0.25 && out[1].gap == -0.25);
  gcv_contact_list_destroy(list);
  gcv_polygon_destroy(square);
}

static void refused_contacts(void) {
  static const double t[] = {0, 0}, bad[] = {0, INFINITY};
  gcv_polygon *square = SQUARE(2);
  gcv_contact_list *list = NULL;
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "translation: number 0",
                gcv_contacts(square, square, bad, 0, 0, NULL, &list));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "distance is",
                gcv_contacts(square, square, t, NAN, 0, NULL, &list));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "distance is",
                gcv_contacts(square, square, t, -1, 0, NULL, &list));
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "slope is",
                gcv_contacts(square, square, t, 0, INFINITY, NULL, &list));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "slope is",
                gcv_contacts(square, square, t, 0, -1, NULL, &list));
  CHECK(list == NULL);
  gcv_polygon_destroy(square);
}

static void refusals(void) {
  const double bad[] = {0, 0, 1, NAN}, far[] = {0, 0, 1.7e308, 0}, good[] = {0, 0, 0, 0};
  const double corner[] = {-1.7e308, 0, -1.6e308, 0, -1.7e308, 1e307};
  gcv_polygon *square = SQUARE(2), *distant = NULL;
  int8_t relation[2] = {77, 77};
  gcv_separation separation[2];
  gcv_impact impact[2];
  gcv_escape escape[2];
  escape[0].depth = 77;
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
  CHECK_REFUSED(GCV_ERR_NOT_FINITE, "translations: number 1",
                gcv_penetration(square, square, bad, 2, NULL, escape));
  CHECK(escape[0].depth == 77);
  CHECK(relation[0] == 77 && separation[0].distance == 77 && impact[0].time == 77);
  CHECK_OK(gcv_relation(distant, square, far, 2, NULL, relation));
  CHECK(relation[0] == GCV_APART && relation[1] == GCV_APART);
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(distant);
}

int main(void) {
  relations_and_distances();
  overlap_along_edges_with_a_common_end();
  casts();
  escapes();
  escapes_with_holes_left_out();
  escape_beyond_the_end_of_an_edge();
  escape_from_a_nearly_level_edge();
  contacts();
  refused_contacts();
  refusals();
  return check_failures != 0;
}

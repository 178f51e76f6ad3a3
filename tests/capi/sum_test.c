/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Outer faces of sums, no-fit polygons and entrance blocks, worked out by hand.
 */
#include <math.h>

#include "handles.h"

static gcv_polygon *square, *triangle, *turned_triangle, *dart, *wedge;

static void make_polygons(void) {
  square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  triangle = POLYGON(0, 0, 2, 0, 0, 1);
  turned_triangle = POLYGON(0, 0, -2, 0, 0, -1);
  dart = POLYGON(0, 0, 4, 4, 2, 3, 0, 4);
  wedge = POLYGON(0, 0, 3, 3, 0, 2);
}

static void destroy_polygons(void) {
  gcv_polygon_destroy(square);
  gcv_polygon_destroy(triangle);
  gcv_polygon_destroy(turned_triangle);
  gcv_polygon_destroy(dart);
  gcv_polygon_destroy(wedge);
}

static double area_of(const gcv_outer_face *face) {
  double area = -1;
  CHECK_OK(gcv_outer_face_area(face, &area));
  return area;
}

static double error_bound_of(const gcv_outer_face *face) {
  double bound = -1;
  CHECK_OK(gcv_outer_face_error_bound(face, &bound));
  return bound;
}

static int wkt_is(const gcv_outer_face *face, const char *expected) {
  char text[MOST_TEXT] = "";
  size_t required = 0;
  CHECK_OK(gcv_outer_face_wkt(face, text, sizeof text, &required));
  CHECK(required == strlen(text) + 1);
  return strcmp(text, expected) == 0;
}

/* The same handle twice, and handles that die before the face. */
static void square_and_square(void) {
  gcv_polygon *once = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  gcv_outer_face *face = sum_of(once, once);
  gcv_polygon_destroy(once);
  CHECK(exact_ring_is(face, "0/1 0/1, 2/1 0/1, 2/1 2/1, 0/1 2/1"));
  CHECK(face_is(face, RING(0, 0, 2, 0, 2, 2, 0, 2)));
  CHECK(area_of(face) == 4);
  CHECK(error_bound_of(face) == 0);
  CHECK(wkt_is(face, "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"));
  gcv_outer_face_destroy(face);
}

static void hexagon(void) {
  gcv_outer_face *face = sum_of(triangle, turned_triangle);
  CHECK(exact_ring_is(face, "-2/1 0/1, 0/1 -1/1, 2/1 -1/1, 2/1 0/1, 0/1 1/1, -2/1 1/1"));
  CHECK(face_is(face, RING(-2, 0, 0, -1, 2, -1, 2, 0, 0, 1, -2, 1)));
  CHECK(area_of(face) == 6);
  gcv_outer_face_destroy(face);
}

/* At the notch of the dart, the line from (7, 7) along (-3, -1) meets the one from (5, 6)
 * along (-2, 1): in (23/5, 31/5). */
static void crossing(void) {
  gcv_outer_face *face = sum_of(dart, wedge), *swapped = sum_of(wedge, dart);
  CHECK(exact_ring_is(face, "0/1 0/1, 7/1 7/1, 23/5 31/5, 3/1 7/1, 0/1 6/1"));
  CHECK(face_is(face, RING(0, 0, 7, 7, 4.6, 6.2, 3, 7, 0, 6)));
  CHECK(face_is(swapped, RING(0, 0, 7, 7, 4.6, 6.2, 3, 7, 0, 6)));
  CHECK(wkt_is(face, "POLYGON ((0 0, 7 7, 4.6 6.2, 3 7, 0 6, 0 0))"));
  gcv_outer_face_destroy(face);
  gcv_outer_face_destroy(swapped);
}

/* A frame with a slit, of width 1, in its right side: wide squares close it, one that
 * just fits does, too, and narrow ones leave it open. */
static void frame(void) {
  gcv_polygon *slit_frame =
      POLYGON(0, 0, 12, 0, 12, 5, 11, 5, 11, 1, 1, 1, 1, 11, 11, 11, 11, 6, 12, 6, 12, 12, 0, 12);
  gcv_polygon *half = POLYGON(0, 0, 0.5, 0, 0.5, 0.5, 0, 0.5);
  gcv_polygon *two = POLYGON(0, 0, 2, 0, 2, 2, 0, 2);
  gcv_outer_face *closed = sum_of(slit_frame, two), *fits = sum_of(slit_frame, square),
                 *open = sum_of(slit_frame, half);
  CHECK(face_is(closed, RING(0, 0, 14, 0, 14, 14, 0, 14)));
  CHECK(face_is(fits, RING(0, 0, 13, 0, 13, 13, 0, 13)));
  CHECK(face_is(open, RING(0, 0, 12.5, 0, 12.5, 5.5, 11, 5.5, 11, 1.5, 1.5, 1.5, 1.5, 11, 11, 11,
                           11, 6, 12.5, 6, 12.5, 12.5, 0, 12.5)));
  gcv_outer_face_destroy(closed);
  gcv_outer_face_destroy(fits);
  gcv_outer_face_destroy(open);
  gcv_polygon_destroy(two);
  gcv_polygon_destroy(half);
  gcv_polygon_destroy(slit_frame);
}

static void no_fit_polygon(void) {
  const double reference[2] = {10, -1};
  gcv_outer_face *face = NULL;
  CHECK_OK(gcv_no_fit_polygon(triangle, triangle, reference, NULL, &face));
  CHECK(face_is(face, RING(8, -1, 10, -2, 12, -2, 12, -1, 10, 0, 8, 0)));
  gcv_outer_face_destroy(face);
  CHECK_OK(gcv_no_fit_polygon(square, triangle, reference, NULL, &face));
  CHECK(face_is(face, RING(8, -1, 10, -2, 11, -2, 11, 0, 8, 0)));
  gcv_outer_face_destroy(face);
}

/* A part that just fits a slot: its way in is a slit without width, which lies inside the ring.
   A part that leaves a gap, however narrow, has its way in on the ring. */
static void slot(void) {
  const double gap = 0x1p-40;
  const double reference[2] = {0, 0};
  gcv_polygon *block = POLYGON(0, 0, 6, 0, 6, 6, 4, 6, 4, 2, 2, 2, 2, 6, 0, 6);
  gcv_polygon *fit = POLYGON(0, 0, 2, 0, 2, 2, 0, 2);
  gcv_polygon *loose = POLYGON(0, 0, 2 - gap, 0, 2 - gap, 2, 0, 2);
  gcv_outer_face *face = NULL;
  CHECK_OK(gcv_no_fit_polygon(block, fit, reference, NULL, &face));
  CHECK(face_is(face, RING(-2, -2, 6, -2, 6, 6, -2, 6)));
  gcv_outer_face_destroy(face);
  CHECK_OK(gcv_no_fit_polygon(block, loose, reference, NULL, &face));
  CHECK(face_is(face,
                RING(gap - 2, -2, 6, -2, 6, 6, 2 + gap, 6, 2 + gap, 2, 2, 2, 2, 6, gap - 2, 6)));
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(loose);
  gcv_polygon_destroy(fit);
  gcv_polygon_destroy(block);
}

/* B + (-A) + a0 is the no-fit polygon of B and A. */
static void entrance_block(void) {
  const double a0[2] = {10, -1};
  gcv_outer_face *face = NULL;
  CHECK_OK(gcv_entrance_block(triangle, square, a0, NULL, &face));
  CHECK(face_is(face, RING(8, -1, 10, -2, 11, -2, 11, 0, 8, 0)));
  gcv_outer_face_destroy(face);
}

static void bad_reference(void) {
  static const double bad[][2] = {{NAN, 0}, {0, NAN}, {INFINITY, 0}, {0, -INFINITY}};
  gcv_outer_face *face = NULL;
  size_t k;
  for (k = 0; k < sizeof bad / sizeof *bad; ++k) {
    CHECK_REFUSED(GCV_ERR_NOT_FINITE, "reference",
                  gcv_no_fit_polygon(square, square, bad[k], NULL, &face));
    CHECK_REFUSED(GCV_ERR_NOT_FINITE, "a0",
                  gcv_entrance_block(square, square, bad[k], NULL, &face));
  }
  CHECK(face == NULL);
}

static void index_past_the_end(void) {
  gcv_outer_face *face = sum_of(square, square);
  char text[64] = "untouched";
  size_t required = 0;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "4",
                gcv_outer_face_exact_vertex(face, 4, text, sizeof text, &required));
  CHECK_STATUS(GCV_ERR_INVALID_ARGUMENT,
               gcv_outer_face_exact_vertex(face, SIZE_MAX, text, sizeof text, &required));
  CHECK(strcmp(text, "untouched") == 0);
  gcv_outer_face_destroy(face);
}

/* The ring as a polygon and as text, and back. */
static void rings_go_on(void) {
  gcv_outer_face *face = sum_of(dart, wedge), *next;
  gcv_polygon *polygon = NULL, *read = NULL;
  char text[MOST_TEXT] = "";
  size_t required = 0;
  CHECK_OK(gcv_outer_face_polygon(face, &polygon));
  CHECK_OK(gcv_outer_face_wkt(face, text, sizeof text, &required));
  CHECK_OK(gcv_polygon_create_wkt(text, required - 1, &read));
  gcv_outer_face_destroy(face);
  CHECK(polygon_is(polygon, RING(0, 0, 7, 7, 4.6, 6.2, 3, 7, 0, 6)));
  CHECK(polygon_is(read, RING(0, 0, 7, 7, 4.6, 6.2, 3, 7, 0, 6)));
  next = sum_of(polygon, square);
  CHECK(area_of(next) > 0);
  gcv_outer_face_destroy(next);
  gcv_polygon_destroy(polygon);
  gcv_polygon_destroy(read);
}

/* Doubles of every size come back from their text. */
static void wkt_round_trip(void) {
  const double xy[] = {-1e308, 0.1, 1.0 / 3, -0x1p-1074, 1e22, 5e-324, 123456789.125, 1e23};
  gcv_polygon *polygon = polygon_of(xy, 4), *tiny = POLYGON(0, 0, 0x1p-1074, 0, 0, 0x1p-1074);
  gcv_polygon *read = NULL;
  gcv_outer_face *face = sum_of(polygon, tiny);
  double ring[2 * MOST_VERTICES];
  char text[MOST_TEXT] = "";
  size_t count = 0, required = 0;
  CHECK_OK(gcv_outer_face_vertices(face, ring, MOST_VERTICES, &count));
  CHECK_OK(gcv_outer_face_wkt(face, text, sizeof text, &required));
  CHECK_OK(gcv_polygon_create_wkt(text, required - 1, &read));
  CHECK(polygon_is(read, ring, count));
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(read);
  gcv_polygon_destroy(tiny);
  gcv_polygon_destroy(polygon);
}

static int exact_indices_are(const gcv_outer_face *face, const uint64_t *expected, size_t count) {
  uint64_t indices[MOST_VERTICES];
  size_t required = 0;
  CHECK_OK(gcv_outer_face_exact_indices(face, indices, MOST_VERTICES, &required));
  return required == count && memcmp(indices, expected, count * sizeof *indices) == 0;
}

/* Which exact vertex each vertex stands for. Far away, the two ends of a short edge fall together:
 * then it is the first of them. */
static void exact_indices(void) {
  static const uint64_t all[] = {0, 1, 2, 3, 4}, first_of_two[] = {0, 1, 2, 4};
  const double near[2] = {0, 0}, far[2] = {0x1p60, 0x1p60};
  gcv_polygon *chamfered = POLYGON(0, 0, 1024, 0, 1024, 1023, 1023, 1024, 0, 1024);
  gcv_polygon *block = POLYGON(0, 0, 256, 0, 256, 256, 0, 256);
  gcv_outer_face *face = NULL;
  CHECK_OK(gcv_no_fit_polygon(chamfered, block, near, NULL, &face));
  CHECK(exact_indices_are(face, all, 5));
  gcv_outer_face_destroy(face);
  CHECK_OK(gcv_no_fit_polygon(chamfered, block, far, NULL, &face));
  CHECK(face_is(face, RING(0x1p60 - 256, 0x1p60 - 256, 0x1p60 + 1024, 0x1p60 - 256, 0x1p60 + 1024,
                           0x1p60 + 1024, 0x1p60 - 256, 0x1p60 + 1024)));
  CHECK(exact_indices_are(face, first_of_two, 4));
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(chamfered);
  gcv_polygon_destroy(block);
}

/* Outward no vertex is where the exact one is. Each stands for the one whose edge leads on along
 * the edge from there, in outer faces, in regions and in inner fits. */
static void outward_indices(void) {
  static const uint64_t all[] = {0, 1, 2, 3};
  const double reference[2] = {0.1, 0.2};
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_polygon *a = POLYGON(0.1, 0.1, 0.3, 0.1, 0.3, 0.3, 0.1, 0.3);
  gcv_polygon *b = POLYGON(0.2, 0.2, 0.7, 0.2, 0.7, 0.7, 0.2, 0.7);
  gcv_outer_face *face = NULL;
  gcv_region *regions[2] = {NULL, NULL};
  uint64_t indices[MOST_VERTICES];
  size_t k, required = 0;
  options.rounding = GCV_ROUND_OUTWARD;
  CHECK_OK(gcv_minkowski_sum(a, b, &options, &face));
  CHECK(exact_indices_are(face, all, 4));
  CHECK_OK(gcv_minkowski_sum_region(a, b, &options, &regions[0]));
  CHECK_OK(gcv_inner_fit_region(b, a, reference, &options, &regions[1]));
  for (k = 0; k < 2; ++k) {
    CHECK_OK(gcv_region_exact_indices(regions[k], indices, MOST_VERTICES, &required));
    CHECK(required == 4 && memcmp(indices, all, sizeof all) == 0);
    gcv_region_destroy(regions[k]);
  }
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

/* A vertex that was moved apart from others stands for the exact one that it was. */
static void repaired_indices(void) {
  /* A slot 2 wide and a peg 2 x 2, both turned by the same angle: the slot of the sum is a segment
   * but for roundings. */
  const double sine = -0.4520786680204372, cosine = -0.8919780703138768;
  static const double slot[] = {0, 0, 6, 0, 6, 4, 4, 4, 4, 1, 2, 1, 2, 4, 0, 4};
  static const double peg[] = {0, 0, 2, 0, 2, 2, 0, 2};
  const double reference[2] = {0, 0};
  double turned_slot[16], turned_peg[8];
  gcv_polygon *a = NULL, *b = NULL;
  gcv_outer_face *face = NULL;
  gcv_region *region = NULL;
  gcv_stats stats = {sizeof stats, 0, 0, 0, 0, 0, 0, 0};
  uint64_t of_face[MOST_VERTICES], of_region[MOST_VERTICES];
  size_t k, in_face = 0, in_region = 0;
  for (k = 0; k < 16; k += 2) {
    turned_slot[k] = slot[k] * cosine - slot[k + 1] * sine;
    turned_slot[k + 1] = slot[k] * sine + slot[k + 1] * cosine;
  }
  for (k = 0; k < 8; k += 2) {
    turned_peg[k] = peg[k] * cosine - peg[k + 1] * sine;
    turned_peg[k + 1] = peg[k] * sine + peg[k + 1] * cosine;
  }
  CHECK_OK(gcv_polygon_create(turned_slot, 8, 0, &a));
  CHECK_OK(gcv_polygon_create(turned_peg, 4, 0, &b));
  CHECK_OK(gcv_no_fit_polygon(a, b, reference, NULL, &face));
  CHECK_OK(gcv_outer_face_stats(face, &stats));
  CHECK(stats.vertices_repaired > 0);
  CHECK_OK(gcv_outer_face_exact_indices(face, of_face, MOST_VERTICES, &in_face));
  for (k = 0; k < in_face; ++k) CHECK(of_face[k] == k);
  CHECK_OK(gcv_no_fit_region(a, b, reference, NULL, &region));
  CHECK_OK(gcv_region_exact_indices(region, of_region, MOST_VERTICES, &in_region));
  CHECK(in_region >= in_face && memcmp(of_face, of_region, in_face * sizeof *of_face) == 0);
  gcv_outer_face_destroy(face);
  gcv_region_destroy(region);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

static void out_of_range(void) {
  const double reference[2] = {-1.7e308, 0}, away[2] = {1.7e308, 0};
  gcv_polygon *right = POLYGON(1.7e308, 0, 1.7e308, 1, 1.6e308, 0);
  gcv_polygon *left = POLYGON(-1.7e308, 0, -1.6e308, 0, -1.7e308, 1);
  gcv_polygon *wide = POLYGON(0, 0, 1e200, 0, 1e200, 1e200, 0, 1e200);
  gcv_outer_face *face = NULL;
  gcv_superset *superset = NULL;
  double area = -1;

  CHECK_STATUS(GCV_ERR_RANGE, gcv_minkowski_sum(right, right, NULL, &face));
  CHECK_STATUS(GCV_ERR_RANGE, gcv_minkowski_sum(left, left, NULL, &face));
  CHECK_STATUS(GCV_ERR_RANGE, gcv_no_fit_polygon(right, left, away, NULL, &face));
  CHECK_STATUS(GCV_ERR_RANGE, gcv_entrance_block(right, left, reference, NULL, &face));
  CHECK_STATUS(GCV_ERR_RANGE, gcv_superset_create(right, right, &superset));
  CHECK(face == NULL && superset == NULL);

  /* Only the results have to be in range, not what they are computed from. */
  CHECK_OK(gcv_no_fit_polygon(right, left, reference, NULL, &face));
  gcv_outer_face_destroy(face);
  face = sum_of(left, right);
  gcv_outer_face_destroy(face);

  face = sum_of(wide, wide);
  CHECK_STATUS(GCV_ERR_RANGE, gcv_outer_face_area(face, &area));
  CHECK(area == -1);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(wide);
  gcv_polygon_destroy(left);
  gcv_polygon_destroy(right);
}

int main(void) {
  make_polygons();
  square_and_square();
  hexagon();
  crossing();
  frame();
  no_fit_polygon();
  slot();
  entrance_block();
  bad_reference();
  index_past_the_end();
  rings_go_on();
  wkt_round_trip();
  exact_indices();
  outward_indices();
  repaired_indices();
  out_of_range();
  destroy_polygons();
  return check_failures != 0;
}

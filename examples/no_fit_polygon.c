/*
 * no_fit_polygon.c - places one part against another, as nesting programs do: at the
 * lowest vertex of their no-fit polygon that is on the sheet, and of the lowest, at the
 * leftmost.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include <gcv/gcv.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { FIXED_COUNT = 8, MOVING_COUNT = 4 };

/* The sheet goes from (0, 0) to here. */
static const double SHEET[2] = {12, 12};

/* A part with a notch from above, as wide as the sheet; and a wedge. */
static const double FIXED[FIXED_COUNT][2] = {{0, 0}, {12, 0}, {12, 6}, {8, 6},
                                             {7, 2}, {5, 2},  {4, 6},  {0, 6}};
static const double MOVING[MOVING_COUNT][2] = {{1, 0}, {2, 0}, {3, 4}, {0, 4}};

/* Ends the program with the library's message if a call failed. */
static void check(gcv_status status) {
  if (status == GCV_OK) return;
  fprintf(stderr, "no_fit_polygon: %s: %s\n", gcv_status_name(status), gcv_last_error_message());
  exit(EXIT_FAILURE);
}

/* The vertices of the no-fit polygon; the caller's to free. */
static double *positions(const double reference[2], size_t *count) {
  gcv_polygon *fixed, *moving;
  gcv_outer_face *face;
  check(gcv_polygon_create(&FIXED[0][0], FIXED_COUNT, 0, &fixed));
  check(gcv_polygon_create(&MOVING[0][0], MOVING_COUNT, 0, &moving));
  check(gcv_no_fit_polygon(fixed, moving, reference, NULL, &face));
  check(gcv_outer_face_vertices(face, NULL, 0, count));

  double *xy = malloc(*count * 2 * sizeof *xy);
  if (!xy) exit(EXIT_FAILURE);
  check(gcv_outer_face_vertices(face, xy, *count, count));

  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(moving);
  gcv_polygon_destroy(fixed);
  return xy;
}

/* The moving part with its reference point at `position`. */
static void place(const double reference[2], const double position[2],
                  double placed[MOVING_COUNT][2]) {
  for (int i = 0; i < MOVING_COUNT; ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      placed[i][axis] = MOVING[i][axis] + position[axis] - reference[axis];
    }
  }
}

static bool on_sheet(double part[MOVING_COUNT][2]) {
  for (int i = 0; i < MOVING_COUNT; ++i) {
    if (part[i][0] < 0 || part[i][0] > SHEET[0] || part[i][1] < 0 || part[i][1] > SHEET[1]) {
      return false;
    }
  }
  return true;
}

/* The lowest, then leftmost position on the sheet; NULL if there is none. */
static const double *best_position(const double *xy, size_t count, const double reference[2]) {
  const double *best = NULL;
  for (const double *p = xy; p < xy + 2 * count; p += 2) {
    double placed[MOVING_COUNT][2];
    place(reference, p, placed);
    if (!on_sheet(placed)) continue;
    if (!best || p[1] < best[1] || (p[1] == best[1] && p[0] < best[0])) best = p;
  }
  return best;
}

/* Whether p is on the segment from a to b; exact for the small integers of this example. */
static bool on_segment(const double p[2], const double a[2], const double b[2]) {
  double cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  double from_a = (p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1]);
  double from_b = (p[0] - b[0]) * (a[0] - b[0]) + (p[1] - b[1]) * (a[1] - b[1]);
  return cross == 0 && from_a >= 0 && from_b >= 0;
}

/* Whether a vertex of either part is on an edge of the other. */
static bool touches(double placed[MOVING_COUNT][2]) {
  for (int i = 0; i < MOVING_COUNT; ++i) {
    for (int k = 0; k < FIXED_COUNT; ++k) {
      if (on_segment(placed[i], FIXED[k], FIXED[(k + 1) % FIXED_COUNT])) return true;
      if (on_segment(FIXED[k], placed[i], placed[(i + 1) % MOVING_COUNT])) return true;
    }
  }
  return false;
}

int main(void) {
  const double *reference = MOVING[0];
  size_t count;
  double *xy = positions(reference, &count);
  printf("no-fit polygon, %zu vertices:\n", count);
  for (size_t i = 0; i < count; ++i) printf("  %g %g\n", xy[2 * i], xy[2 * i + 1]);

  const double *best = best_position(xy, count, reference);
  if (!best) {
    puts("no vertex is a position on the sheet");
    free(xy);
    return EXIT_FAILURE;
  }
  double placed[MOVING_COUNT][2];
  place(reference, best, placed);
  bool touching = touches(placed);
  printf("lowest, then leftmost on the sheet: %g %g\n", best[0], best[1]);
  printf("there the parts %s; the moving one is at\n", touching ? "touch" : "DO NOT TOUCH");
  for (int i = 0; i < MOVING_COUNT; ++i) printf("  %g %g\n", placed[i][0], placed[i][1]);
  free(xy);
  return touching ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Times of sums by the native library, as compare.mjs takes those in WebAssembly: from coordinates
 * to coordinates, the median of a number of milliseconds. Reads the numbers of vertices of A and of
 * B and then the coordinates, as doubles; prints the times of the outer face and of the region.
 *
 *   native MILLISECONDS < operands
 */
#define _POSIX_C_SOURCE 199309L
#include <gcv/gcv.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { most_times = 1 << 20, most_vertices = 1 << 20 };

static double times[most_times], vertices[2 * most_vertices], read_doubles[2 * most_vertices];

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1e3 * (double)time.tv_sec + 1e-6 * (double)time.tv_nsec;
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static gcv_status sum(const gcv_polygon *a, const gcv_polygon *b, int is_region) {
  gcv_outer_face *face = NULL;
  gcv_region *region = NULL;
  size_t needed = 0;
  gcv_status status = is_region ? gcv_minkowski_sum_region(a, b, NULL, &region)
                                : gcv_minkowski_sum(a, b, NULL, &face);
  if (!status)
    status = is_region ? gcv_region_vertices(region, vertices, most_vertices, &needed)
                       : gcv_outer_face_vertices(face, vertices, most_vertices, &needed);
  gcv_outer_face_destroy(face);
  gcv_region_destroy(region);
  return status;
}

static gcv_status once(const double *a, size_t n, const double *b, size_t m, int is_region) {
  gcv_polygon *p = NULL, *q = NULL;
  gcv_status status = gcv_polygon_create(a, n, 0, &p);
  if (!status) status = gcv_polygon_create(b, m, 0, &q);
  if (!status) status = sum(p, q, is_region);
  gcv_polygon_destroy(q);
  gcv_polygon_destroy(p);
  return status;
}

int main(int count, char **arguments) {
  double sizes[2];
  size_t n, m;
  int is_region;
  if (count != 2 || fread(sizes, sizeof *sizes, 2, stdin) != 2) return 2;
  n = (size_t)sizes[0], m = (size_t)sizes[1];
  if (n + m > most_vertices ||
      fread(read_doubles, sizeof(double), 2 * (n + m), stdin) != 2 * (n + m))
    return 2;
  for (is_region = 0; is_region < 2; ++is_region) {
    size_t taken = 0;
    double end;
    if (once(read_doubles, n, read_doubles + 2 * n, m, is_region)) {
      fprintf(stderr, "%s\n", gcv_last_error_message());
      return 1;
    }
    end = now() + atof(arguments[1]);
    while (taken < 3 || (taken < most_times && now() < end)) {
      const double start = now();
      if (once(read_doubles, n, read_doubles + 2 * n, m, is_region)) return 1;
      times[taken++] = now() - start;
    }
    qsort(times, taken, sizeof *times, ascending);
    printf("%.9g\n", times[taken / 2]);
  }
  return 0;
}

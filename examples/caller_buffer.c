/*
 * caller_buffer.c - results in buffers of the caller: once asked for their size first,
 * once with one buffer that is used for many sums and grows only when it has to.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include <gcv/gcv.h>
#include <stdio.h>
#include <stdlib.h>

/* Ends the program with the library's message if a call failed. */
static void check(gcv_status status) {
  if (status == GCV_OK) return;
  fprintf(stderr, "caller_buffer: %s: %s\n", gcv_status_name(status), gcv_last_error_message());
  exit(EXIT_FAILURE);
}

/* realloc that ends the program when there is no memory; room for `count` vertices. */
static double *vertex_buffer(double *old, size_t count) {
  double *buffer = realloc(old, count * 2 * sizeof *buffer);
  if (buffer) return buffer;
  fputs("caller_buffer: no memory\n", stderr);
  exit(EXIT_FAILURE);
}

static gcv_polygon *polygon(const double *xy, size_t count) {
  gcv_polygon *result;
  check(gcv_polygon_create(xy, count, 0, &result));
  return result;
}

/* Asks for the size, gets a buffer of that size, has it filled. */
static void size_then_fill(const gcv_outer_face *face) {
  size_t count;
  check(gcv_outer_face_vertices(face, NULL, 0, &count));
  double *xy = vertex_buffer(NULL, count);
  check(gcv_outer_face_vertices(face, xy, count, &count));

  printf("square + triangle: %zu vertices\n", count);
  for (size_t i = 0; i < count; ++i) printf("  %g %g\n", xy[2 * i], xy[2 * i + 1]);
  free(xy);
}

/* A buffer that lives for many calls. */
typedef struct buffer {
  double *xy;
  size_t capacity; /* in vertices */
} buffer;

/* Fills the buffer without asking first, and doubles it only when told that it is too small. */
static size_t fill(const gcv_outer_face *face, buffer *b) {
  size_t count;
  gcv_status status = gcv_outer_face_vertices(face, b->xy, b->capacity, &count);
  if (status == GCV_ERR_BUFFER_TOO_SMALL) {
    printf("  %zu vertices do not fit into room for %zu\n", count, b->capacity);
    b->capacity = 2 * count;
    b->xy = vertex_buffer(b->xy, b->capacity);
    status = gcv_outer_face_vertices(face, b->xy, b->capacity, &count);
  }
  check(status);
  return count;
}

int main(void) {
  static const double square_xy[] = {0, 0, 4, 0, 4, 4, 0, 4};
  static const double triangle_xy[] = {0, 0, 2, 1, 1, 3};
  gcv_polygon *square = polygon(square_xy, 4), *triangle = polygon(triangle_xy, 3);
  gcv_outer_face *face;
  check(gcv_minkowski_sum(square, triangle, NULL, &face));
  size_then_fill(face);

  /* Six more triangles, each added to the sum so far. The results live on by themselves. */
  buffer b = {vertex_buffer(NULL, 8), 8};
  for (int k = 3; k <= 8; ++k) {
    gcv_polygon *sum;
    check(gcv_outer_face_polygon(face, &sum));
    gcv_outer_face_destroy(face);
    gcv_polygon_destroy(triangle);

    const double xy[] = {0, 0, k, 1, 1, k};
    triangle = polygon(xy, 3);
    check(gcv_minkowski_sum(sum, triangle, NULL, &face));
    gcv_polygon_destroy(sum);
    printf("+ triangle %d: %zu vertices\n", k, fill(face, &b));
  }

  free(b.xy);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(triangle);
  gcv_polygon_destroy(square);
  return EXIT_SUCCESS;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Programs that were compiled with an earlier gcv.h: the options of then, with memory of the
 * program's own behind them. The first struct had 16 bytes, before any release; that of 0.1.0
 * has 40.
 */
#include <string.h>

#include "handles.h"

typedef struct first_options {
  uint32_t struct_size;
  int32_t rounding;
  double tolerance;
} first_options;

typedef struct options_0_1 {
  first_options first;
  int32_t threads;
  int32_t (*progress)(void *context, uint64_t done, uint64_t estimate);
  void *progress_context;
} options_0_1;

typedef struct frame {
  first_options options;
  unsigned char own[64];
} frame;

static frame frame_of(int32_t rounding) {
  frame made = {{sizeof(first_options), rounding, 0}, {0}};
  memset(made.own, 0xa5, sizeof made.own);
  return made;
}

/* The sum of a square and a triangle with a corner at thirds; its area. */
static double area_with(const frame *caller) {
  const double point[2] = {0, 0};
  const gcv_options *options = (const gcv_options *)&caller->options;
  gcv_polygon *a = POLYGON(0, 0, 8, 0, 8, 6, 3, 1, 0, 7), *b = POLYGON(0, 0, 1, 0, 0, 1);
  gcv_outer_face *sum = NULL, *no_fit = NULL, *block = NULL;
  double area = 0;
  CHECK_OK(gcv_minkowski_sum(a, b, options, &sum));
  CHECK_OK(gcv_no_fit_polygon(a, b, point, options, &no_fit));
  CHECK_OK(gcv_entrance_block(a, b, point, options, &block));
  CHECK_OK(gcv_outer_face_area(sum, &area));
  gcv_outer_face_destroy(sum);
  gcv_outer_face_destroy(no_fit);
  gcv_outer_face_destroy(block);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
  return area;
}

static void first_struct(void) {
  const frame nearest = frame_of(GCV_ROUND_NEAREST), outward = frame_of(GCV_ROUND_OUTWARD);
  gcv_outer_face *none = NULL;
  frame unknown = frame_of(7);
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  CHECK(sizeof(first_options) == 16);
  CHECK(area_with(&outward) > area_with(&nearest));
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "rounding",
                gcv_minkowski_sum(square, square, (const gcv_options *)&unknown.options, &none));
  gcv_polygon_destroy(square);
}

/* A struct of 0.1 is taken, and what lies behind it is not read. */
static void struct_of_0_1(void) {
  struct {
    options_0_1 options;
    unsigned char own[64];
  } caller;
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  gcv_outer_face *face = NULL;
  gcv_region *region = NULL;
  memset(&caller, 0, sizeof caller);
  memset(caller.own, 0xa5, sizeof caller.own);
  caller.options.first.struct_size = sizeof caller.options;
  caller.options.threads = 1;
  CHECK_OK(gcv_minkowski_sum(square, square, (const gcv_options *)&caller.options, &face));
  CHECK_OK(gcv_minkowski_sum_region(square, square, (const gcv_options *)&caller.options, &region));
  gcv_outer_face_destroy(face);
  gcv_region_destroy(region);
  gcv_polygon_destroy(square);
}

/* The version of the function that a program of 0.1 is bound to writes a struct of 0.1. */
__asm__(".symver options_init_0_1, gcv_options_init@GCV_0.1");
void options_init_0_1(gcv_options *options);

static void init_of_0_1(void) {
  struct {
    options_0_1 options;
    unsigned char own[64];
  } caller;
  size_t k;
  memset(&caller, 0xa5, sizeof caller);
  options_init_0_1((gcv_options *)&caller.options);
  CHECK(caller.options.first.struct_size == sizeof caller.options);
  CHECK(caller.options.first.rounding == GCV_ROUND_NEAREST);
  for (k = 0; k < sizeof caller.own; ++k) CHECK(caller.own[k] == 0xa5);
}

int main(void) {
  first_struct();
  struct_of_0_1();
  init_of_0_1();
  return check_failures != 0;
}

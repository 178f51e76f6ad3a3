/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * A program that was compiled with the first gcv.h, of version 0.1.0: it has the options of
 * then in 16 bytes, with memory of its own behind them.
 */
#include <string.h>

#include "handles.h"

typedef struct first_options {
  uint32_t struct_size;
  int32_t rounding;
  double tolerance;
} first_options;

typedef struct frame {
  first_options options;
  unsigned char own[64];
} frame;

/* The version of the function that such a program is bound to. */
__asm__(".symver first_options_init, gcv_options_init@GCV_0.1");
void first_options_init(gcv_options *options);

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

static void first_init(void) {
  const frame expected = frame_of(GCV_ROUND_NEAREST);
  frame made = frame_of(7);
  first_options_init((gcv_options *)&made.options);
  CHECK(memcmp(&made, &expected, sizeof made) == 0);
}

int main(void) {
  first_struct();
  first_init();
  return check_failures != 0;
}

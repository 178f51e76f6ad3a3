/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The structs that begin with their size: gcv_options and gcv_stats.
 */
#include <limits.h>
#include <math.h>

#include "handles.h"

static gcv_polygon *square;

/* The sizes of the structs in version 0.1.0. */
enum {
  OPTIONS_0_1 = offsetof(gcv_options, leave_out),
  STATS_0_1 = offsetof(gcv_stats, parts_dropped)
};

/* Every function with options takes these alike. */
static void options_give(gcv_status expected, const char *part, const gcv_options *options) {
  const double point[2] = {0, 0};
  gcv_outer_face *sum = NULL, *no_fit = NULL, *block = NULL;
  gcv_region *regions[4] = {NULL, NULL, NULL, NULL};
  size_t k;
  CHECK_REFUSED(expected, part, gcv_minkowski_sum(square, square, options, &sum));
  CHECK_REFUSED(expected, part, gcv_no_fit_polygon(square, square, point, options, &no_fit));
  CHECK_REFUSED(expected, part, gcv_entrance_block(square, square, point, options, &block));
  CHECK_REFUSED(expected, part, gcv_minkowski_sum_region(square, square, options, &regions[0]));
  CHECK_REFUSED(expected, part, gcv_no_fit_region(square, square, point, options, &regions[1]));
  CHECK_REFUSED(expected, part, gcv_entrance_region(square, square, point, options, &regions[2]));
  CHECK_REFUSED(expected, part, gcv_inner_fit_region(square, square, point, options, &regions[3]));
  for (k = 0; k < 4; ++k) {
    CHECK((regions[k] != NULL) == (expected == GCV_OK));
    gcv_region_destroy(regions[k]);
  }
  CHECK((sum != NULL) == (expected == GCV_OK));
  CHECK((no_fit != NULL) == (expected == GCV_OK));
  CHECK((block != NULL) == (expected == GCV_OK));
  gcv_outer_face_destroy(sum);
  gcv_outer_face_destroy(no_fit);
  gcv_outer_face_destroy(block);
}

static void options_defaults(void) {
  const gcv_options by_macro = GCV_OPTIONS_INIT;
  gcv_options by_function;
  memset(&by_function, 0xff, sizeof by_function);
  gcv_options_init(&by_function);
  CHECK(by_macro.struct_size == sizeof(gcv_options));
  CHECK(by_macro.rounding == GCV_ROUND_NEAREST && by_macro.rounding == 0);
  CHECK(by_macro.tolerance == 0);
  CHECK(by_macro.threads == 1 && by_macro.progress == NULL && by_macro.progress_context == NULL);
  CHECK(by_macro.leave_out == 0);
  CHECK(by_function.struct_size == by_macro.struct_size && by_function.rounding == 0);
  CHECK(by_function.tolerance == 0 && by_function.threads == 1);
  CHECK(by_function.progress == NULL && by_function.progress_context == NULL);
  CHECK(by_function.leave_out == 0);
  options_give(GCV_OK, "", &by_function);
  options_give(GCV_OK, "", NULL);
}

static void options_size(void) {
  struct {
    gcv_options known;
    unsigned char later[24];
  } larger = {GCV_OPTIONS_INIT, {0}};
  gcv_options options = GCV_OPTIONS_INIT;
  uint32_t size;
  size_t k;
  for (size = 0; size < sizeof options; ++size) {
    /* 16 is the size of the first version. */
    const int is_known = size == 16 || size == OPTIONS_0_1;
    options.struct_size = size;
    options_give(is_known ? GCV_OK : GCV_ERR_INVALID_ARGUMENT, is_known ? "" : "struct_size",
                 &options);
  }
  /* What lies behind the struct of 0.1 is not read. */
  options.struct_size = OPTIONS_0_1;
  options.leave_out = UINT64_MAX;
  options_give(GCV_OK, "", &options);
  for (size = sizeof larger.known; size <= sizeof larger; ++size) {
    larger.known.struct_size = size;
    options_give(GCV_OK, "", &larger.known);
  }
  for (k = 0; k < sizeof larger.later; ++k) {
    larger.later[k] = 1;
    options_give(GCV_ERR_INVALID_ARGUMENT, "options", &larger.known);
    larger.known.struct_size = (uint32_t)(sizeof larger.known + k);
    options_give(GCV_OK, "", &larger.known);
    larger.known.struct_size = sizeof larger;
    larger.later[k] = 0;
  }
}

static void options_values(void) {
  const int32_t roundings[] = {-1, 2, 7, INT_MAX, INT_MIN};
  const double tolerances[] = {NAN, INFINITY, -INFINITY, -1, -0x1p-1074};
  gcv_options outward = GCV_OPTIONS_INIT;
  size_t k;
  outward.rounding = GCV_ROUND_OUTWARD;
  options_give(GCV_OK, "", &outward);
  for (k = 0; k < sizeof roundings / sizeof *roundings; ++k) {
    gcv_options options = GCV_OPTIONS_INIT;
    options.rounding = roundings[k];
    options_give(GCV_ERR_INVALID_ARGUMENT, "rounding", &options);
  }
  for (k = 0; k < sizeof tolerances / sizeof *tolerances; ++k) {
    gcv_options options = GCV_OPTIONS_INIT;
    options.tolerance = tolerances[k];
    options_give(GCV_ERR_INVALID_ARGUMENT, "tolerance", &options);
  }
}

static void options_left_out(void) {
  gcv_options options = GCV_OPTIONS_INIT;
  int bit;
  options.leave_out = GCV_LEAVE_OUT_FITS;
  options_give(GCV_OK, "", &options);
  for (bit = 2; bit < 64; ++bit) {
    options.leave_out = UINT64_C(1) << bit;
    options_give(GCV_ERR_INVALID_ARGUMENT, "leave_out", &options);
    options.leave_out |= GCV_LEAVE_OUT_FITS;
    options_give(GCV_ERR_INVALID_ARGUMENT, "leave_out", &options);
  }
}

/* The struct of 0.1 is filled as far as it goes; in between, all that a size covers is whole. */
static void stats_of_0_1(void) {
  gcv_region *region = NULL;
  gcv_outer_face *face = sum_of(square, square);
  gcv_stats whole = {sizeof whole, 0, 0, 0, 0, 0, 0, 0}, small;
  uint32_t size;
  CHECK_OK(gcv_minkowski_sum_region(square, square, NULL, &region));
  CHECK_OK(gcv_region_stats(region, &whole));
  CHECK(whole.parts_dropped == 0 && whole.vertices_repaired == 0);
  for (size = STATS_0_1; size < sizeof(gcv_stats); ++size) {
    const unsigned char *bytes = (const unsigned char *)&small;
    size_t k;
    memset(&small, 0xa5, sizeof small);
    small.struct_size = size;
    CHECK_OK(gcv_region_stats(region, &small));
    CHECK(small.struct_size == size && small.walk_steps == whole.walk_steps);
    CHECK(small.predicates_rational == whole.predicates_rational && small.vertices_repaired == 0);
    for (k = STATS_0_1; k < sizeof small; ++k) CHECK(bytes[k] == (k < size ? 0 : 0xa5));
    CHECK_OK(gcv_outer_face_stats(face, &small));
    CHECK(small.vertices_repaired == 0 && small.walk_steps > 0);
  }
  memset(&small, 0xa5, sizeof small);
  small.struct_size = STATS_0_1 - 1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size", gcv_region_stats(region, &small));
  gcv_outer_face_destroy(face);
  gcv_region_destroy(region);
}

static void stats(void) {
  gcv_outer_face *face = sum_of(square, square), *again = sum_of(square, square);
  struct {
    gcv_stats known;
    unsigned char later[16];
  } larger;
  gcv_stats exact, repeated = {sizeof repeated, 0, 0, 0, 0, 0, 0, 0}, small, before;
  const uint32_t sizes[] = {0, 1, STATS_0_1 - 1};
  size_t k;

  memset(&before, 0xa5, sizeof before);
  for (k = 0; k < sizeof sizes / sizeof *sizes; ++k) {
    before.struct_size = sizes[k];
    small = before;
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size", gcv_outer_face_stats(face, &small));
    CHECK(memcmp(&small, &before, sizeof small) == 0);
  }

  memset(&exact, 0xa5, sizeof exact);
  exact.struct_size = sizeof exact;
  CHECK_OK(gcv_outer_face_stats(face, &exact));
  CHECK(exact.struct_size == sizeof exact);
  CHECK(exact.walk_steps >= 4 && exact.vertices_repaired == 0 && exact.parts_dropped == 0);
  for (k = sizeof exact.struct_size; k < offsetof(gcv_stats, walk_steps); ++k) {
    CHECK(((const unsigned char *)&exact)[k] == 0); /* no byte is left to chance */
  }

  CHECK_OK(gcv_outer_face_stats(again, &repeated));
  CHECK(exact.walk_steps == repeated.walk_steps);
  CHECK(exact.candidate_edges == repeated.candidate_edges);
  CHECK(exact.predicates_filtered == repeated.predicates_filtered);
  CHECK(exact.predicates_fixed_width == repeated.predicates_fixed_width);
  CHECK(exact.predicates_rational == repeated.predicates_rational);

  memset(&larger, 0xa5, sizeof larger);
  larger.known.struct_size = sizeof larger.known + 8;
  CHECK_OK(gcv_outer_face_stats(face, &larger.known));
  CHECK(larger.known.struct_size == sizeof larger.known + 8);
  CHECK(larger.known.walk_steps == exact.walk_steps);
  for (k = 0; k < sizeof larger.later; ++k) CHECK(larger.later[k] == (k < 8 ? 0 : 0xa5));

  gcv_outer_face_destroy(face);
  gcv_outer_face_destroy(again);
}

int main(void) {
  square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  options_defaults();
  options_size();
  options_values();
  options_left_out();
  stats_of_0_1();
  stats();
  gcv_polygon_destroy(square);
  return check_failures != 0;
}

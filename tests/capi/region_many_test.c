/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Many regions and many no-fit polygons at once: each is what the function for one pair gives.
 */
#include "record.h"
#include "regions.h"

enum { COUNT = 12, NO_FIRST = 3, NO_SECOND = 5, BAD_REFERENCE = 7, TOO_LARGE = 9 };

static gcv_polygon *shapes[6];
static const gcv_polygon *a[COUNT], *b[COUNT];
static double references[2 * COUNT];

/* Good pairs, and one of every kind that fails. */
static void make_pairs(void) {
  size_t k;
  shapes[0] = polygon_of_rings(&frame);
  shapes[1] = polygon_of_rings(&plate);
  shapes[2] = POLYGON(SLOTTED);
  shapes[3] = SQUARE(1);
  shapes[4] = SQUARE(2);
  shapes[5] = POLYGON(0, 0, 1.7e308, 0, 0, 1.7e308);
  for (k = 0; k < COUNT; ++k) {
    a[k] = shapes[k % 3];
    b[k] = shapes[3 + k % 2];
    references[2 * k] = (double)k / 10;
    references[2 * k + 1] = -(double)k;
  }
  a[NO_FIRST] = NULL;
  b[NO_SECOND] = NULL;
  references[2 * BAD_REFERENCE + 1] = NAN;
  a[TOO_LARGE] = b[TOO_LARGE] = shapes[5];
  references[2 * TOO_LARGE] = 1.7e308;
}

static char nowhere;
#define UNTOUCHED ((void *)&nowhere)
static const gcv_status UNTOUCHED_STATUS = -4711;

/* Sums and no-fit regions, seen as one function. */
struct function {
  const char *a;
  const char *b;
  int has_references;
  gcv_status (*many)(const gcv_polygon *const *, const gcv_polygon *const *, const double *, size_t,
                     const gcv_options *, gcv_region **, gcv_status *);
  gcv_status (*one)(const gcv_polygon *, const gcv_polygon *, const double *, const gcv_options *,
                    gcv_region **);
};

static gcv_status sum_many(const gcv_polygon *const *first, const gcv_polygon *const *second,
                           const double *points, size_t count, const gcv_options *options,
                           gcv_region **out, gcv_status *statuses) {
  (void)points;
  return gcv_minkowski_sum_region_many(first, second, count, options, out, statuses);
}

static gcv_status sum_one(const gcv_polygon *first, const gcv_polygon *second, const double *point,
                          const gcv_options *options, gcv_region **out) {
  (void)point;
  return gcv_minkowski_sum_region(first, second, options, out);
}

static const struct function sums = {"a", "b", 0, sum_many, sum_one};
static const struct function no_fits = {"fixed", "moving", 1, gcv_no_fit_region_many,
                                        gcv_no_fit_region};

/* Does the pair fail, for a reason that the message gives after "pair k: "? */
static const char *reason(const struct function *f, size_t k) {
  return k == NO_FIRST                             ? f->a
         : k == NO_SECOND                          ? f->b
         : k == BAD_REFERENCE && f->has_references ? "reference: the y coordinate is nan"
         : k == TOO_LARGE                          ? "beyond the largest double"
                                                   : NULL;
}

static void each_is_as_alone(const struct function *f, const gcv_options *options) {
  static struct record among, alone;
  gcv_region *out[COUNT + 1];
  gcv_status statuses[COUNT + 1];
  gcv_options one_thread = GCV_OPTIONS_INIT; /* which each pair is computed on, and counted */
  size_t k;
  if (options != NULL) one_thread = *options;
  one_thread.threads = 1;
  for (k = 0; k <= COUNT; ++k) {
    out[k] = UNTOUCHED;
    statuses[k] = UNTOUCHED_STATUS;
  }
  CHECK_OK(f->many(a, b, references, COUNT, options, out, statuses));
  CHECK(strstr(gcv_last_error_message(), "pair 3: ") == gcv_last_error_message());
  CHECK(strstr(gcv_last_error_message(), f->a) != NULL);
  CHECK(out[COUNT] == UNTOUCHED && statuses[COUNT] == UNTOUCHED_STATUS);
  for (k = 0; k < COUNT; ++k) {
    gcv_region *region = NULL;
    const gcv_status status = f->one(a[k], b[k], references + 2 * k, &one_thread, &region);
    CHECK(statuses[k] == status && (out[k] != NULL) == (status == GCV_OK));
    CHECK((status == GCV_OK) == (reason(f, k) == NULL));
    if (status != GCV_OK) CHECK(strstr(gcv_last_error_message(), reason(f, k)) != NULL);
    among.size = alone.size = 0;
    if (out[k] != NULL && region != NULL) {
      put_region(&among, out[k]);
      put_region(&alone, region);
    }
    CHECK(among.size == alone.size && memcmp(among.bytes, alone.bytes, alone.size) == 0);
    gcv_region_destroy(region);
    gcv_region_destroy(out[k]);
  }
}

static void all_options(const struct function *f) {
  gcv_options options = GCV_OPTIONS_INIT;
  each_is_as_alone(f, NULL);
  for (options.threads = 0; options.threads < 4; ++options.threads) each_is_as_alone(f, &options);
  options.leave_out = GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS;
  options.rounding = GCV_ROUND_OUTWARD;
  each_is_as_alone(f, &options);
  options.leave_out = 0;
  options.tolerance = 0.5;
  each_is_as_alone(f, &options);
}

/* Each pair alone, so that the message is about it. */
static void messages(const struct function *f) {
  size_t k;
  for (k = 0; k < COUNT; ++k) {
    gcv_region *out = NULL;
    gcv_status status = UNTOUCHED_STATUS;
    const char *const expected = reason(f, k);
    CHECK_OK(f->many(a + k, b + k, references + 2 * k, 1, NULL, &out, &status));
    CHECK((status == GCV_OK) == (expected == NULL));
    if (expected != NULL) {
      CHECK(strstr(gcv_last_error_message(), "pair 0: ") == gcv_last_error_message());
      CHECK(strstr(gcv_last_error_message(), expected) != NULL);
    }
    gcv_region_destroy(out);
  }
}

static int32_t cancel(void *context, uint64_t done, uint64_t estimate) {
  int *calls = context;
  CHECK(done <= estimate);
  return ++*calls == 2;
}

static void refused(const struct function *f) {
  gcv_region *out[COUNT];
  gcv_status statuses[COUNT];
  gcv_options options = GCV_OPTIONS_INIT;
  int calls = 0;
  size_t k;
  for (k = 0; k < COUNT; ++k) {
    out[k] = UNTOUCHED;
    statuses[k] = UNTOUCHED_STATUS;
  }
  CHECK_OK(f->many(NULL, NULL, NULL, 0, NULL, NULL, NULL));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, f->a,
                f->many(NULL, b, references, COUNT, NULL, out, statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, f->b,
                f->many(a, NULL, references, COUNT, NULL, out, statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "out is NULL",
                f->many(a, b, references, COUNT, NULL, NULL, statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "statuses is NULL",
                f->many(a, b, references, COUNT, NULL, out, NULL));
  if (f->has_references) {
    CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "references is NULL",
                  f->many(a, b, NULL, COUNT, NULL, out, statuses));
  }
  options.leave_out = 4;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "leave_out",
                f->many(a, b, references, COUNT, &options, out, statuses));
  options.leave_out = 0;
  options.progress = cancel;
  options.progress_context = &calls;
  CHECK_REFUSED(GCV_ERR_CANCELLED, "progress",
                f->many(a, b, references, COUNT, &options, out, statuses));
  CHECK(calls == 2);
  for (k = 0; k < COUNT; ++k) CHECK(out[k] == UNTOUCHED && statuses[k] == UNTOUCHED_STATUS);
}

static void many_no_fit_polygons(void) {
  static struct record among, alone;
  gcv_outer_face *out[COUNT];
  gcv_status statuses[COUNT];
  gcv_options options = GCV_OPTIONS_INIT;
  size_t k;
  for (options.threads = 1; options.threads < 3; ++options.threads) {
    CHECK_OK(gcv_no_fit_polygon_many(a, b, references, COUNT, &options, out, statuses));
    CHECK(strcmp(gcv_last_error_message(), "pair 3: fixed is NULL") == 0);
    for (k = 0; k < COUNT; ++k) {
      gcv_outer_face *face = NULL;
      const gcv_status status = gcv_no_fit_polygon(a[k], b[k], references + 2 * k, NULL, &face);
      CHECK(statuses[k] == status && (out[k] != NULL) == (status == GCV_OK));
      among.size = alone.size = 0;
      if (out[k] != NULL && face != NULL) {
        put_face(&among, out[k]);
        put_face(&alone, face);
      }
      CHECK(among.size == alone.size && memcmp(among.bytes, alone.bytes, alone.size) == 0);
      gcv_outer_face_destroy(face);
      gcv_outer_face_destroy(out[k]);
    }
  }
  CHECK_OK(gcv_no_fit_polygon_many(NULL, NULL, NULL, 0, NULL, NULL, NULL));
  for (k = 0; k < COUNT; ++k) out[k] = UNTOUCHED;
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "references is NULL",
                gcv_no_fit_polygon_many(a, b, NULL, COUNT, NULL, out, statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "moving is NULL",
                gcv_no_fit_polygon_many(a, NULL, references, COUNT, NULL, out, statuses));
  for (k = 0; k < COUNT; ++k) CHECK(out[k] == UNTOUCHED);
}

int main(void) {
  size_t k;
  make_pairs();
  all_options(&sums);
  all_options(&no_fits);
  messages(&sums);
  messages(&no_fits);
  refused(&sums);
  refused(&no_fits);
  many_no_fit_polygons();
  for (k = 0; k < sizeof shapes / sizeof *shapes; ++k) gcv_polygon_destroy(shapes[k]);
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Long work: threads, progress, cancelling, and many sums in one call.
 */
#include <pthread.h>
#include <stdlib.h>

#include "handles.h"

enum { MOST_REPORTS = 1000 };

/* A star-shaped ring of 4 * quarter vertices on rational points of a circle, every other one
 * pulled inwards by a different amount. */
static gcv_polygon *star(int quarter, unsigned seed) {
  const size_t count = 4 * (size_t)quarter;
  double *xy = malloc(2 * count * sizeof *xy);
  gcv_polygon *polygon = NULL;
  size_t k;
  for (k = 0; k < count; ++k) {
    const double t = (double)(k % (size_t)quarter) / quarter, w = 1 + t * t;
    const double c = (1 - t * t) / w, s = 2 * t / w;
    const double turned[4][2] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};
    double radius = 1000;
    seed = seed * 1664525u + 1013904223u;
    if (k % 2 != 0) radius -= (double)(seed >> 8) / (1 << 24);
    xy[2 * k] = radius * turned[k / (size_t)quarter][0];
    xy[2 * k + 1] = radius * turned[k / (size_t)quarter][1];
  }
  CHECK_OK(gcv_polygon_create(xy, count, 0, &polygon));
  free(xy);
  return polygon;
}

/* All that a caller can see of an outer face, but for the statistics. */
static void same(const gcv_outer_face *face, const gcv_outer_face *other) {
  size_t count, other_count, edges, other_edges;
  double bound, other_bound, *xy, *other_xy;
  gcv_edge_source *sources, *other_sources;
  CHECK_OK(gcv_outer_face_vertex_count(face, &count));
  CHECK_OK(gcv_outer_face_vertex_count(other, &other_count));
  CHECK_OK(gcv_outer_face_exact_vertex_count(face, &edges));
  CHECK_OK(gcv_outer_face_exact_vertex_count(other, &other_edges));
  CHECK_OK(gcv_outer_face_error_bound(face, &bound));
  CHECK_OK(gcv_outer_face_error_bound(other, &other_bound));
  if (!CHECK(count == other_count && edges == other_edges && bound == other_bound)) return;
  xy = malloc(2 * count * sizeof *xy);
  other_xy = malloc(2 * count * sizeof *xy);
  sources = malloc(edges * sizeof *sources);
  other_sources = malloc(edges * sizeof *sources);
  CHECK_OK(gcv_outer_face_vertices(face, xy, count, &count));
  CHECK_OK(gcv_outer_face_vertices(other, other_xy, count, &count));
  CHECK_OK(gcv_outer_face_edge_sources(face, sources, edges, &edges));
  CHECK_OK(gcv_outer_face_edge_sources(other, other_sources, edges, &edges));
  CHECK(memcmp(xy, other_xy, 2 * count * sizeof *xy) == 0);
  CHECK(memcmp(sources, other_sources, edges * sizeof *sources) == 0);
  free(xy);
  free(other_xy);
  free(sources);
  free(other_sources);
}

static gcv_outer_face *sum_with(const gcv_polygon *a, const gcv_polygon *b, int32_t rounding,
                                int32_t threads) {
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_outer_face *face = NULL;
  options.rounding = rounding;
  options.threads = threads;
  CHECK_OK(gcv_minkowski_sum(a, b, &options, &face));
  return face;
}

static void threads_give_the_same(void) {
  gcv_polygon *shapes[] = {star(200, 1), star(90, 2), POLYGON(0, 0, 1, 0, 1, 1, 0, 1),
                           POLYGON(0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3),
                           POLYGON(0, 0, -5, 1, -7, -2)};
  const size_t count = sizeof shapes / sizeof *shapes;
  const int32_t threads[] = {0, 2, 3, 8};
  size_t i, j, k;
  int32_t rounding;
  for (i = 0; i < count; ++i) {
    for (j = 0; j < count; ++j) {
      for (rounding = 0; rounding < 2; ++rounding) {
        gcv_outer_face *one = sum_with(shapes[i], shapes[j], rounding, 1);
        for (k = 0; k < sizeof threads / sizeof *threads; ++k) {
          gcv_outer_face *several = sum_with(shapes[i], shapes[j], rounding, threads[k]);
          same(one, several);
          gcv_outer_face_destroy(several);
        }
        gcv_outer_face_destroy(one);
      }
    }
  }
  for (i = 0; i < count; ++i) gcv_polygon_destroy(shapes[i]);
}

static void many_threads_are_no_more(void) {
  const int32_t threads[] = {1000, 1 << 30, INT32_MAX};
  gcv_polygon *a = star(20, 9), *b = star(10, 10);
  gcv_outer_face *one = sum_with(a, b, GCV_ROUND_NEAREST, 1);
  size_t k;
  for (k = 0; k < sizeof threads / sizeof *threads; ++k) {
    gcv_outer_face *several = sum_with(a, b, GCV_ROUND_NEAREST, threads[k]);
    same(one, several);
    gcv_outer_face_destroy(several);
  }
  gcv_outer_face_destroy(one);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

static void threads_are_checked(void) {
  gcv_polygon *square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_outer_face *face = NULL;
  options.threads = -1;
  CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "threads is -1",
                gcv_minkowski_sum(square, square, &options, &face));
  CHECK(face == NULL);
  gcv_polygon_destroy(square);
}

struct reports {
  int count;
  int cancel_at; /* the call that returns non-zero; 0: none */
  uint64_t done;
  uint64_t estimate;
  int estimates; /* how many there were, one after another */
  int ends;      /* how many reached the estimate */
  int wrong;
  double shares[MOST_REPORTS]; /* of the estimates that were done */
  pthread_t thread;
};

static int32_t record(void *context, uint64_t done, uint64_t estimate) {
  struct reports *reports = context;
  if (done < reports->done || estimate < done) reports->wrong = 1;
  if (!pthread_equal(reports->thread, pthread_self())) reports->wrong = 1;
  reports->done = done;
  if (reports->count == 0 || estimate != reports->estimate) ++reports->estimates;
  reports->estimate = estimate;
  if (done == estimate) ++reports->ends;
  if (reports->count < MOST_REPORTS)
    reports->shares[reports->count] = (double)done / (double)estimate;
  return ++reports->count == reports->cancel_at ? 7 : 0;
}

static gcv_options reporting(struct reports *reports, int cancel_at, int32_t threads) {
  gcv_options options = GCV_OPTIONS_INIT;
  memset(reports, 0, sizeof *reports);
  reports->cancel_at = cancel_at;
  reports->thread = pthread_self();
  options.threads = threads;
  options.progress = record;
  options.progress_context = reports;
  return options;
}

static void progress_is_reported(void) {
  gcv_polygon *large = star(500, 3), *small = star(3, 4);
  struct reports reports;
  int32_t threads;
  for (threads = 1; threads <= 2; ++threads) {
    gcv_outer_face *face = NULL, *plain = sum_with(large, large, 0, 1);
    gcv_options options = reporting(&reports, 0, threads);
    int count, k;
    CHECK_OK(gcv_minkowski_sum(large, large, &options, &face));
    CHECK(reports.count >= 3 && reports.count < MOST_REPORTS && !reports.wrong);
    same(face, plain);
    gcv_outer_face_destroy(face);
    gcv_outer_face_destroy(plain);
    count = threads == 1 ? reports.count : 3;
    for (k = 1; k <= count; ++k) {
      gcv_outer_face *none = NULL;
      options = reporting(&reports, k, threads);
      CHECK_REFUSED(GCV_ERR_CANCELLED, "progress",
                    gcv_minkowski_sum(large, large, &options, &none));
      CHECK(none == NULL && reports.count == k && !reports.wrong);
    }
  }
  {
    gcv_options options = reporting(&reports, 1, 1);
    gcv_outer_face *none = NULL;
    CHECK_REFUSED(GCV_ERR_CANCELLED, "", gcv_minkowski_sum(small, small, &options, &none));
    options = reporting(&reports, 2, 1);
    CHECK_REFUSED(GCV_ERR_CANCELLED, "", gcv_minkowski_sum(small, small, &options, &none));
    CHECK(none == NULL);
  }
  gcv_polygon_destroy(large);
  gcv_polygon_destroy(small);
}

static int32_t make_a_polygon_once(void *context, uint64_t done, uint64_t estimate) {
  int *const calls = context;
  (void)done, (void)estimate;
  if (++*calls == 1) {
    gcv_polygon_destroy(star(15000, 3));
    CHECK(*calls == 1);
  }
  return 0;
}

/* What is prepared for a question asks the caller, too, and is made anew after a cancel. What the
   caller makes meanwhile does not ask. */
static void preparations_are_cancelled(void) {
  gcv_polygon *a = star(6000, 3), *b = star(6000, 5);
  const double t[2] = {1, 2};
  int8_t relation = 5;
  int calls = 0;
  struct reports reports;
  gcv_options options = reporting(&reports, 5, 1);
  CHECK_REFUSED(GCV_ERR_CANCELLED, "progress", gcv_relation(a, b, t, 1, &options, &relation));
  CHECK(reports.count == 5 && reports.done == 0 && !reports.wrong && relation == 5);
  options.progress = make_a_polygon_once;
  options.progress_context = &calls;
  CHECK_OK(gcv_relation(a, b, t, 1, &options, &relation));
  CHECK(relation == GCV_OVERLAPPING && calls > 5);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

/* A bar that shows it does not stand at its end: only the last report may correct the estimate. */
static void estimate_of_a_region_lasts(void) {
  gcv_polygon *large = star(100, 3);
  gcv_region *region = NULL;
  struct reports reports;
  gcv_options options = reporting(&reports, 0, 1);
  CHECK_OK(gcv_minkowski_sum_region(large, large, &options, &region));
  CHECK(reports.count >= 6 && reports.estimates <= 2 && !reports.wrong);
  gcv_region_destroy(region);
  gcv_polygon_destroy(large);
}

/* Spikes cost far more than their few pairs of edges tell. Still the caller may cancel in between.
 */
static void a_region_asks_often(void) {
  gcv_polygon *a = star(200, 3), *b = star(200, 5);
  gcv_region *region = NULL;
  struct reports reports;
  gcv_options options = reporting(&reports, 0, 1);
  CHECK_OK(gcv_minkowski_sum_region(a, b, &options, &region));
  CHECK(reports.count >= 16 && !reports.wrong);
  gcv_region_destroy(region);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

/* Two stars have far more steps than vertices. Still a bar goes on evenly, and ends with the work.
 */
static void share_of_a_sum_is_even(void) {
  gcv_polygon *a = star(2000, 3), *b = star(1999, 5);
  struct reports reports;
  gcv_outer_face *face = NULL;
  gcv_options options = reporting(&reports, 0, 1);
  CHECK_OK(gcv_minkowski_sum(a, b, &options, &face));
  CHECK(reports.count >= 8 && reports.count < MOST_REPORTS && !reports.wrong);
  CHECK(reports.ends == 1);
  CHECK(reports.shares[reports.count / 4] > 0.1 && reports.shares[reports.count / 4] < 0.5);
  CHECK(reports.shares[reports.count / 2] > 0.3 && reports.shares[reports.count / 2] < 0.7);
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

static void many(void) {
  enum { PAIRS = 40 };
  gcv_polygon *large = star(300, 5), *small = star(10, 6);
  gcv_polygon *huge = POLYGON(0, 0, 1.7e308, 0, 0, 1.7e308);
  const gcv_polygon *a[PAIRS], *b[PAIRS];
  gcv_outer_face *out[PAIRS];
  gcv_status statuses[PAIRS];
  int32_t threads;
  size_t k;
  for (k = 0; k < PAIRS; ++k) {
    a[k] = k % 3 == 0 ? large : small;
    b[k] = k % 2 == 0 ? large : small;
  }
  a[11] = b[11] = huge;
  b[13] = NULL;
  for (threads = 0; threads < 4; ++threads) {
    gcv_options options = GCV_OPTIONS_INIT;
    options.threads = threads;
    memset(out, 0xa5, sizeof out);
    memset(statuses, 0xa5, sizeof statuses);
    CHECK_OK(gcv_minkowski_sum_many(a, b, PAIRS, &options, out, statuses));
    CHECK(strstr(gcv_last_error_message(), "pair 11: ") == gcv_last_error_message());
    for (k = 0; k < PAIRS; ++k) {
      if (k == 11 || k == 13) {
        CHECK(statuses[k] == (k == 11 ? GCV_ERR_RANGE : GCV_ERR_NULL_ARGUMENT) && out[k] == NULL);
      } else if (CHECK(statuses[k] == GCV_OK)) {
        gcv_outer_face *face = sum_with(a[k], b[k], 0, 1);
        same(out[k], face);
        gcv_outer_face_destroy(face);
        gcv_outer_face_destroy(out[k]);
      }
    }
  }
  CHECK_OK(gcv_minkowski_sum_many(NULL, NULL, 0, NULL, NULL, NULL));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "a is NULL",
                gcv_minkowski_sum_many(NULL, b, PAIRS, NULL, out, statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "b is NULL",
                gcv_minkowski_sum_many(a, NULL, PAIRS, NULL, out, statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "out is NULL",
                gcv_minkowski_sum_many(a, b, PAIRS, NULL, NULL, statuses));
  CHECK_REFUSED(GCV_ERR_NULL_ARGUMENT, "statuses is NULL",
                gcv_minkowski_sum_many(a, b, PAIRS, NULL, out, NULL));
  {
    struct reports reports;
    gcv_options options = reporting(&reports, 2, 2);
    memset(out, 0, sizeof out);
    memset(statuses, 0x5a, sizeof statuses);
    CHECK_REFUSED(GCV_ERR_CANCELLED, "progress",
                  gcv_minkowski_sum_many(a, b, PAIRS, &options, out, statuses));
    CHECK(reports.count == 2 && !reports.wrong && out[0] == NULL && statuses[0] == 0x5a5a5a5a);
  }
  gcv_polygon_destroy(large);
  gcv_polygon_destroy(small);
  gcv_polygon_destroy(huge);
}

static gcv_status region_of(int function, const gcv_polygon *a, const gcv_polygon *b,
                            const gcv_options *options, gcv_region **out) {
  const double origin[2] = {0, 0};
  gcv_status status = GCV_OK;
  if (function == 0) return gcv_minkowski_sum_region(a, b, options, out);
  if (function == 1) return gcv_inner_fit_region(a, b, origin, options, out);
  CHECK_OK(gcv_minkowski_sum_region_many(&a, &b, 1, options, out, &status));
  return status;
}

/* Regions report and can be cancelled like outer faces; the wkt is the same for all threads. */
static void regions(void) {
  gcv_polygon *large = star(300, 11), *small = star(7, 12);
  int function;
  for (function = 0; function < 3; ++function) {
    static char first[1 << 17], other[1 << 17];
    int32_t threads;
    for (threads = 1; threads <= 3; ++threads) {
      struct reports reports;
      gcv_options options = reporting(&reports, 0, threads);
      gcv_region *region = NULL;
      size_t required = 0;
      int k, count;
      CHECK_OK(region_of(function, large, small, &options, &region));
      CHECK(reports.count >= 2 && reports.count < MOST_REPORTS && !reports.wrong);
      CHECK_OK(gcv_region_wkt(region, threads == 1 ? first : other, sizeof first, &required));
      if (threads > 1) CHECK(strcmp(first, other) == 0);
      gcv_region_destroy(region);
      count = threads == 1 ? reports.count : 2;
      for (k = 1; function < 2 && k <= count; ++k) {
        gcv_region *none = NULL;
        options = reporting(&reports, k, threads);
        CHECK_REFUSED(GCV_ERR_CANCELLED, "progress",
                      region_of(function, large, small, &options, &none));
        CHECK(none == NULL && reports.count == k && !reports.wrong);
      }
    }
  }
  gcv_polygon_destroy(large);
  gcv_polygon_destroy(small);
}

enum { WORKERS = 4, REGION_PAIRS = 6, PLACES = 400, MOST_WKT = 1 << 16 };

/* What threads share that compute regions and locate points at the same time. */
static gcv_polygon *fixed, *moving;
static gcv_region *shared_region;
static double places_xy[2 * PLACES];
static int8_t places[PLACES];
static char shared_wkt[MOST_WKT];

static void region_with_threads(int32_t threads) {
  struct reports reports;
  gcv_options options = reporting(&reports, 0, threads);
  const double origin[2] = {0, 0};
  gcv_region *region = NULL, *none = NULL;
  char *const wkt = malloc(MOST_WKT);
  size_t required;
  CHECK_OK(gcv_no_fit_region(fixed, moving, origin, &options, &region));
  CHECK(reports.count >= 2 && !reports.wrong);
  CHECK_OK(gcv_region_wkt(region, wkt, MOST_WKT, &required));
  CHECK(strcmp(wkt, shared_wkt) == 0);
  options = reporting(&reports, 2, threads);
  CHECK_REFUSED(GCV_ERR_CANCELLED, "progress",
                gcv_no_fit_region(fixed, moving, origin, &options, &none));
  CHECK(none == NULL && reports.count == 2 && !reports.wrong);
  gcv_region_destroy(region);
  free(wkt);
}

static void many_regions_with_threads(int32_t threads) {
  struct reports reports;
  gcv_options options = reporting(&reports, 0, threads);
  const gcv_polygon *a[REGION_PAIRS], *b[REGION_PAIRS];
  double references[2 * REGION_PAIRS] = {0};
  gcv_region *out[REGION_PAIRS] = {NULL};
  gcv_status statuses[REGION_PAIRS];
  char *const wkt = malloc(MOST_WKT);
  size_t k, required;
  for (k = 0; k < REGION_PAIRS; ++k) {
    a[k] = fixed;
    b[k] = moving;
    statuses[k] = -1;
  }
  CHECK_OK(gcv_no_fit_region_many(a, b, references, REGION_PAIRS, &options, out, statuses));
  CHECK(reports.count >= 2 && !reports.wrong);
  for (k = 0; k < REGION_PAIRS; ++k) {
    if (!CHECK(statuses[k] == GCV_OK)) continue;
    CHECK_OK(gcv_region_wkt(out[k], wkt, MOST_WKT, &required));
    CHECK(strcmp(wkt, shared_wkt) == 0);
    gcv_region_destroy(out[k]);
    out[k] = NULL;
    statuses[k] = -1;
  }
  options = reporting(&reports, 2, threads);
  CHECK_REFUSED(GCV_ERR_CANCELLED, "progress",
                gcv_no_fit_region_many(a, b, references, REGION_PAIRS, &options, out, statuses));
  CHECK(reports.count == 2 && !reports.wrong);
  for (k = 0; k < REGION_PAIRS; ++k) CHECK(out[k] == NULL && statuses[k] == -1);
  free(wkt);
}

static void *compute_and_locate(void *argument) {
  const int32_t threads = *(const int32_t *)argument;
  int8_t found[PLACES] = {0};
  CHECK_OK(gcv_region_locate(shared_region, places_xy, PLACES, found));
  CHECK(memcmp(found, places, sizeof found) == 0);
  region_with_threads(threads);
  many_regions_with_threads(threads);
  return NULL;
}

/* Several threads, each of which computes with several of its own. All locate points in one
 * region, and are the first to do so. */
static void regions_at_the_same_time(void) {
  const double origin[2] = {0, 0};
  int32_t threads[WORKERS] = {1, 2, 3, 0};
  pthread_t workers[WORKERS];
  gcv_region *other = NULL;
  size_t required;
  int k;
  fixed = star(40, 21);
  moving = star(6, 22);
  CHECK_OK(gcv_no_fit_region(fixed, moving, origin, NULL, &shared_region));
  CHECK_OK(gcv_no_fit_region(fixed, moving, origin, NULL, &other));
  CHECK_OK(gcv_region_wkt(other, shared_wkt, MOST_WKT, &required));
  for (k = 0; k < PLACES; ++k) {
    places_xy[2 * k] = -2200 + 11 * k;
    places_xy[2 * k + 1] = k % 7 * 100;
  }
  CHECK_OK(gcv_region_locate(other, places_xy, PLACES, places));
  for (k = 0; k < WORKERS; ++k) {
    if (!CHECK(pthread_create(&workers[k], NULL, compute_and_locate, &threads[k]) == 0)) exit(1);
  }
  for (k = 0; k < WORKERS; ++k) CHECK(pthread_join(workers[k], NULL) == 0);
  gcv_region_destroy(other);
  gcv_region_destroy(shared_region);
  gcv_polygon_destroy(fixed);
  gcv_polygon_destroy(moving);
}

/* What programs have that were compiled when the struct had no more fields. */
static void first_options(void) {
  struct {
    uint32_t struct_size;
    int32_t rounding;
    double tolerance;
  } first = {16, GCV_ROUND_OUTWARD, 0};
  gcv_polygon *a = star(10, 7), *b = star(5, 8);
  gcv_outer_face *face = NULL, *outward = sum_with(a, b, GCV_ROUND_OUTWARD, 1);
  uint32_t size;
  CHECK(sizeof first == 16);
  CHECK_OK(gcv_minkowski_sum(a, b, (const gcv_options *)(const void *)&first, &face));
  same(face, outward);
  for (size = 0; size < sizeof(gcv_options); ++size) {
    gcv_options options = GCV_OPTIONS_INIT;
    gcv_outer_face *none = NULL;
    options.struct_size = size;
    if (size == 16 || size == offsetof(gcv_options, leave_out)) continue;
    CHECK_REFUSED(GCV_ERR_INVALID_ARGUMENT, "struct_size",
                  gcv_minkowski_sum(a, b, &options, &none));
    CHECK(none == NULL);
  }
  gcv_outer_face_destroy(face);
  gcv_outer_face_destroy(outward);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
}

int main(void) {
  threads_give_the_same();
  many_threads_are_no_more();
  threads_are_checked();
  progress_is_reported();
  preparations_are_cancelled();
  estimate_of_a_region_lasts();
  a_region_asks_often();
  share_of_a_sum_is_even();
  many();
  regions();
  regions_at_the_same_time();
  first_options();
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Progress of the questions about scenes, and their end by it.
 */
#include "regions.h"
#include "scenes.h"

struct progress {
  int calls, ends_at; /* the call that ends the computation; 0 for none */
  int is_wrong;
  uint64_t done;
};

static int32_t report(void *context, uint64_t done, uint64_t estimate) {
  struct progress *progress = context;
  if (progress->calls == 0 ? done != 0 : done < progress->done) progress->is_wrong = 1;
  if (estimate < done) progress->is_wrong = 1;
  progress->done = done;
  return ++progress->calls == progress->ends_at;
}

enum { MOST = 5000, FEW = 400, SIDE = 5 };

static gcv_scene *scene;
static gcv_polygon *unit;
static double positions[2 * MOST];
static int8_t relations[MOST];
static gcv_separation separations[MOST];
static gcv_impact impacts[MOST];
static gcv_pair_list *pairs;
static gcv_contact_list *contacts;
static gcv_region *region;
static gcv_escape escapes[FEW];
static double best[2];
static int32_t found;

static gcv_status ask_relation(const gcv_options *options) {
  return gcv_scene_relation(scene, unit, positions, MOST, NULL, options, relations);
}
static gcv_status ask_distance(const gcv_options *options) {
  return gcv_scene_distance(scene, unit, positions, MOST, NULL, options, separations);
}
static gcv_status ask_cast(const gcv_options *options) {
  return gcv_scene_cast(scene, unit, positions, positions, MOST, NULL, options, impacts);
}
static gcv_status ask_near(const gcv_options *options) {
  return gcv_scene_near(scene, unit, positions, 5, NULL, options, &pairs);
}
static gcv_status ask_pairs(const gcv_options *options) {
  return gcv_scene_pairs(scene, NULL, 1, NULL, options, &pairs);
}
static gcv_status ask_contacts(const gcv_options *options) {
  return gcv_scene_contacts(scene, NULL, 1, 0, NULL, options, &contacts);
}
static gcv_status ask_free_region(const gcv_options *options) {
  return gcv_scene_free_region(scene, unit, NULL, NULL, options, &region);
}
static gcv_status ask_best(const gcv_options *options) {
  static const double direction[] = {1, 0.5};
  return gcv_scene_best(scene, unit, direction, NULL, options, best, &found);
}
static gcv_status ask_penetration(const gcv_options *options) {
  return gcv_scene_penetration(scene, unit, positions, FEW, NULL, options, escapes);
}

static void forget(void) {
  gcv_pair_list_destroy(pairs);
  gcv_contact_list_destroy(contacts);
  gcv_region_destroy(region);
  pairs = NULL;
  contacts = NULL;
  region = NULL;
  relations[0] = 77;
  separations[0].distance = impacts[0].time = escapes[0].depth = 77;
  best[0] = found = 77;
}

static int is_untouched(void) {
  return pairs == NULL && contacts == NULL && relations[0] == 77 && separations[0].distance == 77 &&
         impacts[0].time == 77 && region == NULL && escapes[0].depth == 77 && best[0] == 77 &&
         found == 77;
}

static void follow(gcv_status (*ask)(const gcv_options *options), int32_t threads) {
  struct progress progress = {0, 0, 0, 0};
  gcv_options options = GCV_OPTIONS_INIT;
  int calls, k;
  options.progress = report;
  options.progress_context = &progress;
  options.threads = threads;
  forget();
  CHECK_OK(ask(&options));
  calls = progress.calls;
  CHECK(calls >= 2 && !progress.is_wrong && !is_untouched());
  /* At the start, on the way, and at the end. With threads the number of calls is no matter of
   * course. */
  for (k = 0; k < (threads == 1 ? 3 : 1); ++k) {
    const struct progress ending = {0, k == 0 ? 1 : k == 1 ? (calls + 1) / 2 : calls, 0, 0};
    progress = ending;
    forget();
    CHECK_STATUS(GCV_ERR_CANCELLED, ask(&options));
    CHECK(progress.calls == progress.ends_at && !progress.is_wrong && is_untouched());
    forget();
    CHECK_OK(ask(NULL));
    CHECK(!is_untouched());
  }
}

int main(void) {
  gcv_polygon *room = POLYGON(-3, -3, 11, -3, 11, 11, -3, 11);
  int k;
  int32_t threads;
  unit = SQUARE(1);
  scene = new_scene();
  CHECK_OK(gcv_scene_set_container(scene, room));
  for (k = 0; k < SIDE * SIDE; ++k) add(scene, unit, 1.5 * (k % SIDE), 1.5 * (k / SIDE));
  for (k = 0; k < MOST; ++k) {
    positions[2 * k] = (k % 173) / 16.0 - 2;
    positions[2 * k + 1] = (k % 101) / 8.0 - 2;
  }
  for (threads = 1; threads <= 3; threads += 2) {
    follow(ask_relation, threads);
    follow(ask_distance, threads);
    follow(ask_cast, threads);
    follow(ask_near, threads);
    follow(ask_pairs, threads);
    follow(ask_contacts, threads);
    follow(ask_free_region, threads);
    follow(ask_best, threads);
    follow(ask_penetration, threads);
  }
  forget();
  gcv_scene_destroy(scene);
  gcv_polygon_destroy(unit);
  gcv_polygon_destroy(room);
  return check_failures != 0;
}

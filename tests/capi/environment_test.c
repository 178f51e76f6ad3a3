/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The caller's floating-point environment, its rounding mode, flush-to-zero, trapping and
 * flags, changes no result and is changed by no call.
 */
#if defined(__GLIBC__) || defined(__linux__)
#define _GNU_SOURCE /* feenableexcept */
#endif
#include <fenv.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "scenes.h"

/* Two members and a container, at places where they have no doubles. */
static void put_scene_of(struct record *record, const gcv_polygon *a, const gcv_polygon *b) {
  const gcv_polygon *members[2];
  const double positions[] = {0.1, 0.2, 1e9, 0.3};
  uint64_t ids[2];
  gcv_scene *scene = new_scene();
  members[0] = members[1] = a;
  if (put_status(record, gcv_scene_set_container(scene, b)) &&
      put_status(record, gcv_scene_add(scene, members, positions, 2, ids))) {
    put_scene(record, scene);
  }
  gcv_scene_destroy(scene);
}

static void put_everything(struct record *record) {
  int pair;
  for (pair = 0; pair < PAIRS; ++pair) {
    gcv_polygon *a = NULL, *b = NULL;
    if (put_status(record, pair_polygon(pair, 0, &a)) &&
        put_status(record, pair_polygon(pair, 1, &b))) {
      put_pair(record, a, b, pair_tolerances[pair]);
      if (pair < 2) put_scene_of(record, b, a); /* integers and fractions */
    }
    gcv_polygon_destroy(a);
    gcv_polygon_destroy(b);
  }
  put_others(record);
  put_refusals(record);
}

static struct record reference, record;

static unsigned control_and_flags(void) {
#if defined(__SSE__)
  return _mm_getcsr();
#else
  return 0;
#endif
}

/* To be called in the environment to test. */
static void same_here(const char *name) {
  const int failures = check_failures;
  const int rounding = fegetround(), flags = fetestexcept(FE_ALL_EXCEPT);
  const unsigned csr = control_and_flags();
  int rounding_after, flags_after;
  unsigned csr_after;
  record.size = 0;
  put_everything(&record);
  rounding_after = fegetround();
  flags_after = fetestexcept(FE_ALL_EXCEPT);
  csr_after = control_and_flags();
  fesetenv(FE_DFL_ENV);
  CHECK(rounding_after == rounding);
  CHECK(flags_after == flags);
  CHECK(csr_after == csr);
  CHECK(record.size == reference.size && memcmp(record.bytes, reference.bytes, record.size) == 0);
  if (check_failures != failures) fprintf(stderr, "  with %s\n", name);
}

int main(void) {
  put_everything(&reference);
  CHECK(reference.size > 10000);

  fesetenv(FE_DFL_ENV);
  same_here("no flag raised");
  fesetround(FE_UPWARD);
  feraiseexcept(FE_DIVBYZERO);
  same_here("rounding upwards");
  fesetround(FE_DOWNWARD);
  feraiseexcept(FE_ALL_EXCEPT);
  same_here("rounding downwards");
  fesetround(FE_TOWARDZERO);
  same_here("rounding towards zero");
#if defined(__SSE__)
  _mm_setcsr(_mm_getcsr() | 0x8040);
  same_here("flush-to-zero and denormals-are-zero");
  fesetround(FE_UPWARD);
  _mm_setcsr(_mm_getcsr() | 0x8040);
  same_here("both, and rounding upwards");
#endif
#if defined(__GLIBC__)
  feenableexcept(FE_ALL_EXCEPT);
  record.size = 0;
  put_everything(&record);
  CHECK(fegetexcept() == FE_ALL_EXCEPT);
  same_here("every exception trapping");
#endif
  return check_failures != 0;
}

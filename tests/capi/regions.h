/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Regions as text, and in comparison with what they should be.
 */
#ifndef GCV_TESTS_CAPI_REGIONS_H
#define GCV_TESTS_CAPI_REGIONS_H

#include "rings.h"

enum { MOST_PARTS = 64, MOST_REGION_TEXT = 4096 };

/* A frame of width 1 about a hole of 2 x 2, and a square that goes into it. */
static const struct rings frame = {2, {4, 4}, {0, 0, 4, 0, 4, 4, 0, 4, 1, 1, 3, 1, 3, 3, 1, 3}};
/* A slot of width 2 from above. */
#define SLOTTED 0, 0, 6, 0, 6, 6, 4, 6, 4, 2, 2, 2, 2, 6, 0, 6
/* A hole of 2 x 2. */
static const struct rings plate = {2, {4, 4}, {0, 0, 6, 0, 6, 6, 0, 6, 2, 2, 4, 2, 4, 4, 2, 4}};
#define SQUARE(size) POLYGON(0, 0, size, 0, size, size, 0, size)

static inline gcv_region *region_of_sum(const gcv_polygon *a, const gcv_polygon *b) {
  gcv_region *region = NULL;
  CHECK_OK(gcv_minkowski_sum_region(a, b, NULL, &region));
  return region;
}

static inline gcv_region *no_fit_region(const gcv_polygon *fixed, const gcv_polygon *moving,
                                        uint64_t leave_out, int32_t rounding) {
  const double origin[2] = {0, 0};
  gcv_options options = GCV_OPTIONS_INIT;
  gcv_region *region = NULL;
  options.leave_out = leave_out;
  options.rounding = rounding;
  CHECK_OK(gcv_no_fit_region(fixed, moving, origin, &options, &region));
  return region;
}

static const char *const part_names[] = {"?", "outer", "hole", "segment", "point"};

/* The exact region, as "outer p/q r/s, p/q r/s, ...; hole ...; segment ...; point ...", or "empty".
 * For text of MOST_REGION_TEXT bytes. */
static inline void exact_region_text(const gcv_region *region, char *text) {
  gcv_region_part parts[MOST_PARTS];
  size_t count = 0, vertex = 0, required, k, i;
  char *to = text;
  strcpy(text, "empty");
  if (!CHECK_OK(gcv_region_exact_parts(region, parts, MOST_PARTS, &count))) return;
  for (k = 0; k < count; ++k) {
    to += sprintf(to, "%s%s ", k == 0 ? "" : "; ", part_names[parts[k].kind]);
    for (i = 0; i < parts[k].vertex_count; ++i) {
      to += sprintf(to, "%s", i == 0 ? "" : ", ");
      if (!CHECK_OK(gcv_region_exact_vertex(
              region, vertex++, to, (size_t)(text + MOST_REGION_TEXT - 32 - to), &required))) {
        return;
      }
      to += required - 1;
    }
  }
  /* There are no more vertices than those of the parts. */
  CHECK_STATUS(GCV_ERR_INVALID_ARGUMENT,
               gcv_region_exact_vertex(region, vertex, NULL, 0, &required));
}

static inline int exact_region_is(const gcv_region *region, const char *expected) {
  char text[MOST_REGION_TEXT];
  exact_region_text(region, text);
  if (strcmp(text, expected) == 0) return 1;
  fprintf(stderr, "the exact region is %s\n", text);
  return 0;
}

/* The polygons and the fits in doubles, as texts. */
static inline int region_is(const gcv_region *region, const char *polygons, const char *fits) {
  char text[MOST_REGION_TEXT] = "", fits_text[MOST_REGION_TEXT] = "";
  size_t required = 0;
  CHECK_OK(gcv_region_wkt(region, text, sizeof text, &required));
  CHECK(required == strlen(text) + 1);
  CHECK_OK(gcv_region_fits_wkt(region, fits_text, sizeof fits_text, &required));
  CHECK(required == strlen(fits_text) + 1);
  if (strcmp(text, polygons) == 0 && strcmp(fits_text, fits) == 0) return 1;
  fprintf(stderr, "the region is\n  %s\n  %s\n", text, fits_text);
  return 0;
}

#endif

/*
 * Known results from an installed libgcv.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include <gcv/gcv.h>
#include <stdio.h>

/* Says what went wrong if a condition does not hold; gives 1 then, else 0. */
static int wrong(int condition, const char *what) {
  if (condition) return 0;
  fprintf(stderr, "smoke: %s; last error: \"%s\"\n", what, gcv_last_error_message());
  return 1;
}

int main(void) {
  const double one[] = {0, 0, 1, 0, 1, 1, 0, 1};
  const double two[] = {0, 0, 2, 0, 2, 2, 0, 2};
  const double bow_tie[] = {0, 0, 2, 2, 2, 0, 0, 2};
  const double three[] = {0, 0, 3, 0, 3, 3, 0, 3};
  gcv_polygon *a = NULL, *b = NULL, *none = NULL;
  gcv_outer_face *face = NULL;
  double area = 0, xy[8] = {0};
  size_t count = 0;
  int k, failures = 0;

  failures += wrong(gcv_version_number() / 10000 == GCV_VERSION_MAJOR, "major version");
  failures += wrong(gcv_polygon_create(one, 4, 0, &a) == GCV_OK, "first square");
  failures += wrong(gcv_polygon_create(two, 4, 0, &b) == GCV_OK, "second square");
  failures += wrong(gcv_minkowski_sum(a, b, NULL, &face) == GCV_OK, "sum");
  failures += wrong(gcv_outer_face_area(face, &area) == GCV_OK && area == 9, "area is not 9");
  failures += wrong(gcv_outer_face_vertices(face, xy, 4, &count) == GCV_OK && count == 4,
                    "not four vertices");
  for (k = 0; k < 8; ++k) failures += wrong(xy[k] == three[k], "a coordinate");

  failures += wrong(gcv_polygon_create(bow_tie, 4, 0, &none) == GCV_ERR_NOT_SIMPLE && !none,
                    "bow-tie accepted");
  failures += wrong(gcv_last_error_message()[0] != '\0', "no message");

  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
  return failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Where C writes one and a half as 1,5, Well-Known Text still has a point.
 */
#include <locale.h>

#include "handles.h"

int main(void) {
  const char text[] = "POLYGON ((0 0, 1.5 0, 1.5 1.25, 0 1.25))";
  char written[128] = "";
  gcv_polygon *polygon = NULL, *back = NULL;
  gcv_outer_face *face;
  size_t required = 0;

  if (setlocale(LC_ALL, "comma") == NULL) {
    fprintf(stderr, "skipped: there is no locale with a decimal comma\n");
    return SKIPPED;
  }
  CHECK(strcmp(localeconv()->decimal_point, ",") == 0);

  CHECK_OK(gcv_polygon_create_wkt(text, sizeof text - 1, &polygon));
  CHECK(polygon_is(polygon, RING(0, 0, 1.5, 0, 1.5, 1.25, 0, 1.25)));
  face = sum_of(polygon, polygon);
  CHECK_OK(gcv_outer_face_wkt(face, written, sizeof written, &required));
  CHECK(strcmp(written, "POLYGON ((0 0, 3 0, 3 2.5, 0 2.5, 0 0))") == 0);
  CHECK_STATUS(GCV_ERR_PARSE, gcv_polygon_create_wkt("POLYGON ((0 0, 1,5 0, 0 1))", 27, &back));
  CHECK(localeconv()->decimal_point[0] == ',');

  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(polygon);
  return check_failures != 0;
}

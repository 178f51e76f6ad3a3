/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Polygons from Well-Known Text.
 */
#include <float.h>
#include <stdint.h>
#include <stdlib.h>

#include "handles.h"

/* Parses a copy of the text that has exactly `length` bytes. */
static gcv_status parse_bytes(const char *text, size_t length, gcv_polygon **out) {
  char *copy = malloc(length > 0 ? length : 1);
  gcv_status status;
  if (copy == NULL) abort();
  memcpy(copy, text, length);
  status = gcv_polygon_create_wkt(copy, length, out);
  free(copy);
  return status;
}

static void is_the_triangle(const char *text) {
  gcv_polygon *polygon = NULL;
  CHECK_OK(parse_bytes(text, strlen(text), &polygon));
  CHECK(polygon_is(polygon, RING(0, 0, 4, 0, 0, 3)));
  gcv_polygon_destroy(polygon);
}

static void accepted(void) {
  is_the_triangle("POLYGON ((0 0, 4 0, 0 3, 0 0))");
  is_the_triangle("POLYGON ((0 0, 4 0, 0 3))");
  is_the_triangle("POLYGON ((0 3, 4 0, 0 0, 0 3))");
  is_the_triangle("polygon((0 0,4 0,0 3,0 0))");
  is_the_triangle(" \t\r\n\f\vPoLyGoN\n(\t( 0\v0 ,\f4\r0 ,\n0 3 , 0 0 ) ) \n");
  is_the_triangle("POLYGON ((+0 -0, 4e0 0e7, -0.0 30E-1, 0 0))");
  is_the_triangle("POLYGON ((0. .0, +0.4e+1 0e-9, 000 3.000, 0 0))");
  is_the_triangle("POLYGON ((0 0, 2 0, 2 0, 4 0, 0 3))");
  /* The outer ring of polygons with holes. */
  is_the_triangle("POLYGON ((0 0, 4 0, 0 3, 0 0), (1 1, 1.5 1, 1 1.5, 1 1))");
  is_the_triangle("POLYGON ((0 0, 4 0, 0 3), (1 1, 1.5 1, 1 1.5),(0.5 0.5, 1 0.5, 1 1, 0.5 0.5))");
}

static void refused(gcv_status status, const char *part, const char *text) {
  gcv_polygon *polygon = NULL;
  if (!CHECK_REFUSED(status, part, parse_bytes(text, strlen(text), &polygon))) {
    fprintf(stderr, "  text: %s\n", text);
  }
  CHECK(polygon == NULL);
}

static void malformed(void) {
  static const char *const texts[] = {
      "",
      " ",
      "(",
      "POLY",
      "POLYGON",
      "POLYGON(",
      "POLYGON ()",
      "POLYGON (())",
      "POLYGON ((,))",
      "POLYGON EMPTY x",
      "POLYGON EMPTY ((0 0, 4 0, 0 3))",
      "POLYGONE ((0 0, 4 0, 0 3))",
      "POINT (0 0)",
      "MULTIPOLYGON (((0 0, 4 0, 0 3)))",
      "POLYGON Z ((0 0 0, 4 0 0, 0 3 0))",
      "POLYGON ((0 0 0, 4 0 0, 0 3 0))",
      "POLYGON (0 0, 4 0, 0 3)",
      "POLYGON ((0 0, 4 0, 0 3)) x",
      "POLYGON ((0 0, 4 0, 0 3)))",
      "POLYGON ((0 0, 4 0, 0 3)",
      "POLYGON ((0 0, 4 0, 0 3),)",
      "POLYGON ((0 0, 4 0, 0 3), ())",
      "POLYGON ((0 0, 4 0, 0 3) (1 1, 2 1, 1 2))",
      "POLYGON ((0 0, 4 0, 0 3), (1 1))",
      "POLYGON ((0 0, 4 0, 0 3), (1 1, 2 1))",
      "POLYGON ((0 0, 4 0, 0 3), (1 1, 2 1, 1 1))",
      "POLYGON ((0 0, 4 0, 0 3), EMPTY)",
      "POLYGON ((0 0,, 4 0, 0 3))",
      "POLYGON ((0 0, 4 0, 0 3,))",
      "POLYGON ((0, 4 0, 0 3))",
      "POLYGON ((0 0; 4 0; 0 3))",
      "POLYGON ((0,0 4,0 0,3))",
      "POLYGON ((0 0, 4,0 0, 0 3))",
      "POLYGON ((0 0, --4 0, 0 3))",
      "POLYGON ((0 0, +-4 0, 0 3))",
      "POLYGON ((0 0, ++4 0, 0 3))",
      "POLYGON ((0 0, - 4 0, 0 3))",
      "POLYGON ((0 0, . 0, 0 3))",
      "POLYGON ((0 0, + 0, 0 3))",
      "POLYGON ((0 0, e5 0, 0 3))",
      "POLYGON ((0 0, 4e 0, 0 3))",
      "POLYGON ((0 0, 4e+ 0, 0 3))",
      "POLYGON ((0 0, 4-1, 0 3))",
      "POLYGON ((0 0, 4.5.5, 0 3))",
      "POLYGON ((0 0, 4_0 0, 0 3))",
      "POLYGON ((0 0, 4.0.0 0, 0 3))",
      "POLYGON ((0 0, 4f 0, 0 3))",
  };
  size_t k;
  for (k = 0; k < sizeof texts / sizeof *texts; ++k) refused(GCV_ERR_PARSE, "byte ", texts[k]);
}

static void byte_offsets(void) {
  refused(GCV_ERR_PARSE, "byte 0:", "LINE");
  refused(GCV_ERR_PARSE, "byte 16:", "POLYGON ((0 0, 4?0, 0 3))");
  refused(GCV_ERR_PARSE, "byte 19:", "POLYGON ((0 0, 4 0,? 3))");
  refused(GCV_ERR_PARSE, "byte 22:", "POLYGON ((0 0, 4 0, 0 ?))");
  refused(GCV_ERR_PARSE, "byte 24:", "POLYGON ((0 0, 4 0, 0 3)");
  refused(GCV_ERR_PARSE, "byte 26:", "POLYGON ((0 0, 4 0, 0 3)) ?");
}

static void other_refusals(void) {
  refused(GCV_ERR_DEGENERATE, "EMPTY", "POLYGON EMPTY");
  refused(GCV_ERR_DEGENERATE, "EMPTY", " polygon empty\n");
  refused(GCV_ERR_DEGENERATE, "", "POLYGON ((0 0))");
  refused(GCV_ERR_DEGENERATE, "", "POLYGON ((0 0, 1 1, 0 0))");
  refused(GCV_ERR_DEGENERATE, "", "POLYGON ((0 0, 1 1, 2 2))");
  refused(GCV_ERR_NOT_SIMPLE, "edges 0 and 2", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))");
  refused(GCV_ERR_NOT_FINITE, "1e999", "POLYGON ((0 0, 1e999 0, 0 3))");
  refused(GCV_ERR_NOT_FINITE, "-1e400", "POLYGON ((0 0, 4 0, 0 -1e400))");
  refused(GCV_ERR_NOT_FINITE, "", "POLYGON ((0 0, 1.7976931348623159e308 0, 0 3))");
  refused(GCV_ERR_NOT_FINITE, "1e999", "POLYGON ((0 0, 4 0, 0 3), (1 1, 1e999 1, 1 2))");
  /* What C reads as a NaN or an infinity is a number, but no coordinate. */
  refused(GCV_ERR_NOT_FINITE, "nan", "POLYGON ((0 0, nan 0, 0 3))");
  refused(GCV_ERR_NOT_FINITE, "-NAN", "POLYGON ((0 0, -NAN 0, 0 3))");
  refused(GCV_ERR_NOT_FINITE, "inf", "POLYGON ((0 0, 4 inf, 0 3))");
  refused(GCV_ERR_NOT_FINITE, "-Infinity", "POLYGON ((0 0, 4 -Infinity, 0 3))");
}

static void number_is(double expected, const char *number) {
  char text[2000];
  gcv_polygon *polygon = NULL;
  double xy[6] = {0};
  size_t required;
  const int length = snprintf(text, sizeof text, "POLYGON ((0 %s, 2 -1, 3 -1.25))", number);
  CHECK_OK(parse_bytes(text, (size_t)length, &polygon));
  CHECK_OK(gcv_polygon_vertices(polygon, xy, 3, &required));
  if (!CHECK(xy[1] == expected)) fprintf(stderr, "  %.40s gave %a\n", number, xy[1]);
  gcv_polygon_destroy(polygon);
}

static void numbers(void) {
  char text[900];
  number_is(0.1, "0.1");
  number_is(-0x1.8p3, "-1.2e1");
  number_is(123456.789, "+123456789e-3");
  number_is(0x1p53, "9007199254740993");
  number_is(0x1p53 + 2, "9007199254740993.0000000000000000000000000000001");
  number_is(DBL_MAX, "1.7976931348623157e308");
  number_is(DBL_MAX, "1.7976931348623158e+308");
  number_is(0x1p-1074, "5e-324");
  number_is(0x1p-1074, "2.5e-324");
  number_is(0x0.fffffffffffffp-1022, "2.2250738585072011e-308");
  number_is(0, "2.4e-324");
  number_is(0, "1e-999");
  number_is(0, "-1e-999");
  number_is(0, "1e-99999999999999999999");
  number_is(0, "0e99999999999999999999");
  number_is(0, "0.000e+999");

  /* 10^400 in digits, divided by 10^400, and the other way round. */
  memset(text, '0', sizeof text);
  text[0] = '1';
  strcpy(text + 401, "e-400");
  number_is(1, text);
  memset(text, '0', 402);
  text[1] = '.';
  strcpy(text + 401, "1e400");
  number_is(1, text);
}

static const char *const valid[] = {
    "POLYGON ((0 0, 4 0, 0 3, 0 0))",
    "polygon((-1.25e-1 +.5,4e3 0,0 3.),(1 1,2 1,1 2))",
};
enum { VALID_COUNT = sizeof valid / sizeof *valid };

static void truncated(void) {
  gcv_polygon *polygon = NULL;
  size_t k, length;
  for (k = 0; k < VALID_COUNT; ++k) {
    for (length = 0; length < strlen(valid[k]); ++length) {
      CHECK_REFUSED(GCV_ERR_PARSE, "byte ", parse_bytes(valid[k], length, &polygon));
    }
    CHECK_OK(parse_bytes(valid[k], length, &polygon));
    gcv_polygon_destroy(polygon);
    polygon = NULL;
  }
}

/* Is the offset in the message that of the garbage, or of the token that it spoils? */
static int points_at(size_t position) {
  const char *at = strstr(gcv_last_error_message(), "byte ");
  size_t offset = 0;
  return at != NULL && sscanf(at, "byte %zu", &offset) == 1 && offset <= position &&
         offset + 8 > position;
}

static void garbage(void) {
  static const char bytes[] = {'\0', '\1', '!', ';', 'x', '\177', '\200', '\377'};
  char text[80];
  gcv_polygon *polygon = NULL;
  size_t k, b, position;
  for (k = 0; k < VALID_COUNT; ++k) {
    const size_t length = strlen(valid[k]);
    for (position = 0; position < length; ++position) {
      for (b = 0; b < sizeof bytes; ++b) {
        memcpy(text, valid[k], length);
        text[position] = bytes[b];
        CHECK_STATUS(GCV_ERR_PARSE, parse_bytes(text, length, &polygon));
        CHECK(points_at(position));
        memcpy(text + position + 1, valid[k] + position, length - position);
        CHECK_STATUS(GCV_ERR_PARSE, parse_bytes(text, length + 1, &polygon));
        CHECK(points_at(position));
      }
    }
  }
  CHECK(polygon == NULL);
}

/* Three bytes at a time, of those that the grammar knows: anything may come of it, but
 * nothing undocumented. */
static void random_texts(void) {
  static const char alphabet[] = "POLYGNEMTpin()(),, \t0123456789.+-eExa";
  char text[80];
  uint64_t state = 1;
  unsigned seen[16] = {0};
  int round, change;
  for (round = 0; round < 20000; ++round) {
    const char *base = valid[round % VALID_COUNT];
    const size_t length = strlen(base);
    gcv_polygon *polygon = NULL;
    gcv_status status;
    memcpy(text, base, length);
    for (change = 0; change < 3; ++change) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      text[(state >> 33) % length] = alphabet[(state >> 45) % (sizeof alphabet - 1)];
    }
    status = parse_bytes(text, length, &polygon);
    CHECK((polygon != NULL) == (status == GCV_OK));
    if (CHECK(status == GCV_OK || (status >= GCV_ERR_NOT_FINITE && status <= GCV_ERR_NOT_SIMPLE) ||
              status == GCV_ERR_PARSE)) {
      ++seen[status];
    }
    gcv_polygon_destroy(polygon);
  }
  CHECK(seen[GCV_OK] > 0 && seen[GCV_ERR_PARSE] > 0 && seen[GCV_ERR_NOT_SIMPLE] > 0);
}

int main(void) {
  accepted();
  malformed();
  byte_offsets();
  other_refusals();
  numbers();
  truncated();
  garbage();
  random_texts();
  return check_failures != 0;
}

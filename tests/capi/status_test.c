/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Versions, names of statuses, and the message of the last failure. The other programs
 * provoke every status through every function that documents it, save two: none knows an
 * input that gives GCV_ERR_INTERNAL, a defect of the library, and a text of more than
 * 2^31 vertices, for GCV_ERR_INVALID_ARGUMENT, would take many gigabytes.
 */
#include <pthread.h>

#include "check.h"

static void versions(void) {
  char text[32];
  snprintf(text, sizeof text, "%d.%d.%d", GCV_VERSION_MAJOR, GCV_VERSION_MINOR, GCV_VERSION_PATCH);
  CHECK(strcmp(gcv_version_string(), text) == 0);
  CHECK(gcv_version_number() ==
        GCV_VERSION_MAJOR * 10000 + GCV_VERSION_MINOR * 100 + GCV_VERSION_PATCH);
}

static void status_names(void) {
  static const struct {
    int32_t value, status;
    const char *name;
  } known[] = {
      {0, GCV_OK, "GCV_OK"},
      {1, GCV_ERR_NULL_ARGUMENT, "GCV_ERR_NULL_ARGUMENT"},
      {2, GCV_ERR_INVALID_ARGUMENT, "GCV_ERR_INVALID_ARGUMENT"},
      {3, GCV_ERR_NOT_FINITE, "GCV_ERR_NOT_FINITE"},
      {4, GCV_ERR_DEGENERATE, "GCV_ERR_DEGENERATE"},
      {5, GCV_ERR_NOT_SIMPLE, "GCV_ERR_NOT_SIMPLE"},
      {6, GCV_ERR_BUFFER_TOO_SMALL, "GCV_ERR_BUFFER_TOO_SMALL"},
      {7, GCV_ERR_RANGE, "GCV_ERR_RANGE"},
      {8, GCV_ERR_PARSE, "GCV_ERR_PARSE"},
      {9, GCV_ERR_NO_MEMORY, "GCV_ERR_NO_MEMORY"},
      {100, GCV_ERR_INTERNAL, "GCV_ERR_INTERNAL"},
  };
  static const gcv_status unknown[] = {-1, 10, 99, 101, INT32_MAX, INT32_MIN};
  size_t k;
  for (k = 0; k < sizeof known / sizeof *known; ++k) {
    CHECK(known[k].value == known[k].status);
    CHECK(strcmp(gcv_status_name(known[k].value), known[k].name) == 0);
  }
  for (k = 0; k < sizeof unknown / sizeof *unknown; ++k) {
    CHECK(strcmp(gcv_status_name(unknown[k]), "GCV_ERR_UNKNOWN") == 0);
  }
}

static void fail_by_null(void) {
  CHECK_STATUS(GCV_ERR_NULL_ARGUMENT, gcv_polygon_area(NULL, NULL));
}

static void fail_by_parsing(const char *text) {
  gcv_polygon *polygon = NULL;
  CHECK_STATUS(GCV_ERR_PARSE, gcv_polygon_create_wkt(text, strlen(text), &polygon));
}

struct thread_messages {
  char first[512], later[512];
};

static void *fail_in_thread(void *argument) {
  struct thread_messages *messages = argument;
  gcv_polygon *polygon = NULL;
  strcpy(messages->first, gcv_last_error_message());
  if (gcv_polygon_create_wkt("thread", 6, &polygon) == GCV_ERR_PARSE) {
    strcpy(messages->later, gcv_last_error_message());
  }
  return NULL;
}

static void last_error_message(void) {
  const double triangle[] = {0, 0, 1, 0, 0, 1};
  gcv_polygon *polygon = NULL;
  double area = 0;
  char before[512] = "", long_text[2000];
  pthread_t threads[2];
  struct thread_messages messages[2] = {{"?", ""}, {"?", ""}};
  size_t k;

  CHECK(strcmp(gcv_last_error_message(), "") == 0);
  CHECK_OK(gcv_polygon_create(triangle, 3, 0, &polygon));
  CHECK(strcmp(gcv_last_error_message(), "") == 0);

  fail_by_null();
  strcpy(before, gcv_last_error_message());
  CHECK(strlen(before) > 0);
  CHECK_OK(gcv_polygon_area(polygon, &area));
  gcv_polygon_destroy(polygon);
  CHECK(strcmp(gcv_last_error_message(), before) == 0);

  for (k = 0; k < 2; ++k) {
    if (!CHECK(pthread_create(&threads[k], NULL, fail_in_thread, &messages[k]) == 0)) return;
  }
  for (k = 0; k < 2; ++k) {
    CHECK(pthread_join(threads[k], NULL) == 0);
    CHECK(strcmp(messages[k].first, "") == 0);
    CHECK(strlen(messages[k].later) > 0 && strcmp(messages[k].later, before) != 0);
  }
  CHECK(strcmp(gcv_last_error_message(), before) == 0);

  fail_by_parsing("POLYGON ((nonsense");
  CHECK(strcmp(gcv_last_error_message(), before) != 0);
  memset(long_text, '7', sizeof long_text);
  memcpy(long_text, "POLYGON ((", 10);
  CHECK_STATUS(GCV_ERR_NOT_FINITE, gcv_polygon_create_wkt(long_text, sizeof long_text, &polygon));
  CHECK(strlen(gcv_last_error_message()) <= 511);
}

int main(void) {
  versions();
  status_names();
  last_error_message();
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Checks: each says on stderr what does not hold, and the program goes on. main returns
 * check_failures != 0.
 */
#ifndef GCV_TESTS_CAPI_CHECK_H
#define GCV_TESTS_CAPI_CHECK_H

#include <gcv/gcv.h>
#include <stdio.h>
#include <string.h>

/* The exit status of a test that cannot run here. */
#define SKIPPED 77

#define CHECK(condition) check((condition) != 0, __FILE__, __LINE__, #condition)
#define CHECK_STATUS(expected, call) check_status(expected, call, "", __FILE__, __LINE__, #call)
#define CHECK_OK(call) CHECK_STATUS(GCV_OK, call)
/* The call gives the status, and `part` occurs in the message. */
#define CHECK_REFUSED(expected, part, call) \
  check_status(expected, call, part, __FILE__, __LINE__, #call)

static int check_failures = 0;

static inline int check(int holds, const char *file, int line, const char *text) {
  if (!holds) {
    fprintf(stderr, "%s:%d: %s\n  last error: \"%s\"\n", file, line, text,
            gcv_last_error_message());
    ++check_failures;
  }
  return holds;
}

static inline int check_status(gcv_status expected, gcv_status status, const char *part,
                               const char *file, int line, const char *text) {
  const int holds = status == expected && strstr(gcv_last_error_message(), part) != NULL;
  if (!holds) {
    fprintf(stderr, "%s:%d: %s\n  gave %s (%d), expected %s \"...%s...\"\n  last error: \"%s\"\n",
            file, line, text, gcv_status_name(status), (int)status, gcv_status_name(expected), part,
            gcv_last_error_message());
    ++check_failures;
  }
  return holds;
}

#endif

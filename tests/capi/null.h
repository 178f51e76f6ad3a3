/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * A call that is given NULL is refused by a message that names the parameter.
 */
#ifndef GCV_TESTS_CAPI_NULL_H
#define GCV_TESTS_CAPI_NULL_H

#include <ctype.h>

#include "handles.h"

#define REFUSES(parameter, call)                          \
  do {                                                    \
    CHECK_STATUS(GCV_ERR_NULL_ARGUMENT, call);            \
    CHECK(has_word(gcv_last_error_message(), parameter)); \
  } while (0)

static inline int has_word(const char *text, const char *word) {
  const size_t length = strlen(word);
  const char *at = text;
  for (; (at = strstr(at, word)) != NULL; ++at) {
    const int starts = at == text || !isalnum((unsigned char)at[-1]);
    if (starts && !isalnum((unsigned char)at[length])) return 1;
  }
  return 0;
}

/* Outputs hold these before the calls, and must hold them after. */
static char nowhere;
static const double UNTOUCHED = -12345.5;
#define UNTOUCHED_HANDLE ((void *)&nowhere)
static const size_t UNTOUCHED_COUNT = 4711;
static const gcv_status UNTOUCHED_STATUS = -4711;

#endif

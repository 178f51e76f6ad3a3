/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Calls without memory: the first, the second, ... allocation and all after it fail, until one more
 * would have been enough. For that, the program has a malloc of its own, which a sanitizer or
 * valgrind would not allow, and which a DLL would not see: GCV_STARVES says whether it has.
 */
#ifndef GCV_TESTS_CAPI_STARVE_H
#define GCV_TESTS_CAPI_STARVE_H

#include <stdlib.h>

#include "handles.h"

#if !defined(GCV_SANITIZED) && defined(__linux__)
#define GCV_STARVES 1

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

extern void *__libc_malloc(size_t size);
extern void __libc_free(void *block);

static long allowed = -1; /* allocations until they fail; below 0: for ever */
static long live = 0;

void *malloc(size_t size) {
  if (allowed == 0) return NULL;
  if (allowed > 0) --allowed;
  ++live;
  return __libc_malloc(size);
}

void free(void *block) {
  if (block != NULL) --live;
  __libc_free(block);
}

/* Of the program that is to starve: all that its calls give. */
static int outputs_are_untouched(void);
static void forget_outputs(void);

/* Each time the call says GCV_ERR_NO_MEMORY, gives nothing out, and gives back what it took. */
static void starve(gcv_status (*call)(void)) {
  long enough = 0;
  for (;; ++enough) {
    const long live_before = live;
    gcv_status status;
    allowed = enough;
    status = call();
    allowed = -1;
    if (status == GCV_OK) break;
    if (!CHECK_STATUS(GCV_ERR_NO_MEMORY, status)) break;
    CHECK(live == live_before);
    CHECK(outputs_are_untouched());
  }
  CHECK(enough > 0);
  forget_outputs();
}

/* In a child process, so that one function that ends the process is one failure. */
static void starve_in_child(const char *name, gcv_status (*call)(void)) {
  const pid_t child = fork();
  int status = -1;
  if (child == 0) {
    check_failures = 0;
    starve(call);
    _exit(check_failures != 0);
  }
  CHECK(child > 0 && waitpid(child, &status, 0) == child);
  if (!CHECK(status == 0)) {
    fprintf(stderr, "  %s %s %d\n", name, WIFSIGNALED(status) ? "ends by signal" : "exits with",
            WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
  }
}

#else
#define GCV_STARVES 0

static inline int skip(void) {
  fprintf(stderr, "skipped: the sanitizers, and Windows, have a malloc of their own\n");
  return SKIPPED;
}

#endif

#endif

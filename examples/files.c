/*
 * files.c - whole files in, checked files out.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include "files.h"

#include <errno.h>
#include <stdlib.h>

/* Reads to the end of the file. *text grows by doubling, and is the caller's even on failure. */
static bool read_all(FILE *file, char **text, size_t *length) {
  size_t capacity = 0;
  while (!feof(file)) {
    if (*length == capacity) {
      capacity = capacity ? 2 * capacity : 4096;
      char *larger = realloc(*text, capacity);
      if (!larger) return false;
      *text = larger;
    }
    *length += fread(*text + *length, 1, capacity - *length, file);
    if (ferror(file)) return false;
  }
  return true;
}

bool read_file(const char *path, char **text, size_t *length) {
  FILE *file = fopen(path, "rb");
  if (!file) return false;

  *text = NULL;
  *length = 0;
  bool ok = read_all(file, text, length);

  int reason = errno; /* of the reading, not of what follows */
  fclose(file);
  if (!ok) free(*text);
  errno = reason;
  return ok;
}

bool close_output(FILE *file) {
  /* A full disk may show at any write or only at the last, the one by fclose. */
  bool written = fflush(file) == 0 && !ferror(file);
  int reason = errno;
  bool closed = fclose(file) == 0;
  if (!written) errno = reason;
  return written && closed;
}

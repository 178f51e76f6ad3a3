/*
 * files.h - whole files in, checked files out.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef EXAMPLES_FILES_H
#define EXAMPLES_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/** Reads a file. *text is the caller's to free. On failure errno says why. */
bool read_file(const char *path, char **text, size_t *length);

/** Closes a file. Says whether all that was written has arrived; if not, errno says why. */
bool close_output(FILE *file);

#endif

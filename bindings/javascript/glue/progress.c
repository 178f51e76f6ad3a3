/*
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The progress function of gcv_options, which asks JavaScript.
 */
#include <gcv/gcv.h>

#define IMPORT(name) __attribute__((import_module("gcv"), import_name(name)))

IMPORT("progress") int32_t gcv_js_report(double done, double estimate);

/* JavaScript would get integers of 64 bits as BigInt. */
static int32_t progress(void *context, uint64_t done, uint64_t estimate) {
  (void)context;
  return gcv_js_report((double)done, (double)estimate);
}

void gcv_js_set_progress(gcv_options *options);
void gcv_js_set_progress(gcv_options *options) {
  options->progress = progress;
}

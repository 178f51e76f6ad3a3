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

/* The layouts that src/records.ts, options.ts, facts.ts, sums.ts and scene.ts read and write. */
_Static_assert(sizeof(gcv_options) == 40 && sizeof(gcv_query) == 16 && sizeof(gcv_stats) == 64, "");
_Static_assert(sizeof(gcv_edge_source) == 12 && sizeof(gcv_superset_edge) == 48, "");
_Static_assert(sizeof(gcv_region_part) == 16 && sizeof(gcv_contact) == 88, "");
_Static_assert(sizeof(gcv_separation) == 104 && sizeof(gcv_escape) == 136, "");
_Static_assert(sizeof(gcv_impact) == 120 && sizeof(gcv_pair) == 24, "");

void gcv_js_set_progress(gcv_options *options) { options->progress = progress; }

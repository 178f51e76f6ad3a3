// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The options of computations.

import { CancelledError, unfit } from "./errors.js";
import { Made } from "./handle.js";
import { library, reporting, view } from "./library.js";
import { check, type Scratch } from "./memory.js";
import { numberOf } from "./points.js";

/** What a region is to lack, to save time: its holes, its segments and points, or both. */
export type LeaveOut = "holes" | "fits" | readonly ("holes" | "fits")[];

/** Options of whatever can take long. */
export interface CallOptions {
  /**
   * Called with the steps done and a guess of all steps, which is never below, at the start, at the
   * end, and every few thousand steps. Where it gives true, the computation ends with a
   * CancelledError; what it throws ends it too.
   */
  progress?: (done: number, estimate: number) => boolean | void;
  /**
   * Ends the computation with its reason. Nothing else runs in this thread during a computation: it
   * has to be aborted before or by the progress function.
   */
  signal?: AbortSignal;
}

/** Options of outer faces. */
export interface SumOptions extends CallOptions {
  /**
   * How exact coordinates become doubles. With "nearest", the default, each is the nearest double,
   * save where vertices must move a few units in the last place for a ring to be simple. With
   * "outward" a sum contains the exact one, and a free region lies inside the exact one.
   */
  rounding?: "nearest" | "outward";
  /**
   * How far, in input units, the result may be from the exact one, but for the rounding. 0 by
   * default. Above 0, each polygon is first simplified by at most half of it.
   */
  tolerance?: number;
}

/** Options of regions. */
export interface RegionOptions extends SumOptions {
  /** What the region is to lack. Inner fits and free regions have all holes. */
  leaveOut?: LeaveOut;
}

const roundings = ["nearest", "outward"];
const parts = ["holes", "fits"];

/** The rounding as the library takes it. */
export function roundingOf(rounding: string = "nearest"): number {
  const value = roundings.indexOf(rounding);
  if (value < 0) {
    throw unfit("rounding", rounding, `one of ${roundings.join(", ")}`);
  }
  return value;
}

function bitsOf(leaveOut: LeaveOut = []): number {
  let bits = 0;
  for (const part of typeof leaveOut === "string" ? [leaveOut] : leaveOut) {
    if (!parts.includes(part)) {
      throw unfit("leaveOut", part, `one of ${parts.join(", ")}`);
    }
    bits |= 1 << parts.indexOf(part);
  }
  return bits;
}

const optionsSize = 40;

/** Makes a call that takes options, which are in memory of the scratch. */
export function run(
  scratch: Scratch,
  options: RegionOptions,
  call: (options: number) => number,
): void {
  const { progress, signal } = options;
  signal?.throwIfAborted();
  const pointer = scratch.room(optionsSize);
  library.gcv_options_init_size(pointer, optionsSize);
  view().setInt32(pointer + 4, roundingOf(options.rounding), true);
  view().setFloat64(pointer + 8, numberOf(options.tolerance ?? 0, "tolerance"), true);
  view().setUint32(pointer + 32, bitsOf(options.leaveOut), true);
  if (progress === undefined) {
    check(call(pointer));
    return;
  }
  library.gcv_js_set_progress(pointer);
  let thrown: { error: unknown } | undefined;
  const report = (done: number, estimate: number): boolean => {
    try {
      return progress(done, estimate) === true || signal?.aborted === true;
    } catch (error) {
      thrown = { error };
      return true;
    }
  };
  try {
    check(reporting(report, () => call(pointer)));
  } catch (error) {
    if (error instanceof CancelledError) {
      if (thrown !== undefined) {
        throw thrown.error;
      }
      signal?.throwIfAborted();
    }
    throw error;
  }
}

/** The object that such a call makes, and writes to `out`. @internal */
export function madeBy(
  scratch: Scratch,
  options: RegionOptions,
  call: (options: number, out: number) => number,
): Made {
  const out = scratch.room(4);
  run(scratch, options, (known) => call(known, out));
  return new Made(view().getUint32(out, true));
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The options of computations.

import { CancelledError, errorOf, Status, unfit } from "./errors.js";
import { Made } from "./handle.js";
import { library, reporting, view } from "./library.js";
import { check, type Scratch } from "./memory.js";
import { numberOf } from "./points.js";

/** What a region is to lack, to save time: its holes, its segments and points, or both. */
export type LeaveOut = "holes" | "fits" | readonly ("holes" | "fits")[];

/** What is used of an AbortSignal; any AbortSignal will do. */
export interface AbortSignalLike {
  readonly aborted: boolean;
  throwIfAborted(): void;
}

/** Options of whatever can take long. */
export interface CallOptions {
  /**
   * Called with the steps done and a guess of all steps, which is never below, at the start, at the
   * end, and every few thousand steps. Where it gives true, the computation ends with a
   * CancelledError; what it throws ends it too. It can read and ask all objects. To free or
   * to change one that the computation uses throws.
   */
  progress?: (done: number, estimate: number) => boolean | void;
  /**
   * Ends the computation with its reason. Nothing else runs in this thread during a computation: it
   * has to be aborted before or by the progress function.
   */
  signal?: AbortSignalLike;
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

/** The names of the options of each kind. @internal */
export const callOptions = ["progress", "signal"];
export const sumOptions = [...callOptions, "rounding", "tolerance"];
export const regionOptions = [...sumOptions, "leaveOut"];
export const escapeOptions = [...callOptions, "leaveOut"];

/** Throws for what is no options, and for an option with none of these names. @internal */
export function checkOptions(options: object, names: readonly string[]): void {
  if (typeof options !== "object" || options === null) {
    throw unfit("options", options, "an object");
  }
  const other = Object.keys(options).find((name) => !names.includes(name));
  if (other !== undefined) {
    throw unfit("options", other, `one of ${names.join(", ")}`);
  }
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
  for (const part of Array.isArray(leaveOut) ? leaveOut : [leaveOut]) {
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
  const { rounding, tolerance = 0, leaveOut, progress, signal } = options;
  if (progress !== undefined && typeof progress !== "function") {
    throw unfit("progress", progress, "a function");
  }
  if (signal !== undefined && typeof signal?.throwIfAborted !== "function") {
    throw unfit("signal", signal, "an AbortSignal");
  }
  signal?.throwIfAborted();
  const pointer = scratch.room(optionsSize);
  library.gcv_options_init_size(pointer, optionsSize);
  view().setInt32(pointer + 4, roundingOf(rounding), true);
  view().setFloat64(pointer + 8, numberOf(tolerance, "tolerance"), true);
  view().setUint32(pointer + 32, bitsOf(leaveOut), true);
  if (progress === undefined) {
    check(call(pointer));
    return;
  }
  library.gcv_js_set_progress(pointer);
  let thrown: { error: unknown } | undefined;
  const report = (done: number, estimate: number): boolean => {
    try {
      const answer: unknown = progress(done, estimate);
      if (answer instanceof Promise) {
        const reason = "progress: it gives a promise; only true at once ends a computation";
        throw errorOf(Status.INVALID_ARGUMENT, reason);
      }
      return answer === true || signal?.aborted === true;
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

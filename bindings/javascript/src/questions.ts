// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about two polygons, one of which is moved by translations.

import { errorOf, renamed, Status } from "./errors.js";
import { library } from "./library.js";
import { ContactList } from "./lists.js";
import { structsAt, withScratch, type Scratch } from "./memory.js";
import { withPolygons } from "./operands.js";
import {
  callOptions,
  checkOptions,
  escapeOptions,
  madeBy,
  run,
  type CallOptions,
  type LeaveOut,
} from "./options.js";
import { coordinatesOf, isPoint, numberOf, numbersOf, type Point, type Points } from "./points.js";
import {
  escapeStruct,
  impactStruct,
  relationStruct,
  separationStruct,
  type Escape,
  type Impact,
  type Relation,
  type Separation,
  type Struct,
} from "./records.js";
import type { PolygonLike } from "./sources.js";

/** Options of ways out of overlaps. */
export interface EscapeOptions extends CallOptions {
  /** Where ways are not to lead. */
  leaveOut?: LeaveOut;
}

/**
 * What a call gives for vectors by their names: one record where each of them is a point, else one
 * for each. A point stands for as many as there are of the others. @internal
 */
export function answer<T>(
  scratch: Scratch,
  struct: Struct<T>,
  vectors: Record<string, Point | Points>,
  options: EscapeOptions,
  call: (vectors: number[], count: number, options: number, out: number) => number,
): T | T[] {
  const read = Object.entries(vectors).map(([name, value]) => {
    const isOne = isPoint(value);
    const coordinates = isOne
      ? numbersOf(value, 2, name)
      : coordinatesOf(value, name, "a pair of numbers, nor an array of pairs");
    return { name, isOne, coordinates };
  });
  const several = read.filter(({ isOne }) => !isOne);
  const count = several.length === 0 ? 1 : several[0].coordinates.length / 2;
  if (several.some(({ coordinates }) => coordinates.length !== 2 * count)) {
    const counts = several.map(({ name, coordinates }) => `${name} has ${coordinates.length / 2} pairs`);
    throw errorOf(Status.INVALID_ARGUMENT, counts.join(" and "));
  }
  const pointers = read.map(({ isOne, coordinates }) =>
    scratch.doubles(
      isOne ? Float64Array.from({ length: 2 * count }, (_, k) => coordinates[k % 2]) : coordinates,
    ),
  );
  const out = scratch.room(struct.size * count);
  run(scratch, options, (known) => call(pointers, count, known, out));
  const records = structsAt(out, struct.size, count, struct.read);
  return several.length === 0 ? records[0] : records;
}

function ask<T>(
  call: (...values: number[]) => number,
  struct: Struct<T>,
  sources: Record<string, PolygonLike>,
  vectors: Record<string, Point | Points>,
  options: EscapeOptions,
  names = callOptions,
): T | T[] {
  checkOptions(options, names);
  return withPolygons(sources, (a, b) =>
    withScratch((scratch) =>
      renamed(/^(translation|motion)s:/, "$1:", () =>
        answer(scratch, struct, vectors, options, (pointers, ...rest) =>
          call(a!, b!, ...pointers, ...rest),
        ),
      ),
    ),
  );
}

/** How A and B, moved by a translation, lie: exact. One translation, or many. */
export function relation(
  a: PolygonLike,
  b: PolygonLike,
  translation?: Point,
  options?: CallOptions,
): Relation;
export function relation(
  a: PolygonLike,
  b: PolygonLike,
  translation: Points,
  options?: CallOptions,
): Relation[];
export function relation(
  a: PolygonLike,
  b: PolygonLike,
  translation: Point | Points = [0, 0],
  options: CallOptions = {},
): Relation | Relation[] {
  return ask(library.gcv_relation, relationStruct, { a, b }, { translation }, options);
}

/** How far B, moved by a translation, is from A, and where they are nearest. */
export function distance(
  a: PolygonLike,
  b: PolygonLike,
  translation?: Point,
  options?: CallOptions,
): Separation;
export function distance(
  a: PolygonLike,
  b: PolygonLike,
  translation: Points,
  options?: CallOptions,
): Separation[];
export function distance(
  a: PolygonLike,
  b: PolygonLike,
  translation: Point | Points = [0, 0],
  options: CallOptions = {},
): Separation | Separation[] {
  return ask(library.gcv_distance, separationStruct, { a, b }, { translation }, options);
}

/**
 * How far B can move along a motion before it overlaps A, from the translation on. Sliding is no
 * hit, and neither is touching at the end. A pair stands for as many as the others are.
 */
export function cast(
  a: PolygonLike,
  b: PolygonLike,
  translation: Point,
  motion: Point,
  options?: CallOptions,
): Impact;
export function cast(
  a: PolygonLike,
  b: PolygonLike,
  translation: Point | Points,
  motion: Point | Points,
  options?: CallOptions,
): Impact[];
export function cast(
  a: PolygonLike,
  b: PolygonLike,
  translation: Point | Points,
  motion: Point | Points,
  options: CallOptions = {},
): Impact | Impact[] {
  return ask(library.gcv_cast, impactStruct, { a, b }, { translation, motion }, options);
}

/** The shortest way out: how B is best moved on so that it does not overlap A. */
export function penetration(
  a: PolygonLike,
  b: PolygonLike,
  translation?: Point,
  options?: EscapeOptions,
): Escape;
export function penetration(
  a: PolygonLike,
  b: PolygonLike,
  translation: Points,
  options?: EscapeOptions,
): Escape[];
export function penetration(
  a: PolygonLike,
  b: PolygonLike,
  translation: Point | Points = [0, 0],
  options: EscapeOptions = {},
): Escape | Escape[] {
  const call = library.gcv_penetration;
  return ask(call, escapeStruct, { a, b }, { translation }, options, escapeOptions);
}

/**
 * The contacts of A and B, moved by a translation, whose |gap| is at most the distance. With a slope
 * also those that a turn by an angle of at most this tangent would admit.
 */
export function contacts(
  a: PolygonLike,
  b: PolygonLike,
  translation: Point = [0, 0],
  distance = 0,
  slope = 0,
  options: CallOptions = {},
): ContactList {
  checkOptions(options, callOptions);
  return withPolygons({ a, b }, (first, second) =>
    withScratch((scratch) => {
      const place = scratch.doubles(numbersOf(translation, 2, "translation"));
      const limits = [numberOf(distance, "distance"), numberOf(slope, "slope")];
      return new ContactList(
        madeBy(scratch, options, (known, out) =>
          library.gcv_contacts(first!, second!, place, ...limits, known, out),
        ),
      );
    }),
  );
}

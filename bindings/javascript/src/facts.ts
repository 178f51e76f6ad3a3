// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What outer faces and regions tell of themselves.

import { view } from "./library.js";
import { check, integerAt, textOf, withScratch } from "./memory.js";

/** The kind of a superset edge. */
export const EdgeKind = {
  /** No edge: a point, the second end of a segment, or what a window has cut. */
  NONE: 0,
  /** Edge a of A, translated by vertex b of B. */
  TRANSLATED: 1,
  /** Edge b of B, translated by vertex a of A. */
  CORNER: 2,
  /** Edge a of A and edge b of B, which have the same direction, merged. */
  TRANSLATED_CORNER: 3,
} as const;
export type EdgeKind = (typeof EdgeKind)[keyof typeof EdgeKind];

/** Where an edge of a sum comes from: numbers of vertices or edges of A and B as passed. */
export interface EdgeSource {
  kind: EdgeKind;
  a: number;
  b: number;
}

/** A fraction in lowest terms, with a positive denominator. */
export interface Fraction {
  numerator: bigint;
  denominator: bigint;
}

/** An exact vertex. */
export type ExactPoint = [x: Fraction, y: Fraction];

/** What a computation took: counts, the same on every run, not times. */
export interface Stats {
  /** Edges that the walk went along. */
  walkSteps: number;
  /** Superset edges that the walk tested. */
  candidateEdges: number;
  /** Predicates decided by doubles with a proven error bound, or by indices. */
  predicatesFiltered: number;
  /** Predicates decided by double-doubles or by integers of at most 512 bits. */
  predicatesFixedWidth: number;
  /** Predicates that needed larger integers, of up to 21,504 bits. */
  predicatesRational: number;
  /** Vertices moved further than to the nearest double to keep rings simple and apart. */
  verticesRepaired: number;
  /** Parts of the exact region that doubles cannot show; 0 for outer faces. */
  partsDropped: number;
}

export const edgeSourceSize = 12;

export function edgeSourceAt(pointer: number): EdgeSource {
  return {
    kind: view().getInt32(pointer, true) as EdgeKind,
    a: view().getUint32(pointer + 4, true),
    b: view().getUint32(pointer + 8, true),
  };
}

/** The exact vertex whose text the call writes. */
export function exactPointOf(call: Parameters<typeof textOf>[0]): ExactPoint {
  return textOf(call)
    .split(" ")
    .map((fraction) => {
      const [numerator, denominator] = fraction.split("/").map(BigInt) as [bigint, bigint];
      return { numerator, denominator };
    }) as ExactPoint;
}

const statsSize = 64;

export function statsOf(call: (out: number) => number): Stats {
  return withScratch((scratch) => {
    const out = scratch.room(statsSize);
    view().setUint32(out, statsSize, true);
    check(call(out));
    const count = (index: number) => integerAt(out + 8 * index);
    return {
      walkSteps: count(1),
      candidateEdges: count(2),
      predicatesFiltered: count(3),
      predicatesFixedWidth: count(4),
      predicatesRational: count(5),
      verticesRepaired: count(6),
      partsDropped: count(7),
    };
  });
}

/** The smallest box round coordinates x0, y0, x1, y1, ...; undefined for none. */
export function boundsOf(
  coordinates: Float64Array,
): [xmin: number, ymin: number, xmax: number, ymax: number] | undefined {
  if (coordinates.length === 0) {
    return undefined;
  }
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; k < coordinates.length; ++k) {
    box[k % 2] = Math.min(box[k % 2], coordinates[k]);
    box[2 + (k % 2)] = Math.max(box[2 + (k % 2)], coordinates[k]);
  }
  return box;
}

/** Whether two lists of exact vertices are equal. */
export function areEqual(p: readonly ExactPoint[], q: readonly ExactPoint[]): boolean {
  const same = (f: Fraction, g: Fraction) =>
    f.numerator === g.numerator && f.denominator === g.denominator;
  return p.length === q.length && p.every(([x, y], k) => same(x, q[k][0]) && same(y, q[k][1]));
}


// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Outer faces and regions of two polygons, and of many pairs.

import { caught, GcvError, type Status } from "./errors.js";
import { edgeSourceAt, type EdgeSource } from "./facts.js";
import { Made } from "./handle.js";
import { library, view } from "./library.js";
import { failure, lastMessage, pointerOf, structsAt, structsOf, withScratch } from "./memory.js";
import { withOperands, withPolygons } from "./operands.js";
import {
  checkOptions,
  madeBy,
  regionOptions,
  run,
  sumOptions,
  type RegionOptions,
  type SumOptions,
} from "./options.js";
import { OuterFace } from "./outer_face.js";
import { checkCounts, coordinatesOf, elementsOf, numbersOf, type Point, type Points } from "./points.js";
import { Region } from "./region.js";
import type { PolygonLike } from "./sources.js";

/** An edge of the superset, from one point to another. */
export interface SupersetEdge {
  start: Point;
  end: Point;
  source: EdgeSource;
}

/** Of functions for many pairs. */
export interface ManyOptions {
  /** Gives errors in the places of results, and does not throw the first one. */
  returnErrors?: boolean;
}

/** The names of the options of such a result. */
function optionsOf(Result: Function): string[] {
  return Result === OuterFace ? sumOptions : regionOptions;
}

type Sum = (a: number, b: number, options: number, out: number) => number;
type PlacedSum = (a: number, b: number, point: number, options: number, out: number) => number;

function sum<T>(
  call: Sum,
  Result: new (made: Made) => T,
  sources: Record<string, PolygonLike>,
  options: RegionOptions,
): T {
  checkOptions(options, optionsOf(Result));
  return withPolygons(sources, (a, b) =>
    withScratch(
      (scratch) => new Result(madeBy(scratch, options, (known, out) => call(a!, b!, known, out))),
    ),
  );
}

function placedSum<T>(
  call: PlacedSum,
  Result: new (made: Made) => T,
  sources: Record<string, PolygonLike>,
  [name, point]: [name: string, point: Point],
  options: RegionOptions,
): T {
  return withScratch((scratch) => {
    const place = scratch.doubles(numbersOf(point, 2, name));
    return sum((a, b, known, out) => call(a, b, place, known, out), Result, sources, options);
  });
}

/**
 * The outer face of the Minkowski sum A + B: the boundary of what lies outside of it. Holes of the
 * polygons change nothing; minkowskiSumRegion has what the ring leaves out.
 */
export function minkowskiSum(a: PolygonLike, b: PolygonLike, options: SumOptions = {}): OuterFace {
  return sum(library.gcv_minkowski_sum, OuterFace, { a, b }, options);
}

/**
 * The no-fit polygon fixed + (-moving) + reference: where the point `reference`, tied to `moving`,
 * may go while the two touch. noFitRegion has what the ring leaves out.
 */
export function noFitPolygon(
  fixed: PolygonLike,
  moving: PolygonLike,
  reference: Point = [0, 0],
  options: SumOptions = {},
): OuterFace {
  const point: [string, Point] = ["reference", reference];
  return placedSum(library.gcv_no_fit_polygon, OuterFace, { fixed, moving }, point, options);
}

/** Shi's entrance block B + (-A) + a0: where the point a0 of block A may go while the two touch. */
export function entranceBlock(
  a: PolygonLike,
  b: PolygonLike,
  a0: Point = [0, 0],
  options: SumOptions = {},
): OuterFace {
  return placedSum(library.gcv_entrance_block, OuterFace, { a, b }, ["a0", a0], options);
}

/** The Minkowski sum A + B with all of its holes, and the exact fits in it. */
export function minkowskiSumRegion(
  a: PolygonLike,
  b: PolygonLike,
  options: RegionOptions = {},
): Region {
  return sum(library.gcv_minkowski_sum_region, Region, { a, b }, options);
}

/**
 * The no-fit region fixed + (-moving) + reference: where the point `reference`, tied to `moving`,
 * may not go. On its boundary, segments and points the two touch.
 */
export function noFitRegion(
  fixed: PolygonLike,
  moving: PolygonLike,
  reference: Point = [0, 0],
  options: RegionOptions = {},
): Region {
  const point: [string, Point] = ["reference", reference];
  return placedSum(library.gcv_no_fit_region, Region, { fixed, moving }, point, options);
}

/** The whole of Shi's entrance block: where the point a0 of block A may not go. */
export function entranceRegion(
  a: PolygonLike,
  b: PolygonLike,
  a0: Point = [0, 0],
  options: RegionOptions = {},
): Region {
  return placedSum(library.gcv_entrance_region, Region, { a, b }, ["a0", a0], options);
}

/**
 * The inner-fit region: where the point `reference`, tied to `moving`, may go with `moving` inside
 * the container. Touching is allowed. Takes no tolerance, and leaves out no holes.
 */
export function innerFitRegion(
  container: PolygonLike,
  moving: PolygonLike,
  reference: Point = [0, 0],
  options: RegionOptions = {},
): Region {
  const point: [string, Point] = ["reference", reference];
  return placedSum(library.gcv_inner_fit_region, Region, { container, moving }, point, options);
}

type Many = (a: number, b: number, ...rest: number[]) => number;
type Maybe<T, O> = O extends { returnErrors: true } ? T | GcvError : T;

/** What the call gives for each pair: results, or errors. References are those of no-fit shapes. */
function many<T extends OuterFace | Region>(
  call: Many,
  Result: new (made: Made) => T,
  sources: Record<string, readonly PolygonLike[]>,
  references: Points | null | undefined,
  options: RegionOptions & ManyOptions = {},
): (T | GcvError)[] {
  checkOptions(options, [...optionsOf(Result), "returnErrors"]);
  return withOperands((operands) => {
    const [[firstName, first], [secondName, second]] = Object.entries(sources).map(([name, list]) => [
      name,
      elementsOf(list, name).map((source, k) =>
        caught(() => operands.polygon(source, `${name}[${k}]`)),
      ),
    ]) as [[string, (number | GcvError)[]], [string, (number | GcvError)[]]];
    const places =
      references == null ? null : coordinatesOf(references, "references", "an array of points");
    checkCounts(firstName, first.length, secondName, second.length);
    if (places) {
      checkCounts(firstName, first.length, "references", places.length / 2);
    }
    const results: (T | GcvError | undefined)[] = first.map((one, k) =>
      [one, second[k]].find((polygon) => polygon instanceof GcvError),
    );
    throwFirst(results, options);
    const tried = [...results.keys()].filter((k) => results[k] === undefined);
    withScratch((scratch) => {
      const pointers = (polygons: (number | GcvError)[]) =>
        scratch.words(tried.map((k) => polygons[k] as number));
      const [a, b, count] = [pointers(first), pointers(second), tried.length];
      const points = tried.flatMap((k) => [places?.[2 * k] ?? 0, places?.[2 * k + 1] ?? 0]);
      const given = "fixed" in sources ? [scratch.doubles(points)] : [];
      const [out, statuses] = [scratch.room(4 * count), scratch.room(4 * count)];
      run(scratch, options, (known) => call(a, b, ...given, count, known, out, statuses));
      let message = lastMessage();
      const found = structsAt(out, 4, count, (at) => view().getUint32(at, true));
      structsAt(statuses, 4, count, (at) => view().getInt32(at, true)).forEach((status, n) => {
        const k = tried[n];
        if (status === 0) {
          results[k] = new Result(new Made(found[n]));
          return;
        }
        const reason = message.replace(`pair ${n}:`, `pair ${k}:`);
        results[k] = failure(status as Status, reason || `pair ${k} alone says why it fails`);
        message = "";
      });
    });
    throwFirst(results, options);
    return results as (T | GcvError)[];
  });
}

function throwFirst(
  results: (OuterFace | Region | GcvError | undefined)[],
  options: ManyOptions,
): void {
  const failure = results.find((result) => result instanceof GcvError);
  if (failure !== undefined && options.returnErrors !== true) {
    results.forEach((result) => result instanceof GcvError || result?.free());
    throw failure;
  }
}

/** Many sums: the k-th outer face is that of a[k] + b[k]. Throws the first error. */
export function minkowskiSumMany<O extends SumOptions & ManyOptions>(
  a: readonly PolygonLike[],
  b: readonly PolygonLike[],
  options?: O,
): Maybe<OuterFace, O>[] {
  const call = library.gcv_minkowski_sum_many;
  return many(call, OuterFace, { a, b }, null, options) as Maybe<OuterFace, O>[];
}

/** Many no-fit polygons; all references are the origin by default. Throws the first error. */
export function noFitPolygonMany<O extends SumOptions & ManyOptions>(
  fixed: readonly PolygonLike[],
  moving: readonly PolygonLike[],
  references?: Points,
  options?: O,
): Maybe<OuterFace, O>[] {
  const call = library.gcv_no_fit_polygon_many;
  const polygons = { fixed, moving };
  return many(call, OuterFace, polygons, references, options) as Maybe<OuterFace, O>[];
}

/** Many whole sums: the k-th region is that of a[k] + b[k]. Throws the first error. */
export function minkowskiSumRegionMany<O extends RegionOptions & ManyOptions>(
  a: readonly PolygonLike[],
  b: readonly PolygonLike[],
  options?: O,
): Maybe<Region, O>[] {
  const call = library.gcv_minkowski_sum_region_many;
  return many(call, Region, { a, b }, null, options) as Maybe<Region, O>[];
}

/** Many no-fit regions; all references are the origin by default. Throws the first error. */
export function noFitRegionMany<O extends RegionOptions & ManyOptions>(
  fixed: readonly PolygonLike[],
  moving: readonly PolygonLike[],
  references?: Points,
  options?: O,
): Maybe<Region, O>[] {
  const call = library.gcv_no_fit_region_many;
  return many(call, Region, { fixed, moving }, references, options) as Maybe<Region, O>[];
}

const supersetEdgeSize = 48;

/** The superset of the outer face of A + B, for plots and for tests. Sums do not need it. */
export function superset(a: PolygonLike, b: PolygonLike): SupersetEdge[] {
  return withPolygons({ a, b }, (first, second) => {
    const pointer = pointerOf((out) => library.gcv_superset_create(first!, second!, out));
    try {
      return structsOf(
        (...buffer) => library.gcv_superset_edges(pointer, ...buffer),
        supersetEdgeSize,
        (at) => {
          const [x0, y0, x1, y1] = [0, 8, 16, 24].map((k) => view().getFloat64(at + k, true));
          return { start: [x0!, y0!], end: [x1!, y1!], source: edgeSourceAt(at + 32) } as const;
        },
      );
    } finally {
      library.gcv_superset_destroy(pointer);
    }
  });
}

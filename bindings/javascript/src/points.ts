// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points and numbers as they are passed.

import { errorOf, hasLostBuffer, InputError, Status, unfit } from "./errors.js";

/** A typed array of numbers. */
export type NumberArray =
  | Float64Array
  | Float32Array
  | Int8Array
  | Uint8Array
  | Uint8ClampedArray
  | Int16Array
  | Uint16Array
  | Int32Array
  | Uint32Array;

/** The x and the y of a point, or of a vector. */
export type Point = readonly [x: number, y: number];

/** Many points: x0, y0, x1, y1, ... in a typed array, or an array of pairs. */
export type Points = NumberArray | readonly (readonly number[])[];

/** The number that the argument of that name should be. @internal */
export function numberOf(value: number, name: string): number {
  if (typeof value !== "number") {
    throw unfit(name, value, "a number");
  }
  return value;
}

/** Numbers that the argument of that name should have, so many of them. @internal */
export function numbersOf(value: ArrayLike<number>, count: number, name: string): number[] {
  const numbers = isList(value) ? Array.from(value) : [];
  if (numbers.length !== count || !numbers.every((x) => typeof x === "number")) {
    throw unfit(name, value, count === 2 ? "a pair of numbers" : `${count} numbers`);
  }
  return numbers;
}

/** The same, if all of them are finite. @internal */
export function finiteNumbersOf(value: ArrayLike<number>, count: number, name: string): number[] {
  const numbers = numbersOf(value, count, name);
  const k = numbers.findIndex((x) => !Number.isFinite(x));
  if (k >= 0) {
    const reason = `number ${k} is ${numbers[k]}, not finite`;
    throw new InputError(Status.NOT_FINITE, `${name}: ${reason}`);
  }
  return numbers;
}

/**
 * The elements of the array of polygons that the argument of that name should be, with undefined for
 * those that are missing. @internal
 */
export function elementsOf<T>(value: readonly T[], name: string): T[] {
  if (!Array.isArray(value)) {
    throw unfit(name, value, "an array of polygons");
  }
  return Array.from<T>(value);
}

/** Whether the value is one point and not many. @internal */
export function isPoint(value: Point | Points): value is Point {
  return Array.isArray(value) && value.length === 2 && !value.some(isList);
}

/** The coordinates x0, y0, x1, y1, ... of points. @internal */
export function coordinatesOf(
  points: Points,
  name: string,
  what: string,
  nameOf = (index: number) => `${name}[${index}]`,
): ArrayLike<number> {
  if (isNumberArray(points)) {
    if (points.length % 2 !== 0) {
      const reason = `an array of ${points.length} numbers does not hold pairs`;
      throw errorOf(Status.INVALID_ARGUMENT, `${name}: ${reason}`);
    }
    return points;
  }
  if (!Array.isArray(points)) {
    throw unfit(name, points, what);
  }
  const coordinates = new Float64Array(2 * points.length);
  // Not by forEach, which skips elements that are missing.
  for (let k = 0; k < points.length; ++k) {
    coordinates.set(numbersOf(points[k], 2, nameOf(k)), 2 * k);
  }
  return coordinates;
}

function isNumberArray(value: unknown): value is NumberArray {
  return (
    ArrayBuffer.isView(value) &&
    !(value instanceof DataView) &&
    !(value instanceof BigInt64Array) &&
    !(value instanceof BigUint64Array) &&
    value.constructor.name !== "Buffer" && // bytes of a text or a file, in Node
    !hasLostBuffer(value)
  );
}

/** Whether the value is an array, or a typed array of numbers. @internal */
export function isList(value: unknown): value is ArrayLike<unknown> {
  return Array.isArray(value) || isNumberArray(value);
}

/** As many of one as of the other. @internal */
export function checkCounts(a: string, countOfA: number, b: string, countOfB: number): void {
  if (countOfA !== countOfB) {
    const reason = `${a} has ${countOfA} elements and ${b} has ${countOfB}`;
    throw errorOf(Status.INVALID_ARGUMENT, reason);
  }
}

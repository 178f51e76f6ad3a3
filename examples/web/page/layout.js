// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where A and B lie in the first view, so that there is room for the result.

import { boundsOf, shapeOf } from "./shapes.js";

/**
 * @typedef {import("./shapes.js").Point} Point
 * @typedef {import("./shapes.js").Box} Box
 * @typedef {import("./shapes.js").Shape} Shape
 */

/** The positions of A and B. For sums they are on both sides of the origin, and the sum in the middle;
 * else A is at the origin and B beside the region.
 * @param {Shape} a @param {Shape} b @param {boolean} isNoFit @param {0 | 1} axis along which they lie
 * @returns {[a: Point, b: Point]} */
export function laidOut(a, b, isNoFit, axis) {
  const [boxA, boxB] = [boundsOf({ ...a, at: [0, 0] }), boundsOf({ ...b, at: [0, 0] })];
  const size = (/** @type {Box} */ box) => box[2 + axis] - box[axis];
  const [sizeA, sizeB] = [size(boxA), size(boxB)];
  const gap = 0.08 * (sizeA + sizeB);
  // Positions are multiples of a power of two, so that sums of them are exact.
  const unit = 2 ** Math.floor(Math.log2(gap));
  const grid = (/** @type {number} */ value) => Math.round(value / unit) * unit;
  /** @param {Box} box @param {number} along @returns {Point} */
  const placed = (box, along) => {
    /** @type {Point} */
    const at = [-grid((box[0] + box[2]) / 2), -grid((box[1] + box[3]) / 2)];
    at[axis] += grid(along);
    return at;
  };
  const sign = axis === 0 ? 1 : -1;
  if (isNoFit) {
    return [placed(boxA, 0), placed(boxB, sign * (sizeA / 2 + 1.5 * sizeB + gap))];
  }
  const far = sizeA / 2 + sizeB / 2 + Math.max(sizeA, sizeB) / 2 + gap;
  return [placed(boxA, -sign * far), placed(boxB, sign * far)];
}

/** A box round A, B and the result. @param {Shape} a @param {Shape} b @param {boolean} isNoFit */
export function boxOf(a, b, isNoFit) {
  const boxA = boundsOf(a);
  const boxB = boundsOf(isNoFit ? { ...b, at: [0, 0] } : b);
  const [dx, dy] = b.rings[0];
  const result = isNoFit
    ? [boxA[0] - boxB[2] + dx, boxA[1] - boxB[3] + dy, boxA[2] - boxB[0] + dx, boxA[3] - boxB[1] + dy]
    : boxA.map((value, k) => value + boxB[k]);
  return boundsOf(a, b, shapeOf("", [result]));
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The edges of a region, each known by the vertex that begins it, and what they are made of.

import { cornerOf, nearestOfSegment, neighbour, placeOf } from "./shapes.js";

/**
 * @typedef {import("./shapes.js").Point} Point
 * @typedef {import("./shapes.js").Shape} Shape
 * @typedef {import("./compute/packed.js").Packed} Packed
 *
 * The kind is 1 for an edge of A, 2 for one of B, 3 for both, and 0 for a point.
 * @typedef {{ kind: number, a: number, b: number, words: string }} Source
 */

/** The ends of an edge of a region that lies at a position.
 * @param {Packed} region @param {Point} at @param {number} edge @returns {[start: Point, end: Point]} */
export function endsOf({ vertices, parts }, [dx, dy], edge) {
  const part = parts.find(({ start, stop }) => start <= edge && edge < stop);
  const next = part === undefined || edge + 1 < part.stop ? edge + 1 : part.start;
  const place = (/** @type {number} */ k) =>
    /** @type {Point} */ ([vertices[2 * k] + dx, vertices[2 * k + 1] + dy]);
  return [place(edge), place(next)];
}

/** The nearest edge to a point; null where none is within reach.
 * @param {Packed} region @param {Point} at @param {Point} point @param {number} reach */
export function edgeNear(region, at, point, reach) {
  let nearest = /** @type {number | null} */ (null);
  for (const { start, stop } of region.parts) {
    for (let edge = start; edge < stop; ++edge) {
      const { distance } = nearestOfSegment(point, ...endsOf(region, at, edge));
      if (distance < reach) {
        [nearest, reach] = [edge, distance];
      }
    }
  }
  return nearest;
}

/** What an edge is made of. @param {Packed} region @param {number} edge @returns {Source} */
export function sourceOf({ sources }, edge) {
  const [kind, a, b] = sources.subarray(3 * edge, 3 * edge + 3);
  const words = [
    "a point, no edge",
    `edge ${a} of A at vertex ${b} of B`,
    `edge ${b} of B at vertex ${a} of A`,
    `edge ${a} of A and edge ${b} of B, merged`,
  ];
  return { kind, a, b, words: words[kind] };
}

/** Marks an edge, and what it is made of in A and B. @param {import("./pen.js").Pen} pen
 * @param {[start: Point, end: Point]} ends @param {Source} source @param {Shape[]} shapes */
export function drawSource(pen, [start, end], { kind, a, b }, shapes) {
  pen.line(start, end, "mark", 4);
  pen.dot(start, "mark", 4);
  if (kind === 0) {
    return;
  }
  shapes.forEach((shape, k) => {
    const corner = cornerOf(shape, [a, b][k]);
    if (kind === 3 || kind === k + 1) {
      pen.line(placeOf(shape, corner), placeOf(shape, neighbour(shape, corner)), "mark", 4);
    } else {
      pen.dot(placeOf(shape, corner), "mark", 6);
    }
  });
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the page shows of a region, as plain data.

/**
 * The sources of edges have three numbers for each vertex, of the edge from it to the next of its
 * part: the kind, and the numbers of A and B.
 * @typedef {{
 *   vertices: Float64Array,
 *   parts: { kind: number, start: number, stop: number }[],
 *   sources: Int32Array,
 *   area: number,
 *   errorBound: number,
 * }} Packed
 */

/** @param {import("../../../../bindings/javascript/dist/index.js").Region} region @returns {Packed} */
export function packed(region) {
  const { vertices, exactIndices, sources } = region;
  const numbers = new Int32Array(3 * exactIndices.length);
  exactIndices.forEach((exact, k) => {
    const { kind, a, b } = sources[exact];
    numbers.set([kind, a, b], 3 * k);
  });
  return {
    vertices: vertices.slice(),
    parts: region.parts.map(({ kind, start, stop }) => ({ kind, start, stop })),
    sources: numbers,
    area: region.area,
    errorBound: region.errorBound,
  };
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Texts that polygons are made from.

import { Polygon } from "../../../../bindings/javascript/dist/index.js";

/** Coordinates beyond this are refused: the page moves and measures shapes in doubles. */
const largest = 1e100;

/** The rings of each text's polygon, turned by its matrix if it has one.
 * @param {import("../reading.js").Source[]} sources @returns {Float64Array[][]} */
export function read(sources) {
  return sources.map(({ text, matrix }) => {
    const made = [new Polygon(text)];
    if (matrix !== null) {
      made.push(made[0].affine(matrix));
    }
    const rings = made[made.length - 1].rings.map((ring) => ring.slice());
    made.forEach((polygon) => polygon.free());
    if (rings[0].some((coordinate) => Math.abs(coordinate) > largest)) {
      throw new Error(`A polygon has a coordinate beyond ${largest}, which is more than this page can show.`);
    }
    return rings;
  });
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons of the library for the shapes of the page. They are kept, with what they have prepared.

import { GcvError, Polygon } from "../../../../bindings/javascript/dist/index.js";

/** @typedef {import("../shapes.js").Shape} Shape */

/** The polygons by the keys of their shapes, the one used last at the end. */
const kept = /** @type {Map<string, Polygon>} */ (new Map());
const most = 200;

/** The polygon of a shape, where the shape has no position yet.
 * @param {Shape} shape */
export function polygonOf({ key, name, rings: [outer, ...holes] }) {
  let polygon = kept.get(key);
  kept.delete(key);
  try {
    polygon ??= new Polygon(outer, holes);
  } catch (error) {
    if (error instanceof GcvError) {
      throw new Error(error.message.replace(/^polygon:/, `${name}:`));
    }
    throw error;
  }
  kept.set(key, polygon);
  return polygon;
}

/** Ends the polygons that have not been used for long. */
export function trim() {
  for (const [key, polygon] of kept) {
    if (kept.size <= most) {
      return;
    }
    kept.delete(key);
    polygon.free();
  }
}

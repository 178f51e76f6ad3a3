// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons at positions, and the places on them that a pointer can take.

/**
 * @typedef {[x: number, y: number]} Point
 * @typedef {[xmin: number, ymin: number, xmax: number, ymax: number]} Box
 *
 * A vertex: the index of its ring, and its index in that ring.
 * @typedef {{ ring: number, index: number }} Corner
 *
 * Rings, each x0, y0, x1, y1, ..., the outer one first, moved by `at`. The key is another one
 * whenever the rings are.
 * @typedef {{ name: string, rings: Float64Array[], at: Point, key: string }} Shape
 */

let keys = 0;

/** @param {string} name @param {ArrayLike<number>[]} rings @param {Point} at @returns {Shape} */
export function shapeOf(name, rings, at = [0, 0]) {
  return { name, rings: rings.map((ring) => Float64Array.from(ring)), at, key: `${++keys}` };
}

/** @param {Shape} shape @param {ArrayLike<number>[]} rings */
export function setRings(shape, rings) {
  shape.rings = rings.map((ring) => Float64Array.from(ring));
  shape.key = `${++keys}`;
}

/** @param {Shape} shape */
export function countOf({ rings }) {
  return rings.reduce((count, ring) => count + ring.length / 2, 0);
}

/** Where a vertex lies. @param {Shape} shape @param {Corner} corner @returns {Point} */
export function placeOf({ rings, at }, { ring, index }) {
  return [rings[ring][2 * index] + at[0], rings[ring][2 * index + 1] + at[1]];
}

/** The vertex with a number, as the library counts: through all rings.
 * @param {Shape} shape @param {number} number @returns {Corner} */
export function cornerOf({ rings }, number) {
  let ring = 0;
  for (; ring < rings.length - 1 && number >= rings[ring].length / 2; ++ring) {
    number -= rings[ring].length / 2;
  }
  return { ring, index: number };
}

/** The next vertex of its ring, or the one before it.
 * @param {Shape} shape @param {Corner} corner @param {number} step @returns {Corner} */
export function neighbour({ rings }, { ring, index }, step = 1) {
  const count = rings[ring].length / 2;
  return { ring, index: (index + step + count) % count };
}

/** The smallest box round shapes. @param {readonly Shape[]} shapes @returns {Box} */
export function boundsOf(...shapes) {
  /** @type {Box} */
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { rings, at } of shapes) {
    for (let k = 0; k < rings[0].length; ++k) {
      const value = rings[0][k] + at[k % 2];
      box[k % 2] = Math.min(box[k % 2], value);
      box[2 + (k % 2)] = Math.max(box[2 + (k % 2)], value);
    }
  }
  return box;
}

/** @param {Box} box @returns {Point} */
export function centreOf([xmin, ymin, xmax, ymax]) {
  return [(xmin + xmax) / 2, (ymin + ymax) / 2];
}

/** Whether a point is inside. For a pointer: doubles are exact enough.
 * @param {Shape} shape @param {Point} point */
export function contains({ rings, at }, [px, py]) {
  let inside = false;
  const [x, y] = [px - at[0], py - at[1]];
  for (const ring of rings) {
    let [x0, y0] = ring.slice(-2);
    for (let k = 0; k < ring.length; k += 2) {
      const [x1, y1] = [ring[k], ring[k + 1]];
      if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) {
        inside = !inside;
      }
      [x0, y0] = [x1, y1];
    }
  }
  return inside;
}

/** The nearest point of a segment, and how far it is.
 * @param {Point} point @param {Point} start @param {Point} end
 * @returns {{ point: Point, distance: number }} */
export function nearestOfSegment([x, y], [x0, y0], [x1, y1]) {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const length = dx * dx + dy * dy;
  const part = length === 0 ? 0 : Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / length));
  /** @type {Point} */
  const point = [x0 + part * dx, y0 + part * dy];
  return { point, distance: Math.hypot(x - point[0], y - point[1]) };
}

/** @param {Shape} shape @returns {Generator<Corner>} */
export function* cornersOf({ rings }) {
  for (let ring = 0; ring < rings.length; ++ring) {
    for (let index = 0; index < rings[ring].length / 2; ++index) {
      yield { ring, index };
    }
  }
}

/** @param {Shape} shape @param {Point} point */
export function nearestCorner(shape, point) {
  let best = { corner: { ring: 0, index: 0 }, distance: Infinity };
  for (const corner of cornersOf(shape)) {
    const [x, y] = placeOf(shape, corner);
    const distance = Math.hypot(x - point[0], y - point[1]);
    if (distance < best.distance) {
      best = { corner, distance };
    }
  }
  return best;
}

/** The nearest edge, by its first vertex. @param {Shape} shape @param {Point} point */
export function nearestEdge(shape, point) {
  let best = { corner: { ring: 0, index: 0 }, point, distance: Infinity };
  for (const corner of cornersOf(shape)) {
    const ends = [placeOf(shape, corner), placeOf(shape, neighbour(shape, corner))];
    const found = nearestOfSegment(point, ends[0], ends[1]);
    if (found.distance < best.distance) {
      best = { corner, ...found };
    }
  }
  return best;
}

/** @param {Shape} shape @param {Corner} corner @param {Point} place */
export function moveCorner(shape, { ring, index }, [x, y]) {
  const rings = [...shape.rings];
  rings[ring] = rings[ring].slice();
  rings[ring].set([x - shape.at[0], y - shape.at[1]], 2 * index);
  setRings(shape, rings);
}

/** Adds a vertex after another one, and gives it.
 * @param {Shape} shape @param {Corner} corner @param {Point} place @returns {Corner} */
export function insertCorner(shape, { ring, index }, [x, y]) {
  const rings = shape.rings.map((values) => Array.from(values));
  rings[ring].splice(2 * index + 2, 0, x - shape.at[0], y - shape.at[1]);
  setRings(shape, rings);
  return { ring, index: index + 1 };
}

/** Takes a vertex out; of a hole with three vertices, the hole. Says whether it did.
 * @param {Shape} shape @param {Corner} corner */
export function removeCorner(shape, { ring, index }) {
  const rings = shape.rings.map((values) => Array.from(values));
  if (rings[ring].length <= 6) {
    if (ring === 0) {
      return false;
    }
    rings.splice(ring, 1);
  } else {
    rings[ring].splice(2 * index, 2);
  }
  setRings(shape, rings);
  return true;
}

/** Turns a shape by a quarter about the middle of its box, which stays exact but for the middle.
 * @param {Shape} shape @param {(value: number) => number} snap */
export function turn(shape, snap) {
  const before = centreOf(boundsOf(shape));
  setRings(
    shape,
    shape.rings.map((ring) => ring.map((_, k) => (k % 2 === 0 ? -ring[k + 1] : ring[k - 1]))),
  );
  const after = centreOf(boundsOf(shape));
  shape.at = [snap(shape.at[0] + before[0] - after[0]), snap(shape.at[1] + before[1] - after[1])];
}

/** A point well inside of a shape, as far as a few tries find one: for its name.
 * @param {Shape} shape @returns {Point} */
export function middleOf(shape) {
  const [xmin, ymin, xmax, ymax] = boundsOf(shape);
  let best = { point: centreOf([xmin, ymin, xmax, ymax]), depth: -Infinity };
  for (const u of [4, 2, 6, 1, 7]) {
    for (const v of [4, 2, 6, 1, 7]) {
      /** @type {Point} */
      const point = [xmin + (u / 8) * (xmax - xmin), ymin + (v / 8) * (ymax - ymin)];
      const depth = nearestEdge(shape, point).distance * (contains(shape, point) ? 1 : -1);
      best = depth > 1.01 * best.depth ? { point, depth } : best;
    }
  }
  return best.point;
}

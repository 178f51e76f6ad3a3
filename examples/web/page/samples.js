// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons to begin with.

/** @typedef {number[][]} Rings each x0, y0, x1, y1, ... */

/** @param {number} width @param {number} height @returns {Rings} */
export const brick = (width, height) => [[0, 0, width, 0, width, height, 0, height]];

/** A plate with a slot, a chamber behind a narrow mouth, a window, and a square hole. @type {Rings} */
const plate = [
  [0, 0, 14, 0, 14, 10, 11, 10, 11, 7, 9, 7, 9, 10, 3, 10, 3, 8, 5, 8, 5, 4, 1, 4, 1, 8, 2, 8, 2, 10, 0, 10],
  [9, 1, 13, 1, 13, 5, 9, 5],
  [6, 1, 8, 1, 8, 3, 6, 3],
];

/** @type {Rings} */
const hook = [[0, 0, 7, 0, 7, 5, 4, 5, 4, 3, 5, 3, 5, 2, 2, 2, 2, 7, 0, 7]];
/** @type {Rings} */
const wedge = [[0, 0, 4, 1, 5, 4, 2, 3]];

/** A ring of vertices round the origin, on a grid of 1/64, at the radius of each angle.
 * @param {number} count @param {(angle: number, k: number) => number} radius @returns {Rings} */
function round(count, radius) {
  const grid = (/** @type {number} */ value) => Math.round(64 * value) / 64;
  return [
    Array.from({ length: count }, (_, k) => {
      const angle = (2 * Math.PI * k) / count;
      return [grid(radius(angle, k) * Math.cos(angle)), grid(radius(angle, k) * Math.sin(angle))];
    }).flat(),
  ];
}

/** @param {number} size @param {number} depth @param {number} lobes */
const wave = (size, depth, lobes) => round(200, (angle) => size * (1 + depth * Math.sin(lobes * angle)));

/** @param {number} size @param {number} depth */
const star = (size, depth) =>
  round(200, (_, k) => size * (k % 2 === 0 ? 1 : 1 - depth * (0.5 + 0.5 * Math.sin(12.9898 * k * k))));

/** Pairs for the first view. @type {Record<string, { a: Rings, b: Rings }>} */
export const pairs = {
  plate: { a: plate, b: brick(2, 2) },
  hook: { a: hook, b: wedge },
  waves: { a: wave(5, 0.3, 7), b: wave(3, 0.4, 5) },
  stars: { a: star(6, 0.2), b: star(4, 0.3) },
};

/** Pairs of files for the first view: of examples/polygons. @type {Record<string, [a: string, b: string]>} */
export const files = {
  room: ["room", "robot"],
  forks: ["fork_large", "fork_small"],
  lock: ["lock", "key"],
};

/** A sheet with a notch and a flaw. @type {Rings} */
export const sheet = [
  [0, 0, 24, 0, 24, 10, 20, 10, 20, 14, 0, 14],
  [9, 9, 12, 8, 13, 10, 11, 11],
];

/** The parts that there are for a sheet. @type {Record<string, Rings>} */
export const parts = {
  peg: brick(2, 2),
  brick: brick(4, 2),
  corner: [[0, 0, 5, 0, 5, 2, 2, 2, 2, 5, 0, 5]],
  tee: [[0, 0, 2, 0, 2, 2, 4, 2, 4, 4, -2, 4, -2, 2, 0, 2]],
  triangle: [[0, 0, 5, 0, 2, 4]],
  clamp: [[0, 0, 6, 0, 6, 4, 4, 4, 4, 2, 2, 2, 2, 4, 0, 4]],
};

/** What lies on the sheet at first. @type {[name: string, x: number, y: number][]} */
export const laid = [
  ["peg", 15, 4],
  ["brick", 0, 0],
  ["brick", 6, 0],
  ["corner", 0, 4],
  ["clamp", 12, 0],
  ["triangle", 18, 4],
  ["tee", 4, 9],
];

/** The blocks of the third view. @type {{ a: Rings, b: Rings }} */
export const blocks = {
  a: [[0, 0, 10, 0, 10, 6, 8, 6, 8, 2, 5, 2, 5, 5, 2, 6, 2, 8, 0, 8]],
  b: [[0, 0, 3, 0, 3, 3, 2, 4, 2, 6, -1, 6, -1, 4]],
};

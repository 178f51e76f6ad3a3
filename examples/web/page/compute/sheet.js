// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The second view: a sheet, the parts on it, and where one of them is free.

import { Scene } from "../../../../bindings/javascript/dist/index.js";
import { packed } from "./packed.js";
import { polygonOf } from "./polygons.js";

/**
 * @typedef {import("../shapes.js").Shape} Shape
 * @typedef {import("../shapes.js").Point} Point
 *
 * The parts are those that lie on the sheet, without the moving one.
 * @typedef {{ sheet: Shape, parts: Shape[], moving: Shape | null }} Question
 *
 * The key is that of the moving part.
 * @typedef {{
 *   key: string,
 *   region: import("./packed.js").Packed,
 *   relation: number,
 *   escape: import("../../../../bindings/javascript/dist/index.js").Escape,
 * }} Answer
 */

let known = { key: "", scene: new Scene() };
let free = { key: "", region: /** @type {import("./packed.js").Packed | null} */ (null) };

/** The scene of the question, which stays while only the moving part moves.
 * @param {Question} question */
function sceneOf({ sheet, parts }) {
  const key = [sheet.key, ...parts.flatMap((part) => [part.key, ...part.at])].join();
  if (known.key !== key) {
    const scene = new Scene(polygonOf(sheet));
    scene.addMany(
      parts.map(polygonOf),
      parts.map(({ at }) => at),
    );
    known.scene.free();
    known = { key, scene };
  }
  return known.scene;
}

/** @param {Question} question @returns {Answer | null} */
export function sheet(question) {
  const scene = sceneOf(question);
  if (question.moving === null) {
    return null;
  }
  const { key, at } = question.moving;
  const part = polygonOf(question.moving);
  if (free.region === null || free.key !== `${key} ${known.key}`) {
    const region = scene.freeRegion(part);
    free = { key: `${key} ${known.key}`, region: packed(region) };
    region.free();
  }
  return {
    key,
    region: /** @type {import("./packed.js").Packed} */ (free.region),
    relation: scene.relation(part, at),
    escape: scene.penetration(part, at),
  };
}

/** The leftmost free position, and of these the lowest; null where there is none.
 * @param {Question & { moving: Shape }} question */
export function best(question) {
  return sceneOf(question).best(polygonOf(question.moving), [-1, 0]);
}

/** Where the part comes to when it moves until it hits something.
 * @param {Question & { moving: Shape, motion: Point }} question */
export function slide(question) {
  const part = polygonOf(question.moving);
  return sceneOf(question).cast(part, question.moving.at, question.motion).position;
}

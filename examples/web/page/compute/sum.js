// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The first view: the sum of A and B, or the no-fit region of B round A.

import * as gcv from "../../../../bindings/javascript/dist/index.js";
import { packed } from "./packed.js";
import { polygonOf } from "./polygons.js";

/**
 * @typedef {import("../shapes.js").Shape} Shape
 *
 * With isWhole the region has its holes and exact fits, else its outer ring alone.
 * @typedef {{ a: Shape, b: Shape, isNoFit: boolean, isWhole: boolean, hasSuperset: boolean }} Question
 *
 * The superset has four coordinates for each edge.
 * @typedef {{
 *   region: import("./packed.js").Packed,
 *   superset: Float64Array,
 *   isWhole: boolean,
 *   relation: gcv.Relation,
 *   key: string,
 * }} Answer
 */

let known = /** @type {Omit<Answer, "relation">} */ ({ key: "" });

/** @param {Question} question @returns {Answer} */
export function sum(question) {
  const { a, b, isNoFit } = question;
  const [first, second] = [polygonOf(a), polygonOf(b)];
  const key = [a.key, b.key, isNoFit, question.isWhole, question.hasSuperset].join();
  if (known.key !== key) {
    const region = regionOf(first, second, question);
    known = {
      region: packed(region),
      isWhole: question.isWhole,
      superset: question.hasSuperset ? supersetOf(first, second, isNoFit) : new Float64Array(0),
      key,
    };
    region.free();
  }
  const relation = gcv.relation(first, second, [b.at[0] - a.at[0], b.at[1] - a.at[1]]);
  return { ...known, relation };
}

/** @param {gcv.Polygon} a @param {gcv.Polygon} b @param {Question} question */
function regionOf(a, b, { isNoFit, isWhole }) {
  /** @type {gcv.RegionOptions} */
  const options = { leaveOut: isWhole ? [] : ["holes", "fits"] };
  return isNoFit ? gcv.noFitRegion(a, b, [0, 0], options) : gcv.minkowskiSumRegion(a, b, options);
}

/** @param {gcv.Polygon} a @param {gcv.Polygon} b @param {boolean} isNoFit */
function supersetOf(a, b, isNoFit) {
  const second = isNoFit ? b.negated() : b;
  const edges = gcv.superset(a, second);
  if (isNoFit) {
    second.free();
  }
  return Float64Array.from(edges.flatMap(({ start, end }) => [...start, ...end]));
}

/** The region as text, for A and B where they lie. @param {Question} question */
export function text({ a, b, isNoFit }) {
  const [first, second] = [polygonOf(a).translated(a.at), polygonOf(b).translated(b.at)];
  const region = isNoFit
    ? gcv.noFitRegion(first, second, b.at)
    : gcv.minkowskiSumRegion(first, second);
  const written = `${region.toWKT()}\n${region.fitsToWKT()}\n`;
  [first, second, region].forEach((made) => made.free());
  return written;
}

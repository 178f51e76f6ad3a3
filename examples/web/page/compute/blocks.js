// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The third view: how two blocks lie.

import * as gcv from "../../../../bindings/javascript/dist/index.js";
import { polygonOf } from "./polygons.js";

/**
 * @typedef {import("../shapes.js").Shape} Shape
 *
 * With isOutside the way out of an overlap leads outside, past holes and exact fits.
 * @typedef {{ a: Shape, b: Shape, limit: number, isOutside: boolean }} Question
 *
 * @typedef {{
 *   separation: gcv.Separation,
 *   escape: gcv.Escape,
 *   contacts: gcv.Contact[],
 * }} Answer
 */

/** Of blocks without positions; what is answered is moved by that of A.
 * @param {Question} question @returns {Answer} */
export function blocks({ a, b, limit, isOutside }) {
  const [first, second] = [polygonOf(a), polygonOf(b)];
  /** @type {[number, number]} */
  const way = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
  const list = gcv.contacts(first, second, way, limit);
  const contacts = list.records;
  list.free();
  return {
    separation: gcv.distance(first, second, way),
    escape: gcv.penetration(first, second, way, { leaveOut: isOutside ? ["holes", "fits"] : [] }),
    contacts,
  };
}

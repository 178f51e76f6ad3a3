// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the views have in common: questions to the worker, and what the panel tells.

import { Editing } from "./editing.js";
import { boundsOf, centreOf, nearestEdge, setRings } from "./shapes.js";

/**
 * @typedef {import("./shapes.js").Point} Point
 * @typedef {import("./shapes.js").Shape} Shape
 *
 * What the page gives to its views.
 * @typedef {{
 *   stage: import("./stage.js").Stage,
 *   answers: import("./answers.js").Answers,
 *   isShown: (view: View) => boolean,
 *   report: (problem: string) => void,
 *   shapesChanged: () => void,
 *   answered: (milliseconds: number) => void,
 *   say: (words: string) => void,
 *   facts: (facts: [name: string, value: string][]) => void,
 * }} Page
 */

export class View extends Editing {
  /** What of the plane is shown; null where that is to be found. @type {import("./stage.js").Camera | null} */
  camera = null;
  /** The newest answer of the worker. @type {any} */
  answer = null;
  problem = "";

  /** @param {Page} page @param {string} name the name of its question, and of its elements */
  constructor(page, name) {
    super(page);
    this.name = name;
  }

  /** An element of this view's controls. @template {HTMLElement} T @param {string} id
   * @param {new () => T} Type @returns {T} */
  element(id, Type) {
    const found = document.getElementById(`${this.name}-${id}`);
    if (!(found instanceof Type)) {
      throw new Error(`${this.name}-${id} is not there`);
    }
    return found;
  }

  /** Asks the worker anew, and draws. @override */
  changed() {
    this.page.stage.redraw();
    this.page.answers.live(
      this.name,
      () => this.question(),
      ({ answer, milliseconds }) => {
        this.answer = answer;
        this.problem = "";
        this.answered(milliseconds);
        this.page.answered(milliseconds);
        this.shown();
      },
      (error) => {
        this.problem = error.message;
        this.shown();
      },
    );
  }

  shown() {
    if (!this.page.isShown(this)) {
      return;
    }
    this.page.report(this.problem);
    this.page.facts(this.facts());
    this.page.stage.redraw();
  }

  /** What the worker is asked. @returns {unknown} */
  question() {
    return null;
  }

  /** What is done with the answer beyond showing it. @param {number} _milliseconds */
  answered(_milliseconds) {}

  /** What the panel tells. @returns {[name: string, value: string][]} */
  facts() {
    return [];
  }

  /** @param {import("./pen.js").Pen} _pen */
  draw(_pen) {}

  /** What the stage shows at first. */
  box() {
    return boundsOf(...this.shapes);
  }

  /** @override @param {Shape} shape */
  isWrong({ name }) {
    return this.problem.startsWith(`${name}:`);
  }

  /** A key of this view alone; says whether it is one. @param {KeyboardEvent} _event */
  key(_event) {
    return false;
  }

  /** Takes polygons that were dropped or pasted: in the place of the selected shape and of those after it.
   * @param {Float64Array[][]} polygons @param {Point | null} point where they were dropped */
  take(polygons, point) {
    let first = this.selected;
    if (polygons.length > 1) {
      first = 0;
    } else if (point !== null) {
      const distances = this.shapes.map((shape) => nearestEdge(shape, point).distance);
      first = distances.indexOf(Math.min(...distances));
    }
    polygons.slice(0, this.shapes.length).forEach((rings, k) => {
      this.replace(this.shapes[(first + k) % this.shapes.length], rings);
    });
    [this.selected, this.corner] = [first, null];
    this.page.shapesChanged();
    this.changed();
  }

  /** Gives a shape other rings, with the middle where it was. @param {Shape} shape @param {Float64Array[]} rings */
  replace(shape, rings) {
    const [x, y] = centreOf(boundsOf(shape));
    setRings(shape, rings);
    shape.at = [0, 0];
    const [cx, cy] = centreOf(boundsOf(shape));
    const { snap } = this.page.stage;
    shape.at = [snap(x - cx), snap(y - cy)];
  }
}

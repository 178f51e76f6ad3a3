// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The first view: A, B, and their sum, or the no-fit region of B round A.

import { drawSource, edgeNear, endsOf, sourceOf } from "../edges.js";
import { boxOf, laidOut } from "../layout.js";
import { fits, short } from "../objects.js";
import { files, pairs } from "../samples.js";
import { countOf, placeOf, shapeOf } from "../shapes.js";
import { View } from "../view.js";

/**
 * @typedef {import("../shapes.js").Point} Point
 * @typedef {import("../compute/sum.js").Question} Question
 * @typedef {import("../compute/sum.js").Answer} Answer
 */

/** While something is dragged, holes and exact fits are left out when they take longer, in milliseconds. */
const patience = 10;
const lies = { "1": "apart", "0": "touching", "-1": "overlapping" };

export class SumView extends View {
  #isNoFit = false;
  #hasSuperset = false;
  #wholeTime = 0;
  #milliseconds = 0;
  /** The vertex of the region that begins the chosen edge. @type {number | null} */
  #edge = null;

  /** @param {import("../view.js").Page} page */
  constructor(page) {
    super(page, "sum");
    const sample = this.element("sample", HTMLSelectElement);
    sample.addEventListener("change", () => void this.load(sample.value));
    const mode = this.element("no-fit", HTMLInputElement);
    for (const input of [mode, this.element("plain", HTMLInputElement)]) {
      input.addEventListener("change", () => this.#setMode(mode.checked));
    }
    const edges = this.element("superset", HTMLInputElement);
    edges.addEventListener("change", () => {
      this.#hasSuperset = edges.checked;
      this.changed();
    });
    this.element("copy", HTMLButtonElement).addEventListener("click", () => void this.#copy());
    this.#put(pairs["plate"].a, pairs["plate"].b);
  }

  /** @param {boolean} isNoFit */
  #setMode(isNoFit) {
    this.#isNoFit = isNoFit;
    this.#edge = null;
    this.#lay();
    this.page.shapesChanged();
    this.changed();
  }

  /** @param {string} name the name of a sample */
  async load(name) {
    try {
      const { a, b } = name in pairs ? pairs[name] : await this.#read(files[name]);
      this.#put(a, b);
    } catch (error) {
      this.page.report(/** @type {Error} */ (error).message);
      return;
    }
    this.page.shapesChanged();
    this.changed();
  }

  /** @param {string[]} names of files */
  async #read(names) {
    const sources = names.map(async (name) => {
      const response = await fetch(new URL(`../../../polygons/${name}.wkt`, import.meta.url));
      return { text: await response.text(), matrix: null };
    });
    const { answer } = await this.page.answers.ask("read", await Promise.all(sources));
    return { a: answer[0], b: answer[1] };
  }

  /** @param {ArrayLike<number>[]} a @param {ArrayLike<number>[]} b */
  #put(a, b) {
    this.shapes = [shapeOf("A", a), shapeOf("B", b)];
    [this.selected, this.corner, this.#edge, this.#wholeTime] = [0, null, null, 0];
    this.answer = null;
    this.#lay();
  }

  /** Lays A and B so that the result is between them, or B is beside it. */
  #lay() {
    const [a, b] = this.shapes;
    [a.at, b.at] = laidOut(a, b, this.#isNoFit, this.page.stage.width >= this.page.stage.height ? 0 : 1);
    this.camera = null;
  }

  async #copy() {
    try {
      const { answer } = await this.page.answers.ask("text", this.#asked(true));
      await navigator.clipboard.writeText(answer);
      this.page.say("The region is copied as Well-Known Text.");
    } catch (error) {
      this.page.say(`It cannot be copied: ${/** @type {Error} */ (error).message}`);
    }
  }

  /** @param {boolean} isWhole @returns {Question} */
  #asked(isWhole) {
    const [a, b] = this.shapes;
    return { a, b, isNoFit: this.#isNoFit, isWhole, hasSuperset: this.#hasSuperset && isWhole };
  }

  /** @override */
  question() {
    return this.#asked(!this.isDragging || this.#wholeTime < patience);
  }

  /** @override @param {number} milliseconds */
  answered(milliseconds) {
    this.#milliseconds = milliseconds;
    if (this.answer.isWhole) {
      this.#wholeTime = milliseconds;
    }
    if (this.#edge !== null && this.#edge >= this.answer.region.vertices.length / 2) {
      this.#edge = null;
    }
  }

  /** Where the region lies: sums where A + B is, no-fit regions where B's first vertex may not go. */
  get #at() {
    const [a, b] = this.shapes;
    const [dx, dy] = this.#isNoFit ? b.rings[0] : b.at;
    return /** @type {Point} */ ([a.at[0] + dx, a.at[1] + dy]);
  }

  /** @override */
  box() {
    const [a, b] = this.shapes;
    return boxOf(a, b, this.#isNoFit);
  }

  /** @override @param {Point | null} point @param {number} reach */
  hover(point, reach) {
    super.hover(point, reach);
    const before = this.#edge;
    const region = this.#told?.region;
    const isOverResult = point !== null && this.newCorner === null && region !== undefined;
    this.#edge = isOverResult ? edgeNear(region, this.#at, point, reach) : null;
    if (this.#edge !== before) {
      this.page.facts(this.facts());
    }
  }

  /** A touch does not hover, and so chooses an edge. @override @param {Point} point */
  click(point) {
    super.click(point);
    this.hover(point, 16 / this.page.stage.camera.scale);
  }

  /** The answer, if it is about the shapes as they are: there is none where one of them is wrong. */
  get #told() {
    return this.problem === "" ? /** @type {Answer | null} */ (this.answer) : null;
  }

  /** What the chosen edge is made of. */
  get #source() {
    const region = this.#told?.region;
    return this.#edge === null || region === undefined ? null : sourceOf(region, this.#edge);
  }

  /** @override */
  facts() {
    const answer = /** @type {Answer | null} */ (this.answer);
    if (answer === null) {
      return [];
    }
    const { region } = answer;
    const count = (/** @type {number} */ kind) => region.parts.filter((part) => part.kind === kind).length;
    const whole = answer.isWhole ? "" : " (after the drag)";
    /** @type {[string, string][]} */
    const facts = [
      ["Vertices of A, B", this.shapes.map(countOf).join(", ")],
      ["Vertices of the result", String(region.vertices.length / 2)],
      ["Holes", `${count(2)}${whole}`],
      ["Exact fits", `${fits(count(3), count(4))}${whole}`],
      ["Area", short(region.area)],
      ["Error at most", region.errorBound === 0 ? "0, exact" : region.errorBound.toPrecision(2)],
      ["Edge from", this.#source?.words ?? "none chosen"],
      ["Computed in", `${this.#milliseconds.toFixed(1)} ms`],
    ];
    if (this.#isNoFit) {
      facts.unshift(["A and B are", lies[answer.relation]]);
    }
    if (this.#hasSuperset) {
      facts.splice(-1, 0, ["Superset edges", `${answer.superset.length / 4}${whole}`]);
    }
    return facts;
  }

  /** @override @param {KeyboardEvent} event */
  key(event) {
    const region = this.#told?.region;
    if (event.key.toLowerCase() !== "e" || region === undefined) {
      return false;
    }
    const count = region.vertices.length / 2;
    const step = event.shiftKey ? -1 : 1;
    this.#edge = this.#edge === null ? 0 : (this.#edge + step + count) % count;
    this.page.say(`Edge of the result from ${this.#source?.words}`);
    this.shown();
    return true;
  }

  /** @override @param {import("../pen.js").Pen} pen */
  draw(pen) {
    const answer = /** @type {Answer | null} */ (this.answer);
    if (!this.#isNoFit) {
      pen.cross([0, 0], "faint", 5);
    }
    if (answer !== null) {
      pen.edges(answer.superset, this.#at, "faint", 0.75);
      pen.region(answer.region, this.#at, "sum", this.problem === "" ? 0.2 : 0.05);
    }
    this.drawShapes(pen, ["a", "b"]);
    if (answer !== null) {
      pen.fits(answer.region, this.#at);
    }
    this.drawNames(pen, ["a", "b"]);
    if (this.#isNoFit) {
      pen.cross(placeOf(this.shapes[1], { ring: 0, index: 0 }), "b", 7);
    }
    const told = this.#told;
    if (this.#edge !== null && told !== null) {
      const ends = endsOf(told.region, this.#at, this.#edge);
      drawSource(pen, ends, sourceOf(told.region, this.#edge), this.shapes);
    }
  }
}

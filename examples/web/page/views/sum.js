// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The first view: A, B, and their sum, or the no-fit region of B round A.

import { boxOf, laidOut } from "../layout.js";
import { fits, short } from "../objects.js";
import { files, pairs } from "../samples.js";
import { cornerOf, countOf, nearestOfSegment, neighbour, placeOf, shapeOf } from "../shapes.js";
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
  #isWhole = true;
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
    if (name in pairs) {
      this.#put(pairs[name].a, pairs[name].b);
    } else {
      const read = files[name].map(async (file) => {
        const response = await fetch(new URL(`../../../polygons/${file}.wkt`, import.meta.url));
        return { text: await response.text(), matrix: null };
      });
      const { answer } = await this.page.answers.ask("read", await Promise.all(read));
      this.#put(answer[0], answer[1]);
    }
    this.page.shapesChanged();
    this.changed();
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
    return { a, b, isNoFit: this.#isNoFit, isWhole, hasSuperset: this.#hasSuperset };
  }

  /** @override */
  question() {
    this.#isWhole = !this.isDragging || this.#wholeTime < patience;
    return this.#asked(this.#isWhole);
  }

  /** @override @param {number} milliseconds */
  answered(milliseconds) {
    this.#milliseconds = milliseconds;
    if (this.#isWhole) {
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

  /** The ends of the edge of the region that begins at a vertex.
   * @param {number} vertex @returns {[start: Point, end: Point]} */
  #endsOf(vertex) {
    const { vertices, parts } = /** @type {Answer} */ (this.answer).region;
    const part = parts.find(({ start, stop }) => start <= vertex && vertex < stop);
    const next = part === undefined || vertex + 1 < part.stop ? vertex + 1 : part.start;
    const [dx, dy] = this.#at;
    const place = (/** @type {number} */ k) =>
      /** @type {Point} */ ([vertices[2 * k] + dx, vertices[2 * k + 1] + dy]);
    return [place(vertex), place(next)];
  }

  /** @override @param {Point | null} point @param {number} reach */
  hover(point, reach) {
    super.hover(point, reach);
    let best = reach;
    const before = this.#edge;
    this.#edge = null;
    const count = (this.answer?.region.vertices.length ?? 0) / 2;
    for (let k = 0; point !== null && this.newCorner === null && k < count; ++k) {
      const { distance } = nearestOfSegment(point, ...this.#endsOf(k));
      if (distance < best) {
        best = distance;
        this.#edge = k;
      }
    }
    if (this.#edge !== before) {
      this.page.facts(this.facts());
    }
  }

  /** The source of the chosen edge: what it is called, and the features of A and B.
   * @returns {{ kind: number, a: number, b: number, words: string } | null} */
  get #source() {
    if (this.#edge === null || this.answer === null) {
      return null;
    }
    const [kind, a, b] = this.answer.region.sources.subarray(3 * this.#edge, 3 * this.#edge + 3);
    const words = [
      "a point, no edge",
      `edge ${a} of A at vertex ${b} of B`,
      `edge ${b} of B at vertex ${a} of A`,
      `edge ${a} of A and edge ${b} of B, merged`,
    ];
    return { kind, a, b, words: words[kind] };
  }

  /** @override */
  facts() {
    const answer = /** @type {Answer | null} */ (this.answer);
    if (answer === null) {
      return [];
    }
    const { region } = answer;
    const count = (/** @type {number} */ kind) => region.parts.filter((part) => part.kind === kind).length;
    const whole = this.#isWhole ? "" : " (after the drag)";
    /** @type {[string, string][]} */
    const facts = [
      ["Vertices of A, B", this.shapes.map(countOf).join(", ")],
      ["Vertices of the result", String(region.vertices.length / 2)],
      ["Holes", `${count(2)}${whole}`],
      ["Exact fits", `${fits(count(3), count(4))}${whole}`],
      ["Area", short(region.area)],
      ["Error at most", region.errorBound === 0 ? "0, exact" : region.errorBound.toPrecision(2)],
      ["Edge from", this.#source?.words ?? "point at an edge of the result"],
      ["Computed in", `${this.#milliseconds.toFixed(1)} ms`],
    ];
    if (this.#isNoFit) {
      facts.unshift(["A and B are", lies[answer.relation]]);
    }
    if (this.#hasSuperset) {
      facts.splice(-1, 0, ["Superset edges", String(answer.superset.length / 4)]);
    }
    return facts;
  }

  /** @override @param {KeyboardEvent} event */
  key(event) {
    if (event.key.toLowerCase() !== "e" || this.answer === null) {
      return false;
    }
    const count = this.answer.region.vertices.length / 2;
    const step = event.shiftKey ? -1 : 1;
    this.#edge = this.#edge === null ? 0 : (this.#edge + step + count) % count;
    this.page.say(`Edge of the result from ${this.#source?.words}`);
    this.shown();
    return true;
  }

  /** @override @param {import("../pen.js").Pen} pen */
  draw(pen) {
    const answer = /** @type {Answer | null} */ (this.answer);
    pen.cross([0, 0], "faint", 5);
    if (answer !== null) {
      pen.edges(answer.superset, this.#at, "faint", 0.75);
      pen.region(answer.region, this.#at, "sum", this.problem === "" ? 0.2 : 0.05);
    }
    this.drawShapes(pen, ["a", "b"]);
    if (this.#isNoFit) {
      pen.cross(placeOf(this.shapes[1], { ring: 0, index: 0 }), "b", 7);
    }
    const source = this.#source;
    if (this.#edge !== null && source !== null) {
      this.#drawSource(pen, this.#edge, source);
    }
  }

  /** @param {import("../pen.js").Pen} pen @param {number} edge @param {{ kind: number, a: number, b: number }} source */
  #drawSource(pen, edge, { kind, a, b }) {
    const [start, end] = this.#endsOf(edge);
    pen.line(start, end, "mark", 4);
    pen.dot(start, "mark", 4);
    if (kind === 0) {
      return;
    }
    const numbers = [a, b];
    this.shapes.forEach((shape, k) => {
      const corner = cornerOf(shape, numbers[k]);
      if (kind === 3 || kind === k + 1) {
        pen.line(placeOf(shape, corner), placeOf(shape, neighbour(shape, corner)), "mark", 4);
      } else {
        pen.dot(placeOf(shape, corner), "mark", 6);
      }
    });
  }
}

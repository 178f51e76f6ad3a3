// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The third view: two blocks, their distance, the way out of an overlap, and their contacts.

import { short } from "../objects.js";
import { blocks } from "../samples.js";
import { boundsOf, centreOf, shapeOf } from "../shapes.js";
import { View } from "../view.js";

/**
 * @typedef {import("../shapes.js").Point} Point
 * @typedef {import("../compute/blocks.js").Answer} Answer
 */

const lies = { "1": "apart", "0": "touching", "-1": "overlapping" };
const kinds = ["", "Edge and vertex", "Vertex and edge", "Two vertices"];

export class BlocksView extends View {
  #milliseconds = 0;
  #limit;
  #isOutside;
  #shown;

  /** @param {import("../view.js").Page} page */
  constructor(page) {
    super(page, "blocks");
    this.shapes = [shapeOf("A", blocks.a, [0, 0]), shapeOf("B", blocks.b, [12, 3])];
    this.selected = 1;
    this.#limit = this.element("limit", HTMLInputElement);
    this.#isOutside = this.element("outside", HTMLInputElement);
    this.#shown = this.element("limit-shown", HTMLOutputElement);
    this.#limit.addEventListener("input", () => {
      this.#shown.textContent = this.#limit.value;
      this.changed();
    });
    this.#setLimits();
    this.#isOutside.addEventListener("change", () => this.changed());
    this.element("escape", HTMLButtonElement).addEventListener("click", () => void this.#escape());
  }

  /** Distances of contacts that suit the size of the blocks. */
  #setLimits() {
    const [xmin, ymin, xmax, ymax] = boundsOf(...this.shapes);
    const unit = 2 ** Math.floor(Math.log2(Math.max(xmax - xmin, ymax - ymin) / 8));
    [this.#limit.max, this.#limit.step] = [String(4 * unit), String(unit / 8)];
    this.#shown.textContent = this.#limit.value = String(unit);
  }

  /** @override @param {Float64Array[][]} polygons @param {Point | null} point */
  take(polygons, point) {
    super.take(polygons, point);
    this.#setLimits();
  }

  /** Room for B to go round A. @override */
  box() {
    const [xmin, ymin, xmax, ymax] = boundsOf(...this.shapes);
    const room = Math.max(xmax - xmin, ymax - ymin) / 6;
    return /** @type {import("../shapes.js").Box} */ ([xmin - room, ymin - room, xmax + room, ymax + room]);
  }

  /** @override */
  question() {
    const [a, b] = this.shapes;
    return { a, b, limit: Number(this.#limit.value), isOutside: this.#isOutside.checked };
  }

  /** @override @param {number} milliseconds */
  answered(milliseconds) {
    this.#milliseconds = milliseconds;
  }

  /** Moves B along the shortest way out. */
  async #escape() {
    const [a, b] = this.shapes;
    const before = b.at;
    try {
      const { answer } = await this.page.answers.ask("blocks", this.question());
      const [x, y] = /** @type {Answer} */ (answer).escape.position;
      if (b.at === before) {
        b.at = [a.at[0] + x, a.at[1] + y];
        this.page.say(`B is at ${b.at.map(short).join(", ")}.`);
      }
    } catch (error) {
      this.page.report(/** @type {Error} */ (error).message);
      return;
    }
    this.page.shapesChanged();
    this.changed();
  }

  /** @override @param {KeyboardEvent} event */
  key(event) {
    if (event.key !== "Enter") {
      return false;
    }
    void this.#escape();
    return true;
  }

  /** @override @returns {[string, string][]} */
  facts() {
    const answer = /** @type {Answer | null} */ (this.answer);
    if (answer === null) {
      return [];
    }
    const { separation, escape, contacts } = answer;
    const counts = kinds.slice(1).map((name, k) => {
      const count = contacts.filter(({ kind }) => kind === k + 1).length;
      return /** @type {[string, string]} */ ([name, String(count)]);
    });
    return [
      ["A and B are", lies[separation.relation]],
      ["Distance", short(separation.distance)],
      ["Depth of the overlap", short(escape.depth)],
      ["Shortest way out", escape.depth === 0 ? "none needed" : escape.translation.map(short).join(", ")],
      ["Contacts", String(contacts.length)],
      ...counts,
      ["Computed in", `${this.#milliseconds.toFixed(1)} ms`],
    ];
  }

  /** @override @param {import("../pen.js").Pen} pen */
  draw(pen) {
    this.drawShapes(pen, ["a", "b"]);
    const answer = /** @type {Answer | null} */ (this.answer);
    if (answer === null) {
      return;
    }
    const [a, b] = this.shapes;
    /** @param {readonly [number, number]} point @returns {Point} */
    const placed = ([x, y]) => [x + a.at[0], y + a.at[1]];
    const { separation, escape, contacts } = answer;
    for (const { onA, onB, normal } of contacts) {
      pen.line(placed(onA), placed(onB), "fit", 2);
      pen.dot(placed(onA), "fit", 4);
      const length = 22 / pen.stage.camera.scale;
      const [x, y] = placed(onB);
      pen.arrow([x, y], [x + length * normal[0], y + length * normal[1]], "fit", 1.5);
    }
    if (separation.nearest !== null) {
      const [start, end] = [placed(separation.nearest.onA), placed(separation.nearest.onB)];
      pen.line(start, end, "ink", 2, [6, 4]);
      pen.dot(start, "ink", 4);
      pen.dot(end, "ink", 4);
      const middle = /** @type {Point} */ ([(start[0] + end[0]) / 2, (start[1] + end[1]) / 2]);
      pen.words(middle, short(separation.distance), "ink", [0, -14]);
    }
    if (escape.depth > 0) {
      pen.rings(b.rings, placed(escape.position), "free", { fill: 0.08, width: 2, dash: [6, 4] });
      const [x, y] = centreOf(boundsOf(b));
      pen.arrow([x, y], [x + escape.translation[0], y + escape.translation[1]], "ink", 2.5);
    }
    this.drawNames(pen, ["a", "b"]);
  }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The second view: a sheet with parts, and where the selected part is free.

import { arrows } from "../keys.js";
import { fits, short } from "../objects.js";
import { laid, parts, sheet } from "../samples.js";
import { boundsOf, centreOf, middleOf, placeOf, setRings, shapeOf, turn } from "../shapes.js";
import { View } from "../view.js";

/**
 * @typedef {import("../shapes.js").Point} Point
 * @typedef {import("../shapes.js").Shape} Shape
 * @typedef {import("../compute/sheet.js").Answer} Answer
 */

const lies = { "1": "free", "0": "touching", "-1": "overlapping" };
/** As many parts as the worker keeps polygons for. */
const mostParts = 100;

export class SheetView extends View {
  #milliseconds = 0;
  #names = /** @type {Record<string, number>} */ ({});

  /** @param {import("../view.js").Page} page */
  constructor(page) {
    super(page, "sheet");
    this.hasVertices = false;
    this.shapes = [shapeOf("Sheet", sheet)];
    for (const [name, x, y] of laid) {
      this.shapes.push(shapeOf(this.#nameOf(name), parts[name], [x, y]));
    }
    this.selected = 1;
    const kind = this.element("part", HTMLSelectElement);
    const on = (/** @type {string} */ id, /** @type {() => void} */ act) =>
      this.element(id, HTMLButtonElement).addEventListener("click", act);
    on("add", () => void this.#add(kind.value, parts[kind.value]));
    on("remove", () => this.#removePart());
    on("turn", () => this.#turn());
    on("place", () => void this.place());
    on("best", () => void this.#best());
  }

  /** @param {string} kind */
  #nameOf(kind) {
    this.#names[kind] = (this.#names[kind] ?? 0) + 1;
    return `${kind[0].toUpperCase()}${kind.slice(1)} ${this.#names[kind]}`;
  }

  /** @override @param {number} index */
  canMove(index) {
    return index > 0;
  }

  /** The answer, if it is about the selected part. @returns {Answer | null} */
  get #found() {
    return this.answer?.key === this.shape.key ? this.answer : null;
  }

  /** The selected part; null for the sheet. */
  get #part() {
    return this.selected > 0 ? this.shape : null;
  }

  /** @override */
  box() {
    return boundsOf(this.shapes[0]);
  }

  /** @override */
  question() {
    const others = this.shapes.filter((_, k) => k > 0 && k !== this.selected);
    return { sheet: this.shapes[0], parts: others, moving: this.#part };
  }

  /** @override @param {number} milliseconds */
  answered(milliseconds) {
    this.#milliseconds = milliseconds;
  }

  /** Asks about the selected part, and puts it where the answer says. Where it was moved
   * meanwhile, it stays. @param {string} name @param {object} more @param {(answer: any) => Point | null} where */
  async #move(name, more, where) {
    const part = this.#part;
    if (part === null) {
      this.page.say("Choose a part first.");
      return;
    }
    const before = part.at;
    try {
      const { answer } = await this.page.answers.ask(name, { .../** @type {object} */ (this.question()), ...more });
      const place = where(answer);
      if (place === null) {
        this.page.say(`${part.name} is free nowhere.`);
      } else if (part.at === before) {
        part.at = place;
        this.page.say(`${part.name} is at ${place.map(short).join(", ")}.`);
      }
    } catch (error) {
      this.problem = /** @type {Error} */ (error).message;
      this.page.report(this.problem);
      return;
    }
    this.page.shapesChanged();
    this.changed();
  }

  /** Puts the selected part at the nearest free position. */
  place() {
    return this.#move("sheet", {}, ({ escape }) => (Number.isFinite(escape.depth) ? escape.position : null));
  }

  #best() {
    return this.#move("best", {}, (position) => position);
  }

  /** @override @param {Point} point @param {boolean} hasMoved */
  release(point, hasMoved) {
    super.release(point, hasMoved);
    if (hasMoved) {
      void this.place();
    }
  }

  /** Puts the selected part as near to a point as it is free. @override @param {Point} point */
  click(point) {
    const part = this.#part;
    if (part !== null) {
      const [x, y] = centreOf(boundsOf(part));
      const { snap } = this.page.stage;
      part.at = [snap(part.at[0] + point[0] - x), snap(part.at[1] + point[1] - y)];
      void this.place();
    }
  }

  /** @param {string} kind @param {ArrayLike<number>[]} rings */
  async #add(kind, rings, [x, y] = centreOf(boundsOf(this.shapes[0]))) {
    if (this.shapes.length > mostParts) {
      this.page.say(`There are ${mostParts} parts, and no more are taken.`);
      return;
    }
    const part = shapeOf(this.#nameOf(kind), rings);
    const [cx, cy] = centreOf(boundsOf(part));
    part.at = [this.page.stage.snap(x - cx), this.page.stage.snap(y - cy)];
    this.selected = this.shapes.push(part) - 1;
    this.page.shapesChanged();
    await this.place();
  }

  #removePart() {
    if (this.#part === null) {
      this.page.say("Choose a part first.");
      return;
    }
    this.shapes.splice(this.selected, 1);
    this.selected = Math.min(this.selected, this.shapes.length - 1);
    this.page.shapesChanged();
    this.changed();
  }

  #turn() {
    if (this.#part !== null) {
      turn(this.#part, this.page.stage.snap);
      this.page.shapesChanged();
      this.changed();
    }
  }

  /** With the sheet selected, the first polygon is the sheet; all others are parts.
   * @override @param {Float64Array[][]} polygons @param {Point | null} point */
  async take(polygons, point) {
    const isOnSheet = this.selected === 0;
    for (const [k, rings] of polygons.entries()) {
      if (isOnSheet && k === 0) {
        setRings(this.shapes[0], rings);
        this.page.stage.fit(this.box());
      } else {
        await this.#add("part", rings, point ?? undefined);
      }
    }
    this.page.shapesChanged();
    this.changed();
  }

  /** @override @param {KeyboardEvent} event */
  key(event) {
    const arrow = arrows[event.key];
    if (arrow !== undefined && event.shiftKey) {
      const [xmin, ymin, xmax, ymax] = this.box();
      const far = xmax - xmin + ymax - ymin;
      void this.#move("slide", { motion: [far * arrow[0], far * arrow[1]] }, (position) => position);
      return true;
    }
    const acts = /** @type {Record<string, () => void>} */ ({
      Enter: () => void this.place(),
      b: () => void this.#best(),
      r: () => this.#turn(),
      Delete: () => this.#removePart(),
      Backspace: () => this.#removePart(),
    });
    const act = acts[event.key];
    act?.();
    return act !== undefined || [",", ".", "i", "Insert"].includes(event.key);
  }

  /** @override @returns {[string, string][]} */
  facts() {
    const answer = this.#found;
    const part = this.#part;
    if (part === null || answer === null) {
      return [["Parts", String(this.shapes.length - 1)]];
    }
    const count = (/** @type {number} */ kind) =>
      answer.region.parts.filter((found) => found.kind === kind).length;
    const { depth } = answer.escape;
    const way = Number.isFinite(depth) ? (depth === 0 ? "here" : `${short(depth)} away`) : "nowhere";
    return [
      ["Parts", String(this.shapes.length - 1)],
      [part.name, lies[/** @type {keyof typeof lies} */ (String(answer.relation))]],
      ["Nearest free position", way],
      ["Free polygons", `${count(1)}, with ${count(2)} holes`],
      ["Exact fits", fits(count(3), count(4))],
      ["Free area", short(answer.region.area)],
      ["Computed in", `${this.#milliseconds.toFixed(1)} ms`],
    ];
  }

  /** @override @param {import("../pen.js").Pen} pen */
  draw(pen) {
    const [sheetShape, ...rest] = this.shapes;
    pen.shape(sheetShape, "ink", { fill: 0.06, width: this.selected === 0 ? 3 : 2 });
    const answer = this.#found;
    const part = this.#part;
    for (const other of rest.filter((shape) => shape !== part)) {
      pen.shape(other, "a", { fill: 0.25 });
    }
    if (part !== null) {
      this.#drawPart(pen, part, answer);
    }
    for (const other of rest.filter((one) => one !== part && pen.hasRoom(one.name, one))) {
      pen.words(middleOf(other), other.name, "a");
    }
    if (part !== null) {
      pen.words(middleOf(part), part.name, "b");
    }
  }

  /** The part and where it is free. @param {import("../pen.js").Pen} pen @param {Shape} part
   * @param {Answer | null} answer */
  #drawPart(pen, part, answer) {
    // The region is of the first vertex: where that may be.
    const [x, y] = part.rings[0];
    const place = placeOf(part, { ring: 0, index: 0 });
    if (answer !== null) {
      pen.region(answer.region, [x, y], "free", 0.3);
      pen.fits(answer.region, [x, y]);
    }
    const isOverlapping = answer !== null && answer.relation < 0;
    pen.shape(part, isOverlapping ? "bad" : "b", { fill: 0.35, width: 2.5 });
    if (isOverlapping && Number.isFinite(answer.escape.depth)) {
      const [dx, dy] = answer.escape.position;
      pen.rings(part.rings, [dx, dy], "free", { fill: 0, width: 2, dash: [6, 4] });
      pen.arrow(place, [dx + x, dy + y], "ink");
    }
    pen.dot(place, "b", 5);
  }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shapes that are chosen, moved, and edited vertex by vertex.

import * as shapes from "./shapes.js";

/**
 * @typedef {import("./shapes.js").Point} Point
 * @typedef {import("./shapes.js").Shape} Shape
 * @typedef {import("./shapes.js").Corner} Corner
 * @typedef {import("./pen.js").Pen} Pen
 * @typedef {import("./view.js").Page} Page
 */

export class Editing {
  /** @type {Shape[]} */
  shapes = [];
  selected = 0;
  /** The chosen vertex of the selected shape. @type {Corner | null} */
  corner = null;
  /** The edge under the pointer, where a click adds a vertex. @type {Point | null} */
  newCorner = null;
  isDragging = false;
  /** Whether vertices can be edited. */
  hasVertices = true;
  /** Where the pointer is on what is dragged. @type {Point} */
  #grip = [0, 0];

  /** @param {Page} page */
  constructor(page) {
    this.page = page;
  }

  /** Called after every change. */
  changed() {}

  /** Whether a shape is no polygon as it is. @param {Shape} _shape */
  isWrong(_shape) {
    return false;
  }

  get shape() {
    return this.shapes[this.selected];
  }

  /** The shapes that can be dragged. @param {number} _index */
  canMove(_index) {
    return true;
  }

  /** @param {number} index */
  select(index) {
    if (index !== this.selected) {
      this.selected = index;
      this.corner = null;
      this.page.shapesChanged();
      this.changed();
    }
  }

  /** The vertex, the edge or the shape at a point: of the selected shape first.
   * @param {Point} point @param {number} reach */
  pick(point, reach) {
    const order = [this.selected, ...[...this.shapes.keys()].reverse()];
    for (const index of this.hasVertices ? order : []) {
      const { corner, distance } = shapes.nearestCorner(this.shapes[index], point);
      if (distance <= reach) {
        return { index, corner, place: shapes.placeOf(this.shapes[index], corner) };
      }
    }
    for (const index of this.hasVertices ? order : []) {
      const edge = shapes.nearestEdge(this.shapes[index], point);
      if (edge.distance <= 0.6 * reach) {
        return { index, edge: edge.corner, place: edge.point };
      }
    }
    const index = order.find((k) => this.canMove(k) && shapes.contains(this.shapes[k], point));
    return index === undefined ? null : { index, place: point };
  }

  /** @param {Point} point @param {number} reach */
  press(point, reach) {
    const found = this.pick(point, reach);
    if (found === null) {
      return false;
    }
    this.selected = found.index;
    this.corner = found.corner ?? null;
    this.newCorner = null;
    const from = this.shape.at;
    this.#grip = [point[0] - from[0], point[1] - from[1]];
    if (found.edge !== undefined) {
      const { snap } = this.page.stage;
      const [x, y] = found.place;
      this.corner = shapes.insertCorner(this.shape, found.edge, [snap(x), snap(y)]);
    }
    if (this.corner !== null) {
      this.#grip = [point[0] - found.place[0], point[1] - found.place[1]];
    }
    this.isDragging = true;
    this.page.shapesChanged();
    this.changed();
    return true;
  }

  /** @param {Point} point */
  drag(point) {
    const { snap } = this.page.stage;
    /** @type {Point} */
    const place = [snap(point[0] - this.#grip[0]), snap(point[1] - this.#grip[1])];
    if (this.corner !== null) {
      shapes.moveCorner(this.shape, this.corner, place);
    } else if (this.canMove(this.selected)) {
      this.shape.at = place;
    }
    this.changed();
  }

  /** @param {Point} _point @param {boolean} _hasMoved */
  release(_point, _hasMoved) {
    this.isDragging = false;
    this.page.shapesChanged();
    this.changed();
  }

  /** A click beside all shapes. @param {Point} _point */
  click(_point) {
    this.corner = null;
    this.page.stage.redraw();
  }

  /** @param {Point | null} point @param {number} reach */
  hover(point, reach) {
    const found = point === null ? null : this.pick(point, reach);
    this.newCorner = found?.edge === undefined ? null : found.place;
    const movable = found !== null && found.edge === undefined;
    this.page.stage.canvas.style.cursor =
      this.newCorner !== null ? "copy" : movable ? (found.corner ? "pointer" : "grab") : "default";
    this.page.stage.redraw();
  }

  /** @param {Point} point @param {number} reach */
  remove(point, reach) {
    const found = this.pick(point, reach);
    if (found?.corner !== undefined) {
      [this.selected, this.corner] = [found.index, found.corner];
      this.removeCorner();
    }
  }

  /** Takes the chosen vertex out. */
  removeCorner() {
    if (this.corner === null) {
      this.page.say("Choose a vertex first.");
      return;
    }
    if (!shapes.removeCorner(this.shape, this.corner)) {
      this.page.say("A polygon keeps three vertices.");
      return;
    }
    const { ring, index } = this.corner;
    const count = (this.shape.rings[ring]?.length ?? 0) / 2;
    this.corner = count === 0 ? null : { ring, index: Math.min(index, count - 1) };
    this.page.shapesChanged();
    this.changed();
  }

  /** Adds a vertex in the middle of the edge after the chosen vertex, or after the first. */
  addCorner() {
    const corner = this.corner ?? { ring: 0, index: 0 };
    const [x0, y0] = shapes.placeOf(this.shape, corner);
    const [x1, y1] = shapes.placeOf(this.shape, shapes.neighbour(this.shape, corner));
    this.corner = shapes.insertCorner(this.shape, corner, [(x0 + x1) / 2, (y0 + y1) / 2]);
    this.page.shapesChanged();
    this.changed();
  }

  /** Chooses the next vertex, or the one before. @param {number} step */
  chooseCorner(step) {
    const all = [...shapes.cornersOf(this.shape)];
    const at = all.findIndex(({ ring, index }) => ring === this.corner?.ring && index === this.corner.index);
    const next = at < 0 ? (step > 0 ? 0 : all.length - 1) : (at + step + all.length) % all.length;
    this.corner = all[next];
    const [x, y] = shapes.placeOf(this.shape, this.corner);
    this.page.say(`${this.shape.name}, vertex ${next} at ${x}, ${y}`);
    this.page.stage.redraw();
  }

  /** Moves the chosen vertex or the shape by steps of the grid. @param {Point} steps */
  nudge([dx, dy]) {
    const { step, snap } = this.page.stage;
    const [x, y] = this.corner === null ? this.shape.at : shapes.placeOf(this.shape, this.corner);
    /** @type {Point} */
    const place = [dx === 0 ? x : snap(x + dx * step), dy === 0 ? y : snap(y + dy * step)];
    if (this.corner !== null) {
      shapes.moveCorner(this.shape, this.corner, place);
    } else if (this.canMove(this.selected)) {
      this.shape.at = place;
    }
    this.page.shapesChanged();
    this.changed();
  }

  /** The shapes as they are edited, in their colours. @param {Pen} pen @param {string[]} colours */
  drawShapes(pen, colours) {
    this.shapes.forEach((shape, k) => {
      const colour = this.isWrong(shape) ? "bad" : colours[k % colours.length];
      pen.shape(shape, colour, { fill: 0.25, width: k === this.selected ? 2.5 : 1.5 });
      if (k === this.selected && this.hasVertices) {
        pen.corners(shape, colour);
      }
    });
    if (this.newCorner !== null) {
      pen.dot(this.newCorner, "mark", 4, true);
    }
    if (this.corner !== null) {
      pen.dot(shapes.placeOf(this.shape, this.corner), "mark", 6);
    }
  }

  /** @param {Pen} pen @param {string[]} colours */
  drawNames(pen, colours) {
    this.shapes.forEach((shape, k) => {
      pen.words(shapes.middleOf(shape), shape.name, colours[k % colours.length]);
    });
  }
}

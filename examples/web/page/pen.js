// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is drawn: rings, lines, points, arrows and words, in the colours of the style sheet.

import { boundsOf, cornersOf, neighbour, placeOf } from "./shapes.js";

/**
 * @typedef {import("./shapes.js").Point} Point
 * @typedef {import("./shapes.js").Shape} Shape
 * @typedef {import("./compute/packed.js").Packed} Packed
 */

const names = ["paper", "ink", "faint", "grid", "a", "b", "sum", "fit", "free", "bad", "mark"];

const font = "600 14px system-ui, sans-serif";

/** The colours, by the names of the style sheet without their hyphens. */
export function coloursOf() {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

export class Pen {
  /**
   * @param {CanvasRenderingContext2D} context @param {import("./stage.js").Stage} stage
   * @param {Record<string, string>} colours
   */
  constructor(context, stage, colours) {
    this.context = context;
    this.stage = stage;
    this.colours = colours;
    context.lineJoin = "round";
    context.lineCap = "round";
  }

  /** Makes rings the path, moved by a vector. @param {Iterable<Float64Array>} rings @param {Point} at */
  #path(rings, [dx, dy]) {
    const { context, stage } = this;
    context.beginPath();
    for (const ring of rings) {
      for (let k = 0; k < ring.length; k += 2) {
        const [x, y] = stage.toScreen(ring[k] + dx, ring[k + 1] + dy);
        if (k === 0) {
          context.moveTo(x, y);
        } else {
          context.lineTo(x, y);
        }
      }
      context.closePath();
    }
  }

  /**
   * @param {Iterable<Float64Array>} rings @param {Point} at @param {string} colour
   * @param {{ fill?: number, width?: number, dash?: number[] }} style
   */
  rings(rings, at, colour, { fill = 0.2, width = 1.5, dash = [] } = {}) {
    const { context } = this;
    this.#path(rings, at);
    context.fillStyle = context.strokeStyle = this.colours[colour];
    if (fill > 0) {
      context.globalAlpha = fill;
      context.fill("evenodd");
      context.globalAlpha = 1;
    }
    if (width > 0) {
      this.#stroke(width, dash);
    }
  }

  /** @param {number} width @param {number[]} dash */
  #stroke(width, dash = []) {
    this.context.lineWidth = width;
    this.context.setLineDash(dash);
    this.context.stroke();
    this.context.setLineDash([]);
  }

  /** @param {Shape} shape @param {string} colour @param {{ fill?: number, width?: number, dash?: number[] }} style */
  shape(shape, colour, style = {}) {
    this.rings(shape.rings, shape.at, colour, style);
  }

  /** The polygons of a region, with their holes. @param {Packed} region @param {Point} at
   * @param {string} colour */
  region({ vertices, parts }, at, colour, fill = 0.22) {
    const rings = parts.filter(({ kind }) => kind <= 2);
    this.rings(
      rings.map(({ start, stop }) => vertices.subarray(2 * start, 2 * stop)),
      at,
      colour,
      { fill, width: 2 },
    );
  }

  /** The segments and points of a region. @param {Packed} region @param {Point} at */
  fits({ vertices, parts }, [dx, dy]) {
    for (const { kind, start, stop } of parts) {
      const [x0, y0, x1, y1] = vertices.subarray(2 * start, 2 * stop);
      if (kind === 3) {
        this.line([x0 + dx, y0 + dy], [x1 + dx, y1 + dy], "fit", 4);
      } else if (kind === 4) {
        this.dot([x0 + dx, y0 + dy], "fit", 5);
      }
    }
  }

  /** Many edges, with four coordinates each; the more there are, the fainter.
   * @param {Float64Array} edges @param {Point} at @param {string} colour @param {number} width */
  edges(edges, [dx, dy], colour, width) {
    const { context, stage } = this;
    context.beginPath();
    for (let k = 0; k < edges.length; k += 4) {
      context.moveTo(...stage.toScreen(edges[k] + dx, edges[k + 1] + dy));
      context.lineTo(...stage.toScreen(edges[k + 2] + dx, edges[k + 3] + dy));
    }
    context.strokeStyle = this.colours[colour];
    context.globalAlpha = Math.min(1, Math.max(0.2, 1200 / edges.length));
    this.#stroke(width);
    context.globalAlpha = 1;
  }

  /** @param {Point} start @param {Point} end @param {string} colour */
  line(start, end, colour, width = 1.5, dash = /** @type {number[]} */ ([])) {
    const { context, stage } = this;
    context.beginPath();
    context.moveTo(...stage.toScreen(...start));
    context.lineTo(...stage.toScreen(...end));
    context.strokeStyle = this.colours[colour];
    this.#stroke(width, dash);
  }

  /** @param {Point} start @param {Point} end @param {string} colour */
  arrow(start, end, colour, width = 2) {
    const [[x0, y0], [x1, y1]] = [this.stage.toScreen(...start), this.stage.toScreen(...end)];
    const length = Math.hypot(x1 - x0, y1 - y0);
    if (length < 1) {
      return;
    }
    const { context } = this;
    const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
    const head = Math.min(9, length);
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.moveTo(x1 - head * (ux - 0.5 * uy), y1 - head * (uy + 0.5 * ux));
    context.lineTo(x1, y1);
    context.lineTo(x1 - head * (ux + 0.5 * uy), y1 - head * (uy - 0.5 * ux));
    context.strokeStyle = this.colours[colour];
    this.#stroke(width);
  }

  /** @param {Point} point @param {string} colour */
  dot(point, colour, radius = 4, isHollow = false) {
    const { context } = this;
    context.beginPath();
    context.arc(...this.stage.toScreen(...point), radius, 0, 2 * Math.PI);
    context.fillStyle = this.colours[isHollow ? "paper" : colour];
    context.strokeStyle = this.colours[isHollow ? colour : "paper"];
    context.fill();
    this.#stroke(1.5);
  }

  /** @param {Point} point @param {string} colour */
  cross(point, colour, size = 6) {
    const [x, y] = this.stage.toScreen(...point);
    const { context } = this;
    context.beginPath();
    context.moveTo(x - size, y);
    context.lineTo(x + size, y);
    context.moveTo(x, y - size);
    context.lineTo(x, y + size);
    context.strokeStyle = this.colours[colour];
    this.#stroke(2);
  }

  /** Whether words are as short as a shape is wide. @param {string} text @param {Shape} shape */
  hasRoom(text, shape) {
    const [xmin, , xmax] = boundsOf(shape);
    this.context.font = font;
    return this.context.measureText(text).width < 1.1 * (xmax - xmin) * this.stage.camera.scale;
  }

  /** Words at a point, moved by pixels, on the colour of the paper.
   * @param {Point} point @param {string} text @param {string} colour @param {Point} shift */
  words(point, text, colour, shift = [0, 0]) {
    const { context, stage } = this;
    context.font = font;
    context.textAlign = "center";
    context.textBaseline = "middle";
    const half = context.measureText(text).width / 2 + 6;
    let [x, y] = stage.toScreen(...point);
    x = Math.min(Math.max(x + shift[0], half), stage.width - half);
    y = Math.min(Math.max(y + shift[1], 12), stage.height - 12);
    context.lineWidth = 4;
    context.strokeStyle = this.colours["paper"];
    context.strokeText(text, x, y);
    context.fillStyle = this.colours[colour];
    context.fillText(text, x, y);
  }

  /** The vertices of a shape, as far as there is room for them. @param {Shape} shape @param {string} colour */
  corners(shape, colour) {
    for (const corner of cornersOf(shape)) {
      const [x0, y0] = this.stage.toScreen(...placeOf(shape, corner));
      const [x1, y1] = this.stage.toScreen(...placeOf(shape, neighbour(shape, corner, -1)));
      const room = Math.hypot(x1 - x0, y1 - y0);
      if (room > 7) {
        this.dot(placeOf(shape, corner), colour, Math.min(4.5, room / 4), true);
      }
    }
  }

  /** The grid that positions keep to, each eighth line of it. */
  grid() {
    const { context, stage } = this;
    const step = 8 * stage.step;
    const { x, y, scale } = stage.camera;
    const [right, top] = [x + stage.width / 2 / scale, y + stage.height / 2 / scale];
    context.beginPath();
    for (let at = Math.ceil((2 * x - right) / step) * step; at <= right; at += step) {
      const [column] = stage.toScreen(at, 0);
      context.moveTo(column, 0);
      context.lineTo(column, stage.height);
    }
    for (let at = Math.ceil((2 * y - top) / step) * step; at <= top; at += step) {
      const [, row] = stage.toScreen(0, at);
      context.moveTo(0, row);
      context.lineTo(stage.width, row);
    }
    context.strokeStyle = this.colours["grid"];
    this.#stroke(1);
  }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The canvas, and the part of the plane that it shows.

/**
 * @typedef {import("./shapes.js").Point} Point
 * @typedef {import("./shapes.js").Box} Box
 *
 * The point in the middle of the canvas, and the pixels of a unit. The y axis points upwards.
 * @typedef {{ x: number, y: number, scale: number }} Camera
 */

export class Stage {
  /** @type {Camera} */
  camera = { x: 0, y: 0, scale: 20 };
  width = 1;
  height = 1;
  /** Whether positions and vertices keep to the grid. */
  isSnapping = true;
  #isWaiting = false;
  #frames = /** @type {number[]} */ ([]);

  /** @param {HTMLCanvasElement} canvas @param {(context: CanvasRenderingContext2D) => void} draw */
  constructor(canvas, draw) {
    this.canvas = canvas;
    this.context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    this.draw = draw;
    /** Called when the width changes. */
    this.onResize = () => {};
    new ResizeObserver(() => this.#resize()).observe(canvas);
    this.#resize();
  }

  #resize() {
    const { clientWidth, clientHeight } = this.canvas;
    const ratio = window.devicePixelRatio;
    const isNew = clientWidth !== this.width;
    [this.width, this.height] = [Math.max(1, clientWidth), Math.max(1, clientHeight)];
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = Math.round(this.height * ratio);
    if (isNew) {
      this.onResize();
    }
    this.redraw();
  }

  /** Draws at the next frame. */
  redraw() {
    if (this.#isWaiting) {
      return;
    }
    this.#isWaiting = true;
    requestAnimationFrame((time) => {
      this.#isWaiting = false;
      this.#frames = [...this.#frames.filter((frame) => frame > time - 1000), time];
      const ratio = window.devicePixelRatio;
      this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
      this.context.clearRect(0, 0, this.width, this.height);
      this.draw(this.context);
    });
  }

  /** The frames drawn in the last second. */
  get frames() {
    return this.#frames.length;
  }

  /** @param {number} x @param {number} y @returns {Point} */
  toScreen(x, y) {
    const { camera } = this;
    return [
      this.width / 2 + (x - camera.x) * camera.scale,
      this.height / 2 - (y - camera.y) * camera.scale,
    ];
  }

  /** The point of the plane under an event. @param {{ clientX: number, clientY: number }} event
   * @returns {Point} */
  pointOf({ clientX, clientY }) {
    const { left, top } = this.canvas.getBoundingClientRect();
    const { camera } = this;
    return [
      camera.x + (clientX - left - this.width / 2) / camera.scale,
      camera.y - (clientY - top - this.height / 2) / camera.scale,
    ];
  }

  /** Shows a box and a margin round it. @param {Box} box */
  fit([xmin, ymin, xmax, ymax]) {
    if (!Number.isFinite(xmax - xmin)) {
      return;
    }
    const [width, height] = [Math.max(xmax - xmin, 1e-9), Math.max(ymax - ymin, 1e-9)];
    const margin = Math.min(48, this.width / 10, this.height / 10);
    const scale = Math.min((this.width - 2 * margin) / width, (this.height - 2 * margin) / height);
    this.camera = { x: (xmin + xmax) / 2, y: (ymin + ymax) / 2, scale: Math.max(scale, 1e-9) };
    this.redraw();
  }

  /** Zooms about a point of the plane, which stays where it is.
   * @param {number} factor @param {Point} point */
  zoom(factor, [x, y] = [this.camera.x, this.camera.y]) {
    const { camera } = this;
    const scale = Math.min(1e12, Math.max(1e-9, camera.scale * factor));
    const kept = camera.scale / scale;
    this.camera = { x: x + (camera.x - x) * kept, y: y + (camera.y - y) * kept, scale };
    this.redraw();
  }

  /** Moves what is shown, by pixels. @param {number} dx @param {number} dy */
  pan(dx, dy) {
    const { x, y, scale } = this.camera;
    this.camera = { x: x - dx / scale, y: y + dy / scale, scale };
    this.redraw();
  }

  /** The step of the grid: a power of two of at least some pixels, so that sums of steps are exact. */
  get step() {
    return 2 ** Math.ceil(Math.log2(7 / this.camera.scale));
  }

  /** The nearest number of the grid; without one, the number itself. @param {number} value */
  snap = (value) => (this.isSnapping ? Math.round(value / this.step) * this.step : value);
}

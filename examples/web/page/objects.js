// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The shapes for the keyboard and for screen readers: a button over each shape of the stage.

import { boundsOf, centreOf, countOf } from "./shapes.js";

/** A number with as many digits as help. @param {number} value */
export const short = (value) => String(Number(value.toPrecision(6)));

/** How many of something there are; nothing where there are none. @param {number} count @param {string} name */
const counted = (count, name) => (count === 0 ? [] : [`${count} ${name}${count === 1 ? "" : "s"}`]);

/** @param {number} segments @param {number} points */
export const fits = (segments, points) =>
  [...counted(segments, "segment"), ...counted(points, "point")].join(", ") || "none";

export class Objects {
  /** @type {HTMLButtonElement[]} */
  #buttons = [];
  #view;

  /** @param {HTMLElement} list @param {import("./stage.js").Stage} stage
   * @param {() => import("./view.js").View} view */
  constructor(list, stage, view) {
    this.list = list;
    this.stage = stage;
    this.#view = view;
  }

  /** Makes as many buttons as there are shapes, and names them. */
  update() {
    const { shapes, selected } = this.#view();
    while (this.#buttons.length > shapes.length) {
      this.#buttons.pop()?.remove();
    }
    while (this.#buttons.length < shapes.length) {
      const index = this.#buttons.length;
      const button = document.createElement("button");
      button.addEventListener("focus", () => this.#view().select(index));
      this.#buttons.push(button);
      this.list.append(button);
    }
    shapes.forEach((shape, k) => {
      const [x, y] = centreOf(boundsOf(shape)).map(short);
      const label = `${shape.name}, ${countOf(shape)} vertices, at ${x}, ${y}`;
      this.#buttons[k].setAttribute("aria-label", label);
      this.#buttons[k].setAttribute("aria-pressed", String(k === selected));
    });
    this.place();
  }

  /** Puts the buttons over the shapes. */
  place() {
    this.#view().shapes.forEach((shape, k) => {
      const [xmin, ymin, xmax, ymax] = boundsOf(shape);
      const [[left, top], [right, bottom]] = [
        this.stage.toScreen(xmin, ymax),
        this.stage.toScreen(xmax, ymin),
      ];
      const button = this.#buttons[k];
      if (button !== undefined) {
        button.style.transform = `translate(${left}px, ${top}px)`;
        button.style.width = `${right - left}px`;
        button.style.height = `${bottom - top}px`;
      }
    });
  }

  /** Gives the keyboard to the selected shape. */
  focus() {
    this.#buttons[this.#view().selected]?.focus({ preventScroll: true });
  }

  /** Whether a shape has the keyboard. */
  get hasFocus() {
    return this.list.contains(document.activeElement);
  }
}

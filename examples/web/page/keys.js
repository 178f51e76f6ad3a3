// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What keys do while a shape has the keyboard.

/** @type {Record<string, import("./shapes.js").Point>} */
export const arrows = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Does what a key says to a view. Says whether it is a key. @param {import("./view.js").View} view
 * @param {KeyboardEvent} event */
export function pressed(view, event) {
  if (view.key(event)) {
    return true;
  }
  const arrow = arrows[event.key];
  if (arrow !== undefined) {
    const steps = event.shiftKey ? 8 : 1;
    view.nudge([steps * arrow[0], steps * arrow[1]]);
    return true;
  }
  switch (event.key) {
    case ".":
      view.chooseCorner(1);
      return true;
    case ",":
      view.chooseCorner(-1);
      return true;
    case "Insert":
    case "i":
      view.addCorner();
      return true;
    case "Delete":
    case "Backspace":
      view.removeCorner();
      return true;
    case "Escape":
      view.corner = null;
      view.page.stage.redraw();
      return true;
    default:
      return false;
  }
}

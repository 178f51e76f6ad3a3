// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What mouse, pen and fingers do on the stage.

/**
 * @typedef {import("./shapes.js").Point} Point
 *
 * What a view does with a pointer. press() says whether it takes it; else the plane moves.
 * @typedef {{
 *   press: (point: Point, reach: number) => boolean,
 *   drag: (point: Point) => void,
 *   release: (point: Point, hasMoved: boolean) => void,
 *   click: (point: Point) => void,
 *   hover: (point: Point | null, reach: number) => void,
 *   remove: (point: Point, reach: number) => void,
 * }} Target
 */

/** How far, in pixels, a pointer may be from what it takes. */
const reaches = /** @type {Record<string, number>} */ ({ mouse: 9, pen: 12, touch: 20 });
/** How far a pointer may move in a click. */
const stillness = 4;

/** @param {import("./stage.js").Stage} stage @param {() => Target} target */
export function listen(stage, target) {
  const { canvas } = stage;
  /** The pointers that are down, where they were last. */
  const down = /** @type {Map<number, { x: number, y: number }>} */ (new Map());
  let start = { x: 0, y: 0 };
  let state = /** @type {"none" | "taken" | "pan" | "pinch"} */ ("none");
  let hasMoved = false;

  const reachOf = (/** @type {MouseEvent} */ event) =>
    (reaches[/** @type {PointerEvent} */ (event).pointerType] ?? reaches["mouse"]) / stage.camera.scale;

  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) {
      return;
    }
    event.preventDefault();
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const point = stage.pointOf(event);
    if (down.size > 1) {
      if (state === "taken") {
        target().release(point, hasMoved);
      }
      state = "pinch";
      return;
    }
    start = { x: event.clientX, y: event.clientY };
    hasMoved = false;
    state = target().press(point, reachOf(event)) ? "taken" : "pan";
  });

  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (before === undefined) {
      target().hover(stage.pointOf(event), reachOf(event));
      return;
    }
    const now = { x: event.clientX, y: event.clientY };
    hasMoved ||= Math.hypot(now.x - start.x, now.y - start.y) > stillness;
    if (state === "pinch") {
      pinch(event.pointerId, before, now);
    } else if (state === "pan" && hasMoved) {
      stage.pan(now.x - before.x, now.y - before.y);
    } else if (state === "taken" && hasMoved) {
      target().drag(stage.pointOf(event));
    }
    if (state !== "pan" || hasMoved) {
      down.set(event.pointerId, now);
    }
  });

  /** @param {number} id @param {{ x: number, y: number }} before @param {{ x: number, y: number }} now */
  function pinch(id, before, now) {
    const other = [...down].find(([key]) => key !== id)?.[1];
    if (other === undefined) {
      return;
    }
    const width = (/** @type {{ x: number, y: number }} */ { x, y }) =>
      Math.max(1, Math.hypot(x - other.x, y - other.y));
    const [clientX, clientY] = [(now.x + other.x) / 2, (now.y + other.y) / 2];
    stage.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    stage.zoom(width(now) / width(before), stage.pointOf({ clientX, clientY }));
  }

  const end = (/** @type {PointerEvent} */ event) => {
    if (!down.delete(event.pointerId)) {
      return;
    }
    const point = stage.pointOf(event);
    if (state === "taken") {
      target().release(point, hasMoved);
    } else if (state === "pan" && !hasMoved && event.type === "pointerup") {
      target().click(point);
    }
    state = down.size > 0 ? "pinch" : "none";
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("pointerleave", () => down.size === 0 && target().hover(null, 0));

  canvas.addEventListener("mousedown", (event) => event.preventDefault());
  canvas.addEventListener("contextmenu", (event) => {
    event.preventDefault();
    if (/** @type {PointerEvent} */ (event).pointerType !== "touch") {
      target().remove(stage.pointOf(event), reachOf(event));
    }
  });
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1;
      stage.zoom(2 ** ((-event.deltaY * lines) / 400), stage.pointOf(event));
    },
    { passive: false },
  );
}

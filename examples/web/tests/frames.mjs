// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
//   node tests/frames.mjs   measures frames while a vertex is dragged, of 200 x 200 vertices
//
// Prints for each sample how many frames and answers there were in a second; how long frames and
// computations took, in milliseconds; and how long the whole region took after the drag.

import { pathToFileURL } from "node:url";
import { cornerOnScreen, factsOf, open, start } from "./browser.mjs";

const seconds = 4;

/** What a drag of the rightmost vertex, outwards and back, took. @param {import("playwright-core").Page} page */
async function drag(page) {
  const [x, y] = await cornerOnScreen(page, 0, 0);
  const vertex = { x, y };
  return page.evaluate(
    ({ vertex, milliseconds }) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("stage"));
      const frames = /** @type {number[]} */ ([]);
      const answers = /** @type {number[]} */ ([]);
      const heard = (/** @type {Event} */ event) => answers.push(/** @type {CustomEvent} */ (event).detail);
      const send = (/** @type {string} */ type, /** @type {number} */ x, /** @type {number} */ y) =>
        canvas.dispatchEvent(
          new PointerEvent(type, { pointerId: 1, pointerType: "mouse", clientX: x, clientY: y, bubbles: true }),
        );
      canvas.setPointerCapture = () => {};
      return new Promise((done) => {
        send("pointerdown", vertex.x, vertex.y);
        window.addEventListener("answered", heard);
        const begin = performance.now();
        let last = begin;
        requestAnimationFrame(function step(now) {
          frames.push(now - last);
          last = now;
          send("pointermove", vertex.x + 12 + 6 * Math.sin((now - begin) / 200), vertex.y);
          if (now - begin < milliseconds) {
            requestAnimationFrame(step);
            return;
          }
          send("pointerup", vertex.x, vertex.y);
          window.removeEventListener("answered", heard);
          done({ frames: frames.slice(1), answers, elapsed: now - begin });
        });
      });
    },
    { vertex, milliseconds: 1000 * seconds },
  );
}

/** @param {number[]} values @param {number} part */
function quantile(values, part) {
  return [...values].sort((p, q) => p - q)[Math.floor(part * (values.length - 1))];
}

/** Frames and answers of a sample. @param {import("playwright-core").Browser} browser
 * @param {string} url @param {string} sample */
export async function measured(browser, url, sample) {
  const { page, context } = await open(browser, url);
  await page.selectOption("#sum-sample", sample);
  await page.uncheck("#snap");
  await page.waitForTimeout(1000);
  await drag(page);
  const { frames, answers, elapsed } = /** @type {any} */ (await drag(page));
  // A key moves the vertex without a drag, so that the whole region is computed.
  await page.locator("#objects button").first().focus();
  await page.keyboard.press(".");
  await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(500);
  const whole = Number.parseFloat((await factsOf(page))["Computed in"]);
  await context.close();
  return {
    framesPerSecond: (1000 * frames.length) / elapsed,
    answersPerSecond: (1000 * answers.length) / elapsed,
    frame: [quantile(frames, 0.5), quantile(frames, 0.95)],
    whole,
    answer: [quantile(answers, 0.5), quantile(answers, 0.95)],
  };
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  const { browser, url, close } = await start();
  console.log("sample  frames/s  frame 50% 95%  answers/s  computation 50% 95%  whole region");
  for (const sample of ["waves", "stars"]) {
    const { framesPerSecond, answersPerSecond, frame, answer, whole } = await measured(browser, url, sample);
    const numbers = [framesPerSecond, ...frame, answersPerSecond, ...answer, whole];
    console.log(sample.padEnd(7), ...numbers.map((value) => value.toFixed(1).padStart(7)));
  }
  await close();
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The page in a browser, for tests.

import { spawnSync } from "node:child_process";
import { chromium } from "playwright-core";
import { pageServer, prepare } from "../serve.mjs";

/** The path of Chromium. */
function executable() {
  const named = process.env["CHROMIUM"];
  const names = named === undefined ? ["chromium", "chromium-browser", "google-chrome"] : [named];
  for (const name of names) {
    const { stdout, status } = spawnSync("sh", ["-c", 'command -v "$1"', "sh", name], { encoding: "utf8" });
    if (status === 0) {
      return stdout.trim();
    }
  }
  throw new Error(
    `${names.join(", ")}: not found. The tests need a browser: ` +
      "sudo apt-get install --no-install-recommends chromium, or CHROMIUM=/path/to/it",
  );
}

/** A browser and a server of the page; close() ends both. */
export async function start() {
  const missing = prepare();
  if (missing !== "") {
    throw new Error(missing);
  }
  const browser = await chromium.launch({ executablePath: executable(), args: ["--no-sandbox"] });
  const server = pageServer();
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(null)));
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  return {
    browser,
    url: `http://localhost:${port}/`,
    async close() {
      await browser.close();
      server.closeAllConnections();
      server.close();
    },
  };
}

/** Waits until the view that is shown has an answer. @param {import("playwright-core").Page} page */
export function answered(page) {
  return page.waitForFunction(() => document.querySelectorAll("#facts dd").length > 0);
}

/**
 * The page in a context of its own, once the first answer is shown. Errors of the page fail.
 * @param {import("playwright-core").Browser} browser @param {string} url
 * @param {import("playwright-core").BrowserContextOptions} options
 */
export async function open(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 760 }, ...options });
  const page = await context.newPage();
  const errors = /** @type {string[]} */ ([]);
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  await page.goto(url);
  await answered(page);
  return { page, context, errors };
}

/** The module of the page, in the page. */
const main = "/examples/web/page/main.js";

/** Where a point of the plane is on the screen. @param {import("playwright-core").Page} page
 * @param {number} x @param {number} y @returns {Promise<[x: number, y: number]>} */
export function onScreen(page, x, y) {
  return page.evaluate(
    async ({ main, x, y }) => {
      const { stage } = await import(main);
      const { left, top } = stage.canvas.getBoundingClientRect();
      const [column, row] = stage.toScreen(x, y);
      return [left + column, top + row];
    },
    { main, x, y },
  );
}

/** The outer ring of a shape where it lies, in pairs.
 * @param {import("playwright-core").Page} page @param {number} shape
 * @returns {Promise<[x: number, y: number][]>} */
export function ringOf(page, shape) {
  return page.evaluate(
    async ({ main, shape }) => {
      const { rings, at } = (await import(main)).shownView().shapes[shape];
      return Array.from({ length: rings[0].length / 2 }, (_, k) => [
        rings[0][2 * k] + at[0],
        rings[0][2 * k + 1] + at[1],
      ]);
    },
    { main, shape },
  );
}

/** Where a vertex of a shape is on the screen. @param {import("playwright-core").Page} page
 * @param {number} shape @param {number} corner */
export async function cornerOnScreen(page, shape, corner) {
  const [x, y] = (await ringOf(page, shape))[corner];
  return onScreen(page, x, y);
}

/** What the panel tells, by its names. @param {import("playwright-core").Page} page
 * @returns {Promise<Record<string, string>>} */
export function factsOf(page) {
  return page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll("#facts dt")].map((name) => [
        name.textContent ?? "",
        name.nextElementSibling?.textContent ?? "",
      ]),
    ),
  );
}

/** Waits until the panel tells something. @param {import("playwright-core").Page} page
 * @param {string} name @param {string} value */
export async function until(page, name, value) {
  await page.waitForFunction(
    ({ name, value }) =>
      [...document.querySelectorAll("#facts dt")].some(
        (item) => item.textContent === name && item.nextElementSibling?.textContent === value,
      ),
    { name, value },
    { timeout: 20000 },
  );
}

/** Drags with the mouse. @param {import("playwright-core").Page} page
 * @param {[number, number]} from @param {[number, number]} to */
export async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await page.mouse.move(...to, { steps: 3 });
  await page.mouse.up();
}

/** Drops a file onto the stage, or pastes its text. @param {import("playwright-core").Page} page
 * @param {"drop" | "paste"} how @param {string} text @param {[number, number]} point */
export function give(page, how, text, [clientX, clientY] = [0, 0]) {
  return page.evaluate(
    ({ how, text, clientX, clientY }) => {
      const data = new DataTransfer();
      if (how === "paste") {
        data.setData("text/plain", text);
        window.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true }));
        return;
      }
      data.items.add(new File([text], "polygon.txt"));
      const target = document.getElementById("stage");
      const where = { clientX, clientY, bubbles: true, cancelable: true };
      target?.dispatchEvent(new DragEvent("drop", { dataTransfer: data, ...where }));
    },
    { how, text, clientX, clientY },
  );
}

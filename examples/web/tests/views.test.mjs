// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// The second and the third view.

import assert from "node:assert/strict";
import { test } from "node:test";
import { answered, drag, factsOf, give, onScreen, ringOf, until } from "./browser.mjs";
import { freshPage } from "./fresh_page.mjs";

const opened = freshPage();

/** Shows a view, and waits for its first answer. @param {"sheet" | "blocks"} view */
async function show(view) {
  const { page } = opened;
  await page.click(`#tab-${view}`);
  await answered(page);
  return page;
}

/** Waits until a shape lies with its first vertex at a point. @param {number} shape
 * @param {[number, number]} point */
async function lies(shape, point) {
  for (let tries = 0; tries < 500; ++tries) {
    const [[x, y]] = await ringOf(opened.page, shape);
    if (x === point[0] && y === point[1]) {
      return;
    }
    await opened.page.waitForTimeout(20);
  }
  assert.deepEqual((await ringOf(opened.page, shape))[0], point);
}

test("a view that is chosen shows no facts of the one before", async () => {
  const left = await opened.page.evaluate(() => {
    document.getElementById("tab-sheet")?.click();
    return document.querySelectorAll("#facts dd").length;
  });
  assert.equal(left, 0);
});

test("the free region of the peg has its exact fits", async () => {
  const facts = await factsOf(await show("sheet"));
  assert.equal(facts["Peg 1"], "touching");
  assert.match(facts["Exact fits"], /^\d+ segments/);
});

test("a part that is dragged onto another one goes to the nearest free position", async () => {
  const page = await show("sheet");
  assert.deepEqual((await ringOf(page, 1))[0], [15, 4]);
  // The peg is 2 wide. It just fits between the bricks, which end at 4 and begin at 6.
  await drag(page, await onScreen(page, 16, 5), await onScreen(page, 5.5, 1));
  await lies(1, [4, 0]);
  await until(page, "Peg 1", "touching");
});

test("a click on the sheet places the part near it", async () => {
  const page = await show("sheet");
  await page.mouse.click(...(await onScreen(page, 18, 9)));
  await lies(1, [17, 8]);
  await until(page, "Peg 1", "free");
});

test("buttons and keys of the sheet", async () => {
  const page = await show("sheet");
  await page.click("#sheet-best");
  await lies(1, [0, 2]);
  await page.locator("#objects button").nth(1).focus();
  await page.keyboard.press("Shift+ArrowRight");
  await page.waitForFunction(() => document.getElementById("live")?.textContent?.startsWith("Peg 1 is at"));
  await lies(1, [10, 2]);
  await page.selectOption("#sheet-part", "clamp");
  await page.click("#sheet-add");
  await until(page, "Parts", "8");
  await page.waitForFunction(() => document.querySelector("#facts dt:nth-of-type(2)")?.textContent === "Clamp 2");
  await page.click("#sheet-turn");
  await page.click("#sheet-remove");
  await until(page, "Parts", "7");
});

test("polygons dropped on the sheet are parts; with the sheet selected, the sheet", async () => {
  const page = await show("sheet");
  await give(page, "drop", "M 0 0 H 3 V 1 H 0 Z", await onScreen(page, 12, 6));
  await until(page, "Parts", "8");
  const bar = "((0 0, 3 0, 3 1, 0 1, 0 0))";
  await give(page, "paste", `MULTIPOLYGON (${bar}, ${bar}, ${bar})`);
  await until(page, "Parts", "11");
  await page.waitForFunction(() => document.getElementById("live")?.textContent?.startsWith("Part 4"));
  const corners = [8, 9, 10, 11].map((shape) => ringOf(page, shape));
  assert.equal(new Set((await Promise.all(corners)).map(String)).size, 4);
  await page.locator("#objects button").first().focus();
  await give(page, "paste", "POLYGON ((0 0, 40 0, 40 20, 0 20, 0 0))");
  await page.waitForFunction(() =>
    document.querySelector("#objects button")?.getAttribute("aria-label")?.includes("Sheet, 4 vertices"),
  );
});

test("blocks: their distance, contacts, and the way out", async () => {
  const page = await show("blocks");
  assert.equal((await factsOf(page))["A and B are"], "apart");
  assert.equal((await factsOf(page))["Distance"], "1.21268");
  const grip = /** @type {const} */ ([1, 2]);
  const at = (/** @type {number} */ x, /** @type {number} */ y) => onScreen(page, x + grip[0], y + grip[1]);
  await drag(page, await at(12, 3), await at(8, 6));
  await until(page, "A and B are", "touching");
  await until(page, "Distance", "0");
  assert.ok(Number((await factsOf(page))["Contacts"]) > 0);
  await drag(page, await at(8, 6), await at(8, 5.5));
  await until(page, "A and B are", "overlapping");
  await until(page, "Depth of the overlap", "0.5");
  await until(page, "Shortest way out", "0, 0.5");
  await page.click("#blocks-escape");
  await lies(1, [8, 6]);
  await until(page, "A and B are", "touching");
});

test("a block is edited and moved by keys", async () => {
  const page = await show("blocks");
  await page.locator("#objects button").nth(1).focus();
  await page.keyboard.press("ArrowLeft");
  const [[x]] = await ringOf(page, 1);
  assert.ok(x < 12);
  await page.keyboard.press(".");
  await page.keyboard.press("i");
  assert.equal((await ringOf(page, 1)).length, 8);
  await page.keyboard.press("Delete");
  assert.equal((await ringOf(page, 1)).length, 7);
});

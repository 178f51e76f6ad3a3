// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// The first view: dragging, editing, hovering, and reading files.

import assert from "node:assert/strict";
import { test } from "node:test";
import { minkowskiSum } from "../../../bindings/javascript/dist/index.js";
import { cornerOnScreen, drag, factsOf, give, onScreen, ringOf, until } from "./browser.mjs";
import { freshPage } from "./fresh_page.mjs";

const opened = freshPage();

const square = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
const triangle = "POLYGON ((0 0, 2 0, 0 2, 0 0))";

/** Makes A a square with sides of 4, and B a triangle. */
async function simple() {
  await give(opened.page, "paste", `${square} ${triangle}`);
  await until(opened.page, "Vertices of A, B", "4, 3");
}

test("the sum of the plate and the peg has its holes and exact fits", async () => {
  const facts = await factsOf(opened.page);
  assert.equal(facts["Holes"], "2");
  assert.equal(facts["Exact fits"], "1 segment, 1 point");
  assert.equal(facts["Area"], "184");
  assert.equal(facts["Error at most"], "0, exact");
});

test("a polygon is dragged by its inside", async () => {
  const { page } = opened;
  await simple();
  const before = await ringOf(page, 0);
  const [x, y] = [before[0][0] + 2, before[0][1] + 2];
  await drag(page, await onScreen(page, x, y), await onScreen(page, x + 1, y + 2));
  assert.deepEqual(await ringOf(page, 0), before.map(([u, v]) => [u + 1, v + 2]));
});

test("a vertex is dragged", async () => {
  const { page } = opened;
  await simple();
  assert.equal((await factsOf(page))["Area"], "34");
  const [x, y] = (await ringOf(page, 0))[2];
  await drag(page, await onScreen(page, x, y), await onScreen(page, x + 2, y + 2));
  assert.deepEqual((await ringOf(page, 0))[2], [x + 2, y + 2]);
  const face = minkowskiSum([[0, 0], [4, 0], [6, 6], [0, 4]], triangle);
  await until(page, "Area", String(face.area));
});

test("a click on an edge adds a vertex, a right click removes it", async () => {
  const { page } = opened;
  await simple();
  const [x, y] = (await ringOf(page, 0))[0];
  const middle = await onScreen(page, x + 2, y);
  await page.mouse.click(...middle);
  await until(page, "Vertices of A, B", "5, 3");
  assert.deepEqual((await ringOf(page, 0))[1], [x + 2, y]);
  await page.mouse.click(...middle, { button: "right" });
  await until(page, "Vertices of A, B", "4, 3");
});

test("what is no simple polygon is named, and the last result stays", async () => {
  const { page } = opened;
  await simple();
  const [x, y] = (await ringOf(page, 0))[0];
  await drag(page, await onScreen(page, x, y), await onScreen(page, x + 5, y + 2));
  await page.waitForFunction(() => document.getElementById("problem")?.textContent?.startsWith("A: "));
  assert.ok(Number((await factsOf(page))["Vertices of the result"]) > 0);
  await page.keyboard.press("e");
  assert.equal((await factsOf(page))["Edge from"], "none chosen");
  await drag(page, await onScreen(page, x + 5, y + 2), await onScreen(page, x, y));
  await page.waitForFunction(() => document.getElementById("problem")?.textContent === "");
});

test("an edge of the result tells what it is made of", async () => {
  const { page } = opened;
  await simple();
  const [[ax, ay], [bx, by]] = [(await ringOf(page, 0))[0], (await ringOf(page, 1))[0]];
  const at = (/** @type {number} */ x, /** @type {number} */ y) => onScreen(page, ax + bx + x, ay + by + y);
  await page.mouse.move(...(await at(3, 0)));
  await until(page, "Edge from", "edge 0 of A and edge 0 of B, merged");
  await page.mouse.move(...(await at(6, 2)));
  await until(page, "Edge from", "edge 1 of A at vertex 1 of B");
  await page.mouse.move(...(await at(5, 5)));
  await until(page, "Edge from", "edge 1 of B at vertex 2 of A");
});

test("superset edges are counted", async () => {
  const { page } = opened;
  await simple();
  await page.check("#sum-superset");
  await page.waitForFunction(() => document.getElementById("facts")?.textContent?.includes("Superset edges"));
  assert.ok(Number((await factsOf(page))["Superset edges"]) >= 5);
});

test("the no-fit region tells how A and B lie", async () => {
  const { page } = opened;
  await simple();
  await page.check("#sum-no-fit");
  await until(page, "A and B are", "apart");
  const [[ax, ay], [bx, by]] = [(await ringOf(page, 0))[0], (await ringOf(page, 1))[0]];
  const grip = /** @type {const} */ ([0.5, 0.5]);
  const place = (/** @type {number} */ x, /** @type {number} */ y) => onScreen(page, x + grip[0], y + grip[1]);
  await drag(page, await place(bx, by), await place(ax + 4, ay + 1));
  await until(page, "A and B are", "touching");
  await drag(page, await place(ax + 4, ay + 1), await place(ax + 3, ay + 1));
  await until(page, "A and B are", "overlapping");
});

const texts = {
  "Well-Known Text": "POLYGON ((0 0, 6 0, 6 1, 1 1, 1 5, 0 5, 0 0))",
  GeoJSON: JSON.stringify({
    type: "FeatureCollection",
    features: [
      {
        type: "Feature",
        properties: {},
        geometry: { type: "Polygon", coordinates: [[[0, 0], [6, 0], [6, 1], [1, 1], [1, 5], [0, 5], [0, 0]]] },
      },
    ],
  }),
  "a path of SVG": "M 0 0 h 6 v 1 h -5 v 4 h -1 Z",
  "an SVG picture":
    '<svg xmlns="http://www.w3.org/2000/svg"><g transform="translate(9 7)"><path transform="scale(1 -1)"' +
    ' d="M 0 0 h 6 v 1 h -5 v 4 h -1 Z"/></g></svg>',
};
for (const [name, text] of Object.entries(texts)) {
  test(`${name} is dropped, and is pasted`, async () => {
    const { page } = opened;
    await simple();
    await give(page, "drop", text, await cornerOnScreen(page, 1, 0));
    await until(page, "Vertices of A, B", "4, 6");
    await page.evaluate(() => document.querySelector("button")?.focus());
    await give(page, "drop", text, await cornerOnScreen(page, 0, 0));
    await until(page, "Vertices of A, B", "6, 6");
    await simple();
    await give(page, "paste", text);
    await until(page, "Vertices of A, B", "6, 3");
    const ring = await ringOf(page, 0);
    assert.deepEqual(
      ring.map(([x, y]) => [x - ring[0][0], y - ring[0][1]]),
      [[0, 0], [6, 0], [6, 1], [1, 1], [1, 5], [0, 5]],
    );
  });
}

test("a file is opened, and one without polygons is named", async () => {
  const { page } = opened;
  const buffer = Buffer.from(`MULTIPOLYGON ((${square.slice(9, -1)}), (${triangle.slice(9, -1)}))`);
  await page.setInputFiles("#file", { name: "two.wkt", mimeType: "text/plain", buffer });
  await until(page, "Vertices of A, B", "4, 3");
  const shapes = '<rect x="1" y="1" width="9" height="5"/><polygon points="0,0 4,0 4,4 2,6 0,4"/>';
  await give(page, "drop", `<svg xmlns="http://www.w3.org/2000/svg">${shapes}</svg>`);
  await until(page, "Vertices of A, B", "4, 5");
  await give(page, "drop", "nothing");
  await page.waitForFunction(() => document.getElementById("problem")?.textContent?.includes("no polygon"));
  await give(page, "drop", "M 0 0 C 1 1 2 2 3 3 Z");
  await page.waitForFunction(() => document.getElementById("problem")?.textContent?.includes("curves"));
});

test("of several files each has its polygons", async () => {
  const { page } = opened;
  const files = [square, '<svg xmlns="http://www.w3.org/2000/svg"><polyline points="0,0 3,0 3,3 2,3 0,1"/></svg>'];
  await page.setInputFiles(
    "#file",
    files.map((text, k) => ({ name: `${k}.txt`, mimeType: "text/plain", buffer: Buffer.from(text) })),
  );
  await until(page, "Vertices of A, B", "4, 5");
});

test("what is wrong with a text is said, and changes nothing", async () => {
  const { page } = opened;
  await simple();
  const svg = (/** @type {string} */ shape) => `<svg xmlns="http://www.w3.org/2000/svg">${shape}</svg>`;
  /** @type {[string, string][]} */
  const wrong = [
    ['{"type": ', "GeoJSON: "],
    ['{"type": "FeatureCollection"}', "GeoJSON: the features of a FeatureCollection are not a list."],
    ['{"type": "MultiPolygon", "coordinates": 5}', "GeoJSON: the coordinates of a MultiPolygon are not a list."],
    ['{"type": "Polygon"}', "polygon: undefined in a geometry is not a list"],
    ["POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))", "polygon: edges 0 and 2 meet"],
    ["POLYGON ((0 0, 1e308 0, 1e308 1e308, -1e308 1e308))", "A polygon has a coordinate beyond 1e+100"],
    [svg('<rect width="9" height="5" rx="2"/>'), "SVG: a rectangle with round corners"],
    [svg('<rect width="100%" height="5"/>'), 'SVG: width="100%" of a rect'],
    [svg("<path"), "SVG: error on line 1"],
  ];
  for (const [text, words] of wrong) {
    await give(page, "drop", text);
    await page.waitForFunction((words) => document.getElementById("problem")?.textContent?.startsWith(words), words);
    assert.equal((await factsOf(page))["Vertices of A, B"], "4, 3");
  }
  await give(page, "paste", triangle);
  await until(page, "Vertices of A, B", "3, 3");
  assert.equal(await page.textContent("#problem"), "");
});

test("the result is copied as text", async () => {
  const { page, context } = opened;
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await simple();
  await page.click("#sum-copy");
  await page.waitForFunction(() => document.getElementById("live")?.textContent?.includes("copied"));
  const text = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(text, /^MULTIPOLYGON \(\(\(.*\)\)\)\nGEOMETRYCOLLECTION EMPTY\n$/);
});

test("every sample is computed", async () => {
  const { page } = opened;
  const samples = await page.locator("#sum-sample option").evaluateAll((all) =>
    all.map((option) => /** @type {HTMLOptionElement} */ (option).value),
  );
  assert.equal(samples.length, 7);
  for (const sample of samples) {
    const answered = page.evaluate(
      () => new Promise((done) => window.addEventListener("answered", done, { once: true })),
    );
    await page.selectOption("#sum-sample", sample);
    await answered;
    assert.equal(await page.textContent("#problem"), "", sample);
  }
  assert.equal((await factsOf(page))["Vertices of A, B"], "200, 200");
});

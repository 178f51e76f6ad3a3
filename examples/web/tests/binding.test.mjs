// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// The binding in a browser: with and without SIMD the same bits as in Node.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import * as gcv from "../../../bindings/javascript/dist/index.js";
import { pairs as samples } from "../page/samples.js";
import { measured } from "./frames.mjs";
import { start } from "./browser.mjs";

const file = (/** @type {string} */ name) =>
  readFileSync(new URL(`../../polygons/${name}.wkt`, import.meta.url), "utf8");

/** A source, and its holes. @typedef {[source: any, holes: number[][]]} Operand */

/** @param {number[][]} rings @returns {Operand} */
function operand([outer, ...holes]) {
  const paired = (/** @type {number[]} */ ring) =>
    Array.from({ length: ring.length / 2 }, (_, k) => [ring[2 * k], ring[2 * k + 1]]);
  return [paired(outer), /** @type {any} */ (holes.map(paired))];
}

/** @type {[Operand, Operand][]} */
const pairs = [
  [[file("room"), []], [file("robot"), []]],
  [[file("fork_large"), []], [file("fork_small"), []]],
  [[file("coast"), []], [file("islet"), []]],
  [operand(samples["plate"].a), operand(samples["plate"].b)],
  [operand(samples["stars"].a), operand(samples["stars"].b)],
];

/** All there is of regions and of one scene, as text. Runs in Node and in the browser.
 * @param {typeof gcv} library @param {[Operand, Operand][]} pairs */
function results(library, pairs) {
  const texts = pairs.flatMap(([[a, holesOfA], [b, holesOfB]]) => {
    const first = new library.Polygon(a, holesOfA.map((ring) => /** @type {any} */ (ring)));
    const second = new library.Polygon(b, holesOfB.map((ring) => /** @type {any} */ (ring)));
    const region = library.noFitRegion(first, second);
    const exact = region.exact.map((point) =>
      point.map(({ numerator, denominator }) => `${numerator}/${denominator}`).join(" "),
    );
    const escape = library.penetration(first, second);
    return [exact.join(), region.toWKT(), region.fitsToWKT(), JSON.stringify([region.sources, escape])];
  });
  const scene = new library.Scene([[0, 0], [10, 0], [10, 6], [0, 6]]);
  scene.add([[0, 0], [4, 0], [4, 2], [0, 2]], [[0, 0], [6, 0]]);
  texts.push(scene.freeRegion([[0, 0], [2, 0], [2, 3], [0, 3]]).fitsToWKT());
  return texts;
}

let site = /** @type {Awaited<ReturnType<typeof start>>} */ (/** @type {unknown} */ (null));

before(async () => {
  site = await start();
});
after(() => site?.close());

for (const [name, hasSIMD] of /** @type {const} */ ([["gcv-simd.wasm", true], ["gcv.wasm", false]])) {
  test(`${name} gives the same exact vertices in the browser as in Node`, async () => {
    const page = await site.browser.newPage();
    if (!hasSIMD) {
      await page.addInitScript(() => {
        WebAssembly.validate = () => false;
      });
    }
    const loaded = /** @type {string[]} */ ([]);
    page.on("response", (response) => loaded.push(response.url().split("/").at(-1) ?? ""));
    // Any file of the site will do for a page that is not the page.
    await page.goto(new URL("/examples/polygons/room.wkt", site.url).href);
    const found = await page.evaluate(
      async ({ source, pairs }) => {
        const path = "/bindings/javascript/dist/index.js";
        return new Function(`return (${source})`)()(await import(path), pairs);
      },
      { source: results.toString(), pairs },
    );
    assert.deepEqual(found, results(gcv, pairs));
    assert.ok(loaded.includes(name), loaded.join());
    await page.close();
  });
}

test("frames and answers are counted while a vertex of 200 x 200 is dragged", async () => {
  const { framesPerSecond, answersPerSecond } = await measured(site.browser, site.url, "waves");
  assert.ok(framesPerSecond > 0 && answersPerSecond > 0);
});

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// The page for all: keys, touch, colours, widths, and names of what there is.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { answered, onScreen, open, ringOf, start, until } from "./browser.mjs";

let site = /** @type {Awaited<ReturnType<typeof start>>} */ (/** @type {unknown} */ (null));

before(async () => {
  site = await start();
});
after(() => site?.close());

test("keys reach every shape, move it, and choose its vertices", async () => {
  const { page, context, errors } = await open(site.browser, site.url);
  const label = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? "");
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement?.id), "tab-sum");
  await page.keyboard.press("Tab");
  assert.match(await label(), /^A, 24 vertices/);
  const [[x, y]] = await ringOf(page, 0);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  const [[u, v]] = await ringOf(page, 0);
  assert.ok(u > x && v > y);
  await page.keyboard.press("e");
  await page.waitForFunction(() => document.getElementById("live")?.textContent?.startsWith("Edge of the result"));
  await page.keyboard.press(".");
  await page.keyboard.press("Delete");
  await until(page, "Vertices of A, B", "23, 4");
  await page.keyboard.press("i");
  await until(page, "Vertices of A, B", "24, 4");
  await page.keyboard.press("Tab");
  assert.match(await label(), /^B, 4 vertices/);
  await page.keyboard.press("2");
  assert.equal(await page.getAttribute("#tab-sheet", "aria-selected"), "true");
  await page.keyboard.press("3");
  assert.equal(await page.getAttribute("#tab-blocks", "aria-selected"), "true");
  await page.focus("#tab-blocks");
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.getAttribute("#tab-sum", "aria-selected"), "true");
  await page.keyboard.press("?");
  assert.ok(await page.isVisible("#help dl"));
  await context.close();
  assert.deepEqual(errors, []);
});

test("a finger drags a shape, two fingers zoom", async () => {
  const options = { viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };
  const { page, context, errors } = await open(site.browser, site.url, options);
  await page.tap("#tab-blocks");
  await until(page, "A and B are", "apart");
  const client = await context.newCDPSession(page);
  /** @param {"touchStart" | "touchMove" | "touchEnd"} type @param {number[][]} points */
  const touch = async (type, ...points) => {
    const touchPoints = points.map(([x, y], id) => ({ x, y, id }));
    await client.send("Input.dispatchTouchEvent", { type, touchPoints });
  };
  const before = await ringOf(page, 1);
  await touch("touchStart", await onScreen(page, 13, 5));
  await touch("touchMove", await onScreen(page, 13, 6));
  await touch("touchMove", await onScreen(page, 13, 7));
  await touch("touchEnd");
  assert.deepEqual((await ringOf(page, 1))[0], [before[0][0], before[0][1] + 2]);
  const width = async () => (await onScreen(page, 1, 0))[0] - (await onScreen(page, 0, 0))[0];
  const narrow = await width();
  await touch("touchStart", [150, 90]);
  await touch("touchStart", [150, 90], [250, 90]);
  await touch("touchMove", [120, 90], [280, 90]);
  await touch("touchMove", [100, 90], [300, 90]);
  await touch("touchEnd");
  assert.ok((await width()) > 1.5 * narrow);
  await context.close();
  assert.deepEqual(errors, []);
});

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`the ${colorScheme} colours can be read`, async () => {
    const { page, context } = await open(site.browser, site.url, { colorScheme });
    const contrasts = await page.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      const luminance = (/** @type {string} */ name) => {
        const value = Number.parseInt(style.getPropertyValue(`--${name}`).trim().slice(1), 16);
        const [r, g, b] = [value >> 16, (value >> 8) & 255, value & 255].map((part) =>
          part / 255 <= 0.04045 ? part / 255 / 12.92 : ((part / 255 + 0.055) / 1.055) ** 2.4,
        );
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const contrast = (/** @type {string} */ one, /** @type {string} */ other) => {
        const [low, high] = [luminance(one), luminance(other)].sort((p, q) => p - q);
        return (high + 0.05) / (low + 0.05);
      };
      const names = ["ink", "faint", "a", "b", "sum", "free", "fit", "bad", "mark", "accent"];
      return names.flatMap((name) => ["paper", "panel"].map((ground) => [name, ground, contrast(name, ground)]));
    });
    for (const [name, ground, contrast] of contrasts) {
      assert.ok(Number(contrast) >= 4.5, `${name} on ${ground}: ${contrast}`);
    }
    await context.close();
  });
}

test("the canvas takes its colours anew when they change", async () => {
  const { page, context } = await open(site.browser, site.url, { colorScheme: "light" });
  /** Whether a pixel of the canvas has the colour of A, as the style sheet has it now. */
  const isDrawn = () =>
    page.evaluate(() => {
      const colour = getComputedStyle(document.documentElement).getPropertyValue("--a").trim();
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("stage"));
      const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
      const words = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
      const [r, g, b] = [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
      return words.includes(((255 << 24) | (b << 16) | (g << 8) | r) >>> 0);
    });
  assert.ok(await isDrawn());
  await page.emulateMedia({ colorScheme: "dark" });
  await page.waitForTimeout(300);
  assert.ok(await isDrawn());
  await context.close();
});

for (const width of [320, 390, 760, 900]) {
  test(`nothing is cut off at a width of ${width}`, async () => {
    const { page, context } = await open(site.browser, site.url, { viewport: { width, height: 720 } });
    for (const view of ["sum", "sheet", "blocks"]) {
      await page.click(`#tab-${view}`);
      const wide = await page.evaluate(() =>
        [...document.querySelectorAll("header, header *, aside, aside *")]
          .filter((item) => item.getBoundingClientRect().right > document.documentElement.clientWidth + 0.5)
          .map((item) => item.outerHTML.slice(0, 80)),
      );
      assert.deepEqual(wide, []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
    }
    await context.close();
  });
}

test("everything that can be used has a name", async () => {
  const { page, context } = await open(site.browser, site.url);
  for (const view of ["sum", "sheet", "blocks"]) {
    await page.click(`#tab-${view}`);
    await answered(page);
    const client = await context.newCDPSession(page);
    const { nodes } = await client.send("Accessibility.getFullAXTree");
    const roles = ["button", "checkbox", "radio", "combobox", "slider", "tab", "tabpanel", "group", "toolbar"];
    const found = nodes.filter((node) => roles.includes(String(node.role?.value)) && !node.ignored);
    assert.ok(found.length > 10);
    for (const node of found) {
      assert.ok(String(node.name?.value ?? "") !== "" || node.role?.value === "group", JSON.stringify(node));
    }
  }
  await context.close();
});

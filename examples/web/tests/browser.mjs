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
  await page.waitForFunction(() => document.querySelectorAll("#facts dd").length > 0);
  return { page, context, errors };
}

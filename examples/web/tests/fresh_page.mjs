// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A browser for the tests of a file, and the page anew for each of them.

import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach } from "node:test";
import { open, start } from "./browser.mjs";

/** What is open: filled before each test, which must leave no errors on the page. */
export function freshPage() {
  const opened = /** @type {Awaited<ReturnType<typeof open>>} */ ({});
  let site = /** @type {Awaited<ReturnType<typeof start>> | undefined} */ (undefined);
  before(async () => {
    site = await start();
  });
  after(() => site?.close());
  beforeEach(async () => {
    assert.ok(site);
    Object.assign(opened, await open(site.browser, site.url));
  });
  afterEach(async () => {
    await opened.context.close();
    assert.deepEqual(opened.errors, []);
  });
  return opened;
}

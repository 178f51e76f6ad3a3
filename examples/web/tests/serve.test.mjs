// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The server: what it gives, and what it does not.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { request } from "node:http";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { pageServer } from "../serve.mjs";

const server = pageServer();
let port = 0;

before(async () => {
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(null)));
  port = /** @type {import("node:net").AddressInfo} */ (server.address()).port;
});
after(() => {
  server.closeAllConnections();
  server.close();
});

/** The status and the type of a path, which is sent as it is.
 * @param {string} path @returns {Promise<[status: number | undefined, type: string | undefined]>} */
function get(path) {
  return new Promise((done, fail) => {
    request({ port, path, host: "127.0.0.1" }, (response) => {
      response.resume();
      done([response.statusCode, response.headers.location ?? response.headers["content-type"]]);
    })
      .on("error", fail)
      .end();
  });
}

test("the page, the library and the polygons are served", async () => {
  assert.deepEqual(await get("/"), [302, "/examples/web/page/"]);
  assert.deepEqual(await get("/examples/web/page/"), [200, "text/html; charset=utf-8"]);
  assert.deepEqual(await get("/examples/web/page/main.js"), [200, "text/javascript; charset=utf-8"]);
  assert.deepEqual(await get("/bindings/javascript/dist/gcv.wasm"), [200, "application/wasm"]);
  assert.deepEqual(await get("/examples/polygons/room.wkt"), [200, "text/plain; charset=utf-8"]);
});

test("nothing else is", async () => {
  for (const path of [
    "/README.md",
    "/examples/web/package.json",
    "/examples/web/page/../package.json",
    "/examples/web/page/..%2fpackage.json",
    "/examples/web/page/%2e%2e/package.json",
    "/examples/web/page",
    "/%",
    "//",
  ]) {
    assert.equal((await get(path))[0], 404, path);
  }
});

/** What the command says, and its status. @param {string[]} values */
function command(...values) {
  const child = spawn(process.execPath, [fileURLToPath(new URL("../serve.mjs", import.meta.url)), ...values]);
  let said = "";
  child.stderr.on("data", (data) => (said += data));
  return new Promise((done) => child.on("close", (status) => done([status, said])));
}

test("a port that is in use, and what is no port, are named", async () => {
  assert.deepEqual(await command(String(port)), [
    1,
    `Port ${port} is in use. Choose another one: npm start -- 8001\n`,
  ]);
  assert.deepEqual(await command("here"), [2, "here is not a port.\n"]);
});

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
//   node serve.mjs [PORT]   serves the page to this machine, at port 8000 by default
//
// The library is a WebAssembly module. Where it is not built yet, it is built first.

import { spawnSync } from "node:child_process";
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize, sep } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = fileURLToPath(new URL("../../", import.meta.url));
const binding = join(root, "bindings/javascript");
const start = "/examples/web/page/";

/** All that is served, at the paths that it has in the repository. */
const served = [start, "/examples/polygons/", "/bindings/javascript/dist/"];

const types = {
  ".html": "text/html; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".wkt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
};

/** The file that a path of a URL stands for; null where nothing is served.
 * @param {string} url */
function fileOf(url) {
  const path = normalize(decodeURIComponent(new URL(url, "http://localhost").pathname));
  const name = path.endsWith(sep) ? join(path, "index.html") : path;
  const file = join(root, name);
  const isServed = served.some((folder) => name.startsWith(normalize(folder)));
  return isServed && existsSync(file) && statSync(file).isFile() ? file : null;
}

/** A server of the page, which does not listen yet. */
export function pageServer() {
  return createServer((request, response) => {
    if (request.url === "/") {
      response.writeHead(302, { location: start }).end();
      return;
    }
    let file = null;
    try {
      file = fileOf(request.url ?? "/");
    } catch {
      // A path that is no path.
    }
    if (file === null) {
      response.writeHead(404, { "content-type": "text/plain" }).end("There is nothing here.\n");
      return;
    }
    const type = types[/** @type {keyof typeof types} */ (extname(file))] ?? "text/plain";
    response.writeHead(200, { "content-type": type, "cache-control": "no-cache" });
    createReadStream(file).pipe(response);
  });
}

/** Whether a program is there.
 * @param {string} name */
function isThere(name) {
  return spawnSync("sh", ["-c", `command -v ${name}`]).status === 0;
}

/** Builds the library unless it is built. Gives what is missing, or nothing. */
export function prepare() {
  const built = ["index.js", "gcv.wasm", "gcv-simd.wasm"];
  if (built.every((name) => existsSync(join(binding, "dist", name)))) {
    return "";
  }
  const tools = { emcc: "emscripten", cmake: "cmake", "pkg-config": "pkg-config", npm: "npm" };
  const missing = Object.entries(tools).flatMap(([tool, name]) => (isThere(tool) ? [] : [name]));
  if (missing.length > 0) {
    return (
      `The library is not built for JavaScript yet, and to build it these are missing: ${missing.join(", ")}.\n` +
      "On Debian 12 install them, then run this again:\n" +
      "  sudo apt-get install --no-install-recommends emscripten cmake libboost-dev pkg-config nodejs npm"
    );
  }
  console.log("Building the library for JavaScript, once. This takes some minutes.");
  const { status } = spawnSync(join(binding, "build.sh"), { stdio: "inherit" });
  return status === 0 ? "" : `${join(binding, "build.sh")} failed; its messages are above.`;
}

function main() {
  const port = Number(process.argv[2] ?? process.env["PORT"] ?? 8000);
  if (!Number.isInteger(port) || port < 0 || port > 65535) {
    console.error(`${process.argv[2] ?? process.env["PORT"]} is not a port.`);
    process.exit(2);
  }
  const missing = prepare();
  if (missing !== "") {
    console.error(missing);
    process.exit(1);
  }
  const server = pageServer();
  server.on("error", (/** @type {NodeJS.ErrnoException} */ error) => {
    console.error(
      error.code === "EADDRINUSE"
        ? `Port ${port} is in use. Choose another one: npm start -- 8001`
        : error.message,
    );
    process.exit(1);
  });
  server.listen(port, "127.0.0.1", () => {
    const address = /** @type {import("node:net").AddressInfo} */ (server.address());
    console.log(`Open http://localhost:${address.port}/ in a browser. Ctrl+C ends this.`);
  });
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  main();
}

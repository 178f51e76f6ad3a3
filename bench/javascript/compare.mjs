// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Times of sums in JavaScript: libgcv in WebAssembly beside clipper-lib, and Clipper2 in
// WebAssembly, from coordinates to coordinates. Prints a table in Markdown. Where GCV_LIBRARY names
// the native library, a second one has how many times as long as that WebAssembly takes.
//
//   npm ci && node compare.mjs [SECONDS]  each, of the median: 0.5 by default
//
// Takes bindings/javascript/dist, which build.sh there makes. The paper's pairs are taken where
// ../shared/data or GCV_DATA_DIR has them. The others compute in integers: coordinates are scaled to
// 2^30, as they are in practice. They give the largest ring of what their sums of closed paths are.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { performance } from "node:perf_hooks";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";

import * as gcv from "../../bindings/javascript/dist/index.js";

const require = createRequire(import.meta.url);
const root = new URL("../../", import.meta.url);
const data = process.env.GCV_DATA_DIR
  ? new URL(`file://${process.env.GCV_DATA_DIR}/`)
  : new URL("../shared/data/", root);
const seconds = Number(process.argv[2] ?? 0.5);

const own = (name) => new URL(`examples/polygons/${name}.wkt`, root);
const papers = (name) => new URL(`cgal/${name}.wkt`, data);
const pairs = [
  ["room, robot", own("room"), own("robot")],
  ["shirt front, sleeve", own("shirt_front"), own("sleeve")],
  ["lock, key", own("lock"), own("key")],
  ["Stars", papers("star_a"), papers("star_b")],
  ["Comb", papers("comb_a"), papers("comb_b")],
  ["Fork", papers("fork_a"), papers("fork_b")],
  ["Knife", papers("knife_a"), papers("knife_b")],
];

function outerRing(file) {
  const polygon = new gcv.Polygon(readFileSync(file, "utf8"));
  return polygon.vertices;
}

function median(values) {
  values.sort((p, q) => p - q);
  return values[values.length >> 1];
}

// Milliseconds of a call.
function time(call) {
  call();
  const times = [];
  const until = performance.now() + 1000 * seconds;
  while (times.length < 3 || performance.now() < until) {
    const start = performance.now();
    call();
    times.push(performance.now() - start);
  }
  return median(times);
}

const scaleOf = (a, b) => {
  const largest = Math.max(...a.map(Math.abs), ...b.map(Math.abs));
  return 2 ** (29 - Math.ceil(Math.log2(largest)));
};

function clipperLib() {
  const Clipper = require("clipper-lib");
  return (a, b) => {
    const scale = scaleOf(a, b);
    const path = (xy) => {
      const points = [];
      for (let k = 0; k < xy.length; k += 2) {
        points.push({ X: Math.round(scale * xy[k]), Y: Math.round(scale * xy[k + 1]) });
      }
      return points;
    };
    const rings = Clipper.Clipper.MinkowskiSum(path(a), path(b), true);
    const largest = rings.reduce((p, q) => (Clipper.Clipper.Area(p) < Clipper.Clipper.Area(q) ? q : p));
    return largest.map(({ X, Y }) => [X / scale, Y / scale]);
  };
}

async function clipper2() {
  const Clipper = await require("clipper2-wasm")();
  return (a, b) => {
    const decimals = Math.min(8, Math.round(Math.log10(scaleOf(a, b))));
    const [first, second] = [Clipper.MakePathD(a), Clipper.MakePathD(b)];
    const rings = Clipper.MinkowskiSumD(first, second, true, decimals);
    let largest = [];
    let area = -Infinity;
    for (let k = 0; k < rings.size(); ++k) {
      const ring = rings.get(k);
      if (Clipper.AreaPathD(ring) > area) {
        area = Clipper.AreaPathD(ring);
        largest = Array.from({ length: ring.size() }, (_, i) => [ring.get(i).x, ring.get(i).y]);
      }
      ring.delete();
    }
    [first, second, rings].forEach((handle) => handle.delete());
    return largest;
  };
}

const outerFace = (a, b) => {
  const face = gcv.minkowskiSum(a, b);
  const vertices = face.vertices;
  face.free();
  return vertices;
};

const region = (a, b) => {
  const found = gcv.minkowskiSumRegion(a, b);
  const vertices = found.vertices;
  found.free();
  return vertices;
};

for (const name of ["gcv-simd", "gcv"]) {
  const module = readFileSync(new URL(`bindings/javascript/dist/${name}.wasm`, root));
  console.log(`${name}.wasm: ${module.length} bytes, ${brotliCompressSync(module).length} by Brotli`);
}
console.log();

const others = [clipperLib(), await clipper2()];
console.log("| pair | vertices | outer face, ms | region, ms | clipper-lib | Clipper2 |");
console.log("| --- | --- | --- | --- | --- | --- |");
for (const [name, ...files] of pairs) {
  if (!files.every((file) => existsSync(file))) {
    console.log(`skipped: ${name}, which is not at ${files[0].pathname}`);
    continue;
  }
  const [a, b] = files.map(outerRing);
  const [ours, whole] = [time(() => outerFace(a, b)), time(() => region(a, b))];
  const ratios = others.map((sum) => {
    const [p, q] = [Array.from(a), Array.from(b)];
    return `${Number((time(() => sum(p, q)) / ours).toPrecision(3))}x`;
  });
  const sizes = `${a.length / 2}, ${b.length / 2}`;
  console.log(`| ${name} | ${sizes} | ${ours.toPrecision(3)} | ${whole.toPrecision(3)} | ${ratios.join(" | ")} |`);
}

// The median of several ratios, each of two times that were taken one after the other: what else the
// machine does is much the same for both.
function nativeRatios(program, a, b) {
  const operands = new Uint8Array(Float64Array.of(a.length / 2, b.length / 2, ...a, ...b).buffer);
  const found = Array.from({ length: 5 }, () => {
    const printed = execFileSync(program, [String(1000 * seconds)], { input: operands, encoding: "utf8" });
    const [face, whole] = printed.trim().split("\n").map(Number);
    return [time(() => outerFace(a, b)) / face, time(() => region(a, b)) / whole];
  });
  return [0, 1].map((k) => median(found.map((ratios) => ratios[k])));
}

const library = process.env.GCV_LIBRARY;
if (library) {
  const folder = mkdtempSync(join(tmpdir(), "gcv-"));
  const program = join(folder, "native");
  const [include, source] = [new URL("capi/include", root), new URL("native.c", import.meta.url)].map(fileURLToPath);
  const runPath = `-Wl,-rpath,${dirname(library)}`;
  execFileSync("cc", ["-std=c99", "-O2", `-I${include}`, source, library, runPath, "-o", program]);
  console.log("\n| pair | outer face : native | region : native |\n| --- | --- | --- |");
  for (const [name, ...files] of pairs.filter(([, ...files]) => files.every((file) => existsSync(file)))) {
    const ratios = nativeRatios(program, ...files.map(outerRing));
    console.log(`| ${name} | ${ratios.map((ratio) => ratio.toFixed(2)).join(" | ")} |`);
  }
  rmSync(folder, { recursive: true });
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { inspect } from "node:util";

import * as gcv from "gcv";
import { library } from "../dist/library.js";
import { check, withScratch } from "../dist/memory.js";

const square = [[0, 0], [1, 0], [1, 1], [0, 1]];

test("what was freed is not used any more", () => {
  const polygon = new gcv.Polygon(square);
  assert.equal(polygon.isFreed, false);
  assert.equal(polygon.vertices.length, 8);
  polygon.free();
  polygon.free();
  assert.equal(polygon.isFreed, true);
  for (const use of [
    () => polygon.vertices,
    () => polygon.area,
    () => gcv.minkowskiSum(polygon, square),
    () => new gcv.Polygon(polygon),
  ]) {
    assert.throws(use, /Polygon: it was freed/);
  }
});

test("objects are shown in words", () => {
  const polygon = new gcv.Polygon(square);
  const frame = new gcv.Polygon([[0, 0], [4, 0], [4, 4], [0, 4]], [[[1, 1], [2, 1], [2, 2], [1, 2]]]);
  const scene = new gcv.Scene(frame);
  const region = gcv.noFitRegion(frame, polygon);
  assert.equal(inspect(polygon), "<Polygon of 4 vertices>");
  assert.equal(inspect(frame), "<Polygon of 4 vertices with 1 hole>");
  assert.equal(inspect(gcv.minkowskiSum(frame, polygon)), "<OuterFace of 4 vertices>");
  assert.equal(inspect(region), "<Region of 1 polygon, 1 point>");
  assert.equal(inspect(gcv.innerFitRegion(polygon, frame)), "<Region of no parts>");
  assert.equal(inspect(scene), "<Scene of 0 members in a container>");
  const id = scene.add(polygon);
  assert.equal(inspect([scene]), "[ <Scene of 1 member in a container> ]");
  assert.equal(inspect(scene.pairs(1)), "<PairList of 1 pair>");
  assert.equal(inspect(gcv.contacts(polygon, polygon, [1, 0], 0)), "<ContactList of 6 contacts>");
  const objects = [polygon, region, scene, scene.pairs(1), scene.contacts(1)];
  assert.deepEqual(objects.flatMap(Object.keys), []);
  assert.equal(String(scene), "<Scene of 1 member in a container>");
  assert.equal(`${scene.pairs(1)}`, "<PairList of 1 pair>");
  scene.remove(id);
  polygon.free();
  assert.equal(inspect(polygon), "<Polygon, freed>");
});

test("results do not need what they were made from", () => {
  const polygon = new gcv.Polygon(square);
  const scene = new gcv.Scene(polygon);
  const region = gcv.minkowskiSumRegion(polygon, polygon);
  polygon.free();
  assert.equal(region.area, 4);
  assert.equal(scene.freeRegion(square).fitsToWKT(), "GEOMETRYCOLLECTION (POINT (0 0))");
});

test("dispose", { skip: typeof Symbol.dispose !== "symbol" }, () => {
  const polygon = new gcv.Polygon(square);
  polygon[Symbol.dispose]();
  assert.equal(polygon.isFreed, true);
});

// So many bytes that a leak at each turn would make the memory of the library grow.
const turns = 4000;
const large = Float64Array.from({ length: 2000 }, (_, k) =>
  (k % 2 === 0 ? Math.cos : Math.sin)((2 * Math.PI * (k >> 1)) / 1000),
);

function growth(work) {
  work();
  const before = library.memory.buffer.byteLength;
  for (let k = 0; k < turns; ++k) {
    work();
  }
  return library.memory.buffer.byteLength - before;
}

test("free gives memory back", () => {
  assert.equal(growth(() => new gcv.Polygon(large).free()), 0);
});

test("arguments that are no polygons yet end after a call, also after one that fails", () => {
  const fail = () => assert.throws(() => gcv.relation(large, [[0, 0]]), gcv.InputError);
  assert.equal(growth(fail), 0);
  assert.equal(growth(() => gcv.relation(large, square, [5, 5])), 0);
});

test("where memory runs out, the message names what gives it back", () => {
  const fails = { name: "GcvError", status: gcv.Status.NO_MEMORY, message: /; free\(\) ends objects at once/ };
  assert.throws(() => check(gcv.Status.NO_MEMORY), fails);
  assert.throws(() => withScratch((scratch) => scratch.room(2 ** 32)), fails);
});

test("what the garbage collector finds is freed", { skip: !globalThis.gc }, async () => {
  const turn = async () => {
    for (let k = 0; k < 100; ++k) {
      new gcv.Polygon(large);
    }
    globalThis.gc();
    await new Promise((done) => setTimeout(done, 10));
  };
  for (let k = 0; k < 3; ++k) {
    await turn();
  }
  const before = library.memory.buffer.byteLength;
  for (let k = 0; k < 20; ++k) {
    await turn();
  }
  assert.equal(library.memory.buffer.byteLength, before);
});

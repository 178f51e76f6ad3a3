// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a call uses is not freed and not changed before it returns.
import assert from "node:assert/strict";
import { test } from "node:test";

import * as gcv from "gcv";

const square = (size) => new gcv.Polygon([[0, 0], [size, 0], [size, size], [0, size]]);
const bracket = () => new gcv.Polygon([[0, 0], [5, 0], [5, 1], [1, 1], [1, 5], [0, 5]]);

function objectsOfCalls() {
  const [a, b, scene] = [bracket(), square(2), new gcv.Scene(square(50))];
  scene.addMany([b, b, a, a], [[0, 0], [4, 0], [2, 2], [6, 2]]);
  const [face, region] = [gcv.minkowskiSum(a, b), gcv.minkowskiSumRegion(a, b)];
  return { a, b, face, region, scene, pairs: scene.pairs(1), contacts: scene.contacts(1) };
}

// Each function that reports progress, and the names of all objects that it uses.
const [origin, places] = [[0, 0], [[0, 0], [1, 1], [2, 5]]];
const calls = [
  ["a b", ({ a, b }, options) => gcv.minkowskiSum(a, b, options)],
  ["face region", ({ face, region }, options) => gcv.minkowskiSum(face, region, options)],
  ["a b", ({ a, b }, options) => gcv.noFitPolygon(a, b, origin, options)],
  ["a b", ({ a, b }, options) => gcv.entranceBlock(a, b, origin, options)],
  ["a b", ({ a, b }, options) => gcv.minkowskiSumRegion(a, b, options)],
  ["a b", ({ a, b }, options) => gcv.noFitRegion(a, b, origin, options)],
  ["a b", ({ a, b }, options) => gcv.entranceRegion(a, b, origin, options)],
  ["a b", ({ a, b }, options) => gcv.innerFitRegion(a, b, origin, options)],
  ["a b", ({ a, b }, options) => gcv.minkowskiSumMany([a, b], [b, b], options)],
  ["face region", ({ face, region }, options) => gcv.minkowskiSumMany([face], [region], options)],
  ["a b", ({ a, b }, options) => gcv.noFitPolygonMany([a, b], [b, b], places.slice(1), options)],
  ["a b", ({ a, b }, options) => gcv.minkowskiSumRegionMany([a, b], [b, b], options)],
  ["a b", ({ a, b }, options) => gcv.noFitRegionMany([a, b], [b, b], null, options)],
  ["a", ({ a }, options) => gcv.offset(a, 1, 0.1, options)],
  ["region", ({ region }, options) => gcv.offset(region, -0.1, 0.01, options)],
  ["a b", ({ a, b }, options) => gcv.relation(a, b, places, options)],
  ["a b", ({ a, b }, options) => gcv.distance(a, b, places, options)],
  ["a b", ({ a, b }, options) => gcv.cast(a, b, places, [-3, -3], options)],
  ["a b", ({ a, b }, options) => gcv.penetration(a, b, places, options)],
  ["a b", ({ a, b }, options) => gcv.contacts(a, b, origin, 1, 0, options)],
  ["scene b", ({ scene, b }, options) => scene.relation(b, places, options)],
  ["scene region", ({ scene, region }, options) => scene.relation(region, places, options)],
  ["scene b", ({ scene, b }, options) => scene.distance(b, places, options)],
  ["scene b", ({ scene, b }, options) => scene.cast(b, places, [-3, -3], options)],
  ["scene b", ({ scene, b }, options) => scene.penetration(b, places, options)],
  ["scene b", ({ scene, b }, options) => scene.near(b, origin, 1, options)],
  ["scene b", ({ scene, b }, options) => scene.freeRegion(b, null, options)],
  ["scene b", ({ scene, b }, options) => scene.best(b, [-1, 0], options)],
  ["scene pairs", ({ scene, pairs }, options) => scene.pairs(1, pairs, options)],
  ["scene contacts", ({ scene, contacts }, options) => scene.contacts(1, 0, contacts, options)],
];

const refusal = (object, what) => ({
  name: "InputError",
  status: gcv.Status.INVALID_ARGUMENT,
  message: `${object.constructor.name}: it is in use by a call that has not returned, and cannot be ${what}`,
});

const ways = [(object) => object.free()];
if (typeof Symbol.dispose === "symbol") {
  ways.push((object) => object[Symbol.dispose]());
}

for (const [names, call] of calls) {
  const title = String(call).replace(/^.*=> /, "");

  test(`what is freed only after ${title}`, () => {
    const objects = objectsOfCalls();
    const expected = JSON.stringify(call(objects, {}));
    for (const object of names.split(" ").map((name) => objects[name])) {
      for (const free of ways) {
        // At each report: an error that progress throws ends the call, one that it catches does not.
        let reports = 0;
        const progress = () => {
          ++reports;
          assert.throws(() => free(object), refusal(object, "freed"));
          assert.equal(object.isFreed, false);
        };
        assert.equal(JSON.stringify(call(objects, { progress })), expected);
        for (let last = 1; last <= reports; ++last) {
          let left = last;
          const freeing = () => void (--left === 0 && free(object));
          assert.throws(() => call(objects, { progress: freeing }), refusal(object, "freed"));
        }
        assert.ok(reports >= 2);
      }
      assert.equal(JSON.stringify(call(objects, {})), expected);
    }
    for (const object of Object.values(objects)) {
      object.free();
      assert.equal(object.isFreed, true);
    }
  });

  if (names.startsWith("scene")) {
    test(`what changes a scene only after ${title}`, () => {
      const objects = objectsOfCalls();
      const { a, scene } = objects;
      const expected = JSON.stringify(call(objects, {}));
      for (const change of [
        () => scene.add(a),
        () => scene.add(a, places),
        () => scene.addMany([a], [origin]),
        () => scene.addMany([], []),
        () => scene.move(2, [9, 9]),
        () => scene.setPolygon(2, a),
        () => scene.setMany([2], [a], [[9, 9]]),
        () => scene.setLayers(2, 0),
        () => scene.remove(scene.ids),
        () => scene.setContainer(null),
        () => (scene.container = a),
      ]) {
        assert.throws(() => call(objects, { progress: () => void change() }), refusal(scene, "changed"));
        const progress = () => assert.throws(change, refusal(scene, "changed"));
        assert.equal(JSON.stringify(call(objects, { progress })), expected);
      }
      scene.remove(scene.ids);
      assert.equal(scene.size, 0);
    });
  }
}

test("what is in use can be read and asked, and other objects freed and changed", () => {
  const objects = objectsOfCalls();
  const { scene, contacts } = objects;
  const expected = JSON.stringify(contacts);
  const inner = calls.map(([, call]) => JSON.stringify(call(objects, {})));
  const progress = () => {
    assert.deepEqual(calls.map(([, call]) => JSON.stringify(call(objects, {}))), inner);
    const copy = scene.copy();
    copy.remove(copy.ids);
    copy.setContainer(objects.a);
    copy.free();
    assert.equal(scene.size, 4);
    // The calls inside have returned, this one has not.
    for (const object of [scene, contacts]) {
      assert.throws(() => object.free(), refusal(object, "freed"));
    }
    objects.a.free();
    objects.b.free();
    objects.a = bracket();
    objects.b = square(2);
  };
  assert.equal(JSON.stringify(scene.contacts(1, 0, contacts, { progress })), expected);
});

test("what a call used that failed can be freed", () => {
  const stop = () => {
    throw new RangeError("enough");
  };
  for (const [, call] of calls) {
    const objects = objectsOfCalls();
    assert.throws(() => call(objects, { progress: stop }), RangeError);
    assert.throws(() => call(objects, { progress: () => true }), gcv.CancelledError);
    assert.throws(() => call(objects, { progress: 5 }), gcv.InputError);
    assert.throws(() => call(objects, { signal: { throwIfAborted: stop } }), RangeError);
    Object.values(objects).forEach((object) => object.free());
  }
  const { a, scene, pairs } = objectsOfCalls();
  assert.throws(() => gcv.minkowskiSum(a, [[0, 0]]), gcv.InputError);
  assert.throws(() => gcv.minkowskiSumMany([a], []), gcv.InputError);
  assert.throws(() => scene.near(a, [NaN, 0]), gcv.InputError);
  assert.throws(() => new gcv.Scene().pairs(0, pairs), gcv.InputError);
  assert.throws(() => scene.addMany([a, 5], places), gcv.InputError);
  [a, scene, pairs].forEach((object) => object.free());
});

test("nor are they freed by what a call reads", () => {
  const freeing = (object, value) => ({ get: () => (object.free(), value), enumerable: true });
  for (const [names, call] of calls) {
    const objects = objectsOfCalls();
    for (const object of names.split(" ").map((name) => objects[name])) {
      const signal = { aborted: false, throwIfAborted: () => object.free() };
      assert.throws(() => call(objects, { signal }), refusal(object, "freed"));
    }
  }
  const { a, b, scene } = objectsOfCalls();
  const place = Object.defineProperty([0, 0], 0, freeing(a, 0));
  assert.throws(() => gcv.relation(a, b, place), refusal(a, "freed"));
  assert.throws(() => scene.add(a, [place, [1, 1]]), refusal(a, "freed"));
  const ring = Object.defineProperty([], 0, freeing(a, 0));
  assert.throws(() => gcv.minkowskiSum(a, ring), { message: /^b: Polygon: it is in use/ });
  assert.throws(() => gcv.minkowskiSumMany([a], [ring]), { message: /^b\[0\]: Polygon: it is in use/ });
  const freed = { name: "InputError", message: /^(Polygon|Scene): it was freed/ };
  assert.throws(() => a.affine(Object.defineProperty([1, 0, 0, 0, 1, 0], 2, freeing(a, 0))), freed);
  assert.throws(() => scene.add(b, [Object.defineProperty([0, 0], 0, freeing(scene, 0))]), freed);
});

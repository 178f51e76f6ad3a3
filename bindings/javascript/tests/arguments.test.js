// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Arguments that are not what they should be: each is refused by its name.
import assert from "node:assert/strict";
import { test } from "node:test";

import * as gcv from "gcv";

const square = new gcv.Polygon([[0, 0], [1, 0], [1, 1], [0, 1]]);
const scene = new gcv.Scene(new gcv.Polygon("M 0 0 H 9 V 9 H 0 Z"));
scene.add(square, [[0, 0], [5, 5]]);

function refuses(cases) {
  for (const [call, message] of cases) {
    assert.throws(
      call,
      { name: "InputError", status: gcv.Status.INVALID_ARGUMENT, message },
      String(call),
    );
  }
  assert.deepEqual(scene.ids, [2, 3]);
}

test("elements that are missing", () => {
  const pairs = [[0, 0], , [1, 1], [0, 1]];
  const polygons = [square, , square];
  const none = "undefined is not a polygon, and none can be made from it";
  refuses([
    [() => new gcv.Polygon(pairs), "polygon: vertex 1: undefined is not a pair of numbers"],
    [() => new gcv.Polygon(square, polygons.slice(1)), `polygon: hole 0: ${none}`],
    [() => new gcv.Polygon({ type: "Polygon", coordinates: [pairs] }), /^polygon: vertex 1: undefined/],
    [() => new gcv.Polygon({ type: "Polygon", coordinates: [[], , []] }), /undefined in a geometry is not a list/],
    [() => gcv.Polygon.many(polygons), `polygon 1: ${none}`],
    [() => gcv.minkowskiSumMany(polygons, polygons), `a[1]: ${none}`],
    [() => gcv.relation(square, square, pairs), "translation[1]: undefined is not a pair of numbers"],
    [() => gcv.noFitPolygonMany([square], [square], [,]), /^references\[0\]: undefined is not/],
    [() => scene.addMany(polygons, [[0, 0], [1, 1], [2, 2]]), `polygons[1]: ${none}`],
    [() => scene.addMany([square, square], [[0, 0], ,]), /^positions\[1\]: undefined is not/],
    [() => scene.remove([2, , 3]), "ids[1]: undefined is not an id"],
  ]);
  const results = gcv.Polygon.many(polygons, { returnErrors: true });
  assert.deepEqual(Object.keys(results), ["0", "1", "2"]);
});

test("what is no array of polygons", () => {
  refuses([
    [() => new gcv.Polygon(square, 5), "holes: 5 is not an array of polygons"],
    [() => new gcv.Polygon(square, null), "holes: null is not an array of polygons"],
    [() => gcv.Polygon.many(null), "sources: null is not an array of polygons"],
    [() => gcv.Polygon.many({}), "sources: {} is not an array of polygons"],
    [() => gcv.minkowskiSumMany(square, square), "a: <Polygon of 4 vertices> is not an array of polygons"],
    [() => new gcv.Polygon(Buffer.from("M 0 0 H 9 V 9 Z")), /is not a polygon, and none can be made/],
    [() => new gcv.Polygon(scene), /^polygon: <Scene of 2 members in a container> is not a polygon/],
    [() => gcv.noFitRegionMany([], 5n), "moving: 5n is not an array of polygons"],
    [() => scene.addMany(null, []), "polygons: null is not an array of polygons"],
    [() => scene.setMany([2], 5, [[0, 0]]), "polygons: 5 is not an array of polygons"],
  ]);
  const freed = square.translated([0, 0]);
  freed.free();
  refuses([[() => gcv.minkowskiSumMany(freed, []), "a: <Polygon, freed> is not an array of polygons"]]);
});

test("arrays whose buffers were transferred", () => {
  const points = Float64Array.of(0, 0, 1, 0, 0, 1);
  structuredClone(points.buffer, { transfer: [points.buffer] });
  const lost = "an array that has lost its buffer is not";
  refuses([
    [() => new gcv.Polygon(points), `polygon: ${lost} a polygon, and none can be made from it`],
    [() => new gcv.Polygon([points]), `polygon: vertex 0: ${lost} a pair of numbers`],
    [() => gcv.relation(square, square, points), `translation: ${lost} a pair of numbers, nor an array of pairs`],
    [() => square.translated(points), `vector: ${lost} a pair of numbers`],
    [() => scene.remove(points), `ids: ${lost} an id, nor an array of them`],
  ]);
  assert.throws(() => new gcv.Polygon(new Float64Array()), { status: gcv.Status.DEGENERATE });
});

test("what is no id", () => {
  const what = "is not an id, nor an array of them";
  refuses([
    [() => scene.move(2n, [0, 0]), `ids: 2n ${what}`],
    [() => scene.move("2", [0, 0]), `ids: "2" ${what}`],
    [() => scene.move([2, 3n], [[0, 0], [1, 1]]), "ids[1]: 3n is not an id"],
    [() => scene.remove(undefined), `ids: undefined ${what}`],
    [() => scene.setLayers({}, 1), `ids: {} ${what}`],
    [() => scene.polygon([2]), "id: [2] is not an id"],
    [() => scene.position(-1), "id: -1 is not an id"],
    [() => scene.relation(square, [0, 0], { ignore: "a" }), `ignore: "a" ${what}`],
    [() => scene.pairs(0, null, { ignore: null }), `ignore: null ${what}`],
  ]);
});

test("options that there are not", () => {
  const point = [0, 0];
  const call = "progress, signal";
  const query = `${call}, layers, ignore`;
  const sum = `${call}, rounding, tolerance`;
  const cases = [
    [(options) => gcv.Polygon.many([], options), "returnErrors"],
    [(options) => gcv.Polygon.disc(point, 1, 0.1, options), "rounding"],
    [(options) => square.simplified(0, options), "rounding"],
    [(options) => gcv.minkowskiSum(square, square, options), sum],
    [(options) => gcv.entranceBlock(square, square, point, options), sum],
    [(options) => gcv.noFitRegion(square, square, point, options), `${sum}, leaveOut`],
    [(options) => gcv.minkowskiSumMany([], [], options), `${sum}, returnErrors`],
    [(options) => gcv.noFitRegionMany([], [], [], options), `${sum}, leaveOut, returnErrors`],
    [(options) => gcv.offset(square, 1, 0.1, options), call],
    [(options) => gcv.relation(square, square, point, options), call],
    [(options) => gcv.cast(square, square, point, point, options), call],
    [(options) => gcv.penetration(square, square, point, options), `${call}, leaveOut`],
    [(options) => gcv.contacts(square, square, point, 0, 0, options), call],
    [(options) => scene.distance(square, point, options), query],
    [(options) => scene.near(square, point, 0, options), query],
    [(options) => scene.pairs(0, null, options), query],
    [(options) => scene.contacts(0, 0, null, options), query],
    [(options) => scene.best(square, [1, 0], options), `${query}, leaveOut`],
    [(options) => scene.penetration(square, point, options), `${query}, leaveOut`],
    [(options) => scene.freeRegion(square, null, options), `${query}, leaveOut, rounding`],
  ];
  for (const [take, names] of cases) {
    refuses([
      [() => take({ bogus: 1 }), `options: "bogus" is not one of ${names}`],
      [() => take({ threads: 2 }), `options: "threads" is not one of ${names}`],
      [() => take(null), "options: null is not an object"],
      [() => take(5), "options: 5 is not an object"],
    ]);
  }
});

test("options that are not what they should be", () => {
  const take = (options) => gcv.minkowskiSumRegion(square, square, options);
  refuses([
    [() => take({ progress: 5 }), "progress: 5 is not a function"],
    [() => take({ progress: async () => true }), "progress: it gives a promise; only true at once ends a computation"],
    [() => take({ signal: 5 }), "signal: 5 is not an AbortSignal"],
    [() => take({ leaveOut: 5 }), "leaveOut: 5 is not one of holes, fits"],
    [() => take({ leaveOut: ["fits", null] }), "leaveOut: null is not one of holes, fits"],
    [() => take({ rounding: null }), "rounding: null is not one of nearest, outward"],
    [() => take({ tolerance: null }), "tolerance: null is not a number"],
  ]);
  const all = { leaveOut: ["holes", "fits"], rounding: "outward", tolerance: 0, signal: undefined };
  assert.equal(take(all).area, 4);
});

test("earlier lists of another kind", () => {
  refuses([
    [() => scene.pairs(0, 5), "previous: 5 is not a PairList"],
    [() => scene.pairs(0, scene.contacts()), "previous: <ContactList of 4 contacts> is not a PairList"],
    [() => scene.contacts(0, 0, []), "previous: [] is not a ContactList"],
    [() => scene.contacts(0, 0, scene.pairs()), "previous: <PairList of 1 pair> is not a ContactList"],
  ]);
});

test("messages of the library have the names of arguments here", () => {
  const region = gcv.minkowskiSumRegion(square, square);
  const [bad, pairs] = [[NaN, 0], [[0, 0], [NaN, 0]]];
  const notFinite = "number 0 is (nan, 0), not finite";
  const cases = [
    [() => gcv.relation(square, square, bad), `translation: ${notFinite}`],
    [() => gcv.distance(square, square, pairs), "translation: number 1 is (nan, 0), not finite"],
    [() => gcv.cast(square, square, [0, 0], bad), `motion: ${notFinite}`],
    [() => scene.cast(square, [0, 0], bad), `motions: ${notFinite}`],
    [() => region.locate(bad), "points: the x coordinate of point 0 is nan, not a finite number"],
    [() => region.polygon(7), "number is 7, the region has 1 polygons"],
    [() => scene.position(9), "id is 9, not that of a member"],
  ];
  for (const [call, message] of cases) {
    assert.throws(call, { name: "InputError", message }, String(call));
  }
});

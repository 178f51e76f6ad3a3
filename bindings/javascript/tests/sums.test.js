// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";

import * as gcv from "gcv";

const square = (size) => [[0, 0], [size, 0], [size, size], [0, size]];
const sheet = new gcv.Polygon(square(9), [
  [[1, 1], [4, 1], [4, 4], [1, 4]],
  [[5, 3], [8, 3], [8, 5], [5, 5]],
]);
const star = (points) =>
  Float64Array.from({ length: 2 * points }, (_, k) => {
    const vertex = k >> 1;
    const angle = (2 * Math.PI * vertex) / points;
    return (vertex % 2 === 0 ? 5 : 1) * (k % 2 === 0 ? Math.cos(angle) : Math.sin(angle));
  });

test("outer faces", () => {
  const face = gcv.minkowskiSum(square(1), square(2));
  assert.deepEqual(face.vertices, Float64Array.of(0, 0, 3, 0, 3, 3, 0, 3));
  assert.equal(face.area, 9);
  assert.equal(face.errorBound, 0);
  assert.deepEqual(face.bounds, [0, 0, 3, 3]);
  assert.deepEqual(face.exact[1], [
    { numerator: 3n, denominator: 1n },
    { numerator: 0n, denominator: 1n },
  ]);
  assert.deepEqual(face.exactIndices, [0, 1, 2, 3]);
  assert.deepEqual(face.sources[0], { kind: gcv.EdgeKind.TRANSLATED_CORNER, a: 0, b: 0 });
  assert.ok(face.stats.predicatesFiltered > 0);
  assert.equal(face.toWKT(), "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))");
  assert.equal(face.toSVGPath(), "M 0 0 L 3 0 L 3 3 L 0 3 Z");
  assert.equal(face.toGeoJSON().coordinates[0].length, 5);
  assert.equal(`${face}`, face.toWKT());
  assert.deepEqual(JSON.parse(JSON.stringify({ face })), { face: face.toGeoJSON() });
  assert.ok(face.equals(gcv.minkowskiSum(square(2), square(1))));
  assert.ok(!face.equals(null));
  assert.deepEqual(gcv.noFitPolygon(square(1), square(2), [1, 1]).bounds, [-1, -1, 2, 2]);
  assert.deepEqual(gcv.entranceBlock(square(1), square(2), [1, 1]).bounds, [0, 0, 3, 3]);
});

test("regions", () => {
  const region = gcv.noFitRegion(sheet, square(2));
  assert.equal(
    region.toWKT(),
    "MULTIPOLYGON (((-2 -2, 9 -2, 9 9, -2 9, -2 -2), (1 1, 1 2, 2 2, 2 1, 1 1)))",
  );
  assert.equal(region.fitsToWKT(), "GEOMETRYCOLLECTION (LINESTRING (5 3, 6 3))");
  assert.deepEqual(region.segments, [Float64Array.of(5, 3, 6, 3)]);
  assert.deepEqual(region.points, []);
  assert.equal(region.polygons.length, 1);
  assert.equal(region.polygons[0].length, 2);
  assert.deepEqual(
    region.parts.map(({ kind, polygon, start, stop }) => [kind, polygon, start, stop]),
    [[1, 0, 0, 4], [2, 0, 4, 8], [3, null, 8, 10]],
  );
  assert.deepEqual(region.exactParts, region.parts);
  assert.equal(region.exact.length, 10);
  assert.deepEqual(region.exactIndices, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
  assert.equal(region.sources.at(-1).kind, gcv.EdgeKind.NONE);
  assert.ok(region.owners.every((owner) => owner === 0));
  assert.equal(region.area, 120);
  assert.equal(region.errorBound, 0);
  assert.deepEqual(region.bounds, [-2, -2, 9, 9]);
  assert.equal(region.stats.partsDropped, 0);
  assert.equal(region.toGeoJSON().type, "GeometryCollection");
  assert.equal(region.toGeoJSON().geometries.length, 2);
  assert.equal(String(region), region.toWKT());
  assert.equal(JSON.stringify(region), JSON.stringify(region.toGeoJSON()));
  assert.ok(!region.equals(undefined));
  assert.equal(region.locate([5.5, 3]), gcv.Location.BOUNDARY);
  assert.deepEqual(region.locate([[1.5, 1.5], [1, 2], [7, 7]]), Int8Array.of(-1, 0, 1));
  assert.equal(region.polygon(0).area, 120);
  assert.throws(() => region.polygon(1), gcv.InputError);
  assert.throws(() => new gcv.Polygon(region), /1 polygons and 1 fits/);
  assert.ok(region.equals(gcv.entranceRegion(square(2), sheet)));
  assert.equal(gcv.noFitRegion(sheet, square(2), [0, 0], { leaveOut: "fits" }).segments.length, 0);
  const bare = gcv.minkowskiSumRegion(sheet, square(1), { leaveOut: ["holes", "fits"] });
  assert.equal(bare.parts.length, 1);
  assert.equal(bare.toGeoJSON().type, "MultiPolygon");
});

test("inner fits", () => {
  const slot = [[0, 0], [5, 0], [5, 2], [0, 2]];
  assert.equal(
    gcv.innerFitRegion(slot, square(2)).fitsToWKT(),
    "GEOMETRYCOLLECTION (LINESTRING (0 0, 3 0))",
  );
  const none = gcv.innerFitRegion(slot, square(3));
  assert.ok(none.isEmpty);
  assert.equal(none.bounds, null);
  assert.equal(none.toWKT(), "MULTIPOLYGON EMPTY");
  assert.equal(none.toSVGPath(), "");
  assert.equal(none.exact.length, 0);
  assert.throws(() => gcv.innerFitRegion(slot, square(2), [0, 0], { tolerance: 1 }), gcv.InputError);
});

test("many pairs", () => {
  const faces = gcv.minkowskiSumMany([square(1), square(2)], [square(3), square(3)]);
  assert.deepEqual(faces.map((face) => face.area), [16, 25]);
  const huge = [[0, 0], [1.7e308, 0], [0, 1.7e308]];
  const results = gcv.minkowskiSumMany([square(1), huge, []], [square(1), huge, square(1)], {
    returnErrors: true,
  });
  assert.equal(results[0].area, 4);
  assert.equal(results[1].status, gcv.Status.RANGE);
  assert.match(results[1].message, /pair 1/);
  assert.match(results[2].message, /^a\[2\]: /);
  assert.throws(() => gcv.minkowskiSumMany([huge], [huge]), /pair 0/);
  assert.throws(() => gcv.minkowskiSumMany([huge], []), /a has 1 elements and b has 0/);
  const placed = gcv.noFitPolygonMany([square(1), square(1)], [square(1), square(1)], [[0, 0], [5, 0]]);
  assert.deepEqual(placed.map((face) => face.bounds[0]), [-1, 4]);
  const atOrigin = gcv.noFitPolygonMany([square(1)], [square(1)], null);
  assert.deepEqual(atOrigin[0].bounds, [-1, -1, 1, 1]);
  assert.equal(gcv.minkowskiSumRegionMany([sheet], [square(1)])[0].polygons.length, 1);
  assert.equal(gcv.noFitRegionMany([sheet], [square(2)])[0].segments.length, 1);
  assert.deepEqual(gcv.minkowskiSumMany([], []), []);
});

test("options", () => {
  const [a, b] = [star(40), star(30)];
  const exact = gcv.minkowskiSum(a, b);
  const outward = gcv.minkowskiSum(a, b, { rounding: "outward", tolerance: 0.5 });
  assert.ok(outward.area >= exact.area);
  assert.ok(outward.errorBound <= 0.51);
  assert.throws(() => gcv.minkowskiSum(a, b, { rounding: "up" }), /rounding: "up"/);
  assert.throws(() => gcv.minkowskiSum(a, b, { tolerance: -1 }), gcv.InputError);
  assert.throws(() => gcv.minkowskiSumRegion(a, b, { leaveOut: "walls" }), /leaveOut: "walls"/);
  assert.throws(() => gcv.noFitPolygon(a, b, [0, NaN]), { status: gcv.Status.NOT_FINITE });
  assert.throws(() => gcv.noFitPolygon(a, b, [0]), /reference: \[0\] is not a pair of numbers/);
});

test("progress, and how it ends a computation", () => {
  const [a, b] = [star(60), star(50)];
  const calls = [];
  gcv.minkowskiSum(a, b, { progress: (done, estimate) => void calls.push([done, estimate]) });
  assert.ok(calls.length >= 2 && calls.every(([done, estimate]) => done <= estimate));
  assert.throws(() => gcv.minkowskiSum(a, b, { progress: () => true }), gcv.CancelledError);
  const fail = () => {
    throw new RangeError("enough");
  };
  assert.throws(() => gcv.minkowskiSum(a, b, { progress: fail }), RangeError);
  const controller = new AbortController();
  const abort = () => controller.abort(new Error("stopped"));
  assert.throws(() => gcv.minkowskiSum(a, b, { progress: abort, signal: controller.signal }), {
    message: "stopped",
  });
  assert.throws(() => gcv.minkowskiSum(a, b, { signal: controller.signal }), { message: "stopped" });
  const nested = { progress: () => void gcv.minkowskiSum(square(1), square(1)) };
  assert.ok(gcv.minkowskiSum(a, b, nested).area > 0);
});

test("supersets and the version", () => {
  const edges = gcv.superset(square(1), square(2));
  assert.equal(edges.length, 4);
  assert.ok(edges.every(({ source }) => source.kind === gcv.EdgeKind.TRANSLATED_CORNER));
  assert.match(gcv.libraryVersion(), /^\d+\.\d+\.\d+$/);
});

test("clearances", () => {
  const grown = gcv.offset(sheet, 0.5, 0.01);
  assert.deepEqual(grown.polygons.map((rings) => rings.length), [3]);
  // (-0.3, -0.4) is at the distance from a corner.
  const places = grown.locate([[-0.3, -0.4], [-0.5, 3], [-0.31, -0.42], [1.5, 3], [1.52, 3]]);
  assert.ok(places[0] >= 0 && places[1] >= 0 && places[3] >= 0);
  assert.deepEqual([places[2], places[4]], [-1, -1]);
  const shrunk = gcv.offset(square(4), -1, 0.01);
  assert.ok(shrunk.bounds[0] >= 1 && shrunk.area > 3.9 && shrunk.area <= 4);
  assert.equal(gcv.offset(square(4), -2, 0.01).polygons.length, 0);
  assert.ok(grown.errorBound <= 0.01 / 16 && gcv.offset(sheet, 2, 0.1).polygons[0].length === 1);

  const { INVALID_ARGUMENT: unfit, NOT_FINITE: endless } = gcv.Status;
  for (const [distance, status] of [
    [0, unfit],
    [NaN, endless],
    [Infinity, endless],
    ["1", unfit],
  ]) {
    const message = /^distance: .* is not a /;
    assert.throws(() => gcv.offset(sheet, distance, 0.01), { message, status });
  }
  for (const [tolerance, status] of [
    [0, unfit],
    [-1, unfit],
    [NaN, endless],
    [undefined, unfit],
  ]) {
    const message = /^tolerance: .* is not a /;
    assert.throws(() => gcv.offset(sheet, 1, tolerance), { message, status });
  }
  const far = new gcv.Polygon(square(1)).translated([1e9, 0]);
  for (const [polygon, tolerance, reason] of [
    [far, 1e-7, "the roundings of these coordinates to doubles"],
    [sheet, 3e-14, "a distance of 0.3: its disc has too many vertices"],
    [sheet, 1e-17, "a distance of 0.3: its disc has too many vertices"],
  ]) {
    assert.throws(() => gcv.offset(polygon, 0.3, tolerance), {
      name: "InputError",
      message: `tolerance: ${tolerance} is too small for ${reason}`,
    });
  }
  assert.throws(() => gcv.offset([[0, 0]], 1, 0.1), { message: /^polygon: / });
  assert.throws(() => gcv.offset(star(99), 1, 0.1, { progress: () => true }), gcv.CancelledError);
});

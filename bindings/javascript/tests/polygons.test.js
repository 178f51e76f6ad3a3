// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";

import { GcvError, InputError, Polygon, Status, minkowskiSum, minkowskiSumRegion, offset, pairsOf } from "gcv";

const plate = [[0, 0], [6, 0], [6, 4], [0, 4]];
const hole = [[1, 1], [3, 1], [3, 3]];
const wkt = "POLYGON ((0 0, 6 0, 6 4, 0 4, 0 0), (1 1, 3 3, 3 1, 1 1))";

const fails = (make, Kind, status, message) =>
  assert.throws(make, (error) => {
    assert.ok(error instanceof Kind && error instanceof GcvError, String(error));
    assert.equal(error.status, status);
    assert.match(error.message, message);
    return true;
  });

test("a polygon from every kind of source", () => {
  const geometry = { type: "Polygon", coordinates: [[...plate, [0, 0]], [...hole, [1, 1]]] };
  const sources = [
    wkt,
    "multipolygon (((0 0, 6 0, 6 4, 0 4), (1 1, 3 1, 3 3)))",
    "POLYGON Z ((0 0 9, 6 0 9, 6 4 9, 0 4 9), (1 1 9, 3 1 9, 3 3 9))",
    "M 0,0 H6V4 H 0 Z M 1 1 L 3 1 3 3 z",
    "m0 0 6 0 0 4h-6zm1 1 2 0 0 2z",
    geometry,
    JSON.stringify(geometry),
    `\ufeff${wkt}`,
    `\ufeff${JSON.stringify(geometry)}`,
    "MULTIPOLYGON (EMPTY, ((0 0, 6 0, 6 4, 0 4), (1 1, 3 1, 3 3)), EMPTY , EMPTY)",
    { type: "MultiPolygon", coordinates: [geometry.coordinates] },
    { type: "MultiPolygon", coordinates: [[], geometry.coordinates, []] },
    { type: "Feature", geometry },
    { type: "FeatureCollection", features: [{ type: "Feature", geometry }] },
  ];
  const expected = new Polygon(plate, [hole]);
  for (const source of sources) {
    assert.ok(new Polygon(source).equals(expected), JSON.stringify(source));
  }
  for (const ring of [Float64Array.from(plate.flat()), Int32Array.from(plate.flat())]) {
    assert.ok(new Polygon(ring, [new Polygon(hole)]).equals(expected));
  }
  assert.ok(new Polygon(expected).equals(expected));
  assert.equal(new Polygon(new Polygon(plate), [hole]).toWKT(), wkt);
});

test("what a polygon tells", () => {
  const polygon = new Polygon(plate, [hole]);
  assert.deepEqual(polygon.vertices, Float64Array.of(0, 0, 6, 0, 6, 4, 0, 4));
  assert.deepEqual(polygon.holes, [Float64Array.of(1, 1, 3, 3, 3, 1)]);
  assert.equal(polygon.rings, polygon.rings);
  assert.equal(polygon.area, 22);
  assert.deepEqual(polygon.bounds, [0, 0, 6, 4]);
  assert.equal(polygon.toWKT(), wkt);
  assert.equal(polygon.toSVGPath(), "M 0 0 L 6 0 L 6 4 L 0 4 Z M 1 1 L 3 3 L 3 1 Z");
  assert.ok(new Polygon(polygon.toSVGPath()).equals(polygon));
  assert.ok(new Polygon(polygon.toGeoJSON()).equals(polygon));
  assert.equal(String(polygon), wkt);
  assert.equal(JSON.stringify(polygon), JSON.stringify(polygon.toGeoJSON()));
  assert.ok(new Polygon(JSON.stringify(polygon)).equals(polygon));
  assert.ok(!polygon.equals(new Polygon(plate)));
  assert.ok(!polygon.equals(wkt));
});

test("what is made of a polygon", () => {
  const polygon = new Polygon(plate);
  assert.deepEqual(polygon.translated([1, 2]).bounds, [1, 2, 7, 6]);
  assert.deepEqual(polygon.negated().bounds, [-6, -4, 0, 0]);
  assert.deepEqual(polygon.affine([0, -1, 0, 1, 0, 0]).bounds, [-4, 0, 0, 6]);
  const rows = [[0, -1, 0], [1, 0, 0]];
  fails(() => polygon.affine(rows), InputError, Status.INVALID_ARGUMENT, /^matrix: .* is not 6 numbers/);
  const endless = [1, 0, 0, 0, 1, Infinity];
  fails(() => polygon.affine(endless), InputError, Status.NOT_FINITE, /^matrix: number 5 is Infinity/);
  fails(() => polygon.translated([0, NaN]), InputError, Status.NOT_FINITE, /^vector: number 1 is NaN/);
  const { polygon: simple, errorBound } = new Polygon([...plate, [0, 2], [0.01, 1]]).simplified(0.1);
  assert.ok(simple.equals(polygon));
  assert.ok(errorBound > 0 && errorBound <= 0.1);
  const disc = Polygon.disc([1, 1], 2, 0.01, { rounding: "outward" });
  assert.ok(disc.area > 4 * Math.PI);
});

test("many polygons", () => {
  const made = Polygon.many([plate, wkt, "M 0 0 L 1 1", [[0, 0], [1, 0], [NaN, 1]]], {
    returnErrors: true,
  });
  assert.ok(made[0].equals(new Polygon(plate)));
  assert.equal(made[1].area, 22);
  assert.equal(made[2].status, Status.DEGENERATE);
  assert.match(made[3].message, /^polygon 3: .*vertex 2/);
  fails(() => Polygon.many([plate, []]), InputError, Status.DEGENERATE, /^polygon 1: /);
});

test("many polygons of a collection", () => {
  const triangle = [[0, 0], [1, 0], [0, 1]];
  const other = "((5 5, 6 5, 5 6), (5.25 5.25, 5.5 5.25, 5.25 5.5))";
  const point = { type: "Point", coordinates: [9, 9] };
  const polygons = Polygon.many([triangle, `POLYGON ${other}`]);
  const [first, second] = polygons.map((polygon) => polygon.toGeoJSON());
  const parts = { type: "MultiPolygon", coordinates: [first.coordinates, [], second.coordinates] };
  const features = [first, null, point, second].map((geometry) => ({ type: "Feature", geometry }));
  const collections = [
    `MULTIPOLYGON (((0 0, 1 0, 0 1)), EMPTY, ${other})`,
    `\ufeffPOLYGON Z ((0 0 9, 1 0 9, 0 1 9))\nPOLYGON ${other}`,
    `GEOMETRYCOLLECTION (POINT (0 0), MULTIPOINT ((1 1), EMPTY), POLYGON ((0 0, 1 0, 0 1)),
      POLYGON EMPTY, GEOMETRYCOLLECTION (LINESTRING (0 0, 1 1), MULTIPOLYGON (${other})))`,
    parts,
    JSON.stringify(parts),
    { type: "Feature", geometry: parts },
    { type: "FeatureCollection", features },
    { type: "GeometryCollection", geometries: [point, { type: "GeometryCollection", geometries: [first] }, second] },
  ];
  for (const collection of collections) {
    assert.deepEqual(Polygon.many(collection).map(String), polygons.map(String), JSON.stringify(collection));
  }
  for (const one of [polygons[1], first, JSON.stringify(first), "M 0 0 H 1 L 0 1 Z"]) {
    assert.ok(Polygon.many(one)[0].equals(new Polygon(one)));
  }
  for (const none of ["", "MULTIPOLYGON EMPTY", { type: "FeatureCollection", features: [] }]) {
    assert.deepEqual(Polygon.many(none), []);
  }
  const made = Polygon.many("MULTIPOLYGON (((0 0, 1 0, 0 1)), ((0 0, 1 x)))", { returnErrors: true });
  assert.ok(made[0].equals(polygons[0]));
  assert.equal(made[1].message, "polygon 1: byte 42: expected a number, found 'x'");
});

test("collections that are none", () => {
  const collection = { type: "GeometryCollection" };
  collection.geometries = [collection, collection];
  const point = { type: "Point", coordinates: [9, 9] };
  const cases = [
    ["LINESTRING (0 0, 1 1)", Status.PARSE, /^sources: byte 0: expected POLYGON, MULTIPOLYGON or/],
    ["GEOMETRYCOLLECTION ( CIRCLE (0 0))", Status.PARSE, /^sources: byte 21: expected a geometry/],
    ["GEOMETRYCOLLECTION (POINT (0 0)", Status.PARSE, /^sources: byte 31: expected ',' or '\)'/],
    ["MULTIPOLYGON (0 0)", Status.PARSE, /^sources: byte 14: expected '\('/],
    ["{", Status.PARSE, /^sources: GeoJSON text/],
    [collection, Status.INVALID_ARGUMENT, /^sources: this is nested too deeply/],
    [{ type: "GeometryCollection" }, Status.INVALID_ARGUMENT, /^sources: undefined in a geometry is not a list/],
    [{ type: "Feature", geometry: point }, Status.INVALID_ARGUMENT, /^polygon 0: a geometry of type "Point" is not/],
  ];
  for (const [source, status, message] of cases) {
    fails(() => Polygon.many(source), InputError, status, message);
  }
});

test("shapes as sources", () => {
  const face = minkowskiSum(plate, plate);
  assert.ok(new Polygon(face).equals(face.polygon()));
  const region = minkowskiSumRegion(new Polygon(plate, [hole]), [[0, 0], [0.5, 0], [0.5, 0.5]]);
  assert.ok(new Polygon(region).equals(region.polygon(0)));
  const two = offset("M 0 0 H 3 V 3 H 6 V 0 H 9 V 9 H 6 V 4 H 3 V 9 H 0 Z", -1, 0.1);
  const polygons = [two.polygon(0), two.polygon(1)].map(String);
  assert.deepEqual([...two].map(String), polygons);
  assert.deepEqual(Polygon.many(two).map(String), polygons);
});

test("sources that are no polygons", () => {
  const feature = { type: "Feature" };
  feature.geometry = { type: "FeatureCollection", features: [feature] };
  const cases = [
    [[[0, 0], [1, 0]], Status.DEGENERATE, /^polygon: /],
    [[[0, 0], [2, 0], [0, 2], [2, 2]], Status.NOT_SIMPLE, /edges 1 and 3/],
    [[[0, 0], [1, 0], [0, Infinity]], Status.NOT_FINITE, /vertex 2/],
    [[[0, 0], [1, 0], [0]], Status.INVALID_ARGUMENT, /vertex 2: \[0\] is not a pair of numbers/],
    [[[0, 0], [1, "0"], [0, 1]], Status.INVALID_ARGUMENT, /vertex 1/],
    [Float64Array.of(0, 0, 1), Status.INVALID_ARGUMENT, /3 numbers/],
    ["POLYGON ((0 0, 1 x))", Status.PARSE, /byte 17/],
    ["POLYGON ((0 0, 1 0x1, 0 1))", Status.PARSE, /byte/],
    ["POLYGON ((0 0, 1e400 0, 0 1))", Status.NOT_FINITE, /1e400/],
    ["M 0 0 L 1 0 C 1 1 0 1 0 0", Status.PARSE, /character 12: .*curves/],
    ["M 0 0 L 1", Status.PARSE, /the path ends/],
    ["MULTIPOLYGON (((0 0, 1 0, 0 1)), ((5 5, 6 5, 5 6)))", Status.INVALID_ARGUMENT, /MultiPolygon of 2 parts/],
    ["MULTIPOLYGON EMPTY", Status.INVALID_ARGUMENT, /a MultiPolygon of 0 parts is not one polygon/],
    [" MultiPolygon Z ( EMPTY )", Status.INVALID_ARGUMENT, /a MultiPolygon of 0 parts/],
    ["MULTIPOLYGON M (((0 0 7, 1 x 7)))", Status.PARSE, /byte 27: .*'x'/],
    ["MULTIPOLYGON (((0 0, 1 0, 0 1)) EMPTY)", Status.PARSE, /byte 32: expected ',' or '\)'/],
    ["MULTIPOLYGON (((0 0, 1 0, 0 1))), POLYGON EMPTY", Status.PARSE, /byte 32: expected the end of the text/],
    ["MULTIPOLYGON (((0 0, 1 0, 0 1), EMPTY))", Status.PARSE, /byte 32: expected '\(', found 'EMPTY'/],
    ["POLYGON ZM EMPTY", Status.DEGENERATE, /EMPTY has no vertices/],
    ["{", Status.PARSE, /GeoJSON/],
    [{ type: "Point", coordinates: [0, 0] }, Status.INVALID_ARGUMENT, /"Point" is not a polygon/],
    [{ type: 5n }, Status.INVALID_ARGUMENT, /a geometry of type 5n is not/],
    [{ type: "Polygon", coordinates: 5n }, Status.INVALID_ARGUMENT, /5n in a geometry is not a list/],
    [{ type: "MultiPolygon", coordinates: [] }, Status.INVALID_ARGUMENT, /0 parts/],
    [feature, Status.INVALID_ARGUMENT, /^polygon: a Feature that is in itself is not a polygon/],
    [5, Status.INVALID_ARGUMENT, /5 is not a polygon/],
    [null, Status.INVALID_ARGUMENT, /null is not a polygon/],
  ];
  for (const [source, status, message] of cases) {
    fails(() => new Polygon(source), InputError, status, message);
  }
  const { INVALID_ARGUMENT } = Status;
  fails(() => new Polygon(plate, hole), InputError, INVALID_ARGUMENT, /^polygon: hole 0: vertex 0: 1 is/);
  fails(() => new Polygon(plate, [hole, []]), InputError, Status.DEGENERATE, /^polygon: ring 2/);
  fails(() => minkowskiSum(plate, []), InputError, Status.DEGENERATE, /^b: /);
  fails(() => new Polygon(plate, [wkt]), InputError, Status.INVALID_ARGUMENT, /hole 0 has 2 rings/);
  fails(() => Polygon.disc([0, 0], -1, 1), InputError, Status.INVALID_ARGUMENT, /radius/);
  fails(() => new Polygon([[0, 0], [1e308, 0], [0, 1e308]]).area, GcvError, Status.RANGE, /./);
});

test("arrays of pairs come out, too", () => {
  const polygon = new Polygon(plate, [hole]);
  assert.deepEqual(pairsOf(polygon.vertices), plate);
  assert.deepEqual(pairsOf(polygon.holes[0]), [[1, 1], [3, 3], [3, 1]]);
  assert.deepEqual(pairsOf(plate), plate);
  assert.deepEqual(pairsOf(new Float64Array()), []);
  fails(() => pairsOf([0, 0]), InputError, Status.INVALID_ARGUMENT, /^coordinates\[0\]: 0 is not a pair/);
  fails(() => pairsOf(new Float64Array(3)), InputError, Status.INVALID_ARGUMENT, /3 numbers does not hold pairs/);
});

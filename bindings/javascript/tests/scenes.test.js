// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";

import { GcvError, InputError, Polygon, Relation, Scene, Status } from "gcv";

const square = (size) => new Polygon([[0, 0], [size, 0], [size, size], [0, size]]);
const { APART, TOUCHING, OVERLAPPING } = Relation;

test("members come, change and go", () => {
  const scene = new Scene(square(10));
  assert.equal(scene.add(square(1), [0, 0]), 2);
  assert.deepEqual(scene.add(square(1), [[2, 0], [4, 0]]), [3, 4]);
  assert.deepEqual(scene.addMany([square(2), square(3)], [[6, 0], [0, 5]]), [5, 6]);
  assert.deepEqual(scene.ids, [2, 3, 4, 5, 6]);
  assert.equal(scene.size, 5);
  assert.deepEqual([...scene], scene.ids);
  assert.deepEqual(scene.positions([3, 6]), Float64Array.of(2, 0, 0, 5));
  scene.move(3, [2, 1]);
  scene.move([2, 4], [[0, 1], [4, 1]]);
  assert.deepEqual(scene.position(4), [4, 1]);
  scene.setPolygon([2, 3], square(2));
  assert.equal(scene.polygon(3).area, 4);
  scene.setMany([2], [square(1)], [[0, 0]]);
  assert.equal(scene.polygon(2).area, 1);
  const copy = scene.copy();
  scene.remove([5, 6]);
  assert.deepEqual(scene.ids, [2, 3, 4]);
  assert.equal(copy.size, 5);
  assert.equal(scene.add(square(1), [8, 8]), 7);
});

test("the container is given back, as it was passed", () => {
  const given = square(10);
  const scene = new Scene(given);
  given.free();
  assert.equal(scene.container.toWKT(), square(10).toWKT());
  const copy = scene.copy();
  scene.setContainer([[0, 0], [4, 0], [0, 4]]);
  assert.throws(() => scene.setContainer([[0, 0]]), { name: "InputError", message: /^container: / });
  assert.equal(scene.container.area, 8);
  scene.setContainer(null);
  assert.equal(scene.container, null);
  scene.container = square(3);
  assert.equal(scene.container.area, 9);
  assert.throws(() => (scene.container = 5), { name: "InputError", message: /^container: 5 is not/ });
  scene.container = null;
  assert.equal(scene.freeRegion(square(1), [0, 0, 2, 2]).area, 4);
  scene.free();
  assert.throws(() => scene.container, InputError);
  assert.equal(copy.container.area, 100);
  assert.equal(new Scene().container, null);
});

test("changes that fail leave a scene as it was", () => {
  const scene = new Scene();
  scene.add(square(1));
  for (const change of [
    () => scene.remove([2, 3]),
    () => scene.remove([2, 2]),
    () => scene.move(2, [NaN, 0]),
    () => scene.move([2], [[0, 0], [1, 1]]),
    () => scene.move(2.5, [0, 0]),
    () => scene.add([[0, 0]], [0, 0]),
    () => scene.addMany([square(1)], [[0, 0], [1, 1]]),
    () => scene.setLayers(2, -1),
    () => scene.polygon(9),
    () => new Scene("POLYGON EMPTY"),
  ]) {
    assert.throws(change, InputError);
  }
  assert.deepEqual(scene.ids, [2]);
  assert.deepEqual(scene.position(2), [0, 0]);
});

test("questions", () => {
  const scene = new Scene(square(10));
  scene.add(square(2), [[0, 0], [4, 4]]);
  const part = square(1);
  assert.equal(scene.relation(part, [2.5, 2.5]), APART);
  assert.deepEqual(scene.relation(part, [[2, 0], [5, 5], [9.5, 0]]), [TOUCHING, OVERLAPPING, OVERLAPPING]);
  assert.equal(scene.relation(part, [5, 5], { ignore: 3 }), APART);
  scene.setLayers(3, 2);
  assert.equal(scene.relation(part, [5, 5], { layers: 1 }), APART);
  assert.equal(scene.relation(part, [5, 5], { layers: 2 }), OVERLAPPING);
  assert.equal(scene.relation(part, [0, 0], { layers: 0, ignore: [1, 2] }), APART);
  const { distance, id } = scene.distance(part, [2.5, 1]);
  assert.deepEqual([distance, id], [0.5, 2]);
  assert.equal(new Scene().distance(part).distance, Infinity);
  const impact = scene.cast(part, [8, 4], [-4, 0]);
  assert.deepEqual([impact.hit, impact.id, impact.position], [true, 3, [6, 4]]);
  assert.equal(scene.cast(part, [8, 4], [[-4, 0], [0, 1]]).length, 2);
  const escape = scene.penetration(part, [5.75, 5]);
  assert.deepEqual([escape.depth, escape.position, escape.id], [0.25, [6, 5], 3]);
  assert.throws(() => scene.relation(part, [0, 0], { layers: 0.5 }), InputError);
});

test("free positions", () => {
  const scene = new Scene(square(3));
  scene.add(square(1));
  const region = scene.freeRegion(square(2));
  assert.equal(region.isEmpty, false);
  assert.equal(region.fitsToWKT(), "GEOMETRYCOLLECTION (LINESTRING (0 1, 1 1), LINESTRING (1 0, 1 1))");
  assert.deepEqual([...new Set(region.owners)].sort(), [0, 1, 2]);
  assert.deepEqual(scene.best(square(2), [-1, 0]), [0, 1]);
  assert.equal(scene.best(square(4), [-1, 0]), null);
  assert.equal(scene.freeRegion(square(1), [0, 0, 2, 2]).isEmpty, false);
  assert.throws(() => new Scene().freeRegion(square(1)), InputError);
  assert.throws(() => scene.freeRegion(square(1), [0, 0, 1]), /window: \[0,0,1\] is not 4 numbers/);
});

test("lists of pairs and contacts", () => {
  const scene = new Scene();
  scene.add(square(1), [[0, 0], [1, 0], [5, 0]]);
  const pairs = scene.pairs();
  assert.deepEqual([...pairs], [{ a: 2, b: 3, relation: TOUCHING }]);
  assert.equal(JSON.stringify(pairs), '[{"a":2,"b":3,"relation":0}]');
  const contacts = scene.contacts();
  assert.equal(contacts.at(0).idA, 2);
  assert.equal(contacts.at(0).idB, 3);
  scene.move(4, [2, 0]);
  const later = scene.contacts(0, 0, contacts);
  assert.deepEqual(later.previous.filter((index) => index !== null).length, contacts.length);
  assert.equal(later.length, 2 * contacts.length);
  assert.deepEqual([...scene.pairs(0, pairs)].map(({ a, b }) => [a, b]), [[2, 3], [3, 4]]);
  assert.deepEqual([...scene.near(square(1), [3, 0])].map(({ a, b }) => [a, b]), [[4, 0]]);
  assert.throws(() => new Scene().pairs(0, pairs), { status: Status.INVALID_ARGUMENT });
  assert.throws(() => scene.near(square(1), [0, 0], NaN), GcvError);
});

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";

import * as gcv from "gcv";

const { APART, TOUCHING, OVERLAPPING } = gcv.Relation;
const square = [[0, 0], [2, 0], [2, 2], [0, 2]];

test("relations", () => {
  assert.equal(gcv.relation(square, square), OVERLAPPING);
  assert.equal(gcv.relation(square, square, [2, 0]), TOUCHING);
  assert.deepEqual(gcv.relation(square, square, [[3, 0], [2, 2], [1, 1]]), [
    APART,
    TOUCHING,
    OVERLAPPING,
  ]);
  assert.deepEqual(gcv.relation(square, square, Float64Array.of(3, 0)), [APART]);
  assert.throws(() => gcv.relation(square, square, [[0, 0], [NaN, 0]]), {
    status: gcv.Status.NOT_FINITE,
  });
});

test("distances", () => {
  const { distance, relation, nearest, id } = gcv.distance(square, square, [5, 6]);
  assert.deepEqual([distance, relation, id], [5, APART, 0]);
  assert.deepEqual(nearest, {
    kind: gcv.ContactKind.VERTEX_VERTEX,
    a: 2,
    b: 0,
    gap: 5,
    normal: [0.6, 0.8],
    onA: [2, 2],
    onB: [5, 6],
    idA: 0,
    idB: 0,
  });
  assert.equal(gcv.distance(square, square).nearest, null);
  assert.deepEqual(
    gcv.distance(square, square, [[3, 0], [0, 7]]).map((separation) => separation.distance),
    [1, 5],
  );
});

test("casts", () => {
  const impact = gcv.cast(square, square, [6, 0], [-8, 0]);
  assert.deepEqual([impact.hit, impact.time, impact.relation], [true, 0.5, TOUCHING]);
  assert.deepEqual(impact.position, [2, 0]);
  const [left, up] = gcv.cast(square, square, [6, 0], [[-8, 0], [0, 8]]);
  assert.ok(left.hit && !up.hit && up.contact === null && up.time === 1);
  assert.throws(
    () => gcv.cast(square, square, [[0, 0]], [[1, 0], [2, 0]]),
    /translation has 1 pairs and motion has 2 pairs/,
  );
});

test("ways out", () => {
  const escape = gcv.penetration(square, square, [1.5, 0.5]);
  assert.equal(escape.depth, 0.5);
  assert.deepEqual(escape.translation, [0.5, 0]);
  assert.deepEqual(escape.position, [2, 0.5]);
  assert.equal(gcv.penetration(square, square, [[3, 0]])[0].depth, 0);
});

test("contacts", () => {
  const list = gcv.contacts(square, square, [2.5, 0], 1);
  assert.equal(list.length, 6);
  assert.equal(list.at(0).gap, 0.5);
  assert.deepEqual([...list], list.records);
  assert.deepEqual(list.previous, new Array(6).fill(null));
  assert.equal(String(list), "<ContactList of 6 contacts>");
  assert.deepEqual(JSON.parse(JSON.stringify({ list })), { list: list.records });
  assert.throws(() => gcv.contacts(square, square, [0, 0], -1), gcv.InputError);
});

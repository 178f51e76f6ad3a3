// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The cases that all bindings share; tests/corpus/README.md describes the format.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import * as gcv from "gcv";

const sums = { no_fit: gcv.noFitPolygon, entrance: gcv.entranceBlock };
const regions = {
  no_fit_region: gcv.noFitRegion,
  entrance_region: gcv.entranceRegion,
  inner_fit_region: gcv.innerFitRegion,
};
const nameIn = (values, value) =>
  Object.keys(values).find((name) => values[name] === value).toLowerCase();

const vertices = (exact) =>
  exact
    .map((point) => point.map((f) => `${f.numerator}/${f.denominator}`).join(" "))
    .join(", ");

function parts(region) {
  const texts = region.exactParts.map(
    ({ kind, start, stop }) =>
      `${nameIn(gcv.PartKind, kind)} ${vertices(region.exact.slice(start, stop))}`,
  );
  return texts.join("; ") || "empty";
}

// Numbers are compared as doubles: they are written as their shortest digits.
const numbers = (...values) => values.map((x) => String(Number(x))).join(" ");
const readNumbers = (text) =>
  text.replace(/(?<![\w/.])-?(?:\d[\d.e+-]*|inf)(?![\w/])/g, (digits) =>
    numbers(digits.replace("inf", "Infinity")),
  );

function contact(found) {
  if (found === null) {
    return "none";
  }
  const { kind, a, b, gap, onA, onB } = found;
  return `${nameIn(gcv.ContactKind, kind)} ${numbers(a, b, gap, ...onA, ...onB)}`;
}

function position({ relation, position }, line) {
  const exact = `${nameIn(gcv.Relation, relation)} ${numbers(...position)}`;
  return line.includes(" inexact") ? "inexact" : exact;
}

const number = (word) => Number(word.replace("inf", "Infinity"));

function answer(a, b, word, words, line) {
  const translation = words.slice(0, 2).map(number);
  const more = words.slice(2, 4).map(number);
  switch (word) {
    case "relation":
      return nameIn(gcv.Relation, gcv.relation(a, b, translation));
    case "distance": {
      const { relation, distance, nearest } = gcv.distance(a, b, translation);
      return `${nameIn(gcv.Relation, relation)} ${numbers(distance)} ${contact(nearest)}`;
    }
    case "penetration": {
      const escape = gcv.penetration(a, b, translation);
      const way = numbers(escape.depth, ...escape.translation);
      return `${way} ${position(escape, line)} ${contact(escape.contact)}`;
    }
    case "contacts":
      return [...gcv.contacts(a, b, translation, ...more)].map(contact).join("; ") || "empty";
    case "cast": {
      const impact = gcv.cast(a, b, translation, more);
      const time = `${impact.hit ? "hit" : "miss"} ${numbers(impact.time)}`;
      return `${time} ${position(impact, line)} ${contact(impact.contact)}`;
    }
    default:
      throw new Error(`nothing is known of ${word}`);
  }
}

function outcome(a, b, line) {
  const [word, ...words] = line.split(" ");
  const refused = word === "refuse" ? words.slice(1).join(" ") : "";
  try {
    if (word === "refuse") {
      new gcv.Polygon(refused);
      return "GCV_OK";
    }
    if (word === "sum") {
      return `GCV_OK ${vertices(gcv.minkowskiSum(a, b).exact)}`;
    }
    if (word === "sum_region") {
      return `GCV_OK ${parts(gcv.minkowskiSumRegion(a, b))}`;
    }
    const point = words.slice(0, 2).map(number);
    if (word in regions) {
      return `GCV_OK ${parts(regions[word](a, b, point))}`;
    }
    if (word in sums) {
      return `GCV_OK ${vertices(sums[word](a, b, point).exact)}`;
    }
    return `GCV_OK ${answer(a, b, word, words, line)}`;
  } catch (error) {
    if (!(error instanceof gcv.GcvError)) {
      throw error;
    }
    return `${error.statusName} ${refused}`.trimEnd();
  }
}

// The library refuses this text. JavaScript takes the one polygon of it, as from GeoJSON.
const onePart = "MULTIPOLYGON (((0 0, 1 0, 0 1)))";
const exactLine = /^(refuse|sum|no_fit|entrance|\w+_region) /;

const file = new URL("../../../tests/corpus/cases.txt", import.meta.url);
let name, a, b;
for (const line of readFileSync(file, "utf8").split("\n")) {
  const [word] = line.split(" ", 1);
  const rest = line.slice(word.length + 1);
  if (word === "case") {
    [name, a, b] = [rest, "", ""];
  } else if (word === "a") {
    a = rest;
  } else if (word === "b") {
    b = rest;
  } else if (word !== "" && word !== "#") {
    const operands = [a, b];
    const read = exactLine.test(line) ? (text) => text : readNumbers;
    const expected = line.endsWith(onePart) ? "GCV_OK" : line.slice(line.indexOf("GCV_"));
    test(`${name}: ${word}`, () => {
      assert.equal(outcome(...operands, line), read(expected));
    });
  }
}

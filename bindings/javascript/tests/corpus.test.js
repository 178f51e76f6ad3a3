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
  return listed(texts);
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

const separation = ({ relation, distance, nearest }, key = "") =>
  `${nameIn(gcv.Relation, relation)} ${numbers(distance)} ${key}${contact(nearest)}`;

const escape = (way, line, key = "") =>
  `${numbers(way.depth, ...way.translation)} ${position(way, line)} ${key}${contact(way.contact)}`;

const impact = (found, line, key = "") =>
  `${found.hit ? "hit" : "miss"} ${numbers(found.time)} ${position(found, line)} ` +
  `${key}${contact(found.contact)}`;

const listed = (texts) => texts.join("; ") || "empty";

const pairs = (found) =>
  listed([...found].map(({ a, b, relation }) => `${a} ${b} ${nameIn(gcv.Relation, relation)}`));

const number = (word) => Number(word.replace("inf", "Infinity"));

function sceneOf(lines) {
  const scene = new gcv.Scene();
  for (const line of lines) {
    const [word, ...words] = line.split(" ");
    if (word === "container") {
      scene.setContainer(words.join(" "));
    } else {
      scene.add(words.slice(2).join(" "), words.slice(0, 2).map(number));
    }
  }
  return scene;
}

function sceneAnswer(scene, b, word, values, line) {
  const place = values.slice(0, 2);
  const more = values.slice(2);
  switch (word) {
    case "scene_free_region":
      return parts(scene.freeRegion(b));
    case "scene_window_region":
      return parts(scene.freeRegion(b, values));
    case "scene_pairs":
      return pairs(scene.pairs(...values));
    case "scene_contacts":
      return listed(
        [...scene.contacts(...values)].map((one) => `${one.idA} ${one.idB} ${contact(one)}`),
      );
    case "scene_near":
      return pairs(scene.near(b, place, ...more));
    case "scene_best": {
      const best = scene.best(b, place);
      return best === null ? "none" : line.endsWith(" inexact") ? "inexact" : numbers(...best);
    }
    case "scene_relation":
      return nameIn(gcv.Relation, scene.relation(b, place));
    case "scene_distance": {
      const found = scene.distance(b, place);
      return separation(found, `${found.id} `);
    }
    case "scene_penetration": {
      const way = scene.penetration(b, place);
      return escape(way, line, `${way.id} `);
    }
    case "scene_cast": {
      const found = scene.cast(b, place, more);
      return impact(found, line, `${found.id} `);
    }
    default:
      throw new Error(`nothing is known of ${word}`);
  }
}

function answer(a, b, word, values, line) {
  const translation = values.slice(0, 2);
  const more = values.slice(2);
  switch (word) {
    case "relation":
      return nameIn(gcv.Relation, gcv.relation(a, b, translation));
    case "distance":
      return separation(gcv.distance(a, b, translation));
    case "penetration":
      return escape(gcv.penetration(a, b, translation), line);
    case "contacts":
      return listed([...gcv.contacts(a, b, translation, ...more)].map(contact));
    case "cast":
      return impact(gcv.cast(a, b, translation, more), line);
    default:
      throw new Error(`nothing is known of ${word}`);
  }
}

function outcome(a, b, scene, line) {
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
    const values = words.slice(0, words.findIndex((text) => text.startsWith("GCV_"))).map(number);
    if (word.startsWith("scene_")) {
      return `GCV_OK ${sceneAnswer(sceneOf(scene), b, word, values, line)}`;
    }
    const point = values.slice(0, 2);
    if (word in regions) {
      return `GCV_OK ${parts(regions[word](a, b, point))}`;
    }
    if (word in sums) {
      return `GCV_OK ${vertices(sums[word](a, b, point).exact)}`;
    }
    return `GCV_OK ${answer(a, b, word, values, line)}`;
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
let name, a, b, scene;
for (const line of readFileSync(file, "utf8").split("\n")) {
  const [word] = line.split(" ", 1);
  const rest = line.slice(word.length + 1);
  if (word === "case") {
    [name, a, b, scene] = [rest, "", "", []];
  } else if (word === "a") {
    a = rest;
  } else if (word === "b") {
    b = rest;
  } else if (word === "container" || word === "member") {
    scene.push(line);
  } else if (word !== "" && word !== "#") {
    const operands = [a, b, scene];
    const read = exactLine.test(line) ? (text) => text : readNumbers;
    const expected = line.endsWith(onePart) ? "GCV_OK" : line.slice(line.indexOf("GCV_"));
    test(`${name}: ${word}`, () => {
      assert.equal(outcome(...operands, line), read(expected));
    });
  }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Well-Known Text as the library reads it: of one polygon, without elevations.

import { errorOf, noPolygon, Status } from "./errors.js";

/** The text of a polygon, and how much further on its rings are in the text that it is from. */
export interface PolygonText {
  text: string;
  shift: number;
}

const withArea = "(?:MULTI)?POLYGON|GEOMETRYCOLLECTION";
const tagOf = (kinds: string) => new RegExp(`\\s*(${kinds})\\s*(ZM|Z|M)?\\s*(?:(\\()|EMPTY\\b)`, "iy");
const geometry = tagOf(withArea);
const member = tagOf(`${withArea}|(?:MULTI)?(?:POINT|LINESTRING)`);
const part = /\s*(?:(\()|EMPTY\b)/iy;
const next = /\s*([,)])/y;
const between = /[\s,;]*/y;
const end = /\s*$/y;

/** The polygon of a text: a MULTIPOLYGON of one part is that part, and other text stays as it is. */
export function polygonOfWKT(text: string): PolygonText {
  if (!/^\s*MULTIPOLYGON/i.test(text)) {
    return { text: withoutElevations(text), shift: 0 };
  }
  const parts = polygonsOfWKT(text, true);
  if (parts.length !== 1) {
    throw noPolygon(`a MultiPolygon of ${parts.length} parts is not one polygon`);
  }
  return parts[0];
}

/** The polygons of all geometries of a text, or of the only one. What has no area is left out. */
export function polygonsOfWKT(text: string, isOne = false): PolygonText[] {
  const polygons: PolygonText[] = [];
  let place = 0;
  const take = (pattern: RegExp, what: string): RegExpExecArray => {
    pattern.lastIndex = place;
    const found = pattern.exec(text);
    if (found === null) {
      const byte = place + text.slice(place).search(/\S|$/);
      throw errorOf(Status.PARSE, `polygon: byte ${byte}: expected ${what}`);
    }
    place = pattern.lastIndex;
    return found;
  };
  const goesOn = () => take(next, "',' or ')'")[1] === ",";
  for (let depth = 0; ; ) {
    if (depth === 0) {
      take(isOne && place > 0 ? end : between, "the end of the text");
      if (place === text.length) {
        return polygons;
      }
    }
    const [, kind, elevations = "", opened] =
      depth === 0
        ? take(geometry, "POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION")
        : take(member, "a geometry");
    const takeBrackets = () => {
      const start = place - 1;
      place = closing(text, place);
      if (/POLYGON$/i.test(kind!)) {
        const tag = `POLYGON${elevations}`;
        const plain = withoutElevations(tag + text.slice(start, place));
        polygons.push({ text: plain, shift: start - tag.length });
      }
    };
    if (opened && /^GEOMETRYCOLLECTION$/i.test(kind!)) {
      ++depth;
      continue;
    }
    if (opened && /^MULTIPOLYGON$/i.test(kind!)) {
      do {
        if (take(part, "'('")[1]) {
          takeBrackets();
        }
      } while (goesOn());
    } else if (opened) {
      takeBrackets();
    }
    while (depth > 0 && !goesOn()) {
      --depth;
    }
  }
}

/** The place after the bracket that closes what was opened before start; the end if none does. */
function closing(text: string, start: number): number {
  const bracket = /[()]/g;
  bracket.lastIndex = start;
  for (let depth = 1; depth > 0; ) {
    const found = bracket.exec(text);
    if (found === null) {
      return text.length;
    }
    depth += found[0] === "(" ? 1 : -1;
  }
  return bracket.lastIndex;
}

/** Blanks for a Z and an M, and for their numbers. */
function withoutElevations(text: string): string {
  const tag = /^(\s*POLYGON\s*)(ZM|Z|M)(?=\s*(?:\(|EMPTY))/i.exec(text);
  if (!tag) {
    return text;
  }
  const [all, name, letters] = tag as unknown as [string, string, string];
  const vertex = new RegExp(
    `([(,]\\s*[-+.\\w]+\\s+[-+.\\w]+)((?:\\s+[-+.\\w]+){${letters.length}})(?=\\s*[,)])`,
    "g",
  );
  const rest = text
    .slice(all.length)
    .replace(vertex, (_, kept: string, left: string) => kept + " ".repeat(left.length));
  return name + " ".repeat(letters.length) + rest;
}

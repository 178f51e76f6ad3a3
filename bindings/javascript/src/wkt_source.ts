// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Forms of Well-Known Text that the library does not read, in forms that it does. All that is kept
// stays where it is, so that the library's messages name its place.

import { noPolygon } from "./errors.js";

/** As a POLYGON, without elevations; other text as it is. */
export function asPlainPolygon(text: string): string {
  return withoutElevations(ofOnePart(text));
}

/** A MULTIPOLYGON of one part as that part. One of more or of none throws. */
function ofOnePart(text: string): string {
  const tag = /^(\s*)MULTI(POLYGON\s*(?:ZM|Z|M)?\s*)(?:\(|EMPTY\s*$)/i.exec(text);
  if (!tag) {
    return text;
  }
  const [all, space, name] = tag as unknown as [string, string, string];
  const rest = text.slice(all.length);
  const parts = rest.match(/\(\s*\(/g)?.length ?? 0;
  if (parts !== 1) {
    throw noPolygon(`a MultiPolygon of ${parts} parts is not one polygon`);
  }
  return `${space}     ${name} ${rest.replace(/\)([^)]*)$/, " $1")}`;
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

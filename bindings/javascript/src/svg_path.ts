// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Paths of SVG with straight segments: M, L, H, V and Z, absolute and relative.

import { errorOf, Status } from "./errors.js";

const space = /[\s,]*/y;
const number = /[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/y;

/** Whether text is a path and not Well-Known Text. */
export function isSVGPath(text: string): boolean {
  return /^\s*[Mm][\s,]*[-+.\d]/.test(text);
}

/**
 * The subpaths as rings x0, y0, x1, y1, ...; all of them are closed.
 *
 * A relative coordinate is the double nearest to the sum of the current one and the number.
 */
export function ringsOfSVGPath(text: string): number[][] {
  const rings: number[][] = [];
  let at = 0;
  let [x, y] = [0, 0];
  let ring: number[] | undefined;

  function fail(what: string): never {
    const found = at < text.length ? `found '${text[at]}'` : "the path ends";
    throw errorOf(Status.PARSE, `polygon: SVG path: character ${at}: expected ${what}, ${found}`);
  }
  function skipSpace(): void {
    space.lastIndex = at;
    space.exec(text);
    at = space.lastIndex;
  }
  function isNumber(): boolean {
    skipSpace();
    number.lastIndex = at;
    return number.test(text);
  }
  function read(): number {
    if (!isNumber()) {
      fail("a number");
    }
    const digits = text.slice(at, number.lastIndex);
    at = number.lastIndex;
    return Number(digits);
  }
  function add(): void {
    ring ??= rings[rings.push([]) - 1];
    ring.push(x, y);
  }

  for (skipSpace(); at < text.length; skipSpace()) {
    const command = text[at];
    const absolute = command.toUpperCase();
    if (rings.length === 0 ? absolute !== "M" : !"MLHVZ".includes(absolute)) {
      fail(rings.length === 0 ? "M" : "M, L, H, V or Z, for curves are no polygons");
    }
    ++at;
    if (absolute === "Z") {
      const last = rings.at(-1)!;
      [x, y] = [last[0], last[1]];
      ring = undefined;
      continue;
    }
    const isRelative = command !== absolute;
    if (absolute === "M") {
      ring = undefined;
    } else if (ring === undefined) {
      add(); // after Z, from where the subpath before began
    }
    do {
      if (absolute !== "V") {
        x = read() + (isRelative ? x : 0);
      }
      if (absolute !== "H") {
        y = read() + (isRelative ? y : 0);
      }
      add();
    } while (isNumber());
  }
  if (rings.length === 0) {
    fail("M");
  }
  return rings;
}

/** The rings as a path, which reads back to the same doubles. */
export function svgPathOf(rings: Float64Array[]): string {
  return rings
    .map((ring) => {
      const vertices: string[] = [];
      for (let k = 0; k < ring.length; k += 2) {
        vertices.push(`${ring[k]} ${ring[k + 1]}`);
      }
      return `M ${vertices.join(" L ")} Z`;
    })
    .join(" ");
}

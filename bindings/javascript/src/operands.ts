// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The objects that a call uses.

import { caught, GcvError, named } from "./errors.js";
import { Handle, type Made } from "./handle.js";
import { library } from "./library.js";
import { Polygon } from "./polygon.js";
import { madeOf, type PolygonLike } from "./sources.js";

/** What a call uses: nothing frees or changes it before the call returns, nor is it garbage. */
export class Operands {
  readonly #ends: (() => void)[] = [];

  /** The same object or source. What the library has is in use from now on. */
  use<T>(object: T): T {
    if (object instanceof Handle) {
      object.hold();
      this.#ends.push(() => object.release());
    }
    return object;
  }

  /** The same polygon, which ends with the call. */
  own(polygon: Polygon): Polygon {
    this.#ends.push(() => polygon.free());
    return polygon;
  }

  /** The pointer of the polygon that a source is, or of one made from it, which ends with the call. */
  polygon(source: PolygonLike, name: string): number {
    this.use(source);
    if (source instanceof Polygon) {
      return source.pointer;
    }
    const { pointer } = madeFor(source, name);
    this.#ends.push(() => library.gcv_polygon_destroy(pointer));
    return pointer;
  }

  /** The pointers of the polygons of sources by the names of the arguments. */
  pointers(sources: Record<string, PolygonLike>): number[] {
    return Object.entries(sources).map(([name, source]) => this.polygon(source, name));
  }

  end(): void {
    this.#ends.forEach((end) => end());
  }
}

/** What use() gives, with operands that it uses until it returns. */
export function withOperands<T>(use: (operands: Operands) => T): T {
  const operands = new Operands();
  try {
    return use(operands);
  } finally {
    operands.end();
  }
}

/** What use() gives for the polygons of sources by the names of the arguments. */
export function withPolygons<T>(
  sources: Record<string, PolygonLike>,
  use: (...polygons: number[]) => T,
): T {
  return withOperands((operands) => use(...operands.pointers(sources)));
}

/** A new polygon from a source, whose name messages begin with. */
export function newPolygon(source: PolygonLike, name: string): Polygon {
  return new Polygon(madeFor(source, name));
}

function madeFor(source: PolygonLike, name: string): Made {
  const made = caught(() => madeOf(source));
  if (made instanceof GcvError) {
    throw named(made, name);
  }
  return made;
}

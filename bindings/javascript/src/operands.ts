// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The objects that a call uses.

import { caught, GcvError, named } from "./errors.js";
import type { Handle } from "./handle.js";
import { Polygon } from "./polygon.js";
import { Shape } from "./shape.js";
import type { PolygonLike } from "./sources.js";

/** What a call uses: nothing frees or changes it before the call returns, nor is it garbage. */
export class Operands {
  readonly #held: Handle[] = [];
  readonly #made: Polygon[] = [];

  /** The same object, in use from now on. */
  use<T extends Handle>(object: T): T {
    object.hold();
    this.#held.push(object);
    return object;
  }

  /** The polygon that a source is, or one made from it, which ends with the call. */
  polygon(source: PolygonLike, name: string): Polygon {
    if (source instanceof Shape) {
      this.use(source);
    }
    return source instanceof Polygon ? source : this.own(newPolygon(source, name));
  }

  /** The same polygon, which ends with the call. */
  own(polygon: Polygon): Polygon {
    this.#made.push(polygon);
    return polygon;
  }

  /** The pointers of the polygons of sources by the names of the arguments. */
  pointers(sources: Record<string, PolygonLike>): number[] {
    return Object.entries(sources).map(([name, source]) => this.polygon(source, name).pointer);
  }

  end(): void {
    this.#held.forEach((object) => object.release());
    this.#made.forEach((polygon) => polygon.free());
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
  const polygon = caught(() => new Polygon(source));
  if (polygon instanceof GcvError) {
    throw named(polygon, name);
  }
  return polygon;
}

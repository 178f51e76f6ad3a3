// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons.

import { GcvError, named } from "./errors.js";
import { closedRing, wktOfRings, type GeoJSONPolygon } from "./geojson.js";
import { counted, Made } from "./handle.js";
import { library, view } from "./library.js";
import { check, doubleOf, doublesAt, pointerOf, withScratch } from "./memory.js";
import { checkOptions, roundingOf, type SumOptions } from "./options.js";
import { finiteNumbersOf, numberOf, numbersOf, type Point } from "./points.js";
import { Shape } from "./shape.js";
import { madeOf, madeOfMany, normalisedRings, type PolygonLike, type PolygonsLike } from "./sources.js";
import { svgPathOf } from "./svg_path.js";

/** A box: xmin, ymin, xmax, ymax. */
export type Box = [xmin: number, ymin: number, xmax: number, ymax: number];

/** A polygon with fewer vertices, and how far it is from the given one. */
export interface Simplified {
  polygon: Polygon;
  /** At least the Hausdorff distance between the two boundaries, certified. */
  errorBound: number;
}

/**
 * A simple polygon, perhaps with holes. It never changes.
 *
 * Rings may have either orientation, and may be closed or not. All checks are exact. Numbers of
 * vertices and edges, in messages and sources, run through all rings as passed; those of
 * Well-Known Text likewise.
 */
export class Polygon extends Shape {
  /**
   * A polygon from points, GeoJSON, Well-Known Text, a path of SVG, or a shape, with the rings of
   * `holes` as further holes.
   *
   * Throws an InputError for coordinates that are not finite, polygons without area, rings that
   * cross or lie where they may not, and for what is no polygon.
   */
  constructor(source: PolygonLike, holes?: readonly PolygonLike[]);
  /** @internal */
  constructor(source: Made);
  constructor(source: PolygonLike | Made, holes?: readonly PolygonLike[]) {
    super(source instanceof Made ? source : madeOf(source, holes), "gcv_polygon_destroy");
  }

  /**
   * Many polygons: of an array of sources, made at once where they have one ring each; or all those
   * of a region, of GeoJSON, or of Well-Known Text, without its segments and points. Throws the
   * first error.
   */
  static many(sources: PolygonsLike, options?: { returnErrors?: false }): Polygon[];
  /** With errors in the places of sources that are no polygons. */
  static many(
    sources: PolygonsLike,
    options: { returnErrors?: boolean },
  ): (Polygon | GcvError)[];
  static many(
    sources: PolygonsLike,
    options: { returnErrors?: boolean } = {},
  ): (Polygon | GcvError)[] {
    checkOptions(options, ["returnErrors"]);
    const results = madeOfMany(sources).map((made, k) =>
      made instanceof Made ? new Polygon(made) : named(made, `polygon ${k}`),
    );
    const failure = results.find((result) => result instanceof GcvError);
    if (failure !== undefined && options.returnErrors !== true) {
      results.forEach((result) => result instanceof Polygon && result.free());
      throw failure;
    }
    return results;
  }

  /**
   * A convex polygon in place of a disc: for clearances, as part + disc. Boundary and circle are
   * within the tolerance of each other, certified. With the rounding "outward" it contains the disc.
   */
  static disc(
    centre: Point,
    radius: number,
    tolerance: number,
    options: Pick<SumOptions, "rounding"> = {},
  ): Polygon {
    checkOptions(options, ["rounding"]);
    return withScratch((scratch) => {
      const middle = scratch.doubles(numbersOf(centre, 2, "centre"));
      const numbers = [numberOf(radius, "radius"), numberOf(tolerance, "tolerance")] as const;
      const rounding = roundingOf(options.rounding);
      const call = (out: number) =>
        library.gcv_polygon_create_disc(middle, ...numbers, rounding, out);
      return new Polygon(new Made(pointerOf(call)));
    });
  }

  /**
   * All rings, each x0, y0, x1, y1, ... First the outer ring, counter-clockwise, then the holes in
   * the order passed, clockwise. Each begins with its lexicographically smallest vertex, and has
   * no repeated and no collinear vertices. The same arrays at each access: do not change them.
   */
  get rings(): Float64Array[] {
    return this.known("rings", normalisedRings);
  }

  /** The outer ring. */
  get vertices(): Float64Array {
    return this.rings[0];
  }

  /** The rings without the outer one. */
  get holes(): Float64Array[] {
    return this.rings.slice(1);
  }

  /** @internal */
  protected override inWords(): string {
    const vertices = counted(this.vertices.length / 2, "vertex", "vertices");
    const holes = this.rings.length - 1;
    return holes > 0 ? `${vertices} with ${counted(holes, "hole")}` : vertices;
  }

  /** The area without the holes, in square units, correctly rounded. */
  get area(): number {
    return doubleOf((out) => library.gcv_polygon_area(this.pointer, out));
  }

  /** The smallest box around the polygon, exact. */
  get bounds(): Box {
    return withScratch((scratch) => {
      const out = scratch.room(32);
      check(library.gcv_polygon_bounds(this.pointer, out));
      return Array.from(doublesAt(out, 4)) as Box;
    });
  }

  /**
   * The polygon with fewer vertices, within a tolerance in input units. With the rounding "outward"
   * it contains this one. Numbers of vertices and edges stay.
   */
  simplified(tolerance: number, options: Pick<SumOptions, "rounding"> = {}): Simplified {
    checkOptions(options, ["rounding"]);
    return withScratch((scratch) => {
      const bound = scratch.room(8);
      const limit = numberOf(tolerance, "tolerance");
      const rounding = roundingOf(options.rounding);
      const pointer = pointerOf((out) =>
        library.gcv_polygon_simplified(this.pointer, limit, rounding, out, bound),
      );
      return {
        polygon: new Polygon(new Made(pointer)),
        errorBound: view().getFloat64(bound, true),
      };
    });
  }

  /**
   * The polygon with (x, y) moved to (m0 x + m1 y + m2, m3 x + m4 y + m5), each coordinate correctly
   * rounded. Numbers of vertices and edges stay. The matrix is six numbers in one array, row by row:
   * [0, -1, 0, 1, 0, 0] is a quarter turn. Two rows of three are refused.
   */
  affine(matrix: ArrayLike<number>): Polygon {
    return new Polygon(affineMade(this, matrix));
  }

  /** The polygon moved by a vector, each coordinate correctly rounded. */
  translated(vector: Point): Polygon {
    const [x, y] = finiteNumbersOf(vector, 2, "vector") as [number, number];
    return this.affine([1, 0, x, 0, 1, y]);
  }

  /** The polygon reflected in the origin, exactly. */
  negated(): Polygon {
    return this.affine([-1, 0, 0, 0, -1, 0]);
  }

  /** Whether both are the same set of points. */
  equals(other: Polygon): boolean {
    const key = ({ rings: [outer, ...holes] }: Polygon) =>
      [String(outer), ...holes.map(String).sort()].join(";");
    return other instanceof Polygon && key(this) === key(other);
  }

  override toGeoJSON(): GeoJSONPolygon {
    return { type: "Polygon", coordinates: this.rings.map(closedRing) };
  }

  /** Well-Known Text, which reads back to the same doubles. */
  override toWKT(): string {
    return `POLYGON ${wktOfRings(this.rings)}`;
  }

  /** A path of SVG with a subpath for each ring, which reads back to the same doubles. */
  toSVGPath(): string {
    return svgPathOf(this.rings);
  }

  /** @internal */
  override polygonMade(): Made {
    return affineMade(this, [1, 0, 0, 0, 1, 0]);
  }
}

function affineMade(polygon: Polygon, matrix: ArrayLike<number>): Made {
  return withScratch((scratch) => {
    const numbers = scratch.doubles(finiteNumbersOf(matrix, 6, "matrix"));
    return new Made(pointerOf((out) => library.gcv_polygon_affine(polygon.pointer, numbers, out)));
  });
}

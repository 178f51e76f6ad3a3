// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Regions.

import { errorOf, renamed, Status, unfit } from "./errors.js";
import {
  areEqual,
  boundsOf,
  edgeSourceAt,
  edgeSourceSize,
  exactPointOf,
  statsOf,
  type EdgeSource,
  type ExactPoint,
  type Stats,
} from "./facts.js";
import {
  closedRing,
  pairsOf,
  wktOfPairs,
  wktOfRings,
  type GeoJSONGeometryCollection,
  type GeoJSONMultiPolygon,
} from "./geojson.js";
import { counted, Made } from "./handle.js";
import { library, view } from "./library.js";
import { check, coordinatesOf, doubleOf, integerAt, pointerOf, structsOf, withScratch } from "./memory.js";
import { coordinatesOf as coordinatesOfPoints, isPoint, numbersOf, type Point, type Points } from "./points.js";
import { Polygon, type Box } from "./polygon.js";
import { Shape } from "./shape.js";
import { svgPathOf } from "./svg_path.js";

/** What a part of a region is. */
export const PartKind = {
  /** The outer ring of a polygon, counter-clockwise. */
  OUTER: 1,
  /** The ring of a hole in the polygon before it, clockwise. */
  HOLE: 2,
  /** A segment: one polygon fits the other exactly, and has room along a line only. */
  SEGMENT: 3,
  /** A point: one polygon fits the other exactly, and has no room at all. */
  POINT: 4,
} as const;
export type PartKind = (typeof PartKind)[keyof typeof PartKind];

/** One part of a region: a ring, a segment or a point. */
export interface RegionPart {
  kind: PartKind;
  /** The number of the polygon, from 0; null for segments and points. */
  polygon: number | null;
  /** The index of its first vertex. */
  start: number;
  /** The index after that of its last vertex. */
  stop: number;
}

/** Where a point lies. */
export const Location = {
  /** In the interior of a polygon of the region. */
  INSIDE: 1,
  /** On a ring, a segment or a point of it. */
  BOUNDARY: 0,
  /** Elsewhere; holes are outside. */
  OUTSIDE: -1,
} as const;
export type Location = (typeof Location)[keyof typeof Location];

/**
 * Polygons with holes, segments and points. It never changes.
 *
 * In a segment or a point, one polygon fits the other exactly. There are two regions in one: the
 * exact one, in fractions, and that in doubles, which are rounded from these, each once. What has
 * no "exact" in its name is about the one in doubles. What is a list or an array is the same at
 * each access.
 */
export class Region extends Shape implements Iterable<Polygon> {
  /** @internal */
  constructor(made: Made) {
    super(made, "gcv_region_destroy");
  }

  /** The parts: for each polygon its outer ring, then its holes; then segments; then points. */
  get parts(): RegionPart[] {
    return this.known("parts", (pointer) =>
      partsOf((...buffer) => library.gcv_region_parts(pointer, ...buffer)),
    );
  }

  /** The vertices of all parts, part after part: x0, y0, x1, y1, ... */
  get vertices(): Float64Array {
    return this.known("vertices", (pointer) =>
      coordinatesOf((...buffer) => library.gcv_region_vertices(pointer, ...buffer)),
    );
  }

  /** The polygons: for each its rings, the outer one first, then its holes. */
  get polygons(): Float64Array[][] {
    return this.known("polygons", () => {
      const polygons: Float64Array[][] = [];
      for (const { polygon, start, stop } of this.parts) {
        if (polygon !== null) {
          (polygons[polygon] ??= []).push(this.vertices.subarray(2 * start, 2 * stop));
        }
      }
      return polygons;
    });
  }

  /** The segments, each its two ends x0, y0, x1, y1 in lexicographic order. */
  get segments(): Float64Array[] {
    return this.known("segments", () => this.verticesOf(PartKind.SEGMENT));
  }

  /** The single points, each x, y. */
  get points(): Float64Array[] {
    return this.known("points", () => this.verticesOf(PartKind.POINT));
  }

  private verticesOf(kind: PartKind): Float64Array[] {
    return this.parts
      .filter((part) => part.kind === kind)
      .map(({ start, stop }) => this.vertices.subarray(2 * start, 2 * stop));
  }

  /** @internal */
  protected override inWords(): string {
    const holes = this.parts.filter((part) => part.kind === PartKind.HOLE).length;
    const words: [number, string][] = [
      [this.polygons.length, "polygon"],
      [holes, "hole"],
      [this.segments.length, "segment"],
      [this.points.length, "point"],
    ];
    const found = words.filter(([count]) => count > 0);
    return found.map(([count, word]) => counted(count, word)).join(", ") || "no parts";
  }

  /** Whether there is no part at all. That is an answer, not an error. */
  get isEmpty(): boolean {
    return this.parts.length === 0;
  }

  /** The parts of the exact region. They are canonical: the same set has the same parts. */
  get exactParts(): RegionPart[] {
    return this.known("exactParts", (pointer) =>
      partsOf((...buffer) => library.gcv_region_exact_parts(pointer, ...buffer)),
    );
  }

  /** The vertices of all parts of the exact region, part after part. */
  get exact(): ExactPoint[] {
    return this.known("exact", (pointer) =>
      Array.from({ length: this.exactParts.at(-1)?.stop ?? 0 }, (_, k) =>
        exactPointOf((...buffer) => library.gcv_region_exact_vertex(pointer, k, ...buffer)),
      ),
    );
  }

  /** For each of vertices, the index in exact of the vertex that it stands for. */
  get exactIndices(): number[] {
    return this.known("exactIndices", (pointer) =>
      structsOf((...buffer) => library.gcv_region_exact_indices(pointer, ...buffer), 8, integerAt),
    );
  }

  /** Where each edge of the exact region comes from: k is for exact vertex k to the next of its part. */
  get sources(): EdgeSource[] {
    return this.known("sources", (pointer) =>
      structsOf(
        (...buffer) => library.gcv_region_edge_sources(pointer, ...buffer),
        edgeSourceSize,
        edgeSourceAt,
      ),
    );
  }

  /** The id of the scene's member that made each edge; 1 is the container, 0 a window or no scene. */
  get owners(): number[] {
    return this.known("owners", (pointer) =>
      structsOf((...buffer) => library.gcv_region_edge_owners(pointer, ...buffer), 8, integerAt),
    );
  }

  /** The area of the polygons without their holes, in square units, correctly rounded. */
  get area(): number {
    return doubleOf((out) => library.gcv_region_area(this.pointer, out));
  }

  /** An upper bound on the distance from the exact boundary, certified and rounded up. */
  get errorBound(): number {
    return doubleOf((out) => library.gcv_region_error_bound(this.pointer, out));
  }

  /** The smallest box around all parts; null for a region without parts. */
  get bounds(): Box | null {
    return boundsOf(this.vertices) ?? null;
  }

  /** What the computation took. */
  get stats(): Stats {
    return statsOf((out) => library.gcv_region_stats(this.pointer, out));
  }

  /** One polygon with its holes, for the next sum; made at each call. */
  polygon(number: number): Polygon {
    if (!Number.isSafeInteger(number) || number < 0) {
      throw unfit("number", number, "the number of a polygon");
    }
    return renamed(/^polygon is/, "number is", () => new Polygon(this.polygonMadeOf(number)));
  }

  /** The polygons with their holes, made at each turn. */
  *[Symbol.iterator](): Generator<Polygon, void, undefined> {
    for (const number of this.polygons.keys()) {
      yield this.polygon(number);
    }
  }

  /** Where a point lies in the exact region. */
  locate(point: Point): Location;
  /** Where each of many points lies. */
  locate(points: Points): Int8Array;
  locate(points: Point | Points): Location | Int8Array {
    const isOne = isPoint(points);
    const coordinates = isOne
      ? numbersOf(points, 2, "points")
      : coordinatesOfPoints(points, "points", "a point, nor an array of points");
    return withScratch((scratch) => {
      const count = coordinates.length / 2;
      const [xy, out] = [scratch.doubles(coordinates), scratch.room(count)];
      renamed(/^xy:/, "points:", () => check(library.gcv_region_locate(this.pointer, xy, count, out)));
      const places = new Int8Array(library.memory.buffer, out, count).slice();
      return isOne ? (places[0] as Location) : places;
    });
  }

  /** Whether both the exact parts and those in doubles are equal. */
  equals(other: Region): boolean {
    const key = ({ parts, vertices, exactParts }: Region) =>
      JSON.stringify([parts, Array.from(vertices), exactParts]);
    return other instanceof Region && key(this) === key(other) && areEqual(this.exact, other.exact);
  }

  /** A MultiPolygon; with segments or points a GeometryCollection of all parts. */
  override toGeoJSON(): GeoJSONMultiPolygon | GeoJSONGeometryCollection {
    const polygons = this.polygons.map((rings) => rings.map(closedRing));
    if (this.segments.length + this.points.length === 0) {
      return { type: "MultiPolygon", coordinates: polygons };
    }
    return {
      type: "GeometryCollection",
      geometries: [
        ...polygons.map((coordinates) => ({ type: "Polygon", coordinates }) as const),
        ...this.segments.map(
          (ends) => ({ type: "LineString", coordinates: pairsOf(ends) }) as const,
        ),
        ...this.points.map((xy) => ({ type: "Point", coordinates: Array.from(xy) }) as const),
      ],
    };
  }

  /** The polygons as Well-Known Text: always a MULTIPOLYGON, without segments and points. */
  override toWKT(): string {
    return `MULTIPOLYGON ${listed(this.polygons.map(wktOfRings))}`;
  }

  /** The segments and points as Well-Known Text: always a GEOMETRYCOLLECTION. */
  fitsToWKT(): string {
    return `GEOMETRYCOLLECTION ${listed([
      ...this.segments.map((ends) => `LINESTRING (${wktOfPairs(pairsOf(ends))})`),
      ...this.points.map((xy) => `POINT (${wktOfPairs(pairsOf(xy))})`),
    ])}`;
  }

  /** The polygons as a path of SVG, without segments and points. "" where there is none. */
  toSVGPath(): string {
    return svgPathOf(this.polygons.flat());
  }

  /** @internal */
  override polygonMade(): Made {
    const polygons = this.polygons.length;
    if (polygons !== 1 || this.segments.length + this.points.length !== 0) {
      const fits = this.segments.length + this.points.length;
      const reason = `a region of ${polygons} polygons and ${fits} fits is not one polygon`;
      throw errorOf(Status.INVALID_ARGUMENT, `polygon: ${reason}`);
    }
    return this.polygonMadeOf(0);
  }

  /** @internal */
  override polygonsMade(): Made[] {
    return this.polygons.map((_, number) => this.polygonMadeOf(number));
  }

  private polygonMadeOf(number: number): Made {
    return new Made(pointerOf((out) => library.gcv_region_polygon(this.pointer, number, out)));
  }
}

function listed(texts: string[]): string {
  return texts.length === 0 ? "EMPTY" : `(${texts.join(", ")})`;
}

const partSize = 16;
const noPolygon = 0xffffffff;

function partsOf(call: Parameters<typeof structsOf>[0]): RegionPart[] {
  let start = 0;
  return structsOf(call, partSize, (at) => {
    const polygon = view().getUint32(at + 4, true);
    const stop = start + integerAt(at + 8);
    const part = {
      kind: view().getInt32(at, true) as PartKind,
      polygon: polygon === noPolygon ? null : polygon,
      start,
      stop,
    };
    start = stop;
    return part;
  });
}

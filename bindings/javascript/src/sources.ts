// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Whatever a polygon can be made from.

import { caught, errorOf, GcvError, named, noPolygon, short, Status, unfit } from "./errors.js";
import type { GeoJSONCollection, GeoJSONSource } from "./geojson.js";
import { Made } from "./handle.js";
import { library, view } from "./library.js";
import { check, coordinatesOf as coordinatesFrom, pointerOf, structsAt, withScratch } from "./memory.js";
import { coordinatesOf, elementsOf, type Points } from "./points.js";
import { Shape } from "./shape.js";
import { isSVGPath, ringsOfSVGPath } from "./svg_path.js";
import { polygonOfWKT, polygonsOfWKT, type PolygonText } from "./wkt_source.js";

/**
 * Whatever a polygon can be made from: the points of a ring; GeoJSON, as an object or as text;
 * Well-Known Text; a path of SVG with straight segments, whose first subpath is the outer ring; a
 * polygon; an outer face; a region of one polygon and nothing else.
 */
export type PolygonLike = Points | GeoJSONSource | string | Shape;

/** Whatever many polygons can be made from: an array of sources, or one source of several polygons. */
export type PolygonsLike = readonly PolygonLike[] | GeoJSONCollection | string | Shape;

type Ring = ArrayLike<number>;

/** The polygon of a source, with more holes. Messages begin with "polygon: ". */
export function madeOf(source: PolygonLike, holes: readonly PolygonLike[] = []): Made {
  const added = elementsOf(holes, "holes");
  const read = ringsOrPolygon(source);
  if (read instanceof Made && added.length === 0) {
    return read;
  }
  return madeOfRings([...ringsOf(read), ...added.map(ringOfHole)]);
}

/** The polygon of each source, or its error. Those of one ring are made at once. */
export function madeOfMany(sources: PolygonsLike): (Made | GcvError)[] {
  const readers = caught(() => readersOf(sources));
  if (readers instanceof GcvError) {
    throw named(readers, "sources");
  }
  const read = readers.map((reader) => caught(reader));
  const isSingle = (one: Ring[] | Made | GcvError): one is [Ring] =>
    Array.isArray(one) && one.length === 1;
  const pointers = pointersOf(read.filter(isSingle).map(([ring]) => ring));
  return read.map((one) => {
    const pointer = isSingle(one) ? pointers.shift()! : 0;
    if (pointer !== 0) {
      return new Made(pointer);
    }
    // Of a ring without a polygon, this says why.
    return Array.isArray(one) ? caught(() => madeOfRings(one)) : one;
  });
}

function madeOfRings(rings: Ring[]): Made {
  return withScratch((scratch) => {
    const vertices = scratch.joined(rings);
    const sizes = rings.map((ring) => ring.length / 2);
    return new Made(
      pointerOf((out) =>
        sizes.length === 1
          ? library.gcv_polygon_create(vertices, sizes[0], 0, out)
          : library.gcv_polygon_create_rings(vertices, scratch.words(sizes), sizes.length, 0, out),
      ),
    );
  });
}

/** The polygons of rings, 0 where there is none. */
function pointersOf(rings: Ring[]): number[] {
  return withScratch((scratch) => {
    const count = rings.length;
    const vertices = scratch.joined(rings);
    const sizes = scratch.words(rings.map((ring) => ring.length / 2));
    const [out, statuses] = [scratch.room(4 * count), scratch.room(4 * count)];
    check(library.gcv_polygon_create_many(vertices, sizes, count, 0, out, statuses));
    return structsAt(out, 4, count, (at) => view().getUint32(at, true));
  });
}

/** What reads each of many sources, or each polygon of a source. */
function readersOf(sources: PolygonsLike): (() => Ring[] | Made)[] {
  if (sources instanceof Shape) {
    return sources.polygonsMade().map((made) => () => made);
  }
  const source = unpacked(sources);
  if (typeof source === "string") {
    return isSVGPath(source)
      ? [() => ringsOfSVGPath(source)]
      : polygonsOfWKT(source).map((polygon) => () => madeOfWKT(polygon));
  }
  return isGeoJSON(source)
    ? geometriesOf(source).map((geometry) => () => ringsOfGeoJSON(geometry))
    : elementsOf(source, "polygon").map((one) => () => ringsOrPolygon(one));
}

function ringsOrPolygon(given: PolygonLike): Ring[] | Made {
  if (given instanceof Shape) {
    return given.polygonMade();
  }
  const source = unpacked(given);
  if (typeof source === "string") {
    return isSVGPath(source) ? ringsOfSVGPath(source) : madeOfWKT(polygonOfWKT(source));
  }
  return isGeoJSON(source) ? ringsOfGeoJSON(source) : [ringOfPoints(source)];
}

/** The object that text of GeoJSON says; other text without a mark of UTF-8; the rest as it is. */
function unpacked<T>(source: T | string): T | string {
  if (typeof source !== "string") {
    return source;
  }
  const text = source.replace(/^\ufeff/, "");
  return text.trimStart().startsWith("{") ? (parsed(text) as T) : text;
}

function isGeoJSON<T>(source: T): source is Extract<T, { type: unknown }> {
  return typeof source === "object" && source !== null && "type" in source;
}

function ringOfPoints(points: Points, ofRing = ""): Ring {
  const what = "a polygon, and none can be made from it";
  return coordinatesOf(points, "polygon", what, (k) => `polygon: vertex ${k}${ofRing}`);
}

/** The rings, from which a polygon is ended. */
function ringsOf(read: Ring[] | Made): Ring[] {
  if (Array.isArray(read)) {
    return read;
  }
  try {
    return normalisedRings(read.pointer);
  } finally {
    library.gcv_polygon_destroy(read.pointer);
  }
}

/** The rings of a polygon as the library has them. */
export function normalisedRings(pointer: number): Float64Array[] {
  const count = withScratch((scratch) => {
    const out = scratch.room(4);
    check(library.gcv_polygon_ring_count(pointer, out));
    return view().getUint32(out, true);
  });
  return Array.from({ length: count }, (_, k) =>
    coordinatesFrom((...buffer) => library.gcv_polygon_ring(pointer, k, ...buffer)),
  );
}

function ringOfHole(source: PolygonLike, index: number): Ring {
  const rings = caught(() => ringsOf(ringsOrPolygon(source)));
  if (rings instanceof GcvError) {
    throw named(rings, `polygon: hole ${index}`);
  }
  if (rings.length !== 1) {
    throw noPolygon(`hole ${index} has ${rings.length} rings, not one`);
  }
  return rings[0];
}

function madeOfWKT({ text, shift }: PolygonText): Made {
  const made = withScratch((scratch) => {
    const bytes = new TextEncoder().encode(text);
    const pointer = scratch.bytes(bytes);
    return caught(() => pointerOf((out) => library.gcv_polygon_create_wkt(pointer, bytes.length, out)));
  });
  if (made instanceof GcvError) {
    const place = (_: string, byte: string) => `byte ${Number(byte) + shift}`;
    throw errorOf(made.status, made.message.replace(/byte (\d+)/, place));
  }
  return new Made(made);
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw errorOf(Status.PARSE, `polygon: GeoJSON text: ${(error as Error).message}`);
  }
}

function ringsOfGeoJSON(source: unknown): Ring[] {
  const outer = new Set<unknown>();
  for (let geometry = source; ; ) {
    const { type, ...members } = Object(geometry) as Record<string, unknown>;
    if (outer.has(geometry)) {
      throw noPolygon(`a ${type} that is in itself is not a polygon`);
    }
    outer.add(geometry);
    switch (type) {
      case "Feature":
        geometry = members["geometry"];
        break;
      case "FeatureCollection":
        geometry = only(members["features"], type);
        break;
      case "MultiPolygon":
        return ringsOfCoordinates(only(partsOf(members["coordinates"]), type));
      case "Polygon":
        return ringsOfCoordinates(members["coordinates"]);
      case undefined:
        throw unfit("polygon", geometry, "a geometry");
      default:
        throw noPolygon(`a geometry of type ${short(type)} is not a polygon`);
    }
  }
}

const deepest = 1000;
const withoutArea: unknown[] = ["Point", "MultiPoint", "LineString", "MultiLineString"];

/** The polygons of a geometry. What is none stays as it is; in collections, what has no area is left out. */
function geometriesOf(source: unknown, alone = true, depth = 0): unknown[] {
  if (depth > deepest) {
    throw noPolygon("this is nested too deeply");
  }
  const { type, ...members } = Object(source) as Record<string, unknown>;
  const inside = (parts: unknown, alone: boolean) =>
    listOf(parts).flatMap((one) => geometriesOf(one, alone, depth + 1));
  switch (type) {
    case "Feature":
      return members["geometry"] == null ? [] : inside([members["geometry"]], alone);
    case "FeatureCollection":
      return inside(members["features"], false);
    case "GeometryCollection":
      return inside(members["geometries"], false);
    case "MultiPolygon":
      return partsOf(members["coordinates"]).map((coordinates) => ({ type: "Polygon", coordinates }));
    default:
      return alone || !withoutArea.includes(type) ? [source] : [];
  }
}

/** The parts of a MultiPolygon, without those that are empty. */
function partsOf(coordinates: unknown): unknown[] {
  return listOf(coordinates).filter((part) => !Array.isArray(part) || part.length > 0);
}

function only(parts: unknown, type: string): unknown {
  const list = listOf(parts);
  if (list.length !== 1) {
    throw noPolygon(`a ${type} of ${list.length} parts is not one polygon`);
  }
  return list[0];
}

function ringsOfCoordinates(coordinates: unknown): Ring[] {
  const rings = listOf(coordinates).map((ring, r) => {
    const pairs = listOf(ring).map((position) =>
      Array.isArray(position) ? position.slice(0, 2) : position,
    );
    return ringOfPoints(pairs as number[][], r === 0 ? "" : ` of ring ${r}`);
  });
  return rings.length === 0 ? [[]] : rings;
}

/** With undefined for missing elements. */
function listOf(value: unknown): unknown[] {
  if (!Array.isArray(value)) {
    throw noPolygon(`${short(value)} in a geometry is not a list`);
  }
  return Array.from(value);
}

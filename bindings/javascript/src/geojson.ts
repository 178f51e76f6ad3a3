// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Geometries of GeoJSON and Well-Known Text: the types, and what is made of rings.

import { coordinatesOf, type Points } from "./points.js";

/** Two coordinates; further ones are left out. */
export type Position = number[];

export interface GeoJSONPolygon {
  type: "Polygon";
  coordinates: Position[][];
}

export interface GeoJSONMultiPolygon {
  type: "MultiPolygon";
  coordinates: Position[][][];
}

export interface GeoJSONLineString {
  type: "LineString";
  coordinates: Position[];
}

export interface GeoJSONPoint {
  type: "Point";
  coordinates: Position;
}

export interface GeoJSONGeometryCollection {
  type: "GeometryCollection";
  geometries: (GeoJSONPolygon | GeoJSONLineString | GeoJSONPoint)[];
}

/** Whatever of GeoJSON has one polygon. */
export type GeoJSONSource =
  | { readonly type: "Polygon"; readonly coordinates: readonly (readonly (readonly number[])[])[] }
  | {
      readonly type: "MultiPolygon";
      readonly coordinates: readonly (readonly (readonly (readonly number[])[])[])[];
    }
  | { readonly type: "Feature"; readonly geometry: GeoJSONSource | null }
  | { readonly type: "FeatureCollection"; readonly features: readonly GeoJSONSource[] };

/** Whatever of GeoJSON has polygons. Segments and points of collections are left out. */
export type GeoJSONCollection =
  | GeoJSONSource
  | {
      readonly type: "Point" | "MultiPoint" | "LineString" | "MultiLineString";
      readonly coordinates: readonly unknown[];
    }
  | { readonly type: "Feature"; readonly geometry: GeoJSONCollection | null }
  | { readonly type: "FeatureCollection"; readonly features: readonly GeoJSONCollection[] }
  | { readonly type: "GeometryCollection"; readonly geometries: readonly GeoJSONCollection[] };

/** The pairs of x0, y0, x1, y1, ...: of a ring, of the ends of a segment, or of positions. */
export function pairsOf(coordinates: Points): [number, number][] {
  const xy = coordinatesOf(coordinates, "coordinates", "an array of coordinates");
  return Array.from({ length: xy.length / 2 }, (_, k) => [xy[2 * k], xy[2 * k + 1]]);
}

/** A ring as GeoJSON has it: closed. */
export function closedRing(ring: Float64Array): [number, number][] {
  const pairs = pairsOf(ring);
  return [...pairs, [ring[0], ring[1]]];
}

/** Rings in brackets, as Well-Known Text has them. Every number has the fewest digits. */
export function wktOfRings(rings: Float64Array[]): string {
  return `(${rings.map((ring) => `(${wktOfPairs(closedRing(ring))})`).join(", ")})`;
}

export function wktOfPairs(pairs: [number, number][]): string {
  return pairs.map(([x, y]) => `${x} ${y}`).join(", ");
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Minkowski sums of two polygons, exactly: outer faces, regions, questions and scenes.

export { CancelledError, GcvError, InputError, Status } from "./errors.js";
export { EdgeKind } from "./facts.js";
export type { EdgeSource, ExactPoint, Fraction, Stats } from "./facts.js";
export { pairsOf } from "./geojson.js";
export type {
  GeoJSONCollection,
  GeoJSONGeometryCollection,
  GeoJSONLineString,
  GeoJSONMultiPolygon,
  GeoJSONPoint,
  GeoJSONPolygon,
  GeoJSONSource,
  Position,
} from "./geojson.js";
export { ContactList, PairList } from "./lists.js";
export { version as libraryVersion } from "./memory.js";
export { offset } from "./offset.js";
export type { AbortSignalLike, CallOptions, LeaveOut, RegionOptions, SumOptions } from "./options.js";
export { OuterFace } from "./outer_face.js";
export type { NumberArray, Point, Points } from "./points.js";
export { Polygon } from "./polygon.js";
export type { Box, Simplified } from "./polygon.js";
export { cast, contacts, distance, penetration, relation } from "./questions.js";
export type { EscapeOptions } from "./questions.js";
export { ContactKind, Relation } from "./records.js";
export type { Contact, Escape, Impact, Pair, Separation } from "./records.js";
export { Location, PartKind, Region } from "./region.js";
export type { RegionPart } from "./region.js";
export { Scene } from "./scene.js";
export type { FreeRegionOptions, QueryOptions } from "./scene.js";
export type { PolygonLike, PolygonsLike } from "./sources.js";
export {
  entranceBlock,
  entranceRegion,
  innerFitRegion,
  minkowskiSum,
  minkowskiSumMany,
  minkowskiSumRegion,
  minkowskiSumRegionMany,
  noFitPolygon,
  noFitPolygonMany,
  noFitRegion,
  noFitRegionMany,
  superset,
} from "./sums.js";
export type { ManyOptions, SupersetEdge } from "./sums.js";

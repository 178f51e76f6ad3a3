// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What polygons, outer faces and regions have in common.

import type { GeoJSONGeometryCollection, GeoJSONMultiPolygon, GeoJSONPolygon } from "./geojson.js";
import { Handle, Made } from "./handle.js";

/** Rings of doubles, which never change. */
export abstract class Shape extends Handle {
  abstract toWKT(): string;

  abstract toGeoJSON(): GeoJSONPolygon | GeoJSONMultiPolygon | GeoJSONGeometryCollection;

  /** The same as toWKT(). */
  override toString(): string {
    return this.toWKT();
  }

  /** The same as toGeoJSON(), for JSON.stringify. */
  toJSON(): ReturnType<this["toGeoJSON"]> {
    return this.toGeoJSON() as ReturnType<this["toGeoJSON"]>;
  }

  /** The polygon that it is, as a new object, with its numbers of vertices. @internal */
  abstract polygonMade(): Made;

  /** Its polygons, each as a new object. @internal */
  polygonsMade(): Made[] {
    return [this.polygonMade()];
  }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Outer faces.

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
import { closedRing, wktOfRings, type GeoJSONPolygon } from "./geojson.js";
import { counted, Made } from "./handle.js";
import { library, view } from "./library.js";
import { check, coordinatesOf, doubleOf, integerAt, pointerOf, structsOf, withScratch } from "./memory.js";
import { Polygon, type Box } from "./polygon.js";
import { Shape } from "./shape.js";
import { svgPathOf } from "./svg_path.js";

/**
 * The outer face of a Minkowski sum: one simple ring. It never changes.
 *
 * The doubles of vertices are rounded from an exact ring, each once; exact gives that ring itself.
 * What is a list or an array is the same at each access.
 */
export class OuterFace extends Shape {
  /** @internal */
  constructor(made: Made) {
    super(made, "gcv_outer_face_destroy");
  }

  /** The ring, counter-clockwise from its lexicographically smallest vertex: x0, y0, x1, y1, ... */
  get vertices(): Float64Array {
    return this.known("vertices", (pointer) =>
      coordinatesOf((...buffer) => library.gcv_outer_face_vertices(pointer, ...buffer)),
    );
  }

  /** @internal */
  protected override inWords(): string {
    return counted(this.vertices.length / 2, "vertex", "vertices");
  }

  /** The vertices of the exact ring. */
  get exact(): ExactPoint[] {
    return this.known("exact", (pointer) => {
      const count = withScratch((scratch) => {
        const out = scratch.room(4);
        check(library.gcv_outer_face_exact_vertex_count(pointer, out));
        return view().getUint32(out, true);
      });
      return Array.from({ length: count }, (_, k) =>
        exactPointOf((...buffer) => library.gcv_outer_face_exact_vertex(pointer, k, ...buffer)),
      );
    });
  }

  /** Where each edge of the exact ring comes from: k is for exact vertex k to k + 1. */
  get sources(): EdgeSource[] {
    return this.known("sources", (pointer) =>
      structsOf(
        (...buffer) => library.gcv_outer_face_edge_sources(pointer, ...buffer),
        edgeSourceSize,
        edgeSourceAt,
      ),
    );
  }

  /** For each of vertices, the index in exact of the vertex that it stands for. */
  get exactIndices(): number[] {
    return this.known("exactIndices", (pointer) =>
      structsOf(
        (...buffer) => library.gcv_outer_face_exact_indices(pointer, ...buffer),
        8,
        integerAt,
      ),
    );
  }

  /** An upper bound on the Hausdorff distance from the exact ring, certified and rounded up. */
  get errorBound(): number {
    return doubleOf((out) => library.gcv_outer_face_error_bound(this.pointer, out));
  }

  /** The area inside the ring of doubles, in square units, correctly rounded. */
  get area(): number {
    return doubleOf((out) => library.gcv_outer_face_area(this.pointer, out));
  }

  /** The smallest box around the ring of doubles. */
  get bounds(): Box {
    return boundsOf(this.vertices)!;
  }

  /** What the computation took. */
  get stats(): Stats {
    return statsOf((out) => library.gcv_outer_face_stats(this.pointer, out));
  }

  /** The ring of doubles as a polygon, for the next sum; made at each call. */
  polygon(): Polygon {
    return new Polygon(this.polygonMade());
  }

  /** Whether both rings are equal, the exact ones and those in doubles. */
  equals(other: OuterFace): boolean {
    return (
      other instanceof OuterFace &&
      String(this.vertices) === String(other.vertices) &&
      areEqual(this.exact, other.exact)
    );
  }

  override toGeoJSON(): GeoJSONPolygon {
    return { type: "Polygon", coordinates: [closedRing(this.vertices)] };
  }

  /** Well-Known Text, which reads back to the same doubles. */
  override toWKT(): string {
    return `POLYGON ${wktOfRings([this.vertices])}`;
  }

  /** A path of SVG, which reads back to the same doubles. */
  toSVGPath(): string {
    return svgPathOf([this.vertices]);
  }

  /** @internal */
  override polygonMade(): Made {
    return new Made(pointerOf((out) => library.gcv_outer_face_polygon(this.pointer, out)));
  }
}

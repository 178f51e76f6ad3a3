// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The types of the package, as a program in TypeScript sees them. It is compiled, and not run.
import * as gcv from "gcv";

const pairs: [number, number][] = [[0, 0], [1, 0], [0, 1]];
const polygon: gcv.Polygon = new gcv.Polygon(pairs, [new Float64Array(6)]);
const typed: Float64Array = polygon.vertices;
const sources: gcv.PolygonLike[] = [
  pairs,
  typed,
  "M 0 0 L 1 0 L 0 1 Z",
  { type: "Polygon", coordinates: [pairs] },
  polygon.toGeoJSON(),
  polygon,
];
const face: gcv.OuterFace = gcv.minkowskiSum(sources[0], polygon, { rounding: "outward" });
const one: gcv.Relation = gcv.relation(polygon, face, [0, 0]);
const many: gcv.Relation[] = gcv.relation(polygon, face, typed);
const faces: gcv.OuterFace[] = gcv.minkowskiSumMany(sources, sources);
const results: (gcv.OuterFace | gcv.GcvError)[] = gcv.minkowskiSumMany(sources, sources, {
  returnErrors: true,
});
const collection: gcv.PolygonsLike = { type: "GeometryCollection", geometries: [polygon.toGeoJSON()] };
const members: gcv.Polygon[] = gcv.Polygon.many(collection);
const region: gcv.Region = new gcv.Scene(polygon).freeRegion(pairs, null, { leaveOut: "fits" });
const place: gcv.Location = region.locate([0, 0]);
const places: Int8Array = region.locate(pairs);
const best: gcv.Point | null = new gcv.Scene(polygon).best(pairs, [-1, 0], { ignore: [2, 3] });
const text: string = `${polygon}`;
const json: gcv.GeoJSONPolygon = polygon.toJSON();
const parts: gcv.GeoJSONMultiPolygon | gcv.GeoJSONGeometryCollection = region.toJSON();
const grown: gcv.Region = gcv.offset(polygon, 1, 0.1, { progress: () => false });
const list: gcv.ContactList = gcv.contacts(polygon, polygon);
const found: gcv.Contact[] = list.toJSON();
const scene = new gcv.Scene();
scene.container = pairs;
scene.container = null;
const container: gcv.Polygon | null = scene.container;
const listed: gcv.Polygon[] = [...region, ...gcv.Polygon.many(region)];
const ids: number[] = [...scene];
const degenerate: gcv.Status = gcv.Status.DEGENERATE;
const status: gcv.Status = new gcv.InputError(degenerate, "").status;
const signal: gcv.AbortSignalLike = { aborted: false, throwIfAborted() {} };
const stopped: gcv.OuterFace = gcv.minkowskiSum(polygon, polygon, { signal });
export { best, container, faces, found, grown, ids, json, listed, many, members, one, parts, place, places };
export { results, status, stopped, text };

// @ts-expect-error: only the library makes outer faces.
new gcv.OuterFace();
// @ts-expect-error: there is no such rounding.
gcv.minkowskiSum(polygon, polygon, { rounding: "up" });
// @ts-expect-error: outer faces have all of their parts.
gcv.minkowskiSum(polygon, polygon, { leaveOut: "fits" });
// @ts-expect-error: these are contacts, not pairs.
new gcv.Scene().pairs(0, new gcv.Scene().contacts());
// @ts-expect-error: there is no such status.
new gcv.GcvError(10, "");
// @ts-expect-error: this cannot say that it is aborted.
gcv.minkowskiSum(polygon, polygon, { signal: {} });
// @ts-expect-error: a translation is a pair.
gcv.relation(polygon, polygon, [1, 2, 3]);

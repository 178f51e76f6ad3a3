// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How two polygons lie: what questions are answered with, read from structs of the library.

import { view } from "./library.js";
import { integerAt } from "./memory.js";
import type { Point } from "./points.js";

/** How two polygons lie. */
export const Relation = {
  /** They have no point in common. */
  APART: 1,
  /** Their boundaries meet, their interiors do not. */
  TOUCHING: 0,
  /** Their interiors meet. */
  OVERLAPPING: -1,
} as const;
export type Relation = (typeof Relation)[keyof typeof Relation];

/** The features of a contact. */
export const ContactKind = {
  /** An edge of A and a vertex of B. */
  EDGE_VERTEX: 1,
  /** A vertex of A and an edge of B. */
  VERTEX_EDGE: 2,
  /** A vertex of A and a vertex of B. */
  VERTEX_VERTEX: 3,
} as const;
export type ContactKind = (typeof ContactKind)[keyof typeof ContactKind];

/** A feature of A and one of B that touch, or would, and where. */
export interface Contact {
  /** Whether a and b are numbers of vertices or of edges. */
  kind: ContactKind;
  /** Of vertex k of A as passed, or of the edge from vertex k to k + 1. */
  a: number;
  /** The same of B. */
  b: number;
  /**
   * The distance between the features; in lists negative for a vertex on the inner side of the line
   * of the edge.
   */
  gap: number;
  /** A unit vector from A to B; 0 0 for two vertices that coincide. */
  normal: Point;
  /** The point of the feature of A that is nearest to that of B. */
  onA: Point;
  /** The point of the feature of B, where the translation has moved it. */
  onB: Point;
  /** The id of A in a scene, 1 for the container; 0 without a scene. */
  idA: number;
  /** The id of B in a scene; 0 for a polygon that is no member, and without a scene. */
  idB: number;
}

/** How far two polygons are from each other. */
export interface Separation {
  /** The Euclidean distance, correctly rounded; 0 where they touch or overlap. */
  distance: number;
  /** Exact, even where the distance underflows to 0. */
  relation: Relation;
  /** Where the distance is taken; null where they touch or overlap. */
  nearest: Contact | null;
  /** In a scene, of what is nearest; 0 where nothing is there. */
  id: number;
}

/** The shortest way out of an overlap. */
export interface Escape {
  /** The length of the way, correctly rounded; 0 where they do not overlap. */
  depth: number;
  /** The way itself. Of several ways, the lexicographically smallest. */
  translation: Point;
  /** A translation of doubles near the end of the way, where B does not overlap A if there is one. */
  position: Point;
  /** How they lie at the position, exactly. */
  relation: Relation;
  /**
   * What they touch with at the end of the way; null where they do not overlap, in a scene where
   * nothing is free, and where only points touch there at which rings of both polygons touch.
   */
  contact: Contact | null;
  /** In a scene, of what is touched at the end of the way; 0 where there is no way. */
  id: number;
}

/** How far a motion leads before the polygons overlap. */
export interface Impact {
  /** Whether B would overlap A right after the time. */
  hit: boolean;
  /** How they lie at the position, exactly. */
  relation: Relation;
  /** The largest part of the motion, from 0 to 1, up to which they never overlap; rounded down. */
  time: number;
  /** A translation of doubles near the exact one, where B does not overlap A if there is one. */
  position: Point;
  /** What is hit; null without a hit, and where they overlap at the start. */
  contact: Contact | null;
  /** In a scene, of what is hit, also without a contact; 0 without a hit. */
  id: number;
}

/** Two members of a scene, or the container or another polygon and a member. */
export interface Pair {
  /** An id, 1 for the container. */
  a: number;
  /** The other one; 0 for a polygon that is no member. */
  b: number;
  /** How they lie, exactly. */
  relation: Relation;
}

/** A struct of the library: its size, and what is made of it. */
export interface Struct<T> {
  readonly size: number;
  readonly read: (pointer: number) => T;
}

const int32 = (pointer: number): number => view().getInt32(pointer, true);
const uint32 = (pointer: number): number => view().getUint32(pointer, true);
const double = (pointer: number): number => view().getFloat64(pointer, true);
const point = (pointer: number): Point => [double(pointer), double(pointer + 8)];
const relation = (pointer: number): Relation => int32(pointer) as Relation;
const contactOrNull = (at: number): Contact | null => (int32(at) === 0 ? null : contactStruct.read(at));

export const relationStruct: Struct<Relation> = {
  size: 1,
  read: (at) => view().getInt8(at) as Relation,
};

export const contactStruct: Struct<Contact> = {
  size: 88,
  read: (at) => ({
    kind: int32(at) as ContactKind,
    a: uint32(at + 4),
    b: uint32(at + 8),
    gap: double(at + 32),
    normal: point(at + 40),
    onA: point(at + 56),
    onB: point(at + 72),
    idA: integerAt(at + 16),
    idB: integerAt(at + 24),
  }),
};

export const separationStruct: Struct<Separation> = {
  size: 104,
  read: (at) => ({
    distance: double(at),
    relation: relation(at + 8),
    nearest: contactOrNull(at + 16),
    id: integerAt(at + 32),
  }),
};

export const impactStruct: Struct<Impact> = {
  size: 120,
  read: (at) => ({
    hit: int32(at) !== 0,
    relation: relation(at + 4),
    time: double(at + 8),
    position: point(at + 16),
    contact: contactOrNull(at + 32),
    id: integerAt(at + 48),
  }),
};

export const escapeStruct: Struct<Escape> = {
  size: 136,
  read: (at) => ({
    depth: double(at),
    translation: point(at + 8),
    position: point(at + 24),
    relation: relation(at + 40),
    contact: contactOrNull(at + 48),
    id: integerAt(at + 64),
  }),
};

export const pairStruct: Struct<Pair> = {
  size: 24,
  read: (at) => ({ a: integerAt(at), b: integerAt(at + 8), relation: relation(at + 16) }),
};

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scenes of many polygons.

import { errorOf, Status, unfit } from "./errors.js";
import { Handle, Made } from "./handle.js";
import { library, view } from "./library.js";
import { ContactList, PairList } from "./lists.js";
import { check, doublesAt, integerAt, pointerOf, structsAt, structsOf, withScratch, type Scratch } from "./memory.js";
import { run, type CallOptions, type LeaveOut, type RegionOptions } from "./options.js";
import { coordinatesOf, isPoint, numberOf, numbersOf, type Point, type Points } from "./points.js";
import { Polygon, polygonOf, withPolygons, type Box } from "./polygon.js";
import { answer, type EscapeOptions } from "./questions.js";
import {
  escapeStruct,
  impactStruct,
  relationStruct,
  separationStruct,
  type Escape,
  type Impact,
  type Relation,
  type Separation,
  type Struct,
} from "./records.js";
import { Region } from "./region.js";
import type { PolygonLike } from "./sources.js";

/** Which members a question is about. */
export interface QueryOptions extends CallOptions {
  /** A bit for every layer: members that share none of them are left out. All by default. */
  layers?: number;
  /** The id of a member that is left out, or several; 1 for the container. */
  ignore?: number | readonly number[];
}

/** Of free regions. */
export interface FreeRegionOptions extends QueryOptions, Pick<RegionOptions, "rounding"> {
  /** "fits" for a region without segments and points. */
  leaveOut?: LeaveOut;
}

const allLayers = 0xffffffff;
const querySize = 16;

/**
 * Polygons at positions, the members, and perhaps a container round them. It can change; a change
 * that throws leaves it as it was.
 *
 * A member is its polygon moved by its position, exactly. Members have ids 2, 3, 4, ... as they are
 * added; an id is never used again, and the container's is 1. The scene keeps what it needs of the
 * polygons, which can be freed.
 */
export class Scene extends Handle {
  /** A scene without members, in a container if there is one. */
  constructor(container?: PolygonLike | null);
  /** @internal */
  constructor(container: Made);
  constructor(container: PolygonLike | Made | null = null) {
    super(
      container instanceof Made ? container : new Made(pointerOf((out) => library.gcv_scene_create(out))),
      "gcv_scene_destroy",
    );
    if (!(container instanceof Made) && container !== null) {
      try {
        this.setContainer(container);
      } catch (error) {
        this.free();
        throw error;
      }
    }
  }

  /** Puts a container round the members, in place of the one that there may be; null for none. */
  setContainer(container: PolygonLike | null): void {
    if (container === null) {
      check(library.gcv_scene_set_container(this.pointer, 0));
      return;
    }
    withPolygons({ container }, (polygon) =>
      check(library.gcv_scene_set_container(this.pointer, polygon!)),
    );
  }

  /** Adds a polygon at a position, and gives its id. */
  add(polygon: PolygonLike, position?: Point): number;
  /** Adds a polygon at each of many positions, and gives their ids. */
  add(polygon: PolygonLike, positions: Points): number[];
  add(polygon: PolygonLike, positions: Point | Points = [0, 0]): number | number[] {
    const isOne = isPoint(positions);
    const places = isOne ? [positions] : positions;
    return withPolygons({ polygon }, (pointer) => {
      const ids = this.addPointers((count) => new Array<number>(count).fill(pointer!), places);
      return isOne ? ids[0] : ids;
    });
  }

  /** Adds many polygons, each at its position, and gives their ids. */
  addMany(polygons: readonly PolygonLike[], positions: Points): number[] {
    return withMany(polygons, (pointers) => this.addPointers(() => pointers, positions));
  }

  private addPointers(pointersOf: (count: number) => number[], positions: Points): number[] {
    return withScratch((scratch) => {
      const places = coordinatesOf(positions, "positions", "an array of pairs");
      const count = places.length / 2;
      const pointers = pointersOf(count);
      checkCounts("polygons", pointers.length, "positions", count);
      const [polygons, xy, ids] = [
        scratch.words(pointers),
        scratch.doubles(places),
        scratch.room(8 * count),
      ];
      check(library.gcv_scene_add(this.pointer, polygons, xy, count, ids));
      return structsAt(ids, 8, count, integerAt);
    });
  }

  /** Moves a member, or each of many. */
  move(id: number, position: Point): void;
  move(ids: readonly number[], positions: Points): void;
  move(ids: number | readonly number[], positions: Point | Points): void {
    const places = isPoint(positions) ? [positions] : positions;
    this.change(ids, (scratch, list, count) => {
      const coordinates = coordinatesOf(places, "positions", "a pair of numbers, nor an array of pairs");
      checkCounts("ids", count, "positions", coordinates.length / 2);
      const xy = scratch.doubles(coordinates);
      return library.gcv_scene_set(this.pointer, list, 0, xy, count);
    });
  }

  /** Gives a member another polygon, or several members one polygon. They stay where they are. */
  setPolygon(ids: number | readonly number[], polygon: PolygonLike): void {
    withPolygons({ polygon }, (pointer) =>
      this.change(ids, (scratch, list, count) => {
        const polygons = scratch.words(new Array<number>(count).fill(pointer!));
        return library.gcv_scene_set(this.pointer, list, polygons, 0, count);
      }),
    );
  }

  /** Gives many members other polygons and other positions in one change. */
  setMany(ids: readonly number[], polygons: readonly PolygonLike[], positions: Points): void {
    withMany(polygons, (pointers) =>
      this.change(ids, (scratch, list, count) => {
        const coordinates = coordinatesOf(positions, "positions", "an array of pairs");
        checkCounts("ids", count, "polygons", pointers.length);
        checkCounts("ids", count, "positions", coordinates.length / 2);
        const [shapes, xy] = [scratch.words(pointers), scratch.doubles(coordinates)];
        return library.gcv_scene_set(this.pointer, list, shapes, xy, count);
      }),
    );
  }

  /** Puts members into layers, which questions choose from: a number with a bit for every layer. */
  setLayers(ids: number | readonly number[], layers: number): void {
    const bits = layersOf(layers);
    this.change(ids, (scratch, list, count) => {
      const words = scratch.words(new Array<number>(count).fill(bits));
      return library.gcv_scene_set_layers(this.pointer, list, words, count);
    });
  }

  /** Takes members out. */
  remove(ids: number | readonly number[]): void {
    this.change(ids, (_, list, count) => library.gcv_scene_remove(this.pointer, list, count));
  }

  private change(
    ids: number | readonly number[],
    call: (scratch: Scratch, ids: number, count: number) => number,
  ): void {
    withScratch((scratch) => {
      const list = idsOf(ids, "ids");
      check(call(scratch, scratch.ids(list), list.length));
    });
  }

  /** The ids of all members, from the smallest on. */
  get ids(): number[] {
    return structsOf((...buffer) => library.gcv_scene_ids(this.pointer, ...buffer), 8, integerAt);
  }

  /** The number of members. */
  get size(): number {
    return this.ids.length;
  }

  /** The position of a member. */
  position(id: number): Point {
    const [x, y] = this.positions([id]);
    return [x!, y!];
  }

  /** The positions of members, of all of them by default: x0, y0, x1, y1, ... */
  positions(ids: readonly number[] = this.ids): Float64Array {
    return withScratch((scratch) => {
      const list = idsOf(ids, "ids");
      const [pointer, out] = [scratch.ids(list), scratch.room(16 * list.length)];
      check(library.gcv_scene_positions(this.pointer, pointer, list.length, out));
      return doublesAt(out, 2 * list.length);
    });
  }

  /** The polygon of a member, before it is moved to its position; made at each call. */
  polygon(id: number): Polygon {
    const [known] = idsOf(id, "id");
    return new Polygon(
      new Made(pointerOf((out) => library.gcv_scene_polygon(this.pointer, BigInt(known!), out))),
    );
  }

  /** A scene with the same members, ids, layers and container. From then on each changes alone. */
  copy(): Scene {
    return new Scene(new Made(pointerOf((out) => library.gcv_scene_copy(this.pointer, out))));
  }

  /**
   * Where a polygon is free: where it lies in the container and overlaps no member. With a window,
   * what of that lies in it. Without a container there must be a window.
   */
  freeRegion(moving: PolygonLike, window: Box | null = null, options: FreeRegionOptions = {}): Region {
    return this.ask({ moving }, options, (scratch, polygon, query) => {
      const bounds = window === null ? 0 : scratch.doubles(numbersOf(window, 4, "window"));
      const out = scratch.room(4);
      run(scratch, options, (known) =>
        library.gcv_scene_free_region(this.pointer, polygon, bounds, query, known, out),
      );
      return new Region(new Made(view().getUint32(out, true)));
    });
  }

  /**
   * The free position that is furthest in a direction, null where nothing is free. [-1, 0] places
   * bottom-left: leftmost, and of these lowest. There must be a container.
   */
  best(
    moving: PolygonLike,
    direction: Point,
    options: QueryOptions & Pick<RegionOptions, "leaveOut"> = {},
  ): Point | null {
    return this.ask({ moving }, options, (scratch, polygon, query) => {
      const towards = scratch.doubles(numbersOf(direction, 2, "direction"));
      const [out, found] = [scratch.room(16), scratch.room(4)];
      run(scratch, options, (known) =>
        library.gcv_scene_best(this.pointer, polygon, towards, query, known, out, found),
      );
      const [x, y] = doublesAt(out, 2);
      return view().getInt32(found, true) === 0 ? null : [x!, y!];
    });
  }

  /** How a polygon at a position lies to the members and the container, or at each of many. */
  relation(moving: PolygonLike, positions?: Point, options?: QueryOptions): Relation;
  relation(moving: PolygonLike, positions: Points, options?: QueryOptions): Relation[];
  relation(
    moving: PolygonLike,
    positions: Point | Points = [0, 0],
    options: QueryOptions = {},
  ): Relation | Relation[] {
    return this.answer(library.gcv_scene_relation, relationStruct, moving, { positions }, options);
  }

  /** How far a polygon is from what is nearest, a member or the container. */
  distance(moving: PolygonLike, positions?: Point, options?: QueryOptions): Separation;
  distance(moving: PolygonLike, positions: Points, options?: QueryOptions): Separation[];
  distance(
    moving: PolygonLike,
    positions: Point | Points = [0, 0],
    options: QueryOptions = {},
  ): Separation | Separation[] {
    return this.answer(library.gcv_scene_distance, separationStruct, moving, { positions }, options);
  }

  /** How far a polygon can move along a motion before it overlaps something. */
  cast(moving: PolygonLike, positions: Point, motions: Point, options?: QueryOptions): Impact;
  cast(
    moving: PolygonLike,
    positions: Point | Points,
    motions: Point | Points,
    options?: QueryOptions,
  ): Impact[];
  cast(
    moving: PolygonLike,
    positions: Point | Points,
    motions: Point | Points,
    options: QueryOptions = {},
  ): Impact | Impact[] {
    const vectors = { positions, motions };
    return this.answer(library.gcv_scene_cast, impactStruct, moving, vectors, options);
  }

  /** The shortest way out of all overlaps with members and the container. */
  penetration(moving: PolygonLike, positions?: Point, options?: QueryOptions & EscapeOptions): Escape;
  penetration(moving: PolygonLike, positions: Points, options?: QueryOptions & EscapeOptions): Escape[];
  penetration(
    moving: PolygonLike,
    positions: Point | Points = [0, 0],
    options: QueryOptions & EscapeOptions = {},
  ): Escape | Escape[] {
    return this.answer(library.gcv_scene_penetration, escapeStruct, moving, { positions }, options);
  }

  /** What is no further than a distance from a polygon at a position: pairs of an id and 0. */
  near(
    moving: PolygonLike,
    position: Point,
    distance = 0,
    options: QueryOptions = {},
  ): PairList {
    return this.ask({ moving }, options, (scratch, polygon, query) => {
      const place = scratch.doubles(numbersOf(position, 2, "position"));
      const limit = numberOf(distance, "distance");
      const out = scratch.room(4);
      run(scratch, options, (known) =>
        library.gcv_scene_near(this.pointer, polygon, place, limit, query, known, out),
      );
      return new PairList(new Made(view().getUint32(out, true)));
    });
  }

  /**
   * All pairs of members, and of the container and a member, no further than a distance from each
   * other. With an earlier list of this scene, what has not moved since is not computed again.
   */
  pairs(distance = 0, previous: PairList | null = null, options: QueryOptions = {}): PairList {
    return this.ask({}, options, (scratch, _, query) => {
      const limit = numberOf(distance, "distance");
      const [earlier, out] = [previous?.pointer ?? 0, scratch.room(4)];
      run(scratch, options, (known) =>
        library.gcv_scene_pairs(this.pointer, earlier, limit, query, known, out),
      );
      return new PairList(new Made(view().getUint32(out, true)));
    });
  }

  /** The contacts of all pairs, within a distance: those of contacts(). `previous` as in pairs. */
  contacts(
    distance = 0,
    slope = 0,
    previous: ContactList | null = null,
    options: QueryOptions = {},
  ): ContactList {
    return this.ask({}, options, (scratch, _, query) => {
      const limits = [numberOf(distance, "distance"), numberOf(slope, "slope")];
      const [earlier, out] = [previous?.pointer ?? 0, scratch.room(4)];
      run(scratch, options, (known) =>
        library.gcv_scene_contacts(this.pointer, earlier, ...limits, query, known, out),
      );
      return new ContactList(new Made(view().getUint32(out, true)));
    });
  }

  private answer<T>(
    call: (...values: number[]) => number,
    struct: Struct<T>,
    moving: PolygonLike,
    vectors: Record<string, Point | Points>,
    options: QueryOptions & EscapeOptions,
  ): T | T[] {
    return this.ask({ moving }, options, (scratch, polygon, query) =>
      answer(scratch, struct, vectors, options, (pointers, count, known, out) =>
        call(this.pointer, polygon, ...pointers, count, query, known, out),
      ),
    );
  }

  private ask<T>(
    sources: { moving?: PolygonLike },
    { layers = allLayers, ignore = [] }: QueryOptions,
    use: (scratch: Scratch, moving: number, query: number) => T,
  ): T {
    return withPolygons(sources as Record<string, PolygonLike>, (moving = 0) =>
      withScratch((scratch) => {
        const ids = idsOf(ignore, "ignore");
        const query = scratch.room(querySize);
        const ignored = scratch.ids(ids);
        [querySize, layersOf(layers), ignored, ids.length].forEach((word, k) =>
          view().setUint32(query + 4 * k, word, true),
        );
        return use(scratch, moving, query);
      }),
    );
  }
}

function withMany<T>(sources: readonly PolygonLike[], use: (pointers: number[]) => T): T {
  const made: Polygon[] = [];
  try {
    return use(sources.map((source, k) => polygonOf(source, `polygons[${k}]`, made).pointer));
  } finally {
    made.forEach((polygon) => polygon.free());
  }
}

function idsOf(ids: number | readonly number[], name: string): readonly number[] {
  const list = typeof ids === "number" ? [ids] : ids;
  list.forEach((id, k) => {
    if (!Number.isSafeInteger(id) || id < 0) {
      throw unfit(typeof ids === "number" ? name : `${name}[${k}]`, id, "an id");
    }
  });
  return list;
}

function layersOf(layers: number): number {
  if (!Number.isInteger(layers) || layers < 0 || layers > allLayers) {
    throw unfit("layers", layers, "a number of 32 bits, one for each layer");
  }
  return layers;
}

function checkCounts(a: string, countOfA: number, b: string, countOfB: number): void {
  if (countOfA !== countOfB) {
    const reason = `${a} has ${countOfA} elements and ${b} has ${countOfB}`;
    throw errorOf(Status.INVALID_ARGUMENT, reason);
  }
}

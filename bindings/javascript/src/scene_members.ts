// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The members of scenes, and how they change.

import { renamed, unfit } from "./errors.js";
import { counted, Handle, Made } from "./handle.js";
import { library } from "./library.js";
import { check, doublesAt, integerAt, pointerOf, structsAt, structsOf, withScratch, type Scratch } from "./memory.js";
import { newPolygon, withOperands, withPolygons } from "./operands.js";
import { checkCounts, coordinatesOf, elementsOf, isList, isPoint, type Point, type Points } from "./points.js";
import { Polygon } from "./polygon.js";
import type { PolygonLike } from "./sources.js";

/** All layers, one for each bit. @internal */
export const allLayers = 0xffffffff;

/** What a scene consists of. */
export abstract class SceneMembers extends Handle implements Iterable<number> {
  /** The polygon of the container, of which the library gives no handle. */
  #kept: Polygon | null = null;

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

  /** The polygon that members are to be in, made at each call; null for none. It can be set. */
  get container(): Polygon | null {
    void this.pointer; // throws where the scene was freed
    return this.#kept === null ? null : new Polygon(this.#kept.polygonMade());
  }

  set container(container: PolygonLike | null) {
    this.setContainer(container);
  }

  /** Puts a container round the members, in place of the one that there may be; null for none. */
  setContainer(container: PolygonLike | null): void {
    const kept = container === null ? null : newPolygon(container, "container");
    try {
      check(library.gcv_scene_set_container(this.pointerToChange, kept?.pointer ?? 0));
    } catch (error) {
      kept?.free();
      throw error;
    }
    this.#kept?.free();
    this.#kept = kept;
  }

  /** Keeps the container of another scene, of which this is a copy. @internal */
  protected keepContainerOf(other: SceneMembers): void {
    this.#kept = other.container;
  }

  override free(): void {
    super.free();
    this.#kept?.free();
    this.#kept = null;
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
      check(library.gcv_scene_add(this.pointerToChange, polygons, xy, count, ids));
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
      return library.gcv_scene_set(this.pointerToChange, list, 0, xy, count);
    });
  }

  /** Gives a member another polygon, or several members one polygon. They stay where they are. */
  setPolygon(ids: number | readonly number[], polygon: PolygonLike): void {
    withPolygons({ polygon }, (pointer) =>
      this.change(ids, (scratch, list, count) => {
        const polygons = scratch.words(new Array<number>(count).fill(pointer!));
        return library.gcv_scene_set(this.pointerToChange, list, polygons, 0, count);
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
        return library.gcv_scene_set(this.pointerToChange, list, shapes, xy, count);
      }),
    );
  }

  /** Puts members into layers, which questions choose from: a number with a bit for every layer. */
  setLayers(ids: number | readonly number[], layers: number): void {
    const bits = layersOf(layers);
    this.change(ids, (scratch, list, count) => {
      const words = scratch.words(new Array<number>(count).fill(bits));
      return library.gcv_scene_set_layers(this.pointerToChange, list, words, count);
    });
  }

  /** Takes members out. */
  remove(ids: number | readonly number[]): void {
    this.change(ids, (_, list, count) => library.gcv_scene_remove(this.pointerToChange, list, count));
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

  /** The ids of the members that there are now. */
  [Symbol.iterator](): Iterator<number> {
    return this.ids.values();
  }

  /** @internal */
  protected override inWords(): string {
    return counted(this.size, "member") + (this.#kept === null ? "" : " in a container");
  }

  /** The position of a member. */
  position(id: number): Point {
    const [x, y] = renamed(/^ids: number 0/, "id", () => this.positions([idOf(id)]));
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
    const known = BigInt(idOf(id));
    return new Polygon(
      new Made(pointerOf((out) => library.gcv_scene_polygon(this.pointer, known, out))),
    );
  }
}

function withMany<T>(sources: readonly PolygonLike[], use: (pointers: number[]) => T): T {
  return withOperands((operands) => {
    const polygons = elementsOf(sources, "polygons");
    return use(polygons.map((source, k) => operands.polygon(source, `polygons[${k}]`)));
  });
}

/** Ids as they are passed. @internal */
export function idsOf(ids: number | readonly number[], name: string): number[] {
  const isOne = !isList(ids);
  const list = isOne ? [ids] : Array.from(ids);
  const wrong = list.findIndex((id) => !isId(id));
  if (wrong >= 0) {
    throw isOne
      ? unfit(name, ids, "an id, nor an array of them")
      : unfit(`${name}[${wrong}]`, list[wrong], "an id");
  }
  return list;
}

function idOf(id: number): number {
  if (!isId(id)) {
    throw unfit("id", id, "an id");
  }
  return id;
}

function isId(id: number): boolean {
  return Number.isSafeInteger(id) && id >= 0;
}

/** Layers as they are passed. @internal */
export function layersOf(layers: number): number {
  if (!Number.isInteger(layers) || layers < 0 || layers > allLayers) {
    throw unfit("layers", layers, "a number of 32 bits, one for each layer");
  }
  return layers;
}

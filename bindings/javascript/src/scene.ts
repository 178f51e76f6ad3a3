// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scenes of many polygons, and questions about them.

import { unfit } from "./errors.js";
import { Made } from "./handle.js";
import { library, view } from "./library.js";
import { ContactList, PairList } from "./lists.js";
import { doublesAt, pointerOf, withScratch, type Scratch } from "./memory.js";
import { withOperands, type Operands } from "./operands.js";
import {
  callOptions,
  checkOptions,
  madeBy,
  run,
  type CallOptions,
  type LeaveOut,
  type RegionOptions,
} from "./options.js";
import { numberOf, numbersOf, type Point, type Points } from "./points.js";
import type { Box } from "./polygon.js";
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
import { allLayers, idsOf, layersOf, SceneMembers } from "./scene_members.js";
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

const queryOptions = [...callOptions, "layers", "ignore"];
const placeOptions = [...queryOptions, "leaveOut"];
const regionOptions = [...placeOptions, "rounding"];

const querySize = 16;

/**
 * Polygons at positions, the members, and perhaps a container round them. It can change, but not
 * while it is asked, by a progress function; a change that throws leaves it as it was.
 *
 * A member is its polygon moved by its position, exactly. Members have ids 2, 3, 4, ... as they are
 * added; an id is never used again, and the container's is 1. The scene keeps what it needs of the
 * polygons, which can be freed.
 */
export class Scene extends SceneMembers {
  /** A scene with the same members, ids, layers and container. From then on each changes alone. */
  copy(): Scene {
    const made = new Made(pointerOf((out) => library.gcv_scene_copy(this.pointer, out)));
    const scene = new Scene(made);
    scene.keepContainerOf(this);
    return scene;
  }

  /**
   * Where a polygon is free: where it lies in the container and overlaps no member. With a window,
   * what of that lies in it. Without a container there must be a window.
   */
  freeRegion(
    moving: PolygonLike,
    window: Readonly<Box> | null = null,
    options: FreeRegionOptions = {},
  ): Region {
    return this.ask({ moving }, options, regionOptions, (scratch, polygon, query) => {
      const bounds = window === null ? 0 : scratch.doubles(numbersOf(window, 4, "window"));
      return new Region(
        madeBy(scratch, options, (known, out) =>
          library.gcv_scene_free_region(this.pointer, polygon, bounds, query, known, out),
        ),
      );
    });
  }

  /**
   * The free position that is furthest in a direction, null where nothing is free. [-1, 0] places
   * bottom-left: leftmost, and of these lowest. There must be a container. The position overlaps
   * nothing, unless no numbers show what is free: then relation tells.
   */
  best(
    moving: PolygonLike,
    direction: Point,
    options: QueryOptions & Pick<RegionOptions, "leaveOut"> = {},
  ): Point | null {
    return this.ask({ moving }, options, placeOptions, (scratch, polygon, query) => {
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
    const call = library.gcv_scene_penetration;
    return this.answer(call, escapeStruct, moving, { positions }, options, placeOptions);
  }

  /** What is no further than a distance from a polygon at a position: pairs of an id and 0. */
  near(
    moving: PolygonLike,
    position: Point,
    distance = 0,
    options: QueryOptions = {},
  ): PairList {
    return this.ask({ moving }, options, queryOptions, (scratch, polygon, query) => {
      const place = scratch.doubles(numbersOf(position, 2, "position"));
      const limit = numberOf(distance, "distance");
      return new PairList(
        madeBy(scratch, options, (known, out) =>
          library.gcv_scene_near(this.pointer, polygon, place, limit, query, known, out),
        ),
      );
    });
  }

  /**
   * All pairs of members, and of the container and a member, no further than a distance from each
   * other. With an earlier list of this scene, what has not moved since is not computed again.
   */
  pairs(distance = 0, previous: PairList | null = null, options: QueryOptions = {}): PairList {
    return this.ask({}, options, queryOptions, (scratch, _, query, operands) => {
      const limit = numberOf(distance, "distance");
      const earlier = pointerOfPrevious(previous, PairList, operands);
      return new PairList(
        madeBy(scratch, options, (known, out) =>
          library.gcv_scene_pairs(this.pointer, earlier, limit, query, known, out),
        ),
      );
    });
  }

  /** The contacts of all pairs, within a distance: those of contacts(). `previous` as in pairs. */
  contacts(
    distance = 0,
    slope = 0,
    previous: ContactList | null = null,
    options: QueryOptions = {},
  ): ContactList {
    return this.ask({}, options, queryOptions, (scratch, _, query, operands) => {
      const limits = [numberOf(distance, "distance"), numberOf(slope, "slope")];
      const earlier = pointerOfPrevious(previous, ContactList, operands);
      return new ContactList(
        madeBy(scratch, options, (known, out) =>
          library.gcv_scene_contacts(this.pointer, earlier, ...limits, query, known, out),
        ),
      );
    });
  }

  private answer<T>(
    call: (...values: number[]) => number,
    struct: Struct<T>,
    moving: PolygonLike,
    vectors: Record<string, Point | Points>,
    options: QueryOptions & EscapeOptions,
    names = queryOptions,
  ): T | T[] {
    return this.ask({ moving }, options, names, (scratch, polygon, query) =>
      answer(scratch, struct, vectors, options, (pointers, count, known, out) =>
        call(this.pointer, polygon, ...pointers, count, query, known, out),
      ),
    );
  }

  private ask<T>(
    sources: { moving?: PolygonLike },
    options: QueryOptions,
    names: string[],
    use: (scratch: Scratch, moving: number, query: number, operands: Operands) => T,
  ): T {
    checkOptions(options, names);
    const { layers = allLayers, ignore = [] } = options;
    return withOperands((operands) =>
      withScratch((scratch) => {
        operands.use(this);
        const [moving = 0] = operands.pointers(sources as Record<string, PolygonLike>);
        const ids = idsOf(ignore, "ignore");
        const query = scratch.room(querySize);
        const ignored = scratch.ids(ids);
        [querySize, layersOf(layers), ignored, ids.length].forEach((word, k) =>
          view().setUint32(query + 4 * k, word, true),
        );
        return use(scratch, moving, query, operands);
      }),
    );
  }
}

/** The pointer of an earlier list of that kind, 0 for none. */
function pointerOfPrevious(
  previous: PairList | ContactList | null,
  Kind: typeof PairList | typeof ContactList,
  operands: Operands,
): number {
  if (previous === null) {
    return 0;
  }
  if (!(previous instanceof Kind)) {
    throw unfit("previous", previous, `a ${Kind.name}`);
  }
  return operands.use(previous).pointer;
}

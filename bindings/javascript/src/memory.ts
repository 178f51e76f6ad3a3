// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Memory of the library for the arguments and the results of a call.

import { errorOf, Status, type GcvError } from "./errors.js";
import { library, view } from "./library.js";

/** Blocks of memory that end together. */
export class Scratch {
  readonly #blocks: number[] = [];

  /** Room for so many bytes, aligned for any number. */
  room(bytes: number): number {
    const pointer = bytes < 2 ** 32 ? library.malloc(bytes) : 0;
    if (pointer === 0) {
      throw failure(Status.NO_MEMORY, `there is no memory for ${bytes} bytes`);
    }
    this.#blocks.push(pointer);
    return pointer;
  }

  doubles(values: ArrayLike<number>): number {
    return this.joined([values]);
  }

  /** The doubles of lists, one list after the other. */
  joined(lists: readonly ArrayLike<number>[]): number {
    const count = lists.reduce((sum, list) => sum + list.length, 0);
    const pointer = this.room(8 * count);
    const room = new Float64Array(library.memory.buffer, pointer, count);
    let at = 0;
    for (const list of lists) {
      room.set(list, at);
      at += list.length;
    }
    return pointer;
  }

  /** Pointers, sizes or numbers of 32 bits. */
  words(values: ArrayLike<number>): number {
    const pointer = this.room(4 * values.length);
    new Uint32Array(library.memory.buffer, pointer, values.length).set(values);
    return pointer;
  }

  ids(values: readonly number[]): number {
    const pointer = this.room(8 * values.length);
    new BigUint64Array(library.memory.buffer, pointer, values.length).set(values.map(BigInt));
    return pointer;
  }

  bytes(values: Uint8Array): number {
    const pointer = this.room(values.length);
    new Uint8Array(library.memory.buffer, pointer, values.length).set(values);
    return pointer;
  }

  free(): void {
    this.#blocks.forEach((pointer) => library.free(pointer));
  }
}

/** What use() gives, with memory that ends after it. */
export function withScratch<T>(use: (scratch: Scratch) => T): T {
  const scratch = new Scratch();
  try {
    return use(scratch);
  } finally {
    scratch.free();
  }
}

const decoder = new TextDecoder();

function textAt(pointer: number): string {
  const bytes = new Uint8Array(library.memory.buffer, pointer);
  return decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
}

/** The message of the last failure. */
export function lastMessage(): string {
  return textAt(library.gcv_last_error_message());
}

/** Throws the error of a status other than 0. */
export function check(status: number): void {
  if (status !== 0) {
    throw failure(status as Status, lastMessage());
  }
}

/** The error of a status, with what helps where there is no memory. */
export function failure(status: Status, message: string): GcvError {
  const help = "free() ends objects at once, garbage ends between turns of the event loop alone";
  return errorOf(status, status === Status.NO_MEMORY ? `${message}; ${help}` : message);
}

export function version(): string {
  return textAt(library.gcv_version_string());
}

/** The pointer that call(out) writes. */
export function pointerOf(call: (out: number) => number): number {
  return withScratch((scratch) => {
    const out = scratch.room(4);
    check(call(out));
    return view().getUint32(out, true);
  });
}

/** The double that call(out) writes. */
export function doubleOf(call: (out: number) => number): number {
  return withScratch((scratch) => {
    const out = scratch.room(8);
    check(call(out));
    return view().getFloat64(out, true);
  });
}

type BufferCall = (out: number, capacity: number, required: number) => number;

/** What read(pointer, count) makes of the elements of a buffer function. */
function elements<T>(call: BufferCall, size: number, read: (pointer: number, count: number) => T): T {
  return withScratch((scratch) => {
    const required = scratch.room(4);
    check(call(0, 0, required));
    const count = view().getUint32(required, true);
    const out = scratch.room(Math.max(1, count * size));
    check(call(out, count, required));
    return read(out, count);
  });
}

/** The coordinates x0, y0, x1, y1, ... that a buffer function gives. */
export function coordinatesOf(call: BufferCall): Float64Array {
  return elements(call, 16, (out, count) => doublesAt(out, 2 * count));
}

/** The structs of a buffer function, each made by read(pointer). */
export function structsOf<T>(call: BufferCall, size: number, read: (pointer: number) => T): T[] {
  return elements(call, size, (out, count) => structsAt(out, size, count, read));
}

/** The text of a buffer function, without its final NUL. */
export function textOf(call: BufferCall): string {
  return elements(call, 1, textAt);
}

/** A copy of doubles of the library. */
export function doublesAt(pointer: number, count: number): Float64Array {
  return new Float64Array(library.memory.buffer, pointer, count).slice();
}

/** The structs at a pointer, each made by read(pointer). */
export function structsAt<T>(
  pointer: number,
  size: number,
  count: number,
  read: (pointer: number) => T,
): T[] {
  return Array.from({ length: count }, (_, k) => read(pointer + k * size));
}

/** An integer of 64 bits: an id, an index or a count. */
export function integerAt(pointer: number): number {
  return Number(view().getBigUint64(pointer, true));
}

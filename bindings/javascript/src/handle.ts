// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
/// <reference lib="esnext.disposable" preserve="true" />
//
// What all objects of the library have in common.

import { InputError, Status } from "./errors.js";
import { library } from "./library.js";

/** The name of the function that ends an object. */
type Destroy = `gcv_${string}_destroy`;

/** An object of the library that was just made: whoever takes it ends it. */
export class Made {
  constructor(readonly pointer: number) {}
}

/** "1 vertex", "2 vertices". @internal */
export const counted = (count: number, one: string, many = `${one}s`) => `${count} ${count === 1 ? one : many}`;

const registry = new FinalizationRegistry<[Destroy, number]>(([destroy, pointer]) =>
  library[destroy](pointer),
);

/**
 * An object of the library, in the memory of its WebAssembly module.
 *
 * free() ends it at once, and so does `using`. Otherwise it ends at some time after the garbage
 * collector has found that nothing refers to it.
 */
export abstract class Handle {
  #pointer: number;
  readonly #destroy: Destroy;
  readonly #facts = new Map<string, unknown>();

  protected constructor(made: Made, destroy: Destroy) {
    this.#pointer = made.pointer;
    this.#destroy = destroy;
    registry.register(this, [destroy, made.pointer], this);
  }

  /** @internal */
  get pointer(): number {
    if (this.#pointer === 0) {
      throw new InputError(
        Status.INVALID_ARGUMENT,
        `${this.constructor.name}: it was freed, and cannot be used any more`,
      );
    }
    return this.#pointer;
  }

  /** What ask() gives, asked once. @internal */
  protected known<T>(name: string, ask: (pointer: number) => T): T {
    const pointer = this.pointer;
    if (!this.#facts.has(name)) {
      this.#facts.set(name, ask(pointer));
    }
    return this.#facts.get(name) as T;
  }

  /** What it holds, in a few words. @internal */
  protected abstract inWords(): string;

  /** What console.log() shows in Node. */
  [Symbol.for("nodejs.util.inspect.custom")](): string {
    return `<${this.constructor.name}${this.isFreed ? ", freed" : ` of ${this.inWords()}`}>`;
  }

  /** Whether free() was called. */
  get isFreed(): boolean {
    return this.#pointer === 0;
  }

  /** Ends the object and gives its memory back. A second call does nothing. */
  free(): void {
    if (this.#pointer !== 0) {
      registry.unregister(this);
      library[this.#destroy](this.#pointer);
      this.#pointer = 0;
      this.#facts.clear();
    }
  }
}

export interface Handle {
  /** Does free(), at the end of a block with `using`. */
  [Symbol.dispose](): void;
}

// Node 18 and some browsers have no such symbol.
if (typeof Symbol.dispose === "symbol") {
  Object.defineProperty(Handle.prototype, Symbol.dispose, {
    value(this: Handle) {
      this.free();
    },
  });
}

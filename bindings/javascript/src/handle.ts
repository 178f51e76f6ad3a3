// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
/// <reference lib="esnext.disposable" preserve="true" />
//
// What all objects of the library have in common.

import { InputError, Status, words } from "./errors.js";
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
 * collector has found that nothing refers to it, between two turns of the event loop. While a call
 * uses an object, it can be neither freed nor changed by what the call calls, such as its progress
 * function: that throws an InputError.
 */
export abstract class Handle {
  #pointer: number;
  /** How many calls use it and have not returned. */
  #calls = 0;
  readonly #destroy: Destroy;
  #facts: Map<string, unknown> | undefined;

  protected constructor(made: Made, destroy: Destroy) {
    this.#pointer = made.pointer;
    this.#destroy = destroy;
    registry.register(this, [destroy, made.pointer], this);
  }

  /** @internal */
  get pointer(): number {
    if (this.#pointer === 0) {
      throw this.refusal("it was freed, and cannot be used any more");
    }
    return this.#pointer;
  }

  /** The same, for a call that changes the object. @internal */
  protected get pointerToChange(): number {
    this.refuseInUse("changed");
    return this.pointer;
  }

  /** A call begins to use it: nothing frees or changes it before release(). @internal */
  hold(): void {
    ++this.#calls;
  }

  /** That call returns. @internal */
  release(): void {
    --this.#calls;
  }

  private refuseInUse(what: string): void {
    if (this.#calls !== 0) {
      throw this.refusal(`it is in use by a call that has not returned, and cannot be ${what}`);
    }
  }

  private refusal(reason: string): InputError {
    return new InputError(Status.INVALID_ARGUMENT, `${this.constructor.name}: ${reason}`);
  }

  /** What ask() gives, asked once. @internal */
  protected known<T>(name: string, ask: (pointer: number) => T): T {
    const pointer = this.pointer;
    this.#facts ??= new Map();
    if (!this.#facts.has(name)) {
      this.#facts.set(name, ask(pointer));
    }
    return this.#facts.get(name) as T;
  }

  /** What it holds, in a few words. @internal */
  protected abstract inWords(): string;

  /** @internal */
  get [words](): string {
    return `<${this.constructor.name}${this.isFreed ? ", freed" : ` of ${this.inWords()}`}>`;
  }

  /** What console.log() shows in Node. */
  [Symbol.for("nodejs.util.inspect.custom")](): string {
    return this[words];
  }

  /** What it is, in a few words. */
  toString(): string {
    return this[words];
  }

  /** Whether free() was called. */
  get isFreed(): boolean {
    return this.#pointer === 0;
  }

  /**
   * Ends the object and gives its memory back. A second call does nothing. Throws while a call uses
   * the object.
   */
  free(): void {
    if (this.#pointer !== 0) {
      this.refuseInUse("freed");
      registry.unregister(this);
      library[this.#destroy](this.#pointer);
      this.#pointer = 0;
      this.#facts = undefined;
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

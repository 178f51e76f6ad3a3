// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions to the worker.

/**
 * @template T
 * @typedef {{ answer: T, milliseconds: number }} Answered
 */

export class Answers {
  #worker;
  #ready;
  #last = 0;
  #open = /** @type {Map<number, { done: (value: any) => void, fail: (error: Error) => void }>} */ (
    new Map()
  );
  #isBusy = false;
  #next = /** @type {(() => void) | null} */ (null);

  constructor() {
    this.#worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    /** @type {(value?: unknown) => void} */
    let isReady = () => {};
    this.#ready = new Promise((done, fail) => {
      isReady = done;
      this.#worker.onerror = (event) => fail(new Error(event.message || "The worker cannot be loaded."));
    });
    this.#worker.onmessage = ({ data: { id, answer, milliseconds, problem } }) => {
      if (id === 0) {
        isReady();
        return;
      }
      const asked = this.#open.get(id);
      this.#open.delete(id);
      if (problem === undefined) {
        asked?.done({ answer, milliseconds });
      } else {
        asked?.fail(new Error(problem));
      }
    };
  }

  /** @param {string} name @param {unknown} question @returns {Promise<Answered<any>>} */
  async ask(name, question) {
    await this.#ready;
    const id = ++this.#last;
    return new Promise((done, fail) => {
      this.#open.set(id, { done, fail });
      this.#worker.postMessage({ id, name, question });
    });
  }

  /**
   * Asks as soon as the answer before has come. Of questions that wait, only the newest is asked.
   * @param {string} name @param {() => unknown} question made when it is asked
   * @param {(answered: Answered<any>) => void} show @param {(error: Error) => void} fail
   */
  live(name, question, show, fail) {
    if (this.#isBusy) {
      this.#next = () => this.live(name, question, show, fail);
      return;
    }
    this.#isBusy = true;
    this.ask(name, question())
      .then(show, fail)
      .finally(() => {
        this.#isBusy = false;
        const next = this.#next;
        this.#next = null;
        next?.();
      });
  }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The library as a WebAssembly module: where it is loaded, and its memory.

type Exports = {
  memory: WebAssembly.Memory;
} & Record<`gcv_${string}` | "malloc" | "free" | "_initialize", (...values: (number | bigint)[]) => number>;

// A module of one function, which gives a SIMD vector. It is valid where SIMD instructions are.
const simdProbe = [
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15,
  253, 98, 11,
];

const url = WebAssembly.validate(new Uint8Array(simdProbe))
  ? new URL("./gcv-simd.wasm", import.meta.url)
  : new URL("./gcv.wasm", import.meta.url);

/** What calls of the library report to. One call can run inside the progress function of another. */
let report: ((done: number, estimate: number) => boolean) | undefined;

const imports = {
  gcv: { progress: (done: number, estimate: number) => (report?.(done, estimate) ? 1 : 0) },
  env: { emscripten_notify_memory_growth() {} },
  wasi_snapshot_preview1: {
    proc_exit(status: number) {
      throw new Error(`gcv: the WebAssembly module ended with status ${status}`);
    },
    // The library reads neither clocks nor environments; its standard library could.
    clock_time_get: () => 0,
    environ_get: () => 0,
    environ_sizes_get(count: number, size: number) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
  },
};

async function load(): Promise<Exports> {
  if (url.protocol === "file:") {
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:fs/promises");
    const { instance } = await WebAssembly.instantiate(await readFile(url), imports);
    return instance.exports as Exports;
  }
  const response = await fetch(url);
  if (!response.ok) {
    throw new Error(`gcv: ${url} cannot be loaded: status ${response.status}`);
  }
  const { instance } = await WebAssembly.instantiate(await response.arrayBuffer(), imports);
  return instance.exports as Exports;
}

/** The functions of the C interface, and its memory. */
export const library: Exports = await load();

let current = new DataView(library.memory.buffer);

/** The memory of the library. Calls can make it grow, and a view that was taken before is lost. */
export function view(): DataView {
  if (current.buffer !== library.memory.buffer) {
    current = new DataView(library.memory.buffer);
  }
  return current;
}

library._initialize();

/** Calls work() while what the library reports goes to progress. */
export function reporting<T>(progress: typeof report, work: () => T): T {
  const before = report;
  report = progress;
  try {
    return work();
  } finally {
    report = before;
  }
}

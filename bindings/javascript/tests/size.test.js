// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { brotliCompressSync } from "node:zlib";

for (const name of ["gcv-simd", "gcv"]) {
  test(`${name}.wasm has less than 350 KiB by Brotli`, () => {
    const module = readFileSync(new URL(`../dist/${name}.wasm`, import.meta.url));
    assert.ok(brotliCompressSync(module).length < 350 * 1024);
  });
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where there are types of browsers, or of Node.
import * as gcv from "gcv";

const { signal }: { signal: AbortSignal } = new AbortController();
export const area: number = gcv.minkowskiSum([], [], { signal }).area;

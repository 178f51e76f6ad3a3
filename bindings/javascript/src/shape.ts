// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What polygons, outer faces and regions have in common.

import { Handle, Made } from "./handle.js";

/** Rings of doubles, which never change. */
export abstract class Shape extends Handle {
  /** The polygon that it is, as a new object, with its numbers of vertices. @internal */
  abstract polygonMade(): Made;
}

/*
 * svg.h - a picture of two polygons and the region of their sum.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef EXAMPLES_SVG_H
#define EXAMPLES_SVG_H

#include <gcv/gcv.h>
#include <stdbool.h>
#include <stdio.h>

/** Parts of the plane: rings, segments and points. Rings are not closed. */
typedef struct parts {
  gcv_region_part *list;
  size_t count;
  double *xy; /**< the vertices of all parts, x0 y0 x1 y1 ... */
  size_t vertex_count;
} parts;

/** How many parts are of a kind, one of GCV_PART_... */
size_t count_parts(const parts *p, int32_t kind);

typedef struct picture {
  parts a, b, sum;
  /** What the edge from each vertex of the sum comes from. */
  const gcv_edge_source *sources;
  /** The sum is the no-fit region of A and B with this reference point of B. */
  bool no_fit;
  double reference[2];
} picture;

/**
 * Draws A and B at the left and the sum at the right, all at one scale, the y axis
 * up. Any finite coordinates will do. Write errors are left to the caller: they
 * show in ferror(file).
 */
void write_svg(FILE *file, const picture *p);

#endif

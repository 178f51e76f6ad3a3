/*
 * svg.h - a picture of two polygons and the outer face of their sum.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef EXAMPLES_SVG_H
#define EXAMPLES_SVG_H

#include <gcv/gcv.h>
#include <stdbool.h>
#include <stdio.h>

/** A ring of vertices, x0 y0 x1 y1 ..., not closed. */
typedef struct ring {
  double *xy;
  size_t count;
} ring;

typedef struct picture {
  ring a, b, sum;
  /** What each edge of the sum comes from, or NULL: then all have one colour. */
  const gcv_edge_source *sources;
  /** The sum is the no-fit polygon of A and B with this reference point of B. */
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

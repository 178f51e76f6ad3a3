// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Tables of the times of whole regions, printed in Markdown. A quick run has fewer and smaller
// pairs.
#pragma once

namespace gcv::bench {

// The real pairs and coasts, each beside the outer face and CGAL's reduced convolution.
void print_pairs(bool quick);

// Parts of nesting instances and small random polygons, likewise: what is usual and what is worst.
// Beside them, regions that leave out everything but the outer ring.
void print_samples(bool quick);

// Coasts of growing size: what a vertex costs.
void print_growth(bool quick);

// Families of pairs in the eight positions of the square, exchanged, and stretched.
void print_positions(bool quick);

}  // namespace gcv::bench

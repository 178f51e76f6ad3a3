/*
 * gcv.h - Minkowski sums of two polygons, exactly: outer faces and whole regions.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The Minkowski sum of two polygons A and B is A + B = { a + b : a in A, b in B }. Polygons
 * may have holes. There are two answers:
 *
 * - A gcv_outer_face is the boundary of the unbounded face outside of the sum: one simple
 *   ring, after the paper
 *   "Generalized Contributing Vertices-Based Method for Minkowski Sum Outer-Face of Two Polygons".
 *   The ring says nothing about the inside of the sum.
 * - A gcv_region is the whole sum: its outer ring, its holes, and the segments and points
 *   where one polygon fits the other exactly.
 *
 * The no-fit polygon of nesting codes and the entrance block of contact detection are the
 * same sums with one polygon reflected. The inner-fit region is where a polygon may go inside
 * a container.
 *
 * Two polygons overlap if their interiors meet. Else they are apart or touch: a position
 * where they do not overlap is free. A gcv_scene holds many polygons at positions, and perhaps
 * a container round them.
 *
 * Exactness. Every coordinate is a finite double and stands for exactly that
 * number. Every decision of the computation is exact for every such input. There is
 * no epsilon, and no tolerance unless the caller asks for one. Only the coordinates
 * that are returned as doubles are rounded, each once. Each function says how.
 *
 * Reproducibility. The same input gives the same bits on every run, thread,
 * compiler and optimisation level. The rounding mode, flush-to-zero and exception
 * flags of the caller's floating-point environment neither change a result nor are
 * changed by a call.
 *
 * Threads. Handles are immutable once created, but for scenes: any number of threads may use
 * one const handle at a time. Destroy a handle when no thread uses it any more. A stack of
 * 256 KB is enough for every call: numbers of all magnitudes take some 140 KB of it.
 *
 * Errors. Functions that can fail return a gcv_status. A function that fails writes
 * nothing to its outputs, except *required of the buffer functions. Nothing aborts,
 * throws, prints, or keeps global state. A count that no array can have is
 * GCV_ERR_INVALID_ARGUMENT. With count 0 no array is read or written; questions about
 * polygons, regions and scenes check handles, options and queries all the same.
 *
 * Ownership. A handle given through an output argument belongs to the caller, who
 * ends it with the matching destroy function. Destroying NULL does nothing. Handles
 * do not depend on one another: a polygon may be destroyed before an outer face or a region
 * that was computed from it. Where an array of `const gcv_polygon *` is taken, C wants a cast of
 * an array of `gcv_polygon *`: (const gcv_polygon *const *)polygons.
 *
 * Buffers. Buffers are the caller's, and are passed as (out, capacity, &required):
 * capacity counts elements (vertices, edges, or bytes for text). *required is set
 * to the number of elements that there are (for text with its final NUL). With
 * out == NULL and capacity == 0 nothing else happens, and GCV_OK is returned. A
 * capacity below *required writes nothing else and returns
 * GCV_ERR_BUFFER_TOO_SMALL. out == NULL with any other capacity, and
 * required == NULL, are GCV_ERR_NULL_ARGUMENT. Coordinates are x0 y0 x1 y1 ...:
 * a buffer for n vertices holds 2 n doubles.
 */
#ifndef GCV_GCV_H
#define GCV_GCV_H

#include <stddef.h>
#include <stdint.h>

#define GCV_VERSION_MAJOR 0
#define GCV_VERSION_MINOR 2
#define GCV_VERSION_PATCH 0

#if defined(_WIN32) && defined(gcv_EXPORTS)
#define GCV_API __declspec(dllexport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define GCV_API __attribute__((visibility("default")))
#else
#define GCV_API
#endif

#if defined(__GNUC__)
#define GCV_NODISCARD __attribute__((warn_unused_result))
#else
#define GCV_NODISCARD
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- status -- */

/** The result of a call. Values never change. Later versions may add some. */
typedef int32_t gcv_status;

enum {
  /** Done. */
  GCV_OK = 0,
  /** A pointer that must not be NULL is NULL. */
  GCV_ERR_NULL_ARGUMENT = 1,
  /** An argument has a value that it cannot have: an unknown rounding, a stride
   *  below 16 bytes, an index past the end, a struct_size of no known version. */
  GCV_ERR_INVALID_ARGUMENT = 2,
  /** A coordinate of the input is a NaN or an infinity. */
  GCV_ERR_NOT_FINITE = 3,
  /** A polygon without area: fewer than three vertices that are distinct and not
   *  collinear. */
  GCV_ERR_DEGENERATE = 4,
  /** A ring that crosses or touches itself, or rings that lie as they may not; the message names
   *  the two edges. */
  GCV_ERR_NOT_SIMPLE = 5,
  /** The buffer is too small; *required says how large it must be. */
  GCV_ERR_BUFFER_TOO_SMALL = 6,
  /** The result cannot be given in finite doubles. */
  GCV_ERR_RANGE = 7,
  /** The text is not what it should be; the message gives the byte offset. */
  GCV_ERR_PARSE = 8,
  /** There is not enough memory. */
  GCV_ERR_NO_MEMORY = 9,
  /** The caller's progress function ended the computation. */
  GCV_ERR_CANCELLED = 11,
  /** A defect of this library; please report it with the input. */
  GCV_ERR_INTERNAL = 100
};

/**
 * The version of the library that is running: major * 10000 + minor * 100 + patch.
 * Compare it with the GCV_VERSION_* macros, which are those of the header.
 * Threads: any. @since 0.1
 */
GCV_API uint32_t gcv_version_number(void);

/**
 * The version of the library that is running as text, such as "0.2.0".
 *
 * @return never NULL; valid for ever. Threads: any. @since 0.1
 */
GCV_API const char *gcv_version_string(void);

/**
 * The name of a status, such as "GCV_ERR_NOT_SIMPLE".
 *
 * @param status  any value.
 * @return        never NULL, valid for ever; "GCV_ERR_UNKNOWN" for a value that
 *                this version does not know. Threads: any. @since 0.1
 */
GCV_API const char *gcv_status_name(gcv_status status);

/**
 * The message of the last failure on the calling thread. It is one English sentence
 * of at most 511 bytes. It names the polygon, the vertex or edge in the caller's
 * numbers, and the value. Made for people: programs should test the status.
 *
 * @return never NULL; "" before the first failure. Valid, and unchanged by calls
 *         that succeed, until the next failure on this thread. The functions for many
 *         succeed where one of many fails, and have its message. @since 0.1
 */
GCV_API const char *gcv_last_error_message(void);

/* --------------------------------------------------------------- polygons -- */

/** A polygon, validated and prepared: an outer ring, and rings of holes. Opaque, immutable. */
typedef struct gcv_polygon gcv_polygon;

/**
 * Makes a polygon from the vertices of its boundary.
 *
 * The ring may have either orientation. The last vertex may repeat the first.
 * Repeated vertices and vertices on a straight line are accepted and dropped.
 * Messages and gcv_edge_source use the caller's numbers: vertex k as passed, and
 * edge k from vertex k to k+1.
 *
 * @param xy            vertex_count vertices: x of the first is at xy, its y
 *                      right behind it. Any finite doubles, of any alignment;
 *                      read only during the call.
 * @param vertex_count  their number, at most 2^31 - 1.
 * @param stride_bytes  the distance from one vertex to the next, at least 16, or
 *                      0 for 16.
 * @param out           the new polygon, the caller's.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT for xy or out; GCV_ERR_INVALID_ARGUMENT
 *         for the stride or the count; GCV_ERR_NOT_FINITE; GCV_ERR_DEGENERATE;
 *         GCV_ERR_NOT_SIMPLE; GCV_ERR_NO_MEMORY.
 * Exactness: all checks are exact. Cost: O(n log n). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_create(const double *xy, size_t vertex_count,
                                                    size_t stride_bytes, gcv_polygon **out);

/**
 * Makes a polygon from Well-Known Text: "POLYGON ((x y, x y, ...), (hole), ...)".
 *
 * Any letter case and white space; decimal numbers, with a point whatever the locale,
 * with or without exponent, each read as the nearest double. Rings are closed (the first vertex
 * repeated at the end) or not. Holes are kept, and checked as by gcv_polygon_create_rings;
 * version 0.1 left them out. "POLYGON EMPTY" is degenerate.
 *
 * @param text    the text; need not end in NUL.
 * @param length  its length in bytes.
 * @param out     the new polygon, the caller's.
 * @return as gcv_polygon_create, and GCV_ERR_PARSE with the byte offset in the
 *         message, also for a hole of fewer than three vertices. A number too large for a
 *         double is GCV_ERR_NOT_FINITE.
 * Exactness, cost, threads: as gcv_polygon_create. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_create_wkt(const char *text, size_t length,
                                                        gcv_polygon **out);

/**
 * Makes a polygon with holes from the vertices of its rings.
 *
 * Ring 0 is the outer one, the others are holes. Each ring is as in gcv_polygon_create:
 * either orientation, closed or not. Rings may touch one another in single points, even so that
 * the interior falls apart. They may not cross or overlap. Holes lie in the outer ring and
 * outside one another. Numbers of vertices and edges run through all rings as passed, closing
 * and repeated vertices counted.
 *
 * An outer face is that of the outer rings: holes never change it.
 *
 * @param xy            the vertices of all rings, one ring after the other, as in
 *                      gcv_polygon_create.
 * @param ring_sizes    ring_count numbers of vertices, 2^31 - 1 in all at most.
 * @param ring_count    at least 1; 0 is degenerate.
 * @param stride_bytes  the distance from one vertex to the next, at least 16, or
 *                      0 for 16.
 * @param out           the new polygon, the caller's.
 * @return as gcv_polygon_create, with GCV_ERR_NULL_ARGUMENT for ring_sizes too. The message
 *         names the ring. GCV_ERR_NOT_SIMPLE also for rings that cross, overlap, or lie
 *         where they may not; the message names the rings and the edges.
 *         Of collinear edges of a ring, which are checked as one, the first along the
 *         normalised ring: counter-clockwise, holes clockwise.
 * Exactness: all checks are exact. Cost: O(n log n).
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_create_rings(const double *xy,
                                                          const size_t *ring_sizes,
                                                          size_t ring_count, size_t stride_bytes,
                                                          gcv_polygon **out);

/**
 * Makes many polygons of one ring each, such as blocks that turn in every step.
 *
 * @param xy            the vertices of all polygons, one polygon after the other, as in
 *                      gcv_polygon_create.
 * @param sizes         `count` numbers of vertices.
 * @param count         the number of polygons; with 0 nothing is read or written.
 * @param stride_bytes  the distance from one vertex to the next, at least 16, or
 *                      0 for 16.
 * @param out           room for `count` polygons, the caller's; NULL where one failed.
 * @param statuses      room for `count` statuses, each as gcv_polygon_create would return.
 * @return GCV_OK where every polygon was tried: look at the statuses then. The message of
 *         gcv_last_error_message is about the first one that failed, and names it.
 *         Otherwise nothing is written: GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT
 *         for the stride, or for more vertices in all than memory can hold;
 *         GCV_ERR_NO_MEMORY where there is none for the lists themselves.
 * Exactness, cost, threads: as gcv_polygon_create. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_create_many(const double *xy, const size_t *sizes,
                                                         size_t count, size_t stride_bytes,
                                                         gcv_polygon **out, gcv_status *statuses);

/**
 * Makes a convex polygon in place of a disc: for clearances, as part + disc.
 *
 * Every point of its boundary is within `tolerance` of the circle, and every point of the
 * circle within `tolerance` of its boundary. It has fewer than twice as many vertices as are
 * needed for that and for the roundings. Seen from the centre it is the same after quarter
 * turns, but for roundings where the centre has finer digits than the radius.
 *
 * @param centre     x and y, finite.
 * @param radius     in input units, finite, above 0.
 * @param tolerance  in input units, finite, above 0. Some units in the last place of the
 *                   coordinates are needed for roundings.
 * @param rounding   GCV_ROUND_NEAREST, or GCV_ROUND_OUTWARD: then the polygon contains the
 *                   disc.
 * @param out        the new polygon, the caller's.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_NOT_FINITE for the centre or the radius;
 *         GCV_ERR_INVALID_ARGUMENT for a radius or a tolerance that is not above 0, a
 *         tolerance too small for doubles, or the rounding; GCV_ERR_RANGE where a coordinate
 *         of the centre and four radii add up to more than the largest double;
 *         GCV_ERR_NO_MEMORY.
 * Exactness: the tolerance and the containment are certified by exact arithmetic.
 * Cost: O(vertices). About 1.6 sqrt(radius / tolerance) of them are needed, or 2.2 for
 * GCV_ROUND_OUTWARD; there are 4, 8, 16, ... Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_create_disc(const double centre[2], double radius,
                                                         double tolerance, int32_t rounding,
                                                         gcv_polygon **out);

/**
 * The polygon with (x, y) moved to (m[0] x + m[1] y + m[2], m[3] x + m[4] y + m[5]).
 *
 * The numbers of vertices and edges stay, by a reflection too: collinear edges keep the number
 * that they were merged to.
 *
 * @param m    six finite numbers.
 * @param out  the new polygon, the caller's.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_NOT_FINITE for m; GCV_ERR_RANGE where a
 *         coordinate is no finite double; GCV_ERR_DEGENERATE and GCV_ERR_NOT_SIMPLE where
 *         the map or the roundings leave no polygon; GCV_ERR_NO_MEMORY.
 * Exactness: each coordinate is correctly rounded, to nearest, ties to even. Quarter turns,
 * reflections and powers of two are exact so. Cost: O(n log n). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_affine(const gcv_polygon *polygon, const double m[6],
                                                    gcv_polygon **out);

/** Ends a polygon. NULL is allowed. @since 0.1 */
GCV_API void gcv_polygon_destroy(gcv_polygon *polygon);

/**
 * The number of its rings: 1 for the outer one, and 1 for each hole.
 *
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT. Cost: O(1). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_ring_count(const gcv_polygon *polygon, size_t *out);

/**
 * One normalised ring: from its lexicographically smallest vertex, without repeated and
 * without collinear vertices, not closed. The outer ring is counter-clockwise, holes are
 * clockwise: the polygon is on the left of all edges.
 *
 * @param ring      0 for the outer ring, then the holes in the order passed.
 * @param xy        x0 y0 x1 y1 ...: room for `capacity` vertices; or NULL.
 * @param capacity  in vertices.
 * @param required  the number of vertices of the ring.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_INVALID_ARGUMENT for the ring,
 *         GCV_ERR_BUFFER_TOO_SMALL.
 * Exactness: the doubles passed in, unchanged (but -0 is given as 0). Cost: O(n).
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_ring(const gcv_polygon *polygon, size_t ring,
                                                  double *xy, size_t capacity, size_t *required);

/**
 * The number of vertices of the normalised outer ring (see gcv_polygon_vertices).
 *
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT. Cost: O(1). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_vertex_count(const gcv_polygon *polygon, size_t *out);

/**
 * The normalised outer ring: counter-clockwise, from the lexicographically smallest
 * vertex, without repeated and without collinear vertices, not closed.
 *
 * @param xy        x0 y0 x1 y1 ...: room for `capacity` vertices; or NULL.
 * @param capacity  in vertices.
 * @param required  the number of vertices.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Exactness: the doubles passed in, unchanged (but -0 is given as 0). Cost: O(n).
 * Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_vertices(const gcv_polygon *polygon, double *xy,
                                                      size_t capacity, size_t *required);

/**
 * The area of the polygon, without its holes, in square units. Version 0.1 had no holes to
 * subtract.
 *
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_RANGE where the area is larger
 *         than any finite double.
 * Exactness: correctly rounded, to nearest, ties to even; 0 where the area is at
 * most half the smallest double. Cost: O(n). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_area(const gcv_polygon *polygon, double *out);

/**
 * The smallest box around the polygon: xmin, ymin, xmax, ymax.
 *
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT. Exactness: exact. Cost: O(1).
 * Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_bounds(const gcv_polygon *polygon, double out[4]);

/* ---------------------------------------------------------------- options -- */

/** How exact coordinates become doubles: values of gcv_options.rounding. */
enum {
  /** Each coordinate is the double nearest to the exact one, ties to even. Where a
   *  ring would not be simple, or rings would cross, vertices are moved apart by a few units
   *  in the last place, so that the thinnest slit of an exact ring stays open. */
  GCV_ROUND_NEAREST = 0,
  /** A returned sum contains the exact one. A returned inner-fit region lies inside the exact
   *  one. So a part that is placed on a ring never overlaps. Slits and holes thinner than a
   *  few units in the last place close. Segments and points that doubles cannot show exactly
   *  are dropped. */
  GCV_ROUND_OUTWARD = 1
};

/** What a computation leaves out, to save time: bits of gcv_options.leave_out. @since 0.2 */
enum {
  /** The holes of a sum. Not for inner fits and scenes: obstacles would be free there. */
  GCV_LEAVE_OUT_HOLES = 1,
  /** Segments and points: positions where one polygon fits the other exactly. */
  GCV_LEAVE_OUT_FITS = 2
};

/**
 * Options of a computation. Start from GCV_OPTIONS_INIT or gcv_options_init, then
 * set fields. A program compiled with this header keeps working with a later library
 * whose struct has more fields. The running library accepts a struct_size above its
 * own if all bytes that it does not know are 0.
 */
typedef struct gcv_options {
  /** sizeof(gcv_options) as the caller compiled it. */
  uint32_t struct_size;
  /** GCV_ROUND_NEAREST or GCV_ROUND_OUTWARD. */
  int32_t rounding;
  /** How far, in input units, the sum may be from the exact one. Rounding is not
   *  counted. Finite, not negative. Above 0, each polygon is first simplified by at
   *  most half of the tolerance (see gcv_polygon_simplified), if that saves a quarter
   *  of its vertices. The exact ring is then that of the simplified polygons. With
   *  GCV_ROUND_OUTWARD the result still contains the exact sum. Must be 0 for inner fits, for
   *  ways out of overlaps and for scenes. */
  double tolerance;
  /** The number of threads that work on the sum, the calling one included. 1 by
   *  default; 0 for as many as the machine runs at once; above 256 counts as 256; less
   *  than 0 is no number. The result is the same, to the bit, for every number. */
  int32_t threads;
  /** Reports progress, or NULL. Called at the start, at the end, and in between at most
   *  every few thousand steps; now and then while polygons are prepared, too, with the
   *  `done` of before. Called only from the calling thread, in the default
   *  floating-point environment. `done` is the number of steps done. `estimate` is a
   *  guess of the number of all steps, never below `done`. If it returns other than 0,
   *  the computation ends and returns GCV_ERR_CANCELLED. Must return: no longjmp. */
  int32_t (*progress)(void *context, uint64_t done, uint64_t estimate);
  /** Handed to `progress`. */
  void *progress_context;
  /** GCV_LEAVE_OUT_HOLES and GCV_LEAVE_OUT_FITS, added up. 0 by default: a region has all of
   *  its parts. Outer faces have neither: these bits change nothing for them. @since 0.2 */
  uint64_t leave_out;
} gcv_options;

/** The default options, as an initialiser. */
#define GCV_OPTIONS_INIT \
  { sizeof(gcv_options), GCV_ROUND_NEAREST, 0.0, 1, NULL, NULL, 0 }

/** Sets the default options. Writes as many bytes as the struct has in the version that the
 *  program was linked with. NULL is allowed and does nothing. @since 0.1 */
GCV_API void gcv_options_init(gcv_options *options);

/**
 * Sets the default options in a struct of the caller's size, which may be that of an earlier or a
 * later version: for languages that know no macros.
 *
 * @param options      room for struct_size bytes, all of which are written; NULL is allowed and
 *                     does nothing.
 * @param struct_size  sizeof(gcv_options) as the caller has it. Below 16, less than any version
 *                     had, nothing is written.
 * Threads: any. @since 0.2
 */
GCV_API void gcv_options_init_size(gcv_options *options, uint32_t struct_size);

/**
 * Simplifies a polygon: fewer vertices, within a tolerance. For scenes that need no more
 * detail. Made once for a polygon, and used in many sums.
 *
 * The new boundary is simple. Its Hausdorff distance from the given one is at most
 * `tolerance`. With GCV_ROUND_NEAREST its vertices are some of the given ones. With
 * GCV_ROUND_OUTWARD its region contains the given polygon. It may then have new vertices,
 * where edges were lengthened until they meet. Keeps the numbers of the given polygon: a new
 * vertex or edge that replaces several has the number of the first of them. Holes are
 * simplified likewise, and none is lost.
 *
 * @param tolerance    in input units, finite, from 0 on; 0 leaves every vertex.
 * @param rounding     GCV_ROUND_NEAREST or GCV_ROUND_OUTWARD.
 * @param out          the new polygon, the caller's.
 * @param error_bound  at least the Hausdorff distance between the two boundaries; at
 *                     most `tolerance`, and often less.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for the tolerance or
 *         the rounding; GCV_ERR_NO_MEMORY; GCV_ERR_INTERNAL.
 * Exactness: the bound is certified and rounded up; containment is exact.
 * Cost: O(n log n) for most polygons. Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_polygon_simplified(const gcv_polygon *polygon,
                                                        double tolerance, int32_t rounding,
                                                        gcv_polygon **out, double *error_bound);

/* ------------------------------------------------------------- outer face -- */

/** The outer face of a Minkowski sum. Opaque, immutable. */
typedef struct gcv_outer_face gcv_outer_face;

/**
 * The outer face of the Minkowski sum A + B: the boundary of the unbounded
 * component of the plane without A + B. It leaves out what lies inside: holes of the sum, and
 * the segments and points of exact fits. gcv_minkowski_sum_region has all of them.
 *
 * @param a        the polygon A.
 * @param b        the polygon B; the same handle may be given twice.
 * @param options  or NULL for the defaults.
 * @param out      the new outer face, the caller's.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for an option;
 *         GCV_ERR_RANGE where a coordinate of the result is no finite double,
 *         where the result is so small that in doubles it has no area, or, with
 *         GCV_ROUND_OUTWARD, so thin, a few units in the last place of its length, that
 *         no ring of doubles close around it is found;
 *         GCV_ERR_CANCELLED; GCV_ERR_NO_MEMORY; GCV_ERR_INTERNAL.
 * Exactness: the exact ring (gcv_outer_face_exact_vertex) is exact; the doubles of
 * gcv_outer_face_vertices are rounded from it as the options say, and always form a
 * simple ring.
 * Cost: near-linear in the output for most inputs (the walk visits edges on the
 * outer face only). Threads: any. Source: the paper, sections 3 and 4.3 (walking
 * the outer face). @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_minkowski_sum(const gcv_polygon *a, const gcv_polygon *b,
                                                   const gcv_options *options,
                                                   gcv_outer_face **out);

/**
 * The no-fit polygon fixed + (-moving) + reference: where the point `reference`,
 * tied to `moving`, may go while the two polygons touch.
 *
 * With the point outside the exact ring the two polygons are apart. On the ring they
 * touch and do not overlap. Inside the ring they overlap, but not everywhere: holes of
 * the sum lie inside the ring too, and in a hole the polygons are apart. In a slit
 * without width and at a single free point, as where one polygon just fits the other,
 * they touch and do not overlap. The ring has none of these positions, unless they are
 * connected with the outside by a gap, however narrow, in the doubles passed in.
 * gcv_no_fit_region has all of them.
 *
 * @param fixed      the polygon that stays.
 * @param moving     the polygon that goes around it.
 * @param reference  x and y of the reference point of `moving`, finite.
 * @param options    or NULL for the defaults.
 * @param out        the new outer face, the caller's. In its sources, a is an index in
 *                   `fixed` and b one in `moving`.
 * @return as gcv_minkowski_sum, and GCV_ERR_NOT_FINITE for the reference point.
 * Exactness: the reference point is added exactly, before rounding. Cost, threads:
 * as gcv_minkowski_sum. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_no_fit_polygon(const gcv_polygon *fixed,
                                                    const gcv_polygon *moving,
                                                    const double reference[2],
                                                    const gcv_options *options,
                                                    gcv_outer_face **out);

/**
 * Shi's entrance block E(A, B) = { b - a + a0 } = B + (-A) + a0, for contact
 * detection: where the point a0 of block A may go while A and B touch. What holds on the
 * ring, outside and inside of it is as in gcv_no_fit_polygon. gcv_entrance_region has what the
 * ring leaves out.
 *
 * @param a        the block A, which moves.
 * @param b        the block B.
 * @param a0       x and y of the reference point of A, finite.
 * @param options  or NULL for the defaults.
 * @param out      the new outer face, the caller's. In its sources, a is an index
 *                 in `a` and b one in `b`.
 * @return as gcv_no_fit_polygon. Exactness, cost, threads: as there.
 * Source: the paper, section 1 (applications). @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_entrance_block(const gcv_polygon *a, const gcv_polygon *b,
                                                    const double a0[2], const gcv_options *options,
                                                    gcv_outer_face **out);

/**
 * Many sums: out[k] becomes the outer face of a[k] + b[k], for every k below `count`.
 * The pairs are shared out over options->threads threads. A pair that fails leaves the
 * others as they are.
 *
 * @param a         `count` polygons; a handle may occur any number of times.
 * @param b         as many, and likewise.
 * @param count     their number; with 0 nothing is read or written.
 * @param options   for all pairs, or NULL for the defaults.
 * @param out       room for `count` outer faces, the caller's to end; NULL for a pair
 *                  that failed.
 * @param statuses  room for `count` statuses, each as gcv_minkowski_sum would return.
 * @return GCV_OK where every pair was tried: look at the statuses then. The message of
 *         gcv_last_error_message is about the first pair that failed, and names it.
 *         Otherwise nothing is written: GCV_ERR_NULL_ARGUMENT for a, b, out or
 *         statuses; GCV_ERR_INVALID_ARGUMENT for an option; GCV_ERR_CANCELLED;
 *         GCV_ERR_NO_MEMORY where there is none for the lists themselves.
 * Exactness, threads: as gcv_minkowski_sum. Cost: that of the sums. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_minkowski_sum_many(const gcv_polygon *const *a,
                                                        const gcv_polygon *const *b, size_t count,
                                                        const gcv_options *options,
                                                        gcv_outer_face **out, gcv_status *statuses);

/**
 * Many no-fit polygons: out[k] becomes the outer face of fixed[k] + (-moving[k]) + reference
 * k, for every k below `count`, as by gcv_no_fit_polygon.
 *
 * @param fixed       `count` polygons; a handle may occur any number of times.
 * @param moving      as many, and likewise. Each is reflected once.
 * @param references  x0 y0 x1 y1 ...: `count` reference points. One that is not finite fails
 *                    its pair.
 * @param count       the number of pairs; with 0 nothing is read or written.
 * @param options     for all pairs, or NULL for the defaults.
 * @param out         room for `count` outer faces, the caller's to end; NULL for a pair
 *                    that failed.
 * @param statuses    room for `count` statuses, each as gcv_no_fit_polygon would return.
 * @return as gcv_minkowski_sum_many, with GCV_ERR_NULL_ARGUMENT for references too.
 * Exactness, threads: as gcv_no_fit_polygon. Cost: that of the sums. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_no_fit_polygon_many(
    const gcv_polygon *const *fixed, const gcv_polygon *const *moving, const double *references,
    size_t count, const gcv_options *options, gcv_outer_face **out, gcv_status *statuses);

/** Ends an outer face. NULL is allowed. @since 0.1 */
GCV_API void gcv_outer_face_destroy(gcv_outer_face *face);

/**
 * The number of vertices that gcv_outer_face_vertices gives.
 *
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT. Cost: O(1). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_vertex_count(const gcv_outer_face *face,
                                                             size_t *out);

/**
 * The outer boundary in doubles: counter-clockwise, from the lexicographically
 * smallest vertex, no collinear vertices in the exact ring, not closed; a simple
 * ring in these doubles.
 *
 * @param xy        x0 y0 x1 y1 ...: room for `capacity` vertices; or NULL.
 * @param capacity  in vertices.
 * @param required  the number of vertices.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Vertices of the exact ring that fall together in doubles are given once, so there
 * can be fewer vertices than in the exact ring.
 * Exactness: with GCV_ROUND_NEAREST each coordinate is correctly rounded, save those
 * of the vertices that gcv_stats.vertices_repaired counts; with GCV_ROUND_OUTWARD the
 * region contains the exact one; gcv_outer_face_error_bound holds for both. Cost:
 * O(n). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_vertices(const gcv_outer_face *face, double *xy,
                                                         size_t capacity, size_t *required);

/**
 * The number of vertices of the exact ring.
 *
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT. Cost: O(1). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_exact_vertex_count(const gcv_outer_face *face,
                                                                   size_t *out);

/**
 * One vertex of the exact ring as two fractions, "p/q r/s": in lowest terms,
 * denominators positive and always written. The exact ring is counter-clockwise,
 * from its lexicographically smallest vertex, without collinear vertices.
 *
 * @param index     from 0 to the exact vertex count less 1.
 * @param text      room for `capacity` bytes; or NULL.
 * @param capacity  in bytes.
 * @param required  the length of the text with its final NUL.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_INVALID_ARGUMENT for the index,
 *         GCV_ERR_BUFFER_TOO_SMALL, GCV_ERR_NO_MEMORY.
 * Exactness: exact. Cost: O(1) rational operations, at each call. Threads: any.
 * @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_exact_vertex(const gcv_outer_face *face,
                                                             size_t index, char *text,
                                                             size_t capacity, size_t *required);

/** The kind of a superset edge (the paper, section 3): gcv_edge_source.kind. */
enum {
  /** Edge a of A, translated by vertex b of B. */
  GCV_EDGE_TRANSLATED = 1,
  /** Edge b of B, translated by vertex a of A. */
  GCV_EDGE_CORNER = 2,
  /** Edge a of A and edge b of B, which have the same direction, merged. */
  GCV_EDGE_TRANSLATED_CORNER = 3
};

/**
 * Where an edge of the sum comes from. a is a vertex or edge number of A, b one of
 * B, as `kind` says, in the caller's numbers: vertex k as passed, edge k from
 * vertex k to k+1. Merged collinear edges have the number of the first along the
 * normalised ring: counter-clockwise, holes clockwise. A vertex passed several times in
 * a row has its last number. A closing vertex counts as the first one of its ring.
 * In no-fit, entrance and inner-fit functions and in scenes, B is the reflection of the
 * polygon that moves, with the numbers of that: of two merged edges, that of the polygon
 * as passed has the opposite direction. Edges of a container have its solid, all that is
 * outside, on their left: they run backwards.
 */
typedef struct gcv_edge_source {
  int32_t kind;
  uint32_t a;
  uint32_t b;
} gcv_edge_source;

/**
 * The source of every edge of the exact ring: element i is for the edge from exact
 * vertex i to i+1. If several superset edges overlap on the ring, it is one of them,
 * always the same.
 *
 * @param out       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of edges.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL, GCV_ERR_NO_MEMORY.
 * Exactness: exact. Cost: O(n), where n counts the vertices of both polygons and of the
 * ring. If chains of edges are repeated in both polygons, a search for each edge comes on
 * top. Each call finds the sources anew.
 * Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_edge_sources(const gcv_outer_face *face,
                                                             gcv_edge_source *out, size_t capacity,
                                                             size_t *required);

/**
 * The exact vertex that each returned vertex stands for. With it, gcv_outer_face_edge_sources
 * tells where the returned edges come from.
 *
 * If several exact vertices fell together, it is the lowest of their indices. The edges between
 * them have vanished, and the returned edge from there comes from that of the last of them along
 * the ring. They can lie on both sides of the start of the ring. If rounding made a new vertex, it
 * is the start of the exact edge that the returned edge from there lies closest to.
 *
 * @param out       indices for gcv_outer_face_exact_vertex: room for `capacity` elements; or
 *                  NULL.
 * @param capacity  in elements.
 * @param required  the number of vertices, as gcv_outer_face_vertex_count gives it.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL, GCV_ERR_NO_MEMORY.
 * Exactness: exact but for new vertices, where the distance is measured in doubles. Cost:
 * O(n log n), where n counts the vertices of both rings; each call finds the indices anew.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_exact_indices(const gcv_outer_face *face,
                                                              uint64_t *out, size_t capacity,
                                                              size_t *required);

/**
 * An upper bound on the Hausdorff distance between the returned ring and the exact
 * ring, in input units. It is 0 if every exact coordinate is a double. It is at most half a
 * unit in the last place of each coordinate if nothing had to be repaired, and a few units in
 * most other cases. If outward rounding closes a slit, the pocket behind the slit counts: the
 * bound is then as large as the pocket.
 *
 * With a tolerance, the bound includes what the polygons were simplified by, which is often
 * less than the tolerance. It is then a bound between sets. No point of the ring is further
 * than it from the exact sum of the given polygons. No point of that sum is further than it
 * from the region inside the ring. The rings themselves can be further apart where the
 * entrance of a pocket is narrower than twice the bound: the entrance may be open in one
 * of the two sums and closed in the other.
 *
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT.
 * Exactness: a certified bound, rounded up. Cost: O(1). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_error_bound(const gcv_outer_face *face,
                                                            double *out);

/**
 * The area inside the returned ring, in square units.
 *
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_RANGE where the area is larger
 *         than any finite double.
 * Exactness: the area of the ring of doubles, correctly rounded. Cost: O(n).
 * Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_area(const gcv_outer_face *face, double *out);

/**
 * The returned ring as Well-Known Text, "POLYGON ((x y, ..., x y))", closed, each
 * number in the shortest form that reads back as the same double.
 *
 * @param text      room for `capacity` bytes; or NULL.
 * @param capacity  in bytes.
 * @param required  the length of the text with its final NUL.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL,
 *         GCV_ERR_NO_MEMORY.
 * Exactness: reads back to the doubles of gcv_outer_face_vertices. Cost: O(n), at
 * each call. Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_wkt(const gcv_outer_face *face, char *text,
                                                    size_t capacity, size_t *required);

/**
 * The returned ring as a polygon, ready for the next sum.
 *
 * @param out  the new polygon, the caller's; its numbers are those of
 *             gcv_outer_face_vertices.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_NO_MEMORY.
 * Exactness: the doubles of gcv_outer_face_vertices. Cost: O(n log n).
 * Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_polygon(const gcv_outer_face *face,
                                                        gcv_polygon **out);

/** The cost of a computation, in counts, not times. Set struct_size before the call. */
typedef struct gcv_stats {
  /** sizeof(gcv_stats) as the caller compiled it. */
  uint32_t struct_size;
  /** Edges that the walk went along. */
  uint64_t walk_steps;
  /** Superset edges that the walk tested. */
  uint64_t candidate_edges;
  /** Predicates decided by doubles with a proven error bound, or by indices. */
  uint64_t predicates_filtered;
  /** Predicates decided by double-double numbers or by integers of at most 512 bits. */
  uint64_t predicates_fixed_width;
  /** Predicates that needed larger integers, of up to 21,504 bits. None takes heap memory. */
  uint64_t predicates_rational;
  /** Vertices moved further than to the nearest double to keep rings simple and apart. */
  uint64_t vertices_repaired;
  /** Parts of the exact region that are not in the returned one, for doubles cannot show
   *  them. Always 0 for outer faces. @since 0.2 */
  uint64_t parts_dropped;
} gcv_stats;

/**
 * The cost of the computation of this outer face. The counts are the same on every
 * run with the same version of the library and the same number of threads.
 *
 * @param out  with struct_size set; as many bytes as it says are written. A struct of
 *             version 0.1 is filled as far as it goes.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for a
 *         struct_size below that of version 0.1.
 * Cost: O(1). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_outer_face_stats(const gcv_outer_face *face, gcv_stats *out);

/* ---------------------------------------------------------------- regions -- */

/** Polygons with holes, segments and points. Opaque, immutable. @since 0.2 */
typedef struct gcv_region gcv_region;

/** What a part of a region is: gcv_region_part.kind. @since 0.2 */
enum {
  /** The outer ring of a polygon, counter-clockwise. */
  GCV_PART_OUTER = 1,
  /** The ring of a hole in the polygon before it, clockwise. */
  GCV_PART_HOLE = 2,
  /** A segment: two vertices. One polygon fits the other exactly, and has room along a line
   *  only. */
  GCV_PART_SEGMENT = 3,
  /** A point: one vertex. One polygon fits the other exactly, and has no room at all. */
  GCV_PART_POINT = 4
};

/** One part of a region. Never grows. @since 0.2 */
typedef struct gcv_region_part {
  /** GCV_PART_OUTER, GCV_PART_HOLE, GCV_PART_SEGMENT or GCV_PART_POINT. */
  int32_t kind;
  /** The number of the polygon, from 0; UINT32_MAX for segments and points. */
  uint32_t polygon;
  /** The number of vertices of the part. */
  uint64_t vertex_count;
} gcv_region_part;

/** Where a point lies: results of gcv_region_locate. @since 0.2 */
enum { GCV_INSIDE = 1, GCV_BOUNDARY = 0, GCV_OUTSIDE = -1 };

/**
 * The Minkowski sum A + B with all of its holes, and the exact fits in it.
 *
 * The interior of the region is the open sum: the sums of an inner point of A and an inner
 * point of B. Its holes are what the open sum leaves free. A segment or a point of the region
 * is free too, but without free positions beside it: there, A and the reflection of B fit
 * exactly.
 *
 * There is one polygon. Its outer ring is the ring of gcv_minkowski_sum, vertex for vertex. (With
 * a tolerance it can differ, where an outer ring so simplified would cross holes.)
 *
 * @param a        the polygon A, with its holes.
 * @param b        the polygon B, with its holes; the same handle may be given twice.
 * @param options  or NULL for the defaults.
 * @param out      the new region, the caller's.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for an option;
 *         GCV_ERR_RANGE where a coordinate of the result is no finite double,
 *         where the result is so small that in doubles it has no area, or, with
 *         GCV_ROUND_OUTWARD, so thin, a few units in the last place of its length, that
 *         no region of doubles close to it is found;
 *         GCV_ERR_CANCELLED; GCV_ERR_NO_MEMORY; GCV_ERR_INTERNAL.
 * Exactness: the exact parts (gcv_region_exact_parts, gcv_region_exact_vertex) are exact; the
 * doubles of gcv_region_vertices are rounded from them as the options say.
 * Cost: that of gcv_minkowski_sum, and a search along the superset edges that can bound a
 * hole or a fit. GCV_LEAVE_OUT_HOLES and GCV_LEAVE_OUT_FITS together save that search.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_minkowski_sum_region(const gcv_polygon *a,
                                                          const gcv_polygon *b,
                                                          const gcv_options *options,
                                                          gcv_region **out);

/**
 * The no-fit region fixed + (-moving) + reference: where the point `reference`, tied to
 * `moving`, may not go.
 *
 * With the point in the interior of the region and on no segment and no point of it, the two
 * polygons overlap. With the point anywhere else they do not: outside the outer ring and inside
 * the holes they are apart; on the rings, the segments and the points they touch.
 *
 * @param fixed      the polygon that stays, with its holes.
 * @param moving     the polygon that goes around it or into it, with its holes.
 * @param reference  x and y of the reference point of `moving`, finite.
 * @param options    or NULL for the defaults.
 * @param out        the new region, the caller's. In its sources, a is an index in `fixed`
 *                   and b one in `moving`.
 * @return as gcv_minkowski_sum_region, and GCV_ERR_NOT_FINITE for the reference point.
 * Exactness: the reference point is added exactly, before rounding. Cost, threads:
 * as gcv_minkowski_sum_region. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_no_fit_region(const gcv_polygon *fixed,
                                                   const gcv_polygon *moving,
                                                   const double reference[2],
                                                   const gcv_options *options, gcv_region **out);

/**
 * The whole of Shi's entrance block E(A, B) = B + (-A) + a0: where the point a0 of block A may
 * not go. It is gcv_no_fit_region of B and A with other names.
 *
 * @param a        the block A, which moves, with its holes.
 * @param b        the block B, with its holes.
 * @param a0       x and y of the reference point of A, finite.
 * @param options  or NULL for the defaults.
 * @param out      the new region, the caller's. In its sources, a is an index in `a` and b
 *                 one in `b`.
 * @return as gcv_no_fit_region. Exactness, cost, threads: as there.
 * Source: the paper, section 1 (applications). @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_entrance_region(const gcv_polygon *a, const gcv_polygon *b,
                                                     const double a0[2], const gcv_options *options,
                                                     gcv_region **out);

/**
 * The inner-fit region: where the point `reference`, tied to `moving`, may go with `moving`
 * inside the container.
 *
 * Touching the container from inside is allowed. The holes of the container are solid. The
 * region is several polygons with holes, segments and points, or empty. All of it is free, its
 * boundary too.
 *
 * @param container  the polygon that `moving` stays in, with its holes.
 * @param moving     the polygon that moves, with its holes.
 * @param reference  x and y of the reference point of `moving`, finite.
 * @param options    or NULL for the defaults. The tolerance must be 0, and holes cannot be
 *                   left out.
 * @param out        the new region, the caller's. In its sources, a is an index in `container`
 *                   and b one in `moving`.
 * @return as gcv_no_fit_region; GCV_ERR_INVALID_ARGUMENT also for a tolerance above 0 and for
 *         GCV_LEAVE_OUT_HOLES; GCV_ERR_RANGE also where, with GCV_ROUND_OUTWARD, a hole or the room
 *         round it is too thin for doubles. A region without parts is GCV_OK.
 * Exactness: as gcv_no_fit_region; with GCV_ROUND_OUTWARD the returned region lies inside the
 * exact one. Cost: as a sum of the two polygons. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_inner_fit_region(const gcv_polygon *container,
                                                      const gcv_polygon *moving,
                                                      const double reference[2],
                                                      const gcv_options *options, gcv_region **out);

/**
 * Many sums: out[k] becomes the region of a[k] + b[k], for every k below `count`, as by
 * gcv_minkowski_sum_region. The pairs are shared out over options->threads threads. A pair
 * that fails leaves the others as they are.
 *
 * @param a         `count` polygons; a handle may occur any number of times.
 * @param b         as many, and likewise.
 * @param count     their number; with 0 nothing is read or written.
 * @param options   for all pairs, or NULL for the defaults.
 * @param out       room for `count` regions, the caller's to end; NULL for a pair that
 *                  failed.
 * @param statuses  room for `count` statuses, each as gcv_minkowski_sum_region would return.
 * @return as gcv_minkowski_sum_many.
 * Exactness, threads: as gcv_minkowski_sum_region. Cost: that of the sums. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_minkowski_sum_region_many(
    const gcv_polygon *const *a, const gcv_polygon *const *b, size_t count,
    const gcv_options *options, gcv_region **out, gcv_status *statuses);

/**
 * Many no-fit regions: out[k] becomes the region of fixed[k] + (-moving[k]) + reference k, for
 * every k below `count`, as by gcv_no_fit_region.
 *
 * @param fixed       `count` polygons; a handle may occur any number of times.
 * @param moving      as many, and likewise. Each is reflected once.
 * @param references  x0 y0 x1 y1 ...: `count` reference points. One that is not finite fails
 *                    its pair.
 * @param count       the number of pairs; with 0 nothing is read or written.
 * @param options     for all pairs, or NULL for the defaults.
 * @param out         room for `count` regions, the caller's to end; NULL for a pair that
 *                    failed.
 * @param statuses    room for `count` statuses, each as gcv_no_fit_region would return.
 * @return as gcv_minkowski_sum_many, with GCV_ERR_NULL_ARGUMENT for references too.
 * Exactness, threads: as gcv_no_fit_region. Cost: that of the sums. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_no_fit_region_many(const gcv_polygon *const *fixed,
                                                        const gcv_polygon *const *moving,
                                                        const double *references, size_t count,
                                                        const gcv_options *options,
                                                        gcv_region **out, gcv_status *statuses);

/** Ends a region. NULL is allowed. @since 0.2 */
GCV_API void gcv_region_destroy(gcv_region *region);

/**
 * The parts of the region in doubles, in the order of their vertices in gcv_region_vertices:
 * for each polygon its outer ring, then its holes; then the segments; then the points.
 *
 * The order is that of the exact parts, see gcv_region_exact_parts. A part that doubles cannot
 * show is not there. A segment whose ends fall together is a point.
 *
 * @param out       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of parts; 0 for an empty region.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Cost: O(parts). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_parts(const gcv_region *region, gcv_region_part *out,
                                                  size_t capacity, size_t *required);

/**
 * The vertices of all parts in doubles, part after part as gcv_region_parts has them. Rings are
 * not closed.
 *
 * In these doubles every ring is simple, no two rings cross, and holes lie in their polygon.
 * Vertices that fall together are given once. Rings that have become flat or that cross are
 * widened or moved apart by a few units in the last place where that helps; one that stays in
 * the way of others is dropped. What had to move or go is in gcv_region_error_bound, and in
 * gcv_stats.vertices_repaired and gcv_stats.parts_dropped.
 *
 * @param xy        x0 y0 x1 y1 ...: room for `capacity` vertices; or NULL.
 * @param capacity  in vertices.
 * @param required  the number of vertices of all parts.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Exactness: with GCV_ROUND_NEAREST each coordinate is correctly rounded, save those
 * of the vertices that gcv_stats.vertices_repaired counts. With GCV_ROUND_OUTWARD a sum
 * contains the exact one, an inner-fit region lies inside the exact one, and segments and
 * points are exact. Cost: O(n). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_vertices(const gcv_region *region, double *xy,
                                                     size_t capacity, size_t *required);

/**
 * The parts of the exact region. They are canonical: the same set has the same parts, whatever
 * the polygons that it was computed from.
 *
 * Outer rings are counter-clockwise, holes clockwise. Each ring starts in its lexicographically
 * smallest vertex and has no collinear vertices. Polygons, and the holes of one polygon, are in
 * the lexicographic order of that vertex; ties by the vertices that follow. A ring visits no
 * point twice, and bounds one face of the interior. Where two rings touch, each has a vertex
 * only if it has a corner there.
 *
 * The ends of a segment are in lexicographic order, segments in that of their ends, points in
 * their own. Segments are maximal and straight. They are not cut where segments cross, and are
 * cut where they meet a ring. Points lie on no ring and on no segment.
 *
 * @param out       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of parts; 0 for an empty region.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * With a tolerance, the exact region is that of the simplified polygons.
 * Exactness: exact, whatever the rounding. Cost: O(parts). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_exact_parts(const gcv_region *region,
                                                        gcv_region_part *out, size_t capacity,
                                                        size_t *required);

/**
 * One vertex of the exact region as two fractions, "p/q r/s": in lowest terms,
 * denominators positive and always written.
 *
 * @param index     from 0 to the number of vertices of all exact parts less 1; part after part.
 * @param text      room for `capacity` bytes; or NULL.
 * @param capacity  in bytes.
 * @param required  the length of the text with its final NUL.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_INVALID_ARGUMENT for the index,
 *         GCV_ERR_BUFFER_TOO_SMALL, GCV_ERR_NO_MEMORY.
 * Exactness: exact. Cost: O(1) rational operations, at each call. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_exact_vertex(const gcv_region *region, size_t index,
                                                         char *text, size_t capacity,
                                                         size_t *required);

/**
 * The exact vertex that each returned vertex stands for. With it, gcv_region_edge_sources and
 * gcv_region_edge_owners tell where the returned edges come from.
 *
 * If several exact vertices fell together, it is the lowest of their indices. The edges between
 * them have vanished, and the returned edge from there comes from that of the last of them along
 * the ring. They can lie on both sides of the start of the ring. If rounding made a new vertex, it
 * is the start of the exact edge that the returned edge from there lies closest to.
 *
 * @param out       indices for gcv_region_exact_vertex: room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of vertices, as gcv_region_vertices gives it.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Exactness: exact but for new vertices, where the distance is measured in doubles.
 * Cost: O(n). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_exact_indices(const gcv_region *region, uint64_t *out,
                                                          size_t capacity, size_t *required);

/**
 * The source of every edge of the exact region: element i is for the edge from exact vertex i
 * to the next vertex of its part. The second end of a segment and a point have no edge: kind,
 * a and b are 0 there. Of superset edges that overlap one is named; another version of the
 * library may name another. Otherwise as gcv_outer_face_edge_sources.
 *
 * @param out       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of vertices of all exact parts.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL, GCV_ERR_NO_MEMORY.
 * Exactness, cost, threads: as gcv_outer_face_edge_sources. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_edge_sources(const gcv_region *region,
                                                         gcv_edge_source *out, size_t capacity,
                                                         size_t *required);

/**
 * The owner of every edge of the exact region: of a scene, the id of the member that made it, 1 for
 * the container, 0 for a window. Of several that made an edge, or parts of it, one is named.
 * Regions of two polygons come from no scene: all of their owners are 0. So are those of what is no
 * edge, as in gcv_region_edge_sources.
 *
 * @param ids       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of vertices of all exact parts.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Cost: O(n). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_edge_owners(const gcv_region *region, uint64_t *ids,
                                                        size_t capacity, size_t *required);

/**
 * The area of the returned polygons without their holes, in square units. Segments and points
 * have none. 0 for an empty region.
 *
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_RANGE where the area is larger
 *         than any finite double.
 * Exactness: the area of the rings of doubles, correctly rounded. Cost: O(n).
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_area(const gcv_region *region, double *out);

/**
 * An upper bound on the distance between the returned boundary and the exact one, in input
 * units. The boundary is all rings, segments and points. No point of the returned boundary is
 * further than the bound from the exact one. No point of an exact part is further than the
 * bound from what is returned for it. A part that was dropped counts with its extents. It is 0 if
 * every exact coordinate is a double.
 * With a tolerance it is a bound between sets, as in gcv_outer_face_error_bound.
 *
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT.
 * Exactness: a certified bound, rounded up. Cost: O(1). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_error_bound(const gcv_region *region, double *out);

/**
 * The returned polygons as Well-Known Text: always a MULTIPOLYGON, "MULTIPOLYGON (((x y, ...,
 * x y), (hole)), ...)", or "MULTIPOLYGON EMPTY". Rings are closed. Each number has the fewest
 * digits that read back as the same double. Without segments and points. A polygon handle is made
 * of the rings of a part, by gcv_polygon_create_rings: gcv_polygon_create_wkt reads POLYGON alone.
 *
 * @param text      room for `capacity` bytes; or NULL.
 * @param capacity  in bytes.
 * @param required  the length of the text with its final NUL.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL,
 *         GCV_ERR_NO_MEMORY.
 * Exactness: reads back to the doubles of gcv_region_vertices. Cost: O(n), at
 * each call. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_wkt(const gcv_region *region, char *text,
                                                size_t capacity, size_t *required);

/**
 * The returned segments and points as Well-Known Text: "GEOMETRYCOLLECTION (LINESTRING (x y, x
 * y), ..., POINT (x y), ...)", or "GEOMETRYCOLLECTION EMPTY". Otherwise as gcv_region_wkt.
 *
 * @param text      room for `capacity` bytes; or NULL.
 * @param capacity  in bytes.
 * @param required  the length of the text with its final NUL.
 * @return as gcv_region_wkt. Exactness, cost, threads: as there. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_fits_wkt(const gcv_region *region, char *text,
                                                     size_t capacity, size_t *required);

/**
 * One returned polygon with its holes, ready for the next sum.
 *
 * @param polygon  its number, as in gcv_region_part.
 * @param out      the new polygon, the caller's. Its numbers count its vertices in
 *                 gcv_region_vertices, from 0 in each polygon.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for the number;
 *         GCV_ERR_NO_MEMORY.
 * Exactness: the doubles of gcv_region_vertices. Cost: O(n log n). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_polygon(const gcv_region *region, size_t polygon,
                                                    gcv_polygon **out);

/**
 * Where points lie in the exact region.
 *
 * @param xy     x0 y0 x1 y1 ...: `count` points, finite.
 * @param count  their number; with 0 nothing is read or written.
 * @param out    room for `count` elements. Each becomes GCV_INSIDE in the interior of a
 *               polygon, GCV_BOUNDARY on a ring, a segment or a point, else GCV_OUTSIDE. A
 *               hole is outside.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_NOT_FINITE, and the message names the point;
 *         GCV_ERR_NO_MEMORY. On failure no element is written.
 * Exactness: exact, whatever the rounding. Cost: the first call makes an index, O(n log n);
 * then O(log n) a point for most regions. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_locate(const gcv_region *region, const double *xy,
                                                   size_t count, int8_t *out);

/**
 * The cost of the computation of this region. The counts are the same on every run with the
 * same version of the library and the same number of threads.
 *
 * @param out  with struct_size set; as many bytes as it says are written. A struct of
 *             version 0.1 is filled as far as it goes.
 * @return as gcv_outer_face_stats. Cost: O(1). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_region_stats(const gcv_region *region, gcv_stats *out);

/* ----------------------------------------------------------- two polygons -- */

/*
 * Questions about two polygons A and B, of which B is moved by a translation t: B + t, exactly.
 * Its coordinates are sums of two doubles and are never rounded, so a translation may lead beyond
 * the range of doubles. Holes count: B in a hole of A does not overlap A.
 *
 * Each function takes `count` translations at once: x0 y0 x1 y1 ..., finite; with count 0 nothing
 * is read or written. All or nothing: on failure no result is written. Messages name the number of
 * the translation. options.threads share the translations, options.progress counts them.
 * gcv_penetration takes options.leave_out, too, and refuses a tolerance. Other options change
 * nothing, but their values must be valid. The first question to a polygon prepares it, later ones
 * find that done. Only gcv_penetration builds anything for a pair. Where rings of one polygon
 * touch, contacts are named by a vertex there.
 */

/** How two polygons lie. @since 0.2 */
enum {
  /** They have no point in common. */
  GCV_APART = 1,
  /** Their boundaries meet, their interiors do not. */
  GCV_TOUCHING = 0,
  /** Their interiors meet. */
  GCV_OVERLAPPING = -1
};

/** The kinds of contacts. @since 0.2 */
enum {
  /** An edge of A and a vertex of B. */
  GCV_CONTACT_EDGE_VERTEX = 1,
  /** A vertex of A and an edge of B. */
  GCV_CONTACT_VERTEX_EDGE = 2,
  /** A vertex of A and a vertex of B. */
  GCV_CONTACT_VERTEX_VERTEX = 3
};

/** A feature of A and one of B that touch, or would, and where. All 0: none. @since 0.2 */
typedef struct gcv_contact {
  /** GCV_CONTACT_EDGE_VERTEX, GCV_CONTACT_VERTEX_EDGE or GCV_CONTACT_VERTEX_VERTEX. */
  int32_t kind;
  /** The caller's numbers of the vertices or edges, as in gcv_edge_source. */
  uint32_t a, b;
  /** 0. */
  uint32_t reserved;
  /** In answers of scenes the ids of members, or 1 for the container; 0 for all other polygons. */
  uint64_t id_a, id_b;
  /** The distance between the features, correctly rounded; in lists negative where the vertex is
   *  on the solid side of the line of the edge. */
  double gap;
  /** A unit vector, each coordinate within 1 ulp: the normal of the edge, towards B; for two
   *  vertices the direction from that of A to that of B, or 0 0 where they coincide. */
  double normal[2];
  /** The points of the features that are nearest to each other, each coordinate correctly
   *  rounded; that of B in B + t. */
  double on_a[2], on_b[2];
} gcv_contact;

/** How far two polygons are from each other. @since 0.2 */
typedef struct gcv_separation {
  /** The Euclidean distance, correctly rounded; 0 where they touch or overlap. */
  double distance;
  /** GCV_APART, GCV_TOUCHING or GCV_OVERLAPPING: exact. */
  int32_t relation;
  /** 0. */
  uint32_t reserved;
  /** Where the distance is taken; of several, the smallest kind, then a, then b. An end of an edge
   *  counts as a vertex. All 0 where they touch or overlap. */
  gcv_contact nearest;
} gcv_separation;

/** How far a motion leads before the polygons overlap. @since 0.2 */
typedef struct gcv_impact {
  /** 1 if B would overlap A right after `time`, else 0. */
  int32_t hit;
  /** GCV_APART, GCV_TOUCHING or GCV_OVERLAPPING, at `position`: exact. */
  int32_t relation;
  /** The largest part of the motion, in [0, 1], up to which they never overlap, rounded down; 1
   *  without a hit. */
  double time;
  /** A translation of doubles within 2 ulps of the exact one, so that in each coordinate at most
   *  one other double lies between, at which B does not overlap A, if there is one; else the
   *  nearest one. */
  double position[2];
  /** What is hit, with gap 0; of several, the smallest kind, then a, then b. An edge is hit between
   *  its ends. Where two vertices meet, that is their contact, with the normal 0 0: gcv_contacts at
   *  `position` has those of the edges beside them, with a distance of some units in the last place
   *  where `relation` is GCV_APART. All 0 without a hit, and where B overlaps A at the start. */
  gcv_contact contact;
} gcv_impact;

/**
 * How A and B + t lie: apart, touching or overlapping.
 *
 * @param a             the polygon A.
 * @param b             the polygon B; the same handle may be given twice.
 * @param translations  of B: x0 y0 x1 y1 ..., finite.
 * @param count         the number of translations.
 * @param options       threads and progress; or NULL for the defaults.
 * @param out           room for `count` elements: GCV_APART, GCV_TOUCHING or GCV_OVERLAPPING.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for an option;
 *         GCV_ERR_NOT_FINITE; GCV_ERR_NO_MEMORY; GCV_ERR_CANCELLED; GCV_ERR_INTERNAL.
 * Exactness: exact. Cost: O(log n) where the boundaries come near in few places.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_relation(const gcv_polygon *a, const gcv_polygon *b,
                                              const double *translations, size_t count,
                                              const gcv_options *options, int8_t *out);

/**
 * How far B + t is from A, and where they are nearest.
 *
 * @param a             the polygon A.
 * @param b             the polygon B; the same handle may be given twice.
 * @param translations  of B: x0 y0 x1 y1 ..., finite.
 * @param count         the number of translations.
 * @param options       threads and progress; or NULL for the defaults.
 * @param out           room for `count` elements.
 * @return as gcv_relation; GCV_ERR_RANGE where a result is beyond the largest double.
 * Exactness: relation and features are exact, the distance is correctly rounded. It can underflow
 * to 0 while the polygons are apart. Cost: as gcv_relation. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_distance(const gcv_polygon *a, const gcv_polygon *b,
                                              const double *translations, size_t count,
                                              const gcv_options *options, gcv_separation *out);

/**
 * How far B can move from t along a motion before it overlaps A. Sliding along a boundary is no
 * hit. Touching at the end of the motion is none.
 *
 * @param a             the polygon A.
 * @param b             the polygon B; the same handle may be given twice.
 * @param translations  of B at the start: x0 y0 x1 y1 ..., finite.
 * @param motions       of B: from t to t + motion, finite.
 * @param count         the number of translations and of motions.
 * @param options       threads and progress; or NULL for the defaults.
 * @param out           room for `count` elements.
 * @return as gcv_distance.
 * Exactness: hit, contact and relation are exact; the time is rounded down, so B does not overlap
 * A at t + time motion, taken exactly. Cost: as gcv_relation, for the part of the motion up to the
 * hit. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_cast(const gcv_polygon *a, const gcv_polygon *b,
                                          const double *translations, const double *motions,
                                          size_t count, const gcv_options *options,
                                          gcv_impact *out);

/** A way out of an overlap. @since 0.2 */
typedef struct gcv_escape {
  /** The length of the shortest way out, correctly rounded; 0 where they do not overlap. */
  double depth;
  /** The shortest vector v such that B + t + v does not overlap A, each coordinate correctly
   *  rounded; of several, the lexicographically smallest. */
  double translation[2];
  /** A translation of doubles within 2 ulps of t + v, at which B does not overlap A, if there is
   *  one; else the nearest one. */
  double position[2];
  /** GCV_APART, GCV_TOUCHING or GCV_OVERLAPPING, at `position`: exact. */
  int32_t relation;
  /** 0. */
  uint32_t reserved;
  /** The contact at t + v, with gap 0, an edge and a vertex; of several that gcv_contacts gives
   *  there, the smallest kind, then a, then b. All 0 where they do not overlap; and where there is
   *  none, for they touch only where rings of both touch: there a scene gives id_a alone. */
  gcv_contact contact;
} gcv_escape;

/**
 * The nearest translation at which B does not overlap A, for B that overlaps it at t.
 *
 * It may lead into a hole of A, or to an exact fit, where B cannot move further. With
 * options.leave_out the way leads out of what the region without them is: without holes it ends on
 * the outer ring or in a fit, without fits in the closure of a face. Where B does not overlap A at
 * t, the depth is 0 all the same.
 *
 * @param a             the polygon A.
 * @param b             the polygon B; the same handle may be given twice.
 * @param translations  of B: x0 y0 x1 y1 ..., finite.
 * @param count         the number of translations.
 * @param options       threads, progress and leave_out; or NULL for the defaults. A tolerance is
 *                      refused.
 * @param out           room for `count` elements.
 * @return as gcv_distance; GCV_ERR_INVALID_ARGUMENT for a tolerance above 0.
 * Exactness: which place is the nearest is decided exactly; depth, vector and points are correctly
 * rounded. Cost: what is common to all translations, O((n + m) log (n + m)), once a call; then for
 * each that overlaps about the superset edges that are no further than the depth, as far as no
 * others cover them. Where one, or those of a call, have taken about as long as the region would,
 * or both are convex, that is found, once, and each of the others takes O(log (n + m)) as a rule.
 * With holes left out, the outer ring of the sum, once a call.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_penetration(const gcv_polygon *a, const gcv_polygon *b,
                                                 const double *translations, size_t count,
                                                 const gcv_options *options, gcv_escape *out);

/** A list of contacts. Opaque, immutable. */
typedef struct gcv_contact_list gcv_contact_list;

/**
 * The contacts of A and B + t within a distance: those of Definition 1, which touch or would once B
 * were moved along the normal, covered or not.
 *
 * An edge and a vertex: the vertex is convex, and neither of its edges leads to the solid side of
 * the edge. Two vertices: both are convex, and one of them is such a vertex for an edge of the
 * other. The gap of an edge and a vertex is the distance of the vertex from the edge, its ends
 * included; it is negative where the vertex lies on the solid side of the line of the edge. Of two
 * vertices it is their distance. Where two parallel edges face each other at the distance asked
 * for, these are the ends of what they have in common; for larger distances there are more.
 *
 * With a slope s contacts are given too that a turn of one polygon by an angle of at most atan(s)
 * would admit: an edge of the vertex is off the other edge by no more. So faces that are parallel
 * but for rounding keep both their contacts.
 *
 * Polygons that touch have a contact within distance 0, but for polygons that touch only where
 * rings of both touch: there the vertices of each ring can all be reflex.
 *
 * @param a         the polygon A.
 * @param b         the polygon B; the same handle may be given twice.
 * @param t         the translation of B, finite.
 * @param distance  contacts whose |gap| is at most this are given: finite, not negative.
 * @param slope     finite, not negative; 0 for the contacts of Definition 1 alone.
 * @param options   progress, which counts pairs of edges near each other; or NULL.
 * @param out       the new list, the caller's.
 * @return as gcv_distance; GCV_ERR_INVALID_ARGUMENT for a negative distance or slope.
 * Exactness: which contacts there are, and the sign of each gap, is exact; gaps and points are
 * correctly rounded. Cost: as gcv_distance, and the pairs of edges within the distance.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_contacts(const gcv_polygon *a, const gcv_polygon *b,
                                              const double t[2], double distance, double slope,
                                              const gcv_options *options, gcv_contact_list **out);

/** Ends a list of contacts. NULL is allowed. @since 0.2 */
GCV_API void gcv_contact_list_destroy(gcv_contact_list *list);

/**
 * The contacts of a list: by |gap|, then by ids, kind, a, b. No two of them have the same ids,
 * kind, a and b.
 *
 * @param out       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of contacts.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Cost: O(n). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_contact_list_contacts(const gcv_contact_list *list,
                                                           gcv_contact *out, size_t capacity,
                                                           size_t *required);

/**
 * The index of each contact in the earlier list that its list was computed with. It is UINT64_MAX
 * for a contact that was not there, so for all contacts of gcv_contacts, which takes no list. The
 * same contact is that of the same ids, kind, a and b: where a member has got another polygon
 * since, or where copies of a scene have added members of their own, it may have been another
 * polygon's.
 *
 * @param out       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of contacts.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Cost: O(n). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_contact_list_previous(const gcv_contact_list *list,
                                                           uint64_t *out, size_t capacity,
                                                           size_t *required);

/* ------------------------------------------------------------------ scenes -- */

/**
 * Polygons at positions, the members, and perhaps a container round them. Opaque.
 *
 * A member is its polygon moved by its position, exactly: its coordinates are sums of two doubles,
 * which are never rounded. Members may touch and overlap. The solid of a container is all outside
 * of it, and its holes are solid: what lies in the container touches the solid or is apart from it.
 *
 * Members have ids: 2, 3, 4, ... as they are added. An id is never used again. The container's is
 * 1. Members that share a polygon share what is computed for it.
 *
 * A scene is the one object that can change. While one thread changes it, no other may use it.
 * Any number of threads may ask it questions at a time. A progress function must not change the
 * scene that is asked. A change that fails leaves the scene as it was.
 *
 * The same changes in the same order give the same answers, to the bit. @since 0.2
 */
typedef struct gcv_scene gcv_scene;

/** Which members a question is about. @since 0.2 */
typedef struct gcv_query {
  /** sizeof(gcv_query) as the caller compiled it. As with options, a larger one is accepted if all
   *  bytes that the library does not know are 0. */
  uint32_t struct_size;
  /** Members whose layers share a bit with these. The container is in every layer. With 0, there is
   *  neither. */
  uint32_t layers;
  /** Ids of members that are left out, 1 for the container; in any order. Ids that are not there
   *  are no error. NULL where ignore_count is 0. */
  const uint64_t *ignore;
  /** The number of these ids. */
  size_t ignore_count;
} gcv_query;

/** All members but those in no layer, and the container, as an initialiser. So is a query that is
 *  NULL. @since 0.2 */
#define GCV_QUERY_INIT \
  { sizeof(gcv_query), UINT32_MAX, NULL, 0 }

/**
 * A scene without members and container.
 *
 * @param out  the new scene, the caller's.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_NO_MEMORY. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_create(gcv_scene **out);

/**
 * A scene with the same members, ids and container. From then on each changes alone; members that
 * are added to both get the same ids.
 *
 * @param out  the new scene, the caller's.
 * @return as gcv_scene_create. Cost: O(n). Threads: as a question. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_copy(const gcv_scene *scene, gcv_scene **out);

/** Ends a scene. NULL is allowed. @since 0.2 */
GCV_API void gcv_scene_destroy(gcv_scene *scene);

/**
 * Puts a container round the scene, in place of the one that there may be. It may overlap members.
 *
 * @param container  where members are to be; its holes are solid. NULL for none. The scene keeps
 *                   what it needs of it.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_NO_MEMORY. Threads: one. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_set_container(gcv_scene *scene,
                                                         const gcv_polygon *container);

/**
 * Adds members, in every layer.
 *
 * @param polygons   their polygons; the same handle may be given many times. The scene keeps what
 *                   it needs of them.
 * @param positions  x0 y0 x1 y1 ..., finite.
 * @param count      the number of members.
 * @param ids        room for `count` ids, in the order of the polygons.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_NOT_FINITE; GCV_ERR_NO_MEMORY.
 * Cost: O(log n) each, on average; what is new for a polygon is made in O(its vertices).
 * Threads: one. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_add(gcv_scene *scene, const gcv_polygon *const *polygons,
                                               const double *positions, size_t count,
                                               uint64_t *ids);

/**
 * Moves members, or gives them other polygons, or both.
 *
 * @param ids        of the members, each once.
 * @param polygons   the new polygons; NULL to keep all.
 * @param positions  the new positions, x0 y0 x1 y1 ..., finite; NULL to keep all.
 * @param count      the number of members.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for an id that is no member's or
 *         is given twice; GCV_ERR_NOT_FINITE; GCV_ERR_NO_MEMORY.
 * Cost: O(log n) each, on average. Threads: one. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_set(gcv_scene *scene, const uint64_t *ids,
                                               const gcv_polygon *const *polygons,
                                               const double *positions, size_t count);

/**
 * Puts members into layers.
 *
 * @param ids     of the members, each once.
 * @param layers  of each of them: a bit for every layer. A member in no layer is in no answer.
 * @param count   the number of members.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT as gcv_scene_set;
 *         GCV_ERR_NO_MEMORY. Threads: one. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_set_layers(gcv_scene *scene, const uint64_t *ids,
                                                      const uint32_t *layers, size_t count);

/**
 * Takes members out of the scene.
 *
 * @param ids    of the members, each once.
 * @param count  the number of members.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT as gcv_scene_set;
 *         GCV_ERR_NO_MEMORY. Cost: O(log n) each, on average. Threads: one. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_remove(gcv_scene *scene, const uint64_t *ids,
                                                  size_t count);

/**
 * The ids of all members, from the smallest on. The container's is not among them.
 *
 * @param ids       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of members.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_ids(const gcv_scene *scene, uint64_t *ids,
                                               size_t capacity, size_t *required);

/**
 * The positions of members.
 *
 * @param ids    of the members, each once.
 * @param count  the number of members.
 * @param xy     room for `count` positions: x0 y0 x1 y1 ...
 * @return as gcv_scene_set_layers. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_positions(const gcv_scene *scene, const uint64_t *ids,
                                                     size_t count, double *xy);

/**
 * The polygon of a member, where it is before it is moved to its position.
 *
 * @param id   of the member.
 * @param out  a new handle, the caller's.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for an id that is no member's;
 *         GCV_ERR_NO_MEMORY. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_polygon(const gcv_scene *scene, uint64_t id,
                                                   gcv_polygon **out);

/**
 * Where a polygon is free: all positions at which it lies in the container and overlaps no member.
 * It may touch them, and they may touch and overlap one another. It is the inner fit of the
 * container, less the no-fit regions of the members, with every exact fit as a segment or a point:
 * the feasible region of nesting, the free space of motion planning.
 *
 * With a window, the answer is what of that lies in the window: the two-dimensional part is cut and
 * made regular, and segments and points in the window and on its border stay. What the polygon
 * cannot reach from there is not looked at.
 *
 * gcv_region_edge_owners names the member that made each edge. Of the sources, a is in that member
 * or in the container, b in `moving`. Edges that the window has cut have the owner 0 and the kind
 * 0.
 *
 * @param moving   the polygon.
 * @param window   xmin ymin xmax ymax, of positions, finite, xmin < xmax, ymin < ymax; or NULL.
 *                 Without a container, or if the query ignores it, there must be a window.
 * @param query    which members; or NULL for all.
 * @param options  no tolerance, and no holes left out; or NULL for the defaults. With
 *                 GCV_ROUND_OUTWARD the region lies inside the exact one.
 * @param out      a new handle, the caller's.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_INVALID_ARGUMENT for a window, a query, options,
 *         or where neither a window nor a container bounds the region; GCV_ERR_NOT_FINITE;
 *         GCV_ERR_RANGE where a coordinate of the result is no finite double, where the window is
 *         too large, or too far from the rest, for doubles to tell its sides apart, and, with
 *         GCV_ROUND_OUTWARD, where a hole or the room round it is too thin for doubles;
 *         GCV_ERR_CANCELLED; GCV_ERR_NO_MEMORY; GCV_ERR_INTERNAL.
 * Exactness: as gcv_inner_fit_region. Cost: that of the inner fit of a container with all vertices
 * of the members that can be reached. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status
gcv_scene_free_region(const gcv_scene *scene, const gcv_polygon *moving, const double window[4],
                      const gcv_query *query, const gcv_options *options, gcv_region **out);

/**
 * The free position of a polygon that is furthest in a direction: the one of
 * gcv_scene_free_region for which x * direction[0] + y * direction[1] is largest; of several, the
 * lexicographically smallest. Found without the region. Direction -1 0 places bottom-left:
 * leftmost, and of these lowest.
 *
 * The position is in doubles, and the polygon overlaps nothing there. It is within 2 units in the
 * last place of the exact one where such a position is free. Else it is the nearest one that was
 * found on the way into what is free around, within 2^20 units of the larger coordinate. An exact
 * fit that no doubles within 2 units show, as between slanted edges, or between decimal fractions,
 * is passed over, and so is a corner where what is free is narrower than the gaps between doubles,
 * for the corner or fit that is furthest else. Where nothing else is free, out has the doubles
 * nearest to the exact position, and gcv_scene_relation tells GCV_OVERLAPPING there.
 *
 * @param moving     the polygon.
 * @param direction  finite, not 0 0.
 * @param query      which members; or NULL for all. There must be a container, and the query must
 *                   not ignore it.
 * @param options    no tolerance, and no holes left out; with GCV_LEAVE_OUT_FITS positions are
 *                   looked for on the boundary of the two-dimensional part alone; or NULL.
 * @param out        x y of the position; 0 0 where there is none.
 * @param found      1; 0 where the polygon is free nowhere.
 * @return as gcv_scene_free_region.
 * Exactness: which position is the furthest is decided exactly. Cost: that of the superset edges
 * that reach further in the direction. Where a polygon with the same vertices was asked for before,
 * and members were only added since, less of those that reach further than that answer: a scene
 * keeps 256 questions, of polygons with 2^18 vertices in all. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_best(const gcv_scene *scene, const gcv_polygon *moving,
                                                const double direction[2], const gcv_query *query,
                                                const gcv_options *options, double out[2],
                                                int32_t *found);

/**
 * How a polygon at positions lies to the members and the container: GCV_OVERLAPPING if it overlaps
 * one of them, else GCV_TOUCHING if it touches one, else GCV_APART.
 *
 * @param moving     the polygon.
 * @param positions  x0 y0 x1 y1 ..., finite.
 * @param count      the number of positions.
 * @param query      which members; or NULL for all.
 * @param options    threads and progress, no tolerance or holes left out; or NULL for the defaults.
 * @param out        room for `count` elements.
 * @return as gcv_relation; GCV_ERR_INVALID_ARGUMENT for a query, too.
 * Exactness: exact. Cost: O(log n), and gcv_relation for each member whose box comes near.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_relation(const gcv_scene *scene,
                                                    const gcv_polygon *moving,
                                                    const double *positions, size_t count,
                                                    const gcv_query *query,
                                                    const gcv_options *options, int8_t *out);

/**
 * How far a polygon at positions is from the members and the container: gcv_distance from the
 * nearest one. Its contact is as there, with its id in id_a and 0 in id_b, also where the distance
 * is 0. Of several at the same distance, it is the one with the smallest id. The relation is that
 * of gcv_scene_relation. Where there is nothing, the distance is infinite and all others are 0,
 * GCV_APART apart.
 *
 * @param moving     the polygon.
 * @param positions  x0 y0 x1 y1 ..., finite.
 * @param count      the number of positions.
 * @param query      which members; or NULL for all.
 * @param options    threads and progress, no tolerance or holes left out; or NULL for the defaults.
 * @param out        room for `count` elements.
 * @return as gcv_scene_relation; GCV_ERR_RANGE where a result is beyond the largest double.
 * Exactness: as gcv_distance. Cost: O(log n), and gcv_distance for members whose boxes are as near.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_distance(
    const gcv_scene *scene, const gcv_polygon *moving, const double *positions, size_t count,
    const gcv_query *query, const gcv_options *options, gcv_separation *out);

/**
 * How a polygon at positions gets out of all overlaps with members and the container: the shortest
 * translation to a free position, as in gcv_penetration. The contact is with a member that it
 * touches there, its id in id_a; of several, the one with the smallest id. Where it is free
 * already, the depth is 0. Where nothing is free, the depth is infinite, the translation and the
 * contact are 0, the position is the given one, and the relation GCV_OVERLAPPING.
 *
 * @param moving     the polygon.
 * @param positions  x0 y0 x1 y1 ..., finite.
 * @param count      the number of positions.
 * @param query      which members; or NULL for all.
 * @param options    as gcv_scene_best; or NULL for the defaults. Progress counts positions and the
 *                   steps of their searches.
 * @param out        room for `count` elements.
 * @return as gcv_scene_distance; GCV_ERR_INVALID_ARGUMENT for options, too.
 * Exactness: as gcv_penetration. Cost, of each position where there is an overlap: that of the
 * superset edges as near as the way out; and O(n log n) for the n vertices of all solids near it
 * and of the polygon, once for positions in a row that have the same solids near them. Where these
 * are many, the region of these solids is found once. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_penetration(const gcv_scene *scene,
                                                       const gcv_polygon *moving,
                                                       const double *positions, size_t count,
                                                       const gcv_query *query,
                                                       const gcv_options *options, gcv_escape *out);

/**
 * How far a polygon can move along a motion before it overlaps a member or the container: gcv_cast
 * to the first one that is hit. Its id is in id_a of the contact, also for an overlap at the start.
 * Of several that are hit at the same time, it is the one with the smallest id, with its contact:
 * at time 0 it may be touched, beside another one that is overlapped. Position and relation are
 * about the whole scene.
 *
 * @param moving     the polygon.
 * @param positions  at the start: x0 y0 x1 y1 ..., finite.
 * @param motions    from each position to position + motion, finite.
 * @param count      the number of positions and of motions.
 * @param query      which members; or NULL for all.
 * @param options    threads and progress, no tolerance or holes left out; or NULL for the defaults.
 * @param out        room for `count` elements.
 * @return as gcv_scene_distance.
 * Exactness: as gcv_cast. Cost: gcv_cast for the members whose boxes the motion meets.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_cast(const gcv_scene *scene, const gcv_polygon *moving,
                                                const double *positions, const double *motions,
                                                size_t count, const gcv_query *query,
                                                const gcv_options *options, gcv_impact *out);

/** Two members, and how they lie. @since 0.2 */
typedef struct gcv_pair {
  /** Their ids; b is 0 for a polygon that is no member. */
  uint64_t a, b;
  /** GCV_APART, GCV_TOUCHING or GCV_OVERLAPPING: exact. */
  int32_t relation;
  /** 0. */
  uint32_t reserved;
} gcv_pair;

/** A list of pairs. Opaque, immutable. */
typedef struct gcv_pair_list gcv_pair_list;

/**
 * The members, and the container, that are no further than a distance from a polygon at a position:
 * pairs of their ids and 0, from the smallest id on.
 *
 * @param moving    the polygon.
 * @param position  finite.
 * @param distance  finite, not negative.
 * @param query     which members; or NULL for all.
 * @param options   threads and progress, no tolerance or holes left out; or NULL for the defaults.
 * @param out       the new list, the caller's.
 * @return as gcv_scene_relation; GCV_ERR_INVALID_ARGUMENT for a negative distance.
 * Exactness: exact. Cost: as gcv_scene_relation. Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_near(const gcv_scene *scene, const gcv_polygon *moving,
                                                const double position[2], double distance,
                                                const gcv_query *query, const gcv_options *options,
                                                gcv_pair_list **out);

/**
 * All pairs of members, and of the container and a member, that are no further than a distance from
 * each other: with a < b, from the smallest a on, then by b.
 *
 * @param previous  an earlier list of this scene, or of one that it was copied from or to: what has
 *                  not moved since is not computed again. The list is the same as without it. NULL
 *                  for none.
 * @param distance  finite, not negative.
 * @param query     which members; or NULL for all.
 * @param options   threads and progress, no tolerance or holes left out; or NULL for the defaults.
 * @param out       the new list, the caller's.
 * @return as gcv_scene_near; GCV_ERR_INVALID_ARGUMENT for a list of another scene or of
 *         gcv_scene_near.
 * Exactness: exact. Cost: O(n log n), and gcv_distance for pairs whose boxes are as near. With a
 * previous list of the same distance and query, that for members that have changed, and O(n).
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_pairs(const gcv_scene *scene,
                                                 const gcv_pair_list *previous, double distance,
                                                 const gcv_query *query, const gcv_options *options,
                                                 gcv_pair_list **out);

/** Ends a list of pairs. NULL is allowed. @since 0.2 */
GCV_API void gcv_pair_list_destroy(gcv_pair_list *list);

/**
 * The pairs of a list, in its order.
 *
 * @param out       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of pairs.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Cost: O(n). Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_pair_list_pairs(const gcv_pair_list *list, gcv_pair *out,
                                                     size_t capacity, size_t *required);

/**
 * The contacts of all pairs of members, and of the container and members, within a distance: those
 * of gcv_contacts, with the ids in id_a < id_b. `a` is about the one with id_a.
 *
 * @param previous  an earlier list of contacts of this scene, or of one that it was copied from or
 *                  to: what has not moved since is not computed again, and
 *                  gcv_contact_list_previous tells which contacts were there. NULL for none.
 * @param distance  contacts whose |gap| is at most this are given: finite, not negative.
 * @param slope     as in gcv_contacts.
 * @param query     which members; or NULL for all.
 * @param options   threads and progress, no tolerance or holes left out; or NULL for the defaults.
 * @param out       the new list, the caller's: by |gap|, then id_a, id_b, kind, a, b.
 * @return as gcv_scene_pairs; GCV_ERR_RANGE where a result is beyond the largest double.
 * Exactness: as gcv_contacts. Cost: as gcv_scene_pairs, and gcv_contacts for each pair.
 * Threads: any. @since 0.2
 */
GCV_API GCV_NODISCARD gcv_status gcv_scene_contacts(
    const gcv_scene *scene, const gcv_contact_list *previous, double distance, double slope,
    const gcv_query *query, const gcv_options *options, gcv_contact_list **out);

/* --------------------------------------------------------------- superset -- */

/** The explicit superset of the outer face. Opaque, immutable. */
typedef struct gcv_superset gcv_superset;

/** One edge of the superset, from (x0, y0) to (x1, y1). */
typedef struct gcv_superset_edge {
  double x0, y0, x1, y1;
  gcv_edge_source source;
} gcv_superset_edge;

/**
 * The superset of the outer face of A + B that the paper builds (Definition 1 and
 * the three cases of translated-corner edges), after collinear vertices of A and B
 * are dropped. Holes of the polygons are rings like the outer ones, since version 0.2:
 * their edges bound holes of the sum. For plots, for tests and for readers of the paper:
 * sums do not need it, and it can have in the order of n m edges.
 *
 * @param a    the polygon A.
 * @param b    the polygon B.
 * @param out  the new superset, the caller's.
 * @return GCV_OK; GCV_ERR_NULL_ARGUMENT; GCV_ERR_RANGE where a coordinate is no
 *         finite double; GCV_ERR_NO_MEMORY.
 * Exactness: which edges there are is exact; their coordinates are correctly
 * rounded. Cost: O((n + m) log(n + m) + edges). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_superset_create(const gcv_polygon *a, const gcv_polygon *b,
                                                     gcv_superset **out);

/** Ends a superset. NULL is allowed. @since 0.1 */
GCV_API void gcv_superset_destroy(gcv_superset *superset);

/**
 * The edges of the superset: first the translated ones, then the corner edges, then
 * the translated-corner edges, each kind by a, then by b, in the order of the
 * normalised rings.
 *
 * @param out       room for `capacity` elements; or NULL.
 * @param capacity  in elements.
 * @param required  the number of edges.
 * @return GCV_OK, GCV_ERR_NULL_ARGUMENT, GCV_ERR_BUFFER_TOO_SMALL.
 * Exactness: as gcv_superset_create. Cost: O(edges). Threads: any. @since 0.1
 */
GCV_API GCV_NODISCARD gcv_status gcv_superset_edges(const gcv_superset *superset,
                                                    gcv_superset_edge *out, size_t capacity,
                                                    size_t *required);

#ifdef __cplusplus
}
#endif

#endif /* GCV_GCV_H */

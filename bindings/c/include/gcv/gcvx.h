/*
 * gcvx.h - what programs in C would otherwise write around gcv.h, header-only.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * C99 and later; C++11 and later compile it too. Nothing here is part of the library:
 * the functions are compiled into the program that uses them, and call the interface of
 * gcv.h as any program could.
 *
 * Pointer arguments must not be NULL, save handles, which the library refuses itself. On
 * failure nothing is written to the outputs. Memory that is given through an output
 * argument is the caller's to free().
 */
#ifndef GCV_GCVX_H
#define GCV_GCVX_H

#include <errno.h>
#include <gcv/gcv.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  /** A status of this header: the C library could not do something, and errno says why.
   *  No status of gcv.h is below 0. */
  GCVX_ERR_SYSTEM = -1,
  /** The size in bytes that every message of gcvx_message fits in. */
  GCVX_MESSAGE_SIZE = 640
};

/**
 * A status and what it was about, such as "GCV_ERR_NOT_SIMPLE: edge 0 ...", for people.
 *
 * @param status  what a function of this header or of gcv.h has just returned on this
 *                thread.
 * @param text    room for GCVX_MESSAGE_SIZE bytes.
 * @return        text.
 */
static inline const char *gcvx_message(gcv_status status, char *text) {
  if (status == GCV_OK) {
    snprintf(text, GCVX_MESSAGE_SIZE, "%s", gcv_status_name(status));
  } else if (status == GCVX_ERR_SYSTEM) {
    snprintf(text, GCVX_MESSAGE_SIZE, "GCVX_ERR_SYSTEM: %s", strerror(errno));
  } else {
    snprintf(text, GCVX_MESSAGE_SIZE, "%s: %s", gcv_status_name(status), gcv_last_error_message());
  }
  return text;
}

/* A cast of a pointer to void that is one in C++ too. */
#ifdef __cplusplus
#define GCVX_CAST(type, pointer) static_cast<type>(pointer)
#else
#define GCVX_CAST(type, pointer) ((type)(pointer))
#endif

/*
 * The body of a function that gives in *out, allocated, the *count elements that `call`
 * writes: asks for their number, then for them. `call` has (buffer, capacity, &required).
 * Takes one byte more, for malloc(0) may give NULL.
 */
#define GCVX_ALLOCATED(type, element_size, call, out, count)         \
  type *buffer = NULL;                                               \
  size_t capacity = 0, required = 0;                                 \
  gcv_status status = call;                                          \
  if (status != GCV_OK) return status;                               \
  buffer = GCVX_CAST(type *, malloc(required * (element_size) + 1)); \
  if (buffer == NULL) return GCVX_ERR_SYSTEM;                        \
  capacity = required;                                               \
  status = call;                                                     \
  if (status != GCV_OK) {                                            \
    free(buffer);                                                    \
    return status;                                                   \
  }                                                                  \
  *(out) = buffer;                                                   \
  *(count) = required;                                               \
  return GCV_OK

/**
 * gcv_polygon_vertices into memory of its own.
 *
 * @param xy     x0 y0 x1 y1 ...
 * @param count  the number of vertices.
 * @return as gcv_polygon_vertices, and GCVX_ERR_SYSTEM without memory.
 */
GCV_NODISCARD static inline gcv_status gcvx_polygon_vertices(const gcv_polygon *polygon,
                                                             double **xy, size_t *count) {
  GCVX_ALLOCATED(double, 2 * sizeof(double),
                 gcv_polygon_vertices(polygon, buffer, capacity, &required), xy, count);
}

/** gcv_polygon_ring into memory of its own; as gcvx_polygon_vertices. */
GCV_NODISCARD static inline gcv_status gcvx_polygon_ring(const gcv_polygon *polygon, size_t ring,
                                                         double **xy, size_t *count) {
  GCVX_ALLOCATED(double, 2 * sizeof(double),
                 gcv_polygon_ring(polygon, ring, buffer, capacity, &required), xy, count);
}

/** gcv_outer_face_vertices into memory of its own; as gcvx_polygon_vertices. */
GCV_NODISCARD static inline gcv_status gcvx_outer_face_vertices(const gcv_outer_face *face,
                                                                double **xy, size_t *count) {
  GCVX_ALLOCATED(double, 2 * sizeof(double),
                 gcv_outer_face_vertices(face, buffer, capacity, &required), xy, count);
}

/**
 * gcv_outer_face_edge_sources into memory of its own.
 *
 * @param count  the number of edges of the exact ring.
 * @return as gcv_outer_face_edge_sources, and GCVX_ERR_SYSTEM without memory.
 */
GCV_NODISCARD static inline gcv_status gcvx_outer_face_edge_sources(const gcv_outer_face *face,
                                                                    gcv_edge_source **sources,
                                                                    size_t *count) {
  GCVX_ALLOCATED(gcv_edge_source, sizeof(gcv_edge_source),
                 gcv_outer_face_edge_sources(face, buffer, capacity, &required), sources, count);
}

/** gcv_outer_face_exact_indices into memory of its own; as gcvx_outer_face_vertices. */
GCV_NODISCARD static inline gcv_status gcvx_outer_face_exact_indices(const gcv_outer_face *face,
                                                                     uint64_t **indices,
                                                                     size_t *count) {
  GCVX_ALLOCATED(uint64_t, sizeof(uint64_t),
                 gcv_outer_face_exact_indices(face, buffer, capacity, &required), indices, count);
}

/**
 * gcv_superset_edges into memory of its own.
 *
 * @param count  the number of edges.
 * @return as gcv_superset_edges, and GCVX_ERR_SYSTEM without memory.
 */
GCV_NODISCARD static inline gcv_status gcvx_superset_edges(const gcv_superset *superset,
                                                           gcv_superset_edge **edges,
                                                           size_t *count) {
  GCVX_ALLOCATED(gcv_superset_edge, sizeof(gcv_superset_edge),
                 gcv_superset_edges(superset, buffer, capacity, &required), edges, count);
}

/** gcv_outer_face_wkt into memory of its own, or GCVX_ERR_SYSTEM without memory. */
GCV_NODISCARD static inline gcv_status gcvx_outer_face_wkt(const gcv_outer_face *face,
                                                           char **text) {
  size_t size = 0;
  GCVX_ALLOCATED(char, 1, gcv_outer_face_wkt(face, buffer, capacity, &required), text, &size);
}

/** gcv_outer_face_exact_vertex into memory of its own, or GCVX_ERR_SYSTEM without memory. */
GCV_NODISCARD static inline gcv_status gcvx_outer_face_exact_vertex(const gcv_outer_face *face,
                                                                    size_t index, char **text) {
  size_t size = 0;
  GCVX_ALLOCATED(char, 1, gcv_outer_face_exact_vertex(face, index, buffer, capacity, &required),
                 text, &size);
}

/**
 * gcv_region_parts into memory of its own.
 *
 * @param count  the number of parts; 0 for an empty region, with memory to free all the same.
 * @return as gcv_region_parts, and GCVX_ERR_SYSTEM without memory.
 */
GCV_NODISCARD static inline gcv_status gcvx_region_parts(const gcv_region *region,
                                                         gcv_region_part **parts, size_t *count) {
  GCVX_ALLOCATED(gcv_region_part, sizeof(gcv_region_part),
                 gcv_region_parts(region, buffer, capacity, &required), parts, count);
}

/** gcv_region_vertices into memory of its own; as gcvx_region_parts. */
GCV_NODISCARD static inline gcv_status gcvx_region_vertices(const gcv_region *region, double **xy,
                                                            size_t *count) {
  GCVX_ALLOCATED(double, 2 * sizeof(double),
                 gcv_region_vertices(region, buffer, capacity, &required), xy, count);
}

/** gcv_region_exact_parts into memory of its own; as gcvx_region_parts. */
GCV_NODISCARD static inline gcv_status gcvx_region_exact_parts(const gcv_region *region,
                                                               gcv_region_part **parts,
                                                               size_t *count) {
  GCVX_ALLOCATED(gcv_region_part, sizeof(gcv_region_part),
                 gcv_region_exact_parts(region, buffer, capacity, &required), parts, count);
}

/**
 * gcv_region_edge_sources into memory of its own; as gcvx_region_parts.
 *
 * @param count  the number of vertices of all exact parts.
 */
GCV_NODISCARD static inline gcv_status gcvx_region_edge_sources(const gcv_region *region,
                                                                gcv_edge_source **sources,
                                                                size_t *count) {
  GCVX_ALLOCATED(gcv_edge_source, sizeof(gcv_edge_source),
                 gcv_region_edge_sources(region, buffer, capacity, &required), sources, count);
}

/** gcv_region_edge_owners into memory of its own; as gcvx_region_edge_sources. */
GCV_NODISCARD static inline gcv_status gcvx_region_edge_owners(const gcv_region *region,
                                                               uint64_t **ids, size_t *count) {
  GCVX_ALLOCATED(uint64_t, sizeof(uint64_t),
                 gcv_region_edge_owners(region, buffer, capacity, &required), ids, count);
}

/** gcv_region_exact_indices into memory of its own; as gcvx_region_vertices. */
GCV_NODISCARD static inline gcv_status gcvx_region_exact_indices(const gcv_region *region,
                                                                 uint64_t **indices,
                                                                 size_t *count) {
  GCVX_ALLOCATED(uint64_t, sizeof(uint64_t),
                 gcv_region_exact_indices(region, buffer, capacity, &required), indices, count);
}

/** gcv_region_exact_vertex into memory of its own, or GCVX_ERR_SYSTEM without memory. */
GCV_NODISCARD static inline gcv_status gcvx_region_exact_vertex(const gcv_region *region,
                                                                size_t index, char **text) {
  size_t size = 0;
  GCVX_ALLOCATED(char, 1, gcv_region_exact_vertex(region, index, buffer, capacity, &required), text,
                 &size);
}

/** gcv_region_wkt into memory of its own, or GCVX_ERR_SYSTEM without memory. */
GCV_NODISCARD static inline gcv_status gcvx_region_wkt(const gcv_region *region, char **text) {
  size_t size = 0;
  GCVX_ALLOCATED(char, 1, gcv_region_wkt(region, buffer, capacity, &required), text, &size);
}

/** gcv_region_fits_wkt into memory of its own, or GCVX_ERR_SYSTEM without memory. */
GCV_NODISCARD static inline gcv_status gcvx_region_fits_wkt(const gcv_region *region, char **text) {
  size_t size = 0;
  GCVX_ALLOCATED(char, 1, gcv_region_fits_wkt(region, buffer, capacity, &required), text, &size);
}

/**
 * gcv_contact_list_contacts into memory of its own.
 *
 * @param count  the number of contacts; 0 for an empty list, with memory to free all the same.
 * @return as gcv_contact_list_contacts, and GCVX_ERR_SYSTEM without memory.
 */
GCV_NODISCARD static inline gcv_status gcvx_contact_list_contacts(const gcv_contact_list *list,
                                                                  gcv_contact **contacts,
                                                                  size_t *count) {
  GCVX_ALLOCATED(gcv_contact, sizeof(gcv_contact),
                 gcv_contact_list_contacts(list, buffer, capacity, &required), contacts, count);
}

/** gcv_contact_list_previous into memory of its own; as gcvx_contact_list_contacts. */
GCV_NODISCARD static inline gcv_status gcvx_contact_list_previous(const gcv_contact_list *list,
                                                                  uint64_t **indices,
                                                                  size_t *count) {
  GCVX_ALLOCATED(uint64_t, sizeof(uint64_t),
                 gcv_contact_list_previous(list, buffer, capacity, &required), indices, count);
}

/** gcv_pair_list_pairs into memory of its own; as gcvx_contact_list_contacts. */
GCV_NODISCARD static inline gcv_status gcvx_pair_list_pairs(const gcv_pair_list *list,
                                                            gcv_pair **pairs, size_t *count) {
  GCVX_ALLOCATED(gcv_pair, sizeof(gcv_pair), gcv_pair_list_pairs(list, buffer, capacity, &required),
                 pairs, count);
}

/** gcv_scene_ids into memory of its own; as gcvx_contact_list_contacts. */
GCV_NODISCARD static inline gcv_status gcvx_scene_ids(const gcv_scene *scene, uint64_t **ids,
                                                      size_t *count) {
  GCVX_ALLOCATED(uint64_t, sizeof(uint64_t), gcv_scene_ids(scene, buffer, capacity, &required), ids,
                 count);
}

#undef GCVX_ALLOCATED

/* The rest of a file. *text is the caller's to free, on failure too. */
static inline gcv_status gcvx_read(FILE *file, char **text, size_t *length) {
  size_t capacity = 0;
  while (!feof(file)) {
    if (*length == capacity) {
      char *larger = NULL;
      capacity = capacity == 0 ? 4096 : 2 * capacity;
      larger = GCVX_CAST(char *, realloc(*text, capacity));
      if (larger == NULL) return GCVX_ERR_SYSTEM;
      *text = larger;
    }
    *length += fread(*text + *length, 1, capacity - *length, file);
    if (ferror(file)) return GCVX_ERR_SYSTEM;
  }
  return GCV_OK;
}

/**
 * gcv_polygon_create_wkt from a file.
 *
 * @param path  the name of the file, all of which is one polygon.
 * @param out   the new polygon, the caller's.
 * @return as gcv_polygon_create_wkt, and GCVX_ERR_SYSTEM for a file that cannot be read
 *         or that there is no memory for.
 */
GCV_NODISCARD static inline gcv_status gcvx_polygon_read_wkt(const char *path, gcv_polygon **out) {
  char *text = NULL;
  size_t length = 0;
  gcv_status status = GCVX_ERR_SYSTEM;
  int reason = 0;
  FILE *file = fopen(path, "rb");
  if (file == NULL) return status;
  status = gcvx_read(file, &text, &length);
  reason = errno; /* of the reading, not of what follows */
  fclose(file);
  if (status == GCV_OK) status = gcv_polygon_create_wkt(text, length, out);
  free(text);
  errno = reason;
  return status;
}

#undef GCVX_CAST

#endif /* GCV_GCVX_H */

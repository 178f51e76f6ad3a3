/*
 * outer_face.c - from two WKT files to the outer face of their Minkowski sum: as WKT,
 * as exact fractions, as a picture. See USAGE.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include <errno.h>
#include <gcv/gcv.h>
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "files.h"
#include "svg.h"

static const char USAGE[] =
    "usage: outer_face A.wkt B.wkt [options]\n"
    "\n"
    "Computes the outer face of the Minkowski sum of the polygons in two WKT files\n"
    "and writes it as WKT.\n"
    "\n"
    "  --no-fit X,Y  compute the no-fit polygon instead: where the point (X, Y) of B\n"
    "                may go while B touches A, which stays where it is\n"
    "  --wkt FILE    write the WKT to FILE, not to standard output\n"
    "  --svg FILE    draw A, B and the result to FILE\n"
    "  --exact       print the exact vertices to standard output (after the WKT, if\n"
    "                that goes there), one a line: x and y as fractions\n"
    "  --stats       print sizes, area, error bound, the time of the sum alone and the\n"
    "                counts of gcv_stats to standard error\n"
    "  --help        print this text\n"
    "\n"
    "Exit code: 0; 1 for a file, polygon or sum that failed; 2 for wrong usage.\n";

enum { EXIT_USAGE = 2 };

typedef struct options {
  const char *a, *b;     /* input files */
  const char *wkt, *svg; /* output files, or NULL */
  bool no_fit, exact, stats;
  double reference[2];
} options;

typedef struct results {
  gcv_polygon *a, *b;
  gcv_outer_face *face;
  double milliseconds;
} results;

/* ----------------------------------------------------------------- errors -- */

static bool complain(const char *subject, const char *problem) {
  fprintf(stderr, "outer_face: %s: %s\n", subject, problem);
  return false;
}

/* Whether a call went well; if not, says what the library says, about `subject`. */
static bool check(gcv_status status, const char *subject) {
  if (status == GCV_OK) return true;
  fprintf(stderr, "outer_face: %s: %s: %s\n", subject, gcv_status_name(status),
          gcv_last_error_message());
  return false;
}

static void *allocate(size_t count, size_t size) {
  void *memory = calloc(count, size);
  if (!memory) complain("memory", strerror(errno));
  return memory;
}

/* ------------------------------------------------------------ computation -- */

static bool load(const char *path, gcv_polygon **polygon) {
  char *text;
  size_t length;
  if (!read_file(path, &text, &length)) return complain(path, strerror(errno));
  bool ok = check(gcv_polygon_create_wkt(text, length, polygon), path);
  free(text);
  return ok;
}

static bool compute(const options *o, results *r) {
  if (!load(o->a, &r->a) || !load(o->b, &r->b)) return false;

  clock_t start = clock();
  gcv_status status = o->no_fit ? gcv_no_fit_polygon(r->a, r->b, o->reference, NULL, &r->face)
                                : gcv_minkowski_sum(r->a, r->b, NULL, &r->face);
  r->milliseconds = 1e3 * (double)(clock() - start) / CLOCKS_PER_SEC;

  if (status == GCV_OK) return true;
  fprintf(stderr, "outer_face: %s and %s: %s: %s\n", o->a, o->b, gcv_status_name(status),
          gcv_last_error_message());
  return false;
}

/* ---------------------------------------------------------------- results -- */

typedef bool writer(const options *o, const results *r, FILE *file);

static bool write_wkt(const options *o, const results *r, FILE *file) {
  (void)o;
  size_t length;
  if (!check(gcv_outer_face_wkt(r->face, NULL, 0, &length), "WKT")) return false;
  char *text = allocate(length, 1);
  bool ok = text && check(gcv_outer_face_wkt(r->face, text, length, &length), "WKT");
  if (ok) fprintf(file, "%s\n", text);
  free(text);
  return ok;
}

static bool write_exact_vertex(const gcv_outer_face *face, size_t index, FILE *file) {
  size_t length;
  if (!check(gcv_outer_face_exact_vertex(face, index, NULL, 0, &length), "vertex")) return false;
  char *text = allocate(length, 1);
  bool ok =
      text && check(gcv_outer_face_exact_vertex(face, index, text, length, &length), "vertex");
  if (ok) fprintf(file, "%s\n", text);
  free(text);
  return ok;
}

static bool write_exact(const options *o, const results *r, FILE *file) {
  (void)o;
  size_t count;
  bool ok = check(gcv_outer_face_exact_vertex_count(r->face, &count), "exact vertices");
  for (size_t i = 0; ok && i < count; ++i) ok = write_exact_vertex(r->face, i, file);
  return ok;
}

static bool write_stats(const options *o, const results *r, FILE *file) {
  (void)o;
  size_t a, b, sum;
  double bound, area;
  gcv_stats stats = {.struct_size = sizeof stats};
  gcv_status area_status = gcv_outer_face_area(r->face, &area);
  if (area_status == GCV_ERR_RANGE)
    area = INFINITY; /* finite coordinates do not prevent it */
  else if (!check(area_status, "area"))
    return false;

  if (!check(gcv_polygon_vertex_count(r->a, &a), "A") ||
      !check(gcv_polygon_vertex_count(r->b, &b), "B") ||
      !check(gcv_outer_face_vertex_count(r->face, &sum), "vertices") ||
      !check(gcv_outer_face_error_bound(r->face, &bound), "error bound") ||
      !check(gcv_outer_face_stats(r->face, &stats), "statistics")) {
    return false;
  }
  fprintf(file, "A           %zu vertices\n", a);
  fprintf(file, "B           %zu vertices\n", b);
  fprintf(file, "outer face  %zu vertices, area %.17g, error bound %.3g\n", sum, area, bound);
  fprintf(file, "time        %.3f ms\n", r->milliseconds);
  fprintf(file, "walk        %" PRIu64 " steps, %" PRIu64 " candidate edges\n", stats.walk_steps,
          stats.candidate_edges);
  fprintf(file, "predicates  %" PRIu64 " filtered, %" PRIu64 " fixed-width, %" PRIu64 " rational\n",
          stats.predicates_filtered, stats.predicates_fixed_width, stats.predicates_rational);
  fprintf(file, "rounding    %" PRIu64 " vertices repaired\n", stats.vertices_repaired);
  return true;
}

/* ---------------------------------------------------------------- picture -- */

static bool polygon_ring(const gcv_polygon *polygon, ring *out) {
  size_t count;
  if (!check(gcv_polygon_vertices(polygon, NULL, 0, &count), "vertices")) return false;
  *out = (ring){allocate(count, 2 * sizeof(double)), count};
  return out->xy && check(gcv_polygon_vertices(polygon, out->xy, count, &count), "vertices");
}

static bool face_ring(const gcv_outer_face *face, ring *out) {
  size_t count;
  if (!check(gcv_outer_face_vertices(face, NULL, 0, &count), "vertices")) return false;
  *out = (ring){allocate(count, 2 * sizeof(double)), count};
  return out->xy && check(gcv_outer_face_vertices(face, out->xy, count, &count), "vertices");
}

/*
 * The sources belong to the edges of the exact ring. Where rounding changed the number of
 * edges, they say nothing about the returned ring, and *out stays NULL.
 */
static bool face_sources(const gcv_outer_face *face, size_t edges, gcv_edge_source **out) {
  size_t count;
  if (!check(gcv_outer_face_edge_sources(face, NULL, 0, &count), "edge sources")) return false;
  if (count != edges) return true;
  *out = allocate(count, sizeof **out);
  return *out && check(gcv_outer_face_edge_sources(face, *out, count, &count), "edge sources");
}

static bool write_picture(const options *o, const results *r, FILE *file) {
  picture p = {.no_fit = o->no_fit, .reference = {o->reference[0], o->reference[1]}};
  gcv_edge_source *sources = NULL;
  bool ok = polygon_ring(r->a, &p.a) && polygon_ring(r->b, &p.b) && face_ring(r->face, &p.sum) &&
            face_sources(r->face, p.sum.count, &sources);
  p.sources = sources;
  if (ok) write_svg(file, &p);
  free(p.a.xy);
  free(p.b.xy);
  free(p.sum.xy);
  free(sources);
  return ok;
}

/* ----------------------------------------------------------------- output -- */

static bool write_file(const char *path, writer *write, const options *o, const results *r) {
  FILE *file = fopen(path, "w");
  if (!file) return complain(path, strerror(errno));
  bool ok = write(o, r, file);
  return (close_output(file) || complain(path, strerror(errno))) && ok;
}

static bool write_results(const options *o, const results *r) {
  bool ok = o->wkt ? write_file(o->wkt, write_wkt, o, r) : write_wkt(o, r, stdout);
  ok = ok && (!o->exact || write_exact(o, r, stdout));
  ok = ok && (!o->svg || write_file(o->svg, write_picture, o, r));
  ok = ok && (!o->stats || write_stats(o, r, stderr));
  return ok && (close_output(stdout) || complain("standard output", strerror(errno)));
}

/* ---------------------------------------------------------------- options -- */

/* "X,Y" */
static bool parse_point(const char *text, double point[2]) {
  char *end;
  point[0] = strtod(text, &end);
  if (end == text || *end != ',') return false;
  text = end + 1;
  point[1] = strtod(text, &end);
  return end != text && *end == '\0';
}

/* The option at argv[*i]; takes the value behind it where it has one. */
static bool parse_option(char **argv, int *i, options *o) {
  const char *name = argv[*i];
  if (strcmp(name, "--exact") == 0) return o->exact = true;
  if (strcmp(name, "--stats") == 0) return o->stats = true;

  const char *value = argv[*i + 1]; /* argv ends with a NULL */
  if (!value) return false;
  ++*i;
  if (strcmp(name, "--wkt") == 0) return o->wkt = value, true;
  if (strcmp(name, "--svg") == 0) return o->svg = value, true;
  if (strcmp(name, "--no-fit") == 0) return o->no_fit = parse_point(value, o->reference);
  return false;
}

static bool parse_options(int argc, char **argv, options *o) {
  for (int i = 1; i < argc; ++i) {
    if (strncmp(argv[i], "--", 2) == 0) {
      if (!parse_option(argv, &i, o)) return false;
    } else if (!o->a) {
      o->a = argv[i];
    } else if (!o->b) {
      o->b = argv[i];
    } else {
      return false;
    }
  }
  return o->b != NULL;
}

static bool asks_for_help(char **argv) {
  while (*++argv && strcmp(*argv, "--help") != 0) continue;
  return *argv != NULL;
}

int main(int argc, char **argv) {
  if (argc > 1 && asks_for_help(argv)) {
    fputs(USAGE, stdout);
    return close_output(stdout) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  options o = {0};
  if (!parse_options(argc, argv, &o)) {
    fputs(USAGE, stderr);
    return EXIT_USAGE;
  }
  results r = {0};
  bool ok = compute(&o, &r) && write_results(&o, &r);
  gcv_outer_face_destroy(r.face);
  gcv_polygon_destroy(r.b);
  gcv_polygon_destroy(r.a);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}

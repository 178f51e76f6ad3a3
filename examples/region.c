/*
 * region.c - from two WKT files to their whole Minkowski sum: as WKT, as exact fractions,
 * as a picture. See USAGE.
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
    "usage: region A.wkt B.wkt [options]\n"
    "\n"
    "Computes the region of the Minkowski sum of the polygons in two WKT files: its\n"
    "outer ring, its holes, and the segments and points where one polygon fits the\n"
    "other exactly. Writes it as WKT in two lines: the rings, then the exact fits.\n"
    "\n"
    "  --no-fit X,Y  compute the no-fit region instead: where the point (X, Y) of B\n"
    "                may not go, for there B overlaps A, which stays where it is\n"
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
  gcv_region *region;
  double milliseconds;
} results;

/* ----------------------------------------------------------------- errors -- */

static bool complain(const char *subject, const char *problem) {
  fprintf(stderr, "region: %s: %s\n", subject, problem);
  return false;
}

/* Whether a call went well; if not, says what the library says, about `subject`. */
static bool check(gcv_status status, const char *subject) {
  if (status == GCV_OK) return true;
  fprintf(stderr, "region: %s: %s: %s\n", subject, gcv_status_name(status),
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
  gcv_status status = o->no_fit ? gcv_no_fit_region(r->a, r->b, o->reference, NULL, &r->region)
                                : gcv_minkowski_sum_region(r->a, r->b, NULL, &r->region);
  r->milliseconds = 1e3 * (double)(clock() - start) / CLOCKS_PER_SEC;

  if (status == GCV_OK) return true;
  fprintf(stderr, "region: %s and %s: %s: %s\n", o->a, o->b, gcv_status_name(status),
          gcv_last_error_message());
  return false;
}

/* ------------------------------------------------------------------ parts -- */

static void free_parts(parts *p) {
  free(p->list);
  free(p->xy);
}

/* Of all rings. */
static bool vertex_count(const gcv_polygon *polygon, size_t *out) {
  size_t rings, count;
  *out = 0;
  if (!check(gcv_polygon_ring_count(polygon, &rings), "rings")) return false;
  for (size_t k = 0; k < rings; ++k, *out += count)
    if (!check(gcv_polygon_ring(polygon, k, NULL, 0, &count), "vertices")) return false;
  return true;
}

/* The rings of a polygon, as the parts that they would be. */
static bool polygon_parts(const gcv_polygon *polygon, parts *out) {
  if (!check(gcv_polygon_ring_count(polygon, &out->count), "rings")) return false;
  if (!(out->list = allocate(out->count, sizeof *out->list))) return false;
  for (size_t k = 0; k < out->count; ++k) {
    size_t count;
    if (!check(gcv_polygon_ring(polygon, k, NULL, 0, &count), "vertices")) return false;
    out->list[k] = (gcv_region_part){k ? GCV_PART_HOLE : GCV_PART_OUTER, 0, count};
    out->vertex_count += count;
  }
  if (!(out->xy = allocate(out->vertex_count, 2 * sizeof(double)))) return false;
  size_t start = 0, count = 0;
  for (size_t k = 0; k < out->count; ++k, start += count) {
    double *xy = out->xy + 2 * start;
    if (!check(gcv_polygon_ring(polygon, k, xy, out->vertex_count - start, &count), "vertices"))
      return false;
  }
  return true;
}

static bool region_parts(const gcv_region *region, parts *out) {
  if (!check(gcv_region_parts(region, NULL, 0, &out->count), "parts") ||
      !check(gcv_region_vertices(region, NULL, 0, &out->vertex_count), "vertices")) {
    return false;
  }
  out->list = allocate(out->count, sizeof *out->list);
  out->xy = allocate(out->vertex_count, 2 * sizeof(double));
  return out->list && out->xy &&
         check(gcv_region_parts(region, out->list, out->count, &out->count), "parts") &&
         check(gcv_region_vertices(region, out->xy, out->vertex_count, &out->vertex_count),
               "vertices");
}

/* ---------------------------------------------------------------- results -- */

typedef bool writer(const options *o, const results *r, FILE *file);

typedef gcv_status text_function(const gcv_region *region, char *text, size_t capacity,
                                 size_t *required);

static bool write_text(const gcv_region *region, text_function *get, FILE *file) {
  size_t length;
  if (!check(get(region, NULL, 0, &length), "WKT")) return false;
  char *text = allocate(length, 1);
  bool ok = text && check(get(region, text, length, &length), "WKT");
  if (ok) fprintf(file, "%s\n", text);
  free(text);
  return ok;
}

static bool write_wkt(const options *o, const results *r, FILE *file) {
  (void)o;
  return write_text(r->region, gcv_region_wkt, file) &&
         write_text(r->region, gcv_region_fits_wkt, file);
}

static bool write_exact_vertex(const gcv_region *region, size_t index, FILE *file) {
  size_t length;
  if (!check(gcv_region_exact_vertex(region, index, NULL, 0, &length), "vertex")) return false;
  char *text = allocate(length, 1);
  bool ok = text && check(gcv_region_exact_vertex(region, index, text, length, &length), "vertex");
  if (ok) fprintf(file, "%s\n", text);
  free(text);
  return ok;
}

static bool write_exact(const options *o, const results *r, FILE *file) {
  (void)o;
  size_t count;
  bool ok = check(gcv_region_edge_sources(r->region, NULL, 0, &count), "exact vertices");
  for (size_t i = 0; ok && i < count; ++i) ok = write_exact_vertex(r->region, i, file);
  return ok;
}

static bool write_stats(const options *o, const results *r, FILE *file) {
  (void)o;
  size_t a, b;
  double bound, area;
  gcv_stats stats = {.struct_size = sizeof stats};
  gcv_status area_status = gcv_region_area(r->region, &area);
  if (area_status == GCV_ERR_RANGE)
    area = INFINITY; /* finite coordinates do not prevent it */
  else if (!check(area_status, "area"))
    return false;

  if (!vertex_count(r->a, &a) || !vertex_count(r->b, &b) ||
      !check(gcv_region_error_bound(r->region, &bound), "error bound") ||
      !check(gcv_region_stats(r->region, &stats), "statistics")) {
    return false;
  }
  parts sum = {0};
  bool ok = region_parts(r->region, &sum);
  if (ok) {
    fprintf(file, "A           %zu vertices\n", a);
    fprintf(file, "B           %zu vertices\n", b);
    fprintf(file, "region      %zu vertices, area %.17g, error bound %.3g\n", sum.vertex_count,
            area, bound);
    fprintf(file, "inside      %zu holes, %zu segments, %zu points\n",
            count_parts(&sum, GCV_PART_HOLE), count_parts(&sum, GCV_PART_SEGMENT),
            count_parts(&sum, GCV_PART_POINT));
    fprintf(file, "time        %.3f ms\n", r->milliseconds);
    fprintf(file, "walk        %" PRIu64 " steps, %" PRIu64 " candidate edges\n", stats.walk_steps,
            stats.candidate_edges);
    fprintf(file,
            "predicates  %" PRIu64 " filtered, %" PRIu64 " fixed-width, %" PRIu64 " rational\n",
            stats.predicates_filtered, stats.predicates_fixed_width, stats.predicates_rational);
    fprintf(file, "rounding    %" PRIu64 " vertices repaired, %" PRIu64 " parts dropped\n",
            stats.vertices_repaired, stats.parts_dropped);
  }
  free_parts(&sum);
  return ok;
}

/* ---------------------------------------------------------------- picture -- */

/* ---------------------------------------------------------------- picture -- */

/* What the edges from the returned vertices come from: those from their exact vertices. */
static bool find_sources(const gcv_region *region, size_t vertices, gcv_edge_source **out) {
  size_t count;
  if (!check(gcv_region_edge_sources(region, NULL, 0, &count), "edge sources")) return false;
  gcv_edge_source *exact = allocate(count, sizeof *exact);
  uint64_t *indices = allocate(vertices, sizeof *indices);
  *out = allocate(vertices, sizeof **out);
  bool ok = exact && indices && *out &&
            check(gcv_region_edge_sources(region, exact, count, &count), "edge sources") &&
            check(gcv_region_exact_indices(region, indices, vertices, &vertices), "exact indices");
  for (size_t i = 0; ok && i < vertices; ++i) (*out)[i] = exact[indices[i]];
  free(indices);
  free(exact);
  return ok;
}

static bool write_picture(const options *o, const results *r, FILE *file) {
  picture p = {.no_fit = o->no_fit, .reference = {o->reference[0], o->reference[1]}};
  gcv_edge_source *sources = NULL;
  bool ok = polygon_parts(r->a, &p.a) && polygon_parts(r->b, &p.b) &&
            region_parts(r->region, &p.sum) &&
            find_sources(r->region, p.sum.vertex_count, &sources);
  p.sources = sources;
  if (ok) write_svg(file, &p);
  free_parts(&p.a);
  free_parts(&p.b);
  free_parts(&p.sum);
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
  gcv_region_destroy(r.region);
  gcv_polygon_destroy(r.b);
  gcv_polygon_destroy(r.a);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}

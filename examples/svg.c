/*
 * svg.c - a picture of two polygons and the region of their sum.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include "svg.h"

#include <float.h>
#include <limits.h>
#include <math.h>

/* The page, in pixels: A and B stacked at the left, the sum at the right. */
static const double MARGIN = 32, GAP = 56, CAPTION = 48, LEGEND = 92, LEGEND_LINE = 20;
static const double MIN_LEFT = 120, MIN_RIGHT = 300;
static const double MAX_PLOTS_WIDTH = 880, MAX_PLOTS_HEIGHT = 620;

/* Edges of A are blue, edges of B orange, here and in the sum. Exact fits are purple. */
static const char STYLE[] =
    "<style>\n"
    "  text { font: 14px system-ui, -apple-system, 'Segoe UI', Helvetica, Arial, sans-serif;\n"
    "         fill: #5b6675 }\n"
    "  .title { font-size: 17px; font-weight: 600; fill: #1b2430 }\n"
    "  path { fill: none; fill-rule: evenodd; stroke-linejoin: round; stroke-linecap: round }\n"
    "  .a { fill: #e3eefc; stroke: #1c6dd0; stroke-width: 1.5 }\n"
    "  .b { fill: #fdebe0; stroke: #e0561f; stroke-width: 1.5 }\n"
    "  .sum { fill: #ebeff4 }\n"
    "  .faint-a { fill: #1c6dd0; fill-opacity: 0.14 }\n"
    "  .faint-b { fill: #e0561f; fill-opacity: 0.24 }\n"
    "  .edge { stroke: #1b2430; stroke-width: 2.2 }\n"
    "  .fine .edge { stroke-width: 1.3 }\n"
    "  .kind1 { stroke: #1c6dd0 }\n"
    "  .kind2 { stroke: #e0561f }\n"
    "  .kind3 { stroke: #0b9a6d }\n"
    "  .segment { stroke: #a3238e; stroke-width: 3.6 }\n"
    "  .point { fill: #a3238e }\n"
    "  .reference { fill: #1b2430 }\n"
    "</style>\n";

/* Above so many vertices the edges of the sum are drawn finer. */
static const size_t FINE = 500;

/* B is drawn in at most so many of its exact fits. */
enum { MAX_FITS = 12 };

/* ---------------------------------------------------------------- geometry -- */

/*
 * Points and boxes are in scaled coordinates: those of the rings times 2^-exponent, where
 * the exponent is that of the largest of all. So no difference of two of them overflows.
 */
typedef struct point {
  double x, y;
} point;

typedef struct box {
  double x_min, y_min, x_max, y_max;
} box;

static double width(box b) { return b.x_max - b.x_min; }
static double height(box b) { return b.y_max - b.y_min; }

static bool inside(box b, point p) {
  return b.x_min <= p.x && p.x <= b.x_max && b.y_min <= p.y && p.y <= b.y_max;
}

static int largest_exponent(const parts *r) {
  int largest = INT_MIN;
  for (size_t i = 0; i < 2 * r->vertex_count; ++i) {
    int exponent = INT_MIN;
    if (r->xy[i] != 0) frexp(r->xy[i], &exponent);
    if (exponent > largest) largest = exponent;
  }
  return largest;
}

static int common_exponent(const picture *p) {
  int a = largest_exponent(&p->a), b = largest_exponent(&p->b), sum = largest_exponent(&p->sum);
  return a > b ? (a > sum ? a : sum) : (b > sum ? b : sum);
}

static point scaled(const double xy[2], int exponent) {
  return (point){ldexp(xy[0], -exponent), ldexp(xy[1], -exponent)};
}

/* The box of parts that are moved by `shift`. */
static box bounds(const parts *r, point shift, int exponent) {
  box b = {DBL_MAX, DBL_MAX, -DBL_MAX, -DBL_MAX};
  for (size_t i = 0; i < r->vertex_count; ++i) {
    point p = scaled(r->xy + 2 * i, exponent);
    b.x_min = fmin(b.x_min, p.x + shift.x);
    b.y_min = fmin(b.y_min, p.y + shift.y);
    b.x_max = fmax(b.x_max, p.x + shift.x);
    b.y_max = fmax(b.y_max, p.y + shift.y);
  }
  return b;
}

static box joined(box a, box b) {
  return (box){fmin(a.x_min, b.x_min), fmin(a.y_min, b.y_min), fmax(a.x_max, b.x_max),
               fmax(a.y_max, b.y_max)};
}

/* The vertex that is nearest to the middle of the box. */
static point middle_vertex(const parts *r, int exponent) {
  box b = bounds(r, (point){0, 0}, exponent);
  point best = {0, 0};
  double best_distance = DBL_MAX;
  for (size_t i = 0; i < r->vertex_count; ++i) {
    point p = scaled(r->xy + 2 * i, exponent);
    double distance = hypot(p.x - (b.x_min + b.x_max) / 2, p.y - (b.y_min + b.y_max) / 2);
    if (distance >= best_distance) continue;
    best = p;
    best_distance = distance;
  }
  return best;
}

/* ------------------------------------------------------------------ layout -- */

/* One plot: (x, y) goes to (left + scale (x - x_min), top + scale (y_max - y)). */
typedef struct frame {
  box box;
  double left, top, scale;
} frame;

typedef struct layout {
  int exponent;
  /* A and B are drawn inside the sum too: A moved by a_shift, B with its reference point in
   * each of b_places. */
  bool a_in_sum, b_in_sum;
  point a_shift, reference, b_places[MAX_FITS];
  size_t b_count;
  frame a, b, sum;
  double page_width, page_height;
} layout;

/* From the reference point of B to one of its places. */
static point shift_of_b(const layout *l, size_t place) {
  return (point){l->b_places[place].x - l->reference.x, l->b_places[place].y - l->reference.y};
}

/* The first vertex of each segment and each point, of as many as there is room for. */
static size_t fits(const parts *r, int exponent, point out[MAX_FITS]) {
  size_t count = 0, vertex = 0;
  for (size_t k = 0; k < r->count && count < MAX_FITS; ++k) {
    bool is_fit = r->list[k].kind == GCV_PART_SEGMENT || r->list[k].kind == GCV_PART_POINT;
    if (is_fit) out[count++] = scaled(r->xy + 2 * vertex, exponent);
    vertex += r->list[k].vertex_count;
  }
  return count;
}

/*
 * A + B contains A moved by any vertex of B; the one in the middle is taken. The no-fit
 * region lies round A where A is, if the reference point is about where B is; then B is
 * shown as well: in its exact fits, or else in a contact in the middle.
 */
static void place_inside_sum(const picture *p, layout *l) {
  if (!p->no_fit) {
    l->a_in_sum = true;
    l->a_shift = middle_vertex(&p->b, l->exponent);
    return;
  }
  l->reference = scaled(p->reference, l->exponent);
  l->a_in_sum = l->b_in_sum = inside(l->b.box, l->reference);
  if (!l->b_in_sum) return;
  l->b_count = fits(&p->sum, l->exponent, l->b_places);
  if (l->b_count == 0) l->b_places[l->b_count++] = middle_vertex(&p->sum, l->exponent);
}

static layout lay_out(const picture *p) {
  const point unmoved = {0, 0};
  layout l = {.exponent = common_exponent(p)};
  l.a.box = bounds(&p->a, unmoved, l.exponent);
  l.b.box = bounds(&p->b, unmoved, l.exponent);
  l.sum.box = bounds(&p->sum, unmoved, l.exponent);
  place_inside_sum(p, &l);
  for (size_t k = 0; k < l.b_count; ++k)
    l.sum.box = joined(l.sum.box, bounds(&p->b, shift_of_b(&l, k), l.exponent));

  /* The largest scale at which all fits. */
  double left_width = fmax(width(l.a.box), width(l.b.box));
  double left_height = height(l.a.box) + height(l.b.box);
  double scale = fmin(MAX_PLOTS_WIDTH / (left_width + width(l.sum.box)),
                      MAX_PLOTS_HEIGHT / fmax(left_height, height(l.sum.box)));
  l.a.scale = l.b.scale = l.sum.scale = scale;

  l.a.left = l.b.left = MARGIN;
  l.sum.left = MARGIN + fmax(MIN_LEFT, scale * left_width) + GAP;
  l.page_width = l.sum.left + fmax(MIN_RIGHT, scale * width(l.sum.box)) + MARGIN;

  /* The gap and the caption between A and B are as high as the legend: plots end together. */
  l.a.top = MARGIN + CAPTION;
  l.b.top = l.a.top + scale * height(l.a.box) + LEGEND;
  l.sum.top = l.a.top + LEGEND;
  l.page_height =
      fmax(l.b.top + scale * height(l.b.box), l.sum.top + scale * height(l.sum.box)) + MARGIN;
  return l;
}

/* ----------------------------------------------------------------- drawing -- */

static point on_page(const frame *f, point p) {
  return (point){f->left + f->scale * (p.x - f->box.x_min),
                 f->top + f->scale * (f->box.y_max - p.y)};
}

/* All rings as one path. */
static void put_rings(FILE *file, const frame *f, int exponent, const char *class, const parts *r,
                      point shift) {
  const double *xy = r->xy;
  fprintf(file, "<path class=\"%s\" d=\"", class);
  for (size_t k = 0; k < r->count; ++k) {
    if (r->list[k].kind != GCV_PART_OUTER && r->list[k].kind != GCV_PART_HOLE) break;
    for (size_t i = 0; i < r->list[k].vertex_count; ++i, xy += 2) {
      point p = scaled(xy, exponent);
      p = on_page(f, (point){p.x + shift.x, p.y + shift.y});
      fprintf(file, "%c%.2f %.2f", i == 0 ? 'M' : 'L', p.x, p.y);
    }
    fputs("Z", file);
  }
  fputs("\"/>\n", file);
}

/* The edges of a ring that are of one kind. Those that follow each other are joined. */
static void put_ring_edges(FILE *file, const layout *l, const picture *p, int kind, size_t start,
                           size_t count) {
  const double *xy = p->sum.xy + 2 * start;
  const gcv_edge_source *sources = p->sources + start;
  for (size_t i = 0; i < count; ++i) {
    if (sources[i].kind != kind) continue;
    point from = on_page(&l->sum, scaled(xy + 2 * i, l->exponent));
    point to = on_page(&l->sum, scaled(xy + 2 * ((i + 1) % count), l->exponent));
    if (i == 0 || sources[i - 1].kind != kind) fprintf(file, "M%.2f %.2f", from.x, from.y);
    fprintf(file, "L%.2f %.2f", to.x, to.y);
  }
}

/* All edges of rings of one kind as one path. */
static void put_edges(FILE *file, const layout *l, const picture *p, int kind) {
  size_t start = 0;
  fprintf(file, "<path class=\"edge kind%d\" d=\"", kind);
  for (size_t k = 0; k < p->sum.count; ++k) {
    const gcv_region_part *part = &p->sum.list[k];
    if (part->kind != GCV_PART_OUTER && part->kind != GCV_PART_HOLE) break;
    put_ring_edges(file, l, p, kind, start, part->vertex_count);
    start += part->vertex_count;
  }
  fputs("\"/>\n", file);
}

static void put_dot(FILE *file, const char *class, double radius, point p) {
  fprintf(file, "<circle class=\"%s\" r=\"%.1f\" cx=\"%.2f\" cy=\"%.2f\"/>\n", class, radius, p.x,
          p.y);
}

/* The segments and points of the sum. */
static void put_fits(FILE *file, const layout *l, const picture *p) {
  const double *xy = p->sum.xy;
  for (size_t k = 0; k < p->sum.count; xy += 2 * p->sum.list[k++].vertex_count) {
    if (p->sum.list[k].kind != GCV_PART_SEGMENT && p->sum.list[k].kind != GCV_PART_POINT) continue;
    point start = on_page(&l->sum, scaled(xy, l->exponent));
    if (p->sum.list[k].kind == GCV_PART_POINT) {
      put_dot(file, "point", 4.5, start);
      continue;
    }
    point end = on_page(&l->sum, scaled(xy + 2, l->exponent));
    fprintf(file, "<path class=\"segment\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n", start.x, start.y, end.x,
            end.y);
  }
}

static void put_a_and_b(FILE *file, const layout *l, const picture *p) {
  put_rings(file, &l->a, l->exponent, "a", &p->a, (point){0, 0});
  put_rings(file, &l->b, l->exponent, "b", &p->b, (point){0, 0});
  if (l->b_in_sum) put_dot(file, "reference", 3.2, on_page(&l->b, l->reference));
}

static void put_sum(FILE *file, const layout *l, const picture *p) {
  const frame *f = &l->sum;
  fprintf(file, "<g%s>\n", p->sum.vertex_count > FINE ? " class=\"fine\"" : "");
  put_rings(file, f, l->exponent, "sum", &p->sum, (point){0, 0});
  if (l->a_in_sum) put_rings(file, f, l->exponent, "faint-a", &p->a, l->a_shift);
  for (size_t k = 0; k < l->b_count; ++k) {
    put_rings(file, f, l->exponent, "faint-b", &p->b, shift_of_b(l, k));
    put_dot(file, "reference", 3.2, on_page(f, l->b_places[k]));
  }
  put_edges(file, l, p, GCV_EDGE_TRANSLATED);
  put_edges(file, l, p, GCV_EDGE_CORNER);
  put_edges(file, l, p, GCV_EDGE_TRANSLATED_CORNER);
  put_fits(file, l, p);
  fputs("</g>\n", file);
}

/* -------------------------------------------------------------------- text -- */

size_t count_parts(const parts *p, int32_t kind) {
  size_t count = 0;
  for (size_t k = 0; k < p->count; ++k) count += p->list[k].kind == kind;
  return count;
}

/* ", n words", or nothing where there are none. */
static void put_count(FILE *file, size_t count, const char *word) {
  if (count > 0) fprintf(file, ", %zu %s%s", count, word, count > 1 ? "s" : "");
}

/* A title and the counts of what is drawn, above the plot that starts at (left, top). */
static void put_caption(FILE *file, double left, double top, const char *title, const parts *r) {
  fprintf(file, "<text class=\"title\" x=\"%.2f\" y=\"%.2f\">%s</text>\n", left, top - 34, title);
  fprintf(file, "<text x=\"%.2f\" y=\"%.2f\">%zu vertices", left, top - 15, r->vertex_count);
  put_count(file, count_parts(r, GCV_PART_HOLE), "hole");
  put_count(file, count_parts(r, GCV_PART_SEGMENT), "segment");
  put_count(file, count_parts(r, GCV_PART_POINT), "point");
  fputs("</text>\n", file);
}

static void put_legend_line(FILE *file, const layout *l, int line, const char *class,
                            const char *what, size_t count) {
  double x = l->sum.left, y = l->a.top + 7 + line * LEGEND_LINE;
  fprintf(file, "<path class=\"%s\" d=\"M%.2f %.2fh22\"/>\n", class, x + 1, y - 5);
  fprintf(file, "<text x=\"%.2f\" y=\"%.2f\">%zu %s</text>\n", x + 32, y, count, what);
}

static void put_legend(FILE *file, const layout *l, const picture *p) {
  size_t counts[GCV_EDGE_TRANSLATED_CORNER + 1] = {0}, vertex = 0;
  for (size_t k = 0; k < p->sum.count; vertex += p->sum.list[k++].vertex_count) {
    if (p->sum.list[k].kind != GCV_PART_OUTER && p->sum.list[k].kind != GCV_PART_HOLE) break;
    for (size_t i = 0; i < p->sum.list[k].vertex_count; ++i) ++counts[p->sources[vertex + i].kind];
  }
  size_t fits = count_parts(&p->sum, GCV_PART_SEGMENT) + count_parts(&p->sum, GCV_PART_POINT);
  put_legend_line(file, l, 0, "edge kind1", "translated edges, from A",
                  counts[GCV_EDGE_TRANSLATED]);
  put_legend_line(file, l, 1, "edge kind2", "corner edges, from B", counts[GCV_EDGE_CORNER]);
  put_legend_line(file, l, 2, "edge kind3", "translated-corner edges, from both",
                  counts[GCV_EDGE_TRANSLATED_CORNER]);
  put_legend_line(file, l, 3, "segment", "exact fits: segments and points", fits);
}

void write_svg(FILE *file, const picture *p) {
  layout l = lay_out(p);
  fprintf(file,
          "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 %.0f %.0f\""
          " width=\"%.0f\" height=\"%.0f\">\n",
          l.page_width, l.page_height, l.page_width, l.page_height);
  fprintf(file, "<title>%s</title>\n",
          p->no_fit ? "The no-fit region of A and B" : "The region of the Minkowski sum A + B");
  fputs(STYLE, file);
  fputs("<rect width=\"100%\" height=\"100%\" rx=\"8\" fill=\"#ffffff\"/>\n", file);

  put_caption(file, MARGIN, l.a.top, p->no_fit ? "A, fixed" : "A", &p->a);
  put_caption(file, MARGIN, l.b.top, p->no_fit ? "B, moving" : "B", &p->b);
  put_caption(file, l.sum.left, l.a.top, p->no_fit ? "No-fit region of A and B" : "A + B", &p->sum);
  put_a_and_b(file, &l, p);
  put_sum(file, &l, p);
  put_legend(file, &l, p);
  fputs("</svg>\n", file);
}

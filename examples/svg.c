/*
 * svg.c - a picture of two polygons and the outer face of their sum.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include "svg.h"

#include <float.h>
#include <math.h>

/* The page, in pixels. */
static const double MARGIN = 32, GAP = 56, CAPTION = 48, LEGEND = 56;
static const double MAX_PLOT_WIDTH = 880, MAX_PLOT_HEIGHT = 620;
static const double MIN_LEFT = 150, MIN_RIGHT = 360;

static const char STYLE[] =
    "<style>\n"
    "  text { font: 14px system-ui, -apple-system, 'Segoe UI', Helvetica, Arial, sans-serif;\n"
    "         fill: #5b6675 }\n"
    "  .title { font-size: 17px; font-weight: 600; fill: #1b2430 }\n"
    "  path { stroke-width: 1.5; stroke-linejoin: round; stroke-linecap: round; fill: none }\n"
    "  .a { fill: #e3eefc; stroke: #1c6dd0 }\n"
    "  .b { fill: #fdebe0; stroke: #e0561f }\n"
    "  .sum { fill: #f4f6f8 }\n"
    "  .ghost { fill: #1c6dd0; fill-opacity: 0.13 }\n"
    "  .edge { stroke-width: 2.2; stroke: #1b2430 }\n"
    "  .kind1 { stroke: #1c6dd0 }\n"
    "  .kind2 { stroke: #e0561f }\n"
    "  .kind3 { stroke: #0c9a6c }\n"
    "  .point { fill: #1b2430 }\n"
    "</style>\n";

/* A box in scaled coordinates; see common_exponent. */
typedef struct box {
  double x_min, y_min, x_max, y_max;
} box;

/* Where scaled coordinates go on the page: (x, y) to (left + s (x - x_min), top + s (y_max - y)). */
typedef struct frame {
  double x_min, y_max, left, top, scale;
  int exponent;
} frame;

static double width(box b) { return b.x_max - b.x_min; }
static double height(box b) { return b.y_max - b.y_min; }

/*
 * All coordinates are multiplied by 2^-exponent before anything else. That is exact, and
 * brings them below 1, so that no difference of two of them overflows.
 */
static int common_exponent(const picture *p) {
  const ring *rings[] = {&p->a, &p->b, &p->sum};
  int largest = INT32_MIN;
  for (int r = 0; r < 3; ++r) {
    for (size_t i = 0; i < 2 * rings[r]->count; ++i) {
      int exponent = INT32_MIN;
      if (rings[r]->xy[i] != 0) frexp(rings[r]->xy[i], &exponent);
      if (exponent > largest) largest = exponent;
    }
  }
  return largest;
}

static box bounds(const ring *r, int exponent) {
  box b = {DBL_MAX, DBL_MAX, -DBL_MAX, -DBL_MAX};
  for (size_t i = 0; i < r->count; ++i) {
    double x = ldexp(r->xy[2 * i], -exponent), y = ldexp(r->xy[2 * i + 1], -exponent);
    b.x_min = fmin(b.x_min, x);
    b.y_min = fmin(b.y_min, y);
    b.x_max = fmax(b.x_max, x);
    b.y_max = fmax(b.y_max, y);
  }
  return b;
}

/* ---------------------------------------------------------------- drawing -- */

static void put_point(FILE *file, const frame *f, char command, double x, double y) {
  double page_x = f->left + f->scale * (ldexp(x, -f->exponent) - f->x_min);
  double page_y = f->top + f->scale * (f->y_max - ldexp(y, -f->exponent));
  fprintf(file, "%c%.2f %.2f", command, page_x, page_y);
}

/* A ring, moved by (dx, dy). */
static void put_ring(FILE *file, const frame *f, const char *class, const ring *r, double dx,
                     double dy) {
  fprintf(file, "<path class=\"%s\" d=\"", class);
  for (size_t i = 0; i < r->count; ++i) {
    put_point(file, f, i == 0 ? 'M' : 'L', r->xy[2 * i] + dx, r->xy[2 * i + 1] + dy);
  }
  fputs("Z\"/>\n", file);
}

/* All edges of one kind as one path, in which edges that follow each other are joined. */
static void put_edges(FILE *file, const frame *f, const picture *p, int kind) {
  const double *xy = p->sum.xy;
  fprintf(file, "<path class=\"edge kind%d\" d=\"", kind);
  for (size_t i = 0; i < p->sum.count; ++i) {
    if (p->sources[i].kind != kind) continue;
    size_t end = (i + 1) % p->sum.count;
    if (i == 0 || p->sources[i - 1].kind != kind) {
      put_point(file, f, 'M', xy[2 * i], xy[2 * i + 1]);
    }
    put_point(file, f, 'L', xy[2 * end], xy[2 * end + 1]);
  }
  fputs("\"/>\n", file);
}

static bool inside(box outer, double x, double y) {
  return outer.x_min <= x && x <= outer.x_max && outer.y_min <= y && y <= outer.y_max;
}

/* The vertex nearest to the middle of the ring's box. */
static const double *middle_vertex(const ring *r, int exponent) {
  box b = bounds(r, exponent);
  const double *best = r->xy;
  double best_distance = DBL_MAX;
  for (const double *v = r->xy; v < r->xy + 2 * r->count; v += 2) {
    double distance = hypot(ldexp(v[0], -exponent) - (b.x_min + b.x_max) / 2,
                            ldexp(v[1], -exponent) - (b.y_min + b.y_max) / 2);
    if (distance < best_distance) {
      best = v;
      best_distance = distance;
    }
  }
  return best;
}

/*
 * A inside the sum, faintly. A + B contains A moved by any point of B. The no-fit polygon
 * is where A is, and round A when the reference point is one of B.
 */
static void put_ghost(FILE *file, const frame *f, const picture *p, box sum) {
  if (!p->no_fit) {
    const double *v = middle_vertex(&p->b, f->exponent);
    put_ring(file, f, "ghost", &p->a, v[0], v[1]);
    return;
  }
  box a = bounds(&p->a, f->exponent);
  if (inside(sum, a.x_min, a.y_min) && inside(sum, a.x_max, a.y_max)) {
    put_ring(file, f, "ghost", &p->a, 0, 0);
  }
}

static void put_caption(FILE *file, double x, double y, const char *title, size_t vertices) {
  fprintf(file, "<text class=\"title\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", x, y + 14, title);
  fprintf(file, "<text x=\"%.1f\" y=\"%.1f\">%zu vertices</text>\n", x, y + 33, vertices);
}

/* One entry of the legend; gives the x at which the next one starts. */
static double put_key(FILE *file, double x, double y, const char *class, const char *what,
                      size_t count) {
  fprintf(file, "<path class=\"edge %s\" d=\"M%.1f %.1fh26\"/>\n", class, x, y - 5);
  fprintf(file, "<text x=\"%.1f\" y=\"%.1f\">%s: %zu</text>\n", x + 34, y, what, count);
  return x + 250;
}

static void put_legend(FILE *file, double x, double y, const picture *p) {
  if (!p->sources) {
    put_key(file, x, y, "", "edges of the outer face", p->sum.count);
    return;
  }
  size_t counts[4] = {0};
  for (size_t i = 0; i < p->sum.count; ++i) ++counts[p->sources[i].kind];
  x = put_key(file, x, y, "kind1", "translated edges, of A", counts[GCV_EDGE_TRANSLATED]);
  x = put_key(file, x, y, "kind2", "corner edges, of B", counts[GCV_EDGE_CORNER]);
  put_key(file, x, y, "kind3", "translated-corner edges, of both",
          counts[GCV_EDGE_TRANSLATED_CORNER]);
}

static void put_sum(FILE *file, const frame *f, const picture *p, box sum) {
  if (!p->sources) {
    put_ring(file, f, "sum edge", &p->sum, 0, 0);
    put_ghost(file, f, p, sum);
    return;
  }
  put_ring(file, f, "sum", &p->sum, 0, 0);
  put_ghost(file, f, p, sum);
  for (int kind = GCV_EDGE_TRANSLATED; kind <= GCV_EDGE_TRANSLATED_CORNER; ++kind) {
    put_edges(file, f, p, kind);
  }
}

/* B, and the reference point where it is on or in B's box. */
static void put_b(FILE *file, const frame *f, const picture *p, box b) {
  put_ring(file, f, "b", &p->b, 0, 0);
  double x = ldexp(p->reference[0], -f->exponent), y = ldexp(p->reference[1], -f->exponent);
  if (p->no_fit && inside(b, x, y)) {
    fprintf(file, "<circle class=\"point\" r=\"3\" cx=\"%.2f\" cy=\"%.2f\"/>\n",
            f->left + f->scale * (x - f->x_min), f->top + f->scale * (f->y_max - y));
  }
}

/* ----------------------------------------------------------------- layout -- */

void write_svg(FILE *file, const picture *p) {
  int exponent = common_exponent(p);
  box a = bounds(&p->a, exponent), b = bounds(&p->b, exponent), sum = bounds(&p->sum, exponent);

  /* A above B, and the sum beside them: the largest scale at which that fits. */
  double scale = fmin(MAX_PLOT_WIDTH / (fmax(width(a), width(b)) + width(sum)),
                      MAX_PLOT_HEIGHT / fmax(height(a) + height(b), height(sum)));
  double left_width = fmax(MIN_LEFT, scale * fmax(width(a), width(b)));
  double right_width = fmax(MIN_RIGHT, scale * width(sum));
  double plots_height = fmax(scale * (height(a) + height(b)) + GAP / 2 + CAPTION,
                             scale * height(sum));
  double page_width = MARGIN + left_width + GAP + right_width + MARGIN;
  double page_height = MARGIN + CAPTION + plots_height + LEGEND + MARGIN / 2;

  double right = MARGIN + left_width + GAP, top = MARGIN + CAPTION;
  double b_top = top + scale * height(a) + GAP / 2 + CAPTION;
  double sum_top = top + (plots_height - scale * height(sum)) / 2;
  frame a_frame = {a.x_min, a.y_max, MARGIN, top, scale, exponent};
  frame b_frame = {b.x_min, b.y_max, MARGIN, b_top, scale, exponent};
  frame sum_frame = {sum.x_min, sum.y_max, right, sum_top, scale, exponent};

  fprintf(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 %.0f %.0f\""
                " width=\"%.0f\" height=\"%.0f\">\n",
          page_width, page_height, page_width, page_height);
  fprintf(file, "<title>%s</title>\n", p->no_fit ? "The no-fit polygon of A and B"
                                                 : "The outer face of the Minkowski sum A + B");
  fputs(STYLE, file);
  fputs("<rect width=\"100%\" height=\"100%\" rx=\"8\" fill=\"#ffffff\"/>\n", file);

  put_caption(file, MARGIN, MARGIN, p->no_fit ? "A, fixed" : "A", p->a.count);
  put_ring(file, &a_frame, "a", &p->a, 0, 0);
  put_caption(file, MARGIN, b_top - CAPTION, p->no_fit ? "B, moving" : "B", p->b.count);
  put_b(file, &b_frame, p, b);
  put_caption(file, right, MARGIN, p->no_fit ? "No-fit polygon" : "Outer face of A + B",
              p->sum.count);
  put_sum(file, &sum_frame, p, sum);
  put_legend(file, MARGIN, page_height - MARGIN, p);
  fputs("</svg>\n", file);
}

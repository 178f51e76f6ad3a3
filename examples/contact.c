/*
 * contact.c - the contacts of the blocks of a small wall, as text and as a picture.
 *
 * A level course carries a sill, whose upper side is a slope. Two courses on it are turned by
 * the angle of the slope, and rounded: faces that lie on each other are parallel but for
 * rounding. One brick was pushed into its neighbour, and is brought out of it. One hangs in
 * the air, and falls on the wall. Then all pairs of blocks near each other are asked for their
 * contacts, with a slope that stands for the rounding, and without. contacts.py does the same
 * in Python.
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#include <errno.h>
#include <gcv/gcv.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"

static const char USAGE[] =
    "usage: contact FILE.svg\n"
    "\n"
    "Prints the contacts of the blocks of a small wall, and draws them to FILE.svg.\n";

enum { EXIT_USAGE = 2 };

/* The blocks that stay, then the one that was pushed, then the one that hangs in the air. */
enum { SILL = 4, PUSHED = 10, HANGING = 11, BLOCKS = 12, CORNERS = 4 };

static const double LENGTH = 4, HEIGHT = 2;

/* Lower left corners of bricks; the sill is a triangle. Those behind it are turned. */
static const double PLACES[BLOCKS][2] = {{0, 0}, {4, 0}, {8, 0}, {12, 0}, {0, 2},     {1, 0},
                                         {5, 0}, {9, 0}, {3, 2}, {7, 2},  {10.75, 2}, {1, 11}};
static const double SILL_RING[3][2] = {{0, 2}, {16, 2}, {16, 5.6}};

/* Turns by the angle of the slope, whose tangent is 9/40, and leads to its start. */
static const double TURN[6] = {40.0 / 41, -9.0 / 41, 0, 9.0 / 41, 40.0 / 41, 2};
static const double FALL[2] = {0, -16};
static const double REACH = 0.01; /* contacts are no further from touching, and no deeper */
static const double SLOPE = 1e-9; /* far above what rounding turns a face by */

/* A block, moved by a translation. */
typedef struct block {
  gcv_polygon *polygon;
  double translation[2];
} block;

/* Two blocks that have contacts. */
typedef struct touch {
  const block *a, *b;
  gcv_contact *contacts;
  size_t count, count_without_slope;
  bool keeps_both_ends, keeps_them_without_slope;
  int8_t relation;
} touch;

typedef struct scene {
  block blocks[BLOCKS];
  touch touches[BLOCKS * (BLOCKS - 1) / 2];
  size_t touch_count;
} scene;

/* ----------------------------------------------------------------- errors -- */

static bool complain(const char *subject, const char *problem) {
  fprintf(stderr, "contact: %s: %s\n", subject, problem);
  return false;
}

/* Whether a call went well; if not, says what the library says. */
static bool check(gcv_status status) {
  return status == GCV_OK || complain(gcv_status_name(status), gcv_last_error_message());
}

/* ------------------------------------------------------------------- wall -- */

/* The rings of all blocks, one after the other. */
static void write_rings(double *xy, size_t sizes[BLOCKS]) {
  for (size_t k = 0; k < BLOCKS; ++k) {
    const double x = PLACES[k][0], y = PLACES[k][1];
    const double brick[CORNERS][2] = {
        {x, y}, {x + LENGTH, y}, {x + LENGTH, y + HEIGHT}, {x, y + HEIGHT}};
    sizes[k] = k == SILL ? 3 : CORNERS;
    memcpy(xy, k == SILL ? SILL_RING : brick, sizes[k] * 2 * sizeof *xy);
    xy += 2 * sizes[k];
  }
}

static bool turn(block *b) {
  gcv_polygon *turned = NULL;
  if (!check(gcv_polygon_affine(b->polygon, TURN, &turned))) return false;
  gcv_polygon_destroy(b->polygon);
  b->polygon = turned;
  return true;
}

static bool build(scene *s) {
  double xy[BLOCKS * CORNERS * 2];
  size_t sizes[BLOCKS];
  gcv_polygon *polygons[BLOCKS] = {NULL};
  gcv_status statuses[BLOCKS];
  write_rings(xy, sizes);
  if (!check(gcv_polygon_create_many(xy, sizes, BLOCKS, 0, polygons, statuses))) return false;

  bool ok = true;
  for (size_t k = 0; k < BLOCKS; ++k) s->blocks[k].polygon = polygons[k];
  for (size_t k = 0; k < BLOCKS; ++k) ok = ok && check(statuses[k]);
  for (size_t k = SILL + 1; k < HANGING; ++k) ok = ok && turn(&s->blocks[k]);
  return ok;
}

/* The translation of b that is asked for, beside a as it was made. It is exact here: of two
   blocks near each other, only b was moved. */
static void translation_between(const block *a, const block *b, double out[2]) {
  for (int axis = 0; axis < 2; ++axis) out[axis] = b->translation[axis] - a->translation[axis];
}

/* Moves b to the position that was found beside a. */
static void move(block *b, const block *a, const double position[2]) {
  for (int axis = 0; axis < 2; ++axis) b->translation[axis] = position[axis] + a->translation[axis];
}

/* Brings the pushed block out of the one that it is deepest in. */
static bool pull_out(scene *s) {
  block *b = &s->blocks[PUSHED];
  gcv_escape deepest = {.depth = -1};
  size_t other = 0;
  for (size_t k = 0; k < PUSHED; ++k) {
    double t[2];
    gcv_escape way;
    translation_between(&s->blocks[k], b, t);
    if (!check(gcv_penetration(s->blocks[k].polygon, b->polygon, t, 1, NULL, &way))) return false;
    if (way.depth > deepest.depth) deepest = way, other = k;
  }
  move(b, &s->blocks[other], deepest.position);
  printf("block %d is %g deep in block %zu, and is moved by (%g, %g)\n", PUSHED, deepest.depth,
         other, deepest.translation[0], deepest.translation[1]);
  return true;
}

/* Lets the hanging block fall on the others. */
static bool drop(scene *s) {
  block *b = &s->blocks[HANGING];
  gcv_impact first = {.time = INFINITY};
  size_t other = 0;
  for (size_t k = 0; k < HANGING; ++k) {
    double t[2];
    gcv_impact fall;
    translation_between(&s->blocks[k], b, t);
    if (!check(gcv_cast(s->blocks[k].polygon, b->polygon, t, FALL, 1, NULL, &fall))) return false;
    if (fall.time < first.time) first = fall, other = k;
  }
  move(b, &s->blocks[other], first.position);
  printf("block %d falls by %g, on block %zu\n", HANGING, first.time * -FALL[1], other);
  return true;
}

/* --------------------------------------------------------------- contacts -- */

/* The box of a block: x0 y0 x1 y1. */
static bool box_of(const block *b, double box[4]) {
  if (!check(gcv_polygon_bounds(b->polygon, box))) return false;
  for (int i = 0; i < 4; ++i) box[i] += b->translation[i % 2];
  return true;
}

/* Whether boxes are no further apart than the reach. */
static bool are_near(const double p[4], const double q[4]) {
  return p[0] <= q[2] + REACH && q[0] <= p[2] + REACH && p[1] <= q[3] + REACH &&
         q[1] <= p[3] + REACH;
}

/* The contacts of two blocks; the caller's to free, NULL if there are none. */
static bool find_contacts(const block *a, const block *b, double slope, gcv_contact **out,
                          size_t *count) {
  double t[2];
  gcv_contact_list *list = NULL;
  translation_between(a, b, t);
  bool ok = check(gcv_contacts(a->polygon, b->polygon, t, REACH, slope, NULL, &list)) &&
            check(gcv_contact_list_contacts(list, NULL, 0, count));
  *out = NULL;
  if (ok && *count > 0) {
    *out = calloc(*count, sizeof **out);
    ok = *out ? check(gcv_contact_list_contacts(list, *out, *count, count))
              : complain("memory", strerror(errno));
  }
  gcv_contact_list_destroy(list);
  return ok;
}

/* Whether there are contacts in two places: a face lies on the other along a stretch. */
static bool are_in_two_places(const gcv_contact *contacts, size_t count) {
  for (size_t k = 1; k < count; ++k) {
    if (fabs(contacts[k].on_a[0] - contacts[0].on_a[0]) > REACH ||
        fabs(contacts[k].on_a[1] - contacts[0].on_a[1]) > REACH) {
      return true;
    }
  }
  return false;
}

/* Adds two blocks to those that have contacts, if they have any. */
static bool add_touch(scene *s, const block *a, const block *b) {
  touch found = {.a = a, .b = b};
  gcv_contact *without_slope = NULL;
  double t[2];
  translation_between(a, b, t);
  bool ok = find_contacts(a, b, SLOPE, &found.contacts, &found.count) &&
            find_contacts(a, b, 0, &without_slope, &found.count_without_slope) &&
            check(gcv_relation(a->polygon, b->polygon, t, 1, NULL, &found.relation));
  if (ok) {
    found.keeps_both_ends = are_in_two_places(found.contacts, found.count);
    found.keeps_them_without_slope = are_in_two_places(without_slope, found.count_without_slope);
  }
  free(without_slope);
  if (ok && found.count > 0)
    s->touches[s->touch_count++] = found;
  else
    free(found.contacts);
  return ok;
}

static bool find_touches(scene *s) {
  double boxes[BLOCKS][4];
  for (size_t k = 0; k < BLOCKS; ++k)
    if (!box_of(&s->blocks[k], boxes[k])) return false;
  for (size_t i = 0; i < BLOCKS; ++i) {
    for (size_t j = i + 1; j < BLOCKS; ++j) {
      if (are_near(boxes[i], boxes[j]) && !add_touch(s, &s->blocks[i], &s->blocks[j])) return false;
    }
  }
  return true;
}

static void report(const scene *s) {
  size_t touching = 0, apart = 0, overlapping = 0, total = 0, left = 0, faces = 0, kept = 0;
  for (const touch *t = s->touches; t < s->touches + s->touch_count; ++t) {
    touching += t->relation == GCV_TOUCHING;
    apart += t->relation == GCV_APART;
    overlapping += t->relation == GCV_OVERLAPPING;
    total += t->count;
    left += t->count_without_slope;
    faces += t->keeps_both_ends;
    kept += t->keeps_them_without_slope;
  }
  printf(
      "%zu pairs of blocks have contacts: %zu touch, %zu are apart by rounding, %zu overlap by "
      "rounding\n",
      s->touch_count, touching, apart, overlapping);
  printf("%zu contacts within %g; without a slope %zu of them are lost\n", total, REACH,
         total - left);
  printf("%zu pairs have contacts at both ends of a face; without a slope %zu keep both\n", faces,
         kept);
}

/* ---------------------------------------------------------------- picture -- */

static const double MARGIN = 1, ARROW = 0.7;

static bool write_block(FILE *file, const block *b, const char *style, const char *fill) {
  double xy[2 * CORNERS];
  size_t count;
  if (!check(gcv_polygon_vertices(b->polygon, xy, CORNERS, &count))) return false;
  fprintf(file, "<path class=\"%s\" d=\"", style);
  for (size_t i = 0; i < count; ++i) {
    fprintf(file, "%c%.4f %.4f", i ? 'L' : 'M', xy[2 * i] + b->translation[0],
            xy[2 * i + 1] + b->translation[1]);
  }
  fprintf(file, "Z\" fill=\"%s\"/>\n", fill);
  return true;
}

/* The point of a contact on the first of two blocks, and the normal of its edge. */
static void write_contact(FILE *file, const gcv_contact *c, const block *a) {
  const double x = c->on_a[0] + a->translation[0], y = c->on_a[1] + a->translation[1];
  fprintf(file, "<circle class=\"contact\" cx=\"%.4f\" cy=\"%.4f\" r=\"0.11\"/>\n", x, y);
  if (c->kind == GCV_CONTACT_VERTEX_VERTEX) return;
  fprintf(file, "<path class=\"normal\" d=\"M%.4f %.4fL%.4f %.4f\"/>\n", x, y,
          x + ARROW * c->normal[0], y + ARROW * c->normal[1]);
}

static bool write_picture(FILE *file, const scene *s) {
  double across = 0, up = 0;
  for (size_t k = 0; k < BLOCKS; ++k) {
    double box[4];
    if (!box_of(&s->blocks[k], box)) return false;
    across = fmax(across, box[2]);
    up = fmax(up, box[3]);
  }
  fprintf(file,
          "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" "
          "viewBox=\"%.4f %.4f %.4f %.4f\">\n"
          "<marker id=\"head\" viewBox=\"0 0 6 6\" refX=\"6\" refY=\"3\" markerWidth=\"6\" "
          "markerHeight=\"6\" orient=\"auto\"><path d=\"M0 0L6 3L0 6Z\" "
          "fill=\"#a3238e\"/></marker>\n"
          "<style>.normal { stroke: #a3238e; marker-end: url(#head) } "
          ".contact { fill: #1b2430; stroke: none }</style>\n"
          "<g transform=\"matrix(1 0 0 -1 0 %.4f)\" stroke=\"#5b6675\" stroke-width=\"0.05\">\n",
          -MARGIN, -MARGIN, across + 2 * MARGIN, up + 2 * MARGIN, up);
  bool ok = true;
  for (size_t k = 0; k < PUSHED; ++k)
    ok = ok && write_block(file, &s->blocks[k], "block", "#e3eefc");
  ok = ok && write_block(file, &s->blocks[PUSHED], "pushed", "#fdebe0") &&
       write_block(file, &s->blocks[HANGING], "hanging", "#e0f3ec");
  for (const touch *t = s->touches; t < s->touches + s->touch_count; ++t)
    for (size_t k = 0; k < t->count; ++k) write_contact(file, &t->contacts[k], t->a);
  fputs("</g>\n</svg>\n", file);
  return ok;
}

static bool draw(const char *path, const scene *s) {
  FILE *file = fopen(path, "w");
  if (!file) return complain(path, strerror(errno));
  bool ok = write_picture(file, s);
  return (close_output(file) || complain(path, strerror(errno))) && ok;
}

int main(int argc, char **argv) {
  if (argc != 2) {
    fputs(USAGE, stderr);
    return EXIT_USAGE;
  }
  scene s = {0};
  bool ok = build(&s) && pull_out(&s) && drop(&s) && find_touches(&s);
  if (ok) report(&s);
  ok = ok && draw(argv[1], &s);
  if (ok) printf("picture: %s\n", argv[1]);
  ok = (close_output(stdout) || complain("standard output", strerror(errno))) && ok;

  for (size_t k = 0; k < s.touch_count; ++k) free(s.touches[k].contacts);
  for (size_t k = 0; k < BLOCKS; ++k) gcv_polygon_destroy(s.blocks[k].polygon);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * The cases of tests/corpus, which README.md there describes. Takes the file's name.
 */
#include "corpus_scenes.h"

enum { MOST_LINE = MOST_REGION_TEXT };

static gcv_polygon *a = NULL, *b = NULL, *solid = NULL;
static gcv_scene *scene = NULL;

static void replace(gcv_polygon **polygon, const char *wkt) {
  gcv_polygon_destroy(*polygon);
  *polygon = NULL;
  CHECK_OK(gcv_polygon_create_wkt(wkt, strlen(wkt), polygon));
}

/* Appends the status, and the exact ring if there is one, as a line of the file has them. */
static void append_outcome(char *line, gcv_status status, const gcv_outer_face *face) {
  size_t count = 0, required, i;
  strcat(line, gcv_status_name(status));
  if (status != GCV_OK) return;
  CHECK_OK(gcv_outer_face_exact_vertex_count(face, &count));
  for (i = 0; i < count; ++i) {
    const size_t length = strlen(strcat(line, i == 0 ? " " : ", "));
    CHECK_OK(
        gcv_outer_face_exact_vertex(face, i, line + length, MOST_LINE - 2 - length, &required));
  }
}

/* The region that a word such as "no_fit_region" asks for, likewise. */
static void append_region(char *line, const char *word, const double point[2]) {
  gcv_region *region = NULL;
  gcv_status status = GCV_ERR_INTERNAL;
  if (strcmp(word, "sum_region") == 0) {
    status = gcv_minkowski_sum_region(a, b, NULL, &region);
  } else if (strcmp(word, "no_fit_region") == 0) {
    status = gcv_no_fit_region(a, b, point, NULL, &region);
  } else if (strcmp(word, "entrance_region") == 0) {
    status = gcv_entrance_region(a, b, point, NULL, &region);
  } else if (CHECK(strcmp(word, "inner_fit_region") == 0)) {
    status = gcv_inner_fit_region(a, b, point, NULL, &region);
  }
  strcat(line, gcv_status_name(status));
  if (status == GCV_OK) exact_region_text(region, line + strlen(strcat(line, " ")));
  gcv_region_destroy(region);
}

/* The words of a line whose first one is that of a question: that, and numbers. Gives how many
 * bytes they take; 0 for any other line. */
static int read_question(const char *line, char *word, double numbers[4]) {
  static const struct {
    const char *word;
    int numbers;
  } questions[] = {
      {"relation", 2},       {"distance", 2},          {"cast", 4},
      {"penetration", 2},    {"contacts", 4},          {"scene_relation", 2},
      {"scene_distance", 2}, {"scene_cast", 4},        {"scene_penetration", 2},
      {"scene_best", 2},     {"scene_free_region", 0}, {"scene_window_region", 4},
      {"scene_near", 3},     {"scene_pairs", 1},       {"scene_contacts", 2},
  };
  int end = 0, count = -1, k;
  if (sscanf(line, "%31s%n", word, &end) != 1) return 0;
  for (k = 0; k < (int)(sizeof questions / sizeof questions[0]); ++k) {
    if (strcmp(word, questions[k].word) == 0) count = questions[k].numbers;
  }
  if (count < 0) return 0;
  for (k = 0; k < count; ++k) {
    char *rest;
    numbers[k] = strtod(line + end, &rest);
    end = (int)(rest - line);
  }
  return end;
}

/* The status, and the answer if there is one. */
static void append_answer(char *line, const char *word, const double *numbers, int is_exact) {
  int8_t relation = 2;
  gcv_separation separation;
  gcv_impact impact;
  gcv_escape escape;
  gcv_contact_list *contacts = NULL;
  if (strcmp(word, "relation") == 0) {
    if (append_status(line, gcv_relation(a, b, numbers, 1, NULL, &relation))) {
      append_relation(line, relation);
    }
  } else if (strcmp(word, "distance") == 0) {
    if (append_status(line, gcv_distance(a, b, numbers, 1, NULL, &separation))) {
      append_separation(line, &separation, 0);
    }
  } else if (strcmp(word, "penetration") == 0) {
    if (append_status(line, gcv_penetration(a, b, numbers, 1, NULL, &escape))) {
      append_escape(line, &escape, is_exact, 0);
    }
  } else if (strcmp(word, "contacts") == 0) {
    if (append_status(line, gcv_contacts(a, b, numbers, numbers[2], numbers[3], NULL, &contacts))) {
      append_contacts(line, contacts, 0);
    }
    gcv_contact_list_destroy(contacts);
  } else if (append_status(line, gcv_cast(a, b, numbers, numbers + 2, 1, NULL, &impact))) {
    append_impact(line, &impact, is_exact, 0);
  }
}

/* Does what a line says, and writes the line that it should be. */
static void follow(const char *line, char *should_be) {
  char word[MOST_LINE] = "", question[32], x[64], y[64], status_name[64];
  double point[2], numbers[4];
  int end = 0, is_exact;
  gcv_status status;
  gcv_outer_face *face = NULL;
  gcv_polygon *polygon = NULL;
  uint64_t id = 0;
  strcpy(should_be, line);
  sscanf(line, "%s", word);
  if (strcmp(word, "a") == 0) {
    replace(&a, line + 2);
  } else if (strcmp(word, "b") == 0) {
    replace(&b, line + 2);
  } else if (strcmp(word, "case") == 0) {
    gcv_scene_destroy(scene);
    scene = NULL;
    CHECK_OK(gcv_scene_create(&scene));
  } else if (strcmp(word, "container") == 0) {
    replace(&solid, line + strlen("container "));
    CHECK_OK(gcv_scene_set_container(scene, solid));
  } else if (sscanf(line, "member %63s %63s %n", x, y, &end) == 2) {
    replace(&solid, line + end);
    point[0] = strtod(x, NULL);
    point[1] = strtod(y, NULL);
    CHECK_OK(gcv_scene_add(scene, (const gcv_polygon *const *)&solid, point, 1, &id));
  } else if ((end = read_question(line, question, numbers)) > 0) {
    should_be[end] = '\0';
    is_exact = strstr(line, " inexact") == NULL;
    strcat(should_be, " ");
    if (strncmp(question, "scene_", 6) == 0) {
      append_scene_answer(should_be, scene, b, question, numbers, is_exact);
    } else {
      append_answer(should_be, question, numbers, is_exact);
    }
  } else if (sscanf(line, "refuse %63s %n", status_name, &end) == 1) {
    status = gcv_polygon_create_wkt(line + end, strlen(line + end), &polygon);
    sprintf(should_be, "refuse %s %s", gcv_status_name(status), line + end);
    gcv_polygon_destroy(polygon);
  } else if (strcmp(word, "sum") == 0) {
    status = gcv_minkowski_sum(a, b, NULL, &face);
    strcpy(should_be, "sum ");
    append_outcome(should_be, status, face);
  } else if (strcmp(word, "sum_region") == 0) {
    strcpy(should_be, "sum_region ");
    append_region(should_be, word, NULL);
  } else if (sscanf(line, "%*s %63s %63s", x, y) == 2) {
    const int no_fit = strcmp(word, "no_fit") == 0;
    point[0] = strtod(x, NULL);
    point[1] = strtod(y, NULL);
    sprintf(should_be, "%s %s %s ", word, x, y);
    if (strstr(word, "_region") != NULL) {
      append_region(should_be, word, point);
    } else if (CHECK(no_fit || strcmp(word, "entrance") == 0)) {
      status = no_fit ? gcv_no_fit_polygon(a, b, point, NULL, &face)
                      : gcv_entrance_block(a, b, point, NULL, &face);
      append_outcome(should_be, status, face);
    }
  } else {
    CHECK(0);
  }
  gcv_outer_face_destroy(face);
}

int main(int argc, char **argv) {
  static char line[MOST_LINE], should_be[2 * MOST_LINE];
  FILE *file = argc == 2 ? fopen(argv[1], "r") : NULL;
  int number = 0, tried = 0;
  if (!CHECK(file != NULL)) return 1;
  while (fgets(line, sizeof line, file) != NULL) {
    ++number;
    line[strcspn(line, "\n")] = '\0';
    if (line[0] == '\0' || line[0] == '#') continue;
    follow(line, should_be);
    ++tried;
    if (!CHECK(strcmp(line, should_be) == 0)) {
      fprintf(stderr, "%s:%d: %s\n  should be: %s\n", argv[1], number, line, should_be);
    }
  }
  CHECK(tried > 800);
  fclose(file);
  gcv_polygon_destroy(a);
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(solid);
  gcv_scene_destroy(scene);
  return check_failures != 0;
}

/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Answers about scenes as the lines of tests/corpus have them.
 */
#ifndef GCV_TESTS_CAPI_CORPUS_SCENES_H
#define GCV_TESTS_CAPI_CORPUS_SCENES_H

#include "corpus_texts.h"

enum { MOST_PAIRS = 64 };

static inline void append_pairs(char *line, const gcv_pair_list *list) {
  gcv_pair pairs[MOST_PAIRS];
  size_t count = 0, i;
  CHECK_OK(gcv_pair_list_pairs(list, pairs, MOST_PAIRS, &count));
  if (count == 0) strcat(line, " empty");
  for (i = 0; i < count; ++i) {
    if (i > 0) strcat(line, ";");
    append_id(line, pairs[i].a);
    append_id(line, pairs[i].b);
    append_relation(line, pairs[i].relation);
  }
}

/* It is left out where the exact one is no pair of doubles. */
static inline void append_best(char *line, const double best[2], int found, int is_exact) {
  if (!found || !is_exact) {
    strcat(line, found ? " inexact" : " none");
  } else {
    append_number(line, best[0]);
    append_number(line, best[1]);
  }
}

/* The status, and what is free if that can be told. */
static inline void append_free_region(char *line, const gcv_scene *scene, const gcv_polygon *moving,
                                      const double *window) {
  gcv_region *region = NULL;
  if (append_status(line, gcv_scene_free_region(scene, moving, window, NULL, NULL, &region))) {
    exact_region_text(region, line + strlen(strcat(line, " ")));
  }
  gcv_region_destroy(region);
}

/* The status, and the list if there is one, which is ended. */
static inline void append_pair_list(char *line, gcv_status status, gcv_pair_list *list) {
  if (append_status(line, status)) append_pairs(line, list);
  gcv_pair_list_destroy(list);
}

/* The status, and the answer if there is one. */
static inline void append_scene_answer(char *line, const gcv_scene *scene,
                                       const gcv_polygon *moving, const char *word,
                                       const double *numbers, int is_exact) {
  int8_t relation = 2;
  int32_t found = 0;
  double best[2];
  gcv_separation separation;
  gcv_impact impact;
  gcv_escape escape;
  gcv_contact_list *contacts = NULL;
  gcv_pair_list *pairs = NULL;
  gcv_status status;
  if (strcmp(word, "scene_relation") == 0) {
    status = gcv_scene_relation(scene, moving, numbers, 1, NULL, NULL, &relation);
    if (append_status(line, status)) append_relation(line, relation);
  } else if (strcmp(word, "scene_distance") == 0) {
    status = gcv_scene_distance(scene, moving, numbers, 1, NULL, NULL, &separation);
    if (append_status(line, status)) append_separation(line, &separation, 1);
  } else if (strcmp(word, "scene_cast") == 0) {
    status = gcv_scene_cast(scene, moving, numbers, numbers + 2, 1, NULL, NULL, &impact);
    if (append_status(line, status)) append_impact(line, &impact, is_exact, 1);
  } else if (strcmp(word, "scene_penetration") == 0) {
    status = gcv_scene_penetration(scene, moving, numbers, 1, NULL, NULL, &escape);
    if (append_status(line, status)) append_escape(line, &escape, is_exact, 1);
  } else if (strcmp(word, "scene_best") == 0) {
    status = gcv_scene_best(scene, moving, numbers, NULL, NULL, best, &found);
    if (append_status(line, status)) append_best(line, best, found, is_exact);
  } else if (strcmp(word, "scene_free_region") == 0) {
    append_free_region(line, scene, moving, NULL);
  } else if (strcmp(word, "scene_window_region") == 0) {
    append_free_region(line, scene, moving, numbers);
  } else if (strcmp(word, "scene_near") == 0) {
    status = gcv_scene_near(scene, moving, numbers, numbers[2], NULL, NULL, &pairs);
    append_pair_list(line, status, pairs);
  } else if (strcmp(word, "scene_pairs") == 0) {
    status = gcv_scene_pairs(scene, NULL, numbers[0], NULL, NULL, &pairs);
    append_pair_list(line, status, pairs);
  } else if (CHECK(strcmp(word, "scene_contacts") == 0)) {
    status = gcv_scene_contacts(scene, NULL, numbers[0], numbers[1], NULL, NULL, &contacts);
    if (append_status(line, status)) append_contacts(line, contacts, 1);
    gcv_contact_list_destroy(contacts);
  }
}

#endif

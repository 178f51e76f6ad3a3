/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Answers as the lines of tests/corpus have them, appended to a line.
 */
#ifndef GCV_TESTS_CAPI_CORPUS_TEXTS_H
#define GCV_TESTS_CAPI_CORPUS_TEXTS_H

#include "regions.h"

enum { MOST_CONTACTS = 64 };

/* Does an answer follow? */
static inline int append_status(char *line, gcv_status status) {
  strcat(line, gcv_status_name(status));
  return status == GCV_OK;
}

static inline void append_number(char *line, double x) {
  sprintf(line + strlen(line), " %.17g", x);
}

static inline void append_relation(char *line, int relation) {
  static const char *const names[] = {" overlapping", " touching", " apart"};
  strcat(line, CHECK(relation >= -1 && relation <= 1) ? names[relation + 1] : " ?");
}

static inline void append_contact(char *line, const gcv_contact *contact) {
  static const char *const names[] = {" none", " edge_vertex", " vertex_edge", " vertex_vertex"};
  strcat(line, CHECK(contact->kind >= 0 && contact->kind <= 3) ? names[contact->kind] : " ?");
  if (contact->kind == 0) return;
  sprintf(line + strlen(line), " %u %u", (unsigned)contact->a, (unsigned)contact->b);
  append_number(line, contact->gap);
  append_number(line, contact->on_a[0]);
  append_number(line, contact->on_a[1]);
  append_number(line, contact->on_b[0]);
  append_number(line, contact->on_b[1]);
}

/* It is left out where the exact one is no pair of doubles. */
static inline void append_position(char *line, int relation, const double position[2],
                                   int is_exact) {
  if (is_exact) {
    append_relation(line, relation);
    append_number(line, position[0]);
    append_number(line, position[1]);
  } else {
    strcat(line, " inexact");
  }
}

static inline void append_id(char *line, uint64_t id) {
  sprintf(line + strlen(line), " %lu", (unsigned long)id);
}

/* Of a scene, its id goes first. */
static inline void append_contact_of(char *line, const gcv_contact *contact, int is_of_scene) {
  if (is_of_scene) append_id(line, contact->id_a);
  CHECK(contact->id_b == 0);
  append_contact(line, contact);
}

static inline void append_separation(char *line, const gcv_separation *separation,
                                     int is_of_scene) {
  append_relation(line, separation->relation);
  append_number(line, separation->distance);
  append_contact_of(line, &separation->nearest, is_of_scene);
}

static inline void append_impact(char *line, const gcv_impact *impact, int is_exact,
                                 int is_of_scene) {
  CHECK(impact->hit == 0 || impact->hit == 1);
  strcat(line, impact->hit ? " hit" : " miss");
  append_number(line, impact->time);
  append_position(line, impact->relation, impact->position, is_exact);
  append_contact_of(line, &impact->contact, is_of_scene);
}

static inline void append_escape(char *line, const gcv_escape *escape, int is_exact,
                                 int is_of_scene) {
  append_number(line, escape->depth);
  append_number(line, escape->translation[0]);
  append_number(line, escape->translation[1]);
  append_position(line, escape->relation, escape->position, is_exact);
  append_contact_of(line, &escape->contact, is_of_scene);
}

static inline void append_contacts(char *line, const gcv_contact_list *list, int is_of_scene) {
  gcv_contact contacts[MOST_CONTACTS];
  size_t count = 0, i;
  CHECK_OK(gcv_contact_list_contacts(list, contacts, MOST_CONTACTS, &count));
  if (count == 0) strcat(line, " empty");
  for (i = 0; i < count; ++i) {
    if (i > 0) strcat(line, ";");
    if (is_of_scene) {
      append_id(line, contacts[i].id_a);
      append_id(line, contacts[i].id_b);
    }
    append_contact(line, &contacts[i]);
  }
}

#endif

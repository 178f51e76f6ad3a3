/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * gcv_options_init_size: the defaults in a struct of any size, of earlier and of later versions.
 */
#include "handles.h"

enum { ROOM = 256, SENTINEL = 0xa5, SIZE_0_1 = offsetof(gcv_options, leave_out) };

union options {
  gcv_options known;
  unsigned char bytes[ROOM];
};

static gcv_polygon *square;

static int all_are(const unsigned char *from, const unsigned char *to, unsigned char byte) {
  while (from != to && *from == byte) ++from;
  return from == to;
}

/* The bytes of the defaults, where they are not padding, are those of the macro. */
static int holds_defaults(const union options *options, uint32_t size) {
  const gcv_options defaults = GCV_OPTIONS_INIT;
  union options whole = {GCV_OPTIONS_INIT};
  memcpy(&whole, options, size < sizeof defaults ? size : sizeof defaults);
  return whole.known.struct_size == size && whole.known.rounding == defaults.rounding &&
         whole.known.tolerance == defaults.tolerance && whole.known.threads == defaults.threads &&
         whole.known.progress == NULL && whole.known.progress_context == NULL &&
         whole.known.leave_out == defaults.leave_out;
}

static gcv_status sum_with(const gcv_options *options) {
  gcv_outer_face *face = NULL;
  gcv_region *region = NULL;
  const gcv_status status = gcv_minkowski_sum(square, square, options, &face);
  CHECK(gcv_minkowski_sum_region(square, square, options, &region) == status);
  gcv_outer_face_destroy(face);
  gcv_region_destroy(region);
  return status;
}

static void every_size(void) {
  uint32_t size;
  for (size = 0; size <= ROOM; ++size) {
    const uint32_t written = size < 16 ? 0 : size;
    union options options;
    memset(&options, SENTINEL, sizeof options);
    gcv_options_init_size(&options.known, size);
    CHECK(all_are(options.bytes + written, options.bytes + ROOM, SENTINEL));
    if (written == 0) continue;
    CHECK(holds_defaults(&options, size));
    if (size > sizeof(gcv_options)) {
      CHECK(all_are(options.bytes + sizeof(gcv_options), options.bytes + size, 0));
    }
    /* Those of versions that there are, and of later ones, can be used. */
    if (size == 16 || size == SIZE_0_1 || size >= sizeof(gcv_options)) {
      CHECK_OK(sum_with(&options.known));
    } else {
      CHECK_STATUS(GCV_ERR_INVALID_ARGUMENT, sum_with(&options.known));
    }
  }
}

/* All of a struct is written, its padding too: no byte of it is left to chance. */
static void all_bytes(void) {
  union options first, second;
  memset(&first, 0, sizeof first);
  memset(&second, 0xff, sizeof second);
  gcv_options_init_size(&first.known, ROOM);
  gcv_options_init_size(&second.known, ROOM);
  CHECK(memcmp(&first, &second, ROOM) == 0);
  CHECK(all_are(first.bytes + offsetof(gcv_options, threads) + sizeof first.known.threads,
                first.bytes + offsetof(gcv_options, progress), 0));
}

static void is_as_the_other(void) {
  gcv_options options;
  union options sized;
  gcv_options_init(&options);
  gcv_options_init_size(&sized.known, sizeof options);
  CHECK(options.struct_size == sizeof options && sized.known.struct_size == sizeof options);
  CHECK(holds_defaults(&sized, sizeof options));
  gcv_options_init_size(NULL, sizeof options);
  gcv_options_init_size(NULL, 0);
  gcv_options_init_size(NULL, UINT32_MAX);
  CHECK(strcmp(gcv_last_error_message(), "") == 0);
}

int main(void) {
  square = POLYGON(0, 0, 1, 0, 1, 1, 0, 1);
  is_as_the_other();
  every_size();
  all_bytes();
  gcv_polygon_destroy(square);
  return check_failures != 0;
}

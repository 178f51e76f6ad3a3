// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_version_*: the version of the library.
#include "gcv/gcv.h"
#include "text_of.hpp"

uint32_t gcv_version_number(void) {
  return GCV_VERSION_MAJOR * 10000 + GCV_VERSION_MINOR * 100 + GCV_VERSION_PATCH;
}

const char* gcv_version_string(void) {
  return GCV_TEXT(GCV_VERSION_MAJOR) "." GCV_TEXT(GCV_VERSION_MINOR) "." GCV_TEXT(
      GCV_VERSION_PATCH);
}

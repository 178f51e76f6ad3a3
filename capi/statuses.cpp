// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_status_name and gcv_last_error_message: statuses as text.
#include "gcv/gcv.h"
#include "guard.hpp"

const char* gcv_status_name(gcv_status status) {
  switch (status) {
    case GCV_OK:
      return "GCV_OK";
    case GCV_ERR_NULL_ARGUMENT:
      return "GCV_ERR_NULL_ARGUMENT";
    case GCV_ERR_INVALID_ARGUMENT:
      return "GCV_ERR_INVALID_ARGUMENT";
    case GCV_ERR_NOT_FINITE:
      return "GCV_ERR_NOT_FINITE";
    case GCV_ERR_DEGENERATE:
      return "GCV_ERR_DEGENERATE";
    case GCV_ERR_NOT_SIMPLE:
      return "GCV_ERR_NOT_SIMPLE";
    case GCV_ERR_BUFFER_TOO_SMALL:
      return "GCV_ERR_BUFFER_TOO_SMALL";
    case GCV_ERR_RANGE:
      return "GCV_ERR_RANGE";
    case GCV_ERR_PARSE:
      return "GCV_ERR_PARSE";
    case GCV_ERR_NO_MEMORY:
      return "GCV_ERR_NO_MEMORY";
    case GCV_ERR_CANCELLED:
      return "GCV_ERR_CANCELLED";
    case GCV_ERR_INTERNAL:
      return "GCV_ERR_INTERNAL";
    default:
      return "GCV_ERR_UNKNOWN";
  }
}

const char* gcv_last_error_message(void) { return gcv::capi::last_message(); }

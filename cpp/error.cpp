// SPDX-License-Identifier: LGPL-3.0-or-later
#include "error.hpp"

#include <cstdarg>
#include <cstdio>

namespace gcv {

Error::Error(Status status, const char* format, ...) noexcept : status_(status) {
  std::va_list arguments;
  va_start(arguments, format);
  static_cast<void>(std::vsnprintf(message_, sizeof message_, format, arguments));
  va_end(arguments);
}

}  // namespace gcv

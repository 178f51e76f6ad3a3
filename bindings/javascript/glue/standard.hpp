// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the library takes of C++20 that the standard library of Debian's Emscripten lacks. Included
// before every source file.
#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

// strtod has no locales here. It takes hexadecimal digits, a sign and spaces too.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string_view rest(first, static_cast<size_t>(last - first));
  const string text(rest.substr(0, rest.find_first_of("xX,() \t\n\v\f\r")));
  char* end = nullptr;
  const double number = text.starts_with('+') ? 0 : strtod(text.c_str(), &end);
  if (end == nullptr || end == text.c_str()) {
    return {first, errc::invalid_argument};
  }
  value = number;
  return {first + (end - text.c_str()), errc()};
}

// 17 digits, which read back as the same double, but are not always the fewest. The package writes
// its texts in JavaScript.
inline to_chars_result to_chars(char* first, char* last, double value) {
  char text[32];
  const int length = snprintf(text, sizeof text, "%.17g", value);
  if (length > last - first) {
    return {last, errc::value_too_large};
  }
  return {copy(text, text + length, first), errc()};
}

}  // namespace std
#endif

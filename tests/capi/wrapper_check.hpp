/* SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Checks as in check.h, for C++: each says on stderr what does not hold, and the program goes on.
 */
#ifndef GCV_TESTS_CAPI_WRAPPER_CHECK_HPP
#define GCV_TESTS_CAPI_WRAPPER_CHECK_HPP

#include <cstdio>
#include <gcv/gcv.hpp>
#include <string>

#define CHECK(condition) check((condition), __FILE__, __LINE__, #condition)
/* The expression throws an Error with this status, and `part` occurs in its message. */
#define CHECK_THROWS(status, part, ...) \
  check_throws(                         \
      status, part, [&] { (void)(__VA_ARGS__); }, __FILE__, __LINE__, #__VA_ARGS__)

inline int check_failures = 0;

inline void check(bool holds, const char* file, int line, const char* text) {
  if (!holds) {
    std::fprintf(stderr, "%s:%d: %s\n", file, line, text);
    ++check_failures;
  }
}

template <class Expression>
void check_throws(gcv_status status, const char* part, const Expression& expression,
                  const char* file, int line, const char* text) {
  try {
    expression();
  } catch (const gcv::Error& error) {
    if (error.status() == status && std::string(error.what()).find(part) != std::string::npos) {
      return;
    }
    std::fprintf(stderr, "%s: %s\n", error.status_name(), error.what());
  }
  check(false, file, line, text);
}

#endif

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The one exception type of the core. The message is in a fixed buffer, so reporting an error needs
// no memory.
#pragma once

#include <cstdint>
#include <exception>

// mingw-w64 has two printf: that of the C standard, which C++ gets, and that of Windows.
#ifdef __MINGW32__
#define GCV_PRINTF gnu_printf
#else
#define GCV_PRINTF printf
#endif

namespace gcv {

// The values are those of gcv_status.
enum class Status : std::int32_t {
  ok = 0,
  null_argument = 1,
  invalid_argument = 2,
  not_finite = 3,
  degenerate = 4,
  not_simple = 5,
  buffer_too_small = 6,
  range = 7,
  parse = 8,
  no_memory = 9,
  cancelled = 11,
  internal = 100,
};

class Error : public std::exception {
 public:
  static constexpr int capacity = 512;

  // Takes a format as printf does. Cuts messages that are longer than the buffer.
  [[gnu::format(GCV_PRINTF, 3, 4)]] Error(Status status, const char* format, ...) noexcept;

  [[nodiscard]] Status status() const noexcept { return status_; }
  [[nodiscard]] const char* what() const noexcept override { return message_; }

 private:
  Status status_;
  char message_[capacity] = "";
};

// The exception that is being handled, as an Error. Call only in a catch block.
Error current_error() noexcept;

}  // namespace gcv

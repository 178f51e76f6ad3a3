// SPDX-License-Identifier: LGPL-3.0-or-later
#include "error.hpp"

#include <cstdarg>
#include <cstdio>
#include <new>
#include <stdexcept>

namespace gcv {

Error::Error(Status status, const char* format, ...) noexcept : status_(status) {
  std::va_list arguments;
  va_start(arguments, format);
  static_cast<void>(std::vsnprintf(message_, sizeof message_, format, arguments));
  va_end(arguments);
}

Error current_error() noexcept {
  try {
    throw;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return {Status::no_memory, "not enough memory"};
  } catch (const std::length_error&) {
    return {Status::no_memory, "more memory than a vector can hold"};
  } catch (const std::exception& exception) {
    return {Status::internal, "unexpected: %s", exception.what()};
  } catch (...) {
    return {Status::internal, "unexpected exception"};
  }
}

}  // namespace gcv

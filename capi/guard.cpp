// SPDX-License-Identifier: LGPL-3.0-or-later
#include "guard.hpp"

#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

namespace gcv::capi {

namespace {

thread_local char message[Error::capacity] = "";

}  // namespace

const char* last_message() noexcept { return message; }

gcv_status record(const Error& error) noexcept {
  std::memcpy(message, error.what(), sizeof message);
  return static_cast<gcv_status>(error.status());
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

}  // namespace gcv::capi

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "guard.hpp"

#include <cstring>

namespace gcv::capi {

namespace {

thread_local char message[Error::capacity] = "";

}  // namespace

const char* last_message() noexcept { return message; }

gcv_status record(const Error& error) noexcept {
  std::memcpy(message, error.what(), sizeof message);
  return static_cast<gcv_status>(error.status());
}

}  // namespace gcv::capi

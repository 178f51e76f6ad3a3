// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A function in a process of its own: whatever it does, the next one starts from the same state.
#pragma once

#include <cstring>
#include <functional>
#include <string>
#include <type_traits>

namespace gcv::bench {

struct Outcome {
  std::string bytes;        // what the function returned
  std::string failure;      // empty where there is a result
  bool is_cut_off = false;  // it took too long
};

// The process is ended after `limit` seconds of processor time.
Outcome run_apart(double limit, const std::function<std::string()>& function);

// What a function apart returns, as bytes.
template <class Value>
std::string to_bytes(const Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

template <class Value>
Value from_bytes(const std::string& bytes) {
  Value value{};
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

}  // namespace gcv::bench

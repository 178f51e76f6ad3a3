// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A function in a process of its own: whatever it does, the next one starts from the same state.
#pragma once

#include <functional>
#include <string>

namespace gcv::bench {

struct Outcome {
  std::string bytes;        // what the function returned
  std::string failure;      // empty where there is a result
  bool is_cut_off = false;  // it took too long
};

// The process is ended after `limit` seconds of processor time.
Outcome run_apart(double limit, const std::function<std::string()>& function);

}  // namespace gcv::bench

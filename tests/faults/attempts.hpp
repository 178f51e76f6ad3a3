// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calls while allocations fail: the n-th one, alone or with all after it, for every n.
#pragma once

#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>

#include "faulty_memory.hpp"
#include "pairs.hpp"

namespace gcv::faults {

struct Faults {
  long first = never;  // the number of the allocation that fails, from 0
  long count = 0;
};

// Runs the call while the faults are there.
template <class Call>
gcv_status run(const Faults& faults, Call call) {
  failed = failed_loudly = false;
  until_fault = faults.first;
  faults_left = faults.count;
  const gcv_status status = call();
  until_fault = never;
  faults_left = 0;
  return status;
}

struct Outcome {
  gcv_status status;
  bool untouched;  // the output
  std::string transcript;
};

using Attempt = std::function<Outcome(const Faults&)>;

// call(&out) gives a handle.
template <class Handle, class Call>
Attempt handle(Call call) {
  return [call](const Faults& faults) {
    static char nothing;
    Handle* out = reinterpret_cast<Handle*>(&nothing);
    const gcv_status status = run(faults, [&] { return call(&out); });
    const Owner<Handle> owner(status == GCV_OK ? out : nullptr);
    return Outcome{status, out == reinterpret_cast<Handle*>(&nothing),
                   owner ? faults::transcript(out) : ""};
  };
}

// call(text, capacity, &required) gives text.
template <class Call>
Attempt text(Call call) {
  return [call](const Faults& faults) {
    constexpr std::size_t capacity = 4096;
    const std::string untouched(capacity, '?');
    std::string out = untouched;
    std::size_t required = 0;
    const gcv_status status = run(faults, [&] { return call(out.data(), capacity, &required); });
    return Outcome{status, out == untouched, out};
  };
}

enum class Threads { one, many };

// Gives the number of allocations that the attempt takes.
inline long starve(const std::string& name, const Attempt& attempt, long faults_at_once,
                   const Outcome& expected, Threads threads) {
  for (long n = 0;; ++n) {
    const std::string where = name + ", allocation " + std::to_string(n);
    const long live_before = live;
    {
      const Outcome outcome = attempt({n, faults_at_once});
      const bool well = outcome.status == GCV_OK;
      if (!failed) {
        check(well && outcome.transcript == expected.transcript, where, " is one too many");
        return n;
      }
      // Who asks politely may go on without, and who asks for a thread.
      check(well ? !failed_loudly || threads == Threads::many : outcome.status == GCV_ERR_NO_MEMORY,
            where + " gave ", gcv_status_name(outcome.status));
      check(well ? outcome.transcript == expected.transcript : outcome.untouched, where,
            " gave a wrong result");
    }
    check(live == live_before, where, " leaks");
    check(attempt({}).transcript == expected.transcript, where, " changes later results");
    check(live == live_before, where, " leaks later");
  }
}

inline void starve(const std::string& name, const Attempt& attempt,
                   Threads threads = Threads::one) {
  const Outcome expected = attempt({});
  check(expected.status == GCV_OK && !expected.untouched, name, " does nothing");
  const long allocations = starve(name, attempt, 1, expected, threads);
  starve(name + ", and all later ones", attempt, never, expected, threads);
  check(allocations > 0, name, " takes no memory");
  std::printf("%s: %ld allocations\n", name.c_str(), allocations);
}

}  // namespace gcv::faults

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One system on one pair, in a process of its own: whatever it does, the next one starts
// from the same state.
#pragma once

#include <limits>

#include "systems/system.hpp"

namespace gcv::bench {

struct Demand {
  double limit;             // seconds after which the process is ended
  bool is_timed = true;     // or else run just once
  bool wants_ring = false;  // or else its measures alone
  // After so many seconds in all there is no further batch.
  double most_seconds = std::numeric_limits<double>::infinity();
};

struct Measurement {
  double seconds = 0;  // for one run: the least of some
  std::size_t vertices = 0;
  double area = 0;
  std::size_t peak_bytes = 0;  // resident in the process, with the input
  Observation observation;
  std::string failure;      // empty where there is a result
  bool is_cut_off = false;  // it took too long
  Ring ring = {};           // where it was wanted
};

Measurement measure(const System& system, const Ring& a, const Ring& b, const Demand& demand);

}  // namespace gcv::bench

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The operators new and delete of a program that is linked with this count blocks, and allocations
// fail when they are told to.
#pragma once

#include <limits>

namespace gcv::faults {

constexpr long never = std::numeric_limits<long>::max();

extern long live;         // blocks that were taken and not given back
extern long until_fault;  // allocations that go well; `never` at first
extern long faults_left;  // allocations that fail after these
extern bool failed;
extern bool failed_loudly;  // in an allocation that throws

}  // namespace gcv::faults

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The system gives a program that is linked with this only so many threads.
#pragma once

namespace gcv::faults {

// How many threads there will be, and how many were refused. For one thread at a time.
extern long threads_left;
extern long threads_refused;

}  // namespace gcv::faults

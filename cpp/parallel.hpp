// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Work on several threads, the calling one among them.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>

namespace gcv {

// As many threads as the machine runs at once, at least 1.
unsigned available_threads();

// Calls work(k) once for every k below `count`, on at most `threads` threads; on fewer where
// the system gives no more. Returns when all calls have. Where calls throw, the others are
// made all the same, and the exception of the smallest k is thrown in the end.
void for_each_in_parallel(std::size_t count, unsigned threads,
                          const std::function<void(std::size_t)>& work);

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Runs work on several threads, of which the calling thread is one.
#pragma once

#include <cstddef>
#include <functional>

namespace gcv {

// The number of threads that the machine runs at once, at least 1.
unsigned available_threads();

// The part of for_each_in_parallel that starts threads.
void run_on_threads(std::size_t count, unsigned threads,
                    const std::function<void(std::size_t)>& work,
                    const std::function<void()>& waiting);

// Calls work(k) once for every k below `count`, on at most `threads` threads. Uses fewer threads if
// the system gives no more. Returns when all calls have returned.
//
// If calls throw, the exception of the smallest k is thrown at the end. On one thread no call
// follows the one that throws.
//
// While the calling thread waits for the others, it calls waiting() once a millisecond. waiting()
// must not throw.
template <class Work, class Waiting>
void for_each_in_parallel(std::size_t count, unsigned threads, const Work& work,
                          const Waiting& waiting) {
  if (threads > 1 && count > 1) {
    run_on_threads(count, threads, std::cref(work), std::cref(waiting));
    return;
  }
  for (std::size_t k = 0; k < count; ++k) {
    work(k);
  }
}

template <class Work>
void for_each_in_parallel(std::size_t count, unsigned threads, const Work& work) {
  for_each_in_parallel(count, threads, work, [] {});
}

}  // namespace gcv

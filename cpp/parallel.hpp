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

// Work on a team of threads, as for_each_in_parallel.
void run_on_threads(std::size_t count, unsigned threads,
                    const std::function<void(std::size_t)>& work,
                    const std::function<void()>& waiting);

// Calls work(k) once for every k below `count`, on at most `threads` threads; on fewer where
// the system gives no more. Returns when all calls have. Where calls throw, the exception of
// the smallest k is thrown in the end, and on one thread no call is made after it. The calling
// thread, where it has no more work and waits for the others, calls waiting() once a millisecond;
// that must not throw.
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

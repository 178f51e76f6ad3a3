// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Answers to a question for many translations or positions: all or nothing, on several threads.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "contacts.hpp"
#include "error.hpp"
#include "gcv/gcv.h"
#include "options.hpp"
#include "parallel.hpp"
#include "task.hpp"

namespace gcv::capi {

// After how many translations progress is reported. Hard questions take a time that grows with the
// number of vertices.
inline std::uint64_t translations_a_report(std::uint64_t size_a, std::uint64_t size_b) {
  constexpr std::uint64_t most_vertices = std::uint64_t{1} << 16;  // of all translations
  return std::clamp<std::uint64_t>(most_vertices / (size_a + size_b), 1, Task::portion);
}

// For answers whose making takes long: blocks that each serve many of them.
inline std::size_t long_block(std::size_t count, const gcv_options& options) {
  const unsigned threads = threads_of(options);
  return threads == 1 ? count : count / (std::size_t{4} * threads) + 1;
}

// Writes to out[k], for each k below `count`, once all are known, what answer(k, tally, task)
// gives. begin(tally) makes the answer for some of them, a block, which it serves one after the
// other. Tells the task after each `portion` of them.
template <class Begin, class Result>
void give_all(std::size_t count, std::uint64_t a_report, std::size_t portion, std::size_t block,
              const gcv_options& options, Result* out, Begin begin) {
  constexpr std::size_t few = 8;  // that need no memory of their own
  Task task(threads_of(options), options.progress, options.progress_context, a_report);
  task.begin(count);
  boost::container::small_vector<Result, few> results(count);
  for_each_in_parallel((count + block - 1) / block, task.threads(),
                       [&](std::size_t number) {
                         task.advance(0);  // other threads go on after one that was cancelled
                         Tally tally;
                         auto answer = begin(tally, task);
                         const std::size_t first = number * block;
                         const std::size_t end = std::min(count, first + block);
                         for (std::size_t begun = first; begun < end; begun += portion) {
                           const std::size_t next = std::min(end, begun + portion);
                           for (std::size_t k = begun; k < next; ++k) {
                             results[k] = answer(k);
                           }
                           task.advance(next - begun);
                         }
                       },
                       [&] { task.watch(); });
  task.finish();
  std::copy(results.begin(), results.end(), out);
}

// The same, in blocks of one portion.
template <class Begin, class Result>
void give_all(std::size_t count, std::uint64_t a_report, const gcv_options& options, Result* out,
              Begin begin) {
  constexpr std::uint64_t most = 128;
  const auto portion = static_cast<std::size_t>(std::min(a_report, most));
  give_all(count, a_report, portion, portion, options, out, begin);
}

// Throws Error: range, where a number of the contact is beyond the largest double.
inline void require_finite(const Contact& contact, const char* name, std::size_t number) {
  if (is_out_of_range(contact)) {
    throw Error(Status::range, "%s: number %zu: a distance or a point is beyond the largest double",
                name, number);
  }
}

// Throws Error: range, where a coordinate of the position is beyond the largest double.
inline void require_finite(const Point& position, const char* name, std::size_t number) {
  if (!std::isfinite(position.x) || !std::isfinite(position.y)) {
    throw Error(Status::range, "%s: number %zu: the position is beyond the largest double", name,
                number);
  }
}

// Throws Error: range, where the depth is beyond the largest double.
inline void require_finite_depth(double depth, const char* name, std::size_t number) {
  if (!std::isfinite(depth)) {
    throw Error(Status::range, "%s: number %zu: the depth is beyond the largest double", name,
                number);
  }
}

}  // namespace gcv::capi

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What all rooms stand on: errors, parts made late, buffers, and tasks as their callers see them.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "buffer.hpp"
#include "error.hpp"
#include "lazy.hpp"
#include "parallel.hpp"
#include "task.hpp"

namespace gcv {
namespace {

// ------------------------------------------------------------------------------ errors --

TEST(Error, HasAStatusAndAMessage) {
  const Error error(Status::parse, "%s: %d of %.2f", "name", 3, 0.5);
  EXPECT_EQ(error.status(), Status::parse);
  EXPECT_STREQ(error.what(), "name: 3 of 0.50");
  const Error copy = error;
  EXPECT_STREQ(copy.what(), "name: 3 of 0.50");
  EXPECT_NE(copy.what(), error.what());
}

TEST(Error, CutsLongMessages) {
  const std::string text(2 * Error::capacity, 'x');
  const Error error(Status::range, "%s", text.c_str());
  EXPECT_EQ(error.what(), text.substr(0, Error::capacity - 1));
  const Error full(Status::range, "%s", text.substr(0, Error::capacity - 1).c_str());
  EXPECT_EQ(full.what(), text.substr(0, Error::capacity - 1));
}

template <class Exception>
Error handled(const Exception& exception) {
  try {
    throw exception;
  } catch (...) {
    return current_error();
  }
}

TEST(Error, IsMadeOfAnyException) {
  const Error same = handled(Error(Status::cancelled, "ended"));
  EXPECT_EQ(same.status(), Status::cancelled);
  EXPECT_STREQ(same.what(), "ended");
  EXPECT_EQ(handled(std::bad_alloc()).status(), Status::no_memory);
  EXPECT_EQ(handled(std::bad_array_new_length()).status(), Status::no_memory);
  EXPECT_EQ(handled(std::length_error("length")).status(), Status::no_memory);
  const Error other = handled(std::runtime_error("100%s"));
  EXPECT_EQ(other.status(), Status::internal);
  EXPECT_NE(std::string(other.what()).find("100%s"), std::string::npos);
  EXPECT_EQ(handled(42).status(), Status::internal);
}

// ----------------------------------------------------------------------- parts made late --

TEST(Lazy, IsMadeOnce) {
  const Lazy<std::string> lazy;
  int made = 0;
  const auto make = [&] {
    ++made;
    return std::string("made");
  };
  const std::string& first = lazy.get(make);
  EXPECT_EQ(first, "made");
  EXPECT_EQ(&lazy.get(make), &first);
  EXPECT_EQ(made, 1);
}

TEST(Lazy, IsMadeLaterWhereMakingItFails) {
  const Lazy<int> lazy;
  for (int k = 0; k < 2; ++k) {
    EXPECT_THROW(lazy.get([]() -> int { throw std::bad_alloc(); }), std::bad_alloc);
  }
  EXPECT_EQ(lazy.get([] { return 5; }), 5);
  EXPECT_EQ(lazy.get([]() -> int { throw std::bad_alloc(); }), 5);
}

TEST(Lazy, CopiesStartWithoutIt) {
  const Lazy<int> lazy;
  EXPECT_EQ(lazy.get([] { return 1; }), 1);
  Lazy<int> copy(lazy);
  EXPECT_EQ(copy.get([] { return 2; }), 2);
  EXPECT_EQ(lazy.get([] { return 3; }), 1);
  copy = lazy;
  EXPECT_EQ(copy.get([] { return 4; }), 4);
  const Lazy<int>& same = copy;
  copy = same;
  EXPECT_EQ(copy.get([] { return 5; }), 4);
}

// It is made when all have asked, and have had the time to make it once more.
TEST(Lazy, IsMadeOnceByWhicheverThreadAsks) {
  constexpr int count = 3;
  for (int round = 0; round < 20; ++round) {
    const Lazy<std::vector<int>> lazy;
    std::atomic<int> asked{0};
    std::atomic<int> made{0};
    std::array<const std::vector<int>*, count> seen{};
    std::vector<std::thread> threads;
    const auto make = [&] {
      ++made;
      for (int k = 0; asked < count || k < 100; ++k) {
        std::this_thread::yield();
      }
      return std::vector<int>(100, 7);
    };
    for (const std::vector<int>*& value : seen) {
      threads.emplace_back([&] {
        ++asked;
        value = &lazy.get(make);
      });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    EXPECT_EQ(made, 1);
    for (const std::vector<int>* value : seen) {
      EXPECT_EQ(value, seen.front());
      EXPECT_EQ(*value, std::vector<int>(100, 7));
    }
  }
}

// ------------------------------------------------------------------------------ buffers --

TEST(Buffer, HoldsWhatIsWritten) {
  Buffer<int> numbers(3);
  numbers = {1, 2, 3};
  numbers.resize(5);
  numbers[3] = 4;
  numbers[4] = 5;
  EXPECT_EQ(numbers, (Buffer<int>{1, 2, 3, 4, 5}));
  EXPECT_EQ(Buffer<int>(4, 7), (Buffer<int>{7, 7, 7, 7}));
  numbers.assign(2, 9);
  EXPECT_EQ(numbers, (Buffer<int>{9, 9}));
}

TEST(Buffer, MakesWhatIsNotTrivial) {
  struct Part {
    std::string name = "none";
    int number = 5;
  };
  Buffer<Part> parts(3);
  parts.resize(100);
  for (const Part& part : parts) {
    EXPECT_EQ(part.name, "none");
    EXPECT_EQ(part.number, 5);
  }
}

// -------------------------------------------------------------------------------- tasks --

// What a caller was told, who ends the computation at the report of that number.
struct Caller {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> reports;
  std::size_t last = 1000;
  std::thread::id thread = std::this_thread::get_id();

  static std::int32_t report(void* context, std::uint64_t done, std::uint64_t estimate) {
    auto& caller = *static_cast<Caller*>(context);
    EXPECT_EQ(std::this_thread::get_id(), caller.thread);
    caller.reports.emplace_back(done, estimate);
    return caller.reports.size() == caller.last ? -1 : 0;
  }
};

using Reports = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

Status status_of(const auto& work) {
  try {
    work();
    return Status::ok;
  } catch (const Error& error) {
    return error.status();
  }
}

constexpr std::uint64_t portion = Task::portion;

TEST(Task, ReportsPortions) {
  Caller caller;
  Task task(3, Caller::report, &caller);
  EXPECT_EQ(task.threads(), 3U);
  task.begin(4 * portion);
  EXPECT_EQ(caller.reports, (Reports{{0, 4 * portion}}));
  task.advance(portion - 1);
  task.advance(0);
  EXPECT_EQ(caller.reports.size(), 1U);
  task.advance(1);
  EXPECT_EQ(caller.reports.back(), std::pair(portion, 4 * portion));
  task.advance(portion - 1);
  EXPECT_EQ(caller.reports.size(), 2U);
  // An estimate that was too low is raised above what is done.
  task.advance(5 * portion + 1);
  EXPECT_EQ(caller.reports.back(), std::pair(7 * portion, 7 * portion + 7 * portion / 16 + 1));
  task.advance(1);
  task.finish();
  EXPECT_EQ(caller.reports.back(), std::pair(7 * portion + 1, 7 * portion + 1));
  EXPECT_EQ(caller.reports.size(), 4U);
}

// Parts that are done say how many steps the others take. Few of them say nothing yet.
TEST(Task, EstimatesByParts) {
  Caller caller;
  Task task(1, Caller::report, &caller);
  task.begin(4 * portion, 64);
  task.advance(portion, 2);
  EXPECT_EQ(caller.reports.back(), std::pair(portion, 4 * portion));
  task.advance(portion, 14);
  EXPECT_EQ(caller.reports.back(), std::pair(2 * portion, 8 * portion));
  task.advance(2 * portion, 48);
  EXPECT_EQ(caller.reports.back(), std::pair(4 * portion, 4 * portion + 4 * portion / 16 + 1));
  task.finish();
  EXPECT_EQ(caller.reports.back(), std::pair(4 * portion, 4 * portion));
}

// Where steps take long the caller is asked in between.
TEST(Task, Polls) {
  Caller caller;
  caller.last = 4;
  Task task(1, Caller::report, &caller);
  task.begin(2 * portion);
  task.poll();
  task.advance(1);
  task.poll();
  EXPECT_EQ(caller.reports, (Reports{{0, 2 * portion}, {0, 2 * portion}, {1, 2 * portion}}));
  EXPECT_EQ(status_of([&] { task.poll(); }), Status::cancelled);
  EXPECT_EQ(status_of([&] { task.poll(); }), Status::cancelled);
  EXPECT_EQ(caller.reports.size(), 4U);
}

// Too high an estimate is corrected in the end.
TEST(Task, FinishesWithWhatWasDone) {
  Caller caller;
  Task task(1, Caller::report, &caller);
  task.begin(1000 * portion);
  task.advance(7);
  task.finish();
  EXPECT_EQ(caller.reports, (Reports{{0, 1000 * portion}, {7, 7}}));
}

TEST(Task, IsSilentWithoutACaller) {
  Task alone;
  EXPECT_EQ(alone.threads(), 1U);
  Task silent(2, nullptr, nullptr);
  for (Task* const task : {&alone, &silent}) {
    EXPECT_EQ(status_of([&] {
                task->begin(1);
                task->advance(10 * portion);
                task->watch();
                task->finish();
              }),
              Status::ok);
  }
}

TEST(Task, IsCancelledByAnyReport) {
  for (std::size_t last = 1; last <= 3; ++last) {
    Caller caller;
    caller.last = last;
    Task task(1, Caller::report, &caller);
    EXPECT_EQ(status_of([&] { task.begin(1); }), last == 1 ? Status::cancelled : Status::ok);
    EXPECT_EQ(status_of([&] { task.advance(portion); }),
              last <= 2 ? Status::cancelled : Status::ok);
    EXPECT_EQ(status_of([&] { task.finish(); }), Status::cancelled);
    // Whoever has said so is not asked again.
    EXPECT_EQ(status_of([&] { task.advance(portion); }), Status::cancelled);
    EXPECT_EQ(caller.reports.size(), last);
  }
}

// Others count, and end; the calling thread alone reports.
TEST(Task, IsAdvancedByOtherThreads) {
  Caller caller;
  caller.last = 2;
  Task task(2, Caller::report, &caller);
  task.begin(10 * portion);
  const auto on_another_thread = [&] {
    Status status = Status::internal;
    std::thread([&] { status = status_of([&] { task.advance(3 * portion); }); }).join();
    return status;
  };
  EXPECT_EQ(on_another_thread(), Status::ok);
  EXPECT_EQ(caller.reports.size(), 1U);
  task.watch();  // does not throw
  EXPECT_EQ(caller.reports.back(), std::pair(3 * portion, 10 * portion));
  EXPECT_EQ(on_another_thread(), Status::cancelled);
  task.watch();
  EXPECT_EQ(caller.reports.size(), 2U);
  EXPECT_EQ(status_of([&] { task.advance(0); }), Status::cancelled);
}

// Steps and parts of all threads count, the calling one's and those of others.
TEST(Task, AddsUpAllThreads) {
  Caller caller;
  Task task(2, Caller::report, &caller);
  task.begin(4 * portion, 64);
  task.advance(portion / 2, 2);
  std::thread([&] { task.advance(portion + portion / 2, 14); }).join();
  task.watch();
  EXPECT_EQ(caller.reports.back(), std::pair(2 * portion, 8 * portion));
  task.finish();
  EXPECT_EQ(caller.reports.back(), std::pair(2 * portion, 2 * portion));
}

// ----------------------------------------------------------------------------- parallel --

TEST(ForEachInParallel, CallsEachOnce) {
  EXPECT_GE(available_threads(), 1U);
  for (const unsigned threads : {0U, 1U, 2U, 5U}) {
    for (const std::size_t count : {0U, 1U, 2U, 300U}) {
      std::vector<std::atomic<int>> calls(count);
      for_each_in_parallel(count, threads, [&](std::size_t k) { ++calls[k]; });
      for (const std::atomic<int>& number : calls) {
        EXPECT_EQ(number, 1);
      }
    }
  }
}

TEST(ForEachInParallel, ThrowsTheExceptionOfTheSmallestNumber) {
  for (const unsigned threads : {1U, 2U, 4U}) {
    std::atomic<int> calls{0};
    try {
      for_each_in_parallel(100, threads, [&](std::size_t k) {
        ++calls;
        if (k % 10 == 7) {
          throw k;
        }
      });
      ADD_FAILURE() << "no exception";
    } catch (const std::size_t k) {
      EXPECT_EQ(k, 7U);
    }
    EXPECT_EQ(calls, threads == 1 ? 8 : 100);
  }
}

}  // namespace
}  // namespace gcv

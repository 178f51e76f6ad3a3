// SPDX-License-Identifier: LGPL-3.0-or-later
#include "batch.hpp"

#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <utility>

#include "parallel.hpp"

namespace gcv {

namespace {

class Batch {
 public:
  Batch(const std::vector<OperandPair>& pairs, const SumOptions& options, unsigned threads,
        Task& task, const TakeOuterFace& take)
      : pairs_(pairs),
        options_(options),
        threads_(threads),
        task_(task),
        take_(take),
        first_failed_(pairs.size()) {
    report_.statuses.resize(pairs.size());
  }

  BatchReport run() {
    task_.begin(estimate());
    simplify_all();
    for_each_in_parallel(
        pairs_.size(), threads_, [&](std::size_t k) { add(k); }, [&] { task_.watch(); });
    task_.finish();
    return std::move(report_);
  }

 private:
  using Source = std::shared_ptr<const Boundary>;

  // A polygon of the pairs, simplified; or why it is not, which is for its pairs to say.
  struct Part {
    Simplified simplified;
    std::exception_ptr failure;
  };

  [[nodiscard]] std::uint64_t estimate() const {
    std::uint64_t steps = 0;
    for (const auto& [a, b] : pairs_) {
      if (a != nullptr && b != nullptr) {
        steps += estimated_steps(*a, *b);
      }
    }
    return steps;
  }

  // Each polygon once, however many pairs it is in.
  void simplify_all() {
    for (const auto& [a, b] : pairs_) {
      parts_.try_emplace(a);
      parts_.try_emplace(b);
    }
    parts_.erase(nullptr);
    std::vector<std::pair<const Source, Part>*> all;
    all.reserve(parts_.size());
    for (auto& entry : parts_) {
      all.push_back(&entry);
    }
    for_each_in_parallel(all.size(), threads_, [&](std::size_t k) {
      task_.advance(0);
      Part& part = all[k]->second;
      try {
        part.simplified = simplified_for_sum(all[k]->first, options_);
      } catch (...) {
        part.failure = std::current_exception();
      }
    });
  }

  [[nodiscard]] Operand operand(const Source& polygon, const char* name) const {
    if (polygon == nullptr) {
      throw Error(Status::null_argument, "%s is NULL", name);
    }
    const Part& part = parts_.find(polygon)->second;
    if (part.failure) {
      std::rethrow_exception(part.failure);
    }
    return {part.simplified.ring, name, part.simplified.error_bound};
  }

  // Computes pair k. Throws Error: cancelled.
  void add(std::size_t k) {
    task_.advance(0);
    try {
      const Operand a = operand(pairs_[k].a, "a");
      const Operand b = operand(pairs_[k].b, "b");
      take_(k, minkowski_sum(a, b, {0, 0}, options_.rounding, task_));
    } catch (...) {
      const Error error = current_error();
      if (error.status() == Status::cancelled) {
        throw;
      }
      fail(k, error);
    }
  }

  void fail(std::size_t k, const Error& error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    report_.statuses[k] = error.status();
    if (k < first_failed_) {
      first_failed_ = k;
      report_.first_failure = Error(error.status(), "pair %zu: %s", k, error.what());
    }
  }

  const std::vector<OperandPair>& pairs_;
  SumOptions options_;
  unsigned threads_;
  Task& task_;
  const TakeOuterFace& take_;
  std::map<Source, Part> parts_;
  BatchReport report_;
  std::mutex mutex_;
  std::size_t first_failed_;
};

}  // namespace

BatchReport minkowski_sums(const std::vector<OperandPair>& pairs, const SumOptions& options,
                           unsigned threads, Task& task, const TakeOuterFace& take) {
  return Batch(pairs, options, threads, task, take).run();
}

}  // namespace gcv

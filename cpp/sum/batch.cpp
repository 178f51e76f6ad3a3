// SPDX-License-Identifier: LGPL-3.0-or-later
#include "batch.hpp"

#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <utility>

#include "finite_point.hpp"
#include "parallel.hpp"

namespace gcv {

namespace {

// What a batch computes: how shapes become operands, and operands sums.
struct OuterFaces {
  using Shape = Boundary;
  using Result = OuterFace;
  using Options = SumOptions;

  static std::uint64_t steps(const Boundary& a, const Boundary& b, const Options& /*options*/) {
    return estimated_steps(a, b);
  }
  static std::uint64_t parts(const Boundary& a, const Boundary& b) { return parts_of_sum(a, b); }
  static std::uint64_t parts(const Operand& a, const Operand& b) {
    return parts_of_sum(*a.ring, *b.ring);
  }
  static Operand simplified(const std::shared_ptr<const Boundary>& ring, const Options& options) {
    const Simplified near = simplified_for_sum(ring, options);
    return {near.ring, "", near.error_bound};
  }
  static OuterFace sum(const Operand& a, const Operand& b, const Point& shift,
                       const Options& options, Task& task) {
    return minkowski_sum(a, b, shift, options.rounding, task);
  }
};

struct Regions {
  using Shape = Polygon;
  using Result = Region;
  using Options = RegionOptions;

  static std::uint64_t steps(const Polygon& a, const Polygon& b, const Options& options) {
    return estimated_steps(a, b, options);
  }
  template <class Any>
  static std::uint64_t parts(const Any& /*a*/, const Any& /*b*/) {
    return 0;
  }
  static RegionOperand simplified(const std::shared_ptr<const Polygon>& polygon,
                                  const Options& options) {
    return simplified_for_sum(RegionOperand{polygon, ""}, options);
  }
  static Region sum(const RegionOperand& a, const RegionOperand& b, const Point& shift,
                    const Options& options, Task& task) {
    return sum_region(a, b, shift, options, task);
  }
};

template <class Kind>
class Batch {
 public:
  using Shape = typename Kind::Shape;
  using Result = typename Kind::Result;
  using Options = typename Kind::Options;

  Batch(const std::vector<SumPair<Shape>>& pairs, const PairNames& names, const Options& options,
        unsigned threads, Task& task, const TakeResult<Result>& take)
      : pairs_(pairs),
        names_(names),
        options_(options),
        threads_(threads),
        task_(task),
        take_(take),
        first_failed_(pairs.size()) {
    report_.statuses.resize(pairs.size());
  }

  BatchReport run() {
    const Work work = estimate();
    task_.begin(work.steps, work.parts);
    simplify_all();
    for_each_in_parallel(
        pairs_.size(), threads_, [&](std::size_t k) { add(k); }, [&] { task_.watch(); });
    task_.finish();
    return std::move(report_);
  }

 private:
  using Source = std::shared_ptr<const Shape>;
  using Operand = decltype(Kind::simplified(Source(), Options()));

  // A polygon of the pairs, simplified; or why it is not, which is for its pairs to say.
  struct Part {
    Operand operand;
    std::exception_ptr failure;
  };

  // See Task::begin.
  struct Work {
    std::uint64_t steps = 0;
    std::uint64_t parts = 0;
  };
  [[nodiscard]] Work estimate() const {
    Work work;
    for (const auto& [a, b, shift] : pairs_) {
      if (a != nullptr && b != nullptr) {
        work.steps += Kind::steps(*a, *b, options_);
        work.parts += Kind::parts(*a, *b);
      }
    }
    return work;
  }

  // Each polygon once, however many pairs it is in.
  void simplify_all() {
    for (const auto& [a, b, shift] : pairs_) {
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
        part.operand = Kind::simplified(all[k]->first, options_);
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
    Operand operand = part.operand;
    operand.name = name;
    return operand;
  }

  // Computes pair k. Throws Error: cancelled.
  void add(std::size_t k) {
    task_.advance(0);
    try {
      const Operand a = operand(pairs_[k].a, names_.a);
      const Operand b = operand(pairs_[k].b, names_.b);
      const Point shift = finite_point(pairs_[k].shift, names_.shift);
      task_.advance(0, Kind::parts(*pairs_[k].a, *pairs_[k].b) - Kind::parts(a, b));
      take_(k, Kind::sum(a, b, shift, options_, task_));
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

  const std::vector<SumPair<Shape>>& pairs_;
  PairNames names_;
  Options options_;
  unsigned threads_;
  Task& task_;
  const TakeResult<Result>& take_;
  std::map<Source, Part> parts_;
  BatchReport report_;
  std::mutex mutex_;
  std::size_t first_failed_;
};

}  // namespace

BatchReport minkowski_sums(const std::vector<SumPair<Boundary>>& pairs, const PairNames& names,
                           const SumOptions& options, unsigned threads, Task& task,
                           const TakeResult<OuterFace>& take) {
  return Batch<OuterFaces>(pairs, names, options, threads, task, take).run();
}

BatchReport minkowski_sum_regions(const std::vector<SumPair<Polygon>>& pairs,
                                  const PairNames& names, const RegionOptions& options,
                                  unsigned threads, Task& task, const TakeResult<Region>& take) {
  return Batch<Regions>(pairs, names, options, threads, task, take).run();
}

}  // namespace gcv

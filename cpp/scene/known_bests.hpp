// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The best positions that were asked for in a scene, for as long as none can become better: members
// that are added only take positions away. So the next search begins where the last one ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "exact_point.hpp"
#include "polygon.hpp"

namespace gcv {

// May be asked by many threads at once. What they keep changes no answer.
class KnownBests {
 public:
  KnownBests() = default;
  KnownBests(const KnownBests& other);
  KnownBests& operator=(const KnownBests&) = delete;
  ~KnownBests() = default;

  // What the best position depends on, beside the solids.
  struct Question {
    std::shared_ptr<const Polygon> moving;
    Point direction;
    std::uint32_t layers;
    bool with_fits;
  };
  // The furthest place that was free, or that none was.
  struct Best {
    std::optional<ExactPoint> place;
  };

  // Nothing if it was not asked, or long ago. A polygon is known by its address, while it lives.
  [[nodiscard]] std::optional<Best> find(const Question& question) const;
  void keep(const Question& question, const Best& best);
  void clear();

  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Entry {
    std::weak_ptr<const Polygon> moving;
    Point direction;
    std::uint32_t layers;
    bool with_fits;
    Best best;

    [[nodiscard]] bool answers(const Question& question) const {
      return direction == question.direction && layers == question.layers &&
             with_fits == question.with_fits && moving.lock() == question.moving;
    }
  };
  // So many questions are known: parts times turns, of a layout.
  static constexpr std::size_t most = 256;

  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
  std::size_t kept_ = 0;  // of all, up to now
};

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The best positions that were asked for in a scene, for as long as none can become better: members
// that are added only take positions away. So the next search begins where the last one ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "boundary.hpp"
#include "exact_point.hpp"

namespace gcv {

// May be asked by many threads at once. What they keep changes no answer.
class KnownBests {
 public:
  KnownBests() = default;
  KnownBests(const KnownBests& other);
  KnownBests& operator=(const KnownBests&) = delete;
  ~KnownBests() = default;

  // What the best position depends on, beside the solids. Layouts make many polygons with the same
  // vertices.
  struct Question {
    const Boundary& moving;
    Point direction;
    std::uint32_t layers;
    bool with_fits;
  };
  // The furthest place that was free, whether doubles show it or not; or that none was.
  struct Best {
    std::optional<ExactPoint> place;
  };

  // Nothing if it was not asked, or long ago.
  [[nodiscard]] std::optional<Best> find(const Question& question) const;
  // The oldest ones are dropped for it where that takes too many.
  void keep(const Question& question, const Best& best);
  void clear();

  [[nodiscard]] std::size_t bytes() const;

 private:
  // So many questions are kept: parts times turns, of a layout; and so many vertices.
  static constexpr std::size_t most = 256;
  static constexpr std::size_t most_vertices = std::size_t{1} << 18;

  struct Entry {
    PointVector vertices;  // of the polygon that moves
    RingLayout layout;
    Point direction;
    std::uint32_t layers;
    bool with_fits;
    Best best;

    [[nodiscard]] bool answers(const Question& question) const;
  };
  // The index of the entry that answers, or of none behind the last one.
  [[nodiscard]] std::size_t index_of(const Question& question) const;

  mutable std::mutex mutex_;
  std::vector<Entry> entries_;  // the oldest ones first
  std::size_t vertices_ = 0;    // of all
};

}  // namespace gcv

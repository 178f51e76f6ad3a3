// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Answers about two polygons against the exact ones, which are libgcv's.
#pragma once

#include <cstddef>
#include <vector>

#include "asker.hpp"
#include "scene.hpp"

namespace gcv::bench {

// The answers to one question at all placements. Where B moved in doubles is no simple polygon,
// there is none about it: NaN.
struct Truth {
  std::vector<double> exact;
  std::vector<double> of_rounded;  // the same about B moved in doubles; none of casts
};

Truth truth(const Scene& scene, const Placements& placements, Question question);

struct Verdict {
  std::size_t answers = 0;
  // Relations: what the system tells is another. Distances and times: more than 10^-12 off, as a
  // part of the exact one.
  std::size_t wrong = 0;
  std::size_t wrong_of_rounded = 0;
  // Distances that are not the nearest double to the exact one.
  std::size_t not_nearest = 0;
  std::size_t not_nearest_of_rounded = 0;
  // Distances as a part of the size, times as they are: more than 10^-9 off, and how far.
  std::size_t gross = 0;
  double worst = 0;
  double worst_of_rounded = 0;
};

// Of the first `count` answers.
Verdict judged(const Asker& asker, const Truth& truth, const std::vector<double>& answers,
               std::size_t count, double size);

}  // namespace gcv::bench

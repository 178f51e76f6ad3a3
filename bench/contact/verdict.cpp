// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verdict.hpp"

#include <gcv/gcv.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "handle.hpp"

namespace gcv::bench {

namespace {

constexpr double accepted = 1e-12;
constexpr double gross = 1e-9;
constexpr double apart = GCV_APART;
constexpr double overlapping = GCV_OVERLAPPING;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

double answer_of_rounded(const gcv_polygon* a, const Ring& ring, Question question) {
  gcv_polygon* made = nullptr;
  if (gcv_polygon_create(&ring.data()->x, ring.size(), 0, &made) != GCV_OK) {
    return none;
  }
  const Owned<gcv_polygon> b(made);
  const double here[2] = {0, 0};
  gcv_separation separation{};
  check(gcv_distance(a, b.get(), here, 1, nullptr, &separation));
  return question == Question::relation ? separation.relation : separation.distance;
}

// Is what the system tells true?
bool agree(Tells tells, double answer, double exact) {
  switch (tells) {
    case Tells::apart_or_not:
      return (answer == apart) == (exact == apart);
    case Tells::overlap_or_not:
      return (answer == overlapping) == (exact == overlapping);
    default:
      return answer == exact;
  }
}

bool is_off(double answer, double exact) {
  return !(std::abs(answer - exact) <= accepted * std::abs(exact));
}

}  // namespace

Truth truth(const Scene& scene, const Placements& placements, Question question) {
  Truth truth;
  const std::size_t count = placements.translations.size();
  truth.exact.resize(count);
  for (const Asker& asker : libgcv_askers()) {
    if (asker.question == question) {
      asker.prepare(scene, placements)(0, count, truth.exact.data());
      break;
    }
  }
  truth.of_rounded.assign(count, none);
  if (question != Question::cast) {
    const Owned<gcv_polygon> a = make_polygon(scene.a);
    for (std::size_t k = 0; k < count; ++k) {
      truth.of_rounded[k] =
          answer_of_rounded(a.get(), rounded_at(scene.b, placements.translations[k]), question);
    }
  }
  return truth;
}

Verdict judged(const Asker& asker, const Truth& truth, const std::vector<double>& answers,
               std::size_t count, double size) {
  Verdict verdict;
  verdict.answers = count;
  const double unit = asker.question == Question::cast ? 1 : size;
  for (std::size_t k = 0; k < count; ++k) {
    const double answer = answers[k];
    const double exact = truth.exact[k];
    const double of_rounded = truth.of_rounded[k];
    const bool has_rounded = !std::isnan(of_rounded);
    if (asker.question == Question::relation) {
      verdict.wrong += agree(asker.tells, answer, exact) ? 0 : 1;
      verdict.wrong_of_rounded += has_rounded && !agree(asker.tells, answer, of_rounded) ? 1 : 0;
      continue;
    }
    verdict.wrong += is_off(answer, exact) ? 1 : 0;
    verdict.not_nearest += answer == exact ? 0 : 1;
    const double error = std::abs(answer - exact) / unit;
    verdict.gross += error <= gross ? 0 : 1;
    verdict.worst = std::max(verdict.worst, error);
    if (has_rounded) {
      verdict.wrong_of_rounded += is_off(answer, of_rounded) ? 1 : 0;
      verdict.not_nearest_of_rounded += answer == of_rounded ? 0 : 1;
      verdict.worst_of_rounded =
          std::max(verdict.worst_of_rounded, std::abs(answer - of_rounded) / unit);
    }
  }
  return verdict;
}

}  // namespace gcv::bench

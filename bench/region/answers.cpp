// SPDX-License-Identifier: LGPL-3.0-or-later
#include "answers.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "answer_sets.hpp"
#include "apart.hpp"
#include "sets.hpp"
#include "systems/whole.hpp"
#include "turns.hpp"
#include "verdict.hpp"

namespace gcv::bench {

namespace {

// Of libgcv's region, and of its free points that CGAL's do_intersect does not find free.
struct Truth {
  std::size_t holes = 0;
  std::size_t fits = 0;
  std::size_t denied = 0;
};

Truth truth_of(const Ring& a, const Ring& b) {
  const FreePoints points = free_points(libgcv_exact_region(a, b));
  Truth truth{points.in_holes.size(), points.of_fits.size(), 0};
  for (const auto* list : {&points.in_holes, &points.of_fits}) {
    for (const invariants::Exact& x : *list) {
      truth.denied += overlap_at(a, b, x) ? 1 : 0;
    }
  }
  return truth;
}

struct Judged {
  Verdict verdict;
  std::size_t holes_false = 0;
  std::size_t denied = 0;  // of the points in false holes, by do_intersect
  double ratio = 0;        // time of the system : time of libgcv's region
};

Judged judge(const WholeSystem& system, const Ring& a, const Ring& b) {
  Judged judged;
  const ExactWhole answer = system.exact_sum(a, b);
  const ExactRegion truth = libgcv_exact_region(a, b);
  judged.verdict = verdict_of(answer, truth);
  for (const invariants::Exact& x : points_in_false_holes(answer, truth)) {
    ++judged.holes_false;
    judged.denied += overlap_at(a, b, x) ? 0 : 1;
  }
  const Turns turns({[&] { libgcv_region(a, b); }, [&] { static_cast<void>(system.sum(a, b)); }},
                    answer_turns);
  judged.ratio = turns.ratio(1, 0);
  return judged;
}

// One system on one set, or on all.
struct Tally {
  std::size_t pairs = 0;
  std::size_t without_answer = 0;  // errors, crashes, cut off
  std::size_t wrong_pairs = 0;
  Truth truth;
  Verdict verdict;
  std::size_t holes_false = 0;
  std::size_t denied = 0;
  std::vector<double> ratios;

  void add(const Truth& of_pair, const Judged& judged) {
    const Verdict& v = judged.verdict;
    wrong_pairs += v.holes_lost + judged.holes_false + v.fits_lost > 0 ? 1 : 0;
    truth.holes += of_pair.holes;
    truth.fits += of_pair.fits;
    verdict.holes_lost += v.holes_lost;
    holes_false += judged.holes_false;
    denied += judged.denied;
    verdict.fits_lost += v.fits_lost;
    ratios.push_back(judged.ratio);
  }
};

void print_table(const std::vector<WholeSystem>& systems, const std::vector<Tally>& tallies) {
  std::puts(
      "| system | pairs | no answer | wrong pairs | holes lost | holes false | fits lost | times "
      "libgcv's region: median | least |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
  for (std::size_t k = 0; k < systems.size(); ++k) {
    const Tally& t = tallies[k];
    std::printf("| %s | %zu | %zu | %zu | %zu of %zu | %zu | %zu of %zu |", systems[k].name.c_str(),
                t.pairs, t.without_answer, t.wrong_pairs, t.verdict.holes_lost, t.truth.holes,
                t.holes_false, t.verdict.fits_lost, t.truth.fits);
    if (t.ratios.empty()) {
      std::puts(" - | - |");
    } else {
      std::printf(" %.3g | %.3g |\n", median(t.ratios),
                  *std::min_element(t.ratios.begin(), t.ratios.end()));
    }
  }
  std::puts("");
  std::fflush(stdout);
}

class Answers {
 public:
  void run(const Set& set) {
    std::vector<Tally> tallies(systems_.size());
    std::size_t holes = 0;
    std::size_t fits = 0;
    for (const Pair& pair : set.pairs) {
      const Rings rings = pair.make();
      const Ring a = tidy(rings.first);
      const Ring b = tidy(rings.second);
      if (static_cast<double>(a.size()) * static_cast<double>(b.size()) > most_pairs_of_vertices) {
        continue;
      }
      const Outcome outcome = run_apart(answer_limit, [&] { return to_bytes(truth_of(a, b)); });
      if (!outcome.failure.empty()) {
        std::printf("libgcv, %s: %s\n", pair.name.c_str(), outcome.failure.c_str());
        continue;
      }
      const auto truth = from_bytes<Truth>(outcome.bytes);
      holes += truth.holes;
      fits += truth.fits;
      denied_ += truth.denied;
      for (std::size_t k = 0; k < systems_.size(); ++k) {
        run(k, pair.name, a, b, truth, tallies[k]);
      }
    }
    free_points_ += holes + fits;
    std::printf("%s: %zu holes, %zu fits\n\n", set.name.c_str(), holes, fits);
    print_table(systems_, tallies);
  }

  void print_sum() const {
    std::puts("all:\n");
    print_table(systems_, all_);
    std::size_t holes_false = 0;
    std::size_t denied = 0;
    for (const Tally& tally : all_) {
      holes_false += tally.holes_false;
      denied += tally.denied;
    }
    std::printf(
        "CGAL's do_intersect denies %zu of the %zu free points in libgcv's holes and on its fits, "
        "and %zu of the %zu covered ones in false holes.\n\n",
        denied_, free_points_, denied, holes_false);
  }

 private:
  void run(std::size_t system, const std::string& name, const Ring& a, const Ring& b,
           const Truth& truth, Tally& tally) {
    const WholeSystem& chosen = systems_[system];
    const Outcome outcome = run_apart(answer_limit, [&] { return to_bytes(judge(chosen, a, b)); });
    for (Tally* const each : {&tally, &all_[system]}) {
      ++each->pairs;
      if (outcome.failure.empty()) {
        each->add(truth, from_bytes<Judged>(outcome.bytes));
      } else {
        ++each->without_answer;
      }
    }
    if (!outcome.failure.empty()) {
      std::fprintf(stderr, "%s, %s: %s\n", chosen.name.c_str(), name.c_str(),
                   outcome.failure.c_str());
    }
  }

  std::vector<WholeSystem> systems_ = whole_systems();
  std::vector<Tally> all_ = std::vector<Tally>(systems_.size());
  std::size_t free_points_ = 0;
  std::size_t denied_ = 0;
};

}  // namespace

void print_answers(bool quick) {
  Answers answers;
  for (const Set& set : answer_sets(quick)) {
    answers.run(set);
  }
  answers.print_sum();
}

}  // namespace gcv::bench

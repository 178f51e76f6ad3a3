// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_contacts [--quick] [--families NAME,...]
//
// Puts questions about two polygons to libgcv and to other systems in turns, and judges the
// answers. One thread. Prints a line of JSON for each pair, kind of placements and question.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "contact/asker.hpp"
#include "contact/scene.hpp"
#include "contact/verdict.hpp"
#include "region/turns.hpp"
#include "text.hpp"

namespace gcv::bench {
namespace {

constexpr std::size_t warming_questions = 4;
constexpr double most_seconds_in_turns = 0.005;  // of all questions of one system
constexpr double most_seconds_judged = 0.05;
constexpr std::size_t fewest_in_turns = 16;
constexpr double most_seconds_alone = 1;
constexpr double seconds_of_turns = 0.4;
constexpr int passes = 7;  // over single questions

double seconds_of(const Ask& ask, std::size_t first, std::size_t count, double* out) {
  const auto begin = std::chrono::steady_clock::now();
  ask(first, count, out);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return elapsed.count();
}

// One system with its answers at the placements of one kind.
struct Asked {
  Asker asker;
  Ask ask;
  std::size_t count = 0;   // of the questions that are timed
  std::size_t judged = 0;  // of those whose answers are judged
  std::vector<double> answers;
  bool is_in_turns = false;
  double nanoseconds = 0;  // of one question
  double ratio = 0;        // to libgcv
};

Asked warmed_up(const Asker& asker, const Scene& scene, const Placements& placements) {
  const std::size_t all = placements.translations.size();
  Asked asked{.asker = asker, .ask = asker.prepare(scene, placements), .answers = {}};
  asked.answers.resize(all);
  double* const out = asked.answers.data();
  asked.ask(0, 1, out);
  const double seconds = seconds_of(asked.ask, 0, warming_questions, out) / warming_questions;
  const auto within = [&](double limit) {
    return std::clamp<std::size_t>(static_cast<std::size_t>(limit / seconds), 1, all);
  };
  asked.count = within(most_seconds_in_turns);
  asked.is_in_turns = asked.count >= fewest_in_turns;
  if (!asked.is_in_turns) {
    asked.count = std::min(within(most_seconds_alone), fewest_in_turns);
  }
  asked.judged = std::max(asked.count, within(most_seconds_judged));
  return asked;
}

void measure(std::vector<Asked>& all) {
  std::vector<std::function<void()>> ways;
  std::vector<Asked*> in_turns;
  for (Asked& asked : all) {
    if (asked.is_in_turns) {
      in_turns.push_back(&asked);
      ways.emplace_back([&asked] { asked.ask(0, asked.count, asked.answers.data()); });
    }
  }
  const Turns turns(ways, seconds_of_turns);
  for (std::size_t k = 0; k < in_turns.size(); ++k) {
    Asked& asked = *in_turns[k];
    const auto count = static_cast<double>(asked.count);
    asked.nanoseconds = 1e6 * turns.milliseconds(k) / count;
    asked.ratio = turns.ratio(k, 0) * static_cast<double>(all[0].count) / count;
  }
  for (Asked& asked : all) {
    if (!asked.is_in_turns) {
      const double seconds = seconds_of(asked.ask, 0, asked.count, asked.answers.data());
      asked.nanoseconds = 1e9 * seconds / static_cast<double>(asked.count);
      asked.ratio = asked.nanoseconds / all[0].nanoseconds;
    }
  }
}

// Each question by itself, the median of some passes; sorted.
std::vector<double> single_nanoseconds(Asked& asked) {
  std::vector<std::vector<double>> times(asked.count);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t k = 0; k < asked.count; ++k) {
      times[k].push_back(1e9 * seconds_of(asked.ask, k, 1, asked.answers.data()));
    }
  }
  std::vector<double> medians;
  std::transform(times.begin(), times.end(), std::back_inserter(medians), median);
  std::sort(medians.begin(), medians.end());
  return medians;
}

const char* name_of(Question question) {
  switch (question) {
    case Question::relation:
      return "relation";
    case Question::distance:
      return "distance";
    default:
      return "cast";
  }
}

// JSON has no infinity.
double finite(double x) { return std::isfinite(x) ? x : 1e300; }

std::string to_json(Asked& asked, const Truth& truth, double size) {
  if (asked.judged > asked.count) {
    asked.ask(asked.count, asked.judged - asked.count, asked.answers.data());
  }
  const Verdict v = judged(asked.asker, truth, asked.answers, asked.judged, size);
  std::ostringstream json;
  json.precision(6);
  json << "{\"ns\": " << asked.nanoseconds << ", \"ratio\": " << asked.ratio
       << ", \"answers\": " << v.answers << ", \"wrong\": " << v.wrong
       << ", \"not_nearest\": " << v.not_nearest << ", \"gross\": " << v.gross
       << ", \"worst\": " << finite(v.worst);
  if (asked.asker.is_given_rounded) {
    json << ", \"wrong_of_rounded\": " << v.wrong_of_rounded
         << ", \"not_nearest_of_rounded\": " << v.not_nearest_of_rounded
         << ", \"worst_of_rounded\": " << finite(v.worst_of_rounded);
  }
  if (asked.is_in_turns) {
    const std::vector<double> single = single_nanoseconds(asked);
    json << ", \"median_ns\": " << single[single.size() / 2]
         << ", \"slowest_ns\": " << single.back();
  }
  json << '}';
  return json.str();
}

std::vector<Asker> all_askers() {
  std::vector<Asker> all = libgcv_askers();
  for (const auto& some : {geos_askers(), boost_askers(), cgal_askers(),
#ifdef GCV_BENCH_PARRY
                           parry_askers()
#endif
       }) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

void print_row(const Situation& s, const Placements& placements, Question question) {
  const double vertex_pairs =
      static_cast<double>(s.scene.a.size()) * static_cast<double>(s.scene.b.size());
  std::vector<Asked> all;
  std::string failures;
  for (const Asker& asker : all_askers()) {
    if (asker.question != question || vertex_pairs > asker.most_vertex_pairs) {
      continue;
    }
    try {
      all.push_back(warmed_up(asker, s.scene, placements));
    } catch (const std::exception& exception) {
      failures += ", " + quoted(asker.name) + ": {\"failure\": " + quoted(exception.what()) + '}';
    }
  }
  measure(all);
  const Truth exact = truth(s.scene, placements, question);
  std::string results;
  for (Asked& asked : all) {
    results += (results.empty() ? "" : ", ") + quoted(asked.asker.name) + ": " +
               to_json(asked, exact, s.size);
  }
  std::size_t apart = 0;
  if (question == Question::relation) {
    apart = static_cast<std::size_t>(std::count(exact.exact.begin(), exact.exact.end(), 1.0));
  }
  const auto touching = std::count(exact.exact.begin(), exact.exact.end(), 0.0);
  std::printf(
      "{\"family\": %s, \"pair\": %s, \"a\": %zu, \"b\": %zu, \"kind\": %s, "
      "\"question\": \"%s\", \"apart\": %zu, \"zero\": %zu, \"results\": {%s%s}}\n",
      quoted(s.scene.family).c_str(), quoted(s.scene.pair).c_str(), s.scene.a.size(),
      s.scene.b.size(), quoted(placements.kind).c_str(), name_of(question), apart,
      static_cast<std::size_t>(touching), results.c_str(), failures.c_str());
  std::fflush(stdout);
}

void print_rows(const Situation& s) {
  for (const Placements& placements : s.placements) {
    if (placements.motions.empty()) {
      print_row(s, placements, Question::relation);
      print_row(s, placements, Question::distance);
    } else {
      print_row(s, placements, Question::distance);
      print_row(s, placements, Question::cast);
    }
  }
}

void run(const std::vector<std::string>& arguments) {
  bool quick = false;
  std::vector<std::string> chosen;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (arguments[k] == "--quick") {
      quick = true;
    } else if (arguments[k] == "--families") {
      chosen = split(arguments.at(++k), ';');
    } else {
      throw std::invalid_argument("unknown argument: " + arguments[k]);
    }
  }
  for (const SceneFamily& family : scene_families(quick)) {
    if (chosen.empty() || contains(chosen, family.name)) {
      for (const auto& scene : family.scenes) {
        print_rows(situation(scene(), family.count));
      }
    }
  }
}

}  // namespace
}  // namespace gcv::bench

int main(int argc, char** argv) {
  try {
    gcv::bench::run({argv + 1, argv + argc});
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "gcv_contacts: %s\n", exception.what());
    return 1;
  }
  return 0;
}

// SPDX-License-Identifier: LGPL-3.0-or-later
#include "ways_out.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "answer_sets.hpp"
#include "apart.hpp"
#include "generators.hpp"
#include "nearest.hpp"
#include "overlaps.hpp"
#include "systems/whole.hpp"
#include "turns.hpp"

namespace gcv::bench {

namespace {

constexpr std::size_t places_a_pair = 20;

// Of the ways out that a system gives.
struct Judged {
  std::size_t places = 0;
  std::size_t too_long = 0;     // by more than 10^-9 of the depth: a nearer way is lost
  std::size_t too_short = 0;    // likewise: it leads to a place that is not free
  std::size_t not_nearest = 0;  // double to the depth
  std::size_t overlaps = 0;     // where the way ends
  double worst = 0;             // error, in depths
  double ratio = 0;             // time of the sum and of one search : time of gcv_penetration

  void operator+=(const Judged& other) {
    places += other.places;
    too_long += other.too_long;
    too_short += other.too_short;
    not_nearest += other.not_nearest;
    overlaps += other.overlaps;
    worst = std::max(worst, other.worst);
  }
};

struct Question {
  Ring a;
  Ring b;
  Owned<gcv_polygon> p;
  Owned<gcv_polygon> q;
  PointVector places;
  std::vector<gcv_escape> truth;

  Question(const Ring& of_a, const Ring& of_b)
      : a(of_a),
        b(of_b),
        p(make_polygon(a)),
        q(make_polygon(b)),
        places(overlaps(p.get(), q.get(), places_a_pair)),
        truth(places.size()) {
    check(
        gcv_penetration(p.get(), q.get(), &places.front().x, places.size(), nullptr, truth.data()));
  }

  void add(Judged& judged, std::size_t k, double depth, const Point& end) const {
    const double exact = truth[k].depth;
    const double error = (depth - exact) / exact;
    std::int8_t relation = 0;
    check(gcv_relation(p.get(), q.get(), &end.x, 1, nullptr, &relation));
    ++judged.places;
    judged.too_long += error > 1e-9 ? 1 : 0;
    judged.too_short += error < -1e-9 ? 1 : 0;
    judged.not_nearest += depth != exact ? 1 : 0;
    judged.overlaps += relation == GCV_OVERLAPPING ? 1 : 0;
    judged.worst = std::max(judged.worst, std::abs(error));
  }
};

Judged judge_ourselves(const Question& question) {
  Judged judged;
  for (std::size_t k = 0; k < question.places.size(); ++k) {
    const gcv_escape& way = question.truth[k];
    question.add(judged, k, way.depth, {way.position[0], way.position[1]});
  }
  judged.ratio = 1;
  return judged;
}

NearestPoint nearest_free(const WholeSystem& system, const Question& question, const Point& from) {
  const WholeInDoubles sum = system.sum(question.a, test::negated(question.b));
  NearestPoint nearest = nearest_point(sum.outer, from);
  for (const Ring& hole : sum.holes) {
    nearest.look_at(hole, from);
  }
  return nearest;
}

Judged judge(const WholeSystem& system, const Question& question) {
  Judged judged;
  const WholeInDoubles sum = system.sum(question.a, test::negated(question.b));
  std::vector<Ring> rings = sum.outer;
  rings.insert(rings.end(), sum.holes.begin(), sum.holes.end());
  for (std::size_t k = 0; k < question.places.size(); ++k) {
    const NearestPoint nearest = nearest_point(rings, question.places[k]);
    question.add(judged, k, nearest.distance, nearest.point);
  }
  std::size_t next = 0;
  double sink = 0;
  const auto place = [&]() -> const Point& {
    next = (next + 1) % question.places.size();
    return question.places[next];
  };
  gcv_escape escape{};
  const Turns turns({[&] {
                       const auto p = make_polygon(question.a);
                       const auto q = make_polygon(question.b);
                       check(gcv_penetration(p.get(), q.get(), &place().x, 1, nullptr, &escape));
                     },
                     [&] { sink += nearest_free(system, question, place()).distance; }},
                    answer_turns);
  judged.ratio = sink >= 0 ? turns.ratio(1, 0) : 0;
  return judged;
}

struct Row {
  std::string name;
  std::size_t pairs = 0;
  std::size_t without_answer = 0;
  Judged sum = {};
  std::vector<double> ratios = {};
};

void print(const std::vector<Row>& rows) {
  std::puts(
      "| system | pairs | no answer | ways | too long | too short | not the nearest double | "
      "worst, "
      "in depths | overlapping where it ends | time: median | least |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
  for (const Row& row : rows) {
    const Judged& s = row.sum;
    const auto share = [&](std::size_t count) {
      return 100.0 * static_cast<double>(count) /
             static_cast<double>(std::max<std::size_t>(s.places, 1));
    };
    std::printf("| %s | %zu | %zu | %zu | %.3g %% | %.3g %% | %.3g %% | %.2g | %.3g %% |",
                row.name.c_str(), row.pairs, row.without_answer, s.places, share(s.too_long),
                share(s.too_short), share(s.not_nearest), s.worst, share(s.overlaps));
    if (row.ratios.empty()) {
      std::puts(" - | - |");
    } else {
      std::printf(" %.3g | %.3g |\n", median(row.ratios),
                  *std::min_element(row.ratios.begin(), row.ratios.end()));
    }
  }
  std::puts("");
  std::fflush(stdout);
}

void add_to(Row& row, const std::string& pair, const std::function<Judged()>& judged) {
  const Outcome outcome = run_apart(answer_limit, [&] { return to_bytes(judged()); });
  ++row.pairs;
  if (outcome.failure.empty()) {
    const auto found = from_bytes<Judged>(outcome.bytes);
    row.sum += found;
    row.ratios.push_back(found.ratio);
  } else {
    ++row.without_answer;
    std::fprintf(stderr, "%s, %s: %s\n", row.name.c_str(), pair.c_str(), outcome.failure.c_str());
  }
}

}  // namespace

void print_ways_out(bool quick) {
  const std::vector<WholeSystem> systems = whole_systems();
  for (const Set& set : answer_sets(quick)) {
    std::vector<Row> rows{{.name = "libgcv"}};
    for (const WholeSystem& system : systems) {
      rows.push_back({.name = system.name});
    }
    for (const Pair& pair : set.pairs) {
      const Rings rings = pair.make();
      const Ring a = tidy(rings.first);
      const Ring b = tidy(test::negated(rings.second));
      if (static_cast<double>(a.size()) * static_cast<double>(b.size()) > most_pairs_of_vertices) {
        continue;
      }
      add_to(rows[0], pair.name, [&] { return judge_ourselves(Question(a, b)); });
      for (std::size_t k = 0; k < systems.size(); ++k) {
        add_to(rows[k + 1], pair.name, [&] { return judge(systems[k], Question(a, b)); });
      }
    }
    std::printf("%s:\n\n", set.name.c_str());
    print(rows);
  }
}

}  // namespace gcv::bench

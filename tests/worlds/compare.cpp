// SPDX-License-Identifier: LGPL-3.0-or-later
#include "compare.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>

namespace worlds {
namespace {

std::vector<Convex> reflected_pieces(const std::vector<Convex>& pieces) {
  std::vector<Convex> result;
  for (const Convex& piece : pieces) {
    result.push_back(reflected({piece})[0]);
  }
  return result;
}

std::string number(double x) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.17g", x);
  return buffer.data();
}

std::string line(const std::string& text) { return "  " + text + "\n"; }

// A question about some operands, which are printed where the answers differ.
class Question {
 public:
  Question(std::string operands, Report& report)
      : operands_(std::move(operands)), report_(report) {}

  void compare(const std::string& question, const std::string& library,
               const std::string& definition) {
    report_.add_answers(1);
    if (library != definition) {
      report_.differ(question, operands_, library, definition);
    }
  }

  // Asks, and reports what fails.
  template <class Ask>
  void attempt(Ask ask) {
    try {
      ask();
    } catch (const std::exception& e) {
      report_.differ("failure", operands_, line(e.what()), line("an answer"));
    }
  }

  // Both answers are made into text where they differ.
  template <class Library, class Definition>
  void expect(bool equal, const std::string& question, Point halves, Library library,
              Definition definition) {
    report_.add_answers(1);
    if (!equal) {
      report_.differ(question + " at " + number(static_cast<double>(halves.x) / 2) + " " +
                         number(static_cast<double>(halves.y) / 2),
                     operands_, line(library()), line(definition()));
    }
  }

 private:
  std::string operands_;
  Report& report_;
};

std::vector<double> doubles(const std::vector<Point>& halves) {
  std::vector<double> xy;
  for (const Point& p : halves) {
    xy.insert(xy.end(), {static_cast<double>(p.x) / 2, static_cast<double>(p.y) / 2});
  }
  return xy;
}

int relation_at(const OpenSum& sum, Point place) {
  return sum.holds(place) ? GCV_OVERLAPPING : sum.reaches(place) ? GCV_TOUCHING : GCV_APART;
}

std::string relation_text(int relation) {
  return relation == GCV_APART ? "apart" : relation == GCV_TOUCHING ? "touching" : "overlapping";
}

// A position that doubles can show must be the exact one.
bool is_position(const gcv_escape& escape, const Way& way, Point halves) {
  const Int d = 2 * way.denominator;
  if ((d & (d - 1)) != 0) {
    return true;
  }
  return escape.position[0] == nearest_double({halves.x * way.denominator + 2 * way.x, d}) &&
         escape.position[1] == nearest_double({halves.y * way.denominator + 2 * way.y, d}) &&
         escape.relation == GCV_TOUCHING;
}

void compare_way(const gcv_escape& escape, const std::optional<Way>& way, Point halves,
                 Question& question) {
  const bool equal =
      way ? is_nearest_root(escape.depth, way->square()) &&
                escape.translation[0] == nearest_double(reduced(way->x, way->denominator)) &&
                escape.translation[1] == nearest_double(reduced(way->y, way->denominator)) &&
                is_position(escape, *way, halves)
          : escape.depth == std::numeric_limits<double>::infinity();
  question.expect(
      equal, "penetration", halves,
      [&] {
        return number(escape.depth) + " by " + number(escape.translation[0]) + " " +
               number(escape.translation[1]) + " to " + number(escape.position[0]) + " " +
               number(escape.position[1]) + ", " + relation_text(escape.relation);
      },
      [&] {
        return way ? "the root of " + text(way->square()) + " by " +
                         text(reduced(way->x, way->denominator)) + " " +
                         text(reduced(way->y, way->denominator))
                   : "infinite";
      });
}

// All places of halves of units in a box.
void compare_places(const Subject& subject, const OpenSum& sum, const Parts& free, Point low,
                    Point high, Question& question) {
  std::vector<Point> all;
  std::vector<Point> apart;
  std::vector<Point> within;
  for (Int x = low.x; x <= high.x; ++x) {
    for (Int y = low.y; y <= high.y; ++y) {
      all.push_back({x, y});
    }
  }
  const std::vector<std::int8_t> relations = subject.relation(doubles(all));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int expected = relation_at(sum, kUnit / 2 * all[k]);
    question.expect(
        relations[k] == expected, "relation", all[k], [&] { return relation_text(relations[k]); },
        [&] { return relation_text(expected); });
    (expected == GCV_OVERLAPPING ? within : apart).push_back(all[k]);
  }
  const std::vector<gcv_separation> distances = subject.distance(doubles(apart));
  for (std::size_t k = 0; k < apart.size(); ++k) {
    const Fraction square = sum.squared_distance(apart[k]);
    question.expect(
        is_nearest_root(distances[k].distance, square), "distance", apart[k],
        [&] { return number(distances[k].distance); },
        [&] { return "the root of " + text(square); });
  }
  const std::vector<gcv_escape> ways = subject.penetration(doubles(within));
  for (std::size_t k = 0; k < within.size(); ++k) {
    compare_way(ways[k], shortest_way(free, within[k]), within[k], question);
  }
}

void compare_inner_fit(const Operand& a, const Operand& b, Question& question) {
  const std::array<double, 2> origin{0, 0};
  gcv_region* region = nullptr;
  check(gcv_inner_fit_region(a.handle.get(), b.handle.get(), origin.data(), nullptr, &region));
  const Owner<gcv_region> owner(region);
  std::string expected;
  if (a.size.x >= b.size.x && a.size.y >= b.size.y) {
    OpenSum sum;
    sum.add(a.outside, b.reflected_inside);
    expected = text(parts(sum, Shown::free));
  }
  question.compare("inner fit of B in A", text(*region), expected);
}

void compare_pair(const Operand& a, const Operand& b, Question& question) {
  OpenSum sum;
  sum.add(a.inside, b.reflected_inside);
  const Parts expected = parts(sum, Shown::sum);

  gcv_outer_face* face = nullptr;
  check(gcv_minkowski_sum(a.handle.get(), b.reflected_handle.get(), nullptr, &face));
  const Owner<gcv_outer_face> face_owner(face);
  question.compare("outer face of A - B", text(*face), outer_face_text(expected));

  const std::array<double, 2> origin{0, 0};
  gcv_region* region = nullptr;
  check(gcv_no_fit_region(a.handle.get(), b.handle.get(), origin.data(), nullptr, &region));
  const Owner<gcv_region> region_owner(region);
  question.compare("region of A - B", text(*region), text(expected));

  compare_inner_fit(a, b, question);
  compare_places(PairSubject(*a.handle, *b.handle), sum, expected, -2 * b.size - Point{1, 1},
                 2 * a.size + Point{1, 1}, question);
}

void compare_free(const gcv_scene& scene, Point size, const Operand& moving, const OpenSum& sum,
                  Question& question) {
  const Parts expected = parts(sum, Shown::free);

  gcv_region* region = nullptr;
  check(gcv_scene_free_region(&scene, moving.handle.get(), nullptr, nullptr, nullptr, &region));
  const Owner<gcv_region> owner(region);
  question.compare("free region", text(*region), text(expected));
  compare_places(SceneSubject(scene, *moving.handle), sum, expected, {-1, -1},
                 2 * size + Point{1, 1}, question);
}

}  // namespace

Operand::Operand(const Polygon& given) : Operand(given, inner_pieces(given), outer_pieces(given)) {}

Operand::Operand(const Figure& figure)
    : Operand(figure.polygon(), figure.pieces(), figure.rest()) {}

Operand::Operand(const Polygon& given, const std::vector<Convex>& pieces, std::vector<Convex> rest)
    : polygon(given),
      inside(pieces),
      outside(std::move(rest)),
      reflected_inside(reflected_pieces(inside)),
      handle(make_polygon(given)),
      reflected_handle(make_polygon(reflected(given))) {
  for (const Convex& piece : surroundings(given)) {
    outside.push_back(piece);
  }
  const auto [low, high] = bounds(given[0]);
  size = high - low;
}

void Report::differ(const std::string& question, const std::string& operands,
                    const std::string& library, const std::string& definition) {
  if (++differences_ <= 10) {
    std::printf("Different: %s\n%slibrary:\n%sby definition:\n%s\n", question.c_str(),
                operands.c_str(), library.c_str(), definition.c_str());
  }
}

void compare_pair(const Operand& a, const Operand& b, Report& report) {
  report.add_case();
  Question question("  A: " + text(a.polygon) + "\n  B: " + text(b.polygon) + "\n", report);
  question.attempt([&] { compare_pair(a, b, question); });
}

void compare_scene(const Operand& container, const std::array<Operand, 3>& members,
                   const std::array<Point, 3>& positions, const Operand& moving, Report& report) {
  report.add_case();
  gcv_scene* created = nullptr;
  check(gcv_scene_create(&created));
  const Owner<gcv_scene> scene(created);
  check(gcv_scene_set_container(scene.get(), container.handle.get()));
  std::string operands = "  container: " + text(container.polygon) + "\n";
  OpenSum sum;
  sum.add(container.outside, moving.reflected_inside);
  for (std::size_t k = 0; k < members.size(); ++k) {
    const gcv_polygon* handle = members[k].handle.get();
    const Point at = positions[k];
    std::uint64_t id = 0;
    const std::array<double, 2> xy{static_cast<double>(at.x), static_cast<double>(at.y)};
    check(gcv_scene_add(scene.get(), &handle, xy.data(), 1, &id));
    const Polygon placed = moved(members[k].polygon, at);
    operands += "  member: " + text(placed) + "\n";
    sum.add(inner_pieces(placed), moving.reflected_inside);
  }
  Question question(operands + "  moving: " + text(moving.polygon) + "\n", report);
  question.attempt([&] { compare_free(*scene, container.size, moving, sum, question); });
}

}  // namespace worlds

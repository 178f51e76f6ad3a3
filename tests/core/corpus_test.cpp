// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The core, without the C interface, on the sums and the questions of tests/corpus and on what it
// refuses; README.md there describes the format.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>

#include "cast.hpp"
#include "distance.hpp"
#include "error.hpp"
#include "minkowski_sum.hpp"
#include "near_contacts.hpp"
#include "penetration.hpp"
#include "polygon.hpp"
#include "relation.hpp"
#include "ring_predicates.hpp"
#include "wkt.hpp"

namespace gcv {
namespace {

const std::map<std::string, Status> statuses{
    {"GCV_ERR_NOT_FINITE", Status::not_finite}, {"GCV_ERR_DEGENERATE", Status::degenerate},
    {"GCV_ERR_NOT_SIMPLE", Status::not_simple}, {"GCV_ERR_RANGE", Status::range},
    {"GCV_ERR_PARSE", Status::parse},
};

Operand polygon(const std::string& text, const char* name) {
  return {
      outer_ring(std::make_shared<const Polygon>(make_polygon(parse_polygon(text, name), name))),
      name};
}

std::string exact_ring_of_sum(const Operand& a, const Operand& b) {
  Task task;
  const OuterFace face = minkowski_sum(a, b, {0, 0}, Rounding::nearest, task);
  std::string text;
  for (std::size_t k = 0; k < face.exact.size(); ++k) {
    text += (k == 0 ? "" : ", ") + exact_vertex(face.exact, k);
  }
  return text;
}

template <typename Function>
void expect_status(const std::string& name, Function function) {
  try {
    function();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), statuses.at(name)) << error.what();
  }
}

TEST(Corpus, Sums) {
  std::ifstream file(GCV_CORPUS);
  std::string line, name;
  Operand a, b;
  int tried = 0;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string word, status, rest;
    words >> word;
    SCOPED_TRACE(name + ": " + line);
    if (word == "case") {
      words >> name;
    } else if (word == "a" || word == "b") {
      (word == "a" ? a : b) = polygon(line.substr(2), word.c_str());
    } else if (word == "refuse" || word == "sum") {
      words >> status >> std::ws;
      std::getline(words, rest);
      ++tried;
      if (status == "GCV_OK") {
        EXPECT_EQ(exact_ring_of_sum(a, b), rest);
      } else if (word == "sum") {
        expect_status(status, [&] { exact_ring_of_sum(a, b); });
      } else {
        expect_status(status, [&] { polygon(rest, "polygon"); });
      }
    }
  }
  EXPECT_GT(tried, 40);
}

std::string text_of(double x) {
  char text[40];
  static_cast<void>(std::snprintf(text, sizeof text, " %.17g", x));
  return text;
}

std::string text_of(const Point& p) { return text_of(p.x) + text_of(p.y); }

std::string text_of(Relation relation) {
  return relation == Relation::apart      ? " apart"
         : relation == Relation::touching ? " touching"
                                          : " overlapping";
}

std::string text_of(const Contact& contact) {
  static constexpr const char* names[] = {" none", " edge_vertex", " vertex_edge",
                                          " vertex_vertex"};
  const std::string name = names[static_cast<std::size_t>(contact.kind)];
  return contact.kind == ContactKind::none
             ? name
             : name + " " + std::to_string(contact.a) + " " + std::to_string(contact.b) +
                   text_of(contact.gap) + text_of(contact.on_a) + text_of(contact.on_b);
}

// The numbers of a line, one after the other.
double number(std::istringstream& words) {
  std::string x;
  words >> x;
  return std::strtod(x.c_str(), nullptr);
}

std::string text_of(const UsablePosition& place, const std::string& line) {
  return line.find(" inexact") != std::string::npos
             ? " inexact"
             : text_of(place.relation) + text_of(place.position);
}

std::string escape_text(const std::shared_ptr<const Polygon>& a,
                        const std::shared_ptr<const Polygon>& b, const Point& translation,
                        const std::string& line) {
  Task task;
  Tally tally;
  const Polygon reflected = Polygon::reflected(b);
  const WaysOut ways(*a, reflected, {}, 1, task, tally);
  const PolygonPair pair(*a, *b);
  const Escape escape = EscapeSearch(ways, tally).find(PlacedPair(pair, translation), task);
  return text_of(escape.depth) + text_of(escape.translation) + text_of(escape.place, line) +
         text_of(escape.contact);
}

std::string contacts_text(const PlacedPair& placed, double distance, double slope) {
  Task task;
  Tally tally;
  std::string text;
  for (const Contact& contact : near_contacts(placed, distance, slope, task, tally)) {
    text += text.empty() ? "" : ";";
    text += text_of(contact);
  }
  return text.empty() ? " empty" : text;
}

// The answer as the line has it.
std::string answer(const std::shared_ptr<const Polygon>& a, const std::shared_ptr<const Polygon>& b,
                   const std::string& line) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  const auto point = [&] {
    const double x = number(words);
    return Point{x, number(words)};
  };
  const PolygonPair pair(*a, *b);
  const Point translation = point();
  const PlacedPair placed(pair, translation);
  Tally tally;
  if (word == "relation") {
    return text_of(relation(placed, tally));
  }
  if (word == "distance") {
    const Separation separation = distance(placed, tally);
    return text_of(separation.relation) + text_of(separation.distance) +
           text_of(separation.nearest);
  }
  if (word == "penetration") {
    return escape_text(a, b, translation, line);
  }
  const Point more = point();
  if (word == "contacts") {
    return contacts_text(placed, more.x, more.y);
  }
  const Impact impact = cast(placed, more, tally);
  return std::string(impact.hit ? " hit" : " miss") + text_of(impact.time) +
         text_of(impact.place, line) + text_of(impact.contact);
}

TEST(Corpus, Questions) {
  std::ifstream file(GCV_CORPUS);
  std::string line, name;
  std::map<std::string, std::shared_ptr<const Polygon>> polygons;
  std::map<std::string, int> tried;
  const std::set<std::string> questions{"relation", "distance", "cast", "penetration", "contacts"};
  while (std::getline(file, line)) {
    const std::string word = line.substr(0, line.find(' '));
    SCOPED_TRACE(name + ": " + line);
    const std::string ok = " GCV_OK";
    const std::size_t end = line.find(ok);
    if (word == "case") {
      name = line.substr(word.size());
    } else if (word == "a" || word == "b") {
      polygons[word] =
          std::make_shared<const Polygon>(make_polygon(parse_polygon(line.substr(2), "a"), "a"));
    } else if (questions.count(word) > 0 && end != std::string::npos) {
      ++tried[word];
      EXPECT_EQ(answer(polygons.at("a"), polygons.at("b"), line), line.substr(end + ok.size()));
    }
  }
  for (const std::string& word : questions) {
    EXPECT_GT(tried[word], 40) << word;
  }
}

}  // namespace
}  // namespace gcv

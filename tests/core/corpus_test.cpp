// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The core, without the C interface, on the sums of tests/corpus and on what it refuses;
// README.md there describes the format.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "error.hpp"
#include "minkowski_sum.hpp"
#include "polygon.hpp"
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

}  // namespace
}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Compares the answers of the library with those by definition.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "figures.hpp"
#include "library.hpp"
#include "parts.hpp"

namespace worlds {

// A polygon with all that is asked of it.
struct Operand {
  explicit Operand(const Polygon& given);
  explicit Operand(const Figure& figure);

  Polygon polygon;
  std::vector<Convex> inside;
  std::vector<Convex> outside;
  // Of the polygon reflected.
  std::vector<Convex> reflected_inside;
  Owner<gcv_polygon> handle;
  Owner<gcv_polygon> reflected_handle;
  // The width and the height.
  Point size;

 private:
  Operand(const Polygon& given, const std::vector<Convex>& pieces, std::vector<Convex> rest);
};

// What was compared, and where it differed.
class Report {
 public:
  void add_case() { ++cases_; }
  void add_answers(std::size_t count) { answers_ += count; }

  // Prints the first differences.
  void differ(const std::string& question, const std::string& operands, const std::string& library,
              const std::string& definition);

  [[nodiscard]] std::size_t cases() const { return cases_; }
  [[nodiscard]] std::size_t answers() const { return answers_; }
  [[nodiscard]] std::size_t differences() const { return differences_; }

 private:
  std::size_t cases_ = 0;
  std::size_t answers_ = 0;
  std::size_t differences_ = 0;
};

// The outer face, the region, the inner fit, and B at all places near A.
void compare_pair(const Operand& a, const Operand& b, Report& report);

// A polygon among members at positions, in a container.
void compare_scene(const Operand& container, const std::array<Operand, 3>& members,
                   const std::array<Point, 3>& positions, const Operand& moving, Report& report);

}  // namespace worlds

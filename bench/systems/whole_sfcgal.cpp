// SPDX-License-Identifier: LGPL-3.0-or-later
#include <cstdlib>
#include <string>

#include "sfcgal.hpp"
#include "whole.hpp"

namespace gcv::bench {

namespace {

// The rings of "MULTIPOLYGON(((p/q r/s,p/q r/s,...),(...)),...)".
ExactWhole parsed(const std::string& text) {
  ExactWhole whole;
  const auto add = [&](std::size_t first, std::size_t last, bool is_hole) {
    invariants::Ring ring;
    while (first < last) {
      const std::size_t space = text.find(' ', first);
      const std::size_t end = std::min(text.find(',', space), last);
      ring.push_back({invariants::Rational(text.substr(first, space - first)),
                      invariants::Rational(text.substr(space + 1, end - space - 1))});
      first = end + 1;
    }
    ring.pop_back();  // the first vertex again
    (is_hole ? whole.holes : whole.outer).push_back(ring);
  };
  int depth = 0;
  bool is_hole = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '(' && ++depth == 3) {
      add(k + 1, text.find(')', k), is_hole);
      is_hole = true;
    } else if (text[k] == ')' && --depth == 1) {
      is_hole = false;
    }
  }
  return whole;
}

}  // namespace

WholeInDoubles sfcgal_whole(const Ring& a, const Ring& b) {
  const SfcgalGeometry sum = sfcgal_sum(a, b);
  WholeInDoubles whole;
  for (std::size_t k = 0; k < sfcgal_geometry_collection_num_geometries(sum.get()); ++k) {
    const sfcgal_geometry_t* const polygon = sfcgal_geometry_collection_geometry_n(sum.get(), k);
    whole.outer.push_back(sfcgal_ring(sfcgal_polygon_exterior_ring(polygon)));
    for (std::size_t hole = 0; hole < sfcgal_polygon_num_interior_rings(polygon); ++hole) {
      whole.holes.push_back(sfcgal_ring(sfcgal_polygon_interior_ring_n(polygon, hole)));
    }
  }
  return whole;
}

ExactWhole sfcgal_exact_whole(const Ring& a, const Ring& b) {
  char* buffer = nullptr;
  std::size_t length = 0;
  sfcgal_geometry_as_text(sfcgal_sum(a, b).get(), &buffer, &length);
  const std::string text(buffer, length);
  std::free(buffer);
  return parsed(text);
}

}  // namespace gcv::bench

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exact vertices that the C interface gives, as fractions.
#pragma once

#include <gcv/gcv.h>

#include <cstddef>
#include <string>

#include "exact_geometry.hpp"
#include "handles.hpp"

namespace gcv::invariants {

// The points of `count` exact vertices: read(k, text, capacity, required) gives the text of one.
template <class Read>
Ring exact_points(std::size_t count, Read read) {
  Ring points;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t length = 0;
    require(read(k, nullptr, std::size_t{0}, &length), "a length");
    std::string text(length, ' ');
    require(read(k, text.data(), length, &length), "an exact vertex");
    const std::size_t space = text.find(' ');
    points.push_back(
        {Rational(text.substr(0, space)), Rational(text.substr(space + 1, length - space - 2))});
  }
  return points;
}

inline Ring exact_ring(const gcv_outer_face* face) {
  std::size_t count = 0;
  require(gcv_outer_face_exact_vertex_count(face, &count), "the number of exact vertices");
  return exact_points(
      count, [&](auto... arguments) { return gcv_outer_face_exact_vertex(face, arguments...); });
}

}  // namespace gcv::invariants

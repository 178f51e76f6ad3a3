// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The C interface of parry/src/lib.rs.
#pragma once

#include <cstddef>

extern "C" {
struct parry_shape;
parry_shape* parry_shape_create(const double* xy, std::size_t count);
void parry_shape_destroy(parry_shape* shape);
void parry_relation(const parry_shape* a, const parry_shape* b, const double* xy, std::size_t count,
                    double* out);
void parry_distance(const parry_shape* a, const parry_shape* b, const double* xy, std::size_t count,
                    double* out);
void parry_cast(const parry_shape* a, const parry_shape* b, const double* xy, const double* motions,
                std::size_t count, double* out);
}

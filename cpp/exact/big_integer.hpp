// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The largest integers: those of finite doubles of any magnitude.
//
// Finite doubles are integers on the grid of 2^-1074, of 2098 bits. No formula takes more than
// 10 b + 22 bits for operands of b bits: so many compare two distances of crossings
// (compare_distances). Numbers of that size lie on the stack, and take no heap memory. They have
// 336 limbs of 64 bits: a product takes as many as both its factors, a sum one more than the larger
// of its terms. What needed more would take heap memory, or throw std::bad_alloc.
//
// Heavy headers: include this in source files only.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace gcv {

constexpr int bits_of_all_doubles = 2098;
constexpr int big_integer_bits = 10 * bits_of_all_doubles + 22;

using BigInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<336 * 64>,
                                                 boost::multiprecision::et_off>;

}  // namespace gcv

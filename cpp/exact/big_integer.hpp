// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Integers of any size: GMP's, or Boost's where there is no GMP. Both give the same values.
// Heavy headers: include this in source files only.
#pragma once

#include <string>

#ifdef GCV_GMP
#include <boost/multiprecision/gmp.hpp>
#else
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace gcv {

#ifdef GCV_GMP
using BigIntegerBackend = boost::multiprecision::gmp_int;
#else
using BigIntegerBackend = boost::multiprecision::cpp_int_backend<>;
#endif
using BigInteger = boost::multiprecision::number<BigIntegerBackend, boost::multiprecision::et_off>;

// In decimal digits.
inline std::string to_text(const BigInteger& value) {
#ifdef GCV_GMP
  // str() would leak GMP's text if there is no memory for a copy of it.
  std::string text(mpz_sizeinbase(value.backend().data(), 10) + 2, '\0');
  mpz_get_str(text.data(), 10, value.backend().data());
  text.resize(text.find('\0'));
  return text;
#else
  return value.str();
#endif
}

}  // namespace gcv

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// fma(x, y, z) is x y + z, rounded once. That of mingw-w64 rounds twice, and that of Emscripten is
// slow, so there is another one.
#pragma once

#include <cmath>

namespace gcv {

#if defined(__MINGW32__) || defined(__wasm__)
double fma(double x, double y, double z);
#else
using std::fma;
#endif

}  // namespace gcv

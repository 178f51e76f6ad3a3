// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where a rounded or simplified boundary may lie.
#pragma once

#include <cstdint>

namespace gcv {

// Nearest: near the exact boundary, on either side. Outward: the solid contains the exact one.
// The values are those of gcv_options.rounding.
enum class Rounding : std::int32_t { nearest = 0, outward = 1 };

}  // namespace gcv

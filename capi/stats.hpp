// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Fills gcv_stats of any version.
#pragma once

#include <cstdint>

#include "gcv/gcv.h"
#include "minkowski_sum.hpp"

namespace gcv::capi {

// Writes as many bytes to *out as out->struct_size says. Throws Error: invalid_argument, if
// version 0.1 had more.
void give_stats(const Counts& counts, std::uint64_t vertices_repaired, std::uint64_t parts_dropped,
                gcv_stats* out);

}  // namespace gcv::capi

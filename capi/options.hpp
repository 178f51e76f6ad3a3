// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Reads and checks gcv_options of any version.
#pragma once

#include <cstdint>

#include "exact_region.hpp"
#include "gcv/gcv.h"
#include "minkowski_region.hpp"
#include "minkowski_sum.hpp"
#include "simplification.hpp"

namespace gcv::capi {

// Both throw Error: invalid_argument, with a message that begins with `where`.
Rounding read_rounding(std::int32_t rounding, const char* where);
void check_tolerance(double tolerance, const char* where);

// The options that this version knows. Takes a struct of any version, or NULL for the defaults.
gcv_options read_options(const gcv_options* options);
// Throws Error: invalid_argument for a tolerance. `what` is exact.
void refuse_tolerance(const gcv_options& options, const char* what);
// For what is exact and knows obstacles, called `what` in messages: refuses a tolerance too, and
// the leaving out of holes, for obstacles would be free there.
gcv_options read_exact_options(const gcv_options* options, const char* what);

SumOptions sum_options(const gcv_options& options);
RegionOptions region_options(const gcv_options& options);
WantedParts wanted_parts(const gcv_options& options);

// The number of threads that the options ask for.
unsigned threads_of(const gcv_options& options);

}  // namespace gcv::capi

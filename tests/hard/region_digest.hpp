// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <gcv/gcv.h>

#include <functional>

#include "digest.hpp"

namespace gcv::hard {

using ComputeRegion = std::function<gcv_status(const gcv_options* options, gcv_region** out)>;

// All that the library says of a region, in both roundings.
void add_regions(Digest& digest, const ComputeRegion& compute);

}  // namespace gcv::hard

// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "contact/handle.hpp"

namespace gcv::bench {

// Random translations of B in the box of A + (-B), at which it overlaps A.
PointVector overlaps(const gcv_polygon* a, const gcv_polygon* b, std::size_t count);

}  // namespace gcv::bench

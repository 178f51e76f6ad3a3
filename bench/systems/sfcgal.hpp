// SPDX-License-Identifier: LGPL-3.0-or-later
//
// To and from SFCGAL's geometries, through its C interface.
#pragma once

#include <SFCGAL/capi/sfcgal_c.h>

#include <memory>

#include "point.hpp"

namespace gcv::bench {

using SfcgalGeometry = std::unique_ptr<sfcgal_geometry_t, decltype(&sfcgal_geometry_delete)>;

// The sum, a multipolygon. Throws where there is none.
SfcgalGeometry sfcgal_sum(const PointVector& a, const PointVector& b);

PointVector sfcgal_ring(const sfcgal_geometry_t* line);

}  // namespace gcv::bench

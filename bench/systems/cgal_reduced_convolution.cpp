// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/minkowski_sum_2.h>

#include "cgal.hpp"

namespace gcv::bench {

Job cgal_reduced_convolution(const Ring& a, const Ring& b) {
  return cgal_job(a, b, [](const CgalPolygon& p, const CgalPolygon& q) {
    return CGAL::minkowski_sum_by_reduced_convolution_2(p, q).outer_boundary();
  });
}

}  // namespace gcv::bench

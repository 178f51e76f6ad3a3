// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>

#include "cgal.hpp"

namespace gcv::bench {

Job cgal_decomposition(const Ring& a, const Ring& b) {
  return cgal_job(a, b, [](const CgalPolygon& p, const CgalPolygon& q) {
    const CGAL::Small_side_angle_bisector_decomposition_2<Kernel> decomposition;
    return CGAL::minkowski_sum_2(p, q, decomposition).outer_boundary();
  });
}

}  // namespace gcv::bench

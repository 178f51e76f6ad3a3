// SPDX-License-Identifier: LGPL-3.0-or-later
#include <limits>

#include "system.hpp"

namespace gcv::bench {

std::vector<System> systems() {
  constexpr double any = std::numeric_limits<double>::infinity();
  return {{"libgcv", true, any, libgcv_cold(GCV_LIBRARY)},
          {"libgcv prepared", true, any, libgcv_prepared(GCV_LIBRARY)},
          {"libgcv exact tier only", true, any, libgcv_cold(GCV_EXACT_LIBRARY)},
          {"libgcv plain doubles", true, any, libgcv_cold(GCV_PLAIN_LIBRARY)},
          {"CGAL reduced convolution", true, 1e8, cgal_reduced_convolution},
#ifdef GCV_BENCH_CLIPPER2
          {"Clipper2", true, 3e5, clipper2},
#endif
          {"Clipper", true, 3e5, clipper},
          {"CGAL full convolution", false, 1e5, cgal_full_convolution},
          {"CGAL decomposition", false, 2e6, cgal_decomposition},
          {"GCVMSOF by arrangement", false, 2e6, gcv_arrangement},
          {"RCMSOF by arrangement", false, 2e6, reduced_convolution_arrangement},
          {"Boost.Polygon", false, 1e5, boost_polygon}};
}

}  // namespace gcv::bench

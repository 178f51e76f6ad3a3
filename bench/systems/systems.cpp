// SPDX-License-Identifier: LGPL-3.0-or-later
#include <limits>

#include "system.hpp"

namespace gcv::bench {

namespace {

using OnGrid = Job (*)(const Ring&, const Ring&, double);

Prepare on_29_bits(OnGrid job) {
  return [job](const Ring& a, const Ring& b) { return job(a, b, cells_per_unit(a, b, 29)); };
}

}  // namespace

std::vector<System> systems() {
  constexpr double any = std::numeric_limits<double>::infinity();
  return {
      {"libgcv", Role::libgcv, any, libgcv_cold(GCV_LIBRARY)},
      {"libgcv prepared", Role::libgcv, any, libgcv_prepared(GCV_LIBRARY)},
      {"libgcv exact tier only", Role::libgcv, any, libgcv_cold(GCV_EXACT_LIBRARY)},
      {"libgcv plain doubles", Role::libgcv, any, libgcv_cold(GCV_PLAIN_LIBRARY)},
      {"libgcv without swept spheres", Role::libgcv, 1e8,
       libgcv_cold(GCV_NO_SWEPT_SPHERES_LIBRARY)},
      {"libgcv without cycle", Role::libgcv, 1e8, libgcv_cold(GCV_NO_CONVOLUTION_CYCLE_LIBRARY)},
      {"libgcv without merge", Role::libgcv, 1e8, libgcv_cold(GCV_NO_CONVEX_MERGE_LIBRARY)},
      {"libgcv without table", Role::libgcv, 1e8, libgcv_cold(GCV_NO_TABLE_LIBRARY)},
      {"libgcv without place cache", Role::libgcv, 1e8, libgcv_cold(GCV_NO_PLACE_CACHE_LIBRARY)},
      {"libgcv without ahead cache", Role::libgcv, 1e8, libgcv_cold(GCV_NO_AHEAD_CACHE_LIBRARY)},
      {"libgcv without equal chains", Role::libgcv, 1e8, libgcv_cold(GCV_NO_EQUAL_CHAINS_LIBRARY)},
      {"libgcv without curve order", Role::libgcv, 1e8, libgcv_cold(GCV_NO_CURVE_ORDER_LIBRARY)},
      {"CGAL reduced convolution", Role::principal_peer, 1e8, cgal_reduced_convolution},
#ifdef GCV_BENCH_CLIPPER2
      {"Clipper2", Role::principal_peer, 3e5, on_29_bits(clipper2)},
#endif
      {"Clipper", Role::principal_peer, 3e5, on_29_bits(clipper)},
      {"CGAL full convolution", Role::peer, 1e5, cgal_full_convolution},
      {"CGAL decomposition", Role::peer, 2e6, cgal_decomposition},
      {"GCVMSOF by arrangement", Role::peer, 2e6, gcv_arrangement},
      {"RCMSOF by arrangement", Role::peer, 2e6, reduced_convolution_arrangement},
      {"Boost.Polygon", Role::peer, 1e5, on_29_bits(boost_polygon)}};
}

}  // namespace gcv::bench

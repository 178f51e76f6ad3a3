/* Polygons with a clearance.
 *
 * Copyright (C) 2026 The libgcv authors
 * SPDX-License-Identifier: LGPL-3.0-or-later
 */
#ifndef GCV_HPP_OFFSET_HPP
#define GCV_HPP_OFFSET_HPP

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gcv/hpp/sums.hpp>

namespace gcv {
inline namespace hpp {

namespace detail {

/** A number in few digits that read back as the same one. */
inline std::string digits(double number) {
  char text[32];
  for (int count = 15; count <= 17; ++count) {
    std::snprintf(text, sizeof text, "%.*g", count, number);
    if (std::strtod(text, nullptr) == number) {
      break;
    }
  }
  return text;
}

}  // namespace detail

/**
 * The polygon with a clearance: grown by the distance, or shrunk where it is below 0.
 *
 * Above 0, the region contains every point within the distance of the polygon, and none farther
 * from it than distance + tolerance. Below 0, every point of the region is in the polygon and at
 * least -distance from all outside of it, and every point farther from there than
 * -distance + tolerance is in the region. It has no segments and no points.
 *
 * For: a disc that contains the one of that radius, and is contained in one larger by 7/8 of the
 * tolerance, is added to the polygon, or moved inside of it, exactly; and rounding moves the
 * boundary outwards, or inwards, by a 16th of the tolerance at most, or the call fails.
 *
 * Of the options, threads and progress count. Throws GCV_ERR_INVALID_ARGUMENT for a distance that
 * is 0 or not finite, and for a tolerance that is not above 0, not finite, or too small for
 * doubles; else what the sums throw.
 */
inline Region offset(const Polygon& polygon, double distance, double tolerance,
                     const Options& options = {}) {
  if (!std::isfinite(distance) || distance == 0) {
    throw Error(GCV_ERR_INVALID_ARGUMENT,
                "distance: " + detail::digits(distance) + " is not a finite number other than 0");
  }
  if (!std::isfinite(tolerance) || tolerance <= 0) {
    throw Error(GCV_ERR_INVALID_ARGUMENT,
                "tolerance: " + detail::digits(tolerance) + " is not a finite number above 0");
  }
  const Polygon disc = Polygon::disc({}, std::abs(distance), 0.875 * tolerance, Rounding::outward);
  Options safe;
  safe.rounding = Rounding::outward;
  safe.threads = options.threads;
  safe.progress = options.progress;
  safe.leave_out_fits = true;
  Region region = distance > 0 ? minkowski_sum_region(polygon, disc, safe)
                               : inner_fit_region(polygon, disc, {}, safe);
  if (region.error_bound() > 0.0625 * tolerance) {
    throw Error(GCV_ERR_INVALID_ARGUMENT,
                "tolerance: it is too small for the roundings of these coordinates to doubles");
  }
  return region;
}

}  // namespace hpp
}  // namespace gcv

#endif

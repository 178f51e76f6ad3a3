// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons with a clearance.

import { InputError, Status, unfitNumber } from "./errors.js";
import { newPolygon, withOperands } from "./operands.js";
import { callOptions, checkOptions, type CallOptions, type RegionOptions } from "./options.js";
import { numberOf } from "./points.js";
import { Polygon } from "./polygon.js";
import type { Region } from "./region.js";
import type { PolygonLike } from "./sources.js";
import { innerFitRegion, minkowskiSumRegion } from "./sums.js";

// What the disc and the rounding take of the tolerance; a 16th is left for the rounding of shares.
const shareOfDisc = 7 / 8;
const shareOfRounding = 1 / 16;

// Discs that need more have twice as many, and then no sum fits into the memory of the module.
const mostVertices = 7e6;

const roundings = "the roundings of these coordinates to doubles";

/**
 * The polygon with a clearance: grown by the distance, or shrunk where it is below 0.
 *
 * Above 0, the region contains every point within the distance of the polygon, and none farther
 * from it than distance + tolerance; holes shrink. Below 0, every point of the region is in the
 * polygon and at least -distance from all outside of it, and every point farther from there than
 * -distance + tolerance is in the region; holes grow, and there can be several polygons or none.
 * It has no segments and no points.
 *
 * For: a disc that contains the one of that radius, and is contained in one larger by 7/8 of the
 * tolerance, is added to the polygon, or moved inside of it, exactly; and rounding moves the
 * boundary outwards, or inwards, by a 16th of the tolerance at most, which errorBound certifies.
 *
 * For a distance of r or -r the disc has about 2.4 sqrt(r / tolerance) vertices, up to twice as
 * many.
 *
 * Throws an InputError for a distance that is 0 or not finite, and for a tolerance that is not
 * above 0, not finite, too small for doubles, or so small that the disc does not fit into memory.
 */
export function offset(
  polygon: PolygonLike,
  distance: number,
  tolerance: number,
  options: CallOptions = {},
): Region {
  checkOptions(options, callOptions);
  if (!Number.isFinite(numberOf(distance, "distance")) || distance === 0) {
    throw unfitNumber("distance", distance, "a finite number other than 0");
  }
  if (!Number.isFinite(numberOf(tolerance, "tolerance")) || tolerance <= 0) {
    throw unfitNumber("tolerance", tolerance, "a finite number above 0");
  }
  const safe: RegionOptions = { ...options, rounding: "outward", leaveOut: "fits" };
  const radius = Math.abs(distance);
  if (2.4 * Math.sqrt(radius / tolerance) > mostVertices) {
    throw tooSmall(tolerance, `a distance of ${distance}: its disc has too many vertices`);
  }
  return withOperands((operands) => {
    operands.use(polygon);
    const source =
      polygon instanceof Polygon ? polygon : operands.own(newPolygon(polygon, "polygon"));
    const disc = operands.own(discOf(radius, tolerance));
    const region =
      distance > 0
        ? minkowskiSumRegion(source, disc, safe)
        : innerFitRegion(source, disc, [0, 0], safe);
    if (region.errorBound > shareOfRounding * tolerance) {
      region.free();
      throw tooSmall(tolerance, roundings);
    }
    return region;
  });
}

/** A disc that contains the one of that radius. */
function discOf(radius: number, tolerance: number): Polygon {
  try {
    return Polygon.disc([0, 0], radius, shareOfDisc * tolerance, { rounding: "outward" });
  } catch (error) {
    throw error instanceof InputError ? tooSmall(tolerance, roundings) : error;
  }
}

function tooSmall(tolerance: number, what: string): InputError {
  return new InputError(Status.INVALID_ARGUMENT, `tolerance: ${tolerance} is too small for ${what}`);
}

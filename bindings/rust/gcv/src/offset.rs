// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use crate::{
    inner_fit_region, minkowski_sum_region, status, Error, Options, Polygon, Region, Rounding,
};

/// The shares of the tolerance that the disc and the rounding take. A 16th is left, for the
/// rounding of these shares.
const SHARE_OF_DISC: f64 = 7. / 8.;
const SHARE_OF_ROUNDING: f64 = 1. / 16.;

/// The polygon with a clearance: grown by the distance, or shrunk where it is below 0.
///
/// Above 0, the region contains every point within the distance of the polygon, and none
/// farther from it than `distance + tolerance`; holes shrink. Below 0, every point of the
/// region is in the polygon and at least `-distance` from all outside of it, and every point
/// farther from there than `-distance + tolerance` is in the region; holes grow, and there can
/// be several polygons or none. So what is placed by the region keeps the distance. It has no
/// segments and no points.
///
/// For: a disc that contains the one of that radius, and is contained in one larger by 7/8 of
/// the tolerance, is added to the polygon, or moved inside of it, exactly; and rounding moves
/// the boundary outwards, or inwards, by a 16th of the tolerance at most, which
/// [`Region::error_bound`] certifies.
///
/// The disc has about 2.4 sqrt(|distance| / tolerance) vertices, up to twice as many. Of the
/// options, threads and progress count.
///
/// ```
/// use gcv::{offset, Location, Options, Polygon};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[(0., 0.), (4., 0.), (4., 4.), (0., 4.)])?;
/// let grown = offset(&square, 5., 0.01, &Options::new())?;
/// let locations = grown.locate(&[(7., 8.), (7.01, 8.01)])?;
/// assert_ne!(locations[0], Location::Outside);
/// assert_eq!(locations[1], Location::Outside);
/// let shrunk = offset(&square, -1., 0.01, &Options::new())?;
/// assert!(3.9 < shrunk.area()? && shrunk.area()? <= 4.);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// `GCV_ERR_INVALID_ARGUMENT` for a distance that is 0 or not finite, and for a tolerance that is
/// not above 0, not finite, or too small for `f64`; else as [`minkowski_sum_region`].
pub fn offset(
    polygon: &Polygon,
    distance: f64,
    tolerance: f64,
    options: &Options,
) -> Result<Region, Error> {
    if !distance.is_finite() || distance == 0. {
        let message = format!("distance: {distance} is not a finite number other than 0");
        return Err(invalid(message));
    }
    if !tolerance.is_finite() || tolerance <= 0. {
        let message = format!("tolerance: {tolerance} is not a finite number above 0");
        return Err(invalid(message));
    }
    let too_small = || {
        invalid(format!(
            "tolerance: {tolerance} is too small for the roundings of these coordinates to f64"
        ))
    };
    let (radius, share) = (distance.abs(), SHARE_OF_DISC * tolerance);
    let disc = Polygon::disc([0., 0.], radius, share, Rounding::Outward).map_err(|error| {
        match error.status {
            status::GCV_ERR_INVALID_ARGUMENT => too_small(),
            _ => error,
        }
    })?;
    let options = options
        .clone()
        .rounding(Rounding::Outward)
        .tolerance(0.)
        .leave_out_holes(false)
        .leave_out_fits(true);
    let region = if distance > 0. {
        minkowski_sum_region(polygon, &disc, &options)?
    } else {
        inner_fit_region(polygon, &disc, [0., 0.], &options)?
    };
    if region.error_bound() > SHARE_OF_ROUNDING * tolerance {
        return Err(too_small());
    }
    Ok(region)
}

fn invalid(message: String) -> Error {
    Error {
        status: status::GCV_ERR_INVALID_ARGUMENT,
        message,
    }
}

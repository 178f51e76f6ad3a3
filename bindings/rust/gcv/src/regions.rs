// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::vec;

use gcv_sys as sys;

use crate::call::create;
use crate::sums::{many, pointers, WithReferences};
use crate::{Error, Options, Point, Polygon, Region};

/// The Minkowski sum A + B with all of its holes, and the exact fits in it.
///
/// The interior of the region is the open sum: the sums of an inner point of A and an inner
/// point of B. Its holes are what the open sum leaves free. A segment or a point of the region
/// is free too, but without free positions beside it: there, A and the reflection of B fit
/// exactly.
///
/// There is one polygon. Its outer ring is that of [`minkowski_sum`](crate::minkowski_sum).
///
/// # Errors
/// As [`minkowski_sum`](crate::minkowski_sum).
pub fn minkowski_sum_region(a: &Polygon, b: &Polygon, options: &Options) -> Result<Region, Error> {
    // SAFETY: the polygons are alive, the options are for the call.
    region(options, |options, out| unsafe {
        sys::gcv_minkowski_sum_region(a.as_ptr(), b.as_ptr(), options, out)
    })
}

/// The no-fit region fixed + (-moving) + reference.
///
/// It is where the point `reference`, tied to `moving`, may not go.
///
/// With the point in the interior of the region and on no segment and no point of it, the two
/// polygons overlap. With the point anywhere else they do not: outside the outer ring and
/// inside the holes they are apart; on the rings, the segments and the points they touch.
/// [`Region::locate`] tells which.
///
/// # Errors
/// As [`minkowski_sum_region`], and `GCV_ERR_NOT_FINITE` for the reference point.
pub fn no_fit_region(
    fixed: &Polygon,
    moving: &Polygon,
    reference: impl Point,
    options: &Options,
) -> Result<Region, Error> {
    let reference = reference.xy();
    let (fixed, moving, point) = (fixed.as_ptr(), moving.as_ptr(), reference.as_ptr());
    // SAFETY: the polygons and the point are alive, the options are for the call.
    region(options, |options, out| unsafe {
        sys::gcv_no_fit_region(fixed, moving, point, options, out)
    })
}

/// The whole of Shi's entrance block E(A, B) = B + (-A) + a0.
///
/// It is where the point `a0`, tied to block A, may not go. It is [`no_fit_region`] of B and A,
/// but for the sources of its edges: their first numbers are those of A.
///
/// # Errors
/// As [`no_fit_region`].
pub fn entrance_region(
    a: &Polygon,
    b: &Polygon,
    a0: impl Point,
    options: &Options,
) -> Result<Region, Error> {
    let a0 = a0.xy();
    let (a, b, point) = (a.as_ptr(), b.as_ptr(), a0.as_ptr());
    // SAFETY: the polygons and the point are alive, the options are for the call.
    region(options, |options, out| unsafe {
        sys::gcv_entrance_region(a, b, point, options, out)
    })
}

/// The inner-fit region: where the point `reference`, tied to `moving`, may go with `moving`
/// inside the container.
///
/// Touching the container from inside is allowed. The holes of the container are solid. The
/// region is several polygons with holes, segments and points, or empty. All of it is free,
/// its boundary too.
///
/// ```
/// use gcv::{inner_fit_region, Options, Polygon};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let container = Polygon::new(&[[0., 0.], [5., 0.], [5., 4.], [0., 4.]])?;
/// let square = |size| Polygon::new(&[[0., 0.], [size, 0.], [size, size], [0., size]]);
/// let region = |size| inner_fit_region(&container, &square(size)?, [0., 0.], &Options::new());
/// assert_eq!(region(3.)?.wkt(), "MULTIPOLYGON (((0 0, 2 0, 2 1, 0 1, 0 0)))");
/// assert_eq!(region(4.)?.segments(), [[[0., 0.], [1., 0.]]]);
/// assert!(region(5.)?.is_empty());
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`no_fit_region`]; `GCV_ERR_INVALID_ARGUMENT` also for a tolerance above 0 and for
/// [`Options::leave_out_holes`]. An empty region is no error.
pub fn inner_fit_region(
    container: &Polygon,
    moving: &Polygon,
    reference: impl Point,
    options: &Options,
) -> Result<Region, Error> {
    let reference = reference.xy();
    let (container, moving, point) = (container.as_ptr(), moving.as_ptr(), reference.as_ptr());
    // SAFETY: the polygons and the point are alive, the options are for the call.
    region(options, |options, out| unsafe {
        sys::gcv_inner_fit_region(container, moving, point, options, out)
    })
}

fn region(
    options: &Options,
    call: impl FnOnce(*const sys::gcv_options, *mut *mut sys::gcv_region) -> i32,
) -> Result<Region, Error> {
    options.pass(|options| create(|out| call(options, out)).map(Region))
}

/// The region of every sum of a pair, in their order, each as by [`minkowski_sum_region`].
///
/// The pairs are shared out over the threads of the options. All are computed before the
/// first result is there to take.
///
/// # Errors
/// As [`minkowski_sum_many`](crate::minkowski_sum_many).
pub fn minkowski_sum_region_many<'p>(
    pairs: impl IntoIterator<Item = (&'p Polygon, &'p Polygon)>,
    options: &Options,
) -> vec::IntoIter<Result<Region, Error>> {
    let (a, b) = pointers(pairs);
    // SAFETY: the polygons are alive, the options are for the call, and there is room for as
    // many results as there are pairs.
    many(a.len(), options, Region, |options, out, statuses| unsafe {
        let (a, b, count) = (a.as_ptr(), b.as_ptr(), a.len());
        sys::gcv_minkowski_sum_region_many(a, b, count, options, out, statuses)
    })
}

/// The no-fit region of every fixed polygon, moving polygon and reference point, in their
/// order, each as by [`no_fit_region`].
///
/// The regions are shared out over the threads of the options. All are computed before the
/// first result is there to take. A moving polygon that occurs many times is reflected once.
///
/// # Errors
/// As [`minkowski_sum_many`](crate::minkowski_sum_many), and `GCV_ERR_NOT_FINITE` for a
/// reference point fails its pair.
pub fn no_fit_region_many<'p>(
    pairs: impl IntoIterator<Item = (&'p Polygon, &'p Polygon, [f64; 2])>,
    options: &Options,
) -> vec::IntoIter<Result<Region, Error>> {
    let pairs = WithReferences::from(pairs);
    // SAFETY: the polygons are alive, the options are for the call, and there is room for as
    // many results as there are pairs.
    many(
        pairs.count(),
        options,
        Region,
        |options, out, statuses| unsafe {
            let (fixed, moving, points) = pairs.as_ptrs();
            let count = pairs.count();
            sys::gcv_no_fit_region_many(fixed, moving, points, count, options, out, statuses)
        },
    )
}

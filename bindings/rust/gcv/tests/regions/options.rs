// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What is left out, and what is refused.

use std::ops::ControlFlow;

use gcv::status::*;
use gcv::Options;
use gcv::{entrance_region, inner_fit_region, minkowski_sum, minkowski_sum_region, no_fit_region};

use crate::{frame, frame_and_square, huge, slot, slot_and_peg, square, status, ORIGIN};

#[test]
fn what_is_left_out() {
    let options = Options::new().leave_out_holes(true);
    let region = minkowski_sum_region(&frame(), &square(1.), &options).unwrap();
    assert_eq!(region.area(), Ok(121.));
    let no_fit = no_fit_region(&slot(), &square(2.), ORIGIN, &options).unwrap();
    assert_eq!(no_fit, slot_and_peg());

    let options = Options::new().leave_out_fits(true);
    let region = minkowski_sum_region(&frame(), &square(1.), &options).unwrap();
    assert_eq!(region, frame_and_square());
    let no_fit = no_fit_region(&slot(), &square(2.), ORIGIN, &options).unwrap();
    assert_eq!(no_fit.parts().len(), 1);
    let inner = inner_fit_region(&square(2.), &square(2.), ORIGIN, &options).unwrap();
    assert!(inner.is_empty());

    let options = options.leave_out_holes(true);
    assert!(format!("{options:?}").contains("leave_out_holes: true, leave_out_fits: true"));
    let region = minkowski_sum_region(&frame(), &square(1.), &options).unwrap();
    assert_eq!(region.polygons().next().unwrap().len(), 1);
    let face = minkowski_sum(&frame(), &square(1.), &options).unwrap();
    assert_eq!(face.vertices(), region.vertices());

    let options = options.leave_out_holes(false).leave_out_fits(false);
    let region = minkowski_sum_region(&frame(), &square(1.), &options).unwrap();
    assert_eq!(region, frame_and_square());
}

#[test]
fn refused() {
    let (slot, peg) = (slot(), square(2.));
    let options = Options::new();
    for point in [[f64::NAN, 0.], [0., f64::INFINITY]] {
        for region in [
            no_fit_region(&slot, &peg, point, &options),
            entrance_region(&slot, &peg, point, &options),
            inner_fit_region(&slot, &peg, point, &options),
        ] {
            assert_eq!(status(region), GCV_ERR_NOT_FINITE);
        }
    }
    let overflow = minkowski_sum_region(&huge(), &huge(), &options);
    assert_eq!(status(overflow), GCV_ERR_RANGE);
    let negative = minkowski_sum_region(&slot, &peg, &options.clone().tolerance(-1.));
    assert_eq!(status(negative), GCV_ERR_INVALID_ARGUMENT);

    let inner = |options: Options| status(inner_fit_region(&slot, &peg, ORIGIN, &options));
    assert_eq!(
        inner(Options::new().tolerance(0.5)),
        GCV_ERR_INVALID_ARGUMENT
    );
    assert_eq!(
        inner(Options::new().leave_out_holes(true)),
        GCV_ERR_INVALID_ARGUMENT
    );
    let patience = Options::new().progress(|_, _| ControlFlow::Break(()));
    assert_eq!(inner(patience), GCV_ERR_CANCELLED);
    let patience = Options::new().progress(|_, _| ControlFlow::Break(()));
    let cancelled = minkowski_sum_region(&slot, &peg, &patience);
    assert_eq!(status(cancelled), GCV_ERR_CANCELLED);

    let area = minkowski_sum_region(&square(1e200), &peg, &options)
        .unwrap()
        .area();
    assert_eq!(status(area), GCV_ERR_RANGE);
}

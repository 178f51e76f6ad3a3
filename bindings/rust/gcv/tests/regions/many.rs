// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Many regions, and many no-fit polygons, in one call.

use std::ops::ControlFlow;

use gcv::status::*;
use gcv::{minkowski_sum_region, minkowski_sum_region_many, no_fit_polygon, no_fit_polygon_many};
use gcv::{no_fit_region, no_fit_region_many, Error, Options};

use crate::{frame, huge, slot, square, status, ORIGIN};

/// Asserts that many are as one by one, and that the first message is about the first failure.
fn assert_same<R: PartialEq + std::fmt::Debug>(
    many: impl ExactSizeIterator<Item = Result<R, Error>>,
    singles: Vec<Result<R, Error>>,
    first_failure: usize,
) {
    assert_eq!(many.len(), singles.len());
    for (index, (result, expected)) in many.zip(singles).enumerate() {
        match (result, expected) {
            (Ok(result), Ok(expected)) => assert_eq!(result, expected),
            (Err(error), Err(expected)) => {
                assert_eq!(error.status, expected.status);
                let start = format!("pair {index}: ");
                assert!(error.message.starts_with(&start), "{error}");
                if index == first_failure {
                    assert!(error.message.ends_with(&expected.message), "{error}");
                }
            }
            (result, expected) => panic!("pair {index}: {result:?}, expected {expected:?}"),
        }
    }
}

#[test]
fn many_sums() {
    let (frame, unit, huge) = (frame(), square(1.), huge());
    let pairs = [
        (&frame, &unit),
        (&huge, &huge),
        (&frame, &frame),
        (&huge, &huge),
    ];
    for threads in 0..3 {
        let options = Options::new().threads(threads);
        let singles = pairs.map(|(a, b)| minkowski_sum_region(a, b, &options));
        assert_same(
            minkowski_sum_region_many(pairs, &options),
            singles.to_vec(),
            1,
        );
    }
    assert_eq!(minkowski_sum_region_many([], &Options::new()).len(), 0);
    let refused = Options::new().tolerance(-1.);
    for region in minkowski_sum_region_many(pairs, &refused) {
        assert_eq!(status(region), GCV_ERR_INVALID_ARGUMENT);
    }
}

#[test]
fn many_no_fits() {
    let (frame, slot, peg) = (frame(), slot(), square(2.));
    let pairs = [
        (&slot, &peg, [0., 0.]),
        (&slot, &peg, [0., f64::NAN]),
        (&frame, &peg, [1., -5.]),
        (&peg, &slot, [f64::INFINITY, 0.]),
        (&slot, &peg, [0.1, 0.3]),
    ];
    for threads in 0..3 {
        let options = Options::new().threads(threads);
        let singles = pairs.map(|(fixed, moving, point)| {
            let region = no_fit_region(fixed, moving, point, &options);
            let face = no_fit_polygon(fixed, moving, point, &options);
            (region, face)
        });
        let (regions, faces) = singles.into_iter().unzip();
        assert_same(no_fit_region_many(pairs, &options), regions, 1);
        assert_same(no_fit_polygon_many(pairs, &options), faces, 1);
    }
    let options = Options::new();
    assert_eq!(no_fit_region_many([], &options).len(), 0);
    assert_eq!(no_fit_polygon_many([], &options).len(), 0);

    let patience = Options::new().progress(|_, _| ControlFlow::Break(()));
    for face in no_fit_polygon_many(pairs, &patience) {
        assert_eq!(status(face), GCV_ERR_CANCELLED);
    }
}

#[test]
fn options_are_passed_on_to_many() {
    let (slot, peg) = (slot(), square(2.));
    let options = Options::new().leave_out_fits(true);
    let sums = minkowski_sum_region_many([(&slot, &-&peg)], &options);
    let no_fits = no_fit_region_many([(&slot, &peg, ORIGIN)], &options);
    for region in sums.chain(no_fits) {
        assert_eq!(region.unwrap().parts().len(), 1);
    }
}

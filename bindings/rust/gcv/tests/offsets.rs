// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Clearances: both sides of what they promise, on places that need no roots, and refusals.

use std::ops::ControlFlow;

use gcv::{offset, status, ErrorKind, Location, Options, Polygon};

fn polygon(wkt: &str) -> Polygon {
    wkt.parse().unwrap()
}

fn plate() -> Polygon {
    polygon("POLYGON ((0 0, 60 0, 60 40, 0 40), (20 10, 40 10, 40 30, 20 30))")
}

#[test]
fn outward() {
    for tolerance in [1., 1e-2, 1e-5] {
        let grown = offset(&plate(), 5., tolerance, &Options::new()).unwrap();
        assert!(grown.error_bound() <= tolerance / 16.);
        assert!(grown.segments().is_empty() && grown.points().is_empty());
        // At the distance from a corner, from a side, and in the hole.
        let at = [(63., 44.), (64., 43.), (-3., -4.), (65., 7.), (25., 20.)];
        let locations = grown.locate(&at).unwrap();
        assert!(!locations.contains(&Location::Outside));
        // Hardly farther.
        let more = 1. + 1.01 * tolerance / 5.;
        let beyond = [
            (60. + 3. * more, 40. + 4. * more),
            (-5. * more, 7.),
            (20. + 5. * more, 20.),
        ];
        let locations = grown.locate(&beyond).unwrap();
        assert_eq!(locations, [Location::Outside; 3]);
    }
    // The hole is full.
    let grown = offset(&plate(), 10., 0.1, &Options::new()).unwrap();
    assert_eq!(grown.polygons().next().unwrap().len(), 1);
}

#[test]
fn inward() {
    for tolerance in [1., 1e-2, 1e-5] {
        let shrunk = offset(&plate(), -5., tolerance, &Options::new()).unwrap();
        let deep = 5. + 1.01 * tolerance;
        let inside = [
            (deep, deep),
            (deep, 20.),
            (20. - deep, 20.),
            (30., 10. - 5.01),
        ];
        let locations = shrunk.locate(&inside[..3]).unwrap();
        assert_eq!(locations, [Location::Inside; 3]);
        // Not deep enough: at a side, and at a corner of the hole.
        let near = [(4.99, 20.), (15.01, 20.), (20. - 2.99, 10. - 3.99)];
        assert_eq!(shrunk.locate(&near).unwrap(), [Location::Outside; 3]);
    }
    // The rooms at both ends of a corridor, and nothing.
    let rooms =
        polygon("POLYGON ((0 0, 9 0, 9 3, 20 3, 20 0, 29 0, 29 9, 20 9, 20 5, 9 5, 9 9, 0 9))");
    let shrunk = offset(&rooms, -2., 0.01, &Options::new()).unwrap();
    assert_eq!(shrunk.polygons().count(), 2);
    assert!(offset(&rooms, -5., 0.01, &Options::new())
        .unwrap()
        .is_empty());
}

#[test]
fn options_that_count() {
    let cancel = Options::new().progress(|_, _| ControlFlow::Break(()));
    let error = offset(&plate(), 1., 0.1, &cancel).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Cancelled);
    let others = Options::new()
        .threads(2)
        .tolerance(3.)
        .leave_out_holes(true);
    for distance in [5., -5.] {
        let expected = offset(&plate(), distance, 0.01, &Options::new());
        assert_eq!(offset(&plate(), distance, 0.01, &others), expected);
    }
}

#[test]
fn refusals() {
    let refused = |distance, tolerance| {
        let error = offset(&plate(), distance, tolerance, &Options::new()).unwrap_err();
        assert_eq!(error.status, status::GCV_ERR_INVALID_ARGUMENT);
        error.message
    };
    for distance in [0., f64::NAN, f64::NEG_INFINITY] {
        assert!(refused(distance, 0.1).starts_with("distance: "));
    }
    for tolerance in [0., -1., f64::NAN, f64::INFINITY, 1e-17] {
        assert!(refused(1., tolerance).starts_with("tolerance: "));
    }
    assert_eq!(
        refused(1., 1e-15),
        "tolerance: 0.000000000000001 is too small for the roundings of these coordinates to f64"
    );
    let error = offset(&plate(), 1e308, 1e300, &Options::new()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Range);
}

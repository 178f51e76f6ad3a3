// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! How two polygons lie.

use gcv::status::*;
use gcv::Relation::{self, Apart, Overlapping, Touching};
use gcv::{no_fit_region, relation, relation_into, relation_many, Location, Options, Polygon};

use crate::{assert_fails, frame, polygon, slot, square};

/// Asserts the relation for each translation: of all at once, one by one, and exchanged.
fn assert_relations(a: &Polygon, b: &Polygon, cases: &[([f64; 2], Relation)]) {
    let options = Options::new();
    let translations: Vec<_> = cases.iter().map(|case| case.0).collect();
    let expected: Vec<_> = cases.iter().map(|case| case.1).collect();
    let relations = relation_many(a, b, &translations, &options);
    assert_eq!(relations, Ok(expected));
    for &(translation, expected) in cases {
        let found = relation(a, b, translation, &options);
        assert_eq!(found, Ok(expected), "{translation:?}");
        let exchanged = relation(b, a, translation.map(|c| -c), &options);
        assert_eq!(exchanged, Ok(expected), "{translation:?} exchanged");
    }
}

#[test]
fn squares() {
    let unit = square(1.);
    #[rustfmt::skip]
    let cases = [
        ([0., 0.], Overlapping), ([0.5, -0.5], Overlapping), ([1. - f64::EPSILON, 0.], Overlapping),
        ([1., 0.], Touching), ([1., 0.5], Touching), ([-1., 1.], Touching), ([0., -1.], Touching),
        ([1. + f64::EPSILON, 0.], Apart), ([1., 2.], Apart), ([-1e308, 1e308], Apart),
    ];
    assert_relations(&unit, &unit, &cases);
    assert_relations(&square(4.), &square(1.), &[([1., 1.], Overlapping)]);
}

/// The sums of coordinates are no doubles.
#[test]
fn translations_are_exact() {
    let (unit, tiny) = (square(1.), f64::from_bits(1));
    let triangle = |low| polygon(&[[0., low], [1., low], [0., 2.]]);
    let cases = [([0., 1.], Overlapping), ([0., 1. + f64::EPSILON], Apart)];
    assert_relations(&unit, &triangle(-tiny), &cases);
    let cases = [([0., 1.], Apart), ([0., 1. - f64::EPSILON], Overlapping)];
    assert_relations(&unit, &triangle(tiny), &cases);

    let huge = square(1.7e308);
    let cases = [([1.7e308, 1.7e308], Touching), ([1.7e308, 0.], Touching)];
    assert_relations(&huge, &huge, &cases);
}

#[test]
fn holes_are_free() {
    let frame = frame();
    #[rustfmt::skip]
    let cases = [
        ([3., 3.], Apart), ([1., 3.], Touching), ([7., 7.], Touching), ([0.5, 3.], Overlapping),
        ([10., 3.], Touching), ([11., 3.], Apart), ([9., 3.], Overlapping),
    ];
    assert_relations(&frame, &square(2.), &cases);
    // It fits exactly.
    let cases = [([1., 1.], Touching), ([1., 1. + f64::EPSILON], Overlapping)];
    assert_relations(&frame, &square(8.), &cases);
    assert_relations(&frame, &square(12.), &[([-1., -1.], Overlapping)]);
    assert_relations(&frame, &frame, &[([0., 0.], Overlapping)]);
}

#[test]
fn a_peg_that_just_fits_a_slot() {
    #[rustfmt::skip]
    let cases = [
        ([2., 2.], Touching), ([2., 4.], Touching), ([2., 6.], Touching), ([2., 7.], Apart),
        ([2., 1.9], Overlapping), ([2.1, 4.], Overlapping), ([3., 6.], Touching),
    ];
    assert_relations(&slot(), &square(2.), &cases);
}

#[test]
fn as_in_the_no_fit_region() {
    let (slot, peg, options) = (slot(), square(2.), Options::new());
    let region = no_fit_region(&slot, &peg, [0., 0.], &options).unwrap();
    let halves = |k: i32| f64::from(k) / 2.;
    let translations: Vec<_> = (0..400)
        .map(|k| [halves(k % 20 - 5), halves(k / 20 - 5)])
        .collect();
    let expected: Vec<_> = region
        .locate(&translations)
        .unwrap()
        .into_iter()
        .map(|location| match location {
            Location::Inside => Overlapping,
            Location::Boundary => Touching,
            Location::Outside => Apart,
        })
        .collect();
    let relations = relation_many(&slot, &peg, &translations, &options);
    assert_eq!(relations, Ok(expected));
}

#[test]
fn into_a_slice() {
    let (unit, options) = (square(1.), Options::new());
    let mut out = [Overlapping; 3];
    relation_into(&unit, &unit, &[[1., 0.], [2., 0.]], &options, &mut out[..2]).unwrap();
    assert_eq!(out, [Touching, Apart, Overlapping]);

    let failed = relation_into(
        &unit,
        &unit,
        &[[0., 0.], [f64::NAN, 0.]],
        &options,
        &mut out[..2],
    );
    assert_fails(failed, GCV_ERR_NOT_FINITE, "translations: number 1 ");
    assert_eq!(out, [Touching, Apart, Overlapping]);

    let failed = relation_into(&unit, &unit, &[[0., 0.]], &options, &mut out);
    let message = "out: the length is 3, that of translations is 1";
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, message);
    assert_eq!(out, [Touching, Apart, Overlapping]);
}

#[test]
fn of_nothing() {
    let (unit, options) = (square(1.), Options::new());
    assert_eq!(relation_many(&unit, &unit, &[], &options), Ok(vec![]));
    assert_eq!(relation_into(&unit, &unit, &[], &options, &mut []), Ok(()));
    let failed = relation_into(&unit, &unit, &[], &options, &mut [Apart]);
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, "out: ");
}

#[test]
fn refused() {
    let (unit, options) = (square(1.), Options::new());
    for translation in [[f64::NAN, 0.], [0., f64::INFINITY]] {
        let failed = relation(&unit, &unit, translation, &options);
        assert_fails(failed, GCV_ERR_NOT_FINITE, "translations: number 0 ");
        let translations = [[0., 0.], [1., 1.], translation];
        let failed = relation_many(&unit, &unit, &translations, &options);
        assert_fails(failed, GCV_ERR_NOT_FINITE, "translations: number 2 ");
    }
}

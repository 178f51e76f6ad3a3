// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! How deep two polygons overlap, and the way out.

use std::f64::consts::FRAC_1_SQRT_2;

use gcv::status::*;
use gcv::{penetration, penetration_into, penetration_many, relation_many};
use gcv::{Escape, Options, Polygon, Relation};

use crate::{assert_fails, frame, polygon, slot, square};

fn escape(a: &Polygon, b: &Polygon, translation: [f64; 2]) -> Escape {
    penetration(a, b, translation, &Options::new()).unwrap()
}

#[test]
fn the_shortest_way_out() {
    let square = square(4.);
    let found = escape(&square, &square, [3., 1.]);
    assert_eq!((found.depth(), found.translation()), (1., [1., 0.]));
    assert_eq!(found.position(), [4., 1.]);
    assert_eq!(found.relation(), Relation::Touching);
    let contact = found.contact().unwrap();
    assert_eq!(contact.normal(), [1., 0.]);
    let debug = format!(
        "Escape {{ depth: 1.0, translation: [1.0, 0.0], position: [4.0, 1.0], \
         relation: Touching, id: 0, contact: Some({contact:?}) }}"
    );
    assert_eq!(format!("{found:?}"), debug);

    // Of several, the lexicographically smallest.
    let found = escape(&square, &square, [0., 0.]);
    assert_eq!((found.depth(), found.translation()), (4., [-4., 0.]));
}

#[test]
fn correctly_rounded() {
    let triangle = polygon(&[[0., 0.], [4., 0.], [0., 4.]]);
    let found = escape(&triangle, &square(1.), [1.5, 1.5]);
    assert_eq!(found.depth(), FRAC_1_SQRT_2);
    assert_eq!((found.translation(), found.position()), ([0.5; 2], [2.; 2]));
}

#[test]
fn without_overlap() {
    let unit = square(1.);
    for (translation, relation) in [
        ([1., 0.5], Relation::Touching),
        ([3., -7.], Relation::Apart),
    ] {
        let found = escape(&unit, &unit, translation);
        assert_eq!((found.depth(), found.translation()), (0., [0., 0.]));
        assert_eq!(found.position(), translation);
        assert_eq!((found.relation(), found.contact()), (relation, None));
    }
}

#[test]
fn into_holes_and_fits() {
    let (frame, slot, peg) = (frame(), slot(), square(2.));
    let way = |a: &Polygon, translation, options: Options| {
        penetration(a, &peg, translation, &options)
            .unwrap()
            .translation()
    };
    let (at_hole, at_slot) = ([0.5, 3.], [2.25, 4.]);
    assert_eq!(way(&frame, at_hole, Options::new()), [0.5, 0.]);
    assert_eq!(way(&slot, at_slot, Options::new()), [-0.25, 0.]);
    let without_holes = Options::new().leave_out_holes(true);
    assert_eq!(way(&frame, at_hole, without_holes), [-2.5, 0.]);
    let without_fits = Options::new().leave_out_fits(true);
    assert_eq!(way(&slot, at_slot, without_fits), [0., 2.]);
}

#[test]
fn many_and_into_a_slice() {
    let (slot, peg, options) = (slot(), square(2.), Options::new());
    let translation = |k| [f64::from(k % 10) - 2., f64::from(k / 10) - 2.];
    let translations: Vec<_> = (0..100).map(translation).collect();
    let many = penetration_many(&slot, &peg, &translations, &options).unwrap();
    let relations = relation_many(&slot, &peg, &translations, &options).unwrap();
    let mut out = vec![Escape::default(); 100];
    penetration_into(&slot, &peg, &translations, &options, &mut out).unwrap();
    assert_eq!(out, many);
    for (k, found) in many.iter().enumerate() {
        assert_eq!(*found, escape(&slot, &peg, translations[k]));
        assert_eq!(found.depth() > 0., relations[k] == Relation::Overlapping);
        assert_eq!(found.contact().is_some(), found.depth() > 0.);
        assert_ne!(found.relation(), Relation::Overlapping);
    }
    let threads = Options::new().threads(3);
    let again = penetration_many(&slot, &peg, &translations, &threads);
    assert_eq!(again, Ok(many));

    assert_eq!(penetration_many(&slot, &peg, &[], &options), Ok(vec![]));
    let nothing = penetration_into(&slot, &peg, &[], &options, &mut []);
    assert_eq!(nothing, Ok(()));
}

#[test]
fn refused() {
    let (unit, options) = (square(1.), Options::new());
    let failed = penetration(&unit, &unit, [0., f64::NAN], &options);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "translations: number 0 ");
    let failed = penetration(&unit, &unit, [0., 0.], &Options::new().tolerance(0.5));
    assert_fails(
        failed,
        GCV_ERR_INVALID_ARGUMENT,
        "options: tolerance is 0.5",
    );

    let start = escape(&unit, &unit, [0.5, 0.]);
    let mut out = [start; 2];
    let translations = [[0., 0.], [f64::INFINITY, 0.]];
    let failed = penetration_into(&unit, &unit, &translations, &options, &mut out);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "translations: number 1 ");
    let failed = penetration_into(&unit, &unit, &translations[..1], &options, &mut out);
    let message = "out: the length is 2, that of translations is 1";
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, message);
    assert_eq!(out, [start; 2]);
}

#[test]
fn out_of_range() {
    let far = 1.7e308;
    let huge = polygon(&[[-far, -far], [far, -far], [far, far], [-far, far]]);
    let translations = [[far, 0.], [0., 0.]];
    let options = Options::new();
    // The place to go to is twice as far away.
    let failed = penetration_many(&huge, &huge, &translations, &options);
    assert_fails(failed, GCV_ERR_RANGE, "translations: number 0: ");
}

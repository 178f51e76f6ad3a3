// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! How far a motion leads.

use gcv::status::*;
use gcv::ContactKind::{EdgeVertex, VertexEdge};
use gcv::{cast, cast_into, cast_many, Impact, Options, Polygon, Relation};

use crate::{assert_fails, frame, polygon, slot, square};

fn impact(a: &Polygon, b: &Polygon, from: [f64; 2], motion: [f64; 2]) -> Impact {
    cast(a, b, from, motion, &Options::new()).unwrap()
}

fn assert_no_hit(a: &Polygon, b: &Polygon, from: [f64; 2], motion: [f64; 2], end: Relation) {
    let found = impact(a, b, from, motion);
    assert!(!found.hit(), "{found:?}");
    assert_eq!(found.time(), 1.);
    assert_eq!(found.position(), [from[0] + motion[0], from[1] + motion[1]]);
    assert_eq!(found.relation(), end);
    assert_eq!(found.contact(), None);
}

#[test]
fn a_hit() {
    let (unit, triangle) = (square(1.), polygon(&[[0., 0.], [2., -1.], [2., 1.]]));
    let found = impact(&unit, &triangle, [5., 0.25], [-8., 0.]);
    assert!(found.hit());
    assert_eq!((found.time(), found.position()), (0.5, [1., 0.25]));
    assert_eq!(found.relation(), Relation::Touching);
    let contact = found.contact().unwrap();
    let kind = EdgeVertex {
        edge_a: 1,
        vertex_b: 0,
    };
    assert_eq!((contact.kind(), contact.gap()), (kind, 0.));
    assert_eq!((contact.on_a(), contact.on_b()), ([1., 0.25], [1., 0.25]));
    assert_eq!(contact.normal(), [1., 0.]);
    let debug = format!(
        "Impact {{ hit: true, time: 0.5, position: [1.0, 0.25], relation: Touching, \
         id: 0, contact: Some({contact:?}) }}"
    );
    assert_eq!(format!("{found:?}"), debug);

    let exchanged = impact(&triangle, &unit, [-5., -0.25], [8., 0.]);
    let kind = VertexEdge {
        vertex_a: 0,
        edge_b: 1,
    };
    assert_eq!(exchanged.contact().unwrap().kind(), kind);
    assert_eq!(exchanged.contact().unwrap().normal(), [-1., 0.]);
}

#[test]
fn no_hit() {
    let unit = square(1.);
    // Past it, along its boundary, up to it, away from it.
    assert_no_hit(&unit, &unit, [-3., 2.], [6., 0.], Relation::Apart);
    assert_no_hit(&unit, &unit, [-3., 1.], [6., 0.], Relation::Apart);
    assert_no_hit(&unit, &unit, [-3., 1.], [3.5, 0.], Relation::Touching);
    assert_no_hit(&unit, &unit, [-3., 0.], [2., 0.], Relation::Touching);
    assert_no_hit(&unit, &unit, [1., 0.], [2., 0.], Relation::Apart);
    assert_no_hit(&unit, &unit, [1., 0.], [0., 0.], Relation::Touching);
    // Through the corner.
    assert_no_hit(&unit, &unit, [-2., 0.], [2., 2.], Relation::Apart);
}

#[test]
fn overlapping_at_the_start() {
    for motion in [[0., 0.], [5., 0.]] {
        let found = impact(&square(4.), &square(1.), [1., 1.], motion);
        assert!(found.hit());
        assert_eq!((found.time(), found.position()), (0., [1., 1.]));
        assert_eq!(found.relation(), Relation::Overlapping);
        assert_eq!(found.contact(), None);
    }
}

#[test]
fn touching_at_the_start() {
    let unit = square(1.);
    let found = impact(&unit, &unit, [1., 0.], [-1., 0.]);
    assert!(found.hit());
    assert_eq!((found.time(), found.position()), (0., [1., 0.]));
    assert_eq!(found.relation(), Relation::Touching);
    assert!(found.contact().is_some());
}

/// The default is as of polygons that touch and do not move.
#[test]
fn without_motion() {
    let right = polygon(&[[1., 0.], [2., 0.], [2., 1.]]);
    let found = impact(&square(1.), &right, [0., 0.], [0., 0.]);
    assert_eq!(found, Impact::default());
}

#[test]
fn in_a_hole() {
    let found = impact(&frame(), &square(2.), [3., 3.], [8., 0.]);
    assert!(found.hit());
    assert_eq!((found.time(), found.position()), (0.5, [7., 3.]));
    let kind = EdgeVertex {
        edge_a: 5,
        vertex_b: 1,
    };
    assert_eq!(found.contact().unwrap().kind(), kind);
    assert_eq!(found.contact().unwrap().normal(), [-1., 0.]);
}

/// It slides along both walls to the ground.
#[test]
fn a_peg_into_a_slot() {
    let found = impact(&slot(), &square(2.), [2., 10.], [0., -16.]);
    assert_eq!((found.time(), found.position()), (0.5, [2., 2.]));
    assert_eq!(found.relation(), Relation::Touching);
    let beside = impact(&slot(), &square(2.), [2.125, 10.], [0., -16.]);
    assert_eq!((beside.time(), beside.position()), (0.25, [2.125, 6.]));
}

/// Two fifths of the way; 0.4 is above them.
#[test]
fn times_are_rounded_down() {
    let found = impact(&slot(), &square(2.), [2., 10.], [0., -20.]);
    assert_eq!(found.time(), 0.4 - f64::EPSILON / 4.);
    assert_eq!(found.position(), [2., 2.]);
}

#[test]
fn many_and_into_a_slice() {
    let (slot, peg, options) = (slot(), square(2.), Options::new());
    let motion = |k: i32| ([f64::from(k % 10), 9.], [f64::from(k / 10) - 4.5, -10.]);
    let (from, motions): (Vec<_>, Vec<_>) = (0..100).map(motion).unzip();
    let many = cast_many(&slot, &peg, &from, &motions, &options).unwrap();
    let mut out = vec![Impact::default(); 100];
    cast_into(&slot, &peg, &from, &motions, &options, &mut out).unwrap();
    assert_eq!(out, many);
    for (k, found) in many.iter().enumerate() {
        assert_eq!(*found, impact(&slot, &peg, from[k], motions[k]));
        assert_eq!(found.contact().is_some(), found.hit());
        assert_eq!(found.time() < 1., found.hit());
    }
    assert!(many.iter().any(Impact::hit) && !many.iter().all(Impact::hit));

    assert_eq!(cast_many(&slot, &peg, &[], &[], &options), Ok(vec![]));
    assert_eq!(cast_into(&slot, &peg, &[], &[], &options, &mut []), Ok(()));
}

#[test]
fn refused() {
    let (unit, options) = (square(1.), Options::new());
    let (here, nowhere) = ([0., 0.], [f64::NAN, 0.]);
    let failed = cast(&unit, &unit, nowhere, here, &options);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "translations: number 0 ");
    let failed = cast_many(&unit, &unit, &[here; 3], &[here, here, nowhere], &options);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "motions: number 2 ");

    let start = impact(&unit, &unit, [7., 0.], [1., 1.]);
    let mut out = [start; 2];
    let failed = cast_into(&unit, &unit, &[here; 2], &[nowhere; 2], &options, &mut out);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "motions: number 0 ");
    let failed = cast_into(&unit, &unit, &[here; 2], &[here], &options, &mut out);
    let message = "motions: the length is 1, that of translations is 2";
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, message);
    let failed = cast_into(&unit, &unit, &[here], &[here], &options, &mut out);
    let message = "out: the length is 2, that of translations is 1";
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, message);
    assert_eq!(out, [start; 2]);
    let failed = cast_many(&unit, &unit, &[], &[here], &options);
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, "motions: ");
}

#[test]
fn out_of_range() {
    let (unit, options, far) = (square(1.), Options::new(), [1.7e308, 0.]);
    let failed = cast_many(&unit, &unit, &[[3., 0.], far], &[[1., 0.], far], &options);
    assert_fails(failed, GCV_ERR_RANGE, "translations: number 1: ");
}

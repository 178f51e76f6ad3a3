// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Questions that are refused.

use gcv::status::*;
use gcv::Relation::{Apart, Touching};
use gcv::{Impact, Options, Scene, Separation};

use crate::{all, assert_fails, on_a_sheet, square, status};

#[test]
fn refused() {
    let (scene, unit, query, options) = (on_a_sheet(), square(1.), all(), Options::new());
    let (bad, start) = ([[1., 1.], [0., f64::NAN]], "positions: number 1 ");
    let mut relations = [Touching; 2];
    let failed = scene.relation_into(&unit, &bad, &query, &options, &mut relations);
    assert_fails(failed, GCV_ERR_NOT_FINITE, start);
    assert_eq!(relations, [Touching; 2]);

    let mut separations = [Separation::default(); 2];
    let failed = scene.distance_into(&unit, &bad, &query, &options, &mut separations);
    assert_fails(failed, GCV_ERR_NOT_FINITE, start);
    assert_eq!(separations, [Separation::default(); 2]);

    let (mut impacts, good) = ([Impact::default(); 2], [[1., 1.]; 2]);
    let failed = scene.cast_into(&unit, &bad, &good, &query, &options, &mut impacts);
    assert_fails(failed, GCV_ERR_NOT_FINITE, start);
    let failed = scene.cast_into(&unit, &good, &bad, &query, &options, &mut impacts);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "motions: number 1 ");
    assert_eq!(impacts, [Impact::default(); 2]);

    let near = |position, distance| scene.near(&unit, position, distance, &query, &options);
    assert_eq!(status(near([f64::INFINITY, 0.], 1.)), GCV_ERR_NOT_FINITE);
    assert_fails(near([0., 0.], f64::NAN), GCV_ERR_NOT_FINITE, "distance");
    assert_fails(
        near([0., 0.], f64::INFINITY),
        GCV_ERR_NOT_FINITE,
        "distance",
    );
    assert_fails(near([0., 0.], -1.), GCV_ERR_INVALID_ARGUMENT, "distance");
}

#[test]
fn lengths_that_differ() {
    let (scene, unit, query, options) = (on_a_sheet(), square(1.), all(), Options::new());
    let (refused, from) = (GCV_ERR_INVALID_ARGUMENT, [[1., 1.]; 2]);
    let start = "out: the length is 1, that of positions is 2";
    let failed = scene.relation_into(&unit, &from, &query, &options, &mut [Apart]);
    assert_fails(failed, refused, start);
    let mut out = [Separation::default()];
    assert_fails(
        scene.distance_into(&unit, &from, &query, &options, &mut out),
        refused,
        start,
    );
    let mut out = [Impact::default()];
    let failed = scene.cast_into(&unit, &from, &from, &query, &options, &mut out);
    assert_fails(failed, refused, start);
    let start = "motions: the length is 1, that of positions is 2";
    let failed = scene.cast_many(&unit, &from, &[[1., 1.]], &query, &options);
    assert_fails(failed, refused, start);
}

#[test]
fn out_of_range() {
    let mut scene = Scene::new();
    scene.add(&square(1.), [-1.7e308, 0.]).unwrap();
    let (unit, options) = (square(1.), Options::new());
    let positions = [[-1.6e308, 0.], [1.7e308, 0.]];
    let failed = scene.distance_many(&unit, &positions, &all(), &options);
    assert_fails(failed, GCV_ERR_RANGE, "positions: number 1: ");
    let relations = scene.relation_many(&unit, &positions, &all(), &options);
    assert_eq!(relations, Ok(vec![Apart; 2]));
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Best positions, and ways out of overlaps.

use gcv::status::*;
use gcv::Relation::{self, Apart, Overlapping, Touching};
use gcv::{Escape, Options, Polygon, Query, Scene};

use crate::{all, assert_fails, on_a_sheet, polygon, sheet, square, squares, status};

fn rectangle(width: f64, height: f64) -> Polygon {
    polygon(&[[0., 0.], [width, 0.], [width, height], [0., height]])
}

fn best(scene: &Scene, moving: &Polygon, direction: [f64; 2]) -> Option<[f64; 2]> {
    let found = scene.best(moving, direction, &all(), &Options::new());
    found.unwrap()
}

fn escape(scene: &Scene, moving: &Polygon, position: [f64; 2]) -> Escape {
    let found = scene.penetration(moving, position, &all(), &Options::new());
    found.unwrap()
}

#[test]
fn furthest_in_a_direction() {
    // A solid block in the middle, and squares in two corners.
    let (scene, unit) = (on_a_sheet(), square(1.));
    for (direction, expected) in [
        ([-1., 0.], [0., 1.]),
        ([1., 0.], [9., 0.]),
        ([0., -1.], [1., 0.]),
        ([0., 1.], [0., 9.]),
        ([-1., 1.], [0., 9.]),
        // Two of them are as far: the lexicographically smaller one.
        ([1., 1.], [8., 9.]),
        ([-1., -1.], [0., 1.]),
        // Only the direction counts.
        ([-1e-300, 0.], [0., 1.]),
        ([3e300, -1e300], [9., 0.]),
        ([5e-324, 5e-324], [8., 9.]),
    ] {
        assert_eq!(
            best(&scene, &unit, direction),
            Some(expected),
            "{direction:?}"
        );
    }
    // As wide as the room on each side of the block.
    assert_eq!(best(&scene, &square(4.), [-1., 0.]), Some([0., 1.]));
    assert_eq!(best(&scene, &square(4.), [1., -1.]), Some([6., 0.]));
}

#[test]
fn bottom_left_nesting() {
    let (mut scene, part) = (Scene::new(), rectangle(2., 3.));
    scene.set_container(Some(&rectangle(5., 7.))).unwrap();
    let mut places = vec![];
    while let Some(place) = best(&scene, &part, [-1., 0.]) {
        scene.add(&part, place).unwrap();
        places.push(place);
    }
    assert_eq!(places, [[0., 0.], [0., 3.], [2., 0.], [2., 3.]]);
}

#[test]
fn nowhere() {
    let mut scene = on_a_sheet();
    assert_eq!(best(&scene, &square(5.), [1., 0.]), None);
    assert_eq!(best(&scene, &square(10.), [1., 0.]), None);
    // Just one place is left, then none.
    scene.set_container(Some(&square(2.))).unwrap();
    scene
        .add_many(&[&square(1.); 2], &[[1., 0.], [0., 1.]])
        .unwrap();
    assert_eq!(best(&scene, &square(1.), [-1., 0.]), Some([1., 1.]));
    scene.add(&square(1.), [1., 1.]).unwrap();
    assert_eq!(best(&scene, &square(1.), [-1., 0.]), None);
}

/// In a slot that is just as wide as the part.
#[test]
fn in_fits() {
    let mut scene = squares(&[[0., 0.], [2., 0.]]);
    scene.set_container(Some(&rectangle(3., 3.))).unwrap();
    let unit = square(1.);
    let lowest = |options| scene.best(&unit, [0., -1.], &all(), &options);
    assert_eq!(lowest(Options::new()), Ok(Some([1., 0.])));
    let without_fits = Options::new().leave_out_fits(true);
    assert_eq!(lowest(without_fits), Ok(Some([0., 1.])));
}

/// The exact position is in no doubles.
#[test]
fn positions_are_free() {
    let mut scene = Scene::new();
    let container = polygon(&[[0., 0.], [3., 1.], [4., 7.], [-1., 5.]]);
    scene.set_container(Some(&container)).unwrap();
    let moving = polygon(&[[0., 0.], [1., 0.3], [0.1, 0.9]]);
    for k in 0..64 {
        let angle = f64::from(k) / 10.;
        let direction = [angle.cos(), angle.sin()];
        let place = best(&scene, &moving, direction).unwrap();
        let relation = scene.relation(&moving, place, &all(), &Options::new());
        assert_ne!(relation, Ok(Overlapping), "{direction:?}");
        let region = scene.free_region(&moving, None, &all(), &Options::new());
        let along = |[x, y]: [f64; 2]| x * direction[0] + y * direction[1];
        let vertices = region.unwrap().vertices().into_iter();
        let furthest = vertices.map(along).fold(f64::NEG_INFINITY, f64::max);
        assert!((along(place) - furthest).abs() < 1e-14, "{direction:?}");
    }
}

#[test]
fn which_members() {
    let (scene, unit) = (on_a_sheet(), square(1.));
    let best = |query: Query| scene.best(&unit, [-1., -1.], &query, &Options::new());
    assert_eq!(best(all().ignore(&[2])), Ok(Some([0., 0.])));
    assert_eq!(best(all().ignore(&[3, 9])), Ok(Some([0., 1.])));
    let refused = GCV_ERR_INVALID_ARGUMENT;
    for query in [all().layers(0), all().ignore(&[Scene::CONTAINER])] {
        assert_eq!(status(best(query)), refused);
    }
    let found = squares(&[]).best(&unit, [1., 0.], &all(), &Options::new());
    assert_eq!(status(found), refused);
}

#[test]
fn directions_that_are_refused() {
    let (scene, unit) = (on_a_sheet(), square(1.));
    let best = |direction| scene.best(&unit, direction, &all(), &Options::new());
    assert_fails(best([0., -0.]), GCV_ERR_INVALID_ARGUMENT, "direction");
    assert_fails(best([f64::NAN, 0.]), GCV_ERR_NOT_FINITE, "direction");
    assert_fails(best([0., f64::INFINITY]), GCV_ERR_NOT_FINITE, "direction");
}

#[test]
fn out_of_one_member() {
    let scene = squares(&[[0., 0.], [9., 0.]]);
    let found = escape(&scene, &square(2.), [8., 0.5]);
    assert_eq!((found.depth(), found.translation()), (0.5, [0., 0.5]));
    assert_eq!((found.id(), found.position()), (3, [8., 1.]));
    assert_eq!(found.relation(), Touching);
    let contact = found.contact().unwrap();
    assert_eq!((contact.id_a(), contact.id_b(), contact.gap()), (3, 0, 0.));
    assert_eq!(contact.normal(), [0., 1.]);
    let debug = format!("{found:?}");
    let end = format!("relation: Touching, id: 3, contact: Some({contact:?}) }}");
    assert!(debug.ends_with(&end), "{debug}");
}

#[test]
fn out_of_all_at_once() {
    // A shorter way out of each one leads into the other one.
    let scene = squares(&[[0., 0.], [1.5, 0.]]);
    let found = escape(&scene, &square(1.), [0.75, 0.25]);
    assert_eq!((found.depth(), found.position()), (0.75, [0.75, 1.]));
    assert_eq!(found.id(), 2);
    // Into the container, and out of a member.
    let mut scene = squares(&[[0., 0.]]);
    scene.set_container(Some(&square(9.))).unwrap();
    let found = escape(&scene, &square(1.), [-4., 0.]);
    assert_eq!((found.depth(), found.position()), (17f64.sqrt(), [0., 1.]));
    assert_eq!(found.id(), Scene::CONTAINER);
    let found = escape(&scene, &square(1.), [10., 12.]);
    assert_eq!((found.depth(), found.position()), (20f64.sqrt(), [8., 8.]));
    assert_eq!(found.id(), Scene::CONTAINER);
}

/// Between two members there is just the room.
#[test]
fn into_fits() {
    let (scene, unit) = (squares(&[[2., 0.], [0., 0.]]), square(1.));
    let from = [1.25, 0.125];
    let found = escape(&scene, &unit, from);
    assert_eq!((found.translation(), found.id()), ([-0.25, 0.], 2));
    let options = Options::new().leave_out_fits(true);
    let found = scene.penetration(&unit, from, &all(), &options).unwrap();
    assert_eq!((found.depth(), found.position()), (0.875, [1.25, 1.]));
}

#[test]
fn free_already() {
    let (scene, unit) = (on_a_sheet(), square(1.));
    for (position, relation) in [([1., 0.5], Touching), ([2., 2.], Apart)] {
        let found = escape(&scene, &unit, position);
        assert_eq!((found.depth(), found.translation()), (0., [0., 0.]));
        assert_eq!((found.position(), found.relation()), (position, relation));
        assert_eq!(found.contact(), None);
    }
    let found = escape(&Scene::new(), &unit, [3., 4.]);
    assert_eq!((found.depth(), found.position()), (0., [3., 4.]));
    assert_eq!((found.id(), found.relation()), (0, Apart));
}

#[test]
fn no_way_out() {
    let found = escape(&on_a_sheet(), &square(5.), [1., 2.]);
    assert_eq!(
        (found.depth(), found.translation()),
        (f64::INFINITY, [0., 0.])
    );
    assert_eq!(
        (found.position(), found.relation()),
        ([1., 2.], Overlapping)
    );
    assert_eq!((found.id(), found.contact()), (0, None));
}

#[test]
fn ways_out_of_which_members() {
    let (scene, unit) = (on_a_sheet(), square(1.));
    let escape = |query: Query| {
        let found = scene.penetration(&unit, [0.25, 0.5], &query, &Options::new());
        let found = found.unwrap();
        (found.depth(), found.id())
    };
    assert_eq!(escape(all()), (0.5, 2));
    assert_eq!(escape(all().ignore(&[2])), (0., 0));
    // Without the ground there is a way below.
    assert_eq!(escape(all().ignore(&[1])), (0.5, 2));
    assert_eq!(escape(all().layers(0)), (0., 0));
}

#[test]
fn slices_and_single_ones() {
    let (scene, unit, query) = (on_a_sheet(), square(1.), all());
    let from: Vec<_> = (0..400)
        .map(|k| [f64::from(k % 20) * 0.75 - 2., f64::from(k / 20) * 0.75 - 2.])
        .collect();
    let options = Options::new();
    let many = scene
        .penetration_many(&unit, &from, &query, &options)
        .unwrap();
    let mut into = vec![Escape::default(); 400];
    scene
        .penetration_into(&unit, &from, &query, &options, &mut into)
        .unwrap();
    assert_eq!(into, many);
    let relations = scene.relation_many(&unit, &from, &query, &options).unwrap();
    for k in 0..400 {
        assert_eq!(many[k], escape(&scene, &unit, from[k]));
        assert_eq!(many[k].depth() > 0., relations[k] == Overlapping);
        assert_ne!(many[k].relation(), Overlapping);
    }
    let nothing = scene.penetration_many(&unit, &[], &query, &options);
    assert_eq!(nothing, Ok(vec![]));
}

#[test]
fn ways_that_are_refused() {
    let (scene, unit, query, options) = (on_a_sheet(), square(1.), all(), Options::new());
    let start = escape(&scene, &unit, [0.5, 0.]);
    let mut out = [start; 2];
    let bad = [[1., 1.], [0., f64::NAN]];
    let failed = scene.penetration_into(&unit, &bad, &query, &options, &mut out);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "positions: number 1 ");
    let failed = scene.penetration_into(&unit, &bad[..1], &query, &options, &mut out);
    let message = "out: the length is 2, that of positions is 1";
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, message);
    assert_eq!(out, [start; 2]);
}

#[test]
fn in_holes_of_a_container() {
    let mut scene = Scene::new();
    scene.set_container(Some(&sheet())).unwrap();
    let found = escape(&scene, &square(1.), [4.25, 4.5]);
    assert_eq!((found.depth(), found.position()), (1.25, [3., 4.5]));
    assert_eq!((found.id(), found.relation()), (1, Relation::Touching));
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What is in a scene, and how that changes.

use gcv::status::*;
use gcv::{Options, Polygon, Relation, Scene};

use crate::{all, assert_fails, polygon, sheet, square, squares, status};

/// What there is to see of a scene.
fn state(scene: &Scene) -> Vec<(u64, [f64; 2], Polygon)> {
    let ids = scene.ids();
    let positions = scene.positions(&ids).unwrap();
    let members = ids.iter().zip(positions);
    members
        .map(|(&id, position)| (id, position, scene.polygon(id).unwrap()))
        .collect()
}

/// Asserts that a change fails with this status and a message that begins so, and changes
/// nothing.
fn assert_refused<T>(
    scene: &mut Scene,
    expected: i32,
    start: &str,
    change: impl FnOnce(&mut Scene) -> Result<T, gcv::Error>,
) {
    let before = state(scene);
    assert_fails(change(scene), expected, start);
    assert_eq!(state(scene), before);
}

#[test]
fn empty() {
    let scene = Scene::default();
    assert!(scene.is_empty());
    assert_eq!((scene.len(), scene.ids()), (0, vec![]));
    assert_eq!(scene.positions(&[]), Ok(vec![]));
    assert_eq!(format!("{scene:?}"), "Scene { ids: [], positions: [] }");
}

#[test]
fn ids_count_from_two() {
    let (unit, large, mut scene) = (square(1.), square(5.), Scene::new());
    assert_eq!(scene.add(&unit, [3., 4.]), Ok(2));
    let positions = [[5., 6.], [7., 8.], [5., 6.]];
    let added = scene.add_many(&[&large, &unit, &large], &positions);
    assert_eq!(added, Ok(vec![3, 4, 5]));
    assert_eq!(scene.add_many(&[], &[]), Ok(vec![]));
    assert!(!scene.is_empty());
    assert_eq!((scene.len(), scene.ids()), (4, vec![2, 3, 4, 5]));
    let found = scene.positions(&[4, 2, 5]);
    assert_eq!(found, Ok(vec![[7., 8.], [3., 4.], [5., 6.]]));
    assert_eq!(scene.polygon(3), Ok(large));
    assert_eq!(scene.polygon(4), Ok(unit));
}

#[test]
fn ids_are_never_used_again() {
    let mut scene = squares(&[[0., 0.]; 3]);
    scene.remove(&[4, 2]).unwrap();
    assert_eq!(scene.ids(), [3]);
    assert_eq!(scene.add(&square(1.), [0., 0.]), Ok(5));
    scene.remove(&[3, 5]).unwrap();
    assert!(scene.is_empty());
    assert_eq!(scene.add(&square(1.), [0., 0.]), Ok(6));
}

#[test]
fn moved_and_reshaped() {
    let mut scene = squares(&[[0., 0.], [1., 0.], [2., 0.]]);
    let (unit, large) = (square(1.), square(5.));
    scene.set_positions(&[4, 2], &[[9., 0.], [8., 0.]]).unwrap();
    scene.set_polygons(&[3], &[&large]).unwrap();
    let expected = [
        (2, [8., 0.], unit.clone()),
        (3, [1., 0.], large.clone()),
        (4, [9., 0.], unit.clone()),
    ];
    assert_eq!(state(&scene), expected);
    let polygons = [&unit, &large];
    scene
        .set(&[3, 2], &polygons, &[[7., 7.], [6., 6.]])
        .unwrap();
    let expected = [
        (2, [6., 6.], large),
        (3, [7., 7.], unit.clone()),
        (4, [9., 0.], unit),
    ];
    assert_eq!(state(&scene), expected);
}

#[test]
fn of_none() {
    let mut scene = squares(&[[0., 0.]]);
    let before = state(&scene);
    assert_eq!(scene.set(&[], &[], &[]), Ok(()));
    assert_eq!(scene.set_positions(&[], &[]), Ok(()));
    assert_eq!(scene.set_polygons(&[], &[]), Ok(()));
    assert_eq!(scene.set_layers(&[], &[]), Ok(()));
    assert_eq!(scene.remove(&[]), Ok(()));
    assert_eq!(state(&scene), before);
}

/// A scene keeps what it needs of polygons.
#[test]
fn polygons_may_go() {
    let mut scene = Scene::new();
    {
        let triangle = polygon(&[[0., 0.], [4., 0.], [0., 4.]]);
        scene.add(&triangle, [1., 1.]).unwrap();
        scene.set_container(Some(&sheet())).unwrap();
    }
    let relation = |position| scene.relation(&square(1.), position, &all(), &Options::new());
    assert_eq!(relation([3., 3.]), Ok(Relation::Touching));
    assert_eq!(relation([2., 2.]), Ok(Relation::Overlapping));
    assert_eq!(relation([9.5, 2.]), Ok(Relation::Overlapping));
    let vertices = scene.polygon(2).unwrap().vertices();
    assert_eq!(vertices, [[0., 0.], [4., 0.], [0., 4.]]);
    drop(scene);
}

#[test]
fn a_polygon_outlives_the_scene() {
    let scene = squares(&[[0., 0.]]);
    let found = scene.polygon(2).unwrap();
    drop(scene);
    assert_eq!(found, square(1.));
}

#[test]
fn containers() {
    let (mut scene, unit) = (Scene::new(), square(1.));
    let relation = |scene: &Scene| scene.relation(&unit, [8.5, 1.], &all(), &Options::new());
    assert_eq!(relation(&scene), Ok(Relation::Apart));
    scene.set_container(Some(&square(9.))).unwrap();
    assert_eq!(relation(&scene), Ok(Relation::Overlapping));
    scene.set_container(Some(&square(9.5))).unwrap();
    assert_eq!(relation(&scene), Ok(Relation::Touching));
    // It is no member.
    assert!(scene.is_empty() && scene.ids().is_empty());
    assert_eq!(scene.add(&unit, [0., 0.]), Ok(2));
    scene.set_container(None).unwrap();
    assert_eq!(relation(&scene), Ok(Relation::Apart));
    scene.set_container(None).unwrap();
}

#[test]
fn copies_change_alone() {
    let mut scene = squares(&[[0., 0.], [5., 0.]]);
    scene.set_container(Some(&square(10.))).unwrap();
    scene.set_layers(&[3], &[0b100]).unwrap();
    let mut copy = scene.clone();
    assert_eq!(state(&copy), state(&scene));

    copy.set_positions(&[2], &[[1., 1.]]).unwrap();
    copy.set_container(None).unwrap();
    scene.remove(&[3]).unwrap();
    assert_eq!(scene.positions(&[2]), Ok(vec![[0., 0.]]));
    assert_eq!(copy.ids(), [2, 3]);
    let relation = |scene: &Scene, position| {
        let query = all().layers(0b100);
        scene.relation(&square(1.), position, &query, &Options::new())
    };
    assert_eq!(relation(&copy, [5., 0.]), Ok(Relation::Overlapping));
    assert_eq!(relation(&copy, [9.5, 5.]), Ok(Relation::Apart));
    assert_eq!(relation(&scene, [5., 0.]), Ok(Relation::Touching));
    assert_eq!(relation(&scene, [9.5, 5.]), Ok(Relation::Overlapping));

    // What is added to both has the same id.
    assert_eq!(scene.add(&square(2.), [0., 0.]), Ok(4));
    assert_eq!(copy.add(&square(3.), [0., 0.]), Ok(4));
    drop(scene);
    assert_eq!(copy.polygon(4), Ok(square(3.)));
    assert_eq!(copy.try_clone().unwrap().ids(), [2, 3, 4]);
}

#[test]
fn unknown_ids() {
    let (mut scene, unit) = (squares(&[[0., 0.], [1., 0.], [2., 0.]]), square(1.));
    scene.set_container(Some(&sheet())).unwrap();
    scene.remove(&[3]).unwrap();
    let (refused, far) = (GCV_ERR_INVALID_ARGUMENT, [99., 99.]);
    for id in [0, Scene::CONTAINER, 3, 5, u64::MAX] {
        let (ids, units, fars) = ([2, id], [&unit; 2], [far; 2]);
        let start = format!("ids: number 1 is {id}");
        let scene = &mut scene;
        assert_refused(scene, refused, &start, |scene| {
            scene.set(&ids, &units, &fars)
        });
        assert_refused(scene, refused, &start, |scene| {
            scene.set_positions(&ids, &fars)
        });
        assert_refused(scene, refused, &start, |scene| {
            scene.set_polygons(&ids, &units)
        });
        assert_refused(scene, refused, &start, |scene| {
            scene.set_layers(&ids, &[0; 2])
        });
        assert_refused(scene, refused, &start, |scene| scene.remove(&ids));
        assert_fails(scene.positions(&ids), refused, &start);
        assert_eq!(status(scene.polygon(id)), refused);
    }
    let relation = scene.relation(&unit, [0., 0.], &all(), &Options::new());
    assert_eq!(relation, Ok(Relation::Overlapping));
}

#[test]
fn ids_that_are_given_twice() {
    let (mut scene, unit) = (squares(&[[0., 0.], [1., 0.]]), square(1.));
    let (refused, far, ids) = (GCV_ERR_INVALID_ARGUMENT, [[99., 99.]; 3], [2, 3, 2]);
    let (scene, units, start) = (&mut scene, [&unit; 3], "ids: ");
    assert_refused(scene, refused, start, |scene| scene.set(&ids, &units, &far));
    assert_refused(scene, refused, start, |scene| {
        scene.set_positions(&ids, &far)
    });
    assert_refused(scene, refused, start, |scene| {
        scene.set_polygons(&ids, &units)
    });
    assert_refused(scene, refused, start, |scene| {
        scene.set_layers(&ids, &[0; 3])
    });
    assert_refused(scene, refused, start, |scene| scene.remove(&ids));
    assert_fails(scene.positions(&ids), refused, start);
}

#[test]
fn positions_that_are_not_finite() {
    let (mut scene, unit) = (squares(&[[0., 0.], [1., 0.]]), square(1.));
    let start = "positions: number 1 ";
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (scene, positions, units) = (&mut scene, [[0., 0.], [3., bad]], [&unit; 2]);
        assert_refused(scene, GCV_ERR_NOT_FINITE, start, |scene| {
            scene.add_many(&units, &positions)
        });
        assert_refused(scene, GCV_ERR_NOT_FINITE, start, |scene| {
            scene.set(&[3, 2], &units, &positions)
        });
        assert_refused(scene, GCV_ERR_NOT_FINITE, start, |scene| {
            scene.set_positions(&[3, 2], &positions)
        });
        assert_refused(scene, GCV_ERR_NOT_FINITE, "positions: number 0 ", |scene| {
            scene.add(&unit, [bad, 0.])
        });
    }
    // Failures take no ids.
    assert_eq!(scene.add(&unit, [0., 0.]), Ok(4));
}

#[test]
fn lengths_that_differ() {
    let (mut scene, unit) = (squares(&[[0., 0.], [1., 0.]]), square(1.));
    let (scene, refused, far) = (&mut scene, GCV_ERR_INVALID_ARGUMENT, [99., 99.]);
    let start = "positions: the length is 1, that of polygons is 2";
    assert_refused(scene, refused, start, |scene| {
        scene.add_many(&[&unit; 2], &[far])
    });
    let start = "positions: the length is 1, that of ids is 2";
    assert_refused(scene, refused, start, |scene| {
        scene.set_positions(&[2, 3], &[far])
    });
    assert_refused(scene, refused, start, |scene| {
        scene.set(&[2, 3], &[&unit; 2], &[far])
    });
    let start = "polygons: the length is 0, that of ids is 1";
    assert_refused(scene, refused, start, |scene| scene.set(&[2], &[], &[far]));
    assert_refused(scene, refused, start, |scene| scene.set_polygons(&[2], &[]));
    let start = "layers: the length is 2, that of ids is 1";
    assert_refused(scene, refused, start, |scene| {
        scene.set_layers(&[2], &[1; 2])
    });
}

#[test]
fn debug() {
    let scene = squares(&[[0., 0.], [1., 2.5]]);
    let debug = "Scene { ids: [2, 3], positions: [[0.0, 0.0], [1.0, 2.5]] }";
    assert_eq!(format!("{scene:?}"), debug);
}

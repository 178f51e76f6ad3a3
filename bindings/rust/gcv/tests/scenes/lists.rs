// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Lists of pairs and of contacts, and what an earlier list changes.

use gcv::status::*;
use gcv::ContactKind::{EdgeVertex, VertexEdge, VertexVertex};
use gcv::Relation::{Apart, Overlapping, Touching};
use gcv::{contacts, ContactList, Options, PairList, Query, Scene};

use crate::{all, assert_fails, name, pairs, sheet, square, squares, status};

fn pairs_of(scene: &Scene, previous: Option<&PairList>, distance: f64) -> PairList {
    let list = scene.pairs(previous, distance, &all(), &Options::new());
    list.unwrap()
}

fn contacts_of(scene: &Scene, previous: Option<&ContactList>, distance: f64) -> ContactList {
    let list = scene.contacts(previous, distance, 0., &all(), &Options::new());
    list.unwrap()
}

/// Asserts that these earlier lists change nothing, but for what tells where contacts were.
fn assert_previous(scene: &Scene, pairs: &PairList, contacts: &ContactList, distance: f64) {
    let found = pairs_of(scene, Some(pairs), distance);
    assert_eq!(found, pairs_of(scene, None, distance));
    let found = contacts_of(scene, Some(contacts), distance);
    assert_eq!(*found, *contacts_of(scene, None, distance));
    assert_eq!(found.previous().len(), found.len());
    for (contact, previous) in found.iter().zip(found.previous()) {
        let same = contacts.iter().position(|old| name(old) == name(contact));
        assert_eq!(*previous, same, "{contact:?}");
    }
}

#[test]
fn pairs_by_hand() {
    let mut scene = squares(&[[0., 0.], [1., 0.], [1.5, 0.5], [4., 0.]]);
    let touching = [(2, 3, Touching), (3, 4, Overlapping)];
    assert_eq!(pairs(&pairs_of(&scene, None, 0.)), touching);
    let near = [(2, 3, Touching), (2, 4, Apart), (3, 4, Overlapping)];
    assert_eq!(pairs(&pairs_of(&scene, None, 0.5)), near);
    assert_eq!(pairs_of(&scene, None, 1e308).len(), 6);

    scene.set_container(Some(&sheet())).unwrap();
    let bounded = [
        (1, 2, Touching),
        (1, 3, Touching),
        (1, 5, Touching),
        (2, 3, Touching),
        (3, 4, Overlapping),
    ];
    assert_eq!(pairs(&pairs_of(&scene, None, 0.)), bounded);
    scene.set_positions(&[5], &[[9.5, 5.]]).unwrap();
    assert_eq!(pairs(&pairs_of(&scene, None, 0.))[2], (1, 5, Overlapping));
}

#[test]
fn of_few_members() {
    let mut scene = Scene::new();
    assert!(pairs_of(&scene, None, 1.).is_empty());
    assert!(contacts_of(&scene, None, 1.).is_empty());
    scene.set_container(Some(&sheet())).unwrap();
    assert!(pairs_of(&scene, None, 1.).is_empty());
    scene.set_container(None).unwrap();
    scene.add(&square(1.), [0., 0.]).unwrap();
    assert!(pairs_of(&scene, None, 1.).is_empty());
    assert!(contacts_of(&scene, None, 1.).is_empty());
}

/// The lower one carries two that touch each other.
#[test]
fn contacts_by_hand() {
    let mut scene = Scene::new();
    let below = scene.add(&square(4.), [0., 0.]).unwrap();
    let left = scene.add(&square(2.), [0., 4.]).unwrap();
    let upper = scene.add(&square(2.), [2., 4.25]).unwrap();
    let found = contacts_of(&scene, None, 0.);
    let left_end = VertexVertex {
        vertex_a: 3,
        vertex_b: 0,
    };
    assert!(found.iter().all(|contact| contact.gap() == 0.));
    let names: Vec<_> = found.iter().map(name).collect();
    assert!(names.contains(&(below, left, left_end)), "{names:?}");
    assert!(!names.iter().any(|name| name.0 == below && name.1 == upper));

    let found = contacts_of(&scene, None, 0.25);
    let vertex = EdgeVertex {
        edge_a: 2,
        vertex_b: 0,
    };
    let contact = found
        .iter()
        .find(|found| name(found) == (below, upper, vertex));
    let contact = contact.unwrap();
    assert_eq!((contact.gap(), contact.normal()), (0.25, [0., 1.]));
    assert_eq!((contact.on_a(), contact.on_b()), ([2., 4.], [2., 4.25]));
    let side = VertexEdge {
        vertex_a: 2,
        edge_b: 3,
    };
    let contact = found
        .iter()
        .find(|found| name(found) == (left, upper, side));
    assert_eq!(contact.unwrap().normal(), [1., 0.]);
    assert_eq!(contact.unwrap().on_b(), [2., 6.]);
}

/// A list of two members is that of the pair function, but for the ids.
#[test]
fn contacts_of_a_pair() {
    let scene = squares(&[[0., 0.], [0.75, 0.5]]);
    let found = contacts_of(&scene, None, 1.);
    let unit = square(1.);
    let expected = contacts(&unit, &unit, [0.75, 0.5], 1., 0., &Options::new()).unwrap();
    assert!(expected.len() > 4);
    assert_eq!(found.len(), expected.len());
    for (contact, expected) in found.iter().zip(&expected) {
        assert_eq!(name(contact), (2, 3, expected.kind()));
        assert_eq!(contact.gap(), expected.gap());
        assert_eq!(contact.normal(), expected.normal());
        assert_eq!(contact.on_a(), expected.on_a());
        assert_eq!(contact.on_b(), expected.on_b());
    }
    assert!(found.previous().iter().all(Option::is_none));
}

/// The container's edges are numbered as passed, and face inwards.
#[test]
fn contacts_with_a_container() {
    let mut scene = squares(&[[3., 1.]]);
    scene.set_container(Some(&sheet())).unwrap();
    let found = contacts_of(&scene, None, 1.);
    let bottom = EdgeVertex {
        edge_a: 0,
        vertex_b: 0,
    };
    let contact = found.iter().find(|found| name(found) == (1, 2, bottom));
    assert_eq!(
        (contact.unwrap().gap(), contact.unwrap().normal()),
        (1., [0., 1.])
    );
    assert_eq!(contact.unwrap().on_a(), [3., 0.]);

    scene.set_positions(&[2], &[[4.5, 3.]]).unwrap();
    let found = contacts_of(&scene, None, 0.);
    // The lower edge of the block is edge 4 of the sheet.
    let block = EdgeVertex {
        edge_a: 4,
        vertex_b: 2,
    };
    let contact = found.iter().find(|found| name(found) == (1, 2, block));
    assert_eq!(contact.unwrap().normal(), [0., -1.]);
    assert_eq!(contact.unwrap().on_a(), [5.5, 4.]);
}

#[test]
fn previous_lists() {
    let positions: Vec<_> = (0..49)
        .map(|k| [f64::from(k % 7), f64::from(k / 7)])
        .collect();
    let mut scene = squares(&positions);
    scene.set_container(Some(&square(9.))).unwrap();
    let distance = 0.25;
    let (mut pairs, mut contacts) = (
        pairs_of(&scene, None, distance),
        contacts_of(&scene, None, distance),
    );
    assert_eq!(contacts.previous(), vec![None; contacts.len()]);
    let unmoved: Vec<_> = (0..contacts.len()).map(Some).collect();
    assert_eq!(
        contacts_of(&scene, Some(&contacts), distance).previous(),
        unmoved
    );

    for step in 0..12 {
        match step {
            0 => scene.set_positions(&[7, 30], &[[5.5, 0.25], [20., 20.]]),
            1 => scene.set_positions(&[30], &[[2., 4.]]),
            2 => scene.set_polygons(&[12], &[&square(1.5)]),
            3 => scene.remove(&[2, 25, 26]),
            4 => scene.add(&square(2.), [6.75, 6.75]).map(|_| ()),
            5 => scene.set_container(Some(&sheet())),
            6 => scene.set_container(None),
            7 => scene.set(&[12, 13], &[&square(1.); 2], &[[4., 2.], [3., 2.]]),
            8 => scene.set_container(Some(&square(7.))),
            9 => scene.set_layers(&[9], &[0]),
            10 => scene.set_layers(&[9], &[1]),
            _ => Ok(()),
        }
        .unwrap();
        assert_previous(&scene, &pairs, &contacts, distance);
        pairs = pairs_of(&scene, Some(&pairs), distance);
        contacts = contacts_of(&scene, Some(&contacts), distance);
    }
}

/// A list of another distance, slope or query is taken, too.
#[test]
fn previous_lists_of_other_questions() {
    let scene = squares(&[[0., 0.], [1., 0.25], [2.25, 0.], [1., 1.25]]);
    let options = Options::new();
    for earlier in [0., 0.25, 1., 9.] {
        for query in [all(), all().ignore(&[3]), all().layers(0)] {
            let pairs = scene.pairs(None, earlier, &query, &options).unwrap();
            for slope in [0., 1.] {
                let contacts = scene.contacts(None, earlier, slope, &query, &options);
                let contacts = contacts.unwrap();
                for distance in [0., 0.25, 1., 9.] {
                    assert_previous(&scene, &pairs, &contacts, distance);
                }
            }
        }
    }
}

/// After many changes, what moved back has not moved.
#[test]
fn lists_that_are_far_back() {
    let mut scene = squares(&[[0., 0.], [1., 0.], [2., 0.]]);
    let (pairs, contacts) = (pairs_of(&scene, None, 0.5), contacts_of(&scene, None, 0.5));
    for k in 0..1000 {
        scene.set_positions(&[3], &[[1., f64::from(k)]]).unwrap();
    }
    assert_previous(&scene, &pairs, &contacts, 0.5);
    scene.set_positions(&[3], &[[1., 0.]]).unwrap();
    assert_previous(&scene, &pairs, &contacts, 0.5);
    let found = contacts_of(&scene, Some(&contacts), 0.5);
    let expected: Vec<_> = (0..contacts.len()).map(Some).collect();
    assert_eq!(
        (found.previous(), &found[..]),
        (&expected[..], &contacts[..])
    );
}

#[test]
fn previous_lists_of_copies() {
    let mut scene = squares(&[[0., 0.], [1., 0.], [2., 0.]]);
    let before = (pairs_of(&scene, None, 0.5), contacts_of(&scene, None, 0.5));
    let mut copy = scene.clone();
    assert_previous(&copy, &before.0, &before.1, 0.5);
    let from_the_copy = (pairs_of(&copy, None, 0.5), contacts_of(&copy, None, 0.5));
    assert_previous(&scene, &from_the_copy.0, &from_the_copy.1, 0.5);

    // The same id, and as many changes, but other members.
    scene.add(&square(1.), [0., 1.]).unwrap();
    copy.add(&square(2.), [2., 1.]).unwrap();
    scene.set_positions(&[2], &[[0., 0.25]]).unwrap();
    copy.set_positions(&[2], &[[0., -0.25]]).unwrap();
    let lists = |scene: &Scene| (pairs_of(scene, None, 0.5), contacts_of(scene, None, 0.5));
    let (of_scene, of_copy) = (lists(&scene), lists(&copy));
    assert_ne!(of_scene.0, of_copy.0);
    assert_previous(&scene, &of_copy.0, &of_copy.1, 0.5);
    assert_previous(&copy, &of_scene.0, &of_scene.1, 0.5);
    // By way of a copy of the copy.
    let second = copy.clone();
    drop(copy);
    assert_previous(&second, &of_scene.0, &of_scene.1, 0.5);
}

/// And lists of other questions.
#[test]
fn lists_of_another_scene() {
    let (scene, other) = (
        squares(&[[0., 0.], [1., 0.]]),
        squares(&[[0., 0.], [1., 0.]]),
    );
    let (pairs, contacts) = (pairs_of(&other, None, 0.), contacts_of(&other, None, 0.));
    drop(other);
    let (query, options) = (all(), Options::new());
    let failed = scene.pairs(Some(&pairs), 0., &query, &options);
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, "previous");
    let failed = scene.contacts(Some(&contacts), 0., 0., &query, &options);
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, "previous");
    let unit = square(1.);
    let near = scene.near(&unit, [1., 0.], 0., &query, &options).unwrap();
    let failed = scene.pairs(Some(&near), 0., &query, &options);
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, "previous");
    let of_no_scene = gcv::contacts(&unit, &unit, [1., 0.], 0., 0., &options).unwrap();
    let failed = scene.contacts(Some(&of_no_scene), 0., 0., &query, &options);
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, "previous");
}

#[test]
fn slices_and_clones() {
    let mut scene = squares(&[[0., 0.], [1., 0.], [2., 0.]]);
    let found = pairs_of(&scene, None, 0.);
    let clone = found.clone();
    assert_eq!(clone, found);
    assert_eq!(clone.as_ptr(), found.as_ptr());
    drop(found);
    assert_eq!((clone.as_ref().len(), (&clone).into_iter().len()), (2, 2));
    let debug =
        "[Pair { a: 2, b: 3, relation: Touching }, Pair { a: 3, b: 4, relation: Touching }]";
    assert_eq!(format!("{clone:?}"), debug);

    let contacts = contacts_of(&scene, None, 0.);
    let debug = format!("{contacts:?}");
    assert!(
        debug.contains(" }, id_a: 2, id_b: 3, gap: 0.0, "),
        "{debug}"
    );
    assert_eq!(contacts.clone(), contacts);
    // The same contacts, but another history.
    assert_ne!(contacts_of(&scene, Some(&contacts), 0.), contacts);

    // Lists do not change with their scene, and outlive it.
    scene.remove(&[2]).unwrap();
    assert_eq!(clone.len(), 2);
    assert_ne!(pairs_of(&scene, None, 0.), clone);
    drop(scene);
    assert_eq!(pairs(&clone), [(2, 3, Touching), (3, 4, Touching)]);
}

#[test]
fn refused() {
    let scene = squares(&[[0., 0.], [1., 0.]]);
    let options = Options::new();
    let pairs = |distance| scene.pairs(None, distance, &Query::new(), &options);
    let contacts = |distance, slope| scene.contacts(None, distance, slope, &all(), &options);
    let (not_finite, invalid) = (GCV_ERR_NOT_FINITE, GCV_ERR_INVALID_ARGUMENT);
    for bad in [f64::NAN, f64::INFINITY] {
        assert_fails(pairs(bad), not_finite, "distance");
        assert_fails(contacts(bad, 0.), not_finite, "distance");
        assert_fails(contacts(0., bad), not_finite, "slope");
    }
    assert_fails(pairs(-1.), invalid, "distance");
    assert_fails(contacts(-1., 0.), invalid, "distance");
    assert_fails(contacts(0., -1.), invalid, "slope");

    let mut scene = squares(&[[-1.7e308, 0.], [1.7e308, 0.]]);
    let contacts = scene.contacts(None, 1.7e308, 0., &all(), &options);
    assert!(contacts.unwrap().is_empty());
    scene.add(&square(1e308), [1e308, 0.]).unwrap();
    let pairs = scene.pairs(None, 0., &all(), &options).unwrap();
    assert_eq!(crate::pairs(&pairs), [(3, 4, Overlapping)]);
    let failed = scene.contacts(None, 0., 0., &all(), &options.clone().tolerance(-1.));
    assert_eq!(status(failed), invalid);
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Which members a question is about.

use gcv::{ContactList, Options, PairList, Query, Relation, Scene};

use crate::{all, pairs, square, squares};

/// Three unit squares in a row that touch one another and the container, in layers 1, 2 and
/// both.
fn row() -> Scene {
    let mut scene = squares(&[[0., 0.], [1., 0.], [2., 0.]]);
    scene.set_layers(&[2, 3, 4], &[0b01, 0b10, 0b11]).unwrap();
    scene.set_container(Some(&square(3.))).unwrap();
    scene
}

fn near(query: Query) -> Vec<u64> {
    let (unit, options) = (square(1.), Options::new());
    let list: PairList = row().near(&unit, [1., 1.], 0.5, &query, &options).unwrap();
    list.iter().map(|pair| pair.a()).collect()
}

fn all_pairs(query: Query) -> Vec<[u64; 2]> {
    let list = row().pairs(None, 0., &query, &Options::new()).unwrap();
    pairs(&list).iter().map(|&(a, b, _)| [a, b]).collect()
}

/// Each pair that has a contact.
fn in_contact(query: Query) -> Vec<[u64; 2]> {
    let options = Options::new();
    let list: ContactList = row().contacts(None, 0., 0., &query, &options).unwrap();
    let mut found: Vec<_> = list
        .iter()
        .map(|contact| [contact.id_a(), contact.id_b()])
        .collect();
    found.dedup();
    found
}

#[test]
fn layers() {
    assert_eq!(near(all()), [2, 3, 4]);
    assert_eq!(near(Query::default()), [2, 3, 4]);
    assert_eq!(near(all().layers(0b01)), [2, 4]);
    assert_eq!(near(all().layers(0b110)), [3, 4]);
    assert_eq!(near(all().layers(0b100)), []);

    let with_container = |query| {
        let list = row().near(&square(1.), [1., 1.], 1., &query, &Options::new());
        list.unwrap()
            .iter()
            .map(|pair| pair.a())
            .collect::<Vec<_>>()
    };
    assert_eq!(with_container(all().layers(0b01)), [1, 2, 4]);
    assert_eq!(with_container(all().layers(1 << 31)), [1]);
    assert_eq!(with_container(all().layers(0)), []);
}

#[test]
fn members_begin_in_every_layer() {
    let scene = squares(&[[0., 0.]]);
    for layer in 0..32 {
        let query = all().layers(1 << layer);
        let relation = scene.relation(&square(1.), [0., 0.], &query, &Options::new());
        assert_eq!(relation, Ok(Relation::Overlapping), "layer {layer}");
    }
}

#[test]
fn ignored() {
    assert_eq!(near(all().ignore(&[3])), [2, 4]);
    // In any order, many times, and what is not there.
    assert_eq!(near(all().ignore(&[77, 4, 0, 2, 4, u64::MAX])), [3]);
    assert_eq!(near(all().ignore(&[])), [2, 3, 4]);
    assert_eq!(near(all().ignore(&[2]).layers(0b01)), [4]);
}

#[test]
fn containers_are_ignored() {
    let (scene, unit, options) = (row(), square(1.), Options::new());
    let relation = |query| scene.relation(&unit, [2.5, 1.5], &query, &options);
    assert_eq!(relation(all()), Ok(Relation::Overlapping));
    let without = all().ignore(&[Scene::CONTAINER]);
    assert_eq!(relation(without), Ok(Relation::Apart));
    assert_eq!(relation(all().layers(0)), Ok(Relation::Apart));
}

#[test]
fn pairs_and_contacts() {
    let expected = [[1, 2], [1, 3], [1, 4], [2, 3], [3, 4]];
    assert_eq!(
        (all_pairs(all()), in_contact(all())),
        (expected.into(), expected.into())
    );
    for (query, expected) in [
        (all().ignore(&[Scene::CONTAINER]), vec![[2, 3], [3, 4]]),
        (all().ignore(&[3]), vec![[1, 2], [1, 4]]),
        (all().layers(0b10), vec![[1, 3], [1, 4], [3, 4]]),
        (all().layers(0b10).ignore(&[1, 4]), vec![]),
        (all().layers(0), vec![]),
    ] {
        assert_eq!(all_pairs(query), expected, "{query:?}");
        assert_eq!(in_contact(query), expected, "{query:?}");
    }
}

#[test]
fn distance_and_cast() {
    let (scene, unit, options) = (row(), square(1.), Options::new());
    let distance = |query| {
        let found = scene.distance(&unit, [1., 1.25], &query, &options).unwrap();
        (found.id(), found.distance(), found.relation())
    };
    assert_eq!(distance(all()), (2, 0.25, Relation::Apart));
    assert_eq!(distance(all().ignore(&[3])), (2, 0.25, Relation::Apart));
    assert_eq!(
        distance(all().ignore(&[2, 3, 4])),
        (1, 0.75, Relation::Apart)
    );
    assert_eq!(
        distance(all().layers(0)),
        (0, f64::INFINITY, Relation::Apart)
    );

    let cast = |query| {
        let found = scene.cast(&unit, [1., 1.25], [0., -10.], &query, &options);
        let found = found.unwrap();
        (found.hit(), found.id(), found.position())
    };
    assert_eq!(cast(all()), (true, 3, [1., 1.]));
    assert_eq!(cast(all().ignore(&[3])), (true, 1, [1., 0.]));
    assert_eq!(cast(all().layers(0)), (false, 0, [1., -8.75]));
}

#[test]
fn values() {
    let query = Query::new().layers(3).ignore(&[2]);
    assert_eq!(format!("{query:?}"), "Query { layers: 3, ignore: [2] }");
    assert_ne!(query, Query::new().layers(3));
    assert_eq!(Query::default(), Query::new().layers(u32::MAX).ignore(&[]));
}

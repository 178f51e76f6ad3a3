// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Scenes; here what the tests of several subjects need.

mod best;
mod brute_force;
mod free;
mod free_brute_force;
mod lists;
mod members;
mod options;
mod puzzles;
mod queries;
mod questions;
mod refusals;

use gcv::{Contact, ContactKind, Error, Pair, PairList, Polygon, Query, Relation, Scene};

fn polygon(vertices: &[[f64; 2]]) -> Polygon {
    Polygon::new(vertices).unwrap()
}

fn square(size: f64) -> Polygon {
    polygon(&[[0., 0.], [size, 0.], [size, size], [0., size]])
}

/// Unit squares at positions. Their ids are 2, 3, 4, ...
fn squares(positions: &[[f64; 2]]) -> Scene {
    let (mut scene, unit) = (Scene::new(), square(1.));
    let polygons = vec![&unit; positions.len()];
    scene.add_many(&polygons, positions).unwrap();
    scene
}

/// A container of size 10 with a solid block from (4, 4) to (6, 6).
fn sheet() -> Polygon {
    let ring = |low, high| [[low, low], [high, low], [high, high], [low, high]];
    Polygon::from_rings([ring(0., 10.), ring(4., 6.)]).unwrap()
}

fn all() -> Query<'static> {
    Query::new()
}

/// The facts of a pair.
fn pair(pair: &Pair) -> (u64, u64, Relation) {
    (pair.a(), pair.b(), pair.relation())
}

fn pairs(list: &PairList) -> Vec<(u64, u64, Relation)> {
    list.iter().map(pair).collect()
}

/// What a contact is named by.
fn name(contact: &Contact) -> (u64, u64, ContactKind) {
    (contact.id_a(), contact.id_b(), contact.kind())
}

fn status<T>(result: Result<T, Error>) -> i32 {
    result.err().unwrap().status
}

/// Asserts that a call failed with this status and a message that begins so.
fn assert_fails<T>(result: Result<T, Error>, status: i32, start: &str) {
    let error = result.err().unwrap();
    assert_eq!(error.status, status, "{error}");
    assert!(error.message.starts_with(start), "{error}");
}

/// The sheet, with unit squares in two of its corners.
fn on_a_sheet() -> Scene {
    let mut scene = squares(&[[0., 0.], [9., 9.]]);
    scene.set_container(Some(&sheet())).unwrap();
    scene
}

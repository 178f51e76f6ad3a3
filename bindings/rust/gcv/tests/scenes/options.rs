// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Threads, progress, cancelling, options that are refused, and scenes that threads share.

use std::ops::ControlFlow::{Break, Continue};
use std::panic::{catch_unwind, AssertUnwindSafe};

use gcv::status::*;
use gcv::{Contact, ContactList, Impact, Options, Pair, PairList, Query, Relation, Scene};
use gcv::{Error, Escape, Region, Separation};

use crate::{all, assert_fails, sheet, square, squares, status};

const COUNT: usize = 2000;

/// Squares in rows that touch and overlap, in a container.
fn crowd() -> Scene {
    let position = |k: i32| [f64::from(k % 20) * 1.25, f64::from(k / 20) * 0.75];
    let mut scene = squares(&(0..400).map(position).collect::<Vec<_>>());
    scene.set_container(Some(&square(25.))).unwrap();
    scene
}

fn positions() -> Vec<[f64; 2]> {
    let position = |k| [(k % 50) as f64 / 2., (k / 50) as f64 / 2.];
    (0..COUNT).map(position).collect()
}

type Answers = (
    Vec<Relation>,
    Vec<Separation>,
    Vec<Impact>,
    PairList,
    PairList,
    ContactList,
    Region,
    Option<[f64; 2]>,
    Vec<Escape>,
);

fn ask(scene: &Scene, options: &Options) -> Result<Answers, Error> {
    let (moving, from, query) = (square(0.25), positions(), all().ignore(&[5]));
    let motions = vec![[3., -5.]; COUNT];
    Ok((
        scene.relation_many(&moving, &from, &query, options)?,
        scene.distance_many(&moving, &from, &query, options)?,
        scene.cast_many(&moving, &from, &motions, &query, options)?,
        scene.near(&moving, [7., 7.], 3., &query, options)?,
        scene.pairs(None, 0.25, &query, options)?,
        scene.contacts(None, 0.25, 0., &query, options)?,
        scene.free_region(&moving, None, &query, options)?,
        scene.best(&moving, [3., -1.], &query, options)?,
        scene.penetration_many(&moving, &from[..COUNT / 20], &query, options)?,
    ))
}

#[test]
fn threads_give_the_same() {
    let scene = crowd();
    let one = ask(&scene, &Options::new()).unwrap();
    assert!(one.4.len() > 400 && one.5.len() > 400);
    // Between the squares there is just the room.
    assert_eq!(one.6.segments().len(), 20);
    assert!(one.7.is_some());
    for threads in [0, 2, 5, usize::MAX] {
        assert!(ask(&scene, &Options::new().threads(threads)).unwrap() == one);
    }
}

/// The first questions, from many threads at once.
#[test]
fn threads_ask_at_once() {
    let scene = crowd();
    let expected = ask(&crowd(), &Options::new()).unwrap();
    std::thread::scope(|scope| {
        let ask = |threads| ask(&scene, &Options::new().threads(threads)).unwrap();
        let asking: Vec<_> = [1, 2, 1, 1]
            .into_iter()
            .map(|threads| scope.spawn(move || ask(threads)))
            .collect();
        // Copies are taken and members are looked at meanwhile.
        let copy = scene.clone();
        assert_eq!(copy.ids(), scene.ids());
        assert_eq!(scene.polygon(7), Ok(square(1.)));
        for thread in asking {
            assert!(thread.join().unwrap() == expected);
        }
    });
}

/// Copies share what is computed for polygons.
#[test]
fn copies_change_while_others_ask() {
    let scene = crowd();
    let expected = ask(&scene, &Options::new()).unwrap();
    let mut copies = [scene.clone(), scene.clone()];
    std::thread::scope(|scope| {
        for copy in &mut copies {
            scope.spawn(move || {
                for id in 2..100 {
                    copy.set_positions(&[id], &[[50., id as f64]]).unwrap();
                    copy.add(&square(1.), [60., id as f64]).unwrap();
                }
                copy.remove(&(2..100).collect::<Vec<_>>()).unwrap();
                copy.set_container(Some(&sheet())).unwrap();
                assert_eq!(copy.len(), 400);
            });
        }
        assert!(ask(&scene, &Options::new()).unwrap() == expected);
    });
    assert_eq!(copies[0].ids(), copies[1].ids());
}

#[test]
fn scenes_and_answers_are_shared() {
    fn shareable<T: Send + Sync + 'static>() {}
    shareable::<Scene>();
    shareable::<PairList>();
    shareable::<ContactList>();
    shareable::<Pair>();
    shareable::<Contact>();
    shareable::<Query<'static>>();

    let scene = squares(&[[0., 0.]]);
    let moved = std::thread::spawn(move || {
        let mut scene = scene;
        scene.add(&square(1.), [1., 0.]).unwrap();
        scene
    });
    assert_eq!(moved.join().unwrap().len(), 2);
}

/// What a question reports: never fewer steps than before, nor more than are estimated.
fn reports<T>(ask: impl FnOnce(&Options) -> Result<T, Error>) -> Vec<(u64, u64)> {
    let mut reports = vec![];
    let options = Options::new().progress(|done, estimate| {
        reports.push((done, estimate));
        Continue(())
    });
    assert!(ask(&options).is_ok());
    drop(options);
    assert!(!reports.is_empty());
    let grows = |pair: &[(u64, u64)]| pair[0].0 <= pair[1].0;
    assert!(reports.windows(2).all(grows), "{reports:?}");
    let below = |report: &(u64, u64)| report.0 <= report.1;
    assert!(reports.iter().all(below), "{reports:?}");
    reports
}

#[test]
fn progress_counts_positions() {
    let (scene, moving, from, query) = (crowd(), square(0.25), positions(), all());
    let distances = reports(|options| scene.distance_many(&moving, &from, &query, options));
    let count = COUNT as u64;
    assert_eq!(distances.last(), Some(&(count, count)));
    let from = &from[..100];
    // Steps of the searches are among them.
    let ways = reports(|options| scene.penetration_many(&moving, from, &query, options));
    let (done, estimate) = ways[ways.len() - 1];
    assert!(done == estimate && done >= 100);
}

#[test]
fn progress_of_lists_and_regions() {
    let (scene, moving, query) = (crowd(), square(0.25), all());
    reports(|options| scene.contacts(None, 0.25, 0., &query, options));
    reports(|options| scene.free_region(&moving, None, &query, options));
    reports(|options| scene.best(&moving, [1., 0.], &query, options));
}

#[test]
fn breaking_cancels() {
    let (scene, moving, from, query) = (crowd(), square(0.25), positions(), all());
    let mut relations = vec![Relation::Apart; COUNT];
    let mut separations = vec![Separation::default(); COUNT];
    let mut impacts = vec![Impact::default(); COUNT];
    let mut escapes = vec![Escape::default(); COUNT];
    for threads in [1, 3] {
        let options = Options::new().progress(|_, _| Break(())).threads(threads);
        let options = &options;
        let failed = scene.relation_into(&moving, &from, &query, options, &mut relations);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = scene.distance_into(&moving, &from, &query, options, &mut separations);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = scene.cast_into(&moving, &from, &from, &query, options, &mut impacts);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = scene.penetration_into(&moving, &from, &query, options, &mut escapes);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = scene.free_region(&moving, None, &query, options);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = scene.best(&moving, [1., 0.], &query, options);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = scene.near(&moving, [7., 7.], 3., &query, options);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = scene.pairs(None, 1., &query, options);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = scene.contacts(None, 1., 0., &query, options);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
    }
    assert!(relations == vec![Relation::Apart; COUNT]);
    assert!(separations == vec![Separation::default(); COUNT]);
    assert!(impacts == vec![Impact::default(); COUNT]);
    assert!(escapes == vec![Escape::default(); COUNT]);
}

#[test]
fn panics_go_on_in_the_caller() {
    let scene = crowd();
    let options = Options::new().progress(|_, _| panic!("out of patience"));
    let ask = AssertUnwindSafe(|| scene.contacts(None, 1., 0., &all(), &options));
    let panic = catch_unwind(ask).unwrap_err();
    assert_eq!(panic.downcast_ref(), Some(&"out of patience"));
    let ask = AssertUnwindSafe(|| scene.relation(&square(1.), [0., 0.], &all(), &options));
    let panic = catch_unwind(ask).unwrap_err();
    assert_eq!(panic.downcast_ref(), Some(&"out of patience"));
    let ask = AssertUnwindSafe(|| scene.free_region(&square(1.), None, &all(), &options));
    let panic = catch_unwind(ask).unwrap_err();
    assert_eq!(panic.downcast_ref(), Some(&"out of patience"));
}

#[test]
fn options_that_are_refused() {
    let (scene, unit, query) = (crowd(), square(1.), all());
    let options = Options::new().tolerance(-1.);
    let (refused, message) = (GCV_ERR_INVALID_ARGUMENT, "options: tolerance is -1");
    let at = [0., 0.];
    assert_fails(
        scene.relation(&unit, at, &query, &options),
        refused,
        message,
    );
    assert_fails(
        scene.distance(&unit, at, &query, &options),
        refused,
        message,
    );
    assert_fails(
        scene.cast(&unit, at, at, &query, &options),
        refused,
        message,
    );
    assert_fails(
        scene.near(&unit, at, 0., &query, &options),
        refused,
        message,
    );
    assert_fails(scene.pairs(None, 0., &query, &options), refused, message);
    assert_fails(
        scene.contacts(None, 0., 0., &query, &options),
        refused,
        message,
    );
}

#[test]
fn options_that_free_positions_refuse() {
    let (scene, unit, query) = (crowd(), square(1.), all());
    for (options, message) in [
        (Options::new().tolerance(0.5), "options: tolerance is 0.5"),
        (
            Options::new().leave_out_holes(true),
            "options: leave_out has GCV_LEAVE_OUT_HOLES",
        ),
    ] {
        let refused = GCV_ERR_INVALID_ARGUMENT;
        let region = scene.free_region(&unit, None, &query, &options);
        assert_fails(region, refused, message);
        let best = scene.best(&unit, [1., 0.], &query, &options);
        assert_fails(best, refused, message);
        let escape = scene.penetration(&unit, [1., 0.], &query, &options);
        assert_fails(escape, refused, message);
    }
}

#[test]
fn without_fits() {
    let (scene, moving) = (crowd(), square(0.25));
    let region = |options: Options| scene.free_region(&moving, None, &all(), &options).unwrap();
    let without = region(Options::new().leave_out_fits(true));
    assert!(without.segments().is_empty() && without.points().is_empty());
    assert_eq!(without.wkt(), region(Options::new()).wkt());
}

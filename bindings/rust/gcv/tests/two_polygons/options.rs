// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Threads, progress, cancelling, and options that are refused.

use std::ops::ControlFlow::{Break, Continue};
use std::panic::{catch_unwind, AssertUnwindSafe};

use gcv::status::*;
use gcv::{cast, cast_into, cast_many, distance, distance_into, distance_many};
use gcv::{relation, relation_into, relation_many, Impact, Options, Relation, Separation};

use crate::{assert_fails, frame, slot, square, status};

const COUNT: usize = 2000;

/// Translations round the slot and in it.
fn translations() -> Vec<[f64; 2]> {
    let quarters = |k: usize| k as f64 / 4. - 4.;
    let translation = |k| [quarters(k % 50), quarters(k / 50)];
    (0..COUNT).map(translation).collect()
}

#[test]
fn threads_give_the_same() {
    let (slot, peg, from) = (slot(), square(2.), translations());
    let motions = vec![[3., -5.]; COUNT];
    let answers = |threads| {
        let options = Options::new().threads(threads);
        (
            relation_many(&slot, &peg, &from, &options).unwrap(),
            distance_many(&slot, &peg, &from, &options).unwrap(),
            cast_many(&slot, &peg, &from, &motions, &options).unwrap(),
        )
    };
    let one = answers(1);
    for threads in [0, 2, 5, usize::MAX] {
        assert!(answers(threads) == one);
    }
}

/// The first questions to polygons, from two threads at once.
#[test]
fn polygons_are_shared() {
    let (frame, square) = (frame(), square(2.));
    std::thread::scope(|scope| {
        let ask = || {
            let options = Options::new();
            let relation = relation(&frame, &square, [3., 3.], &options);
            let distance = distance(&frame, &square, [3., 3.], &options);
            (relation, distance.unwrap().distance())
        };
        for thread in [scope.spawn(ask), scope.spawn(ask)] {
            assert_eq!(thread.join().unwrap(), (Ok(Relation::Apart), 2.));
        }
    });
}

#[test]
fn answers_are_shared() {
    fn shareable<T: Send + Sync + Copy + 'static>() {}
    shareable::<Relation>();
    shareable::<Separation>();
    shareable::<Impact>();
    shareable::<gcv::Contact>();
}

#[test]
fn progress_counts_translations() {
    let (slot, peg, from) = (slot(), square(2.), translations());
    let mut reports = vec![];
    let options = Options::new().progress(|done, estimate| {
        reports.push((done, estimate));
        Continue(())
    });
    distance_many(&slot, &peg, &from, &options).unwrap();
    drop(options);
    assert_eq!(reports.last(), Some(&(COUNT as u64, COUNT as u64)));
    let grows = |pair: &[(u64, u64)]| pair[0].0 <= pair[1].0;
    assert!(reports.windows(2).all(grows), "{reports:?}");
    let known = |report: &(u64, u64)| report.1 == COUNT as u64;
    assert!(reports.iter().all(known), "{reports:?}");
}

#[test]
fn breaking_cancels() {
    let (slot, peg, from) = (slot(), square(2.), translations());
    let impatient = || Options::new().progress(|_, _| Break(()));
    let mut relations = vec![Relation::Apart; COUNT];
    let mut separations = vec![Separation::default(); COUNT];
    let mut impacts = vec![Impact::default(); COUNT];
    for threads in [1, 3] {
        let options = impatient().threads(threads);
        let failed = relation_into(&slot, &peg, &from, &options, &mut relations);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = distance_into(&slot, &peg, &from, &options, &mut separations);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
        let failed = cast_into(&slot, &peg, &from, &from, &options, &mut impacts);
        assert_eq!(status(failed), GCV_ERR_CANCELLED);
    }
    assert!(relations.iter().all(|found| *found == Relation::Apart));
    assert!(separations
        .iter()
        .all(|found| *found == Separation::default()));
    assert!(impacts.iter().all(|found| *found == Impact::default()));

    let options = impatient();
    assert_eq!(
        status(relation(&slot, &peg, [0., 0.], &options)),
        GCV_ERR_CANCELLED
    );
}

#[test]
fn panics_go_on_in_the_caller() {
    let (slot, peg) = (slot(), square(2.));
    let options = Options::new().progress(|_, _| panic!("out of patience"));
    let ask = AssertUnwindSafe(|| relation(&slot, &peg, [0., 0.], &options));
    let panic = catch_unwind(ask).unwrap_err();
    assert_eq!(panic.downcast_ref(), Some(&"out of patience"));
}

#[test]
fn options_that_are_refused() {
    let (slot, peg) = (slot(), square(2.));
    let options = Options::new().tolerance(-1.);
    let (refused, message) = (GCV_ERR_INVALID_ARGUMENT, "options: tolerance is -1");
    assert_fails(relation(&slot, &peg, [0., 0.], &options), refused, message);
    assert_fails(distance(&slot, &peg, [0., 0.], &options), refused, message);
    let failed = cast(&slot, &peg, [0., 0.], [0., 0.], &options);
    assert_fails(failed, refused, message);
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Questions about two polygons; here what the tests of several subjects need.

mod cast;
mod contacts;
mod distance;
mod options;
mod penetration;
mod properties;
mod relation;

use gcv::{Error, Polygon};

fn polygon(vertices: &[[f64; 2]]) -> Polygon {
    Polygon::new(vertices).unwrap()
}

fn square(size: f64) -> Polygon {
    polygon(&[[0., 0.], [size, 0.], [size, size], [0., size]])
}

/// A frame of width 1 round a square hole of size 8.
fn frame() -> Polygon {
    let ring = |low, high| [[low, low], [high, low], [high, high], [low, high]];
    Polygon::from_rings([ring(0., 10.), ring(1., 9.)]).unwrap()
}

/// A block with a slot of width 2 that is open above.
fn slot() -> Polygon {
    #[rustfmt::skip]
    let vertices = [
        [0., 0.], [6., 0.], [6., 6.], [4., 6.], [4., 2.], [2., 2.], [2., 6.], [0., 6.],
    ];
    polygon(&vertices)
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

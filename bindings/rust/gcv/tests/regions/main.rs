// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Regions through the whole interface; here what the tests of several subjects need.

mod inner_fits;
mod many;
mod options;
mod sums;

use gcv::{minkowski_sum_region, no_fit_region, Error, Options, Part, PartKind, Polygon, Region};

const ORIGIN: [f64; 2] = [0., 0.];

fn polygon(vertices: &[[f64; 2]]) -> Polygon {
    Polygon::new(vertices).unwrap()
}

fn rectangle(width: f64, height: f64) -> Polygon {
    polygon(&[[0., 0.], [width, 0.], [width, height], [0., height]])
}

fn square(size: f64) -> Polygon {
    rectangle(size, size)
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

fn huge() -> Polygon {
    square(1.7e308)
}

fn frame_and_square() -> Region {
    minkowski_sum_region(&frame(), &square(1.), &Options::new()).unwrap()
}

fn slot_and_peg() -> Region {
    no_fit_region(&slot(), &square(2.), ORIGIN, &Options::new()).unwrap()
}

fn status<T>(result: Result<T, Error>) -> i32 {
    result.err().unwrap().status
}

/// Parts of these kinds and numbers of vertices.
fn parts(kinds: &[(PartKind, usize)]) -> Vec<Part> {
    let mut end = 0;
    let part = |&(kind, count)| {
        let start = end;
        end += count;
        let vertices = start..end;
        Part { kind, vertices }
    };
    kinds.iter().map(part).collect()
}

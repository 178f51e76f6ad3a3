// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Exact vertices as fractions of num-rational.

use num_rational::BigRational;

/// The numbers of vertices that the library wrote as `"p/q r/s"`.
pub(crate) fn rationals(vertices: Vec<String>) -> Vec<[BigRational; 2]> {
    const FRACTIONS: &str = "libgcv writes two fractions";
    let convert = |vertex: String| {
        let (x, y) = vertex.split_once(' ').expect(FRACTIONS);
        [x, y].map(|fraction| fraction.parse().expect(FRACTIONS))
    };
    vertices.into_iter().map(convert).collect()
}

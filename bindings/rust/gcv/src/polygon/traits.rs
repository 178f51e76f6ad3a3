// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What polygons have of the traits of the standard library.

use std::fmt;
use std::hash::{Hash, Hasher};
use std::ops::{Add, Neg};
use std::str::FromStr;

use super::hash_ring;
use crate::call::INFALLIBLE;
use crate::{minkowski_sum, Error, Options, OuterFace, Polygon};

impl fmt::Debug for Polygon {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Polygon")
            .field("ring_count", &self.ring_count())
            .field("rings", &self.rings().collect::<Vec<_>>())
            .finish()
    }
}

impl fmt::Display for Polygon {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        // With the fewest digits that read back as the same number.
        let number = |number: f64| {
            let digits = format!("{number:?}");
            digits
                .strip_suffix(".0")
                .map(str::to_owned)
                .unwrap_or(digits)
        };
        let vertex = |[x, y]: [f64; 2]| number(x) + " " + &number(y);
        let ring = |mut ring: Vec<[f64; 2]>| {
            ring.push(ring[0]);
            let vertices: Vec<_> = ring.into_iter().map(vertex).collect();
            format!("({})", vertices.join(", "))
        };
        let rings: Vec<_> = self.rings().map(ring).collect();
        write!(formatter, "POLYGON ({})", rings.join(", "))
    }
}

impl FromStr for Polygon {
    type Err = Error;

    fn from_str(wkt: &str) -> Result<Self, Error> {
        Self::from_wkt(wkt)
    }
}

impl PartialEq for Polygon {
    fn eq(&self, other: &Self) -> bool {
        self.as_ptr() == other.as_ptr() || self.rings().eq(other.rings())
    }
}

impl Eq for Polygon {}

impl Hash for Polygon {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.ring_count().hash(state);
        for ring in self.rings() {
            hash_ring(&ring, state);
        }
    }
}

/// Reflected in the origin, exactly; panics without memory.
impl Neg for &Polygon {
    type Output = Polygon;

    fn neg(self) -> Polygon {
        self.affine([-1., 0., 0., 0., -1., 0.]).expect(INFALLIBLE)
    }
}

/// Reflected in the origin, exactly; panics without memory.
impl Neg for Polygon {
    type Output = Self;

    fn neg(self) -> Self {
        -&self
    }
}

/// The outer face of the sum with the default options, as by [`minkowski_sum`]: `(&a + &b)?`.
impl Add for &Polygon {
    type Output = Result<OuterFace, Error>;

    fn add(self, other: Self) -> Result<OuterFace, Error> {
        minkowski_sum(self, other, &Options::new())
    }
}

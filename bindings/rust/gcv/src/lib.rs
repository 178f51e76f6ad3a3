// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! The outer face of the Minkowski sum of two polygons, exactly.
//!
//! Every coordinate is a finite `f64` and stands for exactly that number; nothing is
//! rounded but the coordinates that are handed back as `f64`. Polygons and outer faces
//! never change, so threads may share them.
//!
//! ```
//! use gcv::{minkowski_sum, Options, Polygon};
//!
//! # fn main() -> Result<(), gcv::Error> {
//! let notched = Polygon::new(&[[0., 0.], [8., 0.], [8., 6.], [3., 1.], [0., 7.]])?;
//! let triangle = Polygon::new(&[[0., 0.], [1., 0.], [0., 1.]])?;
//! let face = minkowski_sum(&notched, &triangle, &Options::new())?;
//! assert_eq!(face.exact_vertices()[4], "10/3 7/3");
//! assert_eq!(face.vertices()[4], [10. / 3., 7. / 3.]);
//! # Ok(())
//! # }
//! ```

#![warn(missing_docs)]

mod call;
mod error;
#[cfg(feature = "geo-types")]
mod geo;
mod handle;
mod options;
mod outer_face;
mod point;
mod polygon;
mod source;
mod sums;

pub use error::{status, Error, ErrorKind};
pub use options::{Options, Rounding};
pub use outer_face::{OuterFace, Stats};
pub use point::Point;
pub use polygon::Polygon;
pub use source::EdgeSource;
pub use sums::{
    entrance_block, minkowski_sum, minkowski_sum_many, no_fit_polygon, superset, SupersetEdge,
};

/// The version of the library that is running, such as `"0.2.0"`.
pub fn library_version() -> String {
    // SAFETY: the function gives a text that stays.
    unsafe { call::text(gcv_sys::gcv_version_string()) }
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

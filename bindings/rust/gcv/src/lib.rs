// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Minkowski sums of two polygons, exactly: outer faces and whole regions. Questions about two
//! polygons without a sum: how they lie, how far apart they are, when they meet.
//!
//! An [`OuterFace`] is one ring, the boundary of the unbounded face outside of the sum. A
//! [`Region`] is the whole sum: its outer ring, its holes, and the segments and points where
//! one polygon fits the other exactly; or where a polygon may go inside a container or in a scene.
//!
//! [`relation`], [`distance`] and [`cast`] take two polygons and a translation of the second
//! one, or many translations, and build nothing.
//!
//! A [`Scene`] holds many polygons at positions, and perhaps a container round them. It answers
//! the same questions about all of them, and which of them are near each other. Its free region is
//! where one more polygon may go.
//!
//! Every coordinate is a finite `f64` and stands for exactly that number; nothing is
//! rounded but the coordinates that are handed back as `f64`. Polygons, outer faces, regions and
//! lists never change, so threads may share them; what changes a scene takes `&mut`.
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
mod cast;
mod contact;
mod contacts;
mod distance;
mod error;
#[cfg(feature = "num-rational")]
mod exact;
#[cfg(feature = "geo-types")]
mod geo;
mod handle;
mod lengths;
mod location;
mod offset;
mod options;
mod outer_face;
mod pairs;
mod part;
mod penetration;
mod point;
mod polygon;
mod query;
mod region;
mod regions;
mod relation;
mod scene;
mod source;
mod stats;
mod sums;

pub use cast::{cast, cast_into, cast_many, Impact};
pub use contact::{Contact, ContactKind};
pub use contacts::{contacts, ContactList};
pub use distance::{distance, distance_into, distance_many, Separation};
pub use error::{status, Error, ErrorKind};
pub use location::Location;
pub use offset::offset;
pub use options::{Options, Rounding};
pub use outer_face::OuterFace;
pub use pairs::{Pair, PairList};
pub use part::{Part, PartKind};
pub use penetration::{penetration, penetration_into, penetration_many, Escape};
pub use point::Point;
pub use polygon::Polygon;
pub use query::Query;
pub use region::Region;
pub use regions::{
    entrance_region, inner_fit_region, minkowski_sum_region, minkowski_sum_region_many,
    no_fit_region, no_fit_region_many,
};
pub use relation::{relation, relation_into, relation_many, Relation};
pub use scene::Scene;
pub use source::EdgeSource;
pub use stats::Stats;
pub use sums::{
    entrance_block, minkowski_sum, minkowski_sum_many, no_fit_polygon, no_fit_polygon_many,
    superset, SupersetEdge,
};

/// The version of the library that is running, such as `"0.2.0"`.
pub fn library_version() -> String {
    // SAFETY: the function gives a text that stays.
    unsafe { call::text(gcv_sys::gcv_version_string()) }
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

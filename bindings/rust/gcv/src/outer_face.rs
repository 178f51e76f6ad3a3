// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;
use std::hash::{Hash, Hasher};

use gcv_sys as sys;

use crate::call::{create, elements, string, value, INFALLIBLE};
use crate::handle::Handle;
use crate::point::bounds_of;
use crate::polygon::hash_ring;
use crate::{stats, EdgeSource, Error, Polygon, Stats};

/// The outer face of a Minkowski sum.
///
/// Made by [`minkowski_sum`](crate::minkowski_sum), [`no_fit_polygon`](crate::no_fit_polygon),
/// [`entrance_block`](crate::entrance_block),
/// [`minkowski_sum_many`](crate::minkowski_sum_many) and
/// [`no_fit_polygon_many`](crate::no_fit_polygon_many). The whole sum, with its holes, is a
/// [`Region`](crate::Region). It never changes: a clone is the same
/// one, and costs nothing. Two are equal where both their rings are, the exact ones and
/// those in `f64`. As text it is [`OuterFace::wkt`].
#[derive(Clone)]
pub struct OuterFace(pub(crate) Handle<sys::gcv_outer_face>);

impl OuterFace {
    fn as_ptr(&self) -> *const sys::gcv_outer_face {
        self.0.as_ptr()
    }

    /// The outer boundary, rounded as the options said: counter-clockwise from the
    /// lexicographically smallest vertex, not closed, a simple ring.
    pub fn vertices(&self) -> Vec<[f64; 2]> {
        // SAFETY: see `elements`; a vertex is two doubles.
        elements(|out: *mut [f64; 2], capacity, required| unsafe {
            sys::gcv_outer_face_vertices(self.as_ptr(), out.cast(), capacity, required)
        })
    }

    /// The smallest box around the vertices: `[xmin, ymin, xmax, ymax]`.
    pub fn bounds(&self) -> [f64; 4] {
        bounds_of(&self.vertices()).expect("a ring has vertices")
    }

    /// The vertices of the exact ring, without collinear ones, as fractions `"p/q r/s"`
    /// in lowest terms.
    ///
    /// # Panics
    /// Without memory.
    pub fn exact_vertices(&self) -> Vec<String> {
        // SAFETY: the face is alive.
        let count =
            value(|out| unsafe { sys::gcv_outer_face_exact_vertex_count(self.as_ptr(), out) });
        let vertex = |index| {
            // SAFETY: see `string`.
            string(|out, capacity, required| unsafe {
                sys::gcv_outer_face_exact_vertex(self.as_ptr(), index, out, capacity, required)
            })
        };
        (0..count.expect(INFALLIBLE)).map(vertex).collect()
    }

    /// The vertices of the exact ring, without collinear ones, as `[x, y]` each.
    ///
    /// # Panics
    /// Without memory.
    #[cfg(feature = "num-rational")]
    pub fn exact_rationals(&self) -> Vec<[num_rational::BigRational; 2]> {
        crate::exact::rationals(self.exact_vertices())
    }

    /// The source of every edge of the exact ring: element `i` is for the edge from
    /// exact vertex `i` to `i + 1`.
    pub fn sources(&self) -> Vec<EdgeSource> {
        // SAFETY: see `elements`.
        let sources: Vec<sys::gcv_edge_source> = elements(|out, capacity, required| unsafe {
            sys::gcv_outer_face_edge_sources(self.as_ptr(), out, capacity, required)
        });
        sources.into_iter().map(EdgeSource::from).collect()
    }

    /// The exact vertex that each vertex of [`OuterFace::vertices`] stands for, as an index in
    /// [`OuterFace::exact_vertices`] and [`OuterFace::sources`].
    ///
    /// If several exact vertices fell together, it is the lowest of their indices. The edges
    /// between them have vanished, and the returned edge from there comes from that of the last
    /// of them along the ring. They can lie on both sides of the start of the ring. If rounding
    /// made a new vertex, it is the start of the exact edge that the returned edge from there
    /// lies closest to.
    ///
    /// # Panics
    /// Without memory.
    pub fn exact_indices(&self) -> Vec<usize> {
        // SAFETY: see `elements`.
        let indices: Vec<u64> = elements(|out, capacity, required| unsafe {
            sys::gcv_outer_face_exact_indices(self.as_ptr(), out, capacity, required)
        });
        indices.into_iter().map(|index| index as usize).collect()
    }

    /// An upper bound on the Hausdorff distance from [`OuterFace::vertices`] to the exact
    /// ring, in input units: 0 where every exact coordinate is an `f64`.
    ///
    /// With a tolerance it also has what the polygons were simplified by, and is one
    /// between sets: no point of the ring is further than it from the exact sum of the
    /// polygons as given, and no point of that sum is further than it from the region
    /// inside the ring.
    pub fn error_bound(&self) -> f64 {
        // SAFETY: the face is alive.
        let bound = value(|out| unsafe { sys::gcv_outer_face_error_bound(self.as_ptr(), out) });
        bound.expect(INFALLIBLE)
    }

    /// The area inside [`OuterFace::vertices`], in square units, correctly rounded. Holes of
    /// the sum are not subtracted: [`Region::area`](crate::Region::area) does that.
    ///
    /// # Errors
    /// `GCV_ERR_RANGE` where it is larger than any finite `f64`.
    pub fn area(&self) -> Result<f64, Error> {
        // SAFETY: the face is alive.
        value(|out| unsafe { sys::gcv_outer_face_area(self.as_ptr(), out) })
    }

    /// The ring of [`OuterFace::vertices`] as Well-Known Text, `POLYGON ((x y, ...))`,
    /// closed, which reads back to the same numbers.
    ///
    /// # Panics
    /// Without memory.
    pub fn wkt(&self) -> String {
        // SAFETY: see `string`.
        string(|out, capacity, required| unsafe {
            sys::gcv_outer_face_wkt(self.as_ptr(), out, capacity, required)
        })
    }

    /// The ring of [`OuterFace::vertices`] as a polygon, for the next sum.
    ///
    /// # Errors
    /// `GCV_ERR_NO_MEMORY`.
    pub fn polygon(&self) -> Result<Polygon, Error> {
        // SAFETY: the face is alive.
        create(|out| unsafe { sys::gcv_outer_face_polygon(self.as_ptr(), out) }).map(Polygon)
    }

    /// What the computation took.
    pub fn stats(&self) -> Stats {
        // SAFETY: the face is alive, and the struct has the size that it says.
        stats::read(|out| unsafe { sys::gcv_outer_face_stats(self.as_ptr(), out) })
    }
}

impl fmt::Debug for OuterFace {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_tuple("OuterFace")
            .field(&self.vertices())
            .finish()
    }
}

impl fmt::Display for OuterFace {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(&self.wkt())
    }
}

impl PartialEq for OuterFace {
    fn eq(&self, other: &Self) -> bool {
        self.as_ptr() == other.as_ptr()
            || self.vertices() == other.vertices()
                && self.exact_vertices() == other.exact_vertices()
    }
}

impl Eq for OuterFace {}

impl Hash for OuterFace {
    fn hash<H: Hasher>(&self, state: &mut H) {
        hash_ring(&self.vertices(), state);
    }
}

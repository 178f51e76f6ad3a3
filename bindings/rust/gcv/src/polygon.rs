// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;
use std::ptr::NonNull;

use gcv_sys as sys;

use crate::call::{create, elements, value, INFALLIBLE};
use crate::{Error, Rounding};

/// A simple polygon.
pub struct Polygon(NonNull<sys::gcv_polygon>);

// SAFETY: a polygon does not change from its creation to its destruction, and the
// library lets any thread use it and any thread end it.
unsafe impl Send for Polygon {}
unsafe impl Sync for Polygon {}

impl Polygon {
    /// Makes a polygon from the vertices of its boundary, `[x, y]` each.
    ///
    /// Either orientation will do, and the first vertex may be repeated at the end.
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE` for a NaN or an infinity, `GCV_ERR_DEGENERATE` without
    /// area, `GCV_ERR_NOT_SIMPLE` for a ring that crosses or touches itself,
    /// `GCV_ERR_INVALID_ARGUMENT` above 2^31 - 1 vertices, `GCV_ERR_NO_MEMORY`.
    pub fn new(vertices: &[[f64; 2]]) -> Result<Self, Error> {
        let xy = vertices.as_ptr().cast();
        // SAFETY: as many vertices as said are read from the slice, during the call.
        create(|out| unsafe { sys::gcv_polygon_create(xy, vertices.len(), 0, out) }).map(Self)
    }

    /// Makes a polygon from Well-Known Text, `POLYGON ((x y, x y, ...))`.
    ///
    /// Holes are left out, as they never change an outer face.
    ///
    /// # Errors
    /// As [`Polygon::new`], and `GCV_ERR_PARSE` with the byte offset in the message.
    pub fn from_wkt(wkt: &str) -> Result<Self, Error> {
        let bytes = wkt.as_ptr().cast();
        // SAFETY: as many bytes as said are read from the text, during the call.
        create(|out| unsafe { sys::gcv_polygon_create_wkt(bytes, wkt.len(), out) }).map(Self)
    }

    /// The polygon of a handle, which is owned from now on.
    pub(crate) fn from_handle(handle: NonNull<sys::gcv_polygon>) -> Self {
        Self(handle)
    }

    pub(crate) fn as_ptr(&self) -> *const sys::gcv_polygon {
        self.0.as_ptr()
    }

    /// The vertices, counter-clockwise from the lexicographically smallest, without
    /// repeated and without collinear ones; not closed.
    pub fn vertices(&self) -> Vec<[f64; 2]> {
        // SAFETY: see `elements`; a vertex is two doubles.
        elements(|out: *mut [f64; 2], capacity, required| unsafe {
            sys::gcv_polygon_vertices(self.as_ptr(), out.cast(), capacity, required)
        })
    }

    /// The area in square units, above 0, correctly rounded.
    ///
    /// # Errors
    /// `GCV_ERR_RANGE` where it is larger than any finite `f64`.
    pub fn area(&self) -> Result<f64, Error> {
        // SAFETY: the polygon is alive.
        value(|out| unsafe { sys::gcv_polygon_area(self.as_ptr(), out) })
    }

    /// The smallest box around the polygon: `[xmin, ymin, xmax, ymax]`.
    pub fn bounds(&self) -> [f64; 4] {
        // SAFETY: the polygon is alive, and there is room for four doubles.
        let bounds = value(|out: *mut [f64; 4]| unsafe {
            sys::gcv_polygon_bounds(self.as_ptr(), out.cast())
        });
        bounds.expect(INFALLIBLE)
    }

    /// The polygon with fewer vertices, for scenes that need no more detail, and a bound on
    /// the Hausdorff distance between the two boundaries, in input units: at most
    /// `tolerance`, and often less.
    ///
    /// With [`Rounding::Nearest`] the vertices are some of the given ones. With
    /// [`Rounding::Outward`] the new polygon contains the given one, and may have new
    /// vertices, where edges were lengthened until they meet. Numbers of vertices and edges
    /// stay those that the given polygon was created with; of several that one stands for,
    /// the first.
    ///
    /// ```
    /// use gcv::{Polygon, Rounding};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let dented = Polygon::new(&[[0., 0.], [8., 0.], [8., 8.], [4., 7.5], [0., 8.]])?;
    /// let (square, bound) = dented.simplified(1.5, Rounding::Outward)?;
    /// assert_eq!(square.vertices(), [[0., 0.], [8., 0.], [8., 8.], [0., 8.]]);
    /// assert!(0.5 <= bound && bound < 0.5000001);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// `GCV_ERR_INVALID_ARGUMENT` for a tolerance that is negative or not finite;
    /// `GCV_ERR_NO_MEMORY`.
    pub fn simplified(&self, tolerance: f64, rounding: Rounding) -> Result<(Self, f64), Error> {
        let (rounding, mut bound) = (rounding.value(), 0.);
        // SAFETY: the polygon is alive.
        let polygon = create(|out| unsafe {
            sys::gcv_polygon_simplified(self.as_ptr(), tolerance, rounding, out, &mut bound)
        })?;
        Ok((Self(polygon), bound))
    }
}

impl fmt::Debug for Polygon {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_tuple("Polygon")
            .field(&self.vertices())
            .finish()
    }
}

impl Drop for Polygon {
    fn drop(&mut self) {
        // SAFETY: the polygon is owned and not used again.
        unsafe { sys::gcv_polygon_destroy(self.0.as_ptr()) }
    }
}

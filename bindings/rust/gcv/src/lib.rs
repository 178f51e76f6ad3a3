// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! The outer face of the Minkowski sum of two polygons, exactly.
//!
//! Every coordinate is a finite `f64` and stands for exactly that number; nothing is
//! rounded but the coordinates that are handed back as `f64`, each once. Polygons and
//! outer faces never change, so threads may share them.
//!
//! ```
//! use gcv::{minkowski_sum, Polygon};
//!
//! # fn main() -> Result<(), gcv::Error> {
//! let notched = Polygon::new(&[[0., 0.], [8., 0.], [8., 6.], [3., 1.], [0., 7.]])?;
//! let triangle = Polygon::new(&[[0., 0.], [1., 0.], [0., 1.]])?;
//! let face = minkowski_sum(&notched, &triangle)?;
//! assert_eq!(face.exact_vertices()[4], "10/3 7/3");
//! assert_eq!(face.vertices()[4], [10. / 3., 7. / 3.]);
//! # Ok(())
//! # }
//! ```

#![warn(missing_docs)]

use std::ffi::CStr;
use std::fmt;
use std::os::raw::c_char;
use std::ptr::{self, NonNull};

use gcv_sys as sys;

/// What a failed call came to: the values of [`Error::status`].
pub mod status {
    pub use gcv_sys::{
        GCV_ERR_DEGENERATE, GCV_ERR_INTERNAL, GCV_ERR_INVALID_ARGUMENT, GCV_ERR_NOT_FINITE,
        GCV_ERR_NOT_SIMPLE, GCV_ERR_NO_MEMORY, GCV_ERR_PARSE, GCV_ERR_RANGE,
    };
}

/// What an edge of a sum is made of: the values of [`EdgeSource::kind`].
pub mod edge {
    pub use gcv_sys::{GCV_EDGE_CORNER, GCV_EDGE_TRANSLATED, GCV_EDGE_TRANSLATED_CORNER};
}

/// A call that failed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// The status, one of [`status`] or one that a later version of the library adds.
    pub status: i32,
    /// What it was about, in one sentence.
    pub message: String,
}

impl Error {
    /// The name of the status, such as `"GCV_ERR_NOT_SIMPLE"`.
    pub fn status_name(&self) -> String {
        // SAFETY: the function takes any value and gives a text that stays.
        unsafe { text(sys::gcv_status_name(self.status)) }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

/// A simple polygon.
#[derive(Debug)]
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

    /// The vertices, counter-clockwise from the lexicographically smallest, without
    /// repeated and without collinear ones; not closed.
    pub fn vertices(&self) -> Vec<[f64; 2]> {
        // SAFETY: see `elements`; a vertex is two doubles.
        elements(|out: *mut [f64; 2], capacity, required| unsafe {
            sys::gcv_polygon_vertices(self.0.as_ptr(), out.cast(), capacity, required)
        })
    }

    /// The area in square units, above 0, correctly rounded.
    ///
    /// # Errors
    /// `GCV_ERR_RANGE` where it is larger than any finite `f64`.
    pub fn area(&self) -> Result<f64, Error> {
        // SAFETY: the polygon is alive.
        value(|out| unsafe { sys::gcv_polygon_area(self.0.as_ptr(), out) })
    }

    /// The smallest box around the polygon: `[xmin, ymin, xmax, ymax]`.
    pub fn bounds(&self) -> [f64; 4] {
        // SAFETY: the polygon is alive, and there is room for four doubles.
        let bounds = value(|out: *mut [f64; 4]| unsafe {
            sys::gcv_polygon_bounds(self.0.as_ptr(), out.cast())
        });
        bounds.expect(INFALLIBLE)
    }
}

impl Drop for Polygon {
    fn drop(&mut self) {
        // SAFETY: the polygon is owned and not used again.
        unsafe { sys::gcv_polygon_destroy(self.0.as_ptr()) }
    }
}

/// Where an edge of a sum comes from.
///
/// The numbers are those of the caller: vertex `k` as passed, edge `k` from vertex `k`
/// to `k + 1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EdgeSource {
    /// One of [`edge`], which say what `a` and `b` are the numbers of.
    pub kind: i32,
    /// A vertex or an edge of the first polygon.
    pub a: u32,
    /// A vertex or an edge of the second polygon.
    pub b: u32,
}

/// The outer face of a Minkowski sum.
///
/// Made by [`minkowski_sum`], [`no_fit_polygon`] and [`entrance_block`].
#[derive(Debug)]
pub struct OuterFace(NonNull<sys::gcv_outer_face>);

// SAFETY: as for a polygon.
unsafe impl Send for OuterFace {}
unsafe impl Sync for OuterFace {}

impl OuterFace {
    /// The outer boundary, each coordinate correctly rounded: counter-clockwise from
    /// the lexicographically smallest vertex, not closed, a simple ring.
    pub fn vertices(&self) -> Vec<[f64; 2]> {
        // SAFETY: see `elements`; a vertex is two doubles.
        elements(|out: *mut [f64; 2], capacity, required| unsafe {
            sys::gcv_outer_face_vertices(self.0.as_ptr(), out.cast(), capacity, required)
        })
    }

    /// The vertices of the exact ring, without collinear ones, as fractions `"p/q r/s"`
    /// in lowest terms.
    ///
    /// # Panics
    /// Without memory.
    pub fn exact_vertices(&self) -> Vec<String> {
        // SAFETY: the face is alive.
        let count =
            value(|out| unsafe { sys::gcv_outer_face_exact_vertex_count(self.0.as_ptr(), out) });
        let vertex = |index| {
            // SAFETY: see `string`.
            string(|out, capacity, required| unsafe {
                sys::gcv_outer_face_exact_vertex(self.0.as_ptr(), index, out, capacity, required)
            })
        };
        (0..count.expect(INFALLIBLE)).map(vertex).collect()
    }

    /// The source of every edge of the exact ring: element `i` is for the edge from
    /// exact vertex `i` to `i + 1`.
    pub fn sources(&self) -> Vec<EdgeSource> {
        // SAFETY: see `elements`.
        let sources: Vec<sys::gcv_edge_source> = elements(|out, capacity, required| unsafe {
            sys::gcv_outer_face_edge_sources(self.0.as_ptr(), out, capacity, required)
        });
        let convert = |sys::gcv_edge_source { kind, a, b }| EdgeSource { kind, a, b };
        sources.into_iter().map(convert).collect()
    }

    /// An upper bound on the Hausdorff distance from [`OuterFace::vertices`] to the exact
    /// ring, in input units: 0 where every exact coordinate is an `f64`.
    pub fn error_bound(&self) -> f64 {
        // SAFETY: the face is alive.
        let bound = value(|out| unsafe { sys::gcv_outer_face_error_bound(self.0.as_ptr(), out) });
        bound.expect(INFALLIBLE)
    }

    /// The area inside [`OuterFace::vertices`], in square units, correctly rounded.
    ///
    /// # Errors
    /// `GCV_ERR_RANGE` where it is larger than any finite `f64`.
    pub fn area(&self) -> Result<f64, Error> {
        // SAFETY: the face is alive.
        value(|out| unsafe { sys::gcv_outer_face_area(self.0.as_ptr(), out) })
    }

    /// The ring of [`OuterFace::vertices`] as Well-Known Text, `POLYGON ((x y, ...))`,
    /// closed, which reads back to the same numbers.
    ///
    /// # Panics
    /// Without memory.
    pub fn wkt(&self) -> String {
        // SAFETY: see `string`.
        string(|out, capacity, required| unsafe {
            sys::gcv_outer_face_wkt(self.0.as_ptr(), out, capacity, required)
        })
    }

    /// The ring of [`OuterFace::vertices`] as a polygon, for the next sum.
    ///
    /// # Errors
    /// `GCV_ERR_NO_MEMORY`.
    pub fn polygon(&self) -> Result<Polygon, Error> {
        // SAFETY: the face is alive.
        create(|out| unsafe { sys::gcv_outer_face_polygon(self.0.as_ptr(), out) }).map(Polygon)
    }
}

impl Drop for OuterFace {
    fn drop(&mut self) {
        // SAFETY: the face is owned and not used again.
        unsafe { sys::gcv_outer_face_destroy(self.0.as_ptr()) }
    }
}

/// The outer face of the Minkowski sum A + B.
///
/// # Errors
/// `GCV_ERR_RANGE` where a coordinate of the result is no finite `f64`, or where its
/// rounded vertices do not form a simple ring; `GCV_ERR_NO_MEMORY`.
pub fn minkowski_sum(a: &Polygon, b: &Polygon) -> Result<OuterFace, Error> {
    let (a, b) = (a.0.as_ptr(), b.0.as_ptr());
    // SAFETY: the polygons are alive.
    create(|out| unsafe { sys::gcv_minkowski_sum(a, b, ptr::null(), out) }).map(OuterFace)
}

/// The no-fit polygon fixed + (-moving) + reference.
///
/// It is where the point `reference`, tied to `moving`, may go while the two polygons
/// touch: inside the ring they overlap, outside they are apart.
///
/// # Errors
/// As [`minkowski_sum`], and `GCV_ERR_NOT_FINITE` for the reference point.
pub fn no_fit_polygon(
    fixed: &Polygon,
    moving: &Polygon,
    reference: [f64; 2],
) -> Result<OuterFace, Error> {
    let (fixed, moving, point) = (fixed.0.as_ptr(), moving.0.as_ptr(), reference.as_ptr());
    // SAFETY: the polygons and the point are alive.
    create(|out| unsafe { sys::gcv_no_fit_polygon(fixed, moving, point, ptr::null(), out) })
        .map(OuterFace)
}

/// Shi's entrance block E(A, B) = B + (-A) + a0.
///
/// It is where the point `a0`, tied to block A, may go while A and B touch.
///
/// # Errors
/// As [`no_fit_polygon`].
pub fn entrance_block(a: &Polygon, b: &Polygon, a0: [f64; 2]) -> Result<OuterFace, Error> {
    let (a, b, point) = (a.0.as_ptr(), b.0.as_ptr(), a0.as_ptr());
    // SAFETY: the polygons and the point are alive.
    create(|out| unsafe { sys::gcv_entrance_block(a, b, point, ptr::null(), out) }).map(OuterFace)
}

/// The version of the library that is running, such as `"0.1.0"`.
pub fn library_version() -> String {
    // SAFETY: the function gives a text that stays.
    unsafe { text(sys::gcv_version_string()) }
}

const INFALLIBLE: &str = "libgcv fails here only for want of memory";

/// Turns a status into a result, with the message of the thread that got it.
fn check(status: i32) -> Result<(), Error> {
    if status == sys::GCV_OK {
        return Ok(());
    }
    // SAFETY: the message stays until the next failure on this thread.
    let message = unsafe { text(sys::gcv_last_error_message()) };
    Err(Error { status, message })
}

/// Copies a text of the library.
///
/// # Safety
/// `text` ends in a NUL and does not change during the call.
unsafe fn text(text: *const c_char) -> String {
    CStr::from_ptr(text).to_string_lossy().into_owned()
}

/// What a function gives through an output argument.
fn value<T: Default>(call: impl FnOnce(*mut T) -> i32) -> Result<T, Error> {
    let mut out = T::default();
    check(call(&mut out)).map(|()| out)
}

/// The handle that a function gives through an output argument.
fn create<T>(call: impl FnOnce(*mut *mut T) -> i32) -> Result<NonNull<T>, Error> {
    let mut out = ptr::null_mut();
    check(call(&mut out))?;
    Ok(NonNull::new(out).expect("libgcv gives a handle where it succeeds"))
}

/// What a function writes to a buffer: asks for the number of elements, then for them.
fn elements<T: Clone + Default>(call: impl Fn(*mut T, usize, *mut usize) -> i32) -> Vec<T> {
    let mut count = 0;
    check(call(ptr::null_mut(), 0, &mut count)).expect(INFALLIBLE);
    let mut out = vec![T::default(); count];
    check(call(out.as_mut_ptr(), count, &mut count)).expect(INFALLIBLE);
    out
}

/// What a function writes to a buffer as a text with a final NUL.
fn string(call: impl Fn(*mut c_char, usize, *mut usize) -> i32) -> String {
    let bytes = elements(|out: *mut u8, capacity, required| call(out.cast(), capacity, required));
    let end = bytes.len() - 1;
    String::from_utf8_lossy(&bytes[..end]).into_owned()
}

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;

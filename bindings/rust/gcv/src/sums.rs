// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::vec;

use gcv_sys as sys;

use crate::call::{create, create_many, elements};
use crate::handle::{Handle, Made};
use crate::{EdgeSource, Error, Options, OuterFace, Point, Polygon};

/// The outer face of the Minkowski sum A + B.
///
/// It leaves out what lies inside the ring: holes of the sum, and the segments and points of
/// exact fits. [`minkowski_sum_region`](crate::minkowski_sum_region) has all of them.
///
/// # Errors
/// `GCV_ERR_RANGE` where a coordinate of the result is no finite `f64`, or where the
/// result is so small that in `f64` it has no area; `GCV_ERR_INVALID_ARGUMENT` for an
/// option; `GCV_ERR_CANCELLED`; `GCV_ERR_NO_MEMORY`.
pub fn minkowski_sum(a: &Polygon, b: &Polygon, options: &Options) -> Result<OuterFace, Error> {
    // SAFETY: the polygons are alive, the options are for the call.
    outer_face(options, |options, out| unsafe {
        sys::gcv_minkowski_sum(a.as_ptr(), b.as_ptr(), options, out)
    })
}

/// The no-fit polygon fixed + (-moving) + reference.
///
/// It is where the point `reference`, tied to `moving`, may go while the two polygons
/// touch.
///
/// With the point outside the exact ring the two polygons are apart. On the ring they touch
/// and do not overlap. Inside the ring they overlap, but not everywhere: in a hole of the sum
/// they are apart. In a slit without width and at a single free point, as where one polygon
/// just fits the other, they touch and do not overlap. The ring has none of these positions,
/// unless a gap connects them with the outside, however narrow, in the doubles passed in.
/// [`no_fit_region`](crate::no_fit_region) has all of them.
///
/// # Errors
/// As [`minkowski_sum`], and `GCV_ERR_NOT_FINITE` for the reference point.
pub fn no_fit_polygon(
    fixed: &Polygon,
    moving: &Polygon,
    reference: impl Point,
    options: &Options,
) -> Result<OuterFace, Error> {
    let reference = reference.xy();
    let (fixed, moving, point) = (fixed.as_ptr(), moving.as_ptr(), reference.as_ptr());
    // SAFETY: the polygons and the point are alive, the options are for the call.
    outer_face(options, |options, out| unsafe {
        sys::gcv_no_fit_polygon(fixed, moving, point, options, out)
    })
}

/// Shi's entrance block E(A, B) = B + (-A) + a0.
///
/// It is where the point `a0`, tied to block A, may go while A and B touch. What holds
/// outside, on and inside the ring is said at [`no_fit_polygon`].
/// [`entrance_region`](crate::entrance_region) has what the ring leaves out.
///
/// # Errors
/// As [`no_fit_polygon`].
pub fn entrance_block(
    a: &Polygon,
    b: &Polygon,
    a0: impl Point,
    options: &Options,
) -> Result<OuterFace, Error> {
    let a0 = a0.xy();
    let (a, b, point) = (a.as_ptr(), b.as_ptr(), a0.as_ptr());
    // SAFETY: the polygons and the point are alive, the options are for the call.
    outer_face(options, |options, out| unsafe {
        sys::gcv_entrance_block(a, b, point, options, out)
    })
}

fn outer_face(
    options: &Options,
    call: impl FnOnce(*const sys::gcv_options, *mut *mut sys::gcv_outer_face) -> i32,
) -> Result<OuterFace, Error> {
    options.pass(|options| create(|out| call(options, out)).map(OuterFace))
}

/// The outer face of every sum of a pair, in their order.
///
/// The pairs are shared out over the threads of the options. All are computed before the
/// first result is there to take.
///
/// ```
/// use gcv::{minkowski_sum_many, Options, Polygon};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let triangle = Polygon::new(&[[0., 0.], [1., 0.], [0., 1.]])?;
/// let pairs = [(&square, &square), (&square, &triangle)];
/// let faces: Vec<_> = minkowski_sum_many(pairs, &Options::new().threads(0))
///     .collect::<Result<_, _>>()?;
/// assert_eq!(faces[0].area()?, 4.);
/// assert_eq!(faces[1].area()?, 3.5);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// Each result is as that of [`minkowski_sum`]; the first message says what the pair's
/// number is and what it failed for, those of later pairs only their numbers and
/// statuses. Where the call as a whole fails, for an option, when it is cancelled or
/// without memory, every pair has that error.
pub fn minkowski_sum_many<'p>(
    pairs: impl IntoIterator<Item = (&'p Polygon, &'p Polygon)>,
    options: &Options,
) -> vec::IntoIter<Result<OuterFace, Error>> {
    let (a, b) = pointers(pairs);
    // SAFETY: the polygons are alive, the options are for the call, and there is room for as
    // many results as there are pairs.
    many(
        a.len(),
        options,
        OuterFace,
        |options, out, statuses| unsafe {
            sys::gcv_minkowski_sum_many(a.as_ptr(), b.as_ptr(), a.len(), options, out, statuses)
        },
    )
}

/// The no-fit polygon of every fixed polygon, moving polygon and reference point, in their
/// order, each as by [`no_fit_polygon`].
///
/// The no-fit polygons are shared out over the threads of the options. All are computed before
/// the first result is there to take. A moving polygon that occurs many times is reflected
/// once.
///
/// ```
/// use gcv::{no_fit_polygon_many, Options, Polygon};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let triangle = Polygon::new(&[[0., 0.], [1., 0.], [0., 1.]])?;
/// let pairs = [(&square, &triangle, [0., 0.]), (&triangle, &square, [0.5, 0.5])];
/// let faces: Vec<_> = no_fit_polygon_many(pairs, &Options::new().threads(0))
///     .collect::<Result<_, _>>()?;
/// assert_eq!(faces[0].vertices()[0], [-1., 0.]);
/// assert_eq!(faces[1].vertices()[0], [-0.5, -0.5]);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// As [`minkowski_sum_many`], and `GCV_ERR_NOT_FINITE` for a reference point fails its pair.
pub fn no_fit_polygon_many<'p>(
    pairs: impl IntoIterator<Item = (&'p Polygon, &'p Polygon, [f64; 2])>,
    options: &Options,
) -> vec::IntoIter<Result<OuterFace, Error>> {
    let pairs = WithReferences::from(pairs);
    // SAFETY: the polygons are alive, the options are for the call, and there is room for as
    // many results as there are pairs.
    many(
        pairs.count(),
        options,
        OuterFace,
        |options, out, statuses| unsafe {
            let (fixed, moving, points) = pairs.as_ptrs();
            let count = pairs.count();
            sys::gcv_no_fit_polygon_many(fixed, moving, points, count, options, out, statuses)
        },
    )
}

/// The result of every pair, from a function that makes `count` of them.
pub(crate) fn many<T: Made, R>(
    count: usize,
    options: &Options,
    result: fn(Handle<T>) -> R,
    call: impl FnOnce(*const sys::gcv_options, *mut *mut T, *mut i32) -> i32,
) -> vec::IntoIter<Result<R, Error>> {
    let made = options
        .pass(|options| create_many(count, "pair", |out, statuses| call(options, out, statuses)));
    let results: Vec<_> = made.into_iter().map(|made| made.map(result)).collect();
    results.into_iter()
}

type Pointers = Vec<*const sys::gcv_polygon>;

/// The polygons of pairs, as lists for the C interface.
pub(crate) fn pointers<'p>(
    pairs: impl IntoIterator<Item = (&'p Polygon, &'p Polygon)>,
) -> (Pointers, Pointers) {
    let pairs = pairs.into_iter();
    pairs.map(|(a, b)| (a.as_ptr(), b.as_ptr())).unzip()
}

/// Fixed polygons, moving polygons and reference points, as lists for the C interface.
pub(crate) struct WithReferences {
    fixed: Pointers,
    moving: Pointers,
    references: Vec<[f64; 2]>,
}

impl WithReferences {
    pub(crate) fn from<'p>(
        pairs: impl IntoIterator<Item = (&'p Polygon, &'p Polygon, [f64; 2])>,
    ) -> Self {
        let mut references = vec![];
        let (fixed, moving) = pointers(pairs.into_iter().map(|(fixed, moving, reference)| {
            references.push(reference);
            (fixed, moving)
        }));
        Self {
            fixed,
            moving,
            references,
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.references.len()
    }

    /// What the lists are at; `count` elements each.
    pub(crate) fn as_ptrs(
        &self,
    ) -> (
        *const *const sys::gcv_polygon,
        *const *const sys::gcv_polygon,
        *const f64,
    ) {
        let references = self.references.as_ptr().cast();
        (self.fixed.as_ptr(), self.moving.as_ptr(), references)
    }
}

/// One edge of the superset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupersetEdge {
    /// Where it begins.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
    /// Where it comes from.
    pub source: EdgeSource,
}

/// The superset of the outer face of A + B that the paper builds, for plots and tests.
///
/// Holes of the polygons are rings like the outer ones: their edges bound holes of the sum. It
/// can have in the order of n m edges; sums do not need it.
///
/// # Errors
/// `GCV_ERR_RANGE` where a coordinate is no finite `f64`; `GCV_ERR_NO_MEMORY`.
pub fn superset(a: &Polygon, b: &Polygon) -> Result<Vec<SupersetEdge>, Error> {
    // SAFETY: the polygons are alive.
    let superset = create(|out| unsafe { sys::gcv_superset_create(a.as_ptr(), b.as_ptr(), out) })?;
    // SAFETY: see `elements`.
    let edges: Vec<sys::gcv_superset_edge> = elements(|out, capacity, required| unsafe {
        sys::gcv_superset_edges(superset.as_ptr(), out, capacity, required)
    });
    let convert = |edge: sys::gcv_superset_edge| SupersetEdge {
        from: [edge.x0, edge.y0],
        to: [edge.x1, edge.y1],
        source: edge.source.into(),
    };
    Ok(edges.into_iter().map(convert).collect())
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::hash::{Hash, Hasher};

use gcv_sys as sys;

use crate::call::{create, create_many, elements, value, INFALLIBLE};
use crate::handle::Handle;
use crate::{Error, Point, Rounding};

mod traits;

/// A polygon: an outer ring, and rings of holes.
///
/// It never changes: a clone is the same one, and costs nothing. Two are equal where their
/// rings are, in the same order; the numbers that vertices and edges were passed with can
/// differ. As text it is [`Polygon::wkt`], and text is parsed by [`Polygon::from_wkt`].
///
/// ```
/// use gcv::Polygon;
///
/// # fn main() -> Result<(), gcv::Error> {
/// let outer = [[0., 0.], [9., 0.], [9., 9.], [0., 9.]];
/// let hole = [[3., 3.], [6., 3.], [3., 6.]];
/// let frame = Polygon::from_rings([&outer[..], &hole])?;
/// assert_eq!(frame.area()?, 81. - 4.5);
/// assert_eq!(frame, "POLYGON ((0 0, 9 0, 9 9, 0 9), (3 3, 3 6, 6 3))".parse()?);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Polygon(pub(crate) Handle<sys::gcv_polygon>);

impl Polygon {
    /// Makes a polygon from the vertices of its boundary, such as `[x, y]` or `(x, y)`.
    ///
    /// Either orientation will do, and the first vertex may be repeated at the end.
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE` for a NaN or an infinity, `GCV_ERR_DEGENERATE` without
    /// area, `GCV_ERR_NOT_SIMPLE` for a ring that crosses or touches itself,
    /// `GCV_ERR_INVALID_ARGUMENT` above 2^31 - 1 vertices, `GCV_ERR_NO_MEMORY`.
    pub fn new<P: Point>(vertices: &[P]) -> Result<Self, Error> {
        let vertices: Vec<_> = vertices.iter().map(Point::xy).collect();
        let xy = vertices.as_ptr().cast();
        // SAFETY: as many vertices as said are read from the list, during the call.
        create(|out| unsafe { sys::gcv_polygon_create(xy, vertices.len(), 0, out) }).map(Self)
    }

    /// Makes a polygon with holes from its rings: the outer one first.
    ///
    /// Each ring is as in [`Polygon::new`]. Rings may touch one another in single points, but
    /// not cross or overlap. Holes lie in the outer ring and outside one another. Numbers of
    /// vertices and edges run through all rings as passed.
    ///
    /// An outer face is that of the outer rings: holes never change it.
    ///
    /// # Errors
    /// As [`Polygon::new`]; the message names the ring. `GCV_ERR_DEGENERATE` without rings,
    /// `GCV_ERR_NOT_SIMPLE` also for rings that cross, overlap, or lie where they may not.
    pub fn from_rings<I, R, P>(rings: I) -> Result<Self, Error>
    where
        I: IntoIterator<Item = R>,
        R: AsRef<[P]>,
        P: Point,
    {
        let (vertices, sizes) = joined(rings);
        let xy = vertices.as_ptr().cast();
        // SAFETY: as many vertices as the sizes say are read from the list, during the call.
        create(|out| unsafe {
            sys::gcv_polygon_create_rings(xy, sizes.as_ptr(), sizes.len(), 0, out)
        })
        .map(Self)
    }

    /// Makes many polygons of one ring each by one call, such as blocks that turn in every
    /// step.
    ///
    /// ```
    /// use gcv::{status, Polygon};
    ///
    /// let triangle = [[0., 0.], [1., 0.], [0., 1.]];
    /// let line = [[0., 0.], [1., 1.], [2., 2.]];
    /// let polygons = Polygon::many([triangle, line]);
    /// assert_eq!(polygons[0], Polygon::new(&triangle));
    /// let error = polygons[1].as_ref().unwrap_err();
    /// assert_eq!(error.status, status::GCV_ERR_DEGENERATE);
    /// assert!(error.message.starts_with("polygon 1: "));
    /// ```
    ///
    /// # Errors
    /// Each result is as that of [`Polygon::new`]; the first message says what the polygon's
    /// number is and what it failed for, those of later ones only their numbers and statuses.
    /// Where there is no memory for the lists themselves, every result has that error.
    pub fn many<I, R, P>(rings: I) -> Vec<Result<Self, Error>>
    where
        I: IntoIterator<Item = R>,
        R: AsRef<[P]>,
        P: Point,
    {
        let (vertices, sizes) = joined(rings);
        let (xy, count) = (vertices.as_ptr().cast(), sizes.len());
        // SAFETY: as many vertices as the sizes say are read from the list, during the call,
        // and there is room for as many results as there are sizes.
        let made = create_many(count, "polygon", |out, statuses| unsafe {
            sys::gcv_polygon_create_many(xy, sizes.as_ptr(), count, 0, out, statuses)
        });
        made.into_iter().map(|made| made.map(Self)).collect()
    }

    /// Makes a convex polygon in place of a disc: for clearances, as part + disc.
    ///
    /// Every point of its boundary is within `tolerance` of the circle, and every point of
    /// the circle within `tolerance` of its boundary. With [`Rounding::Outward`] it contains
    /// the disc. It has fewer than twice as many vertices as are needed for that.
    ///
    /// ```
    /// use gcv::{minkowski_sum, Options, Polygon, Rounding};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let part = Polygon::new(&[(0., 0.), (8., 0.), (8., 5.)])?;
    /// let disc = Polygon::disc((0., 0.), 0.5, 1e-3, Rounding::Outward)?;
    /// let outward = Options::new().rounding(Rounding::Outward);
    /// let cleared = minkowski_sum(&part, &disc, &outward)?;
    /// assert!(cleared.vertices()[0][0] <= -0.5);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE` for the centre or the radius; `GCV_ERR_INVALID_ARGUMENT` for a
    /// radius or a tolerance that is not above 0, or a tolerance too small for `f64`;
    /// `GCV_ERR_RANGE` where coordinates are near the largest `f64`; `GCV_ERR_NO_MEMORY`.
    pub fn disc(
        centre: impl Point,
        radius: f64,
        tolerance: f64,
        rounding: Rounding,
    ) -> Result<Self, Error> {
        let (centre, rounding) = (centre.xy(), rounding.value());
        // SAFETY: the two coordinates of the centre are read, during the call.
        create(|out| unsafe {
            sys::gcv_polygon_create_disc(centre.as_ptr(), radius, tolerance, rounding, out)
        })
        .map(Self)
    }

    /// Makes a polygon from Well-Known Text, `POLYGON ((x y, x y, ...), (hole), ...)`.
    ///
    /// Holes are kept, and checked as by [`Polygon::from_rings`].
    ///
    /// # Errors
    /// As [`Polygon::from_rings`], and `GCV_ERR_PARSE` with the byte offset in the message.
    pub fn from_wkt(wkt: &str) -> Result<Self, Error> {
        let bytes = wkt.as_ptr().cast();
        // SAFETY: as many bytes as said are read from the text, during the call.
        create(|out| unsafe { sys::gcv_polygon_create_wkt(bytes, wkt.len(), out) }).map(Self)
    }

    pub(crate) fn as_ptr(&self) -> *const sys::gcv_polygon {
        self.0.as_ptr()
    }

    /// The vertices of the outer ring, counter-clockwise from the lexicographically smallest,
    /// without repeated and without collinear ones; not closed.
    pub fn vertices(&self) -> Vec<[f64; 2]> {
        // SAFETY: see `elements`; a vertex is two doubles.
        elements(|out: *mut [f64; 2], capacity, required| unsafe {
            sys::gcv_polygon_vertices(self.as_ptr(), out.cast(), capacity, required)
        })
    }

    /// The number of rings: 1 for the outer one, and 1 for each hole.
    pub fn ring_count(&self) -> usize {
        // SAFETY: the polygon is alive.
        let count = value(|out| unsafe { sys::gcv_polygon_ring_count(self.as_ptr(), out) });
        count.expect(INFALLIBLE)
    }

    /// The vertices of a ring: 0 is the outer one, then come the holes in the order passed.
    /// `None` where there is no such ring.
    ///
    /// Each ring starts at its lexicographically smallest vertex, without repeated and
    /// without collinear ones; not closed. The outer ring is counter-clockwise, holes are
    /// clockwise.
    pub fn ring(&self, ring: usize) -> Option<Vec<[f64; 2]>> {
        (ring < self.ring_count()).then(|| self.known_ring(ring))
    }

    /// The vertices of all rings, each as by [`Polygon::ring`].
    ///
    /// ```
    /// use gcv::Polygon;
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let frame = Polygon::from_wkt("POLYGON ((0 0, 9 0, 9 9, 0 9), (3 3, 6 3, 3 6))")?;
    /// let holes: Vec<_> = frame.rings().skip(1).collect();
    /// assert_eq!(holes, [[[3., 3.], [3., 6.], [6., 3.]]]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn rings(&self) -> impl ExactSizeIterator<Item = Vec<[f64; 2]>> + DoubleEndedIterator + '_ {
        (0..self.ring_count()).map(move |ring| self.known_ring(ring))
    }

    fn known_ring(&self, ring: usize) -> Vec<[f64; 2]> {
        // SAFETY: see `elements`; a vertex is two doubles.
        elements(|out: *mut [f64; 2], capacity, required| unsafe {
            sys::gcv_polygon_ring(self.as_ptr(), ring, out.cast(), capacity, required)
        })
    }

    /// The area in square units, above 0, correctly rounded. Holes are subtracted.
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

    /// The rings as Well-Known Text, `POLYGON ((x y, ...), (hole), ...)`, closed, which reads
    /// back to the same numbers.
    pub fn wkt(&self) -> String {
        self.to_string()
    }

    /// The polygon with `(x, y)` moved to `(m[0] x + m[1] y + m[2], m[3] x + m[4] y + m[5])`.
    ///
    /// Each coordinate is correctly rounded; quarter turns, reflections and powers of two are
    /// exact so. The numbers of vertices and edges stay, by a reflection too. `-&polygon` is
    /// the polygon reflected in the origin.
    ///
    /// ```
    /// use gcv::Polygon;
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let triangle = Polygon::new(&[[0., 0.], [2., 0.], [0., 1.]])?;
    /// let turned_and_moved = triangle.affine([0., -1., 5., 1., 0., 0.])?;
    /// assert_eq!(turned_and_moved, Polygon::new(&[[5., 0.], [5., 2.], [4., 0.]])?);
    /// assert_eq!(-&triangle, triangle.affine([-1., 0., 0., 0., -1., 0.])?);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE` for `m`; `GCV_ERR_RANGE` where a coordinate is no finite `f64`;
    /// `GCV_ERR_DEGENERATE` and `GCV_ERR_NOT_SIMPLE` where the map or the roundings leave no
    /// polygon; `GCV_ERR_NO_MEMORY`.
    pub fn affine(&self, m: [f64; 6]) -> Result<Self, Error> {
        // SAFETY: the polygon is alive, and six numbers are read, during the call.
        create(|out| unsafe { sys::gcv_polygon_affine(self.as_ptr(), m.as_ptr(), out) }).map(Self)
    }

    /// The polygon moved by a vector, each coordinate correctly rounded.
    ///
    /// # Errors
    /// As [`Polygon::affine`].
    pub fn translated(&self, [x, y]: [f64; 2]) -> Result<Self, Error> {
        self.affine([1., 0., x, 0., 1., y])
    }

    /// The polygon with fewer vertices, for scenes that need no more detail, and a bound on
    /// the Hausdorff distance between the two boundaries, in input units: at most
    /// `tolerance`, and often less.
    ///
    /// With [`Rounding::Nearest`] the vertices are some of the given ones. With
    /// [`Rounding::Outward`] the new polygon contains the given one, and may have new
    /// vertices, where edges were lengthened until they meet. Numbers of vertices and edges
    /// stay those that the given polygon was created with; of several that one stands for,
    /// the first. Holes are simplified likewise; none is lost.
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

/// The vertices of rings one after the other, and their numbers.
fn joined<R: AsRef<[P]>, P: Point>(
    rings: impl IntoIterator<Item = R>,
) -> (Vec<[f64; 2]>, Vec<usize>) {
    let (mut vertices, mut sizes) = (vec![], vec![]);
    for ring in rings {
        let ring = ring.as_ref();
        vertices.extend(ring.iter().map(Point::xy));
        sizes.push(ring.len());
    }
    (vertices, sizes)
}

/// A hash that is the same for equal rings, which are of finite numbers without -0.
pub(crate) fn hash_ring<H: Hasher>(ring: &[[f64; 2]], state: &mut H) {
    ring.len().hash(state);
    for coordinate in ring.iter().flatten() {
        coordinate.to_bits().hash(state);
    }
}

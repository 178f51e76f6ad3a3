// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;
use std::hash::{Hash, Hasher};

use gcv_sys as sys;

use crate::call::{check, count, create, elements, string, value, INFALLIBLE};
use crate::handle::Handle;
use crate::part::placed;
use crate::point::bounds_of;
use crate::polygon::hash_ring;
use crate::{stats, EdgeSource, Error, Location, Part, PartKind, Point, Polygon, Stats};

/// Polygons with holes, segments and points: a whole sum, or where a polygon may go inside a
/// container or in a scene.
///
/// Made by [`minkowski_sum_region`](crate::minkowski_sum_region),
/// [`no_fit_region`](crate::no_fit_region), [`entrance_region`](crate::entrance_region),
/// [`inner_fit_region`](crate::inner_fit_region), those that make many, and
/// [`Scene::free_region`](crate::Scene::free_region). It may be empty.
/// It never changes: a clone is the same one, and costs nothing. Two are equal where all their
/// parts are, the exact ones and those in `f64`. As text it is [`Region::wkt`].
///
/// The parts, in their order, are for each polygon its outer ring and then its holes; then
/// the segments; then the points. Outer rings are counter-clockwise, holes clockwise; each
/// ring begins in its lexicographically smallest vertex and is not closed. Segments and points
/// are positions where one polygon fits the other exactly.
///
/// In `f64` every ring is simple, no two rings cross, and holes lie in their polygon. A part
/// that `f64` cannot show is not there, see [`Stats::parts_dropped`]. A segment whose two ends
/// are one in `f64` is a point.
///
/// ```
/// use gcv::{minkowski_sum_region, Options, Polygon};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let outer = [[0., 0.], [10., 0.], [10., 10.], [0., 10.]];
/// let hole = [[1., 1.], [9., 1.], [9., 9.], [1., 9.]];
/// let frame = Polygon::from_rings([outer, hole])?;
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let region = minkowski_sum_region(&frame, &square, &Options::new())?;
/// for rings in region.polygons() {
///     assert_eq!(rings[0], [[0., 0.], [11., 0.], [11., 11.], [0., 11.]]);
///     assert_eq!(rings[1], [[2., 2.], [2., 9.], [9., 9.], [9., 2.]]);
/// }
/// assert_eq!(region.area()?, 121. - 49.);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Region(pub(crate) Handle<sys::gcv_region>);

impl Region {
    fn as_ptr(&self) -> *const sys::gcv_region {
        self.0.as_ptr()
    }

    /// Whether it has no part in `f64`, as where a polygon does not fit into a container.
    pub fn is_empty(&self) -> bool {
        // SAFETY: see `count`.
        let parts = count(|out, capacity, required| unsafe {
            sys::gcv_region_parts(self.as_ptr(), out, capacity, required)
        });
        parts == 0
    }

    /// The rings of every polygon: its outer ring, then its holes, as
    /// [`Polygon::from_rings`] takes them. [`Region::polygon`] gives one ready for the next
    /// sum.
    pub fn polygons(
        &self,
    ) -> impl ExactSizeIterator<Item = Vec<Vec<[f64; 2]>>> + DoubleEndedIterator {
        let vertices = self.vertices();
        let mut polygons: Vec<Vec<_>> = vec![];
        for part in self.parts() {
            let ring = vertices[part.vertices].to_vec();
            match part.kind {
                PartKind::Outer { .. } => polygons.push(vec![ring]),
                PartKind::Hole { polygon } => polygons[polygon].push(ring),
                PartKind::Segment | PartKind::Point => break,
            }
        }
        polygons.into_iter()
    }

    /// The two ends of every segment: one polygon fits the other exactly, and has room along
    /// a line only.
    pub fn segments(&self) -> Vec<[[f64; 2]; 2]> {
        let vertices = self.vertices();
        self.starts(PartKind::Segment)
            .map(|start| [vertices[start], vertices[start + 1]])
            .collect()
    }

    /// Every point: one polygon fits the other exactly, and has no room at all.
    pub fn points(&self) -> Vec<[f64; 2]> {
        let vertices = self.vertices();
        self.starts(PartKind::Point)
            .map(|start| vertices[start])
            .collect()
    }

    /// The first vertex of every part of a kind.
    fn starts(&self, kind: PartKind) -> impl Iterator<Item = usize> {
        let parts = self.parts().into_iter();
        parts.filter_map(move |part| (part.kind == kind).then_some(part.vertices.start))
    }

    /// The parts in `f64`, with what each has of [`Region::vertices`].
    ///
    /// ```
    /// use gcv::{no_fit_region, Options, PartKind, Polygon};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let slot = [(0., 0.), (6., 0.), (6., 6.), (4., 6.), (4., 2.), (2., 2.), (2., 6.), (0., 6.)];
    /// let slot = Polygon::new(&slot)?;
    /// let peg = Polygon::new(&[(0., 0.), (2., 0.), (2., 2.), (0., 2.)])?;
    /// let region = no_fit_region(&slot, &peg, [0., 0.], &Options::new())?;
    /// let parts = region.parts();
    /// assert_eq!(parts[0].kind, PartKind::Outer { polygon: 0 });
    /// assert_eq!(parts[1].kind, PartKind::Segment);
    /// assert_eq!(region.vertices()[parts[1].vertices.clone()], [[2., 2.], [2., 6.]]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn parts(&self) -> Vec<Part> {
        // SAFETY: see `elements`.
        placed(elements(|out, capacity, required| unsafe {
            sys::gcv_region_parts(self.as_ptr(), out, capacity, required)
        }))
    }

    /// The vertices of all parts, part after part, rounded as the options said.
    pub fn vertices(&self) -> Vec<[f64; 2]> {
        // SAFETY: see `elements`; a vertex is two doubles.
        elements(|out: *mut [f64; 2], capacity, required| unsafe {
            sys::gcv_region_vertices(self.as_ptr(), out.cast(), capacity, required)
        })
    }

    /// The smallest box around all parts: `[xmin, ymin, xmax, ymax]`; `None` without parts.
    pub fn bounds(&self) -> Option<[f64; 4]> {
        bounds_of(&self.vertices())
    }

    /// The parts of the exact region, with what each has of [`Region::exact_vertices`].
    ///
    /// They are canonical: the same set has the same parts, whatever the polygons that it was
    /// computed from. Rings have no collinear vertices, and visit no point twice. Segments are
    /// maximal and straight. They are not cut where segments cross, and are cut where they
    /// meet a ring. Points lie on no ring and on no segment.
    pub fn exact_parts(&self) -> Vec<Part> {
        // SAFETY: see `elements`.
        placed(elements(|out, capacity, required| unsafe {
            sys::gcv_region_exact_parts(self.as_ptr(), out, capacity, required)
        }))
    }

    /// The number of vertices of all exact parts.
    fn exact_vertex_count(&self) -> usize {
        // SAFETY: see `count`. There is one owner for each exact vertex.
        count(|out, capacity, required| unsafe {
            sys::gcv_region_edge_owners(self.as_ptr(), out, capacity, required)
        })
    }

    /// One vertex of the exact parts, part after part, as fractions `"p/q r/s"` in lowest
    /// terms. `None` where there is no such vertex.
    ///
    /// # Panics
    /// Without memory.
    pub fn exact_vertex(&self, index: usize) -> Option<String> {
        (index < self.exact_vertex_count()).then(|| self.known_exact_vertex(index))
    }

    fn known_exact_vertex(&self, index: usize) -> String {
        // SAFETY: see `string`.
        string(|out, capacity, required| unsafe {
            sys::gcv_region_exact_vertex(self.as_ptr(), index, out, capacity, required)
        })
    }

    /// The vertices of all exact parts, each as by [`Region::exact_vertex`].
    ///
    /// # Panics
    /// Without memory.
    pub fn exact_vertices(&self) -> Vec<String> {
        let indices = 0..self.exact_vertex_count();
        indices
            .map(|index| self.known_exact_vertex(index))
            .collect()
    }

    /// The vertices of all exact parts, as `[x, y]` each.
    ///
    /// # Panics
    /// Without memory.
    #[cfg(feature = "num-rational")]
    pub fn exact_rationals(&self) -> Vec<[num_rational::BigRational; 2]> {
        crate::exact::rationals(self.exact_vertices())
    }

    /// The exact vertex that each vertex of [`Region::vertices`] stands for, as an index in
    /// [`Region::exact_vertices`], [`Region::sources`] and [`Region::owners`].
    ///
    /// If several exact vertices fell together, it is the lowest of their indices. The edges
    /// between them have vanished, and the returned edge from there comes from that of the last
    /// of them along the ring. They can lie on both sides of the start of the ring. If rounding
    /// made a new vertex, it is the start of the exact edge that the returned edge from there
    /// lies closest to.
    pub fn exact_indices(&self) -> Vec<usize> {
        // SAFETY: see `elements`.
        let indices: Vec<u64> = elements(|out, capacity, required| unsafe {
            sys::gcv_region_exact_indices(self.as_ptr(), out, capacity, required)
        });
        indices.into_iter().map(|index| index as usize).collect()
    }

    /// The source of every edge of the exact parts: element `i` is for the edge from exact
    /// vertex `i` to the next one of its part. `None` for the second end of a segment and for
    /// a point, which have no edge, and for an edge that a window has cut.
    ///
    /// Of a free region, the first polygon is the container or the member that
    /// [`Region::owners`] names, the second one is the one that moves.
    ///
    /// # Panics
    /// Without memory.
    pub fn sources(&self) -> Vec<Option<EdgeSource>> {
        // SAFETY: see `elements`.
        let sources: Vec<sys::gcv_edge_source> = elements(|out, capacity, required| unsafe {
            sys::gcv_region_edge_sources(self.as_ptr(), out, capacity, required)
        });
        let convert = |source: sys::gcv_edge_source| (source.kind != 0).then(|| source.into());
        sources.into_iter().map(convert).collect()
    }

    /// The owner of every edge of the exact parts, as in [`Region::sources`].
    ///
    /// It is the id of the member of the scene that made the edge, or
    /// [`Scene::CONTAINER`](crate::Scene::CONTAINER); of several that made a straight edge, one
    /// of them. It is 0 for an edge that a window has cut, and for what is no edge. All are 0
    /// for regions of two polygons.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = |size| Polygon::new(&[[0., 0.], [size, 0.], [size, size], [0., size]]);
    /// let mut scene = Scene::new();
    /// scene.set_container(Some(&square(9.)?))?;
    /// let id = scene.add(&square(2.)?, [0., 0.])?;
    /// let region = scene.free_region(&square(1.)?, None, &Query::new(), &Options::new())?;
    /// assert_eq!(region.vertices()[0..3], [[0., 2.], [2., 2.], [2., 0.]]);
    /// assert_eq!(region.owners(), [id, id, 1, 1, 1, 1]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn owners(&self) -> Vec<u64> {
        // SAFETY: see `elements`.
        elements(|out, capacity, required| unsafe {
            sys::gcv_region_edge_owners(self.as_ptr(), out, capacity, required)
        })
    }

    /// The area of [`Region::polygons`] without their holes, in square units, correctly
    /// rounded; 0 for an empty region.
    ///
    /// # Errors
    /// `GCV_ERR_RANGE` where it is larger than any finite `f64`.
    pub fn area(&self) -> Result<f64, Error> {
        // SAFETY: the region is alive.
        value(|out| unsafe { sys::gcv_region_area(self.as_ptr(), out) })
    }

    /// An upper bound on the Hausdorff distance from the boundary in `f64` to the exact one,
    /// in input units: 0 where every exact coordinate is an `f64`.
    ///
    /// The boundary is all rings, segments and points. A part that was dropped counts with its
    /// extents. With a tolerance it is a bound between sets, as by
    /// [`OuterFace::error_bound`](crate::OuterFace::error_bound).
    pub fn error_bound(&self) -> f64 {
        // SAFETY: the region is alive.
        let bound = value(|out| unsafe { sys::gcv_region_error_bound(self.as_ptr(), out) });
        bound.expect(INFALLIBLE)
    }

    /// The polygons as Well-Known Text, `MULTIPOLYGON (((x y, ...), (hole)), ...)` or
    /// `MULTIPOLYGON EMPTY`, closed, which reads back to the same numbers.
    ///
    /// # Panics
    /// Without memory.
    pub fn wkt(&self) -> String {
        // SAFETY: see `string`.
        string(|out, capacity, required| unsafe {
            sys::gcv_region_wkt(self.as_ptr(), out, capacity, required)
        })
    }

    /// The segments and points as Well-Known Text,
    /// `GEOMETRYCOLLECTION (LINESTRING (x y, x y), ..., POINT (x y), ...)` or
    /// `GEOMETRYCOLLECTION EMPTY`, which reads back to the same numbers.
    ///
    /// # Panics
    /// Without memory.
    pub fn fits_wkt(&self) -> String {
        // SAFETY: see `string`.
        string(|out, capacity, required| unsafe {
            sys::gcv_region_fits_wkt(self.as_ptr(), out, capacity, required)
        })
    }

    /// One of [`Region::polygons`], for the next sum. Its numbers count its vertices in
    /// [`Region::vertices`], from 0.
    ///
    /// # Errors
    /// `GCV_ERR_INVALID_ARGUMENT` where there is no polygon of that number;
    /// `GCV_ERR_NO_MEMORY`.
    pub fn polygon(&self, polygon: usize) -> Result<Polygon, Error> {
        // SAFETY: the region is alive.
        create(|out| unsafe { sys::gcv_region_polygon(self.as_ptr(), polygon, out) }).map(Polygon)
    }

    /// Where points lie in the exact region, whatever the rounding.
    ///
    /// The first call makes an index; the next ones are faster for it.
    ///
    /// ```
    /// use gcv::{inner_fit_region, Location, Options, Polygon};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let sheet = Polygon::new(&[(0., 0.), (9., 0.), (9., 9.), (0., 9.)])?;
    /// let part = Polygon::new(&[(0., 0.), (2., 0.), (0., 1.)])?;
    /// let region = inner_fit_region(&sheet, &part, [0., 0.], &Options::new())?;
    /// let locations = region.locate(&[(3., 3.), (7., 3.), (8., 3.)])?;
    /// assert_eq!(locations, [Location::Inside, Location::Boundary, Location::Outside]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE`, and the message names the point; `GCV_ERR_NO_MEMORY`.
    pub fn locate<P: Point>(&self, points: &[P]) -> Result<Vec<Location>, Error> {
        let points: Vec<_> = points.iter().map(Point::xy).collect();
        let mut out = vec![sys::GCV_OUTSIDE; points.len()];
        let xy = points.as_ptr().cast();
        // SAFETY: the region is alive, and there is room for as many results as points.
        check(unsafe { sys::gcv_region_locate(self.as_ptr(), xy, points.len(), out.as_mut_ptr()) })
            .map_err(|error| error.renamed("xy:", "points:"))?;
        Ok(out.into_iter().map(Location::of).collect())
    }

    /// What the computation took.
    pub fn stats(&self) -> Stats {
        // SAFETY: the region is alive, and the struct has the size that it says.
        stats::read(|out| unsafe { sys::gcv_region_stats(self.as_ptr(), out) })
    }
}

impl fmt::Debug for Region {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Region")
            .field("polygons", &self.polygons().collect::<Vec<_>>())
            .field("segments", &self.segments())
            .field("points", &self.points())
            .finish()
    }
}

impl fmt::Display for Region {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(&self.wkt())
    }
}

impl PartialEq for Region {
    fn eq(&self, other: &Self) -> bool {
        self.as_ptr() == other.as_ptr()
            || self.parts() == other.parts()
                && self.vertices() == other.vertices()
                && self.exact_parts() == other.exact_parts()
                && self.exact_vertices() == other.exact_vertices()
    }
}

impl Eq for Region {}

impl Hash for Region {
    fn hash<H: Hasher>(&self, state: &mut H) {
        hash_ring(&self.vertices(), state);
    }
}

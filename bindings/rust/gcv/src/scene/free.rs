// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Where a polygon is free in scenes.

use std::ptr;

use gcv_sys as sys;

use super::Scene;
use crate::call::{check, create};
use crate::lengths::same_length;
use crate::{Error, Escape, Options, Polygon, Query, Region};

impl Scene {
    /// All positions at which a polygon lies in the container and overlaps no member.
    ///
    /// It may touch them, and they may touch and overlap one another. It is the inner fit of the
    /// container, less the no-fit regions of the members, with every exact fit as a segment or a
    /// point. All of it is free, its boundary too. It may be empty. [`Region::owners`] names the
    /// member that made each edge.
    ///
    /// With a window, `[xmin, ymin, xmax, ymax]`, the answer is what of that lies in the window.
    /// The polygons of the region are cut. Segments and points in the window and on its border
    /// stay. What the polygon cannot reach from there is not looked at. Without a container, or
    /// where the query ignores it, there must be a window.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = |size| Polygon::new(&[[0., 0.], [size, 0.], [size, size], [0., size]]);
    /// let (sheet, part) = (square(9.)?, square(3.)?);
    /// let mut scene = Scene::new();
    /// scene.set_container(Some(&sheet))?;
    /// scene.add_many(&[&part; 2], &[[0., 0.], [6., 0.]])?;
    /// let (query, options) = (Query::new(), Options::new());
    /// let region = scene.free_region(&part, None, &query, &options)?;
    /// assert_eq!(region.wkt(), "MULTIPOLYGON (((0 3, 6 3, 6 6, 0 6, 0 3)))");
    /// // Between the two there is just the room that it needs.
    /// assert_eq!(region.segments(), [[[3., 0.], [3., 3.]]]);
    ///
    /// let window = Some([2., 1., 4., 4.]);
    /// let region = scene.free_region(&part, window, &query, &options)?;
    /// assert_eq!(region.wkt(), "MULTIPOLYGON (((2 3, 4 3, 4 4, 2 4, 2 3)))");
    /// assert_eq!(region.segments(), [[[3., 1.], [3., 3.]]]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE` for the window; `GCV_ERR_INVALID_ARGUMENT` for a window without area,
    /// an option, a tolerance above 0, [`Options::leave_out_holes`], and where neither a window
    /// nor a container bounds the region; `GCV_ERR_RANGE` where a coordinate of the result is no
    /// finite `f64`, and where, rounding outward, a hole is too thin for `f64`;
    /// `GCV_ERR_CANCELLED`; `GCV_ERR_NO_MEMORY`. An empty region is no error.
    pub fn free_region(
        &self,
        moving: &Polygon,
        window: Option<[f64; 4]>,
        query: &Query,
        options: &Options,
    ) -> Result<Region, Error> {
        let (scene, moving, query) = (self.as_ptr(), moving.as_ptr(), query.raw());
        let window = window
            .as_ref()
            .map_or(ptr::null(), |window| window.as_ptr());
        // SAFETY: the scene and the polygon are alive, and the window if there is one; the query
        // and the options are for the call.
        let region = options.pass(|options| {
            create(|out| unsafe {
                sys::gcv_scene_free_region(scene, moving, window, &query, options, out)
            })
        });
        region.map(Region)
    }

    /// The free position of a polygon that is furthest in a direction; `None` where it is free
    /// nowhere.
    ///
    /// It is the one of [`Scene::free_region`] for which `x * direction[0] + y * direction[1]` is
    /// largest, found without the region. Of several, it is the lexicographically smallest.
    /// Direction `[-1., 0.]` places bottom-left: leftmost, and of these lowest.
    ///
    /// Which position it is, is decided exactly. In `f64` it is within 2 ulps of the exact one,
    /// and the polygon overlaps nothing there, if there is such a position. Otherwise it is the
    /// nearest one that was found on the way into what is free around, within 2^20 ulps. An exact
    /// fit that no `f64` within 2 ulps shows is passed over, and so is a corner where what is free
    /// is narrower than the gaps between `f64`, for the corner or fit that is furthest else. Where
    /// nothing else is free, it is the `f64` nearest to the exact one, and the polygon
    /// overlaps there: [`Scene::relation`] tells.
    ///
    /// It takes less time where a polygon with the same vertices was asked for before, and members
    /// were only added since.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let rectangle = |w, h| Polygon::new(&[[0., 0.], [w, 0.], [w, h], [0., h]]);
    /// let (sheet, part) = (rectangle(5., 4.)?, rectangle(2., 3.)?);
    /// let mut scene = Scene::new();
    /// scene.set_container(Some(&sheet))?;
    /// let mut places = vec![];
    /// while let Some(place) = scene.best(&part, [-1., 0.], &Query::new(), &Options::new())? {
    ///     scene.add(&part, place)?;
    ///     places.push(place);
    /// }
    /// assert_eq!(places, [[0., 0.], [2., 0.]]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE` for the direction; `GCV_ERR_INVALID_ARGUMENT` for direction
    /// `[0., 0.]`, without a container, for a query that ignores it, and for options as in
    /// [`Scene::free_region`]; `GCV_ERR_RANGE`; `GCV_ERR_CANCELLED`; `GCV_ERR_NO_MEMORY`.
    pub fn best(
        &self,
        moving: &Polygon,
        direction: [f64; 2],
        query: &Query,
        options: &Options,
    ) -> Result<Option<[f64; 2]>, Error> {
        let (scene, moving, query) = (self.as_ptr(), moving.as_ptr(), query.raw());
        let (direction, mut position, mut found) = (direction.as_ptr(), [0.; 2], 0);
        let out = position.as_mut_ptr();
        // SAFETY: the scene, the polygon and the direction are alive, the query and the options
        // are for the call, and there is room for a position and for a number.
        options.pass(|options| {
            check(unsafe {
                sys::gcv_scene_best(scene, moving, direction, &query, options, out, &mut found)
            })
        })?;
        Ok((found != 0).then_some(position))
    }

    /// How a polygon at a position gets out of all overlaps with members and the container: the
    /// shortest way to a free position.
    ///
    /// It is as [`penetration`](crate::penetration()), and [`Escape::id`] tells what the polygon
    /// touches at the end of the way: of several, the one with the smallest id. Where nothing is
    /// free, the depth is infinite, and the position is the given one.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Relation, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [4., 0.], [4., 4.], [0., 4.]])?;
    /// let mut scene = Scene::new();
    /// let ids = scene.add_many(&[&square; 2], &[[0., 0.], [8., 0.]])?;
    /// let (query, options) = (Query::new(), Options::new());
    /// // It overlaps the second one. Between the two there is just the room that it needs.
    /// let escape = scene.penetration(&square, [4.5, 2.], &query, &options)?;
    /// assert_eq!((escape.depth(), escape.position()), (0.5, [4., 2.]));
    /// assert_eq!((escape.id(), escape.relation()), (ids[0], Relation::Touching));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Scene::distance`]; `GCV_ERR_INVALID_ARGUMENT` also for a tolerance above 0 and for
    /// [`Options::leave_out_holes`].
    pub fn penetration(
        &self,
        moving: &Polygon,
        position: [f64; 2],
        query: &Query,
        options: &Options,
    ) -> Result<Escape, Error> {
        let mut out = [Escape::default()];
        self.penetration_into(moving, &[position], query, options, &mut out)?;
        Ok(out[0])
    }

    /// The penetration at each position, in their order.
    ///
    /// The positions are shared out over the threads of the options, and its progress function
    /// counts them and the steps of their searches. The call gives all answers or none.
    ///
    /// # Errors
    /// As [`Scene::penetration`].
    pub fn penetration_many(
        &self,
        moving: &Polygon,
        positions: &[[f64; 2]],
        query: &Query,
        options: &Options,
    ) -> Result<Vec<Escape>, Error> {
        let mut out = vec![Escape::default(); positions.len()];
        self.penetration_into(moving, positions, query, options, &mut out)?;
        Ok(out)
    }

    /// As [`Scene::penetration_many`], with the answers written to `out`, one for each position.
    ///
    /// On failure `out` is as it was.
    ///
    /// # Errors
    /// As [`Scene::penetration`]; `GCV_ERR_INVALID_ARGUMENT` also where the lengths differ.
    pub fn penetration_into(
        &self,
        moving: &Polygon,
        positions: &[[f64; 2]],
        query: &Query,
        options: &Options,
        out: &mut [Escape],
    ) -> Result<(), Error> {
        let count = same_length(("positions", positions), ("out", out))?;
        let (scene, moving, query) = (self.as_ptr(), moving.as_ptr(), query.raw());
        let (xy, out) = (positions.as_ptr().cast(), out.as_mut_ptr().cast());
        // SAFETY: the scene and the polygon are alive, the query and the options are for the
        // call, and there are as many positions and as much room as said.
        options.pass(|options| {
            check(unsafe {
                sys::gcv_scene_penetration(scene, moving, xy, count, &query, options, out)
            })
        })
    }
}

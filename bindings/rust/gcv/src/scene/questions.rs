// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Questions to scenes.

use gcv_sys as sys;

use super::Scene;
use crate::call::check;
use crate::lengths::same_length;
use crate::{Error, Impact, Options, Polygon, Query, Relation, Separation};

impl Scene {
    /// How a polygon at a position lies to the members and the container, exactly.
    ///
    /// It overlaps if it overlaps one of them, else it touches if it touches one, else it is
    /// apart.
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE` for a position; the message names its number.
    /// `GCV_ERR_INVALID_ARGUMENT` for an option; `GCV_ERR_CANCELLED`; `GCV_ERR_NO_MEMORY`.
    pub fn relation(
        &self,
        moving: &Polygon,
        position: [f64; 2],
        query: &Query,
        options: &Options,
    ) -> Result<Relation, Error> {
        let mut out = [Relation::Apart];
        self.relation_into(moving, &[position], query, options, &mut out)?;
        Ok(out[0])
    }

    /// The relation at each position, in their order.
    ///
    /// The positions are shared out over the threads of the options, and its progress function
    /// counts them. The call gives all relations or none.
    ///
    /// # Errors
    /// As [`Scene::relation`].
    pub fn relation_many(
        &self,
        moving: &Polygon,
        positions: &[[f64; 2]],
        query: &Query,
        options: &Options,
    ) -> Result<Vec<Relation>, Error> {
        let mut out = vec![Relation::Apart; positions.len()];
        self.relation_into(moving, positions, query, options, &mut out)?;
        Ok(out)
    }

    /// As [`Scene::relation_many`], with the relations written to `out`, one for each position.
    ///
    /// On failure `out` is as it was.
    ///
    /// # Errors
    /// As [`Scene::relation`]; `GCV_ERR_INVALID_ARGUMENT` also where the lengths differ.
    pub fn relation_into(
        &self,
        moving: &Polygon,
        positions: &[[f64; 2]],
        query: &Query,
        options: &Options,
        out: &mut [Relation],
    ) -> Result<(), Error> {
        let count = same_length(("positions", positions), ("out", out))?;
        let (scene, moving, query) = (self.as_ptr(), moving.as_ptr(), query.raw());
        let (xy, out) = (positions.as_ptr().cast(), out.as_mut_ptr().cast());
        // SAFETY: the scene and the polygon are alive, the query and the options are for the
        // call, and there are as many positions and as much room as said. What is written are
        // values of `Relation`.
        options.pass(|options| {
            check(unsafe {
                sys::gcv_scene_relation(scene, moving, xy, count, &query, options, out)
            })
        })
    }

    /// How far a polygon at a position is from the members and the container, and where it is
    /// nearest to one of them.
    ///
    /// It is as [`distance`](crate::distance()) from the nearest one, and
    /// [`Separation::id`] tells which that is, also where the distance is 0: of several, the one
    /// with the smallest id. The relation is that to the whole scene. Where there is nothing, the
    /// distance is infinite.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let mut scene = Scene::new();
    /// let ids = scene.add_many(&[&square, &square], &[[0., 0.], [9., 0.]])?;
    /// let (query, options) = (Query::new(), Options::new());
    /// let separation = scene.distance(&square, [6., 0.], &query, &options)?;
    /// assert_eq!((separation.id(), separation.distance()), (ids[1], 2.));
    ///
    /// let query = query.ignore(&ids);
    /// let separation = scene.distance(&square, [6., 0.], &query, &options)?;
    /// assert_eq!((separation.id(), separation.distance()), (0, f64::INFINITY));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Scene::relation`]; `GCV_ERR_RANGE` where a result is beyond the largest `f64`.
    pub fn distance(
        &self,
        moving: &Polygon,
        position: [f64; 2],
        query: &Query,
        options: &Options,
    ) -> Result<Separation, Error> {
        let mut out = [Separation::default()];
        self.distance_into(moving, &[position], query, options, &mut out)?;
        Ok(out[0])
    }

    /// The distance at each position, in their order.
    ///
    /// The positions are shared out over the threads of the options, and its progress function
    /// counts them. The call gives all distances or none.
    ///
    /// # Errors
    /// As [`Scene::distance`].
    pub fn distance_many(
        &self,
        moving: &Polygon,
        positions: &[[f64; 2]],
        query: &Query,
        options: &Options,
    ) -> Result<Vec<Separation>, Error> {
        let mut out = vec![Separation::default(); positions.len()];
        self.distance_into(moving, positions, query, options, &mut out)?;
        Ok(out)
    }

    /// As [`Scene::distance_many`], with the distances written to `out`, one for each position.
    ///
    /// On failure `out` is as it was.
    ///
    /// # Errors
    /// As [`Scene::distance`]; `GCV_ERR_INVALID_ARGUMENT` also where the lengths differ.
    pub fn distance_into(
        &self,
        moving: &Polygon,
        positions: &[[f64; 2]],
        query: &Query,
        options: &Options,
        out: &mut [Separation],
    ) -> Result<(), Error> {
        let count = same_length(("positions", positions), ("out", out))?;
        let (scene, moving, query) = (self.as_ptr(), moving.as_ptr(), query.raw());
        let (xy, out) = (positions.as_ptr().cast(), out.as_mut_ptr().cast());
        // SAFETY: the scene and the polygon are alive, the query and the options are for the
        // call, and there are as many positions and as much room as said.
        options.pass(|options| {
            check(unsafe {
                sys::gcv_scene_distance(scene, moving, xy, count, &query, options, out)
            })
        })
    }

    /// How far a polygon can move from a position along a motion before it overlaps a member or
    /// the container.
    ///
    /// It is as [`cast`](crate::cast()) to the first one that is hit, and [`Impact::id`] tells
    /// which that is: of several at the same time, the one with the smallest id. Position and
    /// relation are about the whole scene.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Relation, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let mut scene = Scene::new();
    /// let ids = scene.add_many(&[&square, &square], &[[5., 0.], [9., 0.]])?;
    /// let (query, options) = (Query::new(), Options::new());
    /// let impact = scene.cast(&square, [0., 0.], [8., 0.], &query, &options)?;
    /// assert!(impact.hit());
    /// assert_eq!((impact.id(), impact.time()), (ids[0], 0.5));
    /// assert_eq!(impact.position(), [4., 0.]);
    /// assert_eq!(impact.relation(), Relation::Touching);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Scene::distance`], for the motion too.
    pub fn cast(
        &self,
        moving: &Polygon,
        position: [f64; 2],
        motion: [f64; 2],
        query: &Query,
        options: &Options,
    ) -> Result<Impact, Error> {
        let mut out = [Impact::default()];
        self.cast_into(moving, &[position], &[motion], query, options, &mut out)?;
        Ok(out[0])
    }

    /// The impact of every motion, in their order, each from the position of the same number.
    ///
    /// The motions are shared out over the threads of the options, and its progress function
    /// counts them. The call gives all impacts or none.
    ///
    /// # Errors
    /// As [`Scene::cast`]; `GCV_ERR_INVALID_ARGUMENT` also where the lengths differ.
    pub fn cast_many(
        &self,
        moving: &Polygon,
        positions: &[[f64; 2]],
        motions: &[[f64; 2]],
        query: &Query,
        options: &Options,
    ) -> Result<Vec<Impact>, Error> {
        let mut out = vec![Impact::default(); positions.len()];
        self.cast_into(moving, positions, motions, query, options, &mut out)?;
        Ok(out)
    }

    /// As [`Scene::cast_many`], with the impacts written to `out`, one for each motion.
    ///
    /// On failure `out` is as it was.
    ///
    /// # Errors
    /// As [`Scene::cast_many`].
    pub fn cast_into(
        &self,
        moving: &Polygon,
        positions: &[[f64; 2]],
        motions: &[[f64; 2]],
        query: &Query,
        options: &Options,
        out: &mut [Impact],
    ) -> Result<(), Error> {
        same_length(("positions", positions), ("motions", motions))?;
        let count = same_length(("positions", positions), ("out", out))?;
        let (scene, moving, query) = (self.as_ptr(), moving.as_ptr(), query.raw());
        let (from, motions) = (positions.as_ptr().cast(), motions.as_ptr().cast());
        let out = out.as_mut_ptr().cast();
        // SAFETY: the scene and the polygon are alive, the query and the options are for the
        // call, and there are as many positions and motions and as much room as said.
        options.pass(|options| {
            check(unsafe {
                sys::gcv_scene_cast(scene, moving, from, motions, count, &query, options, out)
            })
        })
    }
}

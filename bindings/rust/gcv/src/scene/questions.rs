// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Questions to scenes.

use std::ptr;

use gcv_sys as sys;

use super::Scene;
use crate::call::{check, create};
use crate::lengths::same_length;
use crate::{ContactList, Error, Impact, Options, PairList, Polygon, Query, Relation, Separation};

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

    /// The members, and the container, that are no further than `distance` from a polygon at a
    /// position, from the smallest id on.
    ///
    /// [`Pair::a`](crate::Pair::a) is the id, [`Pair::b`](crate::Pair::b) is 0. Which they are is
    /// decided exactly.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Relation, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let mut scene = Scene::new();
    /// let positions = [[0., 0.], [2., 0.], [4., 0.]];
    /// let ids = scene.add_many(&[&square; 3], &positions)?;
    /// let near = scene.near(&square, [1., 0.], 0.5, &Query::new(), &Options::new())?;
    /// let near: Vec<_> = near.iter().map(|pair| (pair.a(), pair.relation())).collect();
    /// assert_eq!(near, [(ids[0], Relation::Touching), (ids[1], Relation::Touching)]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Scene::relation`], for the distance too; `GCV_ERR_INVALID_ARGUMENT` also for a
    /// distance below 0.
    pub fn near(
        &self,
        moving: &Polygon,
        position: [f64; 2],
        distance: f64,
        query: &Query,
        options: &Options,
    ) -> Result<PairList, Error> {
        let (scene, moving, query) = (self.as_ptr(), moving.as_ptr(), query.raw());
        let xy = position.as_ptr();
        // SAFETY: the scene, the polygon and the position are alive, the query and the options
        // are for the call.
        let list = options.pass(|options| {
            create(|out| unsafe {
                sys::gcv_scene_near(scene, moving, xy, distance, &query, options, out)
            })
        });
        list.map(PairList::of)
    }

    /// All pairs of members, and of the container and a member, that are no further than
    /// `distance` from each other: a < b, from the smallest a on, then by b.
    ///
    /// `previous` is an earlier list that this gave for the scene, or for one that it was copied
    /// from or to. What has not moved since is not computed again. The list is the same as without
    /// it.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Relation, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let mut scene = Scene::new();
    /// let ids = scene.add_many(&[&square; 3], &[[0., 0.], [1., 0.], [9., 0.]])?;
    /// let (query, options) = (Query::new(), Options::new());
    /// let pairs = scene.pairs(None, 0., &query, &options)?;
    /// assert_eq!(pairs.len(), 1);
    /// assert_eq!((pairs[0].a(), pairs[0].b()), (ids[0], ids[1]));
    /// assert_eq!(pairs[0].relation(), Relation::Touching);
    ///
    /// scene.set_positions(&[ids[2]], &[[1.5, 0.5]])?;
    /// let pairs = scene.pairs(Some(&pairs), 0., &query, &options)?;
    /// assert_eq!(pairs.len(), 2);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// `GCV_ERR_NOT_FINITE` for the distance; `GCV_ERR_INVALID_ARGUMENT` for one below 0, an
    /// option, or a list of another scene or of [`Scene::near`]; `GCV_ERR_CANCELLED`;
    /// `GCV_ERR_NO_MEMORY`.
    pub fn pairs(
        &self,
        previous: Option<&PairList>,
        distance: f64,
        query: &Query,
        options: &Options,
    ) -> Result<PairList, Error> {
        let (scene, query) = (self.as_ptr(), query.raw());
        let previous = previous.map_or(ptr::null(), PairList::as_list_ptr);
        // SAFETY: the scene is alive, and the list if there is one; the query and the options
        // are for the call.
        let list = options.pass(|options| {
            create(|out| unsafe {
                sys::gcv_scene_pairs(scene, previous, distance, &query, options, out)
            })
        });
        list.map(PairList::of)
    }

    /// The contacts of all pairs of members, and of the container and members, within a distance:
    /// those of [`contacts`](crate::contacts()), with ids.
    ///
    /// They are in the order of |gap|, then of [`Contact::id_a`](crate::Contact::id_a), of
    /// [`Contact::id_b`](crate::Contact::id_b), of kind, and of the numbers. The first id is the
    /// smaller one.
    ///
    /// `previous` is an earlier list that this gave for the scene, or for one that it was copied
    /// from or to. What has not moved since is not computed again, and [`ContactList::previous`] tells
    /// which contacts were there: so what is known of a contact can be kept.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [2., 0.], [2., 2.], [0., 2.]])?;
    /// let mut scene = Scene::new();
    /// let ids = scene.add_many(&[&square; 2], &[[0., 0.], [1., 2.]])?;
    /// let (query, options) = (Query::new(), Options::new());
    /// let contacts = scene.contacts(None, 0.25, 0., &query, &options)?;
    /// let places: Vec<_> = contacts.iter().map(|contact| contact.on_a()).collect();
    /// assert_eq!(places, [[1., 2.], [2., 2.]]);
    /// assert_eq!((contacts[0].id_a(), contacts[0].id_b()), (ids[0], ids[1]));
    ///
    /// scene.set_positions(&[ids[1]], &[[1., 2.125]])?;
    /// let contacts = scene.contacts(Some(&contacts), 0.25, 0., &query, &options)?;
    /// assert_eq!(contacts.previous(), [Some(0), Some(1)]);
    /// assert_eq!(contacts[0].gap(), 0.125);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Scene::pairs`], for the slope too; `GCV_ERR_RANGE` where a result is beyond the
    /// largest `f64`.
    pub fn contacts(
        &self,
        previous: Option<&ContactList>,
        distance: f64,
        slope: f64,
        query: &Query,
        options: &Options,
    ) -> Result<ContactList, Error> {
        let (scene, query) = (self.as_ptr(), query.raw());
        let previous = previous.map_or(ptr::null(), ContactList::as_list_ptr);
        // SAFETY: the scene is alive, and the list if there is one; the query and the options
        // are for the call.
        let list = options.pass(|options| {
            create(|out| unsafe {
                sys::gcv_scene_contacts(scene, previous, distance, slope, &query, options, out)
            })
        });
        list.map(ContactList::of)
    }
}

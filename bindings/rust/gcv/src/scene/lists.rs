// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What is near in scenes, as lists.

use std::ptr;

use gcv_sys as sys;

use super::Scene;
use crate::call::create;
use crate::{ContactList, Error, Options, PairList, Polygon, Query};

impl Scene {
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

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Scenes: how they are made and changed, and what is in them.

use std::fmt;
use std::ptr;

use gcv_sys as sys;

use crate::call::{check, count, create, create_owned, elements, INFALLIBLE};
use crate::handle::Owned;
use crate::lengths::same_length;
use crate::{Error, Polygon};

mod free;
mod lists;
mod questions;

/// Polygons at positions, the members, and perhaps a container round them.
///
/// A member is its polygon moved by its position, exactly: its coordinates are sums of two `f64`,
/// which are never rounded. Members may touch and overlap. The solid of a container is all
/// outside of it, and its holes are solid: what lies in the container touches the solid or is
/// apart from it.
///
/// Members have ids: 2, 3, 4, ... as they are added. An id is never used again. The container's
/// is [`Scene::CONTAINER`].
///
/// What changes a scene takes `&mut self`, and does all or nothing: where it fails, the scene is
/// as it was. Questions take `&self`, so any number of threads may ask at a time. A
/// [`Query`](crate::Query) says which members a question is about.
///
/// ```
/// use gcv::{Options, Polygon, Query, Relation, Scene};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [2., 0.], [2., 2.], [0., 2.]])?;
/// let sheet = Polygon::new(&[[0., 0.], [9., 0.], [9., 9.], [0., 9.]])?;
/// let mut scene = Scene::new();
/// scene.set_container(Some(&sheet))?;
/// let id = scene.add(&square, [0., 0.])?;
///
/// let (query, options) = (Query::new(), Options::new());
/// let positions = [[2., 0.], [3., 1.], [8., 1.]];
/// let relations = scene.relation_many(&square, &positions, &query, &options)?;
/// assert_eq!(relations, [Relation::Touching, Relation::Apart, Relation::Overlapping]);
///
/// scene.set_positions(&[id], &[[6., 0.]])?;
/// let impact = scene.cast(&square, [0., 0.], [8., 0.], &query, &options)?;
/// assert_eq!((impact.id(), impact.position()), (id, [4., 0.]));
/// # Ok(())
/// # }
/// ```
pub struct Scene(Owned<sys::gcv_scene>);

impl Scene {
    /// The id of the container.
    pub const CONTAINER: u64 = 1;

    /// A scene without members and container.
    ///
    /// # Panics
    /// Without memory.
    pub fn new() -> Self {
        // SAFETY: there is room for a pointer.
        let scene = create_owned(|out| unsafe { sys::gcv_scene_create(out) });
        Self(scene.expect(INFALLIBLE))
    }

    /// A scene with the same members, ids and container. From then on each changes alone; members
    /// that are added to both get the same ids.
    ///
    /// `clone` is the same, and panics without memory.
    ///
    /// # Errors
    /// `GCV_ERR_NO_MEMORY`.
    pub fn try_clone(&self) -> Result<Self, Error> {
        // SAFETY: the scene is alive.
        create_owned(|out| unsafe { sys::gcv_scene_copy(self.as_ptr(), out) }).map(Self)
    }

    fn as_ptr(&self) -> *const sys::gcv_scene {
        self.0.as_ptr()
    }

    fn as_mut_ptr(&mut self) -> *mut sys::gcv_scene {
        self.0.as_mut_ptr()
    }

    /// Puts a container round the scene, in place of the one that there may be; `None` for none.
    /// It may overlap members.
    ///
    /// # Errors
    /// `GCV_ERR_NO_MEMORY`.
    pub fn set_container(&mut self, container: Option<&Polygon>) -> Result<(), Error> {
        let container = container.map_or(ptr::null(), Polygon::as_ptr);
        // SAFETY: the scene is alive, and the container if there is one.
        check(unsafe { sys::gcv_scene_set_container(self.as_mut_ptr(), container) })
    }

    /// Adds a member, in every layer, and gives its id.
    ///
    /// # Errors
    /// As [`Scene::add_many`].
    pub fn add(&mut self, polygon: &Polygon, position: [f64; 2]) -> Result<u64, Error> {
        let (mut id, polygon) = (0, polygon.as_ptr());
        // SAFETY: the scene and the polygon are alive, and there is room for one id.
        check(unsafe {
            sys::gcv_scene_add(self.as_mut_ptr(), &polygon, position.as_ptr(), 1, &mut id)
        })
        .map(|()| id)
    }

    /// Adds members, in every layer, and gives their ids in the order of the polygons.
    ///
    /// The same polygon may be given many times: what is computed for it is shared.
    ///
    /// ```
    /// use gcv::{Polygon, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let triangle = Polygon::new(&[[0., 0.], [1., 0.], [0., 1.]])?;
    /// let mut scene = Scene::new();
    /// let ids = scene.add_many(&[&square, &triangle], &[[0., 0.], [5., 0.]])?;
    /// assert_eq!(ids, [2, 3]);
    /// assert_eq!(scene.add(&square, [0., 5.])?, 4);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// `GCV_ERR_INVALID_ARGUMENT` where the lengths differ; `GCV_ERR_NOT_FINITE` for a position;
    /// `GCV_ERR_NO_MEMORY`.
    pub fn add_many(
        &mut self,
        polygons: &[&Polygon],
        positions: &[[f64; 2]],
    ) -> Result<Vec<u64>, Error> {
        let count = same_length(("polygons", polygons), ("positions", positions))?;
        let (polygons, xy) = (pointers(polygons), positions.as_ptr().cast());
        let mut ids = vec![0; count];
        let out = ids.as_mut_ptr();
        // SAFETY: the scene and the polygons are alive, and there are as many polygons and
        // positions and as much room as said.
        check(unsafe { sys::gcv_scene_add(self.as_mut_ptr(), polygons.as_ptr(), xy, count, out) })?;
        Ok(ids)
    }

    /// Gives members other polygons and moves them.
    ///
    /// # Errors
    /// `GCV_ERR_INVALID_ARGUMENT` for an id that is no member's or is given twice, and where the
    /// lengths differ; `GCV_ERR_NOT_FINITE` for a position; `GCV_ERR_NO_MEMORY`.
    pub fn set(
        &mut self,
        ids: &[u64],
        polygons: &[&Polygon],
        positions: &[[f64; 2]],
    ) -> Result<(), Error> {
        same_length(("ids", ids), ("polygons", polygons))?;
        let count = same_length(("ids", ids), ("positions", positions))?;
        let (scene, ids, polygons) = (self.as_mut_ptr(), ids.as_ptr(), pointers(polygons));
        let xy = positions.as_ptr().cast();
        // SAFETY: the scene and the polygons are alive, and there are as many ids, polygons and
        // positions as said.
        check(unsafe { sys::gcv_scene_set(scene, ids, polygons.as_ptr(), xy, count) })
    }

    /// Moves members; each keeps its polygon.
    ///
    /// ```
    /// use gcv::{status, Polygon, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let mut scene = Scene::new();
    /// let id = scene.add(&square, [0., 0.])?;
    /// scene.set_positions(&[id], &[[5., 0.]])?;
    /// let error = scene.set_positions(&[id, 7], &[[6., 0.], [7., 0.]]).unwrap_err();
    /// assert_eq!(error.status, status::GCV_ERR_INVALID_ARGUMENT);
    /// assert_eq!(scene.positions(&[id])?, [[5., 0.]]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Scene::set`].
    pub fn set_positions(&mut self, ids: &[u64], positions: &[[f64; 2]]) -> Result<(), Error> {
        let count = same_length(("ids", ids), ("positions", positions))?;
        let (scene, ids, xy) = (self.as_mut_ptr(), ids.as_ptr(), positions.as_ptr().cast());
        // SAFETY: the scene is alive, and there are as many ids and positions as said.
        check(unsafe { sys::gcv_scene_set(scene, ids, ptr::null(), xy, count) })
    }

    /// Gives members other polygons; each keeps its position.
    ///
    /// # Errors
    /// As [`Scene::set`].
    pub fn set_polygons(&mut self, ids: &[u64], polygons: &[&Polygon]) -> Result<(), Error> {
        let count = same_length(("ids", ids), ("polygons", polygons))?;
        let (scene, ids, polygons) = (self.as_mut_ptr(), ids.as_ptr(), pointers(polygons));
        // SAFETY: the scene and the polygons are alive, and there are as many ids and polygons as
        // said.
        check(unsafe { sys::gcv_scene_set(scene, ids, polygons.as_ptr(), ptr::null(), count) })
    }

    /// Puts members into layers: a bit for every layer that each of them is in. A member in no
    /// layer is in no answer.
    ///
    /// ```
    /// use gcv::{Options, Polygon, Query, Relation, Scene};
    ///
    /// # fn main() -> Result<(), gcv::Error> {
    /// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
    /// let mut scene = Scene::new();
    /// let id = scene.add(&square, [0., 0.])?;
    /// scene.set_layers(&[id], &[0b10])?;
    /// let ask = |layers| {
    ///     let query = Query::new().layers(layers);
    ///     scene.relation(&square, [0., 0.], &query, &Options::new())
    /// };
    /// assert_eq!(ask(0b11)?, Relation::Overlapping);
    /// assert_eq!(ask(0b01)?, Relation::Apart);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Scene::set`].
    pub fn set_layers(&mut self, ids: &[u64], layers: &[u32]) -> Result<(), Error> {
        let count = same_length(("ids", ids), ("layers", layers))?;
        let (scene, ids, layers) = (self.as_mut_ptr(), ids.as_ptr(), layers.as_ptr());
        // SAFETY: the scene is alive, and there are as many ids and layers as said.
        check(unsafe { sys::gcv_scene_set_layers(scene, ids, layers, count) })
    }

    /// Takes members out of the scene.
    ///
    /// # Errors
    /// As [`Scene::set`].
    pub fn remove(&mut self, ids: &[u64]) -> Result<(), Error> {
        // SAFETY: the scene is alive, and there are as many ids as said.
        check(unsafe { sys::gcv_scene_remove(self.as_mut_ptr(), ids.as_ptr(), ids.len()) })
    }

    /// The number of members. The container is none.
    pub fn len(&self) -> usize {
        // SAFETY: see `count`.
        count(|out, capacity, required| unsafe {
            sys::gcv_scene_ids(self.as_ptr(), out, capacity, required)
        })
    }

    /// Whether there is no member.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The ids of all members, from the smallest on. The container's is not among them.
    pub fn ids(&self) -> Vec<u64> {
        // SAFETY: see `elements`.
        elements(|out, capacity, required| unsafe {
            sys::gcv_scene_ids(self.as_ptr(), out, capacity, required)
        })
    }

    /// The positions of members, in the order of the ids.
    ///
    /// # Errors
    /// `GCV_ERR_INVALID_ARGUMENT` for an id that is no member's or is given twice;
    /// `GCV_ERR_NO_MEMORY`.
    pub fn positions(&self, ids: &[u64]) -> Result<Vec<[f64; 2]>, Error> {
        let mut positions = vec![[0.; 2]; ids.len()];
        let (count, xy) = (ids.len(), positions.as_mut_ptr().cast());
        // SAFETY: the scene is alive, and there are as many ids and as much room as said.
        check(unsafe { sys::gcv_scene_positions(self.as_ptr(), ids.as_ptr(), count, xy) })?;
        Ok(positions)
    }

    /// The polygon of a member, where it is before it is moved to its position.
    ///
    /// # Errors
    /// `GCV_ERR_INVALID_ARGUMENT` for an id that is no member's; `GCV_ERR_NO_MEMORY`.
    pub fn polygon(&self, id: u64) -> Result<Polygon, Error> {
        // SAFETY: the scene is alive.
        create(|out| unsafe { sys::gcv_scene_polygon(self.as_ptr(), id, out) }).map(Polygon)
    }
}

/// What the C interface takes for polygons.
fn pointers(polygons: &[&Polygon]) -> Vec<*const sys::gcv_polygon> {
    polygons.iter().map(|polygon| polygon.as_ptr()).collect()
}

impl Default for Scene {
    fn default() -> Self {
        Self::new()
    }
}

/// As [`Scene::try_clone`]; panics without memory.
impl Clone for Scene {
    fn clone(&self) -> Self {
        self.try_clone().expect(INFALLIBLE)
    }
}

impl fmt::Debug for Scene {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let ids = self.ids();
        let positions = self.positions(&ids).expect(INFALLIBLE);
        formatter
            .debug_struct("Scene")
            .field("ids", &ids)
            .field("positions", &positions)
            .finish()
    }
}

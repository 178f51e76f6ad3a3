// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use gcv_sys as sys;

/// Which members of a [`Scene`](crate::Scene) a question is about.
///
/// ```
/// use gcv::{Options, Polygon, Query, Relation, Scene};
///
/// # fn main() -> Result<(), gcv::Error> {
/// let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]])?;
/// let mut scene = Scene::new();
/// let member = scene.add(&square, [0., 0.])?;
/// let ask = |query: Query| scene.relation(&square, [0.5, 0.], &query, &Options::new());
/// assert_eq!(ask(Query::new())?, Relation::Overlapping);
/// // A member that moves does not block itself.
/// assert_eq!(ask(Query::new().ignore(&[member]))?, Relation::Apart);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Query<'a> {
    layers: u32,
    ignore: &'a [u64],
}

impl<'a> Query<'a> {
    /// All members and the container.
    pub fn new() -> Self {
        Self {
            layers: u32::MAX,
            ignore: &[],
        }
    }

    /// Only members whose layers share a bit with these. The container is in every layer. With
    /// 0 there is neither.
    #[must_use]
    pub fn layers(mut self, layers: u32) -> Self {
        self.layers = layers;
        self
    }

    /// Without the members of these ids, and without the container if
    /// [`Scene::CONTAINER`](crate::Scene::CONTAINER) is among them. Ids that are not in the
    /// scene are no error.
    #[must_use]
    pub fn ignore(mut self, ids: &'a [u64]) -> Self {
        self.ignore = ids;
        self
    }

    /// As the C interface takes it, as long as the ids are there.
    pub(crate) fn raw(&self) -> sys::gcv_query {
        sys::gcv_query {
            layers: self.layers,
            ignore: self.ignore.as_ptr(),
            ignore_count: self.ignore.len(),
            ..sys::GCV_QUERY_INIT
        }
    }
}

impl Default for Query<'_> {
    fn default() -> Self {
        Self::new()
    }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::fmt;
use std::ops::Deref;
use std::slice;
use std::sync::Arc;

use gcv_sys as sys;

use crate::call::elements;
use crate::handle::Handle;
use crate::Relation;

/// Two members of a [`Scene`](crate::Scene), or the container and a member, and how they lie.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Pair(sys::gcv_pair);

impl Pair {
    /// The id of the first one; the container's is
    /// [`Scene::CONTAINER`](crate::Scene::CONTAINER).
    pub fn a(&self) -> u64 {
        self.0.a
    }

    /// The id of the second one; 0 for a polygon that is no member, as in
    /// [`Scene::near`](crate::Scene::near).
    pub fn b(&self) -> u64 {
        self.0.b
    }

    /// How they lie, exactly.
    pub fn relation(&self) -> Relation {
        Relation::of(self.0.relation)
    }
}

impl fmt::Debug for Pair {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Pair")
            .field("a", &self.a())
            .field("b", &self.b())
            .field("relation", &self.relation())
            .finish()
    }
}

/// Pairs of a scene: a slice of [`Pair`], from the smallest ids on.
///
/// Made by [`Scene::near`](crate::Scene::near) and [`Scene::pairs`](crate::Scene::pairs). It never
/// changes: a clone is the same one, and costs nothing. Two are equal where their pairs are.
#[derive(Clone)]
pub struct PairList {
    list: Handle<sys::gcv_pair_list>,
    pairs: Arc<[Pair]>,
}

impl PairList {
    /// With what the library's list has.
    pub(crate) fn of(list: Handle<sys::gcv_pair_list>) -> Self {
        // SAFETY: see `elements`.
        let pairs: Vec<sys::gcv_pair> = elements(|out, capacity, required| unsafe {
            sys::gcv_pair_list_pairs(list.as_ptr(), out, capacity, required)
        });
        Self {
            list,
            pairs: pairs.into_iter().map(Pair).collect(),
        }
    }

    pub(crate) fn as_list_ptr(&self) -> *const sys::gcv_pair_list {
        self.list.as_ptr()
    }
}

impl Deref for PairList {
    type Target = [Pair];

    fn deref(&self) -> &[Pair] {
        &self.pairs
    }
}

impl AsRef<[Pair]> for PairList {
    fn as_ref(&self) -> &[Pair] {
        self
    }
}

impl<'a> IntoIterator for &'a PairList {
    type Item = &'a Pair;
    type IntoIter = slice::Iter<'a, Pair>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl PartialEq for PairList {
    fn eq(&self, other: &Self) -> bool {
        self.pairs == other.pairs
    }
}

impl Eq for PairList {}

impl fmt::Debug for PairList {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.debug_list().entries(self).finish()
    }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::mem::size_of;

use gcv_sys as sys;

use crate::call::{check, INFALLIBLE};

/// What a computation took: counts, not times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Stats {
    /// Edges that the walk went along.
    pub walk_steps: u64,
    /// Superset edges that it looked at.
    pub candidate_edges: u64,
    /// Predicates settled by doubles with a proven error bound or by indices.
    pub predicates_filtered: u64,
    /// Predicates settled by pairs of doubles or integers of at most 512 bits.
    pub predicates_fixed_width: u64,
    /// Predicates that needed larger integers, of up to 21,504 bits.
    pub predicates_rational: u64,
    /// Vertices moved further than to the nearest double to keep rings simple and apart.
    pub vertices_repaired: u64,
    /// Parts of the exact region that are not in the returned one, for doubles cannot show
    /// them. Always 0 for outer faces.
    pub parts_dropped: u64,
}

/// What a function tells of a computation. It gets a struct that has the size that it says.
pub(crate) fn read(call: impl FnOnce(*mut sys::gcv_stats) -> i32) -> Stats {
    let mut stats = sys::gcv_stats {
        struct_size: size_of::<sys::gcv_stats>() as u32,
        ..Default::default()
    };
    check(call(&mut stats)).expect(INFALLIBLE);
    Stats {
        walk_steps: stats.walk_steps,
        candidate_edges: stats.candidate_edges,
        predicates_filtered: stats.predicates_filtered,
        predicates_fixed_width: stats.predicates_fixed_width,
        predicates_rational: stats.predicates_rational,
        vertices_repaired: stats.vertices_repaired,
        parts_dropped: stats.parts_dropped,
    }
}

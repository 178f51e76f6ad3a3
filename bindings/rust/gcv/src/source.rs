// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use gcv_sys as sys;

/// Where an edge of a sum comes from.
///
/// The numbers are those of the caller: vertex `k` as passed, edge `k` from vertex `k`
/// to `k + 1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EdgeSource {
    /// An edge of the first polygon, translated by a vertex of the second.
    Translated {
        /// The edge of the first polygon.
        edge_a: usize,
        /// The vertex of the second polygon.
        vertex_b: usize,
    },
    /// An edge of the second polygon, translated by a vertex of the first.
    Corner {
        /// The vertex of the first polygon.
        vertex_a: usize,
        /// The edge of the second polygon.
        edge_b: usize,
    },
    /// Two edges of the same direction, merged.
    TranslatedCorner {
        /// The edge of the first polygon.
        edge_a: usize,
        /// The edge of the second polygon.
        edge_b: usize,
    },
}

impl From<sys::gcv_edge_source> for EdgeSource {
    fn from(source: sys::gcv_edge_source) -> Self {
        let (a, b) = (source.a as usize, source.b as usize);
        match source.kind {
            sys::GCV_EDGE_TRANSLATED => Self::Translated {
                edge_a: a,
                vertex_b: b,
            },
            sys::GCV_EDGE_CORNER => Self::Corner {
                vertex_a: a,
                edge_b: b,
            },
            sys::GCV_EDGE_TRANSLATED_CORNER => Self::TranslatedCorner {
                edge_a: a,
                edge_b: b,
            },
            kind => unreachable!("libgcv gives three kinds of edges, and gave {kind}"),
        }
    }
}

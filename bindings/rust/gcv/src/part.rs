// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use std::ops::Range;

use gcv_sys as sys;

/// One part of a region.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Part {
    /// What it is.
    pub kind: PartKind,
    /// Which of the vertices of all parts it has.
    pub vertices: Range<usize>,
}

/// What a part of a region is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PartKind {
    /// The outer ring of a polygon, counter-clockwise.
    Outer {
        /// The number of the polygon, from 0.
        polygon: usize,
    },
    /// The ring of a hole, clockwise.
    Hole {
        /// The number of the polygon that it is in.
        polygon: usize,
    },
    /// A segment: two vertices.
    Segment,
    /// A point: one vertex.
    Point,
}

/// The parts with their places among the vertices of all of them.
pub(crate) fn placed(parts: Vec<sys::gcv_region_part>) -> Vec<Part> {
    let mut end = 0;
    let place = |part: sys::gcv_region_part| {
        let polygon = part.polygon as usize;
        let kind = match part.kind {
            sys::GCV_PART_OUTER => PartKind::Outer { polygon },
            sys::GCV_PART_HOLE => PartKind::Hole { polygon },
            sys::GCV_PART_SEGMENT => PartKind::Segment,
            sys::GCV_PART_POINT => PartKind::Point,
            kind => unreachable!("libgcv gives four kinds of parts, and gave {kind}"),
        };
        let start = end;
        end += part.vertex_count as usize;
        let vertices = start..end;
        Part { kind, vertices }
    };
    parts.into_iter().map(place).collect()
}

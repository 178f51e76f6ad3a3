// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

use gcv_sys as sys;

/// Where a point lies in a region.
///
/// In a no-fit region, the two polygons overlap with the point inside, touch with it on the
/// boundary, and are apart with it outside. In an inner-fit region, the polygon fits into the
/// container with the point inside or on the boundary. In a free region, the polygon overlaps
/// nothing at a position inside or on the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Location {
    /// In the interior of a polygon, and on no segment and no point.
    Inside,
    /// On a ring, a segment or a point.
    Boundary,
    /// Anywhere else; a hole is outside.
    Outside,
}

impl Location {
    /// What the C interface calls so.
    pub(crate) fn of(location: i8) -> Self {
        match location {
            sys::GCV_INSIDE => Self::Inside,
            sys::GCV_BOUNDARY => Self::Boundary,
            sys::GCV_OUTSIDE => Self::Outside,
            _ => unreachable!("libgcv gives three locations, and gave {location}"),
        }
    }
}

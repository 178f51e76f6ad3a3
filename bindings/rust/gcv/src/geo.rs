// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Polygons from and to those of geo-types.

use geo_types::{LineString, Polygon as GeoPolygon};

use crate::{Error, OuterFace, Polygon};

/// Holes are left out, as they never change an outer face.
impl TryFrom<&GeoPolygon<f64>> for Polygon {
    type Error = Error;

    fn try_from(polygon: &GeoPolygon<f64>) -> Result<Self, Error> {
        let vertices: Vec<_> = polygon.exterior().coords().map(|c| [c.x, c.y]).collect();
        Self::new(&vertices)
    }
}

/// Holes are left out, as they never change an outer face.
impl TryFrom<GeoPolygon<f64>> for Polygon {
    type Error = Error;

    fn try_from(polygon: GeoPolygon<f64>) -> Result<Self, Error> {
        Self::try_from(&polygon)
    }
}

impl From<&Polygon> for GeoPolygon<f64> {
    fn from(polygon: &Polygon) -> Self {
        GeoPolygon::new(LineString::from(polygon.vertices()), vec![])
    }
}

impl From<&OuterFace> for GeoPolygon<f64> {
    fn from(face: &OuterFace) -> Self {
        GeoPolygon::new(LineString::from(face.vertices()), vec![])
    }
}

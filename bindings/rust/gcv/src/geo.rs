// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Polygons from and to those of geo-types.

use geo_types::{Coord, LineString, Point as GeoPoint, Polygon as GeoPolygon};

use crate::{Error, OuterFace, Point, Polygon};

impl Point for Coord<f64> {
    fn xy(&self) -> [f64; 2] {
        [self.x, self.y]
    }
}

impl Point for GeoPoint<f64> {
    fn xy(&self) -> [f64; 2] {
        self.0.xy()
    }
}

/// With its interiors as holes.
impl TryFrom<&GeoPolygon<f64>> for Polygon {
    type Error = Error;

    fn try_from(polygon: &GeoPolygon<f64>) -> Result<Self, Error> {
        let holes = polygon.interiors().iter().map(|hole| &hole.0);
        Self::from_rings([&polygon.exterior().0].into_iter().chain(holes))
    }
}

/// With its interiors as holes.
impl TryFrom<GeoPolygon<f64>> for Polygon {
    type Error = Error;

    fn try_from(polygon: GeoPolygon<f64>) -> Result<Self, Error> {
        Self::try_from(&polygon)
    }
}

/// With its holes as interiors.
impl From<&Polygon> for GeoPolygon<f64> {
    fn from(polygon: &Polygon) -> Self {
        let holes = polygon.rings().skip(1).map(LineString::from).collect();
        GeoPolygon::new(LineString::from(polygon.vertices()), holes)
    }
}

impl From<&OuterFace> for GeoPolygon<f64> {
    fn from(face: &OuterFace) -> Self {
        GeoPolygon::new(LineString::from(face.vertices()), vec![])
    }
}

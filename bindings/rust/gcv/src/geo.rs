// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Polygons from and to those of geo-types.

use geo_types::{Coord, LineString, Point as GeoPoint, Polygon as GeoPolygon};
use geo_types::{MultiLineString, MultiPoint, MultiPolygon};

use crate::{Error, OuterFace, Point, Polygon, Region};

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

/// The polygons of a region, with their holes as interiors; without its segments and points.
impl From<&Region> for MultiPolygon<f64> {
    fn from(region: &Region) -> Self {
        let polygon = |rings: Vec<Vec<[f64; 2]>>| {
            let mut rings = rings.into_iter().map(LineString::from);
            let outer = rings.next().expect("a polygon has an outer ring");
            GeoPolygon::new(outer, rings.collect())
        };
        MultiPolygon(region.polygons().map(polygon).collect())
    }
}

/// The segments of a region, without its polygons and points.
impl From<&Region> for MultiLineString<f64> {
    fn from(region: &Region) -> Self {
        let segments = region.segments().into_iter();
        MultiLineString(
            segments
                .map(|ends| LineString::from(ends.to_vec()))
                .collect(),
        )
    }
}

/// The points of a region, without its polygons and segments.
impl From<&Region> for MultiPoint<f64> {
    fn from(region: &Region) -> Self {
        MultiPoint(region.points().into_iter().map(GeoPoint::from).collect())
    }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! From and to the types of other crates, each behind the feature of its name.

use gcv::{inner_fit_region, minkowski_sum, Options, OuterFace, Polygon, Region};

fn sum() -> OuterFace {
    let notched = Polygon::new(&[[0., 0.], [8., 0.], [8., 6.], [3., 1.], [0., 7.]]).unwrap();
    let triangle = Polygon::new(&[[0., 0.], [1., 0.], [0., 1.]]).unwrap();
    minkowski_sum(&notched, &triangle, &Options::new()).unwrap()
}

/// Where a square of size 2 may go in a container of three rooms: one with a column, one of
/// its width, one of its size. Corridors of width 1 are between them.
fn rooms() -> Region {
    let container = "POLYGON ((0 0, 7 0, 7 1, 8 1, 8 0, 10 0, 10 1, 11 1, 11 0, 13 0, 13 2, \
                     11 2, 10 2, 10 5, 8 5, 8 2, 7 2, 7 7, 0 7), (3 3, 4 3, 4 4, 3 4))";
    let square = Polygon::new(&[[0., 0.], [2., 0.], [2., 2.], [0., 2.]]).unwrap();
    inner_fit_region(
        &container.parse().unwrap(),
        &square,
        [0., 0.],
        &Options::new(),
    )
    .unwrap()
}

#[test]
fn rooms_of_all_kinds() {
    let region = rooms();
    let polygons: Vec<_> = region.polygons().collect();
    let outer = vec![[0., 0.], [5., 0.], [5., 5.], [0., 5.]];
    let hole = vec![[1., 1.], [1., 4.], [4., 4.], [4., 1.]];
    assert_eq!(polygons, [[outer, hole]]);
    assert_eq!(region.segments(), [[[8., 0.], [8., 3.]]]);
    assert_eq!(region.points(), [[11., 0.]]);
    let fits = "GEOMETRYCOLLECTION (LINESTRING (8 0, 8 3), POINT (11 0))";
    assert_eq!(region.fits_wkt(), fits);
}

#[cfg(feature = "geo-types")]
#[test]
fn regions_to_geo_types() {
    use geo_types::{MultiLineString, MultiPoint, MultiPolygon};

    let region = rooms();
    let MultiPolygon(polygons) = MultiPolygon::from(&region);
    assert_eq!(polygons.len(), 1);
    assert!(polygons[0].exterior().is_closed() && polygons[0].interiors()[0].is_closed());
    assert_eq!(Polygon::try_from(&polygons[0]), region.polygon(0));

    let MultiLineString(lines) = MultiLineString::from(&region);
    let line = geo_types::LineString::from(vec![(8., 0.), (8., 3.)]);
    assert_eq!(lines, [line]);
    let MultiPoint(points) = MultiPoint::from(&region);
    assert_eq!(points, [geo_types::Point::new(11., 0.)]);
    let locations = region.locate(&points).unwrap();
    assert_eq!(locations, [gcv::Location::Boundary]);

    let large = Polygon::new(&[[0., 0.], [9., 0.], [9., 9.], [0., 9.]]).unwrap();
    let small = region.polygon(0).unwrap();
    let empty = inner_fit_region(&small, &large, [0., 0.], &Options::new()).unwrap();
    assert!(MultiPolygon::from(&empty).0.is_empty());
    assert!(MultiLineString::from(&empty).0.is_empty());
    assert!(MultiPoint::from(&empty).0.is_empty());
}

#[cfg(feature = "geo-types")]
#[test]
fn geo_types_there_and_back() {
    let face = sum();
    let geo = geo_types::Polygon::from(&face);
    assert!(geo.exterior().is_closed());
    assert_eq!(geo.exterior().0.len(), face.vertices().len() + 1);

    let polygon = Polygon::try_from(&geo).unwrap();
    assert_eq!(polygon.vertices(), face.vertices());
    assert_eq!(geo_types::Polygon::from(&polygon), geo);
}

#[cfg(feature = "geo-types")]
#[test]
fn geo_types_with_holes_and_without_area() {
    let ring = |vertices: &[[f64; 2]]| geo_types::LineString::from(vertices.to_vec());
    let square = [[0., 0.], [9., 0.], [9., 9.], [0., 9.]];
    let hole = ring(&[[1., 1.], [2., 1.], [1., 2.]]);
    let other_hole = ring(&[[5., 5.], [5., 7.], [7., 5.]]);
    let geo = geo_types::Polygon::new(ring(&square), vec![hole, other_hole]);
    let polygon = Polygon::try_from(&geo).unwrap();
    assert_eq!(polygon.vertices(), square);
    assert_eq!(polygon.ring_count(), 3);
    assert_eq!(polygon.area(), Ok(81. - 0.5 - 2.));
    assert_eq!(polygon.ring(2).unwrap(), [[5., 5.], [5., 7.], [7., 5.]]);

    // Holes come back clockwise.
    let back = geo_types::Polygon::from(&polygon);
    assert_eq!(back.exterior(), geo.exterior());
    let hole = ring(&[[1., 1.], [1., 2.], [2., 1.], [1., 1.]]);
    assert_eq!(back.interiors(), [hole, geo.interiors()[1].clone()]);
    assert_eq!(Polygon::try_from(back), Ok(polygon));

    let outside = ring(&[[10., 1.], [11., 1.], [10., 2.]]);
    let error = Polygon::try_from(geo_types::Polygon::new(ring(&square), vec![outside]));
    assert_eq!(error.unwrap_err().status, gcv::status::GCV_ERR_NOT_SIMPLE);

    let error = Polygon::try_from(geo_types::Polygon::new(ring(&[]), vec![])).unwrap_err();
    assert_eq!(error.status, gcv::status::GCV_ERR_DEGENERATE);
}

#[cfg(feature = "geo-types")]
#[test]
fn points_of_geo_types() {
    let vertices = [(0., 0.), (2., 0.), (0., 2.)];
    let coords = vertices.map(geo_types::Coord::from);
    let points = vertices.map(geo_types::Point::from);
    let expected = Polygon::new(&vertices);
    assert_eq!(Polygon::new(&coords), expected);
    assert_eq!(Polygon::new(&points), expected);
}

#[cfg(feature = "num-rational")]
#[test]
fn rationals() {
    let face = sum();
    let rationals = face.exact_rationals();
    let texts = rationals
        .iter()
        .map(|[x, y]| format!("{}/{} {}/{}", x.numer(), x.denom(), y.numer(), y.denom()));
    assert_eq!(texts.collect::<Vec<_>>(), face.exact_vertices());
    assert_eq!(rationals[4][0].numer(), &10.into());
}

#[cfg(feature = "num-rational")]
#[test]
fn rationals_of_regions() {
    let region = rooms();
    let rationals = region.exact_rationals();
    assert_eq!(rationals.len(), region.exact_vertices().len());
    let integers = rationals.iter().flatten().map(|number| number.to_integer());
    let doubles = region.vertices().into_iter().flatten();
    assert!(integers.eq(doubles.map(|number| (number as i64).into())));
}

#[test]
fn wkt_there_and_back() {
    let face = sum();
    let polygon = Polygon::from_wkt(&face.wkt()).unwrap();
    assert_eq!(polygon.vertices(), face.vertices());
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Known inner fits.

use gcv::status::*;
use gcv::EdgeSource::{Translated, TranslatedCorner};
use gcv::{inner_fit_region, minkowski_sum_region, Location, Options};
use gcv::{PartKind, Polygon, Region, Rounding};

use crate::{parts, polygon, rectangle, square, status, ORIGIN};

/// Two rooms of size 4 with a corridor of width 1 between them.
fn rooms() -> Polygon {
    #[rustfmt::skip]
    let vertices = [
        [0., 0.], [10., 0.], [10., 4.], [6., 4.], [6., 1.], [4., 1.], [4., 4.], [0., 4.],
    ];
    polygon(&vertices)
}

fn inner_fit(container: &Polygon, moving: &Polygon) -> Region {
    inner_fit_region(container, moving, ORIGIN, &Options::new()).unwrap()
}

#[test]
fn squares_in_a_box() {
    let container = rectangle(5., 4.);
    let region = inner_fit(&container, &square(2.));
    let wkt = "MULTIPOLYGON (((0 0, 3 0, 3 2, 0 2, 0 0)))";
    assert_eq!(region.wkt(), wkt);
    assert_eq!(region.area(), Ok(6.));
    assert_eq!(region.bounds(), Some([0., 0., 3., 2.]));
    for (k, source) in region.sources().into_iter().enumerate() {
        // Side k of the square slides along side k of the container.
        let ends = [k, (k + 1) % 4].map(|vertex_b| Translated {
            edge_a: k,
            vertex_b,
        });
        assert!(ends.contains(&source.unwrap()), "{k}: {source:?}");
    }

    let moved = inner_fit_region(&container, &square(2.), [1., -1.], &Options::new()).unwrap();
    let vertices = region.vertices().into_iter();
    let expected: Vec<_> = vertices.map(|[x, y]| [x + 1., y - 1.]).collect();
    assert_eq!(moved.vertices(), expected);

    let region = inner_fit(&container, &square(4.));
    assert_eq!(region.segments(), [[[0., 0.], [1., 0.]]]);
    assert!(region.polygons().next().is_none() && !region.is_empty());
    assert_eq!(region.area(), Ok(0.));
}

#[test]
fn a_box_of_the_same_size() {
    let region = inner_fit(&square(4.), &square(4.));
    assert!(!region.is_empty());
    assert_eq!(region.points(), [[0., 0.]]);
    assert_eq!(region.parts(), parts(&[(PartKind::Point, 1)]));
    assert_eq!(region.wkt(), "MULTIPOLYGON EMPTY");
    assert_eq!(region.fits_wkt(), "GEOMETRYCOLLECTION (POINT (0 0))");
    assert_eq!(region.sources(), [None]);
    assert_eq!(region.owners(), [0]);
    let locations = region.locate(&[[0., 0.], [0., 1e-300]]);
    assert_eq!(locations, Ok(vec![Location::Boundary, Location::Outside]));
}

#[test]
fn no_room() {
    let region = inner_fit(&square(4.), &square(5.));
    assert!(region.is_empty());
    assert_eq!(region.polygons().len(), 0);
    assert!(region.parts().is_empty() && region.exact_parts().is_empty());
    assert!(region.vertices().is_empty() && region.exact_vertices().is_empty());
    assert!(region.segments().is_empty() && region.points().is_empty());
    assert!(region.sources().is_empty() && region.exact_indices().is_empty());
    assert_eq!(region.exact_vertex(0), None);
    assert_eq!((region.area(), region.error_bound()), (Ok(0.), 0.));
    assert_eq!(region.bounds(), None);
    assert_eq!(region.wkt(), "MULTIPOLYGON EMPTY");
    assert_eq!(region.fits_wkt(), "GEOMETRYCOLLECTION EMPTY");
    assert_eq!(status(region.polygon(0)), GCV_ERR_INVALID_ARGUMENT);
    assert_eq!(region.locate(&[ORIGIN]), Ok(vec![Location::Outside]));
    assert_eq!(region, inner_fit(&square(1.), &square(2.)));
}

#[test]
fn two_rooms() {
    let region = inner_fit(&rooms(), &square(2.));
    let room = |x| vec![[x, 0.], [x + 2., 0.], [x + 2., 2.], [x, 2.]];
    let polygons: Vec<_> = region.polygons().collect();
    assert_eq!(polygons, [[room(0.)], [room(6.)]]);
    let kinds = [0, 1].map(|polygon| (PartKind::Outer { polygon }, 4));
    assert_eq!(region.parts(), parts(&kinds));
    assert_eq!(region.polygon(1), Polygon::new(&room(6.)));

    // Ready for the next sum, with numbers from 0.
    let second = region.polygon(1).unwrap();
    let next = minkowski_sum_region(&second, &square(1.), &Options::new()).unwrap();
    assert_eq!(next.area(), Ok(9.));
    let edges = [0, 1, 2, 3].map(|k| {
        Some(TranslatedCorner {
            edge_a: k,
            edge_b: k,
        })
    });
    assert_eq!(next.sources(), edges);
    let error = region.polygon(2).unwrap_err();
    assert_eq!(error.status, GCV_ERR_INVALID_ARGUMENT);
    assert!(error.message.contains('2'), "{error}");
    assert_eq!(status(region.polygon(usize::MAX)), GCV_ERR_INVALID_ARGUMENT);
}

#[test]
fn holes_of_a_container_are_solid() {
    let container = "POLYGON ((0 0, 9 0, 9 9, 0 9), (4 4, 5 4, 5 5, 4 5))";
    let region = inner_fit(&container.parse().unwrap(), &square(1.));
    let rings = &region.polygons().next().unwrap();
    assert_eq!(rings[0], [[0., 0.], [8., 0.], [8., 8.], [0., 8.]]);
    assert_eq!(rings[1], [[3., 3.], [3., 5.], [5., 5.], [5., 3.]]);
    assert_eq!(region.area(), Ok(60.));
    assert_eq!(region.polygon(0), Polygon::from_rings(rings));
}

#[test]
fn outward_drops_what_doubles_cannot_show() {
    let shape = polygon(&[[0., 0.], [5., 1.], [2., 3.]]);
    let moved = polygon(&[[1., 1.], [6., 2.], [3., 4.]]);
    let region = |options| inner_fit_region(&shape, &moved, [0.1, 0.], &options).unwrap();
    let exact = "-32425917317067571/36028797018963968 -1/1";

    let nearest = region(Options::new());
    assert_eq!(nearest.points(), [[0.1 - 1., -1.]]);
    assert!(nearest.error_bound() > 0.);
    let outward = region(Options::new().rounding(Rounding::Outward));
    assert!(outward.is_empty());
    assert_eq!(outward.exact_parts(), parts(&[(PartKind::Point, 1)]));
    assert_eq!(outward.stats().parts_dropped, 1);
    for region in [nearest, outward] {
        assert_eq!(region.exact_vertices(), [exact]);
    }
}

#[test]
fn outward_inner_fits_lie_inside() {
    let container = polygon(&[[0., 0.], [7., 1.], [6., 5.], [1., 4.]]);
    let moving = polygon(&[[0., 0.], [1., 0.3], [0.1, 0.9]]);
    let outward = Options::new().rounding(Rounding::Outward);
    let region = inner_fit_region(&container, &moving, [0.1, 0.2], &outward).unwrap();
    let locations = region.locate(&region.vertices()).unwrap();
    assert!(locations.len() >= 3 && !locations.contains(&Location::Outside));
    assert!(region.sources().iter().flatten().all(|source| {
        matches!(source, Translated { edge_a, vertex_b } if *edge_a < 4 && *vertex_b < 3)
    }));
}

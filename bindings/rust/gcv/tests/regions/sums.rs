// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Known sums and no-fits, when regions are equal, and where points lie in them.

use std::collections::HashSet;

use gcv::status::*;
use gcv::EdgeSource::{Translated, TranslatedCorner};
use gcv::{entrance_region, minkowski_sum, minkowski_sum_region, no_fit_polygon, no_fit_region};
use gcv::{superset, EdgeSource, Location, Options, PartKind, Polygon, Region};

use crate::{frame, frame_and_square, parts, polygon, slot, slot_and_peg, square, ORIGIN};

#[test]
fn a_frame_and_a_square() {
    let region = frame_and_square();
    let outer = vec![[0., 0.], [11., 0.], [11., 11.], [0., 11.]];
    let hole = vec![[2., 2.], [2., 9.], [9., 9.], [9., 2.]];
    let polygons: Vec<_> = region.polygons().collect();
    assert_eq!(polygons, [[outer.clone(), hole.clone()]]);
    assert_eq!(region.vertices(), [outer, hole].concat());
    assert!(region.segments().is_empty() && region.points().is_empty() && !region.is_empty());

    let (outer, hole) = (
        PartKind::Outer { polygon: 0 },
        PartKind::Hole { polygon: 0 },
    );
    assert_eq!(region.parts(), parts(&[(outer, 4), (hole, 4)]));
    assert_eq!(region.exact_parts(), region.parts());
    let exact = region.exact_vertices();
    assert_eq!(exact[4..6], ["2/1 2/1", "2/1 9/1"]);
    assert_eq!(exact.len(), 8);
    assert_eq!(region.exact_vertex(5).unwrap(), "2/1 9/1");
    assert_eq!(region.exact_vertex(8), None);
    assert_eq!(region.exact_vertex(usize::MAX), None);
    assert!(region.exact_indices().into_iter().eq(0..8));

    assert_eq!(region.area(), Ok(121. - 49.));
    assert_eq!(region.error_bound(), 0.);
    let wkt = "MULTIPOLYGON (((0 0, 11 0, 11 11, 0 11, 0 0), (2 2, 2 9, 9 9, 9 2, 2 2)))";
    assert_eq!(region.wkt(), wkt);
    assert_eq!(region.to_string(), wkt);
    assert_eq!(region.fits_wkt(), "GEOMETRYCOLLECTION EMPTY");
    let stats = region.stats();
    assert!(stats.walk_steps >= 4 && stats.predicates_filtered > 0);
    assert_eq!((stats.vertices_repaired, stats.parts_dropped), (0, 0));
}

#[test]
fn sources_run_through_all_rings() {
    let region = frame_and_square();
    let sources: Vec<_> = region.sources().into_iter().flatten().collect();
    let convex = |k| TranslatedCorner {
        edge_a: k,
        edge_b: k,
    };
    assert_eq!(sources[..4], [0, 1, 2, 3].map(convex));
    // The left edge of the hole is edge 7 of the frame as passed, and comes first.
    let edge_a = |source: &_| match source {
        Translated { edge_a, .. } => *edge_a,
        other => panic!("{other:?} is no edge of the frame"),
    };
    let edges: Vec<_> = sources[4..].iter().map(edge_a).collect();
    assert_eq!(edges, [7, 6, 5, 4]);
    let superset = superset(&frame(), &square(1.)).unwrap();
    let is_in_superset = |source: &EdgeSource| superset.iter().any(|edge| edge.source == *source);
    assert!(sources.iter().all(is_in_superset), "{sources:?}");
    assert_eq!(region.owners(), [0; 8]);
}

#[test]
fn a_peg_that_just_fits_a_slot() {
    let region = slot_and_peg();
    let outer = [[-2., -2.], [6., -2.], [6., 6.], [-2., 6.]];
    assert_eq!(region.polygons().len(), 1);
    assert_eq!(region.polygons().next_back().unwrap(), [outer]);
    assert_eq!(region.segments(), [[[2., 2.], [2., 6.]]]);
    assert!(region.points().is_empty());
    let kinds = [(PartKind::Outer { polygon: 0 }, 4), (PartKind::Segment, 2)];
    assert_eq!(region.parts(), parts(&kinds));
    assert_eq!(region.area(), Ok(64.));
    let fits = "GEOMETRYCOLLECTION (LINESTRING (2 2, 2 6))";
    assert_eq!(region.fits_wkt(), fits);

    // The segment is where both walls of the slot touch the peg; its second end has no edge.
    let sources = region.sources();
    let walls = [(5, 3), (3, 1)].map(|(edge_a, edge_b)| TranslatedCorner { edge_a, edge_b });
    assert!(walls.contains(&sources[4].unwrap()), "{sources:?}");
    assert_eq!(sources[5..], [None]);

    let debug = "Region { polygons: [[[[-2.0, -2.0], [6.0, -2.0], [6.0, 6.0], [-2.0, 6.0]]]], \
                 segments: [[[2.0, 2.0], [2.0, 6.0]]], points: [] }";
    assert_eq!(format!("{region:?}"), debug);

    // With a lid on the slot there is one point.
    let closed = "POLYGON ((0 0, 6 0, 6 6, 0 6), (2 2, 4 2, 4 4, 2 4))";
    let region = no_fit_region(
        &closed.parse().unwrap(),
        &square(2.),
        [1., 1.],
        &Options::new(),
    );
    let region = region.unwrap();
    assert_eq!(region.points(), [[3., 3.]]);
    assert_eq!(region.fits_wkt(), "GEOMETRYCOLLECTION (POINT (3 3))");
    assert_eq!(region.sources()[4..], [None]);
}

#[test]
fn entrances_are_no_fits_with_other_names() {
    let (slot, peg) = (slot(), square(2.));
    let options = Options::new();
    let no_fit = no_fit_region(&slot, &peg, [0.5, -3.], &options).unwrap();
    let entrance = entrance_region(&peg, &slot, [0.5, -3.], &options).unwrap();
    assert_eq!(entrance.segments(), [[[2.5, -1.], [2.5, 3.]]]);
    assert_eq!(entrance, no_fit);
    // The lower edge of the slot, 0, and the upper one of the peg, 2.
    let merged = |edge_a, edge_b| Some(TranslatedCorner { edge_a, edge_b });
    assert_eq!(no_fit.sources()[0], merged(0, 2));
    assert_eq!(entrance.sources()[0], merged(2, 0));
}

#[test]
fn the_first_ring_is_the_outer_face() {
    let notched = polygon(&[[0., 0.], [8., 0.], [8., 6.], [3., 1.], [0., 7.]]);
    let triangle = polygon(&[[0., 0.], [1., 0.], [0., 1.]]);
    let options = Options::new();
    let region = minkowski_sum_region(&notched, &triangle, &options).unwrap();
    let face = minkowski_sum(&notched, &triangle, &options).unwrap();
    assert_eq!(region.vertices(), face.vertices());
    assert_eq!(region.exact_vertices(), face.exact_vertices());
    assert_eq!(region.exact_vertex(4).unwrap(), "10/3 7/3");
    let sources: Vec<_> = face.sources().into_iter().map(Some).collect();
    assert_eq!(region.sources(), sources);
    assert!(face.exact_indices().into_iter().eq(0..7));
    assert_eq!(region.exact_indices(), face.exact_indices());
    assert!(0. < region.error_bound() && region.error_bound() < 1e-15);
    assert_eq!(face.stats().parts_dropped, 0);
}

/// Far away, the two ends of a short edge fall together, and so do those of a short segment.
#[test]
fn exact_indices_where_vertices_fall_together() {
    #[rustfmt::skip]
    let chamfered = [
        [0., 0.], [4096., 0.], [4096., 4095.], [4095., 4096.], [0., 4096.],
    ];
    let pocket = [[512., 512.], [769., 512.], [769., 768.], [512., 768.]];
    let fixed = Polygon::from_rings([&chamfered[..], &pocket]).unwrap();
    let far = [2_f64.powi(60); 2];
    let (moving, options) = (square(256.), Options::new());

    let face = no_fit_polygon(&fixed, &moving, far, &options).unwrap();
    assert_eq!((face.vertices().len(), face.exact_vertices().len()), (4, 5));
    assert_eq!(face.exact_indices(), [0, 1, 2, 4]);

    let region = no_fit_region(&fixed, &moving, far, &options).unwrap();
    let outer = PartKind::Outer { polygon: 0 };
    let exact = parts(&[(outer, 5), (PartKind::Segment, 2)]);
    assert_eq!(region.exact_parts(), exact);
    assert_eq!(region.parts(), parts(&[(outer, 4), (PartKind::Point, 1)]));
    assert_eq!(region.exact_indices(), [0, 1, 2, 4, 5]);
    assert_eq!(region.stats().parts_dropped, 0);
}

#[test]
fn equality() {
    let region = frame_and_square();
    let clone = region.clone();
    let again = minkowski_sum_region(&square(1.), &frame(), &Options::new()).unwrap();
    let without_hole = minkowski_sum_region(&square(10.), &square(1.), &Options::new()).unwrap();
    assert!(region == again && region != without_hole);
    drop(region);
    assert_eq!(clone.area(), Ok(72.));
    let set = HashSet::from([clone, again, without_hole, slot_and_peg()]);
    assert_eq!(set.len(), 3);

    // Different exact rings that are the same ones in doubles.
    let far = 2_f64.powi(53);
    let large = polygon(&[[far, 0.], [2. * far, 0.], [far, far]]);
    let sum = |shift: f64| {
        let small = polygon(&[[shift, 0.], [shift + 1., 0.], [shift, 1.]]);
        minkowski_sum_region(&large, &small, &Options::new()).unwrap()
    };
    assert_eq!(sum(0.25).vertices(), sum(0.5).vertices());
    assert_ne!(sum(0.25), sum(0.5));
}

#[test]
fn regions_outlive_polygons_and_are_shared() {
    fn shareable<T: Send + Sync>() {}
    shareable::<Region>();

    let region = {
        let (slot, peg) = (slot(), square(2.));
        no_fit_region(&slot, &peg, ORIGIN, &Options::new()).unwrap()
    };
    let polygon = region.polygon(0).unwrap();
    // The first calls of both make the index.
    std::thread::scope(|scope| {
        let locate = || region.locate(&[[2., 4.], [3., 3.]]).unwrap();
        for thread in [scope.spawn(locate), scope.spawn(locate)] {
            let expected = [Location::Boundary, Location::Inside];
            assert_eq!(thread.join().unwrap(), expected);
        }
    });
    drop(region);
    assert_eq!(polygon.area(), Ok(64.));
}

#[test]
fn locations() {
    use Location::*;

    let region = slot_and_peg();
    #[rustfmt::skip]
    let points = [
        ([2., 4.], Boundary), ([2., 2.], Boundary), ([2., 1.9], Inside), ([3., 3.], Inside),
        ([-2., 0.], Boundary), ([-2., -2.], Boundary), ([7., 0.], Outside), ([2., 6.5], Outside),
    ];
    let expected: Vec<_> = points.iter().map(|(_, location)| *location).collect();
    assert_eq!(region.locate(&points.map(|(point, _)| point)), Ok(expected));

    let region = frame_and_square();
    let points = [(5., 5.), (2., 5.), (1., 5.), (0., 5.), (-1., 5.)];
    let expected = vec![Outside, Boundary, Inside, Boundary, Outside];
    assert_eq!(region.locate(&points), Ok(expected));

    assert_eq!(region.locate::<[f64; 2]>(&[]), Ok(vec![]));
    let error = region.locate(&[(5., 5.), (5., f64::NAN)]).unwrap_err();
    assert_eq!(error.status, GCV_ERR_NOT_FINITE);
    let message = "points: the y coordinate of point 1 is nan, not a finite number";
    assert_eq!(error.message, message);
}

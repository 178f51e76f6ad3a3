// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Regions: known ones through the whole interface.

use std::collections::HashSet;
use std::ops::ControlFlow;

use gcv::status::*;
use gcv::EdgeSource::{Translated, TranslatedCorner};
use gcv::{entrance_region, inner_fit_region, minkowski_sum, minkowski_sum_region};
use gcv::{minkowski_sum_region_many, no_fit_polygon, no_fit_polygon_many};
use gcv::{no_fit_region, no_fit_region_many, superset};
use gcv::{EdgeSource, Error, Location, Options};
use gcv::{Part, PartKind, Polygon, Region, Rounding};

const ORIGIN: [f64; 2] = [0., 0.];

fn polygon(vertices: &[[f64; 2]]) -> Polygon {
    Polygon::new(vertices).unwrap()
}

fn rectangle(width: f64, height: f64) -> Polygon {
    polygon(&[[0., 0.], [width, 0.], [width, height], [0., height]])
}

fn square(size: f64) -> Polygon {
    rectangle(size, size)
}

/// A frame of width 1 round a square hole of size 8.
fn frame() -> Polygon {
    let ring = |low, high| [[low, low], [high, low], [high, high], [low, high]];
    Polygon::from_rings([ring(0., 10.), ring(1., 9.)]).unwrap()
}

/// A block with a slot of width 2 that is open above.
fn slot() -> Polygon {
    #[rustfmt::skip]
    let vertices = [
        [0., 0.], [6., 0.], [6., 6.], [4., 6.], [4., 2.], [2., 2.], [2., 6.], [0., 6.],
    ];
    polygon(&vertices)
}

/// Two rooms of size 4 with a corridor of width 1 between them.
fn rooms() -> Polygon {
    #[rustfmt::skip]
    let vertices = [
        [0., 0.], [10., 0.], [10., 4.], [6., 4.], [6., 1.], [4., 1.], [4., 4.], [0., 4.],
    ];
    polygon(&vertices)
}

fn huge() -> Polygon {
    square(1.7e308)
}

fn frame_and_square() -> Region {
    minkowski_sum_region(&frame(), &square(1.), &Options::new()).unwrap()
}

fn slot_and_peg() -> Region {
    no_fit_region(&slot(), &square(2.), ORIGIN, &Options::new()).unwrap()
}

fn inner_fit(container: &Polygon, moving: &Polygon) -> Region {
    inner_fit_region(container, moving, ORIGIN, &Options::new()).unwrap()
}

fn status<T>(result: Result<T, Error>) -> i32 {
    result.err().unwrap().status
}

/// Parts of these kinds and numbers of vertices.
fn parts(kinds: &[(PartKind, usize)]) -> Vec<Part> {
    let mut end = 0;
    let part = |&(kind, count)| {
        let start = end;
        end += count;
        let vertices = start..end;
        Part { kind, vertices }
    };
    kinds.iter().map(part).collect()
}

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
fn squares_in_a_box() {
    let container = rectangle(5., 4.);
    let region = inner_fit(&container, &square(2.));
    let wkt = "MULTIPOLYGON (((0 0, 3 0, 3 2, 0 2, 0 0)))";
    assert_eq!(region.wkt(), wkt);
    assert_eq!(region.area(), Ok(6.));
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
    assert!(error.message.contains("point 1"), "{error}");
}

#[test]
fn what_is_left_out() {
    let options = Options::new().leave_out_holes(true);
    let region = minkowski_sum_region(&frame(), &square(1.), &options).unwrap();
    assert_eq!(region.area(), Ok(121.));
    let no_fit = no_fit_region(&slot(), &square(2.), ORIGIN, &options).unwrap();
    assert_eq!(no_fit, slot_and_peg());

    let options = Options::new().leave_out_fits(true);
    let region = minkowski_sum_region(&frame(), &square(1.), &options).unwrap();
    assert_eq!(region, frame_and_square());
    let no_fit = no_fit_region(&slot(), &square(2.), ORIGIN, &options).unwrap();
    assert_eq!(no_fit.parts().len(), 1);
    let inner = inner_fit_region(&square(2.), &square(2.), ORIGIN, &options).unwrap();
    assert!(inner.is_empty());

    let options = options.leave_out_holes(true);
    assert!(format!("{options:?}").contains("leave_out_holes: true, leave_out_fits: true"));
    let region = minkowski_sum_region(&frame(), &square(1.), &options).unwrap();
    assert_eq!(region.polygons().next().unwrap().len(), 1);
    let face = minkowski_sum(&frame(), &square(1.), &options).unwrap();
    assert_eq!(face.vertices(), region.vertices());

    let options = options.leave_out_holes(false).leave_out_fits(false);
    let region = minkowski_sum_region(&frame(), &square(1.), &options).unwrap();
    assert_eq!(region, frame_and_square());
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

#[test]
fn refused() {
    let (slot, peg) = (slot(), square(2.));
    let options = Options::new();
    for point in [[f64::NAN, 0.], [0., f64::INFINITY]] {
        for region in [
            no_fit_region(&slot, &peg, point, &options),
            entrance_region(&slot, &peg, point, &options),
            inner_fit_region(&slot, &peg, point, &options),
        ] {
            assert_eq!(status(region), GCV_ERR_NOT_FINITE);
        }
    }
    let overflow = minkowski_sum_region(&huge(), &huge(), &options);
    assert_eq!(status(overflow), GCV_ERR_RANGE);
    let negative = minkowski_sum_region(&slot, &peg, &options.clone().tolerance(-1.));
    assert_eq!(status(negative), GCV_ERR_INVALID_ARGUMENT);

    let inner = |options: Options| status(inner_fit_region(&slot, &peg, ORIGIN, &options));
    assert_eq!(
        inner(Options::new().tolerance(0.5)),
        GCV_ERR_INVALID_ARGUMENT
    );
    assert_eq!(
        inner(Options::new().leave_out_holes(true)),
        GCV_ERR_INVALID_ARGUMENT
    );
    let patience = Options::new().progress(|_, _| ControlFlow::Break(()));
    assert_eq!(inner(patience), GCV_ERR_CANCELLED);
    let patience = Options::new().progress(|_, _| ControlFlow::Break(()));
    let cancelled = minkowski_sum_region(&slot, &peg, &patience);
    assert_eq!(status(cancelled), GCV_ERR_CANCELLED);

    let area = minkowski_sum_region(&square(1e200), &peg, &options)
        .unwrap()
        .area();
    assert_eq!(status(area), GCV_ERR_RANGE);
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

/// Asserts that many are as one by one, and that the first message is about the first failure.
fn assert_same<R: PartialEq + std::fmt::Debug>(
    many: impl ExactSizeIterator<Item = Result<R, Error>>,
    singles: Vec<Result<R, Error>>,
    first_failure: usize,
) {
    assert_eq!(many.len(), singles.len());
    for (index, (result, expected)) in many.zip(singles).enumerate() {
        match (result, expected) {
            (Ok(result), Ok(expected)) => assert_eq!(result, expected),
            (Err(error), Err(expected)) => {
                assert_eq!(error.status, expected.status);
                let start = format!("pair {index}: ");
                assert!(error.message.starts_with(&start), "{error}");
                if index == first_failure {
                    assert!(error.message.ends_with(&expected.message), "{error}");
                }
            }
            (result, expected) => panic!("pair {index}: {result:?}, expected {expected:?}"),
        }
    }
}

#[test]
fn many_sums() {
    let (frame, unit, huge) = (frame(), square(1.), huge());
    let pairs = [
        (&frame, &unit),
        (&huge, &huge),
        (&frame, &frame),
        (&huge, &huge),
    ];
    for threads in 0..3 {
        let options = Options::new().threads(threads);
        let singles = pairs.map(|(a, b)| minkowski_sum_region(a, b, &options));
        assert_same(
            minkowski_sum_region_many(pairs, &options),
            singles.to_vec(),
            1,
        );
    }
    assert_eq!(minkowski_sum_region_many([], &Options::new()).len(), 0);
    let refused = Options::new().tolerance(-1.);
    for region in minkowski_sum_region_many(pairs, &refused) {
        assert_eq!(status(region), GCV_ERR_INVALID_ARGUMENT);
    }
}

#[test]
fn many_no_fits() {
    let (frame, slot, peg) = (frame(), slot(), square(2.));
    let pairs = [
        (&slot, &peg, [0., 0.]),
        (&slot, &peg, [0., f64::NAN]),
        (&frame, &peg, [1., -5.]),
        (&peg, &slot, [f64::INFINITY, 0.]),
        (&slot, &peg, [0.1, 0.3]),
    ];
    for threads in 0..3 {
        let options = Options::new().threads(threads);
        let singles = pairs.map(|(fixed, moving, point)| {
            let region = no_fit_region(fixed, moving, point, &options);
            let face = no_fit_polygon(fixed, moving, point, &options);
            (region, face)
        });
        let (regions, faces) = singles.into_iter().unzip();
        assert_same(no_fit_region_many(pairs, &options), regions, 1);
        assert_same(no_fit_polygon_many(pairs, &options), faces, 1);
    }
    let options = Options::new();
    assert_eq!(no_fit_region_many([], &options).len(), 0);
    assert_eq!(no_fit_polygon_many([], &options).len(), 0);

    let patience = Options::new().progress(|_, _| ControlFlow::Break(()));
    for face in no_fit_polygon_many(pairs, &patience) {
        assert_eq!(status(face), GCV_ERR_CANCELLED);
    }
}

#[test]
fn options_are_passed_on_to_many() {
    let (slot, peg) = (slot(), square(2.));
    let options = Options::new().leave_out_fits(true);
    let sums = minkowski_sum_region_many([(&slot, &-&peg)], &options);
    let no_fits = no_fit_region_many([(&slot, &peg, ORIGIN)], &options);
    for region in sums.chain(no_fits) {
        assert_eq!(region.unwrap().parts().len(), 1);
    }
}

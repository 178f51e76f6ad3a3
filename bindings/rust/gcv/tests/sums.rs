// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Known results through the whole interface.

use std::collections::HashSet;

use gcv::status::*;
use gcv::EdgeSource::*;
use gcv::{entrance_block, minkowski_sum, no_fit_polygon, superset};
use gcv::{Error, ErrorKind, Options, OuterFace, Polygon, SupersetEdge};

const SQUARE: [[f64; 2]; 4] = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]];
const SQUARE_2: [[f64; 2]; 4] = [[0., 0.], [2., 0.], [2., 2.], [0., 2.]];
const SQUARE_3: [[f64; 2]; 4] = [[0., 0.], [3., 0.], [3., 3.], [0., 3.]];
const NOTCHED: [[f64; 2]; 5] = [[0., 0.], [8., 0.], [8., 6.], [3., 1.], [0., 7.]];
const TRIANGLE: [[f64; 2]; 3] = [[0., 0.], [1., 0.], [0., 1.]];
#[rustfmt::skip]
const U_SHAPE: [[f64; 2]; 8] = [
    [0., 0.], [6., 0.], [6., 6.], [4., 6.], [4., 2.], [2., 2.], [2., 6.], [0., 6.],
];
#[rustfmt::skip]
const U_NO_FIT: [[f64; 2]; 8] = [
    [-1., -1.], [6., -1.], [6., 6.], [3., 6.], [3., 2.], [2., 2.], [2., 6.], [-1., 6.],
];

fn polygon(vertices: &[[f64; 2]]) -> Polygon {
    Polygon::new(vertices).unwrap()
}

fn sum(a: &Polygon, b: &Polygon) -> Result<OuterFace, Error> {
    minkowski_sum(a, b, &Options::new())
}

#[test]
fn polygon_properties() {
    let polygon = polygon(&[[2., 0.], [2., 1.], [0., 1.], [0., 0.], [1., 0.], [2., 0.]]);
    let vertices = [[0., 0.], [2., 0.], [2., 1.], [0., 1.]];
    assert_eq!(polygon.vertices(), vertices);
    assert_eq!(polygon.area(), Ok(2.));
    assert_eq!(polygon.bounds(), [0., 0., 2., 1.]);
    assert_eq!(
        polygon.translated([3., -1.]).unwrap().bounds(),
        [3., -1., 5., 0.]
    );
    let rings = "[[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]]]";
    let debug = format!("Polygon {{ ring_count: 1, rings: {rings} }}");
    assert_eq!(format!("{polygon:?}"), debug);
}

#[test]
fn squares() {
    let face = sum(&polygon(&SQUARE), &polygon(&SQUARE_2)).unwrap();
    assert_eq!(face.vertices(), SQUARE_3);
    let exact = ["0/1 0/1", "3/1 0/1", "3/1 3/1", "0/1 3/1"];
    assert_eq!(face.exact_vertices(), exact);
    assert_eq!(face.area(), Ok(9.));
    assert_eq!(face.bounds(), [0., 0., 3., 3.]);
    assert_eq!(face.error_bound(), 0.);
    assert_eq!(face.wkt(), "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))");
    assert_eq!(face.to_string(), face.wkt());
    let debug = "OuterFace([[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]])";
    assert_eq!(format!("{face:?}"), debug);
    let again = Polygon::from_wkt(&face.wkt()).unwrap();
    assert_eq!(again.vertices(), SQUARE_3);
}

#[test]
fn polygon_outlives_its_face() {
    let face = sum(&polygon(&SQUARE), &polygon(&SQUARE_2)).unwrap();
    let polygon = face.polygon().unwrap();
    drop(face);
    let face = sum(&polygon, &polygon).unwrap();
    assert_eq!(face.area(), Ok(36.));
}

#[test]
fn equal_faces() {
    let face = sum(&polygon(&SQUARE), &polygon(&SQUARE_2)).unwrap();
    let clone = face.clone();
    let again = sum(&polygon(&SQUARE_2), &polygon(&SQUARE)).unwrap();
    let other = sum(&polygon(&SQUARE), &polygon(&SQUARE)).unwrap();
    assert!(face == again && face != other);
    drop(face);
    assert_eq!(HashSet::from([clone, again, other]).len(), 2);

    // Different exact rings that are the same one in doubles.
    let scale = 2_f64.powi(53);
    let moved = |shift: f64| polygon(&TRIANGLE.map(|[x, y]| [x + shift, y]));
    let large = polygon(&TRIANGLE.map(|[x, y]| [scale * (x + 1.), scale * y]));
    let (a, b) = (sum(&large, &moved(0.25)), sum(&large, &moved(0.5)));
    let (a, b) = (a.unwrap(), b.unwrap());
    assert_eq!(a.vertices(), b.vertices());
    assert_ne!(a, b);
}

#[test]
fn fractions_and_sources() {
    let face = sum(&polygon(&NOTCHED), &polygon(&TRIANGLE)).unwrap();
    let exact = face.exact_vertices();
    assert_eq!(exact.len(), 7);
    assert_eq!(exact[4], "10/3 7/3");
    assert_eq!(face.vertices()[4], [10. / 3., 7. / 3.]);
    assert!(0. < face.error_bound() && face.error_bound() < 1e-15);
    let expected = [
        TranslatedCorner {
            edge_a: 0,
            edge_b: 0,
        },
        Translated {
            edge_a: 1,
            vertex_b: 1,
        },
        Corner {
            vertex_a: 2,
            edge_b: 1,
        },
        Translated {
            edge_a: 2,
            vertex_b: 2,
        },
        Translated {
            edge_a: 3,
            vertex_b: 1,
        },
        Corner {
            vertex_a: 4,
            edge_b: 1,
        },
        TranslatedCorner {
            edge_a: 4,
            edge_b: 2,
        },
    ];
    assert_eq!(face.sources(), expected);
}

#[test]
fn stats() {
    let stats = sum(&polygon(&NOTCHED), &polygon(&TRIANGLE))
        .unwrap()
        .stats();
    assert!(stats.walk_steps >= 7 && stats.candidate_edges >= stats.walk_steps);
    assert!(stats.predicates_filtered > 0);
    assert_eq!(stats.vertices_repaired, 0);
}

#[test]
fn edges_of_the_superset() {
    let edges = superset(&polygon(&SQUARE), &polygon(&SQUARE_2)).unwrap();
    let expected = SupersetEdge {
        from: [0., 0.],
        to: [3., 0.],
        source: TranslatedCorner {
            edge_a: 0,
            edge_b: 0,
        },
    };
    assert!(edges.contains(&expected), "{edges:?}");
    let huge = polygon(&SQUARE.map(|[x, y]| [1e308 * x, 1e308 * y]));
    assert_eq!(superset(&huge, &huge).unwrap_err().status, GCV_ERR_RANGE);
}

#[test]
fn no_fit() {
    let face = no_fit_polygon(
        &polygon(&U_SHAPE),
        &polygon(&SQUARE),
        [0., 0.],
        &Options::new(),
    )
    .unwrap();
    assert_eq!(face.vertices(), U_NO_FIT);
    assert_eq!(face.area(), Ok(45.));
}

#[test]
fn entrance() {
    let face = entrance_block(
        &polygon(&SQUARE),
        &polygon(&U_SHAPE),
        [1., -2.],
        &Options::new(),
    )
    .unwrap();
    assert_eq!(face.vertices(), U_NO_FIT.map(|[x, y]| [x + 1., y - 2.]));
}

#[test]
fn refused() {
    let status = |vertices: &[[f64; 2]]| Polygon::new(vertices).unwrap_err().status;
    let bow_tie = [[0., 0.], [2., 2.], [2., 0.], [0., 2.]];
    assert_eq!(status(&bow_tie), GCV_ERR_NOT_SIMPLE);
    assert_eq!(status(&[]), GCV_ERR_DEGENERATE);
    let nan = [[0., 0.], [1., f64::NAN], [0., 1.]];
    assert_eq!(status(&nan), GCV_ERR_NOT_FINITE);

    let error = Polygon::from_wkt("POLYGON ((0 0, 1 0").unwrap_err();
    assert_eq!(error.status, GCV_ERR_PARSE);
    assert_eq!(error.status_name(), "GCV_ERR_PARSE");
    assert_eq!(error.kind(), ErrorKind::Parse);
    assert!(!error.to_string().is_empty());

    let square = polygon(&SQUARE);
    let error = no_fit_polygon(&square, &square, [f64::NAN, 0.], &Options::new()).unwrap_err();
    assert_eq!(error.status, GCV_ERR_NOT_FINITE);
}

#[test]
fn kinds_of_errors() {
    let kind = |status| {
        let message = String::new();
        Error { status, message }.kind()
    };
    assert_eq!(kind(GCV_ERR_INVALID_ARGUMENT), ErrorKind::InvalidArgument);
    assert_eq!(kind(GCV_ERR_NOT_FINITE), ErrorKind::NotFinite);
    assert_eq!(kind(GCV_ERR_DEGENERATE), ErrorKind::Degenerate);
    assert_eq!(kind(GCV_ERR_NOT_SIMPLE), ErrorKind::NotSimple);
    assert_eq!(kind(GCV_ERR_RANGE), ErrorKind::Range);
    assert_eq!(kind(GCV_ERR_PARSE), ErrorKind::Parse);
    assert_eq!(kind(GCV_ERR_NO_MEMORY), ErrorKind::NoMemory);
    assert_eq!(kind(GCV_ERR_CANCELLED), ErrorKind::Cancelled);
    assert_eq!(kind(GCV_ERR_INTERNAL), ErrorKind::Internal);
    assert_eq!(kind(77), ErrorKind::Unknown);
}

#[test]
fn out_of_range() {
    let huge = polygon(&SQUARE.map(|[x, y]| [1e308 * x, 1e308 * y]));
    let error = sum(&huge, &huge).unwrap_err();
    assert_eq!(error.status, GCV_ERR_RANGE);
    assert_eq!(huge.area().unwrap_err().status, GCV_ERR_RANGE);
}

#[test]
fn threads() {
    fn shareable<T: Send + Sync>() {}
    shareable::<OuterFace>();
    shareable::<Polygon>();
    shareable::<Options>();

    let (a, b) = (polygon(&NOTCHED), polygon(&TRIANGLE));
    let wkt = || sum(&a, &b).unwrap().wkt();
    let expected = wkt();
    std::thread::scope(|scope| {
        for thread in [scope.spawn(wkt), scope.spawn(wkt)] {
            assert_eq!(thread.join().unwrap(), expected);
        }
    });
}

#[test]
fn version() {
    assert_eq!(gcv::library_version(), env!("CARGO_PKG_VERSION"));
}

#[test]
fn sums_by_plus_and_references_of_all_kinds() {
    let square = Polygon::new(&[(0., 0.), (1., 0.), (1., 1.), (0., 1.)]).unwrap();
    let sum = (&square + &square).unwrap();
    assert_eq!(
        sum,
        minkowski_sum(&square, &square, &Options::new()).unwrap()
    );
    let huge = Polygon::new(&[(0., 0.), (1e308, 0.), (0., 1e308)]).unwrap();
    assert_eq!((&huge + &huge).unwrap_err().status, GCV_ERR_RANGE);

    let options = Options::new();
    let by_pair = no_fit_polygon(&square, &square, (1., 2.), &options);
    assert_eq!(
        by_pair,
        no_fit_polygon(&square, &square, [1., 2.], &options)
    );
}

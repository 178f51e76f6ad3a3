// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Known results through the whole interface.

use gcv::edge::*;
use gcv::status::*;
use gcv::{entrance_block, minkowski_sum, no_fit_polygon, EdgeSource, OuterFace, Polygon};

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

#[test]
fn polygon_properties() {
    let polygon = polygon(&[[2., 0.], [2., 1.], [0., 1.], [0., 0.], [1., 0.], [2., 0.]]);
    let vertices = [[0., 0.], [2., 0.], [2., 1.], [0., 1.]];
    assert_eq!(polygon.vertices(), vertices);
    assert_eq!(polygon.area(), Ok(2.));
    assert_eq!(polygon.bounds(), [0., 0., 2., 1.]);
}

#[test]
fn squares() {
    let face = minkowski_sum(&polygon(&SQUARE), &polygon(&SQUARE_2)).unwrap();
    assert_eq!(face.vertices(), SQUARE_3);
    let exact = ["0/1 0/1", "3/1 0/1", "3/1 3/1", "0/1 3/1"];
    assert_eq!(face.exact_vertices(), exact);
    assert_eq!(face.area(), Ok(9.));
    assert_eq!(face.error_bound(), 0.);
    assert_eq!(face.wkt(), "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))");
    let again = Polygon::from_wkt(&face.wkt()).unwrap();
    assert_eq!(again.vertices(), SQUARE_3);
}

#[test]
fn polygon_outlives_its_face() {
    let face = minkowski_sum(&polygon(&SQUARE), &polygon(&SQUARE_2)).unwrap();
    let polygon = face.polygon().unwrap();
    drop(face);
    let face = minkowski_sum(&polygon, &polygon).unwrap();
    assert_eq!(face.area(), Ok(36.));
}

#[test]
fn fractions_and_sources() {
    let face = minkowski_sum(&polygon(&NOTCHED), &polygon(&TRIANGLE)).unwrap();
    let exact = face.exact_vertices();
    assert_eq!(exact.len(), 7);
    assert_eq!(exact[4], "10/3 7/3");
    assert_eq!(face.vertices()[4], [10. / 3., 7. / 3.]);
    assert!(0. < face.error_bound() && face.error_bound() < 1e-15);
    let expected = [
        (GCV_EDGE_TRANSLATED_CORNER, 0, 0),
        (GCV_EDGE_TRANSLATED, 1, 1),
        (GCV_EDGE_CORNER, 2, 1),
        (GCV_EDGE_TRANSLATED, 2, 2),
        (GCV_EDGE_TRANSLATED, 3, 1),
        (GCV_EDGE_CORNER, 4, 1),
        (GCV_EDGE_TRANSLATED_CORNER, 4, 2),
    ];
    assert_eq!(
        face.sources(),
        expected.map(|(kind, a, b)| EdgeSource { kind, a, b })
    );
}

#[test]
fn no_fit() {
    let face = no_fit_polygon(&polygon(&U_SHAPE), &polygon(&SQUARE), [0., 0.]).unwrap();
    assert_eq!(face.vertices(), U_NO_FIT);
    assert_eq!(face.area(), Ok(45.));
}

#[test]
fn entrance() {
    let face = entrance_block(&polygon(&SQUARE), &polygon(&U_SHAPE), [1., -2.]).unwrap();
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
    assert!(!error.to_string().is_empty());

    let square = polygon(&SQUARE);
    let error = no_fit_polygon(&square, &square, [f64::NAN, 0.]).unwrap_err();
    assert_eq!(error.status, GCV_ERR_NOT_FINITE);
}

#[test]
fn out_of_range() {
    let huge = polygon(&SQUARE.map(|[x, y]| [1e308 * x, 1e308 * y]));
    let error = minkowski_sum(&huge, &huge).unwrap_err();
    assert_eq!(error.status, GCV_ERR_RANGE);
    assert_eq!(huge.area().unwrap_err().status, GCV_ERR_RANGE);
}

#[test]
fn threads() {
    fn shareable<T: Send + Sync>() {}
    shareable::<OuterFace>();

    let (a, b) = (polygon(&NOTCHED), polygon(&TRIANGLE));
    let sum = || minkowski_sum(&a, &b).unwrap().wkt();
    let expected = sum();
    std::thread::scope(|scope| {
        for thread in [scope.spawn(sum), scope.spawn(sum)] {
            assert_eq!(thread.join().unwrap(), expected);
        }
    });
}

#[test]
fn version() {
    assert_eq!(gcv::library_version(), env!("CARGO_PKG_VERSION"));
}

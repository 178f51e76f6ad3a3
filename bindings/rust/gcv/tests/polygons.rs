// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Polygons: how they are made, and what they say of themselves.

use std::collections::HashSet;

use gcv::status::*;
use gcv::{minkowski_sum, EdgeSource, Options, Polygon, Rounding};

const OUTER: [[f64; 2]; 4] = [[0., 0.], [9., 0.], [9., 9.], [0., 9.]];
const HOLE: [[f64; 2]; 3] = [[3., 3.], [6., 3.], [3., 6.]];
/// The hole as it is given back.
const CLOCKWISE: [[f64; 2]; 3] = [[3., 3.], [3., 6.], [6., 3.]];
const WKT: &str = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 3, 3 3))";

fn frame() -> Polygon {
    Polygon::from_rings([&OUTER[..], &HOLE]).unwrap()
}

fn status<T>(result: Result<T, gcv::Error>) -> i32 {
    result.err().unwrap().status
}

#[test]
fn rings() {
    let frame = frame();
    assert_eq!(frame.ring_count(), 2);
    assert_eq!(frame.vertices(), OUTER);
    assert_eq!(frame.ring(0).unwrap(), OUTER);
    assert_eq!(frame.ring(1).unwrap(), CLOCKWISE);
    assert_eq!(frame.ring(2), None);
    assert_eq!(frame.ring(usize::MAX), None);
    assert_eq!(frame.rings().len(), 2);
    assert_eq!(frame.rings().next_back().unwrap(), CLOCKWISE);
    assert_eq!(frame.area(), Ok(81. - 4.5));
    assert_eq!(frame.bounds(), [0., 0., 9., 9.]);
    assert!(format!("{frame:?}").starts_with("Polygon { ring_count: 2, rings: [[[0.0, 0.0], "));
    assert_eq!(Polygon::from_rings(frame.rings()), Ok(frame));
}

#[test]
fn rings_of_one_are_a_polygon() {
    let square = Polygon::from_rings([OUTER]).unwrap();
    assert_eq!(square.ring_count(), 1);
    assert_eq!(square, Polygon::new(&OUTER).unwrap());
}

#[test]
fn rings_that_are_refused() {
    let none: [&[[f64; 2]]; 0] = [];
    let error = Polygon::from_rings(none).unwrap_err();
    assert_eq!(error.status, GCV_ERR_DEGENERATE);
    assert!(error.message.contains("ring_count is 0"), "{error}");

    let moved = HOLE.map(|[x, y]| [x + 4., y]);
    let error = Polygon::from_rings([&OUTER[..], &moved]).unwrap_err();
    assert_eq!(error.status, GCV_ERR_NOT_SIMPLE);
    assert!(error.message.contains("ring"), "{error}");

    let line = [[1., 1.], [2., 2.], [3., 3.]];
    let refused = Polygon::from_rings([&OUTER[..], &line]);
    assert_eq!(status(refused), GCV_ERR_DEGENERATE);
    let infinite = [[1., 1.], [2., 1.], [1., f64::INFINITY]];
    let refused = Polygon::from_rings([&OUTER[..], &infinite]);
    assert_eq!(status(refused), GCV_ERR_NOT_FINITE);
}

#[test]
fn outer_faces_do_not_see_holes() {
    let (frame, square) = (frame(), Polygon::new(&OUTER).unwrap());
    let sum = |polygon| minkowski_sum(polygon, &square, &Options::new()).unwrap();
    assert_eq!(sum(&frame), sum(&square));
}

#[test]
fn points_of_other_types() {
    let expected = Polygon::new(&OUTER);
    let pairs = OUTER.map(|[x, y]| (x, y));
    assert_eq!(Polygon::new(&pairs), expected);
    assert_eq!(Polygon::new(&pairs.iter().collect::<Vec<_>>()), expected);
    let rings = [pairs.to_vec(), HOLE.map(|[x, y]| (x, y)).to_vec()];
    assert_eq!(Polygon::from_rings(&rings), Ok(frame()));
}

#[test]
fn many() {
    let bow_tie = vec![[0., 0.], [2., 2.], [2., 0.], [0., 2.]];
    let rings = [OUTER.to_vec(), vec![], HOLE.to_vec(), bow_tie.clone()];
    let polygons = Polygon::many(&rings);
    assert_eq!(polygons.len(), 4);
    assert_eq!(polygons[0], Polygon::new(&OUTER));
    assert_eq!(polygons[2], Polygon::new(&HOLE));

    let first = polygons[1].as_ref().unwrap_err();
    assert_eq!(first.status, GCV_ERR_DEGENERATE);
    assert!(first.message.starts_with("polygon 1: "), "{first}");
    let second = polygons[3].as_ref().unwrap_err();
    assert_eq!(second.status, GCV_ERR_NOT_SIMPLE);
    assert_eq!(second.message, "polygon 3: GCV_ERR_NOT_SIMPLE");

    assert!(Polygon::many::<_, &[[f64; 2]], _>([]).is_empty());
}

#[test]
fn discs() {
    let near = Polygon::disc([1., 2.], 3., 0.01, Rounding::Nearest).unwrap();
    let around = Polygon::disc((1., 2.), 3., 0.01, Rounding::Outward).unwrap();
    for disc in [&near, &around] {
        for [x, y] in disc.vertices() {
            assert!(((x - 1.).hypot(y - 2.) - 3.).abs() < 0.0101);
        }
    }
    let circle = std::f64::consts::PI * 9.;
    assert!(around.area().unwrap() > circle);
    assert!((near.area().unwrap() - circle).abs() < 0.2);

    let disc = |centre, radius, tolerance| {
        status(Polygon::disc(centre, radius, tolerance, Rounding::Nearest))
    };
    assert_eq!(disc([f64::NAN, 0.], 1., 0.1), GCV_ERR_NOT_FINITE);
    assert_eq!(disc([0., 0.], 0., 0.1), GCV_ERR_INVALID_ARGUMENT);
    assert_eq!(disc([0., 0.], 1., -1.), GCV_ERR_INVALID_ARGUMENT);
    assert_eq!(disc([0., 0.], 1.7e308, 1e300), GCV_ERR_RANGE);
}

#[test]
fn affine() {
    let frame = frame();
    let turned = frame.affine([0., -1., 0., 1., 0., 0.]).unwrap();
    let turn = |ring: &[[f64; 2]]| ring.iter().map(|[x, y]| [-y, *x]).collect::<Vec<_>>();
    let expected = Polygon::from_rings([turn(&OUTER), turn(&HOLE)]).unwrap();
    assert_eq!(turned, expected);

    assert_eq!(status(frame.affine([f64::NAN; 6])), GCV_ERR_NOT_FINITE);
    assert_eq!(status(frame.affine([0.; 6])), GCV_ERR_DEGENERATE);
    let huge = frame.affine([1e308, 0., 0., 0., 1e308, 0.]);
    assert_eq!(status(huge), GCV_ERR_RANGE);
}

#[test]
fn numbers_stay_in_a_reflection() {
    let triangle = Polygon::new(&HOLE).unwrap();
    let sum = minkowski_sum(&triangle, &-&triangle, &Options::new()).unwrap();
    let edge = |source| match source {
        EdgeSource::Translated { edge_a, .. } => edge_a,
        EdgeSource::Corner { edge_b, .. } => edge_b,
        EdgeSource::TranslatedCorner { .. } => panic!("no edges have the same direction"),
    };
    let edges: Vec<_> = sum.sources().into_iter().map(edge).collect();
    // Opposite edges of the hexagon come from the same edge of the triangle.
    assert_eq!(edges.len(), 6);
    assert_eq!(edges[..3], edges[3..]);
    assert_eq!(HashSet::<usize>::from_iter(edges), HashSet::from([0, 1, 2]));
}

#[test]
fn holes_are_simplified_and_stay() {
    let hole = [[3., 3.], [4.5, 2.9], [6., 3.], [3., 6.]];
    let bent = Polygon::from_rings([&OUTER[..], &hole]).unwrap();
    let (simple, bound) = bent.simplified(0.5, Rounding::Nearest).unwrap();
    assert_eq!(simple, frame());
    assert!((0.1..0.1000001).contains(&bound));
}

#[test]
fn text() {
    let frame = frame();
    assert_eq!(frame.wkt(), WKT);
    assert_eq!(frame.to_string(), WKT);
    assert_eq!(WKT.parse(), Ok(frame));
    let error = "POLYGON ((0 0, 1 0".parse::<Polygon>().unwrap_err();
    assert_eq!(error.status, GCV_ERR_PARSE);

    let far = Polygon::new(&[[-0.5, 1e-300], [1e300, 0.1], [0., 1e300]]).unwrap();
    assert_eq!(
        far.wkt(),
        "POLYGON ((-0.5 1e-300, 1e300 0.1, 0 1e300, -0.5 1e-300))"
    );
}

#[test]
fn equality() {
    let square = Polygon::new(&OUTER).unwrap();
    let mut turned = OUTER;
    turned.rotate_left(1);
    turned.reverse();
    let same = Polygon::new(&turned).unwrap();
    let frame = frame();
    let clone = frame.clone();
    assert_eq!(square, same);
    assert_ne!(square, frame);
    drop(frame);
    assert_eq!(clone.ring_count(), 2);
    let zero = Polygon::new(&OUTER.map(|[x, y]| [x, if y == 0. { -0. } else { y }])).unwrap();
    assert_eq!(HashSet::from([square, same, clone, zero]).len(), 2);
}

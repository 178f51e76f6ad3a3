// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Pieces of puzzles. One that is taken out fits at its own place exactly.

use gcv::Location::{Boundary, Outside};
use gcv::{Options, Polygon, Query, Relation, Rounding, Scene};

use crate::{all, polygon, square};

const IN_PLACE: [f64; 2] = [0., 0.];
const NOT_MOVED: [f64; 6] = [1., 0., 0., 0., 1., 0.];

/// Nine pieces with dovetails in one another, moved by a map. The puzzle is 30 wide and high.
fn puzzle(map: [f64; 6]) -> Vec<Polygon> {
    // Corners on the way from a corner of a piece, along an axis.
    let side = |from: [f64; 2], [dx, dy]: [f64; 2], tail: bool| {
        let at = |[along, across]: [f64; 2]| {
            let [x, y] = from;
            [x + along * dx - across * dy, y + along * dy + across * dx]
        };
        let tail = [[4., 0.], [3., 2.], [7., 2.], [6., 0.]]
            .into_iter()
            .filter(|_| tail);
        let corners = [[0., 0.]].into_iter().chain(tail).chain([[10., 0.]]);
        corners.map(at).collect::<Vec<_>>()
    };
    let piece = |k: usize| {
        let (column, row) = (k % 3, k / 3);
        let [x, y] = [column, row].map(|k| 10. * k as f64);
        let below = side([x, y], [1., 0.], row > 0);
        let right = side([x + 10., y], [0., 1.], column < 2);
        let mut above = side([x, y + 10.], [1., 0.], row < 2);
        let mut left = side([x, y], [0., 1.], column > 0);
        above.reverse();
        left.reverse();
        let ring = [below, right, above, left].concat();
        polygon(&ring).affine(map).unwrap()
    };
    (0..9).map(piece).collect()
}

/// The puzzle in a container, without one piece.
fn without(missing: usize) -> (Scene, Polygon) {
    let (mut pieces, mut scene) = (puzzle(NOT_MOVED), Scene::new());
    scene.set_container(Some(&square(30.))).unwrap();
    let missing = pieces.remove(missing);
    let pieces: Vec<_> = pieces.iter().collect();
    scene.add_many(&pieces, &[IN_PLACE; 8]).unwrap();
    (scene, missing)
}

#[test]
fn nowhere_else() {
    for missing in 0..9 {
        let (scene, piece) = without(missing);
        let region = scene.free_region(&piece, None, &all(), &Options::new());
        let region = region.unwrap();
        assert_eq!(region.points(), [IN_PLACE], "{missing}");
        assert_eq!(region.parts().len(), 1);
        assert_eq!(region.exact_vertices(), ["0/1 0/1"]);
        assert_eq!(region.fits_wkt(), "GEOMETRYCOLLECTION (POINT (0 0))");
        let locations = region.locate(&[IN_PLACE, [f64::from_bits(1), 0.]]);
        assert_eq!(locations, Ok(vec![Boundary, Outside]));
    }
}

/// All corners are rounded, but the same corner is the same in all pieces.
#[test]
fn turned_and_moved() {
    for (map, position) in [
        (NOT_MOVED, IN_PLACE),
        (NOT_MOVED, [0.1, -0.7]),
        ([0.8, -0.6, 1. / 3., 0.6, 0.8, 1e3], [1e-9, 0.3]),
        ([1e-3, -2e5, 0.1, 3e5, 1e-3, 0.2], [1e20, 7.]),
    ] {
        let (pieces, mut scene) = (puzzle(map), Scene::new());
        let polygons: Vec<_> = pieces.iter().collect();
        let ids = scene.add_many(&polygons, &[position; 9]).unwrap();
        let [x, y] = position;
        // Below the size of a piece, above the distance of the nearest doubles.
        let size = map[0].abs() / 8. + x.abs() * 1e-10;
        let window = Some([x - size, y - size, x + size, y + size]);
        for (piece, id) in pieces.iter().zip(&ids) {
            let (ignored, options) = ([*id], Options::new());
            let query = Query::new().ignore(&ignored);
            let relation = scene.relation(piece, position, &query, &options);
            assert_eq!(relation, Ok(Relation::Touching));
            let region = scene.free_region(piece, window, &query, &options).unwrap();
            assert!(region.points().contains(&position), "{id}: {region:?}");
            assert_eq!(region.locate(&[position]), Ok(vec![Boundary]));
        }
    }
}

#[test]
fn best_places() {
    for missing in 0..9 {
        let (scene, piece) = without(missing);
        for direction in [[-1., 0.], [0.3, 1e-9]] {
            let best = |options| scene.best(&piece, direction, &all(), &options);
            assert_eq!(best(Options::new()), Ok(Some(IN_PLACE)), "{missing}");
            let without_fits = Options::new().leave_out_fits(true);
            assert_eq!(best(without_fits), Ok(None), "{missing}");
        }
    }
}

#[test]
fn ways_into_place() {
    for missing in 0..9 {
        let (scene, piece) = without(missing);
        let escape = |options| scene.penetration(&piece, [3., -4.], &all(), &options);
        let found = escape(Options::new()).unwrap();
        assert_eq!((found.depth(), found.translation()), (5., [-3., 4.]));
        assert_eq!(found.position(), IN_PLACE);
        assert_eq!(found.relation(), Relation::Touching);
        let touched = scene.near(&piece, IN_PLACE, 0., &all(), &Options::new());
        assert_eq!(found.id(), touched.unwrap()[0].a());
        let found = escape(Options::new().leave_out_fits(true)).unwrap();
        assert_eq!(found.depth(), f64::INFINITY);
    }
}

/// The exact place is between doubles: the piece overlaps at the nearest ones.
#[test]
fn places_that_no_doubles_have() {
    let (mut pieces, mut scene) = (puzzle(NOT_MOVED), Scene::new());
    // With less room beside the puzzle than a piece needs.
    let container = polygon(&[[-1., -1.], [32., -1.], [32., 32.], [-1., 32.]]);
    scene.set_container(Some(&container)).unwrap();
    let piece = pieces.remove(4).affine([1., 0., 1., 0., 1., 1.]).unwrap();
    let pieces: Vec<_> = pieces.iter().collect();
    scene.add_many(&pieces, &[[0.1; 2]; 8]).unwrap();

    let options = Options::new();
    let region = scene.free_region(&piece, None, &all(), &options).unwrap();
    let exact = "-32425917317067571/36028797018963968";
    assert_eq!(region.exact_vertices(), [format!("{exact} {exact}")]);
    let nearest = [0.1 - 1.; 2];
    assert_eq!(region.points(), [nearest]);
    assert_eq!(region.locate(&[nearest]), Ok(vec![Outside]));

    let best = scene.best(&piece, [-1., 0.], &all(), &options);
    assert_eq!(best, Ok(Some(nearest)));
    let relation = scene.relation(&piece, nearest, &all(), &options);
    assert_eq!(relation, Ok(Relation::Overlapping));
    let found = scene
        .penetration(&piece, [0., 0.], &all(), &options)
        .unwrap();
    assert_eq!((found.position(), found.id()), (nearest, 2));
    assert_eq!(found.relation(), Relation::Overlapping);

    let outward = Options::new().rounding(Rounding::Outward);
    let region = scene.free_region(&piece, None, &all(), &outward).unwrap();
    assert!(region.is_empty());
    assert_eq!(region.stats().parts_dropped, 1);
}

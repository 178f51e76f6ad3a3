// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! How far two polygons are apart, and where.

use gcv::status::*;
use gcv::ContactKind::{EdgeVertex, VertexEdge, VertexVertex};
use gcv::{distance, distance_into, distance_many, relation_many};
use gcv::{Contact, ContactKind, Options, Polygon, Relation, Separation};

use crate::{assert_fails, frame, polygon, slot, square};

fn separation(a: &Polygon, b: &Polygon, translation: [f64; 2]) -> Separation {
    distance(a, b, translation, &Options::new()).unwrap()
}

fn nearest(a: &Polygon, b: &Polygon, translation: [f64; 2]) -> Contact {
    let separation = separation(a, b, translation);
    let nearest = separation.nearest().unwrap();
    assert_eq!(nearest.gap(), separation.distance());
    nearest
}

#[test]
fn corners() {
    let unit = square(1.);
    let found = separation(&unit, &unit, [4., 5.]);
    assert_eq!((found.distance(), found.relation()), (5., Relation::Apart));
    let nearest = nearest(&unit, &unit, [4., 5.]);
    let kind = VertexVertex {
        vertex_a: 2,
        vertex_b: 0,
    };
    assert_eq!((nearest.kind(), nearest.normal()), (kind, [0.6, 0.8]));
    assert_eq!((nearest.on_a(), nearest.on_b()), ([1., 1.], [4., 5.]));
    let debug = "Contact { kind: VertexVertex { vertex_a: 2, vertex_b: 0 }, id_a: 0, id_b: 0, \
                 gap: 5.0, normal: [0.6, 0.8], on_a: [1.0, 1.0], on_b: [4.0, 5.0] }";
    assert_eq!(format!("{nearest:?}"), debug);
    let debug =
        format!("Separation {{ distance: 5.0, relation: Apart, id: 0, nearest: Some({debug}) }}");
    assert_eq!(format!("{found:?}"), debug);
}

#[test]
fn edges_and_vertices() {
    let (unit, triangle) = (square(1.), polygon(&[[0., 0.], [2., -1.], [2., 1.]]));
    let to_the_right = nearest(&unit, &triangle, [3., 0.25]);
    let kind = EdgeVertex {
        edge_a: 1,
        vertex_b: 0,
    };
    assert_eq!(to_the_right.kind(), kind);
    assert_eq!((to_the_right.gap(), to_the_right.normal()), (2., [1., 0.]));
    assert_eq!(
        (to_the_right.on_a(), to_the_right.on_b()),
        ([1., 0.25], [3., 0.25])
    );

    // Exchanged, the normal is towards the square.
    let exchanged = nearest(&triangle, &unit, [-3., -0.25]);
    let kind = VertexEdge {
        vertex_a: 0,
        edge_b: 1,
    };
    assert_eq!(exchanged.kind(), kind);
    assert_eq!((exchanged.gap(), exchanged.normal()), (2., [-1., 0.]));
    assert_eq!((exchanged.on_a(), exchanged.on_b()), ([0., 0.], [-2., 0.]));
}

/// Of several, the smallest kind, then the smallest numbers.
#[test]
fn one_of_several() {
    let nearest = nearest(&square(4.), &square(1.), [6., 1.]);
    let kind = EdgeVertex {
        edge_a: 1,
        vertex_b: 0,
    };
    assert_eq!(nearest.kind(), kind);
    assert_eq!((nearest.on_a(), nearest.on_b()), ([4., 1.], [6., 1.]));
}

#[test]
fn correctly_rounded() {
    let unit = square(1.);
    let diagonal = separation(&unit, &unit, [2., 2.]);
    assert_eq!(diagonal.distance(), std::f64::consts::SQRT_2);
    let triangle = polygon(&[[0., 0.], [3., -1.], [3., 2.]]);
    let nearest = nearest(&triangle, &unit, [0., 2.]);
    // From (1, 2) to the line 3 y = 2 x: 4 / sqrt(13).
    assert_eq!(nearest.gap(), 1.1094003924504583);
}

/// Squares of these distances are beyond the range of doubles.
#[test]
fn very_large_and_very_small() {
    for exponent in [-1000, -600, 600, 1000] {
        let size = 2_f64.powi(exponent);
        let triangle = polygon(&[[0., 0.], [size, 0.], [0., size]]);
        let square = square(size);
        let found = separation(&square, &triangle, [4. * size, 5. * size]);
        let nearest = found.nearest().unwrap();
        assert_eq!(found.distance(), 5. * size, "2^{exponent}");
        assert_eq!((nearest.normal(), nearest.on_a()), ([0.6, 0.8], [size; 2]));
    }
}

#[test]
fn in_a_hole() {
    let nearest = nearest(&frame(), &square(2.), [2., 3.]);
    // The left edge of the hole is edge 7 of the frame as passed.
    let kind = EdgeVertex {
        edge_a: 7,
        vertex_b: 0,
    };
    assert_eq!((nearest.kind(), nearest.gap()), (kind, 1.));
    assert_eq!((nearest.on_a(), nearest.on_b()), ([1., 3.], [2., 3.]));
    assert_eq!(nearest.normal(), [1., 0.]);
}

#[test]
fn touching_and_overlapping() {
    for (translation, relation) in [
        ([2., 4.], Relation::Touching),
        ([2., 1.], Relation::Overlapping),
    ] {
        let found = separation(&slot(), &square(2.), translation);
        assert_eq!((found.distance(), found.relation()), (0., relation));
        assert_eq!(found.nearest(), None);
    }
    let touching = separation(&slot(), &square(2.), [2., 4.]);
    assert_eq!(touching, Separation::default());
    let debug = "Separation { distance: 0.0, relation: Touching, id: 0, nearest: None }";
    assert_eq!(format!("{touching:?}"), debug);
}

#[test]
fn too_near_for_doubles() {
    let tiny = f64::from_bits(1);
    let above = polygon(&[[0., 0.], [4. * tiny, tiny], [0., tiny]]);
    let below = polygon(&[[0., 0.], [0., -1.], [1., -1.]]);
    let found = separation(&above, &below, [tiny, 0.]);
    assert_eq!((found.distance(), found.relation()), (0., Relation::Apart));
    let kind = EdgeVertex {
        edge_a: 0,
        vertex_b: 0,
    };
    assert_eq!(found.nearest().unwrap().kind(), kind);
}

#[test]
fn many_and_into_a_slice() {
    let (slot, peg, options) = (slot(), square(2.), Options::new());
    let translations: Vec<_> = (0..100)
        .map(|k| [f64::from(k % 10), f64::from(k / 10)])
        .collect();
    let many = distance_many(&slot, &peg, &translations, &options).unwrap();
    let relations = relation_many(&slot, &peg, &translations, &options).unwrap();
    let mut out = vec![Separation::default(); 100];
    distance_into(&slot, &peg, &translations, &options, &mut out).unwrap();
    assert_eq!(out, many);
    for (k, found) in many.iter().enumerate() {
        assert_eq!(*found, separation(&slot, &peg, translations[k]));
        assert_eq!(found.relation(), relations[k]);
        let apart = found.relation() == Relation::Apart;
        assert_eq!(found.distance() > 0., apart);
        assert_eq!(found.nearest().is_some(), apart);
    }
    let kinds: Vec<ContactKind> = many
        .iter()
        .filter_map(|found| Some(found.nearest()?.kind()))
        .collect();
    assert!(kinds.iter().any(|kind| matches!(kind, VertexVertex { .. })));

    assert_eq!(distance_many(&slot, &peg, &[], &options), Ok(vec![]));
    assert_eq!(distance_into(&slot, &peg, &[], &options, &mut []), Ok(()));
}

#[test]
fn refused() {
    let (unit, options) = (square(1.), Options::new());
    let failed = distance(&unit, &unit, [0., f64::NAN], &options);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "translations: number 0 ");

    let start = separation(&unit, &unit, [7., 0.]);
    let mut out = [start; 2];
    let translations = [[1., 1.], [f64::INFINITY, 0.]];
    let failed = distance_into(&unit, &unit, &translations, &options, &mut out);
    assert_fails(failed, GCV_ERR_NOT_FINITE, "translations: number 1 ");
    let failed = distance_into(&unit, &unit, &translations[..1], &options, &mut out);
    let message = "out: the length is 2, that of translations is 1";
    assert_fails(failed, GCV_ERR_INVALID_ARGUMENT, message);
    assert_eq!(out, [start; 2]);
}

#[test]
fn out_of_range() {
    let (left, right) = (
        polygon(&[[-1.7e308, 0.], [-1.6e308, 0.], [-1.7e308, 1.]]),
        polygon(&[[1.6e308, 0.], [1.7e308, 0.], [1.7e308, 1.]]),
    );
    let translations = [[-1.7e308, 0.], [0., 0.]];
    let options = Options::new();
    let failed = distance_many(&left, &right, &translations, &options);
    assert_fails(failed, GCV_ERR_RANGE, "translations: number 1: ");
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Questions about a polygon in a scene: relation, distance, cast, near.

use gcv::ContactKind::{EdgeVertex, VertexVertex};
use gcv::Relation::{self, Apart, Overlapping, Touching};
use gcv::{Impact, Options, Scene, Separation};

use crate::{all, on_a_sheet, pairs, polygon, sheet, square, squares};

fn relation(scene: &Scene, size: f64, position: [f64; 2]) -> Relation {
    let found = scene.relation(&square(size), position, &all(), &Options::new());
    found.unwrap()
}

fn distance(scene: &Scene, size: f64, position: [f64; 2]) -> Separation {
    let found = scene.distance(&square(size), position, &all(), &Options::new());
    found.unwrap()
}

fn cast(scene: &Scene, size: f64, position: [f64; 2], motion: [f64; 2]) -> Impact {
    let found = scene.cast(&square(size), position, motion, &all(), &Options::new());
    found.unwrap()
}

#[test]
fn relations() {
    let scene = on_a_sheet();
    for (position, expected) in [
        ([1., 0.], Touching),
        ([1.5, 0.5], Apart),
        ([0.5, 0.5], Overlapping),
        ([3., 4.], Touching),
        ([3.5, 4.], Overlapping),
        ([4.5, 4.5], Overlapping),
        ([9., 7.], Touching),
        ([9., 8.5], Overlapping),
        ([9.5, 2.], Overlapping),
        ([50., 2.], Overlapping),
        ([10., 2.], Overlapping),
    ] {
        assert_eq!(relation(&scene, 1., position), expected, "{position:?}");
    }
    // As large as the sheet, or as the room beside the block.
    assert_eq!(relation(&scene, 10., [0., 0.]), Overlapping);
    assert_eq!(relation(&scene, 4., [6., 0.]), Touching);
}

#[test]
fn members_may_overlap() {
    let scene = squares(&[[0., 0.], [0.5, 0.5], [0., 0.]]);
    assert_eq!(relation(&scene, 1., [1., 0.]), Overlapping);
    assert_eq!(relation(&scene, 1., [-1., 0.]), Touching);
    assert_eq!(relation(&scene, 1., [1.75, 0.]), Apart);
}

/// The sums of coordinates are no doubles.
#[test]
fn positions_are_exact() {
    let (mut scene, tiny) = (Scene::new(), f64::from_bits(1));
    let low = polygon(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]]);
    scene.add(&low, [0., 1.]).unwrap();
    let options = Options::new();
    let relation_of = |bottom: f64| {
        let above = polygon(&[[0., bottom], [1., bottom], [0., 2.]]);
        scene.relation(&above, [0., 2.], &all(), &options)
    };
    assert_eq!(relation_of(0.), Ok(Touching));
    assert_eq!(relation_of(tiny), Ok(Apart));
    assert_eq!(relation_of(-tiny), Ok(Overlapping));

    let mut scene = Scene::new();
    scene.add(&square(1.7e308), [1.7e308, 0.]).unwrap();
    assert_eq!(relation(&scene, 1.7e308, [0., 0.]), Touching);
    assert_eq!(relation(&scene, 1.7e308, [-1., 0.]), Apart);
}

#[test]
fn distances() {
    let scene = squares(&[[0., 0.], [9., 0.]]);
    let found = distance(&scene, 1., [4., 5.]);
    assert_eq!((found.id(), found.distance()), (2, 5.));
    assert_eq!(found.relation(), Apart);
    let nearest = found.nearest().unwrap();
    let kind = VertexVertex {
        vertex_a: 2,
        vertex_b: 0,
    };
    assert_eq!((nearest.kind(), nearest.gap()), (kind, 5.));
    assert_eq!((nearest.id_a(), nearest.id_b()), (2, 0));
    assert_eq!((nearest.on_a(), nearest.on_b()), ([1., 1.], [4., 5.]));
    assert_eq!(nearest.normal(), [0.6, 0.8]);
    let debug = format!("{found:?}");
    assert!(debug.starts_with("Separation { distance: 5.0, relation: Apart, id: 2, nearest: "));

    let found = distance(&scene, 1., [6.5, 0.25]);
    let nearest = found.nearest().unwrap();
    let kind = EdgeVertex {
        edge_a: 3,
        vertex_b: 1,
    };
    assert_eq!((found.id(), found.distance()), (3, 1.5));
    assert_eq!((nearest.kind(), nearest.normal()), (kind, [-1., 0.]));
    // Where its member is.
    assert_eq!((nearest.on_a(), nearest.on_b()), ([9., 0.25], [7.5, 0.25]));
}

#[test]
fn the_smallest_id_of_several() {
    let mut scene = squares(&[[5., 0.], [0., 0.], [5., 0.]]);
    assert_eq!(distance(&scene, 1., [2.5, 0.]).id(), 2);
    assert_eq!(cast(&scene, 1., [2., 0.], [9., 0.]).id(), 2);
    scene.set_positions(&[2], &[[0., 0.]]).unwrap();
    assert_eq!(distance(&scene, 1., [2.75, 0.]).id(), 4);
    assert_eq!(distance(&scene, 1., [2.5, 0.]).id(), 2);
    scene.set_container(Some(&square(8.))).unwrap();
    assert_eq!(distance(&scene, 1., [6.5, 3.]).id(), Scene::CONTAINER);
    // As far from the container as from a member.
    assert_eq!(distance(&scene, 1., [1.25, 0.25]).id(), 1);
}

/// There the contact is none, but for its id.
#[test]
fn distance_of_what_touches_and_overlaps() {
    let scene = on_a_sheet();
    for (position, id, relation) in [
        ([1., 0.5], 2, Touching),
        ([0.5, 0.5], 2, Overlapping),
        ([1., 0.], 1, Touching),
        ([4.5, 4.5], 1, Overlapping),
        ([9.5, 5.], 1, Overlapping),
        ([8., 8.5], 3, Touching),
    ] {
        let found = distance(&scene, 1., position);
        assert_eq!((found.distance(), found.id()), (0., id), "{position:?}");
        assert_eq!(found.relation(), relation, "{position:?}");
        assert_eq!(found.nearest(), None, "{position:?}");
    }
    // The first one is touched, the second one overlapped.
    let found = distance(&squares(&[[0., 0.], [1.5, 0.]]), 1., [1., 0.]);
    assert_eq!((found.id(), found.relation()), (2, Overlapping));
}

#[test]
fn nothing_to_be_near() {
    for scene in [Scene::new(), squares(&[])] {
        let found = distance(&scene, 1., [3., 4.]);
        assert_eq!((found.distance(), found.id()), (f64::INFINITY, 0));
        assert_eq!((found.relation(), found.nearest()), (Apart, None));
        assert_eq!(relation(&scene, 1., [3., 4.]), Apart);
        let impact = cast(&scene, 1., [3., 4.], [1., -2.]);
        assert!(!impact.hit());
        assert_eq!((impact.id(), impact.time()), (0, 1.));
        assert_eq!((impact.position(), impact.relation()), ([4., 2.], Apart));
        let near = scene.near(&square(1.), [3., 4.], 1e300, &all(), &Options::new());
        assert!(near.unwrap().is_empty());
    }
}

#[test]
fn only_a_container() {
    let mut scene = Scene::new();
    scene.set_container(Some(&sheet())).unwrap();
    let found = distance(&scene, 1., [2.5, 2.]);
    assert_eq!((found.id(), found.distance()), (1, 1.118033988749895));
    let nearest = found.nearest().unwrap();
    assert_eq!((nearest.on_a(), nearest.on_b()), ([4., 4.], [3.5, 3.]));
    let impact = cast(&scene, 1., [2., 2.], [0., 28.]);
    assert_eq!((impact.id(), impact.position()), (1, [2., 9.]));
    assert_eq!(impact.time(), 0.25);
    assert_eq!(impact.relation(), Touching);
}

#[test]
fn casts() {
    let scene = squares(&[[9., 0.], [5., 0.5], [5., 8.]]);
    let found = cast(&scene, 1., [0., 0.], [8., 0.]);
    assert!(found.hit());
    assert_eq!((found.id(), found.time()), (3, 0.5));
    assert_eq!((found.position(), found.relation()), ([4., 0.], Touching));
    let contact = found.contact().unwrap();
    assert_eq!((contact.id_a(), contact.id_b(), contact.gap()), (3, 0, 0.));
    assert_eq!(contact.normal(), [-1., 0.]);
    assert_eq!(contact.on_a(), contact.on_b());
    let debug = format!("{found:?}");
    assert!(
        debug.contains("relation: Touching, id: 3, contact: Some("),
        "{debug}"
    );

    // Along the second one, which is no hit.
    let found = cast(&scene, 1., [0., -0.5], [16., 0.]);
    assert_eq!(
        (found.id(), found.time(), found.position()),
        (2, 0.5, [8., -0.5])
    );
    let found = cast(&scene, 1., [0., 3.], [16., 0.]);
    assert_eq!((found.hit(), found.id(), found.time()), (false, 0, 1.));
    assert_eq!(found.position(), [16., 3.]);
    assert_eq!(found.contact(), None);
}

/// From all of the smallest numbers on.
#[test]
fn casts_at_any_scale() {
    for unit in [1, 1 << 20, 1 << 50, 1 << 60].map(f64::from_bits) {
        let mut scene = Scene::new();
        let triangle = polygon(&[[0., 0.], [4. * unit, 0.], [0., 2. * unit]]);
        let id = scene.add(&triangle, [9. * unit, 0.]).unwrap();
        let found = cast(&scene, unit, [9. * unit, 3. * unit], [0., -2. * unit]);
        assert_eq!((found.id(), found.time()), (id, 0.5), "{unit}");
        assert_eq!(found.position(), [9. * unit, 2. * unit], "{unit}");
    }
}

/// Position and relation are about the whole scene.
#[test]
fn casts_end_beside_others() {
    let scene = squares(&[[3., 1.], [5., 0.]]);
    let found = cast(&scene, 1., [0., 0.], [8., 0.]);
    assert_eq!((found.id(), found.position()), (3, [4., 0.]));
    assert_eq!(found.relation(), Touching);
    // Without a hit, it ends below the first one.
    let found = cast(&scene, 1., [0., 0.], [3., 0.]);
    assert_eq!((found.hit(), found.relation()), (false, Touching));
}

#[test]
fn overlapping_at_the_start() {
    let scene = squares(&[[5., 0.], [0., 0.], [0.5, 0.]]);
    for motion in [[0., 0.], [5., 0.]] {
        let found = cast(&scene, 1., [0.25, 0.], motion);
        assert!(found.hit());
        assert_eq!((found.id(), found.time()), (3, 0.));
        assert_eq!(
            (found.position(), found.relation()),
            ([0.25, 0.], Overlapping)
        );
        assert_eq!(found.contact(), None);
    }
}

#[test]
fn near() {
    let scene = on_a_sheet();
    let near = |position, distance| {
        let list = scene.near(&square(1.), position, distance, &all(), &Options::new());
        pairs(&list.unwrap())
    };
    assert_eq!(near([2., 1.], 0.5), []);
    assert_eq!(near([2., 1.], 1.), [(1, 0, Apart), (2, 0, Apart)]);
    assert_eq!(near([1., 1.], 0.), [(2, 0, Touching)]);
    assert_eq!(near([0.5, 0.], 0.), [(1, 0, Touching), (2, 0, Overlapping)]);
    assert_eq!(
        near([9.5, 8.5], 0.),
        [(1, 0, Overlapping), (3, 0, Overlapping)]
    );
    let expected = [(1, 0, Touching), (2, 0, Overlapping), (3, 0, Apart)];
    assert_eq!(near([0., 0.], 1e308), expected);
}

/// Whether a distance is at most another one is decided exactly.
#[test]
fn near_is_exact() {
    let scene = squares(&[[0., 0.]]);
    let near = |distance| {
        let list = scene.near(&square(1.), [2., 2.], distance, &all(), &Options::new());
        list.unwrap().len()
    };
    // The square of the nearest double to the root of 2 is above 2.
    let root = std::f64::consts::SQRT_2;
    assert_eq!((near(root), near(root - f64::EPSILON)), (1, 0));
}

#[test]
fn slices_and_single_ones() {
    let (scene, unit, options) = (on_a_sheet(), square(1.), Options::new());
    let positions: Vec<_> = (0..400)
        .map(|k| [f64::from(k % 20) * 0.75, f64::from(k / 20) * 0.75])
        .collect();
    let motions: Vec<_> = positions.iter().map(|[x, y]| [4. - y, x - 4.]).collect();
    let (from, query) = (&positions[..], all());
    let relations = scene.relation_many(&unit, from, &query, &options).unwrap();
    let separations = scene.distance_many(&unit, from, &query, &options).unwrap();
    let impacts = scene
        .cast_many(&unit, from, &motions, &query, &options)
        .unwrap();

    let mut into = (
        vec![Apart; 400],
        vec![Separation::default(); 400],
        vec![Impact::default(); 400],
    );
    scene
        .relation_into(&unit, from, &query, &options, &mut into.0)
        .unwrap();
    scene
        .distance_into(&unit, from, &query, &options, &mut into.1)
        .unwrap();
    scene
        .cast_into(&unit, from, &motions, &query, &options, &mut into.2)
        .unwrap();
    assert!(into == (relations.clone(), separations.clone(), impacts.clone()));

    for k in 0..400 {
        assert_eq!(relations[k], relation(&scene, 1., positions[k]));
        assert_eq!(separations[k], distance(&scene, 1., positions[k]));
        assert_eq!(separations[k].relation(), relations[k]);
        assert_eq!(impacts[k], cast(&scene, 1., positions[k], motions[k]));
    }
    for expected in [Apart, Touching, Overlapping] {
        assert!(relations.contains(&expected));
    }
}

#[test]
fn of_no_positions() {
    let (scene, unit, query, options) = (on_a_sheet(), square(1.), all(), Options::new());
    assert_eq!(
        scene.relation_many(&unit, &[], &query, &options),
        Ok(vec![])
    );
    assert_eq!(
        scene.distance_many(&unit, &[], &query, &options),
        Ok(vec![])
    );
    assert_eq!(
        scene.cast_many(&unit, &[], &[], &query, &options),
        Ok(vec![])
    );
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What holds of every pair of polygons, wherever they are.

use std::f64::consts::TAU;

use gcv::Relation::{self, Apart, Overlapping, Touching};
use gcv::{cast, distance, no_fit_region, relation, relation_many, Location, Options, Polygon};
use proptest::prelude::*;

/// Star-shaped polygons about the origin, with radii from 1 to 10, and some with a hole.
fn polygons() -> impl Strategy<Value = Polygon> {
    (prop::collection::vec(1.0..10.0, 3..20), any::<bool>()).prop_map(
        |(radii, hollow): (Vec<f64>, bool)| {
            let step = TAU / radii.len() as f64;
            let ring = |scale: f64| -> Vec<_> {
                let vertex = |(k, radius): (usize, &f64)| {
                    let (sin, cos) = (step * k as f64).sin_cos();
                    [scale * radius * cos, scale * radius * sin]
                };
                radii.iter().enumerate().map(vertex).collect()
            };
            let rings = [ring(1.), ring(0.75)];
            Polygon::from_rings(&rings[..1 + usize::from(hollow)]).unwrap()
        },
    )
}

/// Polygons whose vertices are small integers: they often touch.
fn integer_polygons() -> impl Strategy<Value = Polygon> {
    prop::collection::vec([0..6, 0..6], 3..8).prop_filter_map("no polygon", |ring| {
        let ring: Vec<_> = ring
            .into_iter()
            .map(|vertex| vertex.map(f64::from))
            .collect();
        Polygon::new(&ring).ok()
    })
}

fn vectors() -> impl Strategy<Value = [f64; 2]> {
    [-20.0..20.0, -20.0..20.0]
}

fn integer_vectors() -> impl Strategy<Value = [f64; 2]> {
    [-8..8, -8..8].prop_map(|vector: [i32; 2]| vector.map(f64::from))
}

fn relation_of(a: &Polygon, b: &Polygon, translation: [f64; 2]) -> Relation {
    relation(a, b, translation, &Options::new()).unwrap()
}

fn check_relations(a: &Polygon, b: &Polygon, mut translations: Vec<[f64; 2]>) {
    let options = Options::new();
    let region = no_fit_region(a, b, [0., 0.], &options).unwrap();
    translations.extend(region.vertices());
    let relations = relation_many(a, b, &translations, &options).unwrap();
    let locations = region.locate(&translations).unwrap();
    for (k, location) in locations.into_iter().enumerate() {
        let expected = match location {
            Location::Inside => Overlapping,
            Location::Boundary => Touching,
            Location::Outside => Apart,
        };
        assert_eq!(relations[k], expected, "{a} {b} {:?}", translations[k]);
        let exchanged = relation_of(b, a, translations[k].map(|c| -c));
        assert_eq!(exchanged, expected, "{b} {a} {:?}", translations[k]);
    }
}

fn check_distance(a: &Polygon, b: &Polygon, translation: [f64; 2]) {
    let options = Options::new();
    let found = distance(a, b, translation, &options).unwrap();
    assert_eq!(found.relation(), relation_of(a, b, translation));
    assert_eq!(found.distance() > 0., found.relation() == Apart);
    let exchanged = distance(b, a, translation.map(|c| -c), &options).unwrap();
    assert_eq!(exchanged.distance(), found.distance());
    if let Some(nearest) = found.nearest() {
        assert_eq!(nearest.gap(), found.distance());
        let (on_a, on_b, normal) = (nearest.on_a(), nearest.on_b(), nearest.normal());
        assert!((normal[0].hypot(normal[1]) - 1.).abs() < 1e-15);
        for axis in 0..2 {
            let difference = on_b[axis] - on_a[axis];
            assert!((nearest.gap() * normal[axis] - difference).abs() < 1e-13);
        }
    }
}

fn check_cast(a: &Polygon, b: &Polygon, from: [f64; 2], motion: [f64; 2]) {
    let found = cast(a, b, from, motion, &Options::new()).unwrap();
    assert!((0. ..=1.).contains(&found.time()), "{found:?}");
    assert_eq!(found.relation(), relation_of(a, b, found.position()));
    for axis in 0..2 {
        let end = from[axis] + found.time() * motion[axis];
        assert!((found.position()[axis] - end).abs() < 1e-13, "{found:?}");
    }
    if relation_of(a, b, from) == Overlapping {
        assert!(found.hit() && found.time() == 0. && found.contact().is_none());
        return;
    }
    assert_eq!(found.contact().is_some(), found.hit());
    if let Some(contact) = found.contact() {
        let normal = contact.normal();
        assert!(normal[0] * motion[0] + normal[1] * motion[1] <= 1e-13);
        assert_eq!(contact.gap(), 0.);
    } else {
        assert_eq!(found.time(), 1.);
    }
}

/// At fractions of the motion, and right after a hit. All numbers are small integers, so the
/// fractions of a motion are exact, and an overlap is not very short.
fn check_cast_of_integers(a: &Polygon, b: &Polygon, from: [f64; 2], motion: [f64; 2]) {
    check_cast(a, b, from, motion);
    let found = cast(a, b, from, motion, &Options::new()).unwrap();
    let at = |time: f64| [from[0] + time * motion[0], from[1] + time * motion[1]];
    let fractions = (0..=32).map(|k| f64::from(k) / 32.);
    for time in fractions.filter(|time| found.time() > 0. && *time <= found.time()) {
        assert_ne!(relation_of(a, b, at(time)), Overlapping, "{found:?}");
    }
    if found.hit() && motion != [0., 0.] {
        let after = at(found.time() + 2_f64.powi(-30));
        assert_eq!(relation_of(a, b, after), Overlapping, "{found:?}");
    }
}

/// Scaled by a power of two, nothing changes but for the scale.
fn check_scale(a: &Polygon, b: &Polygon, from: [f64; 2], motion: [f64; 2], scale: f64) {
    let options = Options::new();
    let polygon = |polygon: &Polygon| polygon.affine([scale, 0., 0., 0., scale, 0.]).unwrap();
    let vector = |vector: [f64; 2]| vector.map(|c| scale * c);
    let (large_a, large_b) = (polygon(a), polygon(b));
    let (large_from, large_motion) = (vector(from), vector(motion));

    let found = cast(&large_a, &large_b, large_from, large_motion, &options).unwrap();
    let expected = cast(a, b, from, motion, &options).unwrap();
    assert_eq!(found.time(), expected.time());
    assert_eq!(found.position(), vector(expected.position()));
    assert_eq!(
        (found.hit(), found.relation()),
        (expected.hit(), expected.relation())
    );
    let kinds = [found, expected].map(|found| found.contact().map(|contact| contact.kind()));
    assert_eq!(kinds[0], kinds[1]);

    let found = distance(&large_a, &large_b, large_from, &options).unwrap();
    let expected = distance(a, b, from, &options).unwrap();
    assert_eq!(found.distance(), scale * expected.distance());
    assert_eq!(found.relation(), expected.relation());
    let kinds = [found, expected].map(|found| found.nearest().map(|contact| contact.kind()));
    assert_eq!(kinds[0], kinds[1]);
}

proptest! {
    #[test]
    fn relations(a in polygons(), b in polygons(), t in prop::collection::vec(vectors(), 20)) {
        check_relations(&a, &b, t);
    }

    /// The second polygon is much larger or smaller than the first, and both may be.
    #[test]
    fn at_any_scale(
        a in integer_polygons(), b in integer_polygons(), t in integer_vectors(),
        scales in [-400..400, -60..60]
    ) {
        let scale = [scales[0], scales[0] + scales[1]].map(|exponent| 2_f64.powi(exponent));
        let scaled = |polygon: &Polygon, s| polygon.affine([s, 0., 0., 0., s, 0.]).unwrap();
        let (a, b) = (scaled(&a, scale[0]), scaled(&b, scale[1]));
        check_relations(&a, &b, vec![t.map(|c| c * scale[0]), t.map(|c| c * scale[1])]);
    }

    #[test]
    fn relations_of_integers(
        a in integer_polygons(), b in integer_polygons(),
        t in prop::collection::vec(integer_vectors(), 20)
    ) {
        check_relations(&a, &b, t);
    }

    #[test]
    fn distances(a in polygons(), b in polygons(), t in vectors()) {
        check_distance(&a, &b, t);
    }

    #[test]
    fn distances_of_integers(
        a in integer_polygons(), b in integer_polygons(), t in integer_vectors()
    ) {
        check_distance(&a, &b, t);
    }

    #[test]
    fn casts(a in polygons(), b in polygons(), from in vectors(), motion in vectors()) {
        check_cast(&a, &b, from, motion);
    }

    #[test]
    fn casts_of_integers(
        a in integer_polygons(), b in integer_polygons(),
        from in integer_vectors(), motion in integer_vectors()
    ) {
        check_cast_of_integers(&a, &b, from, motion);
    }

    #[test]
    fn scales(
        a in integer_polygons(), b in integer_polygons(),
        from in integer_vectors(), motion in integer_vectors(), exponent in -960..1010
    ) {
        check_scale(&a, &b, from, motion, 2_f64.powi(exponent));
    }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! What holds of every pair of polygons.

use std::f64::consts::TAU;

use gcv::{entrance_block, minkowski_sum, minkowski_sum_many, no_fit_polygon, Error};
use gcv::{inner_fit_region, minkowski_sum_region, no_fit_region, Location};
use gcv::{Options, OuterFace, Polygon, Rounding};
use proptest::prelude::*;

/// Star-shaped rings about the origin, with radii from 1 to 10.
fn rings() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec(1.0..10.0, 3..30).prop_map(|radii: Vec<f64>| {
        let step = TAU / radii.len() as f64;
        let vertex = |(k, radius): (usize, &f64)| {
            let (sin, cos) = (step * k as f64).sin_cos();
            [radius * cos, radius * sin]
        };
        radii.iter().enumerate().map(vertex).collect()
    })
}

fn polygons() -> impl Strategy<Value = Polygon> {
    rings().prop_map(|ring| Polygon::new(&ring).unwrap())
}

fn sum(a: &Polygon, b: &Polygon) -> Result<OuterFace, Error> {
    minkowski_sum(a, b, &Options::new())
}

proptest! {
    #[test]
    fn rings_are_normalised(ring in rings(), turns in 0..30_usize) {
        let polygon = Polygon::new(&ring).unwrap();
        let mut turned = ring;
        let turns = turns % turned.len();
        turned.rotate_left(turns);
        turned.reverse();
        prop_assert_eq!(Polygon::new(&turned).unwrap().vertices(), polygon.vertices());
    }

    #[test]
    fn reflections_are_exact(ring in rings(), hole in rings()) {
        let large: Vec<_> = ring.iter().map(|[x, y]| [20. * x, 20. * y]).collect();
        let polygon = Polygon::from_rings([&large, &hole]).unwrap();
        let negated = |ring: &[[f64; 2]]| ring.iter().map(|[x, y]| [-x, -y]).collect::<Vec<_>>();
        let expected = Polygon::from_rings([negated(&large), negated(&hole)]).unwrap();
        prop_assert_eq!(-&polygon, expected);
        prop_assert_eq!(-(-&polygon), polygon);
    }

    #[test]
    fn text_reads_back(ring in prop::collection::vec([any::<f64>(), any::<f64>()], 3..6)) {
        if let Ok(polygon) = Polygon::new(&ring) {
            prop_assert_eq!(polygon.to_string().parse(), Ok(polygon));
        }
    }

    #[test]
    fn many_polygons_are_as_one_by_one(
        rings in prop::collection::vec(prop::collection::vec([0..4, 0..4], 0..6), 0..9)
    ) {
        let float = |ring: &Vec<[i32; 2]>| -> Vec<[f64; 2]> {
            ring.iter().map(|vertex| vertex.map(f64::from)).collect()
        };
        let rings: Vec<_> = rings.iter().map(float).collect();
        let polygons = Polygon::many(&rings);
        prop_assert_eq!(polygons.len(), rings.len());
        for (polygon, ring) in polygons.into_iter().zip(rings) {
            match (polygon, Polygon::new(&ring)) {
                (Err(error), Err(expected)) => prop_assert_eq!(error.status, expected.status),
                (polygon, expected) => prop_assert_eq!(polygon, expected),
            }
        }
    }

    #[test]
    fn sums_commute(a in polygons(), b in polygons()) {
        let (ab, ba) = (sum(&a, &b).unwrap(), sum(&b, &a).unwrap());
        prop_assert_eq!(ab.vertices(), ba.vertices());
        prop_assert_eq!(ab.exact_vertices(), ba.exact_vertices());
    }

    #[test]
    fn edges_have_a_source_each(a in polygons(), b in polygons()) {
        let face = sum(&a, &b).unwrap();
        prop_assert_eq!(face.sources().len(), face.exact_vertices().len());
    }

    #[test]
    fn sums_hold_both(a in polygons(), b in polygons()) {
        let face = sum(&a, &b).unwrap();
        // Brunn and Minkowski; the region inside the outer face is at least the sum.
        let roots = a.area().unwrap().sqrt() + b.area().unwrap().sqrt();
        prop_assert!(face.area().unwrap().sqrt() > roots * (1. - 1e-12));
        let [xmin, ymin, xmax, ymax] = face.polygon().unwrap().bounds();
        let (a, b) = (a.bounds(), b.bounds());
        prop_assert_eq!([xmin, ymin, xmax, ymax], [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]]);
    }

    #[test]
    fn no_fit_polygons_are_sums(a in polygons(), b in polygons()) {
        let expected = sum(&a, &-&b).unwrap().wkt();
        let no_fit = no_fit_polygon(&a, &b, [0., 0.], &Options::new()).unwrap();
        let entrance = entrance_block(&b, &a, [0., 0.], &Options::new()).unwrap();
        prop_assert_eq!(no_fit.wkt(), &*expected);
        prop_assert_eq!(entrance.wkt(), &*expected);
    }

    #[test]
    fn outward_is_not_smaller(a in polygons(), b in polygons()) {
        let outward = Options::new().rounding(Rounding::Outward);
        let outward = minkowski_sum(&a, &b, &outward).unwrap().polygon().unwrap().bounds();
        let nearest = sum(&a, &b).unwrap().polygon().unwrap().bounds();
        prop_assert!(outward[0] <= nearest[0] && outward[1] <= nearest[1]);
        prop_assert!(outward[2] >= nearest[2] && outward[3] >= nearest[3]);
    }

    #[test]
    fn simplified_within(polygon in polygons(), tolerance in 0.0..20.0) {
        let (near, bound) = polygon.simplified(tolerance, Rounding::Nearest).unwrap();
        prop_assert!(0. <= bound && bound <= tolerance);
        let vertices = polygon.vertices();
        prop_assert!(near.vertices().iter().all(|vertex| vertices.contains(vertex)));
        let (around, bound) = polygon.simplified(tolerance, Rounding::Outward).unwrap();
        prop_assert!(0. <= bound && bound <= tolerance);
        let (outer, inner) = (around.bounds(), polygon.bounds());
        prop_assert!(outer[0] <= inner[0] && outer[1] <= inner[1]);
        prop_assert!(outer[2] >= inner[2] && outer[3] >= inner[3]);
        prop_assert!(around.area().unwrap() >= polygon.area().unwrap());
    }

    #[test]
    fn many_are_as_one_by_one(a in polygons(), b in polygons(), threads in 0..4_usize) {
        let pairs = [(&a, &a), (&a, &b), (&b, &b)];
        let sums = minkowski_sum_many(pairs, &Options::new().threads(threads));
        for (face, (a, b)) in sums.zip(pairs) {
            prop_assert_eq!(face.unwrap().wkt(), sum(a, b).unwrap().wkt());
        }
    }

    #[test]
    fn regions_begin_with_the_outer_face(a in polygons(), b in polygons()) {
        let (region, face) = (minkowski_sum_region(&a, &b, &Options::new()).unwrap(), sum(&a, &b));
        let face = face.unwrap();
        let (vertices, exact) = (region.vertices(), region.exact_vertices());
        prop_assert_eq!(&region.polygons().next().unwrap()[0], &face.vertices());
        prop_assert!(exact.starts_with(&face.exact_vertices()));
        prop_assert_eq!(region.sources().len(), exact.len());
        prop_assert_eq!(region.owners().len(), exact.len());
        prop_assert_eq!(region.exact_indices().len(), vertices.len());
        prop_assert!(region.area().unwrap() <= face.area().unwrap());
        prop_assert_eq!(region.polygons().len(), 1);
        let polygon = region.polygon(0).unwrap();
        prop_assert_eq!(polygon.area(), region.area());
        prop_assert_eq!(minkowski_sum_region(&b, &a, &Options::new()).unwrap(), region);
    }

    #[test]
    fn what_fits_inside_is_inside(a in polygons(), b in polygons()) {
        let small = b.affine([0.125, 0., 0., 0., 0.125, 0.]).unwrap();
        let outward = Options::new().rounding(Rounding::Outward);
        let region = inner_fit_region(&a, &small, [0., 0.], &outward).unwrap();
        let positions = region.vertices();
        let locations = region.locate(&positions).unwrap();
        prop_assert!(!locations.contains(&Location::Outside));
        // Where it is inside, it overlaps the container: the no-fit region says so too.
        let no_fit = no_fit_region(&a, &small, [0., 0.], &Options::new()).unwrap();
        let inside = no_fit.locate(&positions).unwrap();
        prop_assert!(inside.iter().all(|location| *location == Location::Inside));
    }

    #[test]
    fn any_numbers_are_taken_or_refused(
        ring in prop::collection::vec([any::<f64>(), any::<f64>()], 0..6)
    ) {
        if let Ok(polygon) = Polygon::new(&ring) {
            prop_assert!(polygon.vertices().len() >= 3);
            match sum(&polygon, &polygon) {
                Ok(face) => prop_assert!(face.vertices().len() >= 3),
                Err(error) => prop_assert_eq!(error.status, gcv::status::GCV_ERR_RANGE),
            }
        }
    }

    #[test]
    fn any_text_is_taken_or_refused(text in any::<String>()) {
        if let Err(error) = Polygon::from_wkt(&text) {
            prop_assert!(error.status_name().starts_with("GCV_ERR_"));
        }
    }
}

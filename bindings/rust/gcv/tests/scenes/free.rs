// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Known free regions.

use gcv::status::*;
use gcv::EdgeSource::{Translated, TranslatedCorner};
use gcv::Location::{Boundary, Inside, Outside};
use gcv::{inner_fit_region, no_fit_region, Location, Options, PartKind, Polygon, Query, Region};
use gcv::{Relation, Rounding, Scene};

use crate::{all, assert_fails, on_a_sheet, polygon, sheet, square, squares};

const ORIGIN: [f64; 2] = [0., 0.];

fn free(scene: &Scene, moving: &Polygon, window: Option<[f64; 4]>) -> Region {
    let region = scene.free_region(moving, window, &all(), &Options::new());
    region.unwrap()
}

/// Where what has such a relation lies in a region.
fn location(relation: Relation) -> Location {
    match relation {
        Relation::Apart => Inside,
        Relation::Touching => Boundary,
        Relation::Overlapping => Outside,
    }
}

/// A container of size 9 with squares of size 3 in two of its corners. Between them there is room
/// for one more.
fn gap() -> (Scene, Polygon) {
    let (mut scene, part) = (Scene::new(), square(3.));
    scene.set_container(Some(&square(9.))).unwrap();
    scene.add_many(&[&part; 2], &[[0., 0.], [6., 0.]]).unwrap();
    (scene, part)
}

#[test]
fn between_members() {
    let (scene, part) = gap();
    let region = free(&scene, &part, None);
    let wkt = "MULTIPOLYGON (((0 3, 6 3, 6 6, 0 6, 0 3)))";
    assert_eq!(region.wkt(), wkt);
    assert_eq!(region.segments(), [[[3., 0.], [3., 3.]]]);
    assert_eq!((region.area(), region.error_bound()), (Ok(18.), 0.));
    let locations = region.locate(&[[1., 4.], [3., 1.], [3., 3.], [2., 1.], [3., -1.]]);
    let expected = vec![Inside, Boundary, Boundary, Outside, Outside];
    assert_eq!(locations, Ok(expected));
}

#[test]
fn owners_and_sources() {
    let (scene, part) = gap();
    let region = free(&scene, &part, None);
    let exact = [
        "0/1 3/1", "6/1 3/1", "6/1 6/1", "0/1 6/1", "3/1 0/1", "3/1 3/1",
    ];
    assert_eq!(region.exact_vertices(), exact);
    let (owners, sources) = (region.owners(), region.sources());
    // Upon both members, and against three sides of the container.
    assert!([2, 3].contains(&owners[0]), "{owners:?}");
    assert_eq!(owners[1..4], [1, 1, 1]);
    // Along the right side of the one, or the left side of the other.
    assert!([2, 3].contains(&owners[4]), "{owners:?}");
    assert_eq!((owners[5], sources[5]), (0, None));
    // The edges of the container and of the member that make them.
    let along = |k: usize| match sources[k] {
        Some(Translated { edge_a, .. } | TranslatedCorner { edge_a, .. }) => edge_a,
        source => panic!("{k}: {source:?}"),
    };
    assert_eq!([1, 2, 3].map(along), [1, 2, 3]);
    assert_eq!(along(0), 2);
    assert_eq!(along(4), if owners[4] == 2 { 1 } else { 3 });
}

/// Ids stay as members come and go.
#[test]
fn owners_are_ids() {
    let mut scene = squares(&[[20., 20.], [1., 1.], [4., 4.]]);
    scene.set_container(Some(&square(9.))).unwrap();
    scene.remove(&[2]).unwrap();
    scene.set_positions(&[3], &[[6., 2.]]).unwrap();
    let last = scene.add(&square(1.), [2., 6.]).unwrap();
    let region = free(&scene, &square(0.5), None);
    let (owners, parts) = (region.owners(), region.exact_parts());
    let holes: Vec<_> = parts
        .iter()
        .filter(|part| matches!(part.kind, PartKind::Hole { .. }))
        .map(|part| &owners[part.vertices.clone()])
        .collect();
    assert_eq!(holes, [[last; 4], [4; 4], [3; 4]]);
    assert_eq!(owners[parts[0].vertices.clone()], [Scene::CONTAINER; 4]);
}

#[test]
fn only_a_container() {
    let mut scene = Scene::new();
    scene.set_container(Some(&sheet())).unwrap();
    let moving = polygon(&[[0., 0.], [2., 0.], [2., 1.], [1., 1.], [0., 3.]]);
    let region = free(&scene, &moving, None);
    let expected = inner_fit_region(&sheet(), &moving, ORIGIN, &Options::new()).unwrap();
    assert_eq!(region, expected);
    assert_eq!(region.sources(), expected.sources());
    let edges = region.exact_vertices().len();
    assert_eq!(region.owners(), vec![Scene::CONTAINER; edges]);
    assert_eq!(expected.owners(), vec![0; edges]);
}

#[test]
fn nowhere() {
    let (mut scene, part) = gap();
    let region = free(&scene, &square(9.5), None);
    assert!(region.is_empty());
    assert!(region.owners().is_empty() && region.sources().is_empty());
    assert_eq!(region.wkt(), "MULTIPOLYGON EMPTY");
    // Just one place is left.
    scene.add_many(&[&part; 2], &[[0., 3.], [6., 3.]]).unwrap();
    let floor = polygon(&[[0., 0.], [9., 0.], [9., 3.], [0., 3.]]);
    scene.set_container(Some(&floor)).unwrap();
    let region = free(&scene, &part, None);
    assert_eq!(region.points(), [[3., 0.]]);
    assert_eq!((region.owners(), region.sources()), (vec![0], vec![None]));
    scene.add(&square(1.), [4., 1.]).unwrap();
    assert!(free(&scene, &part, None).is_empty());
}

/// What is free of one member in a window is outside of its no-fit region.
#[test]
fn in_a_window_without_a_container() {
    let scene = squares(&[[0., 0.]]);
    let (moving, window) = (square(2.), [-5., -4., 3., 2.]);
    let region = free(&scene, &moving, Some(window));
    let wkt = "MULTIPOLYGON (((-5 -4, 3 -4, 3 2, -5 2, -5 -4), (-2 -2, -2 1, 1 1, 1 -2, -2 -2)))";
    assert_eq!(region.wkt(), wkt);
    let owners = region.owners();
    assert_eq!(owners, [0, 0, 0, 0, 2, 2, 2, 2]);
    for (owner, source) in owners.iter().zip(region.sources()) {
        assert_eq!(*owner == 0, source.is_none());
    }
    let no_fit = no_fit_region(&square(1.), &moving, ORIGIN, &Options::new()).unwrap();
    let points: Vec<_> = (0..48 * 40)
        .map(|k| [f64::from(k % 48) / 4. - 7., f64::from(k / 48) / 4. - 5.])
        .filter(|[x, y]| -5. < *x && *x < 3. && -4. < *y && *y < 2.)
        .collect();
    let opposite: Vec<_> = no_fit
        .locate(&points)
        .unwrap()
        .into_iter()
        .map(|location| match location {
            Inside => Outside,
            Boundary => Boundary,
            Outside => Inside,
        })
        .collect();
    assert_eq!(region.locate(&points), Ok(opposite));

    let nothing = free(&Scene::new(), &moving, Some(window));
    assert_eq!(
        nothing.wkt(),
        "MULTIPOLYGON (((-5 -4, 3 -4, 3 2, -5 2, -5 -4)))"
    );
}

#[test]
fn windows_cut() {
    let (scene, part) = gap();
    for (window, wkt, segments) in [
        // Segments are cut, too.
        (
            [2., 1., 4., 4.],
            "MULTIPOLYGON (((2 3, 4 3, 4 4, 2 4, 2 3)))",
            vec![[[3., 1.], [3., 3.]]],
        ),
        // On the border they stay. What has an area only outside does not.
        (
            [3., 1., 5., 3.],
            "MULTIPOLYGON EMPTY",
            vec![[[3., 1.], [3., 3.]]],
        ),
        ([3.5, 0., 5., 3.], "MULTIPOLYGON EMPTY", vec![]),
        // Larger than the region.
        (
            [-9., -9., 99., 99.],
            "MULTIPOLYGON (((0 3, 6 3, 6 6, 0 6, 0 3)))",
            vec![[[3., 0.], [3., 3.]]],
        ),
        ([50., 50., 51., 51.], "MULTIPOLYGON EMPTY", vec![]),
    ] {
        let region = free(&scene, &part, Some(window));
        assert_eq!(region.wkt(), wkt, "{window:?}");
        assert_eq!(region.segments(), segments, "{window:?}");
    }
    // A corner of the window is in the middle of the segment.
    let region = free(&scene, &part, Some([3., -1., 4., 1.]));
    assert_eq!(region.segments(), [[[3., 0.], [3., 1.]]]);
    let region = free(&scene, &part, Some([1., -1., 3., 0.]));
    assert_eq!(
        (region.points(), region.segments()),
        (vec![[3., 0.]], vec![])
    );
}

#[test]
fn windows_of_any_size() {
    let scene = squares(&[[0., 0.]]);
    // Beside the square, of the smallest size.
    let next = f64::from_bits(1f64.to_bits() + 1);
    let region = free(&scene, &square(1.), Some([1., 0., next, f64::from_bits(1)]));
    assert_eq!(region.vertices()[0], [1., 0.]);
    assert_eq!(region.vertices()[2], [next, f64::from_bits(1)]);
    assert_eq!(region.owners(), [0, 0, 0, 2]);
    let region = free(&scene, &square(1.), Some([-1e300, -1e300, 1e300, 1e300]));
    assert_eq!(region.parts().len(), 2);
    assert_eq!(region.vertices()[0], [-1e300, -1e300]);
}

#[test]
fn relations_at_many_points() {
    let mut scene = on_a_sheet();
    let bar = polygon(&[[0., 0.], [3., 1.], [3., 2.], [1., 1.5]]);
    scene
        .add_many(&[&bar; 3], &[[0.5, 6.], [1., 6.25], [6.125, 1.]])
        .unwrap();
    let hook = polygon(&[[0., 0.], [1., 0.], [1., 0.25], [0.25, 0.25], [0., 1.]]);
    let points: Vec<_> = (0..100 * 100)
        .map(|k| [f64::from(k % 100) / 8. - 1., f64::from(k / 100) / 8. - 1.])
        .collect();
    for moving in [hook, square(1.), square(4.)] {
        let options = Options::new();
        let region = free(&scene, &moving, None);
        let relations = scene.relation_many(&moving, &points, &all(), &options);
        let expected: Vec<_> = relations.unwrap().into_iter().map(location).collect();
        assert!(expected.contains(&Boundary) && expected.contains(&Outside));
        assert_eq!(region.locate(&points), Ok(expected));
        // All that is returned is free.
        let outward = Options::new().rounding(Rounding::Outward);
        let inner = scene.free_region(&moving, None, &all(), &outward).unwrap();
        let relations = scene
            .relation_many(&moving, &inner.vertices(), &all(), &options)
            .unwrap();
        assert!(!relations.contains(&Relation::Overlapping));
    }
}

#[test]
fn which_members() {
    let (mut scene, part) = gap();
    scene.set_layers(&[2, 3], &[0b01, 0b10]).unwrap();
    let wkt = |query: Query, window| {
        let region = scene.free_region(&part, window, &query, &Options::new());
        region.map(|region| (region.wkt(), region.segments().len()))
    };
    let with = |wkt: &str, segments| Ok((wkt.into(), segments));
    let without_left = "MULTIPOLYGON (((0 0, 3 0, 3 3, 6 3, 6 6, 0 6, 0 0)))";
    assert_eq!(wkt(all().ignore(&[2]), None), with(without_left, 0));
    assert_eq!(wkt(all().layers(0b10), None), with(without_left, 0));
    let container = "MULTIPOLYGON (((0 0, 6 0, 6 6, 0 6, 0 0)))";
    assert_eq!(wkt(all().ignore(&[3, 2, 7]), None), with(container, 0));
    assert_eq!(wkt(all().layers(0b100), None), with(container, 0));
    // Without the container too.
    let window = [-1., -1., 1., 1.];
    let all_of_it = "MULTIPOLYGON (((-1 -1, 1 -1, 1 1, -1 1, -1 -1)))";
    for query in [all().layers(0), all().ignore(&[1, 2])] {
        assert_eq!(wkt(query, Some(window)), with(all_of_it, 0));
        let message = "window: there is none, and no container";
        assert_fails(wkt(query, None), GCV_ERR_INVALID_ARGUMENT, message);
    }
}

#[test]
fn windows_that_are_refused() {
    let (scene, part) = gap();
    let ask = |window| scene.free_region(&part, Some(window), &all(), &Options::new());
    let (refused, inf) = (GCV_ERR_INVALID_ARGUMENT, f64::INFINITY);
    for (window, status, message) in [
        (
            [0., 0., f64::NAN, 1.],
            GCV_ERR_NOT_FINITE,
            "window: xmax is nan",
        ),
        (
            [0., -inf, 1., 1.],
            GCV_ERR_NOT_FINITE,
            "window: ymin is -inf",
        ),
        (
            [1., 0., 1., 1.],
            refused,
            "window: xmin is 1, not less than xmax, 1",
        ),
        (
            [0., 3., 1., 2.],
            refused,
            "window: ymin is 3, not less than ymax, 2",
        ),
    ] {
        assert_fails(ask(window), status, message);
    }
    let failed = Scene::new().free_region(&part, None, &all(), &Options::new());
    let message =
        "window: there is none, and no container for this query: the free set is unbounded";
    assert_fails(failed, refused, message);
}

#[test]
fn out_of_range() {
    let (mut scene, far) = (Scene::new(), 1.7e308);
    scene.set_container(Some(&square(far))).unwrap();
    let moving = polygon(&[[-far, 0.], [-far, 1.], [-0.5 * far, 0.]]);
    let failed = scene.free_region(&moving, None, &all(), &Options::new());
    let message = "the x coordinate of vertex 1 of the result";
    assert_fails(failed, GCV_ERR_RANGE, message);
}

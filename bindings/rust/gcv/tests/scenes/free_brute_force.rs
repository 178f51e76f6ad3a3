// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Free regions against relations, and best positions and ways out against free regions. All
//! coordinates are small integers.

use gcv::EdgeSource::{Corner, Translated, TranslatedCorner};
use gcv::{EdgeSource, Location, Options, PartKind, Polygon, Query, Region, Relation, Scene};
use proptest::prelude::*;

use crate::brute_force::{container_rings, rings, vectors, Ring};
use crate::{polygon, status};

fn rectangle([width, height]: [f64; 2]) -> Ring {
    vec![[0., 0.], [width, 0.], [width, height], [0., height]]
}

/// Rectangles, L and U between which there is often just the room that one needs, and others.
fn shapes() -> impl Strategy<Value = Ring> {
    let sizes = || vectors(2..6);
    let corner = |[x, y]: [f64; 2]| {
        let [in_x, in_y] = [x - 1., y - 1.];
        vec![
            [0., 0.],
            [x, 0.],
            [x, y],
            [in_x, y],
            [in_x, in_y],
            [0., in_y],
        ]
    };
    let slot = |[x, y]: [f64; 2]| {
        let inner = [[x + 1., y], [x + 1., 1.], [1., 1.], [1., y]];
        [
            vec![[0., 0.], [x + 2., 0.], [x + 2., y]],
            inner.to_vec(),
            vec![[0., y]],
        ]
        .concat()
    };
    prop_oneof![
        2 => rings(6),
        2 => vectors(1..5).prop_map(rectangle),
        1 => sizes().prop_map(corner),
        1 => sizes().prop_map(slot),
    ]
}

#[derive(Clone, Debug)]
struct Case {
    container: Option<Ring>,
    /// With positions and layers.
    members: Vec<(Ring, [f64; 2], u32)>,
    moving: Ring,
    window: [f64; 4],
    layers: u32,
    ignore: Vec<u64>,
}

fn cases() -> impl Strategy<Value = Case> {
    let members = prop::collection::vec((shapes(), vectors(-1..10), 1..4_u32), 0..8);
    let windows = (vectors(-6..16), vectors(1..24))
        .prop_map(|([x, y], [width, height])| [x, y, x + width, y + height]);
    let layers = prop_oneof![3 => Just(u32::MAX), 1 => 1..4_u32];
    let ignore = prop::collection::vec(2..9_u64, 0..2);
    let containers = prop_oneof![container_rings(), vectors(4..12).prop_map(rectangle)];
    let container = prop::option::weighted(0.7, containers);
    (container, members, shapes(), windows, layers, ignore).prop_map(
        |(container, members, moving, window, layers, ignore)| Case {
            container,
            members,
            moving,
            window,
            layers,
            ignore,
        },
    )
}

impl Case {
    fn scene(&self) -> Scene {
        let mut scene = Scene::new();
        if let Some(ring) = &self.container {
            scene.set_container(Some(&polygon(ring))).unwrap();
        }
        for (ring, position, layers) in &self.members {
            let id = scene.add(&polygon(ring), *position).unwrap();
            scene.set_layers(&[id], &[*layers]).unwrap();
        }
        scene
    }

    fn query(&self) -> Query<'_> {
        Query::new().layers(self.layers).ignore(&self.ignore)
    }

    /// The ring of a member or of the container, and its position.
    fn solid(&self, id: u64) -> (&Ring, [f64; 2]) {
        if id == Scene::CONTAINER {
            return (self.container.as_ref().unwrap(), [0., 0.]);
        }
        let (ring, position, _) = &self.members[id as usize - 2];
        (ring, *position)
    }
}

fn sum([x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> [f64; 2] {
    [x + dx, y + dy]
}

/// Whether such small coordinates are not rounded.
fn is_exact(point: &[f64; 2]) -> bool {
    point.iter().all(|c| (c * 64.).fract() == 0.)
}

/// Whether a point is inside a window, on its border, or outside.
fn location_in([x0, y0, x1, y1]: [f64; 4], [x, y]: [f64; 2]) -> Location {
    if x0 < x && x < x1 && y0 < y && y < y1 {
        Location::Inside
    } else if x0 <= x && x <= x1 && y0 <= y && y <= y1 {
        Location::Boundary
    } else {
        Location::Outside
    }
}

fn check_location(location: Location, relation: Relation, in_window: Location) {
    let of_relation = match relation {
        Relation::Apart => Location::Inside,
        Relation::Touching => Location::Boundary,
        Relation::Overlapping => Location::Outside,
    };
    match (in_window, relation) {
        (Location::Inside, _) => assert_eq!(location, of_relation),
        (Location::Outside, _) => assert_eq!(location, Location::Outside),
        (_, Relation::Apart) => assert_eq!(location, Location::Boundary),
        (_, Relation::Overlapping) => assert_eq!(location, Location::Outside),
        // What is free beside it may lie outside of the window alone.
        (_, Relation::Touching) => assert_ne!(location, Location::Inside),
    }
}

/// Every edge of a region whose vertices are exact: its two ends, its owner and its source.
fn edges(region: &Region) -> Vec<([[f64; 2]; 2], u64, Option<EdgeSource>)> {
    let (vertices, owners, sources) = (region.vertices(), region.owners(), region.sources());
    let mut edges = vec![];
    for part in region.parts() {
        let range = part.vertices;
        let count = match part.kind {
            PartKind::Outer { .. } | PartKind::Hole { .. } => range.len(),
            PartKind::Segment => 1,
            PartKind::Point => 0,
        };
        for k in 0..range.len() {
            let (from, to) = (range.start + k, range.start + (k + 1) % range.len());
            if k < count {
                edges.push(([vertices[from], vertices[to]], owners[from], sources[from]));
            } else {
                assert_eq!((owners[from], sources[from]), (0, None));
            }
        }
    }
    edges
}

/// Whether a point is on the line of an edge of a ring.
fn is_on_line(ring: &Ring, edge: usize, point: [f64; 2]) -> bool {
    let (a, b) = (ring[edge], ring[(edge + 1) % ring.len()]);
    (b[0] - a[0]) * (point[1] - a[1]) == (b[1] - a[1]) * (point[0] - a[0])
}

/// Whether a position of the moving polygon is on the superset edge that the source names.
fn is_made_by(case: &Case, owner: u64, source: EdgeSource, at: [f64; 2]) -> bool {
    let (ring, position) = case.solid(owner);
    let vertex_a = |k: usize| sum(ring[k], position);
    // Seen from the solid, and from the moving polygon.
    let (to_a, to_b) = (sum(at, position.map(|c| -c)), at.map(|c| -c));
    match source {
        Translated { edge_a, vertex_b } => {
            is_on_line(ring, edge_a, sum(case.moving[vertex_b], to_a))
        }
        Corner {
            vertex_a: k,
            edge_b,
        } => is_on_line(&case.moving, edge_b, sum(vertex_a(k), to_b)),
        // Both edges are on one line.
        TranslatedCorner { edge_a, edge_b } => {
            is_on_line(ring, edge_a, sum(case.moving[edge_b], to_a))
        }
    }
}

fn check_edges(case: &Case, scene: &Scene, moving: &Polygon, region: &Region, window: [f64; 4]) {
    if region.error_bound() != 0. || region.exact_vertices().len() != region.vertices().len() {
        return;
    }
    let touched = |at| {
        let near = scene.near(moving, at, 0., &case.query(), &Options::new());
        let near = near.unwrap();
        let overlaps = near
            .iter()
            .any(|pair| pair.relation() == Relation::Overlapping);
        assert!(!overlaps, "{at:?}");
        near.iter().map(|pair| pair.a()).collect::<Vec<_>>()
    };
    for ([from, to], owner, source) in edges(region) {
        let along = |t: f64| [0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis]));
        if owner == 0 {
            assert_eq!(source, None);
            assert_eq!(location_in(window, along(0.5)), Location::Boundary);
            continue;
        }
        assert!(is_made_by(case, owner, source.unwrap(), from));
        assert!(is_made_by(case, owner, source.unwrap(), to));
        // Where several members have made an edge, one of them is its owner.
        let parts = [0.5].into_iter().chain((0..65).map(|k| f64::from(k) / 64.));
        let mut places = parts.map(along);
        assert!(places.any(|at| touched(at).contains(&owner)));
    }
}

/// The distance of a point from a segment.
fn distance_to([a, b]: [[f64; 2]; 2], point: [f64; 2]) -> f64 {
    let ([dx, dy], [px, py]) = (
        [b[0] - a[0], b[1] - a[1]],
        [point[0] - a[0], point[1] - a[1]],
    );
    let squared = dx * dx + dy * dy;
    let along = if squared == 0. {
        0.
    } else {
        ((px * dx + py * dy) / squared).clamp(0., 1.)
    };
    (px - along * dx).hypot(py - along * dy)
}

/// How far a point outside of a region is from it.
fn distance_from(region: &Region, point: [f64; 2]) -> f64 {
    let rings = region.polygons().flatten();
    let sides = rings.flat_map(|ring| {
        let next = ring.clone().into_iter().cycle().skip(1);
        ring.into_iter()
            .zip(next)
            .map(|(a, b)| [a, b])
            .collect::<Vec<_>>()
    });
    let points = region.points().into_iter().map(|point| [point; 2]);
    sides
        .chain(region.segments())
        .chain(points)
        .map(|side| distance_to(side, point))
        .fold(f64::INFINITY, f64::min)
}

/// The vertices of rings, and of segments and points those that are not rounded.
fn shown_vertices(region: &Region) -> Vec<[f64; 2]> {
    let vertices = region.vertices();
    let of_part = |part: gcv::Part| {
        let is_fit = matches!(part.kind, PartKind::Segment | PartKind::Point);
        let vertices = vertices[part.vertices].iter().copied();
        vertices.filter(move |vertex| !is_fit || is_exact(vertex))
    };
    region.parts().into_iter().flat_map(of_part).collect()
}

fn grid() -> Vec<[f64; 2]> {
    let point = |k: i32| [f64::from(k % 35) - 8., f64::from(k / 35) - 8.];
    let whole = (0..35 * 35).map(point);
    whole
        .flat_map(|point| [point, point.map(|c| c + 0.5)])
        .collect()
}

proptest! {
    #[test]
    fn free_regions_are_what_relations_say(case in cases()) {
        let (scene, moving, query) = (case.scene(), polygon(&case.moving), case.query());
        let options = Options::new();
        let without_window = case.container.as_ref().map(|_| None);
        for window in without_window.into_iter().chain([Some(case.window)]) {
            let region = scene.free_region(&moving, window, &query, &options).unwrap();
            // None of such coordinates is too thin for doubles.
            assert!(region.error_bound() < 1e-12, "{}", region.error_bound());
            let threads = Options::new().threads(3);
            let again = scene.free_region(&moving, window, &query, &threads);
            assert!(again.unwrap() == region);

            let everything = [-1e9, -1e9, 1e9, 1e9];
            let window = window.unwrap_or(everything);
            let points = grid();
            let relations = scene.relation_many(&moving, &points, &query, &options).unwrap();
            let locations = region.locate(&points).unwrap();
            for k in 0..points.len() {
                check_location(locations[k], relations[k], location_in(window, points[k]));
            }
            check_edges(&case, &scene, &moving, &region, window);
        }
    }

    #[test]
    fn best_positions_are_furthest(case in cases(), direction in vectors(-3..4)) {
        let (scene, moving, query) = (case.scene(), polygon(&case.moving), case.query());
        let options = Options::new();
        let best = scene.best(&moving, direction, &query, &options);
        if case.container.is_none() || direction == [0., 0.] {
            assert_eq!(status(best), gcv::status::GCV_ERR_INVALID_ARGUMENT);
            return Ok(());
        }
        let region = scene.free_region(&moving, None, &query, &options).unwrap();
        let best = match best.unwrap() {
            Some(best) => best,
            None => {
                assert!(region.is_empty());
                return Ok(());
            }
        };
        let along = |[x, y]: [f64; 2]| x * direction[0] + y * direction[1];
        let furthest = |vertices: &[[f64; 2]]| {
            vertices.iter().copied().map(along).fold(f64::NEG_INFINITY, f64::max)
        };
        // Exact fits that no doubles show may be passed over.
        let (vertices, shown) = (region.vertices(), shown_vertices(&region));
        let limit = furthest(&vertices);
        let furthest = furthest(if shown.is_empty() { &vertices } else { &shown });
        assert!(along(best) > furthest - 1e-12, "{best:?}, {furthest}");
        assert!(along(best) < limit + 1e-12, "{best:?}, {limit}");
        if along(best) > furthest + 1e-12 {
            return Ok(());
        }
        let tied = vertices.into_iter().filter(|vertex| along(*vertex) > furthest - 1e-12);
        let tied: Vec<_> = tied.collect();
        if tied.iter().all(is_exact) {
            let expected = tied.into_iter().min_by(|p, q| p.partial_cmp(q).unwrap());
            assert_eq!(Some(best), expected);
        }
    }

    #[test]
    fn ways_out_lead_to_the_nearest_free_position(
        case in cases(), from in prop::collection::vec(vectors(-6..20), 8)
    ) {
        let (scene, moving, query) = (case.scene(), polygon(&case.moving), case.query());
        let options = Options::new();
        let window = case.container.is_none().then_some([-99., -99., 99., 99.]);
        let region = scene.free_region(&moving, window, &query, &options).unwrap();
        let found = scene.penetration_many(&moving, &from, &query, &options).unwrap();
        let relations = scene.relation_many(&moving, &from, &query, &options).unwrap();
        for (k, found) in found.iter().enumerate() {
            if relations[k] != Relation::Overlapping {
                assert_eq!((found.depth(), found.translation()), (0., [0., 0.]));
                assert_eq!((found.position(), found.relation()), (from[k], relations[k]));
                continue;
            }
            if region.is_empty() {
                assert_eq!((found.depth(), found.id()), (f64::INFINITY, 0));
                assert_eq!((found.position(), found.contact()), (from[k], None));
                continue;
            }
            let depth = distance_from(&region, from[k]);
            assert!((found.depth() - depth).abs() < 1e-12 * depth, "{found:?}, {depth}");
            let [x, y] = found.translation();
            assert!((x.hypot(y) - depth).abs() < 1e-12 * depth);
            let relation = scene.relation(&moving, found.position(), &query, &options);
            assert_eq!(relation, Ok(found.relation()));
            assert_eq!(found.contact().map(|contact| contact.id_a()), Some(found.id()));
            // What is rounded is near. What is not rounded touches.
            let is_exact = is_exact(&found.position());
            let limit = if is_exact { 0. } else { 1e-12 };
            let near = scene.near(&moving, found.position(), limit, &query, &options).unwrap();
            if is_exact {
                assert_eq!(found.id(), near[0].a());
                assert_eq!(found.relation(), Relation::Touching);
            } else {
                assert!(near.iter().any(|pair| pair.a() == found.id()), "{found:?}");
            }
        }
    }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Scenes against the functions of two polygons, member by member. All coordinates are small
//! integers, so members can be moved by `affine` without rounding.

use gcv::{cast, contacts, distance, relation};
use gcv::{Contact, ContactKind, ContactList, Options, Polygon, Query, Relation, Scene};
use gcv::{PairList, Separation};
use proptest::prelude::*;

use crate::name;

pub type Ring = Vec<[f64; 2]>;

/// Rings of polygons.
pub fn rings(size: i32) -> impl Strategy<Value = Ring> {
    prop::collection::vec([0..size, 0..size], 3..8).prop_filter_map("no polygon", |ring| {
        let ring: Ring = ring
            .into_iter()
            .map(|vertex| vertex.map(f64::from))
            .collect();
        Polygon::new(&ring).is_ok().then_some(ring)
    })
}

pub fn polygons() -> impl Strategy<Value = Polygon> {
    rings(6).prop_map(|ring| Polygon::new(&ring).unwrap())
}

/// Rings of containers, without collinear vertices: of edges that are merged, the number would be
/// that of the first along a ring that is a hole here.
pub fn container_rings() -> impl Strategy<Value = Ring> {
    rings(24).prop_filter("collinear", |ring| {
        Polygon::new(ring).unwrap().vertices().len() == ring.len()
    })
}

pub fn vectors(range: std::ops::Range<i32>) -> impl Strategy<Value = [f64; 2]> {
    [range.clone(), range].prop_map(|vector| vector.map(f64::from))
}

/// A change of a scene. Members are named by their number among those that are there.
#[derive(Clone, Debug)]
enum Change {
    Container(Option<Ring>),
    Add(Polygon, [f64; 2]),
    Move(usize, [f64; 2]),
    Reshape(usize, Polygon),
    Layers(usize, u32),
    Remove(usize),
    /// Goes on with a copy.
    Copy,
    /// Goes on with what an earlier copy was made of, or with another copy.
    Back(usize),
}

fn changes() -> impl Strategy<Value = Change> {
    let positions = || vectors(-3..16);
    prop_oneof![
        1 => prop::option::of(container_rings()).prop_map(Change::Container),
        4 => (polygons(), positions()).prop_map(|(polygon, at)| Change::Add(polygon, at)),
        3 => (any::<usize>(), positions()).prop_map(|(member, to)| Change::Move(member, to)),
        1 => (any::<usize>(), polygons()).prop_map(|(member, to)| Change::Reshape(member, to)),
        1 => (any::<usize>(), 0..4_u32).prop_map(|(member, to)| Change::Layers(member, to)),
        1 => any::<usize>().prop_map(Change::Remove),
        1 => Just(Change::Copy),
        1 => any::<usize>().prop_map(Change::Back),
    ]
}

#[derive(Clone)]
struct Member {
    id: u64,
    polygon: Polygon,
    position: [f64; 2],
    layers: u32,
}

/// What a scene is about, as a list.
#[derive(Clone, Default)]
struct Model {
    container: Option<Ring>,
    members: Vec<Member>,
    added: u64,
}

impl Model {
    fn change(&mut self, scene: &mut Scene, change: Change, others: &mut Vec<(Scene, Self)>) {
        let chosen = |number: usize, members: &[Member]| number % members.len().max(1);
        match change {
            Change::Container(ring) => {
                let polygon = ring.as_ref().map(|ring| Polygon::new(ring).unwrap());
                scene.set_container(polygon.as_ref()).unwrap();
                self.container = ring;
            }
            Change::Add(polygon, position) => {
                let id = scene.add(&polygon, position).unwrap();
                self.added += 1;
                assert_eq!(id, self.added + 1);
                let layers = u32::MAX;
                self.members.push(Member {
                    id,
                    polygon,
                    position,
                    layers,
                });
            }
            Change::Copy => {
                let before = (std::mem::replace(scene, scene.clone()), self.clone());
                others.push(before);
            }
            Change::Back(number) => {
                let number = number % others.len().max(1);
                if let Some(other) = others.get_mut(number) {
                    std::mem::swap(scene, &mut other.0);
                    std::mem::swap(self, &mut other.1);
                }
            }
            Change::Move(number, position) => {
                let number = chosen(number, &self.members);
                if let Some(member) = self.members.get_mut(number) {
                    scene.set_positions(&[member.id], &[position]).unwrap();
                    member.position = position;
                }
            }
            Change::Reshape(number, polygon) => {
                let number = chosen(number, &self.members);
                if let Some(member) = self.members.get_mut(number) {
                    scene.set_polygons(&[member.id], &[&polygon]).unwrap();
                    member.polygon = polygon;
                }
            }
            Change::Layers(number, layers) => {
                let number = chosen(number, &self.members);
                if let Some(member) = self.members.get_mut(number) {
                    scene.set_layers(&[member.id], &[layers]).unwrap();
                    member.layers = layers;
                }
            }
            Change::Remove(number) => {
                let number = chosen(number, &self.members);
                if number < self.members.len() {
                    scene.remove(&[self.members.remove(number).id]).unwrap();
                }
            }
        }
    }

    /// The container and the members that a question is about, where they are. The container is
    /// what is solid of it, with edges and vertices numbered from 4 on.
    fn bodies(&self, layers: u32, ignore: &[u64]) -> Vec<Body> {
        let container = self.container.iter().map(|ring| {
            let corners = [[-999., -999.], [999., -999.], [999., 999.], [-999., 999.]];
            let polygon = Polygon::from_rings([&corners[..], ring]).unwrap();
            Body {
                id: Scene::CONTAINER,
                polygon,
            }
        });
        let members = self
            .members
            .iter()
            .filter(|member| member.layers & layers != 0);
        let members = members.map(|member| {
            let [x, y] = member.position;
            let polygon = member.polygon.affine([1., 0., x, 0., 1., y]).unwrap();
            Body {
                id: member.id,
                polygon,
            }
        });
        let asked = |body: &Body| layers != 0 && !ignore.contains(&body.id);
        container.chain(members).filter(asked).collect()
    }
}

struct Body {
    id: u64,
    polygon: Polygon,
}

/// A feature's number, of those of the container as it was passed.
fn number(id: u64, number: usize) -> usize {
    number - if id == Scene::CONTAINER { 4 } else { 0 }
}

/// The facts of a contact: of a scene, and of two bodies.
type Facts = (u64, u64, ContactKind, f64, [[f64; 2]; 3]);

fn facts(contact: &Contact) -> Facts {
    let (id_a, id_b, kind) = name(contact);
    let points = [contact.normal(), contact.on_a(), contact.on_b()];
    (id_a, id_b, kind, contact.gap(), points)
}

fn expected_facts(contact: &Contact, id_a: u64, id_b: u64) -> Facts {
    let kind = match contact.kind() {
        ContactKind::EdgeVertex { edge_a, vertex_b } => ContactKind::EdgeVertex {
            edge_a: number(id_a, edge_a),
            vertex_b,
        },
        ContactKind::VertexEdge { vertex_a, edge_b } => ContactKind::VertexEdge {
            vertex_a: number(id_a, vertex_a),
            edge_b,
        },
        ContactKind::VertexVertex { vertex_a, vertex_b } => ContactKind::VertexVertex {
            vertex_a: number(id_a, vertex_a),
            vertex_b,
        },
    };
    let (_, _, _, gap, points) = facts(contact);
    (id_a, id_b, kind, gap, points)
}

fn relation_to(bodies: &[Body], moving: &Polygon, position: [f64; 2]) -> Relation {
    let relations = bodies
        .iter()
        .map(|body| relation(&body.polygon, moving, position, &Options::new()).unwrap());
    relations
        .min_by_key(|relation| *relation as i8)
        .unwrap_or(Relation::Apart)
}

fn distances(bodies: &[Body], moving: &Polygon, position: [f64; 2]) -> Vec<Separation> {
    let of = |body: &Body| distance(&body.polygon, moving, position, &Options::new());
    bodies.iter().map(|body| of(body).unwrap()).collect()
}

/// The number of the first one of the smallest.
fn first_smallest(values: impl Iterator<Item = f64>) -> Option<usize> {
    let smaller = |best: Option<(usize, f64)>, (k, value): (usize, f64)| match best {
        Some((_, smallest)) if smallest <= value => best,
        _ => Some((k, value)),
    };
    values.enumerate().fold(None, smaller).map(|(k, _)| k)
}

/// Questions about a polygon that is no member.
fn check_moving(
    scene: &Scene,
    query: &Query,
    bodies: &[Body],
    moving: &Polygon,
    at: [f64; 2],
    motion: [f64; 2],
) {
    let options = Options::new();
    let expected_relation = relation_to(bodies, moving, at);
    assert_eq!(
        scene.relation(moving, at, query, &options),
        Ok(expected_relation)
    );

    let found = scene.distance(moving, at, query, &options).unwrap();
    assert_eq!(found.relation(), expected_relation);
    let separations = distances(bodies, moving, at);
    if let Some(k) = first_smallest(separations.iter().map(Separation::distance)) {
        let (expected, id) = (separations[k], bodies[k].id);
        assert_eq!((found.id(), found.distance()), (id, expected.distance()));
        let nearest = expected
            .nearest()
            .map(|contact| expected_facts(&contact, id, 0));
        assert_eq!(found.nearest().map(|contact| facts(&contact)), nearest);
    } else {
        assert_eq!((found.id(), found.distance()), (0, f64::INFINITY));
    }

    let found = scene.cast(moving, at, motion, query, &options).unwrap();
    let impact = |body: &Body| cast(&body.polygon, moving, at, motion, &options).unwrap();
    let impacts: Vec<_> = bodies.iter().map(|body| (body.id, impact(body))).collect();
    let hits: Vec<_> = impacts.iter().filter(|(_, impact)| impact.hit()).collect();
    if let Some(k) = first_smallest(hits.iter().map(|(_, impact)| impact.time())) {
        let (id, expected) = hits[k];
        assert!(found.hit());
        assert_eq!((found.id(), found.time()), (*id, expected.time()));
        let contact = expected
            .contact()
            .map(|contact| expected_facts(&contact, *id, 0));
        assert_eq!(found.contact().map(|contact| facts(&contact)), contact);
    } else {
        assert_eq!((found.hit(), found.id(), found.time()), (false, 0, 1.));
        assert_eq!(found.contact(), None);
    }
    for axis in 0..2 {
        let end = at[axis] + found.time() * motion[axis];
        assert!((found.position()[axis] - end).abs() < 1e-13, "{found:?}");
    }
    assert_eq!(
        found.relation(),
        relation_to(bodies, moving, found.position())
    );

    for limit in [0., 1., 2.5] {
        let found = scene.near(moving, at, limit, query, &options).unwrap();
        let found: Vec<_> = found
            .iter()
            .map(|pair| (pair.a(), pair.b(), pair.relation()))
            .collect();
        let near = bodies.iter().zip(&separations);
        let expected: Vec<_> = near
            .filter(|(_, separation)| separation.distance() <= limit)
            .map(|(body, separation)| (body.id, 0, separation.relation()))
            .collect();
        assert_eq!(found, expected, "distance {limit}");
    }
}

/// The lists with these earlier ones.
fn check_lists(
    scene: &Scene,
    query: &Query,
    bodies: &[Body],
    previous: Option<&(PairList, ContactList)>,
    [limit, slope]: [f64; 2],
) -> (PairList, ContactList) {
    let options = Options::new();
    let (mut expected_pairs, mut expected) = (vec![], vec![]);
    for (k, a) in bodies.iter().enumerate() {
        for b in &bodies[k + 1..] {
            let separation = distance(&a.polygon, &b.polygon, [0., 0.], &options).unwrap();
            if separation.distance() <= limit {
                expected_pairs.push((a.id, b.id, separation.relation()));
            }
            let list = contacts(&a.polygon, &b.polygon, [0., 0.], limit, slope, &options).unwrap();
            expected.extend(
                list.iter()
                    .map(|contact| expected_facts(contact, a.id, b.id)),
            );
        }
    }
    // Those of a pair are in order.
    expected.sort_by(|a, b| a.3.abs().total_cmp(&b.3.abs()));

    let (previous_pairs, previous_contacts) = match previous {
        Some((pairs, contacts)) => (Some(pairs), Some(contacts)),
        None => (None, None),
    };
    let pairs = scene.pairs(previous_pairs, limit, query, &options).unwrap();
    assert_eq!(crate::pairs(&pairs), expected_pairs);
    let contacts = scene
        .contacts(previous_contacts, limit, slope, query, &options)
        .unwrap();
    let found: Vec<_> = contacts.iter().map(facts).collect();
    assert_eq!(found, expected);
    for (contact, index) in contacts.iter().zip(contacts.previous()) {
        let mut earlier = previous_contacts.into_iter().flat_map(|list| list.iter());
        assert_eq!(
            *index,
            earlier.position(|earlier| name(earlier) == name(contact))
        );
    }
    (pairs, contacts)
}

proptest! {
    /// Lists are asked for with an earlier one, of the same question or of another one.
    #[test]
    fn as_member_by_member(
        changes in prop::collection::vec(changes(), 1..12), moving in polygons(),
        at in prop::collection::vec([vectors(-3..16), vectors(-8..8)], 12),
        earlier in prop::collection::vec(any::<usize>(), 12),
        widened in prop::collection::vec(prop::bool::weighted(0.2), 12),
        layers in prop_oneof![3 => Just(u32::MAX), 1 => 0..4_u32],
        ignore in prop::collection::vec(0..9_u64, 0..3),
        limits in [0..3, 0..2]
    ) {
        let (mut scene, mut model) = (Scene::new(), Model::default());
        let (mut others, mut lists) = (vec![], vec![]);
        let query = Query::new().layers(layers).ignore(&ignore);
        for (step, change) in changes.into_iter().enumerate() {
            model.change(&mut scene, change, &mut others);
            let ids: Vec<_> = model.members.iter().map(|member| member.id).collect();
            assert_eq!(scene.ids(), ids);
            let positions = model.members.iter().map(|member| member.position).collect();
            assert_eq!(scene.positions(&ids), Ok(positions));

            let bodies = model.bodies(layers, &ignore);
            let [position, motion] = at[step];
            check_moving(&scene, &query, &bodies, &moving, position, motion);
            let limits = limits.map(|limit| f64::from(limit + i32::from(widened[step])));
            let previous = lists.get(earlier[step] % (lists.len() + 1));
            let found = check_lists(&scene, &query, &bodies, previous, limits);
            lists.push(found);
        }
    }
}

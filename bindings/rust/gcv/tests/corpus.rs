// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! The corpus of the source tree, tests/corpus, which the tests of all languages read.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use gcv::{cast, contacts, distance, penetration, relation, Contact, ContactKind};
use gcv::{entrance_block, minkowski_sum, no_fit_polygon};
use gcv::{entrance_region, inner_fit_region, minkowski_sum_region, no_fit_region};
use gcv::{Error, Options, OuterFace, PartKind, Polygon, Region};
use gcv::{Escape, Impact, Pair, Query, Scene, Separation};

/// The text of the corpus; none in a package, where cargo leaves its Cargo.toml.orig.
fn corpus() -> Option<String> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = package.join("../../../tests/corpus/cases.txt");
    if package.join("Cargo.toml.orig").exists() && !file.exists() {
        eprintln!("The corpus is in the source tree of libgcv, not in this package.");
        return None;
    }
    Some(fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display())))
}

/// The status, and the exact ring where there is one, as the corpus has them.
fn outcome(face: Result<OuterFace, Error>) -> String {
    match face {
        Ok(face) => format!("GCV_OK {}", face.exact_vertices().join(", ")),
        Err(error) => error.status_name(),
    }
}

/// Likewise for a region.
fn region_outcome(region: Result<Region, Error>) -> String {
    region.map_or_else(
        |error| error.status_name(),
        |region| format!("GCV_OK {}", region_text(&region)),
    )
}

fn region_text(region: &Region) -> String {
    let vertices = region.exact_vertices();
    let part = |part: gcv::Part| {
        let word = match part.kind {
            PartKind::Outer { .. } => "outer",
            PartKind::Hole { .. } => "hole",
            PartKind::Segment => "segment",
            PartKind::Point => "point",
        };
        format!("{word} {}", vertices[part.vertices].join(", "))
    };
    list(region.exact_parts().into_iter().map(part))
}

/// The texts with "; " between them.
fn list(texts: impl Iterator<Item = String>) -> String {
    let texts: Vec<_> = texts.collect();
    if texts.is_empty() {
        return "empty".into();
    }
    texts.join("; ")
}

fn word(relation: gcv::Relation) -> &'static str {
    match relation {
        gcv::Relation::Apart => "apart",
        gcv::Relation::Touching => "touching",
        gcv::Relation::Overlapping => "overlapping",
    }
}

fn contact(contact: Option<Contact>) -> String {
    let contact = match contact {
        Some(contact) => contact,
        None => return "none".into(),
    };
    let (name, a, b) = match contact.kind() {
        ContactKind::EdgeVertex { edge_a, vertex_b } => ("edge_vertex", edge_a, vertex_b),
        ContactKind::VertexEdge { vertex_a, edge_b } => ("vertex_edge", vertex_a, edge_b),
        ContactKind::VertexVertex { vertex_a, vertex_b } => ("vertex_vertex", vertex_a, vertex_b),
    };
    let ([x, y], [z, w]) = (contact.on_a(), contact.on_b());
    format!("{name} {a} {b} {} {x} {y} {z} {w}", contact.gap())
}

/// The position, unless the exact one is no pair of doubles.
fn place(relation: gcv::Relation, [x, y]: [f64; 2], line: &str) -> String {
    if line.contains(" inexact") {
        return "inexact".into();
    }
    format!("{} {x} {y}", word(relation))
}

/// With the id before the contact, as for scenes, or "".
fn separation_text(separation: &Separation, id: &str) -> String {
    let nearest = contact(separation.nearest());
    let relation = word(separation.relation());
    format!("{relation} {} {id}{nearest}", separation.distance())
}

fn escape_text(escape: &Escape, rest: &str, id: &str) -> String {
    let [x, y] = escape.translation();
    let place = place(escape.relation(), escape.position(), rest);
    let contact = contact(escape.contact());
    format!("{} {x} {y} {place} {id}{contact}", escape.depth())
}

fn impact_text(impact: &Impact, rest: &str, id: &str) -> String {
    let hit = if impact.hit() { "hit" } else { "miss" };
    let place = place(impact.relation(), impact.position(), rest);
    let contact = contact(impact.contact());
    format!("{hit} {} {place} {id}{contact}", impact.time())
}

/// What the question asks for.
fn answer(a: &Polygon, b: &Polygon, key: &str, rest: &str) -> Result<String, Error> {
    let options = Options::new();
    let (from, rest) = point(rest);
    Ok(match key {
        "relation" => word(relation(a, b, from, &options)?).into(),
        "distance" => separation_text(&distance(a, b, from, &options)?, ""),
        "penetration" => escape_text(&penetration(a, b, from, &options)?, rest, ""),
        "contacts" => {
            let ([most, slope], _) = point(rest);
            let found = contacts(a, b, from, most, slope, &options)?;
            list(found.iter().map(|&found| contact(Some(found))))
        }
        _ => impact_text(&cast(a, b, from, point(rest).0, &options)?, rest, ""),
    })
}

fn pair_text(pair: &Pair) -> String {
    format!("{} {} {}", pair.a(), pair.b(), word(pair.relation()))
}

/// What the question about the scene asks for.
fn scene_answer(scene: &Scene, b: &Polygon, key: &str, rest: &str) -> Result<String, Error> {
    let (query, options) = (Query::new(), Options::new());
    let words = rest.split(' ').map_while(|word| word.parse().ok());
    let numbers: Vec<f64> = words.collect();
    Ok(match (key, &numbers[..]) {
        ("scene_relation", &[x, y]) => word(scene.relation(b, [x, y], &query, &options)?).into(),
        ("scene_distance", &[x, y]) => {
            let separation = scene.distance(b, [x, y], &query, &options)?;
            separation_text(&separation, &format!("{} ", separation.id()))
        }
        ("scene_cast", &[x, y, dx, dy]) => {
            let impact = scene.cast(b, [x, y], [dx, dy], &query, &options)?;
            impact_text(&impact, rest, &format!("{} ", impact.id()))
        }
        ("scene_penetration", &[x, y]) => {
            let escape = scene.penetration(b, [x, y], &query, &options)?;
            escape_text(&escape, rest, &format!("{} ", escape.id()))
        }
        ("scene_best", &[dx, dy]) => match scene.best(b, [dx, dy], &query, &options)? {
            None => "none".into(),
            Some(_) if rest.ends_with(" inexact") => "inexact".into(),
            Some([x, y]) => format!("{x} {y}"),
        },
        ("scene_free_region", []) => region_text(&scene.free_region(b, None, &query, &options)?),
        ("scene_window_region", &[x0, y0, x1, y1]) => {
            let window = Some([x0, y0, x1, y1]);
            region_text(&scene.free_region(b, window, &query, &options)?)
        }
        ("scene_near", &[x, y, most]) => {
            let pairs = scene.near(b, [x, y], most, &query, &options)?;
            list(pairs.iter().map(pair_text))
        }
        ("scene_pairs", &[most]) => {
            let pairs = scene.pairs(None, most, &query, &options)?;
            list(pairs.iter().map(pair_text))
        }
        ("scene_contacts", &[most, slope]) => {
            let found = scene.contacts(None, most, slope, &query, &options)?;
            let text = |found: &Contact| {
                let ids = format!("{} {}", found.id_a(), found.id_b());
                format!("{ids} {}", contact(Some(*found)))
            };
            list(found.iter().map(text))
        }
        _ => panic!("what is {key}?"),
    })
}

/// Are the words the same? A number may be written in another way.
fn are_same(found: &str, expected: &str) -> bool {
    let same_word = |(p, q): (&str, &str)| {
        p == q || matches!((p.parse::<f64>(), q.parse::<f64>()), (Ok(x), Ok(y)) if x == y)
    };
    let (found, expected) = [found, expected].map(|text| text.replace(';', " ;")).into();
    found.split(' ').count() == expected.split(' ').count()
        && found.split(' ').zip(expected.split(' ')).all(same_word)
}

/// "X Y REST" as the point and the rest.
fn point(text: &str) -> ([f64; 2], &str) {
    let mut words = text.splitn(3, ' ');
    let mut next = || words.next().unwrap();
    let point = [next(), next()].map(|word| word.parse().unwrap());
    (point, next())
}

#[test]
fn every_case() {
    if let Some(corpus) = corpus() {
        check(&corpus);
    }
}

fn assert_answer(name: &str, key: &str, rest: &str, found: Result<String, Error>) {
    let found = found.map_or_else(|error| error.status_name(), |text| format!("GCV_OK {text}"));
    let expected = &rest[rest.find("GCV_").unwrap()..];
    assert!(
        are_same(&found, expected),
        "{name}: {key}: {found}, not {expected}"
    );
}

fn check(corpus: &str) {
    let options = Options::new();
    let (mut name, mut operands, mut scene) = ("", BTreeMap::new(), Scene::new());
    let mut seen = BTreeMap::<_, u32>::new();
    for line in corpus
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
    {
        let (key, rest) = line.split_once(' ').unwrap();
        *seen.entry(key).or_default() += 1;
        let (found, expected) = match key {
            "case" => {
                name = rest;
                scene = Scene::new();
                continue;
            }
            "a" | "b" => {
                operands.insert(key, Polygon::from_wkt(rest).unwrap());
                continue;
            }
            "container" => {
                let container = Polygon::from_wkt(rest).unwrap();
                scene.set_container(Some(&container)).unwrap();
                continue;
            }
            "member" => {
                let (position, wkt) = point(rest);
                scene
                    .add(&Polygon::from_wkt(wkt).unwrap(), position)
                    .unwrap();
                continue;
            }
            "refuse" => {
                let (status, wkt) = rest.split_once(' ').unwrap();
                let error = Polygon::from_wkt(wkt).unwrap_err();
                (error.status_name(), status)
            }
            "sum" => (
                outcome(minkowski_sum(&operands["a"], &operands["b"], &options)),
                rest,
            ),
            "no_fit" | "entrance" => {
                let (point, expected) = point(rest);
                let compute = if key == "no_fit" {
                    no_fit_polygon
                } else {
                    entrance_block
                };
                let face = compute(&operands["a"], &operands["b"], point, &options);
                (outcome(face), expected)
            }
            "sum_region" => {
                let region = minkowski_sum_region(&operands["a"], &operands["b"], &options);
                (region_outcome(region), rest)
            }
            "no_fit_region" | "entrance_region" | "inner_fit_region" => {
                let (point, expected) = point(rest);
                let compute = match key {
                    "no_fit_region" => no_fit_region,
                    "entrance_region" => entrance_region,
                    _ => inner_fit_region,
                };
                let region = compute(&operands["a"], &operands["b"], point, &options);
                (region_outcome(region), expected)
            }
            "relation" | "distance" | "cast" | "penetration" | "contacts" => {
                let found = answer(&operands["a"], &operands["b"], key, rest);
                assert_answer(name, key, rest, found);
                continue;
            }
            _ if key.starts_with("scene_") => {
                let found = scene_answer(&scene, &operands["b"], key, rest);
                assert_answer(name, key, rest, found);
                continue;
            }
            _ => panic!("{name}: what is {key}?"),
        };
        assert_eq!(found, expected, "{name}: {key}");
    }
    let keys = ["sum", "no_fit", "entrance", "refuse"];
    let region_keys = [
        "sum_region",
        "no_fit_region",
        "entrance_region",
        "inner_fit_region",
    ];
    let questions = ["relation", "distance", "cast", "penetration", "contacts"];
    let scene_questions = [
        "scene_relation",
        "scene_distance",
        "scene_cast",
        "scene_penetration",
        "scene_best",
        "scene_free_region",
        "scene_window_region",
        "scene_near",
        "scene_pairs",
        "scene_contacts",
    ];
    let keys = keys.iter().chain(&region_keys).chain(&questions);
    assert!(
        keys.chain(&scene_questions)
            .all(|key| seen.contains_key(key)),
        "{seen:?}"
    );
}

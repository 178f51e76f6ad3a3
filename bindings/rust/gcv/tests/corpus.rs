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
    let region = match region {
        Ok(region) => region,
        Err(error) => return error.status_name(),
    };
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
    let parts: Vec<_> = region.exact_parts().into_iter().map(part).collect();
    if parts.is_empty() {
        return "GCV_OK empty".into();
    }
    format!("GCV_OK {}", parts.join("; "))
}

fn word(relation: gcv::Relation) -> &'static str {
    match relation {
        gcv::Relation::Apart => "apart",
        gcv::Relation::Touching => "touching",
        gcv::Relation::Overlapping => "overlapping",
    }
}

fn contact(contact: Option<Contact>) -> String {
    let Some(contact) = contact else {
        return "none".into();
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

/// What the question asks for.
fn answer(a: &Polygon, b: &Polygon, key: &str, rest: &str) -> Result<String, Error> {
    let options = Options::new();
    let (from, rest) = point(rest);
    Ok(match key {
        "relation" => format!("GCV_OK {}", word(relation(a, b, from, &options)?)),
        "distance" => {
            let separation = distance(a, b, from, &options)?;
            let relation = word(separation.relation());
            let nearest = contact(separation.nearest());
            format!("GCV_OK {relation} {} {nearest}", separation.distance())
        }
        "penetration" => {
            let escape = penetration(a, b, from, &options)?;
            let [x, y] = escape.translation();
            let place = place(escape.relation(), escape.position(), rest);
            let contact = contact(escape.contact());
            format!("GCV_OK {} {x} {y} {place} {contact}", escape.depth())
        }
        "contacts" => {
            let ([most, slope], _) = point(rest);
            let list = contacts(a, b, from, most, slope, &options)?;
            let texts: Vec<_> = list.iter().map(|&found| contact(Some(found))).collect();
            if texts.is_empty() {
                return Ok("GCV_OK empty".into());
            }
            format!("GCV_OK {}", texts.join("; "))
        }
        _ => {
            let impact = cast(a, b, from, point(rest).0, &options)?;
            let hit = if impact.hit() { "hit" } else { "miss" };
            let place = place(impact.relation(), impact.position(), rest);
            let contact = contact(impact.contact());
            format!("GCV_OK {hit} {} {place} {contact}", impact.time())
        }
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

fn check(corpus: &str) {
    let options = Options::new();
    let (mut name, mut operands) = ("", BTreeMap::new());
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
                continue;
            }
            "a" | "b" => {
                operands.insert(key, Polygon::from_wkt(rest).unwrap());
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
                let found = answer(&operands["a"], &operands["b"], key, rest)
                    .unwrap_or_else(|error| error.status_name());
                let expected = &rest[rest.find("GCV_").unwrap()..];
                assert!(
                    are_same(&found, expected),
                    "{name}: {key}: {found}, not {expected}"
                );
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
    let mut keys = keys.iter().chain(&region_keys).chain(&questions);
    assert!(keys.all(|key| seen.contains_key(key)), "{seen:?}");
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! A robot that moves along a path, without turning, among obstacles: says which part of
//! each leg of the path is free, and draws it.
//!
//! ```sh
//! cargo run --example motion_planning --features num-rational -- picture.svg
//! ```
//!
//! The robot hits an obstacle where its reference point is inside their configuration-space
//! obstacle, the sum of the obstacle and of the robot reflected in that point. All is decided
//! in fractions: where there is exactly enough room, the robot may pass.

use std::error::Error;
use std::{env, fs};

use gcv::{minkowski_sum_many, Options, Polygon};
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

type Point = [BigRational; 2];

const SIZE: [f64; 2] = [44., 24.];

/// Its reference point is the origin.
#[rustfmt::skip]
const ROBOT: [[f64; 2]; 6] = [[-2., -1.], [2., -1.], [2., 0.], [0., 0.], [-1., 2.], [-2., 2.]];

/// Between the first two there is just the room that the robot needs.
const OBSTACLES: [&str; 4] = [
    "POLYGON ((14 0, 20 0, 20 8, 16 8))",
    "POLYGON ((11 24, 11 17, 14 20, 16 19, 16 11, 20 11, 20 24))",
    "POLYGON ((26 4, 37 10, 34 14, 31 10, 30 15, 26 13))",
    "POLYGON ((2 3, 9 1, 8 5, 5 4))",
];

#[rustfmt::skip]
const PATH: [[f64; 2]; 8] = [
    [3., 21.], [8., 9.], [23., 9.], [22., 3.], [34., 3.], [40., 14.], [29., 20.], [23., 9.],
];

/// A part of a leg, from one fraction of it to another, between which nothing changes.
struct Piece {
    start: BigRational,
    end: BigRational,
    free: bool,
}

fn exact([x, y]: [f64; 2]) -> Point {
    let exact = |c| BigRational::from_float(c).expect("coordinates are finite");
    [exact(x), exact(y)]
}

/// The point of a leg at a fraction of it.
fn at([a, b]: &[Point; 2], t: &BigRational) -> Point {
    [0, 1].map(|axis| &a[axis] + (&b[axis] - &a[axis]) * t)
}

fn edges(ring: &[Point]) -> impl Iterator<Item = (&Point, &Point)> {
    ring.iter().zip(ring.iter().cycle().skip(1))
}

/// Above 0 where the point is to the left of the line from a to b, 0 where it is on it.
fn side((a, b): (&Point, &Point), point: &Point) -> BigRational {
    (&b[0] - &a[0]) * (&point[1] - &a[1]) - (&b[1] - &a[1]) * (&point[0] - &a[0])
}

fn is_on((a, b): (&Point, &Point), point: &Point) -> bool {
    let between =
        |axis: usize| !((&point[axis] - &a[axis]) * (&point[axis] - &b[axis])).is_positive();
    between(0) && between(1) && side((a, b), point).is_zero()
}

/// Whether the point is inside the ring and not on it: by the edges to the right of it.
fn is_strictly_inside(ring: &[Point], point: &Point) -> bool {
    let is_right = |&(a, b): &(&Point, &Point)| {
        let (from_below, to_below) = (a[1] <= point[1], b[1] <= point[1]);
        from_below != to_below && from_below == side((a, b), point).is_positive()
    };
    edges(ring).filter(is_right).count() % 2 == 1 && !edges(ring).any(|edge| is_on(edge, point))
}

/// Cuts a leg wherever it meets the line of an edge, and looks at the middle of each piece.
fn pieces(leg: &[Point; 2], obstacles: &[Vec<Point>]) -> Vec<Piece> {
    let mut cuts = vec![BigRational::zero(), BigRational::one()];
    for edge in obstacles.iter().flat_map(|ring| edges(ring)) {
        let [from, to] = [0, 1].map(|end| side(edge, &leg[end]));
        if (&from * &to).is_negative() {
            cuts.push(&from / (&from - &to));
        }
    }
    cuts.sort();
    cuts.dedup();
    let piece = |ends: &[BigRational]| {
        let middle = at(
            leg,
            &((&ends[0] + &ends[1]) / BigRational::from_integer(2.into())),
        );
        Piece {
            start: ends[0].clone(),
            end: ends[1].clone(),
            free: !obstacles
                .iter()
                .any(|ring| is_strictly_inside(ring, &middle)),
        }
    };
    cuts.windows(2).map(piece).collect()
}

fn svg_path(class: &str, points: &[[f64; 2]]) -> String {
    let words: Vec<_> = points.iter().map(|[x, y]| format!("{x} {y}")).collect();
    format!("<path class=\"{class}\" d=\"M{}Z\"/>\n", words.join("L"))
}

fn svg(paths: &str) -> String {
    let [width, height] = SIZE;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"880\" viewBox=\"0 0 {width} {height}\">
<style>
  path {{ stroke-width: 0.12; stroke-linejoin: round }}
  .grown {{ fill: #e0561f; fill-opacity: 0.15; stroke: #e0561f }}
  .obstacle {{ fill: #5b6675 }}
  .robot {{ fill: #1c6dd0; fill-opacity: 0.3 }}
  .free {{ stroke: #0b9a6d; stroke-width: 0.3 }}
  .blocked {{ stroke: #c2185b; stroke-width: 0.3 }}
</style>
<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>
<g transform=\"matrix(1 0 0 -1 0 {height})\">
{paths}</g>
</svg>
"
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    let file = env::args().nth(1);
    let file = file.as_deref().unwrap_or("motion_planning.svg");

    let reflected = -Polygon::new(&ROBOT)?;
    let obstacles: Vec<_> = OBSTACLES
        .iter()
        .map(|wkt| Polygon::from_wkt(wkt))
        .collect::<Result<_, _>>()?;
    let pairs = obstacles.iter().map(|obstacle| (obstacle, &reflected));
    let grown: Vec<_> =
        minkowski_sum_many(pairs, &Options::new().threads(0)).collect::<Result<_, _>>()?;
    let rings: Vec<_> = grown.iter().map(|face| face.exact_rationals()).collect();

    let mut paths = String::new();
    for (obstacle, face) in obstacles.iter().zip(&grown) {
        paths += &svg_path("grown", &face.vertices());
        paths += &svg_path("obstacle", &obstacle.vertices());
    }
    for [x, y] in PATH {
        paths += &svg_path("robot", &ROBOT.map(|[dx, dy]| [x + dx, y + dy]));
    }
    for ends in PATH.windows(2) {
        let leg = [exact(ends[0]), exact(ends[1])];
        let mut free = BigRational::zero();
        for piece in pieces(&leg, &rings) {
            let line = [&piece.start, &piece.end]
                .map(|t| at(&leg, t).map(|c| c.to_f64().expect("coordinates are finite")));
            paths += &svg_path(if piece.free { "free" } else { "blocked" }, &line);
            if piece.free {
                free += piece.end - piece.start;
            }
        }
        println!("{:?} to {:?}: {free} of the way is free", ends[0], ends[1]);
    }
    fs::write(file, svg(&paths))?;
    println!("picture: {file}");
    Ok(())
}

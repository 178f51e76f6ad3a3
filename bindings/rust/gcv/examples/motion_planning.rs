// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! A robot that moves along a path, without turning, on a floor with obstacles: says which part
//! of each leg of the path is free, and draws it.
//!
//! ```sh
//! cargo run --example motion_planning --features num-rational -- picture.svg
//! cargo run --release --example motion_planning --features num-rational -- --maze maze.svg
//! ```
//!
//! The floor is the container of a scene, the obstacles are its members. The free region of the
//! robot is where its reference point may be. All is decided in fractions: where there is exactly
//! enough room, the robot may pass. With `--maze` the scene is a maze of 10,000 pieces of wall, and
//! the time that its free region takes is printed.

use std::error::Error;
use std::time::Instant;
use std::{env, fs};

use gcv::{Options, PartKind, Polygon, Query, Region, Scene};
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

/// The maze has as many cells in a row and in a column. One way leads from each to each other one.
const CELLS: usize = 101;
const CELL: f64 = 10.;

/// How thick a piece of wall may be. Between two thick ones there is just the room that the robot
/// needs.
const THICKNESSES: [f64; 4] = [1., 2., 3., 6.];

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

/// Above 0 where the point is to the left of the line from a to b, 0 where it is on it.
fn side([a, b]: &[Point; 2], point: &Point) -> BigRational {
    (&b[0] - &a[0]) * (&point[1] - &a[1]) - (&b[1] - &a[1]) * (&point[0] - &a[0])
}

fn is_on(line: &[Point; 2], point: &Point) -> bool {
    let [a, b] = line;
    let between =
        |axis: usize| !((&point[axis] - &a[axis]) * (&point[axis] - &b[axis])).is_positive();
    between(0) && between(1) && side(line, point).is_zero()
}

/// Where a point of the line of a leg is on the leg, if it is.
fn fraction_of(leg: &[Point; 2], point: &Point) -> Option<BigRational> {
    let axis = usize::from(leg[0][0] == leg[1][0]);
    let t = (&point[axis] - &leg[0][axis]) / (&leg[1][axis] - &leg[0][axis]);
    is_on(leg, point).then_some(t)
}

/// The free region in fractions.
struct Free {
    /// Those of all rings.
    edges: Vec<[Point; 2]>,
    /// Where there is exactly enough room.
    segments: Vec<[Point; 2]>,
}

impl Free {
    fn of(region: &Region) -> Self {
        let (vertices, mut edges, mut segments) = (region.exact_rationals(), vec![], vec![]);
        for part in region.exact_parts() {
            let ring = &vertices[part.vertices];
            let next = ring.iter().cycle().skip(1);
            let mut sides = ring.iter().zip(next).map(|(a, b)| [a.clone(), b.clone()]);
            match part.kind {
                PartKind::Outer { .. } | PartKind::Hole { .. } => edges.extend(sides),
                PartKind::Segment => segments.extend(sides.next()),
                PartKind::Point => (),
            }
        }
        Self { edges, segments }
    }

    fn lines(&self) -> impl Iterator<Item = &[Point; 2]> {
        self.edges.iter().chain(&self.segments)
    }

    /// Whether the point is in the region: on it, or inside by the edges to the right of it.
    fn has(&self, point: &Point) -> bool {
        let is_right = |edge: &&[Point; 2]| {
            let [from_below, to_below] = [0, 1].map(|end| edge[end][1] <= point[1]);
            from_below != to_below && from_below == side(edge, point).is_positive()
        };
        self.edges.iter().filter(is_right).count() % 2 == 1
            || self.lines().any(|line| is_on(line, point))
    }
}

/// Cuts a leg wherever it meets a line of the region, and looks at the middle of each piece.
fn pieces(leg: &[Point; 2], free: &Free) -> Vec<Piece> {
    let mut cuts = vec![BigRational::zero(), BigRational::one()];
    for line in free.lines() {
        let [from, to] = [0, 1].map(|end| side(line, &leg[end]));
        if (&from * &to).is_negative() {
            cuts.push(&from / (&from - &to));
        } else if from.is_zero() && to.is_zero() {
            cuts.extend(line.iter().filter_map(|end| fraction_of(leg, end)));
        }
    }
    cuts.sort();
    cuts.dedup();
    let piece = |ends: &[BigRational]| {
        let middle = (&ends[0] + &ends[1]) / BigRational::from_integer(2.into());
        Piece {
            start: ends[0].clone(),
            end: ends[1].clone(),
            free: free.has(&at(leg, &middle)),
        }
    };
    cuts.windows(2).map(piece).collect()
}

/// Numbers like those of dice, the same in every run.
struct Dice(u64);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1);
        (self.0 >> 33) as usize % count
    }
}

/// Walls of cells: of each cell the one to the right of it and the one above it. `false` where a
/// way leads through. Ways are dug from cell to cell, as long as there are new ones.
fn dig(dice: &mut Dice) -> Vec<[bool; 2]> {
    let mut walls = vec![[true; 2]; CELLS * CELLS];
    let (mut is_new, mut way) = (vec![true; CELLS * CELLS], vec![0]);
    is_new[0] = false;
    while let Some(&cell) = way.last() {
        let (x, y) = (cell % CELLS, cell / CELLS);
        // The next cell, and the wall before it.
        let mut next = vec![];
        for (axis, place, step) in [(0, x, 1), (1, y, CELLS)] {
            if place + 1 < CELLS && is_new[cell + step] {
                next.push((cell + step, cell, axis));
            }
            if place > 0 && is_new[cell - step] {
                next.push((cell - step, cell - step, axis));
            }
        }
        if next.is_empty() {
            way.pop();
            continue;
        }
        let (next, wall, axis) = next[dice.below(next.len())];
        is_new[next] = false;
        walls[wall][axis] = false;
        way.push(next);
    }
    walls
}

/// A floor with walls, each from corner to corner of a cell. They overlap at the corners.
fn maze() -> Result<Scene, gcv::Error> {
    let wall = |thickness: f64, [x, y]: [f64; 2]| {
        let half = thickness / 2.;
        let (low, high) = (-half, [x + half, y + half]);
        Polygon::new(&[[low, low], [high[0], low], high, [low, high[1]]])
    };
    let of_all = |length| {
        let shapes = THICKNESSES.iter().map(|thickness| wall(*thickness, length));
        shapes.collect::<Result<Vec<_>, _>>()
    };
    let shapes = [of_all([0., CELL])?, of_all([CELL, 0.])?];
    let (mut polygons, mut positions, mut dice) = (vec![], vec![], Dice(1));
    for (cell, walls) in dig(&mut dice).into_iter().enumerate() {
        let place = [cell % CELLS, cell / CELLS];
        for (axis, shapes) in shapes.iter().enumerate() {
            if walls[axis] && place[axis] + 1 < CELLS {
                let mut position = place.map(|k| k as f64 * CELL);
                position[axis] += CELL;
                polygons.push(&shapes[dice.below(shapes.len())]);
                positions.push(position);
            }
        }
    }
    let size = CELLS as f64 * CELL;
    let mut scene = Scene::new();
    scene.set_container(Some(&rectangle([size, size])?))?;
    scene.add_many(&polygons, &positions)?;
    Ok(scene)
}

fn rectangle([width, height]: [f64; 2]) -> Result<Polygon, gcv::Error> {
    Polygon::new(&[[0., 0.], [width, 0.], [width, height], [0., height]])
}

fn svg_path(class: &str, points: &[[f64; 2]]) -> String {
    let words: Vec<_> = points.iter().map(|[x, y]| format!("{x} {y}")).collect();
    format!("<path class=\"{class}\" d=\"M{}Z\"/>\n", words.join("L"))
}

/// A region, and the members of its scene.
fn svg_paths(scene: &Scene, region: &Region) -> Result<String, gcv::Error> {
    let (mut paths, vertices) = (String::new(), region.vertices());
    for part in region.parts() {
        let class = match part.kind {
            PartKind::Outer { .. } => "room",
            PartKind::Hole { .. } => "hole",
            PartKind::Segment | PartKind::Point => "fit",
        };
        paths += &svg_path(class, &vertices[part.vertices]);
    }
    let ids = scene.ids();
    for (id, [dx, dy]) in ids.iter().zip(scene.positions(&ids)?) {
        let vertices = scene.polygon(*id)?.vertices();
        let placed: Vec<_> = vertices.iter().map(|[x, y]| [x + dx, y + dy]).collect();
        paths += &svg_path("obstacle", &placed);
    }
    Ok(paths)
}

fn svg([width, height]: [f64; 2], paths: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"880\" viewBox=\"0 0 {width} {height}\">
<style>
  path {{ stroke-width: 0.12; stroke-linejoin: round }}
  .room {{ fill: #fff; stroke: #e0561f }}
  .hole {{ fill: #fae6dd; stroke: #e0561f }}
  .fit {{ stroke: #e0561f; stroke-width: 0.3 }}
  .obstacle {{ fill: #5b6675 }}
  .robot {{ fill: #1c6dd0; fill-opacity: 0.3 }}
  .free {{ stroke: #0b9a6d; stroke-width: 0.3 }}
  .blocked {{ stroke: #c2185b; stroke-width: 0.3 }}
</style>
<rect width=\"{width}\" height=\"{height}\" fill=\"#fae6dd\"/>
<g transform=\"matrix(1 0 0 -1 0 {height})\">
{paths}</g>
</svg>
"
    )
}

/// Draws the path, and prints how much of each leg is free.
fn follow_path(file: &str) -> Result<(), Box<dyn Error>> {
    let obstacles: Vec<_> = OBSTACLES
        .iter()
        .map(|wkt| Polygon::from_wkt(wkt))
        .collect::<Result<_, _>>()?;
    let mut scene = Scene::new();
    scene.set_container(Some(&rectangle(SIZE)?))?;
    for obstacle in &obstacles {
        scene.add(obstacle, [0., 0.])?;
    }
    let robot = Polygon::new(&ROBOT)?;
    let region = scene.free_region(&robot, None, &Query::new(), &Options::new())?;
    let free = Free::of(&region);

    let mut paths = svg_paths(&scene, &region)?;
    for [x, y] in PATH {
        paths += &svg_path("robot", &ROBOT.map(|[dx, dy]| [x + dx, y + dy]));
    }
    for ends in PATH.windows(2) {
        let leg = [exact(ends[0]), exact(ends[1])];
        let mut length = BigRational::zero();
        for piece in pieces(&leg, &free) {
            let line = [&piece.start, &piece.end]
                .map(|t| at(&leg, t).map(|c| c.to_f64().expect("coordinates are finite")));
            paths += &svg_path(if piece.free { "free" } else { "blocked" }, &line);
            if piece.free {
                length += piece.end - piece.start;
            }
        }
        let [from, to] = [ends[0], ends[1]];
        println!("{from:?} to {to:?}: {length} of the way is free");
    }
    fs::write(file, svg(SIZE, &paths))?;
    Ok(())
}

/// Draws the maze, and prints how long its free region took.
fn explore_maze(file: &str) -> Result<(), Box<dyn Error>> {
    let (scene, robot) = (maze()?, Polygon::new(&ROBOT)?);
    let start = Instant::now();
    let region = scene.free_region(&robot, None, &Query::new(), &Options::new().threads(0))?;
    let time = start.elapsed().as_secs_f64();
    let (walls, polygons) = (scene.len(), region.polygons().len());
    let (vertices, fits) = (region.vertices().len(), region.parts());
    let is_fit = |kind| matches!(kind, PartKind::Segment | PartKind::Point);
    let fits = fits.iter().filter(|part| is_fit(part.kind)).count();
    println!("{walls} pieces of wall, free region in {time:.3} s");
    println!("{polygons} polygons, {vertices} vertices, {fits} fits");
    let size = CELLS as f64 * CELL;
    fs::write(file, svg([size, size], &svg_paths(&scene, &region)?))?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let (modes, files): (Vec<_>, Vec<_>) = env::args().skip(1).partition(|word| word == "--maze");
    if files.len() > 1 || files.iter().any(|word| word.starts_with('-')) {
        return Err("usage: motion_planning [--maze] [PICTURE.svg]".into());
    }
    let file = files.first().map_or("motion_planning.svg", String::as_str);
    if modes.is_empty() {
        follow_path(file)?;
    } else {
        explore_maze(file)?;
    }
    println!("picture: {file}");
    Ok(())
}

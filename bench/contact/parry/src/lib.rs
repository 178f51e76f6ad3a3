// SPDX-License-Identifier: LGPL-3.0-or-later
//! Questions about two polygons, of which the second is moved, put to parry2d in doubles.
//! Its C interface is in ../parry.hpp.

use std::panic::{catch_unwind, AssertUnwindSafe};
use std::ptr;
use std::slice;

use parry2d_f64::math::{Pose, Vector};
use parry2d_f64::query::{self, ShapeCastOptions};
use parry2d_f64::shape::{Compound, ConvexPolygon, SharedShape, TriMesh};

fn turn(p: Vector, q: Vector, r: Vector) -> f64 {
    (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)
}

/// Is a counter-clockwise ring convex, but for roundings?
fn is_convex(ring: &[Vector]) -> bool {
    let n = ring.len();
    (0..n).all(|k| turn(ring[k], ring[(k + 1) % n], ring[(k + 2) % n]) >= 0.0)
}

/// One convex polygon, or else convex pieces of a triangulation.
fn shape(ring: Vec<Vector>) -> Option<SharedShape> {
    if is_convex(&ring) {
        return ConvexPolygon::from_convex_polyline(ring).map(SharedShape::new);
    }
    let triangles = TriMesh::from_polygon(ring)?;
    Some(match Compound::decompose_trimesh(&triangles) {
        Some(pieces) => SharedShape::new(pieces),
        None => SharedShape::new(triangles),
    })
}

fn vectors(xy: &[f64]) -> Vec<Vector> {
    xy.chunks_exact(2)
        .map(|p| Vector::new(p[0], p[1]))
        .collect()
}

/// # Safety
/// `xy` holds `2 * count` doubles.
#[no_mangle]
pub unsafe extern "C" fn parry_shape_create(xy: *const f64, count: usize) -> *mut SharedShape {
    let ring = vectors(slice::from_raw_parts(xy, 2 * count));
    match catch_unwind(|| shape(ring)) {
        Ok(Some(made)) => Box::into_raw(Box::new(made)),
        _ => ptr::null_mut(),
    }
}

/// # Safety
/// `made` is from `parry_shape_create`, or null.
#[no_mangle]
pub unsafe extern "C" fn parry_shape_destroy(made: *mut SharedShape) {
    if !made.is_null() {
        drop(Box::from_raw(made));
    }
}

/// Puts one question for each element of `out`; where parry panics, the rest becomes NaN.
fn put(out: &mut [f64], question: impl Fn(usize) -> f64) {
    for k in 0..out.len() {
        match catch_unwind(AssertUnwindSafe(|| question(k))) {
            Ok(answer) => out[k] = answer,
            Err(_) => out[k..].fill(f64::NAN),
        }
    }
}

fn translation(xy: &[f64], k: usize) -> Pose {
    Pose::translation(xy[2 * k], xy[2 * k + 1])
}

/// Each element becomes 1 where the shapes are apart, else 0.
///
/// # Safety
/// `a` and `b` are from `parry_shape_create`, `xy` holds `2 * count` doubles, `out` room for `count`.
#[no_mangle]
pub unsafe extern "C" fn parry_relation(
    a: *const SharedShape,
    b: *const SharedShape,
    xy: *const f64,
    count: usize,
    out: *mut f64,
) {
    let (a, b) = ((*a).as_ref(), (*b).as_ref());
    let xy = slice::from_raw_parts(xy, 2 * count);
    put(slice::from_raw_parts_mut(out, count), |k| {
        let found = query::intersection_test(&Pose::IDENTITY, a, &translation(xy, k), b);
        found.map_or(f64::NAN, |found| f64::from(u8::from(!found.intersecting)))
    });
}

/// Each element becomes the distance.
///
/// # Safety
/// As for `parry_relation`.
#[no_mangle]
pub unsafe extern "C" fn parry_distance(
    a: *const SharedShape,
    b: *const SharedShape,
    xy: *const f64,
    count: usize,
    out: *mut f64,
) {
    let (a, b) = ((*a).as_ref(), (*b).as_ref());
    let xy = slice::from_raw_parts(xy, 2 * count);
    put(slice::from_raw_parts_mut(out, count), |k| {
        query::distance(&Pose::IDENTITY, a, &translation(xy, k), b)
            .map_or(f64::NAN, |found| found.distance)
    });
}

/// Each element becomes the part of the motion up to the first impact, 1 without one.
///
/// # Safety
/// As for `parry_relation`; `motions` holds `2 * count` doubles.
#[no_mangle]
pub unsafe extern "C" fn parry_cast(
    a: *const SharedShape,
    b: *const SharedShape,
    xy: *const f64,
    motions: *const f64,
    count: usize,
    out: *mut f64,
) {
    let (a, b) = ((*a).as_ref(), (*b).as_ref());
    let xy = slice::from_raw_parts(xy, 2 * count);
    let motions = slice::from_raw_parts(motions, 2 * count);
    let options = ShapeCastOptions::with_max_time_of_impact(1.0);
    put(slice::from_raw_parts_mut(out, count), |k| {
        let velocity = Vector::new(motions[2 * k], motions[2 * k + 1]);
        let start = translation(xy, k);
        query::cast_shapes(
            &Pose::IDENTITY,
            Vector::ZERO,
            a,
            &start,
            velocity,
            b,
            options,
        )
        .map_or(f64::NAN, |hit| hit.map_or(1.0, |hit| hit.time_of_impact))
    });
}

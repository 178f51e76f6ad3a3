// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! The C interface of libgcv as it is in gcv.h, which documents everything here.
//!
//! Statuses are integers, as later versions of the library may add some.
//! Programs in Rust have the crate `gcv` to use instead.

#![allow(non_camel_case_types)]

use std::marker::{PhantomData, PhantomPinned};
use std::os::raw::{c_char, c_void};

mod region;
mod scene;
mod two_polygons;

pub use region::*;
pub use scene::*;
pub use two_polygons::*;

pub type gcv_status = i32;

pub const GCV_OK: gcv_status = 0;
pub const GCV_ERR_NULL_ARGUMENT: gcv_status = 1;
pub const GCV_ERR_INVALID_ARGUMENT: gcv_status = 2;
pub const GCV_ERR_NOT_FINITE: gcv_status = 3;
pub const GCV_ERR_DEGENERATE: gcv_status = 4;
pub const GCV_ERR_NOT_SIMPLE: gcv_status = 5;
pub const GCV_ERR_BUFFER_TOO_SMALL: gcv_status = 6;
pub const GCV_ERR_RANGE: gcv_status = 7;
pub const GCV_ERR_PARSE: gcv_status = 8;
pub const GCV_ERR_NO_MEMORY: gcv_status = 9;
pub const GCV_ERR_CANCELLED: gcv_status = 11;
pub const GCV_ERR_INTERNAL: gcv_status = 100;

pub const GCV_ROUND_NEAREST: i32 = 0;
pub const GCV_ROUND_OUTWARD: i32 = 1;

pub const GCV_LEAVE_OUT_HOLES: u64 = 1;
pub const GCV_LEAVE_OUT_FITS: u64 = 2;

pub const GCV_EDGE_TRANSLATED: i32 = 1;
pub const GCV_EDGE_CORNER: i32 = 2;
pub const GCV_EDGE_TRANSLATED_CORNER: i32 = 3;

/// What only the library can make, move and share.
type Opaque = PhantomData<(*mut u8, PhantomPinned)>;

#[repr(C)]
pub struct gcv_polygon {
    data: [u8; 0],
    marker: Opaque,
}

#[repr(C)]
pub struct gcv_outer_face {
    data: [u8; 0],
    marker: Opaque,
}

#[repr(C)]
pub struct gcv_superset {
    data: [u8; 0],
    marker: Opaque,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct gcv_options {
    pub struct_size: u32,
    pub rounding: i32,
    pub tolerance: f64,
    pub threads: i32,
    pub progress: Option<unsafe extern "C" fn(*mut c_void, u64, u64) -> i32>,
    pub progress_context: *mut c_void,
    pub leave_out: u64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct gcv_edge_source {
    pub kind: i32,
    pub a: u32,
    pub b: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct gcv_stats {
    pub struct_size: u32,
    pub walk_steps: u64,
    pub candidate_edges: u64,
    pub predicates_filtered: u64,
    pub predicates_fixed_width: u64,
    pub predicates_rational: u64,
    pub vertices_repaired: u64,
    pub parts_dropped: u64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct gcv_superset_edge {
    pub x0: f64,
    pub y0: f64,
    pub x1: f64,
    pub y1: f64,
    pub source: gcv_edge_source,
}

extern "C" {
    pub fn gcv_version_number() -> u32;
    pub fn gcv_version_string() -> *const c_char;
    pub fn gcv_status_name(status: gcv_status) -> *const c_char;
    pub fn gcv_last_error_message() -> *const c_char;

    pub fn gcv_polygon_create(
        xy: *const f64,
        vertex_count: usize,
        stride_bytes: usize,
        out: *mut *mut gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_polygon_create_wkt(
        text: *const c_char,
        length: usize,
        out: *mut *mut gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_polygon_create_rings(
        xy: *const f64,
        ring_sizes: *const usize,
        ring_count: usize,
        stride_bytes: usize,
        out: *mut *mut gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_polygon_create_many(
        xy: *const f64,
        sizes: *const usize,
        count: usize,
        stride_bytes: usize,
        out: *mut *mut gcv_polygon,
        statuses: *mut gcv_status,
    ) -> gcv_status;
    pub fn gcv_polygon_create_disc(
        centre: *const f64,
        radius: f64,
        tolerance: f64,
        rounding: i32,
        out: *mut *mut gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_polygon_affine(
        polygon: *const gcv_polygon,
        m: *const f64,
        out: *mut *mut gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_polygon_destroy(polygon: *mut gcv_polygon);
    pub fn gcv_polygon_ring_count(polygon: *const gcv_polygon, out: *mut usize) -> gcv_status;
    pub fn gcv_polygon_ring(
        polygon: *const gcv_polygon,
        ring: usize,
        xy: *mut f64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_polygon_vertex_count(polygon: *const gcv_polygon, out: *mut usize) -> gcv_status;
    pub fn gcv_polygon_vertices(
        polygon: *const gcv_polygon,
        xy: *mut f64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_polygon_area(polygon: *const gcv_polygon, out: *mut f64) -> gcv_status;
    pub fn gcv_polygon_bounds(polygon: *const gcv_polygon, out: *mut f64) -> gcv_status;
    pub fn gcv_polygon_simplified(
        polygon: *const gcv_polygon,
        tolerance: f64,
        rounding: i32,
        out: *mut *mut gcv_polygon,
        error_bound: *mut f64,
    ) -> gcv_status;

    pub fn gcv_options_init(options: *mut gcv_options);
    pub fn gcv_options_init_size(options: *mut gcv_options, struct_size: u32);

    pub fn gcv_minkowski_sum(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        options: *const gcv_options,
        out: *mut *mut gcv_outer_face,
    ) -> gcv_status;
    pub fn gcv_minkowski_sum_many(
        a: *const *const gcv_polygon,
        b: *const *const gcv_polygon,
        count: usize,
        options: *const gcv_options,
        out: *mut *mut gcv_outer_face,
        statuses: *mut gcv_status,
    ) -> gcv_status;
    pub fn gcv_no_fit_polygon(
        fixed: *const gcv_polygon,
        moving: *const gcv_polygon,
        reference: *const f64,
        options: *const gcv_options,
        out: *mut *mut gcv_outer_face,
    ) -> gcv_status;
    pub fn gcv_entrance_block(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        a0: *const f64,
        options: *const gcv_options,
        out: *mut *mut gcv_outer_face,
    ) -> gcv_status;
    pub fn gcv_no_fit_polygon_many(
        fixed: *const *const gcv_polygon,
        moving: *const *const gcv_polygon,
        references: *const f64,
        count: usize,
        options: *const gcv_options,
        out: *mut *mut gcv_outer_face,
        statuses: *mut gcv_status,
    ) -> gcv_status;
    pub fn gcv_outer_face_destroy(face: *mut gcv_outer_face);
    pub fn gcv_outer_face_vertex_count(face: *const gcv_outer_face, out: *mut usize) -> gcv_status;
    pub fn gcv_outer_face_vertices(
        face: *const gcv_outer_face,
        xy: *mut f64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_outer_face_exact_vertex_count(
        face: *const gcv_outer_face,
        out: *mut usize,
    ) -> gcv_status;
    pub fn gcv_outer_face_exact_vertex(
        face: *const gcv_outer_face,
        index: usize,
        text: *mut c_char,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_outer_face_edge_sources(
        face: *const gcv_outer_face,
        out: *mut gcv_edge_source,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_outer_face_exact_indices(
        face: *const gcv_outer_face,
        out: *mut u64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_outer_face_error_bound(face: *const gcv_outer_face, out: *mut f64) -> gcv_status;
    pub fn gcv_outer_face_area(face: *const gcv_outer_face, out: *mut f64) -> gcv_status;
    pub fn gcv_outer_face_wkt(
        face: *const gcv_outer_face,
        text: *mut c_char,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_outer_face_polygon(
        face: *const gcv_outer_face,
        out: *mut *mut gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_outer_face_stats(face: *const gcv_outer_face, out: *mut gcv_stats) -> gcv_status;

    pub fn gcv_superset_create(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        out: *mut *mut gcv_superset,
    ) -> gcv_status;
    pub fn gcv_superset_destroy(superset: *mut gcv_superset);
    pub fn gcv_superset_edges(
        superset: *const gcv_superset,
        out: *mut gcv_superset_edge,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
}

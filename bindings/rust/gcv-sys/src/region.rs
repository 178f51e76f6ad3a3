// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Regions: their parts, how they are made, and what they tell.

use std::os::raw::c_char;

use crate::{gcv_edge_source, gcv_options, gcv_polygon, gcv_stats, gcv_status, Opaque};

pub const GCV_PART_OUTER: i32 = 1;
pub const GCV_PART_HOLE: i32 = 2;
pub const GCV_PART_SEGMENT: i32 = 3;
pub const GCV_PART_POINT: i32 = 4;

pub const GCV_INSIDE: i8 = 1;
pub const GCV_BOUNDARY: i8 = 0;
pub const GCV_OUTSIDE: i8 = -1;

#[repr(C)]
pub struct gcv_region {
    data: [u8; 0],
    marker: Opaque,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct gcv_region_part {
    pub kind: i32,
    pub polygon: u32,
    pub vertex_count: u64,
}

extern "C" {
    pub fn gcv_minkowski_sum_region(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        options: *const gcv_options,
        out: *mut *mut gcv_region,
    ) -> gcv_status;
    pub fn gcv_minkowski_sum_region_many(
        a: *const *const gcv_polygon,
        b: *const *const gcv_polygon,
        count: usize,
        options: *const gcv_options,
        out: *mut *mut gcv_region,
        statuses: *mut gcv_status,
    ) -> gcv_status;
    pub fn gcv_no_fit_region(
        fixed: *const gcv_polygon,
        moving: *const gcv_polygon,
        reference: *const f64,
        options: *const gcv_options,
        out: *mut *mut gcv_region,
    ) -> gcv_status;
    pub fn gcv_no_fit_region_many(
        fixed: *const *const gcv_polygon,
        moving: *const *const gcv_polygon,
        references: *const f64,
        count: usize,
        options: *const gcv_options,
        out: *mut *mut gcv_region,
        statuses: *mut gcv_status,
    ) -> gcv_status;
    pub fn gcv_entrance_region(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        a0: *const f64,
        options: *const gcv_options,
        out: *mut *mut gcv_region,
    ) -> gcv_status;
    pub fn gcv_inner_fit_region(
        container: *const gcv_polygon,
        moving: *const gcv_polygon,
        reference: *const f64,
        options: *const gcv_options,
        out: *mut *mut gcv_region,
    ) -> gcv_status;
    pub fn gcv_region_destroy(region: *mut gcv_region);
    pub fn gcv_region_parts(
        region: *const gcv_region,
        out: *mut gcv_region_part,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_vertices(
        region: *const gcv_region,
        xy: *mut f64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_exact_parts(
        region: *const gcv_region,
        out: *mut gcv_region_part,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_exact_vertex(
        region: *const gcv_region,
        index: usize,
        text: *mut c_char,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_exact_indices(
        region: *const gcv_region,
        out: *mut u64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_edge_sources(
        region: *const gcv_region,
        out: *mut gcv_edge_source,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_edge_owners(
        region: *const gcv_region,
        ids: *mut u64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_area(region: *const gcv_region, out: *mut f64) -> gcv_status;
    pub fn gcv_region_error_bound(region: *const gcv_region, out: *mut f64) -> gcv_status;
    pub fn gcv_region_wkt(
        region: *const gcv_region,
        text: *mut c_char,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_fits_wkt(
        region: *const gcv_region,
        text: *mut c_char,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_region_polygon(
        region: *const gcv_region,
        polygon: usize,
        out: *mut *mut gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_region_locate(
        region: *const gcv_region,
        xy: *const f64,
        count: usize,
        out: *mut i8,
    ) -> gcv_status;
    pub fn gcv_region_stats(region: *const gcv_region, out: *mut gcv_stats) -> gcv_status;
}

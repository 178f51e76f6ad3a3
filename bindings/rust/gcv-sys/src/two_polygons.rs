// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Questions about two polygons: how they lie, how far apart they are, when they meet.

use crate::{gcv_options, gcv_polygon, gcv_status, Opaque};

pub const GCV_APART: i8 = 1;
pub const GCV_TOUCHING: i8 = 0;
pub const GCV_OVERLAPPING: i8 = -1;

pub const GCV_CONTACT_EDGE_VERTEX: i32 = 1;
pub const GCV_CONTACT_VERTEX_EDGE: i32 = 2;
pub const GCV_CONTACT_VERTEX_VERTEX: i32 = 3;

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct gcv_contact {
    pub kind: i32,
    pub a: u32,
    pub b: u32,
    pub reserved: u32,
    pub id_a: u64,
    pub id_b: u64,
    pub gap: f64,
    pub normal: [f64; 2],
    pub on_a: [f64; 2],
    pub on_b: [f64; 2],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct gcv_separation {
    pub distance: f64,
    pub relation: i32,
    pub reserved: u32,
    pub nearest: gcv_contact,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct gcv_escape {
    pub depth: f64,
    pub translation: [f64; 2],
    pub position: [f64; 2],
    pub relation: i32,
    pub reserved: u32,
    pub contact: gcv_contact,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct gcv_impact {
    pub hit: i32,
    pub relation: i32,
    pub time: f64,
    pub position: [f64; 2],
    pub contact: gcv_contact,
}

#[repr(C)]
pub struct gcv_contact_list {
    data: [u8; 0],
    marker: Opaque,
}

extern "C" {
    pub fn gcv_relation(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        translations: *const f64,
        count: usize,
        options: *const gcv_options,
        out: *mut i8,
    ) -> gcv_status;
    pub fn gcv_distance(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        translations: *const f64,
        count: usize,
        options: *const gcv_options,
        out: *mut gcv_separation,
    ) -> gcv_status;
    pub fn gcv_cast(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        translations: *const f64,
        motions: *const f64,
        count: usize,
        options: *const gcv_options,
        out: *mut gcv_impact,
    ) -> gcv_status;
    pub fn gcv_penetration(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        translations: *const f64,
        count: usize,
        options: *const gcv_options,
        out: *mut gcv_escape,
    ) -> gcv_status;
    pub fn gcv_contacts(
        a: *const gcv_polygon,
        b: *const gcv_polygon,
        t: *const f64,
        distance: f64,
        slope: f64,
        options: *const gcv_options,
        out: *mut *mut gcv_contact_list,
    ) -> gcv_status;
    pub fn gcv_contact_list_destroy(list: *mut gcv_contact_list);
    pub fn gcv_contact_list_contacts(
        list: *const gcv_contact_list,
        out: *mut gcv_contact,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_contact_list_previous(
        list: *const gcv_contact_list,
        out: *mut u64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
}

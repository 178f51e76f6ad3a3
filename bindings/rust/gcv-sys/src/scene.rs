// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Scenes: polygons at positions, and questions about them.

use std::mem::size_of;
use std::ptr;

use crate::{
    gcv_contact_list, gcv_escape, gcv_impact, gcv_options, gcv_polygon, gcv_region, gcv_separation,
    gcv_status, Opaque,
};

#[repr(C)]
pub struct gcv_scene {
    data: [u8; 0],
    marker: Opaque,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct gcv_query {
    pub struct_size: u32,
    pub layers: u32,
    pub ignore: *const u64,
    pub ignore_count: usize,
}

pub const GCV_QUERY_INIT: gcv_query = gcv_query {
    struct_size: size_of::<gcv_query>() as u32,
    layers: u32::MAX,
    ignore: ptr::null(),
    ignore_count: 0,
};

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct gcv_pair {
    pub a: u64,
    pub b: u64,
    pub relation: i32,
    pub reserved: u32,
}

#[repr(C)]
pub struct gcv_pair_list {
    data: [u8; 0],
    marker: Opaque,
}

extern "C" {
    pub fn gcv_scene_create(out: *mut *mut gcv_scene) -> gcv_status;
    pub fn gcv_scene_copy(scene: *const gcv_scene, out: *mut *mut gcv_scene) -> gcv_status;
    pub fn gcv_scene_destroy(scene: *mut gcv_scene);
    pub fn gcv_scene_set_container(
        scene: *mut gcv_scene,
        container: *const gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_scene_add(
        scene: *mut gcv_scene,
        polygons: *const *const gcv_polygon,
        positions: *const f64,
        count: usize,
        ids: *mut u64,
    ) -> gcv_status;
    pub fn gcv_scene_set(
        scene: *mut gcv_scene,
        ids: *const u64,
        polygons: *const *const gcv_polygon,
        positions: *const f64,
        count: usize,
    ) -> gcv_status;
    pub fn gcv_scene_set_layers(
        scene: *mut gcv_scene,
        ids: *const u64,
        layers: *const u32,
        count: usize,
    ) -> gcv_status;
    pub fn gcv_scene_remove(scene: *mut gcv_scene, ids: *const u64, count: usize) -> gcv_status;
    pub fn gcv_scene_ids(
        scene: *const gcv_scene,
        ids: *mut u64,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
    pub fn gcv_scene_positions(
        scene: *const gcv_scene,
        ids: *const u64,
        count: usize,
        xy: *mut f64,
    ) -> gcv_status;
    pub fn gcv_scene_polygon(
        scene: *const gcv_scene,
        id: u64,
        out: *mut *mut gcv_polygon,
    ) -> gcv_status;
    pub fn gcv_scene_free_region(
        scene: *const gcv_scene,
        moving: *const gcv_polygon,
        window: *const f64,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut *mut gcv_region,
    ) -> gcv_status;
    pub fn gcv_scene_best(
        scene: *const gcv_scene,
        moving: *const gcv_polygon,
        direction: *const f64,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut f64,
        found: *mut i32,
    ) -> gcv_status;
    pub fn gcv_scene_relation(
        scene: *const gcv_scene,
        moving: *const gcv_polygon,
        positions: *const f64,
        count: usize,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut i8,
    ) -> gcv_status;
    pub fn gcv_scene_distance(
        scene: *const gcv_scene,
        moving: *const gcv_polygon,
        positions: *const f64,
        count: usize,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut gcv_separation,
    ) -> gcv_status;
    pub fn gcv_scene_penetration(
        scene: *const gcv_scene,
        moving: *const gcv_polygon,
        positions: *const f64,
        count: usize,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut gcv_escape,
    ) -> gcv_status;
    pub fn gcv_scene_cast(
        scene: *const gcv_scene,
        moving: *const gcv_polygon,
        positions: *const f64,
        motions: *const f64,
        count: usize,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut gcv_impact,
    ) -> gcv_status;
    pub fn gcv_scene_near(
        scene: *const gcv_scene,
        moving: *const gcv_polygon,
        position: *const f64,
        distance: f64,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut *mut gcv_pair_list,
    ) -> gcv_status;
    pub fn gcv_scene_pairs(
        scene: *const gcv_scene,
        previous: *const gcv_pair_list,
        distance: f64,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut *mut gcv_pair_list,
    ) -> gcv_status;
    pub fn gcv_scene_contacts(
        scene: *const gcv_scene,
        previous: *const gcv_contact_list,
        distance: f64,
        slope: f64,
        query: *const gcv_query,
        options: *const gcv_options,
        out: *mut *mut gcv_contact_list,
    ) -> gcv_status;
    pub fn gcv_pair_list_destroy(list: *mut gcv_pair_list);
    pub fn gcv_pair_list_pairs(
        list: *const gcv_pair_list,
        out: *mut gcv_pair,
        capacity: usize,
        required: *mut usize,
    ) -> gcv_status;
}

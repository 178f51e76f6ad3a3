// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Where this crate takes no memory.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use gcv::{cast, cast_into, distance, distance_into, relation, relation_into};
use gcv::{Escape, Impact, Options, Polygon, Query, Relation, Scene, Separation};

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: all is done by the allocator of the system.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.with(|count| count.set(count.get() + 1));
        System.alloc(layout)
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        System.dealloc(pointer, layout);
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations(call: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.with(Cell::get);
    call();
    ALLOCATIONS.with(Cell::get) - before
}

#[test]
fn questions_about_two_polygons() {
    let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]]).unwrap();
    assert!(allocations(|| drop(square.vertices())) > 0);

    let (options, t) = (Options::new(), [3., 4.]);
    let count = allocations(|| {
        relation(&square, &square, t, &options).unwrap();
        distance(&square, &square, t, &options).unwrap();
        cast(&square, &square, t, [-3., -4.], &options).unwrap();
    });
    assert_eq!(count, 0);

    let (translations, mut relations) = ([t; 100], [Relation::Apart; 100]);
    let mut separations = [Separation::default(); 100];
    let mut impacts = [Impact::default(); 100];
    let count = allocations(|| {
        let (a, b, t) = (&square, &square, &translations);
        relation_into(a, b, t, &options, &mut relations).unwrap();
        distance_into(a, b, t, &options, &mut separations).unwrap();
        cast_into(a, b, t, t, &options, &mut impacts).unwrap();
    });
    assert_eq!(count, 0);
}

#[test]
fn questions_to_scenes() {
    let square = Polygon::new(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]]).unwrap();
    let mut scene = Scene::new();
    let ids = scene.add_many(&[&square; 3], &[[0., 0.], [2., 0.], [9., 0.]]);
    let ids = ids.unwrap();
    let (query, options, at) = (Query::new().ignore(&ids[1..]), Options::new(), [3., 4.]);
    let (positions, mut relations) = ([at; 100], [Relation::Apart; 100]);
    let mut separations = [Separation::default(); 100];
    let mut impacts = [Impact::default(); 100];
    let mut escapes = [Escape::default(); 100];
    scene.set_container(Some(&square)).unwrap();
    let count = allocations(|| {
        scene.relation(&square, at, &query, &options).unwrap();
        scene.distance(&square, at, &query, &options).unwrap();
        scene.cast(&square, at, at, &query, &options).unwrap();
        scene.penetration(&square, at, &query, &options).unwrap();
        scene.best(&square, at, &query, &options).unwrap();
        let (moving, from) = (&square, &positions);
        scene
            .relation_into(moving, from, &query, &options, &mut relations)
            .unwrap();
        scene
            .distance_into(moving, from, &query, &options, &mut separations)
            .unwrap();
        scene
            .cast_into(moving, from, from, &query, &options, &mut impacts)
            .unwrap();
        scene
            .penetration_into(moving, from, &query, &options, &mut escapes)
            .unwrap();
    });
    assert_eq!(count, 0);

    let count = allocations(|| {
        scene.set_positions(&ids, &positions[..3]).unwrap();
        scene.set_layers(&ids, &[1, 2, 3]).unwrap();
        scene.remove(&ids).unwrap();
    });
    assert_eq!(count, 0);
}

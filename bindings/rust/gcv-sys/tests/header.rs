// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! The declarations against the header of the source tree, by the C compiler.

use std::fmt::Write as _;
use std::io::Write as _;
use std::mem::{size_of, MaybeUninit};
use std::process::{Command, Stdio};

use gcv_sys::*;

const INCLUDE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../capi/include");
const HEADER: &str = include_str!("../../../../capi/include/gcv/gcv.h");

/// Adds what must hold of a struct in C: its size and the place of each field.
macro_rules! layout {
    ($c:ident, $name:ident: $($field:ident)*) => {
        let size = size_of::<$name>();
        writeln!($c, "_Static_assert(sizeof({}) == {size}, \"\");", stringify!($name)).unwrap();
        $(
            let (name, field) = (stringify!($name), stringify!($field));
            let value = MaybeUninit::<$name>::uninit();
            // SAFETY: the addresses are of one object; nothing is read.
            let place = unsafe { std::ptr::addr_of!((*value.as_ptr()).$field) };
            let offset = place as usize - value.as_ptr() as usize;
            writeln!($c, "_Static_assert(offsetof({name}, {field}) == {offset}, \"\");").unwrap();
        )*
    };
}

/// Adds what must hold of constants in C: their values.
macro_rules! values {
    ($c:ident, $($name:ident)*) => {
        $(writeln!($c, "_Static_assert({} == {}, \"\");", stringify!($name), $name).unwrap();)*
    };
}

#[test]
fn layouts_and_values() {
    let mut c = String::from("#include <gcv/gcv.h>\n");
    layout!(c, gcv_status:);
    layout!(c, gcv_options: struct_size rounding tolerance threads progress progress_context);
    layout!(c, gcv_edge_source: kind a b);
    layout!(c, gcv_stats: struct_size walk_steps candidate_edges predicates_filtered
        predicates_fixed_width predicates_rational vertices_repaired);
    layout!(c, gcv_superset_edge: x0 y0 x1 y1 source);
    values!(c, GCV_OK GCV_ERR_NULL_ARGUMENT GCV_ERR_INVALID_ARGUMENT GCV_ERR_NOT_FINITE
        GCV_ERR_DEGENERATE GCV_ERR_NOT_SIMPLE GCV_ERR_BUFFER_TOO_SMALL GCV_ERR_RANGE
        GCV_ERR_PARSE GCV_ERR_NO_MEMORY GCV_ERR_CANCELLED GCV_ERR_INTERNAL
        GCV_ROUND_NEAREST GCV_ROUND_OUTWARD
        GCV_EDGE_TRANSLATED GCV_EDGE_CORNER GCV_EDGE_TRANSLATED_CORNER);

    let mut compiler = Command::new("cc")
        .args(["-std=c11", "-fsyntax-only", "-x", "c", "-", "-I", INCLUDE])
        .stdin(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = compiler.stdin.take().unwrap();
    input.write_all(c.as_bytes()).unwrap();
    drop(input);
    assert!(compiler.wait().unwrap().success());
}

#[test]
fn every_function_is_declared() {
    let declarations = include_str!("../src/lib.rs");
    let prototypes: Vec<&str> = HEADER
        .split("\nGCV_API ")
        .skip(1)
        .map(|rest| rest.split('(').next().unwrap())
        .map(|head| &head[head.find("gcv_").unwrap()..])
        .collect();
    assert_eq!(prototypes.len(), declarations.matches("pub fn ").count());
    for prototype in prototypes {
        let name = prototype.rsplit([' ', '*']).next().unwrap();
        assert!(declarations.contains(&format!("pub fn {name}(")), "{name}");
    }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! The declarations against the header and the version script, by the C compiler where
//! it is about types.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::Write as _;
use std::mem::{size_of, MaybeUninit};
use std::process::{Command, Stdio};

use gcv_sys::*;

const INCLUDE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/libgcv/capi/include");
const HEADER: &str = include_str!("../libgcv/capi/include/gcv/gcv.h");
const MAP: &str = include_str!("../libgcv/capi/gcv.map");
const DECLARATIONS: &str = concat!(
    include_str!("../src/lib.rs"),
    include_str!("../src/region.rs"),
    include_str!("../src/scene.rs"),
    include_str!("../src/two_polygons.rs")
);

/// Whether the C compiler takes what is added to the header.
fn compiles(c: &str) -> bool {
    let mut compiler = Command::new("cc")
        .args([
            "-std=c11",
            "-Werror",
            "-fsyntax-only",
            "-x",
            "c",
            "-",
            "-I",
            INCLUDE,
        ])
        .stdin(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = compiler.stdin.take().unwrap();
    write!(input, "#include <gcv/gcv.h>\n{c}").unwrap();
    drop(input);
    compiler.wait().unwrap().success()
}

/// Adds what must hold of a struct in C: its size and the place of each field. The
/// pattern, with every field and no other, is not taken by rustc if one is left out.
macro_rules! layout {
    ($c:ident, $name:ident: $($field:ident)*) => {
        let _ = |$name { $($field: _),* }: $name| ();
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

#[test]
fn layouts() {
    let mut c = String::new();
    layout!(c, gcv_options: struct_size rounding tolerance threads progress progress_context
        leave_out);
    layout!(c, gcv_edge_source: kind a b);
    layout!(c, gcv_stats: struct_size walk_steps candidate_edges predicates_filtered
        predicates_fixed_width predicates_rational vertices_repaired parts_dropped);
    layout!(c, gcv_region_part: kind polygon vertex_count);
    layout!(c, gcv_contact: kind a b reserved id_a id_b gap normal on_a on_b);
    layout!(c, gcv_separation: distance relation reserved nearest);
    layout!(c, gcv_escape: depth translation position relation reserved contact);
    layout!(c, gcv_impact: hit relation time position contact);
    layout!(c, gcv_query: struct_size layers ignore ignore_count);
    layout!(c, gcv_pair: a b relation reserved);
    layout!(c, gcv_superset_edge: x0 y0 x1 y1 source);
    assert!(compiles(&c));

    let public = DECLARATIONS.matches("pub struct ").count();
    let opaque = DECLARATIONS.matches("marker: Opaque").count();
    assert_eq!(public - opaque, c.matches("sizeof").count());
}

/// The names and values of the constants of the crate that are numbers.
fn declared_constants() -> BTreeMap<&'static str, &'static str> {
    let constant = |line: &'static str| {
        let (name, rest) = line.strip_prefix("pub const ")?.split_once(": ")?;
        let (_, value) = rest.split_once(" = ")?;
        Some((name, value.strip_suffix(';')?))
    };
    DECLARATIONS.lines().filter_map(constant).collect()
}

/// The names and values of the enumerators of the header.
fn enumerators() -> BTreeMap<&'static str, &'static str> {
    let words: Vec<_> = HEADER.split_whitespace().collect();
    words
        .windows(3)
        .filter(|words| words[0].starts_with("GCV_") && words[1] == "=")
        .map(|words| (words[0], words[2].trim_end_matches(',')))
        .collect()
}

#[test]
fn constants() {
    let declared = declared_constants();
    let from_each_file = ["GCV_OK", "GCV_OUTSIDE", "GCV_OVERLAPPING"];
    assert!(from_each_file
        .iter()
        .all(|name| declared.contains_key(name)));
    assert_eq!(declared, enumerators());
    let asserted = |(name, value)| format!("_Static_assert({name} == {value}, \"\");\n");
    assert!(compiles(
        &declared.into_iter().map(asserted).collect::<String>()
    ));
}

#[test]
fn initialisers() {
    let size = size_of::<gcv_query>() as u32;
    let gcv_query {
        struct_size,
        layers,
        ignore,
        ignore_count,
    } = GCV_QUERY_INIT;
    assert_eq!((struct_size, layers, ignore_count), (size, u32::MAX, 0));
    assert!(ignore.is_null());
    let (_, initialiser) = HEADER.split_once("#define GCV_QUERY_INIT").unwrap();
    let words: Vec<_> = initialiser.split_whitespace().take(7).collect();
    let expected = "\\ { sizeof(gcv_query), UINT32_MAX, NULL, 0 }";
    assert_eq!(words.join(" "), expected);
}

/// A type of Rust in C.
fn in_c(rust: &str) -> String {
    if let Some(target) = rust.strip_prefix("*const ") {
        return in_c(target) + " const *";
    }
    if let Some(target) = rust.strip_prefix("*mut ") {
        return in_c(target) + " *";
    }
    match rust {
        "i8" => "int8_t",
        "i32" => "int32_t",
        "u32" => "uint32_t",
        "u64" => "uint64_t",
        "usize" => "size_t",
        "f64" => "double",
        "c_char" => "char",
        name => name,
    }
    .into()
}

/// Every function of the crate as a prototype of C.
fn prototypes() -> BTreeMap<&'static str, String> {
    let (_, functions) = DECLARATIONS.split_once("extern \"C\" {").unwrap();
    let prototype = |function: &'static str| {
        let (name, rest) = function.split_once('(').unwrap();
        let (parameters, rest) = rest.split_once(')').unwrap();
        let result = rest.split(';').next().unwrap().strip_prefix(" -> ");
        let types: Vec<_> = parameters
            .split(',')
            .filter_map(|parameter| parameter.split_once(": "))
            .map(|(_, rust)| in_c(rust))
            .collect();
        let types = if types.is_empty() {
            "void".into()
        } else {
            types.join(", ")
        };
        let result = result.map_or("void".into(), in_c);
        (name, format!("{result} {name}({types});\n"))
    };
    functions.split("pub fn ").skip(1).map(prototype).collect()
}

#[test]
fn functions_have_the_types_of_the_header() {
    let prototypes = prototypes();
    assert!(compiles(&prototypes.values().cloned().collect::<String>()));
    let wrong = prototypes["gcv_polygon_area"].replace("double", "float");
    assert!(!compiles(&wrong));
}

#[test]
fn functions_are_those_of_the_version_script() {
    let symbols = |node: &'static str| node.split(['}', ':']).next().unwrap().split(';');
    // A function of which there are two versions is in two nodes.
    let exported: BTreeSet<_> = MAP
        .split("global:")
        .skip(1)
        .flat_map(symbols)
        .map(str::trim)
        .filter(|name| !["", "local"].contains(name))
        .collect();
    assert_eq!(exported, prototypes().into_keys().collect());
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Finds libgcv: in the folder GCV_LIB_DIR, an absolute path, if that is set; else builds it where the
//! feature `vendored` asks for that, else by pkg-config.

use std::path::Path;

fn main() {
    println!("cargo:rerun-if-env-changed=GCV_LIB_DIR");
    match std::env::var("GCV_LIB_DIR") {
        Ok(folder) if !folder.is_empty() => link_with(&folder),
        _ => find(),
    }
}

/// Links with the shared library in a folder, or with the static one where there is no other. Ends
/// the build with a sentence where there is none.
fn link_with(folder: &str) {
    let has = |suffix| {
        Path::new(folder)
            .join("libgcv")
            .with_extension(suffix)
            .exists()
    };
    let is_shared = ["so", "dylib", "dll.a"].into_iter().any(has);
    if Path::new(folder).is_relative() {
        eprintln!("GCV_LIB_DIR is {folder:?}, which is no absolute path.");
        std::process::exit(1);
    }
    if !is_shared && !has("a") {
        eprintln!("GCV_LIB_DIR is {folder:?}, which has no libgcv.so and no libgcv.a. Set it to");
        eprintln!("the folder that has one of them, or unset it to find libgcv by pkg-config.");
        std::process::exit(1);
    }
    println!("cargo:rustc-link-search=native={folder}");
    if is_shared {
        println!("cargo:rustc-link-lib=gcv");
    } else {
        link_statically();
    }
}

fn link_statically() {
    println!("cargo:rustc-link-lib=static=gcv");
    println!("cargo:rustc-link-lib=stdc++");
}

/// Builds the library in `libgcv`, which is the root of the source tree, or a copy of
/// what the library needs of it.
#[cfg(feature = "vendored")]
fn find() {
    println!("cargo:rerun-if-changed=libgcv");
    let prefix = cmake::Config::new("libgcv")
        .profile("Release")
        .define("CMAKE_INSTALL_LIBDIR", "lib")
        .define("GCV_BUILD_EXAMPLES", "OFF")
        .define("GCV_BUILD_TESTS", "OFF")
        .build();
    println!("cargo:rustc-link-search=native={}/lib", prefix.display());
    link_statically();
}

#[cfg(not(feature = "vendored"))]
fn find() {
    let library = pkg_config::Config::new()
        .range_version("0.2".."1")
        .probe("gcv");
    if let Err(error) = library {
        eprintln!("libgcv was not found. Set GCV_LIB_DIR to its folder, or turn on the");
        eprintln!("feature `vendored`, which builds it. What pkg-config says:\n{error}");
        std::process::exit(1);
    }
}

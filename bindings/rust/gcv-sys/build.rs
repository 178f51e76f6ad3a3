// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Finds libgcv: in the folder GCV_LIB_DIR if that is set, else builds it where the
//! feature `vendored` asks for that, else by pkg-config.

use std::path::Path;

fn main() {
    println!("cargo:rerun-if-env-changed=GCV_LIB_DIR");
    match std::env::var("GCV_LIB_DIR") {
        Ok(folder) => {
            check(&folder);
            println!("cargo:rustc-link-search=native={folder}");
            println!("cargo:rustc-link-lib=gcv");
        }
        Err(_) => find(),
    }
}

/// Ends the build with a sentence where the folder has no libgcv to link with.
fn check(folder: &str) {
    let has = |suffix| {
        Path::new(folder)
            .join("libgcv")
            .with_extension(suffix)
            .exists()
    };
    if !["so", "a", "dylib", "dll.a"].into_iter().any(has) {
        eprintln!("GCV_LIB_DIR is {folder:?}, which has no libgcv.so and no libgcv.a. Set it to");
        eprintln!("the folder that has one of them, or unset it to find libgcv by pkg-config.");
        std::process::exit(1);
    }
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
    println!("cargo:rustc-link-lib=static=gcv");
    println!("cargo:rustc-link-lib=stdc++");
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

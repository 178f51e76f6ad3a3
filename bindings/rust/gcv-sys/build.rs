// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Finds libgcv: in the folder GCV_LIB_DIR if that is set, else builds it where the
//! feature `vendored` asks for that, else by pkg-config.

fn main() {
    println!("cargo:rerun-if-env-changed=GCV_LIB_DIR");
    match std::env::var("GCV_LIB_DIR") {
        Ok(folder) => {
            println!("cargo:rustc-link-search=native={folder}");
            println!("cargo:rustc-link-lib=gcv");
        }
        Err(_) => find(),
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
    println!("cargo:rustc-link-lib=gmp");
    println!("cargo:rustc-link-lib=stdc++");
}

#[cfg(not(feature = "vendored"))]
fn find() {
    let library = pkg_config::Config::new()
        .range_version("0.1".."1")
        .probe("gcv");
    if let Err(error) = library {
        eprintln!("libgcv was not found. Set GCV_LIB_DIR to its folder, or turn on the");
        eprintln!("feature `vendored`, which builds it. What pkg-config says:\n{error}");
        std::process::exit(1);
    }
}

// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later

//! Finds libgcv: in the folder GCV_LIB_DIR if that is set, else by pkg-config.

fn main() {
    println!("cargo:rerun-if-env-changed=GCV_LIB_DIR");
    if let Ok(folder) = std::env::var("GCV_LIB_DIR") {
        println!("cargo:rustc-link-search=native={folder}");
        println!("cargo:rustc-link-lib=gcv");
    } else if let Err(error) = pkg_config::Config::new()
        .range_version("0.1".."1")
        .probe("gcv")
    {
        eprintln!("libgcv was not found; set GCV_LIB_DIR to its folder, or:\n{error}");
        std::process::exit(1);
    }
}

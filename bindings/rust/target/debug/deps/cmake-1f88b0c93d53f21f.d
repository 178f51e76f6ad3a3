/work/main/bindings/rust/target/debug/deps/cmake-1f88b0c93d53f21f.d: /root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/cmake-0.1.54/src/lib.rs

/work/main/bindings/rust/target/debug/deps/libcmake-1f88b0c93d53f21f.rlib: /root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/cmake-0.1.54/src/lib.rs

/work/main/bindings/rust/target/debug/deps/libcmake-1f88b0c93d53f21f.rmeta: /root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/cmake-0.1.54/src/lib.rs

/root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/cmake-0.1.54/src/lib.rs:

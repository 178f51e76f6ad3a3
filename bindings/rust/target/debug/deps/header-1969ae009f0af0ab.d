/work/main/bindings/rust/target/debug/deps/header-1969ae009f0af0ab.d: gcv-sys/tests/header.rs gcv-sys/tests/../libgcv/capi/include/gcv/gcv.h gcv-sys/tests/../libgcv/capi/gcv.map gcv-sys/tests/../src/lib.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libheader-1969ae009f0af0ab.rmeta: gcv-sys/tests/header.rs gcv-sys/tests/../libgcv/capi/include/gcv/gcv.h gcv-sys/tests/../libgcv/capi/gcv.map gcv-sys/tests/../src/lib.rs Cargo.toml

gcv-sys/tests/header.rs:
gcv-sys/tests/../libgcv/capi/include/gcv/gcv.h:
gcv-sys/tests/../libgcv/capi/gcv.map:
gcv-sys/tests/../src/lib.rs:
Cargo.toml:

# env-dep:CARGO_MANIFEST_DIR=/work/main/bindings/rust/gcv-sys
# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

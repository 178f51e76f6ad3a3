/work/main/bindings/rust/target/debug/deps/gcv_sys-572e648696ebba9a.d: gcv-sys/src/lib.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libgcv_sys-572e648696ebba9a.rmeta: gcv-sys/src/lib.rs Cargo.toml

gcv-sys/src/lib.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

/work/main/bindings/rust/target/debug/deps/gcv_sys-08334dd4e0fd75a0.d: gcv-sys/src/lib.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libgcv_sys-08334dd4e0fd75a0.rmeta: gcv-sys/src/lib.rs Cargo.toml

gcv-sys/src/lib.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

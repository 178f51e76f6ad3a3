/work/main/bindings/rust/target/debug/deps/polygons-0e6e052ab4d7886c.d: gcv/tests/polygons.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libpolygons-0e6e052ab4d7886c.rmeta: gcv/tests/polygons.rs Cargo.toml

gcv/tests/polygons.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

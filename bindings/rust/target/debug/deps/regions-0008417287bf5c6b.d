/work/main/bindings/rust/target/debug/deps/regions-0008417287bf5c6b.d: gcv/tests/regions.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libregions-0008417287bf5c6b.rmeta: gcv/tests/regions.rs Cargo.toml

gcv/tests/regions.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

/work/main/bindings/rust/target/debug/deps/conversions-8c9cb4de3f4de221.d: gcv/tests/conversions.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libconversions-8c9cb4de3f4de221.rmeta: gcv/tests/conversions.rs Cargo.toml

gcv/tests/conversions.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

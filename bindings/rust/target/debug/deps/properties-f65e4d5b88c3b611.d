/work/main/bindings/rust/target/debug/deps/properties-f65e4d5b88c3b611.d: gcv/tests/properties.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libproperties-f65e4d5b88c3b611.rmeta: gcv/tests/properties.rs Cargo.toml

gcv/tests/properties.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

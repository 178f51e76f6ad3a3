/work/main/bindings/rust/target/debug/deps/sums-f68784c4bdc2d533.d: gcv/tests/sums.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libsums-f68784c4bdc2d533.rmeta: gcv/tests/sums.rs Cargo.toml

gcv/tests/sums.rs:
Cargo.toml:

# env-dep:CARGO_PKG_VERSION=0.2.0
# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

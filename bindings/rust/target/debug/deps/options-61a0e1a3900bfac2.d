/work/main/bindings/rust/target/debug/deps/options-61a0e1a3900bfac2.d: gcv/tests/options.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/liboptions-61a0e1a3900bfac2.rmeta: gcv/tests/options.rs Cargo.toml

gcv/tests/options.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

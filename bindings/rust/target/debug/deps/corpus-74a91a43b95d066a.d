/work/main/bindings/rust/target/debug/deps/corpus-74a91a43b95d066a.d: gcv/tests/corpus.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libcorpus-74a91a43b95d066a.rmeta: gcv/tests/corpus.rs Cargo.toml

gcv/tests/corpus.rs:
Cargo.toml:

# env-dep:CARGO_MANIFEST_DIR=/work/main/bindings/rust/gcv
# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

/work/main/bindings/rust/target/debug/examples/motion_planning-b23a8e84b4b25fc5.d: gcv/examples/motion_planning.rs Cargo.toml

/work/main/bindings/rust/target/debug/examples/libmotion_planning-b23a8e84b4b25fc5.rmeta: gcv/examples/motion_planning.rs Cargo.toml

gcv/examples/motion_planning.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

/work/main/bindings/rust/target/debug/deps/gcv-52bfe489f0318fcb.d: gcv/src/lib.rs gcv/src/call.rs gcv/src/error.rs gcv/src/exact.rs gcv/src/geo.rs gcv/src/handle.rs gcv/src/options.rs gcv/src/outer_face.rs gcv/src/point.rs gcv/src/polygon.rs gcv/src/region.rs gcv/src/regions.rs gcv/src/source.rs gcv/src/stats.rs gcv/src/sums.rs Cargo.toml

/work/main/bindings/rust/target/debug/deps/libgcv-52bfe489f0318fcb.rmeta: gcv/src/lib.rs gcv/src/call.rs gcv/src/error.rs gcv/src/exact.rs gcv/src/geo.rs gcv/src/handle.rs gcv/src/options.rs gcv/src/outer_face.rs gcv/src/point.rs gcv/src/polygon.rs gcv/src/region.rs gcv/src/regions.rs gcv/src/source.rs gcv/src/stats.rs gcv/src/sums.rs Cargo.toml

gcv/src/lib.rs:
gcv/src/call.rs:
gcv/src/error.rs:
gcv/src/exact.rs:
gcv/src/geo.rs:
gcv/src/handle.rs:
gcv/src/options.rs:
gcv/src/outer_face.rs:
gcv/src/point.rs:
gcv/src/polygon.rs:
gcv/src/region.rs:
gcv/src/regions.rs:
gcv/src/source.rs:
gcv/src/stats.rs:
gcv/src/sums.rs:
Cargo.toml:

# env-dep:CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
# env-dep:CLIPPY_CONF_DIR

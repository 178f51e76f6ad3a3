/work/main/bindings/rust/target/debug/deps/rand_xorshift-55b3bb42af65f8cc.d: /root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/rand_xorshift-0.3.0/src/lib.rs

/work/main/bindings/rust/target/debug/deps/librand_xorshift-55b3bb42af65f8cc.rmeta: /root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/rand_xorshift-0.3.0/src/lib.rs

/root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/rand_xorshift-0.3.0/src/lib.rs:

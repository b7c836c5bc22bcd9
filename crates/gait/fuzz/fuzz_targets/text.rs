//! Reads arbitrary bytes as a recording. Start from corpus/text: `cargo +nightly fuzz run text`.
#![no_main]

use std::path::Path;

use gaitcam_gait::{Feet, ReadOptions, cycle, read, stances};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Ok(r) = read(Path::new("fuzz"), bytes, &ReadOptions::default()) {
        let s = stances(&r);
        let _ = cycle(&r, &s, Feet::Both);
        let _ = cycle(&r, &s, Feet::One);
    }
});

//! Reads arbitrary bytes as one cycle of force. Start from corpus/cycle: `cargo +nightly fuzz run cycle`.
#![no_main]

use std::path::Path;

use gaitcam_gait::{Feet, ReadOptions, force_curve};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = force_curve(Path::new("fuzz"), bytes, &ReadOptions::default(), Feet::Both);
});

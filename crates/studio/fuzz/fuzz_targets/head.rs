//! Any bytes as the head of a request; start from corpus/head: `cargo +nightly fuzz run head`.
#![no_main]

use gaitcam_studio::head_length;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let Some(length) = head_length(bytes) else { return };
    // A head is a part of what was sent, and does not depend on what follows it.
    assert!((1..=bytes.len()).contains(&length));
    assert_eq!(head_length(&bytes[..length]), Some(length));
    assert_eq!(head_length(&bytes[..length - 1]), None);
});

//! Time to read and average a long recording. It should be linear in the length.

use std::fmt::Write as _;
use std::path::Path;

use gaitcam::force::{Feet, ReadOptions, cycle, read, stances};

fn main() {
    divan::main();
}

/// Recording of walking with `rows` rows at 1 kHz: time, left and right force.
fn walk(rows: usize) -> Vec<u8> {
    let foot = |i: usize, lead: usize| {
        let x = ((i + lead) % 1100) as f64 / 680.0;
        let a = std::f64::consts::PI * x;
        if x < 1.0 {
            700.0 * (a.sin() + 0.35 * (3.0 * a).sin())
        } else {
            0.0
        }
    };
    let mut text = String::from("time,fz_left,fz_right\n");
    for i in 0..rows {
        let _ = writeln!(
            text,
            "{}.{:03},{:.3},{:.3}",
            i / 1000,
            i % 1000,
            foot(i, 100),
            foot(i, 650)
        );
    }
    text.into_bytes()
}

/// Reads and averages one minute, ten minutes and one hour at 1 kHz.
#[divan::bench(args = [60_000, 600_000, 3_600_000], sample_count = 5, sample_size = 1)]
fn read_and_average(bencher: divan::Bencher, rows: usize) {
    let bytes = walk(rows);
    bencher.bench_local(|| {
        let r = read(Path::new("walk.csv"), &bytes, &ReadOptions::default()).unwrap();
        cycle(&r, &stances(&r), Feet::Both).unwrap()
    });
}

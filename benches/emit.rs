//! What the hand-over costs, file by file and together.

#[path = "../tests/designs/mod.rs"]
mod designs;

use divan::{Bencher, black_box};
use gaitcam::emit::{self, Timing};

fn main() {
    divan::main();
}

/// Everything `synth` writes by default: the budget is 350 ms.
#[divan::bench]
fn all_default_files(bencher: Bencher) {
    let s = designs::footbridge();
    bencher.bench(|| {
        let s = black_box(&s);
        let pictures = [
            emit::plots::svaj(s),
            emit::plots::force(s),
            emit::plots::cam(s),
        ];
        (
            emit::csv::law(s, 1440),
            emit::csv::profile(s, 1440),
            emit::json::summary(s, Timing::default()).to_string(),
            emit::dxf::profile(s, 1440),
            emit::svg::profile(s, 1440),
            pictures.each_ref().map(emit::plots::Picture::svg),
            pictures.each_ref().map(emit::plots::Picture::png),
            emit::report::html(s, Timing::default()),
        )
    });
}

#[divan::bench]
fn report(bencher: Bencher) {
    let s = designs::heel_tester();
    bencher.bench(|| emit::report::html(black_box(&s), Timing::default()));
}

#[divan::bench]
fn one_png(bencher: Bencher) {
    let s = designs::footbridge();
    bencher.bench(|| emit::plots::force(black_box(&s)).png());
}

#[divan::bench(args = [1e-4, 1e-5, 1e-6])]
fn arcs(bencher: Bencher, tolerance: f64) {
    let s = designs::heel_tester();
    bencher.bench(|| emit::biarc::fit(black_box(&s.cam), tolerance));
}

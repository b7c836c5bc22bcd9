//! Time to write the files, one by one and together.

use divan::{Bencher, black_box};
use gaitcam_output::{self, Timing};
use gaitcam_test_support::designs;

fn main() {
    divan::main();
}

/// All files that `synth` writes by default. Required: 350 ms.
#[divan::bench]
fn all_default_files(bencher: Bencher) {
    let s = designs::footbridge();
    bencher.bench(|| {
        let s = black_box(&s);
        let pictures = [
            gaitcam_output::plots::svaj(s, gaitcam_output::Language::En),
            gaitcam_output::plots::force(s, gaitcam_output::Language::En),
            gaitcam_output::plots::cam(s, gaitcam_output::Language::En),
        ];
        (
            gaitcam_output::csv::law(s, 1440),
            gaitcam_output::csv::profile(s, 1440),
            gaitcam_output::json::summary(s, Timing::default()).to_string(),
            gaitcam_cad::dxf::profile(
                s,
                1440,
                gaitcam_cad::dxf::Content::All,
                gaitcam_cad::dxf::Curves::Arcs,
                gaitcam_cad::Units::Millimetres,
            ),
            gaitcam_cad::svg::profile(s, 1440),
            pictures.each_ref().map(gaitcam_output::plots::Picture::svg),
            pictures.each_ref().map(gaitcam_output::plots::Picture::png),
            gaitcam_output::report::html(s, Timing::default(), gaitcam_output::Language::En),
        )
    });
}

#[divan::bench]
fn report(bencher: Bencher) {
    let s = designs::heel_tester();
    bencher.bench(|| {
        gaitcam_output::report::html(
            black_box(&s),
            Timing::default(),
            gaitcam_output::Language::En,
        )
    });
}

#[divan::bench]
fn one_png(bencher: Bencher) {
    let s = designs::footbridge();
    bencher
        .bench(|| gaitcam_output::plots::force(black_box(&s), gaitcam_output::Language::En).png());
}

#[divan::bench(args = [1e-4, 1e-5, 1e-6])]
fn arcs(bencher: Bencher, tolerance: f64) {
    let s = designs::heel_tester();
    bencher.bench(|| gaitcam_cad::biarc::fit(black_box(&s.cam), tolerance));
}

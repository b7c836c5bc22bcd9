//! Figures of the cam are complete, have the correct size, and nothing is clipped.

use gaitcam::criterion::LimitKind;
use gaitcam_output::Language;

use gaitcam_test_support::designs::{footbridge, heel_tester};
use gaitcam_test_support::readers::elements;

#[test]
fn pictures_are_whole_and_nothing_is_cut_off() {
    for s in [footbridge(), heel_tester()] {
        for picture in [
            gaitcam_output::plots::svaj(&s, Language::En),
            gaitcam_output::plots::force(&s, Language::En),
            gaitcam_output::plots::cam(&s, Language::En),
        ] {
            assert_eq!(elements(&picture.svg())[0], "svg");
            let bytes = picture.png();
            let mut reader = zune_png::PngDecoder::new(&bytes);
            let pixels = reader.decode_raw().unwrap();
            assert_eq!(reader.get_dimensions(), Some((1200, 800)));
            assert_eq!(pixels.len(), 3 * 1200 * 800);
            let blank = |x: usize, y: usize| pixels[3 * (1200 * y + x)..][..3] == [255; 3];
            // Ink in the middle, a blank edge all around.
            assert!((0..800).any(|y| (0..1200).any(|x| !blank(x, y))));
            for x in 0..1200 {
                assert!(
                    (0..5).all(|k| blank(x, k) && blank(x, 799 - k)),
                    "edge at x {x}"
                );
            }
            for y in 0..800 {
                assert!(
                    (0..5).all(|k| blank(k, y) && blank(1199 - k, y)),
                    "edge at y {y}"
                );
            }
        }
    }
}

#[test]
fn the_colours_of_a_limited_contact_pressure_reach_the_maximum_of_the_check() {
    let plain = gaitcam_output::plots::cam(&footbridge(), Language::En).svg();
    assert!(!plain.contains("contact pressure"));
    let set = [
        "cam.follower=roller-translating",
        "cam.roller_radius=10 mm",
        "limits.hertz_pressure=900 MPa",
    ];
    let design = gaitcam_test_support::design(gaitcam::scene::DEFAULT, &set).unwrap();
    let highest = design
        .checks
        .iter()
        .find(|c| c.name == LimitKind::HertzPressure);
    let highest = 1e-6 * highest.unwrap().worst;
    let svg = gaitcam_output::plots::cam(&design, Language::En).svg();
    let shown = svg.split("contact pressure ").nth(1).unwrap();
    let shown = shown
        .split(" … ")
        .nth(1)
        .unwrap()
        .split(" MPa")
        .next()
        .unwrap();
    let shown: f64 = shown.parse().unwrap();
    assert!(
        (shown / highest - 1.0).abs() <= 5e-4,
        "{shown} and {highest} MPa"
    );
}

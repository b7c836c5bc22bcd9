//! Pictures of the cam: whole, of the right size, with nothing cut off.

use gaitcam_output::Language;

use crate::designs::{footbridge, heel_tester, impossible};
use crate::readers::{attribute, elements};

#[test]
fn profile_svg_is_as_large_as_the_cam() {
    for s in [footbridge(), heel_tester(), impossible()] {
        let svg = gaitcam_output::svg::profile(&s, 1440);
        let all = elements(&svg);
        assert_eq!(all[0], "svg");
        let width: f64 = attribute(&svg, "width")
            .strip_suffix("mm")
            .unwrap()
            .parse()
            .unwrap();
        let view: Vec<f64> = attribute(&svg, "viewBox")
            .split(' ')
            .map(|x| x.parse().unwrap())
            .collect();
        assert_eq!(width, view[2]);
        let rows = s.cam.profile(1440);
        let (left, right) = rows.iter().fold((0.0_f64, 0.0_f64), |(l, r), p| {
            (l.min(p.pitch_x), r.max(p.pitch_x))
        });
        let prime = s.cam.follower.prime_radius();
        let extent = 1000.0 * (right.max(prime) - left.min(-prime)) + 10.0;
        assert!((width - extent).abs() < 1e-3);
        let path = svg.split("id=\"profile\" d=\"").nth(1).unwrap();
        let path = path.split('"').next().unwrap();
        assert!(path.ends_with('Z') && path.matches('L').count() == 1439);
    }
}

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

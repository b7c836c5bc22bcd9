//! Equal designs result in equal bytes, and unusual designs in complete files.

use gaitcam::cam::Bore;
use gaitcam_cad::Units;
use gaitcam_cad::dxf::{self, Content, Curves};
use gaitcam_cad::solid::{self, Plate};
use gaitcam_cad::{biarc, cutter, svg};
use gaitcam_test_support::designs::{heel_tester, odd_ones};
use gaitcam_test_support::readers::elements;

use crate::drawing::read;

fn form(bore: f64, points: usize) -> Plate {
    Plate {
        thickness: 0.01,
        bore: Some(Bore::plain(bore)),
        points,
    }
}

#[test]
fn the_same_design_gives_the_same_bytes() {
    let s = heel_tester();
    let files = || {
        [
            dxf::profile(&s, 360, Content::All, Curves::Arcs, Units::Millimetres),
            solid::threemf(&s, form(0.02, 360)).unwrap(),
        ]
    };
    assert!(files() == files());
}

#[test]
fn odd_designs_are_handed_over_without_fault() {
    for s in odd_ones() {
        let drawing = read(&dxf::profile(
            &s,
            100,
            Content::All,
            Curves::Arcs,
            Units::Millimetres,
        ));
        assert_eq!(drawing.outline("CUT_PROFILE").1, s.cam.law.is_closed());
        elements(&svg::profile(&s, 100));
        assert_eq!(
            solid::stl(&s, form(0.01, 100)).is_ok(),
            s.cam.law.is_closed()
        );
        assert!(cutter::path(&s, 0.005, 100).is_ok());
        let arcs = biarc::fit(&s.cam, 1e-5).unwrap();
        assert_eq!(arcs.closed, s.cam.law.is_closed());
    }
}

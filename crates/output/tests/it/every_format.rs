//! What holds for every format: equal designs give equal bytes, and odd designs give whole files.

use gaitcam::cam::{Bore, Follower};
use gaitcam::law::Law;
use gaitcam::poly::PiecewisePoly;
use gaitcam::synth::Design;
use gaitcam_output::dxf::Content;
use gaitcam_output::solid::{self, Plate};
use gaitcam_output::{Language, biarc, cutter};

use crate::TIME;
use crate::designs::{footbridge, heel_tester};
use crate::drawing::read;
use crate::readers::{elements, table};

#[test]
fn the_same_design_gives_the_same_bytes() {
    let s = heel_tester();
    let form = Plate {
        thickness: 0.01,
        bore: Some(Bore::plain(0.02)),
        points: 360,
    };
    let files = || {
        [
            gaitcam_output::dxf::profile(&s, 360, Content::All),
            gaitcam_output::plots::cam(&s, Language::En).png(),
            gaitcam_output::report::html(&s, TIME, Language::En).into_bytes(),
            gaitcam_output::xlsx::workbook(&s, TIME, Language::En).unwrap(),
            solid::threemf(&s, form).unwrap(),
        ]
    };
    assert!(files() == files());
}

/// Designs at the edge of what there is: no lift at all, a knife edge, an open law, no target.
fn odd_ones() -> Vec<Design> {
    let mut still = footbridge();
    still.cam.law = Law::harmonic(0.0, &[]);
    let mut knife = heel_tester();
    knife.cam.follower = Follower::RollerTranslating {
        prime_radius: 0.06,
        offset: 0.01,
        roller_radius: 0.0,
    };
    knife.target = None;
    let mut open = footbridge();
    let rise = PiecewisePoly::new(vec![0.5, 2.0], 3, vec![0.0, 0.0, 0.01, 0.01]);
    open.cam.law = Law::from_poly(rise, false);
    open.name = String::new();
    vec![still, knife, open]
}

#[test]
fn odd_designs_are_handed_over_without_fault() {
    for s in odd_ones() {
        assert_eq!(table(&gaitcam_output::csv::law(&s, 100)).1.len(), 100);
        assert_eq!(table(&gaitcam_output::csv::profile(&s, 100)).1.len(), 100);
        let drawing = gaitcam_output::dxf::profile(&s, 100, Content::All);
        let drawing = read(&drawing);
        assert_eq!(drawing.outline("CUT_PROFILE").1, s.cam.law.is_closed());
        elements(&gaitcam_output::svg::profile(&s, 100));
        for picture in [
            gaitcam_output::plots::svaj(&s, Language::En),
            gaitcam_output::plots::force(&s, Language::En),
            gaitcam_output::plots::cam(&s, Language::En),
        ] {
            let svg = picture.svg();
            elements(&svg);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
            assert!(picture.png().len() > 1000);
        }
        let html = gaitcam_output::report::html(&s, TIME, Language::En);
        elements(&html);
        assert!(!html.contains("NaN"));
        assert!(gaitcam_output::xlsx::workbook(&s, TIME, Language::En).is_ok());
        let form = Plate {
            thickness: 0.01,
            bore: Some(Bore::plain(0.01)),
            points: 100,
        };
        assert_eq!(solid::stl(&s, form).is_ok(), s.cam.law.is_closed());
        assert!(cutter::path(&s, 0.005, 100).is_ok());
        let arcs = biarc::fit(&s.cam, 1e-5).unwrap();
        assert_eq!(arcs.closed, s.cam.law.is_closed());
    }
}

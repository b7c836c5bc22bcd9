//! Properties of every format: equal designs lead to equal bytes, and unusual designs to complete files.

use gaitcam_output::Language;
use gaitcam_test_support::designs::{heel_tester, odd_ones};
use gaitcam_test_support::readers::{elements, table};

use crate::TIME;

#[test]
fn the_same_design_gives_the_same_bytes() {
    let s = heel_tester();
    let files = || {
        [
            gaitcam_output::plots::cam(&s, Language::En).png(),
            gaitcam_output::report::html(&s, TIME, Language::En).into_bytes(),
            gaitcam_output::xlsx::workbook(&s, TIME, Language::En).unwrap(),
        ]
    };
    assert!(files() == files());
}

#[test]
fn odd_designs_are_handed_over_without_fault() {
    for s in odd_ones() {
        assert_eq!(table(&gaitcam_output::csv::law(&s, 100)).1.len(), 100);
        assert_eq!(table(&gaitcam_output::csv::profile(&s, 100)).1.len(), 100);
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
    }
}

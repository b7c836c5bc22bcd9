//! Infeasible limits for which no small change is sufficient are reported as such.

use super::relaxations::{HUMP, assignment, good};
use gaitcam::synth::{Reason, synthesise};
use gaitcam_test_support::scene_of;

/// Limits a hundred times below those of any law. A common factor for all limits is no useful advice; the two values are.
#[test]
fn limits_out_of_reach_are_told_by_themselves() {
    let changes = ["limits.velocity=0.0004 m/s", "limits.face_width=0.1 mm"];
    let scene = scene_of(HUMP, &changes);
    let design = synthesise(&scene, None).unwrap().relaxed();
    let Some(Reason::FarTogether { changes }) = design.reasons.last() else {
        panic!("{}", design.reason(gaitcam::wording::Language::En));
    };
    assert_eq!(changes.len(), 2, "{changes:?}");
    let settings: Vec<String> = (design.together.iter())
        .map(|r| assignment(r.limit.name(), r.to.unwrap()))
        .collect();
    let all: Vec<&str> = settings.iter().map(String::as_str).collect();
    assert!(good(&synthesise(&scene_of(HUMP, &all), None).unwrap()));
    // One of them a hair tighter is too tight.
    let tight = &design.together[0];
    let tight = assignment(tight.limit.name(), 0.98 * tight.to.unwrap());
    let pair = [tight.as_str(), all[1]];
    assert!(!good(&synthesise(&scene_of(HUMP, &pair), None).unwrap()));
}

/// A single sufficient change by a factor of 100 is reported as large.
#[test]
fn a_hundredfold_relaxation_is_said_to_be_large() {
    let scene = scene_of(HUMP, &["limits.velocity=0.0004 m/s"]);
    let design = synthesise(&scene, None).unwrap().relaxed();
    let far = matches!(design.reasons.last(), Some(Reason::FarRelaxations { .. }));
    assert!(far, "{}", design.reason(gaitcam::wording::Language::En));
}

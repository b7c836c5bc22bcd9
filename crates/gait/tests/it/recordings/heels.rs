//! Feet and stride times from the heel markers of C3D files, compared with the events in the files and the README.

use std::path::Path;

use super::{middle, open};
use gaitcam_gait::{Feet, Foot, PeriodSource, Recording, Stance, cycle, stances};

/// Files with heel markers and marked heel strikes.
const MARKED: [&str; 5] = [
    "c3d/HC002D06.c3d",
    "c3d/HC030A05.c3d",
    "c3d/HC032A03.c3d",
    "c3d/PiG_Motion3_FF.c3d",
    "c3d/treadmill_events.c3d",
];

/// Stances of a recording, with the feet determined only by the heel markers.
fn by_heels(r: &Recording) -> Vec<Stance> {
    let mut unmarked = r.clone();
    unmarked.strikes.clear();
    stances(&unmarked).used
}

pub fn heel_markers_name_the_feet_that_the_events_name(folder: &Path) {
    let mut compared = 0;
    for file in MARKED {
        let (r, s) = open(folder, file);
        for (marked, heels) in s.used.iter().zip(by_heels(&r)) {
            assert!(marked.foot.is_some(), "{file}");
            assert_eq!(marked.foot, heels.foot, "{file} at {} s", marked.start_s);
            compared += 1;
        }
    }
    assert_eq!(compared, 16);
    // The two of other laboratories, without events: one foot after the other.
    for file in ["c3d/Gait.c3d", "c3d/walking2.c3d"] {
        let (r, _) = open(folder, file);
        let [first, second] = &by_heels(&r)[..] else {
            panic!("{file}");
        };
        assert_eq!(first.foot.map(Foot::other), second.foot, "{file}");
        assert!(first.foot.is_some(), "{file}");
    }
}

pub fn heel_markers_give_the_stride_that_the_events_give(folder: &Path) {
    for file in &MARKED[3..] {
        let (r, _) = open(folder, file);
        let of = |foot: Foot| -> Vec<f64> {
            let own = r.strikes.iter().filter(|k| k.foot == foot);
            own.map(|k| k.at_s).collect()
        };
        let times = [of(Foot::Left), of(Foot::Right)];
        let strides = times.iter().flat_map(|t| t.windows(2).map(|w| w[1] - w[0]));
        let marked = middle(strides.collect());
        let heels = middle(r.heels.as_ref().unwrap().strides_s());
        assert!(
            (heels / marked - 1.0).abs() < 0.005,
            "{file}: {heels} {marked}"
        );
    }
    // One stance of each foot is on record, so that the force gives no stride.
    let (r, s) = open(folder, MARKED[0]);
    let period = cycle(&r, &s, Feet::Both).unwrap().period;
    assert_eq!(period.from, PeriodSource::HeelMarkers);
    assert!((period.seconds - 0.9138).abs() < 0.01, "{period:?}");
}

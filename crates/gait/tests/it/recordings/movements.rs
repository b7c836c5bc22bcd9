//! Recordings other than plain walking: a jump, a run, belts that feet cross.

use std::path::Path;

use gaitcam_gait::units::G;
use gaitcam_gait::{
    CycleSource, Feet, Foot, Kind, MassSource, Note, ReadOptions, Stance, cycle, read, stances,
};

use super::{middle, open};

const EVERY_FEET: [Feet; 5] = Feet::ALL;

/// The weight of a person who stands on the plate before the jump is not an offset of the plate.
pub fn a_person_who_jumps_is_not_tared_away(folder: &Path) {
    let (r, s) = open(folder, "text/jump1.txt");
    assert_eq!(s.recognised, Some(Kind::Jumping));
    assert_eq!(r.channels[0].baseline_n.round(), 0.0);
    // README: a person of about 70 kg stands on the plate, 691 N.
    let quiet = (2.0 * r.rate_hz) as usize..(4.0 * r.rate_hz) as usize;
    let stands = middle(r.channels[0].force_n[quiet].to_vec());
    assert!((stands / 691.0 - 1.0).abs() < 0.02, "{stands} N");
    for feet in EVERY_FEET {
        let refused = cycle(&r, &s, feet).unwrap_err();
        assert_eq!(refused.code(), "force-not-walking", "{feet:?}");
    }
}

/// README: running, contacts of about 0.3 s, flight phases. If it is read as walking, it results in 119.9 kg and 0.42 s.
pub fn running_is_named_and_read_when_asked_for(folder: &Path) {
    let file = "opensim/grf_run.mot";
    let (r, s) = open(folder, file);
    assert_eq!(s.recognised, Some(Kind::Running));
    for feet in [Feet::Both, Feet::One, Feet::Left, Feet::Right] {
        let refused = cycle(&r, &s, feet).unwrap_err();
        assert_eq!(refused.code(), "force-running", "{feet:?}");
    }
    let path = folder.join(file);
    let asked = ReadOptions {
        kind: Some(Kind::Running),
        ..ReadOptions::default()
    };
    let r = read(&path, &std::fs::read(&path).unwrap(), &asked).unwrap();
    let s = stances(&r);
    let [right, left] = &s.used[..] else {
        panic!("{s:?}")
    };
    assert_eq!(
        (right.foot, left.foot),
        (Some(Foot::Right), Some(Foot::Left))
    );
    assert!(left.start_s - right.end_s > 0.05, "a flight");
    for stance in &s.used {
        assert!((0.2..0.35).contains(&stance.duration_s()), "{stance:?}");
    }
    let both = cycle(&r, &s, Feet::Both).unwrap();
    let step = left.start_s - right.start_s;
    assert!((both.curve.period_s / (2.0 * step) - 1.0).abs() < 1e-6);
    // Over a stride the two impulses carry the weight.
    let impulses = left.impulse_ns + right.impulse_ns;
    assert!((both.mass_kg / (impulses / (2.0 * step * G)) - 1.0).abs() < 0.02);
    let one = cycle(&r, &s, Feet::One).unwrap();
    assert!(
        (one.mass_kg / both.mass_kg - 1.0).abs() < 0.05,
        "{}",
        one.mass_kg
    );
}

/// README: undisturbed stances have a P1 of 555 to 581 N and a duration of 0.73 s. Five contacts of 0.82 to 1.03 s include both feet.
pub fn belts_that_feet_cross_are_summed(folder: &Path) {
    let (r, s) = open(folder, "c3d/treadmill_events.c3d");
    // The README counts 17 strikes, the events of the file are 22; they alternate.
    assert!(r.strikes.windows(2).all(|w| w[0].foot != w[1].foot));
    let alike: Vec<&Stance> = s.used.iter().filter(|s| !s.unlike).collect();
    assert!(alike.len() >= 6);
    for stance in &alike {
        assert!((stance.duration_s() - 0.73).abs() < 0.02, "{stance:?}");
    }
    let peak = middle(alike.iter().map(|s| s.p1.force_n).collect());
    assert!((555.0..=581.0).contains(&peak), "{peak} N");
    let one = cycle(&r, &s, Feet::One).unwrap();
    assert_eq!(one.averaged, alike.len());
    // Strides by the strikes that the file marks, which the sum of the belts does not use.
    let of = |foot: Foot| -> Vec<f64> {
        let own = r.strikes.iter().filter(|s| s.foot == foot);
        own.map(|s| s.at_s).collect()
    };
    let marked: Vec<f64> = [of(Foot::Left), of(Foot::Right)]
        .iter()
        .flat_map(|at| at.windows(2).map(|w| w[1] - w[0]).collect::<Vec<f64>>())
        .collect();
    let stride = marked.iter().sum::<f64>() / marked.len() as f64;
    let both = cycle(&r, &s, Feet::Both).unwrap();
    assert!(matches!(both.source, CycleSource::TotalForce { strides } if strides >= 8));
    assert!(both.notes.contains(&Note::PlatesSummed { plates: 2 }));
    let period = both.curve.period_s;
    assert!(
        (period / stride - 1.0).abs() < 0.01,
        "{period} s, marked {stride} s"
    );
    assert_eq!(both.mass_from, MassSource::File);
    let weight = both.mass_kg * G;
    assert!((both.curve.mean_n() / weight - 1.0).abs() < 0.03);
}

//! Recordings on plates: mass, rate, stances and peaks.

use std::path::Path;

use gaitcam_gait::units::G;
use gaitcam_gait::{RejectReason, Stance, stances};

use super::{both, highest, open, slivers};

/// Channel, number of whole stances, and their maximum force as recorded, N.
type Row<'a> = (&'a str, usize, f64);

/// Row for each file: mass in the file, samples per second, plates in the order of the file with stances and maximum force, and number of stances
/// that the recording cuts.
#[allow(clippy::type_complexity)]
const TABLE: &[(&str, Option<f64>, f64, &[Row], usize)] = &[
    // Peaks in BW of the README times the mass it names.
    (
        "opensim/grf_walk_2000hz.mot",
        None,
        2000.0,
        &[
            ("ground_force_r_vy", 2, 1.12 * 85.3 * G),
            ("ground_force_l_vy", 1, 1.12 * 85.3 * G),
        ],
        0,
    ),
    (
        "opensim/std_walking2_grfs.sto",
        None,
        20.02,
        // 948 and 756 N are both peaks of the first plate; the second reaches 741 N.
        &[("f1_3", 1, 948.0), ("f2_3", 1, 741.0)],
        0,
    ),
    (
        "opensim/subject01_walk1_grf.mot",
        None,
        600.0,
        &[
            ("ground_force_vy", 1, 1.08 * 72.6 * G),
            ("1_ground_force_vy", 2, 1.14 * 72.6 * G),
        ],
        1,
    ),
    (
        "c3d/walking2.c3d",
        None,
        2000.0,
        &[("plate 1 Fz1", 1, 951.0), ("plate 2 Fz2", 1, 744.0)],
        0,
    ),
    (
        "c3d/Gait.c3d",
        None,
        1000.0,
        &[("plate 1", 1, 799.0), ("plate 2", 1, 855.0)],
        0,
    ),
    (
        "c3d/HC002D06.c3d",
        Some(32.1),
        1000.0,
        &[
            ("plate 1 Fz1", 1, 1.19 * 32.1 * G),
            ("plate 2 Fz2", 1, 1.25 * 32.1 * G),
        ],
        0,
    ),
    (
        "c3d/HC030A05.c3d",
        Some(45.8),
        1000.0,
        &[
            ("plate 1 Fz1", 1, 1.12 * 45.8 * G),
            ("plate 2 Fz2", 1, 1.07 * 45.8 * G),
        ],
        0,
    ),
    (
        "c3d/HC032A03.c3d",
        Some(60.3),
        1000.0,
        &[
            ("plate 1 Fz1", 1, 1.15 * 60.3 * G),
            ("plate 2 Fz2", 1, 1.04 * 60.3 * G),
        ],
        0,
    ),
    (
        "c3d/PiG_Motion3_FF.c3d",
        Some(74.0),
        1000.0,
        &[
            ("plate 1 Fz1", 1, 1.09 * 74.0 * G),
            ("plate 2 Fz2", 1, 1.13 * 74.0 * G),
            ("plate 3 Fz3", 1, 1.14 * 74.0 * G),
        ],
        0,
    ),
    (
        "c3d/ADemo1_pc_float.c3d",
        None,
        400.0,
        &[("plate 1", 1, 656.0)],
        0,
    ),
    (
        "c3d/ADemo1_pc_integer.c3d",
        None,
        400.0,
        &[("plate 1", 1, 656.0)],
        0,
    ),
    (
        "text/walk1.forces",
        None,
        450.0,
        &[("FY3", 1, 836.0), ("FY5", 1, 802.0), ("FY6", 1, 850.0)],
        1,
    ),
    (
        "text/BiomecII2018_gait_n.txt",
        None,
        150.0,
        &[("Fy", 1, 773.0)],
        0,
    ),
    (
        "text/Trial1-FxFyFzMxMyMz.asc",
        None,
        200.0,
        &[("column 4", 1, 930.0)],
        0,
    ),
    (
        "text/HC038A11_decimal_comma.csv",
        Some(56.8),
        1000.0,
        &[
            ("Platte 1 Fz", 1, 1.08 * 56.8 * G),
            ("Platte 2 Fz", 1, 1.10 * 56.8 * G),
        ],
        0,
    ),
];

pub fn stances_mass_rate_and_peaks_are_those_of_the_readme(folder: &Path) {
    for (file, mass, rate, plates, cut) in TABLE {
        let (r, s) = open(folder, file);
        assert!(
            (r.rate_hz / rate - 1.0).abs() < 1e-3,
            "{file}: {} Hz",
            r.rate_hz
        );
        match (mass, r.mass_kg) {
            (Some(m), Some(got)) => assert!((got - m).abs() < 0.01, "{file}: {got} kg"),
            (m, got) => assert_eq!(*m, got, "{file}"),
        }
        let whole: usize = plates.iter().map(|p| p.1).sum();
        assert_eq!(s.used.len(), whole, "{file}: {:?}", s.rejected);
        let is_cut =
            |r: RejectReason| matches!(r, RejectReason::CutAtStart | RejectReason::CutAtEnd);
        assert_eq!(
            s.rejected.iter().filter(|x| is_cut(x.reason)).count(),
            *cut,
            "{file}"
        );
        let others = s.rejected.len() - slivers(&s);
        assert_eq!(others, *cut, "{file}: {:?}", s.rejected);
        let weight = both(&r, &s).mass_kg * G;
        for (name, count, peak) in *plates {
            let i = r
                .channels
                .iter()
                .position(|c| c.name == *name)
                .unwrap_or_else(|| panic!("{file} lacks {name}"));
            let mine: Vec<&Stance> = s.used.iter().filter(|s| s.channel == i).collect();
            assert_eq!(mine.len(), *count, "{file} {name}");
            let got =
                mine.iter().map(|s| highest(s)).fold(0.0, f64::max) + r.channels[i].baseline_n;
            assert!(
                (got - peak).abs() < 0.01 * weight,
                "{file} {name}: {got:.1} N, README {peak:.1} N"
            );
        }
    }
}

/// Each pair of consecutive stances of a long walk, alone on two plates. Two masses are compared: from the force while both feet are recorded, and
/// from the impulse of both over a doubled step.
pub fn two_stances_in_turn_weigh_the_walker(folder: &Path) {
    let (r, s) = open(folder, "opensim/subject01_walk1_grf_15s_oldheader.mot");
    let (mut window, mut doubled, mut count) = (0.0, 0.0, 0.0);
    for pair in s.used.windows(2) {
        let mut alone = r.clone();
        let forces = alone.channels.iter_mut().map(|c| &mut c.force_n);
        for (channel, force) in forces.enumerate() {
            for (i, x) in force.iter_mut().enumerate() {
                let t = i as f64 / r.rate_hz;
                let of = |s: &Stance| s.channel == channel && s.start_s <= t && t <= s.end_s;
                *x = if pair.iter().any(of) { *x } else { 0.0 };
            }
        }
        let mean = both(&alone, &stances(&alone));
        window += (mean.mass_kg / 72.6 - 1.0).powi(2);
        doubled += (mean.curve.mean_n() / (72.6 * G) - 1.0).powi(2);
        count += 1.0;
    }
    let [window, doubled] = [window, doubled].map(|sum: f64| 100.0 * (sum / count).sqrt());
    println!(
        "mass of {count} pairs: window {window:.2} %, impulse over a doubled step {doubled:.2} %"
    );
    assert!(count > 15.0 && window < 0.5 && window < 0.5 * doubled);
}

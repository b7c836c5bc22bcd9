//! Tests of the peaks P1 and P2 and of the valley V of stances.

use std::path::Path;

use gaitcam_gait::units::G;

use super::{both, open};

/// Forces as recorded (N) and positions (%) of P1, V and P2 of one stance; `None` if the README does not contain the point.
type Landmarks = [Option<(f64, f64)>; 3];

/// A position that the README does not contain.
const NOT_SAID: f64 = f64::NAN;

const fn n(force: f64, at: f64) -> Option<(f64, f64)> {
    Some((force, at))
}

/// File, number of the stance, and its values in the README.
const ROWS: &[(&str, usize, Landmarks)] = &[
    (
        "c3d/ADemo1_pc_float.c3d",
        0,
        [n(619.0, 23.0), n(412.0, 47.0), n(656.0, 79.0)],
    ),
    (
        "text/BiomecII2018_gait_n.txt",
        0,
        [n(714.0, 24.0), n(553.0, 43.0), n(773.0, 79.0)],
    ),
    (
        "text/Trial1-FxFyFzMxMyMz.asc",
        0,
        [n(930.0, 27.0), n(767.0, 45.0), n(914.0, 70.0)],
    ),
    (
        "opensim/grf_walk_2000hz.mot",
        0,
        [
            n(1.09 * 85.3 * G, 28.0),
            n(0.72 * 85.3 * G, 49.0),
            n(1.12 * 85.3 * G, 75.0),
        ],
    ),
    // The README gives both peaks of the C3D plates as recorded, offset and all.
    (
        "c3d/walking2.c3d",
        1,
        [n(951.0, NOT_SAID), None, n(779.0, NOT_SAID)],
    ),
    (
        "c3d/walking2.c3d",
        0,
        [n(540.0, NOT_SAID), None, n(744.0, NOT_SAID)],
    ),
    (
        "opensim/grf_walk_2000hz.mot",
        1,
        [
            n(1.09 * 85.3 * G, 28.0),
            n(0.78 * 85.3 * G, 49.0),
            n(1.12 * 85.3 * G, 75.0),
        ],
    ),
];

pub fn peaks_and_valleys_lie_where_the_readme_says(folder: &Path) {
    for (file, index, landmarks) in ROWS {
        let (r, s) = open(folder, file);
        let weight = both(&r, &s).mass_kg * G;
        let stance = &s.used[*index];
        let base = r.channels[stance.channel].baseline_n;
        let got = [Some(stance.p1), stance.valley, stance.p2];
        for (k, wanted) in landmarks.iter().enumerate() {
            let Some((force, at)) = wanted else { continue };
            let Some(p) = got[k] else {
                panic!("{file}: {stance:?}")
            };
            assert!(
                (p.force_n + base - force).abs() <= 0.01 * weight,
                "{file} landmark {k}: {:.1} N, README {force:.1}",
                p.force_n + base
            );
            assert!(
                at.is_nan() || (100.0 * p.at - at).abs() <= 3.0,
                "{file} landmark {k}: {:.1} %, README {at}",
                100.0 * p.at
            );
        }
    }
}
pub fn every_landmark_the_readme_gives_as_a_range_lies_in_it(folder: &Path) {
    // File, mass the README names (kg; 1/g where it gives newtons), and P1, V, P2 as ranges.
    type Range = Option<(f64, f64)>;
    let rows: &[(&str, f64, [Range; 3])] = &[
        (
            "opensim/grf_walk_2000hz.mot",
            85.3,
            [Some((1.09, 1.09)), Some((0.72, 0.78)), Some((1.12, 1.12))],
        ),
        (
            "c3d/PiG_Motion3_FF.c3d",
            74.0,
            [None, Some((0.73, 0.79)), None],
        ),
        (
            "text/walk1.forces",
            1.0 / G,
            [Some((793.0, 836.0)), None, Some((780.0, 850.0))],
        ),
    ];
    for (file, mass, ranges) in rows {
        let (r, s) = open(folder, file);
        // 1 % of the body weight, in the unit of the row.
        let slack = 0.01 * both(&r, &s).mass_kg / mass;
        for stance in &s.used {
            let got = [Some(stance.p1), stance.valley, stance.p2];
            for (range, p) in ranges.iter().zip(got) {
                if let (Some((low, high)), Some(p)) = (range, p) {
                    let bw = p.force_n / (mass * G);
                    assert!(
                        bw > low - slack && bw < high + slack,
                        "{file}: {bw} outside {low} to {high}"
                    );
                }
            }
        }
    }
}

//! Every recording of the shared folder against its row in that folder's README.
//!
//! Stances exactly, peaks within 1 % of body weight, positions within 3 % of the stance. The README gives peaks
//! as recorded, offset and all; they are compared so, by adding the baseline that was removed.

use std::io::Write;
use std::path::{Path, PathBuf};

use gaitcam::error::{ErrorKind, ReadError};
use gaitcam::force::{
    Cycle, CycleSource, Feet, Foot, ReadOptions, Recording, RejectReason, Stance, Stances, cycle,
    metadata_name, read, stances,
};
use gaitcam::units::G;

/// Folder of the recordings, beside the project or one level higher.
fn folder() -> Option<PathBuf> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let places = ["../shared/data/gait", "../../shared/data/gait"].map(|p| here.join(p));
    places.into_iter().find(|p| p.is_dir())
}

fn open(folder: &Path, file: &str) -> (Recording, Stances) {
    let path = folder.join(file);
    let bytes = std::fs::read(&path).unwrap();
    let options = ReadOptions {
        metadata: metadata_name(&path).and_then(|m| std::fs::read(m).ok()),
        ..ReadOptions::default()
    };
    let r = read(&path, &bytes, &options).unwrap();
    let s = stances(&r);
    (r, s)
}

fn both(r: &Recording, s: &Stances) -> Cycle {
    cycle(r, s, Feet::Both).unwrap()
}

/// Channel, whole stances, and of these the highest force as recorded, N.
type Row<'a> = (&'a str, usize, f64);

/// Slivers of contacts at the edges of a file are neither whole nor cut stances: the README does not count them.
fn slivers(s: &Stances) -> usize {
    s.rejected
        .iter()
        .filter(|x| x.reason == RejectReason::EdgeFragment)
        .count()
}

/// Files: mass in the file, samples per second, plates in the order of the file with stances and peak, and the
/// number of stances that the recording cuts.
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

fn highest(s: &Stance) -> f64 {
    s.p1.force_n.max(s.p2.map_or(0.0, |p| p.force_n))
}

fn stances_mass_rate_and_peaks_are_those_of_the_readme(folder: &Path) {
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

/// One stance: forces as recorded (N) and positions (%) of P1, V and P2; `None` where the README names none.
type Landmarks = [Option<(f64, f64)>; 3];

/// A position that the README does not give.
const NOT_SAID: f64 = f64::NAN;

fn peaks_and_valleys_lie_where_the_readme_says(folder: &Path) {
    let n = |f: f64, at: f64| Some((f, at));
    let rows: &[(&str, usize, Landmarks)] = &[
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
    for (file, index, landmarks) in rows {
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

fn middle(mut v: Vec<f64>) -> f64 {
    v.sort_by(f64::total_cmp);
    v[v.len() / 2]
}

/// Medians over stances of forces (N) and positions (%): P1, V, P2.
fn medians(s: &Stances) -> [(f64, f64); 3] {
    let of = |pick: fn(&Stance) -> Option<gaitcam::force::Point>| {
        let all: Vec<_> = s.used.iter().filter_map(pick).collect();
        (
            middle(all.iter().map(|p| p.force_n).collect()),
            100.0 * middle(all.iter().map(|p| p.at).collect()),
        )
    };
    [of(|s| Some(s.p1)), of(|s| s.valley), of(|s| s.p2)]
}

fn a_long_walk_in_an_old_header_gives_the_subjects_mass(folder: &Path) {
    let (r, s) = open(folder, "opensim/subject01_walk1_grf_15s_oldheader.mot");
    // README: 25, one of them cut. The left foot lands in the first row, at 20.49 N, and counts as whole; a piece of
    // 0.17 s of the right foot before its push-off ends is a sliver.
    assert_eq!((s.used.len(), s.rejected.len(), slivers(&s)), (24, 2, 1));
    assert!((r.duration_s - 15.0).abs() < 0.02);
    let c = both(&r, &s);
    assert!(
        matches!(c.source, CycleSource::WholeStrides { .. }),
        "{:?}",
        c.source
    );
    assert!((72.6..=73.2).contains(&c.mass_kg), "{}", c.mass_kg);
    let w = 72.6 * G;
    let m = medians(&s);
    // P2 is given as 1.08 to 1.12, P1 and V as single figures rounded to two decimals; then 1 % BW.
    for ((force, at), (low, high, a)) in m.iter().zip([
        (1.095, 1.105, 24.0),
        (0.815, 0.825, 43.0),
        (1.08, 1.12, 77.0),
    ]) {
        let bw = force / w;
        assert!(bw > low - 0.01 && bw < high + 0.01, "{bw} {m:?}");
        assert!((at - a).abs() < 3.0, "{m:?}");
    }
}

fn strides_that_the_plates_cover_weigh_the_walker(folder: &Path) {
    for (file, low, high) in [
        ("text/walk1.forces", 76.0, 77.0),
        ("opensim/subject01_walk1_grf.mot", 72.6, 73.2),
        // Built from single stances: the total on record is too low.
        ("opensim/grf_walk_2000hz.mot", 0.97 * 85.3, 1.03 * 85.3),
    ] {
        let (r, s) = open(folder, file);
        let kg = both(&r, &s).mass_kg;
        assert!((low..=high).contains(&kg), "{file}: {kg}");
    }
}

fn a_treadmill_foot_without_header_and_with_jitter_gives_46_stances(folder: &Path) {
    let (r, s) = open(folder, "text/example_vertical_grf.csv");
    assert!((r.rate_hz - 100.0).abs() < 0.1 && (r.duration_s - 55.6).abs() < 0.05);
    assert_eq!(s.used.len(), 46);
    assert_eq!(
        (s.rejected.len(), slivers(&s)),
        (1, 1),
        "it begins inside push-off"
    );
    let m = medians(&s);
    for ((force, _), wanted) in m.iter().zip([1003.0, 802.0, 1008.0]) {
        assert!((force - wanted).abs() < 9.6, "{m:?}");
    }
}

fn tables_of_stances_take_their_masses_from_the_subjects(folder: &Path) {
    let mut highs = Vec::new();
    for side in ["left", "right"] {
        let (r, s) = open(folder, &format!("text/children_F_V_RAW_{side}.csv"));
        assert_eq!(r.rate_hz, 1000.0);
        assert_eq!(s.used.len(), 8);
        let masses: Vec<f64> = s.used.iter().filter_map(|s| s.mass_kg).collect();
        assert_eq!(masses, [32.1, 45.8, 27.7, 60.3, 33.0, 56.8, 39.7, 25.0]);
        assert!(
            s.used
                .iter()
                .all(|s| s.foot.map(gaitcam::force::Foot::name) == Some(side))
        );
        highs.extend(s.used.iter().map(|s| highest(s) / (s.mass_kg.unwrap() * G)));
        assert!((both(&r, &s).curve.mean_n() / (r.mass_kg.unwrap() * G) - 1.0).abs() < 0.01);
    }
    let low = highs.iter().copied().fold(f64::MAX, f64::min);
    let high = highs.iter().copied().fold(0.0, f64::max);
    assert!(
        (low - 1.04).abs() < 0.01 && (high - 1.36).abs() < 0.01,
        "{low} {high}"
    );
}

fn insoles_give_their_steps_and_peaks(folder: &Path) {
    let count = |s: &Stances, c: usize| s.used.iter().filter(|s| s.channel == c).count();
    let top = |s: &Stances, c: usize| {
        s.used
            .iter()
            .filter(|s| s.channel == c)
            .map(highest)
            .fold(0.0, f64::max)
    };
    let (_, s) = open(folder, "insole/opengo_normal_230927_102114.txt");
    assert_eq!((count(&s, 0), count(&s, 1)), (7, 7));
    assert!((top(&s, 0).max(top(&s, 1)) - 1060.0).abs() < 9.0);
    let (_, s) = open(folder, "insole/opengo_fast_230927_102231.txt");
    assert_eq!((count(&s, 0), count(&s, 1)), (5, 5));
    assert!((top(&s, 0) - 1157.0).abs() < 9.0 && (top(&s, 1) - 1391.0).abs() < 9.0);
    // Two totals of eight sensors each, told from their sums; "about 96 + 98" contacts, 1.35 and 1.41 BW.
    let (r, s) = open(folder, "insole/GaCo01_01.txt");
    assert_eq!(r.channels.len(), 2);
    let sides: Vec<_> = r.channels.iter().map(|c| c.foot).collect();
    assert_eq!(sides, [Some(Foot::Left), Some(Foot::Right)]);
    for (c, contacts, peak) in [(0, 96usize, 1.35), (1, 98, 1.41)] {
        let all = count(&s, c) + s.rejected.iter().filter(|x| x.channel == c).count();
        // "About": standing still between two turns is one contact or two.
        assert!(all.abs_diff(contacts) <= 2, "{all}");
        let highs = s
            .used
            .iter()
            .filter(|s| s.channel == c)
            .map(highest)
            .collect();
        assert!((middle(highs) / (83.0 * G) - peak).abs() < 0.01);
    }
}

fn unusable_recordings_are_refused_with_their_reason(folder: &Path) {
    for (file, code) in [
        (
            "opensim/subject01_walk_grf_truncated.mot",
            "force-no-stance-file-cut",
        ),
        ("opensim/subject02_running_grf.mot", "force-running"),
        ("opensim/referenceGRF.sto", "force-no-stance"),
    ] {
        let (r, s) = open(folder, file);
        assert!(s.used.is_empty(), "{file}");
        let e = cycle(&r, &s, Feet::Both).unwrap_err();
        assert_eq!(e.kind.code(), code, "{file}");
    }
    let path = folder.join("text/children_metadata.csv");
    let bytes = std::fs::read(&path).unwrap();
    let e = read(&path, &bytes, &ReadOptions::default()).unwrap_err();
    assert!(
        matches!(&e.kind, ErrorKind::Read(ReadError::NoForceColumn { columns }) if columns.contains("BODY_WEIGHT")),
        "{e:?}"
    );
}

fn float_and_integer_copies_agree_within_a_tenth_of_a_newton(folder: &Path) {
    let (a, _) = open(folder, "c3d/ADemo1_pc_float.c3d");
    let (b, _) = open(folder, "c3d/ADemo1_pc_integer.c3d");
    let pairs = a.channels[0].force_n.iter().zip(&b.channels[0].force_n);
    let worst = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    assert_eq!(a.channels[0].force_n.len(), b.channels[0].force_n.len());
    // Each of the four sensors is rounded to 0.025 N in the integer file; its scale is a float.
    assert!(worst <= 0.1 + 1e-8, "{worst}");
    println!("float against integer: {worst:.2e} N");
}

fn marked_strikes_and_turns_name_the_feet(folder: &Path) {
    let feet = |file: &str| -> Vec<&str> {
        let (_, s) = open(folder, file);
        s.used
            .iter()
            .map(|s| s.foot.map_or("-", gaitcam::force::Foot::name))
            .collect()
    };
    assert_eq!(feet("c3d/HC002D06.c3d"), ["right", "left"]);
    assert_eq!(feet("c3d/PiG_Motion3_FF.c3d"), ["left", "right", "left"]);
    assert_eq!(
        feet("opensim/subject01_walk1_grf.mot"),
        ["left", "right", "left"]
    );
    assert_eq!(feet("text/walk1.forces"), ["-", "-", "-"]);
}

fn every_landmark_the_readme_gives_as_a_range_lies_in_it(folder: &Path) {
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

/// Runs every check on the recordings; says how many could not run where the folder is missing.
#[test]
fn recordings_are_as_their_readme_says() {
    type Check = fn(&Path);
    let checks: [(&str, Check); 11] = [
        (
            "stances_mass_rate_and_peaks_are_those_of_the_readme",
            stances_mass_rate_and_peaks_are_those_of_the_readme,
        ),
        (
            "peaks_and_valleys_lie_where_the_readme_says",
            peaks_and_valleys_lie_where_the_readme_says,
        ),
        (
            "a_long_walk_in_an_old_header_gives_the_subjects_mass",
            a_long_walk_in_an_old_header_gives_the_subjects_mass,
        ),
        (
            "strides_that_the_plates_cover_weigh_the_walker",
            strides_that_the_plates_cover_weigh_the_walker,
        ),
        (
            "a_treadmill_foot_without_header_and_with_jitter_gives_46_stances",
            a_treadmill_foot_without_header_and_with_jitter_gives_46_stances,
        ),
        (
            "tables_of_stances_take_their_masses_from_the_subjects",
            tables_of_stances_take_their_masses_from_the_subjects,
        ),
        (
            "insoles_give_their_steps_and_peaks",
            insoles_give_their_steps_and_peaks,
        ),
        (
            "unusable_recordings_are_refused_with_their_reason",
            unusable_recordings_are_refused_with_their_reason,
        ),
        (
            "float_and_integer_copies_agree_within_a_tenth_of_a_newton",
            float_and_integer_copies_agree_within_a_tenth_of_a_newton,
        ),
        (
            "marked_strikes_and_turns_name_the_feet",
            marked_strikes_and_turns_name_the_feet,
        ),
        (
            "every_landmark_the_readme_gives_as_a_range_lies_in_it",
            every_landmark_the_readme_gives_as_a_range_lies_in_it,
        ),
    ];
    let Some(folder) = folder() else {
        // Not `println`: a passing test's words are swallowed.
        let missing = checks.len();
        std::io::stderr()
            .write_all(
                format!("recordings missing at ../shared/data/gait: {missing} checks NOT RUN\n")
                    .as_bytes(),
            )
            .unwrap();
        return;
    };
    for (name, check) in checks {
        println!("{name}");
        check(&folder);
    }
}

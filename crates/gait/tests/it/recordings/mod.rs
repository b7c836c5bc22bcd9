//! Compares every recording in the shared folder with its row in the README of the folder.
//!
//! Tolerances: stances exactly, peaks within 1 % of the body weight, positions within 3 % of the stance. The README gives the peaks as recorded,
//! including the offset; for the comparison, the subtracted baseline is added.

mod heels;
mod landmarks;
mod long_tables;
mod movements;
mod plates;

use std::io::Write;
use std::path::{Path, PathBuf};

use gaitcam_gait::error::ReadError;
use gaitcam_gait::units::G;
use gaitcam_gait::{
    Cycle, CycleSource, Feet, Foot, ReadOptions, Recording, RejectReason, Stance, Stances, cycle,
    metadata_name, read, stances,
};

/// Folder of the recordings, next to the project or one level higher.
fn folder() -> Option<PathBuf> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let places =
        ["../../../shared/data/gait", "../../../../shared/data/gait"].map(|p| here.join(p));
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

/// Number of short pieces of contacts at the edges of a file. They are neither whole nor incomplete stances; the README does not count them.
fn slivers(s: &Stances) -> usize {
    s.rejected
        .iter()
        .filter(|x| x.reason == RejectReason::EdgeFragment)
        .count()
}

fn highest(s: &Stance) -> f64 {
    s.p1.force_n.max(s.p2.map_or(0.0, |p| p.force_n))
}
fn middle(mut v: Vec<f64>) -> f64 {
    v.sort_by(f64::total_cmp);
    v[v.len() / 2]
}

/// Medians over stances of forces (N) and positions (%): P1, V, P2.
fn medians(s: &Stances) -> [(f64, f64); 3] {
    let of = |pick: fn(&Stance) -> Option<gaitcam_gait::Point>| {
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
                .all(|s| s.foot.map(gaitcam_gait::Foot::name) == Some(side))
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
        assert_eq!(e.code(), code, "{file}");
    }
    let path = folder.join("text/children_metadata.csv");
    let bytes = std::fs::read(&path).unwrap();
    let e = read(&path, &bytes, &ReadOptions::default()).unwrap_err();
    assert!(
        matches!(e.fault(), Some(ReadError::NoForceColumn { columns }) if columns.iter().any(|c| c == "BODY_WEIGHT")),
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
            .map(|s| s.foot.map_or("-", gaitcam_gait::Foot::name))
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

/// Files of the folder; a check below opens each of them.
const FILES: [&str; 29] = [
    "c3d/ADemo1_pc_float.c3d",
    "c3d/ADemo1_pc_integer.c3d",
    "c3d/Gait.c3d",
    "c3d/HC002D06.c3d",
    "c3d/HC030A05.c3d",
    "c3d/HC032A03.c3d",
    "c3d/PiG_Motion3_FF.c3d",
    "c3d/treadmill_events.c3d",
    "c3d/walking2.c3d",
    "insole/GaCo01_01.txt",
    "insole/opengo_fast_230927_102231.txt",
    "insole/opengo_normal_230927_102114.txt",
    "opensim/grf_run.mot",
    "opensim/grf_walk_2000hz.mot",
    "opensim/referenceGRF.sto",
    "opensim/std_walking2_grfs.sto",
    "opensim/subject01_walk1_grf.mot",
    "opensim/subject01_walk1_grf_15s_oldheader.mot",
    "opensim/subject01_walk_grf_truncated.mot",
    "opensim/subject02_running_grf.mot",
    "text/BiomecII2018_gait_n.txt",
    "text/HC038A11_decimal_comma.csv",
    "text/Trial1-FxFyFzMxMyMz.asc",
    "text/children_F_V_RAW_left.csv",
    "text/children_F_V_RAW_right.csv",
    "text/children_metadata.csv",
    "text/example_vertical_grf.csv",
    "text/jump1.txt",
    "text/walk1.forces",
];

fn every_file_of_the_folder_is_looked_at(folder: &Path) {
    let mut found = Vec::new();
    for room in ["c3d", "insole", "opensim", "text"] {
        for entry in std::fs::read_dir(folder.join(room)).unwrap() {
            let name = entry.unwrap().file_name();
            found.push(format!("{room}/{}", name.to_string_lossy()));
        }
    }
    found.sort();
    assert_eq!(found, FILES);
}

/// A check with its path.
type Named = (&'static str, Box<dyn Fn(&Path)>);

fn named<F: Fn(&Path) + 'static>(check: F) -> Named {
    (std::any::type_name::<F>(), Box::new(check))
}

/// Runs all checks of the recordings. If the folder is missing, reports how many checks could not run.
#[test]
fn recordings_are_as_their_readme_says() {
    let checks = [
        named(every_file_of_the_folder_is_looked_at),
        named(movements::a_person_who_jumps_is_not_tared_away),
        named(movements::running_is_named_and_read_when_asked_for),
        named(movements::belts_that_feet_cross_are_summed),
        named(plates::stances_mass_rate_and_peaks_are_those_of_the_readme),
        named(landmarks::peaks_and_valleys_lie_where_the_readme_says),
        named(plates::two_stances_in_turn_weigh_the_walker),
        named(a_long_walk_in_an_old_header_gives_the_subjects_mass),
        named(strides_that_the_plates_cover_weigh_the_walker),
        named(a_treadmill_foot_without_header_and_with_jitter_gives_46_stances),
        named(tables_of_stances_take_their_masses_from_the_subjects),
        named(insoles_give_their_steps_and_peaks),
        named(unusable_recordings_are_refused_with_their_reason),
        named(float_and_integer_copies_agree_within_a_tenth_of_a_newton),
        named(marked_strikes_and_turns_name_the_feet),
        named(heels::heel_markers_name_the_feet_that_the_events_name),
        named(heels::heel_markers_give_the_stride_that_the_events_give),
        named(landmarks::every_landmark_the_readme_gives_as_a_range_lies_in_it),
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

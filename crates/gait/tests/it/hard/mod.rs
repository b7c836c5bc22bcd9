//! Several thousand recordings that are difficult to read, each with known true values. The test counts how many are read correctly, how many have
//! open questions, and how many are accepted although the result is wrong.

mod cases;
pub mod dice;
mod faults;
mod headers;
mod layout;
mod markers;
mod person;

use std::collections::BTreeMap;
use std::path::Path;

use cases::{Case, FAMILIES};
use dice::Dice;
use gaitcam_gait::{Kind, Note, force_curve};

/// Minimum number of cases.
const FEWEST: usize = 2000;
/// Maximum relative error of a correct stride time, and of a correct mass.
const STRIDE: f64 = 0.01;
const MASS: f64 = 0.03;

/// Result of reading a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fate {
    Right,
    Questioned,
    /// The result is wrong, but a note states the assumption.
    Warned,
    Silent,
}

fn fate(case: &Case) -> (Fate, String) {
    let path = Path::new(case.file);
    let curve = match force_curve(path, &case.bytes, &case.options, case.feet) {
        Ok(curve) => curve,
        Err(e) => return (Fate::Questioned, e.code().to_string()),
    };
    let truth = &case.truth;
    let understood = curve.recording.as_ref().expect("a recording");
    let (period, mass) = (curve.period_s, curve.mass_kg.unwrap_or(0.0));
    let near = |x: f64, of: f64, share: f64| (x / of - 1.0).abs() <= share;
    let walks = matches!(truth.kind, Kind::Walking | Kind::Running);
    let right = walks
        && understood.kind == Some(truth.kind)
        && truth.strides.iter().any(|s| near(period, *s, STRIDE))
        && truth.mass.is_none_or(|m| near(mass, m, MASS));
    let doubts = understood.doubts();
    let said = format!(
        "stride {period:.4} of {:?}, mass {mass:.2} of {:?}, {:?}, {:?}",
        truth.strides, truth.mass, understood.cycle, understood.warnings
    );
    let fate = if !doubts.is_empty() {
        Fate::Questioned
    } else if right {
        Fate::Right
    } else if understood.warnings.iter().any(concerns) {
        Fate::Warned
    } else {
        Fate::Silent
    };
    (fate, said)
}

/// Whether a note states an assumption on time base, magnitude or kind, not on rows, samples or names.
fn concerns(note: &Note) -> bool {
    matches!(
        note,
        Note::SpeedChanges { .. }
            | Note::UnitGuessed { .. }
            | Note::UnitLabelRejected { .. }
            | Note::TimeUnitGuessed { .. }
            | Note::VerticalGuessed { .. }
            | Note::TotalColumn
            | Note::CountsScaled { .. }
            | Note::LowForce { .. }
    )
}

#[test]
fn hard_recordings_are_read_right_or_questioned() {
    let mut all: BTreeMap<Fate, usize> = BTreeMap::new();
    let (mut count, mut plain, mut plain_right) = (0usize, 0usize, 0usize);
    let mut lines = Vec::new();
    for (k, (name, seeds, make)) in FAMILIES.iter().enumerate() {
        let mut of: BTreeMap<Fate, usize> = BTreeMap::new();
        let mut bad = Vec::new();
        for seed in 0..*seeds {
            let case = make(&mut Dice::new((1000 * k + seed) as u64));
            assert_eq!(case.name, *name);
            let (fate, said) = fate(&case);
            count += 1;
            *of.entry(fate).or_default() += 1;
            *all.entry(fate).or_default() += 1;
            plain += usize::from(case.plain);
            plain_right += usize::from(case.plain && fate == Fate::Right);
            let missed = case.plain && fate == Fate::Questioned;
            if (missed || fate >= Fate::Warned) && bad.len() < 3 {
                bad.push(format!("      seed {seed}, {fate:?}: {said}"));
            }
        }
        let of = |f| of.get(&f).copied().unwrap_or(0);
        lines.push(format!(
            "  {name:<36} {seeds:>4}  right {:>4}  questioned {:>4}  warned {:>3}  silent {:>3}",
            of(Fate::Right),
            of(Fate::Questioned),
            of(Fate::Warned),
            of(Fate::Silent)
        ));
        lines.extend(bad);
    }
    let share = |f: &[Fate]| {
        let sum: usize = f.iter().filter_map(|f| all.get(f)).sum();
        100.0 * sum as f64 / count as f64
    };
    let good = share(&[Fate::Right, Fate::Questioned]);
    let silent = share(&[Fate::Silent]);
    let read = 100.0 * plain_right as f64 / plain as f64;
    println!("{}", lines.join("\n"));
    println!(
        "{count} hard recordings: right or questioned {good:.2} % (at least 99 %), silently wrong {silent:.2} % \
         (at most 0.2 %); of the {plain} that leave nothing open {read:.1} % are read right (at least 95 %)"
    );
    assert!(count >= FEWEST, "{count} cases were built");
    assert!(good >= 99.0 && silent <= 0.2 && read >= 95.0);
}

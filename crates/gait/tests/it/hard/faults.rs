//! Classes of recordings that were misread or wrongly rejected: clipping, drift, two speeds, feet that cross named belts, insoles without a header,
//! running in one column.

use std::path::Path;
use std::sync::Arc;

use super::dice::Dice;
use super::layout::{Clock, Plate, Table};
use super::person::{Person, Step, changing, limper, runner, walker};
use crate::c3d_file::{Build, Processor, build};
use gaitcam_gait::error::Result;
use gaitcam_gait::{
    Feet, ForceCurve, Interpretation, Kind, Note, OpenQuestion, ReadOptions, force_curve, read,
    stances,
};

pub const CLOCK: Clock = Clock::Seconds {
    from: 0.0,
    decimals: 4,
};

pub fn plain(rate_hz: f64) -> Plate {
    Plate {
        rate_hz,
        noise_n: 0.5,
        offset_n: 0.0,
        drift_n: 0.0,
        sign: 1.0,
        cut_n: 0.0,
    }
}

/// One column for each side. `reading` transforms the force of a side.
pub fn belts(dice: &mut Dice, person: &Person, plate: &Plate, names: [&str; 2]) -> Table {
    let side = |dice: &mut Dice, left: bool| {
        plate.samples(dice, person.seconds, |t| {
            person.feet(t, |_, s| s.left == left)
        })
    };
    Table {
        rate_hz: plate.rate_hz,
        names: names.map(str::to_string).to_vec(),
        columns: vec![side(dice, true), side(dice, false)],
    }
}

pub fn opened(text: &str, options: &ReadOptions) -> Result<ForceCurve> {
    force_curve(Path::new("made.csv"), text.as_bytes(), options, Feet::Both)
}

fn understood(curve: &ForceCurve) -> Arc<Interpretation> {
    curve.recording.clone().expect("a recording")
}

pub fn none() -> ReadOptions {
    ReadOptions::default()
}

/// Disturbances of a column after its force: noise of some newtons, gain, drift in N/s, another rate.
fn processed(dice: &mut Dice, table: &mut Table) {
    let noise = dice.of(&[0.0, 1.0, 2.0, 3.0]);
    let (gain, drift) = (dice.between(0.9, 1.1), dice.of(&[0.0, -8.0, 8.0]));
    let (from, to) = (table.rate_hz, dice.of(&[90.0, 150.0, 240.0]));
    let resampled = dice.chance(50.0);
    for column in &mut table.columns {
        let t = |i: usize| i as f64 / from;
        for (i, x) in column.iter_mut().enumerate() {
            *x = gain * *x + drift * t(i) + noise * dice.between(-1.0, 1.0);
        }
        if resampled {
            let count = (t(column.len() - 1) * to) as usize;
            let at = |k: usize| {
                let place = k as f64 / to * from;
                let (i, x) = (place as usize, place.fract());
                (1.0 - x) * column[i] + x * column[i + 1]
            };
            *column = (0..count).map(at).collect();
        }
    }
    table.rate_hz = if resampled { to } else { from };
}

/// A table with transformed forces.
fn changed(table: &Table, to: impl Fn(f64) -> f64) -> Table {
    let mut out = table.clone();
    for x in out.columns.iter_mut().flatten() {
        *x = to(*x);
    }
    out
}

#[test]
fn clipped_forces_are_an_open_question_that_cannot_be_accepted() {
    let asks = |table: &Table| {
        let curve = opened(&table.delimited(CLOCK, false), &none()).unwrap();
        understood(&curve).doubts().contains(&OpenQuestion::Clipped)
    };
    let mut clipped = 0;
    for seed in 0..100 {
        let dice = &mut Dice::new(seed);
        let seconds = dice.of(&[6.0, 12.0]);
        let person = walker(dice, seconds);
        let plate = plain(dice.of(&[100.0, 300.0, 1000.0]));
        let table = belts(dice, &person, &plate, ["left fz", "right fz"]);
        let mut untouched = table.clone();
        processed(dice, &mut untouched);
        assert!(!asks(&untouched), "seed {seed}: not clipped");
        let digit = dice.of(&[0.1, 1.0, 2.0, 5.0]);
        let rounded = changed(&table, |x| (x / digit).round() * digit);
        assert!(
            !asks(&rounded),
            "seed {seed}: not clipped, of whole {digit} N"
        );
        let peak = |s: &Step| {
            let at = |k: u8| s.at + s.lasts * f64::from(k) / 100.0;
            (0..100).map(|k| person.foot(s, at(k))).fold(0.0, f64::max)
        };
        let mut peaks: Vec<f64> = person.steps.iter().map(peak).collect();
        peaks.sort_by(f64::total_cmp);
        let middle = peaks[peaks.len() / 2];
        for level in (450..=700).step_by(50).map(f64::from) {
            if !(0.6 * middle..0.93 * middle).contains(&level) {
                continue;
            }
            let mut table = changed(&table, |x| x.min(level));
            processed(dice, &mut table);
            assert!(asks(&table), "seed {seed}: {level} of {middle} N");
            clipped += 1;
        }
        // As recorded, just below the peaks too.
        for part in [0.94, 0.97] {
            let table = changed(&table, |x| x.min(part * middle));
            assert!(asks(&table), "seed {seed}: {part} of {middle} N");
            clipped += 1;
        }
    }
    assert!(clipped >= 350, "{clipped} were built");
    assert!(OpenQuestion::list("clipped").is_err());
}

#[test]
fn one_clipped_stance_of_a_c3d_is_asked_about() {
    let built = Build {
        before: 0,
        processor: Processor::Intel,
        float: true,
        kind: 2,
        per_frame: 5,
        frames: 180,
        scale: 0.05,
        offset: 0,
    };
    for (level, clips) in [(700.0, true), (2000.0, false)] {
        let bytes = build(&built, |i| {
            let x = (i as f64 / 500.0 - 0.5) / 0.66;
            let a = std::f64::consts::PI * x;
            let on = (0.0..1.0).contains(&x);
            let force = 800.0 * (a.sin() + 0.3 * (3.0 * a).sin());
            -if on { force.min(level) } else { 0.0 }
        });
        let recording = read(Path::new("made.c3d"), &bytes, &none()).unwrap();
        let clipped = |n: &Note| matches!(n, Note::Clipped { .. });
        assert_eq!(recording.notes.iter().any(clipped), clips, "{level} N");
    }
}

#[test]
fn a_steady_drift_is_removed_and_said() {
    for seed in 0..40 {
        let dice = &mut Dice::new(seed);
        let seconds = dice.of(&[6.0, 20.0]);
        let person = walker(dice, seconds);
        let rise = dice.of(&[-8.0, -4.0, 4.0, 8.0]);
        let plate = Plate {
            drift_n: rise * person.seconds,
            ..plain(200.0)
        };
        let table = belts(dice, &person, &plate, ["left fz", "right fz"]);
        let curve = opened(&table.delimited(CLOCK, false), &none()).unwrap();
        let (stride, mass) = (curve.period_s, curve.mass_kg.unwrap());
        assert!((stride / person.strides[0] - 1.0).abs() < 0.01, "{seed}");
        assert!((mass / person.mass - 1.0).abs() < 0.02, "{seed}: {mass}");
        let said = |n: &&Note| match n {
            Note::DriftRemoved { rise: found, .. } => (found.value - rise).abs() < 0.3,
            _ => false,
        };
        assert_eq!(understood(&curve).warnings.iter().filter(said).count(), 2);
    }
}

#[test]
fn blocks_of_two_speeds_are_asked_about_unless_one_is_most_of_the_recording() {
    let (mut asked, mut one_block) = (0, 0);
    for (seed, layout) in
        (0..40).flat_map(|seed| [(seed, "total"), (seed, "belts"), (seed, "foot")])
    {
        let dice = &mut Dice::new(seed);
        let person = changing(dice);
        let plate = plain(100.0);
        let (from, until) = (person.steps[2].at, person.steps[person.steps.len() - 3].at);
        let mut table = belts(dice, &person, &plate, ["left fz", "right fz"]);
        if layout == "total" {
            table.columns = vec![plate.samples(dice, until - from, |t| person.total(t + from))];
        }
        if layout != "belts" {
            table.columns.truncate(1);
            table.names = vec!["Fz".to_string()];
        }
        let Ok(curve) = opened(&table.delimited(CLOCK, false), &none()) else {
            continue;
        };
        if understood(&curve).doubts() == [OpenQuestion::Clock] {
            asked += 1;
            continue;
        }
        // Stances of each speed: those of two changes of speed count for either.
        let (slow, fast) = (person.strides[0], person.strides[1]);
        let steps = person.steps.windows(3);
        let of = |stride: f64| {
            steps
                .clone()
                .filter(|s| ((s[2].at - s[0].at) / stride - 1.0).abs() < 0.1)
                .count()
        };
        let most = if of(slow) > of(fast) { slow } else { fast };
        let is_most = 3 * of(most) + 9 > 2 * person.steps.len();
        assert!(is_most, "{layout} {seed}: neither is most");
        let period = curve.period_s;
        assert!(
            (period / most - 1.0).abs() < 0.01,
            "{layout} {seed}: {period}"
        );
        one_block += 1;
    }
    assert!(asked > 40 && one_block > 10, "{asked} {one_block}");
}

#[test]
fn feet_that_cross_named_belts_are_found_as_on_unnamed_ones() {
    for seed in 0..40 {
        let dice = &mut Dice::new(seed);
        let person = walker(dice, 20.0);
        let plate = plain(100.0);
        let shares: Vec<f64> = (person.steps.iter())
            .map(|_| if dice.chance(15.0) { 0.4 } else { 0.0 })
            .collect();
        let mut table = belts(dice, &person, &plate, ["left fz", "right fz"]);
        for (i, x) in (0..table.columns[0].len()).map(|i| (i, i as f64 / 100.0)) {
            let crossed: f64 = (person.steps.iter().zip(&shares))
                .filter(|(s, _)| s.left)
                .map(|(s, share)| share * person.foot(s, x))
                .sum();
            table.columns[0][i] -= crossed;
            table.columns[1][i] += crossed;
        }
        let spans = |table: &Table| {
            let text = table.delimited(CLOCK, false);
            let recording = read(Path::new("made.csv"), text.as_bytes(), &none()).unwrap();
            let used = stances(&recording).used;
            used.iter()
                .map(|s| (s.channel, s.start_s))
                .collect::<Vec<_>>()
        };
        let named = spans(&table);
        table.names = vec!["Fz1".to_string(), "Fz2".to_string()];
        assert_eq!(named, spans(&table), "{seed}");
    }
}

#[test]
fn feet_that_change_belts_in_mid_stance_do_not_change_the_speed() {
    let mut right = 0;
    for seed in 0..60 {
        let dice = &mut Dice::new(seed);
        let person = walker(dice, 20.0);
        let often = dice.of(&[10.0, 20.0, 30.0]);
        // The part of a step after which its foot stands on the other belt.
        let leaves: Vec<f64> = (person.steps.iter())
            .map(|_| {
                if dice.chance(often) {
                    dice.between(0.2, 0.8)
                } else {
                    2.0
                }
            })
            .collect();
        let own = |i: usize, s: &Step, t: f64| {
            let late = (t - s.at) / s.lasts - leaves[i];
            1.0 - (late / 0.1).clamp(0.0, 1.0)
        };
        let belt = |dice: &mut Dice, left: bool| {
            let on = |t: f64| {
                let part = |(i, s): (usize, &Step)| {
                    let own = own(i, s, t);
                    let share = if s.left == left { own } else { 1.0 - own };
                    share * person.foot(s, t)
                };
                person.steps.iter().enumerate().map(part).sum()
            };
            let (from, until) = (person.steps[2].at, person.steps[person.steps.len() - 3].at);
            plain(100.0).samples(dice, until - from, |t| on(t + from))
        };
        let names = dice.of(&[["left fz", "right fz"], ["Fz1", "Fz2"]]);
        let table = Table {
            rate_hz: 100.0,
            names: names.map(str::to_string).to_vec(),
            columns: vec![belt(dice, true), belt(dice, false)],
        };
        let curve = opened(&table.delimited(CLOCK, false), &none()).unwrap();
        let told = understood(&curve);
        let speed = |n: &Note| matches!(n, Note::SpeedChanges { .. });
        assert!(!told.warnings.iter().any(speed), "{seed}: {often} %");
        if !told.doubts().is_empty() {
            continue;
        }
        // A stride that begins where the other foot came onto the belt is too long or too short.
        let (stride, mass) = (curve.period_s, curve.mass_kg.unwrap());
        assert!(
            (stride / person.strides[0] - 1.0).abs() < 0.02,
            "{seed}: {stride}"
        );
        assert!((mass / person.mass - 1.0).abs() < 0.025, "{seed}: {mass}");
        right += 1;
    }
    assert!(right >= 40, "{right} of 60");
}

#[test]
fn insoles_without_a_header_leave_the_mass_open_until_it_is_given() {
    for (seed, reads) in [0.68, 0.8, 1.2, 1.25, 1.32].into_iter().enumerate() {
        let dice = &mut Dice::new(seed as u64);
        let person = walker(dice, 12.0);
        let table = belts(dice, &person, &plain(100.0), ["l", "r"]);
        let text: String = (0..table.columns[0].len())
            .map(|i| {
                let [l, r] = [0, 1].map(|k| reads * table.columns[k][i].max(0.0));
                let sensors = |f: f64| format!("{:.3}\t", f / 8.0).repeat(8);
                let t = i as f64 / 100.0;
                format!("{t:.2}\t{}{}{l:.3}\t{r:.3}\n", sensors(l), sensors(r))
            })
            .collect();
        let doubts = |options| understood(&opened(&text, &options).unwrap()).doubts();
        assert_eq!(doubts(none()), [OpenQuestion::Mass], "{reads}");
        let given = ReadOptions {
            mass_kg: Some(reads * person.mass),
            ..none()
        };
        assert_eq!(doubts(given), [], "{reads}");
    }
}

#[test]
fn both_feet_of_a_runner_in_one_column_give_the_stride() {
    for seed in 0..40 {
        let dice = &mut Dice::new(seed);
        let person = runner(dice, 8.0);
        let column = plain(300.0).samples(dice, person.seconds, |t| person.total(t));
        let table = Table {
            rate_hz: 300.0,
            names: vec!["Fz".to_string()],
            columns: vec![column],
        };
        let options = ReadOptions {
            kind: Some(Kind::Running),
            ..none()
        };
        let curve = opened(&table.delimited(CLOCK, false), &options).unwrap();
        let open = !understood(&curve).doubts().is_empty();
        let right = (curve.period_s / person.strides[0] - 1.0).abs() < 0.01;
        assert!(
            open || right,
            "{seed}: {} {:?}",
            curve.period_s,
            person.strides
        );
    }
}

/// The columns of successive contacts, each on a separate plate.
fn plates_in_turn(dice: &mut Dice, person: &Person, contacts: std::ops::Range<usize>) -> Table {
    let plate = plain(dice.of(&[200.0, 500.0, 1000.0]));
    let (first, last) = (person.steps[contacts.start], person.steps[contacts.end - 1]);
    let (from, seconds) = (first.at - 0.4, last.at + last.lasts - first.at + 0.8);
    let on = |k: usize| move |t: f64| person.feet(t + from, |i, _| i == k);
    Table {
        rate_hz: plate.rate_hz,
        names: contacts.clone().map(|k| format!("Fz{k}")).collect(),
        columns: contacts
            .map(|k| plate.samples(dice, seconds, on(k)))
            .collect(),
    }
}

/// Root mean square and maximum absolute value.
fn errors(all: &[f64]) -> (f64, f64) {
    let square = all.iter().map(|x| x * x).sum::<f64>() / all.len() as f64;
    (square.sqrt(), all.iter().fold(0.0, |m, x| m.max(x.abs())))
}

#[test]
fn a_stride_from_one_step_is_within_twice_the_uncertainty_that_is_said() {
    let mut off = Vec::new();
    for seed in 0..100 {
        let dice = &mut Dice::new(seed);
        let person = if seed % 4 == 0 {
            limper(dice, 9.0)
        } else {
            walker(dice, 9.0)
        };
        let first = dice.of(&[2, 3]);
        let table = plates_in_turn(dice, &person, first..first + 2);
        let curve = opened(&table.delimited(CLOCK, false), &none()).unwrap();
        let understood = understood(&curve);
        let one = understood.warnings.iter().find_map(|n| match n {
            Note::StrideFromOne { error, stroke, .. } => Some((error.value, stroke.value)),
            _ => None,
        });
        let (error, stroke) = one.expect("the note");
        // The stroke of a law goes with the square of the period.
        assert!((stroke / error - 2.0).abs() < 1e-9, "{seed}");
        assert!(understood.period.unwrap().uncertainty_s().is_some());
        let stride = person.strides[0];
        if seed % 4 != 0 {
            off.push((curve.period_s / stride - 1.0) / error);
        }
    }
    let (rms, worst) = errors(&off);
    assert!(off.len() == 75 && rms < 1.0 && worst < 2.0);
}

#[test]
fn contacts_in_turn_weigh_the_walker() {
    let mut off = Vec::new();
    for seed in 0..120 {
        let dice = &mut Dice::new(seed);
        let person = walker(dice, 9.0);
        let count = dice.of(&[2, 3, 4]);
        let table = plates_in_turn(dice, &person, 2..2 + count);
        let curve = opened(&table.delimited(CLOCK, false), &none()).unwrap();
        off.push(curve.mass_kg.unwrap() / person.mass - 1.0);
    }
    let (rms, worst) = errors(&off);
    // Single contacts of the made walkers differ by 1.5 %.
    assert!(rms < 0.015 && worst < 0.04);
}

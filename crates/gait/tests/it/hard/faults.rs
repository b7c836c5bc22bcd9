//! Classes of recordings that were once believed or refused wrongly: clipping, drift, two speeds in one column, feet that
//! cross named belts, insoles without a header, zones of insoles, running in one column.

use std::path::Path;
use std::sync::Arc;

use super::dice::Dice;
use super::layout::{Clock, Plate, Table};
use super::person::{Person, changing, runner, walker};
use crate::c3d_file::{Build, Processor, build};
use gaitcam_gait::error::Result;
use gaitcam_gait::units::G;
use gaitcam_gait::{
    Feet, ForceCurve, Interpretation, Kind, Note, OpenQuestion, ReadOptions, force_curve, read,
    stances,
};

const CLOCK: Clock = Clock::Seconds {
    from: 0.0,
    decimals: 4,
};

fn plain(rate_hz: f64) -> Plate {
    Plate {
        rate_hz,
        noise_n: 0.5,
        offset_n: 0.0,
        drift_n: 0.0,
        sign: 1.0,
        cut_n: 0.0,
    }
}

/// One column for each side; the force of a side passes through `reading`.
fn belts(dice: &mut Dice, person: &Person, plate: &Plate, names: [&str; 2]) -> Table {
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

fn opened(text: &str, options: &ReadOptions) -> Result<ForceCurve> {
    force_curve(Path::new("made.csv"), text.as_bytes(), options, Feet::Both)
}

fn understood(curve: &ForceCurve) -> Arc<Interpretation> {
    curve.recording.clone().expect("a recording")
}

fn none() -> ReadOptions {
    ReadOptions::default()
}

#[test]
fn clipped_forces_are_an_open_question_that_cannot_be_accepted() {
    for seed in 0..60 {
        let dice = &mut Dice::new(seed);
        let person = walker(dice, 9.0);
        let plate = plain(dice.of(&[100.0, 300.0, 1000.0]));
        let mut table = belts(dice, &person, &plate, ["left fz", "right fz"]);
        let asks = |table: &Table| {
            let curve = opened(&table.delimited(CLOCK, false), &none()).unwrap();
            understood(&curve).doubts().contains(&OpenQuestion::Clipped)
        };
        assert!(!asks(&table), "seed {seed}: not clipped");
        let top = |c: &Vec<f64>| c.iter().copied().fold(0.0, f64::max);
        let level = dice.between(0.7, 0.93) * top(&table.columns[0]).min(top(&table.columns[1]));
        for x in table.columns.iter_mut().flatten() {
            *x = x.min(level);
        }
        assert!(asks(&table), "seed {seed}: clipped at {level} N");
    }
    assert!(OpenQuestion::list("clipped").is_err());
}

#[test]
fn one_clipped_stance_of_a_c3d_is_asked_about() {
    let built = Build {
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
        let person = walker(dice, 20.0);
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
fn two_speeds_in_one_column_are_asked_about() {
    for seed in 0..40 {
        let dice = &mut Dice::new(seed);
        let person = changing(dice);
        let plate = plain(100.0);
        let (from, until) = (person.steps[2].at, person.steps[person.steps.len() - 3].at);
        let column = plate.samples(dice, until - from, |t| person.total(t + from));
        let table = Table {
            rate_hz: 100.0,
            names: vec!["Fz".to_string()],
            columns: vec![column],
        };
        if let Ok(curve) = opened(&table.delimited(CLOCK, false), &none()) {
            // Few steps of the other speed are left out, and the mean is of one speed.
            let asks = understood(&curve).doubts() == [OpenQuestion::Clock];
            let near = |s: &f64| (curve.period_s / s - 1.0).abs() < 0.01;
            assert!(asks || person.strides.iter().any(near), "{seed}");
        }
    }
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
fn zones_of_an_insole_stand_beside_their_total() {
    let dice = &mut Dice::new(2);
    let person = walker(dice, 8.0);
    let sides = belts(dice, &person, &plain(100.0), ["l", "r"]);
    let zones = [
        "L::heel [N]",
        "L::medial [N]",
        "L [N]",
        "R::heel [N]",
        "R::medial [N]",
        "R [N]",
    ];
    let part = |k: usize, share: f64| sides.columns[k].iter().map(|f| share * f).collect();
    let table = Table {
        rate_hz: 100.0,
        names: zones.map(str::to_string).to_vec(),
        columns: vec![
            part(0, 0.4),
            part(0, 0.6),
            part(0, 1.0),
            part(1, 0.4),
            part(1, 0.6),
            part(1, 1.0),
        ],
    };
    let text = table.delimited(CLOCK, false);
    let recording = read(Path::new("made.csv"), text.as_bytes(), &none()).unwrap();
    let names: Vec<&str> = recording.channels.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["L [N]", "R [N]"]);
}

#[test]
fn every_unit_of_force_in_a_header_gives_the_same_newtons() {
    const KGF: f64 = 9.806_65;
    const LBF: f64 = 4.448_221_615_260_5;
    let units: [(&str, f64); 14] = [
        ("N", 1.0),
        ("newtons", 1.0),
        ("daN", 0.1),
        ("kN", 1e-3),
        ("kilonewton", 1e-3),
        ("lbf", 1.0 / LBF),
        ("lb", 1.0 / LBF),
        ("lbs", 1.0 / LBF),
        ("kgf", 1.0 / KGF),
        ("kp", 1.0 / KGF),
        ("N/kg", 1.0 / 80.0),
        ("BW", 1.0 / (80.0 * G)),
        ("%BW", 100.0 / (80.0 * G)),
        ("N/BW", 1.0 / (80.0 * G)),
    ];
    for (seed, (unit, per_newton)) in units.into_iter().enumerate() {
        let dice = &mut Dice::new(seed as u64);
        let person = walker(dice, 9.0);
        for style in ["{} [U]", "{} (U)", "{}_U", "{} U", "row"] {
            let names = ["left fz", "right fz"].map(|n| style.replace("{}", n).replace('U', unit));
            let rows = style == "row";
            let names = if rows {
                ["left fz", "right fz"].map(str::to_string)
            } else {
                names
            };
            let mut table = belts(dice, &person, &plain(200.0), ["", ""]);
            table.names = names.to_vec();
            for x in table.columns.iter_mut().flatten() {
                *x *= per_newton;
            }
            let mut text = table.delimited(CLOCK, false);
            if rows {
                text = text.replacen('\n', &format!("\ns,{unit},{unit}\n"), 1);
            }
            let relative = unit.contains('W') || unit.contains("kg") && unit.contains('/');
            let options = ReadOptions {
                mass_kg: relative.then_some(80.0),
                ..none()
            };
            let recording = read(Path::new("made.csv"), text.as_bytes(), &options).unwrap();
            let top = |c: &[f64]| c.iter().copied().fold(0.0, f64::max);
            let truth = top(&belts(&mut Dice::new(1), &person, &plain(200.0), ["", ""]).columns[0]);
            let read = top(&recording.channels[0].force_n);
            assert!(
                (read / truth - 1.0).abs() < 0.02,
                "{unit} {style}: {read} for {truth} N"
            );
        }
    }
}

#[test]
fn columns_in_a_unit_that_is_none_of_force_are_refused_by_it() {
    let units = [
        "mV", "V", "mV/V", "kPa", "bar", "mbar", "psi", "N/cm²", "ADC", "counts", "bits", "Nm",
        "N.mm", "mm", "deg", "m/s^2",
    ];
    for (seed, unit) in units.into_iter().enumerate() {
        let dice = &mut Dice::new(seed as u64);
        let person = walker(dice, 9.0);
        for style in [
            "left Fz [U],right Fz [U]",
            "left Fz (U),right Fz (U)",
            "row",
        ] {
            let mut table = belts(dice, &person, &plain(200.0), ["left Fz", "right Fz"]);
            let text = if style == "row" {
                let text = table.delimited(CLOCK, false);
                text.replacen('\n', &format!("\ns,{unit},{unit}\n"), 1)
            } else {
                let names = style.replace('U', unit);
                table.names = names.split(',').map(str::to_string).collect();
                table.delimited(CLOCK, false)
            };
            let code = opened(&text, &none()).err().map(|e| e.code().to_string());
            let refused = code.as_deref() == Some("read-no-force-unit");
            assert!(refused, "{unit} {style}: {code:?}");
        }
    }
}

#[test]
fn decimal_commas_between_commas_are_refused_by_that_reason() {
    for seed in 0..20 {
        let dice = &mut Dice::new(seed);
        let person = walker(dice, 6.0);
        let table = belts(dice, &person, &plain(200.0), ["left fz", "right fz"]);
        let points = table.delimited(CLOCK, false);
        assert!(opened(&points, &none()).is_ok());
        let commas = points.replace('.', ",");
        let refused = opened(&commas, &none()).unwrap_err();
        assert_eq!(refused.code(), "read-commas-twice", "{seed}");
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

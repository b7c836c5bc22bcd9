//! Output of `gaitcam gait` for a recording.

use std::f64::consts::PI;
use std::fmt::Write as _;

use gaitcam::force::{Feet, ForceUnit, Interpretation, ReadOptions, cycle, read, stances};
use gaitcam::units::G;
use gaitcam::wording::Language;
use gaitcam_output::gait::{json, table};

/// Recording of two force plates with 10.5 s of walking.
const WALK: &[u8] = include_bytes!("../../../../data/recordings/made_walk.csv");

#[test]
fn json_has_the_promised_keys_and_the_table_the_same_numbers() {
    let r = read("walk.csv".as_ref(), WALK, &ReadOptions::default()).unwrap();
    let s = stances(&r);
    let c = cycle(&r, &s, Feet::Both).unwrap();
    let understood = Interpretation::of("walk.csv", &r, &s, Some(&c), Feet::Both);
    let v = json(&understood, &r, &s, Some(&c));
    for key in [
        "format",
        "rate_hz",
        "duration_s",
        "mass_kg",
        "channels",
        "stances",
        "cycle",
        "warnings",
        "kind",
        "period_s",
        "period_from",
        "mass_from",
        "contacts",
        "doubts",
    ] {
        assert!(v.get(key).is_some(), "{key}");
    }
    for key in ["name", "foot", "baseline_n", "stances", "rejected"] {
        assert!(v["channels"][0].get(key).is_some(), "{key}");
    }
    for key in [
        "foot",
        "start_s",
        "end_s",
        "p1_n",
        "p1_at",
        "valley_n",
        "valley_at",
        "p2_n",
        "p2_at",
    ] {
        assert!(v["stances"][0].get(key).is_some(), "{key}");
    }
    for key in ["from_s", "to_s", "reason"] {
        assert!(v["channels"][1]["rejected"][0].get(key).is_some(), "{key}");
    }
    assert_eq!(v["cycle"]["period_s"], c.curve.period_s);
    assert_eq!(v["cycle"]["mean_n"], c.curve.mean_n());
    assert_eq!(v["stances"].as_array().unwrap().len(), s.used.len());
    let t = table(&understood, &r, &s, Ok(&c), true, Language::En);
    for part in [
        "100.00 Hz",
        "Right Fz",
        &format!("{:.4} s", c.curve.period_s),
    ] {
        assert!(t.contains(part), "{part} is not in\n{t}");
    }
    let refused = Interpretation::of("walk.csv", &r, &s, None, Feet::Both);
    assert!(table(&refused, &r, &s, Err("none"), true, Language::En).ends_with(": none\n"));
}

/// Force at the fraction `x` of a stance of 0.7 s with an amplitude of 1 N.
fn shape(x: f64) -> f64 {
    let inside = (0.0..1.0).contains(&x);
    f64::from(u8::from(inside)) * ((PI * x).sin() + 0.3 * (3.0 * PI * x).sin())
}

const STANCE_S: f64 = 0.7;
const STRIDE_S: f64 = 1.1;
const MASS_KG: f64 = 70.0;

/// Amplitude, N, of a stance of a foot: 12 stances that alternate about their mean by 2 %.
fn amplitude(foot: usize, k: usize) -> f64 {
    [760.0, 720.0][foot] * if k.is_multiple_of(2) { 1.02 } else { 0.98 }
}

/// The twelve strides of both feet as a file sampled at 1000 Hz.
fn walk() -> String {
    let mut text = String::from("time,left fz,right fz\n");
    for i in 0..14_000 {
        let t = f64::from(i) / 1000.0;
        let force = |foot: usize| -> f64 {
            let strike = |k: usize| 0.3 + STRIDE_S * (k as f64 + 0.5 * foot as f64);
            let all = (0..12).map(|k| amplitude(foot, k) * shape((t - strike(k)) / STANCE_S));
            all.sum()
        };
        writeln!(text, "{t:.3},{:.3},{:.3}", force(0), force(1)).unwrap();
    }
    text
}

/// Duration of a stance above 20 N, the threshold of contact, s.
fn stands(amplitude: f64) -> f64 {
    let (mut low, mut high) = (0.0, 0.2);
    for _ in 0..60 {
        let x = 0.5 * (low + high);
        let above = amplitude * shape(x) > 20.0;
        (low, high) = if above { (low, x) } else { (x, high) };
    }
    STANCE_S * (1.0 - 2.0 * low)
}

fn mean_and_deviation(values: &[f64]) -> [f64; 2] {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square: f64 = values.iter().map(|x| (x - mean).powi(2)).sum();
    [mean, (square / (n - 1.0)).sqrt()]
}

#[test]
fn means_of_each_foot_are_those_of_the_stances_that_were_made() {
    let options = ReadOptions {
        mass_kg: Some(MASS_KG),
        ..ReadOptions::default()
    };
    let r = read("made.csv".as_ref(), walk().as_bytes(), &options).unwrap();
    let s = stances(&r);
    let c = cycle(&r, &s, Feet::Both).unwrap();
    let understood = Interpretation::of("made.csv", &r, &s, Some(&c), Feet::Both);
    let t = table(&understood, &r, &s, Ok(&c), true, Language::En);
    let feet = t.split("stance %\n").nth(1).expect("means of the feet");
    let numbers = |line: &str| -> Vec<f64> {
        let words = line.split(|c: char| c.is_whitespace() || c == '%' || c == '/');
        words.filter_map(|w| w.parse().ok()).collect()
    };
    // dF/dx = 0 where cos πx = 0, and where 1 + 0.9 (4 cos² πx − 3) = 0.
    let peak = shape(((1.7f64 / 3.6).sqrt()).acos() / PI);
    let valley = shape(0.5);
    let mut durations = [0.0; 2];
    for (foot, line) in feet.lines().take(2).enumerate() {
        assert!(line.starts_with(["left", "right"][foot]), "{t}");
        let amplitudes: Vec<f64> = (0..12).map(|k| amplitude(foot, k)).collect();
        let forces = amplitudes.iter().map(|a| a / (MASS_KG * G));
        let [mean, deviation] = mean_and_deviation(&forces.collect::<Vec<f64>>());
        let stand: Vec<f64> = amplitudes.iter().map(|&a| stands(a)).collect();
        let [stance, apart] = mean_and_deviation(&stand).map(|s| 100.0 * s / STRIDE_S);
        durations[foot] = stance;
        let truth = [
            12.0,
            mean * peak,
            deviation * peak,
            mean * valley,
            deviation * valley,
            mean * peak,
            deviation * peak,
            stance,
            apart,
        ];
        let shown = numbers(line);
        assert_eq!(shown.len(), truth.len(), "{line}");
        for (k, (shown, truth)) in shown.iter().zip(truth).enumerate() {
            // Three decimals of body weights, one of percent.
            let within = if k < 7 { 1.1e-3 } else { 0.11 };
            assert!((shown - truth).abs() < within, "{line}: {shown}, {truth}");
        }
    }
    let value = |label: &str| -> f64 {
        let line = t.lines().find(|l| l.starts_with(label)).expect(label);
        numbers(line)[0]
    };
    let both: f64 = durations.iter().sum();
    assert!(
        (value("double support") - (both - 100.0)).abs() < 0.11,
        "{t}"
    );
    assert!((value("cadence") - 120.0 / STRIDE_S).abs() < 0.06, "{t}");
    // Impulses are in the ratio of the amplitudes but for the ends below 20 N.
    let symmetry = 200.0 * (720.0 - 760.0) / (720.0 + 760.0);
    assert!((value("symmetry index") - symmetry).abs() < 0.06, "{t}");
}

/// Last lines of the table of a recording whose given columns are clipped at 650 N.
fn clipped(columns: [bool; 2], options: &ReadOptions) -> String {
    let text = String::from_utf8_lossy(WALK);
    let line = |line: &str| {
        let cells = line.split(',').enumerate().map(|(i, cell)| {
            let force: Option<f64> = cell.parse().ok().filter(|_| i > 0 && columns[i - 1]);
            force.map_or(cell.to_string(), |f| f.min(650.0).to_string())
        });
        cells.collect::<Vec<_>>().join(",") + "\n"
    };
    let text: String = text.lines().map(line).collect();
    let r = read("walk.csv".as_ref(), text.as_bytes(), options).unwrap();
    let s = stances(&r);
    let c = cycle(&r, &s, Feet::Both).unwrap();
    let understood = Interpretation::of("walk.csv", &r, &s, Some(&c), Feet::Both);
    table(&understood, &r, &s, Ok(&c), true, Language::En)
}

#[test]
fn a_clipped_column_is_left_out_only_beside_another() {
    let all = ReadOptions::default();
    let of = |force: &str| ReadOptions {
        force: vec![force.to_string()],
        ..ReadOptions::default()
    };
    let refused = "The recording cannot be used";
    let advised = "exclude the clipped column (--force)";
    for (columns, options, says) in [
        ([true, false], &all, true),
        ([true, true], &all, false),
        ([true, false], &of("Left Fz"), false),
    ] {
        let text = clipped(columns, options);
        assert!(text.contains(refused), "{text}");
        assert_eq!(text.contains(advised), says, "{text}");
    }
    // The advice is right: without the clipped column nothing is refused.
    assert!(!clipped([true, false], &of("Right Fz")).contains(refused));
}

#[test]
fn a_question_beside_a_clipped_column_is_asked_only_where_a_column_is_left() {
    // Newtons taken as pounds: a walker of 310 kg.
    let pounds = ReadOptions {
        unit: Some(ForceUnit::PoundForce),
        ..ReadOptions::default()
    };
    let refusal =
        "The recording cannot be used: readings that are clipped below the peaks of the force.";
    let question = "Check the mass and the unit of force. Then give the correct value (options ";
    let acceptance = "), or accept with gait.accept = \"mass\".";
    for (columns, refused, asked) in [
        ([false, false], false, true),
        ([true, false], true, true),
        ([true, true], true, false),
    ] {
        let text = clipped(columns, &pounds);
        assert_eq!(text.contains(refusal), refused, "{text}");
        let line = text.lines().find(|line| line.contains(question));
        assert_eq!(line.is_some(), asked, "{text}");
        // A walker of 310 kg: the unit is wrong, or the force is not of both feet.
        let is_complete =
            |l: &str| l.contains("unit") && l.contains("feet") && l.ends_with(acceptance);
        assert!(line.is_none_or(is_complete), "{text}");
    }
}

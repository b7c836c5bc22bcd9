//! Raw recording of one stance over a part of the turn: the stance fills this part; unloaded time in the file is omitted.

use std::f64::consts::{PI, TAU};
use std::path::Path;

use gaitcam_gait::{Feet, Note, ReadOptions, one_cycle};

use crate::hard::dice::Dice;

/// Force of a stance at a fraction of its duration, N, and its mean over the stance.
fn stance(x: f64) -> f64 {
    match (0.0..1.0).contains(&x) {
        true => 640.0 * ((PI * x).sin() + 0.35 * (3.0 * PI * x).sin()),
        false => 0.0,
    }
}
const MEAN: f64 = 640.0 * (2.0 + 0.35 * 2.0 / 3.0) / PI;

#[test]
fn the_stance_fills_the_span_and_the_rest_of_the_turn_is_unloaded() {
    let dice = &mut Dice::new(11);
    for round in 0..30 {
        let rate = dice.of(&[200.0, 500.0, 1000.0]);
        let (before, lasts, after) = (
            dice.between(0.15, 1.5),
            dice.between(0.55, 0.8),
            dice.between(0.15, 1.5),
        );
        let (level, noise) = (dice.between(-20.0, 20.0), dice.of(&[0.0, 2.0, 8.0]));
        let sign = dice.of(&[1.0, -1.0]);
        let mut text = String::from("time (s),Fz (N)\n");
        for i in 0..((before + lasts + after) * rate) as usize {
            let t = i as f64 / rate;
            let force = stance((t - before) / lasts) + level + noise * dice.normal();
            text += &format!("{t:.4},{:.3}\n", sign * force);
        }
        let span = dice.between(150.0, 300.0_f64).to_radians();
        let period_s = dice.of(&[None, Some(0.5), Some(lasts * TAU / span)]);
        let options = ReadOptions {
            span_rad: Some(span),
            period_s,
            ..ReadOptions::default()
        };
        let curve = one_cycle(Path::new("heel.csv"), text.as_bytes(), &options, Feet::Both)
            .unwrap()
            .unwrap();
        let case = format!("round {round}: {rate} Hz, {noise} N, {period_s:?}");
        assert!(
            (curve.period_s / period_s.unwrap_or(lasts * TAU / span) - 1.0).abs() < 0.03,
            "{case}"
        );
        // The contact begins and ends where it exceeds six deviations of the noise.
        let mean = MEAN * span / TAU;
        let most = 0.012 + 0.002 * noise;
        assert!(
            (curve.mean_n() / mean - 1.0).abs() < most,
            "{case}: {} of {mean}",
            curve.mean_n()
        );
        assert_eq!(curve.at(0.5 * (span + TAU)), 0.0, "{case}");
        let stated = curve.noise_n.unwrap();
        let left = noise * (span / TAU).sqrt();
        assert!(
            (stated - left).abs() < 0.15 * left + 0.01,
            "{case}: {stated} of {left}"
        );
        assert!(
            matches!(
                curve.notes.last(),
                Some(Note::StanceFillsSpan { stances: 1, .. })
            ),
            "{case}"
        );
        // Noise that is given replaces the estimate, and the csv of the curve keeps it.
        let given = ReadOptions {
            noise_n: Some(3.0),
            ..options
        };
        let curve = one_cycle(Path::new("heel.csv"), text.as_bytes(), &given, Feet::Both)
            .unwrap()
            .unwrap();
        let csv = curve.to_csv(&[]);
        let again = one_cycle(
            Path::new("c.csv"),
            csv.as_bytes(),
            &ReadOptions::default(),
            Feet::Both,
        );
        assert_eq!(again.unwrap().unwrap().noise_n, Some(3.0));
    }
}

#[test]
fn a_table_without_idle_time_covers_the_span_as_it_is() {
    let rows: String = (0..=100)
        .map(|i| {
            format!(
                "{:.3},{:.4}\n",
                0.006 * f64::from(i),
                stance(f64::from(i) / 100.0)
            )
        })
        .collect();
    let text = format!("time (s),Fz (N)\n{rows}");
    let options = ReadOptions {
        span_rad: Some(0.6 * TAU),
        ..ReadOptions::default()
    };
    let curve = one_cycle(Path::new("a.csv"), text.as_bytes(), &options, Feet::Both)
        .unwrap()
        .unwrap();
    assert!(curve.notes.is_empty() && (curve.period_s - 1.0).abs() < 1e-9);
    assert!((curve.mean_n() / (0.6 * MEAN) - 1.0).abs() < 2e-3);
}

#[test]
fn a_side_chooses_the_stance_and_a_side_that_is_not_there_is_refused() {
    let mut text = String::from("time (s),Left Fz (N),Right Fz (N)\n");
    for i in 0..600 {
        let t = f64::from(i) / 200.0;
        let (left, right) = (stance((t - 0.5) / 0.7), 1.2 * stance((t - 1.6) / 0.7));
        text += &format!("{t:.3},{left:.2},{right:.2}\n");
    }
    let options = ReadOptions {
        span_rad: Some(0.6 * TAU),
        ..ReadOptions::default()
    };
    let of = |text: &str, feet| one_cycle(Path::new("a.csv"), text.as_bytes(), &options, feet);
    let mean = |feet| of(&text, feet).unwrap().unwrap().mean_n();
    let (left, right) = (mean(Feet::Left), mean(Feet::Right));
    assert!((right / left - 1.2).abs() < 0.01, "{left} {right}");
    assert!((mean(Feet::One) / (1.1 * left) - 1.0).abs() < 0.01);
    let unnamed = text.replace("Left Fz", "Fz1").replace("Right Fz", "Fz2");
    assert!(of(&unnamed, Feet::Left).is_err());
}

//! Mean cycles of recordings whose true mean is known, and the notes on them.

use std::path::Path;

use gaitcam_gait::error::ForceError;
use gaitcam_gait::{
    Cycle, CycleSource, Feet, PeriodSource, ReadOptions, Recording, Stances, cycle, force_curve,
    overlay, read, stances,
};

use crate::fault;

const RATE: f64 = 500.0;

fn stance(x: f64) -> f64 {
    if !(0.0..=1.0).contains(&x) {
        return 0.0;
    }
    let a = std::f64::consts::PI * x;
    700.0 * (a.sin() + 0.35 * (3.0 * a).sin())
}

/// A walk with strides of 1.1 s and stances of 0.68 s, right foot first. The force of step k is multiplied by `1 ± wobble`.
fn walk(seconds: f64, wobble: f64) -> (Recording, Stances) {
    let force = |t: f64, lead: f64| {
        let k = ((t + lead) / 1.1).floor();
        let sign = if k as i64 % 2 == 0 { 1.0 } else { -1.0 };
        (1.0 + sign * wobble) * stance(((t + lead) - 1.1 * k) / 0.68)
    };
    let rows: String = (0..(seconds * RATE) as usize)
        .map(|i| {
            let t = i as f64 / RATE;
            format!("{t:.3},{:.4},{:.4}\n", force(t, 0.75), force(t, 0.2))
        })
        .collect();
    let text = format!("time,right fz,left fz\n{rows}");
    let r = read(
        Path::new("walk.csv"),
        text.as_bytes(),
        &ReadOptions::default(),
    )
    .unwrap();
    let s = stances(&r);
    (r, s)
}

fn of(seconds: f64, wobble: f64, feet: Feet) -> Cycle {
    let (r, s) = walk(seconds, wobble);
    cycle(&r, &s, feet).unwrap()
}

#[test]
fn the_mean_of_equal_strides_is_the_stride() {
    let c = of(12.0, 0.0, Feet::Both);
    assert!((c.curve.period_s - 1.1).abs() < 1e-3);
    let n = c.curve.force_n.len();
    // The stride starts where the force of the leading foot crosses 20 N; that is 0.0095 of its stance.
    let late = 0.68 * 20.0 / (700.0 * std::f64::consts::PI * 2.05);
    let worst = (0..n)
        .map(|i| {
            let t = late + 1.1 * i as f64 / n as f64;
            let true_n: f64 = (-1..=2)
                .map(|k| stance((t - 0.55 * f64::from(k)) / 0.68))
                .sum();
            (c.curve.force_n[i] - true_n).abs()
        })
        .fold(0.0, f64::max);
    // The force below the 20 N threshold is kept. Heel strike is a corner of 2.05 π 700 N in 0.68 s, 13 N per
    // sample: a straight line across it errs by a quarter of that at most.
    assert!(worst < 13.3 / 4.0, "{worst}");
    let mass = 2.0 * 700.0 * std::f64::consts::FRAC_2_PI * (1.0 + 0.35 / 3.0) * 0.68 / 1.1 / 9.81;
    assert!(
        (c.mass_kg / mass - 1.0).abs() < 2e-3,
        "{} {mass}",
        c.mass_kg
    );
}

#[test]
fn spread_and_repeatability_are_those_of_the_steps() {
    // Cycles alternate between 1 + w and 1 - w of the mean, so the deviation is w F √(n/(n−1)).
    let c = of(40.0, 0.03, Feet::Right);
    let spread = c.curve.spread_n.as_ref().unwrap();
    let n = c.averaged as f64;
    let (i, top) = c
        .curve
        .force_n
        .iter()
        .enumerate()
        .max_by(|a, b| a.1.total_cmp(b.1))
        .unwrap();
    let expected = 0.03 * top * (n / (n - 1.0)).sqrt();
    assert!(
        (spread[i] / expected - 1.0).abs() < 0.02,
        "{} {expected}",
        spread[i]
    );
    let rms = (spread.iter().map(|s| s * s).sum::<f64>() / spread.len() as f64).sqrt();
    assert!((c.repeatability_n.unwrap() / (1.96 * 2f64.sqrt() * rms) - 1.0).abs() < 1e-12);
}

#[test]
fn one_foot_is_zero_in_swing_and_carries_half_the_body() {
    let one = of(12.0, 0.0, Feet::One);
    let both = of(12.0, 0.0, Feet::Both);
    let n = one.curve.force_n.len();
    // Before the next heel strike comes the little force below its threshold, 0.0095 of a stance.
    let swing = n * 65 / 100..n * 99 / 100;
    assert!(one.curve.force_n[swing].iter().all(|f| *f == 0.0));
    assert!(one.curve.force_n[n - 1] > 0.0 && one.curve.force_n[n - 1] < 20.0);
    assert!((2.0 * one.curve.mean_n() / both.curve.mean_n() - 1.0).abs() < 5e-3);
    assert!((one.mass_kg / both.mass_kg - 1.0).abs() < 5e-3);
}

#[test]
fn a_single_stance_with_a_mass_gives_the_stride_that_carries_it() {
    let rows: String = (0..600)
        .map(|i| {
            let t = f64::from(i) / RATE;
            format!("{t:.3},{:.4}\n", stance((t - 0.2) / 0.68))
        })
        .collect();
    let text = format!("time,fz\n{rows}");
    let mean = 700.0 * std::f64::consts::FRAC_2_PI * (1.0 + 0.35 / 3.0) * 0.68;
    let mass = 2.0 * mean / 1.1 / 9.81;
    let options = ReadOptions {
        mass_kg: Some(mass),
        ..ReadOptions::default()
    };
    let c = force_curve(Path::new("one.csv"), text.as_bytes(), &options, Feet::Both).unwrap();
    assert!((c.period_s - 1.1).abs() < 1e-4, "{}", c.period_s);
    assert!((c.mean_n() / (mass * 9.81) - 1.0).abs() < 5e-3);
    let e = force_curve(Path::new("one.csv"), text.as_bytes(), &options, Feet::Left).unwrap_err();
    assert_eq!(fault(&e), "one.csv: force-feet-not-named");
}

#[test]
fn both_feet_on_one_belt_give_their_stride_and_standing_gives_none() {
    let total = |t: f64| {
        (-2..2)
            .map(|k| stance((t.rem_euclid(0.55) + 0.55 * f64::from(k)) / 0.68))
            .sum::<f64>()
    };
    let text = |force: &dyn Fn(f64) -> f64| -> String {
        let rows = (0..6000)
            .map(|i| f64::from(i) / RATE)
            .map(|t| format!("{t:.3},{:.3}\n", force(t)));
        format!("time,fz\n{}", rows.collect::<String>())
    };
    let open = |text: String| {
        force_curve(
            Path::new("belt.csv"),
            text.as_bytes(),
            &ReadOptions::default(),
            Feet::Both,
        )
    };
    let c = open(text(&total)).unwrap();
    assert!((c.period_s - 1.1).abs() < 1e-3, "{}", c.period_s);
    let mean = 2.0 * 700.0 * std::f64::consts::FRAC_2_PI * (1.0 + 0.35 / 3.0) * 0.68 / 1.1;
    assert!(
        (c.mean_n() / mean - 1.0).abs() < 2e-3,
        "{} {mean}",
        c.mean_n()
    );
    let high = (0..1100)
        .map(|i| total(f64::from(i) / 1000.0))
        .fold(0.0, f64::max);
    let got = c.force_n.iter().copied().fold(0.0, f64::max);
    assert!((got - high).abs() < 3.0, "{got} {high}");
    let e = open(text(&|t| 700.0 + 20.0 * (9.0 * t).sin())).unwrap_err();
    assert!(
        matches!(
            e.fault(),
            Some(ForceError::NotWalking {
                movement: "standing",
                ..
            })
        ),
        "{e:?}"
    );
}

#[test]
fn feet_that_land_together_do_not_make_a_stride_of_no_length() {
    // Found by fuzzing: steps of zero length made a stride that never ended.
    let rows: String = (0..900)
        .map(|i| f64::from(i) / RATE)
        .map(|t| format!("{t:.3},{0:.3},{0:.3}\n", stance((t - 0.4) / 0.68)))
        .collect();
    let text = format!("time,left fz,right fz\n{rows}");
    let e = force_curve(
        Path::new("jump.csv"),
        text.as_bytes(),
        &ReadOptions::default(),
        Feet::Both,
    )
    .unwrap_err();
    assert_eq!(fault(&e), "jump.csv: force-not-walking");
}

#[test]
fn the_written_cycle_reads_back_bit_for_bit() {
    let c = of(12.0, 0.02, Feet::Both);
    let text = c.curve.to_csv(&[&c.source.to_string()]);
    let back = force_curve(
        Path::new("mean.csv"),
        text.as_bytes(),
        &ReadOptions::default(),
        Feet::Both,
    )
    .unwrap();
    assert_eq!(back.force_n, c.curve.force_n);
    assert_eq!(back.spread_n, c.curve.spread_n);
    assert_eq!(
        (back.period_s, back.mass_kg),
        (c.curve.period_s, c.curve.mass_kg)
    );
}

#[test]
fn the_overlay_holds_the_stances_their_mean_and_band() {
    let (r, s) = walk(40.0, 0.03);
    let o = overlay(&r, &s, 10).unwrap();
    assert!(o.stances.len() <= 10 && o.stances.len() >= 8);
    assert_eq!(o.means.len(), 2, "left and right");
    for mean in &o.means {
        assert!((mean.duration_s - 0.68).abs() < 0.01);
        let middle = mean.mean_n.len() / 2;
        assert!((mean.mean_n[middle] - 455.0).abs() < 3.0 && mean.spread_n.is_some());
        let [p1, valley, p2] = mean.landmarks.map(|p| p.unwrap().force_n);
        assert!((p1 - p2).abs() < 5.0 && (valley - 455.0).abs() < 3.0);
    }
    assert_eq!(overlay(&r, &Stances::default(), 10), None);
}

/// Cycle of feet on two plates; each stance starts at one of the given times, s.
fn of_plates(names: &str, seconds: f64, starts: [&[f64]; 2]) -> Cycle {
    let force =
        |t: f64, starts: &[f64]| -> f64 { starts.iter().map(|s| stance((t - s) / 0.68)).sum() };
    let rows: String = (0..(seconds * RATE) as usize)
        .map(|i| i as f64 / RATE)
        .map(|t| {
            format!(
                "{t:.3},{:.4},{:.4}\n",
                force(t, starts[0]),
                force(t, starts[1])
            )
        })
        .collect();
    let text = format!("time,{names}\n{rows}");
    let r = read(
        Path::new("two.csv"),
        text.as_bytes(),
        &ReadOptions::default(),
    )
    .unwrap();
    cycle(&r, &stances(&r), Feet::Both).unwrap()
}

#[test]
fn stances_on_plates_without_sides_alternate_between_the_feet() {
    let c = of_plates("fz 1,fz 2", 2.0, [&[0.2], &[0.75]]);
    assert!(
        matches!(
            c.source,
            CycleSource::TwoFeet {
                one: 1,
                other: 1,
                ..
            }
        ),
        "{:?}",
        c.source
    );
}

#[test]
fn the_spread_of_a_doubled_step_is_twice_that_of_the_step() {
    // Two steps of 0.55 and 0.60 s with a pause between them, so that no stride is on record.
    let c = of_plates("left fz,right fz", 6.0, [&[0.2, 3.5], &[0.75, 4.1]]);
    assert_eq!(c.period.from, PeriodSource::DoubledSteps);
    assert!((c.period.seconds - 1.15).abs() < 3e-3, "{:?}", c.period);
    let spread = c.period.spread_s.unwrap();
    assert!((spread - 2.0 * 0.05 / 2f64.sqrt()).abs() < 5e-3, "{spread}");
}

#[test]
fn of_strides_without_sides_every_other_one_is_averaged_however_long_the_walk() {
    let starts = |first: f64| -> Vec<f64> { (0..70).map(|k| first + 1.1 * f64::from(k)).collect() };
    let c = of_plates("fz 1,fz 2", 78.0, [&starts(0.2), &starts(0.75)]);
    assert!(
        (66..=70).contains(&c.averaged),
        "{} {:?}",
        c.averaged,
        c.source
    );
}

#[test]
fn slow_steps_are_a_walk_only_where_the_total_hardly_moves() {
    // Steps of 0.95 s: a total that varies by half its mean at that pace is no walk.
    let of = |part: f64| {
        let wave = |t: f64| 700.0 * (1.0 + part * (std::f64::consts::TAU * t / 0.95).sin());
        let rows: String = (0..15000)
            .map(|i| f64::from(i) / RATE)
            .map(|t| format!("{t:.3},{:.3}\n", wave(t)))
            .collect();
        let text = format!("time,fz\n{rows}");
        let options = ReadOptions::default();
        force_curve(Path::new("slow.csv"), text.as_bytes(), &options, Feet::Both)
    };
    assert!((of(0.2).unwrap().period_s - 1.9).abs() < 5e-3);
    assert!(of(0.6).is_err());
}

#[test]
fn a_stated_total_counts_from_the_first_contact_to_the_last() {
    let total = |t: f64| {
        let on_the_plate = (3.0..15.0).contains(&t);
        let steps = (-2..2).map(|k| stance((t.rem_euclid(0.55) + 0.55 * f64::from(k)) / 0.68));
        if on_the_plate {
            steps.sum::<f64>()
        } else {
            0.0
        }
    };
    let rows: String = (0..9000)
        .map(|i| f64::from(i) / RATE)
        .map(|t| format!("{t:.3},{:.3}\n", total(t)))
        .collect();
    let text = format!("time,fz\n{rows}");
    let options = ReadOptions::default();
    let c = force_curve(
        Path::new("total.csv"),
        text.as_bytes(),
        &options,
        Feet::Total,
    )
    .unwrap();
    let mean = 2.0 * 700.0 * std::f64::consts::FRAC_2_PI * (1.0 + 0.35 / 3.0) * 0.68 / 1.1;
    assert!((c.period_s - 1.1).abs() < 1e-3, "{}", c.period_s);
    assert!(
        (c.mean_n() / mean - 1.0).abs() < 2e-3,
        "{} {mean}",
        c.mean_n()
    );
}

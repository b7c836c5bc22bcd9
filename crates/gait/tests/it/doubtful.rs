//! Recordings that could be misread: times that count samples, components in addition to the vertical one, incomplete strikes.

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::path::Path;

use gaitcam_gait::error::{ForceError, Result};
use gaitcam_gait::{
    Cycle, Feet, Note, OpenQuestion, PeriodSource, ReadOptions, Recording, cycle, force_curve,
    read, stances,
};

const STANCE_S: f64 = 0.66;

/// Force of one foot at t s after its heel strike, N; zero outside the stance.
fn stance(t: f64) -> f64 {
    let x = t / STANCE_S;
    if !(0.0..1.0).contains(&x) {
        return 0.0;
    }
    720.0 * ((PI * x).sin() + 0.3 * (3.0 * PI * x).sin())
}

/// Force of one foot with heel strikes at the given times, N.
fn foot(strikes: &[f64], t: f64) -> f64 {
    strikes.iter().map(|s| stance(t - s)).sum()
}

/// Force of the left and of the right foot, with a heel strike every 1.1 s.
fn walk(t: f64) -> (f64, f64) {
    let every = |first: f64| (0..6).map(move |i| first + 1.1 * f64::from(i));
    let left: Vec<f64> = every(0.3).collect();
    let right: Vec<f64> = every(0.85).collect();
    (foot(&left, t), foot(&right, t))
}

fn table(head: &str, rate_hz: f64, row: impl Fn(usize, f64) -> String) -> String {
    let mut text = format!("{head}\n");
    for i in 0..(7.0 * rate_hz) as usize {
        writeln!(text, "{}", row(i, i as f64 / rate_hz)).unwrap();
    }
    text
}

fn open(text: &str) -> (Recording, Result<Cycle>) {
    let r = read(
        Path::new("walk.csv"),
        text.as_bytes(),
        &ReadOptions::default(),
    )
    .unwrap();
    let c = cycle(&r, &stances(&r), Feet::Both);
    (r, c)
}

#[test]
fn a_time_column_that_counts_samples_is_questioned_and_milliseconds_are_not() {
    let of = |rate_hz: f64| {
        let text = table("Time,left fz,right fz", rate_hz, |i, t| {
            let (l, r) = walk(t);
            format!("{i},{l:.2},{r:.2}")
        });
        open(&text).1
    };
    let milliseconds = of(1000.0).unwrap();
    assert!((milliseconds.curve.period_s - 1.1).abs() < 0.005);
    // Samples counted as milliseconds: a stride of 1.1 s at 300 Hz seems to last 0.33 s, at 100 Hz 0.11 s.
    for rate_hz in [300.0, 200.0, 150.0, 100.0] {
        let fault = of(rate_hz).unwrap_err();
        let Some(ForceError::ClockImplausible { period }) = fault.fault() else {
            panic!("{rate_hz} Hz: {fault:?}");
        };
        let seconds = 1.1e-3 * rate_hz;
        assert!(
            (period.value / seconds - 1.0).abs() < 0.1,
            "{rate_hz} Hz: {period:?}"
        );
    }
}

#[test]
fn what_was_guessed_goes_with_the_curve() {
    let text = table("Time,left fz,right fz", 1000.0, |i, t| {
        let (l, r) = walk(t);
        format!("{i},{l:.2},{r:.2}")
    });
    let options = ReadOptions::default();
    let curve = force_curve(Path::new("w.csv"), text.as_bytes(), &options, Feet::Both).unwrap();
    let guessed = |n: &&Note| matches!(n, Note::TimeUnitGuessed { .. });
    assert!(curve.warnings().any(|n| guessed(&n)));
    let understood = curve.recording.unwrap();
    assert_eq!(understood.doubts(), [OpenQuestion::Clock]);
}

#[test]
fn shear_components_beside_the_vertical_one_are_not_read_as_vertical() {
    let text = table(
        "time,L_mlGRF,L_apGRF,L_vGRF,R_mlGRF,R_apGRF,R_vGRF",
        200.0,
        |_, t| {
            let (l, r) = walk(t);
            let (a, b, c, d) = (0.05 * l, 0.1 * l, 0.05 * r, 0.1 * r);
            format!("{t:.3},{a:.2},{b:.2},{l:.2},{c:.2},{d:.2},{r:.2}")
        },
    );
    let (r, c) = open(&text);
    let names: Vec<&str> = r.channels.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["L_vGRF", "R_vGRF"]);
    assert!((c.unwrap().curve.period_s - 1.1).abs() < 0.005);
}

#[test]
fn the_strike_of_a_cut_contact_ends_a_stride() {
    // Left on plate 1, right on plate 2, left again on plate 3, where the recording ends; steps differ.
    let text = table("time,Fz1,Fz2,Fz3", 200.0, |_, t| {
        let plates = [foot(&[4.9], t), foot(&[5.40], t), foot(&[6.04], t)];
        let [a, b, c] = plates.map(|f| f + 0.2 * (70.0 * t).sin());
        format!("{t:.3},{a:.2},{b:.2},{c:.2}")
    });
    let cut = text
        .lines()
        .take(1 + 6 * 200 + 80)
        .collect::<Vec<_>>()
        .join("\n");
    let c = open(&cut).1.unwrap();
    assert_eq!(c.period.from, PeriodSource::HeelStrikes);
    assert!(
        (c.curve.period_s - 1.14).abs() < 0.004,
        "{}",
        c.curve.period_s
    );
}

#[test]
fn a_person_who_stands_throughout_gives_no_cycle() {
    let text = table("time,total fz", 200.0, |_, t| {
        format!("{t:.3},{:.2}", 690.0 + 25.0 * (2.0 * t).sin())
    });
    assert!(open(&text).1.is_err());
}

/// Total force of a landing from a height, in body weights: an impact of `peak`, settling, then standing until `leaves` with a `sway`.
fn landing(t: f64, peak: f64, leaves: f64, sway: f64) -> f64 {
    if !(0.0..leaves).contains(&t) {
        return 0.0;
    }
    let hump = |at: f64, width: f64| (-((t - at) / width).powi(2)).exp();
    let rise = (t / 0.03).min(1.0) * ((leaves - t) / 0.2).min(1.0);
    rise * (1.0 + sway * (7.0 * t).sin() + peak * hump(0.06, 0.03) + 0.6 * peak * hump(0.16, 0.07))
}

#[test]
fn landings_from_a_height_are_refused_as_jumps_on_one_plate_and_on_two() {
    let mut built = 0;
    for (peak, leaves) in [(1.5, 9.0), (2.5, 9.0), (2.5, 0.6), (3.5, 0.9), (2.5, 1.5)] {
        for (head, shares) in [
            ("time,Fz", &[1.0][..]),
            ("time,Fz1,Fz2", &[0.48, 0.52]),
            ("time,left fz,right fz", &[0.48, 0.52]),
        ] {
            // Without sway most samples are equal to the last digit.
            for sway in [0.005, 0.0] {
                let text = table(head, 500.0, |_, t| {
                    let total = 690.0 * landing(t - 0.5, peak, leaves, sway);
                    let columns = shares.iter().map(|share| format!(",{:.1}", share * total));
                    format!("{t:.3}{}", columns.collect::<String>())
                });
                let refused = open(&text).1.unwrap_err();
                let case = format!("{peak} {leaves} {sway} {head}: {refused}");
                assert_eq!(refused.code(), "force-not-walking", "{case}");
                assert!(
                    refused.to_string().contains("land at the same time"),
                    "{case}"
                );
                built += 1;
            }
        }
    }
    assert_eq!(built, 30);
}

#[test]
fn feet_that_rise_from_a_chair_together_and_sit_down_again_do_not_walk() {
    // Seated with the feet off the plates, standing for 2.4 s of every 4 s.
    let text = table("time,left fz,right fz", 200.0, |_, t| {
        let x = (t % 4.0 - 0.6) / 2.4;
        let rise = (8.0 * x).min(8.0 * (1.0 - x)).clamp(0.0, 1.0);
        let total = 690.0 * rise * (1.0 + 0.1 * (20.0 * t).sin());
        format!("{t:.3},{:.1},{:.1}", 0.48 * total, 0.52 * total)
    });
    let refused = open(&text).1.unwrap_err();
    assert!(refused.to_string().contains("the load rises"), "{refused}");
}

//! Long tables of standardised gait data: one cycle for each subject, task and step.

use std::path::Path;

use gaitcam_gait::error::ReadError;
use gaitcam_gait::{ReadOptions, force_curve, read};

use crate::fault;
use crate::hard::dice::Dice;

const ROWS: usize = 150;

/// Vertical force of a foot in body weights at a fraction of the cycle, with a mean of one half.
fn share(phase: f64) -> f64 {
    let x = phase / 0.62;
    if x > 1.0 {
        return 0.0;
    }
    let a = std::f64::consts::PI * x;
    let mean = 0.62 * (2.0 + 0.35 * 2.0 / 3.0) / std::f64::consts::PI;
    0.5 / mean * (a.sin() + 0.35 * (3.0 * a).sin())
}

/// A long table with given numbers of subjects, tasks and steps.
fn table(dice: &mut Dice, subjects: usize, tasks: usize, steps: usize) -> String {
    let s = dice.of(&[",", ";", "\t"]);
    let words = dice.chance(60.0);
    let names = [
        "subject",
        "task",
        "step",
        "phase_ipsi",
        "knee_flexion_angle_ipsi_rad",
        "grf_vertical_ipsi_BW",
    ];
    let mut text = names.join(s) + "\n";
    for (subject, task, step) in
        (0..subjects * tasks * steps).map(|k| (k / (tasks * steps), k / steps % tasks, k % steps))
    {
        let (subject, task) = match words {
            true => (
                format!("UM21_AB{subject:02}"),
                ["level_walking", "incline_walking"][task].into(),
            ),
            false => (subject.to_string(), task.to_string()),
        };
        let factor = dice.between(0.95, 1.05);
        for i in 0..ROWS {
            let phase = i as f64 / ROWS as f64;
            let row = [
                subject.clone(),
                task.clone(),
                step.to_string(),
                format!("{:.4}", 100.0 * phase),
                format!("{:.4}", dice.between(-0.1, 1.0)),
                format!("{:.6}", factor * share(phase)),
            ];
            text += &(row.join(s) + "\n");
        }
    }
    text
}

#[test]
fn a_long_table_is_the_mean_of_its_cycles_where_the_period_is_given() {
    let path = Path::new("umich_phase.csv");
    for seed in 0..30 {
        let dice = &mut Dice::new(seed);
        let (subjects, tasks, steps) = (dice.of(&[1, 3, 10]), dice.of(&[1, 2]), dice.of(&[1, 5]));
        let text = table(dice, subjects, tasks, steps);
        let cycles = subjects * tasks * steps;
        let (mass, period) = (dice.between(45.0, 110.0), dice.between(0.95, 1.3));
        let e = read(path, text.as_bytes(), &ReadOptions::default()).unwrap_err();
        let name = fault(&e);
        assert_eq!(
            name, "umich_phase.csv line 1: read-long-table",
            "seed {seed}"
        );
        let known = ReadError::LongTable { cycles };
        assert_eq!(e.fault(), Some(&known), "seed {seed}");
        let given = ReadOptions {
            period_s: Some(period),
            mass_kg: Some(mass),
            ..ReadOptions::default()
        };
        let curve = force_curve(path, text.as_bytes(), &given, Default::default());
        if tasks > 1 {
            let e = curve.unwrap_err();
            let name = fault(&e);
            assert_eq!(
                name, "umich_phase.csv line 1: read-long-tasks",
                "seed {seed}"
            );
            continue;
        }
        let curve = curve.unwrap();
        assert!((curve.period_s - period).abs() < 1e-9, "seed {seed}");
        assert_eq!(curve.spread_n.is_some(), cycles > 1, "seed {seed}");
        // The cycles of a table differ by a random factor with a mean near one.
        let factor = curve.mean_n() / (0.5 * mass * 9.80665);
        assert!((factor - 1.0).abs() < 0.1, "seed {seed}: {factor}");
        for k in 0..100 {
            let phase = f64::from(k) / 100.0;
            let wanted = factor * share(phase) * mass * 9.80665;
            let force = curve.at(std::f64::consts::TAU * phase);
            assert!(
                (force - wanted).abs() < 0.02 * mass * 9.80665,
                "seed {seed}, {phase}"
            );
        }
    }
}

#[test]
fn percent_parts_and_closed_cycles_are_one_turn() {
    for (whole, rows, closed) in [(100.0, 100, true), (100.0, 150, false), (1.0, 100, true)] {
        let mut text = String::from("subject,step,phase_ipsi_dot,phase_ipsi,grf_vertical_ipsi_N\n");
        let last = if closed { rows } else { rows - 1 };
        for i in 0..=last {
            let phase = f64::from(i) / f64::from(rows);
            text += &format!("A,1,3.0,{},{}\n", whole * phase, 700.0 * share(phase % 1.0));
        }
        let given = ReadOptions {
            period_s: Some(1.1),
            ..ReadOptions::default()
        };
        let curve = force_curve(
            Path::new("a.csv"),
            text.as_bytes(),
            &given,
            Default::default(),
        );
        let curve = curve.unwrap();
        assert_eq!(curve.force_n.len(), rows as usize);
        assert!(
            (curve.mean_n() / 350.0 - 1.0).abs() < 1e-3,
            "{}",
            curve.mean_n()
        );
    }
}

#[test]
fn a_damaged_long_table_is_refused_at_its_line() {
    let head = "subject,step,phase_ipsi,grf_vertical_ipsi_N,grf_vertical_contra_N\n";
    let rows = |at: usize, row: &str| -> String {
        let row_of = |i: usize| format!("A,1,{},{},1\n", 10 * i, 100 * i);
        let of = |i: usize| {
            if i == at {
                format!("{row}\n")
            } else {
                row_of(i)
            }
        };
        head.to_string() + &(0..10).map(of).collect::<String>()
    };
    let given = ReadOptions {
        period_s: Some(1.0),
        ..ReadOptions::default()
    };
    let refused = |text: &str| {
        let e = force_curve(
            Path::new("a.csv"),
            text.as_bytes(),
            &given,
            Default::default(),
        );
        fault(&e.unwrap_err())
    };
    assert_eq!(
        refused(&rows(3, "A,1,30,nothing,1")),
        "a.csv line 5: read-cycle-value"
    );
    assert_eq!(
        refused(&rows(4, "A,1,20,400,1")),
        "a.csv line 6: read-time-backwards"
    );
    assert_eq!(
        refused(&rows(9, "A,2,90,400,1")),
        "a.csv line 2: read-few-samples"
    );
    assert_eq!(refused(&rows(0, "A")), "a.csv line 2: read-cycle-value");
    let both = ReadOptions {
        force: vec!["4".into(), "5".into()],
        ..given.clone()
    };
    let text = rows(99, "");
    let e = force_curve(
        Path::new("a.csv"),
        text.as_bytes(),
        &both,
        Default::default(),
    );
    assert_eq!(fault(&e.unwrap_err()), "a.csv line 1: read-long-forces");
    let two = text
        .replace("_ipsi_N", "_left_N")
        .replace("_contra_N", "_right_N");
    assert_eq!(refused(&two), "a.csv line 1: read-long-forces");
}

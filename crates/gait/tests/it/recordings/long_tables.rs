//! Long tables of standardised gait sets: a cycle for every subject, task and step.

use std::path::Path;

use gaitcam_gait::error::ReadError;
use gaitcam_gait::{ReadOptions, force_curve, read};

use crate::fault;
use crate::hard::dice::Dice;

const ROWS: usize = 150;

/// Vertical force of a foot in body weights at a part of the cycle, with a mean of one half.
fn share(phase: f64) -> f64 {
    let x = phase / 0.62;
    if x > 1.0 {
        return 0.0;
    }
    let a = std::f64::consts::PI * x;
    let mean = 0.62 * (2.0 + 0.35 * 2.0 / 3.0) / std::f64::consts::PI;
    0.5 / mean * (a.sin() + 0.35 * (3.0 * a).sin())
}

/// A table of so many subjects, tasks and steps.
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
        for i in 0..ROWS {
            let phase = i as f64 / ROWS as f64;
            let row = [
                subject.clone(),
                task.clone(),
                step.to_string(),
                format!("{:.4}", 100.0 * phase),
                format!("{:.4}", dice.between(-0.1, 1.0)),
                format!("{:.6}", share(phase)),
            ];
            text += &(row.join(s) + "\n");
        }
    }
    text
}

#[test]
fn long_tables_are_refused_with_their_cycles_and_one_cycle_of_them_is_read() {
    let path = Path::new("umich_phase.csv");
    for seed in 0..15 {
        let dice = &mut Dice::new(seed);
        let (subjects, tasks, steps) = (dice.of(&[1, 3, 10]), dice.of(&[1, 2]), dice.of(&[1, 5]));
        let text = table(dice, subjects, tasks, steps);
        let cycles = subjects * tasks * steps;
        let (mass, period) = (dice.between(45.0, 110.0), dice.between(0.95, 1.3));
        let given = ReadOptions {
            period_s: Some(period),
            mass_kg: Some(mass),
            time: Some("phase_ipsi".into()),
            force: vec!["grf_vertical_ipsi_BW".into()],
            ..ReadOptions::default()
        };
        for e in [
            read(path, text.as_bytes(), &ReadOptions::default()).unwrap_err(),
            read(path, &text.as_bytes()[..text.len() - 9], &given).unwrap_err(),
            force_curve(path, text.as_bytes(), &given, Default::default()).unwrap_err(),
        ] {
            assert_eq!(
                fault(&e),
                "umich_phase.csv line 1: read-long-table",
                "seed {seed}"
            );
            assert_eq!(
                e.fault(),
                Some(&ReadError::LongTable { cycles }),
                "seed {seed}"
            );
        }
        // The advice: phase and force of one cycle, with what the options say.
        let rows = text.lines().take(ROWS + 1);
        let one = rows.map(|line| {
            let fields: Vec<&str> = line.split([',', ';', '\t']).collect();
            format!("{},{}\n", fields[3], fields[5])
        });
        let one: String = one.collect();
        let curve = force_curve(path, one.as_bytes(), &given, Default::default()).unwrap();
        let mean = curve.force_n.iter().sum::<f64>() / curve.force_n.len() as f64;
        assert!(
            (mean / (0.5 * mass * 9.80665) - 1.0).abs() < 0.01,
            "seed {seed}: {mean}"
        );
        assert!((curve.period_s - period).abs() < 1e-9, "seed {seed}");
    }
}

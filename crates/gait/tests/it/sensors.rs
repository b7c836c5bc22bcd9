//! Exports of pressure insoles with single sensors, with and without the force of each foot.

use std::path::Path;

use gaitcam_gait::error::ReadError;
use gaitcam_gait::{ForceUnit, ReadOptions, Recording, force_curve, read, stances};

use crate::hard::dice::Dice;
use crate::{fault, notes};

/// A walk of two equal feet on insoles, with its true values.
struct Walk {
    mass_kg: f64,
    period_s: f64,
    sensors: usize,
    separator: &'static str,
    first: usize,
}

const RATE: f64 = 100.0;

impl Walk {
    fn of(dice: &mut Dice) -> Self {
        Walk {
            mass_kg: dice.between(45.0, 110.0),
            period_s: dice.between(0.95, 1.25),
            sensors: dice.of(&[16, 99, 198]),
            separator: dice.of(&["\t", ";", ","]),
            first: dice.of(&[0, 1]),
        }
    }

    /// Force of one foot, N: a stance of 62 % of the stride, with a mean of half the weight.
    fn foot(&self, t: f64, lead: f64) -> f64 {
        let x = (t / self.period_s + lead).rem_euclid(1.0) / 0.62;
        if x > 1.0 {
            return 0.0;
        }
        let a = std::f64::consts::PI * x;
        let mean = 0.62 * (2.0 + 0.35 * 2.0 / 3.0) / std::f64::consts::PI;
        0.5 * self.mass_kg * 9.80665 / mean * (a.sin() + 0.35 * (3.0 * a).sin())
    }

    /// Text with the lines above, the names, and rows with time, pressures and the columns of `more`.
    fn text(&self, head: &str, more: &str, row: impl Fn(f64, f64) -> String) -> String {
        let s = self.separator;
        let names = (0..self.sensors).map(|k| format!("{s}{}", k + self.first));
        let mut text = format!("{head}time[secs]{}{more}\n", names.collect::<String>());
        for i in 0..1200 {
            let t = f64::from(i) / RATE;
            let (l, r) = (self.foot(t, 0.9), self.foot(t, 0.4));
            text += &format!("{t:.3}");
            for k in 0..self.sensors {
                let load = if 2 * k < self.sensors { l } else { r };
                text += &format!("{s}{:.1}", load / 30.0 * (1.0 + (k % 7) as f64 / 7.0));
            }
            text += &format!("{}\n", row(l, r));
        }
        text
    }
}

fn opened(text: &str, options: &ReadOptions) -> gaitcam_gait::error::Result<Recording> {
    read(Path::new("pedar.asc"), text.as_bytes(), options)
}

const HEADS: [&str; 3] = [
    "",
    "sensor type: pedar-x insoles\ninsole: X\n\n\n\n\n\npressure values in kPa\n",
    "file name: walk\npressure values in kPa\n\n",
];

#[test]
fn pressures_of_single_sensors_are_refused_as_such() {
    for seed in 0..12 {
        let dice = &mut Dice::new(seed);
        let walk = Walk::of(dice);
        let head = dice.of(&HEADS);
        let text = walk.text(head, "", |_, _| String::new());
        let line = head.lines().count() + 1;
        let none = ReadOptions::default();
        let named = ReadOptions {
            force: vec!["4".into()],
            ..ReadOptions::default()
        };
        let e = opened(&text, &none).unwrap_err();
        assert_eq!(
            fault(&e),
            format!("pedar.asc line {line}: read-single-sensors"),
            "seed {seed}"
        );
        let sensors = walk.sensors;
        assert_eq!(e.fault(), Some(&ReadError::SingleSensors { sensors }));
        // A named column is taken, unless the file says that it is a pressure.
        let by_name = opened(&text, &named);
        assert_eq!(by_name.is_err(), head.contains("kPa"), "seed {seed}");
        // So is a pressure with its unit, and the names of the sensors are no row.
        let stated = ReadOptions {
            unit: Some(ForceUnit::Decanewton),
            ..named
        };
        let recording = opened(&text, &stated).unwrap();
        assert_eq!(recording.channels[0].force_n.len(), 1200, "seed {seed}");
        assert!(!stances(&recording).used.is_empty());
        let cut = &text[..text.len() / 2];
        assert!(opened(cut, &none).is_err());
    }
}

#[test]
fn forces_beside_the_pressures_are_read() {
    for seed in 20..28 {
        let walk = Walk::of(&mut Dice::new(seed));
        let s = walk.separator;
        let more = format!("{s}left force[N]{s}right force[N]");
        let text = walk.text(HEADS[2], &more, |l, r| format!("{s}{l:.2}{s}{r:.2}"));
        let path = Path::new("pedar.asc");
        let none = ReadOptions::default();
        let curve = force_curve(path, text.as_bytes(), &none, Default::default()).unwrap();
        let mass = curve.mass_kg.unwrap();
        assert!(
            (curve.period_s / walk.period_s - 1.0).abs() < 0.01,
            "seed {seed}"
        );
        assert!(
            (mass / walk.mass_kg - 1.0).abs() < 0.03,
            "seed {seed}: {mass}"
        );
    }
}

/// Plates and insoles of the same walk in one table; the readings of the insoles are multiplied by `gain`.
fn both_families(walk: &Walk, families: [[&str; 2]; 2], insole_first: bool, gain: f64) -> String {
    let s = walk.separator;
    let [insole, plate] = families.map(|f| f.join(s));
    let put = |insole: &str, plate: &str| match insole_first {
        true => format!("{s}{insole}{s}{plate}\n"),
        false => format!("{s}{plate}{s}{insole}\n"),
    };
    let mut text = format!("time (s){}", put(&insole, &plate));
    for i in 0..1200 {
        let t = f64::from(i) / RATE;
        let (l, r) = (walk.foot(t, 0.9), walk.foot(t, 0.4));
        let pair = |k: f64| format!("{:.2}{s}{:.2}", k * l, k * r);
        text += &format!("{t:.3}{}", put(&pair(gain), &pair(1.0)));
    }
    text
}

#[test]
fn of_an_insole_beside_a_plate_the_plate_is_taken_and_both_are_named() {
    let families = [
        [
            ["Insole left Fz (N)", "Insole right Fz (N)"],
            ["FP1 Fz (N)", "FP2 Fz (N)"],
        ],
        [["L_insole_force", "R_insole_force"], ["fz1_N", "fz2_N"]],
        [
            ["pedar left force[N]", "pedar right force[N]"],
            ["left belt Fz", "right belt Fz"],
        ],
        [
            [
                "Plantilla izquierda Fuerza (N)",
                "Plantilla derecha Fuerza (N)",
            ],
            ["Placa 1 Fz", "Placa 2 Fz"],
        ],
    ];
    for seed in 40..60 {
        let dice = &mut Dice::new(seed);
        let walk = Walk::of(dice);
        let (names, gain) = (dice.of(&families), dice.between(0.6, 1.4));
        let text = both_families(&walk, names, dice.chance(50.0), gain);
        let read = |options: &ReadOptions| {
            let recording = opened(&text, options).unwrap();
            let curve = force_curve(
                Path::new("a.csv"),
                text.as_bytes(),
                options,
                Default::default(),
            );
            (recording, curve.unwrap())
        };
        let (recording, curve) = read(&ReadOptions::default());
        let said = |r: &Recording| notes(r).contains(&"note-insole-beside-plate".to_string());
        let columns: Vec<&str> = recording.channels.iter().map(|c| &*c.name).collect();
        assert_eq!(columns, names[1], "seed {seed}");
        assert!(said(&recording) && !recording.insole, "seed {seed}");
        let mass = curve.mass_kg.unwrap();
        assert!(
            (mass / walk.mass_kg - 1.0).abs() < 0.03,
            "seed {seed}: {mass}"
        );
        assert!(
            (curve.period_s / walk.period_s - 1.0).abs() < 0.01,
            "seed {seed}"
        );
        // The insole is taken where its columns are named, and known as one.
        let named = ReadOptions {
            force: names[0].map(String::from).to_vec(),
            ..ReadOptions::default()
        };
        let (recording, curve) = read(&named);
        assert!(recording.insole && !said(&recording), "seed {seed}");
        let mass = curve.mass_kg.unwrap();
        assert!(
            (mass / walk.mass_kg / gain - 1.0).abs() < 0.03,
            "seed {seed}: {mass}"
        );
    }
}

//! Force plates of one trial in one file each, as Qualisys writes them. Together they are one recording.

use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::support::{gaitcam, object, stderr, stdout};

const RATE_HZ: f64 = 300.0;

/// A walk over a row of plates, one step on each.
struct Walk {
    mass_kg: f64,
    stride_s: f64,
    plates: usize,
}

impl Walk {
    /// Force of a plate at a time, N. The mean of both feet over a stride is the weight.
    fn force(&self, plate: usize, t: f64) -> f64 {
        let stance = 0.62 * self.stride_s;
        let x = (t - 0.4 - 0.5 * self.stride_s * plate as f64) / stance;
        // Mean of the two sines over a stance: 2/π (1 + 0.25/3).
        let level = self.mass_kg * 9.81 / (2.0 * 0.62) / (2.0 / PI * (1.0 + 0.25 / 3.0));
        let on = (0.0..1.0).contains(&x);
        if on {
            level * ((PI * x).sin() + 0.25 * (3.0 * PI * x).sin())
        } else {
            0.0
        }
    }

    /// Text of the file of a plate. A plate without contact contains noise of 1 N.
    fn file(&self, stamp: &str, plate: usize) -> String {
        let seconds = 0.8 + 0.5 * self.stride_s * (self.plates + 1) as f64;
        let samples = (RATE_HZ * seconds) as usize;
        let mut text = format!(
            "NO_OF_SAMPLES\t{samples}\nFREQUENCY\t{RATE_HZ}\nTIME_STAMP\t{stamp}\nFIRST_SAMPLE\t1\n\
             DESCRIPTION\tForce data\nFORCE_PLATE_NAME\tForce-plate {}\n\
             Force_X\tForce_Y\tForce_Z\tMoment_X\tMoment_Y\tMoment_Z\tCOP_X\tCOP_Y\tCOP_Z\n",
            plate + 1
        );
        for i in 0..samples {
            let noise = 0.6 * (1.7 * i as f64).sin();
            let stepped_on = plate < self.plates;
            let force = if stepped_on {
                self.force(plate, i as f64 / RATE_HZ)
            } else {
                0.0
            };
            text += &format!(
                "1.0\t-2.0\t{:.3}\t50.0\t60.0\t1.0\t300.0\t200.0\t0.0\n",
                force + noise
            );
        }
        text
    }

    /// Writes the files of all plates into a folder, one plate without contact among them.
    fn write(&self, folder: &Path, name: &str, stamp: &str) -> Vec<PathBuf> {
        let write = |plate: usize| {
            let path = folder.join(format!("{name}_f_{}.tsv", plate + 1));
            fs::write(&path, self.file(stamp, plate)).unwrap();
            path
        };
        (0..=self.plates).map(write).collect()
    }
}

fn near(value: &Value, truth: f64, share: f64) {
    let value = value.as_f64().unwrap();
    assert!((value / truth - 1.0).abs() < share, "{value} for {truth}");
}

fn json(arguments: &[&str]) -> Value {
    object(&gaitcam(&[&["gait", "--json"], arguments].concat()))
}

/// Random walks over two to five plates.
fn walks() -> impl Iterator<Item = Walk> {
    (0..12u32).map(|k| Walk {
        mass_kg: 45.0 + 5.5 * f64::from(k),
        stride_s: 0.95 + 0.04 * f64::from((7 * k) % 12),
        plates: 2 + (k as usize) % 4,
    })
}

#[test]
fn plates_of_one_trial_named_together_are_one_recording() {
    for walk in walks() {
        let folder = tempfile::tempdir().unwrap();
        let files = walk.write(folder.path(), "walk", "2015-10-06, 12:24:07");
        let files: Vec<&str> = files.iter().map(|f| f.to_str().unwrap()).collect();
        let read = json(&files);
        assert_eq!(read["channels"].as_array().unwrap().len(), walk.plates + 1);
        assert_eq!(read["stances"].as_array().unwrap().len(), walk.plates);
        near(&read["cycle"]["period_s"], walk.stride_s, 0.01);
        near(&read["mass_kg"], walk.mass_kg, 0.02);
        let shown = gaitcam(&[&["gait"], &files[..]].concat());
        let said = stdout(&shown) + &stderr(&shown);
        assert!(said.contains("Force-plate 2 Force_Z"), "{said}");
        assert!(!said.contains("unit BW"), "{said}");
    }
}

#[test]
fn plates_in_a_folder_are_gathered_by_trial_and_copies_stay_apart() {
    let folder = tempfile::tempdir().unwrap();
    let stamps = ["2015-10-06, 12:24:07", "2015-10-06, 12:25:31"];
    let walks: Vec<Walk> = walks().take(2).collect();
    for ((walk, stamp), name) in walks.iter().zip(stamps).zip(["a", "b"]) {
        walk.write(folder.path(), name, stamp);
    }
    let path = folder.path().to_str().unwrap();
    let read = json(&[path]);
    let trials = read["recordings"].as_array().unwrap();
    assert_eq!(trials.len(), 2, "{read:#}");
    for (trial, walk) in trials.iter().zip(&walks) {
        near(&trial["cycle"]["period_s"], walk.stride_s, 0.01);
        let file = trial["file"].as_str().unwrap();
        assert_eq!(file.matches(" + ").count(), walk.plates, "{file}");
    }
    // The same plate once more is another recording.
    let first = folder.path().join("a_f_1.tsv");
    fs::copy(&first, folder.path().join("copy.tsv")).unwrap();
    let read = json(&[path]);
    assert_eq!(read["recordings"].as_array().unwrap().len(), 3);
}

#[test]
fn a_plate_whose_file_ends_early_ends_the_recording() {
    let walk = Walk {
        mass_kg: 70.0,
        stride_s: 1.1,
        plates: 2,
    };
    let folder = tempfile::tempdir().unwrap();
    let files = walk.write(folder.path(), "walk", "2015-10-06, 12:24:07");
    let whole = fs::read_to_string(&files[1]).unwrap();
    let lines: Vec<&str> = whole.lines().collect();
    fs::write(&files[1], lines[..lines.len() - 90].join("\n")).unwrap();
    let files: Vec<&str> = files.iter().map(|f| f.to_str().unwrap()).collect();
    let read = json(&files);
    near(
        &read["duration_s"],
        (lines.len() - 7 - 90 - 1) as f64 / RATE_HZ,
        1e-9,
    );
    near(&read["mass_kg"], 70.0, 0.02);
}

#[test]
fn a_scene_names_the_plates_of_a_trial_together_as_gait_prints_them() {
    for walk in walks().take(4) {
        let folder = tempfile::tempdir().unwrap();
        let files = walk.write(folder.path(), "walk", "2015-10-06, 12:24:07");
        let names: Vec<&str> = files.iter().map(|f| f.to_str().unwrap()).collect();
        let read = json(&names);
        let out = folder.path().join("cam");
        let file = format!("gait.file={}", names.join(" + "));
        let design = |file: &str| {
            let out = out.to_str().unwrap();
            gaitcam(&[
                "synth",
                "measured_walk",
                "--set",
                file,
                "--out",
                out,
                "--json",
            ])
        };
        let summary = object(&design(&file));
        near(
            &summary["recording"]["mass_kg"],
            read["mass_kg"].as_f64().unwrap(),
            1e-12,
        );
        let period = read["cycle"]["period_s"].as_f64().unwrap();
        near(
            &summary["drive"]["speed_rad_per_s"],
            2.0 * PI / period,
            1e-6,
        );
        // The folder's own scene names them whole: it gives the same cam from anywhere.
        let again = out.join("scene.toml");
        let again = gaitcam(&[
            "synth",
            again.to_str().unwrap(),
            "--out",
            out.to_str().unwrap(),
            "--json",
        ]);
        assert_eq!(object(&again)["law"], summary["law"]);
        // Files of two trials, and one plate twice, are no recording.
        let other = folder.path().join("other.tsv");
        fs::write(&other, walk.file("2015-10-07, 09:00:00", 1)).unwrap();
        for second in [other.to_str().unwrap(), names[0]] {
            let run = design(&format!("gait.file={} + {second}", names[0]));
            assert_eq!(run.status.code(), Some(2));
            assert!(
                stderr(&run).contains("plates of the same trial"),
                "{}",
                stderr(&run)
            );
        }
    }
}

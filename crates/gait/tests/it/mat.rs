//! Synthetic MAT files of MATLAB: structs, matrices with labels, both byte orders, compressed or not, and damaged.

use std::path::Path;

use gaitcam_gait::error::ReadError;
use gaitcam_gait::units::G;
use gaitcam_gait::{Feet, Format, ReadOptions, Recording, cycle, read, stances};

use crate::hard::dice::Dice;

/// Data element with tag, data and padding.
fn element(kind: u32, data: &[u8], big: bool) -> Vec<u8> {
    let mut out = [word(kind, big), word(data.len() as u32, big)].concat();
    out.extend(data);
    out.resize(out.len().next_multiple_of(8), 0);
    out
}

fn word(x: u32, big: bool) -> Vec<u8> {
    if big {
        x.to_be_bytes()
    } else {
        x.to_le_bytes()
    }
    .to_vec()
}

fn array(
    class: u8,
    rows: usize,
    columns: usize,
    name: &str,
    parts: &[Vec<u8>],
    big: bool,
) -> Vec<u8> {
    let flags = [word(u32::from(class), big), word(0, big)].concat();
    let sizes = [word(rows as u32, big), word(columns as u32, big)].concat();
    let mut body = element(6, &flags, big);
    body.extend(element(5, &sizes, big));
    body.extend(element(1, name.as_bytes(), big));
    body.extend(parts.concat());
    element(14, &body, big)
}

/// Matrix of f64, given by columns.
fn numbers(name: &str, columns: &[&[f64]], big: bool) -> Vec<u8> {
    let bytes = |x: &f64| {
        if big {
            x.to_be_bytes()
        } else {
            x.to_le_bytes()
        }
    };
    let data: Vec<u8> = columns
        .iter()
        .flat_map(|c| c.iter().flat_map(bytes))
        .collect();
    array(
        6,
        columns[0].len(),
        columns.len(),
        name,
        &[element(9, &data, big)],
        big,
    )
}

fn texts(name: &str, all: &[&str], big: bool) -> Vec<u8> {
    let cell = |text: &&str| {
        array(
            4,
            1,
            text.len(),
            "",
            &[element(16, text.as_bytes(), big)],
            big,
        )
    };
    array(
        1,
        1,
        all.len(),
        name,
        &all.iter().map(cell).collect::<Vec<_>>(),
        big,
    )
}

/// Struct whose fields are arrays without names.
fn structure(name: &str, fields: &[(&str, Vec<u8>)], big: bool) -> Vec<u8> {
    let mut names = Vec::new();
    for (field, _) in fields {
        let mut bytes = field.as_bytes().to_vec();
        bytes.resize(32, 0);
        names.extend(bytes);
    }
    let mut parts = vec![element(5, &word(32, big), big), element(1, &names, big)];
    parts.extend(fields.iter().map(|(_, value)| value.clone()));
    array(2, 1, 1, name, &parts, big)
}

fn file(variables: &[Vec<u8>], big: bool, compressed: bool) -> Vec<u8> {
    let mut out = b"MATLAB 5.0 MAT-file of a test".to_vec();
    out.resize(124, b' ');
    out.extend(if big { [1, 0] } else { [0, 1] });
    out.extend(if big { b"MI" } else { b"IM" });
    for variable in variables {
        if compressed {
            let packed = miniz_oxide::deflate::compress_to_vec_zlib(variable, 6);
            out.extend([word(15, big), word(packed.len() as u32, big)].concat());
            out.extend(packed);
        } else {
            out.extend(variable);
        }
    }
    out
}

/// Time, s, and force of both feet, N, of a walker with a given mass and stride time, s.
fn walk(mass: f64, stride: f64, rate: f64) -> [Vec<f64>; 3] {
    let count = (9.3 * stride * rate) as usize;
    let time: Vec<f64> = (0..count).map(|i| i as f64 / rate).collect();
    // Both stances carry the weight over a stride: the mean of sin πx + 0.35 sin 3πx over the stride is half of it.
    let mean = 0.62 * (2.0 + 0.35 * 2.0 / 3.0) / std::f64::consts::PI;
    let foot = |shift: f64| -> Vec<f64> {
        let at = |t: &f64| {
            let x = (t / stride + shift).rem_euclid(1.0) / 0.62;
            let a = std::f64::consts::PI * x;
            let f = if x < 1.0 {
                a.sin() + 0.35 * (3.0 * a).sin()
            } else {
                0.0
            };
            0.5 * mass * G / mean * f
        };
        time.iter().map(at).collect()
    };
    let feet = [foot(0.2), foot(0.7)];
    let [left, right] = feet;
    [time, left, right]
}

fn judge(bytes: &[u8], mass: f64, stride: f64, case: &str) -> Recording {
    let options = ReadOptions::default();
    let recording =
        read(Path::new("walk.mat"), bytes, &options).unwrap_or_else(|e| panic!("{case}: {e}"));
    let mean = cycle(&recording, &stances(&recording), Feet::Both)
        .unwrap_or_else(|e| panic!("{case}: {e}"));
    assert!(
        (mean.mass_kg / mass - 1.0).abs() < 0.01,
        "{case}: {} of {mass}",
        mean.mass_kg
    );
    let (low, high) = mean.mass_interval_kg.unwrap();
    assert!(
        low < mass && mass < high,
        "{case}: {low} to {high} of {mass}"
    );
    assert!((mean.curve.period_s / stride - 1.0).abs() < 0.005, "{case}");
    assert!(matches!(recording.format, Format::Export { program } if program.contains(".mat")));
    recording
}

#[test]
fn every_layout_gives_mass_and_stride() {
    let dice = &mut Dice::new(7);
    for round in 0..12 {
        let (mass, stride) = (dice.between(45.0, 110.0), dice.between(0.95, 1.3));
        let rate = dice.of(&[200.0, 500.0, 1000.0]);
        let [time, left, right] = walk(mass, stride, rate);
        let (big, compressed) = (round % 2 == 1, round % 3 == 1);
        let down: Vec<f64> = left.iter().map(|x| -x).collect();
        let vector = |v: &[f64]| numbers("", &[v], big);
        let plate = |v: &[f64]| {
            structure(
                "",
                &[("Fx", vector(&vec![0.0; v.len()])), ("Fz", vector(v))],
                big,
            )
        };
        let layouts = [
            (
                "structs",
                vec![structure(
                    "data",
                    &[
                        ("time", vector(&time)),
                        ("FP1", plate(&down)),
                        ("FP2", plate(&right)),
                    ],
                    big,
                )],
            ),
            (
                "rate",
                vec![
                    numbers("cutoff_freq", &[&[20.0]], big),
                    numbers("fs", &[&[rate]], big),
                    numbers("left_Fz", &[&left], big),
                    numbers("right_Fz", &[&right], big),
                ],
            ),
            (
                "labels",
                vec![structure(
                    "out",
                    &[
                        ("labels", texts("", &["time", "Left Fz", "Right Fz"], big)),
                        ("data", numbers("", &[&time, &left, &right], big)),
                    ],
                    big,
                )],
            ),
            (
                "matrix",
                vec![numbers("trial", &[&time, &left, &right], big)],
            ),
        ];
        for (name, variables) in layouts {
            let bytes = file(&variables, big, compressed);
            let recording = judge(&bytes, mass, stride, &format!("{name}, round {round}"));
            assert_eq!(recording.channels.len(), 2, "{name}");
        }
    }
}

#[test]
fn a_file_without_force_or_cut_short_is_refused_with_what_it_has() {
    let [time, left, right] = walk(70.0, 1.1, 200.0);
    let refused =
        |bytes: &[u8]| read(Path::new("walk.mat"), bytes, &ReadOptions::default()).unwrap_err();
    let other = file(
        &[
            numbers("angle", &[&time], false),
            numbers("emg", &[&left], false),
        ],
        false,
        true,
    );
    let e = refused(&other);
    let names = vec!["angle".to_string(), "emg".to_string()];
    assert_eq!(
        e.fault(),
        Some(&ReadError::MatWithoutForce { arrays: names }),
        "{e}"
    );
    for compressed in [false, true] {
        let whole = file(
            &[
                numbers("time", &[&time], false),
                numbers("left_Fz", &[&left], false),
                numbers("right_Fz", &[&right], false),
            ],
            false,
            compressed,
        );
        for kept in [0.999, 0.95, 0.9, 0.8, 0.75] {
            let end = (kept * whole.len() as f64) as usize;
            let e = refused(&whole[..end]);
            assert!(
                matches!(e.fault(), Some(ReadError::MatCut { .. })),
                "{compressed}, {kept}: {e}"
            );
        }
    }
    let newer = b"MATLAB 7.3 MAT-file".to_vec();
    assert!(refused(&newer).to_string().contains("-v7"));
}

#[test]
fn damaged_files_are_answered_without_panic() {
    let [time, left, right] = walk(70.0, 1.1, 100.0);
    let of = |compressed| {
        let fields = [
            ("time", numbers("", &[&time], false)),
            ("left_Fz", numbers("", &[&left, &right], false)),
            ("names", texts("", &["a", "b"], false)),
        ];
        file(&[structure("data", &fields, false)], false, compressed)
    };
    let (plain, packed) = (of(false), of(true));
    let dice = &mut Dice::new(3);
    for round in 0..600 {
        let mut bytes = if round % 2 == 0 {
            plain.clone()
        } else {
            packed.clone()
        };
        for _ in 0..1 + round % 5 {
            // Mostly in the headers, where counts and types are.
            let reach = if round % 3 == 0 {
                bytes.len()
            } else {
                600.min(bytes.len())
            };
            let at = 120 + dice.between(0.0, (reach - 121) as f64) as usize;
            bytes[at] = dice.between(0.0, 256.0) as u8;
        }
        bytes.truncate(bytes.len() - dice.between(0.0, 200.0) as usize);
        if let Ok(recording) = read(Path::new("x.mat"), &bytes, &ReadOptions::default()) {
            let _ = cycle(&recording, &stances(&recording), Feet::Both);
        }
    }
}

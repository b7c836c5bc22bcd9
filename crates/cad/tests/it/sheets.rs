//! `drawing.pdf`, read back as text: its numbers are those of the cam.

use gaitcam::cam::Follower;
use gaitcam::law::Law;
use gaitcam::wording::Language;
use gaitcam_cad::Units;
use gaitcam_cad::drawing::{self, Title};

use gaitcam_test_support::designed;

use gaitcam_test_support::designs::{footbridge, heel_tester, with_bore};

const TITLE: Title = Title {
    revision: Some(0x0bad_cafe),
    // 2026-01-31.
    date: Some(20_484),
    accuracy: 0.005,
    units: Units::Millimetres,
};

/// Piece of text on a sheet: its start, in points, and its bytes.
pub struct Shown {
    pub at: [f64; 2],
    pub text: String,
}

/// Texts of each sheet, in the order in which they are drawn.
pub fn sheets(pdf: &[u8]) -> Vec<Vec<Shown>> {
    // Bytes as characters: the streams are not compressed.
    let text: String = pdf.iter().map(|&b| char::from(b)).collect();
    text.split("stream\n")
        .filter(|part| part.contains(" Tj"))
        .map(|part| part.split("endstream").next().unwrap_or_default())
        .map(shown)
        .collect()
}

fn shown(stream: &str) -> Vec<Shown> {
    let mut out: Vec<Shown> = Vec::new();
    for text in stream.split("BT").skip(1) {
        let text = text.split("ET").next().unwrap();
        let matrix = text.split(" Tm").next().unwrap();
        let numbers: Vec<f64> = matrix
            .split_whitespace()
            .map(|n| n.parse().unwrap())
            .collect();
        let mut all = String::new();
        for run in text.split(" Tj").filter(|run| run.contains(" Tf")) {
            let run = run.split(" Tf").nth(1).unwrap().trim();
            match run.strip_prefix('<') {
                Some(hex) => {
                    let hex = hex.trim_end_matches('>');
                    let byte = |i| u8::from_str_radix(&hex[i..i + 2], 16).unwrap();
                    all.extend((0..hex.len()).step_by(2).map(byte).map(char::from));
                }
                None => all += &run[1..run.len() - 1].replace('\\', ""),
            }
        }
        out.push(Shown {
            at: [numbers[4], numbers[5]],
            text: all,
        });
    }
    out
}

/// Rows of the table on a sheet: polar angle, degrees, radii of the profile and of the ball's centre, mm.
fn table(sheet: &[Shown]) -> Vec<[f64; 3]> {
    let number = |i: usize| sheet.get(i)?.text.parse::<f64>().ok();
    let decimals = |i: usize| sheet[i].text.split_once('.').map_or(0, |p| p.1.len());
    (0..sheet.len())
        .filter_map(|i| {
            let row = [number(i)?, number(i + 1)?, number(i + 2)?];
            ([0, 1, 2].map(|k| decimals(i + k)) == [0, 3, 3]).then_some(row)
        })
        .collect()
}

#[test]
fn the_radii_of_an_eccentric_disc_are_those_of_its_circle() {
    // s = 10 mm (1 + sin θ) under a flat face on Rb 20 mm: a circle of 30 mm about (10, 0) mm.
    let (e, radius) = (10.0, 30.0);
    let mut design = footbridge();
    design.cam.law = Law::harmonic(0.01, &[(0.0, 0.01)]);
    design.cam.follower = Follower::FlatTranslating { base_radius: 0.02 };
    let pdf = drawing::pdf(&design, &TITLE, Language::En).unwrap();
    let rows = table(&sheets(&pdf)[0]);
    assert_eq!(rows.len(), 72);
    for (k, row) in rows.iter().enumerate() {
        assert_eq!(row[0], 5.0 * k as f64);
        let (sin, cos) = row[0].to_radians().sin_cos();
        // The ball's centre runs on the circle that is larger by its radius, 1 mm.
        for (found, r) in [(row[1], radius), (row[2], radius + 1.0)] {
            let exact = e * sin + (r * r - (e * cos).powi(2)).sqrt();
            assert!((found - exact).abs() <= 5.01e-4, "{row:?}: {exact}");
        }
    }
}

#[test]
fn each_cam_of_a_pair_has_its_sheet_as_it_stands_on_the_shaft() {
    let design = designed("camdas_07_conjugate_roller");
    let pdf = drawing::pdf(&design, &TITLE, Language::En).unwrap();
    let sheets = sheets(&pdf);
    assert_eq!(sheets.len(), 2);
    let pair = design.conjugate.as_ref().unwrap();
    let profiles = [design.cam.profile(100_000), pair.second_profile(100_000)];
    for (sheet, profile) in sheets.iter().zip(profiles) {
        let rows = table(sheet);
        assert_eq!(rows.len(), 72);
        for row in rows {
            let angle = row[0].to_radians();
            let off = |p: &&gaitcam::cam::ProfilePoint| {
                let a = (p.x.atan2(p.y) - angle).rem_euclid(std::f64::consts::TAU);
                a.min(std::f64::consts::TAU - a)
            };
            let near = profile
                .iter()
                .min_by(|a, b| off(a).total_cmp(&off(b)))
                .unwrap();
            // Half a step of the profile on its steepest flank.
            let exact = 1e3 * near.x.hypot(near.y);
            assert!((row[1] - exact).abs() < 0.006, "{row:?}: {exact}");
        }
    }
}

#[test]
fn the_title_block_names_scene_revision_date_and_what_the_tolerance_does_to_the_force() {
    let pdf = drawing::pdf(&footbridge(), &TITLE, Language::En).unwrap();
    let sheet = &sheets(&pdf)[0];
    let has = |text: &str| sheet.iter().any(|s| s.text.contains(text));
    assert!(has("footbridge") && has("0badcafe") && has("2026-01-31"));
    assert!(has("\u{b1} 0.") && has("% of mean (designed "));
    // A programme without a force and a tolerance has a dash.
    let pdf = drawing::pdf(&designed("camdas_01_roller"), &TITLE, Language::Es).unwrap();
    let sheet = &sheets(&pdf)[0];
    assert!(sheet.iter().any(|s| s.text == "sin fuerza objetivo"));
    assert!(!sheet.iter().any(|s| s.text.trim() == "\u{b1}"));
    // Spanish has a decimal comma.
    assert!(sheet.iter().any(|s| s.text == "5") && table(sheet).is_empty());
}

#[test]
fn bore_and_keyway_are_dimensioned_as_they_are_measured() {
    let design = with_bore(heel_tester(), 0.012, true);
    let pdf = drawing::pdf(&design, &TITLE, Language::En).unwrap();
    let sheet = &sheets(&pdf)[0];
    // DIN 6885-1: a keyway of 4 mm, 1.8 mm deep, in a hub of 12 mm.
    for text in ["\u{d8} 12.000 H7", "4.0 JS9, 13.80"] {
        assert!(sheet.iter().any(|s| s.text == text), "{text}");
    }
}

#[test]
fn a_sheet_in_inches_has_the_numbers_of_the_one_in_millimetres_over_25_4() {
    let design = with_bore(footbridge(), 0.0127, false);
    let title = |units| Title { units, ..TITLE };
    let [mm, inches] = [Units::Millimetres, Units::Inches].map(|units| {
        sheets(&drawing::pdf(&design, &title(units), Language::En).unwrap()).remove(0)
    });
    let has = |text: &str| inches.iter().any(|s| s.text == text);
    assert!(has("\u{d8} 0.5000 H7") && has("in, degrees") && has("r, in"));
    assert!(!inches.iter().any(|s| s.text.contains("mm")));
    let rows = table(&mm);
    assert_eq!(rows.len(), 72);
    let texts: Vec<&str> = inches.iter().map(|s| s.text.as_str()).collect();
    for [angle, profile, ball] in rows {
        let angle = format!("{angle:.0}");
        let near = |text: &str, mm: f64| {
            let number: Option<f64> = text.parse().ok();
            number.is_some_and(|x| (25.4 * x - mm).abs() < 0.5e-3 + 25.4 * 0.5e-4)
        };
        let row = |w: &&[&str]| w[0] == angle && near(w[1], profile) && near(w[2], ball);
        assert!(texts.windows(3).any(|w| row(&w)), "{angle}");
    }
}

#[test]
fn all_text_starts_within_the_frame() {
    for design in [footbridge(), heel_tester()] {
        let pdf = drawing::pdf(&design, &TITLE, Language::Es).unwrap();
        for s in sheets(&pdf).iter().flatten() {
            // A3 is the larger sheet: 420 × 297 mm.
            let mm = s.at.map(|x| x * 25.4 / 72.0);
            assert!(mm[0] > 20.0 && mm[0] < 410.0, "{}: {mm:?}", s.text);
            assert!(mm[1] > 10.0 && mm[1] < 287.0, "{}: {mm:?}", s.text);
        }
    }
}

#[test]
fn a_revision_is_the_crc_of_the_text() {
    // The check value of CRC-32 (ISO-HDLC).
    assert_eq!(drawing::revision("123456789"), 0xcbf4_3926);
}

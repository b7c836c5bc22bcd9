//! Names and units of columns: every unit of force, units of other quantities, brackets without a unit, zones of insoles.

use std::path::Path;

use super::dice::Dice;
use super::faults::{CLOCK, belts, none, opened, plain};
use super::layout::Table;
use super::person::walker;
use gaitcam_gait::units::G;
use gaitcam_gait::{ReadOptions, read};

#[test]
fn zones_of_an_insole_stand_beside_their_total() {
    let dice = &mut Dice::new(2);
    let person = walker(dice, 8.0);
    let sides = belts(dice, &person, &plain(100.0), ["l", "r"]);
    let zones = [
        "L::heel [N]",
        "L::medial [N]",
        "L [N]",
        "R::heel [N]",
        "R::medial [N]",
        "R [N]",
    ];
    let part = |k: usize, share: f64| sides.columns[k].iter().map(|f| share * f).collect();
    let table = Table {
        rate_hz: 100.0,
        names: zones.map(str::to_string).to_vec(),
        columns: vec![
            part(0, 0.4),
            part(0, 0.6),
            part(0, 1.0),
            part(1, 0.4),
            part(1, 0.6),
            part(1, 1.0),
        ],
    };
    let text = table.delimited(CLOCK, false);
    let recording = read(Path::new("made.csv"), text.as_bytes(), &none()).unwrap();
    let names: Vec<&str> = recording.channels.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["L [N]", "R [N]"]);
}

#[test]
fn every_unit_of_force_in_a_header_gives_the_same_newtons() {
    const KGF: f64 = 9.806_65;
    const LBF: f64 = 4.448_221_615_260_5;
    let units: [(&str, f64); 14] = [
        ("N", 1.0),
        ("newtons", 1.0),
        ("daN", 0.1),
        ("kN", 1e-3),
        ("kilonewton", 1e-3),
        ("lbf", 1.0 / LBF),
        ("lb", 1.0 / LBF),
        ("lbs", 1.0 / LBF),
        ("kgf", 1.0 / KGF),
        ("kp", 1.0 / KGF),
        ("N/kg", 1.0 / 80.0),
        ("BW", 1.0 / (80.0 * G)),
        ("%BW", 100.0 / (80.0 * G)),
        ("N/BW", 1.0 / (80.0 * G)),
    ];
    for (seed, (unit, per_newton)) in units.into_iter().enumerate() {
        let dice = &mut Dice::new(seed as u64);
        let person = walker(dice, 9.0);
        for style in ["{} [U]", "{} (U)", "{}_U", "{} U", "row"] {
            let names = ["left fz", "right fz"].map(|n| style.replace("{}", n).replace('U', unit));
            let rows = style == "row";
            let names = if rows {
                ["left fz", "right fz"].map(str::to_string)
            } else {
                names
            };
            let mut table = belts(dice, &person, &plain(200.0), ["", ""]);
            table.names = names.to_vec();
            for x in table.columns.iter_mut().flatten() {
                *x *= per_newton;
            }
            let mut text = table.delimited(CLOCK, false);
            if rows {
                text = text.replacen('\n', &format!("\ns,{unit},{unit}\n"), 1);
            }
            let relative = unit.contains('W') || unit.contains("kg") && unit.contains('/');
            let options = ReadOptions {
                mass_kg: relative.then_some(80.0),
                ..none()
            };
            let recording = read(Path::new("made.csv"), text.as_bytes(), &options).unwrap();
            let top = |c: &[f64]| c.iter().copied().fold(0.0, f64::max);
            let truth = top(&belts(&mut Dice::new(1), &person, &plain(200.0), ["", ""]).columns[0]);
            let read = top(&recording.channels[0].force_n);
            assert!(
                (read / truth - 1.0).abs() < 0.02,
                "{unit} {style}: {read} for {truth} N"
            );
        }
    }
}

#[test]
fn columns_in_a_unit_that_is_none_of_force_are_refused_by_it() {
    let units = [
        "mV", "V", "mV/V", "kPa", "bar", "mbar", "psi", "N/cm²", "N/cm^2", "ADC", "counts", "bits",
        "Nm", "N.mm", "mm", "deg", "m/s^2", "m/s2", "%", "% FS", "%max", "N·s", "N/mm", "kip",
        "µV", "10^3 Nm",
    ];
    // In brackets these may be names of plates.
    let in_rows = ["A", "mA", "x"];
    let styles = [
        "row",
        "left Fz [U],right Fz [U]",
        "left Fz (U),right Fz (U)",
        "Fz [U] (left),Fz [U] (right)",
    ];
    let mut count = 0;
    for (seed, unit) in units.iter().chain(&in_rows).enumerate() {
        let dice = &mut Dice::new(seed as u64);
        let person = walker(dice, 9.0);
        let mut table = belts(dice, &person, &plain(200.0), ["left Fz", "right Fz"]);
        let plain_text = table.delimited(CLOCK, false);
        let count_of = if in_rows.contains(unit) {
            1
        } else {
            styles.len()
        };
        for style in &styles[..count_of] {
            let text = if *style == "row" {
                plain_text.replacen('\n', &format!("\ns,{unit},{unit}\n"), 1)
            } else {
                let names = style.replace('U', unit);
                table.names = names.split(',').map(str::to_string).collect();
                table.delimited(CLOCK, false)
            };
            let period = ReadOptions {
                period_s: Some(1.0),
                ..none()
            };
            for options in [none(), period] {
                let code = opened(&text, &options).err().map(|e| e.code().to_string());
                let refused = code.as_deref() == Some("read-no-force-unit");
                assert!(refused, "{unit} {style}: {code:?}");
                count += 1;
            }
        }
    }
    assert_eq!(count, 2 * (styles.len() * units.len() + in_rows.len()));
}

#[test]
fn brackets_that_hold_no_unit_leave_a_force_in_newtons() {
    for (seed, inside) in [
        "left", "1", "plate 1", "belt", "raw", "filtered", "vertical", "up", "z", "-", "Kistler",
    ]
    .into_iter()
    .enumerate()
    {
        let dice = &mut Dice::new(seed as u64);
        let person = walker(dice, 9.0);
        let names = [
            format!("left Fz ({inside})"),
            format!("right Fz ({inside}) [N]"),
        ];
        let table = belts(dice, &person, &plain(200.0), [&names[0], &names[1]]);
        let curve = opened(&table.delimited(CLOCK, false), &none()).unwrap();
        let mass = curve.mass_kg.unwrap();
        assert!((mass / person.mass - 1.0).abs() < 0.02, "{inside}: {mass}");
    }
}

#[test]
fn decimal_commas_between_commas_are_refused_by_that_reason() {
    for seed in 0..20 {
        let dice = &mut Dice::new(seed);
        let person = walker(dice, 6.0);
        let table = belts(dice, &person, &plain(200.0), ["left fz", "right fz"]);
        let points = table.delimited(CLOCK, false);
        assert!(opened(&points, &none()).is_ok());
        let commas = points.replace('.', ",");
        let refused = opened(&commas, &none()).unwrap_err();
        assert_eq!(refused.code(), "read-commas-twice", "{seed}");
    }
}

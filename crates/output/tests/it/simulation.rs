//! `simulation.json`, `dynamics.csv` and the table of the console.

use std::io::Cursor;

use calamine::{Data, DataType, Reader, Xlsx};
use gaitcam::cam::{Cam, Follower, Measures};
use gaitcam::drive::Drive;
use gaitcam::dynamics::{Model, Run, simulate};
use gaitcam::law::Law;
use gaitcam_output::{Language, csv, simulation, xlsx};
use gaitcam_test_support::designed;

#[test]
fn the_files_of_a_simulation_have_the_documented_keys_and_columns() {
    let design = designed("footbridge");
    let mut run = Run::new(design.cam, design.problem.drive, 1440);
    // Fast enough to lose contact, so that every key has a value.
    run.drive.speed *= 3.0;
    run.machine.restitution = 0.5;
    let out = simulate(&run, Model::Contact).unwrap();
    assert!(out.contact_lost);
    let json = simulation::json(&out);
    let keys: Vec<&String> = json.as_object().unwrap().keys().collect();
    assert_eq!(
        keys,
        [
            "model",
            "why",
            "contact_lost",
            "lost_fraction",
            "force",
            "torque",
            "liftoff_speed_rad_per_s",
            "settle_cycles",
            "details"
        ]
    );
    for key in ["min", "max", "rms_error_n"] {
        assert!(json["force"].get(key).is_some());
    }
    for key in ["min", "max", "mean", "rms"] {
        assert!(json["torque"][key].is_number());
    }
    let csv = csv::text(&simulation::columns(&out));
    assert!(csv.starts_with("theta_rad,contact_force_n,torque_nm,"));
    let rows = csv.lines().count() - 1;
    assert!(
        rows >= 1440 && rows.is_multiple_of(1440),
        "whole turns of 1440 rows: {rows}"
    );
    assert!(simulation::table(&out, Measures::Translating, Language::En).contains("lift-off"));
}

#[test]
fn tables_of_an_arm_have_angles_in_radians_and_forces_in_newtons_at_the_lever() {
    // F = 700 N at 0.1 m: 70 N·m about the pivot on a spring of 200 N·m/rad lift it by 0.35 rad.
    let drive = Drive::fixed_axis(0.0, 20_000.0, 1.0).at_lever(0.1);
    let follower = Follower::RollerOscillating {
        pivot_distance: 0.12,
        arm: 0.1,
        prime_radius: 0.05,
        roller_radius: 0.01,
    };
    let cam = Cam::new(Law::harmonic(0.35, &[(0.1, 0.0)]), follower).unwrap();
    let out = simulate(&Run::new(cam, drive, 720), Model::Rigid).unwrap();
    let csv = csv::text(&simulation::columns(&out));
    let head = "theta_rad,contact_force_n,torque_nm,power_w,lift_rad,gap_rad,normal_force_n,";
    assert!(csv.starts_with(head), "{csv:.120}");
    let columns = simulation::columns(&out);
    let column = |name| &columns.iter().find(|c| c.0 == name).unwrap().1;
    for (force, lift) in column("contact_force_n").iter().zip(column("lift_rad")) {
        assert!((force - 200.0 * lift / 0.1).abs() < 1e-6, "{force} {lift}");
    }
    // The workbook has the same columns, and the console the largest loads in them.
    let book = xlsx::table("dynamics", &columns).unwrap();
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(book)).unwrap();
    let sheet = book.worksheet_range("dynamics").unwrap();
    for (i, (name, values)) in columns.iter().enumerate() {
        let cells: Vec<&Data> = sheet.rows().map(|row| &row[i]).collect();
        assert_eq!(cells[0].get_string(), Some(*name));
        let read = cells[1..].iter().map(|cell| cell.get_float().unwrap());
        assert!(read.eq(values.iter().copied()), "{name}");
    }
    let table = simulation::table(&out, Measures::Oscillating, Language::En);
    for (name, words) in [
        ("normal_force_n", "normal force up to"),
        ("side_thrust_n", "side thrust up to"),
    ] {
        let most = column(name)
            .iter()
            .fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!(
            table.contains(&format!("{words} {most:.1} N")),
            "{most}: {table}"
        );
    }
    let force = &simulation::json(&out)["force"];
    let most = 200.0 * 0.45 / 0.1;
    assert!((force["max"].as_f64().unwrap() - most).abs() < 1e-3);
}

//! Tables of law, profile and workbook: all columns, all rows.

use std::f64::consts::TAU;
use std::io::Cursor;

use calamine::{Data, Reader, Xlsx};
use gaitcam_output::Language;

use crate::TIME;
use gaitcam_test_support::designs::{footbridge, heel_tester};
use gaitcam_test_support::readers::table;

#[test]
fn law_csv_has_the_promised_columns_and_reads_back_to_the_same_bits() {
    let s = footbridge();
    let (head, rows) = table(&gaitcam_output::csv::law(&s, 1440));
    let promised = "theta_rad,s_m,v_m_per_rad,a_m_per_rad2,j_m_per_rad3,force_n,target_n,time_s,speed_rad_per_s";
    assert_eq!(head.join(","), promised);
    assert_eq!(rows.len(), 1440);
    for (i, row) in rows.iter().enumerate() {
        let theta = TAU * i as f64 / 1440.0;
        let at = s.cam.law.svaj(theta);
        let expected = [theta, at.s, at.v, at.a, at.j, s.problem.drive.force(at)];
        for (read, known) in row.iter().zip(expected) {
            assert_eq!(read.unwrap().to_bits(), known.to_bits());
        }
        let target = s.target().unwrap();
        assert_eq!(row[6], Some(target.at(theta)));
        let speed = s.problem.drive.speed;
        assert_eq!(row[7..], [Some(theta / speed), Some(speed)]);
        if i % 4 == 0 {
            // One of the curve's 360 samples, in closed form: Young's four harmonics as in the design.
            let factors = [(0.37, 0.0), (0.054, 0.7), (0.026, 1.9), (0.01, 2.4)];
            let waves: f64 = factors
                .iter()
                .zip(1..)
                .map(|((a, p), n)| a * (f64::from(n) * theta + p).sin())
                .sum();
            assert!((row[6].unwrap() - 700.0 * (1.0 + waves)).abs() < 1e-9);
        }
    }
    let drive = s.problem.drive;
    let classical = s.moved_to(drive, None);
    let (_, rows) = table(&gaitcam_output::csv::law(&classical, 12));
    assert!(rows.iter().all(|r| r.len() == 9 && r[6].is_none()));
}

#[test]
fn law_csv_of_an_arm_has_lifts_in_radians_and_forces_in_newtons_at_the_lever() {
    let toml = "[gait]\nmodel = \"young\"\nstep_frequency = \"1.85 Hz\"\nbody_weight = \"700 N\"\n[drive]\nkind = \"fixed-axis\"\nspring_rate = \"300 N m/rad\"\n\
                lever = \"80 mm\"\n[cam]\nfollower = \"roller-oscillating\"\npivot_distance = \"120 mm\"\narm = \"100 mm\"\n\
                roller_radius = \"10 mm\"";
    let scene = gaitcam::scene::parse(toml).unwrap();
    let design = gaitcam::synth::synthesise(&scene, scene.model_force().unwrap().as_ref()).unwrap();
    let (head, rows) = table(&gaitcam_output::csv::law(&design, 360));
    let promised = "theta_rad,s_rad,v_rad_per_rad,a_rad_per_rad2,j_rad_per_rad3,force_n,target_n,time_s,speed_rad_per_s";
    assert_eq!(head.join(","), promised);
    // F·L = k·s, and Young's mean is the weight.
    for row in &rows {
        assert!((row[5].unwrap() * 0.08 - 300.0 * row[1].unwrap()).abs() < 1e-9);
    }
    let mean = |column: usize| rows.iter().filter_map(|r| r[column]).sum::<f64>() / 360.0;
    assert!((mean(5) - 700.0).abs() < 1e-3 && (mean(6) - 700.0).abs() < 1e-3);
}

#[test]
fn profile_csv_holds_the_contact_at_each_angle() {
    for s in [footbridge(), heel_tester()] {
        let (head, rows) = table(&gaitcam_output::csv::profile(&s, 1440));
        let promised = "theta_rad,x_m,y_m,pitch_x_m,pitch_y_m,rho_m,pressure_angle_rad";
        assert_eq!(head.join(","), promised);
        for (row, p) in rows.iter().zip(s.cam.profile(1440)) {
            let known = [
                p.theta,
                p.x,
                p.y,
                p.pitch_x,
                p.pitch_y,
                p.rho,
                p.pressure_angle,
            ];
            let read: Vec<f64> = row.iter().map(|x| x.unwrap()).collect();
            assert_eq!(read, known);
        }
    }
}

#[test]
fn the_workbook_has_the_columns_of_cam_das() {
    for (s, flat) in [(footbridge(), true), (heel_tester(), false)] {
        let bytes = gaitcam_output::xlsx::workbook(&s, TIME, Language::En).unwrap();
        let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).unwrap();
        assert_eq!(book.sheet_names(), ["cam", "summary"]);
        let sheet = book.worksheet_range("cam").unwrap();
        let text = |row: u32, column: u32| sheet.get_value((row, column)).map(Data::to_string);
        // 004, "Exportar-Excel": A1 the kind, A2 the title, headings in row 10, 361 rows from row 11.
        let kind = if flat { "flat" } else { "roller" };
        assert!(text(0, 0).unwrap().contains(kind), "{:?}", text(0, 0));
        assert_eq!(text(1, 0).unwrap(), s.problem.name);
        let verdict = s.verdict.name().replace("-", " ");
        let said = text(2, 0).unwrap().to_lowercase().replace("-", " ");
        assert!(said.starts_with(&verdict), "{said}");
        let heading = |letter: u8| text(9, u32::from(letter - b'A')).unwrap_or_default();
        assert!(heading(b'A').contains("°") && heading(b'F').contains("curvature"));
        let number = |row: u32, letter: u8| match sheet.get_value((row, u32::from(letter - b'A'))) {
            Some(Data::Float(x)) => *x,
            other => panic!("row {row}: {other:?}"),
        };
        for i in [0, 1, 90, 217, 360] {
            let theta = f64::from(i).to_radians();
            let (p, at) = (s.cam.point(theta), s.cam.law.svaj(theta));
            let row = 10 + i;
            assert_eq!(number(row, b'A'), f64::from(i));
            assert!((number(row, b'B') - 1000.0 * at.s).abs() < 1e-9);
            let speed = s.problem.drive.speed;
            assert!((number(row, b'D') - 1000.0 * at.a * speed * speed).abs() < 1e-6);
            assert!((number(row, b'L') - 1000.0 * p.x).abs() < 1e-9);
            let (r, phi) = (number(row, b'I'), number(row, b'J').to_radians());
            assert!((r * phi.sin() - 1000.0 * p.y).abs() < 1e-9);
            if flat {
                assert!((number(row, b'H') - number(row, b'G') - 1000.0 * at.v).abs() < 1e-9);
            } else {
                assert!((number(row, b'G') - p.pressure_angle.to_degrees()).abs() < 1e-9);
                assert!((number(row, b'R') - 1000.0 * p.pitch_x).abs() < 1e-9);
            }
        }
        assert_eq!(sheet.end().unwrap().0, 370);
        assert_eq!(heading(b'S').is_empty(), flat);
        let summary = book.worksheet_range("summary").unwrap();
        let stroke = summary
            .rows()
            .find(|r| r[0] == Data::String("law.stroke_m".into()))
            .unwrap();
        assert_eq!(stroke[1], Data::Float(s.cam.law.stroke()));
    }
}

#[test]
fn the_profile_of_a_barrel_is_the_wall_of_its_drawing() {
    let s = gaitcam_test_support::designed("thesis_barrel");
    let (_, rows) = table(&gaitcam_output::csv::profile(&s, 720));
    // At rest in height the rollers of 5.25 mm stand 0.25 mm off their stud.
    assert!((rows[0][2].unwrap() + 5.5e-3).abs() < 1e-12);
    assert!((rows[0][4].unwrap() + 0.25e-3).abs() < 1e-12);
}

#[test]
fn the_head_of_the_workbook_names_the_follower_once_and_a_roller_only_where_there_is_one() {
    let head = |design: &gaitcam::synth::Design| {
        let bytes = gaitcam_output::xlsx::workbook(design, TIME, Language::Es).unwrap();
        let mut book = Xlsx::new(Cursor::new(bytes)).unwrap();
        let sheet = book.worksheet_range("cam").unwrap();
        let text = |row| {
            sheet
                .get_value((row, 0))
                .map_or(String::new(), Data::to_string)
        };
        (0..9).map(text).collect::<Vec<_>>().join("\n")
    };
    let flat = head(&footbridge());
    assert_eq!(flat.matches("seguidor").count(), 1, "{flat}");
    assert!(!flat.contains("rodillo"), "{flat}");
    assert!(head(&heel_tester()).contains("Radio del rodillo"));
}

//! Exports of laboratory programs in addition to those of `layouts`, generated from their description: each is read, or rejected with a clear
//! message.

use std::fmt::Write as _;
use std::path::Path;

use gaitcam_gait::error::{FileKind, ReadError};
use gaitcam_gait::{CycleSource, Feet, Foot, ReadOptions, Recording, cycle, read, stances};

use crate::{fault, notes};

const RATE: f64 = 200.0;
const STRIDE_S: f64 = 1.1;
const SAMPLES: usize = 700;

/// Force of one foot, N.
fn foot(i: usize, lead_s: f64) -> f64 {
    let x = (i as f64 / RATE + lead_s).rem_euclid(STRIDE_S) / 0.68;
    if x > 1.0 {
        return 0.0;
    }
    let a = std::f64::consts::PI * x;
    700.0 * (a.sin() + 0.35 * (3.0 * a).sin())
}

/// A header and one line per sample with time, left and right force.
fn table(head: &str, row: impl Fn(f64, f64, f64) -> String) -> String {
    let mut text = head.to_string();
    for i in 0..SAMPLES {
        let line = row(i as f64 / RATE, foot(i, 0.2), foot(i, 0.75));
        let _ = writeln!(text, "{line}");
    }
    text
}

fn open(name: &str, text: &[u8]) -> Recording {
    read(Path::new(name), text, &ReadOptions::default()).unwrap_or_else(|e| panic!("{e}"))
}

/// Checks a recording of both feet: five whole stances, two whole strides of 1.1 s, the weight of the walker, and sides if the file has them.
#[track_caller]
fn holds_both_feet(name: &str, text: &[u8], sided: bool) -> Recording {
    let r = open(name, text);
    assert!((r.rate_hz / RATE - 1.0).abs() < 5e-3, "{} Hz", r.rate_hz);
    let s = stances(&r);
    assert_eq!(s.used.len(), 5, "{:?} {:?}", s.rejected, r.notes);
    // The peaks lie where 700 (sin a + 0.35 sin 3a) is level: cos² a = 2.15 / 4.2.
    let a = (2.15f64 / 4.2).sqrt().acos();
    let peak = 700.0 * (a.sin() + 0.35 * (3.0 * a).sin());
    let near = |f: f64| (f - peak).abs() < 0.01 * 700.0;
    assert!(s.used.iter().all(|x| near(x.p1.force_n)), "{s:?}");
    let c = cycle(&r, &s, Feet::Both).unwrap();
    assert!(
        matches!(c.source, CycleSource::WholeStrides { strides: 2, .. }),
        "{:?}",
        c.source
    );
    assert!((c.curve.period_s - STRIDE_S).abs() < 2e-3);
    let feet: Vec<_> = s.used.iter().map(|x| x.foot).collect();
    let (l, r_) = (Some(Foot::Left), Some(Foot::Right));
    let wanted = if sided {
        vec![r_, l, r_, l, r_]
    } else {
        vec![None; 5]
    };
    assert_eq!(feet, wanted);
    r
}

#[test]
fn treadmill_export_with_names_in_capitals() {
    let text = table(
        "Digital Acquire\nSample Rate,200\nTime,LFX,LFY,LFZ,LMX,LMY,LMZ,RFX,RFY,RFZ,RMX,RMY,RMZ\n",
        |t, l, r| format!("{t:.4},3,-20,{l:.3},900,-800,12,-4,25,{r:.3},700,-650,9"),
    );
    holds_both_feet("bertec.csv", text.as_bytes(), true);
}

#[test]
fn two_plates_with_milliseconds_and_numbers_behind_the_names() {
    let text = table(
        "Time (ms)\tFx1\tFy1\tFz1\tMx1\tMy1\tMz1\tFx2\tFy2\tFz2\tMx2\tMy2\tMz2\n",
        |t, l, r| {
            format!(
                "{:.1}\t3\t-20\t{:.3}\t900\t-800\t12\t-4\t25\t{:.3}\t700\t-650\t9",
                1e3 * t,
                -l,
                -r
            )
        },
    );
    holds_both_feet("bertec.txt", text.as_bytes(), false);
}

#[test]
fn pressure_treadmill_in_german_with_every_field_quoted() {
    let text = table(
        "\"Typ\";\"Ganganalyse\"\n\"Gewicht [kg]\";\"70,5\"\n\n\"Zeit [ms]\";\"Kraft links [N]\";\"Kraft rechts [N]\"\n",
        |t, l, r| format!("\"{:.1}\";\"{l:.2}\";\"{r:.2}\"", 1e3 * t).replace('.', ","),
    );
    let r = holds_both_feet("zebris.csv", text.replace('\n', "\r\n").as_bytes(), true);
    assert_eq!(r.mass_kg, Some(70.5));
}

#[test]
fn sensor_suite_with_units_in_quoted_names_and_a_column_of_marks() {
    let text = table(
        "\"Name\",\"Walk 1\"\n\"Frequency\",\"200\"\n\"time,s\",\"Marker\",\"LT Ground Reaction Force-Z,N\",\"RT Ground Reaction Force-Z,N\",\"LT GASTRO MED.,uV\"\n",
        |t, l, r| {
            let mark = if (0.2..0.21).contains(&t) { "M" } else { "" };
            format!("{t:.6},\"{mark}\",{l:.3},{r:.3},{:.2}", (97.0 * t).sin())
        },
    );
    holds_both_feet("noraxon.csv", text.as_bytes(), true);
}

#[test]
fn insoles_with_force_beside_pressure_and_with_parts_of_the_foot() {
    let text = table(
        "file name:\twalk.fgt\tdate/time\t01.02.2020\ntotal time [secs]:\t3.5\ttime per frame [secs]:\t0.00500\n\ntime[secs]\tleft force[N]\tleft max pressure[kPa]\tleft x[mm]\tright force[N]\tright max pressure[kPa]\tright x[mm]\n",
        |t, l, r| {
            format!(
                "{t:.3}\t{l:.1}\t{:.1}\t30.1\t{r:.1}\t{:.1}\t30.1",
                l / 4.0,
                r / 4.0
            )
        },
    );
    holds_both_feet("pedar.fgt", text.as_bytes(), true);
    let text = table(
        "loadsol data\nWeight: 70 kg\n\nTime[sec]\tLeft Heel[N]\tLeft Forefoot[N]\tLeft[N]\tTime[sec]\tRight Heel[N]\tRight Forefoot[N]\tRight[N]\n",
        |t, l, r| {
            format!(
                "{t:.3}\t{:.1}\t{:.1}\t{l:.1}\t{t:.3}\t{:.1}\t{:.1}\t{r:.1}",
                0.4 * l,
                0.6 * l,
                0.4 * r,
                0.6 * r
            )
        },
    );
    let r = holds_both_feet("loadsol.txt", text.as_bytes(), true);
    assert_eq!(r.mass_kg, Some(70.0));
}

#[test]
fn two_plates_without_a_header_are_told_by_their_sixes() {
    let text = table("", |t, l, r| {
        format!("{t:.3},3.1,-4.2,{l:.3},10,20,1,2.2,5.1,{r:.3},9,8,2")
    });
    holds_both_feet("netforce.csv", text.as_bytes(), false);
}

#[test]
fn frames_with_seconds_per_frame_are_times() {
    let text = table(
        "DATA_TYPE MOVIE\nSECONDS_PER_FRAME 0.005\nUNITS N\n\nFrame,Left Force,Right Force\n",
        |t, l, r| format!("{},{l:.2},{r:.2}", (t * RATE).round() as usize + 1),
    );
    holds_both_feet("fscan.csv", text.as_bytes(), true);
}

#[test]
fn two_plates_of_a_device_export_and_of_a_motion_platform() {
    let text = table(
        "Devices,\n200,\n,,Force Plate #1 - Force,,,Force Plate #1 - Moment,,,Force Plate #2 - Force,,\nFrame,Sub Frame,Fx,Fy,Fz,Mx,My,Mz,Fx,Fy,Fz\n,,N,N,N,N.mm,N.mm,N.mm,N,N,N\n",
        |t, l, r| {
            let i = (t * RATE).round() as usize;
            format!(
                "{},{},2,-3,{:.3},9000,-8000,100,1,2,{:.3}",
                i / 10 + 1,
                i % 10,
                -l,
                -r
            )
        },
    );
    holds_both_feet("nexus.csv", text.as_bytes(), false);
    let text = table(
        "TimeStamp\tFrameNumber\tFP1.CopX\tFP1.ForX\tFP1.ForY\tFP1.ForZ\tFP1.MomX\tFP2.CopX\tFP2.ForX\tFP2.ForY\tFP2.ForZ\tFP2.MomX\tChannel16.Anlg\n",
        |t, l, r| {
            format!(
                "{:.6}\t7\t0.1\t5\t{l:.4}\t-60\t10\t0.1\t5\t{r:.4}\t-60\t10\t0.003",
                t + 9.5
            )
        },
    );
    holds_both_feet("dflow.txt", text.as_bytes(), false);
}

#[test]
fn total_force_beside_the_feet_does_not_count_twice() {
    let text = table(
        "Sampling frequency;200;Hz\nBody weight;700;N\n\nTime;Fz;Fz left;Fz right\ns;N;N;N\n",
        |t, l, r| format!("{t:.3};{:.2};{l:.2};{r:.2}", l + r),
    );
    let r = holds_both_feet("mars.txt", text.as_bytes(), true);
    assert!((r.mass_kg.unwrap() - 700.0 / 9.81).abs() < 1e-9);
}

#[test]
fn sums_of_two_sets_of_sensors_are_the_left_and_the_right_insole() {
    let text = table("", |t, l, r| {
        let part = |f: f64| {
            [0.04, 0.17, 0.06, 0.19, 0.08, 0.21, 0.10, 0.15]
                .map(|share| format!("{:.3}\t", f * share))
                .concat()
        };
        format!("{t:.3}\t{}{}{l:.3}\t{r:.3}", part(l), part(r))
    });
    let r = holds_both_feet("GaCo.txt", text.as_bytes(), true);
    assert!(
        notes(&r).contains(&"note-insole-columns".to_string()),
        "{:?}",
        r.notes
    );
}

#[test]
fn what_is_no_force_is_refused_by_its_kind() {
    let refused = |name: &str, bytes: &[u8]| {
        read(Path::new(name), bytes, &ReadOptions::default()).expect_err(name)
    };
    let zeros = [0u8; 64];
    for (name, start, kind) in [
        ("book.xlsx", &b"PK\x03\x04"[..], FileKind::Zip),
        ("walk.mat", b"MATLAB 5.0 MAT-file", FileKind::Matlab),
        ("walk.xml", b"<?xml version=\"1.0\"?>", FileKind::Xml),
        // The second byte is that of a C3D file.
        (
            "photo.png",
            &[&b"\x89PNG\r\n\x1a\n"[..], &[7; 600]].concat()[..],
            FileKind::Picture,
        ),
        ("photo.jpg", b"\xFF\xD8\xFF\xE0", FileKind::Picture),
        ("raw.dat", b"\x01\x02\x03\x00\x00", FileKind::Binary),
    ] {
        let bytes = [start, &zeros[..]].concat();
        let e = refused(name, &bytes);
        assert_eq!(fault(&e), format!("{name}: read-foreign"));
        assert_eq!(e.fault(), Some(&ReadError::Foreign { kind }));
    }
}

//! Layouts of laboratory programs, each generated from the same walk.

use std::path::Path;

use gaitcam_gait::units::Quantity;
use gaitcam_gait::{
    CycleSource, Feet, Format, Idle, ReadOptions, Recording, RejectReason, cycle, read, stances,
};

use crate::{fault, notes};

const RATE: f64 = 200.0;
const STRIDE_S: f64 = 1.1;
const STANCE_S: f64 = 0.68;

/// Upward force of one foot at sample `i`, N, with peaks of 668 N and a valley of 455 N.
fn foot(i: usize, lead_s: f64) -> f64 {
    let x = (i as f64 / RATE + lead_s).rem_euclid(STRIDE_S) / STANCE_S;
    if x > 1.0 {
        return 0.0;
    }
    let a = std::f64::consts::PI * x;
    700.0 * (a.sin() + 0.35 * (3.0 * a).sin())
}

/// Right foot, which starts in the swing phase.
fn right(i: usize) -> f64 {
    foot(i, 0.75)
}

fn left(i: usize) -> f64 {
    foot(i, 0.2)
}

const SAMPLES: usize = 700;

fn rows(row: impl Fn(usize, f64) -> String) -> String {
    (0..SAMPLES).map(|i| row(i, i as f64 / RATE)).collect()
}

fn open(text: &[u8], options: &ReadOptions) -> Recording {
    read(Path::new("made.txt"), text, options).unwrap_or_else(|e| panic!("{e}"))
}

/// Checks a recording of the right foot: three stances, their rate and the height of the peaks.
#[track_caller]
fn holds_right_foot(text: &str, options: &ReadOptions) -> Recording {
    let r = open(text.as_bytes(), options);
    assert!(
        (r.rate_hz / RATE - 1.0).abs() < 5e-3,
        "{} Hz {:?}",
        r.rate_hz,
        r.notes
    );
    let live: Vec<_> = r.channels.iter().filter(|c| c.idle.is_none()).collect();
    assert_eq!(
        live.len(),
        1,
        "{:?}",
        r.channels.iter().map(|c| &c.name).collect::<Vec<_>>()
    );
    let s = stances(&r);
    assert_eq!(s.used.len(), 3, "{:?} {:?}", s.rejected, r.notes);
    let high = 700.0 * gait_peak();
    for x in &s.used {
        assert!((x.p1.force_n - high).abs() < 7.0, "{x:?}");
        assert!((x.valley.unwrap().force_n - 455.0).abs() < 7.0, "{x:?}");
    }
    r
}

/// Maximum of sin a + 0.35 sin 3a, where cos a (3·1.4·cos² a − 2.15) = 0.
fn gait_peak() -> f64 {
    let a = (2.15f64 / 4.2).sqrt().acos();
    a.sin() + 0.35 * (3.0 * a).sin()
}

fn none() -> ReadOptions {
    ReadOptions::default()
}

#[test]
fn nexus_device_export_with_frames_subframes_and_later_sections() {
    let text = format!(
        "Devices\n200\n,,AMTI OR6 #1 - Force,,,AMTI OR6 #1 - Moment,,,AMTI OR6 #1 - CoP,,\nFrame,Sub Frame,Fx,Fy,Fz,Mx,My,Mz,Cx,Cy,Cz\n,,N,N,N,N.mm,N.mm,N.mm,mm,mm,mm\n{}\nTrajectories\n100\n,,LHEE,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n1,0,1,2,3\n2,0,1,2,3\n",
        rows(|i, _| format!(
            "{},{},2,-3,{:.3},9000,-8000,100,1,2,0\n",
            i / 2 + 1,
            i % 2,
            -right(i)
        ))
    );
    let r = holds_right_foot(&text, &none());
    let program = "Vicon Nexus";
    assert_eq!(r.format, Format::Export { program });
}

#[test]
fn qualisys_force_export_with_key_lines_and_corners() {
    let text = format!(
        "NO_OF_SAMPLES\t{SAMPLES}\nFREQUENCY\t200\nDESCRIPTION\tForce-plate 1\nFORCE_PLATE_CORNER_POSX_POSY_X\t600.0\nFORCE_PLATE_CORNER_POSX_POSY_Y\t0.0\nForce_X\tForce_Y\tForce_Z\tMoment_X\tMoment_Y\tMoment_Z\tCOP_X\tCOP_Y\tCOP_Z\n{}",
        rows(|i, _| format!(
            "1.0\t-2.0\t{:.3}\t50.0\t60.0\t1.0\t300.0\t200.0\t0.0\n",
            right(i)
        ))
    );
    holds_right_foot(&text, &none());
}

#[test]
fn bioware_export_with_a_units_row_and_crlf() {
    let text = format!(
        "BioWare Version 5.3\r\nData File:\twalk.dat\r\nSampling rate (Hz):\t200\r\nBody weight (N): 686.7\r\n\r\nabs time (s)\tFx\tFy\tFz\t|Ft|\tAx\tAy\r\ns\tN\tN\tN\tN\tm\tm\r\n{}",
        rows(|i, t| format!("{t:.6}\t1.0\t20.0\t{0:.4}\t{0:.4}\t0.1\t0.2\r\n", right(i)))
    );
    let r = holds_right_foot(&text, &none());
    let program = "Kistler BioWare";
    let format = Format::Export { program };
    assert_eq!((r.format, r.mass_kg), (format, Some(70.0)));
}

#[test]
fn visual3d_export_with_five_header_rows() {
    let text = format!(
        "\twalk.c3d\twalk.c3d\twalk.c3d\n\tFP1\tFP1\tFP1\n\tFORCE\tFORCE\tFORCE\n\tORIGINAL\tORIGINAL\tORIGINAL\nITEM\tX\tY\tZ\n{}",
        rows(|i, _| format!("{}\t1.5\t-30.0\t{:.4}\n", i + 1, right(i)))
    );
    let options = ReadOptions {
        rate_hz: Some(RATE),
        ..none()
    };
    holds_right_foot(&text, &options);
}

#[test]
fn motion_platform_export_with_y_up_and_camel_case_names() {
    let text = format!(
        "TimeStamp\tFrameNumber\tFP1.CopX\tFP1.CopY\tFP1.CopZ\tFP1.ForX\tFP1.ForY\tFP1.ForZ\tFP1.MomX\tFP1.MomY\tFP1.MomZ\n{}",
        rows(|i, t| format!(
            "{:.6}\t{i}\t0.1\t0\t0.3\t5\t{:.4}\t-60\t10\t20\t30\n",
            t + 1234.5,
            right(i)
        ))
    );
    holds_right_foot(&text, &none());
}

#[test]
fn treadmill_csv_with_both_sides_sums_to_whole_strides() {
    let text = format!(
        "Time (s),Left Fx (N),Left Fz (N),Right Fx (N),Right Fz (N)\n{}",
        rows(|i, t| format!("{t:.4},3,{:.3},-4,{:.3}\n", left(i), right(i)))
    );
    let r = open(text.as_bytes(), &none());
    let s = stances(&r);
    let c = cycle(&r, &s, Feet::Both).unwrap();
    assert!(
        matches!(c.source, CycleSource::WholeStrides { .. }),
        "{:?}",
        c.source
    );
    assert!(
        (c.curve.period_s - STRIDE_S).abs() < 0.002,
        "{}",
        c.curve.period_s
    );
    // Both feet: twice the mean of a stance, 700 (2/π)(1 + 0.35/3), over its part of the stride.
    let mean = 2.0 * 700.0 * std::f64::consts::FRAC_2_PI * (1.0 + 0.35 / 3.0) * STANCE_S / STRIDE_S;
    assert!(
        (c.curve.mean_n() / mean - 1.0).abs() < 2e-3,
        "{} {mean}",
        c.curve.mean_n()
    );
}

#[test]
fn blanks_decimal_commas_latin_1_and_a_byte_order_mark() {
    let body = rows(|i, t| format!("  {t:.3}   {:.2}\n", right(i)).replace('.', ","));
    holds_right_foot(&format!("Zeit Kraft\n{body}"), &none());
    holds_right_foot(&format!("\u{feff}Zeit Kraft\n{body}"), &none());
    let mut latin = b"Gr\xF6\xDFe;174,0\nZeit;Kraft\n".to_vec();
    latin.extend(
        body.lines()
            .flat_map(|l| format!("{}\n", l.trim().replace("   ", ";")).into_bytes()),
    );
    assert_eq!(stances(&open(&latin, &none())).used.len(), 3);
    let wide: Vec<u8> = format!("\u{feff}Zeit Kraft\n{body}")
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    assert_eq!(stances(&open(&wide, &none())).used.len(), 3);
}

#[test]
fn milliseconds_clock_times_and_frames_with_a_rate_are_times() {
    holds_right_foot(
        &format!(
            "time [ms];Fz [N]\n{}",
            rows(|i, t| format!("{:.1};{:.2}\n", 1e3 * t, right(i)))
        ),
        &none(),
    );
    holds_right_foot(
        &format!(
            "time,Fz\n{}",
            rows(|i, t| format!("{},{:.2}\n", 1e3 * t, right(i)))
        ),
        &none(),
    );
    holds_right_foot(
        &format!(
            "time,Fz\n{}",
            rows(|i, t| format!("00:00:{t:06.3},{:.2}\n", right(i)))
        ),
        &none(),
    );
    holds_right_foot(
        &format!(
            "Sample rate: 200\nFrame,Fz\n{}",
            rows(|i, _| format!("{i},{:.2}\n", right(i)))
        ),
        &none(),
    );
    let bare = rows(|i, _| format!("1,2,{:.2},4,5,6\n", -right(i)));
    let e = read(Path::new("made.txt"), bare.as_bytes(), &none()).unwrap_err();
    assert_eq!(fault(&e), "made.txt: read-no-rate");
    holds_right_foot(
        &bare,
        &ReadOptions {
            rate_hz: Some(RATE),
            ..none()
        },
    );
    let frames = rows(|i, _| format!("{i},{:.2}\n", right(i)));
    holds_right_foot(
        &frames,
        &ReadOptions {
            rate_hz: Some(RATE),
            ..none()
        },
    );
}

#[test]
fn every_unit_comes_out_in_newtons_and_wrong_labels_are_seen_through() {
    let mass = ReadOptions {
        mass_kg: Some(70.0),
        ..none()
    };
    let with = |label: &str, per_newton: f64| {
        format!(
            "time (s),Fz ({label})\n{}",
            rows(|i, t| format!("{t:.3},{:.6}\n", right(i) * per_newton))
        )
    };
    let weight = 70.0 * 9.81;
    holds_right_foot(&with("N", 1.0), &none());
    holds_right_foot(&with("kN", 1e-3), &none());
    holds_right_foot(&with("lbf", 1.0 / gaitcam_gait::units::LBF), &none());
    holds_right_foot(&with("BW", 1.0 / weight), &mass);
    holds_right_foot(&with("%BW", 100.0 / weight), &mass);
    holds_right_foot(&with("N/kg", 1.0 / 70.0), &mass);
    for label in ["mV", "V", "kPa", "N.mm"] {
        let e = read(Path::new("made.txt"), with(label, 1.0).as_bytes(), &none()).unwrap_err();
        assert_eq!(fault(&e), "made.txt line 1: read-no-force-unit", "{label}");
    }
    let newtons = ReadOptions {
        unit: Some(gaitcam_gait::ForceUnit::Newton),
        ..none()
    };
    holds_right_foot(&with("mV", 1.0), &newtons);
    let r = holds_right_foot(&with("N", 1.0 / weight), &mass);
    assert!(
        notes(&r).contains(&"note-unit-label-rejected".to_string()),
        "{:?}",
        r.notes
    );
    let e = read(
        Path::new("made.txt"),
        with("BW", 1.0 / weight).as_bytes(),
        &none(),
    )
    .unwrap_err();
    assert_eq!(fault(&e), "made.txt: read-mass-missing");
}

#[test]
fn dead_plates_offsets_and_missing_samples_do_not_disturb_the_live_one() {
    let text = format!(
        "time,Fz1,Fz2,Fz3\n{}",
        rows(|i, t| {
            let f = if i % 50 == 7 {
                String::new()
            } else {
                format!("{:.2}", 23.5 - right(i))
            };
            format!("{t:.3},{f},{:.1},912.0\n", 0.3 * (i as f64).sin())
        })
    );
    let r = holds_right_foot(&text, &none());
    assert!(
        (r.channels[0].baseline_n + 23.5).abs() < 0.1,
        "{}",
        r.channels[0].baseline_n
    );
    assert_eq!(r.channels[1].idle, Some(Idle::NeverLoaded));
    let level = Quantity::force(912.0);
    assert_eq!(r.channels[2].idle, Some(Idle::Constant { level }));
}

#[test]
fn a_standing_plate_a_shared_plate_and_a_graze_are_rejected_by_reason() {
    let reasons = |force: &dyn Fn(usize) -> (f64, f64)| -> Vec<RejectReason> {
        let text = format!(
            "time,Fz1,Fz2\n{}",
            rows(|i, t| format!("{t:.3},{:.2},{:.2}\n", force(i).0, force(i).1))
        );
        let s = stances(&open(text.as_bytes(), &none()));
        s.rejected.iter().map(|r| r.reason).collect()
    };
    assert!(
        reasons(&|_| (700.0, 650.0))
            .iter()
            .all(|r| *r == RejectReason::NeverUnloaded)
    );
    let shared = reasons(&|i| (0.6 * right(i), 0.4 * right(i)));
    assert!(shared.contains(&RejectReason::TwoPlates), "{shared:?}");
    let graze = reasons(&|i| (right(i), if i < 300 { 0.2 * left(i) } else { 0.0 }));
    assert!(graze.contains(&RejectReason::PartialContact), "{graze:?}");
    let long = |i: usize| {
        if (80..500).contains(&i) {
            690.0 + (i as f64).sin()
        } else {
            0.0
        }
    };
    let standing = reasons(&|i| (long(i), right(i)));
    assert!(standing.contains(&RejectReason::Standing), "{standing:?}");
}

#[test]
fn bad_texts_are_refused_by_code_and_line() {
    let of =
        |t: &str, o: &ReadOptions| fault(&read(Path::new("bad.csv"), t.as_bytes(), o).unwrap_err());
    assert_eq!(of("", &none()), "bad.csv: read-empty");
    assert_eq!(of("\n \n", &none()), "bad.csv: read-empty");
    assert_eq!(of("hello\nworld\n", &none()), "bad.csv: read-no-table");
    let no_force = "bad.csv: read-no-force-column";
    assert_eq!(of("time,height\n0,1\n1,2\n", &none()), no_force);
    let few = "bad.csv line 2: read-few-samples";
    assert_eq!(of("time,fz\n0,1\n", &none()), few);
    assert_eq!(
        of("time,fz\n0,1\n0.02,2\n0.01,3\n", &none()),
        "bad.csv line 4: read-time-backwards"
    );
    let o = ReadOptions {
        force: vec!["fy".to_string()],
        ..none()
    };
    let misspelt = "bad.csv line 1: read-misspelt-column";
    assert_eq!(of("time,fz\n0,1\n1,2\n", &o), misspelt);
    // Found by fuzzing: the frame column named as force left nothing to read.
    let o = ReadOptions {
        force: vec!["1".to_string()],
        ..none()
    };
    let e = of("Frame,Sub Frame,fz\n1,0,2\n1,1,2\n", &o);
    assert_eq!(e, "bad.csv line 2: read-force-is-time");
    let bare: String = (0..20)
        .map(|i| format!("{},{i}\n", 0.013 * f64::from(i * i)))
        .collect();
    assert_eq!(of(&bare, &o), "bad.csv line 1: read-force-is-time");
    let twice = ReadOptions {
        force: vec!["2".to_string(), "2".to_string()],
        ..none()
    };
    assert_eq!(open(bare.as_bytes(), &twice).channels.len(), 1);
    let o = ReadOptions {
        rate_hz: Some(-1.0),
        ..none()
    };
    let e = of("time,fz\n0,1\n1,2\n", &o);
    assert_eq!(e, "read-rate-not-positive");
}

#[test]
fn short_rows_are_missing_samples_in_a_recording_of_any_length() {
    // Every fourth row ends before the second plate: of 8000 rows 2000 values are missing.
    let text: String = (0..8000)
        .map(|i| match i % 4 {
            3 => format!("{:.3},{:.2}\n", i as f64 / RATE, right(i)),
            _ => format!("{:.3},{:.2},{:.2}\n", i as f64 / RATE, right(i), left(i)),
        })
        .collect();
    let r = open(format!("time,right fz,left fz\n{text}").as_bytes(), &none());
    let samples: Vec<usize> = r.channels.iter().map(|c| c.force_n.len()).collect();
    assert_eq!(samples, [8000, 8000]);
    assert_eq!(r.channels[1].missing.len(), 2000);
}

#[test]
fn of_a_long_header_the_first_and_the_last_lines_are_read() {
    let remarks: String = (0..900)
        .map(|i| format!("remark {i} of the laboratory\n"))
        .collect();
    let text = format!(
        "Sampling rate: 200\n{remarks}right fz\n{}",
        rows(|i, _| format!("{:.3}\n", right(i)))
    );
    let r = open(text.as_bytes(), &none());
    assert_eq!(
        (r.rate_hz, r.channels[0].name.as_str()),
        (200.0, "right fz")
    );
}

#[test]
fn counts_are_scaled_so_that_a_stance_peaks_at_1_1_body_weights() {
    let text = format!(
        "File_Type:\tAnalog R/C ASCII\tGeneration#:\t1\nPreciseRate:\t200.0\n\nName\tF1X\tF1Y\tF1Z\nRate\t200\t200\t200\nRange\t10000\t10000\t10000\n{}",
        rows(|i, t| format!(
            "{t:.6}\t{}\t{}\t{}\n",
            i % 3,
            i % 2,
            (7.3 * if i < 200 { right(i) } else { 0.0 }).round()
        ))
    );
    let options = ReadOptions {
        mass_kg: Some(60.0),
        ..ReadOptions::default()
    };
    let r = read(Path::new("walk.anc"), text.as_bytes(), &options).unwrap();
    let top = r
        .channels
        .iter()
        .flat_map(|c| &c.force_n)
        .fold(0.0_f64, |m, f| m.max(f.abs()));
    assert!(
        (top / (1.1 * 60.0 * 9.81) - 1.0).abs() < 1e-3,
        "{top} {:?}",
        r.notes
    );
}

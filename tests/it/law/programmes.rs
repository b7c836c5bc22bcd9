//! Programmes of motions compared with the printed values of CAM-DAS, and invalid programmes.

use gaitcam::error::{Fault, JoinCure, JoinError, LawError};
use gaitcam::law::{Extent, Law, Rise, Segment, constant_breadth, program};
use gaitcam::units::Quantity;
use gaitcam_test_support::segments;
use std::f64::consts::PI;

fn turn(motions: &[(&str, f64, f64)]) -> gaitcam::error::Result<Law> {
    program(&segments(motions), Extent::TURN)
}

/// Maximum and minimum of a derivative at whole degrees, which CAM-DAS samples.
fn sampled(law: &Law, order: usize) -> (f64, f64) {
    (0..360).fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), i| {
        let at = law.svaj(f64::from(i).to_radians());
        let x = [at.s, at.v, at.a, at.j][order];
        (lo.min(x), hi.max(x))
    })
}

#[test]
fn cam_das_prints_what_whole_degrees_show_and_misses_the_peaks() {
    // theory §5, Ejemplo11. Its 34.816 for the true peak velocity is 35/16·25/(π/2) = 34.8151.
    let law = turn(&[
        ("dwell", 0.0, 90.0),
        ("4-5-6-7", 25.0, 90.0),
        ("4-5-6-7", -10.0, 45.0),
        ("4-5-6-7", 10.0, 45.0),
        ("4-5-6-7", -25.0, 90.0),
    ])
    .unwrap();
    for (order, at_degrees, exact) in [
        (1, 34.815, 34.815),
        (2, 121.511, 121.799),
        (3, 1080.442, 1083.652),
    ] {
        let (_, high) = sampled(&law, order);
        assert!((high - at_degrees).abs() < 6e-4, "order {order}: {high}");
        let (low, high) = law.extremes(order);
        assert!(
            (high.value - exact).abs() < 6e-4,
            "order {order}: {}",
            high.value
        );
        assert!(
            (low.value + exact).abs() < 6e-4,
            "order {order}: {}",
            low.value
        );
    }
}

#[test]
fn fall_of_ejemplo4_has_its_printed_and_its_true_extremes() {
    // theory §5: 4-5-6-7, −20° in 45°.
    let law = turn(&[
        ("dwell", 0.0, 90.0),
        ("3-4-5", 20.0, 90.0),
        ("dwell", 0.0, 90.0),
        ("4-5-6-7", -20.0, 45.0),
        ("dwell", 0.0, 45.0),
    ])
    .unwrap();
    let fall: Vec<_> = (270..=315)
        .map(|d| law.svaj(f64::from(d).to_radians()))
        .collect();
    let lowest =
        |f: fn(&gaitcam::law::Svaj) -> f64| fall.iter().map(f).fold(f64::INFINITY, f64::min);
    assert!((lowest(|p| p.v) + 55.622).abs() < 6e-4);
    assert!((lowest(|p| p.a) + 243.023).abs() < 6e-4 && (lowest(|p| -p.a) + 243.023).abs() < 6e-4);
    assert!(
        (lowest(|p| -p.j) + 2160.884).abs() < 6e-4 && (lowest(|p| p.j) + 1733.578).abs() < 6e-4
    );
    assert!((law.extremes(1).0.value + 55.704).abs() < 6e-4);
    assert!((law.extremes(2).0.value + 243.598).abs() < 6e-4);
    assert!((law.extremes(3).1.value - 2167.303).abs() < 6e-4);
    assert!((law.extremes(3).0.value + 1733.842).abs() < 6e-4);
    // Fig. 8.19: 60 mm in 60°.
    let law = turn(&[
        ("3-4-5", 60.0, 60.0),
        ("dwell", 0.0, 120.0),
        ("4-5-6-7", -60.0, 60.0),
        ("dwell", 0.0, 120.0),
    ])
    .unwrap();
    assert!((law.extremes(1).1.value - 107.430).abs() < 6e-4);
    assert!((law.extremes(1).0.value + 125.335).abs() < 6e-4);
}

#[test]
fn general_polynomials_take_their_ends_from_their_neighbours() {
    for (name, continuous) in [("polynomial-5", 2), ("polynomial-7", 3)] {
        let law = turn(&[
            ("semicycloidal-start", 5.0, 60.0),
            (name, 15.0, 60.0),
            ("simple-harmonic", -20.0, 90.0),
            (name, 0.0, 60.0),
            ("dwell", 0.0, 90.0),
        ])
        .unwrap();
        let joints = law.joints();
        for joint in &joints {
            // The semicycloidal start leaves the dwell at the wrap with a jump of jerk.
            let jumps = [joint.jump.s, joint.jump.v, joint.jump.a, joint.jump.j];
            let limit = if joint.at == 0.0 { 2 } else { continuous };
            assert!(
                jumps[..=limit].iter().all(|j| j.abs() < 1e-10),
                "{name} {joint:?}"
            );
        }
        assert_eq!(joints.len(), 5);
    }
    let alone = turn(&[
        ("polynomial-5", 1.0, 90.0),
        ("dwell", 0.0, 90.0),
        ("polynomial-7", -1.0, 90.0),
        ("dwell", 0.0, 90.0),
    ])
    .unwrap();
    let plain = turn(&[
        ("3-4-5", 1.0, 90.0),
        ("dwell", 0.0, 90.0),
        ("4-5-6-7", -1.0, 90.0),
        ("dwell", 0.0, 90.0),
    ])
    .unwrap();
    for i in 0..100 {
        let x = 0.0628 * f64::from(i);
        assert!((alone.svaj(x).s - plain.svaj(x).s).abs() < 1e-13);
    }
}

/// Fault of a rejected programme.
fn fault<F: Fault + Clone>(segments: &[(&str, f64, f64)]) -> F {
    let error = turn(segments).unwrap_err();
    error.fault::<F>().cloned().expect("a fault of the law")
}

fn is_near(x: Quantity, wanted: f64) -> bool {
    (x.value - wanted).abs() < 1e-9
}

#[test]
fn refused_programmes_name_the_segment() {
    let short: LawError = fault(&[
        ("3-4-5", 1.0, 90.0),
        ("dwell", 0.0, 90.0),
        ("3-4-5", -1.0, 90.0),
        ("dwell", 0.0, 80.0),
    ]);
    assert!(
        matches!(short, LawError::Uncovered { missing, .. } if is_near(missing, 10f64.to_radians())),
        "{short:?}"
    );
    let below: JoinError = fault(&[
        ("3-4-5", -0.01, 90.0),
        ("dwell", 0.0, 90.0),
        ("3-4-5", 0.01, 90.0),
        ("dwell", 0.0, 90.0),
    ]);
    assert!(
        matches!(&below, JoinError::BelowBaseCircle { segment, depth, .. }
            if segment.number() == 1 && is_near(*depth, 0.01)),
        "{below:?}"
    );
    let twins: LawError = fault(&[
        ("polynomial-5", 1.0, 90.0),
        ("polynomial-7", -1.0, 90.0),
        ("dwell", 0.0, 180.0),
    ]);
    assert!(
        matches!(&twins, LawError::GeneralNeighbours { first, second }
            if first.number() == 1 && second.number() == 2),
        "{twins:?}"
    );
    let moving: LawError = fault(&[("dwell", 0.1, 360.0)]);
    assert!(matches!(moving, LawError::DwellLift { .. }), "{moving:?}");
    let negative: LawError = fault(&[("3-4-5", 1.0, -10.0), ("3-4-5", -1.0, 370.0)]);
    assert!(
        matches!(&negative, LawError::SegmentLength { segment, .. } if segment.number() == 1),
        "{negative:?}"
    );
}

#[test]
fn jumps_between_segments_are_refused_with_their_cure() {
    let line: JoinError = fault(&[
        ("constant-velocity", 1.0, 90.0),
        ("dwell", 0.0, 90.0),
        ("3-4-5", -1.0, 180.0),
    ]);
    assert!(
        matches!(&line, JoinError::VelocityJump { after, cure: JoinCure::PutBetween { .. }, .. }
            if after.number() == 1),
        "{line:?}"
    );
    let open: JoinError = fault(&[("3-4-5", 1.0, 180.0), ("3-4-5", -0.5, 180.0)]);
    assert!(
        matches!(&open, JoinError::LiftJump { before, .. } if before.number() == 2),
        "{open:?}"
    );
    let half: JoinError = fault(&[
        ("semicycloidal-start", 1.0, 60.0),
        ("constant-velocity", 1.0, 40.0),
        ("semicycloidal-end", 1.0, 60.0),
        ("3-4-5", -3.0, 200.0),
    ]);
    assert!(
        matches!(half, JoinError::VelocityJump { cure: JoinCure::LetCover { length, .. }, .. }
            if is_near(length, 30f64.to_radians())),
        "{half:?}"
    );
}

#[test]
fn unknown_motions_and_parameters_are_refused_by_name() {
    // VDI 2143 names rest and constant velocity by a letter, and a type of motion by its two ends.
    assert_eq!(Rise::from_name("R").unwrap(), Rise::Dwell);
    assert_eq!(Rise::from_name("G").unwrap(), Rise::ConstantVelocity);
    let between = |text: &str| match Rise::from_name(text).unwrap_err().fault() {
        Some(LawError::MotionType { laws, .. }) => laws.join(" "),
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(between("R-G"), "semicycloidal-start");
    assert_eq!(between("R-U"), "double-harmonic");
    assert!(between("RR").contains("cycloidal modified-trapezoid modified-sine"));
    assert_eq!(between("B-B"), "");
    let typo = Rise::from_name("cyclodal").unwrap_err();
    assert!(
        matches!(typo.fault(), Some(LawError::UnknownMotion { nearest: Some(name), .. })
            if name == "cycloidal"),
        "{typo:?}"
    );
    let code = |name: &str| Rise::from_name(name).unwrap_err().code();
    assert_eq!(code("scca 0.5 0.6 0.1"), "law-scca-shares");
    assert_eq!(code("eccentric 0.5"), "law-eccentric-ratio");
}

#[test]
fn angles_rounded_by_the_user_still_close() {
    let s = 51.428571;
    let list: Vec<_> = (0..7)
        .map(|i| {
            (
                if i % 2 == 0 { "dwell" } else { "cycloidal" },
                [0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0][i],
                s,
            )
        })
        .collect();
    let law = turn(&list).unwrap();
    assert_eq!(law.extent(), (0.0, 2.0 * PI));
}

#[test]
fn both_halves_of_a_constant_breadth_law_add_to_its_lift() {
    // theory §5, Ejemplo5: SHM 120°, dwell 60°, SHM 120°, dwell 60°.
    let law = constant_breadth(&segments(&[
        ("simple-harmonic", 0.04, 120.0),
        ("dwell", 0.0, 60.0),
    ]))
    .unwrap();
    for i in 0..720 {
        let x = PI * f64::from(i) / 360.0;
        assert!((law.svaj(x).s + law.svaj(x + PI).s - 0.04).abs() < 1e-15);
    }
    assert!(constant_breadth(&segments(&[("3-4-5", 0.04, 120.0)])).is_err());
    assert!(constant_breadth(&segments(&[("3-4-5", -0.04, 180.0)])).is_err());
}

#[test]
fn tables_become_laws() {
    let rows: Vec<(f64, f64)> = (0..=40)
        .map(|i| f64::from(i) / 40.0)
        .map(|x| {
            (
                3.0 + 2.0 * x,
                1.0 + 5.0 * (x - (2.0 * PI * x).sin() / (2.0 * PI)),
            )
        })
        .collect();
    for rest in [true, false] {
        let law = Rise::table("mine", &rows, rest).unwrap().law().unwrap();
        let exact = Rise::Cycloidal.law().unwrap();
        for i in 0..=200 {
            let x = f64::from(i) / 200.0;
            let (a, b) = (law.svaj(x), exact.svaj(x));
            assert!(
                (a.s - b.s).abs() < 2e-7 && (a.a - b.a).abs() < 5e-3,
                "{rest} {x} {a:?} {b:?}"
            );
        }
    }
    let table = Rise::table("mine", &[(0.0, 0.0), (0.0, 1.0)], true);
    assert!(matches!(
        table.unwrap_err().fault(),
        Some(LawError::TableOrder { row: 2, .. })
    ));
}

/// Table of a rise of 12 mm in 90° as in textbooks: rows each `step` degrees, lifts in mm with `decimals` decimals.
fn textbook_table(motion: &Rise, step: usize, decimals: usize) -> Vec<(f64, f64)> {
    let exact = motion.law().unwrap();
    let row = |degrees: usize| {
        let lift = 12.0 * exact.svaj(degrees as f64 / 90.0).s;
        (
            degrees as f64,
            format!("{lift:.decimals$}").parse().unwrap(),
        )
    };
    (0..=90).step_by(step).map(row).collect()
}

/// Segments with the table as rise or fall of 12 mm, a dwell, and the opposite motion.
fn with_table(table: Rise, is_rise: bool) -> [Segment; 3] {
    let segment = |motion, lift, degrees: f64| Segment {
        motion,
        lift,
        angle: degrees.to_radians(),
    };
    match is_rise {
        true => [
            segment(table, 12.0, 90.0),
            segment(Rise::Cycloidal, -12.0, 180.0),
            segment(Rise::Dwell, 0.0, 90.0),
        ],
        false => [
            segment(Rise::Cycloidal, 12.0, 180.0),
            segment(table, -12.0, 90.0),
            segment(Rise::Dwell, 0.0, 90.0),
        ],
    }
}

#[test]
fn textbook_tables_are_laws_within_half_a_unit_of_their_last_decimal() {
    for motion in [
        Rise::Cycloidal,
        Rise::Poly345,
        Rise::Poly4567,
        Rise::SimpleHarmonic,
    ] {
        for (step, decimals) in [1, 2, 5, 10].into_iter().flat_map(|s| [(s, 2), (s, 3)]) {
            let rows = textbook_table(&motion, step, decimals);
            let half_unit = 0.5 * 0.1_f64.powi(decimals as i32);
            for is_rise in [true, false] {
                let case = format!("{} {step}° {decimals} {is_rise}", motion.name());
                let table = Rise::table("table", &rows, true).unwrap();
                let law = program(&with_table(table, is_rise), Extent::TURN)
                    .unwrap_or_else(|e| panic!("{case}: {e}"));
                assert!(law.extremes(0).0.value >= -1e-9, "{case}");
                for &(degrees, s) in &rows {
                    let (at, lift) = match is_rise {
                        true => (degrees, s),
                        false => (180.0 + degrees, 12.0 - s),
                    };
                    let miss = law.svaj(at.to_radians()).s - lift;
                    assert!(
                        (-1e-9..=half_unit).contains(&miss),
                        "{case}: {miss} at {at}°"
                    );
                }
            }
            let table = Rise::table("table", &rows, true).unwrap();
            let half = with_table(table, true);
            let half = [
                half[0].clone(),
                segments(&[("dwell", 0.0, 90.0)])[0].clone(),
            ];
            let breadth = constant_breadth(&half).unwrap_or_else(|e| panic!("{step}°: {e}"));
            assert!(breadth.extremes(0).0.value >= -1e-9);
            assert!((breadth.stroke() - 12.0).abs() <= 2.0 * half_unit);
        }
    }
}

#[test]
fn tables_that_fall_below_the_base_circle_name_the_two_rows() {
    let rows = [
        (0.0, 0.0),
        (20.0, 0.0),
        (30.0, 3.01),
        (40.0, 10.02),
        (90.0, 12.0),
    ];
    let table = Rise::table("table", &rows, true).unwrap();
    let error = program(&with_table(table, true), Extent::TURN).unwrap_err();
    assert!(
        matches!(
            error.fault(),
            Some(JoinError::TableBelowBaseCircle { first: 1, second: 2, depth, .. })
                if depth.value > 0.05
        ),
        "{error}"
    );
    // The rows themselves lie below the first one.
    let rows = [(0.0, 0.0), (20.0, -1.0), (50.0, 5.0), (90.0, 12.0)];
    let table = Rise::table("table", &rows, true).unwrap();
    let error = program(&with_table(table, true), Extent::TURN).unwrap_err();
    assert!(
        matches!(error.fault(), Some(JoinError::BelowBaseCircle { .. })),
        "{error}"
    );
}

#[test]
fn a_scene_writes_tables_behind_the_motion() {
    let exact = Rise::Poly345.law().unwrap();
    let rows = (0..=12).map(|i| f64::from(i) / 12.0);
    let rows: Vec<String> = rows.map(|x| format!("{x} {}", exact.svaj(x).s)).collect();
    let table = Rise::from_name(&format!("table {}", rows.join(" "))).unwrap();
    for i in 0..=100 {
        let x = f64::from(i) / 100.0;
        let wanted = exact.svaj(x);
        let found = table.law().unwrap().svaj(x);
        assert!((found.s - wanted.s).abs() < 1e-9, "at {x}");
        assert!((found.a - wanted.a).abs() < 1e-5);
    }
    assert_eq!(Rise::from_name(&table.written()).unwrap(), table);
    let fault = |text: &str| Rise::from_name(text).unwrap_err().code();
    assert_eq!(fault("table"), "law-motion-needs-points");
    assert_eq!(fault("table 0 0 0.5 0.3 1"), "law-table-pairs");
    assert_eq!(fault("table 0 0 0.6 0.3 0.5 1"), "law-table-order");
}

#[test]
fn thesis_double_harmonic_accelerates_as_recomputed() {
    // theory §3: h = 10 mm, 135° up, 135° down, dwell 90°, ω = 11.624 rad/s.
    let law = turn(&[
        ("double-harmonic", 0.01, 135.0),
        ("double-harmonic", -0.01, 135.0),
        ("dwell", 0.0, 90.0),
    ])
    .unwrap();
    let (low, high) = law.extremes(2);
    let square = 11.624 * 11.624;
    assert!(
        (square * high.value - 1.35117).abs() < 5e-6 && (square * low.value + 2.40209).abs() < 5e-6
    );
    let (down, up) = law.extremes(1);
    assert!((up.value - 0.0086603).abs() < 5e-8 && (down.value + 0.0086603).abs() < 5e-8);
    assert!(law.joints().iter().all(|j| j.jump.a.abs() < 1e-12));
}

#[test]
fn programmes_of_several_turns_and_of_a_length() {
    let up = Segment {
        motion: Rise::BerzakD,
        lift: 0.04,
        angle: 2.0 * PI,
    };
    let down = Segment {
        lift: -0.04,
        ..up.clone()
    };
    let law = program(&[up, down], Extent::Turns(2)).unwrap();
    // theory §4: ω = 2π rad/s.
    let w = 2.0 * PI;
    for (degrees, s, v, a) in [
        (90.0, 4.41748, 43.2949, 210.234),
        (180.0, 20.0, 72.375, 0.0),
        (270.0, 35.58252, 43.2949, -210.234),
    ] {
        let at = law.svaj(f64::to_radians(degrees));
        assert!(
            (1e3 * at.s - s).abs() < 6e-6
                && (1e3 * w * at.v - v).abs() < 6e-5
                && (1e3 * w * w * at.a - a).abs() < 6e-4
        );
    }
    let slide = program(
        &[
            Segment {
                motion: Rise::Poly345,
                lift: 0.02,
                angle: 0.06,
            },
            Segment {
                motion: Rise::Dwell,
                lift: 0.0,
                angle: 0.04,
            },
        ],
        Extent::Length(0.1),
    )
    .unwrap();
    assert!(!slide.is_closed() && (slide.svaj(0.1).s - 0.02).abs() < 1e-15);
}

#[test]
fn the_eight_motions_of_ejemplo9_join() {
    // theory §5, Ejemplo9RT.
    let law = turn(&[
        ("modified-sine", 0.01, 50.0),
        ("dwell", 0.0, 40.0),
        ("cycloidal", -0.01, 50.0),
        ("dwell", 0.0, 40.0),
        ("3-4-5", 0.01, 50.0),
        ("dwell", 0.0, 40.0),
        ("4-5-6-7", -0.01, 50.0),
        ("dwell", 0.0, 40.0),
    ])
    .unwrap();
    for joint in law.joints() {
        assert!(
            joint.jump.s.abs() < 1e-15 && joint.jump.v.abs() < 1e-14 && joint.jump.a.abs() < 1e-12
        );
    }
    assert!((law.stroke() - 0.01).abs() < 1e-16);
}

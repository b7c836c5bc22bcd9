//! Laws of motion against the tables of the papers and of the trade.

use gaitcam::law::{Condition, Law, hermite_birkhoff};
use gaitcam::poly::bernstein;

/// FACTS §2: paper 001, critical points with unrounded s = F/k, at rest at both ends. Inches.
fn paper_rise() -> Law {
    let k = 30.0 * (std::f64::consts::PI * 0.75 * 0.75_f64).powi(2);
    let mut conditions = Vec::new();
    for (degrees, force) in [
        (0.0, 0.0),
        (56.88, 110.282),
        (123.84, 79.338),
        (198.72, 106.667),
        (256.32, 0.0),
    ] {
        conditions.push((degrees, 0, force / k));
    }
    for end in [0.0, 256.32] {
        conditions.extend([(end, 1, 0.0), (end, 2, 0.0)]);
    }
    let conditions: Vec<Condition> = conditions
        .into_iter()
        .map(|(degrees, order, value): (f64, usize, f64)| Condition {
            theta: degrees.to_radians(),
            order,
            value,
        })
        .collect();
    let poly = hermite_birkhoff(&conditions, 0.0, 256.32_f64.to_radians()).unwrap();
    Law::from_poly(poly, false)
}

#[test]
fn paper_coefficients_come_from_its_boundary_conditions() {
    let law = paper_rise();
    let c = bernstein::to_power(law.poly().piece(0));
    let printed = [
        612.721, -4057.255, 10696.565, -13873.375, 8822.470, -2201.126,
    ];
    for (k, expected) in printed.iter().enumerate() {
        assert!(
            (c[k + 3] - expected).abs() < 0.001,
            "C{} = {}",
            k + 3,
            c[k + 3]
        );
    }
    assert!(c[..3].iter().all(|x| x.abs() < 1e-10));
}

#[test]
fn paper_peaks_are_those_of_the_continuous_law() {
    // FACTS §2, recomputed column, whose values in time belong to the paper's rounded ω = 12.566 rad/s
    // (4π gives 22.5508 in/s, 685.575 and −594.256 in/s²). Inches and pounds.
    let law = paper_rise();
    let w = 12.566;
    let k = 30.0 * (std::f64::consts::PI * 0.75 * 0.75_f64).powi(2);
    let (_, top) = law.extremes(0);
    assert!((top.value * k - 126.183).abs() < 5e-4 && (top.value - 1.3469).abs() < 5e-5);
    assert!((top.at.to_degrees() - 74.39).abs() < 5e-3 && (top.at / w - 0.1033).abs() < 5e-5);
    assert!((law.svaj(135_f64.to_radians()).s - 0.8450).abs() < 5e-5);
    let velocity = law.combination([0.0, 1.0, 0.0, 0.0], 0.0);
    let valley = velocity
        .roots()
        .into_iter()
        .find(|r| r.to_degrees() > 100.0)
        .unwrap();
    assert!((valley.to_degrees() - 129.64).abs() < 5e-3);
    assert!((law.svaj(valley).s - 0.8345).abs() < 5e-5);
    let (_, v) = law.extremes(1);
    assert!((v.value * w - 22.550).abs() < 5e-4 && (v.at.to_degrees() - 37.22).abs() < 5e-3);
    let (a_min, a_max) = law.extremes(2);
    assert!((a_max.value * w * w - 685.53).abs() < 5e-3);
    assert!((a_max.at.to_degrees() - 14.11).abs() < 5e-3);
    assert!((a_min.value * w * w + 594.22).abs() < 5e-3);
    let end = 256.32_f64.to_radians();
    assert!((law.svaj(0.0).j - 41.0615).abs() < 5e-5);
    assert!((law.svaj(end).j + 39.8575).abs() < 5e-5);
}

use gaitcam::law::{Extent, Rise, Segment, constant_breadth, program};
use std::f64::consts::PI;

fn near(value: f64, expected: f64, relative: f64) -> bool {
    (value - expected).abs() <= relative * expected.abs()
}

#[test]
fn every_peak_factor_is_that_of_the_table() {
    // FACTS §7: Cv, Ca, Cj, Ct; 0 stands for a factor the table does not give.
    let p = PI;
    let table: [(&str, f64, f64, f64, f64); 15] = [
        ("parabolic", 2.0, 4.0, f64::INFINITY, 8.0),
        ("cubic", 1.5, 6.0, 12.0, 2.0 * 3.0_f64.sqrt()),
        (
            "simple-harmonic",
            p / 2.0,
            p * p / 2.0,
            p.powi(3) / 2.0,
            p.powi(3) / 8.0,
        ),
        (
            "double-harmonic",
            3.0 * 3.0_f64.sqrt() * p / 8.0,
            p * p,
            42.41372,
            9.894847,
        ),
        ("cycloidal", 2.0, 2.0 * p, 4.0 * p * p, 8.162097),
        (
            "modified-trapezoid",
            2.0,
            8.0 * p / (2.0 + p),
            32.0 * p * p / (2.0 + p),
            8.089981,
        ),
        (
            "modified-sine",
            4.0 * p / (p + 4.0),
            4.0 * p * p / (p + 4.0),
            16.0 * p.powi(3) / (p + 4.0),
            5.457753,
        ),
        ("scca", 1.858642, 5.109916, 64.21310, 6.440597),
        ("3-4-5", 1.875, 10.0 / 3.0_f64.sqrt(), 60.0, 6.694269),
        (
            "4-5-6-7",
            35.0 / 16.0,
            84.0 * 5.0_f64.sqrt() / 25.0,
            52.5,
            10.750226,
        ),
        ("5-6-7-8-9", 2.460938, 9.371976, 78.75, 15.435936),
        ("berzak-d", 1.809375, 5.633285, 72.6, 0.0),
        ("gutman-1-3", 2.0, 5.130199, 59.21763, 8.124858),
        ("freudenstein-1-3", 2.017857, 5.247062, 57.10271, 8.221447),
        ("freudenstein-1-3-5", 2.0, 5.060283, 59.61506, 7.850057),
    ];
    for (name, cv, ca, cj, ct) in table {
        let f = Rise::from_name(name).unwrap().factors().unwrap();
        for (what, value, expected) in [
            ("Cv", f.cv, cv),
            ("Ca", f.ca, ca),
            ("Cj", f.cj, cj),
            ("Ct", f.ct, ct),
        ] {
            let same = value == expected || expected == 0.0;
            assert!(
                same || near(value, expected, 1e-6),
                "{name} {what} = {value}, table {expected}"
            );
        }
    }
    let signed = |name: &str| Rise::from_name(name).unwrap().factors().unwrap();
    let double = signed("double-harmonic");
    assert!(near(double.a.1, 9.0 * p * p / 16.0, 1e-12) && near(double.a.0, -p * p, 1e-12));
    assert!(near(signed("modified-sine").j.0, -23.15545, 1e-6));
    assert!(near(signed("3-4-5").j.0, -30.0, 1e-12));
    assert!(near(signed("4-5-6-7").j.1, 42.0, 1e-12));
}

#[test]
fn every_motion_leads_from_0_to_1_without_an_inner_jump_of_lift_or_velocity() {
    for rise in Rise::catalogue() {
        let law = rise.law().unwrap();
        let last = law.poly().pieces() - 1;
        assert!(law.svaj_on(0, 0.0).s.abs() < 1e-14, "{}", rise.name());
        assert!(
            (law.svaj_on(last, 1.0).s - 1.0).abs() < 1e-14,
            "{}",
            rise.name()
        );
        for joint in law.joints() {
            assert!(
                joint.jump.s.abs() < 1e-14 && joint.jump.v.abs() < 1e-13,
                "{}",
                rise.name()
            );
            assert!(
                joint.jump.a.abs() < 1e-12 || rise == Rise::Parabolic,
                "{}",
                rise.name()
            );
        }
        let fall = rise.fall().unwrap();
        assert!(
            (fall.svaj_on(0, 0.0).s - 1.0).abs() < 1e-14 && fall.svaj_on(last, 1.0).s.abs() < 1e-14
        );
    }
}

#[test]
fn ends_say_what_they_join() {
    let ends = |name: &str| {
        let e = Rise::from_name(name).unwrap().ends().unwrap();
        (
            e.start.continuity_with_dwell(),
            e.end.continuity_with_dwell(),
            e.start.joins(),
            e.end.joins(),
        )
    };
    assert_eq!(ends("4-5-6-7"), (3, 3, "dwell", "dwell"));
    assert_eq!(ends("3-4-5"), (2, 2, "dwell", "dwell"));
    assert_eq!(ends("simple-harmonic").0, 1);
    let dh = ends("double-harmonic");
    assert_eq!((dh.0, dh.1, dh.3), (3, 1, "return of equal acceleration"));
    assert_eq!(ends("semicycloidal-start").3, "constant velocity");
    // The printed Freudenstein 1-3 starts backwards: v = −1/56.
    let printed = Rise::from_name("freudenstein-1-3").unwrap().ends().unwrap();
    assert!(near(printed.start.at.v, -1.0 / 56.0, 1e-12));
    assert_eq!(ends("freudenstein-1-3-at-rest").0, 2);
}

#[test]
fn double_harmonic_falls_in_the_mirror() {
    // FACTS §3: h/2[(1 + cos πx) − ¼(1 − cos 2πx)].
    let fall = Rise::DoubleHarmonic.fall().unwrap();
    for i in 0..=20 {
        let x = f64::from(i) / 20.0;
        let expected = 0.5 * ((1.0 + (PI * x).cos()) - 0.25 * (1.0 - (2.0 * PI * x).cos()));
        assert!((fall.svaj(x).s - expected).abs() < 1e-14);
    }
}

fn segment(motion: &str, lift: f64, degrees: f64) -> Segment {
    Segment {
        motion: Rise::from_name(motion).unwrap(),
        lift,
        angle: degrees.to_radians(),
    }
}

fn turn(segments: &[(&str, f64, f64)]) -> gaitcam::error::Result<Law> {
    let list: Vec<Segment> = segments.iter().map(|s| segment(s.0, s.1, s.2)).collect();
    program(&list, Extent::Turn)
}

/// Largest and smallest of a derivative at whole degrees, as CAM-DAS samples.
fn sampled(law: &Law, order: usize) -> (f64, f64) {
    (0..360).fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), i| {
        let at = law.svaj(f64::from(i).to_radians());
        let x = [at.s, at.v, at.a, at.j][order];
        (lo.min(x), hi.max(x))
    })
}

#[test]
fn cam_das_prints_what_whole_degrees_show_and_misses_the_peaks() {
    // FACTS §5, Ejemplo11. Its 34.816 for the true peak velocity is 35/16·25/(π/2) = 34.8151.
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
    // FACTS §5: 4-5-6-7, −20° in 45°.
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

#[test]
fn refused_programmes_name_the_segment() {
    let say = |s: &[(&str, f64, f64)]| turn(s).unwrap_err().to_string();
    let short = say(&[
        ("3-4-5", 1.0, 90.0),
        ("dwell", 0.0, 90.0),
        ("3-4-5", -1.0, 90.0),
        ("dwell", 0.0, 80.0),
    ]);
    assert!(
        short.contains("350.000000°") && short.contains("10.000000° are missing"),
        "{short}"
    );
    let below = say(&[
        ("3-4-5", -0.01, 90.0),
        ("dwell", 0.0, 90.0),
        ("3-4-5", 0.01, 90.0),
        ("dwell", 0.0, 90.0),
    ]);
    assert!(
        below.contains("segment 1 (3-4-5)") && below.contains("10.000000 mm below"),
        "{below}"
    );
    let twins = say(&[
        ("polynomial-5", 1.0, 90.0),
        ("polynomial-7", -1.0, 90.0),
        ("dwell", 0.0, 180.0),
    ]);
    assert!(
        twins.contains("segment 1") && twins.contains("segment 2"),
        "{twins}"
    );
    let line = say(&[
        ("constant-velocity", 1.0, 90.0),
        ("dwell", 0.0, 90.0),
        ("3-4-5", -1.0, 180.0),
    ]);
    assert!(
        line.contains("velocity jumps") && line.contains("segment 1"),
        "{line}"
    );
    let open = say(&[("3-4-5", 1.0, 180.0), ("3-4-5", -0.5, 180.0)]);
    assert!(
        open.contains("lift jumps") && open.contains("segment 2"),
        "{open}"
    );
    let half = say(&[
        ("semicycloidal-start", 1.0, 60.0),
        ("constant-velocity", 1.0, 40.0),
        ("semicycloidal-end", 1.0, 60.0),
        ("3-4-5", -3.0, 200.0),
    ]);
    assert!(half.contains("cover 30.000000°"), "{half}");
    assert!(
        Rise::from_name("cyclodal")
            .unwrap_err()
            .to_string()
            .contains("`cycloidal`")
    );
    assert!(Rise::from_name("scca 0.5 0.6 0.1").is_err());
    assert!(Rise::from_name("eccentric 0.5").is_err());
    assert!(say(&[("dwell", 0.1, 360.0)]).contains("does not move"));
    assert!(say(&[("3-4-5", 1.0, -10.0), ("3-4-5", -1.0, 370.0)]).contains("segment 1"));
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
    // FACTS §5, Ejemplo5: SHM 120°, dwell 60°, SHM 120°, dwell 60°.
    let law = constant_breadth(&[
        segment("simple-harmonic", 0.04, 120.0),
        segment("dwell", 0.0, 60.0),
    ])
    .unwrap();
    for i in 0..720 {
        let x = PI * f64::from(i) / 360.0;
        assert!((law.svaj(x).s + law.svaj(x + PI).s - 0.04).abs() < 1e-15);
    }
    assert!(constant_breadth(&[segment("3-4-5", 0.04, 120.0)]).is_err());
    assert!(constant_breadth(&[segment("3-4-5", -0.04, 180.0)]).is_err());
}

#[test]
fn tables_and_control_points_become_laws() {
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
    let spline = Rise::spline("mine", 5, &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0]).unwrap();
    let f = spline.factors().unwrap();
    assert!(near(f.cv, 1.875, 1e-12) && near(f.ca, 10.0 / 3.0_f64.sqrt(), 1e-12));
    assert!(
        Rise::table("mine", &[(0.0, 0.0), (0.0, 1.0)], true)
            .unwrap_err()
            .to_string()
            .contains("row 2")
    );
    assert!(Rise::spline("mine", 5, &[0.0, 1.0]).is_err());
}

#[test]
fn thesis_double_harmonic_accelerates_as_recomputed() {
    // FACTS §3: h = 10 mm, 135° up, 135° down, dwell 90°, ω = 11.624 rad/s.
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
    // FACTS §4: ω = 2π rad/s.
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

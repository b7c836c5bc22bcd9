//! Laws of motion compared with published and commercial tables.

use gaitcam::law::{Condition, Extent, Law, Segment, assemble, hermite_birkhoff};
use gaitcam::poly::bernstein;

/// Critical points of Vargas and León (2024) with unrounded s = F/k, at rest at both ends. Inches (theory §2).
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
    // reports/reproduction.md, recomputed column, whose values in time belong to the paper's rounded ω = 12.566 rad/s
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

use gaitcam::law::{Rise, program};
use std::f64::consts::PI;

fn near(value: f64, expected: f64, relative: f64) -> bool {
    (value - expected).abs() <= relative * expected.abs()
}

/// Published peak factors (theory §7, §12): Cv, Ca, Cj, Ct. 0 means that the source does not state the factor.
fn peak_factors() -> [(&'static str, f64, f64, f64, f64); 15] {
    let p = PI;
    [
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
    ]
}

#[test]
fn every_peak_factor_is_that_of_the_table() {
    for (name, cv, ca, cj, ct) in peak_factors() {
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
    assert!(near(double.a.1, 9.0 * PI * PI / 16.0, 1e-12) && near(double.a.0, -PI * PI, 1e-12));
    assert!(near(signed("modified-sine").j.0, -23.15545, 1e-6));
    assert!(near(signed("3-4-5").j.0, -30.0, 1e-12));
    assert!(near(signed("4-5-6-7").j.1, 42.0, 1e-12));
}

/// Normalised fall from 1 to 0, as in a programme.
fn fall(motion: Rise) -> Law {
    let fall = Segment {
        motion,
        lift: -1.0,
        angle: 1.0,
    };
    assemble(&[fall], Extent::Length(1.0)).unwrap().raised(1.0)
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
        let fall = fall(rise.clone());
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
    // theory §3: h/2[(1 + cos πx) − ¼(1 − cos 2πx)].
    let fall = fall(Rise::DoubleHarmonic);
    for i in 0..=20 {
        let x = f64::from(i) / 20.0;
        let expected = 0.5 * ((1.0 + (PI * x).cos()) - 0.25 * (1.0 - (2.0 * PI * x).cos()));
        assert!((fall.svaj(x).s - expected).abs() < 1e-14);
    }
}

#[test]
fn wrong_formulas_of_the_theses_are_not_used() {
    // theory §4: Berzak D's jerk ends with +882x⁴ (printed −882): both ends have 72.6.
    let jerk = |x: f64, last: f64| {
        72.6 - 612.0 * x + 1494.0 * x * x - 1764.0 * x.powi(3) + last * x.powi(4)
    };
    let law = Rise::BerzakD.law().unwrap();
    for i in 0..=20 {
        let x = f64::from(i) / 20.0;
        assert!((law.svaj_on(0, x).j - jerk(x, 882.0)).abs() < 1e-11);
    }
    assert!((jerk(1.0, -882.0) + 1691.4).abs() < 1e-9);
    // Cycloidal jerk 4π²h/β³ (printed 4π⁴), and every rise scales by h/βⁿ (4-5-6-7 lacks it in print).
    assert!(near(
        Rise::Cycloidal.factors().unwrap().cj,
        4.0 * PI * PI,
        1e-12
    ));
    let (h, beta) = (0.03, 0.7);
    let rise = Segment {
        motion: Rise::Poly4567,
        lift: h,
        angle: beta,
    };
    let law = program(&[rise], Extent::Length(beta)).unwrap();
    let f = Rise::Poly4567.factors().unwrap();
    for (order, factor) in [(1, f.cv), (2, f.ca), (3, f.cj)] {
        let (low, high) = law.extremes(order);
        let peak = low.value.abs().max(high.value);
        assert!(near(peak, factor * h / beta.powi(order as i32), 1e-12));
    }
    // theory §5: a semicycloidal start ends at 2L/β (CAM-DAS prints πL/2β, the semiharmonic's).
    let end = |r: Rise| r.ends().unwrap().end.at.v;
    assert!(near(end(Rise::SemicycloidalStart), 2.0, 1e-12));
    assert!(near(end(Rise::SemiharmonicStart), 0.5 * PI, 1e-12));
}

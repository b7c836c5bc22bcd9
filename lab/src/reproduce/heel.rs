//! Vargas and León (2024): the hydraulic heel tester (theory §2).

use super::{Value, strip};
use gaitcam::cam::{Cam, Follower};
use gaitcam::drive::Drive;
use gaitcam::error::Result;
use gaitcam::law::{Condition, Law, hermite_birkhoff};
use gaitcam::poly::{PiecewisePoly, bernstein};
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};
use gaitcam::units::LBF;
use gaitcam_output::overlay::{self, Look};
use gaitcam_output::picture::Picture;
use std::f64::consts::{PI, TAU};

const INCH: f64 = 0.0254;
/// Critical points of the measured force, lbf, over the cam angle, degrees.
const POINTS: [(f64, f64); 3] = [(56.88, 110.282), (123.84, 79.338), (198.72, 106.667)];
/// End of the motion, degrees.
const END: f64 = 256.32;
/// Speed as rounded in the paper, rad/s.
const SPEED: f64 = 12.566;

fn drive(speed: f64) -> Drive {
    Drive::hydraulic(30.0 * LBF / INCH.powi(5), 0.75 * INCH, speed)
}

/// Polynomial of degree 8 through the points, with its coefficients in (θ/β)ᵏ, m.
fn law() -> Result<(Law, Vec<f64>)> {
    let beta = END.to_radians();
    let mut conditions: Vec<Condition> = [0.0, beta]
        .into_iter()
        .flat_map(|theta| {
            (0..3).map(move |order| Condition {
                theta,
                order,
                value: 0.0,
            })
        })
        .collect();
    let stiffness = drive(SPEED).spring_rate;
    conditions.extend(POINTS.map(|(degrees, pounds)| Condition {
        theta: degrees.to_radians(),
        order: 0,
        value: pounds * LBF / stiffness,
    }));
    let poly = hermite_birkhoff(&conditions, 0.0, beta)?;
    let coefficients = bernstein::to_power(poly.piece(0));
    let dwell = vec![0.0; poly.degree() + 1];
    let both = [poly.piece(0).to_vec(), dwell].concat();
    let law = PiecewisePoly::new(vec![0.0, beta, TAU], poly.degree(), both);
    Ok((Law::from_poly(law, true), coefficients))
}

pub(super) fn values() -> Result<Vec<Value>> {
    let (law, coefficients) = law()?;
    let exact = 4.0 * PI;
    let mut values: Vec<Value> = (3..=8).map(|k| (coefficients[k] / INCH).into()).collect();
    // Equations 8 to 10: the factors of v, a and j in powers of θ/β.
    let mut factors: Vec<f64> = coefficients.iter().map(|c| c / INCH).collect();
    for _ in 1..=3 {
        factors = factors
            .iter()
            .enumerate()
            .skip(1)
            .map(|(k, c)| k as f64 * c / END.to_radians())
            .collect();
        values.extend(
            factors
                .iter()
                .filter(|c| c.abs() > 1e-6)
                .map(|c| Value::from(*c)),
        );
    }
    // Equation 11: force over the time as a fraction of β.
    let force = |k: usize| coefficients[k] * drive(SPEED).spring_rate / LBF * SPEED.powi(k as i32);
    values.extend((3..=8).map(|k| Value::from(force(k))));
    values.extend(forces(&law));
    values.extend(motion(&law, exact));
    let peak = pounds(&law, law.extremes(0).1.at);
    let second = extremes_of_lift(&law, 150.0..250.0).map(|x| pounds(&law, x));
    let second = second.fold(f64::NAN, f64::max);
    for (force, (_, measured)) in [(peak, POINTS[0]), (second, POINTS[2])] {
        values.push((100.0 * (force / measured - 1.0)).into());
    }
    for objective in ["peak-acceleration", "jerk"] {
        let (low, high) = level(objective)?.cam.law.extremes(2);
        values.extend([high, low].map(|x| Value::from(x.value * exact * exact / INCH)));
    }
    Ok(values)
}

/// Force at a cam angle in rad, lbf.
fn pounds(law: &Law, theta: f64) -> f64 {
    drive(SPEED).force(law.svaj(theta)) / LBF
}

/// Angles of stationary lift between two angles in degrees, rad.
fn extremes_of_lift(law: &Law, degrees: std::ops::Range<f64>) -> impl Iterator<Item = f64> {
    let roots = law.combination([0.0, 1.0, 0.0, 0.0], 0.0).roots();
    (roots.into_iter()).filter(move |x| degrees.contains(&x.to_degrees()))
}

/// Extremes of force and lift with their positions, and the lift at 135°.
fn forces(law: &Law) -> [Value; 5] {
    let top = law.extremes(0).1;
    let degrees = top.at.to_degrees();
    let at_whole = pounds(law, degrees.floor().to_radians());
    let valley = extremes_of_lift(law, 100.0..160.0)
        .map(|x| (x, law.svaj(x).s / INCH))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or((0.0, f64::NAN));
    let valley = format!("{:.4} in at {:.2}°", valley.1, valley.0.to_degrees());
    [
        Value::with(pounds(law, top.at), format!("{at_whole:.3}")),
        degrees.into(),
        (top.at / SPEED).into(),
        (top.value / INCH).into(),
        Value::with(law.svaj(135f64.to_radians()).s / INCH, valley),
    ]
}

/// Pressure angles, speeds and accelerations at the rounded and at the `exact` speed, jerks, pitch radius.
fn motion(law: &Law, exact: f64) -> [Value; 11] {
    let cam = Cam {
        law: law.clone(),
        follower: Follower::RollerTranslating {
            prime_radius: 3.0 * INCH,
            offset: 0.0,
            roller_radius: INCH,
        },
    };
    let (least, most) = cam.pressure_angle_extremes();
    let factor = |order: i32, speed: f64| speed.powi(order) / INCH;
    let velocity = law.extremes(1).1;
    let at_exact = velocity.value * factor(1, exact);
    let (low, high) = law.extremes(2);
    [
        most.value.to_degrees().into(),
        least.value.to_degrees().into(),
        Value::with(velocity.value * factor(1, SPEED), format!("{at_exact:.4}")),
        velocity.at.to_degrees().into(),
        (high.value * factor(2, SPEED)).into(),
        (high.value * factor(2, exact)).into(),
        (low.value * factor(2, SPEED)).into(),
        (low.value * factor(2, exact)).into(),
        (law.svaj_on(0, 0.0).j / INCH).into(),
        (law.svaj_on(0, 1.0).j / INCH).into(),
        ((cam.curvature().convex.value + INCH) / INCH).into(),
    ]
}

/// Design of the piecewise quintic that is level at the critical points, for another objective.
fn level(objective: &str) -> Result<Design> {
    let mut table = scene::table(scene::built_in("heel_tester_fitted")?.toml)?;
    // Force points require no force curve on a hydraulic drive.
    table.remove("gait");
    table.remove("limits");
    scene::set(&mut table, &format!("law.minimise=\"{objective}\""))?;
    scene::set(&mut table, "cam.prime_radius=\"3 in\"")?;
    scene::set(&mut table, "cam.offset=0")?;
    synthesise(&scene::read(&table)?, None)
}

/// Picture of the force of the polynomial and of the level law, with the critical points.
pub(super) fn picture() -> Result<Picture> {
    let (law, _) = law()?;
    let drive = drive(SPEED);
    let level = level("jerk")?;
    let curve = |law: &Law| -> Vec<(f64, f64)> {
        (0..=720)
            .map(|i| 0.5 * f64::from(i))
            .map(|x| (x, drive.force(law.svaj(x.to_radians())) / LBF))
            .collect()
    };
    let mut points = vec![(0.0, 0.0)];
    points.extend(POINTS);
    points.push((END, 0.0));
    let names = [
        "polynomial of degree 8",
        "level at the peaks, least ∫j²",
        "critical points",
    ]
    .map(str::to_string);
    Ok(overlay::diagrams_with(
        &[Look::Line, Look::Line, Look::Dots],
        "Heel tester",
        "force of Vargas and León (2024)",
        &names,
        &[strip(
            "force, lb",
            vec![curve(&law), curve(&level.cam.law), points],
        )],
    ))
}

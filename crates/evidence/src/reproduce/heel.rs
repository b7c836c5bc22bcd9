//! Vargas and León (2024): the hydraulic heel tester (theory §2).

use super::{Class, Row, Rows, strip};
use gaitcam::cam::{Cam, Follower};
use gaitcam::drive::Drive;
use gaitcam::error::Result;
use gaitcam::law::{Condition, Law, hermite_birkhoff};
use gaitcam::poly::{PiecewisePoly, bernstein};
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};
use gaitcam::units::LBF;
use gaitcam_output::overlay;
use gaitcam_output::picture::Picture;
use std::f64::consts::{PI, TAU};

const INCH: f64 = 0.0254;
/// The critical points of the measured force, lbf, over the cam angle, degrees.
const POINTS: [(f64, f64); 3] = [(56.88, 110.282), (123.84, 79.338), (198.72, 106.667)];
/// End of the motion, degrees.
const END: f64 = 256.32;
/// The speed as the paper rounds it, rad/s.
const SPEED: f64 = 12.566;

fn drive(speed: f64) -> Drive {
    Drive::hydraulic(30.0 * LBF / INCH.powi(5), 0.75 * INCH, speed)
}

/// The polynomial of degree 8 through the points, with its coefficients in (θ/β)ᵏ, m.
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

pub(super) fn rows() -> Result<Vec<Row>> {
    let mut rows = Rows::of("Vargas and León (2024), hydraulic heel tester");
    let (law, coefficients) = law()?;
    let drive_given = drive(SPEED);
    for (k, stated) in [
        (3, "612.721"),
        (4, "-4057.255"),
        (5, "10696.565"),
        (6, "-13873.375"),
        (7, "8822.470"),
        (8, "-2201.126"),
    ] {
        let value = coefficients[k] / INCH;
        rows.stated(&format!("coefficient C{k}"), "in", stated, value);
    }
    let force = |degrees: f64| drive_given.force(law.svaj(degrees.to_radians())) / LBF;
    let (_, top) = law.extremes(0);
    let peak = force(top.at.to_degrees());
    let at_whole = force(top.at.to_degrees().floor());
    let reason = format!("the paper reads it at 74°, where the force is {at_whole:.3} lb");
    rows.add(
        "largest force",
        "lb",
        "126.175",
        peak,
        (Class::Rounding, &reason),
    );
    rows.stated("its angle", "°", "74", top.at.to_degrees());
    rows.stated("its time", "s", "0.1", top.at / SPEED);
    rows.stated("largest lift", "in", "1.347", top.value / INCH);
    let valley = law
        .combination([0.0, 1.0, 0.0, 0.0], 0.0)
        .roots()
        .into_iter()
        .filter(|x| (100.0..160.0).contains(&x.to_degrees()))
        .map(|x| (x, law.svaj(x).s))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or((0.0, f64::NAN));
    let reason = format!(
        "the printed lift is that of the valley, {:.4} in at {:.2}°",
        valley.1 / INCH,
        valley.0.to_degrees()
    );
    let there = law.svaj(135f64.to_radians()).s / INCH;
    rows.misprint("lift at 135°", "in", "0.835", there, &reason);
    let cam = Cam {
        law: law.clone(),
        follower: Follower::RollerTranslating {
            prime_radius: 3.0 * INCH,
            offset: 0.0,
            roller_radius: INCH,
        },
    };
    let (low, high) = cam.pressure_angle_extremes();
    rows.stated(
        "largest pressure angle",
        "°",
        "26.6",
        high.value.to_degrees(),
    );
    rows.stated(
        "smallest pressure angle",
        "°",
        "-25.7",
        low.value.to_degrees(),
    );
    let timed = |order: usize, speed: f64| {
        let (low, high) = law.extremes(order);
        let factor = speed.powi(order as i32) / INCH;
        (
            low.value * factor,
            high.value * factor,
            high.at.to_degrees(),
        )
    };
    let exact = 4.0 * PI;
    let speed = timed(1, SPEED);
    let reason = format!(
        "22.5 is cut from it; at ω = 4π in place of 12.566 rad/s it is {:.4}",
        timed(1, exact).1
    );
    rows.add(
        "largest velocity",
        "in/s",
        "22.5",
        speed.1,
        (Class::Rounding, &reason),
    );
    rows.stated("its angle", "°", "37", speed.2);
    let fast = timed(2, SPEED);
    rows.stated("largest acceleration", "in/s²", "685.5", fast.1);
    rows.silent(
        "largest acceleration at ω = 4π",
        "in/s²",
        timed(2, exact).1,
        "the paper rounds ω to 12.566 rad/s",
    );
    rows.silent("smallest acceleration", "in/s²", fast.0, "");
    rows.silent(
        "smallest acceleration at ω = 4π",
        "in/s²",
        timed(2, exact).0,
        "",
    );
    let start = law.svaj_on(0, 0.0).j / INCH;
    let end = law.svaj_on(0, 1.0).j / INCH;
    rows.stated("jerk at the start", "in/rad³", "41.061", start);
    rows.silent(
        "jerk at the end of the motion",
        "in/rad³",
        end,
        "finite, so the jerk jumps where the dwell begins",
    );
    let pitch = cam.curvature().convex.value + INCH;
    rows.silent(
        "smallest convex pitch radius",
        "in",
        pitch / INCH,
        "more than the roller's 1 in: no undercut",
    );
    let second = law
        .combination([0.0, 1.0, 0.0, 0.0], 0.0)
        .roots()
        .into_iter()
        .filter(|x| (150.0..250.0).contains(&x.to_degrees()))
        .map(|x| force(x.to_degrees()))
        .fold(f64::NAN, f64::max);
    let over = |force: f64, measured: f64| 100.0 * (force / measured - 1.0);
    rows.silent(
        "overshoot at the first peak",
        "%",
        over(peak, POINTS[0].1),
        "the polynomial passes the critical points without being level there",
    );
    rows.silent(
        "overshoot at the second peak",
        "%",
        over(second, POINTS[2].1),
        "",
    );
    for (objective, words) in [
        ("peak-acceleration", "level at the extremes, least peak"),
        ("jerk", "level at the extremes, least ∫j²"),
    ] {
        let design = level(objective)?;
        let (low, high) = design.cam.law.extremes(2);
        let reason = "the price of meeting the measured peaks exactly, 48 spans";
        for (side, value) in [("largest", high.value), ("smallest", low.value)] {
            let quantity = format!("{side} acceleration, {words}");
            rows.silent(&quantity, "in/s²", value * exact * exact / INCH, reason);
        }
    }
    Ok(rows.list)
}

/// The piecewise quintic that is level at the critical points, for another objective.
fn level(objective: &str) -> Result<Design> {
    let text = include_str!("../../../../scenes/heel_tester_fitted.toml");
    let mut table: toml::Table = text
        .parse()
        .map_err(|e: toml::de::Error| crate::fault(e.message().to_string()))?;
    // Force points need no curve on a hydraulic drive.
    table.remove("gait");
    table.remove("limits");
    scene::set(&mut table, &format!("law.minimise=\"{objective}\""))?;
    scene::set(&mut table, "cam.prime_radius=\"3 in\"")?;
    scene::set(&mut table, "cam.offset=0")?;
    synthesise(&scene::read(&table)?, None)
}

/// Force of the polynomial and of the level law, with the critical points joined.
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
    points.extend([(END, 0.0), (360.0, 0.0)]);
    let names = [
        "polynomial of degree 8",
        "level at the peaks, least ∫j²",
        "critical points",
    ]
    .map(str::to_string);
    Ok(overlay::diagrams(
        "Heel tester",
        "force of Vargas and León (2024)",
        &names,
        &[strip(
            "force, lb",
            vec![curve(&law), curve(&level.cam.law), points],
        )],
    ))
}

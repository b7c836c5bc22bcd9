//! Comparison of the four iterations of Campillo de Blas (2017) with each other and with the optimum.
//!
//! Measure: RMS difference between the force and the target, for the given phase and for the best phase of the law. The target is that of Young (1.85
//! Hz, both feet), scaled to 1 kg.

use std::fmt::Write;

use super::strip;
use gaitcam::drive::Drive;
use gaitcam::error::Result;
use gaitcam::force::{self, Feet, ForceCurve};
use gaitcam::law::{Condition, Extent, Law, Rise, Segment, hermite_birkhoff, program};
use gaitcam::poly::PiecewisePoly;
use gaitcam::scene;
use gaitcam::synth::synthesise;
use gaitcam::units::G;
use gaitcam_output::overlay;
use gaitcam_output::picture::Picture;
use gaitcam_test_support::thesis;
use std::f64::consts::TAU;

/// Number of angles at which forces are compared.
const POINTS: usize = 720;

/// The force error of one law.
#[derive(Debug, Clone)]
pub struct Method {
    /// Name of the method.
    pub name: String,
    /// Stroke of the law, m.
    pub stroke: f64,
    /// RMS difference between force and target, N, at the given phase.
    pub rms: f64,
    /// RMS difference between force and target at the best phase of the law, N.
    pub rms_turned: f64,
    /// Phase of the law with the minimum error, rad.
    pub phase: f64,
    /// Maximum |jerk|, m/s³; infinite if the acceleration jumps.
    pub jerk: f64,
    /// Largest jump of velocity, m/s.
    pub velocity_jump: f64,
    /// Minimum and maximum force, N.
    pub force: (f64, f64),
    /// Force at equal steps at the best phase, N.
    curve: Vec<(f64, f64)>,
}

fn target() -> Result<ForceCurve> {
    let curve = force::model("young", Some(1.85), 700.0, Feet::Both)?;
    let factor = thesis::MASS * G / curve.mean_n();
    Ok(curve.scaled(factor))
}

fn measured(name: &str, law: &Law, drive: &Drive, target: &ForceCurve) -> Method {
    let angle = |i: usize| TAU * i as f64 / POINTS as f64;
    let target_force: Vec<f64> = (0..POINTS).map(|i| target.at(angle(i))).collect();
    let own: Vec<f64> = (0..POINTS)
        .map(|i| drive.force(law.svaj(angle(i))))
        .collect();
    let distance = |shift: usize| {
        let square = |i: usize| (own[(i + shift) % POINTS] - target_force[i]).powi(2);
        ((0..POINTS).map(square).sum::<f64>() / POINTS as f64).sqrt()
    };
    let (shift, rms_turned) = (0..POINTS)
        .map(|k| (k, distance(k)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or((0, f64::NAN));
    let joints = law.joints();
    let largest = |pick: fn(&gaitcam::law::Joint) -> f64| {
        joints.iter().map(|j| pick(j).abs()).fold(0.0, f64::max)
    };
    let (low, high) = law.extremes(3);
    let scale = law.extremes(2).1.value.abs();
    let jerk = if largest(|j| j.jump.a) > 1e-6 * scale {
        f64::INFINITY
    } else {
        high.value.max(-low.value) * drive.speed.powi(3)
    };
    let velocity_jump = largest(|j| j.jump.v) * drive.speed;
    let (least, most) = drive.force_curve(law).extremes();
    Method {
        name: name.to_string(),
        stroke: law.stroke(),
        rms: distance(0),
        rms_turned,
        phase: angle(shift),
        jerk,
        velocity_jump: if velocity_jump > 1e-9 {
            velocity_jump
        } else {
            0.0
        },
        force: (least.value, most.value),
        curve: (0..=POINTS)
            .map(|i| (360.0 * i as f64 / POINTS as f64, own[(i + shift) % POINTS]))
            .collect(),
    }
}

/// Law of iteration 2: a cubic in every segment with the lifts of iteration 1 and accelerations of three times the lift (the thesis states "about 3
/// times" and prints no values).
fn iteration_2() -> Result<Law> {
    let joints = [
        (0.0, 0.0),
        (90.0, 0.010),
        (135.0, 0.007),
        (180.0, 0.010),
        (270.0, 0.0),
    ];
    let mut breaks = vec![0.0];
    let mut coef = Vec::new();
    for pair in joints.windows(2) {
        let [from, to] = [pair[0], pair[1]].map(|p| (f64::to_radians(p.0), p.1));
        let at = |(theta, lift): (f64, f64)| {
            [(0, lift), (2, 3.0 * lift)].map(|(order, value)| Condition {
                theta,
                order,
                value,
            })
        };
        let conditions = [at(from), at(to)].concat();
        coef.extend_from_slice(hermite_birkhoff(&conditions, from.0, to.0)?.piece(0));
        breaks.push(to.0);
    }
    breaks.push(TAU);
    coef.extend([0.0; 4]);
    Ok(Law::from_poly(PiecewisePoly::new(breaks, 3, coef), true))
}

/// Results of the four iterations, of the eccentric, and of the optimum with the stroke of the thesis and with its optimal stroke.
pub fn methods() -> Result<Vec<Method>> {
    let target = target()?;
    let drive = thesis::real(thesis::SPEED);
    let rise = |motion: &Rise, lift: f64, degrees: f64| Segment {
        motion: motion.clone(),
        lift,
        angle: degrees.to_radians(),
    };
    let rest = rise(&Rise::Dwell, 0.0, 90.0);
    let first = Rise::Poly345;
    let iteration_1 = [
        rise(&first, 0.010, 90.0),
        rise(&first, -0.003, 45.0),
        rise(&first, 0.003, 45.0),
        rise(&first, -0.010, 90.0),
        rest.clone(),
    ];
    let third = Rise::Cycloidal;
    let iteration_3 = [rise(&third, 0.01, 135.0), rise(&third, -0.01, 135.0), rest];
    let law = |segments: &[Segment]| program(segments, Extent::TURN);
    let mut out = Vec::new();
    let mut add = |name: &str, law: &Law| out.push(measured(name, law, &drive, &target));
    add("eccentric", &thesis::eccentric().law);
    add("1: 3-4-5, five segments", &law(&iteration_1)?);
    add("2: polynomials with accelerations", &iteration_2()?);
    add("3: cycloidal", &law(&iteration_3)?);
    add("4: double harmonic", &thesis::double_harmonic().law);
    for (name, stroke) in [
        ("optimum, 10 mm", "10 mm"),
        ("optimum, stroke free", "60 mm"),
    ] {
        add(name, &optimum(stroke, &target)?);
    }
    Ok(out)
}

/// Law with the minimum force error for the given stroke, on the machine of Campillo de Blas (2017).
fn optimum(stroke: &str, target: &ForceCurve) -> Result<Law> {
    let mut table = scene::table(scene::built_in("footbridge_thesis_scale")?.toml)?;
    scene::set(&mut table, &format!("limits.stroke=\"{stroke}\""))?;
    scene::set(&mut table, "cam.base_radius=\"auto\"")?;
    scene::set(
        &mut table,
        &format!("drive.speed=\"{} rad/s\"", thesis::SPEED),
    )?;
    Ok(synthesise(&scene::read(&table)?, Some(target))?.cam.law)
}

/// Writes the comparison as a table of the report.
pub(super) fn table(out: &mut String, methods: &[Method]) {
    out.push_str(
        "\n## Four iterations and the optimum\n\nCampillo de Blas (2017) selected the law without optimisation. This table compares its iterations by the RMS force error to the target (Young, 1.85 Hz, both feet, scaled to M = 1 kg), at the given phase and at the best phase. The accelerations of iteration 2 are not printed; three times the lift per rad² is chosen.\n\n\
         | law | stroke, mm | RMS, N | RMS turned, N | turned by, ° | largest jerk, m/s³ | jump of velocity, m/s | force, N |\n|---|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for m in methods {
        let jerk = if m.jerk.is_finite() {
            format!("{:.2}", m.jerk)
        } else {
            "∞".to_string()
        };
        let _ = writeln!(
            out,
            "| {} | {:.3} | {:.4} | {:.4} | {:.1} | {jerk} | {:.4} | {:.3} … {:.3} |",
            m.name,
            1e3 * m.stroke,
            m.rms,
            m.rms_turned,
            m.phase.to_degrees(),
            m.velocity_jump,
            m.force.0,
            m.force.1
        );
    }
}

/// Picture of all forces at their best phases, with the target.
pub(super) fn picture(methods: &[Method]) -> Picture {
    let mut names: Vec<String> = Vec::new();
    let mut curves = Vec::new();
    if let Ok(target) = target() {
        names.push("wanted".to_string());
        let at = |i: usize| 360.0 * i as f64 / POINTS as f64;
        curves.push(
            (0..=POINTS)
                .map(|i| (at(i), target.at(at(i).to_radians())))
                .collect(),
        );
    }
    // There are six colours. The eccentric and the optimum with free stroke, which coincides with the target, are left out.
    for m in methods.iter().skip(1).take(5) {
        names.push(m.name.clone());
        curves.push(m.curve.clone());
    }
    overlay::diagrams(
        "Campillo de Blas (2017)",
        "force of every iteration, turned to its best phase",
        &names,
        &[
            strip("force, N", curves.clone()),
            strip(
                "force, N",
                vec![
                    curves[0].clone(),
                    Vec::new(),
                    Vec::new(),
                    Vec::new(),
                    curves.get(4).cloned().unwrap_or_default(),
                    curves.get(5).cloned().unwrap_or_default(),
                ],
            ),
        ],
    )
}

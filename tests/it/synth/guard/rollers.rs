//! Rollers with limits on curvature, pressure angle and prime radius. These limits are not jointly convex, so that no other method finds the optimum.
//! The smallest cam is, however, feasible for every larger limit on the prime radius and for any objective. A little above it, each objective must
//! have a result in time. Its pitch curve must satisfy the limits at many angles by its own derivatives, and it must not be worse than the smallest
//! cam.

use super::machines::{Random, fixed, hydraulic, moving};
use super::scenes::Kind;
use super::{is_too_long, processor_seconds, times};
use gaitcam::law::Law;
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// A usual run contains one in this many scenes.
const THINNED: usize = if cfg!(debug_assertions) { 10 } else { 4 };
/// Number of random scenes, and minimum number of designed cams.
const DRAWN: usize = 40;
const BUILT: usize = 160;
/// First seed, so that the seeds differ from those of the kind with the same random numbers.
const FIRST_SEED: usize = 1 << 20;
/// Number of angles at which a cam is checked.
const ANGLES: usize = 20_000;
/// Maximum relative excess over a limit.
const HELD: f64 = 1e-6;
/// Maximum relative excess of an objective over that of the smallest cam. A sequence ends when a step improves less than a ten-millionth, and another
/// sequence may have led to that cam.
const WORSE: f64 = 1e-4;
/// Objectives above the smallest cam.
const OBJECTIVES: [&str; 5] = [
    "force-error",
    "peak-force-error",
    "acceleration",
    "jerk",
    "size",
];

/// Machine with its force and the limits of its cam, in metres and radians.
struct Roller {
    text: String,
    force: gaitcam::force::ForceCurve,
    roller: f64,
    curvature: f64,
    angle: f64,
}

fn drawn(r: &mut Random) -> Roller {
    let machine = match r.below(4) {
        0 => hydraulic(r),
        1 => fixed(r),
        _ => moving(r),
    };
    let (roller, curvature) = (r.within(0.005, 0.02), r.within(0.001, 0.025));
    let angle = r.within(0.3, 0.8);
    let given = r.within(0.0, 0.01);
    let offset = r
        .maybe(0.3, format!("{given} m"))
        .unwrap_or_else(|| "auto".to_string());
    let (accuracy, spans) = (r.within(1.0, 6.0), 14 + r.below(27));
    let text = format!(
        "name = \"roller\"\n{}[accuracy]\nrms = \"{accuracy} %\"\n\
         [cam]\nfollower = \"roller-translating\"\nroller_radius = \"{roller} m\"\noffset = \"{offset}\"\n\
         [law]\nfamily = \"spline\"\ndegree = {}\nspans = {spans}\nminimise = \"MINIMISE\"\n\
         [limits]\nforce_min = \"0 N\"\ncurvature = \"{curvature} m\"\npressure_angle = \"{angle} rad\"\n",
        machine.machine,
        machine.degree.max(4),
    );
    let (_, force) = machine.target.expect("these machines have a wanted force");
    Roller {
        text,
        force,
        roller,
        curvature,
        angle,
    }
}

impl Roller {
    /// Design with an objective and a limit on the prime radius, with relaxations if there is no cam.
    fn design(&self, objective: &str, most: Option<f64>) -> Result<Design, String> {
        let mut text = self.text.replacen("MINIMISE", objective, 1);
        text.extend(most.map(|radius| format!("prime_radius = \"{radius} m\"\n")));
        let table: toml::Table = text.parse().map_err(|e| format!("{e}"))?;
        let scene = scene::read(&table).map_err(|e| e.to_string())?;
        let before = processor_seconds();
        let design = synthesise(&scene, Some(&self.force)).map_err(|e| e.to_string())?;
        let design = design.relaxed();
        let taken = processor_seconds() - before;
        if is_too_long(taken) {
            return Err(format!("{taken:.1} s"));
        }
        Ok(design)
    }

    /// Largest relative excess of a cam over its limits. The centre of the roller is at (e, D + s) in the frame of the follower, which rotates
    /// relative to the cam. Its derivatives in the frame of the cam, rotated back, are those below.
    fn excess(&self, design: &Design, most: f64) -> f64 {
        let follower = &design.cam.follower;
        let (prime, e) = (follower.prime_radius(), follower.offset());
        let rise = (prime * prime - e * e).sqrt();
        let sharpest = self.curvature + self.roller;
        let of_angle = |k: usize| {
            let at = design.cam.law.svaj(TAU * k as f64 / ANGLES as f64);
            let height = rise + at.s;
            let first = [height, at.v - e];
            let second = [2.0 * at.v - e, at.a - height];
            let turned = first[1] * second[0] - first[0] * second[1];
            let bend = turned / first[0].hypot(first[1]).powi(3);
            let slope = first[1].abs() / first[0];
            (bend * sharpest - 1.0).max(slope / self.angle.tan() - 1.0)
        };
        (0..ANGLES).map(of_angle).fold(prime / most - 1.0, f64::max)
    }
}

/// Value of the objective for a design.
fn value(objective: &str, design: &Design) -> f64 {
    let energy = |of: fn(&Law, f64) -> f64| {
        let at = |k: usize| of(&design.cam.law, TAU * k as f64 / ANGLES as f64).powi(2);
        (0..ANGLES).map(at).sum::<f64>()
    };
    match objective {
        "force-error" => design.force.rms_error_n.powi(2),
        "peak-force-error" => design.force.max_error_n,
        "acceleration" => energy(|law, theta| law.svaj(theta).a),
        "jerk" => energy(|law, theta| law.svaj(theta).j),
        _ => design.cam.follower.prime_radius(),
    }
}

/// Number of cams designed above the smallest one of a scene. The error text states what is wrong with a cam.
fn built_above(seed: usize) -> Result<usize, String> {
    let mut random = Random::new(Kind::Touching, FIRST_SEED + seed);
    let roller = drawn(&mut random);
    let smallest = roller
        .design("size", None)
        .map_err(|e| format!("smallest: {e}"))?;
    if smallest.infeasible.is_some() || smallest.checks.iter().any(|c| !c.pass) {
        return Ok(0);
    }
    let radius = smallest.cam.follower.prime_radius();
    for objective in OBJECTIVES {
        let most = radius * (1.0 + 10f64.powf(random.within(-3.3, -0.5)));
        let fault = |words: String| {
            format!(
                "{objective} at {} times the smallest: {words}",
                most / radius
            )
        };
        let design = roller.design(objective, Some(most)).map_err(&fault)?;
        let broken: Vec<_> = design
            .checks
            .iter()
            .filter(|c| !c.pass)
            .map(|c| c.name)
            .collect();
        if design.infeasible.is_some() || !broken.is_empty() {
            return Err(fault(format!("refused, {broken:?}")));
        }
        let excess = roller.excess(&design, most);
        if excess > HELD {
            return Err(fault(format!("a limit is exceeded by {excess:e}")));
        }
        let (own, known) = (value(objective, &design), value(objective, &smallest));
        if own > known * (1.0 + WORSE) {
            return Err(fault(format!("{own} where {known} is known")));
        }
    }
    Ok(OBJECTIVES.len())
}

#[test]
fn rollers_above_their_smallest_cam_are_built_whatever_is_minimised() {
    compared(THINNED, 1);
}

#[test]
#[ignore = "minutes"]
fn forty_rollers_above_their_smallest_cam_are_built_whatever_is_minimised() {
    compared(1, times());
}

/// Compares one scene in `every`, with `times` times the usual number.
fn compared(every: usize, times: usize) {
    let seen: Vec<(usize, Result<usize, String>)> = (0..DRAWN * times)
        .into_par_iter()
        .step_by(every)
        .map(|seed| (seed, built_above(seed)))
        .collect();
    let faults = seen
        .iter()
        .filter_map(|(seed, s)| Some(format!("{seed}: {}", s.as_ref().err()?)));
    let faults: Vec<String> = faults.collect();
    let built: usize = seen.iter().filter_map(|(_, s)| s.as_ref().ok()).sum();
    println!("{built} cams of rollers built");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(built >= BUILT * times / every, "{built} built");
}

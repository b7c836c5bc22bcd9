//! Why a design is as plain as it is: for every choice of model the number that decided it, and the next
//! richer choice, which can be run to see what it changes.
//!
//! A law of twice the spans (or harmonics) contains the chosen one, and limits are convex. The target force
//! is F*, the chosen law's F₁ and the richer one's F₂ are its projections on nested convex sets, so that
//! ‖F₁ − F₂‖² ≤ ‖F₁ − F*‖² − ‖F₂ − F*‖²: the richer choice moves the force by less than the chosen one misses.

use std::f64::consts::TAU;

use gaitcam::cam::Cam;
use gaitcam::dynamics::recover;
use gaitcam::dynamics::{Machine, Run};
use gaitcam::error::Result;
use gaitcam::law::Law;
use gaitcam::scene::{Family, Scene, ShaftSpeed};
use gaitcam::synth::{Design, Tier};
use serde_json::json;

use crate::console::language;
use crate::console::words::{fill, fixed, name, text};

/// One choice of model.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// What was chosen: "family", "spans", …
    pub subject: &'static str,
    /// The choice.
    pub chosen: String,
    /// The number that decided.
    pub because: String,
    /// The next richer choice, or why there is none.
    pub next: String,
    /// The scene that asks for it, to be synthesised for its cost and its change.
    pub richer: Option<Scene>,
}

/// Angles at which forces are compared: not those at which anything is fitted.
const ANGLES: usize = 4001;

/// Family, size and rung of a design.
pub fn choices(scene: &Scene, design: &Design) -> Vec<Choice> {
    let mut out = vec![family(scene, design)];
    out.extend(size(scene, design));
    out.push(tier(design));
    out.extend(shaft(scene, design));
    out
}

/// How well the force is met, against what is asked.
fn accuracy(scene: &Scene, design: &Design) -> String {
    let percent = fixed(design.force.rms_error_percent_of_mean, 4);
    match scene.rms {
        _ if design.target().is_none() => text("explain-no-force"),
        Some(rms) => {
            let allowed = fixed(100.0 * rms, 4);
            let values = json!({"percent": percent, "allowed": allowed});
            fill("explain-accuracy-of", &values)
        }
        None => fill("explain-accuracy", &json!({"percent": percent})),
    }
}

fn asked_for(scene: &Scene, design: &Design) -> String {
    fill(
        "explain-asked",
        &json!({"accuracy": accuracy(scene, design)}),
    )
}

fn family(scene: &Scene, design: &Design) -> Choice {
    let asked = scene.law.family;
    let status = design.solver.status(language::current());
    let because = match asked {
        Family::Auto => fill("explain-simplest", &json!({"status": status})),
        Family::Ladder => fill("explain-simplest-solver", &json!({"status": status})),
        _ => asked_for(scene, design),
    };
    let (next, richer) = match design.family.name() {
        "double-harmonic" => ("explain-to-harmonics", Some(Family::Harmonic)),
        "harmonic" => ("explain-to-spline", Some(Family::Spline)),
        "spline" => ("explain-more-spans", None),
        _ => ("explain-law-given", None),
    };
    Choice {
        subject: "family",
        chosen: fill(
            "explain-family-degree",
            &json!({"family": design.family.name(), "degree": design.degree}),
        ),
        because,
        next: text(next),
        richer: richer.map(|family| with(scene, |s| s.law.family = family)),
    }
}

/// Spans or harmonics, doubled: the richer law contains the chosen one.
fn size(scene: &Scene, design: &Design) -> Option<Choice> {
    let (subject, count): (_, usize) = match design.family.name() {
        "spline" => (
            "spans",
            (scene.law.spans).unwrap_or_else(|| design.cam.law.poly().pieces()),
        ),
        "harmonic" => ("harmonics", design.cam.law.waves(0).len()),
        _ => return None,
    };
    let twice = 2 * count;
    let given = scene.law.spans.or(scene.law.harmonics).is_some();
    let because = if given {
        asked_for(scene, design)
    } else {
        fill(
            "explain-fewest",
            &json!({"accuracy": accuracy(scene, design)}),
        )
    };
    let richer = with(scene, |s| {
        if subject == "spans" {
            (s.law.family, s.law.spans) = (Family::Spline, Some(twice));
        } else {
            (s.law.family, s.law.harmonics) = (Family::Harmonic, Some(twice));
        }
    });
    Some(Choice {
        subject,
        chosen: count.to_string(),
        because,
        next: twice.to_string(),
        richer: Some(richer),
    })
}

fn tier(design: &Design) -> Choice {
    let solver = &design.solver;
    let next = match solver.tier {
        Tier::Spectral | Tier::Equality => "explain-with-rows",
        Tier::Qp => "explain-cone",
        Tier::Socp => "explain-sequence",
        Tier::Scp => "explain-none",
    };
    Choice {
        subject: "solver",
        chosen: name(solver.tier.name()),
        because: fill(
            "explain-solver",
            &json!({"status": solver.status(language::current()),
                "limits": design.binding.len(), "iterations": solver.iterations}),
        ),
        next: text(next),
        richer: None,
    }
}

/// Whether the law is that for the motor, from the forecast of inertia and energy.
fn shaft(scene: &Scene, design: &Design) -> Option<Choice> {
    let on_shaft = design.shaft.as_ref()?;
    let forecast = on_shaft.forecast;
    let is_constant = on_shaft.rounds == 0;
    let percent = |x: f64| fixed(x, 3);
    let values = json!({"ripple": percent(100.0 * forecast.ripple),
        "change": percent(forecast.force_change_percent_of_mean),
        "neglected": percent(forecast.neglected_percent_of_mean),
        "enough": forecast.is_negligible.to_string()});
    let [constant, motor] = ["explain-constant-speed", "explain-motor"].map(text);
    Some(Choice {
        subject: "shaft",
        chosen: if is_constant { constant } else { motor.clone() },
        because: fill("explain-forecast", &values),
        next: if is_constant {
            motor
        } else {
            text("explain-none")
        },
        richer: (is_constant && scene.law.shaft == ShaftSpeed::Constant)
            .then(|| with(scene, |s| s.law.shaft = ShaftSpeed::Motor)),
    })
}

fn with(scene: &Scene, change: impl FnOnce(&mut Scene)) -> Scene {
    let mut out = scene.clone();
    change(&mut out);
    out
}

/// RMS difference of the forces of two designs over a turn, N.
pub fn force_change(one: &Design, other: &Design) -> f64 {
    rms_difference(one, one.pressing(), other.pressing())
}

fn rms_difference(design: &Design, one: &Law, other: &Law) -> f64 {
    let drive = &design.problem.drive;
    let square: f64 = (0..ANGLES)
        .map(|i| TAU * (i as f64 + 0.5) / ANGLES as f64)
        .map(|x| (drive.force(one.svaj(x)) - drive.force(other.svaj(x))).powi(2))
        .sum();
    (square / ANGLES as f64).sqrt()
}

/// Largest distance between the profile and the chords of `n` points at equal steps, m.
pub fn chord_error(cam: &Cam, n: usize) -> f64 {
    let twice = if cam.law.is_closed() {
        2 * n
    } else {
        2 * n - 1
    };
    let rows = cam.profile(twice);
    (1..rows.len())
        .step_by(2)
        .map(|i| {
            let (a, q, b) = (&rows[i - 1], &rows[i], &rows[(i + 1) % rows.len()]);
            let (dx, dy) = (b.x - a.x, b.y - a.y);
            let length = dx.hypot(dy);
            let cross = (q.x - a.x) * dy - (q.y - a.y) * dx;
            if length > 0.0 {
                (cross / length).abs()
            } else {
                0.0
            }
        })
        .fold(0.0, f64::max)
}

/// RMS distance, N, between the force of the law and that of the curve through `n` emitted points.
///
/// Fails where the follower cannot be put back on the points ([`recover()`]).
pub fn force_of_points(design: &Design, n: usize) -> Result<f64> {
    let emitted = recover(&design.cam.follower, &design.cam.profile(n))?;
    Ok(rms_difference(design, &design.cam.law, &emitted.law))
}

/// The emitted cam on a machine without spring or slack, to be run.
pub fn run(design: &Design, points: usize) -> Run {
    Run {
        profile: design.cam.profile(points),
        target: None,
        cam: design.cam.clone(),
        drive: design.problem.drive,
        machine: Machine::default(),
    }
}

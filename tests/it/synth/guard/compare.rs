//! Comparison of one scene by both methods.

use super::asked::Asked;
use super::judge::{Judged, judge};
use super::reference::Reference;
use super::solve::{Aim, EDGE, HELD, Outcome, WHOLE, least_room, solve};
use gaitcam::cam::Check;
use gaitcam::criterion::LimitKind;
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Maximum relative difference of the objectives of both methods.
pub const AGREED: f64 = 1e-6;
/// RMS force error, relative to the mean force, below which it is rounding. Its square is the floor for a difference of two objectives.
const FORCE_FLOOR: f64 = 1e-6;
/// Number of angles at which a law of open level is tested.
pub const ANGLES: usize = 72;

/// Result of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Seen {
    Built(Built),
    /// Both methods find no law.
    Refused,
    /// The limits allow a law, but not if tightened by a millionth.
    Edge,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Built {
    pub certified: bool,
    /// Relative excess of the objective over the reference. It may be negative if the law violates a limit by up to 1e-9.
    pub above: f64,
    /// Largest violation of a limit.
    pub excess: f64,
    /// Whether the objective is below the floor.
    pub is_rounding: bool,
    pub by: Judgement,
}

/// Criterion by which the methods agree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Judgement {
    /// Objective within 1e-6 of the sampled optimum.
    Sampled,
    /// Objective within the interval for tolerances of 1e-9 in the limits.
    Interval,
}

pub fn design(asked: &Asked) -> Result<Design, String> {
    let table: toml::Table = asked.toml().parse().map_err(|e| format!("{e}"))?;
    let scene = scene::read(&table).map_err(|e| e.to_string())?;
    let force = asked.target.as_ref().map(|t| &t.1);
    synthesise(&scene, force).map_err(|e| e.to_string())
}

/// Compares the result with the reference. The error text states the difference.
pub fn compare(asked: &Asked, answer: Result<Design, String>) -> Result<Seen, String> {
    let reference = Reference::new(asked);
    let design = match answer {
        Ok(design) => design,
        Err(words) if reference.space(None).is_some() => {
            return refused(asked, &reference).map_err(|_| words);
        }
        Err(_) => return Ok(Seen::Refused),
    };
    // The limit on vibration is said to fail without a search for what conflicts with it.
    let shakes = |c: &&Check| c.name == LimitKind::Residual && !c.pass;
    if design.infeasible.is_some() || design.checks.iter().any(|c| shakes(&c)) {
        return refused(asked, &reference);
    }
    let x = coefficients(&reference, &design)?;
    let mut judged = judge(&reference, &x);
    let certified = design.solver.certified;
    if let Some(proof) = design.solver.certificate.filter(|_| !certified) {
        judged.stated = proof.relative_gap.max(AGREED);
    }
    if judged.excess > 1.01 * HELD {
        return Err(format!("{} exceeded by {:e}", judged.worst, judged.excess));
    }
    let built = if asked.touches() {
        touching(&reference, &x, &judged)?
    } else {
        let Some(space) = reference.space(None) else {
            return Err("built, and the demands contradict each other".to_string());
        };
        within(&reference, &space, &x, &judged)?
    };
    Ok(Seen::Built(Built { certified, ..built }))
}

/// Checks a scene for which the product finds no law.
fn refused(asked: &Asked, reference: &Reference) -> Result<Seen, String> {
    let angles: Vec<Option<f64>> = if asked.touches() {
        (0..ANGLES)
            .map(|k| Some(TAU * k as f64 / ANGLES as f64))
            .collect()
    } else {
        vec![None]
    };
    let mut seen = Seen::Refused;
    for angle in angles {
        let Some(space) = reference.space(angle) else {
            continue;
        };
        match least_room(reference, &space) {
            Err(words) => return Err(format!("refused, reference: {words}")),
            Ok([_, most]) if most < -EDGE => {
                return Err(format!(
                    "refused, but a law leaves a room of {:e} at {angle:?}",
                    -most
                ));
            }
            Ok([least, _]) if least > HELD => {}
            Ok(_) => seen = Seen::Edge,
        }
    }
    Ok(seen)
}

/// Compares the objective of the law with the interval of the reference.
fn within(
    reference: &Reference,
    space: &super::reference::Space,
    x: &[f64],
    judged: &Judged,
) -> Result<Built, String> {
    // A lower bound that close is all that is asked; rows where the law touches its limits reach it at once.
    let aim = Aim {
        near: Some(x),
        enough: judged.value - judged.stated * size(reference, judged.value).0,
    };
    let bound = match solve(reference, space, 0.0, aim) {
        Outcome::Above(bound) => bound,
        Outcome::Optimum(optimum) => optimum.bound,
        Outcome::Infeasible => match solve(reference, space, 2.0 * HELD, WHOLE) {
            Outcome::Optimum(optimum) => optimum.bound,
            Outcome::Above(bound) => bound,
            Outcome::Infeasible => return Err("built, and the sampled limits leave nothing".into()),
            Outcome::Undecided(words) => return Err(format!("reference: {words}")),
        },
        Outcome::Undecided(words) => return Err(format!("reference: {words}")),
    };
    against(reference, space, judged, bound)
}

/// Reference value of a relative difference, and whether it is the floor: the optimum, or the floor of a force error.
fn size(reference: &Reference, value: f64) -> (f64, bool) {
    let mean = reference
        .asked
        .target
        .as_ref()
        .map_or(0.0, |t| t.0.mean_n());
    let floor = match reference.asked.objective {
        super::asked::Objective::ForceError => 0.5 * (FORCE_FLOOR * mean).powi(2) / AGREED,
        super::asked::Objective::PeakForceError => FORCE_FLOOR * mean / AGREED,
        // The radius is a limit as well as the objective: its tolerance is that of a limit.
        super::asked::Objective::Size => HELD * reference.asked.length() / AGREED,
        _ => 0.0,
    };
    (value.abs().max(floor), value.abs() < floor)
}

fn against(
    reference: &Reference,
    space: &super::reference::Space,
    judged: &Judged,
    bound: f64,
) -> Result<Built, String> {
    let (size, is_rounding) = size(reference, judged.value);
    let above = (judged.value - bound) / size;
    let mut built = Built {
        certified: false,
        above,
        excess: judged.excess,
        is_rounding,
        by: Judgement::Sampled,
    };
    if (-AGREED..=judged.stated).contains(&above) {
        return Ok(built);
    }
    built.by = Judgement::Interval;
    if above < 0.0 {
        // Below the optimum, as its own tolerance in the limits allows?
        return match solve(reference, space, HELD, WHOLE) {
            Outcome::Optimum(o) if judged.value >= o.bound - AGREED * size => Ok(built),
            Outcome::Optimum(o) => Err(format!(
                "{above:e} below the optimum, {:e} with limits eased by 1e-9 (excess {:e} of {})",
                (judged.value - o.bound) / size,
                judged.excess,
                judged.worst
            )),
            _ => Err(format!("{above:e} below the optimum")),
        };
    }
    match solve(reference, space, -2.0 * HELD, WHOLE) {
        Outcome::Optimum(o) if judged.value <= o.value + AGREED * size => Ok(built),
        Outcome::Optimum(o) => Err(format!(
            "{above:e} above the lower bound, {:e} above a law that keeps the limits (value {:e})",
            (judged.value - o.value) / size,
            o.value
        )),
        _ => Err(format!("{above:e} above the lower bound {bound:e}")),
    }
}

/// Checks that the law is the optimum for its touching angle, and that no other touching angle has a better law.
fn touching(reference: &Reference, x: &[f64], judged: &Judged) -> Result<Built, String> {
    let lowest = lowest(reference, x);
    let space = reference
        .space(Some(lowest))
        .ok_or("no law touches at its lowest angle")?;
    let built = within(reference, &space, x, judged)?;
    let (size, _) = size(reference, judged.value);
    let enough = judged.value - AGREED * size;
    for k in 0..ANGLES {
        let angle = TAU * k as f64 / ANGLES as f64;
        let Some(space) = reference.space(Some(angle)) else {
            continue;
        };
        let aim = Aim {
            near: Some(x),
            enough,
        };
        if let Outcome::Optimum(o) = solve(reference, &space, 0.0, aim)
            && o.value < enough
        {
            return Err(format!(
                "{:e} better where the law touches at {angle} instead of {lowest}",
                (judged.value - o.value) / size
            ));
        }
    }
    Ok(built)
}

/// Angle of the lowest point of a law, to rounding of its slope.
fn lowest(reference: &Reference, x: &[f64]) -> f64 {
    let lift =
        |place: &&super::reference::Place| reference.splines.law(place.span, place.theta, x)[0];
    let least = (reference.scan.iter()).min_by(|a, b| lift(a).total_cmp(&lift(b)));
    let mut theta = least.map_or(0.0, |p| p.theta);
    for _ in 0..20 {
        let at = reference
            .splines
            .law(reference.splines.span_of(theta), theta, x);
        if at[2] > 0.0 {
            theta = (theta - (at[1] / at[2]).clamp(-0.01, 0.01)).rem_euclid(TAU);
        }
    }
    theta
}

/// Coefficients of the law in the reference's basis, which must reproduce the law and its derivatives.
fn coefficients(reference: &Reference, design: &Design) -> Result<Vec<f64>, String> {
    let (n, law) = (reference.splines.count(), &design.cam.law);
    let mut matrix = DMatrix::<f64>::zeros(n, n);
    let lift = |place: &super::reference::Place| {
        let inside = reference.splines.breaks()[place.span + 1] - 1e-12;
        law.svaj(place.theta.min(inside)).s
    };
    let pull = |x: &DVector<f64>| {
        let mut out = DVector::<f64>::zeros(n);
        for place in &reference.scan {
            let columns = || reference.splines.columns(place.span).zip(&place.values[0]);
            let miss = lift(place) - columns().map(|(i, b)| b * x[i]).sum::<f64>();
            columns().for_each(|(i, b)| out[i] += b * miss);
        }
        out
    };
    for place in &reference.scan {
        let columns = || reference.splines.columns(place.span).zip(&place.values[0]);
        for (i, b) in columns() {
            columns().for_each(|(j, c)| matrix[(i, j)] += b * c);
        }
    }
    let factor = matrix
        .cholesky()
        .ok_or("functions that depend on each other")?;
    let mut x = DVector::zeros(n);
    for _ in 0..3 {
        x += factor.solve(&pull(&x));
    }
    let x = x.as_slice().to_vec();
    let (mut largest, mut apart) = ([reference.asked.length(); 3], [0.0_f64; 3]);
    for place in &reference.scan {
        let ends = place.ends;
        if place.theta <= ends[0] || place.theta >= ends[1] {
            continue;
        }
        let (own, at) = (
            reference.splines.law(place.span, place.theta, &x),
            law.svaj(place.theta),
        );
        for (k, theirs) in [at.s, at.v, at.a].into_iter().enumerate() {
            largest[k] = largest[k].max(theirs.abs());
            apart[k] = apart[k].max((own[k] - theirs).abs());
        }
    }
    for (k, allowed) in [1e-11, 1e-9, 1e-8].into_iter().enumerate() {
        if apart[k] > allowed * largest[k] {
            return Err(format!(
                "derivative {k} misses the spline by {:e} of {:e}",
                apart[k], largest[k]
            ));
        }
    }
    Ok(x)
}

//! Automatic selection of the simplest sufficient model, with the reason.

use super::models::{contact_run, flexible_run, rigid_run, under};
use super::prepared::Prepared;
use crate::cam::Measures;
use crate::dynamics::flexible::Train;
use crate::dynamics::outcome::{Difference, Model, Outcome};
use crate::dynamics::reason::{ForceMargin, LiftoffMargin, ModelReason, Vibration};
use crate::dynamics::recover::Cycle;
use crate::dynamics::run::Run;
use crate::error::Result;
use crate::poly::amplitudes;
use crate::units::{Dimension, Quantity};

/// Force margin, relative to the mean, below which the contact model is simulated.
pub const MARGIN: f64 = 0.05;
/// Fraction of the lift-off speed above which the contact model is simulated.
pub const NEAR_LIFTOFF: f64 = 0.95;
/// RMS error of the rigid model that is negligible, relative to the mean force (theory §10: 0.20 % at 50 Hz for smooth walking targets).
pub const RIGID_ENOUGH: f64 = 0.002;

/// Selects the model. The default is the rigid model. The flexible model is used if vibration changes the force by more than
/// [`RIGID_ENOUGH`]. The contact model is used near lift-off. The next finer model is simulated once for comparison.
pub(super) fn auto(input: &Run, p: &Prepared) -> Result<Outcome> {
    let rigid = rigid_run(input, p)?;
    let forces: Vec<f64> = p.nodes.iter().map(|at| p.drive.force(*at)).collect();
    let mean = forces.iter().sum::<f64>() / forces.len() as f64;
    // The contact model supports neither a floor nor a motor.
    let is_steady = input.machine.floor.is_none() && p.shaft.is_none();
    let can_lift_off = !p.held && p.cycle == Cycle::TURN && is_steady;
    if can_lift_off && let Some(why) = asks_for_contact(p, &rigid, mean) {
        let next = input.machine.train.map(|_| Model::Flexible);
        return Ok(compared(input, p, contact_run(input, p)?, why, next));
    }
    let contact = can_lift_off.then_some(Model::Contact);
    let margin = force_margin(p, &rigid, &forces, mean);
    let Some(train) = &input.machine.train else {
        let why = ModelReason::NothingVibrates { margin };
        return Ok(compared(input, p, rigid, why, contact));
    };
    let (change, vibration) = vibration(train, p, &forces, mean);
    let allowed = Quantity::share(RIGID_ENOUGH);
    if change <= RIGID_ENOUGH {
        let why = ModelReason::HardlyVibrates {
            vibration,
            allowed,
            margin,
        };
        return Ok(compared(input, p, rigid, why, Some(Model::Flexible)));
    }
    let flexible = flexible_run(input, p)?;
    if flexible.contact_lost && can_lift_off {
        let force = p.load(flexible.force.min);
        let why = ModelReason::VibrationLosesContact { vibration, force };
        let contact = contact_run(input, p)?;
        return Ok(compared(input, p, contact, why, Some(Model::Flexible)));
    }
    let why = ModelReason::Vibrates {
        vibration,
        allowed,
        margin,
    };
    Ok(compared(input, p, flexible, why, contact))
}

/// Adds to the outcome the reason for its model, and its differences from the next finer model. The finer model is simulated for this
/// comparison.
fn compared(
    input: &Run,
    p: &Prepared,
    out: Outcome,
    why: ModelReason,
    next: Option<Model>,
) -> Outcome {
    let next = next.map(|model| difference(&out, model, under(input, p, model)));
    Outcome { why, next, ..out }
}

fn asks_for_contact(p: &Prepared, rigid: &Outcome, mean: f64) -> Option<ModelReason> {
    let scale = mean.abs();
    // Without mass, a small force does not indicate lift-off. Only a negative force requires the contact model.
    let asked = if p.drive.mass > 0.0 {
        rigid.force.min < MARGIN * scale
    } else {
        rigid.contact_lost
    };
    if asked {
        return Some(ModelReason::LowForce {
            force: p.load(rigid.force.min),
            part: Quantity::share(MARGIN),
            mean: p.load(mean),
            liftoff: liftoff_margin(p, rigid),
        });
    }
    let is_near = |liftoff: f64| p.drive.speed > NEAR_LIFTOFF * liftoff;
    if rigid.liftoff_speed.is_some_and(is_near) {
        let liftoff = liftoff_margin(p, rigid);
        return Some(ModelReason::NearLiftoff { liftoff });
    }
    (p.laws.len() > 1).then_some(ModelReason::TwoCams)
}

fn force_margin(p: &Prepared, rigid: &Outcome, forces: &[f64], mean: f64) -> ForceMargin {
    let largest = forces.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    if largest == 0.0 {
        return ForceMargin::NoForce;
    }
    let liftoff = liftoff_margin(p, rigid);
    let low = rigid.force.min;
    // A pure inertia force has no mean value to which the margin could be related.
    if mean.abs() <= 1e-9 * largest {
        return ForceMargin::InertiaOnly {
            low: p.load(low),
            high: p.load(rigid.force.max),
            liftoff,
        };
    }
    // A minimum of zero contains a rounding error of the maximum.
    let low = if low.abs() <= 1e-9 * largest {
        0.0
    } else {
        low
    };
    ForceMargin::SmallestForce {
        force: p.load(low),
        part: Quantity::share(low / mean),
        liftoff,
    }
}

fn liftoff_margin(p: &Prepared, rigid: &Outcome) -> LiftoffMargin {
    let dimension = match p.measures {
        Measures::Straight => Dimension::Speed,
        _ => Dimension::AngularSpeed,
    };
    let speed = Quantity::new(p.drive.speed, dimension);
    match rigid.liftoff_speed {
        Some(w) => LiftoffMargin::LiftoffAt {
            speed,
            liftoff: Quantity::new(w, dimension),
        },
        None if p.held => LiftoffMargin::HeldFromBothSides,
        None if rigid.floor.is_some() => LiftoffMargin::MovingFloor { speed },
        None => LiftoffMargin::NoLiftoff { speed },
    }
}

/// RMS change of the force by vibration, relative to the mean, and its description for messages. The change follows from the harmonics of
/// the rigid force. Harmonic n is multiplied by (1 + 2iζr)/(1 − r² + 2iζr) with r = nω/ω₁, the cam speed ω, the natural frequency ω₁ and
/// the damping ratio ζ.
fn vibration(train: &Train, p: &Prepared, forces: &[f64], mean: f64) -> (f64, Vibration) {
    let Some(natural) = train.natural_frequency(&p.drive) else {
        // Without mass there is no vibration, but the train deflects. The flexible model is therefore always used.
        return (f64::INFINITY, Vibration::NoMass);
    };
    let zeta = train.damping / (2.0 * p.drive.mass * natural);
    let mut sum = 0.0;
    for (n, (a, b)) in amplitudes(forces).into_iter().enumerate().skip(1) {
        let r = n as f64 * p.drive.speed / natural;
        // H − 1 = r²/(1 − r² + 2iζr).
        let extra = r * r / libm::hypot(1.0 - r * r, 2.0 * zeta * r);
        sum += 0.5 * (libm::hypot(a, b) * extra).powi(2);
    }
    // An undamped resonance gives an infinite sum. The flexible model reports it.
    let part = sum.sqrt() / mean.abs();
    let known = Vibration::Harmonics {
        frequency: Quantity::new(natural / std::f64::consts::TAU, Dimension::Frequency),
        ratio: Quantity::new(natural / p.drive.speed, Dimension::Ratio),
        part: Quantity::share(part),
    };
    (if part.is_nan() { f64::INFINITY } else { part }, known)
}

fn difference(base: &Outcome, model: Model, next: Result<Outcome>) -> Difference {
    let (next, failed) = match next {
        Ok(next) => (Some(next), None),
        Err(error) => (None, Some(error)),
    };
    let next = next.as_ref();
    let change = |of: fn(&Outcome) -> f64| next.map_or(0.0, |next| of(next) - of(base));
    Difference {
        model,
        force_min: change(|out| out.force.min),
        force_max: change(|out| out.force.max),
        rms_error: next.and_then(|next| Some(next.force.rms_error? - base.force.rms_error?)),
        lost_fraction: change(|out| out.lost_fraction),
        failed,
    }
}

//! `--model auto`: the least model that is enough, and the numbers that say so.

use super::flexible::Train;
use super::models::{contact_run, flexible_run, rigid_run};
use super::outcome::{Difference, Model, Outcome};
use super::prepared::Prepared;
use super::recover::Cycle;
use super::run::Run;
use crate::cam::Measures;
use crate::error::Result;
use realfft::RealFftPlanner;

/// Force margin, as part of the mean, below which the contact itself is run.
pub const MARGIN: f64 = 0.05;
/// Part of the lift-off speed from which the contact itself is run.
pub const NEAR_LIFTOFF: f64 = 0.95;
/// RMS error of the rigid model, as part of the mean force, that is still nothing (theory §10: 0.20 % at
/// 50 Hz for smooth walking targets).
pub const RIGID_ENOUGH: f64 = 0.002;

/// Rigid first; flexible when the follower's own vibration would move the force by more than
/// [`RIGID_ENOUGH`]; contact when force margin or speed come near lift-off. The next model up is run once
/// to say what it would change.
pub(super) fn auto(input: &Run, p: &Prepared) -> Result<Outcome> {
    let rigid = rigid_run(input, p)?;
    let forces: Vec<f64> = p.nodes.iter().map(|at| p.drive.force(*at)).collect();
    let mean = forces.iter().sum::<f64>() / forces.len() as f64;
    let contact = !p.held && p.cycle == Cycle::TURN;
    if contact && let Some(why) = asks_for_contact(p, &rigid, mean) {
        let mut out = contact_run(input, p)?;
        out.why = why;
        out.next = input
            .machine
            .train
            .map(|_| difference(&out, Model::Flexible, flexible_run(input, p)));
        return Ok(out);
    }
    let margin = margin_words(p, &rigid, &forces, mean);
    let Some(train) = &input.machine.train else {
        let mut out = rigid;
        out.why =
            format!("{margin}; no natural frequency or stiffness is given, so nothing can vibrate");
        if contact {
            out.next = Some(difference(&out, Model::Contact, contact_run(input, p)));
        }
        return Ok(out);
    };
    let (ringing, words) = vibration(train, p, &forces, mean);
    if ringing > RIGID_ENOUGH {
        let mut out = flexible_run(input, p)?;
        if out.contact_lost {
            let flexible_min = out.force.min;
            out = contact_run(input, p)?;
            out.why = format!(
                "{words}; vibrating, the force falls to {flexible_min:.4} N and contact is lost; the contact model leaves the vibration out"
            );
            out.next = Some(difference(&out, Model::Flexible, flexible_run(input, p)));
            return Ok(out);
        }
        out.why = format!("{words}, more than {:.1} %; {margin}", 100.0 * RIGID_ENOUGH);
        if contact {
            out.next = Some(difference(&out, Model::Contact, contact_run(input, p)));
        }
        return Ok(out);
    }
    let mut out = rigid;
    out.why = format!(
        "{words}, no more than {:.1} %; {margin}",
        100.0 * RIGID_ENOUGH
    );
    out.next = Some(difference(&out, Model::Flexible, flexible_run(input, p)));
    Ok(out)
}

fn asks_for_contact(p: &Prepared, rigid: &Outcome, mean: f64) -> Option<String> {
    let scale = mean.abs();
    // Without mass a small force is no nearness to lift-off: only a pull asks for more.
    let asked = if p.drive.mass > 0.0 {
        rigid.force.min < MARGIN * scale
    } else {
        rigid.contact_lost
    };
    if asked {
        let unit = p.measures.force().name;
        return Some(format!(
            "the rigid {} falls to {:.4} {unit}, below {:.0} % of its mean {mean:.4} {unit}; {}",
            p.measures.force_words(),
            rigid.force.min,
            100.0 * MARGIN,
            liftoff_words(p, rigid)
        ));
    }
    if rigid
        .liftoff_speed
        .is_some_and(|w| p.drive.speed > NEAR_LIFTOFF * w)
    {
        return Some(format!("near lift-off: {}", liftoff_words(p, rigid)));
    }
    if p.laws.len() > 1 {
        return Some(
            "two cams hand the follower over with blows that only contact knows".to_string(),
        );
    }
    None
}

fn margin_words(p: &Prepared, rigid: &Outcome, forces: &[f64], mean: f64) -> String {
    let largest = forces.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    let (unit, low) = (p.measures.force().name, rigid.force.min);
    if largest == 0.0 {
        return "no mean force presses the follower on the cam, nor any other: the drive has neither mass nor spring nor preload"
            .to_string();
    }
    let liftoff = liftoff_words(p, rigid);
    // Inertia alone has no mean to be a part of.
    if mean.abs() <= 1e-9 * largest {
        let high = rigid.force.max;
        return format!(
            "no mean force presses the follower on the cam, inertia gives {low:.4} … {high:.4} {unit}; {liftoff}"
        );
    }
    let words = p.measures.force_words();
    let part = 100.0 * low / mean;
    format!("smallest {words} {low:.4} {unit} is {part:.1} % of the mean, {liftoff}")
}

/// A speed for people: slow ones keep their digits.
fn speed_words(speed: f64) -> String {
    if speed != 0.0 && speed.abs() < 0.01 {
        format!("{speed:.4e}")
    } else {
        format!("{speed:.4}")
    }
}

fn liftoff_words(p: &Prepared, rigid: &Outcome) -> String {
    let runs = if p.measures == Measures::Straight {
        "the cam slides at"
    } else {
        "the shaft turns at"
    };
    let unit = p.measures.speed().name;
    match rigid.liftoff_speed {
        Some(w) => format!(
            "{runs} {} {unit}, lift-off is at {} {unit}",
            speed_words(p.drive.speed),
            speed_words(w)
        ),
        None if p.held => "held from both sides, the follower cannot lift off".to_string(),
        None => format!(
            "{runs} {} {unit}, no speed lifts the follower off",
            speed_words(p.drive.speed)
        ),
    }
}

/// RMS change of the force by vibration, as part of the mean, from the rigid force's harmonics, and what
/// to say about it: each harmonic n is passed on with (1 + 2iζr)/(1 − r² + 2iζr), r = nω/ω₁.
fn vibration(train: &Train, p: &Prepared, forces: &[f64], mean: f64) -> (f64, String) {
    let Some(natural) = train.natural_frequency(&p.drive) else {
        // Without mass nothing rings, but springs in series share the lift: always worth running.
        return (
            f64::INFINITY,
            "the column gives without ringing".to_string(),
        );
    };
    let zeta = train.damping / (2.0 * p.drive.mass * natural);
    let mut planner = RealFftPlanner::<f64>::new();
    let forward = planner.plan_fft_forward(forces.len());
    let mut spectrum = forward.make_output_vec();
    if forward
        .process(&mut forces.to_vec(), &mut spectrum)
        .is_err()
    {
        return (f64::INFINITY, "the force has no spectrum".to_string());
    }
    let scale = 2.0 / forces.len() as f64;
    let mut sum = 0.0;
    for (n, c) in spectrum.iter().enumerate().skip(1) {
        let r = n as f64 * p.drive.speed / natural;
        // H − 1 = r²/(1 − r² + 2iζr).
        let extra = r * r / (1.0 - r * r).hypot(2.0 * zeta * r);
        sum += 0.5 * (scale * c.norm() * extra).powi(2);
    }
    // An undamped resonance gives an infinite sum: the flexible run then names it.
    let part = sum.sqrt() / mean.abs();
    let ratio = natural / p.drive.speed;
    let words = format!(
        "first natural frequency {:.2} Hz, {ratio:.1} times the shaft's; its harmonics would move the force by {:.3} % of the mean RMS",
        natural / std::f64::consts::TAU,
        100.0 * part
    );
    (if part.is_nan() { f64::INFINITY } else { part }, words)
}

fn difference(base: &Outcome, model: Model, next: Result<Outcome>) -> Difference {
    match next {
        Ok(next) => Difference {
            model,
            force_min: next.force.min - base.force.min,
            force_max: next.force.max - base.force.max,
            rms_error: next
                .force
                .rms_error
                .zip(base.force.rms_error)
                .map(|(a, b)| a - b),
            lost_fraction: next.lost_fraction - base.lost_fraction,
            failed: None,
        },
        Err(error) => Difference {
            model,
            force_min: 0.0,
            force_max: 0.0,
            rms_error: None,
            lost_fraction: 0.0,
            failed: Some(error.to_string()),
        },
    }
}

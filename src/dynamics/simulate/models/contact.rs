//! Contact model for a prepared cam: event-driven simulation, evaluated at the rows and integrated.

use crate::dynamics::contact::{self, ContactRun, Phase};
use crate::dynamics::outcome::{Force, Model, Outcome, Torque};
use crate::dynamics::reason::RunNote;
use crate::dynamics::recover::Cycle;
use crate::dynamics::run::Run;
use crate::dynamics::simulate::prepared::{Prepared, row_value};
use crate::dynamics::surface::Surface;
use crate::error::{DynamicsError, Placed, Result};
use crate::law::Law;
use std::f64::consts::TAU;

/// Rejects cases that the contact model does not support: followers constrained from both sides, cams with ends, and a varying speed.
fn refuse_contact(input: &Run, p: &Prepared) -> Result<()> {
    if p.held {
        let fault = if input.machine.conjugate.is_some() {
            DynamicsError::HeldByPair
        } else {
            DynamicsError::HeldByGroove
        };
        return Err(fault.into());
    }
    if p.cycle != Cycle::TURN {
        return Err(DynamicsError::NotOneTurn.into());
    }
    if p.shaft.is_some() {
        return Err(DynamicsError::ContactUnderMotor.at_key("machine.motor"));
    }
    Ok(())
}

pub fn contact_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    refuse_contact(input, p)?;
    let surface = |law: &Law| Surface::new(law.clone(), &p.drive);
    let surfaces: Vec<Surface> = p.laws.iter().map(surface).collect();
    let surfaces = &surfaces[..];
    let machine = &input.machine;
    let run = contact::run(surfaces, &p.drive, machine.restitution, &machine.limits);
    let mut out = p.outcome(Model::Contact);
    let (from, to) = run.window();
    let (forces, heights) = samples(&run, surfaces, p);
    let sums = integrate(&run, surfaces, input, p);
    let pressed: f64 = run
        .steady_impacts()
        .map(|i| i.pulse.impulse * p.drive.speed * surfaces[i.surface].at(i.at).v)
        .sum();
    let error_count = to - from;
    out.lost_fraction = run.lost_fraction();
    out.contact_lost = out.lost_fraction > 0.0;
    out.force = Force {
        min: sums.force[0],
        max: sums.force[1],
        rms_error: p.target.as_ref().map(|_| (sums.error / error_count).sqrt()),
    };
    out.torque = p.signed(Torque {
        min: sums.torque[0],
        max: sums.torque[1],
        mean: (sums.work + pressed) / error_count,
        rms: (sums.torque_square / error_count).sqrt(),
    });
    out.settle_cycles = run.settle;
    out.period_turns = run.period;
    p.fill(input, &mut out, &forces, &heights);
    if run.escaped {
        out.notes.push(RunNote::Escapes);
    } else if run.settle.is_none() {
        out.notes.push(RunNote::NotPeriodic {
            turns: run.turns,
            impacts: run.impacts.len(),
        });
    }
    out.impacts = run.impacts;
    Ok(out)
}

/// Contact force, N, and height above the lift of the profile, m, at the rows of one period.
fn samples(run: &ContactRun, surfaces: &[Surface], p: &Prepared) -> (Vec<f64>, Vec<f64>) {
    let (from, _) = run.window();
    let n = p.nodes.len();
    let total = n * run.period;
    let (mut forces, mut heights) = (Vec::with_capacity(total), Vec::with_capacity(total));
    for i in 0..total {
        let angle = from + TAU * i as f64 / n as f64;
        let past = run.stretches.partition_point(|s| s.to <= angle);
        let stretch = run.stretches.get(past).or(run.stretches.last());
        let state = stretch.map(|s| s.phase);
        let (force, lift) = match state {
            Some(Phase::Contact { surface }) => {
                let at = surfaces[surface].at(angle);
                (p.drive.force(at), at.s)
            }
            Some(Phase::Flight(flight)) => (0.0, flight.at(angle).0),
            Some(Phase::Parted { surface }) => (0.0, surfaces[surface].at(angle).s),
            None => (0.0, 0.0),
        };
        forces.push(force);
        heights.push(lift - p.nodes[i % n].s);
    }
    (forces, heights)
}

/// Integrals and extremes of force and torque over one period of the motion.
struct Sums {
    force: [f64; 2],
    torque: [f64; 2],
    work: f64,
    torque_square: f64,
    error: f64,
}

/// Integrates force, torque and error with two Gauss points per row and phase. The method is of fourth order, and the ends of the flights
/// are exact.
fn integrate(run: &ContactRun, surfaces: &[Surface], input: &Run, p: &Prepared) -> Sums {
    const OFFSET: f64 = 0.211_324_865_405_187_1; // (1 − 1/√3)/2
    let (from, to) = run.window();
    let n = p.nodes.len();
    let step = TAU / n as f64;
    let mut sums = Sums {
        force: [f64::INFINITY, f64::NEG_INFINITY],
        torque: [f64::INFINITY, f64::NEG_INFINITY],
        work: 0.0,
        torque_square: 0.0,
        error: 0.0,
    };
    for stretch in &run.stretches {
        let (a, b) = (stretch.from.max(from), stretch.to.min(to));
        if b <= a {
            continue;
        }
        let surface = match stretch.phase {
            Phase::Contact { surface } => Some(&surfaces[surface]),
            Phase::Flight(_) | Phase::Parted { .. } => None,
        };
        let state = |x: f64| {
            surface.map_or((0.0, 0.0), |s| {
                let at = s.at(x);
                let force = p.drive.force(at);
                (force, p.torque(input, force, at))
            })
        };
        let mut x = a;
        while x < b {
            let cell = ((x - p.start) / step + 1e-9).floor();
            let next = (p.start + step * (cell + 1.0)).min(b);
            let width = next - x;
            for u in [OFFSET, 1.0 - OFFSET] {
                let at = x + u * width;
                let (force, torque) = state(at);
                sums.work += 0.5 * width * torque;
                sums.torque_square += 0.5 * width * torque * torque;
                if let Some(target) = &p.target {
                    let wanted = row_value(target, (at - p.start) / step);
                    sums.error += 0.5 * width * (force - wanted).powi(2);
                }
            }
            let (force, torque) = state(x);
            sums.see(force, torque);
            x = next;
        }
        // The force jumps at a landing or lift-off, so the end of a phase is evaluated from inside.
        let (force, torque) = state(b - 1e-12 * (b - a));
        sums.see(force, torque);
    }
    if run.lost_fraction() == 0.0 && surfaces.len() == 1 {
        let (low, high) = surfaces[0].force.extremes();
        sums.force = [low.value, high.value];
    }
    sums
}

impl Sums {
    fn see(&mut self, force: f64, torque: f64) {
        let ([low, high], [least, most]) = (self.force, self.torque);
        self.force = [low.min(force.max(0.0)), high.max(force)];
        self.torque = [least.min(torque), most.max(torque)];
    }
}

//! The contact model on a shaft whose speed varies.
//!
//! Over the part φ of its period instead of its angle the cam is one that turns at constant speed under another law, s(θ(φ)):
//! contact ends and begins at the roots of its force and its gap. In flight the follower does not load the shaft, and a
//! landing takes its impulse from it; speed and events are computed in turns until both agree (exact for plastic landings,
//! after which follower and cam move as one).

use std::f64::consts::TAU;

use super::contact::{refuse_contact, steady_outcome};
use crate::drive::Motor;
use crate::dynamics::contact::{self, ContactRun, Phase};
use crate::dynamics::outcome::{Outcome, Torque};
use crate::dynamics::reason::RunNote;
use crate::dynamics::run::Run;
use crate::dynamics::shaft::{Load, Motion, Node, periodic};
use crate::dynamics::simulate::prepared::Prepared;
use crate::dynamics::simulate::shaft::carrier;
use crate::dynamics::surface::Surface;
use crate::error::Result;
use crate::law::Law;
use crate::poly::PiecewisePoly;

/// Rounds of events and speed at most, and the relative change of the speed at which they agree.
const ROUNDS: usize = 40;
const SAME: f64 = 1e-9;
/// Angle over which the impulse of a landing is spread, before it, rad.
const LANDING: f64 = 1e-4;
/// A side of a place at which a law may jump, rad.
const SIDE: f64 = 1e-10;
/// Equal angles at which two speeds are compared.
const PIECES: usize = 360;

/// A lift over the part of the period, rad: a quintic between its `breaks` and those of the clock.
pub fn in_time(law: &Law, breaks: &[f64], clock: &Motion) -> Law {
    let start = law.extent().0;
    let mut marks: Vec<f64> = clock
        .breaks()
        .chain(breaks.iter().map(|b| b - start))
        .collect();
    marks.sort_by(f64::total_cmp);
    marks.dedup_by(|b, a| *b - *a < 10.0 * SIDE);
    let value = |x: f64| {
        let [phase, rate, bend, _] = clock.phase(x.clamp(0.0, TAU - SIDE));
        let at = law.svaj(start + x);
        let slope = at.v / rate;
        [phase, at.s, slope, (at.a - slope * bend) / (rate * rate)]
    };
    let mut breaks = vec![0.0];
    let mut coefficients = Vec::with_capacity(6 * marks.len());
    for ends in marks.windows(2) {
        let [from, to] = [value(ends[0] + SIDE), value(ends[1] - SIDE)];
        let end = if ends[1] == TAU {
            TAU
        } else {
            clock.phase(ends[1])[0]
        };
        let h = end - breaks[breaks.len() - 1];
        let [d, e] = [h * from[2] / 5.0, h * h * from[3] / 20.0];
        let [f, g] = [h * to[2] / 5.0, h * h * to[3] / 20.0];
        let (y, z) = (from[1], to[1]);
        coefficients.extend([y, y + d, y + 2.0 * d + e, z - 2.0 * f + g, z - f, z]);
        breaks.push(end);
    }
    Law::from_poly(PiecewisePoly::new(breaks, 5, coefficients), true)
}

/// The run over its events, with the speed that the shaft has between them.
pub fn contact_on_shaft(
    input: &Run,
    p: &Prepared,
    motor: &Motor,
    first: &Motion,
) -> Result<Outcome> {
    refuse_contact(input, p)?;
    let machine = &input.machine;
    let mut clock = first.clone();
    let (mut agrees, mut round) = (false, 0);
    loop {
        let surfaces = [Surface::new(in_time(&p.lift, &p.breaks, &clock), &p.drive)];
        let run = contact::run(&surfaces, &p.drive, machine.restitution, &machine.limits);
        round += 1;
        if agrees || round == ROUNDS || run.settle.is_none() || run.period != 1 {
            return Ok(outcome(input, p, motor, (clock, agrees), (&surfaces, run)));
        }
        let load = load(input, p, motor, &clock, &surfaces[0], &run);
        let next = periodic(load, motor, p.drive.speed, Some(&clock))?;
        let angles = (0..PIECES).map(|i| TAU * i as f64 / PIECES as f64);
        let change = |x: f64| (next.speed_at(x)[0] - clock.speed_at(x)[0]).abs();
        agrees = angles.map(change).fold(0.0, f64::max) < SAME * p.drive.speed;
        clock = next;
    }
}

/// The load of a run over the turn: none in flight, and the impulse of every landing on the angle before it.
fn load(
    input: &Run,
    p: &Prepared,
    motor: &Motor,
    clock: &Motion,
    surface: &Surface,
    run: &ContactRun,
) -> Load {
    let (from, to) = run.window();
    let angle = |phase: f64| clock.angle(phase - from);
    let flights: Vec<[f64; 2]> = (run.stretches.iter())
        .filter(|s| !matches!(s.phase, Phase::Contact { .. }) && s.to > from && s.from < to)
        .map(|s| [angle(s.from.max(from)), angle(s.to.min(to))])
        .collect();
    let landings: Vec<(f64, f64)> = (run.steady_impacts())
        .map(|impact| {
            let at = angle(impact.at);
            let [_, rate, ..] = clock.phase(at);
            // By the angle of the cam; the law over time has it by the part of the period.
            let kick = impact.pulse.impulse * surface.at(impact.at).v * rate;
            let speed = clock.speed_at(at - LANDING)[0];
            (
                at,
                (kick * speed - 0.5 * kick * kick / motor.inertia) / LANDING,
            )
        })
        .collect();
    let start = p.start;
    let edges = flights.iter().flatten().copied();
    let before = landings.iter().flat_map(|(at, _)| [*at, at - LANDING]);
    let edges = edges.chain(before).map(|x| start + x.rem_euclid(TAU));
    let breaks: Vec<f64> = p.breaks.iter().copied().chain(edges).collect();
    let carrier = carrier(input, p);
    Load::of(p.lift.extent(), &breaks, carrier.steps, &|theta| {
        let x = theta - start;
        let struck = landings
            .iter()
            .filter(|(at, _)| (at - x).rem_euclid(TAU) <= LANDING);
        let torque: f64 = struck.map(|landing| landing.1).sum();
        if torque != 0.0 {
            return Node::of_torque(torque);
        }
        if flights.iter().any(|[a, b]| x >= *a && x < *b) {
            return Node::of_torque(0.0);
        }
        let at = p.lift.svaj(theta);
        Node::new(&p.drive, at, carrier.arms(at), 0.0)
    })
}

/// What is reported of a run, by the angle of the cam.
fn outcome(
    input: &Run,
    p: &Prepared,
    motor: &Motor,
    (clock, agrees): (Motion, bool),
    (surfaces, run): (&[Surface; 1], ContactRun),
) -> Outcome {
    let n = p.nodes.len();
    let report = clock.report(motor, p.lift.extremes(0).0.at);
    let p = Prepared {
        shaft: Some(clock.at_rows(n)),
        shaft_report: report,
        ..p.clone()
    };
    let mut out = steady_outcome(input, &p, surfaces, run);
    if !agrees {
        out.notes.push(RunNote::ShaftUnsettled);
    }
    let torques = || out.rows.iter().map(|row| row.torque);
    let count = out.rows.len() as f64;
    out.torque = Torque {
        min: torques().fold(f64::INFINITY, f64::min),
        max: torques().fold(f64::NEG_INFINITY, f64::max),
        mean: out.torque.mean,
        rms: (torques().map(|t| t * t).sum::<f64>() / count).sqrt(),
    };
    out
}

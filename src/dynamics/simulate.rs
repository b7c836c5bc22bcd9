//! Runs an emitted cam under one model.

use super::contact::{self, ContactRun, Limits, Phase};
use super::flexible::{self, Train};
use super::impact::Restitution;
use super::load_cell::LoadCell;
use super::outcome::{Force, Model, Outcome, Row, Torque};
use super::profile_curve::{mirrored, recover};
use super::surface::Surface;
use super::two_cams::{envelope, shifted};
use super::{choose, rigid};
use crate::cam::{Cam, ProfilePoint};
use crate::drive::Drive;
use crate::error::{Error, Result};
use crate::law::{Law, Svaj};
use std::f64::consts::TAU;

/// What is known of the machine beyond its drive; the default is a rigid one without friction, plastic
/// landings and one cam.
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    /// What gives between cam and mass, where it is known.
    pub train: Option<Train>,
    /// Coefficient of friction between cam and flat face.
    pub friction: f64,
    /// How landings end.
    pub restitution: Restitution,
    /// Angle by which a second, equal cam follows the first on the shaft, rad.
    pub second_cam: Option<f64>,
    /// Smoothing of the emitted points, m; 0 interpolates them.
    pub smoothing: f64,
    /// The load cell, where there is one.
    pub load_cell: Option<LoadCell>,
    /// How long a contact run may take to settle.
    pub limits: Limits,
}

impl Default for Machine {
    fn default() -> Self {
        Machine {
            train: None,
            friction: 0.0,
            restitution: Restitution::Prescribed(0.0),
            second_cam: None,
            smoothing: 0.0,
            load_cell: None,
            limits: Limits::default(),
        }
    }
}

/// Everything one simulation needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The cam the profile was emitted from: its follower is used, its law only to say how far the emitted
    /// points are from it.
    pub cam: Cam,
    /// The machine; a negative speed turns the cam clockwise.
    pub drive: Drive,
    /// The emitted profile: equal steps of θ over one turn.
    pub profile: Vec<ProfilePoint>,
    /// Wanted force at equal steps of one turn from θ = 0, N.
    pub target: Option<Vec<f64>>,
    /// Machine data.
    pub machine: Machine,
}

/// The cam as the models see it: turning in the sense of growing angle, one or two profiles.
pub(super) struct Prepared {
    pub drive: Drive,
    pub reversed: bool,
    /// Lift of each cam.
    pub laws: Vec<Law>,
    /// Lift of the higher one.
    pub lift: Law,
    /// Motion at the angles of the rows.
    pub nodes: Vec<Svaj>,
    pub start: f64,
    pub reach: f64,
    /// Target at the angles of the rows.
    pub target: Option<Vec<f64>>,
    pub mismatch: f64,
    pub law_mismatch: f64,
    pub notes: Vec<String>,
}

/// Runs the emitted cam under `model`.
///
/// Fails on profiles that are no curve for their follower (see [`recover`]), on machine data out of
/// range, on an undamped resonance, and on `flexible` without a [`Train`].
pub fn simulate(input: &Run, model: Model) -> Result<Outcome> {
    let prepared = prepare(input)?;
    match model {
        Model::Auto => choose::auto(input, &prepared),
        Model::Rigid => rigid_run(input, &prepared),
        Model::Flexible => flexible_run(input, &prepared),
        Model::Contact => contact_run(input, &prepared),
    }
}

pub(super) fn prepare(input: &Run) -> Result<Prepared> {
    let drive = &input.drive;
    let numbers = [
        drive.rest_force,
        drive.spring_rate,
        drive.damping,
        drive.mass,
        drive.speed,
        input.machine.friction,
        input.machine.smoothing,
    ];
    if numbers.iter().any(|x| !x.is_finite())
        || drive.mass < 0.0
        || drive.damping < 0.0
        || drive.spring_rate < 0.0
    {
        return Err(Error::new(
            "the machine's mass, spring, damping and speed must be finite, the first three not negative",
        ));
    }
    if input.machine.friction < 0.0 || input.machine.smoothing < 0.0 {
        return Err(Error::new("friction and smoothing cannot be negative"));
    }
    input.machine.restitution.check()?;
    let emitted = recover(&input.cam.follower, &input.profile, input.machine.smoothing)?;
    let law_mismatch = input
        .profile
        .iter()
        .zip(&emitted.nodes)
        .fold(0.0_f64, |m, (p, at)| {
            m.max((input.cam.law.svaj(p.theta).s - at.s).abs())
        });
    let mut notes = Vec::new();
    if let Some(kept) = emitted.harmonics {
        notes.push(format!(
            "profile smoothed within {:e} m: {kept} harmonics kept",
            input.machine.smoothing
        ));
    }
    let reversed = drive.speed < 0.0;
    let forward = Drive {
        speed: drive.speed.abs(),
        ..*drive
    };
    let one = if reversed {
        mirrored(&emitted.law)
    } else {
        emitted.law
    };
    let n = input.profile.len();
    let start = one.extent().0;
    let mut laws = vec![one];
    let mut lift = laws[0].clone();
    if let Some(angle) = input.machine.second_cam {
        let second = shifted(&laws[0], if reversed { -angle } else { angle });
        lift = envelope(&lift, &second);
        laws.push(second);
    }
    let at = |i: usize| start + TAU * i as f64 / n as f64;
    let single = laws.len() == 1 && !reversed;
    let nodes = if single {
        emitted.nodes
    } else {
        (0..n).map(|i| lift.svaj(at(i))).collect()
    };
    let sign = if reversed { -1.0 } else { 1.0 };
    let target = match &input.target {
        Some(values) if values.is_empty() || values.iter().any(|f| !f.is_finite()) => {
            return Err(Error::new("the target force must be finite at every angle"));
        }
        Some(values) => Some((0..n).map(|i| phase_value(values, sign * at(i))).collect()),
        None => None,
    };
    Ok(Prepared {
        drive: forward,
        reversed,
        laws,
        lift,
        nodes,
        start,
        reach: rigid::reach(&input.cam.follower),
        target,
        mismatch: emitted.mismatch,
        law_mismatch,
        notes,
    })
}

/// Value at angle `theta` of samples at equal steps of one turn, linear between.
fn phase_value(values: &[f64], theta: f64) -> f64 {
    let n = values.len();
    let x = theta.rem_euclid(TAU) / TAU * n as f64;
    // A sample's own angle, met within rounding, is that sample.
    let nearest = x.round();
    if (x - nearest).abs() < 1e-6 {
        return values[nearest as usize % n];
    }
    let (i, u) = (x.floor() as usize, x.fract());
    values[i % n] * (1.0 - u) + values[(i + 1) % n] * u
}

impl Prepared {
    /// Torque in the sense of turning for force and motion, N·m.
    pub fn torque(&self, friction: f64, force: f64, at: Svaj) -> f64 {
        force * at.v + friction * force.abs() * (self.reach + at.s)
    }

    fn rms_error(&self, forces: &[f64]) -> Option<f64> {
        let target = self.target.as_ref()?;
        let sum: f64 = forces
            .iter()
            .enumerate()
            .map(|(i, f)| (f - target[i % target.len()]).powi(2))
            .sum();
        Some((sum / forces.len() as f64).sqrt())
    }

    /// Rows from forces (and heights over the profile's lift) at equal angles over whole turns.
    fn rows(&self, input: &Run, forces: &[f64], heights: &[f64], blows: &[(f64, f64)]) -> Vec<Row> {
        let n = self.nodes.len();
        let total = forces.len();
        let length = TAU * total as f64 / n as f64;
        let cell = input.machine.load_cell.map_or_else(
            || forces.to_vec(),
            |c| c.reading(forces, blows, length, self.drive.speed),
        );
        let sign = if self.reversed { -1.0 } else { 1.0 };
        let first = if self.reversed {
            -(self.start + TAU)
        } else {
            self.start
        };
        let mut rows = vec![Row::default(); total];
        for i in 0..total {
            let at = self.nodes[i % n];
            let touch = rigid::touch(
                &input.cam.follower,
                &self.drive,
                input.machine.friction,
                at,
                forces[i],
            );
            let torque = self.torque(input.machine.friction, forces[i], at);
            let place = if self.reversed {
                (total - i) % total
            } else {
                i
            };
            rows[place] = Row {
                theta: first + TAU * place as f64 / n as f64,
                contact_force: forces[i],
                torque: sign * torque,
                power: torque * self.drive.speed,
                lift: at.s + heights[i],
                gap: if forces[i] == 0.0 {
                    heights[i].max(0.0)
                } else {
                    0.0
                },
                normal_force: touch.normal,
                sliding: sign * touch.sliding,
                entraining: sign * touch.entraining,
                side_thrust: touch.side_thrust,
                load_cell: cell[i],
            };
        }
        rows
    }

    fn signed(&self, t: Torque) -> Torque {
        if !self.reversed {
            return t;
        }
        Torque {
            min: -t.max,
            max: -t.min,
            mean: -t.mean,
            rms: t.rms,
        }
    }

    fn sampled_torque(&self, friction: f64, forces: &[f64]) -> Torque {
        let n = self.nodes.len();
        let values: Vec<f64> = forces
            .iter()
            .enumerate()
            .map(|(i, f)| self.torque(friction, *f, self.nodes[i % n]))
            .collect();
        let count = values.len() as f64;
        Torque {
            min: values.iter().copied().fold(f64::INFINITY, f64::min),
            max: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            mean: values.iter().sum::<f64>() / count,
            rms: (values.iter().map(|t| t * t).sum::<f64>() / count).sqrt(),
        }
    }

    pub fn liftoff(&self) -> Option<f64> {
        rigid::liftoff_speed(&self.lift, &self.drive)
    }

    fn outcome(&self, model: Model, why: &str) -> Outcome {
        Outcome {
            model,
            why: why.to_string(),
            contact_lost: false,
            lost_fraction: 0.0,
            force: Force::default(),
            torque: Torque::default(),
            liftoff_speed: self.liftoff(),
            settle_cycles: Some(0),
            period_turns: 1,
            impacts: Vec::new(),
            next: None,
            profile_mismatch: self.mismatch,
            law_mismatch: self.law_mismatch,
            notes: self.notes.clone(),
            rows: Vec::new(),
        }
    }
}

pub(super) fn rigid_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let friction = input.machine.friction;
    let mut out = p.outcome(Model::Rigid, "asked for");
    let forces: Vec<f64> = p.nodes.iter().map(|at| p.drive.force(*at)).collect();
    let surface = Surface::new(p.lift.clone(), &p.drive);
    let (low, high) = surface.force.extremes();
    out.force = Force {
        min: low.value,
        max: high.value,
        rms_error: p.rms_error(&forces),
    };
    out.torque = p.sampled_torque(friction, &forces);
    if let Some(curve) = rigid::torque_curve(&p.lift, &p.drive, friction, p.reach) {
        let (low, high) = curve.extremes();
        (out.torque.min, out.torque.max) = (low.value, high.value);
        out.torque.mean = curve.integral() / TAU;
    }
    out.torque = p.signed(out.torque);
    out.lost_fraction = surface.pulls.iter().map(|(a, b)| b - a).sum::<f64>() / TAU;
    out.contact_lost = out.lost_fraction > 0.0;
    if out.contact_lost {
        out.notes.push(
            "the rigid model pulls where the force is negative: run --model contact".to_string(),
        );
    }
    if p.laws.len() > 1 {
        out.notes.push(
            "the rigid model leaves out the blows where one cam takes over from the other"
                .to_string(),
        );
    }
    out.rows = p.rows(input, &forces, &vec![0.0; forces.len()], &[]);
    Ok(out)
}

pub(super) fn flexible_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let Some(train) = &input.machine.train else {
        return Err(Error::new("the flexible model needs to know what gives")
            .help("give the follower's natural frequency, or its stiffness"));
    };
    let steady = flexible::steady(&p.lift, &p.drive, train)?;
    let mut out = p.outcome(Model::Flexible, "asked for");
    let n = p.nodes.len();
    // The rows' angles are among the breaks of the forcing.
    let mut k = 0;
    let (mut forces, mut heights, mut outputs) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..n {
        let at = p.start + TAU * i as f64 / n as f64;
        while k + 1 < steady.theta.len() && steady.theta[k] < at - 1e-9 {
            k += 1;
        }
        forces.push(steady.contact[k]);
        heights.push(steady.deflection[k]);
        outputs.push(steady.output[k]);
    }
    let (low, high) = steady.contact_extremes();
    out.force = Force {
        min: low.value,
        max: high.value,
        rms_error: p.rms_error(&outputs),
    };
    out.torque = p.signed(p.sampled_torque(input.machine.friction, &forces));
    out.contact_lost = low.value < 0.0;
    out.lost_fraction = forces.iter().filter(|f| **f < 0.0).count() as f64 / n as f64;
    if out.contact_lost {
        out.notes.push(
            "the vibrating follower leaves the cam: the flexible model pulls there".to_string(),
        );
    }
    out.rows = p.rows(input, &forces, &heights, &[]);
    Ok(out)
}

pub(super) fn contact_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let surfaces: Vec<Surface> = p
        .laws
        .iter()
        .map(|law| Surface::new(law.clone(), &p.drive))
        .collect();
    let run = contact::run(
        &surfaces,
        &p.drive,
        &input.machine.restitution,
        &input.machine.limits,
    );
    let mut out = p.outcome(Model::Contact, "asked for");
    let friction = input.machine.friction;
    let (from, to) = run.window();
    let n = p.nodes.len();
    let total = n * run.period;
    let (mut forces, mut heights) = (Vec::with_capacity(total), Vec::with_capacity(total));
    let mut k = 0;
    for i in 0..total {
        let angle = from + TAU * i as f64 / n as f64;
        while k + 1 < run.stretches.len() && run.stretches[k].to <= angle {
            k += 1;
        }
        let state = run.stretches.get(k).map(|s| s.phase);
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
    let sums = integrate(&run, &surfaces, p, friction);
    let blows: Vec<(f64, f64)> = run
        .steady_impacts()
        .map(|i| (i.at - from, i.pulse.impulse))
        .collect();
    let pressed: f64 = run
        .steady_impacts()
        .map(|i| i.pulse.impulse * p.drive.speed * surfaces[i.surface].at(i.at).v)
        .sum();
    let error_count = to - from;
    out.lost_fraction = run.lost_fraction();
    out.contact_lost = out.lost_fraction > 0.0;
    out.force = Force {
        min: sums.min,
        max: run
            .steady_impacts()
            .fold(sums.max, |m, i| m.max(i.pulse.peak_force)),
        rms_error: p.target.as_ref().map(|_| (sums.error / error_count).sqrt()),
    };
    out.torque = p.signed(Torque {
        min: sums.torque_min,
        max: sums.torque_max,
        mean: (sums.work + pressed) / error_count,
        rms: (sums.torque_square / error_count).sqrt(),
    });
    out.settle_cycles = run.settle;
    out.period_turns = run.period;
    out.rows = p.rows(input, &forces, &heights, &blows);
    if run.escaped {
        out.notes
            .push("the mass leaves the cam and nothing brings it back".to_string());
    } else if run.settle.is_none() {
        out.notes.push(format!(
            "the motion does not repeat within {} turns and {} impacts",
            run.turns,
            run.impacts.len()
        ));
    }
    out.impacts = run.impacts;
    Ok(out)
}

/// Integrals and extremes over one repetition.
struct Sums {
    min: f64,
    max: f64,
    torque_min: f64,
    torque_max: f64,
    work: f64,
    torque_square: f64,
    error: f64,
}

/// Two Gauss points per row and stretch: fourth order, the ends of flights resolved.
fn integrate(run: &ContactRun, surfaces: &[Surface], p: &Prepared, friction: f64) -> Sums {
    const OFFSET: f64 = 0.211_324_865_405_187_1; // (1 − 1/√3)/2
    let (from, to) = run.window();
    let n = p.nodes.len();
    let step = TAU / n as f64;
    let mut sums = Sums {
        min: f64::INFINITY,
        max: f64::NEG_INFINITY,
        torque_min: f64::INFINITY,
        torque_max: f64::NEG_INFINITY,
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
                (force, p.torque(friction, force, at))
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
        // The end of a stretch, seen from inside: at a landing or lift-off the force steps.
        let (force, torque) = state(b - 1e-12 * (b - a));
        sums.see(force, torque);
    }
    if run.lost_fraction() == 0.0 && surfaces.len() == 1 {
        let (low, high) = surfaces[0].force.extremes();
        (sums.min, sums.max) = (low.value, high.value);
    }
    sums
}

impl Sums {
    fn see(&mut self, force: f64, torque: f64) {
        self.min = self.min.min(force.max(0.0));
        self.max = self.max.max(force);
        self.torque_min = self.torque_min.min(torque);
        self.torque_max = self.torque_max.max(torque);
    }
}

fn row_value(values: &[f64], x: f64) -> f64 {
    let n = values.len();
    let (i, u) = (x.floor().rem_euclid(n as f64) as usize, x - x.floor());
    values[i % n] * (1.0 - u) + values[(i + 1) % n] * u
}

#[cfg(test)]
#[path = "simulate_tests.rs"]
mod tests;

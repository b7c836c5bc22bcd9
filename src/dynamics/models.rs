//! The three models on a prepared cam, each with its outcome.

use super::contact::{self, ContactRun, Phase};
use super::outcome::{Force, Model, Outcome, Pressure, Row, Torque};
use super::profile_curve::Cycle;
use super::simulate::{Prepared, Run};
use super::surface::Surface;
use super::touch::{Touch, touch};
use super::{flexible, hertz, rigid};
use crate::error::{Error, Result};
use crate::law::Svaj;
use std::f64::consts::TAU;

impl Prepared {
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
        let length = self.step * total as f64;
        let cell = input.machine.load_cell.map_or_else(
            || forces.to_vec(),
            |c| c.reading(forces, blows, length, self.drive.speed),
        );
        let sign = if self.reversed { -1.0 } else { 1.0 };
        let first = if self.reversed {
            -(self.start + self.cycle.length)
        } else {
            self.start
        };
        let mut rows = vec![Row::default(); total];
        for i in 0..total {
            let at = self.nodes[i % n];
            let touch = self.touch(input, i % n, at, forces[i]);
            let torque = self.torque(input, forces[i], at);
            let place = if self.reversed {
                (total - i) % total
            } else {
                i
            };
            rows[place] = Row {
                theta: first + self.step * place as f64,
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

    /// The contact that bears: the second cam's where a conjugate pair's first one would have to pull.
    fn touch(&self, input: &Run, row: usize, at: Svaj, force: f64) -> Touch {
        let (speed, friction) = (self.drive.speed, input.machine.friction);
        match (&input.machine.conjugate, &self.second) {
            (Some(cam), Some(nodes)) if force < 0.0 => {
                touch(&cam.follower, speed, friction, nodes[row], -force)
            }
            _ => touch(&input.cam.follower, speed, friction, at, force),
        }
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

    fn sampled_torque(&self, input: &Run, forces: &[f64]) -> Torque {
        let n = self.nodes.len();
        let values: Vec<f64> = forces
            .iter()
            .enumerate()
            .map(|(i, f)| self.torque(input, *f, self.nodes[i % n]))
            .collect();
        let count = values.len() as f64;
        Torque {
            min: values.iter().copied().fold(f64::INFINITY, f64::min),
            max: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            mean: values.iter().sum::<f64>() / count,
            rms: (values.iter().map(|t| t * t).sum::<f64>() / count).sqrt(),
        }
    }

    /// Highest line pressure over the rows; curvatures of both bodies added, the flat face has none.
    fn hertz(&self, input: &Run, rows: &[Row]) -> Option<Pressure> {
        let face = input.machine.face?;
        let modulus = hertz::modulus(face.cam, face.follower);
        let n = self.nodes.len();
        rows.iter()
            .enumerate()
            .map(|(i, row)| {
                let place = if self.reversed {
                    (rows.len() - i) % n
                } else {
                    i % n
                };
                // A positive normal force, whichever cam bears it.
                let bearing = self.touch(input, place, self.nodes[place], row.contact_force);
                let press = bearing.normal.abs();
                Pressure {
                    theta: row.theta,
                    contact: hertz::line(press, face.length, bearing.curvature.abs(), modulus),
                }
            })
            .max_by(|a, b| a.contact.pressure.total_cmp(&b.contact.pressure))
    }

    pub fn liftoff(&self) -> Option<f64> {
        if self.held {
            return None;
        }
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
            hertz: None,
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
    out.torque = p.sampled_torque(input, &forces);
    let curve = if p.rubs {
        None
    } else {
        let friction = if p.reach > 0.0 { friction } else { 0.0 };
        rigid::torque_curve(&p.lift, &p.drive, friction, p.reach)
    };
    if let Some(curve) = curve {
        let (low, high) = curve.extremes();
        (out.torque.min, out.torque.max) = (low.value, high.value);
        out.torque.mean = curve.integral() / p.cycle.length;
    }
    out.torque = p.signed(out.torque);
    let pulled = surface.pulls.iter().fold(0.0, |sum, (a, b)| sum + b - a) / p.cycle.length;
    if p.held {
        note_other_side(&mut out, input, pulled);
    } else {
        out.lost_fraction = pulled;
    }
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
    out.hertz = p.hertz(input, &out.rows);
    Ok(out)
}

/// Where a groove or a pair holds the follower from both sides a pull is the other side's push.
fn note_other_side(out: &mut Outcome, input: &Run, pulled: f64) {
    if pulled <= 0.0 {
        return;
    }
    let side = if input.machine.conjugate.is_some() {
        "the second cam"
    } else {
        "the groove's other wall"
    };
    out.notes.push(format!(
        "{side} bears for {:.2} % of the cycle, up to {:.4} N; at each change the play between both sides is crossed",
        100.0 * pulled,
        -out.force.min
    ));
}

pub(super) fn flexible_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let Some(train) = &input.machine.train else {
        return Err(Error::new("the flexible model needs to know what gives")
            .help("give the follower's natural frequency, or its stiffness"));
    };
    if !p.cycle.closed {
        return Err(
            Error::new("a slide that ends has no steady vibration").help("run --model rigid")
        );
    }
    let steady = flexible::steady(&p.lift, &p.drive, train)?;
    let mut out = p.outcome(Model::Flexible, "asked for");
    let n = p.nodes.len();
    // The rows' angles are among the breaks of the forcing.
    let mut k = 0;
    let (mut forces, mut heights, mut outputs) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..n {
        let at = p.start + p.step * i as f64;
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
    out.torque = p.signed(p.sampled_torque(input, &forces));
    let pulled = forces.iter().filter(|f| **f < 0.0).count() as f64 / n as f64;
    if p.held {
        note_other_side(&mut out, input, pulled);
    } else {
        out.contact_lost = low.value < 0.0;
        out.lost_fraction = pulled;
    }
    if out.contact_lost {
        out.notes.push(
            "the vibrating follower leaves the cam: the flexible model pulls there".to_string(),
        );
    }
    out.rows = p.rows(input, &forces, &heights, &[]);
    out.hertz = p.hertz(input, &out.rows);
    Ok(out)
}

/// Lift-off has no meaning where both sides hold, and no steady state where the cam ends.
fn refuse_contact(input: &Run, p: &Prepared) -> Result<()> {
    if p.held {
        let what = if input.machine.conjugate.is_some() {
            "a conjugate pair holds its follower from both sides"
        } else {
            "the groove holds its roller from both sides"
        };
        return Err(Error::new(format!("{what}: nothing lifts off"))
            .help("run --model rigid or flexible; they say which side bears"));
    }
    if p.cycle != Cycle::TURN {
        return Err(
            Error::new("the contact model follows a cam that turns once per cycle")
                .help("run --model rigid: its smallest force says whether a slide keeps contact"),
        );
    }
    Ok(())
}

pub(super) fn contact_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    refuse_contact(input, p)?;
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
    let sums = integrate(&run, &surfaces, input, p);
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
    out.hertz = p.hertz(input, &out.rows);
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
fn integrate(run: &ContactRun, surfaces: &[Surface], input: &Run, p: &Prepared) -> Sums {
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

//! Event-driven simulation of the contact between a mass and the profiles of a shaft.

use super::flight::Flight;
use super::impact::Pulse;
use super::{ContactRun, Impact, Limits, Phase, Stretch};
use crate::drive::Drive;
use crate::dynamics::surface::Surface;
use std::f64::consts::TAU;

/// Separation speed, relative to the velocities of the motion, below which the mass stays in contact after an impact.
const REST: f64 = 1e-9;
/// Stiffness ratio κ = k/(mω²) above which inertia is neglected, because the free motion is much faster than the rotation.
const QUASI_STATIC: f64 = 1e10;
/// Fraction of the lift below which a gap is a rounding error.
const TOUCHING: f64 = 1e-15;
/// Maximum number of steps in the search for one landing.
const MOST_STEPS: usize = 200_000;
/// Difference between the states at two full turns, relative to the maximum lift, below which the motion counts as periodic.
const SAME: f64 = 1e-9;

/// State of the mass at the start of a turn: the profile in contact, or height and slope of the flight.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Mark {
    On(usize),
    Air(f64, f64),
}

struct Engine<'a> {
    surfaces: &'a [Surface],
    drive: &'a Drive,
    restitution: f64,
    /// Damping γ of the free motion y″ + γ y′ + κ y + f = 0, per radian. The height is y, κ is the field `kappa`, and f is `push`.
    gamma: f64,
    kappa: f64,
    push: f64,
    massless: bool,
    /// Reference lift, m, for detecting rounding errors. Speeds up to `rest_speed`, m/s, count as zero.
    lift_scale: f64,
    rest_speed: f64,
    run: ContactRun,
    marks: Vec<Mark>,
}

/// Simulates one mass on one or more profiles of a shaft until the motion is periodic. The mass starts in contact at the first angle. The
/// speed of the drive must be positive or zero.
///
/// Source of the events: theory §10. Gravity and preload are part of the rest force of the drive.
pub fn run(surfaces: &[Surface], drive: &Drive, restitution: f64, limits: &Limits) -> ContactRun {
    let inertia = drive.mass * drive.speed * drive.speed;
    let kappa = drive.spring_rate / inertia;
    let massless = !inertia.is_normal() || kappa.abs() > QUASI_STATIC;
    let (kappa, push) = if massless {
        (0.0, 0.0)
    } else {
        (kappa, drive.rest_force / inertia)
    };
    let scale = |order: usize| {
        let extremes = surfaces.iter().map(|s| s.law.extremes(order));
        extremes.fold(0.0_f64, |m, (low, high)| m.max(high.value).max(-low.value))
    };
    let lift_scale = scale(0);
    let start = surfaces.first().map_or(0.0, |s| s.law.extent().0);
    let engine = Engine {
        surfaces,
        drive,
        restitution,
        gamma: drive.damping * drive.speed / inertia,
        kappa,
        push,
        massless,
        lift_scale,
        rest_speed: REST * drive.speed * scale(1).max(push.abs().min(lift_scale)),
        run: ContactRun {
            stretches: Vec::new(),
            impacts: Vec::new(),
            start,
            settle: None,
            period: 1,
            turns: 0,
            escaped: false,
        },
        marks: Vec::new(),
    };
    engine.go(limits)
}

impl Engine<'_> {
    fn go(mut self, limits: &Limits) -> ContactRun {
        let end = self.run.start + TAU * limits.turns as f64;
        let mut now = self.run.start;
        let mut surface = self.highest(now);
        self.marks.push(Mark::On(surface));
        // During a flight: the flight, the index of the profile that the mass left, and the angle until which the gap certainly opens.
        let mut air: Option<(Flight, usize, f64)> = None;
        while now < end && self.run.impacts.len() < limits.impacts {
            if let Some((flight, left, blind)) = air.take() {
                let Some((at, struck)) = self.landing(&flight, left, blind, end) else {
                    self.stretch(Phase::Flight(flight), now, end);
                    self.run.escaped = self.gap(&flight, end) > 1e3 * self.lift_scale;
                    now = end;
                    continue;
                };
                if self.stretch(Phase::Flight(flight), now, at) {
                    break;
                }
                let speed = self.closing_speed(flight.at(at).1, struck, at);
                let height = self.height(&flight, at);
                (now, surface) = (at, struck);
                air = self.strike(now, surface, speed, flight.start, height);
                continue;
            }
            let (until, event) = self.leave(surface, now, end);
            if self.stretch(Phase::Contact { surface }, now, until) {
                break;
            }
            now = until;
            match event {
                Leave::End => {}
                Leave::Pull(to) if self.massless => {
                    if self.stretch(Phase::Parted { surface }, now, to) {
                        break;
                    }
                    now = to;
                }
                Leave::Pull(to) => {
                    let at = self.surfaces[surface].at(now);
                    air = Some((self.flight(now, at.s, at.v), surface, self.blind(now, to)));
                }
                Leave::Handover(next) => {
                    let rate = self.surfaces[surface].at(now).v;
                    let speed = self.closing_speed(rate, next, now);
                    surface = next;
                    if speed > self.rest_speed && !self.massless {
                        air = self.strike(now, next, speed, now, 0.0);
                    }
                }
            }
        }
        self.run.turns = self.run.turns.max(1);
        self.run
    }

    /// Processes a landing on a profile. The result is the flight after the rebound, or `None` if the mass stays in contact.
    fn strike(
        &mut self,
        now: f64,
        surface: usize,
        speed: f64,
        since: f64,
        height: f64,
    ) -> Option<(Flight, usize, f64)> {
        if speed <= self.rest_speed {
            return None;
        }
        let pulse = Pulse::new(self.drive.mass, speed, self.restitution);
        self.run.impacts.push(Impact {
            at: now,
            surface,
            speed,
            since,
            height,
            pulse,
        });
        if pulse.rebound <= self.rest_speed {
            return None;
        }
        let here = self.surfaces[surface].at(now);
        let rate = here.v + pulse.rebound / self.drive.speed;
        Some((self.flight(now, here.s, rate), surface, now))
    }

    fn flight(&self, start: f64, y: f64, rate: f64) -> Flight {
        Flight {
            start,
            y,
            rate,
            curvature: -(self.push + self.kappa * y + self.gamma * rate),
            kappa: self.kappa,
            gamma: self.gamma,
        }
    }

    /// Angle up to which the gap is certain to increase after lift-off. Up to this angle, the force stays negative and the spring cannot
    /// reverse the motion.
    fn blind(&self, from: f64, to: f64) -> f64 {
        let rate = self.kappa.max(0.25 * self.gamma * self.gamma).sqrt();
        to.min(from + 0.5 / rate.max(1e-3))
    }

    /// Approach speed, m/s, of a mass with the slope `rate` (dy/dθ) and the profile with index `surface`. The result is 0 if mass and
    /// profile do not approach each other.
    fn closing_speed(&self, rate: f64, surface: usize, at: f64) -> f64 {
        ((self.surfaces[surface].at(at).v - rate) * self.drive.speed).max(0.0)
    }

    fn highest(&self, at: f64) -> usize {
        let lift = |i: usize| self.surfaces[i].at(at).s;
        (0..self.surfaces.len())
            .max_by(|&a, &b| lift(a).total_cmp(&lift(b)))
            .unwrap_or(0)
    }

    fn gap(&self, flight: &Flight, at: f64) -> f64 {
        let lifts = self.surfaces.iter().map(|s| s.at(at).s);
        flight.at(at).0 - lifts.fold(f64::NEG_INFINITY, f64::max)
    }

    /// First angle at which the flight meets a profile, and the index of this profile. The second derivative of the gap g has a lower bound
    /// −B. At the angle d ahead, the gap is therefore at least g + g′d − Bd²/2. Each step of the search ends at the first zero of this
    /// bound.
    fn landing(&self, flight: &Flight, left: usize, blind: f64, end: f64) -> Option<(f64, usize)> {
        let fall = flight.steepest_fall();
        let mut now = flight.start;
        for _ in 0..MOST_STEPS {
            let (y, rate) = flight.at(now);
            let mut step = f64::INFINITY;
            for (i, surface) in self.surfaces.iter().enumerate() {
                if i == left && now < blind {
                    step = step.min(blind - now);
                    continue;
                }
                let at = surface.at(now);
                let (gap, opening) = (y - at.s, rate - at.v);
                let floor = TOUCHING * self.lift_scale;
                let just_left = i == left && now == flight.start;
                if gap <= floor && !just_left && opening <= 0.0 {
                    return Some((now, i));
                }
                if gap <= -1e3 * floor && !just_left {
                    return Some((now, i));
                }
                let bound = (fall + surface.steepest).max(f64::MIN_POSITIVE);
                let free = if just_left {
                    2.0 * opening.max(0.0) / bound
                } else {
                    (opening + (opening * opening + 2.0 * bound * gap.max(0.0)).sqrt()) / bound
                };
                if free <= 2.0 * f64::EPSILON * now.abs().max(1.0) {
                    return Some((now, i));
                }
                step = step.min(free);
            }
            now += step;
            if now >= end {
                return None;
            }
        }
        Some((now, left))
    }

    /// Maximum gap of a flight that ends at `to`, by golden-section search near the largest of 15 samples.
    fn height(&self, flight: &Flight, to: f64) -> f64 {
        const PARTS: usize = 16;
        let gap = |t: f64| self.gap(flight, t);
        let at = |k: usize| flight.start + (to - flight.start) * k as f64 / PARTS as f64;
        let top = (1..PARTS)
            .max_by(|&a, &b| gap(at(a)).total_cmp(&gap(at(b))))
            .unwrap_or(1);
        // Golden section between the neighbours of the best sample.
        let (mut a, mut b) = (at(top - 1), at(top + 1));
        let ratio = 0.618_033_988_749_895;
        for _ in 0..40 {
            let (c, d) = (b - ratio * (b - a), a + ratio * (b - a));
            if gap(c) > gap(d) { b = d } else { a = c }
        }
        gap(0.5 * (a + b)).max(0.0)
    }

    /// Angle up to which the mass stays on `surface`, and the reason why it leaves.
    fn leave(&self, surface: usize, now: f64, end: f64) -> (f64, Leave) {
        let own = &self.surfaces[surface];
        let (mut until, mut event) = (end, Leave::End);
        if let Some((from, to)) = own.next_pull(now).filter(|pull| pull.0 < until) {
            (until, event) = (from.max(now), Leave::Pull(to));
        }
        for (i, other) in self.surfaces.iter().enumerate() {
            if i == surface {
                continue;
            }
            if let Some(at) = overtaken(own, other, now, until, TOUCHING * self.lift_scale) {
                (until, event) = (at, Leave::Handover(i));
            }
        }
        (until, event)
    }

    /// Records a phase and the states at the full turns within it. Returns true if the motion is periodic.
    fn stretch(&mut self, phase: Phase, from: f64, to: f64) -> bool {
        if to > from {
            self.run.stretches.push(Stretch { phase, from, to });
        }
        loop {
            let turn = self.marks.len();
            let at = self.run.start + TAU * turn as f64;
            if at > to {
                return false;
            }
            let mark = match phase {
                Phase::Contact { surface } | Phase::Parted { surface } => Mark::On(surface),
                Phase::Flight(flight) => {
                    let (y, rate) = flight.at(at);
                    Mark::Air(y, rate)
                }
            };
            let before = self.marks.iter().position(|m| self.same(m, &mark));
            self.marks.push(mark);
            self.run.turns = turn;
            if let Some(before) = before {
                self.run.settle = Some(before);
                self.run.period = turn - before;
                return true;
            }
        }
    }

    fn same(&self, a: &Mark, b: &Mark) -> bool {
        match (a, b) {
            (Mark::On(i), Mark::On(j)) => i == j,
            (Mark::Air(y, v), Mark::Air(z, w)) => {
                (y - z).abs().max((v - w).abs()) <= SAME * self.lift_scale
            }
            _ => false,
        }
    }
}

/// Reasons why a mass leaves its profile.
enum Leave {
    End,
    /// The contact force would be negative until the given angle.
    Pull(f64),
    /// Contact changes to the profile with this index.
    Handover(usize),
}

/// First angle in (now, until) at which the lift of the profile `other` exceeds the lift of the profile `own`.
fn overtaken(own: &Surface, other: &Surface, now: f64, until: f64, floor: f64) -> Option<f64> {
    let bound = (other.steepest - own.hollowest).max(f64::MIN_POSITIVE);
    let mut at = now;
    for _ in 0..MOST_STEPS {
        let (a, b) = (own.at(at), other.at(at));
        let (gap, opening) = (a.s - b.s, a.v - b.v);
        if gap <= floor && opening < -floor && at > now {
            return Some(at);
        }
        let free = (opening + (opening * opening + 2.0 * bound * gap.max(0.0)).sqrt()) / bound;
        // Intervals in which the profiles coincide, for example on the base circle, are passed in small steps. Bisection within the last
        // step locates the crossing.
        let small = 1e-7;
        if free < small && gap > floor && opening < 0.0 {
            if free <= 4.0 * f64::EPSILON * at.abs().max(1.0) {
                return Some(at);
            }
            at += free;
        } else {
            at += free.max(if gap <= floor { 1e-4 } else { small });
            let (a, b) = (own.at(at), other.at(at));
            if a.s - b.s < -floor {
                return Some(bisect(own, other, at - free.max(1e-4), at));
            }
        }
        if at >= until {
            return None;
        }
    }
    None
}

fn bisect(own: &Surface, other: &Surface, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if own.at(middle).s - other.at(middle).s < 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests;

#[cfg(test)]
mod edge_tests;

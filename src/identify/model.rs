//! Linear model of the force over the phase of the log, with one column for each parameter.

use std::f64::consts::TAU;

use super::cycles::{Cycles, MOST, derivative, value};
use crate::drive::DriveKind;
use crate::dynamics::shaft::force;
use crate::law::Svaj;
use crate::poly::{amplitudes, samples};
use crate::scene::Scene;
use crate::synth::Design;

/// Number of equally spaced cam angles per turn.
pub(super) const ANGLES: usize = 720;
/// Fraction of the maximum speed of the follower below which the follower counts as at rest.
const RESTS: f64 = 1e-6;

/// Motion of the cam in a log, at equally spaced cam angles.
pub(super) struct Clock {
    /// Phase of the log at each angle, rad.
    pub phase: Vec<f64>,
    /// Weight of each angle in a mean over the phase, as a fraction of a cycle.
    pub part: Vec<f64>,
    /// Time since angle 0, scaled so that a cycle is 2π.
    pub time: Vec<f64>,
    /// Speed of the cam at each angle, rad/s.
    pub speed: Vec<f64>,
    /// Angular acceleration of the cam at each angle, rad/s².
    pub rate: Vec<f64>,
}

impl Clock {
    /// Motion of the cam, from the measured speed of the log. Without a measured speed, the speed varies as in the design and is scaled to
    /// the mean speed of the log.
    pub fn of(design: &Design, cycles: &Cycles) -> Clock {
        let mean = cycles.speed;
        let angles = (0..ANGLES).map(angle);
        let speed: Vec<f64> = match (&cycles.lead, &cycles.shaft) {
            (Some(lead), _) => {
                let slope = derivative(&lead.mean);
                angles.map(|x| mean / (1.0 + value(&slope, x))).collect()
            }
            (None, Some(shaft)) if cycles.by_angle => {
                angles.map(|x| value(&shaft.mean, x)).collect()
            }
            _ => {
                let part = mean / design.problem.drive.speed.abs();
                angles.map(|x| part * design.speed_and_time(x).0).collect()
            }
        };
        let slowness: f64 = speed.iter().map(|w| 1.0 / w).sum();
        let duration: Vec<f64> = speed.iter().map(|w| 1.0 / (w * slowness)).collect();
        let (mut sum, step) = (0.0, TAU / ANGLES as f64);
        let time = duration.iter().enumerate().map(|(i, p)| {
            // Each part extends from the middle between two angles to the next middle.
            sum += if i == 0 {
                0.0
            } else {
                0.5 * (p + duration[i - 1])
            };
            TAU * sum
        });
        let time: Vec<f64> = time.collect();
        let around = |i: usize| [speed[(i + ANGLES - 1) % ANGLES], speed[(i + 1) % ANGLES]];
        let rate = |i: usize| speed[i] * (around(i)[1] - around(i)[0]) / (2.0 * step);
        let (phase, part) = match cycles.by_angle {
            true => (
                (0..ANGLES).map(angle).collect(),
                vec![1.0 / ANGLES as f64; ANGLES],
            ),
            false => (time.clone(), duration),
        };
        Clock {
            phase,
            part,
            time,
            rate: (0..ANGLES).map(rate).collect(),
            speed,
        }
    }

    /// First `count` coefficients `[a₀, a₁, b₁ …]` of the harmonic series in the phase, for values given at the cam angles.
    pub fn harmonics(&self, values: &[f64], count: usize) -> Vec<f64> {
        let mut out = vec![0.0; count];
        for ((phase, part), x) in self.phase.iter().zip(&self.part).zip(values) {
            let weight = part * x;
            out[0] += weight;
            for n in 1..=count / 2 {
                let (sin, cos) = libm::sincos(n as f64 * phase);
                out[2 * n - 1] += 2.0 * weight * cos;
                out[2 * n] += 2.0 * weight * sin;
            }
        }
        out
    }

    /// Values of a harmonic series of the phase, at the cam angles.
    pub fn at_angles(&self, harmonics: &[f64]) -> Vec<f64> {
        self.phase.iter().map(|p| value(harmonics, *p)).collect()
    }

    /// The motion with the speed multiplied by `by`.
    pub fn faster(&self, by: f64) -> Clock {
        Clock {
            phase: self.phase.clone(),
            part: self.part.clone(),
            time: self.time.clone(),
            speed: self.speed.iter().map(|w| by * w).collect(),
            rate: self.rate.iter().map(|a| by * by * a).collect(),
        }
    }
}

pub(super) fn angle(i: usize) -> f64 {
    TAU * i as f64 / ANGLES as f64
}

/// A parameter of the machine or of the log. Its effect is its contribution to the force per unit of the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Term {
    /// Key of the parameter in the scene. Parameters without a key have a name such as `log.bias`.
    pub key: &'static str,
    /// Value in the scene, in the units of the drive.
    pub nominal: f64,
    /// Whether the parameter cannot be negative.
    pub is_positive: bool,
    /// Quantity by which the parameter is multiplied in the force.
    pub effect: Effect,
}

/// Quantity by which a parameter is multiplied in the force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Effect {
    /// Constant force. It is multiplied by 1.
    Constant,
    /// Mass on a moving axis. It is multiplied by g + ω²a + αv, where α is the angular acceleration of the cam.
    Weight,
    /// Mass on a fixed axis. It is multiplied by ω²a + αv, where α is the angular acceleration of the cam.
    Mass,
    /// Stiffness of a spring. It is multiplied by the lift s.
    Spring,
    /// Damping coefficient. It is multiplied by the velocity ωv.
    Damping,
    /// Coulomb friction. It is multiplied by the sign of v.
    Coulomb,
    /// Compliance 1/k₁ of a follower train, which deflects by F/k₁: −(k F + c ω F′ + m ω² F″), where F is the force of the drive.
    Compliance,
}

/// Terms of the model for a machine and its log. They are parameters in the scene, the friction of the guide, and the zero offset of the
/// load cell.
pub(super) fn terms(design: &Design, scene: &Scene) -> Vec<Term> {
    let drive = &design.problem.drive;
    let on_arm = design.cam.follower.is_oscillating();
    let term = |key, nominal, effect| Term {
        key,
        nominal,
        is_positive: effect != Effect::Constant,
        effect,
    };
    let mass = if on_arm {
        "drive.inertia"
    } else {
        "drive.mass"
    };
    let friction = [
        term("guide.damping", 0.0, Effect::Damping),
        term("guide.friction", 0.0, Effect::Coulomb),
    ];
    let own = match drive.kind {
        DriveKind::MovingAxis => vec![
            term("log.bias", 0.0, Effect::Constant),
            term(mass, drive.mass, Effect::Weight),
            friction[0],
        ],
        DriveKind::FixedAxis => vec![
            term("drive.preload", drive.rest_force, Effect::Constant),
            term(mass, drive.mass, Effect::Mass),
            term("drive.spring_rate", drive.spring_rate, Effect::Spring),
            match on_arm {
                true => friction[0],
                false => term("drive.damping", drive.damping, Effect::Damping),
            },
        ],
        DriveKind::Hydraulic => vec![
            term("log.bias", 0.0, Effect::Constant),
            term(
                "drive.pressure_per_volume",
                scene.drive.pressure_per_volume,
                Effect::Spring,
            ),
            friction[0],
        ],
    };
    let stiffness = (drive.mass > 0.0).then(|| {
        let train = design.problem.train().ok().flatten();
        let nominal = train.map_or(0.0, |t| 1.0 / t.stiffness);
        term("machine.stiffness", nominal, Effect::Compliance)
    });
    let stands = |t: &Term| t.effect != Effect::Spring || drive.spring_rate > 0.0;
    own.into_iter()
        .chain([friction[1]])
        .chain(stiffness)
        .filter(stands)
        .collect()
}

/// Model of a designed machine for a given motion of the cam (`clock`).
pub(super) struct Machine<'a> {
    pub design: &'a Design,
    pub clock: &'a Clock,
    /// Spring rate per unit of the fitted parameter. It is 1 for a spring. For a hydraulic drive, it is the spring rate divided by the
    /// pressure per volume P/V.
    spring_unit: f64,
    /// Gravitational acceleration g, m/s².
    gravity: f64,
}

impl<'a> Machine<'a> {
    pub fn new(design: &'a Design, scene: &Scene, clock: &'a Clock) -> Machine<'a> {
        let spec = &scene.drive;
        let spring_unit = match design.problem.drive.kind {
            DriveKind::Hydraulic => design.problem.drive.spring_rate / spec.pressure_per_volume,
            DriveKind::MovingAxis | DriveKind::FixedAxis => 1.0,
        };
        Machine {
            design,
            clock,
            spring_unit,
            gravity: spec.gravity,
        }
    }

    fn motion(&self) -> impl Iterator<Item = (Svaj, f64, f64)> {
        let clock = self.clock;
        (0..ANGLES).map(|i| {
            (
                self.design.pressing().svaj(angle(i)),
                clock.speed[i],
                clock.rate[i],
            )
        })
    }

    /// Effect of a parameter on the force, at the cam angles, per unit of the parameter.
    pub fn effect(&self, effect: Effect) -> Vec<f64> {
        match effect {
            Effect::Compliance => return self.compliance(),
            Effect::Coulomb => return self.signs(),
            _ => {}
        }
        let inertia = |at: Svaj, w: f64, rate: f64| w * w * at.a + rate * at.v;
        let value = |(at, w, rate): (Svaj, f64, f64)| match effect {
            Effect::Constant => 1.0,
            Effect::Weight => self.gravity + inertia(at, w, rate),
            Effect::Mass => inertia(at, w, rate),
            Effect::Spring => self.spring_unit * at.s,
            Effect::Damping => w * at.v,
            Effect::Coulomb | Effect::Compliance => 0.0,
        };
        self.motion().map(value).collect()
    }

    /// Sign of v, averaged over the interval around each cam angle. The average resolves a change of sign between two angles.
    fn signs(&self) -> Vec<f64> {
        let law = self.design.pressing();
        let half = 0.5 * TAU / ANGLES as f64;
        let edges: Vec<f64> = (0..ANGLES).map(|i| law.svaj(angle(i) - half).v).collect();
        let rests = RESTS * edges.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let mean = |i: usize| {
            let [a, b] = [edges[i], edges[(i + 1) % ANGLES]];
            (a + b) / (a.abs() + b.abs()).max(rests)
        };
        (0..ANGLES).map(mean).collect()
    }

    /// Derivative of the force with respect to the compliance 1/k₁ of the follower train, N²/m, at the cam angles. The mass follows s −
    /// F/k₁, where k₁ is the stiffness of the train.
    fn compliance(&self) -> Vec<f64> {
        let drive = &self.design.problem.drive;
        let own: Vec<f64> = self
            .motion()
            .map(|(at, w, rate)| force(drive, at, w, rate))
            .collect();
        let terms = amplitudes(&own);
        let terms = &terms[1..=MOST.min(terms.len() - 2)];
        let [first, second] = [1, 2].map(|order| samples(terms, order, ANGLES));
        let w = &self.clock.speed;
        let given = |i: usize| {
            let inertia = drive.mass * w[i] * w[i] * second[i];
            -(drive.spring_rate * own[i] + drive.damping * w[i] * first[i] + inertia)
        };
        (0..ANGLES).map(given).collect()
    }

    /// Force of the design in this motion, at the cam angles: force of the drive plus learned force.
    pub fn nominal_force(&self) -> Vec<f64> {
        let (drive, problem) = (&self.design.problem.drive, &self.design.problem);
        let learned = (0..ANGLES).map(|i| problem.learned_force(angle(i)));
        let own = self.motion().map(|(at, w, rate)| force(drive, at, w, rate));
        own.zip(learned).map(|(f, r)| f + r).collect()
    }
}

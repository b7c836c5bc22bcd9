//! Runs an emitted cam under one model.

use super::backwards::backwards;
use super::contact::Limits;
use super::contact_model::contact_run;
use super::flexible::Train;
use super::hertz::Material;
use super::impact::Restitution;
use super::load_cell::LoadCell;
use super::models::{flexible_run, rigid_run};
use super::outcome::{Model, Outcome};
use super::profile_curve::{Cycle, recover_over};
use super::touch::{held, rubs, touch};
use super::two_cams::{envelope, shifted};
use super::{choose, rigid};
use crate::cam::{Cam, Follower, Measures, ProfilePoint};
use crate::drive::Drive;
use crate::error::{Error, Result};
use crate::law::{Law, Svaj};

/// What is known of the machine beyond its drive; the default is a rigid one without friction, plastic
/// landings and one cam.
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    /// What gives between cam and mass, where it is known.
    pub train: Option<Train>,
    /// Coefficient of friction where cam and follower rub; a roller rolls.
    pub friction: f64,
    /// How landings end.
    pub restitution: Restitution,
    /// Angle by which a second, equal cam follows the first on the shaft, rad.
    pub second_cam: Option<f64>,
    /// The second cam of a conjugate pair, in its own frame: it takes the force where the first one's
    /// would be a pull.
    pub conjugate: Option<Cam>,
    /// Smoothing of the emitted points, m; 0 interpolates them.
    pub smoothing: f64,
    /// The load cell, where there is one.
    pub load_cell: Option<LoadCell>,
    /// Where cam and follower press on each other, where pressure is asked for.
    pub face: Option<Face>,
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
            conjugate: None,
            smoothing: 0.0,
            load_cell: None,
            face: None,
            limits: Limits::default(),
        }
    }
}

/// Cylindrical surfaces that press on each other along a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Face {
    /// Length of the line, m: the thickness of the cam.
    pub length: f64,
    /// Material of the cam.
    pub cam: Material,
    /// Material of the follower.
    pub follower: Material,
}

/// Everything one simulation needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The cam the profile was emitted from: its follower is used, its law only to say how far the emitted
    /// points are from it.
    pub cam: Cam,
    /// The machine; a negative speed turns the cam clockwise.
    pub drive: Drive,
    /// The emitted profile: equal steps of θ over the law's cycle, one turn for most.
    pub profile: Vec<ProfilePoint>,
    /// Wanted force at equal steps of one cycle from θ = 0, N.
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
    /// Motion of the conjugate cam's follower at the angles of the rows.
    pub second: Option<Vec<Svaj>>,
    pub start: f64,
    pub cycle: Cycle,
    pub step: f64,
    pub reach: f64,
    /// What the law is measured in, for words.
    pub measures: Measures,
    /// Whether neither side can lift off the other.
    pub held: bool,
    /// Whether friction makes the torque other than F·v and it is not the flat face's.
    pub rubs: bool,
    /// Target at the angles of the rows.
    pub target: Option<Vec<f64>>,
    pub mismatch: f64,
    pub law_mismatch: f64,
    pub notes: Vec<String>,
}

/// Runs the emitted cam under `model`.
///
/// Fails on profiles that are no curve for their follower (see `profile_curve`), on machine data out of
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
    if let Some(face) = &input.machine.face {
        let sound = |m: &Material| m.young > 0.0 && (0.0..=0.5).contains(&m.poisson);
        if !(face.length > 0.0 && sound(&face.cam) && sound(&face.follower)) {
            return Err(Error::new(
                "a contact line needs a positive length and materials with a positive modulus and a Poisson's ratio in [0, 0.5]",
            ));
        }
    }
    input.machine.restitution.check()?;
    let cycle = Cycle::of(&input.cam.law);
    let smoothing = input.machine.smoothing;
    let emitted = recover_over(&input.cam.follower, &input.profile, cycle, smoothing)?;
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
    let held = held(&input.cam, input.machine.conjugate.as_ref());
    refuse_unknown(input, cycle, held)?;
    let forward = Drive {
        speed: drive.speed.abs(),
        ..*drive
    };
    let one = if reversed {
        backwards(&emitted.law)
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
    let step = cycle.step(n);
    let at = |i: usize| start + step * i as f64;
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
        Some(values) => Some(
            (0..n)
                .map(|i| phase_value(values, sign * at(i) / cycle.length))
                .collect(),
        ),
        None => None,
    };
    let second = match &input.machine.conjugate {
        Some(cam) => Some(conjugate_nodes(cam, n, reversed, &nodes, &mut notes)?),
        None => None,
    };
    let follower = &input.cam.follower;
    if follower.is_oscillating() {
        notes.push(
            "the follower swings: lift and gap are angles, rad, the force is the moment about the pivot, N·m, and the drive's mass, spring and preload count about it; the normal force is in N"
                .to_string(),
        );
    }
    Ok(Prepared {
        drive: forward,
        reversed,
        laws,
        lift,
        nodes,
        second,
        start,
        cycle,
        step,
        reach: rigid::reach(follower),
        measures: follower.measures(),
        held,
        rubs: input.machine.friction > 0.0
            && rubs(follower)
            && !matches!(follower, Follower::FlatTranslating { .. }),
        target,
        mismatch: emitted.mismatch,
        law_mismatch,
        notes,
    })
}

/// What no model here can answer, in words.
fn refuse_unknown(input: &Run, cycle: Cycle, held: bool) -> Result<()> {
    if !cycle.closed && input.drive.speed < 0.0 {
        return Err(Error::new("a slide that ends is run forwards only")
            .help("give the drive a positive speed"));
    }
    if input.machine.second_cam.is_some() && (held || cycle != Cycle::TURN) {
        return Err(Error::new(
            "a second cam that follows on the shaft needs a follower that rests on the first, and a law of one turn",
        )
        .help("leave the second cam out"));
    }
    Ok(())
}

/// Motion of the second follower at the angles of the rows, from its own emitted profile, and a note on
/// how well both cams keep their distance.
fn conjugate_nodes(
    cam: &Cam,
    n: usize,
    reversed: bool,
    first: &[Svaj],
    notes: &mut Vec<String>,
) -> Result<Vec<Svaj>> {
    let cycle = Cycle::of(&cam.law);
    let emitted = recover_over(&cam.follower, &cam.profile(n), cycle, 0.0)?;
    let nodes: Vec<Svaj> = if reversed {
        let law = backwards(&emitted.law);
        let (start, step) = (law.extent().0, cycle.step(n));
        (0..n).map(|i| law.svaj(start + step * i as f64)).collect()
    } else {
        emitted.nodes
    };
    let sums = first.iter().zip(&nodes).map(|(a, b)| a.s + b.s);
    let (low, high) = sums.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
        (l.min(x), h.max(x))
    });
    notes.push(format!(
        "the conjugate pair keeps its distance within {:.1e}; where the force turns negative the second cam takes it",
        high - low
    ));
    Ok(nodes)
}

impl Prepared {
    /// Torque in the sense of turning for force and motion, N·m.
    pub fn torque(&self, input: &Run, force: f64, at: Svaj) -> f64 {
        let friction = input.machine.friction;
        if self.rubs {
            return touch(&input.cam.follower, self.drive.speed, friction, at, force).torque;
        }
        match input.cam.follower {
            Follower::FlatTranslating { .. } => {
                force * at.v + friction * force.abs() * (self.reach + at.s)
            }
            _ => force * at.v,
        }
    }
}

/// Value at the share `part` of a cycle of samples at its equal steps, linear between.
fn phase_value(values: &[f64], part: f64) -> f64 {
    let n = values.len();
    let x = part.rem_euclid(1.0) * n as f64;
    // A sample's own angle, met within rounding, is that sample.
    let nearest = x.round();
    if (x - nearest).abs() < 1e-6 {
        return values[nearest as usize % n];
    }
    let (i, u) = (x.floor() as usize, x.fract());
    values[i % n] * (1.0 - u) + values[(i + 1) % n] * u
}

#[cfg(test)]
#[path = "simulate_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "followers_tests.rs"]
mod followers_tests;

#[cfg(test)]
#[path = "simulate_edge_tests.rs"]
mod edge_tests;

//! Input of the models, prepared from the output profile of a cam.

use crate::cam::{Cam, Follower, Measures};
use crate::drive::Drive;
use crate::dynamics::contact::impact::check_restitution;
use crate::dynamics::contact::two_cams::envelope;
use crate::dynamics::machine_motion::MachineMotion;
use crate::dynamics::reason::RunNote;
use crate::dynamics::recover::{Cycle, recover_cam};
use crate::dynamics::rigid::hertz::Material;
use crate::dynamics::rigid::touch::{FollowerContact, Touch, held, rubs, touch};
use crate::dynamics::run::Run;
use crate::dynamics::shaft::{Motion, Shaft};
use crate::error::{DynamicsError, Result};
use crate::law::{Law, Svaj};

/// Input of the models: one or two profiles of a cam, in the direction of rotation.
#[derive(Clone)]
pub(super) struct Prepared {
    pub drive: Drive,
    pub reversed: bool,
    /// Lift of each cam in the direction of rotation.
    pub laws: Vec<Law>,
    /// Maximum of the lifts of all cams at every angle.
    pub lift: Law,
    /// Angles at which derivatives of the lift may jump.
    pub breaks: Vec<f64>,
    /// Lift and its derivatives at the angles of the rows.
    pub nodes: Vec<Svaj>,
    /// Lift of the conjugate cam.
    pub second: Option<Law>,
    pub start: f64,
    pub cycle: Cycle,
    pub step: f64,
    /// Follower for the maximum contact pressure: for a barrel, with the radius of the groove's floor.
    pub bearing: Follower,
    /// Contact formulas of the follower.
    pub contact: FollowerContact,
    /// Kind of motion, which determines the units of the law in messages.
    pub measures: Measures,
    /// Motion of the shaft if its speed varies.
    pub shaft: Option<Motion>,
    pub shaft_report: Option<Shaft>,
    /// Motion of shaft and floor; `None` for constant speed on a rigid floor without force correction.
    pub machine: Option<MachineMotion>,
    /// Whether the follower is constrained from both sides.
    pub held: bool,
    /// Whether friction acts and its torque differs from the friction torque of a translating flat face.
    pub rubs: bool,
    /// Target force at the angles of the rows, N.
    pub target: Option<Vec<f64>>,
    pub mismatch: f64,
    pub law_mismatch: f64,
    pub notes: Vec<RunNote>,
}

pub(super) fn prepare(input: &Run) -> Result<Prepared> {
    check_machine(input)?;
    let drive = &input.drive;
    let cycle = Cycle::of(&input.cam.law);
    let emitted = recover_cam(&input.cam, &input.profile, cycle)?;
    let law_mismatch = mismatch(input, &emitted.nodes);
    let mut notes = Vec::new();
    let reversed = drive.speed < 0.0;
    let held = held(&input.cam, input.machine.conjugate.as_ref());
    refuse_unknown(input, cycle, held)?;
    let n = input.profile.len();
    let (laws, lift) = lifts(input, emitted.law, reversed);
    let start = laws[0].extent().0;
    let breaks = match reversed {
        true => input.cam.law.reversed().breaks().to_vec(),
        false => input.cam.law.breaks().to_vec(),
    };
    let step = cycle.step(n);
    let at = |i: usize| start + step * i as f64;
    let single = laws.len() == 1 && !reversed;
    let nodes = if single {
        emitted.nodes
    } else {
        (0..n).map(|i| lift.svaj(at(i))).collect()
    };
    let sign = if reversed { -1.0 } else { 1.0 };
    let parts = (0..n).map(|i| sign * at(i) / cycle.length);
    let target = input
        .target
        .as_ref()
        .map(|t| target_at(t, parts))
        .transpose()?;
    let second = match &input.machine.conjugate {
        Some(cam) => Some(conjugate_lift(
            cam,
            reversed,
            (start, step),
            &nodes,
            &mut notes,
        )?),
        None => None,
    };
    let follower = &input.cam.follower;
    if follower.is_oscillating() {
        notes.push(RunNote::Swings);
    }
    Ok(Prepared {
        drive: Drive {
            speed: drive.speed.abs(),
            ..*drive
        },
        reversed,
        laws,
        lift,
        breaks,
        nodes,
        second,
        start,
        cycle,
        step,
        bearing: bearing(input),
        contact: FollowerContact::of(follower),
        measures: follower.measures(),
        shaft: None,
        shaft_report: None,
        machine: None,
        held,
        rubs: has_own_friction(input),
        target,
        mismatch: emitted.mismatch,
        law_mismatch,
        notes,
    })
}

/// Whether friction acts and its torque differs from the friction torque of a translating flat face.
fn has_own_friction(input: &Run) -> bool {
    let follower = &input.cam.follower;
    let is_flat = matches!(follower, Follower::FlatTranslating { .. });
    input.machine.friction > 0.0 && rubs(follower) && !is_flat
}

/// Maximum difference between the lift recovered from the points of the profile and the lift of the law, m.
fn mismatch(input: &Run, nodes: &[Svaj]) -> f64 {
    let pairs = input.profile.iter().zip(nodes);
    let differences = pairs.map(|(p, at)| (input.cam.law.svaj(p.theta).s - at.s).abs());
    differences.fold(0.0, f64::max)
}

/// Follower for the maximum contact pressure: for a barrel, with the radius of the groove's floor.
fn bearing(input: &Run) -> Follower {
    match (input.cam.follower, input.machine.groove_floor) {
        (barrel @ Follower::Barrel { .. }, Some(floor)) => barrel.with_base_radius(floor),
        (follower, _) => follower,
    }
}

/// Lift of each cam in the direction of rotation, and the maximum of these lifts.
fn lifts(input: &Run, law: Law, reversed: bool) -> (Vec<Law>, Law) {
    let first = if reversed { law.reversed() } else { law };
    let Some(angle) = input.machine.second_cam else {
        return (vec![first.clone()], first);
    };
    let second = first.ahead(if reversed { angle } else { -angle });
    let lift = envelope(&first, &second);
    (vec![first, second], lift)
}

/// Rejects invalid machine data: non-finite values, negative mass, stiffness, damping or friction, and invalid contact data.
fn check_machine(input: &Run) -> Result<()> {
    let drive = &input.drive;
    let numbers = [
        drive.rest_force,
        drive.spring_rate,
        drive.damping,
        drive.mass,
        drive.speed,
        input.machine.friction,
    ];
    if numbers.iter().any(|x| !x.is_finite())
        || drive.mass < 0.0
        || drive.damping < 0.0
        || drive.spring_rate < 0.0
    {
        return Err(DynamicsError::Machine.into());
    }
    if input.machine.friction < 0.0 {
        return Err(DynamicsError::Friction {
            friction: input.machine.friction,
        }
        .into());
    }
    if let Some(face) = &input.machine.face {
        let sound = |m: &Material| m.young > 0.0 && (0.0..=0.5).contains(&m.poisson);
        if !(face.length > 0.0 && sound(&face.cam) && sound(&face.follower)) {
            return Err(DynamicsError::ContactLine.into());
        }
    }
    check_restitution(input.machine.restitution)
}

/// Values of the target at fractions of its cycle, N.
fn target_at(target: &[f64], parts: impl Iterator<Item = f64>) -> Result<Vec<f64>> {
    if target.is_empty() || target.iter().any(|f| !f.is_finite()) {
        return Err(DynamicsError::Target.into());
    }
    Ok(parts.map(|part| phase_value(target, part)).collect())
}

/// Rejects combinations of machine data that no model supports.
fn refuse_unknown(input: &Run, cycle: Cycle, held: bool) -> Result<()> {
    if !cycle.closed && input.drive.speed < 0.0 {
        return Err(DynamicsError::SlideBackwards.into());
    }
    if input.machine.second_cam.is_some() && (held || cycle != Cycle::TURN) {
        return Err(DynamicsError::SecondCam.into());
    }
    Ok(())
}

/// Lift of the second cam, recovered from its own output profile. A note on the variation of the distance between both followers is added
/// to `notes`.
fn conjugate_lift(
    cam: &Cam,
    reversed: bool,
    (start, step): (f64, f64),
    first: &[Svaj],
    notes: &mut Vec<RunNote>,
) -> Result<Law> {
    let profile = cam.profile(first.len());
    let emitted = recover_cam(cam, &profile, Cycle::of(&cam.law))?;
    let law = match reversed {
        true => emitted.law.reversed(),
        false => emitted.law,
    };
    let second = |i: usize| law.svaj(start + step * i as f64).s;
    let sums = first.iter().enumerate().map(|(i, a)| a.s + second(i));
    let (low, high) = sums.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
        (l.min(x), h.max(x))
    });
    let deviation = high - low;
    notes.push(RunNote::PairDistance { deviation });
    Ok(law)
}

impl Prepared {
    /// Contact forces at the rows, at constant speed on a rigid floor, N.
    pub fn still_forces(&self) -> Vec<f64> {
        self.nodes.iter().map(|at| self.drive.force(*at)).collect()
    }

    /// Torque in the direction of rotation for a contact force and a motion of the follower, N·m.
    pub fn torque(&self, input: &Run, force: f64, at: Svaj) -> f64 {
        let sign = if self.reversed { -1.0 } else { 1.0 };
        let (friction, v) = (sign * input.machine.friction, sign * at.v);
        sign * self.contact.torque(friction, Svaj { v, ..at }, force)
    }

    /// Computes [`Prepared::torque`] at all rows of a cycle.
    pub fn torques(&self, input: &Run, forces: &[f64]) -> Vec<f64> {
        let sign = if self.reversed { -1.0 } else { 1.0 };
        let turned = |at: &Svaj| Svaj {
            v: sign * at.v,
            ..*at
        };
        let motion: Vec<Svaj> = self.nodes.iter().map(turned).collect();
        let friction = sign * input.machine.friction;
        let mut torques = self.contact.torques(friction, &motion, forces);
        torques.iter_mut().for_each(|torque| *torque *= sign);
        torques
    }

    /// Contact in the direction of rotation. Reversed rotation does not change the contact points. Only the torque and the velocities along
    /// the surfaces change sign.
    pub fn seen(
        &self,
        follower: &Follower,
        speed: f64,
        friction: f64,
        at: Svaj,
        force: f64,
    ) -> Touch {
        if !self.reversed {
            return touch(follower, speed, friction, at, force);
        }
        let forwards = Svaj {
            v: -at.v,
            j: -at.j,
            ..at
        };
        let seen = touch(follower, -speed, -friction, forwards, force);
        Touch {
            torque: -seen.torque,
            sliding: -seen.sliding,
            entraining: -seen.entraining,
            ..seen
        }
    }
}

/// Value at the fraction `part` of a cycle of equally spaced samples, by linear interpolation.
fn phase_value(values: &[f64], part: f64) -> f64 {
    let n = values.len();
    let x = part.rem_euclid(1.0) * n as f64;
    // A position that differs from a sample only by rounding errors counts as this sample.
    let nearest = x.round();
    if (x - nearest).abs() < 1e-6 {
        return values[nearest as usize % n];
    }
    row_value(values, x)
}

/// Value at row `x` of a periodic table, by linear interpolation.
pub(super) fn row_value(values: &[f64], x: f64) -> f64 {
    let n = values.len();
    let (i, u) = (x.floor().rem_euclid(n as f64) as usize, x - x.floor());
    values[i % n] * (1.0 - u) + values[(i + 1) % n] * u
}

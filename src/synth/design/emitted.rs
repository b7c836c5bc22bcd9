//! Profile of a design, as written to the output files, with its machine: the input of a simulation.

use std::f64::consts::TAU;

use super::Design;
use crate::drive::Drive;
use crate::dynamics::{Face, Machine, Run};
use crate::error::Result;
use crate::scene::MachineSpec;
use crate::synth::report::reason::sentences;
use crate::wording::Language;

/// Number of profile points per turn for simulations.
const POINTS: usize = 1440;

impl Design {
    /// Reason why there is no cam to simulate; `None` if there is a cam.
    pub fn no_cam(&self, language: Language) -> Option<String> {
        if let Some(infeasible) = &self.infeasible {
            return Some(infeasible.sentence(language));
        }
        let undercut = self.cam.follower.is_flat() && self.cam.curvature().undercut;
        undercut.then(|| sentences(&self.reasons, language))
    }

    /// Input of a simulation of the cam in a machine with this drive. The simulation uses the profile of the output files, not the law from
    /// which it was computed. The contact pressure is computed for the materials of cam and follower and the thickness of the plate.
    ///
    /// # Errors
    ///
    /// A natural frequency is given, but the mass is zero.
    pub fn emitted(&self, spec: &MachineSpec, drive: Drive) -> Result<Run> {
        let [cam, follower] = self.problem.cam.materials();
        let angles = || (0..POINTS).map(|i| TAU * i as f64 / POINTS as f64);
        let machine = Machine {
            train: spec.train(&drive)?,
            friction: spec.friction,
            restitution: spec.restitution,
            second_cam: spec.second_cam,
            conjugate: self.conjugate.as_ref().map(|pair| pair.second.clone()),
            face: Some(Face {
                length: self.problem.cam.thickness,
                cam,
                follower,
            }),
            groove_floor: self.groove.as_ref().map(|groove| groove.depth().0),
            motor: spec.motor(),
            floor: spec.floor(),
            learned: match spec.learned_force.is_empty() {
                true => Vec::new(),
                false => angles().map(|x| drive.lever * spec.learned_at(x)).collect(),
            },
            ..Machine::default()
        };
        let target = self.target_in_time();
        Ok(Run {
            profile: self.cam.profile(POINTS),
            target: target.map(|t| angles().map(|theta| t.at(theta)).collect()),
            cam: self.cam.clone(),
            drive,
            machine,
        })
    }
}

//! State of the design iteration: the terms that the motion of the machine adds to the design problem of the law.

use super::added::Layout;
use super::through_floor::FloorResponse;
use crate::dynamics::machine_motion::MachineMotion;
use crate::law::Svaj;
use crate::problem::{Extra, Problem};
use crate::synth::attempt::Attempt;

/// Contents of the state: the layout of the terms that are added to force and motion, and, at constant speed, the response of the floor.
pub struct Assumed {
    pub layout: Layout,
    pub floor: Option<FloorResponse>,
}

impl Assumed {
    /// State for a law and its machine motion. `at` returns the motion of the follower at an angle, rad.
    pub fn state(
        &self,
        problem: &Problem,
        attempt: &Attempt,
        motion: &MachineMotion,
        at: &dyn Fn(f64) -> Svaj,
    ) -> Vec<f64> {
        let floor = self.floor.as_ref();
        let mut out = floor.map_or_else(Vec::new, |floor| floor.state(problem, attempt, motion));
        out.extend(self.layout.state(problem, motion, at));
        out
    }

    /// The problem with the terms of a given state: positions in the period, added force and response of the floor.
    pub fn problem(&self, problem: &Problem, state: &[f64]) -> Problem {
        let floor = self.floor.as_ref();
        let (through, own) = state.split_at(floor.map_or(0, |_| FloorResponse::VALUES));
        let (phases, extra) = self.layout.extra(problem, own);
        let through_floor = floor.map(|floor| floor.through(through));
        let extra = Extra {
            through_floor,
            ..extra
        };
        problem.on_shaft(&phases, extra)
    }
}

//! Floor of a machine: the modes of the structure and the walkers on it.

use super::machine::MachineSpec;
use crate::dynamics::{Floor, FloorMode};
use crate::error::SceneError;

impl MachineSpec {
    /// The structure with its walkers; `None` for a rigid floor.
    pub fn floor(&self) -> Option<Floor> {
        let single = self.floor.mode("machine.floor.damping");
        let listed = self.modes.iter();
        let listed = listed.filter_map(|m| m.mode("machine.floor.mode.N.damping"));
        let modes: Vec<FloorMode> = single.into_iter().chain(listed).collect();
        if modes.is_empty() {
            return None;
        }
        let (angles, parts) = (self.walkers.angles()?, self.walkers.parts()?);
        Some(Floor {
            modes,
            walkers: angles.into_iter().zip(parts).collect(),
        })
    }

    /// Whether the scene has a structure that moves.
    pub fn has_floor(&self) -> bool {
        self.floor.is_given() || !self.modes.is_empty()
    }

    /// Checks that each mode of the structure is complete, and that the follower is rigid.
    ///
    /// # Errors
    ///
    /// The data of the floor are inconsistent. The error contains the key that must be changed.
    pub(in crate::scene) fn check_floor(&self) -> Result<(), (&'static str, SceneError)> {
        let floor = &self.floor;
        if !self.has_floor() {
            return Ok(());
        }
        let lacks = [
            ("machine.floor.mass", floor.mass, "5000 kg"),
            ("machine.floor.frequency", floor.frequency, "2 Hz"),
            ("machine.floor.damping", floor.damping, "0.005"),
        ];
        if floor.is_given() {
            if let Some((key, _, example)) = lacks.into_iter().find(|(_, given, _)| given.is_none())
            {
                let example = example.to_string();
                return Err((key, SceneError::FloorLacks { example }));
            }
            if !self.modes.is_empty() {
                return Err(("machine.floor.mode", SceneError::FloorTwice));
            }
        }
        let count = self.walkers.count;
        if self.walkers.angles().is_none() {
            return Err(("machine.walkers.phases", SceneError::WalkerPhases { count }));
        }
        if self.walkers.parts().is_none() {
            return Err((
                "machine.walkers.weights",
                SceneError::WalkerWeights { count },
            ));
        }
        let rivals = [
            (
                "machine.natural_frequency",
                self.natural_frequency.is_some(),
            ),
            ("machine.stiffness", self.stiffness.is_some()),
        ];
        match rivals.into_iter().find(|(_, given)| *given) {
            Some((key, _)) => Err((key, SceneError::FloorAlone)),
            None => Ok(()),
        }
    }
}

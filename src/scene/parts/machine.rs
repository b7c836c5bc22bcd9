//! `[machine]`: what is known of the machine beyond its drive.

use crate::drive::Drive;
use crate::dynamics::Train;
use crate::error::{Placed, Result};

/// Default damping ratio of a follower train: steel parts with oiled joints.
const DAMPING_RATIO: f64 = 0.05;

/// What is known of the machine beyond its drive: `gaitcam simulate` runs with it.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::scene::MachineSpec;
///
/// // k = m (2πf)²
/// let machine = MachineSpec { natural_frequency: Some(50.0), ..MachineSpec::default() };
/// let train = machine.train(&Drive::moving_axis(2.0, 9.81, 10.0))?.unwrap();
/// let omega = std::f64::consts::TAU * 50.0;
/// assert!((train.stiffness / (2.0 * omega * omega) - 1.0).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MachineSpec {
    /// First natural frequency of the follower train, Hz.
    pub natural_frequency: Option<f64>,
    /// Stiffness of the follower train, N/m (an arm: N·m/rad), in place of the frequency.
    pub stiffness: Option<f64>,
    /// Its damping ratio.
    pub damping_ratio: f64,
    /// Coefficient of sliding friction between cam and follower.
    pub friction: f64,
    /// Coefficient of restitution of a landing, 0 … 1.
    pub restitution: f64,
    /// Angle by which a second, equal cam follows on the same shaft, rad.
    pub second_cam: Option<f64>,
}

impl MachineSpec {
    /// Compliance between cam and mass; `None` for a rigid follower.
    ///
    /// # Errors
    /// A natural frequency without a mass.
    pub fn train(&self, drive: &Drive) -> Result<Option<Train>> {
        if let Some(hz) = self.natural_frequency {
            return Train::from_frequency(drive, hz, self.damping_ratio)
                .map(Some)
                .map_err(|e| e.at_key("machine.natural_frequency"));
        }
        Ok(self.stiffness.map(|stiffness| Train {
            stiffness,
            damping: 2.0 * self.damping_ratio * (stiffness * drive.mass).sqrt(),
        }))
    }
}

impl Default for MachineSpec {
    fn default() -> MachineSpec {
        MachineSpec {
            natural_frequency: None,
            stiffness: None,
            damping_ratio: DAMPING_RATIO,
            friction: 0.0,
            restitution: 0.0,
            second_cam: None,
        }
    }
}

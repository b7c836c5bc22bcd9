//! Elastic train between the cam and the moved mass.

use crate::drive::{Drive, DriveKind};
use crate::error::{DynamicsError, Result};

/// Parallel spring and damper between the cam and the moved mass.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::flexible::Train;
///
/// let drive = Drive::moving_axis(2.0, 9.81, 10.0);
/// let train = Train::from_frequency(&drive, 50.0, 0.05)?;
/// let natural = train.natural_frequency(&drive).unwrap();
/// assert!((natural / std::f64::consts::TAU - 50.0).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Train {
    /// Stiffness between cam and mass, N/m; for a hydraulic drive, of the fluid column.
    pub stiffness: f64,
    /// Damping between cam and mass, N·s/m.
    pub damping: f64,
}

impl Train {
    /// Creates the train with a given damping ratio and natural frequency on the cam, Hz (without the return spring), for the mass of the drive.
    ///
    /// # Errors
    ///
    /// Frequency or mass is not positive, or the ratio is negative.
    pub fn from_frequency(drive: &Drive, hertz: f64, ratio: f64) -> Result<Self> {
        if !(hertz > 0.0 && hertz.is_finite() && ratio >= 0.0 && ratio.is_finite()) {
            return Err(DynamicsError::Frequency {
                frequency: hertz,
                ratio,
            }
            .into());
        }
        if drive.mass <= 0.0 {
            let fluid = drive.kind == DriveKind::Hydraulic;
            return Err(DynamicsError::FrequencyWithoutMass { fluid }.into());
        }
        let w = std::f64::consts::TAU * hertz;
        Ok(Train {
            stiffness: drive.mass * w * w,
            damping: 2.0 * ratio * drive.mass * w,
        })
    }

    /// Undamped natural frequency with the return spring, rad/s; `None` without mass.
    pub fn natural_frequency(&self, drive: &Drive) -> Option<f64> {
        (drive.mass > 0.0).then(|| ((self.stiffness + drive.spring_rate) / drive.mass).sqrt())
    }

    /// Checks that the stiffness is positive and the damping is not negative.
    ///
    /// # Errors
    ///
    /// The stiffness is not positive, or the damping is negative.
    pub fn check(&self) -> Result<()> {
        let sound = |x: f64| x.is_finite() && x >= 0.0;
        if sound(self.stiffness) && sound(self.damping) && self.stiffness > 0.0 {
            return Ok(());
        }
        Err(DynamicsError::Train.into())
    }
}

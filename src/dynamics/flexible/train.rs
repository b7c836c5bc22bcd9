//! The elastic train between the cam and the moved mass.

use crate::drive::{Drive, DriveKind};
use crate::error::{DynamicsError, Result};

/// Spring and damper between the cam and the moved mass, in series with it.
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
    /// Stiffness between cam and mass, N/m; for hydraulics, of the fluid column.
    pub stiffness: f64,
    /// Damping between cam and mass, N·s/m.
    pub damping: f64,
}

impl Train {
    /// A train with the given natural frequency on the cam (Hz, return spring not counted) and damping
    /// ratio, for the drive's mass.
    ///
    /// # Errors
    /// Frequency or mass not positive, or a negative ratio.
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

    /// Undamped natural frequency, rad/s, return spring included; `None` without mass.
    pub fn natural_frequency(&self, drive: &Drive) -> Option<f64> {
        (drive.mass > 0.0).then(|| ((self.stiffness + drive.spring_rate) / drive.mass).sqrt())
    }

    /// # Errors
    ///
    /// Stiffness not positive, or negative damping.
    pub fn check(&self) -> Result<()> {
        let sound = |x: f64| x.is_finite() && x >= 0.0;
        if sound(self.stiffness) && sound(self.damping) && self.stiffness > 0.0 {
            return Ok(());
        }
        Err(DynamicsError::Train.into())
    }
}

//! What gives between the cam and the moved mass.

use crate::drive::Drive;
use crate::error::{Error, Result};

/// What gives between the cam and the moved mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Train {
    /// One mass on the train's spring and damper.
    OneMass {
        /// Stiffness between cam and mass, N/m; for hydraulics, of the fluid column.
        stiffness: f64,
        /// Damping between cam and mass, N·s/m.
        damping: f64,
    },
    /// A mass near the cam and the rest behind a second spring.
    TwoMass {
        /// Mass next to the cam, kg; the drive's mass less this one sits at the far end.
        near_mass: f64,
        /// Stiffness between cam and near mass, N/m.
        stiffness: f64,
        /// Damping between cam and near mass, N·s/m.
        damping: f64,
        /// Stiffness between the masses, N/m.
        far_stiffness: f64,
        /// Damping between the masses, N·s/m.
        far_damping: f64,
    },
}

impl Train {
    /// A train with the given natural frequency on the cam (Hz, return spring not counted) and damping
    /// ratio, for the drive's mass. Fails when frequency or mass is not positive or the ratio negative.
    pub fn from_frequency(drive: &Drive, hertz: f64, ratio: f64) -> Result<Self> {
        if !(hertz > 0.0 && hertz.is_finite() && ratio >= 0.0 && ratio.is_finite()) {
            return Err(Error::new(format!(
                "a follower cannot ring at {hertz} Hz with damping ratio {ratio}"
            ))
            .help("give a positive frequency and a ratio of 0 or more"));
        }
        if drive.mass <= 0.0 {
            return Err(Error::new("a natural frequency needs a moved mass")
                .help("give the mass, or the stiffness of the fluid column"));
        }
        let w = std::f64::consts::TAU * hertz;
        Ok(Train::OneMass {
            stiffness: drive.mass * w * w,
            damping: 2.0 * ratio * drive.mass * w,
        })
    }

    /// Undamped natural frequencies, rad/s, lowest first, return spring included; none without mass.
    pub fn natural_frequencies(&self, drive: &Drive) -> Vec<f64> {
        match *self {
            Train::OneMass { stiffness, .. } if drive.mass > 0.0 => {
                vec![((stiffness + drive.spring_rate) / drive.mass).sqrt()]
            }
            Train::OneMass { .. } => Vec::new(),
            Train::TwoMass {
                near_mass,
                stiffness,
                far_stiffness,
                ..
            } => {
                let far = drive.mass - near_mass;
                let p = (stiffness + far_stiffness) / near_mass;
                let q = (far_stiffness + drive.spring_rate) / far;
                let cross = far_stiffness * far_stiffness / (near_mass * far);
                let mean = 0.5 * (p + q);
                let high = mean + (0.25 * (p - q).powi(2) + cross).sqrt();
                let low = (p * q - cross) / high;
                vec![low.max(0.0).sqrt(), high.sqrt()]
            }
        }
    }

    /// Fails on stiffness, damping or masses that cannot be.
    pub fn check(&self, drive: &Drive) -> Result<()> {
        let (values, near): (Vec<f64>, f64) = match *self {
            Train::OneMass { stiffness, damping } => (vec![stiffness, damping], 0.0),
            Train::TwoMass {
                near_mass,
                stiffness,
                damping,
                far_stiffness,
                far_damping,
            } => (
                vec![stiffness, damping, far_stiffness, far_damping, near_mass],
                near_mass,
            ),
        };
        let two = matches!(self, Train::TwoMass { .. });
        if values.iter().any(|x| !(x.is_finite() && *x >= 0.0)) || values[0] <= 0.0 {
            return Err(Error::new(
                "a follower's stiffness must be positive and its damping not negative",
            ));
        }
        if two && !(near > 0.0 && near < drive.mass && values[2] > 0.0) {
            return Err(Error::new(format!(
                "a near mass of {near} kg does not split {} kg in two",
                drive.mass
            ))
            .help("give a part of the moved mass and a positive stiffness behind it"));
        }
        Ok(())
    }
}

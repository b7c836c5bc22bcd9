//! A shaft that winds up: the cam runs ahead of or behind its motor, and the follower with it.

use super::linear::Linear;
use super::rigid::torque_curve;
use crate::drive::Drive;
use crate::error::{Error, Result};
use crate::law::Law;
use nalgebra::{Matrix4, Vector4};

/// Shaft between motor and cam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    /// Torsional stiffness, N·m/rad.
    pub stiffness: f64,
    /// Torsional damping, N·m·s/rad.
    pub damping: f64,
    /// Inertia of the cam, kg·m².
    pub inertia: f64,
}

/// What the wind-up does over a turn; largest absolute values at the breaks of the torque's pieces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindUp {
    /// Wind-up, rad.
    pub angle: f64,
    /// Error of lift, m.
    pub lift: f64,
    /// Error of force, N.
    pub force: f64,
}

/// Steady wind-up φ of J φ̈ + c φ̇ + k φ = −T(θ), exact for the rigid torque.
///
/// The torque is that of even turning, so the answer is good to the square of φ. Lift and force errors
/// are those of s(θ + φ) with the speed ω + φ̇. Fails on a shaft without stiffness and at resonance.
pub fn wind_up(law: &Law, drive: &Drive, shaft: &Shaft) -> Result<WindUp> {
    if !(shaft.stiffness > 0.0 && shaft.damping >= 0.0 && shaft.inertia > 0.0 && drive.speed > 0.0)
    {
        return Err(Error::new(
            "a shaft needs a positive stiffness, inertia and speed",
        ));
    }
    let torque = torque_curve(law, drive, 0.0, 0.0)
        .ok_or_else(|| Error::new("the torque of this machine has no closed form"))?;
    let inertia = shaft.inertia * drive.speed * drive.speed;
    let w = (shaft.stiffness / inertia).sqrt();
    let mut rates = -Matrix4::identity();
    (rates[(0, 0)], rates[(0, 1)]) = (0.0, w);
    (rates[(1, 0)], rates[(1, 1)]) = (-w, -shaft.damping * drive.speed / inertia);
    let linear = Linear {
        rates,
        inputs: vec![Vector4::new(0.0, -1.0 / (inertia * w), 0.0, 0.0)],
    };
    let states = linear
        .periodic(&[&torque], |_| Vector4::zeros())
        .ok_or_else(|| {
            Error::new(format!(
                "resonance: the undamped shaft rings {w:.6} times per turn"
            ))
            .help("give the shaft a damping above 0")
        })?;
    let mut worst = WindUp {
        angle: 0.0,
        lift: 0.0,
        force: 0.0,
    };
    for (theta, z) in torque.breaks().iter().zip(&states) {
        let (phi, rate) = (z[0], w * z[1]);
        let acceleration =
            rates[(1, 0)] * w * z[0] + rates[(1, 1)] * w * z[1] - torque.eval(*theta) / inertia;
        let (even, wound) = (law.svaj(*theta), law.svaj(theta + phi));
        // d/dt = ω d/dθ: ẋ = ω v(1 + φ′), ẍ = ω²(a(1 + φ′)² + v φ″).
        let turned = crate::law::Svaj {
            v: wound.v * (1.0 + rate),
            a: wound.a * (1.0 + rate).powi(2) + wound.v * acceleration,
            ..wound
        };
        worst.angle = worst.angle.max(phi.abs());
        worst.lift = worst.lift.max((wound.s - even.s).abs());
        worst.force = worst
            .force
            .max((drive.force(turned) - drive.force(even)).abs());
    }
    Ok(worst)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::Cam;
    use crate::dynamics::{profile_curve::recover, thesis};

    #[test]
    fn a_stiff_shaft_winds_up_by_torque_over_stiffness() {
        let cam: Cam = thesis::eccentric();
        let law = recover(&cam.follower, &cam.profile(720), 0.0).unwrap().law;
        let drive = thesis::real(thesis::SPEED);
        let shaft = Shaft {
            stiffness: 1000.0,
            damping: 0.01,
            inertia: 1e-6,
        };
        let torque = torque_curve(&law, &drive, 0.0, 0.0).unwrap();
        let (low, high) = torque.extremes();
        let got = wind_up(&law, &drive, &shaft).unwrap();
        let quasi = high.value.max(-low.value) / 1000.0;
        assert!(
            (got.angle / quasi - 1.0).abs() < 1e-3,
            "{} {quasi}",
            got.angle
        );
        assert!(got.lift < 0.01 * got.angle * 1.0001 && got.force > 0.0);
        assert!(
            wind_up(
                &law,
                &drive,
                &Shaft {
                    stiffness: 0.0,
                    ..shaft
                }
            )
            .is_err()
        );
    }
}

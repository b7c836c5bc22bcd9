//! Relation of lift and force: F(θ) = F₀ + k·s + c·ω·v + m·ω²·a (theory §1), with constant ω.

mod motor;

pub use motor::{Motor, TorqueLine};

use crate::law::{Law, Svaj};
use crate::poly::{Extreme, PiecewisePoly};
use serde::Serialize;

/// Gain, relative to its largest term, below which a frequency counts as a resonance. No finite lift produces a given force at a resonance.
pub(crate) const RESONANCE: f64 = 1e-9;

/// Kind of machine that converts the motion of the follower into a force.
///
/// ```
/// use gaitcam::drive::{Drive, DriveKind};
///
/// // F = (P/V)·A²·s: a hydraulic drive is a spring of (P/V)·(πr²)².
/// let drive = Drive::hydraulic(2e9, 0.01, 5.0);
/// assert_eq!(drive.kind, DriveKind::Hydraulic);
/// let area = std::f64::consts::PI * 1e-4;
/// assert!((drive.spring_rate / (2e9 * area * area) - 1.0).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[derive(strum::IntoStaticStr, strum::VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum DriveKind {
    /// Moving axis: the shaft block with the cam moves, and the cam rolls on a plate. The force is F = M(g + ω²a) (Campillo de Blas 2017,
    /// eq. 22).
    MovingAxis,
    /// Fixed axis: the cam turns in a fixed bearing and lifts a follower with spring, preload, damping and mass.
    FixedAxis,
    /// Hydraulic drive: the cam displaces a piston of area A. The force is F = (P/V)·A²·s. P/V is the pressure per displaced volume, Pa/m³
    /// (Vargas and León 2024, eq. 3).
    Hydraulic,
}

impl DriveKind {
    /// All kinds of drive.
    pub const ALL: &'static [DriveKind] = <DriveKind as strum::VariantArray>::VARIANTS;

    /// Name of the drive in a scene file.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// The linear relation between law and force, with the cam's speed.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::law::Svaj;
///
/// // F = M (g + ω² a): at a = g/ω² the mass weighs twice as much.
/// let drive = Drive::moving_axis(70.0, 9.81, 2.0);
/// let at = Svaj { s: 0.0, v: 0.0, a: 9.81 / 4.0, j: 0.0 };
/// assert!((drive.force(at) - 2.0 * 70.0 * 9.81).abs() < 1e-9);
///
/// // F = F₀ + k s + m ω² a
/// let drive = Drive { rest_force: 30.0, ..Drive::fixed_axis(0.5, 2000.0, 10.0) };
/// assert_eq!(drive.force(Svaj { s: 0.01, v: 0.0, a: 0.0, j: 0.0 }), 50.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Drive {
    /// Kind of machine that converts the motion into a force.
    pub kind: DriveKind,
    /// Force at rest on the base circle, N: M·g for the moving axis, otherwise the preload.
    pub rest_force: f64,
    /// Stiffness: force per lift, N/m.
    pub spring_rate: f64,
    /// Damping: force per velocity of the follower, N·s/m.
    pub damping: f64,
    /// Mass that the lift moves, kg. For an arm, it is the moment of inertia, kg·m².
    pub mass: f64,
    /// Cam speed ω, rad/s; positive.
    pub speed: f64,
    /// Lever: distance, m, from the pivot of an arm to the point at which forces act. It is 1 for a translating follower. For an arm, every
    /// force of the drive is stored as a moment about the pivot, N·m, which is force times lever.
    pub lever: f64,
}

impl Drive {
    /// Moving axis of mass `mass` (kg) under gravity `g` (m/s²), at `speed` rad/s.
    pub fn moving_axis(mass: f64, g: f64, speed: f64) -> Self {
        Drive {
            kind: DriveKind::MovingAxis,
            rest_force: mass * g,
            ..Drive::fixed_axis(mass, 0.0, speed)
        }
    }

    /// Fixed axis that lifts `mass` (kg) against a spring of `spring_rate` (N/m), at `speed` rad/s.
    pub fn fixed_axis(mass: f64, spring_rate: f64, speed: f64) -> Self {
        Drive {
            kind: DriveKind::FixedAxis,
            rest_force: 0.0,
            spring_rate,
            damping: 0.0,
            mass,
            speed,
            lever: 1.0,
        }
    }

    /// Hydraulic drive with `pressure_per_volume` (Pa/m³) and piston radius (m), at `speed` rad/s.
    pub fn hydraulic(pressure_per_volume: f64, piston_radius: f64, speed: f64) -> Self {
        let area = std::f64::consts::PI * piston_radius * piston_radius;
        Drive {
            kind: DriveKind::Hydraulic,
            ..Drive::fixed_axis(0.0, pressure_per_volume * area * area, speed)
        }
    }

    /// Converts the drive to an arm. Preload, spring and damper act at the distance `lever` (m) from the pivot and are stored as moments
    /// about the pivot. The mass is unchanged, so it must already be the moment of inertia, kg·m².
    ///
    /// ```
    /// use gaitcam::drive::Drive;
    ///
    /// // A piston at 0.1 m moves 0.1 m per rad: stiffness about the pivot k·L², N·m/rad.
    /// let piston = Drive::hydraulic(2e9, 0.01, 5.0);
    /// let arm = piston.at_lever(0.1);
    /// assert!((arm.spring_rate / (0.01 * piston.spring_rate) - 1.0).abs() < 1e-12);
    /// assert_eq!(arm.newtons(70.0), 700.0);
    /// ```
    #[must_use]
    pub fn at_lever(self, lever: f64) -> Drive {
        let square = lever * lever;
        Drive {
            rest_force: lever * self.rest_force,
            spring_rate: square * self.spring_rate,
            damping: square * self.damping,
            lever,
            ..self
        }
    }

    /// Converts a force of the drive to N: for an arm, the moment divided by the lever.
    pub fn newtons(&self, force: f64) -> f64 {
        force / self.lever
    }

    /// Whether the force is zero for every law: no mass, spring, damping or preload.
    pub fn is_idle(&self) -> bool {
        [self.mass, self.spring_rate, self.damping, self.rest_force] == [0.0; 4]
    }

    /// Weights of s, v, a, j in the force: `[k, cω, mω², 0]`. Their units are N per m, N per m/rad and N per m/rad².
    #[inline]
    pub fn weights(&self) -> [f64; 4] {
        [
            self.spring_rate,
            self.damping * self.speed,
            self.mass * self.speed * self.speed,
            0.0,
        ]
    }

    /// Force at one point of a law, N (for an arm: moment, N·m).
    #[inline]
    pub fn force(&self, at: Svaj) -> f64 {
        let w = self.weights();
        self.rest_force + w[0] * at.s + w[1] * at.v + w[2] * at.a
    }

    /// Force over the whole law, N, as a piecewise polynomial with exact extremes.
    pub fn force_curve(&self, law: &Law) -> PiecewisePoly {
        law.combination(self.weights(), self.rest_force)
    }

    /// Minimum and maximum force over the whole law, N.
    pub fn force_extremes(&self, law: &Law) -> (Extreme, Extreme) {
        law.extremes_of(self.weights(), self.rest_force)
    }

    /// Complex gain of harmonic n: force amplitude per lift amplitude, (real, imaginary) =
    /// (k − m n²ω², c n ω) (theory §1).
    pub fn gain(&self, harmonic: usize) -> (f64, f64) {
        let nw = harmonic as f64 * self.speed;
        (self.spring_rate - self.mass * nw * nw, self.damping * nw)
    }

    /// Harmonic n of the lift, m, that produces the harmonic (a, b) of the force, N. Harmonics are given as (cosine, sine). `None` at
    /// resonance.
    pub(crate) fn lift_of(&self, harmonic: usize, (a, b): (f64, f64)) -> Option<(f64, f64)> {
        let (re, im) = self.gain(harmonic);
        let square = re * re + im * im;
        let nw = harmonic as f64 * self.speed;
        let largest = (self.spring_rate.abs())
            .max(self.mass * nw * nw)
            .max(im.abs());
        // F = a cos + b sin = Re((a − ib) e^{ihθ}). The amplitude is divided by the gain re + i·im.
        let lift = ((a * re - b * im) / square, (b * re + a * im) / square);
        (square.sqrt() > RESONANCE * largest).then_some(lift)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{G, LBF};

    #[test]
    fn thesis_eccentric_presses_between_8_4588_and_11_1612_newtons() {
        // theory §3: e = 0.01 m, M = 1 kg, 111 rpm ≈ 11.624 rad/s.
        let drive = Drive::moving_axis(1.0, G, 11.624);
        let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
        let (low, high) = drive.force_extremes(&law);
        assert!((low.value - 8.4588).abs() < 5e-5 && (high.value - 11.1612).abs() < 5e-5);
    }

    #[test]
    fn paper_piston_gives_93_6841_pounds_per_inch() {
        let psi = LBF / 0.0254_f64.powi(2);
        let drive = Drive::hydraulic(30.0 * psi / 0.0254_f64.powi(3), 0.75 * 0.0254, 12.566);
        assert!((drive.spring_rate * 0.0254 / LBF - 93.6841).abs() < 5e-5);
    }
}

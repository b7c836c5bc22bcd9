//! Moving floor: modes of a structure in steady vibration under the periodic force of the feet.
//!
//! Each mode has the mass m, the natural frequency ω, the damping ratio ζ and the ordinate φ at the feet. Under the downward force F, its
//! modal coordinate q obeys m (q″ + 2ζω q′ + ω² q) = −φ F. It moves the floor upwards by z = φ q. For F = Re Fₙ e^{inΩt} with the cam speed
//! Ω, the acceleration is z″ₙ = Hₙ Fₙ. The accelerance is Hₙ = Σ φ² (nΩ)² / (m (ω² − (nΩ)² + 2iζω nΩ)), summed over the modes (theory §10).

use std::f64::consts::TAU;

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use crate::error::{DynamicsError, Placed, Result};
use crate::poly::{amplitudes, samples};
use crate::units::{Dimension, Quantity};

/// Fraction of ω² below which the dynamic stiffness of a mode with the natural frequency ω counts as zero.
const RESONANT: f64 = 1e-9;
/// Fraction of the maximum harmonic below which a harmonic counts as a rounding error.
const ROUNDING: f64 = 1e-9;
/// Upper bounds of the peak acceleration, m/s², of the comfort classes of SETRA (2006) and HiVoSS (2008).
const CLASSES: [f64; 3] = [0.5, 1.0, 2.5];

/// Minimum number of points per turn in the search for the peak acceleration.
const POINTS: usize = 4096;

/// Cosine and sine amplitudes of one harmonic.
pub type Term = (f64, f64);

/// Vibration mode of a structure.
///
/// ```
/// use gaitcam::dynamics::FloorMode;
///
/// // A footbridge with a modal mass of 40 t. The walker is at a quarter of the span, where φ = sin(π/4).
/// let ordinate = std::f64::consts::FRAC_1_SQRT_2;
/// let mode = FloorMode { mass: 4e4, frequency: 1.9, damping: 0.005, ordinate, key: "machine.floor.damping" };
/// assert!((mode.mass / mode.ordinate.powi(2) - 8e4).abs() < 1e-6); // effective mass at the walker, kg
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloorMode {
    /// Modal mass of the mode, kg.
    pub mass: f64,
    /// Natural frequency of the mode, Hz.
    pub frequency: f64,
    /// Damping ratio of the mode, relative to critical damping.
    pub damping: f64,
    /// Ordinate of the mode shape at the feet.
    pub ordinate: f64,
    /// Key of the damping ratio in a scene, with `N` for the number of the mode.
    pub key: &'static str,
}

/// A structure and the walkers on it.
///
/// ```
/// use gaitcam::dynamics::{Floor, FloorMode};
///
/// // At resonance, a force of amplitude F gives the acceleration F/(2ζm) of a single mode.
/// let mode = FloorMode { mass: 1e4, frequency: 2.0, damping: 0.01, ordinate: 1.0, key: "machine.floor.damping" };
/// let floor = Floor { modes: vec![mode], walkers: vec![(0.0, 1.0)] };
/// let answer = floor.acceleration(std::f64::consts::TAU * 2.0, &[(280.0, 0.0)])?;
/// assert!((answer[0].0.hypot(answer[0].1) - 280.0 / (2.0 * 0.01 * 1e4)).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Floor {
    /// Vibration modes of the structure.
    pub modes: Vec<FloorMode>,
    /// Phase, rad, and weight relative to the shaker, for every walker. The first walker is the shaker.
    pub walkers: Vec<(f64, f64)>,
}

/// Comfort classes of a structure by its peak acceleration, after SETRA (2006) and HiVoSS (2008).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comfort {
    /// Peak acceleration of at most 0.5 m/s².
    Maximum,
    /// Peak acceleration of at most 1 m/s².
    Mean,
    /// Peak acceleration of at most 2.5 m/s².
    Minimum,
    /// Peak acceleration of more than 2.5 m/s².
    Unacceptable,
}

impl Comfort {
    const ALL: [Comfort; 4] = [
        Comfort::Maximum,
        Comfort::Mean,
        Comfort::Minimum,
        Comfort::Unacceptable,
    ];

    /// Name of the comfort class in HiVoSS.
    pub fn hivoss(self) -> &'static str {
        match self {
            Comfort::Maximum => "CL1",
            Comfort::Mean => "CL2",
            Comfort::Minimum => "CL3",
            Comfort::Unacceptable => "CL4",
        }
    }

    /// Name of the comfort class in SETRA.
    pub fn setra(self) -> &'static str {
        match self {
            Comfort::Maximum => "maximum",
            Comfort::Mean => "mean",
            Comfort::Minimum => "minimum",
            Comfort::Unacceptable => "unacceptable",
        }
    }
}

impl Serialize for Comfort {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let mut both = serializer.serialize_struct("Comfort", 2)?;
        both.serialize_field("comfort", self.hivoss())?;
        both.serialize_field("comfort_setra", self.setra())?;
        both.end()
    }
}

/// Steady vibration of the structure at the position of the feet.
///
/// ```
/// use gaitcam::dynamics::FloorMotion;
///
/// let motion = FloorMotion::of(&[(0.6, 0.0)]); // cosine and sine of harmonic 1, m/s²
/// assert_eq!((motion.comfort.hivoss(), motion.comfort.setra()), ("CL2", "mean"));
/// assert!((motion.acceleration_rms_m_per_s2 - 0.6 / 2_f64.sqrt()).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FloorMotion {
    /// Peak acceleration of the floor, m/s².
    pub acceleration_peak_m_per_s2: f64,
    /// Root mean square of the acceleration, m/s².
    pub acceleration_rms_m_per_s2: f64,
    /// Comfort class for the walkers, from the peak acceleration.
    #[serde(flatten)]
    pub comfort: Comfort,
}

impl FloorMotion {
    /// Upper bounds of the peak acceleration, m/s², of all comfort classes except the last.
    pub const CLASSES: [f64; 3] = CLASSES;

    /// Motion of the floor from the harmonics of its acceleration, m/s².
    pub fn of(terms: &[Term]) -> FloorMotion {
        let square: f64 = terms.iter().map(|(a, b)| a * a + b * b).sum();
        let curve = samples(terms, 0, (8 * (terms.len() + 1)).max(POINTS));
        let peak = curve.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let class = CLASSES.iter().filter(|bound| peak > **bound).count();
        FloorMotion {
            acceleration_peak_m_per_s2: peak,
            acceleration_rms_m_per_s2: (0.5 * square).sqrt(),
            comfort: Comfort::ALL[class],
        }
    }
}

/// Harmonics of samples at equal steps of a turn, from order 1. The mean and the highest harmonic are omitted.
pub(crate) fn harmonics(samples: &[f64]) -> Vec<Term> {
    let all = amplitudes(samples);
    all[1..all.len() - 1].to_vec()
}

/// Product of a harmonic and a complex gain.
pub(crate) fn times((a, b): Term, [re, im]: [f64; 2]) -> Term {
    (a * re + b * im, b * re - a * im)
}

/// Complex gain 1/(1 − M H) of the force of a mass M on a floor with the accelerance H.
fn felt(mass: f64, [re, im]: [f64; 2]) -> [f64; 2] {
    inverse([1.0 - mass * re, -mass * im])
}

fn inverse([re, im]: [f64; 2]) -> [f64; 2] {
    let square = re * re + im * im;
    [re / square, -im / square]
}

impl Floor {
    /// Accelerance Hₙ of the floor at a frequency, rad/s, in 1/kg.
    ///
    /// # Errors
    ///
    /// An undamped mode is at resonance.
    fn accelerance(&self, harmonic: usize, frequency: f64) -> Result<[f64; 2]> {
        let mut sum = [0.0; 2];
        for (number, mode) in (1..).zip(&self.modes) {
            let own = TAU * mode.frequency;
            let left = [
                own * own - frequency * frequency,
                2.0 * mode.damping * own * frequency,
            ];
            if libm::hypot(left[0], left[1]) <= RESONANT * own * own {
                let frequency = Quantity::new(mode.frequency, Dimension::Frequency);
                let fault = DynamicsError::FloorResonance {
                    harmonic,
                    frequency,
                };
                return Err(fault.at_key(&mode.key.replace('N', &number.to_string())));
            }
            let gain = (mode.ordinate * frequency).powi(2) / mode.mass;
            for (sum, part) in sum.iter_mut().zip(inverse(left)) {
                *sum += gain * part;
            }
        }
        Ok(sum)
    }

    /// Accelerance at each harmonic of a force; zero for harmonics without force.
    fn gains(&self, speed: f64, force: &[Term]) -> Result<Vec<[f64; 2]>> {
        let size = |(a, b): &Term| libm::hypot(*a, *b);
        let largest = force.iter().map(size).fold(0.0, f64::max);
        (1..)
            .zip(force)
            .map(|(n, term)| match size(term) > ROUNDING * largest {
                true => self.accelerance(n, n as f64 * speed),
                false => Ok([0.0; 2]),
            })
            .collect()
    }

    /// Harmonics of the upward acceleration of the floor, m/s². `speed` is the cam speed, rad/s. `force` contains the harmonics of the
    /// total force of all walkers, N.
    ///
    /// # Errors
    ///
    /// An undamped mode is at resonance.
    pub fn acceleration(&self, speed: f64, force: &[Term]) -> Result<Vec<Term>> {
        let gains = self.gains(speed, force)?;
        Ok(force.iter().zip(gains).map(|(f, h)| times(*f, h)).collect())
    }

    /// Sum of the forces of the walkers if each of them exerts `force` with its own phase and weight. The first `from` walkers are omitted.
    pub fn of_walkers(&self, from: usize, force: &[Term]) -> Vec<Term> {
        let first = self.walkers.first().map_or(0.0, |w| w.0);
        let sum = |n: usize| {
            let each = self.walkers.iter().skip(from);
            each.fold([0.0; 2], |[re, im], (phase, weight)| {
                let (sine, cosine) = libm::sincos(n as f64 * (phase - first));
                [re + weight * cosine, im + weight * sine]
            })
        };
        (1..).zip(force).map(|(n, f)| times(*f, sum(n))).collect()
    }

    /// Harmonics of the force of a shaker with a given mass, kg, on the moving floor, N: Fₙ = (Pₙ + M Hₙ Oₙ)/(1 − M Hₙ). The harmonics
    /// `still` (Pₙ) are the force of the shaker on a rigid floor. The harmonics `others` (Oₙ) are the force of the other walkers.
    ///
    /// # Errors
    ///
    /// An undamped mode is at resonance.
    pub fn pressed(
        &self,
        mass: f64,
        speed: f64,
        still: &[Term],
        others: &[Term],
    ) -> Result<Vec<Term>> {
        // The feet of all walkers load the floor. Where the shaker exerts no force at a harmonic, the other walkers may exert one.
        let size = |(a, b): &Term| libm::hypot(*a, *b);
        let both = still.iter().zip(others);
        let either: Vec<Term> = both.map(|(p, o)| (size(p), size(o))).collect();
        let gains = self.gains(speed, &either)?;
        let each = still.iter().zip(others).zip(gains);
        Ok(each
            .map(|((p, o), [re, im])| {
                let moved = times(*o, [mass * re, mass * im]);
                times((p.0 + moved.0, p.1 + moved.1), felt(mass, [re, im]))
            })
            .collect())
    }

    /// Ratio Gₙ = 1/(1 − M Hₙ) of the force of a shaker on the moving floor to the force of the same shaker on a rigid floor. M is the mass
    /// of the shaker, kg. The ratio is given for the harmonics of order 1 and higher. The ratio is zero at the resonance of an undamped
    /// mode.
    pub fn felt(&self, mass: f64, speed: f64, count: usize) -> Vec<[f64; 2]> {
        let of = |n: usize| self.accelerance(n, n as f64 * speed);
        (1..=count)
            .map(|n| of(n).map_or([0.0; 2], |h| felt(mass, h)))
            .collect()
    }

    /// Limit of the ratio Gₙ for high harmonics: 1/(1 + Σ M φ²/m), with the mass M of the shaker, kg, and the sum over all modes.
    pub fn felt_at_once(&self, mass: f64) -> f64 {
        let part = |mode: &FloorMode| mass * mode.ordinate.powi(2) / mode.mass;
        1.0 / (1.0 + self.modes.iter().map(part).sum::<f64>())
    }
}

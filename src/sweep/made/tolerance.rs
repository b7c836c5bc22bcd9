//! Manufacturing scatter of a design: the force errors of cams with random manufacturing errors.
//!
//! The difference between the force of the manufactured cam and the target is
//!
//! ```text
//! F′ − F* = (F − F*) + (F₀′ − F₀ + kΔ) + c(ω′ − ω)·v + (m′ω′² − mω²)·a + k ε + cω′ ε_θ + m′ω′² ε_θθ
//! ```
//!
//! F is the force of the design, F* the target, F₀ the force at rest, k the spring rate, c the damping, m the mass and ω the speed. v and a
//! are the first and second derivative of the lift with respect to the cam angle θ. A prime denotes the value with manufacturing errors. Δ
//! is the error of the base radius and ε(θ) the error of the profile, with the derivatives ε_θ and ε_θθ. Both errors are displacements of
//! the follower. For a flat face, the displacement equals the normal error. For a roller, to first order, it is the normal error divided by
//! the cosine of the pressure angle.
//!
//! The difference is linear in a few fixed functions of θ. The mean square force error of a sample is therefore a quadratic form in the
//! coefficients of these functions. Its matrix contains the mean products of the functions.

use std::f64::consts::TAU;

use super::over_time::{OverTime, angle};
use crate::drive::{Drive, DriveKind};
use crate::error::{Placed, Result, SweepError};
use crate::scene::keys::{self, Key};
use crate::sweep::plan::sample::Method;
use crate::synth::Design;
use crate::units::{Dimension, parse};
use gaitcam_base::random::{mixed, unit};

/// A quantity with a manufacturing error.
///
/// ```
/// use gaitcam::sweep::{Part, Tolerance};
///
/// assert_eq!(Tolerance::parse("base_radius=0.05 mm")?.part, Part::BaseRadius);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Error of the profile. It is a sum of waves with 2 to 12 lobes per turn, whose amplitudes decrease with the square of the number of
    /// lobes. The sum of the amplitudes is at most the tolerance.
    Profile,
    /// Error of the base radius.
    BaseRadius,
    /// Error of the mass that the cam moves.
    Mass,
    /// Error of the cam speed.
    Speed,
}

impl Part {
    const ALL: [Part; 4] = [Part::Profile, Part::BaseRadius, Part::Mass, Part::Speed];

    /// Key of the quantity in the scene; `None` for the profile, which has no key.
    fn key(self) -> Option<&'static str> {
        match self {
            Part::Profile => None,
            Part::BaseRadius => Some("cam.base_radius"),
            Part::Mass => Some("drive.mass"),
            Part::Speed => Some("drive.speed"),
        }
    }

    /// Whether `name` is the key of the quantity or the last part of this key.
    fn is_named(self, name: &str) -> bool {
        match self.key() {
            None => name == "profile",
            Some(key) => name == key || key.rsplit_once('.').is_some_and(|k| k.1 == name),
        }
    }

    /// Dimension of the tolerance of the quantity.
    fn dimension(self) -> Dimension {
        let measure = self.key().and_then(keys::find).and_then(Key::measure);
        measure.map_or(Dimension::Length, |m| m.translating)
    }
}

/// A symmetric tolerance of a quantity. The errors of samples are uniformly distributed within the tolerance. For the profile, the sum of
/// the amplitudes is uniformly distributed from 0 to the half width.
///
/// ```
/// use gaitcam::sweep::Tolerance;
///
/// let mass = Tolerance::parse("mass=1 %")?;
/// assert_eq!((mass.half_width, mass.relative), (0.01, true));
/// assert_eq!(Tolerance::parse("profile=0.02 mm")?.half_width, 2e-5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Quantity to which the tolerance belongs.
    pub part: Part,
    /// Half width of the tolerance in SI units. If `relative` is true, it is a fraction of the quantity.
    pub half_width: f64,
    /// Whether the tolerance is relative to the value of the quantity.
    pub relative: bool,
}

/// Numbers of lobes per turn of the profile error.
const LOBES: std::ops::RangeInclusive<usize> = 2..=12;
/// Number of fixed functions before the functions of the lobes. The fixed functions are F − F*, 1, v and a.
const FIXED: usize = 4;

impl Tolerance {
    /// Parses a tolerance such as `profile=0.02 mm`, `base_radius=0.1 mm`, `mass=1 %` or `speed=2 %`. Masses and speeds can also have
    /// absolute tolerances (`0.5 kg`, `1 rpm`).
    ///
    /// # Errors
    ///
    /// The name is not that of a quantity with a tolerance. The half width is negative, or has no unit or a wrong unit.
    pub fn parse(text: &str) -> Result<Tolerance> {
        let (name, value) = text
            .split_once('=')
            .ok_or_else(|| SweepError::NoToleranceValue {
                typed: text.to_string(),
            })?;
        let name = name.trim();
        let Some(part) = Part::ALL.into_iter().find(|p| p.is_named(name)) else {
            let typed = name.to_string();
            return Err(SweepError::NoTolerance { typed }.into());
        };
        let relative = value.trim().ends_with('%') && matches!(part, Part::Mass | Part::Speed);
        let dimension = if relative {
            Dimension::Ratio
        } else {
            part.dimension()
        };
        let half_width = parse(value, dimension).map_err(|e| e.at_key(name))?;
        if half_width < 0.0 {
            return Err(SweepError::NegativeTolerance {
                part: name.to_string(),
                typed: value.trim().to_string(),
            }
            .into());
        }
        Ok(Tolerance {
            part,
            half_width,
            relative,
        })
    }
}

/// A manufacturing sample: errors of the quantities, and the resulting force error.
///
/// ```
/// use gaitcam::sweep::{Scatter, Tolerance};
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // With a tolerance of zero, a sample equals the design.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let made = Scatter::new(&design)?.sample(&[Tolerance::parse("mass=0 %")?], 3, 10, 1);
/// assert_eq!(made.mass_kg, 0.0);
/// assert!((made.force_rms_error_n / design.force.rms_error_n - 1.0).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToleranceSample {
    /// Sum of the amplitudes of all waves of the profile error, m.
    pub profile_m: f64,
    /// Error of the base radius, m.
    pub base_radius_m: f64,
    /// Error of the mass, kg.
    pub mass_kg: f64,
    /// Error of the speed, rad/s.
    pub speed_rad_per_s: f64,
    /// RMS force error, N.
    pub force_rms_error_n: f64,
    /// RMS force error in percent of the mean target force.
    pub force_rms_error_percent: f64,
}

/// Computes the force errors of manufacturing samples of a design. It uses precomputed mean products of functions of the cam angle.
///
/// ```
/// use gaitcam::sweep::{Scatter, Tolerance};
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // 1 % of a mass of 71.36 kg is at most 0.7136 kg.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let scatter = Scatter::new(&synthesise(&scene, scene.model_force()?.as_ref())?)?;
/// let mass = [Tolerance::parse("mass=1 %")?];
/// assert!((0..100).all(|i| scatter.sample(&mass, i, 100, 1).mass_kg.abs() <= 0.01 * 700.0 / 9.81));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub struct Scatter {
    drive: Drive,
    mean: f64,
    /// Mean products of all pairs of the fixed functions and the functions of the lobes.
    products: Vec<Vec<f64>>,
}

impl Scatter {
    /// Computes the mean products for a design.
    ///
    /// # Errors
    ///
    /// The design has no target force and therefore no force error. The follower is on an arm, where the effect of a profile error depends
    /// on the angle.
    pub fn new(design: &Design) -> Result<Self> {
        let Some(target) = design.target() else {
            return Err(SweepError::NoForceError.into());
        };
        let count = FIXED + 2 * LOBES.count();
        if design.cam.follower.is_oscillating() {
            return Err(SweepError::ScatterOfArm.into());
        }
        // The last function is the derivative of the target with respect to its phase.
        let mut products = vec![vec![0.0; count + 1]; count + 1];
        let mut row = vec![0.0; count + 1];
        let counts = OverTime::of(design, target);
        for (i, weight) in counts.weights.iter().enumerate() {
            let theta = angle(i);
            row[count] = counts.rates[i];
            let at = design.cam.law.svaj(theta);
            row[..FIXED].copy_from_slice(&[
                design.problem.drive.force(at) + design.problem.extra_force(theta)
                    - target.at(theta),
                1.0,
                at.v,
                at.a,
            ]);
            for (k, n) in LOBES.enumerate() {
                let (sin, cos) = libm::sincos(n as f64 * theta);
                (row[FIXED + 2 * k], row[FIXED + 2 * k + 1]) = (cos, sin);
            }
            for (line, x) in products.iter_mut().zip(&row) {
                for (p, y) in line.iter_mut().zip(&row) {
                    *p += weight * x * y;
                }
            }
        }
        Ok(Scatter {
            drive: design.problem.drive,
            mean: target.mean_n(),
            products: OverTime::free_of_phase(products),
        })
    }

    /// Sample with the index `index` (from 0) of `count` samples. Equal values of `seed` give equal samples.
    pub fn sample(
        &self,
        tolerances: &[Tolerance],
        index: u64,
        count: u64,
        seed: u64,
    ) -> ToleranceSample {
        let drive = &self.drive;
        let (mut profile, mut radius, mut mass, mut speed) = (0.0, 0.0, 0.0, 0.0);
        for (axis, t) in tolerances.iter().enumerate() {
            let u = Method::Latin.coordinate(index, count, axis, seed);
            let error =
                |value: f64| (2.0 * u - 1.0) * t.half_width * if t.relative { value } else { 1.0 };
            match t.part {
                Part::Profile => profile = u * t.half_width,
                Part::BaseRadius => radius = error(0.0),
                Part::Mass => mass = error(drive.mass),
                Part::Speed => speed = error(drive.speed),
            }
        }
        let (w, m) = (drive.speed + speed, drive.mass + mass);
        let heavier = match drive.kind {
            DriveKind::MovingAxis => drive.rest_force * mass / drive.mass,
            _ => 0.0,
        };
        let mut c = vec![0.0; self.products.len()];
        c[0] = 1.0;
        c[1] = heavier + drive.spring_rate * radius;
        c[2] = drive.damping * speed;
        c[3] = m * w * w - drive.mass * drive.speed * drive.speed;
        let all: f64 = LOBES.map(|n| 1.0 / (n * n) as f64).sum();
        for (k, n) in LOBES.enumerate() {
            let x = n as f64;
            let size = profile / (all * x * x);
            let phase = TAU * unit(mixed(seed ^ mixed(index ^ mixed(n as u64))));
            let (b, a) = (size * libm::sin(phase), size * libm::cos(phase));
            let (even, odd) = (drive.spring_rate - m * w * w * x * x, drive.damping * w * x);
            c[FIXED + 2 * k] = even * a + odd * b;
            c[FIXED + 2 * k + 1] = even * b - odd * a;
        }
        let square: f64 = self
            .products
            .iter()
            .zip(&c)
            .map(|(line, x)| x * line.iter().zip(&c).map(|(p, y)| p * y).sum::<f64>())
            .sum();
        let rms = square.max(0.0).sqrt();
        ToleranceSample {
            profile_m: profile,
            base_radius_m: radius,
            mass_kg: mass,
            speed_rad_per_s: speed,
            force_rms_error_n: rms,
            force_rms_error_percent: 100.0 * rms / self.mean.abs(),
        }
    }
}

/// Statistics of a set of numbers.
///
/// ```
/// use gaitcam::sweep::Spread;
///
/// let spread = Spread::of(&[1.0, 2.0, 3.0, 4.0], Some(3.0)).unwrap();
/// assert_eq!((spread.mean, spread.largest, spread.within), (2.5, 4.0, Some(0.75)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Mean of the values.
    pub mean: f64,
    /// Standard deviation of the values, with n − 1 in the denominator.
    pub deviation: f64,
    /// Quantiles 5 %, 50 % and 95 % of the values.
    pub quantiles: [f64; 3],
    /// Maximum of the values.
    pub largest: f64,
    /// Fraction of the values that do not exceed the bound `band`; `None` if no bound is given.
    pub within: Option<f64>,
}

impl Spread {
    /// Statistics of `values`. If `band` is given, they include the fraction of values that do not exceed it. `None` if there are no
    /// values.
    pub fn of(values: &[f64], band: Option<f64>) -> Option<Spread> {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let n = sorted.len() as f64;
        let mean = sorted.iter().sum::<f64>() / n;
        let square = sorted.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
        let quantile = |q: f64| sorted[((q * (n - 1.0)).round() as usize).min(sorted.len() - 1)];
        let largest = *sorted.last()?;
        Some(Spread {
            mean,
            deviation: (square / (n - 1.0).max(1.0)).sqrt(),
            quantiles: [0.05, 0.5, 0.95].map(quantile),
            largest,
            within: band.map(|b| sorted.partition_point(|v| *v <= b) as f64 / n),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::{Deviation, Inspection};
    use crate::force::Feet;
    use crate::scene;
    use crate::sweep::MadeCam;
    use crate::synth::synthesise;

    fn design() -> Design {
        let scene = scene::parse(scene::DEFAULT).unwrap();
        let target = crate::force::model("young", Some(1.85), 700.0, Feet::Both).unwrap();
        synthesise(&scene, Some(&target)).unwrap()
    }

    #[test]
    fn without_tolerances_the_error_is_the_design_s_own() {
        let floor = [
            "machine.floor.mass=10000 kg",
            "machine.floor.frequency=1.85 Hz",
            "machine.floor.damping=0.01",
        ];
        let motor = [
            "machine.motor.slope=10 N m s/rad",
            "machine.inertia=1 kg m^2",
        ];
        let both = [&floor[..], &motor].concat();
        for changes in [&[][..], &floor, &motor, &both] {
            let mut table = scene::table(scene::DEFAULT).unwrap();
            for change in changes {
                scene::set(&mut table, change).unwrap();
            }
            let design = scene::read(&table).unwrap().design().unwrap();
            let made = Scatter::new(&design).unwrap().sample(&[], 0, 1, 1);
            let own = design.force.rms_error_n;
            // With a motor, the force error of the design is a sum over only 240 angles.
            let rounding = match design.shaft {
                Some(_) => 2e-7 * design.force.target_mean_n,
                None => 1e-5 * own,
            };
            assert!((made.force_rms_error_n - own).abs() < rounding, "{own}");
            let none = Inspection {
                turn: 0.0,
                centre: [0.0; 2],
                deviations: (0..90).map(exact).collect(),
                alike: Vec::new(),
                unmeasured: None,
            };
            let cam = MadeCam::of(&design, &none).unwrap().made;
            assert!((cam.rms_error_n.unwrap() / own - 1.0).abs() < 1e-4);
            assert!((cam.min_n - design.force.min_n).abs() < 1e-6);
        }
    }

    /// A measured point without deviation from the profile.
    fn exact(row: usize) -> Deviation {
        let theta = TAU * row as f64 / 90.0;
        let normal = 0.0;
        Deviation {
            row,
            theta,
            normal,
            is_outlier: false,
        }
    }

    #[test]
    fn mass_and_speed_errors_cost_what_their_forces_say() {
        let design = design();
        let scatter = Scatter::new(&design).unwrap();
        // An additional mass ΔM adds the forces ΔM·g and ΔM ω² a. The mean force then differs from the mean target by ΔM·g.
        let t = [
            Tolerance::parse("mass=10 %").unwrap(),
            Tolerance::parse("speed=5 %").unwrap(),
        ];
        let target = design.target().unwrap();
        for i in 0..8 {
            let made = scatter.sample(&t, i, 8, 3);
            let (m, w) = (
                design.problem.drive.mass + made.mass_kg,
                design.problem.drive.speed + made.speed_rad_per_s,
            );
            let n = 20_000;
            let square: f64 = (0..n)
                .map(|k| {
                    let x = TAU * f64::from(k) / f64::from(n);
                    (m * (9.81 + w * w * design.cam.law.svaj(x).a) - target.at(x)).powi(2)
                })
                .sum::<f64>()
                / f64::from(n);
            assert!((made.force_rms_error_n / square.sqrt() - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn a_profile_error_grows_the_error_and_stays_within_its_tolerance() {
        let design = design();
        let scatter = Scatter::new(&design).unwrap();
        let t = [Tolerance::parse("profile=0.05 mm").unwrap()];
        let made: Vec<ToleranceSample> = (0..200).map(|i| scatter.sample(&t, i, 200, 1)).collect();
        assert!(made.iter().all(|m| m.profile_m <= 5e-5));
        let errors: Vec<f64> = made.iter().map(|m| m.force_rms_error_percent).collect();
        let spread = Spread::of(&errors, Some(100.0)).unwrap();
        assert!(
            spread.within == Some(1.0) && spread.largest > design.force.rms_error_percent_of_mean
        );
        assert!(
            Tolerance::parse("colour=3 mm")
                .unwrap_err()
                .to_string()
                .contains("parts have a tolerance")
        );
    }
}

//! Target force as a function of the cam angle.

use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

use super::force_cycle::{self, ForceCycle, most};
use super::machine::Scaling;
use crate::drive::Drive;
use crate::error::{Placed, Result, SynthError};
use crate::force::{ForceCurve, Interpretation};
use crate::law::{Law, weighted};
use crate::poly::{Cells, Distance, PiecewisePoly};
use crate::scene::{Band, LawSpec, PhaseWeight};

/// Target force over one turn. The force between its samples is given by cubic polynomials.
///
/// ```
/// use gaitcam::force::ForceCurve;
/// use gaitcam::problem::Target;
///
/// let samples = (0..64).map(|i| 500.0 + 100.0 * (std::f64::consts::TAU * f64::from(i) / 64.0).sin());
/// let target = Target::new(ForceCurve::from_samples("a wave", 1.0, samples.collect())?);
/// assert!((target.mean_n() - 500.0).abs() < 1e-9);
/// assert!((target.curve().at(std::f64::consts::FRAC_PI_2) - 600.0).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Target {
    /// Cycle of force to which the scaling is applied. The cycle starts at cam angle 0.
    cycle: Arc<ForceCycle>,
    scaling: Scaling,
    /// Samples and cubics of the target, computed only if the scaling changes the force.
    scaled: OnceLock<(Arc<ForceCurve>, Arc<Cells>)>,
}

impl Target {
    /// Creates a target from a curve. The cubics between the samples are computed from the samples.
    pub fn new(curve: impl Into<Arc<ForceCurve>>) -> Self {
        Target::of(Arc::new(ForceCycle::new(curve)), Scaling::NONE)
    }

    /// Creates a target whose cubics have the given slopes, N per sample. The number of slopes is the number of samples plus one.
    pub(crate) fn with_slopes(curve: impl Into<Arc<ForceCurve>>, slopes: Vec<f64>) -> Self {
        let cycle = ForceCycle::with_slopes(curve, slopes);
        Target::of(Arc::new(cycle), Scaling::NONE)
    }

    /// Creates a target from a force cycle and its scaling.
    pub(super) fn of(cycle: Arc<ForceCycle>, scaling: Scaling) -> Self {
        Target {
            cycle,
            scaling,
            scaled: OnceLock::new(),
        }
    }

    /// Factor and force cycle whose product is the target. `None` if the scaling also adds a constant.
    pub(crate) fn multiple(&self) -> Option<(f64, &ForceCycle)> {
        let Scaling { factor, shift } = self.scaling;
        (shift == 0.0).then_some((factor, &*self.cycle))
    }

    /// Scaling of the target, and the cycle to which the scaling is applied.
    pub(super) fn scaled_cycle(&self) -> (Scaling, &ForceCycle) {
        (self.scaling, &self.cycle)
    }

    /// Samples of the target force over one turn, N, starting at cam angle 0.
    pub fn curve(&self) -> &Arc<ForceCurve> {
        if self.scaling.is_none() {
            return self.cycle.curve();
        }
        &self.scaled().0
    }

    /// Target force, N, as cubic polynomials between its samples.
    pub fn cells(&self) -> &Cells {
        if self.scaling.is_none() {
            return self.cycle.cells();
        }
        &self.scaled().1
    }

    fn scaled(&self) -> &(Arc<ForceCurve>, Arc<Cells>) {
        self.scaled.get_or_init(|| {
            let curve = Arc::new(self.scaling.of(self.cycle.curve()));
            let Scaling { factor, shift } = self.scaling;
            (curve, Arc::new(self.cycle.cells().scaled(factor, shift)))
        })
    }

    /// Interpretation of the recording from which the target was computed; `None` without a recording.
    pub fn recording(&self) -> Option<&Interpretation> {
        self.cycle.given()?.recording.as_deref()
    }

    /// Number of samples in one cycle, at equal steps.
    pub fn samples(&self) -> usize {
        self.cycle.samples()
    }

    /// Mean of the target force, N.
    pub fn mean_n(&self) -> f64 {
        self.scaling.at(self.cycle.mean.mean_n)
    }

    /// Minimum and maximum sample of the target, N.
    pub fn range_n(&self) -> [f64; 2] {
        self.cycle.range_n().map(|force| self.scaling.at(force))
    }

    /// Maximum difference between the samples and a constant force, N.
    pub fn farthest_from(&self, force: f64) -> f64 {
        let [least, most] = self.range_n();
        (most - force).max(force - least).max(0.0)
    }

    /// Mean over the turn of the squared difference between the target and a constant force, N².
    pub fn mean_square_from(&self, force: f64) -> f64 {
        let Scaling { factor, shift } = self.scaling;
        factor * factor * self.cycle.mean_square_from((force - shift) / factor)
    }

    /// Least-squares approximation of the target by polynomials of the degree `degree` between the breaks. The result contains the values
    /// of the polynomials, N, at the nodes of [`Cells::nearest`].
    pub fn nearest(&self, breaks: &[f64], degree: usize) -> Vec<f64> {
        let projection = self.cycle.projection(breaks, degree);
        let values = projection.values.iter();
        values.map(|force| self.scaling.at(*force)).collect()
    }

    /// Difference between the target and a force over the turn. The result contains the integral of its square, N² rad, and its maximum, N.
    fn distance(&self, own: &PiecewisePoly) -> Distance {
        let Scaling { factor, shift } = self.scaling;
        let square = match self.scaling.is_none() {
            true => self.cycle.square_distance(own),
            false => {
                let own = PiecewisePoly::combine(&[(1.0 / factor, own)], -shift / factor);
                factor * factor * self.cycle.square_distance(&own)
            }
        };
        Distance {
            square,
            largest: self.cells().largest_distance(own),
        }
    }

    /// RMS and maximum force error of a law with a drive over the turn, N. The force error is the difference between force and target.
    pub fn error_of(&self, law: &Law, drive: &Drive) -> [f64; 2] {
        let series = || Some(self.cycle.series()).filter(|series| series.is_finite());
        if let Some(own) = law.harmonics()
            && let Some(series) = series()
        {
            let factor = self.scaling.factor;
            let weights = drive.weights().map(|weight| weight / factor);
            let mean = drive.rest_force + drive.spring_rate * law.poly().coefficients()[0];
            let gap = (mean - self.mean_n()) / factor;
            let error = series.error_of(gap, &weighted(&own, weights));
            return error.map(|error| factor.abs() * error);
        }
        let apart = self.distance(&drive.force_curve(law));
        let (_, length) = law.extent();
        [(apart.square / length).max(0.0).sqrt(), apart.largest]
    }

    /// Order of the highest harmonic that the samples determine.
    pub(crate) fn most_harmonics(&self) -> usize {
        most(self.samples())
    }

    /// First `count` harmonics of the target as (cosine, sine), N.
    pub(crate) fn harmonics(&self, count: usize) -> impl Iterator<Item = (f64, f64)> {
        let factor = self.scaling.factor;
        let waves = self.cycle.series().first(count).iter();
        let waves = waves.map(move |(a, b)| (factor * a, factor * b));
        // A finite series has no further harmonics, so they are zero.
        waves.chain(std::iter::repeat((0.0, 0.0))).take(count)
    }

    /// RMS of the target after its mean and its first `count` harmonics are removed, N.
    pub(crate) fn left_over(&self, count: usize) -> f64 {
        self.scaling.factor.abs() * self.cycle.series().left_over(count)
    }

    /// Minimum number of harmonics for which the RMS of all higher harmonics is at most `wanted`, N. The result is between 1 and 60.
    pub(crate) fn fewest_harmonics(&self, wanted: f64) -> usize {
        let series = self.cycle.series();
        series.fewest(wanted / self.scaling.factor.abs())
    }
}

/// Target and tolerance band for a turn that starts at phase 0 of the force cycle.
#[derive(Debug)]
pub struct Unturned {
    target: Target,
    /// Minimum and maximum permitted force over the turn, N.
    band: Option<[ForceCurve; 2]>,
}

impl Unturned {
    /// Creates a target with a tolerance band about it.
    ///
    /// # Errors
    ///
    /// The half width of the band is the step-to-step spread, but the force has no spread.
    pub fn new(target: Target, band: Option<Band>) -> Result<Unturned> {
        let band = band.map(|band| band_about(target.curve(), band));
        Ok(Unturned {
            band: band.transpose()?,
            target,
        })
    }

    /// Target and tolerance band for a turn that starts at the given phase of the force cycle, rad.
    pub fn at_phase(&self, phase: f64) -> (Option<Target>, Option<[ForceCurve; 2]>) {
        if phase == 0.0 {
            return (Some(self.target.clone()), self.band.clone());
        }
        let begun = |curve: &ForceCurve| force_cycle::begun_at(curve, phase);
        let band = self.band.as_ref().map(|edges| edges.each_ref().map(begun));
        (Some(Target::new(begun(self.target.curve()))), band)
    }
}

/// Lower and upper edge of a tolerance band about a force, N. Each edge has as many samples as the force.
fn band_about(target: &ForceCurve, band: Band) -> Result<[ForceCurve; 2]> {
    let half: Vec<f64> = match (band, &target.spread_n) {
        (Band::Width(width), _) => vec![width; target.force_n.len()],
        (Band::Spread, Some(spread)) => spread.clone(),
        (Band::Spread, None) => {
            return Err(SynthError::NoSpread.at_key("gait.band"));
        }
    };
    let edge = |sign: f64| {
        let forces = target.force_n.iter().zip(&half);
        target.with_forces(forces.map(|(f, h)| f + sign * h).collect())
    };
    Ok([edge(-1.0), edge(1.0)])
}

/// Lift that the target force and the conditions on the law require, m. The solvers use it as unit of length. It is 1 mm if neither force
/// nor conditions determine it.
pub fn typical_lift(drive: &Drive, target: Option<&Target>, law: &LawSpec) -> f64 {
    let [k, c, m, _] = drive.weights();
    let from_force = target.map_or(0.0, |target| {
        let largest = target.farthest_from(drive.rest_force);
        let gain = k + c + m;
        if gain > 0.0 { largest / gain } else { 0.0 }
    });
    let points = &law.points;
    let lifts = points
        .iter()
        .filter_map(|p| p.lift)
        .chain(law.dwells.iter().filter_map(|d| d.lift));
    let from_points = lifts.fold(0.0_f64, |x, l| x.max(l.abs()));
    let forces = points.iter().filter_map(|p| p.force);
    let from_forces = forces.fold(0.0_f64, |x, f| x.max(f.abs()));
    let from_forces = if k > 0.0 { from_forces / k } else { 0.0 };
    let typical = from_force.max(from_points).max(from_forces);
    if typical > 0.0 && typical.is_finite() {
        typical
    } else {
        1e-3
    }
}

/// A force as a piecewise cubic over θ ∈ [0, 2π], N.
pub fn piecewise(force: &ForceCurve) -> PiecewisePoly {
    let n = force.force_n.len();
    // TAU·n/n may differ from TAU by a rounding error. The last break is therefore set exactly.
    let breaks = (0..n).map(|i| TAU * i as f64 / n as f64);
    let breaks = breaks.chain([TAU]).collect();
    let cells = force_cycle::cells(force, force.slopes());
    let coef = (0..n).flat_map(|i| cells.cubic(i)).collect();
    PiecewisePoly::new(breaks, 3, coef)
}

/// Weight of the squared force error at a phase of the cycle, rad. It is 1 outside all ranges. If ranges overlap, the last range determines
/// the weight.
pub fn weight_at(weights: &[PhaseWeight], phase: f64) -> f64 {
    let at = phase.rem_euclid(TAU);
    let inside = |w: &&PhaseWeight| {
        if w.from < w.to {
            at >= w.from && at < w.to
        } else {
            at >= w.from || at < w.to
        }
    };
    weights.iter().rev().find(inside).map_or(1.0, |w| w.weight)
}

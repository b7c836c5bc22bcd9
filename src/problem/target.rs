//! The target force in step with the cam.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::drive::Drive;
use crate::force::ForceCurve;
use crate::poly::{Cells, PiecewisePoly};
use crate::scene::{LawSpec, PhaseWeight};

/// One turn of the target force with its cubics.
///
/// ```
/// use gaitcam::force::ForceCurve;
/// use gaitcam::problem::Target;
///
/// let samples = (0..64).map(|i| 500.0 + 100.0 * (std::f64::consts::TAU * f64::from(i) / 64.0).sin());
/// let target = Target::new(ForceCurve::from_samples("a wave", 1.0, samples.collect())?);
/// assert!((target.mean_n() - 500.0).abs() < 1e-9);
/// assert!((target.curve.at(std::f64::consts::FRAC_PI_2) - 600.0).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Target {
    /// The cycle, beginning at cam angle 0.
    pub curve: Arc<ForceCurve>,
    /// Its cubics between the samples, N.
    cells: Arc<Cells>,
    mean_n: f64,
    /// Smallest and largest sample, N.
    range_n: [f64; 2],
}

impl Target {
    /// The cycle with its cubics.
    pub fn new(curve: impl Into<Arc<ForceCurve>>) -> Self {
        let curve = curve.into();
        let slopes = curve.slopes();
        Target::with_slopes(curve, slopes)
    }

    /// The same with the slopes of its cubics, N per sample, one more than samples.
    pub(crate) fn with_slopes(curve: impl Into<Arc<ForceCurve>>, slopes: Vec<f64>) -> Self {
        let curve = curve.into();
        Target {
            cells: Arc::new(cells(&curve, slopes)),
            mean_n: curve.mean_n(),
            range_n: curve.range_n().into(),
            curve,
        }
    }

    /// Mean force, N.
    pub fn mean_n(&self) -> f64 {
        self.mean_n
    }

    /// Smallest and largest sample of the force, N.
    pub fn range_n(&self) -> [f64; 2] {
        self.range_n
    }

    /// Largest distance of a sample from a force, N.
    pub fn farthest_from(&self, force: f64) -> f64 {
        let [least, most] = self.range_n;
        (most - force).max(force - least).max(0.0)
    }

    /// The force as cubics between its samples, N.
    pub fn cells(&self) -> &Cells {
        &self.cells
    }
}

/// The cubics between the samples of a force, N.
fn cells(force: &ForceCurve, slopes: Vec<f64>) -> Cells {
    let f = &force.force_n;
    let mut ends = Vec::with_capacity(f.len() + 1);
    ends.extend_from_slice(f);
    ends.push(f[0]);
    Cells::new(ends, slopes, TAU)
}

/// The lift that force and demands ask for, m: the unit in which solvers work.
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
    // TAU·n/n need not be TAU: the last break is set, not computed.
    let breaks = (0..n).map(|i| TAU * i as f64 / n as f64);
    let breaks = breaks.chain([TAU]).collect();
    let cells = cells(force, force.slopes());
    let coef = (0..n).flat_map(|i| cells.cubic(i)).collect();
    PiecewisePoly::new(breaks, 3, coef)
}

/// Weight of the force error at a phase of the cycle; where ranges overlap the last one counts.
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

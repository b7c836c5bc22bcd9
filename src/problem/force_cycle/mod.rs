//! One cycle of a force. Problems with the same cycle share the results that are computed from it.

mod fits;
mod kept;
mod samples;
mod series;
mod shape;

pub use fits::{FitKey, Fits, Objective};
pub use series::{Series, most};
pub use shape::Shape;

use std::convert::Infallible;
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

use nalgebra::DMatrix;

use super::mean_force::MeanForce;
use crate::force::{ForceCurve, FourierForce};
use crate::poly::{Cells, PiecewisePoly, bernstein, gauss_legendre};
use kept::Cache;
use samples::Samples;

/// Maximum degree of least-squares projections. With a higher degree, the rounding errors are too large.
pub const HIGHEST_PROJECTED: usize = 9;

/// One cycle of a force. Problems that scale or shift the force share it.
#[derive(Debug)]
pub struct ForceCycle {
    samples: Samples,
    /// Mean, duration and spread of the force.
    pub mean: MeanForce,
    cells: OnceLock<Arc<Cells>>,
    mean_square: OnceLock<f64>,
    series: OnceLock<Series>,
    projections: Cache<Arc<Projection>>,
    /// Cache of the splines that are fitted to the cycle.
    pub fits: Fits,
}

/// Least-squares approximation of a force by polynomials of equal degree between given breaks.
#[derive(Debug)]
pub struct Projection {
    breaks: Vec<f64>,
    degree: usize,
    /// Values of the approximation at the nodes of [`Cells::nearest`], N.
    pub values: Vec<f64>,
    /// Integral over the turn of the squared difference between force and approximation, N² rad.
    rest: OnceLock<f64>,
}

impl Projection {
    /// The approximation as a piecewise polynomial.
    fn pieces(&self) -> PiecewisePoly {
        let count = self.degree + 1;
        let rule = gauss_legendre(count);
        let unit = |k: usize| -> Vec<f64> { (0..count).map(|i| f64::from(i == k)).collect() };
        let at_nodes = DMatrix::from_fn(count, count, |q, k| bernstein::eval(&unit(k), rule[q].0));
        let pieces = self.values.len() / count;
        let values = DMatrix::from_column_slice(count, pieces, &self.values);
        // The Bernstein polynomials up to degree 9 are linearly independent at the nodes, so the system can be solved.
        let coefficients = at_nodes.lu().solve(&values).unwrap_or(values);
        let coefficients = coefficients.as_slice().to_vec();
        PiecewisePoly::new(self.breaks.clone(), self.degree, coefficients)
    }
}

impl ForceCycle {
    /// Creates a cycle from a force curve. The cycle uses the samples of this curve.
    pub fn new(curve: impl Into<Arc<ForceCurve>>) -> ForceCycle {
        let curve = curve.into();
        let mean = MeanForce::of(&curve);
        ForceCycle::of(Samples::given(curve), mean)
    }

    /// Creates the cycle of a load model from its Fourier series. Samples are computed only if they are needed.
    pub fn of_series(force: FourierForce) -> ForceCycle {
        let mean = MeanForce {
            mean_n: force.mean_n(),
            period_s: force.period_s(),
            spread_n: 0.0,
            noise_n: 0.0,
        };
        ForceCycle::of(Samples::of_series(force), mean)
    }

    fn of(samples: Samples, mean: MeanForce) -> ForceCycle {
        ForceCycle {
            samples,
            mean,
            cells: OnceLock::new(),
            mean_square: OnceLock::new(),
            series: OnceLock::new(),
            projections: Cache::default(),
            fits: Fits::default(),
        }
    }

    /// Creates a cycle whose cubics between the samples have the given slopes, N per sample. The number of slopes is the number of samples
    /// plus one.
    pub fn with_slopes(curve: impl Into<Arc<ForceCurve>>, slopes: Vec<f64>) -> ForceCycle {
        let out = ForceCycle::new(curve);
        let cells = Arc::new(cells(out.curve(), slopes));
        ForceCycle {
            cells: OnceLock::from(cells),
            ..out
        }
    }

    /// Samples of the force, N, at equal steps over one cycle, starting at the start of the cycle.
    pub fn curve(&self) -> &Arc<ForceCurve> {
        self.samples.curve()
    }

    /// Curve from which the cycle was created, such as a recording or a file. `None` for a load model.
    pub fn given(&self) -> Option<&Arc<ForceCurve>> {
        self.samples.as_given()
    }

    /// Number of samples in one cycle, at equal steps.
    pub fn samples(&self) -> usize {
        self.samples.count()
    }

    /// Minimum and maximum sample, N.
    pub fn range_n(&self) -> [f64; 2] {
        self.samples.range_n()
    }

    /// Cubics between the samples, N.
    pub fn cells(&self) -> &Arc<Cells> {
        let cells = || Arc::new(cells(self.curve(), self.curve().slopes()));
        self.cells.get_or_init(cells)
    }

    /// Mean over the cycle of the squared difference between the cubics and a constant force, N².
    pub fn mean_square_from(&self, force: f64) -> f64 {
        // The mean of the Hermite cubics over a period equals the mean of the samples.
        let mean = self.mean.mean_n;
        let about_mean = || self.cells().mean_square_from(mean);
        self.mean_square.get_or_init(about_mean) + (force - mean).powi(2)
    }

    /// Fourier series of the cycle, computed once. It also caches laws with the first harmonics, and the force errors of these laws.
    pub fn series(&self) -> &Series {
        self.series.get_or_init(|| match self.samples.series() {
            Some(force) => Series::finite(force.mean_n(), force.waves()),
            None => Series::of(self.curve()),
        })
    }

    /// RMS and maximum of the force after its mean and its first `count` harmonics are removed, N, computed once. For a finite series, they
    /// are computed from the remaining harmonics. Otherwise, they are computed from the cubics between the samples.
    pub fn error_of_harmonics(&self, count: usize) -> [f64; 2] {
        let series = self.series();
        *series.error(count).get_or_init(|| {
            if series.is_finite() {
                return series.error_of(0.0, series.first(count));
            }
            let own = series.law(count).combination([1.0, 0.0, 0.0, 0.0], 0.0);
            let apart = self.cells().distance(&own);
            [(apart.square / TAU).max(0.0).sqrt(), apart.largest]
        })
    }

    /// Least-squares approximation of the force by polynomials between the breaks, computed once. `degree` is at most
    /// [`HIGHEST_PROJECTED`].
    pub fn projection(&self, breaks: &[f64], degree: usize) -> Arc<Projection> {
        let is_same = |own: &Arc<Projection>| own.degree == degree && own.breaks == breaks;
        let found = self.projections.get(is_same, || {
            Ok::<_, Infallible>(Arc::new(Projection {
                breaks: breaks.to_vec(),
                degree,
                values: self.cells().nearest(breaks, degree),
                rest: OnceLock::new(),
            }))
        });
        found.unwrap_or_else(|never| match never {})
    }

    /// Integral over the turn of the squared difference between the force and a piecewise polynomial, N² rad. It is the sum of two
    /// integrals. The first contains the difference between the polynomial and the least-squares approximation of the force. The second
    /// contains the residual of this approximation.
    pub fn square_distance(&self, own: &PiecewisePoly) -> f64 {
        if own.degree() > HIGHEST_PROJECTED {
            return self.cells().square_distance(own);
        }
        let projection = self.projection(own.breaks(), own.degree());
        let rest = projection.rest.get_or_init(|| {
            let nearest = projection.pieces();
            self.cells().square_distance(&nearest)
        });
        let rule = gauss_legendre(own.degree() + 1);
        let values = projection.values.chunks_exact(rule.len()).enumerate();
        let square = |(piece, values): (usize, &[f64])| {
            let width = own.breaks()[piece + 1] - own.breaks()[piece];
            let each = rule.iter().zip(values).map(|((u, weight), value)| {
                weight * (bernstein::eval(own.piece(piece), *u) - value).powi(2)
            });
            width * each.sum::<f64>()
        };
        rest + values.map(square).sum::<f64>()
    }
}

/// Force, N, as cubic polynomials between its samples. `slopes` are the slopes at the samples, N per sample.
pub fn cells(force: &ForceCurve, slopes: Vec<f64>) -> Cells {
    let f = &force.force_n;
    let mut ends = Vec::with_capacity(f.len() + 1);
    ends.extend_from_slice(f);
    ends.push(f[0]);
    Cells::new(ends, slopes, TAU)
}

/// Copy of a cycle that starts at the phase `phase`, rad. It is resampled, and its mean force is preserved.
pub fn begun_at(curve: &ForceCurve, phase: f64) -> ForceCurve {
    let begun = curve.begun_at(phase);
    let shift = curve.mean_n() - begun.mean_n();
    ForceCurve {
        force_n: begun.force_n.iter().map(|f| f + shift).collect(),
        ..begun
    }
}

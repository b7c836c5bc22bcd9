//! One cycle of a force, with what follows from its course alone: found once for all problems of that force.

mod series;
mod shape;

pub use series::{Series, most};
pub use shape::Shape;

use std::f64::consts::TAU;
use std::sync::{Arc, Mutex, OnceLock};

use super::mean_force::MeanForce;
use crate::force::ForceCurve;
use crate::poly::Cells;

/// Projections kept at a time; one design uses about ten.
const KEPT_PROJECTIONS: usize = 64;

/// One cycle of a force, which problems scale, shift and share.
#[derive(Debug)]
pub struct ForceCycle {
    /// The samples, N.
    pub curve: Arc<ForceCurve>,
    /// Mean, period and spread.
    pub mean: MeanForce,
    /// Smallest and largest sample, N.
    pub range_n: [f64; 2],
    cells: OnceLock<Arc<Cells>>,
    mean_square: OnceLock<f64>,
    series: OnceLock<Series>,
    projections: Mutex<Vec<Projection>>,
}

/// The polynomials of a degree that are nearest to the force between breaks, by their values at quadrature nodes, N.
#[derive(Debug)]
struct Projection {
    breaks: Vec<f64>,
    degree: usize,
    values: Arc<[f64]>,
}

impl ForceCycle {
    /// A cycle about which nothing is known yet but its samples.
    pub fn new(curve: impl Into<Arc<ForceCurve>>) -> ForceCycle {
        let curve = curve.into();
        ForceCycle {
            mean: MeanForce::of(&curve),
            range_n: curve.range_n().into(),
            curve,
            cells: OnceLock::new(),
            mean_square: OnceLock::new(),
            series: OnceLock::new(),
            projections: Mutex::default(),
        }
    }

    /// The cycle with given slopes of its cubics, N per sample, one more than samples.
    pub fn with_slopes(curve: impl Into<Arc<ForceCurve>>, slopes: Vec<f64>) -> ForceCycle {
        let out = ForceCycle::new(curve);
        let cells = Arc::new(cells(&out.curve, slopes));
        ForceCycle {
            cells: OnceLock::from(cells),
            ..out
        }
    }

    /// The cubics between the samples, N.
    pub fn cells(&self) -> &Arc<Cells> {
        let cells = || Arc::new(cells(&self.curve, self.curve.slopes()));
        self.cells.get_or_init(cells)
    }

    /// Mean over the cycle of the squared distance of the cubics from a force, N².
    pub fn mean_square_from(&self, force: f64) -> f64 {
        // The mean of Hermite's cubics over a period is that of the samples.
        let mean = self.mean.mean_n;
        let about_mean = || self.cells().mean_square_from(mean);
        self.mean_square.get_or_init(about_mean) + (force - mean).powi(2)
    }

    /// Its Fourier series, and what laws of its first harmonics leave of it.
    pub fn series(&self) -> &Series {
        self.series.get_or_init(|| Series::of(&self.curve))
    }

    /// The values of [`Cells::nearest`] for these breaks.
    pub fn nearest(&self, breaks: &[f64], degree: usize) -> Arc<[f64]> {
        let is_same = |p: &&Projection| p.degree == degree && p.breaks == breaks;
        if let Ok(kept) = self.projections.lock()
            && let Some(same) = kept.iter().find(is_same)
        {
            return same.values.clone();
        }
        let values: Arc<[f64]> = self.cells().nearest(breaks, degree).into();
        if let Ok(mut kept) = self.projections.lock() {
            if kept.len() >= KEPT_PROJECTIONS {
                kept.clear();
            }
            kept.push(Projection {
                breaks: breaks.to_vec(),
                degree,
                values: values.clone(),
            });
        }
        values
    }
}

/// The cubics between the samples of a force, N.
pub fn cells(force: &ForceCurve, slopes: Vec<f64>) -> Cells {
    let f = &force.force_n;
    let mut ends = Vec::with_capacity(f.len() + 1);
    ends.extend_from_slice(f);
    ends.push(f[0]);
    Cells::new(ends, slopes, TAU)
}

/// A cycle begun at a phase; samples taken elsewhere keep the mean force, which belongs to the whole cycle.
pub fn begun_at(curve: &ForceCurve, phase: f64) -> ForceCurve {
    let begun = curve.begun_at(phase);
    let shift = curve.mean_n() - begun.mean_n();
    ForceCurve {
        force_n: begun.force_n.iter().map(|f| f + shift).collect(),
        ..begun
    }
}

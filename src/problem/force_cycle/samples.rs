//! Samples of a cycle of force. They are given, or computed from a load model when they are needed.

use std::sync::{Arc, OnceLock};

use crate::force::{ForceCurve, FourierForce, SAMPLES};

/// Samples of a cycle of force, or the load model from which they are computed.
#[derive(Debug)]
pub struct Samples {
    /// Fourier series of the load model; `None` if the samples are given.
    series: Option<FourierForce>,
    curve: OnceLock<Arc<ForceCurve>>,
    range_n: OnceLock<[f64; 2]>,
}

impl Samples {
    /// Samples of a given curve.
    pub fn given(curve: Arc<ForceCurve>) -> Samples {
        Samples {
            series: None,
            curve: OnceLock::from(curve),
            range_n: OnceLock::new(),
        }
    }

    /// Samples of a load model.
    pub fn of_series(force: FourierForce) -> Samples {
        Samples {
            series: Some(force),
            curve: OnceLock::new(),
            range_n: OnceLock::new(),
        }
    }

    /// Fourier series of the load model; `None` if the samples are given.
    pub fn series(&self) -> Option<&FourierForce> {
        self.series.as_ref()
    }

    /// The given curve; `None` if the samples are computed from a load model.
    pub fn as_given(&self) -> Option<&Arc<ForceCurve>> {
        self.curve.get().filter(|_| self.series.is_none())
    }

    /// Samples of the force, N, at equal steps over one cycle, starting at the start of the cycle.
    pub fn curve(&self) -> &Arc<ForceCurve> {
        self.curve.get_or_init(|| match &self.series {
            Some(force) => Arc::new(force.curve()),
            None => unreachable!("samples without a series are given"),
        })
    }

    /// Number of samples in one cycle, at equal steps.
    pub fn count(&self) -> usize {
        self.as_given().map_or(SAMPLES, |curve| curve.force_n.len())
    }

    /// Minimum and maximum sample, N.
    pub fn range_n(&self) -> [f64; 2] {
        let range = || self.curve().range_n().into();
        *self.range_n.get_or_init(range)
    }
}

//! The program as the iterations see it, and what they return.

use crate::synth::qp::band::ArrowMatrix;
use crate::synth::qp::double::Number;

/// One row: Σ entries·u against a bound.
pub struct Line<T> {
    pub entries: Vec<(usize, T)>,
    /// The same with usual digits, which is enough for a step.
    pub rounded: Vec<(usize, f64)>,
    pub bound: T,
}

impl<T: Number> Line<T> {
    pub fn new(entries: Vec<(usize, T)>, bound: T) -> Self {
        Line {
            rounded: entries.iter().map(|&(i, a)| (i, a.rounded())).collect(),
            entries,
            bound,
        }
    }

    pub fn of(&self, u: &[T]) -> T {
        let terms = self.entries.iter().map(|&(i, a)| a * u[i]);
        terms.fold(T::of(0.0), |sum, term| sum + term)
    }

    /// Adds `by` times the row to a vector.
    pub fn add_to(&self, out: &mut [T], by: T) {
        for &(i, a) in &self.entries {
            out[i] = out[i] + a * by;
        }
    }
}

/// ½uᵀHu + qᵀu under demands, rows and a cone of three unknowns.
pub struct System<T> {
    pub hessian: ArrowMatrix<T>,
    pub gradient: Vec<T>,
    pub demands: Vec<Line<T>>,
    pub rows: Vec<Line<T>>,
    pub cone: Option<[usize; 3]>,
    /// Size of the objective where unknowns count from.
    pub value: f64,
}

/// Unknowns and multipliers of the rows.
pub struct Found<T> {
    pub unknowns: Vec<T>,
    pub pushes: Vec<f64>,
    pub iterations: usize,
}

//! Basis functions to which the coefficients of a law belong, so that other programs can evaluate the law.

use serde::Serialize;

use crate::synth::qp::Basis;

/// Basis functions, in the order of the coefficients.
///
/// ```
/// use gaitcam::synth::Functions;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // The number of coefficients equals the number of knots per turn.
/// let scene = scene::built_in("footbridge")?.scene()?.with("law.spans", "16")?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let Functions::BSpline { knots } = &design.functions else { panic!() };
/// assert_eq!((knots.len(), design.coefficients.len()), (16, 16));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Functions {
    /// Periodic B-splines: coefficient i belongs to the function on the knots tᵢ … tᵢ₊ₚ₊₁, with tᵢ₊ₙ = tᵢ + 2π. The degree is p, and one
    /// turn has n knots.
    BSpline {
        /// Knots of one turn, rad (`knots_rad` in JSON). Multiple knots are repeated.
        #[serde(rename = "knots_rad")]
        knots: Vec<f64>,
    },
    /// Harmonics 1, cos θ, sin θ, cos 2θ, sin 2θ …
    Fourier,
    /// Powers 1, u, u² … with u from 0 to 1 over a range of angles. Outside this range, the law is constant.
    Monomial {
        /// Range of angles from u = 0 to u = 1, rad (`range_rad` in JSON).
        #[serde(rename = "range_rad")]
        range: [f64; 2],
    },
    /// Parameters of a double harmonic instead of basis functions. Their order is level and lift, m, then start of the rise, angle of the rise
    /// and angle of the fall, rad.
    DoubleHarmonic,
    /// Lifts of the segments of a programme, m (rad for an arm), instead of coefficients of basis functions.
    Segments,
}

impl Functions {
    /// Basis functions of the program that determined the coefficients.
    pub(in crate::synth) fn of(basis: &Basis) -> Self {
        match basis {
            Basis::Spline { space, .. } => Functions::BSpline {
                knots: space.knots(),
            },
            Basis::Harmonic { .. } => Functions::Fourier,
        }
    }

    /// Changes the coefficients so that the lift of the law increases by the constant `by`. Coefficients of segments are unchanged.
    pub(in crate::synth) fn raise(&self, coefficients: &mut [f64], by: f64) {
        match self {
            Functions::BSpline { .. } => coefficients.iter_mut().for_each(|c| *c += by),
            Functions::Fourier | Functions::Monomial { .. } | Functions::DoubleHarmonic => {
                if let Some(mean) = coefficients.first_mut() {
                    *mean += by;
                }
            }
            Functions::Segments => {}
        }
    }
}

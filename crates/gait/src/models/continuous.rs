//! Published models of the force of both feet together, as Fourier series whose coefficients depend on the step frequency.

use std::f64::consts::{FRAC_PI_2, PI};

/// Amplitude, as a fraction of the weight, and phase, rad, of each harmonic of a model. The phase is added to the argument of the sine.
pub(super) type Harmonics = Vec<(f64, f64)>;

/// Amplitudes and phases of the continuous models at the step frequency `f`, Hz.
pub(super) fn harmonics(name: &str, f: f64) -> Harmonics {
    let in_phase = |amplitudes: &[f64]| amplitudes.iter().map(|&a| (a, 0.0)).collect();
    let lagging = |a1: f64| vec![(a1, 0.0), (0.1, -FRAC_PI_2), (0.1, -FRAC_PI_2)];
    match name {
        "blanchard" => in_phase(&[180.0 / 700.0]),
        "bachmann" => lagging((0.4 + 0.25 * (f - 2.0)).clamp(0.4, 0.5)),
        "setra" => lagging(0.4),
        "rebelo" => {
            let a2 = if f > 1.5 { 0.15 * f - 0.125 } else { 0.0 };
            in_phase(&[0.43 * f - 0.38, a2, 0.1])
        }
        "kerr" => {
            let a1 = ((-0.2649 * f + 1.3206) * f - 1.7597) * f + 0.7613;
            in_phase(&[a1, 0.07, 0.05])
        }
        "young" => cresting_together([
            (0.37 * (f - 0.95)).min(0.5),
            0.054 + 0.0044 * 2.0 * f,
            0.026 + 0.0050 * 3.0 * f,
            0.010 + 0.0051 * 4.0 * f,
        ]),
        "young-design" => cresting_together([
            (0.41 * (f - 0.95)).min(0.56),
            0.069 + 0.0056 * 2.0 * f,
            0.033 + 0.0064 * 3.0 * f,
            0.013 + 0.0065 * 4.0 * f,
        ]),
        "sci-p354" => cresting_together([
            0.436 * (f - 0.95),
            0.006 * (2.0 * f + 12.3),
            0.007 * (3.0 * f + 5.2),
            0.007 * (4.0 * f + 2.0),
        ]),
        // `iso-10137` is the only remaining model.
        _ => in_phase(&[0.37 * (f - 1.0), 0.1, 0.06, 0.06, 0.06]),
    }
}

/// Phases 0, −π/2, π, π/2 of SCI P354. With these phases, all four harmonics are cosines of the time after a quarter of the step, so their
/// maxima coincide at this time.
fn cresting_together(amplitudes: [f64; 4]) -> Harmonics {
    let phases = [0.0, -FRAC_PI_2, PI, FRAC_PI_2];
    amplitudes.into_iter().zip(phases).collect()
}

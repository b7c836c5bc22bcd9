//! Polydyne (splinedyne) cams: the lift under which the output of a compliant follower follows a target law.
//!
//! The end y of a follower of mass m on a train of stiffness k₁ and damping c₁ obeys
//!
//! ```text
//! F(y) = F₀ + k y + c ẏ + m ÿ = k₁ (s − y) + c₁ (ṡ − ẏ)
//! ```
//!
//! so the deflection x = s − y follows from the target y by x + τ x′ = F(y)/k₁, τ = c₁ω/k₁. Without damping
//! that is algebra: s = y + F(y)/k₁. With it the steady answer is the series
//! x = (F − τF′ + τ²F″ − …)/k₁, of which as many terms are taken as the target has continuous
//! derivatives for; a sinusoid of frequency r has the whole of it, 1/(1 + i r τ). Source: Dudley's polydyne
//! relation, y and s in the letters of [`super`].

use super::Train;
use crate::drive::Drive;
use crate::dynamics::flexible;
use crate::error::{DynamicsError, Result};
use crate::law::{Law, Wave};
use crate::poly::{Extreme, PiecewisePoly, bernstein};
use crate::units::Quantity;
use serde::Serialize;

/// Terms of the damping's series beyond the first; each needs one more continuous derivative.
const MOST_TERMS: usize = 4;
/// A jump below this part of the derivative's size is rounding; high derivatives of a spline carry much.
const ROUNDING: f64 = 1e-6;
/// Angles of one cycle at which the run of the finished cam is compared with the target.
const COMPARED: usize = 720;

/// Law of the cam under which the output of a compliant follower follows `target` at the drive's speed.
///
/// The constant F₀/k₁, the static deflection under the rest force, is part of the lift.
///
/// # Errors
/// Invalid stiffness or damping, an open law, a target law with a jump in one of its
/// first four derivatives (without mass fewer count): the cam's acceleration would jump there.
pub fn polydyne(target: &Law, drive: &Drive, train: &Train) -> Result<Law> {
    train.check()?;
    let Train { stiffness, damping } = *train;
    if !target.is_closed() {
        return Err(DynamicsError::OpenPolydyne.into());
    }
    let weights = drive.weights();
    // The cam's acceleration takes two derivatives more than the force does.
    let needed = 2 + weights.iter().rposition(|w| *w != 0.0).unwrap_or(0);
    let (smooth, broken_at) = continuous_derivatives(target, needed + MOST_TERMS);
    if smooth < needed {
        let derivative = [
            "lift",
            "velocity",
            "acceleration",
            "jerk",
            "fourth derivative",
        ][smooth + 1];
        return Err(DynamicsError::PolydyneJump {
            derivative,
            at: Quantity::angle(broken_at),
        }
        .into());
    }
    let lag = damping * drive.speed / stiffness;
    let terms = if lag > 0.0 { smooth - needed } else { 0 };
    let alpha = series(&weights, stiffness, lag, terms);
    let rest = drive.rest_force / stiffness;
    let poly = target.poly();
    let one_piece = poly.pieces() == 1 && poly.degree() == 0;
    let gain = |rate: f64| {
        if one_piece {
            whole_gain(rate, drive, stiffness, damping)
        } else {
            series_gain(rate, &alpha)
        }
    };
    let mut order = poly.clone();
    let mut sum = PiecewisePoly::combine(&[(alpha[0], poly)], rest);
    for a in &alpha[1..] {
        order = order.derivative();
        sum = PiecewisePoly::combine(&[(1.0, &sum), (*a, &order)], 0.0);
    }
    let waves: Vec<Vec<Wave>> = (0..poly.pieces())
        .map(|i| {
            let passed = |w: &Wave| passed(w, gain(w.rate));
            target.waves(i).iter().map(passed).collect()
        })
        .collect();
    Ok(Law::with_waves(sum, waves, true))
}

/// Coefficients αₙ of s = Σ αₙ dⁿy/dθⁿ, with so many terms of the damping's series.
fn series(weights: &[f64; 4], stiffness: f64, lag: f64, terms: usize) -> Vec<f64> {
    let mut alpha = vec![0.0; 3 + terms];
    for i in 0..=terms {
        let factor = (-lag).powi(i as i32) / stiffness;
        for (j, w) in weights[..3].iter().enumerate() {
            alpha[i + j] += factor * w;
        }
    }
    alpha[0] += 1.0;
    alpha
}

/// s over y for e^{irθ}: 1 + (k − m r²ω² + i r c ω)/(k₁ + i r c₁ ω), real and imaginary part.
fn whole_gain(rate: f64, drive: &Drive, stiffness: f64, damping: f64) -> (f64, f64) {
    let [k, c, m, _] = drive.weights();
    let (re, im) = (k - m * rate * rate, c * rate);
    let lag = damping * drive.speed * rate;
    let square = stiffness * stiffness + lag * lag;
    (
        1.0 + (re * stiffness + im * lag) / square,
        (im * stiffness - re * lag) / square,
    )
}

/// Σ αₙ (i r)ⁿ.
fn series_gain(rate: f64, alpha: &[f64]) -> (f64, f64) {
    let mut gain = (0.0, 0.0);
    for a in alpha.iter().rev() {
        // gain·(i r) + a
        gain = (a - gain.1 * rate, gain.0 * rate);
    }
    gain
}

/// A sinusoid passed through a complex gain.
fn passed(wave: &Wave, (re, im): (f64, f64)) -> Wave {
    Wave {
        rate: wave.rate,
        cos: re * wave.cos + im * wave.sin,
        sin: re * wave.sin - im * wave.cos,
    }
}

/// How many derivatives of a closed law are continuous (0: the lift alone, looked at up to `most`), and
/// where the next one jumps. A law whose lift jumps counts as if its velocity did.
fn continuous_derivatives(law: &Law, most: usize) -> (usize, f64) {
    let mut poly = law.poly().clone();
    let breaks = poly.breaks().to_vec();
    let pieces = poly.pieces();
    for order in 0..=most {
        let wave = |i: usize, x: f64| -> f64 {
            let turned = order as f64 * std::f64::consts::FRAC_PI_2;
            law.waves(i)
                .iter()
                .map(|w| {
                    let phase = w.rate * x + turned;
                    w.rate.powi(order as i32) * (w.cos * phase.cos() + w.sin * phase.sin())
                })
                .sum()
        };
        let ends = |i: usize| {
            let b = poly.piece(i);
            let width = breaks[i + 1] - breaks[i];
            (b[0] + wave(i, 0.0), b[b.len() - 1] + wave(i, width))
        };
        let size = (0..pieces)
            .map(|i| {
                let (low, high) = bernstein::hull(poly.piece(i));
                let rate = |w: &Wave| w.rate.powi(order as i32) * w.cos.hypot(w.sin);
                low.abs().max(high.abs()) + law.waves(i).iter().map(rate).sum::<f64>()
            })
            .fold(0.0, f64::max);
        let jump = |i: usize| (ends(i).0 - ends((i + pieces - 1) % pieces).1).abs();
        if let Some(i) = (0..pieces).find(|&i| jump(i) > ROUNDING * size) {
            return (order.saturating_sub(1), breaks[i]);
        }
        poly = poly.derivative();
    }
    (most, breaks[0])
}

/// Deviation of a compliant follower's output from its target.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synthesise;
///
/// // A polydyne cam has a smaller deviation than the target law itself as cam.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let scene = scene.with("machine.natural_frequency", "12 Hz")?.with("law.degree", "7")?.with("law.polydyne", "true")?;
/// let end = synthesise(&scene, scene.model_force()?.as_ref())?.end.unwrap();
/// assert!(end.miss.unwrap().force_rms < 0.1 * end.plain_miss.unwrap().force_rms);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Miss {
    /// Force handed on minus the force of the target law: root mean square, N.
    pub force_rms: f64,
    /// The same, largest, N.
    pub force_max: f64,
    /// Largest deviation of the output from the target without the constant part, m, and its angle.
    pub lift: Extreme,
}

/// Compares the exact steady motion under `cam` with the target of the output, at equal steps of the angle.
///
/// # Errors
/// Fails where the run has no steady state (see [`flexible::steady`]).
pub fn end_error(cam: &Law, target: &Law, drive: &Drive, train: &Train) -> Result<Miss> {
    let steady = flexible::steady(&finely(cam), drive, train)?;
    let (start, length) = cam.extent();
    let (mut square, mut largest) = (0.0, 0.0_f64);
    let mut apart = Vec::with_capacity(COMPARED);
    let step = length / COMPARED as f64;
    let mut k = 0;
    for i in 0..COMPARED {
        let at = start + step * i as f64;
        while k + 1 < steady.theta.len() && steady.theta[k] < at - 1e-9 {
            k += 1;
        }
        let (given, asked) = (cam.svaj(at), target.svaj(at));
        let force = (steady.output[k] - drive.force(asked)).abs();
        square += force * force;
        largest = largest.max(force);
        apart.push(given.s + steady.deflection[k] - asked.s);
    }
    let level = apart.iter().sum::<f64>() / COMPARED as f64;
    let lift = (0..COMPARED)
        .map(|i| Extreme {
            at: start + step * i as f64,
            value: (apart[i] - level).abs(),
        })
        .max_by(|a, b| a.value.total_cmp(&b.value));
    Ok(Miss {
        force_rms: (square / COMPARED as f64).sqrt(),
        force_max: largest,
        lift: lift.unwrap_or(Extreme {
            at: start,
            value: 0.0,
        }),
    })
}

/// The same law with the angles that are compared among its breaks.
fn finely(law: &Law) -> Law {
    let (start, length) = law.extent();
    // A piece as wide as a rounding error has no derivative.
    let new = |x: &f64| law.breaks().iter().all(|b| (b - x).abs() > 1e-9 * length);
    let further: Vec<f64> = (1..COMPARED)
        .map(|i| start + length * i as f64 / COMPARED as f64)
        .filter(new)
        .collect();
    let poly = law.poly().cut_at(&further);
    let waves: Vec<Vec<Wave>> = (0..poly.pieces())
        .map(|i| {
            let middle = 0.5 * (poly.breaks()[i] + poly.breaks()[i + 1]);
            let (own, _) = law.poly().locate(middle);
            let later = poly.breaks()[i] - law.breaks()[own];
            law.waves(own).iter().map(|w| w.from(later)).collect()
        })
        .collect();
    Law::with_waves(poly, waves, law.is_closed())
}

#[cfg(test)]
mod tests;

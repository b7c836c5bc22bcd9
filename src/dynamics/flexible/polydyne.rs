//! Polydyne (splinedyne) cams: the lift for which the end of a compliant follower follows a target law.
//!
//! The end y of a follower of mass m on a train of stiffness k₁ and damping c₁ obeys
//!
//! ```text
//! F(y) = F₀ + k y + c ẏ + m ÿ = k₁ (s − y) + c₁ (ṡ − ẏ)
//! ```
//!
//! so the deflection x = s − y follows from the target y by x + τ x′ = F(y)/k₁, τ = c₁ω/k₁. Without damping, this equation is algebraic: s
//! = y + F(y)/k₁. If the target is a sum of sinusoids, each sinusoid of F(y)/k₁ with frequency r is multiplied by 1/(1 + i r τ). In all
//! other cases, x and its first three derivatives are computed at the breaks of F in the periodic steady state. The derivatives of x obey
//! the same equation with the derivatives of F. Polynomials of degree 7 interpolate between the breaks. Source: Dudley's polydyne relation,
//! with the symbols of [`super`].

use super::Train;
use super::linear::{Linear, Matrix2, Vector2};
use crate::drive::Drive;
use crate::dynamics::flexible;
use crate::error::{DynamicsError, Result};
use crate::law::{Law, Wave};
use crate::poly::{Extreme, PiecewisePoly};
use crate::units::Quantity;
use serde::Serialize;
use std::f64::consts::TAU;

/// Maximum number of parts into which a span is divided to represent its transients. The length of each part is at most the lag of the
/// damping, unless this number is reached.
const MOST_PARTS: f64 = 16.0;
/// Maximum length of a part of a span, rad. On this length a polynomial of degree 7 approximates a sinusoid of rate 20 to 1e-10.
const LONGEST_PART: f64 = TAU / 180.0;
/// Lag τ = c₁ω/k₁, rad, below which the train counts as undamped.
const INSTANT: f64 = 1e-8;
/// Fraction of the bound of a derivative below which its jumps count as rounding errors.
const ROUNDING: f64 = 1e-6;
/// Number of angles per cycle at which the motion of the follower end is compared with the target.
const COMPARED: usize = 720;

/// Law of the cam for which the end of a compliant follower follows `target` at the speed of the drive.
///
/// The lift includes the constant F₀/k₁, which is the static deflection by the rest force.
///
/// # Errors
///
/// Invalid stiffness or damping; an open law; a target law with a jump in one of its first four derivatives (fewer without mass). Such a
/// jump would cause a jump in the acceleration of the cam.
pub fn polydyne(target: &Law, drive: &Drive, train: &Train) -> Result<Law> {
    train.check()?;
    let Train { stiffness, damping } = *train;
    if !target.is_closed() {
        return Err(DynamicsError::OpenPolydyne.into());
    }
    let weights = drive.weights();
    // The acceleration of the cam requires two more derivatives than the force.
    let needed = 2 + weights.iter().rposition(|w| *w != 0.0).unwrap_or(0);
    let (smooth, broken_at) = continuous_derivatives(target, needed);
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
    let poly = target.poly();
    let is_sum_of_sinusoids = poly.pieces() == 1 && poly.degree() == 0;
    if lag > INSTANT && !is_sum_of_sinusoids {
        return lagging(target, drive, train, lag);
    }
    let first = poly.derivative();
    let second = first.derivative();
    let [k, c, m] = [0, 1, 2].map(|order| weights[order] / stiffness);
    let terms = [(1.0 + k, poly), (c, &first), (m, &second)];
    let sum = PiecewisePoly::combine(&terms, drive.rest_force / stiffness);
    let passed = |w: &Wave| passed(w, gain(w.rate, drive, stiffness, damping));
    let waves = (0..poly.pieces()).map(|i| target.waves(i).iter().map(passed).collect());
    Ok(Law::with_waves(sum, waves.collect(), true))
}

/// Sum of the target and the deflection of a damped train. The deflection has degree 7 between the breaks of the force.
fn lagging(target: &Law, drive: &Drive, train: &Train, lag: f64) -> Result<Law> {
    let mut cuts = Vec::new();
    for ends in target.breaks().windows(2) {
        let width = ends[1] - ends[0];
        let for_transients = (width / lag).min(MOST_PARTS);
        let parts = for_transients.max(width / LONGEST_PART).ceil() as usize;
        cuts.extend((1..parts).map(|i| ends[0] + width * i as f64 / parts as f64));
    }
    let mut force = drive.force_curve(target).cut_at(&cuts);
    let breaks = force.breaks().to_vec();
    let linear = Linear {
        rates: Matrix2::new(-1.0 / lag, 0.0, 0.0, -1.0),
        input: Vector2::new(1.0 / (lag * train.stiffness), 0.0),
    };
    let mut orders = Vec::with_capacity(4);
    for _ in 0..4 {
        let states = linear.periodic(&force, |_| Vector2::zeros());
        orders.push(states.ok_or_else(|| flexible::resonance(drive, train))?);
        force = force.derivative();
    }
    let at = |i: usize| [0, 1, 2, 3].map(|order| orders[order][i][0]);
    let pieces =
        (0..breaks.len() - 1).flat_map(|i| hermite(breaks[i + 1] - breaks[i], at(i), at(i + 1)));
    let deflection = PiecewisePoly::new(breaks.clone(), 7, pieces.collect());
    let cut = cut_at(target, &breaks[1..breaks.len() - 1]);
    let deflection = deflection.cut_at(cut.breaks());
    let sum = PiecewisePoly::combine(&[(1.0, cut.poly()), (1.0, &deflection)], 0.0);
    let waves = (0..cut.poly().pieces()).map(|i| cut.waves(i).to_vec());
    Ok(Law::with_waves(sum, waves.collect(), true))
}

/// Bernstein coefficients of degree 7 from value and three derivatives at both ends of a span.
fn hermite(width: f64, start: [f64; 4], end: [f64; 4]) -> [f64; 8] {
    let from = |[s, v, a, j]: [f64; 4], width: f64| {
        let first = s + width * v / 7.0;
        let second = 2.0 * first - s + width * width * a / 42.0;
        let third = 3.0 * (second - first) + s + width.powi(3) * j / 210.0;
        [s, first, second, third]
    };
    let ([a, b, c, d], [h, g, f, e]) = (from(start, width), from(end, -width));
    [a, b, c, d, e, f, g, h]
}

/// Complex ratio of the cam's lift s to the motion y of the follower end for e^{irθ}, as real and imaginary part. The ratio is 1 + (k − m
/// r²ω² + i r c ω)/(k₁ + i r c₁ ω).
fn gain(rate: f64, drive: &Drive, stiffness: f64, damping: f64) -> (f64, f64) {
    let [k, c, m, _] = drive.weights();
    let (re, im) = (k - m * rate * rate, c * rate);
    let lag = damping * drive.speed * rate;
    let square = stiffness * stiffness + lag * lag;
    (
        1.0 + (re * stiffness + im * lag) / square,
        (im * stiffness - re * lag) / square,
    )
}

/// A sinusoid multiplied by a complex gain.
fn passed(wave: &Wave, (re, im): (f64, f64)) -> Wave {
    Wave {
        rate: wave.rate,
        cos: re * wave.cos + im * wave.sin,
        sin: re * wave.sin - im * wave.cos,
    }
}

/// Number of continuous derivatives of a closed law (0: only the lift), up to `most`, and the angle at which the next derivative jumps. A jump of the
/// lift counts as a jump of the velocity.
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
                    w.rate.powi(order as i32)
                        * (w.cos * libm::cos(phase) + w.sin * libm::sin(phase))
                })
                .sum()
        };
        let ends = |i: usize| {
            let b = poly.piece(i);
            let width = breaks[i + 1] - breaks[i];
            (b[0] + wave(i, 0.0), b[b.len() - 1] + wave(i, width))
        };
        let size = law.bound(order);
        let jump = |i: usize| (ends(i).0 - ends((i + pieces - 1) % pieces).1).abs();
        if let Some(i) = (0..pieces).find(|&i| jump(i) > ROUNDING * size) {
            return (order.saturating_sub(1), breaks[i]);
        }
        poly = poly.derivative();
    }
    (most, breaks[0])
}

/// Deviation of the end of a compliant follower from its target law.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // A polydyne cam has a smaller deviation than a cam whose lift is the target law.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let scene = scene.with("machine.natural_frequency", "12 Hz")?.with("law.degree", "7")?.with("law.polydyne", "true")?;
/// let end = synthesise(&scene, scene.model_force()?.as_ref())?.end.unwrap();
/// assert!(end.miss.unwrap().force_rms < 0.1 * end.plain_miss.unwrap().force_rms);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Miss {
    /// Root mean square difference between the transmitted force and the force of the target law, N.
    pub force_rms: f64,
    /// Maximum absolute difference between the transmitted force and the force of the target law, N.
    pub force_max: f64,
    /// Maximum absolute deviation of the end from the target after subtraction of the mean deviation, m, and its angle.
    pub lift: Extreme,
}

/// Compares the exact steady motion of the follower end on the cam `cam` with its target, at equal steps of the angle.
///
/// # Errors
///
/// There is no steady state (see [`flexible::steady`]).
pub fn end_error(cam: &Law, target: &Law, drive: &Drive, train: &Train) -> Result<Miss> {
    let steady = flexible::steady(&finely(cam), drive, train)?;
    let (start, length) = cam.extent();
    let (mut square, mut largest) = (0.0, 0.0_f64);
    let mut apart = Vec::with_capacity(COMPARED);
    let step = length / COMPARED as f64;
    let last = steady.theta.len() - 1;
    for i in 0..COMPARED {
        let at = start + step * i as f64;
        let k = steady.theta.partition_point(|t| *t < at - 1e-9).min(last);
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

/// The law with additional breaks at the angles of the comparison.
fn finely(law: &Law) -> Law {
    let (start, length) = law.extent();
    let compared = (1..COMPARED).map(|i| start + length * i as f64 / COMPARED as f64);
    cut_at(law, &compared.collect::<Vec<_>>())
}

/// The law with additional breaks at `further`, except at angles that coincide with a break of the law up to rounding errors. The
/// derivatives on the resulting very short spans would be inaccurate.
fn cut_at(law: &Law, further: &[f64]) -> Law {
    let (_, length) = law.extent();
    let new = |x: &f64| law.breaks().iter().all(|b| (b - x).abs() > 1e-9 * length);
    let further: Vec<f64> = further.iter().copied().filter(new).collect();
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

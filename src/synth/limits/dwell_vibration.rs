//! Limit on the residual vibration in a dwell (theory §10).
//!
//! The state (q, p) of the vibration at the start of a dwell is linear in the law. The length of the vector (q, p) is the amplitude. If the
//! law without the limit has a larger amplitude, the disc |(q, p)| ≤ limit is replaced by its tangents. The finished cam is checked with the
//! simulation model.

use std::f64::consts::TAU;

use super::finished::Finished;
use crate::cam::{Check, LimitKind};
use crate::dynamics::flexible::in_rests;
use crate::dynamics::flexible::polydyne::end_error;
use crate::law::Law;
use crate::poly::{Extreme, Peak, gauss_legendre};
use crate::problem::Problem;
use crate::synth::qp::{Basis, Entries, Row, TOLERANCE, apply};

/// Relative violation below which the limit counts as satisfied.
const SLACK: f64 = 1e-6;
/// Minimum scale of a violation, as a fraction of the deflections. The vibration is a difference of deflections and contains the rounding
/// errors of the deflections.
const CANCELLED: f64 = 1e-4;

/// Check of the residual vibration of the finished cam. For a polydyne cam, the deviation of the follower's end from its law is checked.
pub fn check(design: &Finished) -> Option<Check> {
    let problem = design.problem;
    let limit = problem.limits[LimitKind::Residual]?;
    let worst = match problem.train() {
        Ok(Some(train)) if problem.law.polydyne => {
            let miss = end_error(&design.cam.law, design.pressing, &problem.drive, &train);
            miss.ok().map(|m| m.lift)
        }
        _ => left_over(problem, &design.cam.law),
    };
    Some(Check::of(LimitKind::Residual, worst?, limit, SLACK))
}

/// Maximum amplitude of the residual vibration in the dwells, m, with the start of the dwell; infinite without a steady state. `None` without
/// dwells or a compliant follower.
fn left_over(problem: &Problem, law: &Law) -> Option<Extreme> {
    let train = problem.train().ok()??;
    let starts: Vec<f64> = problem.rests().iter().map(|r| r.0).collect();
    let amplitudes = in_rests(law, &problem.drive, &train, &starts);
    let amplitudes = amplitudes.unwrap_or_else(|_| vec![f64::INFINITY; starts.len()]);
    (starts.into_iter().zip(amplitudes))
        .map(|(at, value)| Extreme { at, value })
        .max_by(|a, b| a.value.total_cmp(&b.value))
}

/// Determinant det(1 − e^{2πA}) below which the free vibration is at an undamped resonance.
const RESONANCE: f64 = 1e-11;

/// Intervals of motion between consecutive dwells, rad. An interval or dwell across the end of the turn continues above 2π.
fn motions(rests: &[(f64, f64)]) -> Vec<(f64, f64)> {
    (0..rests.len())
        .map(|k| {
            let from = rests[k].1;
            let last = k + 1 == rests.len();
            let to = if last {
                rests[0].0 + TAU
            } else {
                rests[k + 1].0
            };
            // A dwell across the end of the turn ends in the next turn.
            if from < rests[k].0 {
                (from + TAU, to)
            } else {
                (from, to)
            }
        })
        .collect()
}

/// Free vibration of the follower as a function of the angle. Over the angle φ, the state (q, p) = (1, 0) becomes (C + ζS, −S) with the
/// functions C and S of `waves`.
struct Free {
    /// Frequency ratio r = √(K/m)/ω.
    rate: f64,
    /// Damping ratio ζ of all dampers together.
    damping: f64,
}

impl Free {
    /// Functions C = e^{−ζrφ} cos(√(1 − ζ²) rφ) and S = e^{−ζrφ} sin(√(1 − ζ²) rφ)/√(1 − ζ²) of the angle φ. For ζ = 1 they are the limits of
    /// these expressions. For ζ > 1, cosh and sinh replace cos and sin.
    fn waves(&self, angle: f64) -> [f64; 2] {
        let (z, x) = (self.damping, self.rate * angle);
        let square = 1.0 - z * z;
        let root = square.abs().sqrt();
        if root * x < 1e-8 {
            return [1.0, x].map(|w| w * libm::exp(-z * x));
        }
        if square > 0.0 {
            let (sin, cos) = libm::sincos(root * x);
            return [cos, sin / root].map(|w| w * libm::exp(-z * x));
        }
        let (slow, fast) = (libm::exp((root - z) * x), libm::exp((-root - z) * x));
        [0.5 * (slow + fast), 0.5 * (slow - fast) / root]
    }

    /// State transition matrix e^{A φ} over the angle φ, with A = r (0 1; −1 −2ζ).
    fn carried(&self, angle: f64) -> [[f64; 2]; 2] {
        let ([c, s], z) = (self.waves(angle), self.damping);
        [[c + z * s, s], [-s, c - z * s]]
    }
}

/// Vibrations at the starts of the dwells in the steady state. Each vibration consists of a row for q and a row for p. The product of a row
/// and the coefficients of a law is the value of q or p.
pub struct Vibrations {
    rests: Vec<(f64, f64)>,
    rows: Vec<[Vec<f64>; 2]>,
    limit: f64,
}

impl Vibrations {
    /// Vibrations of a problem and their limit; `None` without a limit, a dwell or a compliant follower. A polydyne cam has no such vibration,
    /// because the follower's end is at rest where its law is at rest.
    pub fn of(problem: &Problem, basis: &Basis) -> Option<Vibrations> {
        let limit = problem.limits[LimitKind::Residual].filter(|_| !problem.law.polydyne)?;
        let (train, rests) = (problem.train().ok()??, problem.rests());
        let drive = &problem.drive;
        if rests.is_empty() || drive.mass <= 0.0 {
            return None;
        }
        let stiffness = train.stiffness + drive.spring_rate;
        let inertia = drive.mass * drive.speed * drive.speed;
        let free = Free {
            rate: (stiffness / inertia).sqrt(),
            damping: 0.5 * (train.damping + drive.damping) / (stiffness * drive.mass).sqrt(),
        };
        let [k, c, m, _] = drive.weights();
        // During a motion, q increases by F′/K per angle, because the static deflection changes.
        let gained = [0.0, k, c, m].map(|w| w / stiffness);
        let own: Vec<[Vec<f64>; 2]> = (motions(&rests).into_iter())
            .map(|motion| of_motion(basis, motion, &free, &gained))
            .collect();
        let rows = steady(&rests, own, &free);
        Some(Vibrations { rests, rows, limit })
    }

    /// Tangents of the discs |(q, p)| ≤ limit as rows of the program, for each dwell in which the law with coefficients `x` exceeds the limit.
    pub fn tangents(&self, x: &[f64]) -> Vec<Row> {
        let sum = |row: &[f64]| row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
        let mut out = Vec::new();
        for (k, [q, p]) in self.rows.iter().enumerate() {
            let state = [sum(q), sum(p)];
            let length = libm::hypot(state[0], state[1]);
            let size = |row: &[f64]| row.iter().zip(x).map(|(a, x)| (a * x).abs()).sum::<f64>();
            let scale = self.limit.max(CANCELLED * size(q).max(size(p)));
            if length <= self.limit + TOLERANCE * scale {
                continue;
            }
            let normal = state.map(|s| s / length);
            let entries: Entries = (q.iter().zip(p).enumerate())
                .map(|(i, (q, p))| (i, normal[0] * q + normal[1] * p))
                .filter(|e| e.1 != 0.0)
                .collect();
            debug_assert!((apply(&entries, x) - length).abs() <= 1e-6 * length);
            let (name, place) = (
                LimitKind::Residual.into(),
                Peak::place(0, 0.0, self.rests[k].0),
            );
            out.push(Row {
                scale,
                ..Row::of_no_limit(name, place, entries, self.limit)
            });
        }
        out
    }
}

/// Vibration after one interval of motion that begins at rest: (q, p) = ∫ e^{A(θ₁ − θ)} (1, 0) F′(θ)/K dθ, as rows over the coefficients.
/// θ₁ is the end of the interval, F′ the derivative of the static force, and K the total stiffness. The matrix A is defined at `carried`.
fn of_motion(basis: &Basis, motion: (f64, f64), free: &Free, gained: &[f64; 4]) -> [Vec<f64>; 2] {
    let mut out = [vec![0.0; basis.columns()], vec![0.0; basis.columns()]];
    for (theta, weight) in quadrature(&basis.breaks(), motion, free.rate) {
        let [[q, _], [p, _]] = free.carried(motion.1 - theta);
        for (i, x) in basis.row(theta, gained) {
            out[0][i] += weight * q * x;
            out[1][i] += weight * p * x;
        }
    }
    out
}

/// Angles and weights of a quadrature for ∫ f(θ) e^{irθ} dθ over one interval of motion. The spans are divided into parts of at most one radian
/// of phase rθ. Each part has eight Gauss points, which give an accuracy of 1e-14 for the degrees used here.
fn quadrature(breaks: &[f64], (from, to): (f64, f64), rate: f64) -> Vec<(f64, f64)> {
    let gauss = gauss_legendre(8);
    let mut cuts: Vec<f64> = (breaks.iter())
        .flat_map(|b| [*b, b + TAU])
        .filter(|b| *b > from && *b < to)
        .collect();
    cuts.extend([from, to]);
    cuts.sort_by(f64::total_cmp);
    let mut out = Vec::new();
    for pair in cuts.windows(2).filter(|w| w[1] - w[0] > 1e-12) {
        let parts = ((pair[1] - pair[0]) * rate).ceil().max(1.0) as usize;
        let width = (pair[1] - pair[0]) / parts as f64;
        for p in 0..parts {
            let places = gauss.iter();
            out.extend(places.map(|(x, w)| (pair[0] + (p as f64 + x) * width, w * width)));
        }
    }
    out
}

/// Vibrations z = (q, p) at the starts of the dwells in the steady state, from zₖ = e^{A(θₖ − θₖ₋₁)} zₖ₋₁ + rₖ around the turn. Dwell k
/// starts at θₖ, and rₖ is the vibration that the motion before this dwell causes from rest. At an undamped resonance there is no steady
/// state, and the vibration after each interval of motion from rest is returned.
fn steady(rests: &[(f64, f64)], own: Vec<[Vec<f64>; 2]>, free: &Free) -> Vec<[Vec<f64>; 2]> {
    let n = rests.len();
    // own[k] is the vibration at the start of dwell k + 1.
    let end = |k: usize| (k + 1) % n;
    let apart = |k: usize| {
        let turn = if k + 1 == n { TAU } else { 0.0 };
        rests[end(k)].0 + turn - rests[k].0
    };
    let moved = |m: &[[f64; 2]; 2], z: &[Vec<f64>; 2]| -> [Vec<f64>; 2] {
        [0, 1].map(|i| {
            let both = z[0].iter().zip(&z[1]);
            both.map(|(q, p)| m[i][0] * q + m[i][1] * p).collect()
        })
    };
    let add = |to: &mut [Vec<f64>; 2], more: &[Vec<f64>; 2]| {
        for (to, more) in to.iter_mut().zip(more) {
            to.iter_mut().zip(more).for_each(|(a, b)| *a += b);
        }
    };
    // Vibration after one turn that begins at rest at the start of dwell 0.
    let mut around = [vec![0.0; own[0][0].len()], vec![0.0; own[0][0].len()]];
    for (k, left) in own.iter().enumerate() {
        around = moved(&free.carried(apart(k)), &around);
        add(&mut around, left);
    }
    let turn = free.carried(TAU);
    let [[a, b], [c, d]] = [
        [1.0 - turn[0][0], -turn[0][1]],
        [-turn[1][0], 1.0 - turn[1][1]],
    ];
    let determinant = a * d - b * c;
    let mut out = vec![[Vec::new(), Vec::new()]; n];
    if determinant.abs() < RESONANCE {
        for (k, left) in own.into_iter().enumerate() {
            out[end(k)] = left;
        }
        return out;
    }
    let inverse = [[d, -b], [-c, a]].map(|row| row.map(|x| x / determinant));
    let mut state = moved(&inverse, &around);
    for (k, left) in own.iter().enumerate() {
        out[k] = state.clone();
        state = moved(&free.carried(apart(k)), &state);
        add(&mut state, left);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_free_vibration_solves_its_equation_at_every_damping() {
        // X′ = A X with A = r (0 1; −1 −2ζ) and X(0) = 1, by central differences.
        for damping in [0.0, 0.3, 0.999, 1.0, 1.001, 2.5] {
            let free = Free { rate: 3.0, damping };
            let [r, h] = [free.rate, 1e-5];
            assert_eq!(free.carried(0.0), [[1.0, 0.0], [0.0, 1.0]]);
            for angle in [0.2, 0.9, 2.0] {
                let [before, now, after] = [-h, 0.0, h].map(|d| free.carried(angle + d));
                for k in 0..2 {
                    let (q, p) = (now[0][k], now[1][k]);
                    let slopes = [r * p, -r * (q + 2.0 * damping * p)];
                    for (i, slope) in slopes.into_iter().enumerate() {
                        let found = (after[i][k] - before[i][k]) / (2.0 * h);
                        assert!(
                            (found - slope).abs() < 1e-7,
                            "{damping} {angle}: {found} {slope}"
                        );
                    }
                }
            }
        }
    }
}

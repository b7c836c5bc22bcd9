//! Projection of a force onto double harmonics. For given angles, lift and level follow in closed form.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Complex;

use crate::drive::Drive;
use crate::poly::{Cells, amplitudes};

/// Number of samples of the force from which its harmonics are computed.
const SAMPLES: usize = 512;
/// Maximum number of harmonics of the force in the projection.
const HARMONICS: usize = 64;
/// Fraction of the force below which an amplitude is a rounding error.
const ROUNDING: f64 = 1e-9;
/// Maximum number of force harmonics that are used in the search for the initial angles.
const COARSE: usize = 32;
/// Number of grid steps per turn in the search for the initial angles.
const STEPS: usize = 96;
/// Angle h, rad, below which sin h / h is computed as 1 − h²/6.
const SMALL: f64 = 1e-4;
/// Powers i⁰, i¹ and i² of the imaginary unit, which rotate by 0°, 90° and 180°.
const QUARTERS: [Complex<f64>; 3] = [
    Complex::new(1.0, 0.0),
    Complex::new(0.0, 1.0),
    Complex::new(-1.0, 0.0),
];

/// Start of the rise, and angles of rise and fall, rad.
pub(super) type Angles = [f64; 3];

/// Harmonics of the target force minus the force at rest, and the weights of lift, velocity and acceleration in the force of a drive.
pub(super) struct Projection {
    /// Complex harmonics a − ib of the force terms a cos kθ + b sin kθ, k = 1, 2, …
    waves: Vec<Complex<f64>>,
    mean: f64,
    square: f64,
    /// Weights of lift, velocity and acceleration in the force.
    weights: [f64; 3],
    stroke: f64,
}

/// Best double harmonic for given angles, with its error.
pub(super) struct Nearest {
    /// Lift of the rise, m, at most the stroke; negative if the law falls first.
    pub lift: f64,
    /// Level of the dwell, m; 0 if the force does not depend on the level.
    pub level: f64,
    /// Mean square error of the force, N².
    pub square: f64,
}

/// Means over a turn for a law with the lift 1. `mean` and `square` are the means of its force and of the squared force. `product` is the
/// mean product of this force and the target without its mean.
struct Means {
    mean: f64,
    square: f64,
    product: f64,
}

impl Projection {
    /// Projection of a force over a turn, N, for a drive and a maximum stroke.
    pub fn new(force: &Cells, drive: &Drive, stroke: Option<f64>) -> Projection {
        let at = |i| force.at(TAU * i as f64 / SAMPLES as f64) - drive.rest_force;
        let samples: Vec<f64> = (0..SAMPLES).map(at).collect();
        let square = samples.iter().map(|f| f * f).sum::<f64>() / SAMPLES as f64;
        let series = &amplitudes(&samples)[..=HARMONICS];
        let most = square.sqrt();
        let counts = |(a, b): &(f64, f64)| libm::hypot(*a, *b) > ROUNDING * most;
        let count = series.iter().rposition(counts).unwrap_or(0);
        let [s, v, a, _] = drive.weights();
        Projection {
            waves: series[1..=count.max(1)]
                .iter()
                .map(|&(cos, sin)| Complex::new(cos, -sin))
                .collect(),
            mean: series[0].0,
            square,
            weights: [s, v, a],
            stroke: stroke.unwrap_or(f64::INFINITY),
        }
    }

    /// Best double harmonic for given angles. The lift, and with a spring also the level, follow from linear equations. If the law would be
    /// below the base circle, its dwell or its minimum is placed on the base circle.
    pub fn nearest(&self, angles: Angles) -> Nearest {
        self.fit(&self.means(angles))
    }

    fn fit(&self, of: &Means) -> Nearest {
        // Mean product with the target including its mean, for a law whose dwell is at lift 0.
        let product = of.product + self.mean * of.mean;
        let at_zero = |lifts: [f64; 2]| self.along(product, of.square, 0.0, lifts);
        let spring = self.weights[0];
        if spring == 0.0 {
            return at_zero([-self.stroke, self.stroke]);
        }
        let lift = best(
            of.product,
            of.square - of.mean * of.mean,
            [-self.stroke, self.stroke],
        );
        let level = (self.mean - lift * of.mean) / spring;
        if level >= 0.0 && level + lift >= 0.0 {
            let rest = self.square - self.mean * self.mean;
            let alone = of.square - of.mean * of.mean;
            return Nearest {
                lift,
                level,
                square: (rest - lift * (2.0 * of.product - lift * alone)).max(0.0),
            };
        }
        // The law would be below its base circle: its dwell or its minimum is placed on the base circle.
        let rests = at_zero([0.0, self.stroke]);
        let turns = self.along(
            product - spring * self.mean,
            of.square + spring * (spring - 2.0 * of.mean),
            -1.0,
            [-self.stroke, 0.0],
        );
        if rests.square <= turns.square {
            rests
        } else {
            turns
        }
    }

    /// Best law whose lift is between the bounds `lifts` and whose dwell level is `level` times this lift.
    fn along(&self, product: f64, square: f64, level: f64, lifts: [f64; 2]) -> Nearest {
        let lift = best(product, square, lifts);
        Nearest {
            lift,
            level: level * lift,
            square: (self.square - lift * (2.0 * product - lift * square)).max(0.0),
        }
    }

    fn means(&self, [start, rise, fall]: Angles) -> Means {
        let (up, down) = (self.motion(rise, 1.0), self.motion(fall, -1.0));
        let product = (1..).zip(&self.waves).map(|(k, wave)| {
            let k = f64::from(k);
            let shape = up.transform(k) + turned(k * rise) * down.transform(k);
            (wave * turned(k * start) * shape).re
        });
        Means {
            mean: up.mean() + down.mean(),
            square: up.square() + down.square(),
            product: product.sum(),
        }
    }

    /// Force of a unit rise (`sign` = 1) or of a unit fall (`sign` = −1) over an angle, rad. The fall is the rise traversed in the opposite
    /// direction.
    fn motion(&self, angle: f64, sign: f64) -> Motion {
        let [s, v, a] = self.weights;
        let rate = PI / angle;
        let (v, a) = (v * rate, a * rate * rate);
        Motion {
            angle,
            terms: [
                (0.375 * s, 0.0),
                (sign * 0.5 * (a - s), sign * 0.5 * v),
                (0.125 * s - 0.5 * a, -0.25 * v),
            ],
        }
    }

    /// Initial angles for the searches, rad. They are the best points of a grid over start, rise angle and fall angle. Of adjacent grid
    /// points, only the best is used.
    pub fn starts(&self, shortest: f64, count: usize) -> Vec<Angles> {
        let step = TAU / STEPS as f64;
        let least = (shortest / step).ceil() as usize;
        let angles: Vec<usize> = (least..=STEPS - least).collect();
        let [up, down] = [1.0, -1.0].map(|sign| {
            let row = |&n: &usize| self.row(self.motion(n as f64 * step, sign));
            angles.iter().map(row).collect::<Vec<Row>>()
        });
        let mut found: Vec<(f64, [usize; 3])> = Vec::new();
        for (&rise, up) in angles.iter().zip(&up) {
            for (&fall, down) in angles
                .iter()
                .zip(&down)
                .take_while(|(fall, _)| rise + **fall <= STEPS)
            {
                let squares = (0..STEPS).map(|start| {
                    let product = up.products[start] + down.products[(start + rise) % STEPS];
                    let means = Means {
                        mean: up.mean + down.mean,
                        square: up.square + down.square,
                        product,
                    };
                    (self.fit(&means).square, [start, rise, fall])
                });
                found.extend(squares.min_by(|a, b| a.0.total_cmp(&b.0)));
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut out: Vec<[usize; 3]> = Vec::new();
        for (_, angles) in found {
            if out.len() < count && !out.iter().any(|other| are_neighbours(*other, angles)) {
                out.push(angles);
            }
        }
        out.into_iter()
            .map(|angles| angles.map(|n| n as f64 * step))
            .collect()
    }

    /// Means of the force and of the squared force of a motion over a turn, and its mean product with the target for each start angle on
    /// the grid.
    fn row(&self, motion: Motion) -> Row {
        let step = TAU / STEPS as f64;
        let waves: Vec<Complex<f64>> = (1..)
            .zip(self.waves.iter().take(COARSE))
            .map(|(k, wave)| wave * motion.transform(f64::from(k)))
            .collect();
        let turns: Vec<Complex<f64>> = (0..STEPS).map(|i| turned(i as f64 * step)).collect();
        let product = |start: usize| {
            let terms = (1..)
                .zip(&waves)
                .map(|(k, wave)| (wave * turns[k * start % STEPS]).re);
            terms.sum()
        };
        Row {
            mean: motion.mean(),
            square: motion.square(),
            products: (0..STEPS).map(product).collect(),
        }
    }
}

/// Lift, m, between two bounds, for which the mean square force error is minimum.
fn best(product: f64, square: f64, [low, high]: [f64; 2]) -> f64 {
    let free = if square > 0.0 { product / square } else { 0.0 };
    free.clamp(low, high)
}

struct Row {
    mean: f64,
    square: f64,
    products: Vec<f64>,
}

/// Whether two grid points are neighbours: all three angles differ by less than three steps.
fn are_neighbours(a: [usize; 3], b: [usize; 3]) -> bool {
    let apart = |i: usize| a[i].abs_diff(b[i]);
    let around = apart(0).min(STEPS - apart(0));
    around.max(apart(1)).max(apart(2)) < 3
}

/// Force of a motion (a rise or a fall) over its angle: c₀ + c₁ cos πx + d₁ sin πx + c₂ cos 2πx + d₂ sin 2πx, with x from 0 to 1.
struct Motion {
    angle: f64,
    terms: [(f64, f64); 3],
}

impl Motion {
    /// Integral of the force times e^{ikθ} over the angle of the motion, divided by 2π.
    fn transform(&self, k: f64) -> Complex<f64> {
        let half = 0.5 * k * self.angle;
        let wave = turned(half);
        let waves = [0.0, 1.0, 2.0].into_iter().zip(QUARTERS);
        let sum: Complex<f64> = (waves.zip(&self.terms))
            .map(|((m, quarter), &(cos, sin))| {
                let plus = mean_of_wave(half + m * FRAC_PI_2, wave * quarter);
                let minus = mean_of_wave(half - m * FRAC_PI_2, wave * quarter.conj());
                let (even, odd) = (0.5 * (plus + minus), 0.5 * (plus - minus));
                even * cos + odd * Complex::new(0.0, -sin)
            })
            .sum();
        sum * (self.angle / TAU)
    }

    fn mean(&self) -> f64 {
        self.transform(0.0).re
    }

    /// Mean square of the force over a turn, N².
    fn square(&self) -> f64 {
        let [(c0, _), (c1, d1), (c2, d2)] = self.terms;
        // The motion covers half a period, so the mean products of sines with cosines are not zero.
        let squares = c0 * c0 + 0.5 * (c1 * c1 + d1 * d1 + c2 * c2 + d2 * d2);
        let mixed = c0 * d1 * 2.0 + c1 * d2 * (4.0 / 3.0) - d1 * c2 * (2.0 / 3.0);
        (squares + mixed * 2.0 / PI) * self.angle / TAU
    }
}

/// Mean of e^{2ihx} over x from 0 to 1, which is e^{ih} sin h / h. `wave` is e^{ih}.
fn mean_of_wave(h: f64, wave: Complex<f64>) -> Complex<f64> {
    wave * if h.abs() < SMALL {
        1.0 - h * h / 6.0
    } else {
        wave.im / h
    }
}

fn turned(angle: f64) -> Complex<f64> {
    let (sin, cos) = libm::sincos(angle);
    Complex::new(cos, sin)
}

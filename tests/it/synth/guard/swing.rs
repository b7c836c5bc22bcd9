//! Vibration of a compliant follower at the start of a dwell, as rows over the coefficients. On every span, the response to a polynomial force is a
//! polynomial, and the free part is a sum of complex exponentials.

use super::asked::Asked;
use super::splines::{ORDERS, Splines};
use nalgebra::{Complex, DMatrix, DVector, Matrix2, Matrix2xX};
use std::f64::consts::TAU;

/// Compliant follower with its limit on the vibration in dwells.
#[derive(Debug, Clone, Copy)]
pub struct Train {
    /// Natural frequency of the train without return spring, rad/s, and its damping ratio.
    pub own: f64,
    pub ratio: f64,
    /// Mass at the end of the train, kg.
    pub mass: f64,
    /// Maximum amplitude at the start of a dwell, m.
    pub most: f64,
}

/// Fraction of the lift of a law that is the reference of an excess if the limit is smaller. The vibration is a small difference of large
/// deflections, which both methods round.
pub const PART: f64 = 0.1;

/// Rows at the start of a dwell: deflection from the static position, and its slope by the phase of the vibration.
pub type Swing = [DVector<f64>; 2];

/// Follower with the equation m ω² y″ + c ω y′ + K y = −(k s + c ω v + m ω² a).
struct Follower {
    inertia: f64,
    damping: f64,
    stiffness: f64,
}

impl Follower {
    fn of(asked: &Asked, train: &Train) -> Self {
        let [spring, damping, inertia] = asked.weights;
        let stiff = train.mass * train.own * train.own;
        Follower {
            inertia,
            damping: damping + 2.0 * train.ratio * train.mass * train.own * asked.speed,
            stiffness: stiff + spring,
        }
    }

    fn rate(&self) -> f64 {
        (self.stiffness / self.inertia).sqrt()
    }

    /// Matrix that maps (y, y′) to its value after an angle of free vibration.
    fn freed(&self, angle: f64) -> Matrix2<f64> {
        let half = -0.5 * self.damping / self.inertia;
        let root = Complex::new(half * half - self.stiffness / self.inertia, 0.0).sqrt();
        let [a, b] = [half + root, half - root];
        let [of_a, of_b] = [(a * angle).exp(), (b * angle).exp()];
        let over = (a - b).inv();
        let one = |x: Complex<f64>| (x * over).re;
        Matrix2::new(
            one(a * of_b - b * of_a),
            one(of_a - of_b),
            one(a * b * (of_b - of_a)),
            one(a * of_a - b * of_b),
        )
    }

    /// Polynomial response y of u ∈ [0, 1] to a force on a span of this width.
    fn answer(&self, force: &DVector<f64>, width: f64) -> Vec<f64> {
        let mut y = vec![0.0; force.len() + 2];
        for i in (0..force.len()).rev() {
            let k = i as f64;
            let bent = self.inertia / (width * width) * (k + 1.0) * (k + 2.0) * y[i + 2];
            y[i] =
                (-force[i] - bent - self.damping / width * (k + 1.0) * y[i + 1]) / self.stiffness;
        }
        y
    }
}

/// Vibrations at the start of the dwells of a scene, in the periodic steady state.
pub fn swings(asked: &Asked, splines: &Splines) -> Vec<Swing> {
    let Some(train) = &asked.train else {
        return Vec::new();
    };
    let follower = Follower::of(asked, train);
    let n = splines.count();
    // (y, y′) at a break is states·x + turned·(what it is at angle 0).
    let (mut state, mut turned) = (Matrix2xX::<f64>::zeros(n), Matrix2::identity());
    let mut states = vec![(state.clone(), turned)];
    for span in 0..splines.spans() {
        let [a, b] = [splines.breaks()[span], splines.breaks()[span + 1]];
        let [first, last] = particular(&follower, asked.weights, splines, span);
        let free = follower.freed(b - a);
        state = free * (state - first) + last;
        turned = free * turned;
        states.push((state.clone(), turned));
    }
    let around = (Matrix2::identity() - turned).lu();
    let begin = around.solve(&state).expect("a damped follower");
    let at_rest = |from: f64| {
        let from = from.rem_euclid(TAU);
        let span = splines.span_of(from);
        let (state, turned) = &states[span];
        let mut here = state + turned * &begin;
        let [k, c, m] = asked.weights.map(|w| w / follower.stiffness);
        let deflected = DVector::from_vec(splines.row(span, from, [k, c, m, 0.0]));
        here.row_mut(1).unscale_mut(follower.rate());
        [here.row(0).transpose() + deflected, here.row(1).transpose()]
    };
    asked.dwells.iter().map(|d| at_rest(d.from)).collect()
}

/// (y, y′) of the polynomial response at both ends of a span.
fn particular(
    follower: &Follower,
    [k, c, m]: [f64; 3],
    splines: &Splines,
    span: usize,
) -> [Matrix2xX<f64>; 2] {
    let [a, b] = [splines.breaks()[span], splines.breaks()[span + 1]];
    let (degree, width) = (splines.columns(span).count() - 1, b - a);
    let place = |i: usize| 0.5 - 0.5 * (TAU * (i as f64 + 0.5) / (2.0 * degree as f64 + 2.0)).cos();
    let powers = DMatrix::from_fn(degree + 1, degree + 1, |i, j| place(i).powi(j as i32)).lu();
    let values: Vec<[Vec<f64>; ORDERS]> = (0..=degree)
        .map(|i| splines.values(span, a + width * place(i)))
        .collect();
    let mut ends = [0, 1].map(|_| Matrix2xX::zeros(splines.count()));
    for (j, column) in splines.columns(span).enumerate() {
        let force = DVector::from_fn(degree + 1, |i, _| {
            k * values[i][0][j] + c * values[i][1][j] + m * values[i][2][j]
        });
        let y = follower.answer(&powers.solve(&force).expect("distinct places"), width);
        ends[0][(0, column)] += y[0];
        ends[0][(1, column)] += y[1] / width;
        ends[1][(0, column)] += y.iter().sum::<f64>();
        let slopes = y.iter().enumerate().map(|(i, y)| i as f64 * y);
        ends[1][(1, column)] += slopes.sum::<f64>() / width;
    }
    ends
}

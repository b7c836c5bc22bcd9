//! Textbook methods that the charts compare with gaitcam, in a simple form.

use nalgebra::{DMatrix, DVector};

use gaitcam::drive::Drive;
use gaitcam::force::ForceCurve;
use gaitcam::law::Condition;
use gaitcam::poly::bernstein;

/// Stance phase of a stride.
pub struct Stance {
    /// Angle at which the force reaches zero, rad.
    pub end: f64,
    /// Angles of the maxima and minima, rad.
    critical: Vec<f64>,
}

impl Stance {
    /// Finds the end of the stance and the extremes in it; `None` if the force is never zero.
    pub fn of(target: &ForceCurve) -> Option<Stance> {
        let f = &target.force_n;
        let n = f.len();
        let most = f.iter().fold(0.0_f64, |m, x| m.max(*x));
        let last = f.iter().rposition(|x| *x > 1e-3 * most)?;
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
        let wide = n / 40;
        let critical = (wide..last.saturating_sub(wide))
            .filter(|&i| {
                let around = &f[i - wide..=i + wide];
                around.iter().all(|x| *x <= f[i]) || around.iter().all(|x| *x >= f[i])
            })
            .map(angle)
            .collect();
        (last + 1 < n).then(|| Stance {
            end: angle(last + 1),
            critical,
        })
    }

    /// Conditions of Vargas and León (2024): force, velocity and acceleration of zero at both ends, the values of the critical points, and `extra`
    /// further points at equal steps.
    pub fn conditions(&self, target: &ForceCurve, extra: usize) -> Vec<Condition> {
        let mut out = Vec::new();
        for theta in [0.0, self.end] {
            for order in 0..3 {
                out.push(Condition {
                    theta,
                    order,
                    value: 0.0,
                });
            }
        }
        let equal = (1..=extra).map(|i| self.end * i as f64 / (extra + 1) as f64);
        for theta in self.critical.iter().copied().chain(equal) {
            let near = out
                .iter()
                .any(|c: &Condition| (c.theta - theta).abs() < 1e-3);
            if !near {
                out.push(Condition {
                    theta,
                    order: 0,
                    value: target.at(theta),
                });
            }
        }
        out
    }
}

/// Bases of a polynomial on the unit interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PolynomialBasis {
    /// Powers 1, u, u² …
    Monomial,
    /// Bernstein polynomials on the interval.
    Bernstein,
    /// Legendre polynomials on the interval.
    Legendre,
}

impl PolynomialBasis {
    /// All bases, for the charts.
    pub const ALL: [PolynomialBasis; 3] = [Self::Monomial, Self::Bernstein, Self::Legendre];

    /// Name of the basis in the charts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Monomial => "least squares, monomials",
            Self::Bernstein => "least squares, Bernstein",
            Self::Legendre => "least squares, Legendre",
        }
    }

    /// Values of all basis functions at u.
    fn row(self, degree: usize, u: f64) -> Vec<f64> {
        let mut out = Vec::with_capacity(degree + 1);
        match self {
            Self::Monomial => {
                let mut p = 1.0;
                for _ in 0..=degree {
                    out.push(p);
                    p *= u;
                }
            }
            Self::Bernstein => {
                for k in 0..=degree {
                    let (i, j) = (k as i32, (degree - k) as i32);
                    out.push(bernstein::binomial(degree, k) * u.powi(i) * (1.0 - u).powi(j));
                }
            }
            Self::Legendre => {
                let x = 2.0 * u - 1.0;
                let (mut p, mut q) = (1.0, x);
                for k in 0..=degree {
                    out.push(p);
                    let k = k as f64 + 1.0;
                    (p, q) = (q, ((2.0 * k + 1.0) * x * q - k * p) / (k + 1.0));
                }
            }
        }
        out
    }

    /// Coefficients by normal equations over `samples` equal steps of [0, end]; `None` if they are numerically singular.
    pub fn fit(
        self,
        target: &ForceCurve,
        end: f64,
        degree: usize,
        samples: usize,
    ) -> Option<Vec<f64>> {
        let at = |i: usize| i as f64 / (samples - 1) as f64;
        let rows: Vec<Vec<f64>> = (0..samples).map(|i| self.row(degree, at(i))).collect();
        let a = DMatrix::from_fn(samples, degree + 1, |i, j| rows[i][j]);
        let b = DVector::from_fn(samples, |i, _| target.at(end * at(i)));
        let gram = a.transpose() * &a;
        let x = gram.lu().solve(&(a.transpose() * b))?;
        Some(x.iter().copied().collect())
    }

    /// Value of the polynomial at u.
    pub fn value(self, c: &[f64], u: f64) -> f64 {
        self.row(c.len() - 1, u)
            .iter()
            .zip(c)
            .map(|(p, c)| p * c)
            .sum()
    }
}

/// A force over the cam angle.
pub type Force = Box<dyn Fn(f64) -> f64>;

/// Force of a polynomial over the whole turn whose inertia force follows the target, with equal v and a at both ends. Method: least squares in
/// Legendre polynomials for the acceleration, without the mean.
pub fn periodic_polynomial(
    target: &ForceCurve,
    drive: &Drive,
    degree: usize,
) -> (Option<Force>, usize) {
    let basis = PolynomialBasis::Legendre;
    let fit = basis.fit(target, std::f64::consts::TAU, degree - 2, 400);
    // The mean of a Legendre series is its first coefficient. For a closed motion it must be the weight.
    let rest = drive.rest_force;
    let force = fit.map(|mut c| -> Force {
        c[0] = rest;
        Box::new(move |x| basis.value(&c, x / std::f64::consts::TAU))
    });
    (force, degree)
}

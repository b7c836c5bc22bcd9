//! Lower bound of the number of spans for an accuracy, from the spectrum of the target force.
//!
//! On equal spans of a turn the shifts of one B-spline are the basis, so the least squares fall apart by residues:
//! harmonics n that differ by multiples of N share one unknown. With the force's weight W(n) = k − mω²n² + i cωn and
//! the spline's own spectrum, which on one residue is n^−(p+1) but for a factor,
//!
//! ```text
//! ψ(n) = W(n)/n^(p+1)
//! mean square left = mean (F − F₀)² − Σ over residues |Σ ψ*(n) F̂(n)|² / Σ |ψ(n)|²
//! ```
//!
//! Demands and limits can only leave more. So what is foretold is no answer: it says where to begin.

use crate::drive::Drive;
use crate::problem::{Problem, Target};

/// Aliases of a residue on either side; they fall as ψ does.
const ALIASES: i64 = 3;
/// Samples for each span, at least: then the samples' harmonics are those of the force between them.
const SAMPLES_PER_SPAN: usize = 16;
/// A miss that is foretold by less than this part is looked at.
const MARGIN: f64 = 0.02;

/// What splines on equal spans leave of a force, before any demand.
pub struct Forecast<'a> {
    target: &'a Target,
    drive: Drive,
    degree: i32,
    /// Mean square of the force less what the machine presses with at rest, N².
    whole: f64,
}

impl<'a> Forecast<'a> {
    /// Of a problem's force; `None` where the spans are not equal or the force is weighed by phase.
    pub fn of(problem: &'a Problem) -> Option<Self> {
        let target = problem.target.as_ref()?;
        let suits = problem.law.dwells.is_empty() && !problem.is_weighed();
        suits.then(|| Forecast {
            target,
            drive: problem.drive,
            degree: problem.spline_degree as i32,
            whole: target.mean_square_from(problem.drive.rest_force),
        })
    }

    /// Whether this number of spans surely misses an RMS error, N.
    pub fn misses(&self, spans: usize, wanted: f64) -> bool {
        let known = spans * SAMPLES_PER_SPAN <= self.target.curve.force_n.len();
        known && self.left(spans) > wanted * wanted * (1.0 + MARGIN) * (1.0 + MARGIN)
    }

    /// Mean square that the best spline leaves, N².
    fn left(&self, spans: usize) -> f64 {
        let mean = self.target.spectrum()[0].0 - self.drive.rest_force;
        let level = if self.drive.spring_rate == 0.0 {
            0.0
        } else {
            mean * mean
        };
        let n = spans as i64;
        let caught: f64 = (1..=n / 2)
            .map(|residue| {
                // Conjugate residues catch the same; the middle one of an even number is its own.
                let twice = if 2 * residue == n { 1.0 } else { 2.0 };
                twice * self.caught(residue, n)
            })
            .sum();
        self.whole - level - caught
    }

    /// What one residue catches of the mean square, N².
    fn caught(&self, residue: i64, spans: i64) -> f64 {
        let spectrum = self.target.spectrum();
        let (mut product, mut square) = ([0.0; 2], 0.0);
        for alias in -ALIASES..=ALIASES {
            let n = residue + alias * spans;
            let harmonic = n.unsigned_abs() as usize;
            let Some(&(cosine, sine)) = spectrum.get(harmonic) else {
                continue;
            };
            let sign = if n < 0 { -1.0 } else { 1.0 };
            let force = [0.5 * cosine, -0.5 * sign * sine];
            let (re, im) = self.drive.gain(harmonic);
            // n^(p+1) of the residue's own harmonic keeps the numbers near one.
            let falls = (residue as f64 / n as f64).powi(self.degree + 1);
            let psi = [re * falls, sign * im * falls];
            product[0] += psi[0] * force[0] + psi[1] * force[1];
            product[1] += psi[0] * force[1] - psi[1] * force[0];
            square += psi[0] * psi[0] + psi[1] * psi[1];
        }
        if square > 0.0 {
            (product[0] * product[0] + product[1] * product[1]) / square
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::force::{Feet, model};
    use crate::scene;
    use crate::synth::families::formulation::unlimited;
    use crate::synth::qp;
    use crate::synth::search::Search;

    /// The forecast is the least squares' own error, on inertia, spring and damper.
    #[test]
    fn what_is_foretold_is_what_the_least_squares_leave() {
        let machines: [&[&str]; 3] = [
            &[],
            &["law.degree=7"],
            &[
                "drive.kind=fixed-axis",
                "drive.mass=20 kg",
                "drive.spring_rate=30 N/mm",
                "drive.damping=200 N*s/m",
                "drive.preload=100 N",
            ],
        ];
        let force = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
        for changes in machines {
            let mut table: toml::Table = scene::DEFAULT.parse().unwrap();
            table["drive"] = toml::Value::Table(toml::Table::new());
            scene::set(&mut table, "drive.kind=moving-axis").unwrap();
            for change in changes {
                scene::set(&mut table, change).unwrap();
            }
            let scene = scene::read(&table).unwrap();
            let problem = Problem::resolve(&scene, Some(&force)).unwrap();
            let forecast = Forecast::of(&problem).unwrap();
            for spans in [3, 4, 5, 7, 8, 13, 24] {
                let (program, distance) = unlimited(&problem, &Search::default(), spans).unwrap();
                let x = qp::solve_equalities(&program).unwrap().x;
                let exact = 2.0 * distance.value(&x);
                let found = forecast.left(spans);
                assert!(
                    (found - exact).abs() < 1e-3 * exact + 1e-4,
                    "{changes:?} {spans}: {found} {exact}"
                );
            }
        }
    }
}

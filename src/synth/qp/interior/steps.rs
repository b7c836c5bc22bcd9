//! The iterations: residuals, one factor, a predictor and a corrector (Mehrotra 1992).
//!
//! ```text
//! H u + q + Eᵀν + Aᵀz = 0,   E u = e,   A u + s = b,   s ≥ 0, z ≥ 0, s∘z = μ → 0
//! ```

use super::Left;
use super::cone::{Cone, MIDDLE, Scaling, inside, product, times};
use super::demands::Demands;
use super::system::{Found, System};
use crate::halt::Halt;
use crate::synth::qp::band::ArrowFactor;
use crate::synth::qp::double::Number;
use crate::synth::qp::program::{Failure, Stop};
use crate::synth::qp::settings::InteriorPointSettings;

/// Of the way to the first slack or multiplier that vanishes.
const SHORT: f64 = 0.99;
/// Iterations without a better point that end the search.
const PATIENCE: usize = 7;
/// A best point that misses by no more than this will do: rounding is what is left.
const NEARLY: f64 = 2e-8;
/// Steps shorter than this come no further.
const SHORTEST: f64 = 1e-8;
/// A ray of multipliers this clean proves that nothing keeps all rows.
const RAY: f64 = 1e-8;
/// … by more than this, in the rows' units.
const SURELY: f64 = 1e-9;
/// What is left of the equations of the unknowns is to be smaller than the gap by this factor, where digits allow.
const CLEANER: f64 = 1e-4;
/// Part of the softest direction's stiffness that the rounding of a row's products may take.
const BLURRED: f64 = 1e-3;
/// Part of the largest pivot that keeps directions which nothing holds.
const HELD: f64 = 1e5;
/// … that is raised by this factor while there is no factor.
const RAISED: f64 = 1e3;
const RAISES: usize = 4;

/// Solves a system.
pub fn solve<T: Number>(
    system: &System<T>,
    settings: &InteriorPointSettings,
    halt: &Halt,
) -> Result<Found<T>, Left> {
    let mut point = Point::first(system).ok_or(Left::Open)?;
    // More digits cost a few iterations only.
    let tolerance = if T::EPSILON < f64::EPSILON {
        settings.many_spans_tolerance
    } else {
        settings.tolerance
    };
    let mut best: Option<(f64, Found<T>)> = None;
    let mut since = 0;
    for iteration in 0..settings.iterations as usize {
        if halt.is_asked() {
            return Err(Left::Failed(Stop::OutOfTime.into()));
        }
        let miss = Miss::of(system, &point);
        let off = miss.off(system, &point, tolerance);
        if !off.is_finite() {
            break;
        }
        since += 1;
        if best.as_ref().is_none_or(|(least, _)| off < 0.9 * least) {
            let found = Found {
                unknowns: point.u.clone(),
                pushes: point.z.clone(),
                iterations: iteration,
            };
            if off <= 1.0 {
                return Ok(found);
            }
            best = Some((off, found));
            since = 0;
        }
        if miss.is_ray(system, &point) {
            return Err(Left::Failed(Failure::Infeasible));
        }
        if since > PATIENCE || !point.advance(system, &miss) {
            break;
        }
    }
    match best {
        Some((off, found)) if off * tolerance <= NEARLY => Ok(found),
        _ => Err(Left::Open),
    }
}

struct Point<T> {
    u: Vec<T>,
    nu: Vec<T>,
    s: Vec<f64>,
    z: Vec<f64>,
    cone: Option<Cone>,
}

/// What a point leaves of the equations.
struct Miss<T> {
    /// −(H u + q + Eᵀν + Aᵀz).
    x: Vec<T>,
    /// e − E u.
    y: Vec<T>,
    /// b − A u − s.
    rows: Vec<f64>,
    /// The same of the cone.
    cone: [f64; 3],
    /// Aᵀz + Eᵀν, as far as it is not balanced.
    pull: f64,
    value: f64,
    /// Largest term in the equations of the unknowns.
    size: f64,
}

impl<T: Number> Miss<T> {
    fn of(system: &System<T>, point: &Point<T>) -> Self {
        let two = T::of(2.0);
        let hu = system.hessian.times(&point.u);
        let mut value = T::of(0.0);
        let mut size = 0.0_f64;
        let mut x: Vec<T> = Vec::with_capacity(hu.len());
        for ((&h, &q), &u) in hu.iter().zip(&system.gradient).zip(&point.u) {
            value = value + u * (h / two + q);
            size = size.max(h.rounded().abs()).max(q.rounded().abs());
            x.push(h + q);
        }
        let mut push = vec![T::of(0.0); x.len()];
        let rows = (system.rows.iter().zip(&point.z).zip(&point.s))
            .map(|((row, &z), &s)| {
                row.add_to(&mut push, T::of(z));
                (row.bound - row.of(&point.u) - T::of(s)).rounded()
            })
            .collect();
        let y = (system.demands.iter().zip(&point.nu))
            .map(|(demand, &nu)| {
                demand.add_to(&mut push, nu);
                demand.bound - demand.of(&point.u)
            })
            .collect();
        let mut cone = [0.0; 3];
        if let (Some(columns), Some(own)) = (system.cone, point.cone) {
            for k in 0..3 {
                let column = columns[k];
                push[column] = push[column] - T::of(own.z[k]);
                cone[k] = point.u[column].rounded() - own.s[k];
            }
        }
        let largest = |v: &[T]| v.iter().fold(0.0_f64, |m, x| m.max(x.rounded().abs()));
        let pull = largest(&push);
        for (x, p) in x.iter_mut().zip(push) {
            *x = -(*x + p);
        }
        Miss {
            x,
            y,
            rows,
            cone,
            pull,
            value: value.rounded(),
            size,
        }
    }

    /// How far from the tolerance, as a factor; 1 or less is there.
    fn off(&self, system: &System<T>, point: &Point<T>, tolerance: f64) -> f64 {
        let largest = |v: &[T]| v.iter().fold(0.0_f64, |m, x| m.max(x.rounded().abs()));
        let rows = self.rows.iter().chain(&self.cone);
        let primal = rows.fold(largest(&self.y), |m, r| m.max(r.abs()));
        // A law far above its circle takes up what is left of the pull on its level.
        let digits = T::EPSILON / f64::EPSILON;
        let dual = largest(&self.x) / (1e-3 + self.size) / digits.max(CLEANER);
        let value = (self.value + system.value).abs().max(1e-14);
        let gap = point.gap() / value;
        primal.max(dual).max(gap) / tolerance
    }

    /// Whether the multipliers prove that nothing keeps all rows: Aᵀz + Eᵀν = 0 with bᵀz + eᵀν < 0.
    fn is_ray(&self, system: &System<T>, point: &Point<T>) -> bool {
        let rows = system.rows.iter().zip(&point.z);
        let held: f64 = rows.map(|(r, z)| r.bound.rounded() * z).sum();
        let demands = system.demands.iter().zip(&point.nu);
        let held = held
            + demands
                .map(|(d, &nu)| (d.bound * nu).rounded())
                .sum::<f64>();
        // What is infeasible by rounding alone is none.
        let pushes: f64 = point.z.iter().sum();
        held < -SURELY * pushes && self.pull <= -RAY * held
    }
}

/// A step of everything.
struct Move<T> {
    u: Vec<T>,
    nu: Vec<T>,
    s: Vec<f64>,
    z: Vec<f64>,
    cone_s: [f64; 3],
    cone_z: [f64; 3],
}

/// The factor of an iteration, for predictor and corrector.
struct Solver<'a, T> {
    system: &'a System<T>,
    factor: ArrowFactor<T>,
    demands: Demands<T>,
    s: &'a [f64],
    z: &'a [f64],
    scaling: Option<Scaling>,
}

impl<'a, T: Number> Solver<'a, T> {
    fn new(
        system: &'a System<T>,
        s: &'a [f64],
        z: &'a [f64],
        scaling: Option<Scaling>,
    ) -> Option<Self> {
        let mut matrix = system.hessian.clone();
        // The softest direction is a slow wave: (2π/n)⁴ of the stiffest.
        let softest = (std::f64::consts::TAU / matrix.dimension() as f64).powi(4);
        let light = BLURRED * softest / f64::EPSILON;
        for ((row, s), z) in system.rows.iter().zip(s).zip(z) {
            let weight = z / s;
            if weight < light {
                for (p, &(i, a)) in row.rounded.iter().enumerate() {
                    let weighed = a * weight;
                    for &(j, b) in &row.rounded[..=p] {
                        matrix.add(i, j, T::of(weighed * b));
                    }
                }
                continue;
            }
            for (p, &(i, a)) in row.entries.iter().enumerate() {
                let weighed = a * T::of(weight);
                for &(j, b) in &row.entries[..=p] {
                    matrix.add(i, j, weighed * b);
                }
            }
        }
        if let (Some(columns), Some(scaling)) = (system.cone, scaling) {
            let weight = scaling.weight();
            for p in 0..3 {
                for q in 0..=p {
                    matrix.add(columns[p], columns[q], T::of(weight[p][q]));
                }
            }
        }
        let stiffness = Demands::stiffen(&system.demands, &mut matrix);
        let mut held = HELD * T::EPSILON * system.hessian.largest_diagonal().max(1.0);
        for _ in 0..RAISES {
            let mut regular = matrix.clone();
            for i in 0..regular.dimension() {
                regular.add(i, i, T::of(held));
            }
            if let Some(factor) = regular.factor() {
                let demands = Demands::new(&system.demands, &factor, stiffness);
                return Some(Solver {
                    system,
                    factor,
                    demands,
                    s,
                    z,
                    scaling,
                });
            }
            held *= RAISED;
        }
        None
    }

    /// The step with s∘z to change by `towards` and, where there is a cone, its own products by `cone`.
    fn step(&self, miss: &Miss<T>, towards: &[f64], cone: &[f64; 3]) -> Move<T> {
        let mut pull = vec![0.0; miss.x.len()];
        for (i, row) in self.system.rows.iter().enumerate() {
            let t = (towards[i] - self.z[i] * miss.rows[i]) / self.s[i];
            row.rounded.iter().for_each(|&(k, a)| pull[k] -= a * t);
        }
        let mut rhs: Vec<T> = (miss.x.iter().zip(pull))
            .map(|(&x, p)| x + T::of(p))
            .collect();
        let mut of_cone = [0.0; 3];
        let mut weight = [[0.0; 3]; 3];
        if let (Some(columns), Some(scaling)) = (self.system.cone, &self.scaling) {
            weight = scaling.weight();
            let own = scaling.unscaled(&scaling.divided(cone));
            let missed = times(&weight, &miss.cone);
            for k in 0..3 {
                of_cone[k] = own[k] - missed[k];
                rhs[columns[k]] = rhs[columns[k]] + T::of(of_cone[k]);
            }
        }
        let nu = self
            .demands
            .solve(&self.system.demands, &self.factor, &mut rhs, &miss.y);
        let u = rhs;
        let du: Vec<f64> = u.iter().map(|u| u.rounded()).collect();
        let mut s = Vec::with_capacity(self.s.len());
        let mut z = Vec::with_capacity(self.s.len());
        for (i, row) in self.system.rows.iter().enumerate() {
            let moved: f64 = row.rounded.iter().map(|&(k, a)| a * du[k]).sum();
            let ds = miss.rows[i] - moved;
            s.push(ds);
            z.push((towards[i] - self.z[i] * ds) / self.s[i]);
        }
        let (mut cone_s, mut cone_z) = ([0.0; 3], [0.0; 3]);
        if let Some(columns) = self.system.cone {
            let du = columns.map(|c| u[c].rounded());
            let back = times(&weight, &du);
            for k in 0..3 {
                cone_s[k] = miss.cone[k] + du[k];
                cone_z[k] = of_cone[k] - back[k];
            }
        }
        Move {
            u,
            nu,
            s,
            z,
            cone_s,
            cone_z,
        }
    }
}

impl<T: Number> Point<T> {
    /// The least squares of slacks and multipliers, brought inside.
    fn first(system: &System<T>) -> Option<Self> {
        let ones = vec![1.0; system.rows.len()];
        let identity = Cone {
            s: MIDDLE,
            z: MIDDLE,
        };
        let scaling = system.cone.and_then(|_| identity.scaling());
        let solver = Solver::new(system, &ones, &ones, scaling)?;
        let miss = Miss {
            x: system.gradient.iter().map(|&q| -q).collect(),
            y: system.demands.iter().map(|d| d.bound).collect(),
            rows: system.rows.iter().map(|r| r.bound.rounded()).collect(),
            cone: [0.0; 3],
            pull: 0.0,
            value: 0.0,
            size: 0.0,
        };
        let step = solver.step(&miss, &vec![0.0; ones.len()], &[0.0; 3]);
        let mut cone = system.cone.map(|_| Cone {
            s: step.cone_s,
            z: step.cone_z,
        });
        let least = |v: &[f64], cone: Option<&[f64; 3]>| {
            let least = v.iter().fold(f64::INFINITY, |m, x| m.min(*x));
            cone.map_or(least, |c| least.min(inside(c)))
        };
        let (mut s, mut z) = (step.s, step.z);
        let room = least(&s, cone.as_ref().map(|c| &c.s));
        if room <= 0.0 {
            s.iter_mut().for_each(|s| *s += 1.0 - room);
            cone.iter_mut().for_each(|c| c.s[0] += 1.0 - room);
        }
        let room = least(&z, cone.as_ref().map(|c| &c.z));
        if room <= 0.0 {
            z.iter_mut().for_each(|z| *z += 1.0 - room);
            cone.iter_mut().for_each(|c| c.z[0] += 1.0 - room);
        }
        Some(Point {
            u: step.u,
            nu: step.nu,
            s,
            z,
            cone,
        })
    }

    fn gap(&self) -> f64 {
        let rows: f64 = self.s.iter().zip(&self.z).map(|(s, z)| s * z).sum();
        rows + self.cone.map_or(0.0, |c| c.gap())
    }

    /// One iteration; false where no step is left.
    fn advance(&mut self, system: &System<T>, miss: &Miss<T>) -> bool {
        let scaling = match self.cone.map(|c| c.scaling()) {
            Some(None) => return false,
            other => other.flatten(),
        };
        let Some(solver) = Solver::new(system, &self.s, &self.z, scaling) else {
            return false;
        };
        let lambda = scaling.map_or([0.0; 3], |w| product(&w.lambda, &w.lambda));
        let towards: Vec<f64> = self.s.iter().zip(&self.z).map(|(s, z)| -s * z).collect();
        let predicted = solver.step(miss, &towards, &lambda.map(|l| -l));
        let reach = self.longest(&predicted).min(1.0);
        let degree = self.s.len() + usize::from(self.cone.is_some());
        let middle = (1.0 - reach).powi(3) * self.gap() / degree as f64;
        let corrected: Vec<f64> = (towards.iter().zip(&predicted.s).zip(&predicted.z))
            .map(|((t, ds), dz)| t + middle - ds * dz)
            .collect();
        let mut cone = [0.0; 3];
        if let Some(w) = &scaling {
            let second = product(&w.unscaled(&predicted.cone_s), &w.scaled(&predicted.cone_z));
            for k in 0..3 {
                cone[k] = middle * MIDDLE[k] - lambda[k] - second[k];
            }
        }
        let step = solver.step(miss, &corrected, &cone);
        let part = (SHORT * self.longest(&step)).min(1.0);
        if part.is_nan() || part < SHORTEST {
            return false;
        }
        let by = T::of(part);
        for (u, &d) in self.u.iter_mut().zip(&step.u) {
            *u = *u + by * d;
        }
        for (nu, &d) in self.nu.iter_mut().zip(&step.nu) {
            *nu = *nu + by * d;
        }
        for (s, d) in self.s.iter_mut().zip(&step.s) {
            *s += part * d;
        }
        for (z, d) in self.z.iter_mut().zip(&step.z) {
            *z += part * d;
        }
        if let Some(own) = &mut self.cone {
            for k in 0..3 {
                own.s[k] += part * step.cone_s[k];
                own.z[k] += part * step.cone_z[k];
            }
        }
        true
    }

    /// Longest step that keeps slacks and multipliers positive.
    fn longest(&self, step: &Move<T>) -> f64 {
        let line = |v: &[f64], d: &[f64]| {
            let ends = v.iter().zip(d).filter(|(_, d)| **d < 0.0);
            ends.fold(f64::INFINITY, |m, (v, d)| m.min(-v / d))
        };
        let rows = line(&self.s, &step.s).min(line(&self.z, &step.z));
        self.cone
            .map_or(rows, |c| rows.min(c.longest(&step.cone_s, &step.cone_z)))
    }
}

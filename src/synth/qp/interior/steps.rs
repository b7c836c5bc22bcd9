//! The iterations: residuals, one factor, a predictor and a corrector (Mehrotra 1992).
//!
//! ```text
//! H u + q + Eᵀν + Aᵀz = 0,   E u = e,   A u + s = b,   s ≥ 0, z ≥ 0, s∘z = μ → 0
//! ```

use super::Left;
use super::cone::{Cone, MIDDLE, Scaling, inside, product, times};
use super::system::{Factor, Found, Matrix, Midway, System};
use crate::halt::Halt;
use crate::synth::qp::program::{Failure, Stop};
use crate::synth::qp::settings::InteriorPointSettings;

/// Of the way to the first slack or multiplier that vanishes.
const SHORT: f64 = 0.99;
/// Iterations in which neither the point nor what is left of its pull comes nearer end the search.
const PATIENCE: usize = 7;
/// A best point that misses by no more than this will do, or by no more than the program asks: rounding is what is left.
const NEARLY: f64 = 2e-8;
/// Steps shorter than this come no further.
const SHORTEST: f64 = 1e-8;
/// A ray of multipliers this clean proves that nothing keeps all rows.
const RAY: f64 = 1e-8;
/// … by more than this, in the rows' units.
const SURELY: f64 = 1e-9;
/// Relative gap of the point from which a solution with a few rows more goes on.
const MIDWAY: f64 = 1e-3;
/// Factor by which a row's slack times its push lies apart from the mean there.
const APART: f64 = 100.0;

/// Solves a system that is asked to hold to a part of its limits, from a point on the way to the solution with other rows
/// where there is one and it leads there.
pub fn solve(
    system: &System,
    settings: &InteriorPointSettings,
    asked: f64,
    halt: &Halt,
    from: Option<Midway>,
) -> Result<Found, Left> {
    if let Some(point) = from.and_then(|from| Point::midway(system, from)) {
        match solve_from(system, settings, asked, halt, point) {
            Err(Left::Open) => (),
            settled => return settled,
        }
    }
    let point = Point::first(system).ok_or(Left::Open)?;
    solve_from(system, settings, asked, halt, point)
}

fn solve_from(
    system: &System,
    settings: &InteriorPointSettings,
    asked: f64,
    halt: &Halt,
    mut point: Point,
) -> Result<Found, Left> {
    let mut midway = None;
    // More digits cost a few iterations only.
    let tolerance = match system.matrix {
        Matrix::Chained(..) => settings.many_spans_tolerance,
        Matrix::Banded(..) => settings.tolerance,
    };
    let mut best: Option<(f64, Found)> = None;
    let (mut since, mut smallest) = (0, f64::INFINITY);
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
        // Far from the end a pull is as large as what it is measured by.
        if miss.unbalanced < 0.9 * smallest {
            smallest = miss.unbalanced;
            since = 0;
        }
        if best.as_ref().is_none_or(|(least, _)| off < 0.9 * least) {
            let mut found = Found {
                unknowns: point.u.clone(),
                pushes: point.z.clone(),
                iterations: iteration,
                midway: None,
            };
            if off <= 1.0 {
                found.midway = midway;
                return Ok(found);
            }
            best = Some((off, found));
            since = 0;
        }
        if midway.is_none() && miss.gap(system, &point) < MIDWAY {
            midway = Some(point.on_the_way());
        }
        if miss.is_ray(system, &point) {
            return Err(Left::Failed(Failure::Infeasible));
        }
        if since > PATIENCE || !point.advance(system, &miss) {
            break;
        }
    }
    match best {
        Some((off, found)) if off * tolerance <= NEARLY.max(asked) => Ok(Found { midway, ..found }),
        _ => Err(Left::Open),
    }
}

struct Point {
    u: Vec<f64>,
    nu: Vec<f64>,
    s: Vec<f64>,
    z: Vec<f64>,
    cone: Option<Cone>,
}

/// What a point leaves of the equations.
struct Miss {
    /// −(H u + q + Eᵀν + Aᵀz).
    x: Vec<f64>,
    /// e − E u.
    y: Vec<f64>,
    /// b − A u − s.
    rows: Vec<f64>,
    /// The same of the cone.
    cone: [f64; 3],
    /// What of x nothing balances.
    unbalanced: f64,
    /// Aᵀz + Eᵀν, as far as it is not balanced.
    pull: f64,
    value: f64,
    /// Largest term in the equations of the unknowns.
    size: f64,
}

impl Miss {
    fn of(system: &System, point: &Point) -> Self {
        let hu = system.times(&point.u);
        let mut value = 0.0;
        let mut x: Vec<f64> = Vec::with_capacity(hu.len());
        for ((&h, &q), &u) in hu.iter().zip(&system.gradient).zip(&point.u) {
            value += u * (h / 2.0 + q);
            x.push(h + q);
        }
        let mut push = vec![0.0; x.len()];
        system.add_rows(&point.z, &mut push);
        let mut rows = system.rows(&point.u);
        for ((row, bound), s) in rows.iter_mut().zip(&system.bounds).zip(&point.s) {
            *row = bound - *row - s;
        }
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
                push[column] -= own.z[k];
                cone[k] = point.u[column] - own.s[k];
            }
        }
        // What the rows and demands pull is what the objective pulls back.
        let pull = system.unbalanced(&push);
        let size = pull.max(system.size);
        for (x, p) in x.iter_mut().zip(push) {
            *x = -(*x + p);
        }
        Miss {
            unbalanced: system.unbalanced(&x),
            x,
            y,
            rows,
            cone,
            pull,
            value,
            size,
        }
    }

    /// How far from the tolerance, as a factor; 1 or less is there.
    fn off(&self, system: &System, point: &Point, tolerance: f64) -> f64 {
        let largest = |v: &[f64]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let rows = self.rows.iter().chain(&self.cone);
        let primal = rows.fold(largest(&self.y), |m, r| m.max(r.abs()));
        // A law far above its circle takes up what is left of the pull on its level.
        let dual = self.unbalanced / (1e-3 + self.size);
        primal.max(dual).max(self.gap(system, point)) / tolerance
    }

    /// Gap as a part of the objective.
    fn gap(&self, system: &System, point: &Point) -> f64 {
        point.gap() / (self.value + system.value).abs().max(1e-14)
    }

    /// Whether the multipliers prove that nothing keeps all rows: Aᵀz + Eᵀν = 0 with bᵀz + eᵀν < 0.
    fn is_ray(&self, system: &System, point: &Point) -> bool {
        let rows = system.bounds.iter().zip(&point.z);
        let held: f64 = rows.map(|(bound, z)| bound * z).sum();
        let demands = system.demands.iter().zip(&point.nu);
        let held = held + demands.map(|(d, &nu)| d.bound * nu).sum::<f64>();
        // What is infeasible by rounding alone is none.
        let pushes: f64 = point.z.iter().sum();
        held < -SURELY * pushes && self.pull <= -RAY * held
    }
}

/// A step of everything.
struct Move {
    u: Vec<f64>,
    nu: Vec<f64>,
    s: Vec<f64>,
    z: Vec<f64>,
    cone_s: [f64; 3],
    cone_z: [f64; 3],
}

/// The factor of an iteration, for predictor and corrector.
struct Solver<'a> {
    system: &'a System,
    factor: Factor,
    s: &'a [f64],
    z: &'a [f64],
    scaling: Option<Scaling>,
}

impl<'a> Solver<'a> {
    fn new(
        system: &'a System,
        s: &'a [f64],
        z: &'a [f64],
        scaling: Option<Scaling>,
    ) -> Option<Self> {
        let weights: Vec<f64> = s.iter().zip(z).map(|(s, z)| z / s).collect();
        let factor = system.factor(&weights, scaling.map(|s| s.weight()))?;
        Some(Solver {
            system,
            factor,
            s,
            z,
            scaling,
        })
    }

    /// The step with s∘z to change by `towards` and, where there is a cone, its own products by `cone`.
    fn step(&self, miss: &Miss, towards: &[f64], cone: &[f64; 3]) -> Move {
        let mut rhs = miss.x.clone();
        let rows = towards.iter().zip(self.z).zip(&miss.rows).zip(self.s);
        let pulls: Vec<f64> = rows.map(|(((t, z), r), s)| (z * r - t) / s).collect();
        self.system.add_rows(&pulls, &mut rhs);
        let mut of_cone = [0.0; 3];
        let mut weight = [[0.0; 3]; 3];
        if let (Some(columns), Some(scaling)) = (self.system.cone, &self.scaling) {
            weight = scaling.weight();
            let own = scaling.unscaled(&scaling.divided(cone));
            let missed = times(&weight, &miss.cone);
            for k in 0..3 {
                of_cone[k] = own[k] - missed[k];
                rhs[columns[k]] += of_cone[k];
            }
        }
        let nu = self.system.solve(&self.factor, &mut rhs, &miss.y);
        let u = rhs;
        let mut s = self.system.rows(&u);
        let mut z = Vec::with_capacity(s.len());
        for (i, ds) in s.iter_mut().enumerate() {
            *ds = miss.rows[i] - *ds;
            z.push((towards[i] - self.z[i] * *ds) / self.s[i]);
        }
        let (mut cone_s, mut cone_z) = ([0.0; 3], [0.0; 3]);
        if let Some(columns) = self.system.cone {
            let du = columns.map(|c| u[c]);
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

impl Point {
    /// The least squares of slacks and multipliers, brought inside.
    fn first(system: &System) -> Option<Self> {
        let ones = vec![1.0; system.bounds.len()];
        let identity = Cone {
            s: MIDDLE,
            z: MIDDLE,
        };
        let scaling = system.cone.and_then(|_| identity.scaling());
        let solver = Solver::new(system, &ones, &ones, scaling)?;
        let miss = Miss {
            x: system.gradient.iter().map(|&q| -q).collect(),
            y: system.demands.iter().map(|d| d.bound).collect(),
            rows: system.bounds.clone(),
            cone: [0.0; 3],
            unbalanced: 0.0,
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

    fn on_the_way(&self) -> Midway {
        Midway {
            u: self.u.clone(),
            nu: self.nu.clone(),
            z: self.z.iter().map(|&z| Some(z)).collect(),
            mean: self.gap() / (self.s.len() + usize::from(self.cone.is_some())) as f64,
            cone: self.cone,
        }
    }

    /// A point with the slacks that its law has, new rows in the middle between slack and push.
    fn midway(system: &System, from: Midway) -> Option<Self> {
        let fits = from.u.len() == system.gradient.len() && from.nu.len() == system.demands.len();
        if !fits || from.mean <= 0.0 {
            return None;
        }
        let least = from.mean.sqrt();
        let values = system.rows(&from.u);
        let mut s = Vec::with_capacity(values.len());
        let mut z = Vec::with_capacity(values.len());
        for ((bound, value), push) in system.bounds.iter().zip(values).zip(from.z) {
            let slack = bound - value;
            let own = if slack > 0.0 && push.is_some() {
                slack
            } else {
                slack.max(least)
            };
            s.push(own);
            let middle = from.mean / own;
            z.push(push.map_or(middle, |push| push.clamp(middle / APART, middle * APART)));
        }
        Some(Point {
            u: from.u,
            nu: from.nu,
            s,
            z,
            cone: from.cone,
        })
    }

    fn gap(&self) -> f64 {
        let rows: f64 = self.s.iter().zip(&self.z).map(|(s, z)| s * z).sum();
        rows + self.cone.map_or(0.0, |c| c.gap())
    }

    /// One iteration; false where no step is left.
    fn advance(&mut self, system: &System, miss: &Miss) -> bool {
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
        for (u, &d) in self.u.iter_mut().zip(&step.u) {
            *u += part * d;
        }
        for (nu, &d) in self.nu.iter_mut().zip(&step.nu) {
            *nu += part * d;
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
    fn longest(&self, step: &Move) -> f64 {
        let line = |v: &[f64], d: &[f64]| {
            let ends = v.iter().zip(d).filter(|(_, d)| **d < 0.0);
            ends.fold(f64::INFINITY, |m, (v, d)| m.min(-v / d))
        };
        let rows = line(&self.s, &step.s).min(line(&self.z, &step.z));
        self.cone
            .map_or(rows, |c| rows.min(c.longest(&step.cone_s, &step.cone_z)))
    }
}

//! The spline family: least squares in force space under demands and limits.

use std::f64::consts::TAU;

use super::answer::{Infeasible, Step};
use super::demand::Demand;
use super::limits;
use super::qp::Quadratic;
use super::qp::{Basis, Entries};
use super::qp::{Equality, Failure, Limit, PEAK, Program, Solution};
use crate::error::{Error, Result};
use crate::force::{ForceCurve, spread_rms_n};
use crate::law::Law;
use crate::poly::SplineSpace;
use crate::scene::{Dwell, Family, Minimise, Scene, Weigh};

/// Accuracy that chooses the spans when the scene asks for none, part of the mean force.
const DEFAULT_ACCURACY: f64 = 0.005;
/// Spans tried before "auto" gives up.
const MOST_AUTO_SPANS: usize = 400;
/// Spans for laws that follow no force.
const SPANS_WITHOUT_FORCE: usize = 48;
/// Weight of the jerk term against the force term, both made dimensionless: it settles what the force
/// leaves open (phases of zero weight) and is far below any accuracy.
const JERK_TERM: f64 = 1e-12;
/// Jerk, in typical lifts per rad³, whose mean square weighs as much as one typical lift of radius when
/// size is minimised: large enough to leave the size alone, small enough to keep the law smooth.
const SIZE_JERK: f64 = 1e3;
/// Spans tried first inside a band.
const FEWEST_IN_BAND: usize = 8;
/// … and last.
const MOST_IN_BAND: usize = 120;
/// A limit that is broken may want more spans; they grow by this factor while the error still falls.
const GROWTH: f64 = 1.5;
/// … by at least this part.
const WORTHWHILE: f64 = 0.02;

/// A law of the family, or why there is none.
pub struct Fitted {
    /// The program that was solved.
    pub program: Program,
    /// Its solution.
    pub solution: Solution,
    /// The sequence of convex programs that the loads needed, and why it ended.
    pub sequence: Option<(Vec<Step>, &'static str)>,
    /// Number of spans.
    pub spans: usize,
    /// Degree.
    pub degree: usize,
}

impl Fitted {
    /// The law, as solved.
    pub fn law(&self) -> Law {
        self.program.basis.law(&self.solution.x)
    }
}

/// What a fit ends in.
pub enum Outcome {
    /// A law.
    Law(Box<Fitted>),
    /// The program that has no solution, and why.
    None(Box<Program>, Failure),
    /// Limits that are not convex and leave no law beside the others.
    Fight(Box<Infeasible>),
}

/// Fits the scene's law with its own number of spans, or with the fewest that reach the accuracy.
pub fn fit(scene: &Scene, demand: &Demand) -> Result<Outcome> {
    if let Some(spans) = scene.law.spans {
        return solve(scene, demand, spans);
    }
    if scene.gait.as_ref().is_some_and(|g| g.band.is_some()) {
        return fewest_in_band(scene, demand);
    }
    let of_force = [Minimise::ForceError, Minimise::PeakForceError];
    let follows_force = of_force.contains(&objective(scene));
    let Some(target) = demand.target.as_ref().filter(|_| follows_force) else {
        return solve(scene, demand, SPANS_WITHOUT_FORCE);
    };
    let wanted = accuracy(scene, target);
    // The unlimited fit is the cheaper lower bound: spans that miss the accuracy without limits miss it
    // with them.
    let mut spans = 3;
    while spans < MOST_AUTO_SPANS {
        let program = program(scene, demand, spans, Vec::new())?;
        match super::qp::solve_equalities(&program.0) {
            Ok(u) if rms(&program.1, &u.x) <= wanted => break,
            _ => spans += 1 + spans / 40,
        }
    }
    let mut best: Option<(f64, Box<Fitted>)> = None;
    loop {
        let outcome = solve(scene, demand, spans)?;
        let Outcome::Law(fitted) = outcome else {
            return Ok(match best {
                Some((_, fitted)) => Outcome::Law(fitted),
                None => outcome,
            });
        };
        let error = force_error(scene, demand, &fitted);
        let reached = error <= wanted;
        let hopeless = best
            .as_ref()
            .is_some_and(|(e, _)| error > e * (1.0 - WORTHWHILE));
        let better = match best {
            Some(earlier) if earlier.0 <= error => earlier,
            _ => (error, fitted),
        };
        if reached || hopeless || spans >= MOST_AUTO_SPANS {
            return Ok(Outcome::Law(better.1));
        }
        best = Some(better);
        spans = ((spans as f64 * GROWTH) as usize).min(MOST_AUTO_SPANS);
    }
}

/// Inside a band the fewest spans that have a law there; with none, the answer of the most.
fn fewest_in_band(scene: &Scene, demand: &Demand) -> Result<Outcome> {
    let mut spans = FEWEST_IN_BAND;
    loop {
        let outcome = solve(scene, demand, spans)?;
        if matches!(outcome, Outcome::Law(_)) || spans >= MOST_IN_BAND {
            return Ok(outcome);
        }
        spans = ((spans as f64 * GROWTH) as usize).min(MOST_IN_BAND);
    }
}

/// Force error, N RMS, at which an automatic size is large enough.
pub fn accuracy(scene: &Scene, target: &ForceCurve) -> f64 {
    match scene.rms {
        Some(rms) => rms * target.mean_n().abs(),
        None => noise(target).max(finest(target)),
    }
}

/// Error, N, that is small enough where the scene asks for none and no spread is known.
fn finest(target: &ForceCurve) -> f64 {
    DEFAULT_ACCURACY * target.mean_n().abs()
}

/// Error below which a fit would follow the noise: a fifth of the step-to-step spread, N.
///
/// Such an error adds 2 % to the walker's own variation (1 + 0.2² under the root).
fn noise(target: &ForceCurve) -> f64 {
    0.2 * spread_rms_n(target).unwrap_or(0.0)
}

/// Says so where the spread, not the accuracy, ended the choice of spans (or harmonics, on the ladder).
pub fn stopped_at_noise(scene: &Scene, demand: &Demand, family: Family) -> Option<String> {
    let target = demand.target.as_ref()?;
    let by_force = matches!(objective(scene), Minimise::ForceError);
    let auto = match scene.law.family {
        Family::Spline => scene.law.spans.is_none(),
        asked => asked == Family::Ladder,
    };
    let size = if family == Family::Spline {
        "spans"
    } else {
        "harmonics"
    };
    let (noise, finest) = (noise(target), finest(target));
    (auto && by_force && scene.rms.is_none() && noise > finest).then(|| {
        format!(
            "The {size} stop at an error of {noise:.1} N RMS, a fifth of the walker's step-to-step spread: \
             more would follow its noise. accuracy.rms asks for another."
        )
    })
}

/// The force fit in a given number of harmonics with the scene's limits. `unlimited` is the law without
/// them: where nothing fixes the lift, its lowest angle is taken for the base circle's.
pub fn harmonic_program(scene: &Scene, demand: &Demand, count: usize, unlimited: &Law) -> Program {
    let basis = Basis::Harmonic { count };
    let force = force_distance(scene, demand, &basis);
    let mut program = Program::new(basis, force, Vec::new(), demand.length);
    let level = level_is_known(scene, demand);
    let on_the_cam = limits::size_is_given(scene);
    program.limits = limits::linear(scene, demand, level || on_the_cam);
    program.limits.extend(super::machine::rows(scene, demand));
    if !level && on_the_cam {
        let entries = program
            .basis
            .row(unlimited.extremes(0).0.at, &[1.0, 0.0, 0.0, 0.0]);
        program.equalities.push(Equality {
            name: "base circle".to_string(),
            entries,
            value: 0.0,
        });
    }
    program
}

/// What the scene minimises.
pub fn objective(scene: &Scene) -> Minimise {
    let follows = |g: &crate::scene::Gait| g.band.is_none();
    let default = if scene.gait.as_ref().is_some_and(follows) {
        Minimise::ForceError
    } else {
        Minimise::Energy(3)
    };
    scene.law.minimise.unwrap_or(default)
}

fn rms(force: &Quadratic, x: &[f64]) -> f64 {
    (2.0 * force.value(x)).max(0.0).sqrt()
}

fn force_error(scene: &Scene, demand: &Demand, fitted: &Fitted) -> f64 {
    let force = force_distance(scene, demand, &fitted.program.basis);
    rms(&force, &fitted.solution.x)
}

fn solve(scene: &Scene, demand: &Demand, spans: usize) -> Result<Outcome> {
    let degree = degree(scene);
    let level = level_is_known(scene, demand);
    let mut rows = limits::linear(scene, demand, level);
    rows.extend(super::machine::rows(scene, demand));
    let (mut program, _) = program(scene, demand, spans, Vec::new())?;
    let sought = limits::size_is_sought(scene);
    if !level && (limits::size_is_given(scene) || sought) {
        // The base circle is where the law is lowest, and a given size counts from there. Which angle
        // that is comes from the law without limits.
        if let Ok(unlimited) = super::qp::solve_equalities(&program) {
            let lowest = program.basis.law(&unlimited.x).extremes(0).0.at;
            rows = limits::linear(scene, demand, true);
            rows.extend(super::machine::rows(scene, demand));
            program.equalities.push(Equality {
                name: "base circle".to_string(),
                entries: program.basis.row(lowest, &[1.0, 0.0, 0.0, 0.0]),
                value: 0.0,
            });
        }
    }
    if scene.law.monotone {
        rows.extend(limits::monotone(scene, demand));
    }
    if sought {
        rows.retain(|l| l.name != "base_circle");
    }
    if let Minimise::Peak(order) = objective(scene) {
        for sign in [1.0, -1.0] {
            let mut weights = [0.0; 5];
            weights[order] = sign;
            rows.push(Limit::new("peak", weights, 0.0, demand.length).minimised());
        }
        program.cost[PEAK] = 1.0;
    }
    rows.extend(limits::about_the_target(scene, demand, &mut program)?);
    program.limits = rows;
    if sought {
        limits::with_size(scene, demand, &mut program);
    }
    Ok(match program.solve() {
        Ok(solution) => match super::machine::hold(scene, demand, program, solution) {
            Ok(held) => Outcome::Law(Box::new(Fitted {
                program: held.program,
                solution: held.solution,
                sequence: held.sequence,
                spans,
                degree,
            })),
            Err(infeasible) => Outcome::Fight(Box::new(infeasible)),
        },
        Err(failure) => Outcome::None(Box::new(program), failure),
    })
}

/// Whether the law's zero is fixed by the drive or by a demand.
pub fn level_is_known(scene: &Scene, demand: &Demand) -> bool {
    demand.drive.spring_rate != 0.0
        || scene.law.points.iter().any(|p| p.lift.is_some())
        || scene.law.dwells.iter().any(|d| d.lift.is_some())
        || matches!(scene.law.family, Family::Program)
}

/// The program without limits, and the force distance alone.
fn program(
    scene: &Scene,
    demand: &Demand,
    spans: usize,
    limits: Vec<Limit>,
) -> Result<(Program, Quadratic)> {
    let degree = degree(scene);
    let corners = if scene.law.polydyne { degree - 1 } else { 2 };
    let basis = spline_basis(degree, spans, &scene.law.dwells, corners)?;
    let mut equalities = point_demands(scene, demand, &basis)?;
    equalities.extend(dwell_demands(&scene.law.dwells, &basis));
    let force = force_distance(scene, demand, &basis);
    let mut quadratic = match objective(scene) {
        Minimise::ForceError => force.clone(),
        Minimise::Weighed(weigh) => weighed(demand, &basis, &force, weigh),
        _ => Quadratic::zero(&basis),
    };
    match objective(scene) {
        Minimise::Energy(order) => quadratic.add_energy(&basis, order, 1.0),
        Minimise::Peak(_) | Minimise::PeakForceError | Minimise::Weighed(_) => {}
        Minimise::Size => {
            // ½ μ mean(j²) with μ such that a jerk of SIZE_JERK lengths costs as much as one length of radius.
            let unit = SIZE_JERK * demand.length;
            quadratic.add_energy(&basis, 3, demand.length / (unit * unit));
        }
        Minimise::ForceError => {
            let scale = quadratic.hessian.largest_diagonal();
            let mut jerk = Quadratic::zero(&basis);
            jerk.add_energy(&basis, 3, 1.0);
            let own = jerk.hessian.largest_diagonal();
            if own > 0.0 {
                quadratic.add_energy(&basis, 3, JERK_TERM * scale / own);
            }
        }
    }
    let mut program = Program::new(basis, quadratic, equalities, demand.length);
    program.limits = limits;
    Ok((program, force))
}

/// The quadratic part of (e/e₁)² + R/R₁ + (j/j₁)²; `force` holds ½e².
fn weighed(demand: &Demand, basis: &Basis, force: &Quadratic, weigh: Weigh) -> Quadratic {
    let mean = demand.target.as_ref().map_or(0.0, |t| t.mean_n().abs());
    let mut sum = Quadratic::zero(basis);
    if let Some(part) = weigh.force_error {
        sum = force.times(2.0 / (part * mean).powi(2));
    }
    if let Some(one) = weigh.jerk {
        let by_angle = one / demand.drive.speed.powi(3);
        sum.add_energy(basis, 3, 2.0 / (by_angle * by_angle));
    } else {
        // What force and size leave open, as where size alone is minimised.
        let unit = SIZE_JERK * demand.length;
        let radius = weigh.prime_radius.unwrap_or(demand.length);
        sum.add_energy(basis, 3, demand.length / radius / (unit * unit));
    }
    sum
}

fn force_distance(scene: &Scene, demand: &Demand, basis: &Basis) -> Quadratic {
    let mut force = Quadratic::zero(basis);
    if let Some(target) = &demand.target {
        let w = demand.drive.weights();
        let pieces = basis.breaks().len() - 1;
        let degree = match basis {
            Basis::Spline { space, .. } => space.degree(),
            Basis::Harmonic { .. } => 6,
        };
        let weight = |x: f64| demand.weight(scene, x);
        let weighed = scene.gait.as_ref().is_some_and(|g| !g.weights.is_empty());
        let nodes = (degree + 2).max(target.force_n.len().div_ceil(pieces));
        force.add_distance(
            basis,
            &w,
            nodes,
            |start, width, places, out| {
                demand.wanted_on(start, width, places, out);
                out.iter_mut().for_each(|f| *f -= demand.drive.rest_force);
            },
            weighed.then_some(&weight),
        );
    }
    force
}

/// Degree of the scene's splines: 5, or two more for the first terms of a polydyne follower's damping.
fn degree(scene: &Scene) -> usize {
    let damped = scene.law.polydyne && scene.machine.damping_ratio > 0.0;
    scene.law.degree.unwrap_or(if damped { 7 } else { 5 })
}

/// Periodic splines over the turn with `spans` spans outside the dwells, with `smooth` continuous
/// derivatives at the dwells' ends.
fn spline_basis(degree: usize, spans: usize, dwells: &[Dwell], smooth: usize) -> Result<Basis> {
    if dwells.is_empty() {
        let space = SplineSpace::periodic_uniform(degree, spans, TAU);
        return Ok(Basis::Spline {
            space,
            closed: true,
        });
    }
    let rests = rests(dwells)?;
    let mut corners: Vec<f64> = rests
        .iter()
        .flat_map(|r| [r.0, r.1])
        .filter(|x| *x > 0.0 && *x < TAU)
        .collect();
    corners.sort_by(f64::total_cmp);
    corners.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
    let ends: Vec<f64> = std::iter::once(0.0)
        .chain(corners.iter().copied())
        .chain([TAU])
        .collect();
    let resting = |mid: f64| rests.iter().any(|r| mid > r.0 && mid < r.1);
    let moving: f64 = ends
        .windows(2)
        .filter(|w| !resting(0.5 * (w[0] + w[1])))
        .map(|w| w[1] - w[0])
        .sum();
    let mut breaks = vec![0.0];
    let mut multiplicity = Vec::new();
    // As smooth as the degree allows where rest and motion do not meet.
    let corner = degree.saturating_sub(smooth).max(1);
    for w in ends.windows(2) {
        let rests_here = resting(0.5 * (w[0] + w[1]));
        let parts = if rests_here {
            1
        } else {
            ((spans as f64 * (w[1] - w[0]) / moving).round() as usize).max(1)
        };
        let is_corner = w[0] > 0.0 || (resting(0.5 * (w[0] + w[1])) != resting(TAU - 1e-9));
        multiplicity.push(if is_corner { corner } else { 1 });
        for p in 1..=parts {
            let x = if p == parts {
                w[1]
            } else {
                w[0] + (w[1] - w[0]) * p as f64 / parts as f64
            };
            breaks.push(x);
            if p < parts {
                multiplicity.push(1);
            }
        }
    }
    let space = SplineSpace::periodic(degree, &breaks, &multiplicity);
    Ok(Basis::Spline {
        space,
        closed: true,
    })
}

/// Dwells as ranges inside [0, 2π], those across 0 cut in two.
fn rests(dwells: &[Dwell]) -> Result<Vec<(f64, f64)>> {
    let mut out = Vec::new();
    for (i, d) in dwells.iter().enumerate() {
        let key = format!("law.dwell[{}]", i + 1);
        let inside = |x: f64| (-1e-9..=TAU + 1e-9).contains(&x);
        if !inside(d.from) || !inside(d.to) || d.from == d.to {
            return Err(Error::key(
                &key,
                format!(
                    "{:.3}° to {:.3}° is no range of one turn",
                    d.from.to_degrees(),
                    d.to.to_degrees()
                ),
            )
            .help("angles run from 0 to 360 deg"));
        }
        let (from, to) = (d.from.clamp(0.0, TAU), d.to.clamp(0.0, TAU));
        if from < to {
            out.push((from, to));
        } else {
            out.push((from, TAU));
            out.push((0.0, to));
        }
    }
    let mut sorted = out.clone();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    if sorted.windows(2).any(|w| w[0].1 > w[1].0 + 1e-12) {
        return Err(Error::key("law.dwell", "two dwells overlap").help("write them as one"));
    }
    if (sorted.iter().map(|r| r.1 - r.0).sum::<f64>() - TAU).abs() < 1e-9 {
        return Err(
            Error::key("law.dwell", "the dwells fill the whole turn").help("leave room for motion")
        );
    }
    out.retain(|r| r.1 > r.0);
    Ok(out)
}

fn point_demands(scene: &Scene, demand: &Demand, basis: &Basis) -> Result<Vec<Equality>> {
    let mut out = Vec::new();
    let w = demand.drive.weights();
    for (i, p) in scene.law.points.iter().enumerate() {
        let key = format!("law.point[{}]", i + 1);
        if !(-1e-9..=TAU + 1e-9).contains(&p.angle) {
            return Err(Error::key(
                &key,
                format!("{:.3}° lies outside the turn", p.angle.to_degrees()),
            )
            .help("angles run from 0 to 360 deg"));
        }
        let mut push = |what: &str, weights: &[f64], value: f64| {
            let name = format!("{key} at {:.2}°: {what}", p.angle.to_degrees());
            out.push(Equality {
                name,
                entries: basis.row(p.angle, weights),
                value,
            });
        };
        for (order, (what, value)) in [
            ("lift", p.lift),
            ("velocity", p.velocity),
            ("acceleration", p.acceleration),
            ("jerk", p.jerk),
        ]
        .into_iter()
        .enumerate()
        {
            if let Some(value) = value {
                let mut weights = [0.0; 4];
                weights[order] = 1.0;
                push(what, &weights, value);
            }
        }
        if let Some(force) = p.force {
            push("force", &w, force - demand.drive.rest_force);
        }
    }
    Ok(out)
}

/// On a span at rest every coefficient that lives there is the same.
fn dwell_demands(dwells: &[Dwell], basis: &Basis) -> Vec<Equality> {
    let Basis::Spline { space, .. } = basis else {
        return Vec::new();
    };
    let mut out: Vec<Equality> = Vec::new();
    for (d, dwell) in dwells.iter().enumerate() {
        let name = format!("law.dwell[{}]", d + 1);
        let mut resting: Vec<usize> = Vec::new();
        for (i, span) in space.spans().iter().enumerate() {
            let mid = span.start + 0.5 * span.width;
            let inside = if dwell.from < dwell.to {
                mid > dwell.from && mid < dwell.to
            } else {
                mid > dwell.from || mid < dwell.to
            };
            if inside {
                for k in 0..=space.degree() {
                    let index = space.index(i, k);
                    if !resting.contains(&index) {
                        resting.push(index);
                    }
                }
            }
        }
        let rows: Vec<(Entries, f64)> = match dwell.lift {
            Some(lift) => resting.iter().map(|&i| (vec![(i, 1.0)], lift)).collect(),
            None => resting
                .windows(2)
                .map(|w| (vec![(w[0], 1.0), (w[1], -1.0)], 0.0))
                .collect(),
        };
        out.extend(rows.into_iter().map(|(entries, value)| Equality {
            name: name.clone(),
            entries,
            value,
        }));
    }
    out
}

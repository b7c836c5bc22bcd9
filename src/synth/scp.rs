//! Limits that are not convex in the law, by a sequence of convex programs that stays feasible: a roller's
//! curvature, and curvature and pressure angle of followers on an arm.
//!
//! With X = D + s, Y = v − e, w = X² + Y² and ρ = ρ_cam,min + R_f the pitch curve is nowhere sharper than ρ
//! where h = w^{3/2}/ρ − (w + vY − aX) ≥ 0 (theory §6). That is not convex. It is linearised about the last
//! law at the places where it is near zero, the convex program is solved again, and the step is shortened
//! until the true h holds all around: every limit that is convex holds along the whole step.
//! A whole step that breaks h is linearised once more about its own end (Newton's method on the contacts), and cut
//! short only where that does not mend it.
//! The first steps use the restriction a ≥ X − X²/ρ with X² ≥ 2X₀X − X₀², which is sufficient for X ≥ 4ρ/3
//! and needs no trust in the linearisation. Followers on an arm go the same way with the h of their own
//! geometry. A concave profile needs no row: its radius is the pitch curve's plus the roller's, so the
//! roller always fits.

mod corrected;
mod start;

use corrected::corrected;

use super::design::Step;
use super::limits::{NonconvexLimits, ProfileSize, clearance, clearances, relative};
use super::method::Ended;
use super::qp::{EXTRAS, Limit, OFFSET, Program, RADIUS, RISE, Row, SIZES, Solution, apply};
use crate::cam::LimitKind;
use crate::poly::{Peak, PiecewisePoly};

/// Steps before the sequence is called finished as it is.
const MOST_STEPS: usize = 40;
/// A step must promise to improve the merit by this part, and do so, or the sequence ends.
const IMPROVEMENT: f64 = 1e-7;
/// Tolerance of the limits between steps; the last law is solved to rounding.
const STEP_TOLERANCE: f64 = 1e-6;
/// Rows per piece of the law.
const ROWS_PER_PIECE: usize = 4;
/// Places where h exceeds this part of its largest term are left out of a step; the search along the step
/// watches them.
const FAR: f64 = 0.6;
/// Low points of h/w below this become rows.
const NEAR: f64 = 0.05;
/// A place this near (in units of its piece) to another one is the same.
const COINCIDENT: f64 = 1e-6;
/// What the exchange of rows leaves further outside a limit than this is no solution.
const BROKEN: f64 = 1e-4;
/// Room kept in h, relative to w, so that the finished cam passes its own check.
const ROOM: f64 = 1e-9;
/// A start that misses by less than this, relative to w, is sought with more room.
const NEARLY: f64 = 1e-3;
/// Linearisations tried for the last law.
const HELD_ROUNDS: usize = 6;
/// Part by which the last law's size is held larger than the sequence's.
pub const ENLARGED: f64 = 4.0 * STEP_TOLERANCE;
/// A mended step that gains less than this part of what the step promised is held against its parts.
const WORTH_MENDING: f64 = 0.5;
/// Limits with this part of their size to spare, or less, may bind after the next step.
const SOON: f64 = 0.03;
/// Weight of a size that has to shrink, against what is minimised.
const FOREMOST: f64 = 1e3;
/// Steps are shortened to no less than this.
const SHORTEST: f64 = 1e-4;

/// Improves a law of `program` until no step that keeps the follower's limits as well improves it: the best of those to
/// which the `starts` lead, laws that keep what is convex but for the size. Where the program has the size among its
/// variables, the follower's own is not looked at.
///
/// Returns the last solution with its size, the steps taken and why no more were, or `None` where no
/// feasible start was found.
pub fn refine(
    program: &Program,
    starts: &[Solution],
    limits: NonconvexLimits,
) -> Option<(Solution, Vec<Step>, Ended)> {
    // Between steps limits need not hold better than the next step will change them.
    let mut program = program.clone();
    program.settings.tolerance = STEP_TOLERANCE;
    let program = &program;
    let present = program.present();
    let given = limits.size();
    let sized = |extra: &[f64; EXTRAS]| sized(&limits, &present, given, extra);
    let merit = |s: &Solution| {
        program.objective(&s.x)
            + program.constant
            + (0..EXTRAS)
                .map(|k| program.cost[k] * s.extra[k])
                .sum::<f64>()
    };
    let mut current = starts
        .iter()
        .filter_map(|start| start::feasible(program, start, &sized))
        .min_by(|a, b| merit(a).total_cmp(&merit(b)))
        .or_else(|| start::tightened(program, starts.last()?, &sized))
        .or_else(|| shrunk(program, starts.last()?, limits))?;
    let mut steps = Vec::new();
    let mut ended = Ended::MostSteps;
    // Part by which a step may make the cam smaller: a size alone in the objective draws the law as far as the
    // linearised limits let it, beyond where they say anything.
    let priced = SIZES.iter().any(|&k| program.cost[k] != 0.0);
    let mut reach = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        if program.halt.is_asked() {
            ended = Ended::OutOfTime;
            break;
        }
        let here = sized(&current.extra);
        let near = within_reach(program, &current, reach);
        let mut next = near.clone();
        next.fixed = linearised(program, &current, &here, &present, &Room::above(0.0));
        next.seeds = contacts(program, &current);
        let Some(target) = solved(&next) else {
            if priced && reach > SHORTEST {
                reach = 0.5 * reach.min(1.0);
                continue;
            }
            ended = Ended::NoSolution;
            break;
        };
        let gained = |trial: &Solution| merit(&current) - merit(trial);
        if gained(&target) <= IMPROVEMENT * merit(&current).abs() {
            ended = Ended::SmallGain;
            break;
        }
        let whole = corrected(&near, &target, &sized).filter(|(trial, _)| gained(trial) > 0.0);
        let mut taken = 1.0;
        // Where mending the whole step costs most of what it promised, a part of it may bring more.
        let enough = WORTH_MENDING * gained(&target);
        let good = (whole.as_ref()).is_some_and(|(trial, _)| gained(trial) >= enough);
        if good {
            reach *= 2.0;
        } else {
            let there = sized(&target.extra).size().prime_radius();
            reach = 0.5 * (1.0 - there / here.size().prime_radius()).min(reach);
        }
        let accepted = if good {
            whole
        } else {
            let least = whole.as_ref().map_or(0.0, |(trial, _)| gained(trial));
            let mut part = 1.0;
            let shortened = loop {
                let mut trial = blend(&current, &target, part, program);
                (trial.iterations, trial.rounds) = (target.iterations, target.rounds);
                let room = clearance(&program.basis.law(&trial.x), &sized(&trial.extra));
                if room >= ROOM && gained(&trial) > least {
                    taken = part;
                    break Some((trial, room));
                }
                part *= 0.5;
                if part < SHORTEST {
                    break None;
                }
            };
            shortened.or(whole)
        };
        let Some((mut trial, room)) = accepted else {
            if priced && reach > SHORTEST {
                continue;
            }
            ended = Ended::NoImprovement;
            break;
        };
        let gain = merit(&current) - merit(&trial);
        let old = merit(&current);
        trial.iterations += current.iterations;
        trial.rounds += current.rounds;
        let own = |row: &Row| row.limit.is_none_or(|limit| limit < program.limits.len());
        trial.active.retain(own);
        current = trial;
        let there = sized(&current.extra).size();
        steps.push(Step {
            prime_radius: there.prime_radius(),
            merit: merit(&current),
            clearance: room,
            taken,
        });
        if gain <= IMPROVEMENT * old.abs() {
            ended = Ended::SmallGain;
            break;
        }
    }
    if let Some(exact) = held(program, &current, sized(&current.extra)) {
        let active = current.active;
        current = Solution {
            active,
            extra: current.extra,
            iterations: current.iterations + exact.iterations,
            ..exact
        };
    }
    Some((current, steps, ended))
}

/// A start by shrinking a cam that is larger than allowed: the sequence itself with the size in front of what it minimises.
fn shrunk(program: &Program, start: &Solution, limits: NonconvexLimits) -> Option<Solution> {
    if program.keeps_sizes(&start.extra) {
        return None;
    }
    let size = SIZES.iter().fold(0.0_f64, |m, &k| m.max(start.extra[k]));
    let rest = (program.objective(&start.x) + program.constant).abs();
    let priced = program.with_sizes_priced(&start.extra, FOREMOST * rest / size);
    let (found, ..) = refine(&priced, std::slice::from_ref(start), limits)?;
    program.keeps_sizes(&found.extra).then_some(Solution {
        active: Vec::new(),
        ..found
    })
}

/// The program with the sizes that it prices held above the present ones less this part.
fn within_reach(program: &Program, current: &Solution, part: f64) -> Program {
    let mut out = program.clone();
    if part.is_finite() {
        for k in SIZES.into_iter().filter(|&k| program.cost[k] > 0.0) {
            let least = (1.0 - part) * current.extra[k];
            let mut limit = Limit::new(LimitKind::PrimeRadius, [0.0; 5], -least, program.length);
            limit.extra[k] = -1.0;
            limit.domain = (0.0, 0.0);
            out.limits.push(limit);
        }
    }
    out
}

/// Room kept in h, relative to w, in each of the limits.
struct Room {
    /// What is kept in every one.
    level: f64,
    each: Vec<f64>,
}

impl Room {
    fn above(level: f64) -> Room {
        Room {
            level,
            each: Vec::new(),
        }
    }

    fn of(&self, limit: usize) -> f64 {
        let least = self.level + 2.0 * ROOM;
        self.each.get(limit).map_or(least, |own| own.max(least))
    }

    /// Low points wander between two programs: a limit that they miss by little needs a little more room than that. One
    /// that holds may have no more to give.
    fn widen(&mut self, clear: &[f64]) {
        self.each.resize(clear.len(), f64::NEG_INFINITY);
        for (own, clear) in self.each.iter_mut().zip(clear) {
            let missed = self.level - clear;
            if missed > 0.0 && missed < NEARLY {
                *own = own.max(self.level + 2.0 * missed);
            }
        }
    }
}

/// The least of several clearances.
fn least(clear: &[f64]) -> f64 {
    clear.iter().copied().fold(f64::INFINITY, f64::min)
}

/// The solution of a program, where there is one.
fn solved(program: &Program) -> Option<Solution> {
    program.solve().ok().filter(|s| s.violation <= BROKEN)
}

/// A solution that holds the limits beside the program's own, from the program's `start`; `None` where
/// none was found.
pub fn feasible(program: &Program, start: &Solution, limits: NonconvexLimits) -> Option<Solution> {
    let present = program.present();
    let given = limits.size();
    let sized = |extra: &[f64; EXTRAS]| sized(&limits, &present, given, extra);
    start::feasible(program, start, &sized).or_else(|| start::tightened(program, start, &sized))
}

/// The limits at the size that a solution has, where it is among the variables.
pub fn sized(
    limits: &NonconvexLimits,
    present: &[bool; EXTRAS],
    given: ProfileSize,
    extra: &[f64; EXTRAS],
) -> NonconvexLimits {
    let of = |k: usize, given: f64| if present[k] { extra[k] } else { given };
    limits.at_size(ProfileSize {
        rise: of(RISE, given.rise),
        offset: of(OFFSET, given.offset),
        radius: of(RADIUS, given.radius),
        rho: given.rho,
    })
}

/// The law nearest to the last one whose limits hold to rounding, the size held a hair larger.
fn held(program: &Program, current: &Solution, limits: NonconvexLimits) -> Option<Solution> {
    // A given size stays as it is.
    let present = program.present();
    let size = limits.size();
    let room = if present[RISE] || (present[RADIUS] && size.radius > 0.0) {
        ENLARGED
    } else {
        0.0
    };
    let enlarged = limits.at_size(ProfileSize {
        rise: size.rise * (1.0 + room),
        radius: size.radius * (1.0 + room),
        ..size
    });
    let gradient: Vec<f64> = program
        .hessian
        .times(&current.x)
        .iter()
        .map(|g| -g)
        .collect();
    let mut about = current.clone();
    let mut kept = Room::above(0.0);
    for _ in 0..HELD_ROUNDS {
        let mut last = program.clone();
        last.fixed = linearised(program, &about, &enlarged, &[false; EXTRAS], &kept);
        // Nearest to the law at hand, so that the linearised curvature stays true.
        last.gradient.clone_from(&gradient);
        last.lifted = None;
        let mut exact = solved(&last.with_sizes_held(current, room))?;
        let violation = exact.violation;
        let clear = clearances(&program.basis.law(&exact.x), &enlarged);
        if least(&clear) >= 0.0 {
            return (violation < current.violation).then_some(exact);
        }
        kept.widen(&clear);
        exact.extra = about.extra;
        about = exact;
    }
    None
}

/// Where the limits themselves touched in the last program, or soon may: rows that the next one need not find.
fn contacts(program: &Program, solution: &Solution) -> Vec<Row> {
    let own = solution.active.iter().filter(|r| r.limit.is_some());
    let mut out: Vec<Row> = own.cloned().collect();
    let soon = |limit: &Limit| {
        let room = program.room(limit, &solution.x, &solution.extra);
        room - SOON * limit.size(room)
    };
    program.each_peak_above(&solution.x, soon, |index, peak| {
        let known = |r: &Row| r.limit == Some(index) && r.peak.piece == peak.piece;
        if !out.iter().any(known) {
            out.push(program.row(index, peak));
        }
    });
    out
}

/// Rows of h₀ + ∇h·(step) ≥ room·w where h is small enough for one step to matter.
fn linearised(
    program: &Program,
    current: &Solution,
    limits: &NonconvexLimits,
    present: &[bool; EXTRAS],
    room: &Room,
) -> Vec<Row> {
    let law = program.basis.law(&current.x);
    let mut out = Vec::new();
    let mut places = Vec::new();
    each_place(program, |place| places.push(place));
    // The rows of the grid bound h between them only to second order; its own low points are rows too.
    for curve in relative(&law, limits) {
        let low = PiecewisePoly::combine(&[(-1.0, &curve)], 0.0).peaks_above(-NEAR, 0.0, f64::MAX);
        for dip in low {
            let (piece, u) = law.poly().locate(dip.at);
            places.push(Peak {
                piece,
                u,
                at: dip.at,
                value: 0.0,
            });
        }
    }
    // A low point wanders from one law to the next: rows on both sides of a contact close in on it like a secant.
    let touched = current.active.iter().filter(|r| r.limit.is_none());
    for peak in touched.map(|r| r.peak) {
        let near = |p: &Peak| p.piece == peak.piece && (p.u - peak.u).abs() < COINCIDENT;
        if !places.iter().any(near) {
            places.push(peak);
        }
    }
    let size = limits.size();
    for place in places {
        let at = law.svaj_on(place.piece, place.u);
        for (k, s) in limits.slacks(at).into_iter().enumerate() {
            if s.h > FAR * s.largest {
                continue;
            }
            // Σ −∂h·x ≤ h₀ − Σ ∂h·x₀, with room for the check.
            let mut bound = s.h
                - room.of(k) * s.w
                - s.by_lift * at.s
                - s.by_velocity * at.v
                - s.by_acceleration * at.a
                - s.by_jerk * at.j;
            let mut extra = [0.0; EXTRAS];
            if present[RISE] {
                extra[RISE] = -s.by_rise;
                bound -= s.by_rise * size.rise;
            }
            if present[OFFSET] {
                extra[OFFSET] = -s.by_offset;
                bound -= s.by_offset * size.offset;
            }
            if present[RADIUS] && s.by_radius != 0.0 {
                extra[RADIUS] = -s.by_radius;
                bound -= s.by_radius * size.radius;
            }
            let weights = [-s.by_lift, -s.by_velocity, -s.by_acceleration, -s.by_jerk];
            let one = row(program, place, &weights, extra, bound, s.w);
            out.push(Row {
                name: s.name,
                ..one
            });
        }
    }
    out
}

fn each_place(program: &Program, mut visit: impl FnMut(Peak)) {
    let breaks = program.basis.breaks();
    for piece in 0..breaks.len() - 1 {
        for k in 0..=ROWS_PER_PIECE {
            let u = k as f64 / ROWS_PER_PIECE as f64;
            let at = breaks[piece] + u * (breaks[piece + 1] - breaks[piece]);
            visit(Peak {
                piece,
                u,
                at,
                value: 0.0,
            });
        }
    }
}

fn row(
    program: &Program,
    peak: Peak,
    weights: &[f64],
    extra: [f64; EXTRAS],
    bound: f64,
    scale: f64,
) -> Row {
    let entries = program.basis.row_on(peak.piece, peak.u, weights);
    let mut all = [0.0; 5];
    all[..weights.len()].copy_from_slice(weights);
    Row {
        limit: None,
        name: LimitKind::Curvature.into(),
        peak,
        weights: all,
        entries,
        touching: Vec::new(),
        extra,
        bound,
        scale,
        multiplier: 0.0,
    }
}

/// A point on the way from one solution to another; convex limits that hold at both ends hold there.
fn blend(from: &Solution, to: &Solution, part: f64, program: &Program) -> Solution {
    let mix = |a: f64, b: f64| a + part * (b - a);
    let x: Vec<f64> = from.x.iter().zip(&to.x).map(|(a, b)| mix(*a, *b)).collect();
    let mut extra = [0.0; EXTRAS];
    for (k, value) in extra.iter_mut().enumerate() {
        *value = mix(from.extra[k], to.extra[k]);
    }
    if program.cone {
        extra[RADIUS] = extra[RISE].hypot(extra[OFFSET]);
    }
    debug_assert!(
        program
            .equalities
            .iter()
            .all(|e| (apply(&e.entries, &x) - e.value).abs() < 1e-6 * program.length)
    );
    let violation = program.violation(&x, &extra);
    Solution {
        x,
        extra,
        violation,
        active: to.active.clone(),
        used_rows: true,
        ..*from
    }
}

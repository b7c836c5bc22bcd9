//! Roller curvature by a sequence of convex programs that stays feasible.
//!
//! With X = D + s, Y = v − e, w = X² + Y² and ρ = ρ_cam,min + R_f the pitch curve is nowhere sharper than ρ
//! where h = w^{3/2}/ρ − (w + vY − aX) ≥ 0 (FACTS §6). That is not convex. It is linearised about the last
//! law at the places where it is near zero, the convex program is solved again, and the step is shortened
//! until the true h holds all around: every limit that is convex holds along the whole step.
//! The first steps use the restriction a ≥ X − X²/ρ with X² ≥ 2X₀X − X₀², which is sufficient for X ≥ 4ρ/3
//! and needs no trust in the linearisation.

use super::answer::Step;
use super::basis::apply;
use super::problem::{EXTRAS, OFFSET, Program, RADIUS, RISE, Row, Solution};
use crate::law::{Law, Svaj};
use crate::poly::{Peak, PiecewisePoly, stand_in};

/// Size of a roller cam.
#[derive(Debug, Clone, Copy)]
pub struct Size {
    /// D.
    pub rise: f64,
    /// e.
    pub offset: f64,
    /// Smallest pitch radius allowed: smallest convex radius of the cam plus the roller's.
    pub rho: f64,
}

/// Steps before the sequence is called finished as it is.
const MOST_STEPS: usize = 40;
/// The merit must improve by this part, or the sequence ends.
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
/// Room kept in h, relative to w, so that the finished cam passes its own check.
const ROOM: f64 = 1e-9;
/// Linearisations tried for the last law.
const HELD_ROUNDS: usize = 6;
/// Steps are shortened to no less than this.
const SHORTEST: f64 = 1e-4;

/// h and its derivatives by s, v, a, D, e.
struct Slack {
    h: f64,
    w: f64,
    by_lift: f64,
    by_velocity: f64,
    by_acceleration: f64,
    by_offset: f64,
}

fn slack(at: Svaj, size: Size) -> Slack {
    let (x, y) = (size.rise + at.s, at.v - size.offset);
    let w = x * x + y * y;
    let root = w.sqrt();
    let h = w * root / size.rho - (w + at.v * y - at.a * x);
    let by_x = 3.0 * x * root / size.rho - (2.0 * x - at.a);
    let by_y = 3.0 * y * root / size.rho - (2.0 * y + at.v);
    Slack {
        h,
        w,
        by_lift: by_x,
        by_velocity: by_y - y,
        by_acceleration: x,
        by_offset: -by_y,
    }
}

/// h/w over the law.
fn relative(law: &Law, size: Size) -> PiecewisePoly {
    let breaks = law.breaks();
    stand_in(breaks, 1e-11, |i, x| {
        let at = law.svaj_on(i, (x - breaks[i]) / (breaks[i + 1] - breaks[i]));
        let s = slack(at, size);
        s.h / s.w
    })
}

/// Smallest h/w over the law.
pub fn clearance(law: &Law, size: Size) -> f64 {
    relative(law, size).extremes().0.value
}

/// Improves `program`'s solution until the curvature holds as well; `start` is its optimum without
/// curvature, `size` gives the roller and, where the program has no size among its variables, the size.
///
/// Returns the last solution with its size, the steps taken and why no more were, or `None` where no
/// feasible start was found.
pub fn refine(
    program: &Program,
    start: &Solution,
    size: Size,
) -> Option<(Solution, Vec<Step>, &'static str)> {
    // Between steps limits need not hold better than the next step will change them.
    let program = &Program {
        tolerance: STEP_TOLERANCE,
        ..program.clone()
    };
    let present = program.present();
    let sized = |extra: &[f64; EXTRAS]| Size {
        rise: if present[RISE] {
            extra[RISE]
        } else {
            size.rise
        },
        offset: if present[OFFSET] {
            extra[OFFSET]
        } else {
            size.offset
        },
        rho: size.rho,
    };
    let mut current = feasible_start(program, start, &sized)?;
    let merit = |s: &Solution| {
        program.objective(&s.x)
            + (1..EXTRAS)
                .map(|k| program.cost[k] * s.extra[k])
                .sum::<f64>()
    };
    let mut steps = Vec::new();
    let mut ended = "as many steps as are allowed were taken";
    for _ in 0..MOST_STEPS {
        let here = sized(&current.extra);
        let mut next = program.clone();
        next.fixed = linearised(program, &current, here, &present);
        next.seeds = contacts(&current);
        let Ok(target) = next.solve() else {
            ended = "the linearised program has no solution beside the last law";
            break;
        };
        let mut taken = 1.0;
        let accepted = loop {
            let trial = blend(&current, &target, taken, program);
            let room = clearance(&program.basis.law(&trial.x), sized(&trial.extra));
            if room >= ROOM && merit(&trial) < merit(&current) {
                break Some((trial, room));
            }
            taken *= 0.5;
            if taken < SHORTEST {
                break None;
            }
        };
        let Some((mut trial, room)) = accepted else {
            ended = "no part of the last step improves the objective";
            break;
        };
        let gain = merit(&current) - merit(&trial);
        let old = merit(&current);
        trial.iterations = current.iterations + target.iterations;
        trial.rounds = current.rounds + target.rounds;
        current = trial;
        let there = sized(&current.extra);
        steps.push(Step {
            prime_radius: there.rise.hypot(there.offset),
            merit: merit(&current),
            clearance: room,
            taken,
        });
        if gain <= IMPROVEMENT * old.abs() {
            ended = "the last step improved the objective by less than one part in ten million";
            break;
        }
    }
    let size = sized(&current.extra);
    if let Some(exact) = held(program, &current, size) {
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

/// The law nearest to the last one whose limits hold to rounding, the size held a hair larger.
fn held(program: &Program, current: &Solution, size: Size) -> Option<Solution> {
    // A given size stays as it is.
    let room = if program.present()[RISE] {
        4.0 * STEP_TOLERANCE
    } else {
        0.0
    };
    let enlarged = Size {
        rise: size.rise * (1.0 + room),
        ..size
    };
    let gradient: Vec<f64> = program
        .hessian
        .times(&current.x)
        .iter()
        .map(|g| -g)
        .collect();
    let mut about = current.clone();
    for _ in 0..HELD_ROUNDS {
        let mut last = program.clone();
        last.fixed = linearised(program, &about, enlarged, &[false; EXTRAS]);
        // Nearest to the law at hand, so that the linearised curvature stays true.
        last.gradient.clone_from(&gradient);
        let mut exact = last.with_sizes_held(current, room).solve().ok()?;
        let violation = exact.violation;
        if clearance(&program.basis.law(&exact.x), enlarged) >= 0.0 {
            return (violation < current.violation).then_some(exact);
        }
        exact.extra = about.extra;
        about = exact;
    }
    None
}

/// Where the limits themselves touched in the last program.
fn contacts(solution: &Solution) -> Vec<Row> {
    solution
        .active
        .iter()
        .filter(|r| r.limit.is_some())
        .cloned()
        .collect()
}

/// The start itself where it holds; otherwise the optimum under the sufficient restriction, tightened
/// about its own X a few times.
fn feasible_start(
    program: &Program,
    start: &Solution,
    sized: &impl Fn(&[f64; EXTRAS]) -> Size,
) -> Option<Solution> {
    let mut current = start.clone();
    for _ in 0..20 {
        let here = sized(&current.extra);
        if clearance(&program.basis.law(&current.x), here) >= ROOM {
            return Some(current);
        }
        let mut next = program.clone();
        next.fixed = restricted(program, &current, here);
        next.seeds = contacts(&current);
        let solved = next.solve().ok()?;
        current = Solution {
            iterations: current.iterations + solved.iterations,
            ..solved
        };
    }
    None
}

/// Rows of a + (2X₀/ρ − 1)X − X₀²/ρ ≥ 0 all around, X₀ no smaller than the 4ρ/3 that makes it sufficient.
fn restricted(program: &Program, current: &Solution, size: Size) -> Vec<Row> {
    let present = program.present();
    let law = program.basis.law(&current.x);
    let sufficient = 4.0 / 3.0 * size.rho;
    let mut out = Vec::new();
    each_place(program, |place| {
        let at = law.svaj_on(place.piece, place.u);
        let x0 = (size.rise + at.s).max(sufficient);
        let by_x = 2.0 * x0 / size.rho - 1.0;
        let mut bound = -x0 * x0 / size.rho;
        let mut extra = [0.0; EXTRAS];
        if present[RISE] {
            extra[RISE] = -by_x;
        } else {
            bound += by_x * size.rise;
        }
        out.push(row(program, place, &[-by_x, 0.0, -1.0], extra, bound, x0));
        if present[RISE] {
            let mut high_enough = [0.0; EXTRAS];
            high_enough[RISE] = -1.0;
            out.push(row(program, place, &[-1.0], high_enough, -sufficient, x0));
        }
    });
    out
}

/// Rows of h₀ + ∇h·(step) ≥ 0 where h is small enough for one step to matter.
fn linearised(
    program: &Program,
    current: &Solution,
    size: Size,
    present: &[bool; EXTRAS],
) -> Vec<Row> {
    let law = program.basis.law(&current.x);
    let mut out = Vec::new();
    let mut places = Vec::new();
    each_place(program, |place| places.push(place));
    // The rows of the grid bound h between them only to second order; its own low points are rows too.
    let low = PiecewisePoly::combine(&[(-1.0, &relative(&law, size))], 0.0).peaks_above(
        -NEAR,
        0.0,
        f64::MAX,
    );
    for dip in low {
        let (piece, u) = law.poly().locate(dip.at);
        places.push(Peak {
            piece,
            u,
            at: dip.at,
            value: 0.0,
        });
    }
    for place in places {
        let at = law.svaj_on(place.piece, place.u);
        let s = slack(at, size);
        if s.h > FAR * s.w.powf(1.5) / size.rho {
            continue;
        }
        // Σ −∂h·x ≤ h₀ − Σ ∂h·x₀, with room for the check.
        let mut bound = s.h
            - 2.0 * ROOM * s.w
            - s.by_lift * at.s
            - s.by_velocity * at.v
            - s.by_acceleration * at.a;
        let mut extra = [0.0; EXTRAS];
        if present[RISE] {
            extra[RISE] = -s.by_lift;
            bound -= s.by_lift * size.rise;
        }
        if present[OFFSET] {
            extra[OFFSET] = -s.by_offset;
            bound -= s.by_offset * size.offset;
        }
        out.push(row(
            program,
            place,
            &[-s.by_lift, -s.by_velocity, -s.by_acceleration],
            extra,
            bound,
            s.w,
        ));
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
    Row {
        limit: None,
        peak,
        entries,
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
    if program.present()[RADIUS] {
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

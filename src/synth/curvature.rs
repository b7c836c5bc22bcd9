//! Limits that are not convex in the law, by a sequence of convex programs that stays feasible: a roller's
//! curvature, and curvature and pressure angle of followers on an arm.
//!
//! With X = D + s, Y = v − e, w = X² + Y² and ρ = ρ_cam,min + R_f the pitch curve is nowhere sharper than ρ
//! where h = w^{3/2}/ρ − (w + vY − aX) ≥ 0 (FACTS §6). That is not convex. It is linearised about the last
//! law at the places where it is near zero, the convex program is solved again, and the step is shortened
//! until the true h holds all around: every limit that is convex holds along the whole step.
//! The first steps use the restriction a ≥ X − X²/ρ with X² ≥ 2X₀X − X₀², which is sufficient for X ≥ 4ρ/3
//! and needs no trust in the linearisation. Followers on an arm go the same way with the h of their own
//! geometry. A concave profile needs no row: its radius is the pitch curve's plus the roller's, so the
//! roller always fits.

use super::answer::Step;
use super::basis::apply;
use super::problem::{EXTRAS, OFFSET, Program, RADIUS, RISE, Row, Solution};
use crate::law::{Law, Svaj};
use crate::poly::{Peak, PiecewisePoly, stand_in};

/// A follower whose limits are not convex in the law, with all that fixes them.
#[derive(Debug, Clone, Copy)]
pub enum Follower {
    /// A roller that slides along +y.
    Roller(Size),
    /// A roller on an arm: pivot at distance c, arm A, ξ = rest + s.
    Arm {
        /// c.
        pivot: f64,
        /// A.
        arm: f64,
        /// ξ on the base circle, rad.
        rest: f64,
        /// Smallest pitch radius allowed.
        rho: f64,
        /// Tangents of the pressure angles allowed on the rise and on the fall.
        tan: [Option<f64>; 2],
    },
    /// A flat face that swings: c + face offset, ξ = rest + s.
    Face {
        /// c.
        pivot: f64,
        /// Distance of the face from the pivot.
        offset: f64,
        /// ξ on the base circle, rad.
        rest: f64,
        /// Smallest convex radius allowed.
        rho: f64,
    },
}

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
/// A start that misses by less than this, relative to w, is sought with more room.
const NEARLY: f64 = 1e-3;
/// Linearisations tried for the last law.
const HELD_ROUNDS: usize = 6;
/// Steps are shortened to no less than this.
const SHORTEST: f64 = 1e-4;

/// h and its derivatives by s, v, a, e; by D as by s.
struct Slack {
    /// Name of the limit.
    name: &'static str,
    h: f64,
    /// Size of which h is a part: what the clearance is counted in.
    w: f64,
    /// Largest term in h.
    largest: f64,
    by_lift: f64,
    by_velocity: f64,
    by_acceleration: f64,
    by_offset: f64,
}

impl Follower {
    /// Every limit at a place of the law; h ≥ 0 where it holds.
    fn slacks(&self, at: Svaj) -> Vec<Slack> {
        match *self {
            Follower::Roller(size) => vec![roller(at, size)],
            Follower::Arm {
                pivot,
                arm,
                rest,
                rho,
                tan,
            } => {
                let mut out = vec![arm_curvature(at, pivot, arm, rest, rho)];
                for (tan, side) in tan.into_iter().zip([1.0, -1.0]) {
                    out.extend(tan.map(|t| arm_pressure(at, pivot, arm, rest, t, side)));
                }
                out
            }
            Follower::Face {
                pivot,
                offset,
                rest,
                rho,
            } => vec![face_curvature(at, pivot, offset, rest, rho)],
        }
    }

    /// The size where it may be among the variables.
    fn size(&self) -> Size {
        match *self {
            Follower::Roller(size) => size,
            _ => Size {
                rise: 0.0,
                offset: 0.0,
                rho: 0.0,
            },
        }
    }

    /// The same follower at another size.
    fn at_size(&self, size: Size) -> Self {
        match self {
            Follower::Roller(_) => Follower::Roller(size),
            other => *other,
        }
    }
}

/// w^{3/2}/ρ − (w + vY − aX).
fn roller(at: Svaj, size: Size) -> Slack {
    let (x, y) = (size.rise + at.s, at.v - size.offset);
    let w = x * x + y * y;
    let root = w.sqrt();
    let by_x = 3.0 * x * root / size.rho - (2.0 * x - at.a);
    let by_y = 3.0 * y * root / size.rho - (2.0 * y + at.v);
    Slack {
        name: "curvature",
        h: w * root / size.rho - (w + at.v * y - at.a * x),
        w,
        largest: w * root / size.rho,
        by_lift: by_x,
        by_velocity: by_y - y,
        by_acceleration: x,
        by_offset: -by_y,
    }
}

/// W^{3/2}/ρ − K of the arm's pitch curve, with q = 1 + ξ′: the tangent in the fixed frame is
/// (A q sin ξ, A q cos ξ − c), W its square and K = A²q³ − c A q(1 + q) cos ξ − c A ξ″ sin ξ + c² (FACTS §6
/// in other letters).
fn arm_curvature(at: Svaj, c: f64, arm: f64, rest: f64, rho: f64) -> Slack {
    let (sin, cos) = (rest + at.s).sin_cos();
    let (s, p, q) = (arm * sin, arm * cos, 1.0 + at.v);
    let w = arm * arm * q * q - 2.0 * c * p * q + c * c;
    let k = arm * arm * q.powi(3) - c * p * q * (1.0 + q) - c * s * at.a + c * c;
    let root = w.sqrt();
    let by_w = 1.5 * root / rho;
    Slack {
        name: "curvature",
        h: w * root / rho - k,
        w,
        largest: w * root / rho,
        by_lift: by_w * 2.0 * c * s * q - (c * s * q * (1.0 + q) - c * p * at.a),
        by_velocity: by_w * (2.0 * arm * arm * q - 2.0 * c * p)
            - (3.0 * arm * arm * q * q - c * p * (1.0 + 2.0 * q)),
        by_acceleration: c * s,
        by_offset: 0.0,
    }
}

/// t c sin ξ ∓ (A(1 + ξ′) − c cos ξ): the pressure angle on one side, tan φ = (A(1 + ξ′) − c cos ξ)/(c sin ξ).
fn arm_pressure(at: Svaj, c: f64, arm: f64, rest: f64, tan: f64, side: f64) -> Slack {
    let (sin, cos) = (rest + at.s).sin_cos();
    Slack {
        name: if side > 0.0 {
            "pressure_angle_rise"
        } else {
            "pressure_angle_fall"
        },
        h: tan * c * sin - side * (arm * (1.0 + at.v) - c * cos),
        w: c,
        largest: tan * c + arm,
        by_lift: tan * c * cos - side * c * sin,
        by_velocity: -side * arm,
        by_acceleration: 0.0,
        by_offset: 0.0,
    }
}

/// (ρ_face − ρ) q³ with q = 1 + ξ′ and the radius of FACTS §6, the face's offset added.
fn face_curvature(at: Svaj, c: f64, offset: f64, rest: f64, rho: f64) -> Slack {
    let (sin, cos) = (rest + at.s).sin_cos();
    let q = 1.0 + at.v;
    let twice = 2.0 * q - 1.0;
    let room = offset - rho;
    Slack {
        name: "curvature",
        h: c * sin * twice * q + c * cos * at.a + room * q.powi(3),
        w: c,
        largest: c * sin * (twice * q).abs() + (room * q.powi(3)).abs(),
        by_lift: c * cos * twice * q - c * sin * at.a,
        by_velocity: c * sin * (4.0 * q - 1.0) + 3.0 * room * q * q,
        by_acceleration: c * cos,
        by_offset: 0.0,
    }
}

/// Smallest h/w over the law, of each of the follower's limits.
fn relative(law: &Law, follower: &Follower) -> Vec<PiecewisePoly> {
    let breaks = law.breaks();
    let place = |i: usize, x: f64| law.svaj_on(i, (x - breaks[i]) / (breaks[i + 1] - breaks[i]));
    let count = follower.slacks(place(0, breaks[0])).len();
    (0..count)
        .map(|k| {
            stand_in(breaks, 1e-11, |i, x| {
                let s = &follower.slacks(place(i, x))[k];
                s.h / s.w
            })
        })
        .collect()
}

/// Smallest h/w over the law.
pub fn clearance(law: &Law, follower: &Follower) -> f64 {
    relative(law, follower)
        .iter()
        .fold(f64::INFINITY, |m, curve| m.min(curve.extremes().0.value))
}

/// Improves `program`'s solution until the follower's limits hold as well; `start` is its optimum without
/// them. Where the program has the size among its variables, the follower's own is not looked at.
///
/// Returns the last solution with its size, the steps taken and why no more were, or `None` where no
/// feasible start was found.
pub fn refine(
    program: &Program,
    start: &Solution,
    follower: Follower,
) -> Option<(Solution, Vec<Step>, &'static str)> {
    // Between steps limits need not hold better than the next step will change them.
    let program = &Program {
        tolerance: STEP_TOLERANCE,
        ..program.clone()
    };
    let present = program.present();
    let given = follower.size();
    let sized = |extra: &[f64; EXTRAS]| {
        let of = |k: usize, given: f64| if present[k] { extra[k] } else { given };
        follower.at_size(Size {
            rise: of(RISE, given.rise),
            offset: of(OFFSET, given.offset),
            rho: given.rho,
        })
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
        next.fixed = linearised(program, &current, &here, &present, 2.0 * ROOM);
        next.seeds = contacts(&current);
        let Ok(target) = next.solve() else {
            ended = "the linearised program has no solution beside the last law";
            break;
        };
        let mut taken = 1.0;
        let accepted = loop {
            let trial = blend(&current, &target, taken, program);
            let room = clearance(&program.basis.law(&trial.x), &sized(&trial.extra));
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
        let there = sized(&current.extra).size();
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

/// The law nearest to the last one whose limits hold to rounding, the size held a hair larger.
fn held(program: &Program, current: &Solution, follower: Follower) -> Option<Solution> {
    // A given size stays as it is.
    let room = if program.present()[RISE] {
        4.0 * STEP_TOLERANCE
    } else {
        0.0
    };
    let size = follower.size();
    let enlarged = follower.at_size(Size {
        rise: size.rise * (1.0 + room),
        ..size
    });
    let gradient: Vec<f64> = program
        .hessian
        .times(&current.x)
        .iter()
        .map(|g| -g)
        .collect();
    let mut about = current.clone();
    for _ in 0..HELD_ROUNDS {
        let mut last = program.clone();
        last.fixed = linearised(program, &about, &enlarged, &[false; EXTRAS], 2.0 * ROOM);
        // Nearest to the law at hand, so that the linearised curvature stays true.
        last.gradient.clone_from(&gradient);
        let mut exact = last.with_sizes_held(current, room).solve().ok()?;
        let violation = exact.violation;
        if clearance(&program.basis.law(&exact.x), &enlarged) >= 0.0 {
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
/// about its own X a few times. Followers on an arm have no such restriction: there the linearised limits
/// are solved until they hold.
fn feasible_start(
    program: &Program,
    start: &Solution,
    sized: &impl Fn(&[f64; EXTRAS]) -> Follower,
) -> Option<Solution> {
    let mut current = start.clone();
    let mut room = 2.0 * ROOM;
    for _ in 0..20 {
        let here = sized(&current.extra);
        let clear = clearance(&program.basis.law(&current.x), &here);
        if clear >= ROOM {
            return Some(current);
        }
        // Low points that wander between two programs need a little more room than they take.
        if clear > -NEARLY {
            room = room.max(-2.0 * clear);
        }
        let mut next = program.clone();
        next.fixed = match here {
            Follower::Roller(size) => restricted(program, &current, size),
            _ => linearised(program, &current, &here, &program.present(), room),
        };
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

/// Rows of h₀ + ∇h·(step) ≥ room·w where h is small enough for one step to matter.
fn linearised(
    program: &Program,
    current: &Solution,
    follower: &Follower,
    present: &[bool; EXTRAS],
    room: f64,
) -> Vec<Row> {
    let law = program.basis.law(&current.x);
    let mut out = Vec::new();
    let mut places = Vec::new();
    each_place(program, |place| places.push(place));
    // The rows of the grid bound h between them only to second order; its own low points are rows too.
    for curve in relative(&law, follower) {
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
    let size = follower.size();
    for place in places {
        let at = law.svaj_on(place.piece, place.u);
        for s in follower.slacks(at) {
            if s.h > FAR * s.largest {
                continue;
            }
            // Σ −∂h·x ≤ h₀ − Σ ∂h·x₀, with room for the check.
            let mut bound = s.h
                - room * s.w
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
            let weights = [-s.by_lift, -s.by_velocity, -s.by_acceleration];
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
    Row {
        limit: None,
        name: "curvature",
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::{Cam, Follower as Kind};
    use crate::law::{Extent, Rise, Segment, program};

    fn law(lift: f64) -> Law {
        let segment = |lift: f64, angle: f64| Segment {
            motion: Rise::Cycloidal,
            lift,
            angle,
        };
        let pi = std::f64::consts::PI;
        program(&[segment(lift, pi), segment(-lift, pi)], Extent::Turns(1)).unwrap()
    }

    /// Central differences of h against the derivatives stated, at places of many kinds.
    #[test]
    fn derivatives_of_every_limit_agree_with_differences() {
        let followers = [
            Follower::Roller(Size {
                rise: 0.04,
                offset: 0.007,
                rho: 0.02,
            }),
            Follower::Arm {
                pivot: 0.1,
                arm: 0.08,
                rest: 0.6,
                rho: 0.02,
                tan: [Some(0.6), Some(0.7)],
            },
            Follower::Face {
                pivot: 0.1,
                offset: 0.01,
                rest: 0.5,
                rho: 0.005,
            },
        ];
        for follower in followers {
            let unit = if matches!(follower, Follower::Roller(_)) {
                0.01
            } else {
                0.1
            };
            for i in 0..20 {
                let x = f64::from(i);
                let at = Svaj {
                    s: unit * (1.0 + (1.3 * x).sin()),
                    v: unit * (0.7 * x).cos(),
                    a: unit * (0.3 * x + 1.0).sin(),
                    j: 0.0,
                };
                for k in 0..follower.slacks(at).len() {
                    let h = |at: Svaj| follower.slacks(at)[k].h;
                    let d = 1e-6 * unit;
                    let by = |plus: Svaj, minus: Svaj| (h(plus) - h(minus)) / (2.0 * d);
                    let found = [
                        by(Svaj { s: at.s + d, ..at }, Svaj { s: at.s - d, ..at }),
                        by(Svaj { v: at.v + d, ..at }, Svaj { v: at.v - d, ..at }),
                        by(Svaj { a: at.a + d, ..at }, Svaj { a: at.a - d, ..at }),
                    ];
                    let own = &follower.slacks(at)[k];
                    let stated = [own.by_lift, own.by_velocity, own.by_acceleration];
                    let size = stated.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
                    for (f, s) in found.iter().zip(stated) {
                        assert!(
                            (f - s).abs() < 1e-6 * size,
                            "{follower:?} {k}: {found:?} {stated:?}"
                        );
                    }
                }
            }
        }
    }

    /// h is zero exactly where the finished cam has the radius or the pressure angle asked for.
    #[test]
    fn limits_of_arms_are_those_of_the_cam() {
        let law = law(0.3);
        let (pivot, arm, prime, roller) = (0.1, 0.08, 0.05, 0.01);
        let cam = Cam {
            law: law.clone(),
            follower: Kind::RollerOscillating {
                pivot_distance: pivot,
                arm,
                prime_radius: prime,
                roller_radius: roller,
            },
        };
        let rest = ((arm * arm + pivot * pivot - prime * prime) / (2.0 * arm * pivot)).acos();
        let (fall, rise) = cam.pressure_angle_extremes();
        let arms = |rho: f64, tan: [Option<f64>; 2]| Follower::Arm {
            pivot,
            arm,
            rest,
            rho,
            tan,
        };
        let sharpest = cam.curvature().convex.value + roller;
        let exact = clearance(&law, &arms(sharpest, [None, None]));
        assert!(exact.abs() < 1e-7, "{exact}");
        for (k, angle) in [(0, rise.value), (1, -fall.value)] {
            let mut tan = [None, None];
            tan[k] = Some(angle.tan());
            let exact = clearance(&law, &arms(1e-4, tan));
            assert!(exact.abs() < 1e-7, "{k}: {exact}");
        }
        let (base, offset) = (0.05, 0.004);
        let cam = Cam {
            law: law.clone(),
            follower: Kind::FlatOscillating {
                pivot_distance: pivot,
                face_offset: offset,
                base_radius: base,
            },
        };
        let face = Follower::Face {
            pivot,
            offset,
            rest: ((base - offset) / pivot).asin(),
            rho: cam.curvature().convex.value,
        };
        let exact = clearance(&law, &face);
        assert!(exact.abs() < 1e-7, "{exact}");
    }
}

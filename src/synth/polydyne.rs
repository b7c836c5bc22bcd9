//! Polydyne cam of a compliant follower: the law is optimised for the follower's end, the cam is cut so that the end
//! follows it, and every limit of the cam holds for the cam's own law.

use super::design::End;
use super::families::{self, NoLaw, SolvedLaw, on_base_circle};
use super::limits::{Finished, force_report};
use super::search::Search;
use super::sizing;
use crate::cam::{Cam, Check, Criterion, LimitKind};
use crate::dynamics::Train;
use crate::dynamics::flexible::polydyne::{end_error, polydyne};
use crate::error::{Placed, Result};
use crate::law::Law;
use crate::problem::{Note, Problem};
use crate::scene::Limits;
use crate::units::{Dimension, Quantity};

/// Times that the end's limits are moved so that the cam keeps its own.
const ROUNDS: usize = 12;
/// The end's limit aims at this part of it inside what the cam needs, so that the rounds end.
const AIM: f64 = 1e-6;
/// A limit that binds the end is reached by the cam when it is this near to its own.
const NEAR: f64 = 1e-4;
/// A share of the plain cam's miss that is worth saying how to lower it.
const WORTH_A_DEGREE: f64 = 0.01;
/// Splines go no higher.
const MOST_DEGREE: usize = 9;

/// The law of the end, the cam that gives it, and what is known of both. The law is found for `asked`, which
/// is the problem itself, or the problem without the limits that leave none.
///
/// Limits of the program hold for the end; the cam's law differs from it by the follower's give. Where the
/// cam breaks a limit, or keeps away from one that binds the end, the end's limit moves by as much and the
/// law is found again.
pub fn design(
    problem: &Problem,
    asked: &Problem,
    search: &Search,
    train: &Train,
) -> std::result::Result<(SolvedLaw, Cam, End), NoLaw> {
    let mut moved = asked.clone();
    let mut best = one(problem, &moved, search, train)?;
    let mut last = best.clone();
    for _ in 0..ROUNDS {
        if !last.move_limits(&mut moved.limits) {
            break;
        }
        last = match one(problem, &moved, search, train) {
            Ok(round) => round,
            // Tightened limits may leave no law: then the checks of the round before show what is violated.
            Err(NoLaw::Refused(_)) => break,
            Err(fault) => return Err(fault),
        };
        if last.passes() || !best.passes() {
            best = last.clone();
        }
    }
    let end = end_of(problem, train, &best.cam, best.wanted);
    Ok((best.found, best.cam, end))
}

/// One round: the law under the limits as they stand, its cam, and that cam's checks against the problem.
fn one(
    problem: &Problem,
    moved: &Problem,
    search: &Search,
    train: &Train,
) -> std::result::Result<Round, NoLaw> {
    let found = families::law(moved, search)?;
    let (cam, wanted) = cut(problem, search, train, &found.law)?;
    let force = force_report(problem, search, &wanted);
    let checks = Finished::of_one_cam(problem, &cam, &wanted, &force).checks();
    Ok(Round {
        found,
        cam,
        wanted,
        checks,
    })
}

#[derive(Clone)]
struct Round {
    found: SolvedLaw,
    cam: Cam,
    wanted: Law,
    checks: Vec<Check>,
}

impl Round {
    fn passes(&self) -> bool {
        self.checks.iter().all(|c| c.pass)
    }

    /// Moves the end's limits by what the cam lacks or leaves of its own; `false` where none had to be.
    fn move_limits(&self, limits: &mut Limits) -> bool {
        let mut any = false;
        for check in &self.checks {
            let binds = self.found.binding.iter().any(|b| b.limit == check.name);
            let apart = check.worst - check.limit;
            let idle = binds && apart.abs() > NEAR * check.limit.abs();
            if check.pass && !idle {
                continue;
            }
            let Some(limit) = own_limit(limits, check.name) else {
                continue;
            };
            // A radius has to be large enough, all others small enough.
            let inside = if check.name == LimitKind::Curvature {
                1.0
            } else {
                -1.0
            };
            let next = *limit - apart + inside * AIM * check.limit.abs();
            if next.is_finite() && next > 0.0 {
                *limit = next;
                any = true;
            }
        }
        any
    }
}

/// The cam for a law of the end, and that law with its zero moved as the cam's was.
fn cut(problem: &Problem, search: &Search, train: &Train, wanted: &Law) -> Result<(Cam, Law)> {
    let key = |e: crate::error::Error| e.at_key("law.polydyne");
    let whole = polydyne(wanted, &problem.drive, train).map_err(key)?;
    let law = on_base_circle(problem, search, &whole);
    let (start, _) = whole.extent();
    let moved = law.svaj(start).s - whole.svaj(start).s;
    let wanted = wanted.raised(moved);
    let cam = sizing::cam(problem, law, &wanted)?;
    Ok((cam, wanted))
}

/// Limits of the cam that no change of the end's own limits brings nearer.
const OTHERS: [LimitKind; 4] = [
    LimitKind::ForceMin,
    LimitKind::ForceMax,
    LimitKind::FaceWidth,
    LimitKind::Residual,
];

/// The scene's number behind a check, where rows of the program can hold it.
fn own_limit(limits: &mut Limits, check: Criterion) -> Option<&mut f64> {
    let kind = check.limit().filter(|kind| !OTHERS.contains(kind))?;
    limits[kind].as_mut()
}

/// The end with its deviation from its law, for this cam and for one cut to the law itself.
fn end_of(problem: &Problem, train: &Train, cam: &Cam, wanted: Law) -> End {
    let Train { stiffness, damping } = *train;
    // Undamped and in resonance with a harmonic there is no steady state.
    let miss = |law: &Law| end_error(law, &wanted, &problem.drive, train).ok();
    End {
        stiffness,
        damping,
        miss: miss(&cam.law),
        plain_miss: miss(&wanted),
        law: wanted,
    }
}

impl End {
    /// What to know of the design: its speed and stiffness, and what it misses.
    pub fn notes(&self, speed: f64, degree: usize) -> Vec<Note> {
        let mut out = vec![Note::Polydyne {
            speed: Quantity::new(speed, Dimension::AngularSpeed),
            stiffness: Quantity::new(self.stiffness, Dimension::SpringRate),
        }];
        if let (Some(own), Some(plain)) = (self.miss, self.plain_miss) {
            out.push(Note::PolydyneMiss {
                own: Quantity::force(own.force_rms),
                plain: Quantity::force(plain.force_rms),
            });
            if own.force_rms > WORTH_A_DEGREE * plain.force_rms && degree < MOST_DEGREE {
                out.push(Note::PolydyneDegree);
            }
        }
        out
    }
}

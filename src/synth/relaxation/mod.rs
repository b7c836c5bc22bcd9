//! Suggested changes: for every limit, the minimum change with which the complete design passes.
//!
//! Each change is confirmed by a complete design. The convex program (`iis`) is not sufficient, because it does not contain all requirements.
//! A size that is computed after the law, the finished profile, or the accuracy may still fail a check.

mod beside;
mod by_size;
mod relaxable;
mod several;

use std::sync::Arc;

use crate::cam::{Criterion, LimitKind, Verdict};
use crate::halt::Halt;
use crate::problem::{Note, Problem};
use crate::scene::{Family, Minimise};
use crate::synth::design::Design;
use crate::synth::infeasible::reasons::{changes, smallest_relaxations};
use crate::synth::limits::NonconvexLimits;
use crate::synth::report::limited::{Conflicting, Infeasible, Relaxation};
use crate::synth::report::reason::Reason;
use crate::synth::search::Search;
use crate::synth::synthesis;
use crate::synth::verdict::verdict;
use beside::beside;
use by_size::BySize;
use relaxable::{Relaxable, relaxables};

/// Relative margins beyond a sufficient value, tried one after the other, because a design may fail exactly at the edge of feasibility.
const ROOMS: [f64; 4] = [0.0, 1e-4, 1e-3, 1e-2];
/// Relative margins beyond a value that is sufficient for one motion of the machine. They are necessary because this motion changes with the
/// cam.
const MACHINE_ROOMS: [f64; 5] = [0.0, 1e-3, 1e-2, 0.05, 0.2];
/// Factor between old and new value above which a change counts as unreasonably large. It is also the largest common relative change of
/// several limits that is tried.
const FAR: f64 = 10.0;
/// Relative change of several limits that is tried first.
const SMALL: f64 = 0.01;
/// Tolerance at which the bisection for a sufficient value ends, relative to the first sufficient value. It applies if the steps
/// between rounded values are smaller, for example near zero.
const SMALLEST: f64 = 1e-7;
/// Relative tolerance of a sufficient value, for a machine that responds to the cam.
const ON_MACHINE: f64 = 5e-3;
/// Relative distance by which a sufficient value is reduced to test whether a smaller change is also sufficient.
const BACK: f64 = 1e-3;

impl Design {
    /// The design with suggested changes. For conflicting limits, the changes are tested and corrected. For a failed check, changes are
    /// computed. A design that passes is returned unchanged.
    #[must_use]
    pub fn relaxed(self) -> Design {
        self.relaxed_with(&Search::default())
    }

    /// The design with suggested changes. The computation ends early at the stop condition of `search`.
    #[must_use]
    pub fn relaxed_with(self, search: &Search) -> Design {
        // Relaxed limits change neither the mean target force, nor open questions about the recording, nor a prescribed law. If the solver
        // stopped, it is not proved that the limits are the cause.
        let hopeless = self.reasons.iter().any(|reason| {
            matches!(
                reason,
                Reason::MeanForce { .. }
                    | Reason::RecordingKind { .. }
                    | Reason::RecordingClock { .. }
                    | Reason::RecordingMass { .. }
                    | Reason::RecordingClipped { .. }
                    | Reason::LiftJumps { .. }
                    | Reason::VelocityJumps { .. }
                    | Reason::LimitUnbounded { .. }
                    | Reason::NothingPresses
                    | Reason::SolverStopped { .. }
            )
        });
        if hopeless || self.out_of_time || passes(&self) {
            return self;
        }
        let problem = Arc::clone(&self.problem);
        with_relaxations(&problem, search, self)
    }
}

fn with_relaxations(problem: &Problem, search: &Search, design: Design) -> Design {
    let numbers = relaxables(problem);
    if numbers.is_empty() {
        return design;
    }
    let relaxing = Relaxing::of(problem, search, &design);
    let found = relaxing.each(&numbers, &design);
    let is_goal = |number: &Relaxable| Relaxation::of(number.criterion(), 0.0, None).is_goal();
    let (cures, together) = if found.is_empty() && !search.halt.is_asked() {
        relaxing.several(&numbers, &design.reasons)
    } else if found.iter().all(Relaxation::is_goal) {
        // A common change of several limits may be sufficient without relaxing the accuracy.
        let limits: Vec<_> = numbers.iter().copied().filter(|n| !is_goal(&n.0)).collect();
        (
            vec![relaxing.cure(&found)],
            relaxing.several_limits(&limits),
        )
    } else {
        (vec![relaxing.cure(&found)], Vec::new())
    };
    let (infeasible, reasons) = match design.infeasible {
        Some(why) => {
            let why = with_cures(why, &found, cures);
            let reasons = why.reasons.clone();
            (Some(why), reasons)
        }
        None => {
            // If the size is relaxed, the law changes too. The base radius that the present law requires is then not valid.
            let is_found = |key: &str| found.iter().any(|f| f.key == key);
            let resized = (numbers.iter())
                .any(|(number, _)| number.key.section() == "cam" && is_found(number.key.path));
            let own = |r: &Reason| matches!(r, Reason::BaseRadiusWorks { .. });
            let known = design.reasons.into_iter().filter(|r| !(resized && own(r)));
            (None, known.chain(cures).collect())
        }
    };
    // A suggested inertia is kept only if the design with this inertia passes every check.
    let of_machine = design.relaxations.into_iter();
    let of_machine = of_machine.filter(|r| r.limit == Criterion::Inertia && relaxing.passes_on(r));
    let out_of_time = search.halt.was_heard() && !design.out_of_time;
    let notes = design.notes.into_iter();
    Design {
        infeasible,
        reasons,
        relaxations: of_machine.chain(found).collect(),
        together,
        out_of_time: design.out_of_time || out_of_time,
        notes: notes
            .chain(out_of_time.then_some(Note::OutOfTime))
            .collect(),
        ..design
    }
}

/// Adds the suggested changes to a conflict. For limits without a sufficient change, the value is `None`.
fn with_cures(why: Infeasible, found: &[Relaxation], cures: Vec<Reason>) -> Infeasible {
    let Infeasible {
        conflict,
        relaxations,
        reasons,
    } = why;
    let is_helpless = |k: &Relaxation| {
        !found.iter().any(|f| f.limit == k.limit) && conflict.contains(&Conflicting::Limit(k.limit))
    };
    let helpless: Vec<Relaxation> = relaxations
        .into_iter()
        .filter(is_helpless)
        .map(|k| Relaxation { to: None, ..k })
        .collect();
    Infeasible {
        relaxations: [found.to_vec(), helpless].concat(),
        reasons: reasons.into_iter().take(1).chain(cures).collect(),
        conflict,
    }
}

fn passes(design: &Design) -> bool {
    design.verdict != Verdict::Unacceptable
}

/// Middle of two values: the arithmetic mean, or the geometric mean if the values differ by more than a factor of four.
fn middle(works: f64, fails: f64) -> f64 {
    if fails > 0.0 && works / fails > 4.0 {
        (works * fails).sqrt()
    } else {
        0.5 * (works + fails)
    }
}

/// Values that may be relaxed, each with a trial value or its present value.
type Values = [(Relaxable, f64)];

/// The problem with the given values of limits.
fn changed(problem: &Problem, values: &Values) -> Problem {
    let start = problem.clone();
    (values.iter()).fold(start, |problem, (number, value)| {
        number.with(&problem, *value)
    })
}

/// A complete design that passes; `None` if no such design is found. If the force error is limited, the law with minimum force error is
/// tried, because it takes the least time to compute.
fn passing(problem: &Problem, search: &Search) -> Option<Design> {
    let nearest = (problem.limited_error().is_some() && problem.law.family == Family::Spline)
        .then(|| problem.minimising(Minimise::ForceError));
    let problem = nearest.as_ref().unwrap_or(problem);
    synthesis::passing(problem, search).ok()?
}

struct Relaxing<'a> {
    problem: &'a Problem,
    /// The problem in which each design has its own machine motion. In `problem`, the motion of the given design is fixed.
    asked: &'a Problem,
    search: &'a Search,
    /// Magnitude of the force, N: the larger of the absolute mean target force and the absolute force at rest.
    force: f64,
}

impl<'a> Relaxing<'a> {
    fn of(problem: &'a Problem, search: &'a Search, design: &Design) -> Self {
        let (mean, rest) = (design.force.target_mean_n, design.problem.drive.rest_force);
        let asked = problem.at_constant_speed();
        // A design on a responding floor takes little time, and the floor motion for the present limit is not valid for another limit. The
        // machine motion is therefore not fixed.
        let is_quick = problem.through_floor().is_some();
        Relaxing {
            problem: if is_quick { asked } else { problem },
            asked,
            search,
            force: mean.abs().max(rest.abs()),
        }
    }

    /// Minimum sufficient change of each value alone.
    fn each(&self, numbers: &Values, design: &Design) -> Vec<Relaxation> {
        let known = || design.infeasible.iter().flat_map(|i| &i.relaxations);
        let is_hinted = known().any(|r| r.to.is_some());
        let by_size = (!is_hinted).then(|| BySize::of(self.problem, self.search));
        let by_size = by_size.flatten();
        let relaxation = |&(number, from): &(Relaxable, f64), halt: &Halt| {
            if halt.is_asked() {
                return None;
            }
            let hint = known().find(|r| r.limit == number.criterion());
            let hint = hint.and_then(|r| r.to);
            let relaxing = Relaxing {
                search: &self.search.ended_by(halt),
                ..*self
            };
            let to = match (relaxing.own_accuracy(number, design), &by_size) {
                (Some(own), _) => own,
                (None, None) => relaxing
                    .of_smallest_cam(number, from)
                    .or_else(|| relaxing.smallest(number, from, hint)),
                (None, Some(by_size)) => {
                    let precise = |works: f64| number.step(works.abs().max(from.abs()));
                    let free = number.away(from, self.force);
                    let edge = by_size.value(number, [from, free], precise);
                    edge.and_then(|edge| relaxing.passing_from(number, edge))
                }
            };
            let eases = |to: &f64| number.sign() * (to - from) > 0.0;
            let to = relaxing.confirmed(number, to.filter(eases)?)?;
            let to = relaxing.on_machine(number, to)?;
            Some(Relaxation::of(number.criterion(), from, Some(to)))
        };
        let tried = beside(numbers, &self.search.halt, relaxation);
        tried.into_iter().flatten().collect()
    }

    /// The value `to`, or a slightly weaker value, for which the optimum itself passes. The search for `to` used other laws. For non-convex
    /// limits or many walkers, it ended at the first passing law. For a limited force error, it minimised this error.
    fn confirmed(&self, number: Relaxable, to: f64) -> Option<f64> {
        let problem = self.problem;
        let is_same = NonconvexLimits::of(problem).is_none()
            && problem.limited_error().is_none()
            && problem.walkers.is_none();
        if is_same || problem.on_shaft.is_some() {
            return Some(to);
        }
        let weaker = ROOMS[1..].iter().map(|room| number.with_room(to, *room));
        let mut values = [to, number.after(to)].into_iter().chain(weaker);
        values.find(|to| self.passes_as_asked(&[(number, *to)]))
    }

    /// Whether the optimum passes in the machine with the suggested inertia.
    fn passes_on(&self, machine: &Relaxation) -> bool {
        let inertia = machine.to.map(|to| self.asked.with(machine.limit, to));
        let kept = inertia.and_then(|problem| synthesis::kept(&problem, self.search).ok());
        kept.flatten().is_some()
    }

    /// Whether the optimum with the given values passes in a machine with its own motion.
    fn passes_as_asked(&self, values: &Values) -> bool {
        synthesis::kept(&changed(self.asked, values), self.search).is_ok_and(|d| d.is_some())
    }

    /// Reason that lists the suggested changes, of which one is sufficient.
    fn cure(&self, found: &[Relaxation]) -> Reason {
        let measures = self.problem.cam.measures();
        if !found.is_empty() && found.iter().all(|r| self.is_far(r)) {
            let changes = changes(found, measures);
            return Reason::FarRelaxations { changes };
        }
        smallest_relaxations(found, measures)
    }

    /// Design with one changed value; `None` if it does not pass.
    fn tried(&self, number: Relaxable, value: f64) -> Option<Design> {
        passing(&number.with(self.problem, value), self.search)
    }

    /// Value of `number` near `hint` for which the complete design passes. `hint` is the value that is sufficient in the convex program.
    /// `None` if a small margin beyond `hint` is not sufficient, or if a smaller change is sufficient.
    fn near(&self, number: Relaxable, hint: f64) -> Option<f64> {
        // At the edge of feasibility, a program is hard to solve. If small margins are not sufficient, the value is rejected.
        let [none, less, most, _] = ROOMS;
        let weakest = number.with_room(hint, most);
        self.tried(number, weakest)?;
        for room in [none, less] {
            let to = number.with_room(hint, room);
            let back = to - BACK * to.abs() * number.sign();
            if self.tried(number, to).is_none() {
                continue;
            }
            let is_edge = room > 0.0 || self.tried(number, back).is_none();
            return is_edge.then(|| self.edge(number, to, back));
        }
        Some(weakest)
    }

    /// Rounded value nearest to `fails` for which the design passes. It is found by bisection, from the rounded value `works` for which the
    /// design passes.
    fn edge(&self, number: Relaxable, works: f64, fails: f64) -> f64 {
        let (mut works, mut fails) = (works, fails);
        // Towards zero the steps decrease without end, so the tolerance is relative to the first value.
        let least = SMALLEST * works.abs();
        while !self.search.halt.is_asked() && (works - fails).abs() > least {
            let halved = number.rounded(middle(works, fails));
            let value = if halved == works || halved == fails {
                number.after(fails)
            } else {
                halved
            };
            if number.sign() * (works - value) <= 0.5 * number.step(works) {
                break;
            }
            if self.tried(number, value).is_some() {
                works = value;
            } else {
                fails = value;
            }
        }
        works
    }

    /// The value, or a slightly larger change, for which the design passes in a machine with its own motion. `None` if no margin is sufficient.
    fn on_machine(&self, number: Relaxable, to: f64) -> Option<f64> {
        if self.problem.on_shaft.is_none() {
            return Some(to);
        }
        let holds = |to: f64| self.passes_as_asked(&[(number, to)]);
        let values = MACHINE_ROOMS.map(|room| number.with_room(to, room));
        let at = values.iter().position(|to| holds(*to))?;
        let Some(last) = at.checked_sub(1) else {
            return Some(to);
        };
        let precise = |works: f64| ON_MACHINE * works.abs();
        let edge = self.bisected(values[at], values[last], precise, |to| {
            holds(number.rounded(to))
        });
        Some(number.rounded(edge))
    }

    /// Value nearest to `from` for which the design passes, rounded towards the weaker limit. `hint` is the value of the convex program. `None`
    /// if the design fails even without the limit.
    fn smallest(&self, number: Relaxable, from: f64, hint: Option<f64>) -> Option<f64> {
        if let Some(to) = hint.and_then(|hint| self.near(number, hint)) {
            return Some(to);
        }
        let free = number.away(from, self.force);
        // The value that the best law without the limit requires is sufficient, and often the result.
        let design = self.tried(number, free)?;
        let unit = if number.is_accuracy() {
            self.force_mean()
        } else {
            1.0
        };
        let checks = design.checks.iter();
        let needed = checks
            .filter(|c| number.is_measured_by(c.name))
            .map(|c| c.worst / unit)
            .reduce(|a, b| if number.grows() { a.max(b) } else { a.min(b) });
        let (mut works, mut fails) = (free, from);
        for (needed, room) in needed.iter().flat_map(|n| ROOMS.map(|room| (n, room))) {
            let value = number.with_room(*needed, room);
            if self.tried(number, value).is_some() {
                works = value;
                break;
            }
            fails = value;
        }
        Some(self.edge(number, works, fails))
    }

    /// Minimum sufficient value of the diameter limit, m, if the design minimises the size: the diameter of the smallest cam. `None` for
    /// other limits and objectives.
    ///
    /// The sufficient values of other limits are found by a search, which uses the law of minimum force error. The cam of this law is
    /// larger than the smallest cam.
    fn of_smallest_cam(&self, number: Relaxable, from: f64) -> Option<f64> {
        let is_diameter = number.key.limit == Some(LimitKind::Diameter);
        if !is_diameter || self.problem.objective() != Minimise::Size {
            return None;
        }
        let free = number.with(self.problem, number.away(from, self.force));
        let design = synthesis::kept(&free, self.search).ok()??;
        let own = design
            .checks
            .iter()
            .find(|c| number.is_measured_by(c.name))?;
        Some(number.with_room(own.worst, 0.0))
    }

    /// A value for which the design passes, from a value at the edge of feasibility. It is rounded towards the weaker limit, with a margin if
    /// necessary.
    fn passing_from(&self, number: Relaxable, works: f64) -> Option<f64> {
        // At the boundary of feasibility, the solver may fail numerically, so slightly weaker values are tried too.
        let mut rounded = ROOMS.map(|room| number.with_room(works, room)).into_iter();
        rounded.find(|to| self.tried(number, *to).is_some())
    }

    /// Passing end of a range between a passing and a failing value. The range is bisected until it is not longer than `precise`.
    fn bisected(
        &self,
        mut works: f64,
        mut fails: f64,
        precise: impl Fn(f64) -> f64,
        holds: impl Fn(f64) -> bool,
    ) -> f64 {
        while !self.search.halt.is_asked() && (works - fails).abs() > precise(works) {
            let middle = middle(works, fails);
            if holds(middle) {
                works = middle;
            } else {
                fails = middle;
            }
        }
        works
    }

    /// Sufficient accuracy for a given number of spans. The minimised force error does not depend on the required accuracy. The error of the
    /// design itself is therefore a sufficient accuracy, if no other check fails. The outer `None` means that a search is necessary, and the
    /// inner `None` that no accuracy is sufficient.
    fn own_accuracy(&self, number: Relaxable, design: &Design) -> Option<Option<f64>> {
        let law = &self.problem.law;
        let given = law.spans.is_some() && law.family == Family::Spline;
        let several = self.problem.walkers.is_some();
        if !number.is_accuracy() || !given || several || self.problem.limited_error().is_some() {
            return None;
        }
        if design.infeasible.is_some() {
            return Some(None);
        }
        let to = number.rounded(design.force.rms_error_n / self.force_mean());
        let eased = number.with(self.problem, to);
        let mut checks = design.checks.clone();
        checks.retain(|c| c.name != Criterion::RmsError);
        let (verdict, _) = verdict(&eased, &design.cam, &checks, &design.force);
        Some((verdict != Verdict::Unacceptable).then_some(to))
    }

    fn force_mean(&self) -> f64 {
        let mean = self.problem.target_mean();
        if mean > 0.0 {
            mean
        } else {
            self.force.max(f64::MIN_POSITIVE)
        }
    }

    /// Whether a change is unreasonably large (by a factor above `FAR`).
    fn is_far(&self, relaxation: &Relaxation) -> bool {
        let from = relaxation.from.abs();
        let to = relaxation.to.map_or(from, f64::abs);
        let least = if from > 0.0 { 0.0 } else { 1e-3 * self.force };
        from.max(to) > FAR * from.min(to).max(least)
    }
}

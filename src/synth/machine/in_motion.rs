//! Design of a law for a motor-driven shaft with varying speed, and for a moving floor.
//!
//! The design at constant speed on a rigid floor determines a motion of the follower in time. From the power of this motion, the torque line
//! of the motor determines the speed ω(θ). At this varying speed, the same motion in time corresponds to another law over the cam angle. The
//! target force causes the floor acceleration z″, which is computed by one linear response per harmonic.
//!
//! If ω(θ) and z″(θ) are known, the force is linear in the law ([`crate::problem`]). The program is then solved again with the machine
//! motion of the previous law. Each iteration reduces the change of the machine motion to a fraction of the previous change. This fraction
//! is of the order of the speed ripple and of the residual of the law (theory §10).

use super::added::Layout;
use super::assumed::Assumed;
use super::runner::{ROWS, Runner, angle, depends_on_speed, retimed};
use super::through_floor::FloorResponse;
use crate::cam::{Check, Criterion};
use crate::dynamics::fixed_point::{FixedPoint, Round, largest_difference, settled};
use crate::dynamics::machine_motion::MachineMotion;
use crate::dynamics::shaft::{InTime, Motion};
use crate::dynamics::{Floor, FloorMotion};
use crate::error::{Placed, Result, SynthError};
use crate::law::Law;
use crate::poly::Extreme;
use crate::problem::{Note, Problem};
use crate::scene::{Family, LawSpec, ShaftSpeed};
use crate::synth::attempt::{Attempt, attempt};
use crate::synth::design::Design;
use crate::synth::families::{SolvedLaw, TELLING};
use crate::synth::finish::{Reports, finished};
use crate::synth::qp::TOLERANCE;
use crate::synth::report::limited::Relaxation;
use crate::synth::report::proof::{self, Doubt};
use crate::synth::report::shaft::{Forecast, OnShaft};
use crate::synth::search::Search;
use crate::synth::sizing::checked_cam::checked_cam;
use crate::units::{Dimension, Quantity};

/// Maximum difference between assumed and actual state, in the units of the state, at which the iteration has converged.
const SETTLED: f64 = 1e-6;
/// Maximum difference between assumed and actual state at convergence, if the response of the floor is part of the program.
const SETTLED_ON_FLOOR: f64 = 1e-9;
const ACCEPTED: f64 = 1e-4;
/// Maximum number of designs with a tighter accuracy, if a law satisfies the accuracy over the angle but not over time.
const TIGHTER: usize = 4;
const ROOM: f64 = 1e-4;
/// Number of equally spaced angles at which the report contains speed and time.
const TOLD_ROWS: usize = 1440;
/// Maximum speed ripple that a message states. Ripples above it have no physical meaning.
const LARGEST_RIPPLE: f64 = 2.0;
/// Speed ripple up to which the iteration usually converges.
const CALM: f64 = 0.25;
/// Relative margins above the inertia that is sufficient for the present law. They are tried one after the other.
const INERTIA_ROOMS: [f64; 4] = [0.0, 0.01, 0.1, 0.5];
/// Number of iterations without improvement after which the number of spans is increased.
const STALLED: usize = 3;

/// Problem, law with its cam, and the machine motion that results from this law.
struct Iterate {
    problem: Problem,
    attempt: Attempt,
    motion: MachineMotion,
}

impl Iterate {
    /// Replaces the problem by the one for the machine motion in `state`, and checks the cam for it.
    ///
    /// # Errors
    ///
    /// Errors in determining the size of the cam.
    fn judged(mut self, problem: &Problem, assumed: &Assumed, state: &[f64]) -> Result<Iterate> {
        let law = &self.attempt.law;
        self.problem = assumed.problem(problem, state);
        self.attempt.cam = checked_cam(&self.problem, &law.law, law.circle, None)?;
        Ok(self)
    }

    /// Marks the certificate as valid only for this machine motion. Laws with other motions were not compared.
    fn hold_for_its_motion(&mut self) {
        let solver = &mut self.attempt.law.solver;
        if solver.certificate.is_some() && solver.certified {
            solver.certified = false;
            solver.doubt = Some(Doubt::FixedMotion);
        }
    }

    /// Adds the gap of the coupled program of law and floor to the certificate. If `gap` is `None`, the certificate is valid only for the floor
    /// motion of this law.
    fn prove_on_floor(&mut self, gap: Option<f64>) {
        let solver = &mut self.attempt.law.solver;
        match (gap, &mut solver.certificate) {
            (Some(gap), Some(certificate)) => {
                certificate.widen(gap);
                solver.doubt = solver.doubt.or_else(|| proof::doubt(certificate));
                solver.certified = solver.doubt.is_none();
            }
            _ => self.hold_for_its_motion(),
        }
    }

    /// Restores the law specification of the scene, and the reason why the first design did not use a simpler family.
    fn take_law_of(&mut self, law: &LawSpec, first: &Attempt) {
        let solver = &mut self.attempt.law.solver;
        solver.passed_over = first.law.solver.passed_over.clone();
        self.problem = self.problem.with_law(law.clone());
    }

    /// Replaces the force error of the cam, and the check of this error, by the error over time.
    fn take_error_over_time(&mut self, error: Option<InTime>) {
        let Some(error) = error else { return };
        let allowed = self.problem.judged_error();
        let cam = &mut self.attempt.cam;
        cam.force.rms_error_n = error.rms_error_n;
        cam.force.rms_error_percent_of_mean = error.rms_error_percent_of_mean;
        for check in &mut cam.checks {
            if check.name == Criterion::RmsError {
                let worst = Extreme {
                    at: check.at,
                    value: error.rms_error_n,
                };
                let limit = allowed.unwrap_or(check.limit);
                *check = Check::of(check.name, worst, limit, TOLERANCE);
            }
        }
    }

    /// Factor below 1 on the accuracy over the angle, for which a law probably also satisfies the accuracy over time. `None` if the law
    /// already satisfies the accuracy over time, violates the accuracy over the angle, or if the limits are infeasible.
    fn tighter(&self, run: &Runner, allowed: f64) -> Option<f64> {
        let rows = self.motion.shaft.clone().at_rows(ROWS);
        let over_time = run.error(&self.attempt.cam.cam.law, &self.motion, &rows)?;
        let part = allowed / over_time.rms_error_n;
        let keeps = self.attempt.cam.force.rms_error_n <= (1.0 + TOLERANCE) * allowed;
        (part < 1.0 && keeps && self.attempt.refusal.is_none()).then_some((1.0 - ROOM) * part)
    }

    /// Replaces the means of target and force over the angle by means over the period.
    fn take_means_over_time(&mut self, problem: &Problem) {
        let force = &mut self.attempt.cam.force;
        force.target_mean_n = problem.target_mean();
        force.mean_n = mean_over_time(&self.problem, &self.attempt.law.law, &self.motion.shaft);
    }
}

/// Designs a cam for its machine. If the limits are infeasible at constant speed and the machine analysis fails, the result is the design for
/// constant speed without a machine report.
///
/// # Errors
///
/// Errors of the input. The shaft stops, the iteration does not converge, or an undamped mode is at resonance.
pub fn designed(problem: &Problem, search: &Search) -> Result<Design> {
    let first = attempt(problem, search)?;
    match on_machine(problem, search, &first) {
        Ok((last, mut reports)) => {
            if let Some((note, relaxation)) = larger_inertia(problem, search, &last, &reports) {
                reports.notes.push(note);
                reports.relaxations.push(relaxation);
            }
            Ok(finished(&last.problem, search, last.attempt, reports))
        }
        Err(_) if first.refusal.is_some() => {
            Ok(finished(problem, search, first, Reports::default()))
        }
        Err(fault) => Err(fault),
    }
}

/// Final iterate and machine report. The iteration starts from the law for constant speed.
fn on_machine(problem: &Problem, search: &Search, first: &Attempt) -> Result<(Iterate, Reports)> {
    let (motor, floor) = (problem.machine.motor(), problem.machine.floor());
    let target = problem.target.as_ref().map(|t| &**t.curve());
    let run = Runner::new(
        problem,
        &first.cam.cam,
        target,
        motor.as_ref(),
        floor.as_ref(),
    )?;
    let law = &first.law.law;
    let before = run.of_law(law, None)?;
    let rows = before.shaft.clone().at_rows(ROWS);
    let at_constant_speed = run.error(law, &before, &rows);
    let forecast = run.forecast(problem, law, at_constant_speed);
    let is_designed_for = |forecast: &Forecast| {
        let fixed = problem.law.shaft == ShaftSpeed::Constant || forecast.is_negligible;
        !fixed && !matches!(problem.law.family, Family::Program | Family::Polynomial)
    };
    let varies = forecast.as_ref().is_some_and(is_designed_for);
    let floor = run.carrier.floor;
    let has_force = floor.is_some() || !problem.machine.learned_force.is_empty();
    let is_corrected = (varies || has_force) && problem.target.is_some();
    let at_speed = if varies { run.clone() } else { run.evenly() };
    let (mut last, rounds, contraction) = match is_corrected {
        true => corrected(first, before, &at_speed, problem, search)?,
        false => {
            let plain = Iterate {
                problem: problem.clone(),
                attempt: first.clone(),
                motion: before,
            };
            (plain, 0, None)
        }
    };
    if is_corrected && !varies {
        last.motion = run.of_law(&last.attempt.cam.cam.law, None)?;
    }
    if varies {
        last.hold_for_its_motion();
    }
    // A law for constant speed is checked at the speed that results from its motor.
    let has_ripple = forecast.as_ref().is_some_and(|f| !f.is_negligible);
    if has_ripple && !varies && problem.target.is_some() {
        let law = &last.attempt.law.law;
        let assumed = Assumed {
            layout: Layout::new(problem, law, true, true),
            floor: None,
        };
        let state = assumed.state(problem, &last.attempt, &last.motion, &|x| law.svaj(x));
        last = last.judged(problem, &assumed, &state)?;
        last.hold_for_its_motion();
        last.take_means_over_time(problem);
    }
    let mut reports = Reports {
        floor: floor.map(|_| FloorMotion::of(&last.motion.floor)),
        ..Reports::default()
    };
    if let Some((motor, forecast)) = run.carrier.motor.zip(forecast) {
        let supply = last.motion.shaft.check_supply(motor);
        supply.map_err(|e| e.at_key("machine.motor"))?;
        let rows = last.motion.shaft.clone().at_rows(ROWS);
        let force_time = run.error(&last.attempt.cam.cam.law, &last.motion, &rows);
        last.take_error_over_time(force_time);
        let (law, shaft) = (&last.attempt.cam.cam.law, &last.motion.shaft);
        let report = shaft.report(motor, law.extremes(0).0.at);
        let told = shaft.clone().at_rows(TOLD_ROWS);
        reports.shaft = report.map(|shaft| OnShaft {
            shaft,
            force_time,
            at_constant_speed,
            rounds,
            contraction,
            forecast,
            speed: told.speed,
            time: told.time,
        });
    }
    Ok((last, reports))
}

/// Inertia of the shaft, kg·m², with which the design satisfies the accuracy over time, as a note and a suggested change. `None` if the
/// design already satisfies the accuracy, or if no inertia is sufficient. The search starts from the inertia that is sufficient for the
/// present law. For each trial value, the cam is designed again.
fn larger_inertia(
    problem: &Problem,
    search: &Search,
    last: &Iterate,
    reports: &Reports,
) -> Option<(Note, Relaxation)> {
    let of_time = |reports: &Reports| {
        let in_time = reports.shaft.as_ref()?.force_time?;
        Some(in_time.rms_error_percent_of_mean)
    };
    let allowed = 100.0 * problem.allowed_error()? / problem.target_mean();
    let error = of_time(reports).filter(|error| *error > allowed * (1.0 + TOLERANCE))?;
    let (motor, floor) = (problem.machine.motor()?, problem.machine.floor());
    let law = &last.attempt.cam.cam.law;
    let target = problem.target.as_ref().map(|t| &**t.curve());
    let cam = &last.attempt.cam.cam;
    let run = Runner::new(problem, cam, target, Some(&motor), floor.as_ref()).ok()?;
    // The inertia in the scene does not include the rotor.
    let least = run.inertia_for_accuracy(law, allowed)? - problem.machine.motor.rotor_at_cam();
    let meets = |inertia: &f64| {
        let heavier = problem.with(Criterion::Inertia, *inertia);
        let reports = attempt(&heavier, search)
            .and_then(|first| on_machine(&heavier, search, &first))
            .map(|(_, reports)| of_time(&reports));
        matches!(reports, Ok(Some(error)) if error <= allowed * (1.0 + TOLERANCE))
    };
    let tried = INERTIA_ROOMS.map(|room| (1.0 + room) * least);
    let enough = tried.into_iter().find(meets)?;
    let [error, allowed] = [error, allowed].map(|percent| Quantity::share(0.01 * percent));
    let note = Note::InertiaForAccuracy {
        error,
        allowed,
        inertia: Quantity::new(enough, Dimension::Inertia),
    };
    let relaxation = Relaxation::of(Criterion::Inertia, motor.inertia, Some(enough));
    Some((note, relaxation))
}

/// Final iterate, checked with the converged machine motion, the number of iterations, and the ratio of the last two changes.
fn corrected(
    first: &Attempt,
    before: MachineMotion,
    run: &Runner,
    problem: &Problem,
    search: &Search,
) -> Result<(Iterate, usize, Option<f64>)> {
    let rounds_of = |problem: &Problem, last: Option<&Iterate>| -> Result<FixedPoint<Iterate>> {
        let begin = match last {
            Some(last) => Begin::FixedPoint(last),
            None => Begin::ConstantSpeed(first, &before),
        };
        let (mut settled, assumed) = rounds(begin, None, run, problem, search)?;
        if let Some(state) = &settled.made {
            settled.design = settled.design.judged(problem, &assumed, state)?;
        }
        Ok(settled)
    };
    let mut settled = rounds_of(problem, None)?;
    if let Some(floor) = run.carrier.floor.filter(|_| run.carrier.motor.is_none()) {
        settled = on_responding_floor(settled, floor, run, problem, search);
    }
    let accuracy = problem
        .judged_error()
        .filter(|_| run.carrier.motor.is_some());
    let asked = accuracy.unwrap_or(0.0) / problem.target_mean();
    let mut of_mean = asked;
    for _ in 0..TIGHTER {
        let Some(part) = accuracy.and_then(|most| settled.design.tighter(run, most)) else {
            break;
        };
        of_mean *= part;
        let tighter = problem.with_accuracy(Some(of_mean));
        match rounds_of(&tighter, Some(&settled.design)) {
            Ok(next) if next.design.attempt.refusal.is_none() => settled = next,
            _ => break,
        }
    }
    let mut last = settled.design;
    last.problem = last.problem.with_accuracy(problem.accuracy);
    // The reported gain refers to the accuracy of the scene, relaxed by the same percentage as the tighter accuracy.
    let eased = last.attempt.law.easing.iter_mut();
    for easing in eased.filter(|e| e.limit == Criterion::Accuracy) {
        let found = easing.from;
        (easing.from, easing.to) = (asked, easing.to / found * asked);
    }
    if run.carrier.motor.is_some() {
        last.take_means_over_time(problem);
    }
    Ok((last, settled.rounds, settled.contraction))
}

/// Optimum on a floor that responds to the law. The iteration starts from the optimum for a fixed floor motion and uses the same number of
/// spans. If the iteration does not converge, the optimum for the fixed floor motion is returned.
fn on_responding_floor(
    mut settled: FixedPoint<Iterate>,
    floor: &Floor,
    run: &Runner,
    problem: &Problem,
    search: &Search,
) -> FixedPoint<Iterate> {
    let first = &settled.design.attempt;
    if first.law.solver.certificate.is_none() {
        return settled;
    }
    let mut law = problem.law.clone();
    if first.law.family == Family::Spline {
        // The law may have more spans than `first.law.spans`, the sufficient number.
        let spans = match law.dwells.is_empty() {
            true => first.law.law.breaks().len() - 1,
            false => first.law.spans,
        };
        (law.family, law.spans) = (Family::Spline, Some(spans));
    }
    let response = FloorResponse::of(problem, floor, &first.law);
    let begin = Begin::FixedPoint(&settled.design);
    let found = rounds(begin, Some(response), run, &problem.with_law(law), search).ok();
    let found = found.filter(|(found, _)| {
        found.design.attempt.refusal.is_none() && found.difference <= ACCEPTED
    });
    let Some((
        mut found,
        Assumed {
            floor: Some(floor), ..
        },
    )) = found
    else {
        settled.design.hold_for_its_motion();
        return settled;
    };
    let gap = floor.gap(problem, &found.design.attempt, found.difference);
    found.design.prove_on_floor(gap);
    found.design.take_law_of(&problem.law, first);
    found.rounds += settled.rounds;
    found
}

/// Mean contact force of a law over the period, N.
fn mean_over_time(problem: &Problem, law: &Law, shaft: &Motion) -> f64 {
    let (mut sum, mut all) = (0.0, 0.0);
    for x in (0..ROWS).map(angle) {
        let time = 1.0 / shaft.speed_at(x)[0];
        sum += time * (problem.drive.force(law.svaj(x)) + problem.extra_force(x));
        all += time;
    }
    sum / all
}

/// Initial law and machine motion of the iteration.
#[derive(Clone, Copy)]
enum Begin<'a> {
    /// The law for constant speed on a rigid floor, and the machine motion of this law.
    ConstantSpeed(&'a Attempt, &'a MachineMotion),
    /// Final iterate of a previous fixed-point iteration.
    FixedPoint(&'a Iterate),
}

/// Repeats design and simulation until the assumed machine motion agrees with the machine motion of the designed law.
fn rounds(
    begin: Begin,
    floor: Option<FloorResponse>,
    run: &Runner,
    problem: &Problem,
    search: &Search,
) -> Result<(FixedPoint<Iterate>, Assumed)> {
    let (first, before) = match begin {
        Begin::ConstantSpeed(first, before) => (first, before),
        Begin::FixedPoint(last) => (&last.attempt, &last.motion),
    };
    let law = &first.law.law;
    let diverges = |motion: &MachineMotion| {
        let speed = problem.drive.speed;
        let calm = CALM.min(0.5 * motion.shaft.ripple());
        let inertia = run.load_of_law(law).swing(speed) / (calm * speed * speed);
        let inertia = inertia - problem.machine.motor.rotor_at_cam();
        let fault = SynthError::ShaftDiverges {
            inertia: Quantity::new(three_digits(inertia), Dimension::Inertia),
            ripple: Quantity::share(three_digits(motion.shaft.ripple().min(LARGEST_RIPPLE))),
            calm: Quantity::share(three_digits(calm)),
        };
        fault.at_key("machine.inertia")
    };
    let is_exact = depends_on_speed(problem) || run.carrier.floor.is_some();
    let assumed = Assumed {
        layout: Layout::new(problem, law, run.carrier.motor.is_some(), is_exact),
        floor,
    };
    let allowed = match assumed.floor {
        Some(_) => SETTLED_ON_FLOOR,
        None => SETTLED,
    };
    let (mut motion, state) = match begin {
        Begin::ConstantSpeed(..) => {
            // With a small flywheel, the motion in time of a law for constant speed may stop the shaft, although the law over the angle
            // does not.
            let start = run.in_time(law, before.clone());
            let motion = start.map_err(|_| diverges(before))?;
            let at = |x: f64| retimed(law, &motion.shaft, x);
            let state = assumed.state(problem, first, &motion, &at);
            (motion, state)
        }
        Begin::FixedPoint(_) => {
            let state = assumed.state(problem, first, before, &|x| law.svaj(x));
            (before.clone(), state)
        }
    };
    // The number of spans never decreases between iterations, so that results that depend on it remain comparable. The number increases if
    // the iteration does not converge, because very different laws may be nearly equally good.
    let mut search = search.clone();
    search.least_spans = first.law.spans;
    let (mut nearest, mut stalled) = (f64::INFINITY, 0);
    let last = settled(state, allowed, |state| {
        let own = assumed.problem(problem, state);
        let attempt = attempt(&own, &search)?;
        let SolvedLaw { law, spans, .. } = &attempt.law;
        // The law of an iterate may stop the shaft although the first law does not.
        motion = match run.of_law(law, Some(&motion)) {
            Ok(next) => next,
            Err(fault) if run.carrier.motor.is_none() => return Err(fault),
            Err(_) => return Err(diverges(&motion)),
        };
        let made = assumed.state(problem, &attempt, &motion, &|x| law.svaj(x));
        let off = largest_difference(&made, state);
        stalled = if off < nearest { 0 } else { stalled + 1 };
        nearest = off.min(nearest);
        search.least_spans = match stalled < STALLED {
            true => *spans,
            false => (*spans).max(TELLING.min(2 * spans)),
        };
        Ok(Round {
            made,
            has_law: attempt.refusal.is_none(),
            design: Iterate {
                problem: own,
                attempt,
                motion: motion.clone(),
            },
        })
    })?;
    let disagrees = last.difference > ACCEPTED && last.design.attempt.refusal.is_none();
    if disagrees && run.carrier.motor.is_some() {
        return Err(diverges(&last.design.motion));
    }
    Ok((last, assumed))
}

/// A positive number, rounded up to three significant digits.
fn three_digits(value: f64) -> f64 {
    let unit = libm::pow(10f64, libm::log10(value).floor() - 2.0);
    (value / unit).ceil() * unit
}

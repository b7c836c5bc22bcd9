//! A law for the speed that the motor gives the shaft, and for a floor that moves.
//!
//! The design at constant speed on a stiff floor is a motion in time. Run by the motor it fixes power and so ω(θ); at that
//! speed the same motion in time is another law. The wanted force fixes z″ of the floor by one linear answer per harmonic. With
//! ω(θ) and z″(θ) known the force is linear in the law ([`crate::problem`]): the program is solved again for what the law
//! before makes of the machine, and so on; each round multiplies the change by about the ripple, and by what the law leaves of
//! the target (theory §10).

use super::added::Layout;
use super::runner::{ROWS, Runner, angle, depends_on_speed, retimed};
use crate::drive::Motor;
use crate::dynamics::fixed_point::{Round, Settled, largest_difference, settled};
use crate::dynamics::machine_motion::MachineMotion;
use crate::dynamics::shaft::Motion;
use crate::dynamics::{FloorMotion, InTime};
use crate::error::{Placed, Result, SynthError};
use crate::problem::Problem;
use crate::scene::{Family, ShaftSpeed};
use crate::synth::design::Design;
use crate::synth::families::{self, SolvedLaw};
use crate::synth::optimum::Refusal;
use crate::synth::report::shaft::{Forecast, OnShaft};
use crate::synth::{
    Search, SizedLaw, at_best_phase, best, best_law, finished, infeasible, on_cam, sizing,
};
use crate::units::{Dimension, Quantity};

/// Largest difference of target and force between what a law is designed for and what it makes, part of the mean, at which
/// the design is final: where a limit depends on it or a floor moves, and at most; else this part of the accuracy.
const SETTLED_AT_LIMITS: f64 = 1e-6;
const SETTLED: f64 = 1e-4;
const SETTLED_OF_ACCURACY: f64 = 0.1;
/// Ripple at which the rounds usually agree.
const CALM: f64 = 0.25;
/// Rounds that come no nearer than one before them, after which the law gets more spans.
const STALLED: usize = 3;

impl Problem {
    /// Whether a force of the machine beyond its drive is known.
    fn has_learned_force(&self) -> bool {
        !self.machine.learned_force.is_empty()
    }

    /// The motor that turns the shaft of the design, where there is one.
    fn motor(&self) -> Option<Motor> {
        let is_run = self.on_shaft.is_none() && !self.law.polydyne;
        self.machine.motor().filter(|_| is_run)
    }
}

/// The law for a problem as a round has it, why there is none, and the motion that it makes of the machine.
struct OnMachine {
    problem: Problem,
    law: SolvedLaw,
    refusal: Option<Box<Refusal>>,
    motion: MachineMotion,
}

/// The design of a problem, for the machine that it has; where limits leave no law at constant speed and the machine does not
/// turn with the one without them, that one.
///
/// # Errors
/// The shaft stops; the rounds do not contract; an undamped mode in resonance.
pub fn designed(problem: &Problem, search: &Search) -> Result<Design> {
    let problem = &at_best_phase(problem, search)?;
    let (motor, floor) = (problem.motor(), problem.machine.floor());
    let has_force = floor.is_some() || problem.has_learned_force();
    if problem.law.polydyne || !(has_force || motor.is_some()) {
        let (sized, refusal) = best(problem, search)?;
        return at_constant_speed(problem, search, sized, refusal.as_deref());
    }
    let (first, refusal) = best_law(problem, search)?;
    let target = problem.target.as_ref().map(|t| &*t.curve);
    let cam = sizing::cam(problem, first.law.clone(), &first.law)?;
    let run = Runner::new(problem, &cam, target, motor.as_ref(), floor.as_ref());
    let refusal = refusal.as_deref();
    let found = run.and_then(|run| on_machine(problem, search, &first, refusal, &run));
    if found.is_ok() || refusal.is_none() {
        return found;
    }
    at_constant_speed(problem, search, on_cam(problem, first)?, refusal)
}

/// The law for constant speed on a stiff floor, finished.
fn at_constant_speed(
    problem: &Problem,
    search: &Search,
    first: SizedLaw,
    refusal: Option<&Refusal>,
) -> Result<Design> {
    let why = refusal.map(|refusal| infeasible::explain(problem, refusal));
    finished(problem, search, first, why)
}

/// The design on its machine, with what that does.
fn on_machine(
    problem: &Problem,
    search: &Search,
    first: &SolvedLaw,
    refusal: Option<&Refusal>,
    run: &Runner,
) -> Result<Design> {
    let law = &first.law;
    let before = run.of_law(law, None)?;
    let rows = before.shaft.clone().at_rows(ROWS);
    let at_constant_speed_error = run.error(law, &before, &rows);
    let forecast = run.forecast(problem, law);
    let is_designed_for = |forecast: &Forecast| {
        let fixed = problem.law.shaft == ShaftSpeed::Constant || forecast.is_negligible;
        !fixed && !matches!(problem.law.family, Family::Program | Family::Polynomial)
    };
    let varies = forecast.as_ref().is_some_and(is_designed_for);
    let is_corrected = (varies || run.carrier.floor.is_some() || problem.has_learned_force())
        && problem.target.is_some();
    let at_speed = if varies { run.clone() } else { run.evenly() };
    let mut made = match is_corrected {
        true => Made::corrected(first, before, &at_speed, problem, search)?,
        false => Made {
            design: at_constant_speed(problem, search, on_cam(problem, first.clone())?, refusal)?,
            motion: before,
            rounds: 0,
            contraction: None,
        },
    };
    if is_corrected && !varies {
        made.motion = run.of_law(&made.design.cam.law, None)?;
    }
    made.design.band = problem.band.clone();
    let floor = run.carrier.floor;
    made.design.floor = floor.map(|_| FloorMotion::of(&made.motion.floor));
    if let Some((motor, forecast)) = run.carrier.motor.zip(forecast) {
        made.report(run, motor, forecast, at_constant_speed_error)?;
    }
    Ok(made.design)
}

/// A design with the motion of its machine, and the rounds that it took.
struct Made {
    design: Design,
    motion: MachineMotion,
    rounds: usize,
    contraction: Option<f64>,
}

impl Made {
    /// From the law for constant speed and its motion.
    fn corrected(
        law: &SolvedLaw,
        before: MachineMotion,
        run: &Runner,
        problem: &Problem,
        search: &Search,
    ) -> Result<Made> {
        let (last, layout) = rounds(law, before, run, problem, search)?;
        let (rounds, contraction) = (last.rounds, last.contraction);
        let (mut design, motion) = judged(last, &layout, problem, search)?;
        if run.carrier.motor.is_none() {
            design.target = problem.target.as_ref().map(|t| (*t.curve).clone());
        } else {
            by_time(&mut design, &motion.shaft, problem);
        }
        Ok(Made {
            design,
            motion,
            rounds,
            contraction,
        })
    }

    /// Adds what the shaft does under its motor.
    fn report(
        &mut self,
        run: &Runner,
        motor: &Motor,
        forecast: Forecast,
        at_constant_speed: Option<InTime>,
    ) -> Result<()> {
        let (law, shaft) = (self.design.cam.law.clone(), &self.motion.shaft);
        let supply = shaft.check_supply(motor);
        supply.map_err(|e| e.at_key("machine.motor"))?;
        let rows = shaft.clone().at_rows(ROWS);
        let force_time = run.error(&law, &self.motion, &rows);
        let problem = self.design.problem.clone();
        if let Some((note, relaxation)) = run.inertia_for_accuracy(&problem, &law, force_time) {
            self.design.notes.push(note);
            self.design.relaxations.push(relaxation);
        }
        let report = shaft.report(motor, law.extremes(0).0.at);
        self.design.shaft = report.map(|shaft| OnShaft {
            shaft,
            force_time,
            at_constant_speed,
            rounds: self.rounds,
            contraction: self.contraction,
            forecast,
            speed: rows.speed,
            time: rows.time,
            target: run.wanted.cloned(),
        });
        Ok(())
    }
}

/// The finished design of the last round, judged in the state of the machine that it is settled in.
fn judged(
    last: Settled<OnMachine>,
    layout: &Layout,
    problem: &Problem,
    search: &Search,
) -> Result<(Design, MachineMotion)> {
    let OnMachine {
        problem: own,
        law,
        refusal,
        motion,
    } = last.design;
    let made = match &last.made {
        None => own.clone(),
        Some(state) => {
            let (phases, extra) = layout.extra(problem, state);
            problem.on_shaft(&phases, extra)
        }
    };
    let sized = on_cam(&made, law)?;
    let why = refusal.map(|refusal| infeasible::explain(&own, &refusal));
    Ok((finished(&made, search, sized, why)?, motion))
}

/// Gives a design its target by the cam angle, and its mean force over time.
fn by_time(design: &mut Design, shaft: &Motion, problem: &Problem) {
    let Some(on_shaft) = design.problem.on_shaft.clone() else {
        return;
    };
    let (mut sum, mut all) = (0.0, 0.0);
    for i in 0..ROWS {
        let time = 1.0 / shaft.speed_at(angle(i))[0];
        sum += time * design.force_at(angle(i));
        all += time;
    }
    (design.force.mean_n, design.force.target_mean_n) = (sum / all, problem.target_mean());
    design.target = Some(on_shaft.target.clone());
}

/// Designs for the machine that the design before makes, from that of a law for constant speed on a stiff floor, until both
/// agree.
fn rounds(
    first: &SolvedLaw,
    before: MachineMotion,
    run: &Runner,
    problem: &Problem,
    search: &Search,
) -> Result<(Settled<OnMachine>, Layout)> {
    let law = &first.law;
    let diverges = |motion: &MachineMotion, contraction: Option<f64>| {
        let speed = problem.drive.speed;
        let calm = CALM.min(0.5 * motion.shaft.ripple());
        let inertia = run.load_of_law(law).swing(speed) / (calm * speed * speed);
        let fault = SynthError::ShaftDiverges {
            inertia: Quantity::new(inertia, Dimension::Inertia),
            ripple: Quantity::share(motion.shaft.ripple()),
            calm: Quantity::share(calm),
            contraction: contraction.unwrap_or(1.0),
        };
        fault.at_key("machine.inertia")
    };
    // The motion in time of a law for constant speed may stop a small wheel that the law itself turns.
    let start = run.in_time(law, before.clone());
    let mut motion = start.map_err(|_| diverges(&before, None))?;
    let is_exact = depends_on_speed(problem) || run.carrier.floor.is_some();
    let layout = Layout::new(problem, law, run.carrier.motor.is_some(), is_exact);
    let state = layout.state(problem, &motion, &|x| retimed(law, &motion.shaft, x));
    let allowed = if is_exact {
        SETTLED_AT_LIMITS
    } else {
        let accuracy = problem
            .allowed_error()
            .map_or(0.0, |most| most / problem.target_mean());
        (SETTLED_OF_ACCURACY * accuracy).max(SETTLED_AT_LIMITS)
    };
    // A round has no fewer spans than the one before, so that what depends on their number stays the same; and more, where
    // rounds come no nearer with so few that very different laws are nearly as good.
    let mut search = search.clone();
    search.least_spans = first.spans;
    let (mut nearest, mut stalled) = (f64::INFINITY, 0);
    let last = settled(state, allowed, |state| {
        let (phases, extra) = layout.extra(problem, state);
        let own = problem.on_shaft(&phases, extra);
        let (solved, refusal) = best_law(&own, &search)?;
        let law = &solved.law;
        // A law of a round may stop the shaft that the first one does not.
        motion = match run.of_law(law, Some(&motion)) {
            Ok(next) => next,
            Err(fault) if run.carrier.motor.is_none() => return Err(fault),
            Err(_) => return Err(diverges(&motion, None)),
        };
        let made = layout.state(problem, &motion, &|x| law.svaj(x));
        let off = largest_difference(&made, state);
        stalled = if off < nearest { 0 } else { stalled + 1 };
        nearest = off.min(nearest);
        search.least_spans = match stalled < STALLED {
            true => solved.spans,
            false => solved.spans.max(families::TELLING.min(2 * solved.spans)),
        };
        Ok(Round {
            made,
            has_law: refusal.is_none(),
            design: OnMachine {
                problem: own,
                law: solved,
                refusal,
                motion: motion.clone(),
            },
        })
    })?;
    let disagrees = last.difference > allowed.max(SETTLED) && last.design.refusal.is_none();
    if disagrees && run.carrier.motor.is_some() {
        return Err(diverges(&last.design.motion, last.contraction));
    }
    Ok((last, layout))
}

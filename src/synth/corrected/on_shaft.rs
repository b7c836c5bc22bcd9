//! A law for the speed that the motor gives the shaft.
//!
//! The design at constant speed is a motion in time. Run by the motor it fixes power and so ω(θ); at that speed the same
//! motion in time is another law, whose force differs from the target by what the design left only. With ω(θ) known the
//! force is linear in the law ([`crate::problem`]), the program is solved again, and so on: each round multiplies the change
//! by about the ripple (theory §10).

use serde::Serialize;

use super::added::Layout;
use super::fixed_point::{Round, settled};
use super::runner::{Forecast, ROWS, Runner, Sensitivity, angle, depends_on_speed, retimed};
use crate::drive::Motor;
use crate::dynamics::shaft::Motion;
use crate::dynamics::{InTime, Shaft};
use crate::error::{Error, Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::law::Law;
use crate::problem::Problem;
use crate::scene::{Family, ShaftSpeed};
use crate::synth::design::Design;
use crate::synth::{Search, at_constant_speed};
use crate::units::{Dimension, Quantity};

/// Largest difference of target and force between what a law is designed for and what it makes, part of the mean, at which
/// the design is final: where a limit depends on it, and at most; without such a limit this part of the accuracy.
const SETTLED_AT_LIMITS: f64 = 1e-6;
const SETTLED: f64 = 1e-4;
const SETTLED_OF_ACCURACY: f64 = 0.1;
/// Ripple at which the rounds surely agree.
const CALM: f64 = 0.25;

/// The design on its shaft.
///
/// ```
/// use gaitcam::{scene, synthesise};
///
/// // A wheel of 0.5 kg m² and a motor that loses 10 N·m per rad/s: the speed ripples by a quarter.
/// let mut table = scene::built_in("footbridge")?.scene()?.to_table();
/// scene::set(&mut table, "machine.motor.slope=10 N m s/rad")?;
/// scene::set(&mut table, "machine.inertia=0.5 kg m^2")?;
/// let scene = scene::read(&table)?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let on_shaft = design.shaft.as_ref().unwrap();
/// assert!((on_shaft.shaft.ripple - 0.25).abs() < 0.01);
/// assert!(on_shaft.force_time.unwrap().rms_error_percent_of_mean < 0.5);
/// assert!(on_shaft.at_constant_speed.unwrap().rms_error_percent_of_mean > 6.0);
/// // With 10 % more inertia the same cam still presses to 1 % of the weight.
/// let [less, more] = design.sensitivity()[0].percent;
/// assert!(less.unwrap() < 1.0 && more.unwrap() < 1.0);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct OnShaft {
    /// Motion of the shaft.
    pub shaft: Shaft,
    /// Force error over time.
    pub force_time: Option<InTime>,
    /// The same of the law for constant speed under this motor.
    pub at_constant_speed: Option<InTime>,
    /// Programs solved beside the one at constant speed.
    pub rounds: usize,
    /// Factor between the last two changes of the target from round to round; `None` of fewer than two changes.
    pub contraction: Option<f64>,
    /// What inertia and energy of the load said beforehand.
    pub forecast: Forecast,
    /// Speed at equal cam angles, rad/s.
    #[serde(skip)]
    pub speed: Vec<f64>,
    /// Time there since cam angle 0, s.
    #[serde(skip)]
    pub time: Vec<f64>,
    /// The target over time.
    #[serde(skip)]
    pub target: Option<ForceCurve>,
}

impl Problem {
    /// The motor that turns the shaft of the design, where there is one.
    fn motor(&self) -> Option<Motor> {
        let is_run = self.on_shaft.is_none() && !self.law.polydyne;
        self.machine.motor().filter(|_| is_run)
    }
}

/// The design for the speed that the motor gives, from the one at constant speed; that one where there is no motor, no
/// force, or no law.
///
/// # Errors
/// The shaft stops; the rounds do not contract.
pub fn designed(first: Design, search: &Search) -> Result<Design> {
    let problem = first.problem.clone();
    let Some(motor) = problem.motor().filter(|_| first.infeasible.is_none()) else {
        return Ok(first);
    };
    let run = Runner::new(&first, &motor)?;
    let clock = run.of_law(&first.cam.law, None)?;
    let at_constant_speed = run.error(&first.cam.law, &clock);
    let forecast = run.forecast(&problem, &first.cam.law);
    let fixed = problem.law.shaft == ShaftSpeed::Constant
        || forecast.is_negligible
        || matches!(problem.law.family, Family::Program | Family::Polynomial);
    let Last {
        mut design,
        clock,
        rounds,
        contraction,
    } = if fixed || problem.target.is_none() {
        Last {
            design: first,
            clock,
            rounds: 0,
            contraction: None,
        }
    } else {
        rounds(&first.cam.law, clock, &run, &problem, search)?
    };
    let law = design.cam.law.clone();
    let load = run.load_of_law(&law);
    let supply = clock.check_supply(&load, &motor);
    supply.map_err(|e| e.at_key("machine.motor"))?;
    let lowest = law.extremes(0).0.at;
    let on_shaft = design.problem.on_shaft.clone();
    if let Some(target) = on_shaft.map(|shaft| shaft.target.clone()) {
        let at = |i: usize| (design.force_at(angle(i)), 1.0 / clock.speed_at(angle(i))[0]);
        let [force, time] = (0..ROWS)
            .map(at)
            .fold([0.0, 0.0], |[sum, all], (force, time)| {
                [sum + force * time, all + time]
            });
        (design.force.mean_n, design.force.target_mean_n) = (force / time, problem.target_mean());
        design.target = Some(target);
        design.band = problem.band.clone();
    }
    let force_time = run.error(&law, &clock);
    design
        .notes
        .extend(run.inertia_note(&problem, &law, force_time));
    design.shaft = Some(OnShaft {
        shaft: clock.report(&load, &motor, lowest),
        force_time,
        at_constant_speed,
        rounds,
        contraction,
        forecast,
        speed: run.speed(&clock),
        time: run.time(&clock),
        target: problem.target.as_ref().map(|t| (*t.curve).clone()),
    });
    Ok(design)
}

impl Design {
    /// Force error over time, percent of the mean, where the machine differs by ±10 %, its supply set again; nothing at
    /// constant speed or without a target.
    pub fn sensitivity(&self) -> Vec<Sensitivity> {
        let motor = self.problem.machine.motor();
        let Some(motor) = motor.filter(|_| self.shaft.is_some()) else {
            return Vec::new();
        };
        let run = Runner::new(self, &motor);
        run.map_or_else(|_| Vec::new(), |run| run.sensitivity(&self.cam.law))
    }
}

/// The last design with the shaft under it.
struct Last {
    design: Design,
    clock: Motion,
    rounds: usize,
    contraction: Option<f64>,
}

/// Designs for the speed that the design before makes, from that of a law for constant speed, until both agree.
fn rounds(
    first: &Law,
    clock: Motion,
    run: &Runner,
    problem: &Problem,
    search: &Search,
) -> Result<Last> {
    // The motion in time of a law for constant speed may stop a small wheel that the law itself turns.
    let inertia = run.load_of_law(first).swing(run.drive.speed) / (CALM * run.drive.speed.powi(2));
    let in_time = run.in_time(first, clock.clone());
    let mut clock = in_time.map_err(|_| diverges(&clock, None, inertia))?;
    let layout = Layout::new(problem, first);
    let start = layout.state(problem, &clock, &|x| retimed(first, &clock, x));
    let allowed = if depends_on_speed(problem) {
        SETTLED_AT_LIMITS
    } else {
        let accuracy = problem
            .allowed_error()
            .map_or(0.0, |most| most / problem.target_mean());
        (SETTLED_OF_ACCURACY * accuracy).max(SETTLED_AT_LIMITS)
    };
    let last = settled(start, allowed, |state| {
        let (phases, extra) = layout.extra(problem, state);
        // What is kept belongs to the target of the round before.
        let fresh = Search {
            cache: Default::default(),
            ..search.clone()
        };
        let design = at_constant_speed(&problem.on_shaft(&phases, extra), &fresh)?;
        let law = &design.cam.law;
        // A law of a round may stop the shaft that the first one does not.
        let next = run.of_law(law, Some(&clock));
        clock = next.map_err(|_| diverges(&clock, None, inertia))?;
        Ok(Round {
            made: layout.state(problem, &clock, &|x| law.svaj(x)),
            has_law: design.infeasible.is_none(),
            design: (design, clock.clone()),
        })
    })?;
    let (design, clock) = last.design;
    if last.difference > allowed.max(SETTLED) && design.infeasible.is_none() {
        return Err(diverges(&clock, last.contraction, inertia));
    }
    Ok(Last {
        design,
        clock,
        rounds: last.rounds,
        contraction: last.contraction,
    })
}

/// The fault of rounds that do not agree, with an inertia, kg·m², at which they do.
fn diverges(clock: &Motion, contraction: Option<f64>, inertia: f64) -> Error {
    SynthError::ShaftDiverges {
        inertia: Quantity::new(inertia, Dimension::Inertia),
        ripple: Quantity::share(clock.ripple()),
        contraction: contraction.unwrap_or(1.0),
    }
    .at_key("machine.inertia")
}

//! Identification: from the log of a running machine to its parameters, and from what repeats to the next cam.
//!
//! The law s(θ) is known, so that of a steady cycle everything but a shift of the phase is linear:
//!
//! ```text
//! y(φ + ψ) = b + F₀ + m (ω² a + α v) + k s + c ω v + f_C sign v + r(φ) + noise
//! ```
//!
//! The mean cycle is fitted in harmonics, with parameters that cannot be negative. An interval has two sources: the noise of
//! the mean cycle, from the scatter of the same estimate over the cycles, and the force r that repeats and that no parameter
//! explains. r is taken as random in the few harmonics that it is in; so one that could pass for a delay or a damping makes
//! their intervals wide. A parameter whose interval holds 0, or is wider than half its value, is not identified
//! (theory §10).
//!
//! For the next cam it does not matter how a force is named, only that it repeats: [`recut`] adds what the log has beyond the
//! design, less its noise, to the machine (`machine.learned_force`) and designs again within all limits.

mod cycles;
mod fit;
mod log;
mod model;
mod motor;
mod next_run;
mod period;
mod recut;

pub use log::Log;
pub use next_run::{Change, NextRun};
pub use recut::{Recut, recut};

use std::f64::consts::TAU;

use serde::Serialize;

use crate::error::{LogError, Result};
use crate::scene::Scene;
use crate::synth::Design;
use crate::units::Quantity;
use cycles::{Averaged, Cycles};
use fit::{Column, Estimate, Fit, difference, fit};
use model::{ANGLES, Clock, Effect, Machine, Term, terms};

/// Largest part of its value that an interval of an identified parameter has.
const WIDEST: f64 = 0.5;
/// Longest delay of a sensor, s.
const LONGEST_DELAY: f64 = 0.05;
/// Part of the alternating force of the model that its harmonics must hold to be sampled.
const HELD: f64 = 0.999;
/// Alternating force, and mean, of the log as parts of the model's: outside, another unit or machine.
const SIZES: [f64; 2] = [0.4, 2.5];
/// Alternating force below this part of the model's is none.
const NO_FORCE: f64 = 0.02;
/// Newtons of the units that a load cell may have, and part by which a log in such a unit is off.
const UNITS: [(&str, f64); 5] = [
    ("kN", 1e3),
    ("lbf", 4.448_221_615_260_5),
    ("kgf", 9.806_65),
    ("mN", 1e-3),
    ("kip", 4_448.221_615_260_5),
];
const SAME_UNIT: f64 = 0.25;

/// A parameter of the machine, as the log shows it.
///
/// ```
/// use gaitcam::identify::Parameter;
///
/// let mass = Parameter { key: "drive.mass", value: 71.4, low: Some(71.2), high: Some(71.6), identifiable: true };
/// assert_eq!(serde_json::to_value(&mass).unwrap()["key"], "drive.mass");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Parameter {
    /// Key of the scene, or `log.…` and `guide.…` for what a scene has no key of: `log.bias` (N), `log.delay` (s), `log.scale`,
    /// `guide.damping` (N·s/m), `guide.friction` (N).
    pub key: &'static str,
    /// Most likely value, SI.
    pub value: f64,
    /// Ends of the 95 % interval; `None`: unbounded.
    pub low: Option<f64>,
    /// The same.
    pub high: Option<f64>,
    /// Whether the log holds it.
    pub identifiable: bool,
}

impl Parameter {
    fn of(key: &'static str, found: Estimate, is_positive: bool) -> Parameter {
        let Estimate { value, ends } = found;
        let [low, high] = ends.map(|x| if is_positive { x.max(0.0) } else { x });
        let end = |x: f64| x.is_finite().then_some(x);
        Parameter {
            key,
            value,
            low: end(low),
            high: end(high),
            identifiable: low * high > 0.0 && high - low <= WIDEST * value.abs(),
        }
    }

    /// A parameter whose inverse is estimated; one that may be infinite has the smallest that it may be.
    fn inverse(key: &'static str, found: Estimate) -> Parameter {
        let of = Parameter::of(key, found, true);
        let inverse = |x: f64| (x > 0.0).then(|| 1.0 / x);
        let [low, high] = [of.high.and_then(inverse), of.low.and_then(inverse)];
        let value = inverse(of.value).or(low).unwrap_or(0.0);
        Parameter {
            value,
            low,
            high,
            ..of
        }
    }

    fn unknown(key: &'static str, value: f64) -> Parameter {
        let (low, high, identifiable) = (None, None, false);
        Parameter {
            key,
            value,
            low,
            high,
            identifiable,
        }
    }
}

/// What a log shows of a machine.
///
/// ```
/// use gaitcam::{identify::{Log, identify}, scene, synthesise};
///
/// // The footbridge shaker of 73 kg instead of 71.4 kg, with a cell that reads 5 N too much and scatters by 2 N.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let mut text = String::from("theta_rad,time_s,force_n\n");
/// for i in 0..4000 {
///     let (time, scatter) = (0.002 * f64::from(i), f64::from(i * 7919 % 101) / 25.0 - 2.0);
///     let theta = design.problem.drive.speed * time;
///     let a = design.cam.law.svaj(theta).a * design.problem.drive.speed.powi(2);
///     text += &format!("{theta},{time},{}\n", 73.0 * (9.81 + a) + 5.0 + scatter);
/// }
/// let found = identify(&design, &scene, &Log::read("log.csv".as_ref(), text.as_bytes())?)?;
/// let mass = found.parameters.iter().find(|p| p.key == "drive.mass").unwrap();
/// assert!(mass.identifiable && (mass.value - 73.0).abs() < 0.2);
/// // A cell that reads 2 % too much and a machine that is 2 % heavier look alike.
/// assert!(found.parameters.iter().any(|p| p.key == "log.scale" && !p.identifiable));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct Identified {
    /// What was looked for.
    pub parameters: Vec<Parameter>,
    /// Root mean square of the samples about the mean cycle, N.
    pub noise_rms_n: f64,
    /// Root mean square of the force that repeats and that no parameter explains, N.
    pub repeatable_rms_n: f64,
    /// Mean speed, rad/s.
    pub speed_rad_per_s: f64,
    /// Whole cycles of the log.
    pub cycles: usize,
    /// Whether the log has the cam angle; otherwise its phase is the one at which it fits best.
    pub has_angle: bool,
    /// The run that would tell what this one does not.
    pub next_run: Option<NextRun>,
    /// Measured mean cycle and model at equal cam angles, N.
    #[serde(skip)]
    pub measured_n: Vec<f64>,
    /// The same.
    #[serde(skip)]
    pub modelled_n: Vec<f64>,
}

impl Identified {
    /// The scene of the machine: identified keys with their values, all others as they were.
    ///
    /// # Errors
    /// A value that the scene refuses.
    pub fn scene(&self, scene: &Scene) -> Result<Scene> {
        let mut out = scene.clone();
        for parameter in self.parameters.iter().filter(|p| p.identifiable) {
            let Some(key) = crate::scene::keys::find(parameter.key) else {
                continue;
            };
            let value = crate::scene::keys::Value::Number(parameter.value);
            key.set(&mut out, 0, value)?;
        }
        crate::scene::read(&out.to_table())
    }
}

/// A log on the machine of a design, fitted.
struct Fitted {
    cycles: Cycles,
    clock: Clock,
    terms: Vec<Term>,
    columns: Vec<Column>,
    fit: Fit,
}

/// The parameters of the machine of a design, `scene` as it is written, from a log.
///
/// # Errors
/// A log that does not hold a steady run of this machine, with what it shows instead.
pub fn identify(design: &Design, scene: &Scene, log: &Log) -> Result<Identified> {
    Ok(identified(design, scene, &Fitted::of(design, scene, log)?))
}

fn identified(design: &Design, scene: &Scene, fitted: &Fitted) -> Identified {
    let Fitted {
        cycles, terms, fit, ..
    } = fitted;
    let lever = design.problem.drive.lever;
    let mut parameters: Vec<Parameter> = (terms.iter().zip(&fit.each))
        .map(|(t, found)| match t.effect {
            Effect::Compliance => Parameter::inverse(t.key, *found),
            _ => Parameter::of(t.key, *found, t.is_positive),
        })
        .collect();
    let delay = Estimate {
        value: fit.shift.value / cycles.speed,
        ends: fit.shift.ends.map(|x| x / cycles.speed),
    };
    parameters.push(match cycles.by_angle {
        true => Parameter::of("log.delay", delay, true),
        false => Parameter::unknown("log.delay", delay.value),
    });
    parameters.push(Parameter::unknown("log.scale", 1.0));
    parameters.extend(motor::parameters(design, fitted));
    let energy: f64 = fit.repeats.iter().sum();
    let modelled = fitted.modelled();
    let in_newtons = |harmonics: &[f64]| -> Vec<f64> {
        let values = fitted.clock.at_angles(harmonics);
        values
            .into_iter()
            .map(|f| design.problem.drive.newtons(f))
            .collect()
    };
    Identified {
        noise_rms_n: cycles.noise_rms / lever,
        repeatable_rms_n: (0.5 * energy).sqrt() / lever,
        speed_rad_per_s: cycles.speed,
        cycles: cycles.force.each.len(),
        has_angle: cycles.by_angle,
        next_run: next_run::next_run(design, scene, fitted, &parameters),
        measured_n: in_newtons(&fit.measured.mean),
        modelled_n: in_newtons(&modelled),
        parameters,
    }
}

impl Fitted {
    fn of(design: &Design, scene: &Scene, log: &Log) -> Result<Fitted> {
        let law = design.pressing();
        if !law.is_closed() || law.extent() != (0.0, TAU) || design.problem.drive.speed <= 0.0 {
            return Err(log.refused(LogError::NoTurn));
        }
        let speed = design.problem.drive.speed;
        let still = Clock::steady(design);
        let machine = Machine::new(design, scene, &still);
        let wanted = still.harmonics(&machine.nominal_force(), ANGLES / 4 + 1);
        let mut cycles = Cycles::of(log, speed, held(&wanted))?;
        if design.problem.drive.lever != 1.0 {
            let lever = design.problem.drive.lever;
            cycles.force = cycles.force.map(|c| c.iter().map(|f| lever * f).collect());
            cycles.noise_rms *= lever;
        }
        let clock = Clock::of(design, &cycles);
        if !clock.speed.iter().all(|w| *w > 0.0) {
            return Err(log.refused(period::no_cycle(speed)));
        }
        let machine = Machine::new(design, scene, &clock);
        let count = cycles.force.mean.len();
        let wanted = clock.harmonics(&machine.nominal_force(), count);
        let longest = if cycles.by_angle {
            LONGEST_DELAY * cycles.speed
        } else {
            TAU
        };
        let shifts = [0.0, longest.min(TAU)];
        check_size(log, design, &cycles.force.mean, &wanted, shifts)?;
        let terms = terms(design, scene);
        let columns: Vec<Column> = terms
            .iter()
            .map(|t| Column {
                values: clock.harmonics(&machine.effect(t.effect), count),
                is_positive: t.is_positive,
            })
            .collect();
        let fit = fit(&columns, &cycles.force, shifts);
        Ok(Fitted {
            cycles,
            clock,
            terms,
            columns,
            fit,
        })
    }

    /// The model with the fitted parameters.
    fn modelled(&self) -> Vec<f64> {
        let mut out = vec![0.0; self.fit.measured.mean.len()];
        for (column, found) in self.columns.iter().zip(&self.fit.each) {
            (out.iter_mut().zip(&column.values)).for_each(|(x, c)| *x += found.value * c);
        }
        out
    }
}

impl Clock {
    /// At the design's own speed.
    fn steady(design: &Design) -> Clock {
        let none = Averaged {
            each: Vec::new(),
            mean: Vec::new(),
        };
        Clock::of(
            design,
            &Cycles {
                speed: design.problem.drive.speed,
                by_angle: false,
                force: none,
                shaft: None,
                torque: None,
                lead: None,
                noise_rms: 0.0,
            },
        )
    }
}

/// Number of harmonics that hold all but a thousandth of the energy.
fn held(harmonics: &[f64]) -> usize {
    let energy = |n: usize| harmonics[2 * n - 1].powi(2) + harmonics[2 * n].powi(2);
    let count = harmonics.len() / 2;
    let all: f64 = (1..=count).map(energy).sum();
    let mut sum = 0.0;
    let enough = (1..=count).find(|n| {
        sum += energy(*n);
        sum >= HELD * all
    });
    enough.unwrap_or(count)
}

/// Refuses a force that is none of this machine: no size, another unit, the other sign.
fn check_size(
    log: &Log,
    design: &Design,
    measured: &[f64],
    wanted: &[f64],
    shifts: fit::Shifts,
) -> Result<()> {
    let size = |x: &[f64]| fit::dot(&x[1..], &x[1..]).sqrt();
    let (found, known) = (size(measured), size(wanted));
    let newtons = |x: f64| Quantity::force(design.problem.drive.newtons(x / 2.0_f64.sqrt()));
    let ratio = found / known;
    if ratio < NO_FORCE * 1e-3 {
        let (found, expected) = (newtons(found), newtons(known));
        return Err(log.refused(LogError::NoAlternating { found, expected }));
    }
    let is_known = |x: f64| (SIZES[0]..=SIZES[1]).contains(&x);
    let has_mean = wanted[0].abs() > 0.2 * known;
    let mean = measured[0] / wanted[0];
    if !is_known(ratio) || (has_mean && !is_known(mean.abs())) {
        let near = |x: f64, unit: f64| (x * unit - 1.0).abs() < SAME_UNIT;
        let fits = |u: &&(&str, f64)| near(ratio, u.1) && (!has_mean || near(mean.abs(), u.1));
        let unit = UNITS.iter().find(fits).map(|u| u.0.to_string());
        let (found, expected) = (newtons(found), newtons(known));
        return Err(log.refused(match unit {
            Some(unit) => LogError::WrongUnit {
                unit,
                found,
                expected,
            },
            None if ratio < NO_FORCE => LogError::NoAlternating { found, expected },
            None => LogError::OtherSize { found, expected },
        }));
    }
    let alternating = |x: &[f64]| {
        let mut out = x.to_vec();
        out[0] = 0.0;
        out
    };
    let (own, other) = (alternating(measured), alternating(wanted));
    let along = |sign: f64| {
        let column = Column {
            values: other.iter().map(|x| sign * x).collect(),
            is_positive: true,
        };
        let each = Averaged {
            each: vec![own.clone(), own.clone()],
            mean: own.clone(),
        };
        let found = fit(&[column], &each, shifts);
        let model: Vec<f64> = other
            .iter()
            .map(|x| sign * found.each[0].value * x)
            .collect();
        let left = difference(&found.measured.mean, &model);
        fit::dot(&left, &left)
    };
    let is_turned = match has_mean {
        true => mean < 0.0,
        false => along(-1.0) < 0.5 * along(1.0),
    };
    match is_turned {
        true => Err(log.refused(LogError::WrongSign)),
        false => Ok(()),
    }
}

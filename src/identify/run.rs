//! A log, divided into cycles, for the machine of a design. Logs whose magnitude, unit or sign does not fit the machine are rejected.

use std::f64::consts::TAU;

use super::cycles::{Averaged, Cycles};
use super::fit::{Shift, fit};
use super::least_squares::{Column, difference, dot};
use super::log::Log;
use super::model::{ANGLES, Clock, Machine, terms};
use super::period;
use crate::error::{LogError, Result};
use crate::scene::Scene;
use crate::synth::Design;
use crate::units::Quantity;

/// Maximum delay of a sensor, s.
pub(super) const LONGEST_DELAY: f64 = 0.05;
/// Minimum fraction of the energy of the alternating force that the harmonics must contain.
const HELD: f64 = 0.999;
/// Range of the ratio of measured to modelled force, for the alternating and the mean force. A ratio outside this range indicates another
/// unit or another machine.
const SIZES: [f64; 2] = [0.4, 2.5];
/// Ratio of measured to modelled alternating force below which the measured alternating force counts as zero. Another unit of the force is
/// tried first.
const NO_FORCE: f64 = 0.02;
/// Common units of load cells, each with its value in N. They are tried if the magnitude of the measured force does not fit the machine.
const UNITS: [(&str, f64); 5] = [
    ("kN", 1e3),
    ("lbf", 4.448_221_615_260_5),
    ("kgf", 9.806_65),
    ("mN", 1e-3),
    ("kip", 4_448.221_615_260_5),
];
const SAME_UNIT: f64 = 0.25;

/// Cycles of one log, with the columns of the linear model in the motion of the log.
pub(super) struct Run {
    /// Name of the log in messages: the file name without folders.
    pub name: String,
    pub cycles: Cycles,
    pub clock: Clock,
    pub columns: Vec<Column>,
    /// Range of the phase delay of the log, rad.
    pub phases: [f64; 2],
}

impl Run {
    pub fn of(design: &Design, scene: &Scene, log: &Log) -> Result<Run> {
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
        let longest = match cycles.by_angle {
            true => LONGEST_DELAY * cycles.speed,
            false => TAU,
        };
        let phases = [0.0, longest.min(TAU)];
        check_size(log, design, &cycles.force.mean, &wanted, phases)?;
        let columns = terms(design, scene).into_iter().map(|t| Column {
            values: clock.harmonics(&machine.effect(t.effect), count),
            is_positive: t.is_positive,
        });
        Ok(Run {
            name: log.name(),
            columns: columns.collect(),
            cycles,
            clock,
            phases,
        })
    }
}

impl Clock {
    /// Motion of the cam at the speed of the design.
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

/// Number of harmonics that contain 99.9 % of the energy of the alternating force.
pub(super) fn held(harmonics: &[f64]) -> usize {
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

/// Rejects a force whose magnitude, unit or sign is impossible for this machine.
fn check_size(
    log: &Log,
    design: &Design,
    measured: &[f64],
    wanted: &[f64],
    phases: [f64; 2],
) -> Result<()> {
    let size = |x: &[f64]| dot(&x[1..], &x[1..]).sqrt();
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
        let shift = Shift {
            range: phases,
            rates: vec![1.0],
        };
        let found = fit(&[column], &[each], &[shift], &[0.0]);
        let model: Vec<f64> = other
            .iter()
            .map(|x| sign * found.each[0].value * x)
            .collect();
        let left = difference(&found.measured[0].mean, &model);
        dot(&left, &left)
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

//! Twins: simulated machines whose parameters are hidden from `identify` and `recut`. The tests measure the force error after one and two corrected
//! cams, and how often the 95 % interval of a parameter contains its true value.

mod machine;
pub mod report;

use std::f64::consts::TAU;
use std::path::Path;

pub use machine::{Dice, PARTS, RunOfTwin, Sensors, Twin};

use gaitcam::drive::Drive;
use gaitcam::error::Result;
use gaitcam::force::ForceCurve;
use gaitcam::identify::{Log, LogOptions, Parameter, Recut, identify, recut};
use gaitcam::scene::{self, Scene};
use gaitcam::synth::{Design, Search, synthesise};

/// Scenes of a walking force on a moving axis, with and without a spring. The accuracy is 0.1 % of the weight, so that the error of the law is
/// negligible.
const SCENES: [&str; 2] = [
    "name = \"moving\"\n[gait]\nmodel = \"young\"\nstep_frequency = \"1.85 Hz\"\nbody_weight = \"700 N\"\n\
     [cam]\nfollower = \"flat-translating\"\nbore = \"12 mm\"\n[limits]\ncurvature = \"5 mm\"\n[accuracy]\nrms = \"0.1 %\"\n",
    "name = \"sprung\"\n[gait]\nmodel = \"young\"\nstep_frequency = \"1.85 Hz\"\nbody_weight = \"700 N\"\n\
     [drive]\nkind = \"fixed-axis\"\nmass = \"2 kg\"\nspring_rate = \"20000 N/m\"\npreload = \"300 N\"\ndamping = \"20 N s/m\"\n\
     [cam]\nfollower = \"roller-translating\"\nroller_radius = \"12 mm\"\n[accuracy]\nrms = \"0.1 %\"\n",
];

/// Effects of a twin that the model of `identify` does not contain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// No further effect: rigid, constant speed, viscous and Coulomb friction, a delay.
    Model,
    /// A force in two harmonics that no parameter explains.
    TwoHarmonics,
    /// Compliance, Stribeck friction, motor ripple, play, sensor lag, a floor.
    Whole,
}

/// Scene with its design, and a machine built for it.
pub struct Case {
    /// Scene with the nominal parameters.
    pub scene: Scene,
    /// Target force of the scene.
    pub target: ForceCurve,
    /// Design for the scene.
    pub design: Design,
    /// Machine with hidden parameters.
    pub twin: Twin,
    dice: Dice,
}

impl Case {
    /// Case with a number, which is the seed.
    ///
    /// # Errors
    ///
    /// Errors of the scene.
    pub fn new(class: Class, number: u64) -> Result<Case> {
        let mut dice = Dice(number.wrapping_mul(0x1000_0000_01b3) ^ class as u64);
        let scene = scene::parse(SCENES[usize::from(number % 3 == 2)])?;
        let target = scene.model_force()?;
        let design = synthesise(&scene, target.as_ref())?;
        let target = target.ok_or_else(|| crate::fault("no force"))?;
        let twin = draw(class, &design.problem.drive, &mut dice);
        Ok(Case {
            scene,
            target,
            design,
            twin,
            dice,
        })
    }

    /// Log of the twin with a design.
    ///
    /// # Errors
    ///
    /// A log that is rejected.
    pub fn log(&mut self, design: &Design) -> Result<(Log, f64)> {
        let run = self.twin.run(&design.cam.law, &mut self.dice);
        let log = Log::read(
            Path::new("twin.csv"),
            run.log.as_bytes(),
            &LogOptions::default(),
        )?;
        Ok((log, self.error(&run.force)))
    }

    /// RMS difference between a force and the target over time at the best phase, percent of the weight. On a moving axis, the means are removed,
    /// since they are the weights of machine and walker.
    fn error(&self, force: &[f64]) -> f64 {
        let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
        let wanted = |shift: f64| -> Vec<f64> {
            let at = |i| self.target.at(TAU * i as f64 / PARTS as f64 + shift);
            (0..PARTS).map(at).collect()
        };
        let weight = mean(&wanted(0.0));
        let is_carried = self.twin.drive.spring_rate == 0.0;
        let error = |shift: f64| {
            let target = wanted(shift);
            let offset = if is_carried {
                mean(force) - mean(&target)
            } else {
                0.0
            };
            let square = |(f, t): (&f64, &f64)| (f - t - offset).powi(2);
            let sum: f64 = force.iter().zip(&target).map(square).sum();
            100.0 * (sum / PARTS as f64).sqrt() / weight
        };
        let tried = (-100..=100).map(|k| error(0.002 * f64::from(k)));
        tried.fold(f64::INFINITY, f64::min)
    }

    /// Force errors before and after each corrected cam, percent of the weight, with the prediction, N.
    ///
    /// # Errors
    ///
    /// A log that is rejected. If the residual is noise, the cam stays the same.
    pub fn cuts(&mut self, cuts: usize) -> Result<(Vec<f64>, Vec<Recut>)> {
        let mut design = self.design.clone();
        let mut scene = self.scene.clone();
        let (mut errors, mut predicted) = (Vec::new(), Vec::new());
        for cut in 0..=cuts {
            let (log, error) = self.log(&design)?;
            errors.push(error);
            if cut == cuts {
                break;
            }
            let search = Search::default();
            match recut(&design, &scene, Some(&self.target), &[log], &search) {
                Ok((next, figures, _)) => {
                    design = synthesise(&next, Some(&self.target))?;
                    (scene, predicted) = (next, [predicted, vec![figures]].concat());
                }
                Err(error) if error.code() == "log-noise" => {}
                Err(error) => return Err(error),
            }
        }
        Ok((errors, predicted))
    }

    /// Identified parameters with their true values, for the parameters of the twin.
    ///
    /// # Errors
    ///
    /// A log that is rejected.
    pub fn parameters(&mut self) -> Result<Vec<(Parameter, f64)>> {
        let design = self.design.clone();
        let (log, _) = self.log(&design)?;
        let found = identify(&design, &self.scene, &[log])?;
        let twin = &self.twin;
        let truth = |key: &str| match key {
            "drive.mass" => Some(twin.drive.mass),
            "drive.spring_rate" => Some(twin.drive.spring_rate),
            "drive.damping" => Some(twin.drive.damping + twin.guide[0]),
            "drive.preload" => Some(twin.drive.rest_force + twin.sensors.bias),
            "guide.damping" => Some(twin.guide[0]),
            "guide.friction" => Some(twin.guide[1]),
            "log.bias" => Some(twin.sensors.bias),
            "machine.stiffness" => Some(twin.contact.map_or(f64::INFINITY, |c| c[0])),
            "log.delay" if twin.sensors.has_angle => Some(twin.sensors.delay + twin.sensors.lag),
            _ => None,
        };
        let known = found.parameters.into_iter();
        Ok(known.filter_map(|p| Some((p, truth(p.key)?))).collect())
    }
}

/// Random machine built for a drive.
fn draw(class: Class, nominal: &Drive, dice: &mut Dice) -> Twin {
    let is_whole = class == Class::Whole;
    let mut near = |x: f64, part: f64| x * (1.0 + dice.between(-part, part));
    let mut drive = Drive {
        mass: near(nominal.mass, 0.03),
        spring_rate: near(nominal.spring_rate, 0.03),
        damping: near(nominal.damping, 0.3),
        ..*nominal
    };
    drive.rest_force = match nominal.spring_rate {
        0.0 => drive.mass * gaitcam::units::G,
        _ => near(nominal.rest_force, 0.02),
    };
    let sensors = Sensors {
        rate: dice.between(500.0, 2000.0),
        cycles: dice.between(15.0, 40.0) as usize,
        noise: dice.between(1.0, 5.0),
        bias: if nominal.spring_rate > 0.0 {
            0.0
        } else {
            dice.between(-7.0, 7.0)
        },
        lag: if is_whole {
            dice.between(2e-4, 2e-3)
        } else {
            0.0
        },
        delay: dice.between(0.0, 2e-3),
        has_angle: dice.unit() < 0.7,
        has_speed: dice.unit() < 0.3,
    };
    let guide = [
        dice.between(5.0, 40.0),
        dice.between(1.0, 6.0),
        if is_whole {
            dice.between(0.0, 3.0)
        } else {
            0.0
        },
        dice.between(5e-3, 3e-2),
    ];
    let force = |dice: &mut Dice, n: f64| (n, dice.between(2.0, 8.0), dice.between(0.0, TAU));
    let stiffness = dice.between(4e6, 2.2e7);
    let ratio = dice.between(0.03, 0.1);
    let damping = 2.0 * ratio * (stiffness * drive.mass).sqrt();
    let floor = [
        dice.between(1e4, 6e4),
        TAU * dice.between(5.0, 15.0),
        dice.between(0.01, 0.03),
    ];
    let number = dice.between(4.0, 13.0).floor();
    let motor = [
        dice.between(5.0, 20.0),
        dice.between(20.0, 100.0),
        dice.between(0.0, 1.0),
        number,
    ];
    Twin {
        contact: is_whole.then_some([stiffness, damping]),
        motor: is_whole.then_some(motor),
        play: if is_whole {
            dice.between(0.0, 5e-6)
        } else {
            0.0
        },
        floor: (is_whole && dice.unit() < 0.5).then_some(floor),
        extra: match class {
            Class::Model => Vec::new(),
            Class::TwoHarmonics | Class::Whole => {
                let first = dice.between(1.0, 3.0).floor();
                let second = dice.between(3.0, 7.0).floor();
                vec![force(dice, first), force(dice, second)]
            }
        },
        drive,
        guide,
        sensors,
    }
}

//! Speed of the camshaft over time for which a cam reproduces the steps of a recorded walk.

use std::f64::consts::TAU;

use super::follower::{Follower, ProgrammeRun};
use super::mode::Misfit;
use super::speed::SpeedProgramme;
use super::spline::Periodic;
use crate::dynamics::run::Run;
use crate::error::{DynamicsError, Result};
use crate::force::Walk;
use crate::units::{Dimension, Quantity};

/// Maximum and minimum smoothing parameter, relative to the cube of a step time. The speed is practically constant at the maximum and
/// practically unsmoothed at the minimum.
const SMOOTHEST: f64 = 1e9;
const LEAST: f64 = 1e-6;
/// Number of halvings in the search for the smoothing parameter on a logarithmic scale.
const HALVINGS: usize = 24;

/// Bounds that a speed programme must satisfy.
///
/// ```
/// use gaitcam::dynamics::Bounds;
///
/// let free = Bounds { acceleration: f64::INFINITY, force_min: 0.0 };
/// assert!(free.acceleration > 10.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Maximum angular acceleration of the camshaft, rad/s².
    pub acceleration: f64,
    /// Minimum contact force of the run, N.
    pub force_min: f64,
}

/// Speed programme for a recorded walk, and the run of the cam that follows it.
///
/// ```
/// use gaitcam::dynamics::{Bounds, Followed};
/// use gaitcam::force::{Feet, ReadOptions, force_curve};
/// use gaitcam::scene;
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/data/recordings/made_walk.csv"));
/// let force = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let scene = scene::parse("gait.file = \"walk.csv\"")?;
/// let design = scene.design_for(&force)?;
/// let walk = design.walk().unwrap();
/// let run = design.emitted(&scene.machine, design.problem.drive)?;
/// let bounds = Bounds { acceleration: 50.0, force_min: 0.0 };
/// let found = Followed::new(&run, &walk, 2, 0.0, walk.middle(), bounds)?;
/// // The nine strides have the recorded step times, and nearly the recorded response.
/// assert!(found.step_error_s < 1e-9 && found.misfits[1].misfit < 0.05);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Followed {
    /// Programme: speed of the shaft; with a motor, commanded no-load speed.
    pub programme: SpeedProgramme,
    /// Run of the cam that follows the programme.
    pub run: ProgrammeRun,
    /// Force of the walk (recorded or generated) at the rows, N.
    pub walk_n: Vec<f64>,
    /// Differences between the responses of a structural mode to the force of the walk and to the force of the cam.
    pub misfits: [Misfit; 3],
    /// Maximum deviation of a step time of the programme from the recorded one, s.
    pub step_error_s: f64,
    /// Root mean square difference between the force of the cam and the force of the walk, N.
    pub rms_error_n: f64,
}

/// Cam angles of the heel strikes of a walk, rad, increasing. One turn is a stride of two steps, or one step. The heel strike that begins
/// the cycle of the force is at the angle `first`. The heel strike of the other foot is at the fraction `middle` of a stride.
fn strike_angles(walk: &Walk, steps_per_turn: usize, first: f64, middle: f64) -> Vec<f64> {
    let angle = |i: usize| match steps_per_turn {
        1 => TAU * i as f64,
        _ => TAU * ((i / 2) as f64 + if i % 2 == 1 { middle } else { 0.0 }),
    };
    (0..walk.steps_s.len()).map(|i| first + angle(i)).collect()
}

impl SpeedProgramme {
    /// Times of the rows of the programme for a walk, s: the times of its force samples, and its end.
    fn times(walk: &Walk) -> Vec<f64> {
        let count = walk.samples();
        let at = |i: usize| walk.duration_s * i as f64 / count as f64;
        (0..=count).map(at).collect()
    }

    /// Speed programme whose cam angles at the heel strikes approximate `angles`, rad, smoothed with the weight `lambda`. Also returns the
    /// cam angle at the first row, rad, and the spline of the deviation from constant speed, rad.
    fn of(walk: &Walk, angles: &[f64], turns: f64, lambda: f64) -> (SpeedProgramme, f64, Periodic) {
        let mean = TAU * turns / walk.duration_s;
        let off = angles.iter().zip(&walk.steps_s);
        let off: Vec<f64> = off.map(|(angle, t)| angle - mean * t).collect();
        let spline = Periodic::smoothed(&walk.steps_s, &off, walk.duration_s, lambda);
        let time_s = SpeedProgramme::times(walk);
        let speed = time_s.iter().map(|t| mean + spline.at(*t)[1]).collect();
        (SpeedProgramme { time_s, speed }, spline.at(0.0)[0], spline)
    }
}

impl Followed {
    /// Computes the speed for which a cam reproduces the step times of a walk, with the minimum smoothing that the bounds and the motor
    /// permit. `steps_per_turn` is 1 or 2. The cycle of the cam's force begins at the cam angle `first`. The other foot strikes at the
    /// fraction `middle` of the cycle.
    ///
    /// # Errors
    /// The cam violates a bound even at constant speed; the motor cannot follow the programme; the rigid model does not support the cam or
    /// the machine.
    pub fn new(
        run: &Run,
        walk: &Walk,
        steps_per_turn: usize,
        first: f64,
        middle: f64,
        bounds: Bounds,
    ) -> Result<Followed> {
        let follower = Follower::new(run)?;
        let angles = strike_angles(walk, steps_per_turn, first, middle);
        let turns = walk.steps_s.len() as f64 / steps_per_turn as f64;
        let unit = (0.5 * walk.duration_s / walk.strides() as f64).powi(3);
        let of = |lambda: f64| SpeedProgramme::of(walk, &angles, turns, lambda * unit);
        let keeps = |lambda: f64| -> Result<()> {
            let (programme, start, spline) = of(lambda);
            let slowest = programme
                .speed
                .iter()
                .copied()
                .fold(f64::INFINITY, f64::min);
            let run = follower.prescribed(&programme, start);
            let least = run.force_n.iter().copied().fold(f64::INFINITY, f64::min);
            if spline.most_bend() > bounds.acceleration || slowest <= 0.0 {
                let most = Quantity::new(bounds.acceleration, Dimension::AngularAcceleration);
                return Err(DynamicsError::ProgrammeAcceleration { most }.into());
            }
            if least < bounds.force_min {
                let [least, limit] = [least, bounds.force_min].map(Quantity::force);
                return Err(DynamicsError::ProgrammeContact { least, limit }.into());
            }
            follower.command(&run).map(drop)
        };
        let lambda = match keeps(0.0) {
            Ok(()) => 0.0,
            Err(_) => {
                keeps(SMOOTHEST)?;
                let (mut low, mut high) = (libm::log(LEAST), libm::log(SMOOTHEST));
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    match keeps(libm::exp(middle)) {
                        Ok(()) => high = middle,
                        Err(_) => low = middle,
                    }
                }
                libm::exp(high)
            }
        };
        let (speed, start, spline) = of(lambda);
        let run = follower.prescribed(&speed, start);
        let mean = TAU * turns / walk.duration_s;
        let step_error = walk.steps_s.iter().zip(&angles).map(|(t, angle)| {
            let [off, rate, _] = spline.at(*t);
            ((mean * t + off - angle) / (mean + rate)).abs()
        });
        let step_error_s = step_error.fold(0.0, f64::max);
        let mut walk_n = walk.force_n();
        walk_n.push(walk_n[0]);
        let programme = SpeedProgramme {
            speed: follower.command(&run)?,
            time_s: speed.time_s,
        };
        Ok(Followed {
            misfits: run.misfits(&walk_n, walk.strides()),
            rms_error_n: run.rms_error(&walk_n),
            programme,
            run,
            walk_n,
            step_error_s,
        })
    }
}

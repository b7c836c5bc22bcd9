//! Response of the floor as a function of the step frequency at which the cam runs.

use std::f64::consts::TAU;

use crate::drive::Drive;
use crate::dynamics::FloorMotion;
use crate::dynamics::floor::harmonics;
use crate::synth::design::Design;

/// Number of equally spaced angles at which the force is computed.
const SAMPLES: usize = 720;
/// Step frequencies of the resonance curve: first value, Hz, step, Hz, and number of values.
const CURVE: (f64, f64, usize) = (1.0, 0.01, 201);
/// Number of harmonics of the force for which resonances are computed.
const MOST_RESONANT: u32 = 10;
const FLANKS: [f64; 9] = [-4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0];

/// Response of the floor at one step frequency.
///
/// ```
/// use gaitcam::dynamics::FloorMotion;
/// use gaitcam::synth::AtFrequency;
///
/// let motion = FloorMotion::of(&[(2.6, 0.0)]);
/// let at = AtFrequency { step_frequency: 1.85, motion, of_cam: motion };
/// assert_eq!(at.motion.comfort.setra(), "unacceptable");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtFrequency {
    /// Step frequency of the point, Hz.
    pub step_frequency: f64,
    /// Steady motion of the floor under the target force.
    pub motion: FloorMotion,
    /// Steady motion of the floor under the force of the finished cam, at the cam speed for this step frequency.
    pub of_cam: FloorMotion,
}

impl Design {
    /// Steady motion of the floor as a function of the step frequency, at equal steps and near the resonances. Undamped resonances are omitted.
    /// Empty for a rigid floor.
    pub fn resonance(&self) -> Vec<AtFrequency> {
        let floor = self.problem.machine.floor();
        let Some((floor, target)) = floor.zip(self.target_in_time()) else {
            return Vec::new();
        };
        let factors = self.load_factors();
        let steps = factors.first().map_or(1.0, |f| 1.0 / f.of_step);
        let (first, step, count) = CURVE;
        let last = first + step * (count - 1) as f64;
        let mut at: Vec<f64> = (0..count).map(|i| first + step * i as f64).collect();
        for mode in &floor.modes {
            // Resonance of the mode without the shaker, and with the mass of the shaker.
            let carried = self.problem.drive.mass * mode.ordinate.powi(2) / mode.mass;
            for frequency in [mode.frequency, mode.frequency / (1.0 + carried).sqrt()] {
                for harmonic in 1..=MOST_RESONANT {
                    let peak = steps * frequency / f64::from(harmonic);
                    let flanks = FLANKS.map(|widths| peak * (1.0 + widths * mode.damping));
                    at.extend(flanks.into_iter().filter(|f| (first..=last).contains(f)));
                }
            }
        }
        at.sort_by(f64::total_cmp);
        at.dedup();
        let angle = |i: usize| TAU * i as f64 / SAMPLES as f64;
        let sampled = |of: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
            harmonics(&(0..SAMPLES).map(|i| of(angle(i))).collect::<Vec<_>>())
        };
        let wanted = sampled(&|x| target.at(x));
        let (all, others) = (floor.of_walkers(0, &wanted), floor.of_walkers(1, &wanted));
        let point = |step_frequency: f64| {
            let speed = TAU * step_frequency / steps;
            let answer = floor.acceleration(speed, &all).ok()?;
            let drive = Drive {
                speed,
                ..self.problem.drive
            };
            let still = sampled(&|x| drive.force(self.cam.law.svaj(x)));
            let own = floor.pressed(drive.mass, speed, &still, &others).ok()?;
            let both = own.iter().zip(&others).map(|(a, b)| (a.0 + b.0, a.1 + b.1));
            let of_cam = floor.acceleration(speed, &both.collect::<Vec<_>>()).ok()?;
            Some(AtFrequency {
                step_frequency,
                motion: FloorMotion::of(&answer),
                of_cam: FloorMotion::of(&of_cam),
            })
        };
        at.into_iter().filter_map(point).collect()
    }
}

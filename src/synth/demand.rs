//! What is wanted, with every number settled, and what can be said before anything is solved.

use std::f64::consts::TAU;

use crate::drive::{Drive, DriveKind};
use crate::error::{Error, Result};
use crate::force::ForceCurve;
use crate::scene::{Band, Phase, PhaseWeight, Scene};

/// The target in step with the cam, and the machine that turns lift into force.
#[derive(Debug, Clone)]
pub struct Demand {
    /// One turn of wanted force, scaled to the mass where the scene says so.
    pub target: Option<ForceCurve>,
    /// The machine.
    pub drive: Drive,
    /// Phase of the force cycle at cam angle 0, rad.
    pub phase: f64,
    /// The target's cubics between its samples, N: what the fits read thousands of times.
    pub cubics: Vec<[f64; 4]>,
    /// Typical lift, m: the unit in which solvers work.
    pub length: f64,
    /// Whether an answer without a law says why: a search for one that has a law need not know.
    pub explain: bool,
    /// What a user should know before looking at the result.
    pub remarks: Vec<String>,
}

/// Differences of the mean force from M·g below this part of it are not worth a remark.
const CLOSURE: f64 = 1e-6;
/// A force below this part of the mean asks the moving axis for free fall.
const FREE_FALL: f64 = 0.02;

impl Demand {
    /// Settles speed and mass and scales the target.
    ///
    /// Fails when the scene wants a force and none is given, when the mean force is not positive on a
    /// moving axis, and when the drive relates no lift to force at all.
    ///
    /// A scene whose phase is free begins its cycle at 0 here.
    pub fn settle(scene: &Scene, target: Option<&ForceCurve>) -> Result<Demand> {
        let phase = match scene.gait.as_ref().map(|g| g.phase) {
            Some(Phase::At(phase)) => phase,
            _ => 0.0,
        };
        let target = match (&scene.gait, target) {
            (Some(_), None) => return Err(Error::key("gait", "the force curve was not read")),
            (None, _) => None,
            (Some(_), Some(curve)) if phase != 0.0 => Some(curve.begun_at(phase)),
            (Some(_), Some(curve)) => Some(curve.clone()),
        };
        let spec = &scene.drive;
        let speed = match (spec.speed, &target) {
            (Some(w), _) => w,
            (None, Some(curve)) => TAU / curve.period_s,
            (None, None) => {
                return Err(Error::key(
                    "drive.speed",
                    "needs a value where no force is given",
                ));
            }
        };
        let mut demand = Demand {
            explain: true,
            target,
            drive: Drive::moving_axis(0.0, 0.0, speed),
            phase,
            cubics: Vec::new(),
            length: 0.0,
            remarks: Vec::new(),
        };
        demand.note_speed(spec.speed);
        demand.drive = match spec.kind {
            DriveKind::MovingAxis => {
                let mass = demand.moving_mass(spec.mass, spec.gravity)?;
                if scene.gait.as_ref().is_some_and(|g| g.to_mass) {
                    demand.scale_to(mass * spec.gravity)?;
                }
                Drive::moving_axis(mass, spec.gravity, speed)
            }
            DriveKind::FixedAxis => Drive {
                kind: DriveKind::FixedAxis,
                rest_force: spec.preload,
                spring_rate: spec.spring_rate,
                damping: spec.damping,
                mass: spec.mass.unwrap_or(0.0),
                speed,
            },
            DriveKind::Hydraulic => {
                Drive::hydraulic(spec.pressure_per_volume, spec.piston_radius, speed)
            }
        };
        if demand.target.is_some() && demand.drive.weights() == [0.0; 4] {
            return Err(Error::key(
                "drive",
                "no lift changes the force: spring rate, damping and mass are all zero",
            )
            .help("give at least one of spring_rate, damping, mass"));
        }
        demand.cubics = demand
            .target
            .as_ref()
            .map_or(Vec::new(), ForceCurve::cubics);
        demand.length = demand.typical_lift(scene);
        if demand.drive.kind == DriveKind::MovingAxis {
            demand.diagnose_closure(scene);
        }
        Ok(demand)
    }

    /// Wanted force at an angle of the first turn, N; 0 where none is wanted.
    pub fn wanted(&self, theta: f64) -> f64 {
        let mut out = [0.0];
        self.wanted_on(theta, 0.0, &[(0.0, 0.0)], &mut out);
        out[0]
    }

    /// The same at places u ∈ [0, 1] of a range of the first turn, given with their weights.
    pub fn wanted_on(&self, start: f64, width: f64, places: &[(f64, f64)], out: &mut [f64]) {
        let n = self.cubics.len();
        if n == 0 {
            return out.fill(0.0);
        }
        let per_angle = n as f64 / TAU;
        let (first, step) = (start * per_angle, width * per_angle);
        for (f, (place, _)) in out.iter_mut().zip(places) {
            let x = first + place * step;
            let i = (x as u32 as usize).min(n - 1);
            let u = x - i as f64;
            let [a, b, c, d] = self.cubics[i];
            let v = 1.0 - u;
            *f = v * v * (v * a + 3.0 * u * b) + u * u * (3.0 * v * c + u * d);
        }
    }

    /// Weight of the force error at a cam angle, where the scene weighs phases.
    pub fn weight(&self, scene: &Scene, theta: f64) -> f64 {
        let Some(gait) = &scene.gait else { return 1.0 };
        let at = (theta + self.phase).rem_euclid(TAU);
        let inside = |w: &&PhaseWeight| {
            if w.from < w.to {
                at >= w.from && at < w.to
            } else {
                at >= w.from || at < w.to
            }
        };
        gait.weights
            .iter()
            .rev()
            .find(inside)
            .map_or(1.0, |w| w.weight)
    }

    /// Lowest and highest force of the band that the scene asks for, as cycles like the target.
    ///
    /// Fails on a band of one spread where the target carries none.
    pub fn band(&self, scene: &Scene) -> Result<Option<[ForceCurve; 2]>> {
        let (Some(band), Some(target)) = (scene.gait.as_ref().and_then(|g| g.band), &self.target)
        else {
            return Ok(None);
        };
        let half: Vec<f64> = match (band, &target.spread_n) {
            (Band::Width(width), _) => vec![width; target.force_n.len()],
            (Band::Spread, Some(spread)) => spread.clone(),
            (Band::Spread, None) => {
                return Err(
                    Error::key("gait.band", "the target is one cycle: nothing spreads")
                        .help("give a recording of several steps, or a width: band = \"20 N\""),
                );
            }
        };
        let edge = |sign: f64| {
            let forces = target.force_n.iter().zip(&half);
            target.with_forces(forces.map(|(f, h)| f + sign * h).collect())
        };
        Ok(Some([edge(-1.0), edge(1.0)]))
    }

    fn note_speed(&mut self, given: Option<f64>) {
        if let (Some(w), Some(curve)) = (given, &self.target) {
            let turn = TAU / w;
            if (turn / curve.period_s - 1.0).abs() > 1e-3 {
                self.remarks.push(format!(
                    "One turn takes {turn:.4} s, the force cycle {:.4} s: the curve is stretched to the turn.",
                    curve.period_s
                ));
            }
        }
    }

    fn moving_mass(&self, given: Option<f64>, gravity: f64) -> Result<f64> {
        if let Some(mass) = given {
            return Ok(mass);
        }
        let Some(curve) = &self.target else {
            return Err(Error::key(
                "drive.mass",
                "needs a value where no force is given",
            ));
        };
        let mean = curve.mean_n();
        if mean <= 0.0 {
            return Err(Error::key(
                "gait",
                format!("the mean force is {mean:.3} N, so no mass can rest on the cam"),
            )
            .help("forces must press downwards: check the sign and the column"));
        }
        Ok(mean / gravity)
    }

    fn scale_to(&mut self, weight: f64) -> Result<()> {
        if let Some(curve) = &self.target {
            let mean = curve.mean_n();
            if mean <= 0.0 {
                return Err(Error::key(
                    "gait.scale",
                    format!("a mean force of {mean:.3} N cannot be scaled to {weight:.3} N"),
                ));
            }
            self.target = Some(curve.scaled(weight / mean));
        }
        Ok(())
    }

    fn typical_lift(&self, scene: &Scene) -> f64 {
        let [k, c, m, _] = self.drive.weights();
        let from_force = self.target.as_ref().map_or(0.0, |curve| {
            let largest = curve
                .force_n
                .iter()
                .fold(0.0_f64, |x, f| x.max((f - self.drive.rest_force).abs()));
            let gain = k + c + m;
            if gain > 0.0 { largest / gain } else { 0.0 }
        });
        let points = scene
            .law
            .points
            .iter()
            .filter_map(|p| p.lift)
            .chain(scene.law.dwells.iter().filter_map(|d| d.lift));
        let from_points = points.fold(0.0_f64, |x, l| x.max(l.abs()));
        let from_forces = scene
            .law
            .points
            .iter()
            .filter_map(|p| p.force)
            .fold(0.0_f64, |x, f| x.max(f.abs()));
        let from_forces = if k > 0.0 { from_forces / k } else { 0.0 };
        let typical = from_force.max(from_points).max(from_forces);
        if typical > 0.0 && typical.is_finite() {
            typical
        } else {
            1e-3
        }
    }

    /// Closure of the moving axis (theory §1): mean(F) = M g, free fall, the least stroke.
    fn diagnose_closure(&mut self, scene: &Scene) {
        let Some(curve) = &self.target else { return };
        let (mass, speed) = (self.drive.mass, self.drive.speed);
        let weight = self.drive.rest_force;
        let mean = curve.mean_n();
        let mut remarks = Vec::new();
        if (mean - weight).abs() > CLOSURE * weight.abs() {
            remarks.push(format!(
                "The mean of the wanted force is {mean:.4} N but the mass weighs {weight:.4} N. A cam lifts and lowers; \
                 over a turn it cannot change the mean, so the error stays at {:.4} N at least. \
                 Set drive.mass = \"auto\" or gait.scale = \"to-mass\".",
                (mean - weight).abs()
            ));
        }
        let n = curve.force_n.len();
        let falling = curve
            .force_n
            .iter()
            .filter(|f| **f < FREE_FALL * mean)
            .count();
        if falling > 0 {
            let seconds = falling as f64 / n as f64 * TAU / speed;
            remarks.push(format!(
                "For {:.0} % of the turn ({seconds:.3} s) the wanted force is near zero: the mass must fall freely there, \
                 which alone needs about {:.0} mm of lift. Both feet together (feet = \"both\") never leave the ground.",
                100.0 * falling as f64 / n as f64,
                1e3 * weight / mass * seconds * seconds / 8.0
            ));
        }
        let hardest = curve
            .force_n
            .iter()
            .fold(0.0_f64, |x, f| x.max((f - mean).abs()))
            / mass;
        let period = TAU / speed;
        let largest_stroke = hardest * period * period / 16.0;
        let stroke = scene.limits.stroke.filter(|h| *h > largest_stroke);
        remarks.push(format!(
            "The wanted force accelerates the mass by up to {hardest:.3} m/s², so the stroke is at most {:.1} mm (16 h/T² ≤ max|a|){}.",
            1e3 * largest_stroke,
            if stroke.is_some() { "; the stroke limit cannot bind" } else { "" }
        ));
        self.remarks.extend(remarks);
    }
}

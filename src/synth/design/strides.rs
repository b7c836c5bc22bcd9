//! Law for several consecutive recorded strides, for a servo axis that repeats these strides instead of one mean stride.

use std::f64::consts::TAU;

use super::Design;
use crate::criterion::Criterion;
use crate::criterion::LimitKind;
use crate::drive::DriveKind;
use crate::error::Result;
use crate::force::{ForceCurve, Walk};
use crate::scene::{CamSpec, Family, ForceScale, Gait, LawSpec, Limits, MachineSpec, Scene};

/// Limits on motion and force, which also apply to a servo axis. All other limits apply only to a cam profile or a shaft.
const OF_MOTION: [LimitKind; 6] = [
    LimitKind::Stroke,
    LimitKind::Velocity,
    LimitKind::Acceleration,
    LimitKind::Jerk,
    LimitKind::ForceMin,
    LimitKind::ForceMax,
];
/// Minimum number of spans for each stride.
const SPANS: usize = 24;
/// Minimum permitted RMS force error of the law, relative to the mean force. It is also the default if the design has no limit on its force
/// error.
const ACCEPTED: f64 = 0.005;

impl Design {
    /// Designs a law with one cycle for the given number of consecutive recorded strides. The result contains the design and these strides.
    /// `None` if fewer strides are recorded.
    ///
    /// `scene` is the scene of this design. Its limits on stroke, velocity, acceleration, jerk and force apply to all strides. The strides are
    /// blended at the start of the cycle, so that the law closes without a jump.
    ///
    /// # Errors
    /// Errors of the scene.
    pub fn of_strides(&self, scene: &Scene, strides: usize) -> Result<Option<(Design, Walk)>> {
        let Some(part) = self.walk().and_then(|walk| walk.typical(strides)) else {
            return Ok(None);
        };
        let own = &self.problem.drive;
        let mut drive = scene.drive.clone();
        drive.speed = Some(TAU / part.duration_s);
        drive.mass = Some(own.mass)
            .filter(|mass| *mass > 0.0 && drive.mass.is_none())
            .or(drive.mass);
        let check = self.checks.iter().find(|c| c.name == Criterion::RmsError);
        let rms = check.map_or(ACCEPTED, |c| c.limit / self.force.target_mean_n.abs());
        let scale = match own.kind {
            DriveKind::MovingAxis => ForceScale::ToMass,
            DriveKind::FixedAxis | DriveKind::Hydraulic => ForceScale::None,
        };
        let limits = OF_MOTION
            .into_iter()
            .fold(Limits::default(), |limits, kind| match scene.limits[kind] {
                Some(bound) => limits.with(kind, bound),
                None => limits,
            });
        let scene = Scene {
            name: format!("{}_{strides}_strides", self.problem.name),
            gait: Some(Gait {
                scale,
                ..Gait::given()
            }),
            drive,
            law: LawSpec {
                degree: scene.law.degree,
                spans: Some(strides * self.cam.law.poly().pieces().max(SPANS)),
                ..LawSpec::of(Family::Spline)
            },
            cam: CamSpec::default(),
            limits,
            machine: MachineSpec::default(),
            rms: Some(rms.max(ACCEPTED)),
        };
        let name = scene.name.clone();
        let force = ForceCurve::from_samples(&name, part.duration_s, part.force_n())?;
        Ok(Some((scene.design_for(&force)?, part)))
    }
}

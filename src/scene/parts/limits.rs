//! `[limits]`: limits of the design, such as stroke, jerk and pressure angle.

use std::ops::{Index, IndexMut};

use crate::cam::LimitKind;

/// Limits of the design in SI units, indexed by [`LimitKind`]; `None` means no limit. [`LimitKind::PressureAngle`] is a common bound for
/// rise and fall, so [`Limits::set`] and [`Limits::with`] set both bounds.
///
/// ```
/// use gaitcam::LimitKind;
/// use gaitcam::scene::Limits;
///
/// let limits = Limits::default().with(LimitKind::Stroke, 0.04).with(LimitKind::PressureAngle, 0.5);
/// assert_eq!(limits[LimitKind::Stroke], Some(0.04));
/// assert_eq!(limits[LimitKind::Jerk], None);
/// assert_eq!(limits.pressure_angles(), [Some(0.5), Some(0.5)]);
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Limits {
    bounds: [Option<f64>; LimitKind::ALL.len()],
    /// Default bounds that the scene switches off.
    pub unjudged: Unjudged,
}

impl Index<LimitKind> for Limits {
    type Output = Option<f64>;

    /// Bound of a limit in SI units. For [`LimitKind::PressureAngle`], it is the bound on the rise.
    fn index(&self, kind: LimitKind) -> &Option<f64> {
        &self.bounds[place(kind)]
    }
}

impl IndexMut<LimitKind> for Limits {
    fn index_mut(&mut self, kind: LimitKind) -> &mut Option<f64> {
        &mut self.bounds[place(kind)]
    }
}

fn place(kind: LimitKind) -> usize {
    match kind {
        LimitKind::PressureAngle => LimitKind::PressureAngleRise as usize,
        other => other as usize,
    }
}

impl Limits {
    /// Sets a limit in SI units, or removes it with `None`.
    pub fn set(&mut self, kind: LimitKind, bound: Option<f64>) {
        self[kind] = bound;
        if kind == LimitKind::PressureAngle {
            self[LimitKind::PressureAngleFall] = bound;
        }
    }

    /// Copy of the limits in which one limit has the value `bound`, in SI units.
    #[must_use]
    pub fn with(mut self, kind: LimitKind, bound: f64) -> Limits {
        self.set(kind, Some(bound));
        self
    }

    /// Maximum magnitude of the pressure angle on the rise and on the fall, rad; `None` without a limit.
    pub fn pressure_angles(&self) -> [Option<f64>; 2] {
        [LimitKind::PressureAngleRise, LimitKind::PressureAngleFall].map(|side| self[side])
    }
}

/// Default bounds of the verdict that the scene switches off with `"none"`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Unjudged {
    /// Whether the scene contains `limits.pressure_angle = "none"`.
    pub pressure_angle: bool,
    /// Whether the scene contains `limits.force_min = "none"`.
    pub contact_force: bool,
    /// Whether the scene contains `accuracy.rms = "none"`.
    pub accuracy: bool,
    /// Whether the scene contains `limits.hertz_pressure = "none"`. The allowable pressure from hardness or materials is then not a limit.
    pub contact_pressure: bool,
}

impl Unjudged {
    /// Dotted keys with the value `"none"`.
    pub fn keys(self) -> Vec<&'static str> {
        let all = [
            ("limits.pressure_angle", self.pressure_angle),
            ("limits.force_min", self.contact_force),
            ("accuracy.rms", self.accuracy),
            ("limits.hertz_pressure", self.contact_pressure),
        ];
        all.into_iter().filter(|k| k.1).map(|k| k.0).collect()
    }
}

//! `[limits]`: bounds of the design.

use std::ops::{Index, IndexMut};

use crate::cam::LimitKind;

/// Bounds of the design, by [`LimitKind`], in SI units; `None`: no limit.
///
/// [`LimitKind::PressureAngle`] is one bound for rise and fall: [`Limits::set`] and [`Limits::with`] set both.
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
    /// Default bounds that are switched off.
    pub unjudged: Unjudged,
}

impl Index<LimitKind> for Limits {
    type Output = Option<f64>;

    /// Bound of a limit. For [`LimitKind::PressureAngle`] the result is the bound on the rise.
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
    /// Sets or removes a limit; value in SI units.
    pub fn set(&mut self, kind: LimitKind, bound: Option<f64>) {
        self[kind] = bound;
        if kind == LimitKind::PressureAngle {
            self[LimitKind::PressureAngleFall] = bound;
        }
    }

    /// The limits with one of them set; value in SI units.
    #[must_use]
    pub fn with(mut self, kind: LimitKind, bound: f64) -> Limits {
        self.set(kind, Some(bound));
        self
    }

    /// Maximum |pressure angle| on the rise and on the fall, rad.
    pub fn pressure_angles(&self) -> [Option<f64>; 2] {
        [LimitKind::PressureAngleRise, LimitKind::PressureAngleFall].map(|side| self[side])
    }
}

/// Default bounds of the verdict that are switched off with `"none"`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Unjudged {
    /// Whether `limits.pressure_angle = "none"`.
    pub pressure_angle: bool,
    /// Whether `limits.force_min = "none"`.
    pub contact_force: bool,
    /// Whether `accuracy.rms = "none"`.
    pub accuracy: bool,
    /// Whether `limits.hertz_pressure = "none"`: the allowable pressure of hardness or materials is not a limit.
    pub contact_pressure: bool,
}

impl Unjudged {
    /// The keys with the value `"none"`.
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

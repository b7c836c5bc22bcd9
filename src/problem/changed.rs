//! A problem with another value of what searches change: a limit, the accuracy, a size of the cam.

use super::Problem;
use crate::cam::{Criterion, LimitKind};
use crate::drive::Drive;

impl Problem {
    /// The value of a limit, of the accuracy or of a given size; `None` where the problem leaves it open.
    pub fn value(&self, criterion: Criterion) -> Option<f64> {
        let [rise, fall] = self.limits.pressure_angles();
        match criterion {
            Criterion::Limit(LimitKind::PressureAngle) => rise.filter(|_| rise == fall),
            Criterion::Limit(
                side @ (LimitKind::PressureAngleRise | LimitKind::PressureAngleFall),
            ) => self.limits[side].filter(|_| rise != fall),
            Criterion::Limit(kind) => self.limits[kind],
            Criterion::Accuracy => self.accuracy,
            Criterion::Bore => self.cam.bore,
            Criterion::BaseRadius => self.cam.base_radius,
            Criterion::GivenPrimeRadius => self.cam.prime_radius,
            _ => None,
        }
    }

    /// The same problem with another value of what [`Problem::value`] returns.
    #[must_use]
    pub fn with(&self, criterion: Criterion, value: f64) -> Problem {
        let mut out = self.clone();
        let value = Some(value);
        match criterion {
            Criterion::Limit(kind) => out.limits.set(kind, value),
            Criterion::Accuracy => out.accuracy = value,
            Criterion::Bore => out.cam.bore = value,
            Criterion::BaseRadius => out.cam.base_radius = value,
            Criterion::GivenPrimeRadius => out.cam.prime_radius = value,
            _ => {}
        }
        out
    }

    /// The same problem on another drive.
    #[must_use]
    pub fn with_drive(&self, drive: Drive) -> Problem {
        let mut out = self.clone();
        out.required.drive = drive;
        out
    }
}

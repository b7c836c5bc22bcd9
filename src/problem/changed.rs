//! Variants of a problem. Each method returns a copy of the problem with one change.

use super::Problem;
use crate::cam::{Criterion, LimitKind};
use crate::drive::Drive;
use crate::scene::{CamSpec, LawSpec, Limits, Minimise};

impl Problem {
    /// Value of a limit, of the accuracy, or of a given dimension or inertia, in SI units. The accuracy is relative to the mean force.
    /// `None` if the problem does not specify a value for the criterion.
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
            Criterion::Inertia => self.machine.inertia,
            Criterion::BaseRadius => self.cam.base_radius,
            Criterion::GivenPrimeRadius => self.cam.prime_radius,
            _ => None,
        }
    }

    /// Copy of the problem with the given value for a limit, the accuracy, or a dimension or inertia. Other criteria have no value, and the
    /// copy is then unchanged.
    #[must_use]
    pub fn with(&self, criterion: Criterion, value: f64) -> Problem {
        let mut out = self.clone();
        let value = Some(value);
        match criterion {
            Criterion::Limit(kind) => out.limits.set(kind, value),
            Criterion::Accuracy => out.accuracy = value,
            Criterion::Bore => out.cam.bore = value,
            Criterion::Inertia => out.machine.inertia = value,
            Criterion::BaseRadius => out.cam.base_radius = value,
            Criterion::GivenPrimeRadius => out.cam.prime_radius = value,
            _ => {}
        }
        out
    }

    /// Copy of the problem with other limits.
    #[must_use]
    pub fn with_limits(&self, limits: Limits) -> Problem {
        let mut out = self.clone();
        out.limits = limits;
        out
    }

    /// Copy of the problem with another specification of the law, that is, of its family, size, objective and conditions.
    #[must_use]
    pub fn with_law(&self, law: LawSpec) -> Problem {
        let mut out = self.clone();
        out.length = self.length().into();
        out.law = law;
        out
    }

    /// Copy of the problem with other dimensions of the cam.
    #[must_use]
    pub fn with_cam(&self, cam: CamSpec) -> Problem {
        let mut out = self.clone();
        out.cam = cam;
        out
    }

    /// Copy of the problem with another offset of the follower's line of motion, m.
    #[must_use]
    pub fn at_offset(&self, offset: f64) -> Problem {
        self.with_cam(CamSpec {
            offset: Some(offset),
            ..self.cam.clone()
        })
    }

    /// Copy of the problem with the mean force of its walkers as the only force. With several walkers, the force error of the mean is not
    /// limited.
    #[must_use]
    pub fn of_mean(&self) -> Problem {
        let mut out = self.clone();
        out.limits.unjudged.accuracy |= self.serves_several();
        out.walkers = None;
        out
    }

    /// Copy of the problem without the check of the force error.
    #[must_use]
    pub fn without_accuracy(&self) -> Problem {
        let mut out = self.clone();
        out.limits.unjudged.accuracy = true;
        out
    }

    /// Copy of the problem with another objective of the law.
    #[must_use]
    pub fn minimising(&self, objective: Minimise) -> Problem {
        let mut out = self.clone();
        out.law.minimise = Some(objective);
        out
    }

    /// Copy of the problem without limits, tolerance band and check of the force error. Target force and conditions on the law are
    /// unchanged.
    #[must_use]
    pub fn without_limits(&self) -> Problem {
        let mut out = self.clone();
        (out.limits, out.band) = (Limits::default(), None);
        out.without_accuracy()
    }

    /// Copy of the problem with another drive.
    #[must_use]
    pub fn with_drive(&self, drive: Drive) -> Problem {
        let mut out = self.clone();
        out.length = self.length().into();
        out.drive = drive;
        out
    }
}

//! Variants of a problem: each constructor returns a new one that differs in what its name says.

use super::Problem;
use crate::cam::{Criterion, LimitKind};
use crate::drive::Drive;
use crate::scene::{CamSpec, LawSpec, Limits, Minimise};

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
            Criterion::Inertia => self.machine.inertia,
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
            Criterion::Inertia => out.machine.inertia = value,
            Criterion::BaseRadius => out.cam.base_radius = value,
            Criterion::GivenPrimeRadius => out.cam.prime_radius = value,
            _ => {}
        }
        out
    }

    /// The same problem under other limits.
    #[must_use]
    pub fn with_limits(&self, limits: Limits) -> Problem {
        let mut out = self.clone();
        out.limits = limits;
        out
    }

    /// The same problem for a law of another family, size or objective.
    #[must_use]
    pub fn with_law(&self, law: LawSpec) -> Problem {
        let mut out = self.clone();
        out.length = self.length().into();
        out.law = law;
        out
    }

    /// The same problem for a cam of other lengths.
    #[must_use]
    pub fn with_cam(&self, cam: CamSpec) -> Problem {
        let mut out = self.clone();
        out.cam = cam;
        out
    }

    /// The same problem with the follower's line at an offset, m.
    #[must_use]
    pub fn at_offset(&self, offset: f64) -> Problem {
        self.with_cam(CamSpec {
            offset: Some(offset),
            ..self.cam.clone()
        })
    }

    /// The same for the mean of its walkers as for one force; of several walkers its error is not judged.
    #[must_use]
    pub fn of_mean(&self) -> Problem {
        let mut out = self.clone();
        out.limits.unjudged.accuracy |= self.serves_several();
        out.walkers = None;
        out
    }

    /// The same whose force error is not judged.
    #[must_use]
    pub fn without_accuracy(&self) -> Problem {
        let mut out = self.clone();
        out.limits.unjudged.accuracy = true;
        out
    }

    /// The same with another objective.
    #[must_use]
    pub fn minimising(&self, objective: Minimise) -> Problem {
        let mut out = self.clone();
        out.law.minimise = Some(objective);
        out
    }

    /// The same with its force and demands, but without a limit, an accuracy and a band.
    #[must_use]
    pub fn without_limits(&self) -> Problem {
        let mut out = self.clone();
        (out.limits, out.band) = (Limits::default(), None);
        out.without_accuracy()
    }

    /// The same problem on another drive.
    #[must_use]
    pub fn with_drive(&self, drive: Drive) -> Problem {
        let mut out = self.clone();
        out.length = self.length().into();
        out.drive = drive;
        out
    }
}

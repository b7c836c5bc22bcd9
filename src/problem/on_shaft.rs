//! Problem for a shaft with varying speed. The target is a function of the cam angle, and the speed variation adds a force.
//!
//! Symbols: F force, s, v and a lift and its first and second derivative with respect to the cam angle θ, k spring rate, c damping, m mass,
//! F₀ a constant force, ω(θ) shaft speed, ω′ = dω/dθ, Ω mean speed.
//!
//! The force is F = F₀ + k s + c ω v + m (ω² a + ω ω′ v). It equals the force at the mean speed Ω plus Δ = c (ω − Ω) v + m ((ω² − Ω²) a + ω
//! ω′ v). Δ is computed from the previous iterate, so the force remains linear in the law. Δ is subtracted from target, tolerance band and
//! limits of the force. Families, certificates and checks are the same as for constant speed (theory §10).

use std::f64::consts::TAU;
use std::sync::Arc;

use super::{Problem, Target};
use crate::drive::Drive;
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::{Extreme, PiecewisePoly};
use crate::scene::Minimise;

/// Difference between the phase within the period and the cam angle, rad, below which the speed counts as constant.
const EVEN: f64 = 1e-9;

/// Terms that are added by a varying speed or a moving floor, as functions of the cam angle.
#[derive(Debug, Clone)]
pub struct Extra {
    /// Added force Δ, N.
    pub force: PiecewisePoly,
    /// Terms that are added to the first, second and third time derivative of the lift, m/s, m/s² and m/s³ (rad instead of m for an arm).
    /// `None` if a term is zero or not required.
    pub timed: [Option<PiecewisePoly>; 3],
    /// Speed of the shaft as a function of the cam angle, rad/s; `None` if it is constant.
    pub speed: Option<PiecewisePoly>,
    /// Effect of the floor response on the objective; `None` if the floor is rigid or its motion is prescribed.
    pub through_floor: Option<ThroughFloor>,
}

/// Correction of the objective for a floor that responds to the law. The program uses the floor motion for the previous law. J is the
/// objective of a law on a floor that responds to this law.
///
/// P is the force of the law on a rigid floor, and Δ the added force. In the program, the force is P + Δ with fixed Δ, but the true force
/// is T P + const. The operator T multiplies harmonic n by the response Gₙ of the floor, which tends to G∞ for large n. The gradients of
/// program and J agree if the program minimises G∞ J + mean(h P) + constant. Here h = `(T − G∞)* π`, where `*` denotes the adjoint
/// operator. π is the derivative of the Lagrangian with respect to the force (theory §10).
#[derive(Debug, Clone)]
pub struct ThroughFloor {
    /// Objective of the program to which these terms belong.
    pub minimised: Minimise,
    /// Response G∞ of the force at high harmonics, as a fraction of the change of the force on a rigid floor.
    pub at_once: f64,
    /// Harmonics 1, 2, … of h as (cosine, sine), in units of the objective per N.
    pub slope: Vec<(f64, f64)>,
    /// Constant of the objective. With it, the objective of the program at the previous law equals the objective of this law on the moving
    /// floor.
    pub constant: f64,
}

impl ThroughFloor {
    /// Value of h at a cam angle, in units of the objective per N.
    pub fn slope_at(&self, theta: f64) -> f64 {
        let (sine, cosine) = libm::sincos(theta);
        let (mut sum, mut at) = (0.0, (1.0, 0.0));
        for (a, b) in &self.slope {
            at = (at.0 * cosine - at.1 * sine, at.1 * cosine + at.0 * sine);
            sum += a * at.0 + b * at.1;
        }
        sum
    }
}

impl Extra {
    /// Terms that consist only of an added force, N.
    pub fn of_force(force: PiecewisePoly) -> Extra {
        Extra {
            force,
            timed: [None, None, None],
            speed: None,
            through_floor: None,
        }
    }
}

/// Changes of a problem by a varying shaft speed or a moving floor.
#[derive(Debug, Clone)]
pub struct OnShaft {
    /// Terms that are added to force, velocity, acceleration and jerk.
    pub extra: Extra,
    /// Derivative dΔ/dθ of the added force, N/rad.
    pub force_rate: PiecewisePoly,
    /// Target as a function of the cam angle, N, without subtraction of the added force.
    pub target: ForceCurve,
    /// The original problem, at constant speed and on a rigid floor.
    pub even: Arc<Problem>,
}

impl Problem {
    /// Copy of the problem for a shaft with varying speed. `phases` are the phases within the period, rad, at equally spaced cam angles.
    /// `extra` contains the terms that speed and floor add.
    #[must_use]
    pub fn on_shaft(&self, phases: &[f64], extra: Extra) -> Problem {
        let step = TAU / phases.len() as f64;
        let added: Vec<f64> = (0..phases.len())
            .map(|i| extra.force.eval(step * i as f64))
            .collect();
        let at_cam = |target: &Target| -> Vec<f64> {
            let at = |phase: &f64| target.cells().at(phase.rem_euclid(TAU));
            phases.iter().map(at).collect()
        };
        let less = |curve: &ForceCurve, forces: &[f64]| {
            let forces = forces.iter().zip(&added);
            curve.with_forces(forces.map(|(f, x)| f - x).collect())
        };
        let mut out = self.clone();
        let target = self.target.as_ref().map(|t| (t.curve(), at_cam(t)));
        out.target = (target.as_ref()).map(|(curve, forces)| Target::new(less(curve, forces)));
        let is_even = |(i, phase): (usize, &f64)| (phase - step * i as f64).abs() < EVEN;
        let varies = !phases.iter().enumerate().all(is_even);
        let edge = |curve: &ForceCurve| less(curve, &at_cam(&Target::new(curve.clone())));
        out.band = self.band.as_ref().map(|edges| edges.each_ref().map(edge));
        out.phase_is_free = false;
        for weight in &mut out.weights {
            for edge in [&mut weight.from, &mut weight.to] {
                *edge = self.phase + angle_at(phases, *edge - self.phase);
            }
        }
        out.on_shaft = target.map(|(curve, forces)| {
            Arc::new(OnShaft {
                force_rate: extra.force.derivative(),
                extra,
                target: match varies {
                    true => curve.with_forces(forces),
                    false => (**curve).clone(),
                },
                even: Arc::new(self.clone()),
            })
        });
        out
    }

    /// Copy of the problem with another accuracy, relative to the mean force.
    #[must_use]
    pub fn with_accuracy(&self, accuracy: Option<f64>) -> Problem {
        let mut out = self.clone();
        out.accuracy = accuracy;
        if let Some(shaft) = &self.on_shaft {
            out.on_shaft = Some(Arc::new(OnShaft {
                even: Arc::new(shaft.even.with_accuracy(accuracy)),
                ..OnShaft::clone(shaft)
            }));
        }
        out
    }

    /// Correction of the objective for the response of the floor. `None` if the floor is rigid, its motion is prescribed, or the correction
    /// belongs to another objective.
    pub fn through_floor(&self) -> Option<&ThroughFloor> {
        let through = self.on_shaft.as_ref()?.extra.through_floor.as_ref()?;
        (through.minimised == self.objective()).then_some(through)
    }

    /// Force that the varying speed and the moving floor add at a cam angle, rad; result in N.
    pub fn extra_force(&self, theta: f64) -> f64 {
        let shaft = self.on_shaft.as_ref();
        shaft.map_or(0.0, |shaft| shaft.extra.force.eval(theta.rem_euclid(TAU)))
    }

    /// Learned force of the machine at a cam angle, rad. The result is in N, or in N·m for an arm.
    pub fn learned_force(&self, theta: f64) -> f64 {
        self.drive.lever * self.machine.learned_at(theta)
    }

    /// Target as a function of the cam angle, N, without subtraction of the added force.
    pub fn target_at_cam(&self) -> Option<&ForceCurve> {
        let shaft = self.on_shaft.as_ref().map(|shaft| &shaft.target);
        shaft.or(self.target.as_ref().map(|target| &**target.curve()))
    }

    /// Target as a function of the phase within the period, N.
    pub fn target_in_time(&self) -> Option<&ForceCurve> {
        let target = self.at_constant_speed().target.as_ref();
        target.map(|target| &**target.curve())
    }

    /// Lower and upper edge of the tolerance band of the force over the period, N; `None` without a band.
    pub fn band_in_time(&self) -> Option<&[ForceCurve; 2]> {
        self.at_constant_speed().band.as_ref()
    }

    /// The original problem, at constant speed and on a rigid floor, before the motion of the machine is computed.
    pub fn at_constant_speed(&self) -> &Problem {
        self.on_shaft.as_ref().map_or(self, |shaft| &shaft.even)
    }

    /// Copy of the problem with another drive and another target over the period. The terms added by speed and floor are unchanged.
    #[must_use]
    pub fn against(&self, drive: Drive, target: Option<ForceCurve>) -> Problem {
        let mut out = self.with_drive(drive);
        let curve = target.map(Arc::new);
        out.on_shaft = self
            .on_shaft
            .as_ref()
            .zip(curve.clone())
            .map(|(shaft, curve)| {
                Arc::new(OnShaft {
                    target: (*curve).clone(),
                    even: Arc::new(shaft.even.against(drive, Some((*curve).clone()))),
                    ..OnShaft::clone(shaft)
                })
            });
        out.target = curve.map(Target::new);
        out
    }

    /// Force of a law over the turn, N, as a piecewise polynomial with exact extremes.
    pub fn force_curve(&self, law: &Law) -> PiecewisePoly {
        let own = self.drive.force_curve(law);
        match &self.on_shaft {
            None => own,
            Some(shaft) => sum(&own, &shaft.extra.force),
        }
    }

    /// Minimum and maximum force of a law, N.
    pub fn force_extremes(&self, law: &Law) -> (Extreme, Extreme) {
        match &self.on_shaft {
            None => self.drive.force_extremes(law),
            Some(_) => self.force_curve(law).extremes(),
        }
    }
}

/// Product of two piecewise polynomials. The breaks of the polynomials can differ.
pub fn product(own: &PiecewisePoly, other: &PiecewisePoly) -> PiecewisePoly {
    let other = other.cut_at(own.breaks());
    own.cut_at(other.breaks()).times(&other)
}

/// Sum of two piecewise polynomials. The breaks of the polynomials can differ.
pub fn sum(own: &PiecewisePoly, extra: &PiecewisePoly) -> PiecewisePoly {
    let extra = extra.cut_at(own.breaks());
    let own = own.cut_at(extra.breaks());
    PiecewisePoly::combine(&[(1.0, &own), (1.0, &extra)], 0.0)
}

/// Cam angle, rad, at a phase within the period, rad, by linear interpolation. `phases` contains the phases at equally spaced cam angles.
/// Angle and phase are zero at the start of the period.
fn angle_at(phases: &[f64], phase: f64) -> f64 {
    let (turns, part) = ((phase / TAU).floor(), phase.rem_euclid(TAU));
    let (n, first) = (phases.len(), phases[0]);
    let place = |i: usize| if i < n { phases[i] - first } else { TAU };
    let i = (1..n).find(|i| place(*i) > part).unwrap_or(n);
    let (a, b) = (place(i - 1), place(i));
    TAU * (turns + ((i - 1) as f64 + (part - a) / (b - a)) / n as f64)
}

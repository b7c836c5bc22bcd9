//! A compliant follower: the cam moves the mass through a spring and a damper, or through a column of fluid.
//!
//! The deflection x is the motion of the mass relative to the rigid lift s. The mass m is on a train of stiffness k₁ and damping c₁, in a
//! machine of stiffness k and damping c. With the rigid force F(θ), the deflection obeys m ẍ + (c + c₁) ẋ + (k + k₁) x = −F(θ). The contact
//! force is N = −(k₁ x + c₁ ẋ). The input is the piecewise polynomial of the law, so each span has a closed form ([`Linear`]). Steps of
//! velocity or lift in the law cause steps of the state.

mod linear;
pub(crate) mod polydyne;
mod rest;
mod train;

pub use linear::Linear;
pub(crate) use rest::in_rests;
pub use train::Train;

use crate::drive::{Drive, DriveKind};
use crate::error::{DynamicsError, Error, Result};
use crate::law::{Joint, Law};
use crate::poly::{Extreme, PiecewisePoly};
pub(crate) use nalgebra::{Matrix2, Vector2};

/// Steady motion of a flexible machine, at angles that include the breaks of the input.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::flexible::{Train, steady};
/// use gaitcam::law::Law;
///
/// // The natural frequency is 100.5 times the shaft speed, so the follower deflects by nearly force/stiffness.
/// let drive = Drive::moving_axis(10.0, 9.81, 10.0);
/// let train = Train { stiffness: 10.0 * 1005.0_f64.powi(2), damping: 0.0 };
/// let run = steady(&Law::harmonic(0.01, &[(0.0, 0.01)]), &drive, &train)?;
/// let (low, high) = run.contact_extremes();
/// assert!((low.value - 88.1).abs() < 0.1 && (high.value - 108.1).abs() < 0.1);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Steady {
    /// Cam angles, rad; the last is one period after the first.
    pub theta: Vec<f64>,
    /// Deflection: motion of the mass relative to the rigid lift, m.
    pub deflection: Vec<f64>,
    /// Force between cam and follower, N.
    pub contact: Vec<f64>,
    /// Derivative of the contact force with respect to the cam angle, N/rad.
    pub contact_rate: Vec<f64>,
    /// Output force of the machine, N: the contact force, or the piston force of a hydraulic drive.
    pub output: Vec<f64>,
}

/// Linear system of a train, its polynomial input and the conversion to forces.
struct Model {
    linear: Linear,
    /// Force of a rigid follower as a piecewise polynomial, N.
    force: PiecewisePoly,
    /// Weights w of the contact force Σ wᵢ zᵢ, N. The states z are the deflection x and x′/scale, with scale = √((k + k₁)/(mω²)).
    contact: Vector2<f64>,
    scale: f64,
}

fn model(law: &Law, drive: &Drive, train: &Train) -> Model {
    let w = drive.speed;
    let force = drive.force_curve(law);
    let Train { stiffness, damping } = *train;
    if drive.mass <= 0.0 {
        // Without mass the state is x alone: (c + c₁) ω x′ = −(k + k₁) x − F.
        let drag = (drive.damping + damping) * w;
        let fade = -(drive.spring_rate + stiffness) / drag;
        return Model {
            linear: Linear {
                rates: Matrix2::new(fade, 0.0, 0.0, -1.0),
                input: Vector2::new(-1.0 / drag, 0.0),
            },
            force,
            contact: Vector2::new(-stiffness, 0.0),
            scale: 0.0,
        };
    }
    let inertia = drive.mass * w * w;
    let rate = (drive.spring_rate + stiffness) / inertia;
    let scale = rate.sqrt();
    let fade = -(drive.damping + damping) * w / inertia;
    Model {
        linear: Linear {
            rates: Matrix2::new(0.0, scale, -scale, fade),
            input: Vector2::new(0.0, -1.0 / (inertia * scale)),
        },
        force,
        contact: Vector2::new(-stiffness, -damping * w * scale),
        scale,
    }
}

/// Periodic steady state with a closed law, exact at the returned angles.
///
/// The speed of the drive must be positive. For a cam that turns clockwise, use the mirrored law.
///
/// # Errors
///
/// Invalid stiffness or mass; an undamped resonance, which has no steady state.
pub fn steady(law: &Law, drive: &Drive, train: &Train) -> Result<Steady> {
    Ok(match periodic(law, drive, train, &[])? {
        Some((model, states)) => read(law, drive, train, &model, &states),
        None => quasi_static(law, drive, train),
    })
}

/// Distance below which two breaks count as one, rad.
const SAME: f64 = 1e-9;

/// Model whose input has additional breaks at `cuts`, rad, and its periodic states at all breaks. `None` if the response is quasi-static.
fn periodic(
    law: &Law,
    drive: &Drive,
    train: &Train,
    cuts: &[f64],
) -> Result<Option<(Model, Vec<Vector2<f64>>)>> {
    train.check()?;
    let still = drive.mass <= 0.0 && drive.damping + train.damping <= 0.0;
    if still || drive.speed <= f64::MIN_POSITIVE {
        return Ok(None);
    }
    let mut model = model(law, drive, train);
    let breaks = model.force.breaks();
    let is_new = |cut: &f64| !breaks.iter().any(|b| (b - cut).abs() < SAME);
    let cuts: Vec<f64> = cuts.iter().copied().filter(is_new).collect();
    model.force = model.force.cut_at(&cuts);
    if model.linear.rates.norm() * widest(&model.force) > linear::STIFFEST {
        return Ok(None);
    }
    let kicks = kicks(law, &model);
    let kick = |piece: usize| {
        let own = kicks.iter().find(|k| k.0 == piece);
        own.map_or_else(Vector2::zeros, |k| k.1)
    };
    let states = model.linear.periodic(&model.force, kick);
    let states = states.ok_or_else(|| resonance(drive, train))?;
    Ok(Some((model, states)))
}

/// Fraction of the maximum lift below which a step of lift or velocity counts as a rounding error.
const ROUNDING: f64 = 1e-12;

/// Steps of the relative state (x, x′/scale) at the jumps of lift and velocity of the law. Each step is given with the index of the input
/// span that begins there. The mass does not follow a step of the lift, so x and x′ change by minus the step.
fn kicks(law: &Law, model: &Model) -> Vec<(usize, Vector2<f64>)> {
    let breaks = model.force.breaks();
    let size = ROUNDING * law.bound(0);
    let stepped = |j: &Joint| j.jump.v.abs() > size || j.jump.s.abs() > size;
    (law.joints().into_iter())
        .filter(stepped)
        .filter_map(|j| {
            let piece = breaks.iter().position(|b| (b - j.at).abs() < 1e-12)?;
            let v = if model.scale > 0.0 {
                -j.jump.v / model.scale
            } else {
                0.0
            };
            Some((piece, Vector2::new(-j.jump.s, v)))
        })
        .collect()
}

fn widest(p: &PiecewisePoly) -> f64 {
    p.breaks()
        .windows(2)
        .map(|w| w[1] - w[0])
        .fold(0.0, f64::max)
}

fn resonance(drive: &Drive, train: &Train) -> Error {
    let natural = train.natural_frequency(drive).unwrap_or(f64::NAN);
    DynamicsError::Resonance {
        cycles: natural / drive.speed,
    }
    .into()
}

/// Quasi-static solution: the train and the spring of the machine share the rigid force in proportion to their stiffness.
fn quasi_static(law: &Law, drive: &Drive, train: &Train) -> Steady {
    let force = drive.force_curve(law);
    let give = 1.0 / (train.stiffness + drive.spring_rate);
    let carried = 1.0 - drive.spring_rate * give;
    let rate = force.derivative();
    let theta = force.breaks().to_vec();
    let contact: Vec<f64> = breaks_of(&force).map(|f| f * carried).collect();
    Steady {
        theta,
        deflection: breaks_of(&force).map(|f| -f * give).collect(),
        contact_rate: breaks_of(&rate).map(|r| r * carried).collect(),
        output: contact.clone(),
        contact,
    }
}

/// Values of a piecewise polynomial at its breaks. They are limits from the right, except the last value, which is the limit from the left.
fn breaks_of(p: &PiecewisePoly) -> impl Iterator<Item = f64> + '_ {
    let last = p.pieces() - 1;
    (0..=last)
        .map(|i| p.piece(i)[0])
        .chain(std::iter::once(p.piece(last)[p.degree()]))
}

fn read(law: &Law, drive: &Drive, train: &Train, model: &Model, states: &[Vector2<f64>]) -> Steady {
    let theta = model.force.breaks().to_vec();
    let rates = &model.linear.rates;
    let forces: Vec<f64> = breaks_of(&model.force).collect();
    let mut out = Steady {
        deflection: states.iter().map(|z| z[0]).collect(),
        contact: Vec::with_capacity(states.len()),
        contact_rate: Vec::with_capacity(states.len()),
        output: Vec::new(),
        theta,
    };
    // Without mass, x′ is not a state. The damper force c₁ ω x′ is computed from the derivative of x.
    let extra = if drive.mass <= 0.0 {
        train.damping * drive.speed
    } else {
        0.0
    };
    for (i, z) in states.iter().enumerate() {
        let dz = rates * z + model.linear.input * forces[i];
        out.contact.push(model.contact.dot(z) - extra * dz[0]);
        out.contact_rate.push(model.contact.dot(&dz));
    }
    out.output = match drive.kind {
        DriveKind::Hydraulic => {
            let (start, length) = law.extent();
            out.theta
                .iter()
                .zip(states)
                .map(|(t, z)| {
                    let at = law.svaj(t.min(start + length));
                    drive.rest_force + drive.spring_rate * (at.s + z[0])
                })
                .collect()
        }
        DriveKind::MovingAxis | DriveKind::FixedAxis => out.contact.clone(),
    };
    out
}

impl Steady {
    /// Minimum and maximum contact force, N: extremes of the cubic polynomials through the exact values and slopes.
    pub fn contact_extremes(&self) -> (Extreme, Extreme) {
        let mut coef = Vec::with_capacity(4 * self.theta.len());
        for i in 0..self.theta.len() - 1 {
            let third = (self.theta[i + 1] - self.theta[i]) / 3.0;
            coef.extend([
                self.contact[i],
                self.contact[i] + third * self.contact_rate[i],
                self.contact[i + 1] - third * self.contact_rate[i + 1],
                self.contact[i + 1],
            ]);
        }
        PiecewisePoly::new(self.theta.clone(), 3, coef).extremes()
    }
}

#[cfg(test)]
mod tests;

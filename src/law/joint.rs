//! Joints between the spans of a law. The fundamental law of cam design requires that the lift is twice continuously differentiable (C²).

use super::svaj::Svaj;

/// Jumps of the law at one break. A jump is the value after the break minus the value before it.
///
/// ```
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// // A parabolic rise of h over β has a = ±4h/β²: at its middle a falls by 8h/β².
/// let (h, pi) = (0.02, std::f64::consts::PI);
/// let segment = |lift| Segment { motion: Rise::Parabolic, lift, angle: pi };
/// let law = program(&[segment(h), segment(-h)], Extent::TURN)?;
/// let middle = law.joints().into_iter().find(|j| (j.at - 0.5 * pi).abs() < 1e-9).unwrap();
/// assert!((middle.jump.a + 8.0 * h / (pi * pi)).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// Angle of the break, rad.
    pub at: f64,
    /// Lift and derivatives before and after the break.
    pub sides: [Svaj; 2],
    /// Jumps of s, v, a, j at the break.
    pub jump: Svaj,
}

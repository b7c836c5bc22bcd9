//! Segments of a programme, the extent of a programme, and its law before the checks.

use std::f64::consts::TAU;

use crate::error::SegmentName;
use crate::law::{Law, Rise};

/// Segment of a programme: a motion with its lift and its length.
///
/// ```
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// let up = Segment { motion: Rise::Poly345, lift: 0.02, angle: 2.0 };
/// let down = Segment { motion: Rise::Poly345, lift: -0.02, angle: std::f64::consts::TAU - 2.0 };
/// let law = program(&[up, down], Extent::TURN)?;
/// assert!((law.svaj(1.0).s - 0.01).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// Motion of the catalogue that determines the shape of the lift curve.
    pub motion: Rise,
    /// Change of lift, m (rad for an oscillating follower): positive for a rise, negative for a fall, 0 for a dwell.
    pub lift: f64,
    /// Length of the segment: rad of cam angle, or m of travel for a translating cam.
    pub angle: f64,
}

/// Extent of a programme: a number of turns, or a length of travel.
///
/// ```
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// // A slide of 80 mm: the law ends where it ends.
/// let segment = |lift| Segment { motion: Rise::Cycloidal, lift, angle: 0.04 };
/// let law = program(&[segment(0.01), segment(-0.01)], Extent::Length(0.08))?;
/// assert!(!law.is_closed());
/// assert_eq!(law.extent(), (0.0, 0.08));
/// assert_eq!(Extent::TURN, Extent::Turns(1));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// A number of whole turns; more than one only for a barrel cam. The law is periodic, and the extent is its period.
    Turns(usize),
    /// Length of the travel of a translating cam, m. The law is open.
    Length(f64),
}

impl Extent {
    /// Extent of one turn.
    pub const TURN: Extent = Extent::Turns(1);

    pub(super) fn length(self) -> f64 {
        match self {
            Extent::Turns(n) => TAU * n as f64,
            Extent::Length(l) => l,
        }
    }

    pub(super) fn is_closed(self) -> bool {
        !matches!(self, Extent::Length(_))
    }
}

/// Maximum relative difference between the sum of the segment lengths and the extent. Rounded degrees cause such differences, for example. All
/// lengths are then scaled to the extent.
pub(super) const ROUNDING: f64 = 1e-6;
/// Jump of a derivative, relative to the maximum of the derivative, below which it counts as a rounding error.
pub(super) const JUMP: f64 = 1e-9;

/// Law of a programme, with the angle at which each segment ends.
pub(super) struct Draft {
    pub(super) law: Law,
    pub(super) ends: Vec<f64>,
}

impl Draft {
    /// Number (from 1) of the segment that starts at an angle.
    pub(super) fn starting(&self, at: f64) -> Option<usize> {
        let near = |x: f64| (x - at).abs() <= 1e-9;
        if near(0.0) {
            return Some(1);
        }
        self.ends.iter().position(|&e| near(e)).map(|i| i + 2)
    }

    /// Number (from 1) of the segment that contains an angle.
    pub(super) fn holding(&self, at: f64) -> usize {
        self.ends
            .partition_point(|&e| e < at - 1e-9)
            .min(self.ends.len() - 1)
            + 1
    }
}

/// Name of a segment in an error message: its number and motion.
pub(super) fn name(segments: &[Segment], i: usize) -> SegmentName {
    SegmentName::Segment {
        number: i + 1,
        motion: segments[i].motion.name().to_string(),
    }
}

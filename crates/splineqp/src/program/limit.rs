//! Linear limits on the law over a range of angles.

use super::variable::{PEAK, Values, Variable};
use crate::Names;
use std::ops::Neg;

/// A derivative of the law of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Derivative {
    /// Zeroth derivative: the law itself.
    Value,
    /// First derivative of the law.
    First,
    /// Second derivative of the law.
    Second,
    /// Third derivative of the law.
    Third,
    /// Fourth derivative of the law.
    Fourth,
}

impl Derivative {
    /// Weights of this derivative alone, indexed by the order of the derivative.
    pub fn weights(self) -> [f64; 5] {
        LeftSide::from(self).weights()
    }
}

/// A linear combination of the law and its derivatives.
///
/// ```
/// use splineqp::{Derivative, LeftSide};
///
/// // s″ + 4 s
/// let side = LeftSide::from([(Derivative::Second, 1.0), (Derivative::Value, 4.0)]);
/// assert_eq!(side.weights(), [4.0, 0.0, 1.0, 0.0, 0.0]);
/// assert_eq!(-LeftSide::from(Derivative::First), [0.0, -1.0, 0.0, 0.0, 0.0].into());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftSide([f64; 5]);

impl LeftSide {
    /// Weights of the law and its derivatives, indexed by their order.
    pub fn weights(self) -> [f64; 5] {
        self.0
    }
}

impl From<Derivative> for LeftSide {
    fn from(derivative: Derivative) -> Self {
        LeftSide::from([(derivative, 1.0)])
    }
}

impl<const K: usize> From<[(Derivative, f64); K]> for LeftSide {
    fn from(terms: [(Derivative, f64); K]) -> Self {
        let mut weights = [0.0; 5];
        for (derivative, weight) in terms {
            weights[derivative as usize] += weight;
        }
        LeftSide(weights)
    }
}

impl From<[f64; 5]> for LeftSide {
    /// Left side with the given weights, indexed by the order of the derivative.
    fn from(weights: [f64; 5]) -> Self {
        LeftSide(weights)
    }
}

impl Neg for LeftSide {
    type Output = LeftSide;
    fn neg(self) -> LeftSide {
        LeftSide(self.0.map(|w| -w))
    }
}

/// A linear limit on the law, for all angles or for a range of angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit<N: Names> {
    /// Name of the limit for users. The two sides of a two-sided limit have the same name.
    pub name: N::Limit,
    /// Weights of the law and its derivatives, indexed by their order.
    pub weights: [f64; 5],
    /// Bound of the limit: Σ weights·s⁽ᵏ⁾ + Σ extra·y ≤ bound + shape(θ).
    pub bound: f64,
    /// Weights of the further variables y in the left side.
    pub extra: Values,
    /// Index of the part of the bound that varies with θ, in the shapes of the program; `None` for a constant bound.
    pub shape: Option<usize>,
    /// Whether the law is measured from its value at the reference angle of the program.
    pub from_reference: bool,
    /// First and last angle at which the limit applies, rad.
    pub domain: (f64, f64),
    /// Scale of a violation. The default is |bound|, or 1 if the bound is 0.
    pub scale: f64,
    /// Whether a solver may tighten the limit by a margin. It must be false if the law may have to equal its bound over a whole range.
    pub has_room: bool,
    /// Whether the limit is one end of a range of values whose position is free.
    pub is_window: bool,
    /// Meaning of the bound for the caller, such as the quantity from which the caller computes the bound.
    pub meaning: N::Meaning,
}

/// Left side of a limit, without its bound.
#[derive(Debug, Clone, Copy)]
pub struct Limited<N: Names> {
    name: N::Limit,
    side: LeftSide,
}

impl<N: Names> Limited<N> {
    /// Limits the left side to at most `bound`. The scale of a violation is |bound|, or 1 if the bound is 0.
    pub fn at_most(self, bound: f64) -> Limit<N> {
        Limit {
            name: self.name,
            weights: self.side.0,
            bound,
            extra: Values::NONE,
            shape: None,
            from_reference: false,
            domain: (f64::MIN, f64::MAX),
            scale: if bound == 0.0 { 1.0 } else { bound.abs() },
            has_room: true,
            is_window: false,
            meaning: N::Meaning::default(),
        }
    }

    /// Limits the left side to at least `bound`. The scale of a violation is |bound|, or 1 if the bound is 0.
    pub fn at_least(self, bound: f64) -> Limit<N> {
        let side = -self.side;
        Limited { side, ..self }.at_most(-bound)
    }

    /// Limits the left side to a range of the given width, which begins at the value of a variable.
    pub fn within(self, width: f64, from: Variable) -> [Limit<N>; 2] {
        let (mut top, mut bottom) = (self.at_most(width), self.at_least(0.0).scaled(width));
        (top.extra[from], bottom.extra[from]) = (-1.0, 1.0);
        (top.is_window, bottom.is_window) = (true, true);
        [top, bottom]
    }
}

impl<N: Names> Limit<N> {
    /// Left side of a limit on a derivative or on a combination of derivatives.
    ///
    /// ```
    /// use splineqp::{Derivative, Limit};
    ///
    /// let limit: Limit<()> = Limit::on("acceleration", Derivative::Second).at_most(0.7);
    /// assert_eq!((limit.weights[2], limit.bound, limit.scale), (1.0, 0.7, 0.7));
    /// let limit: Limit<()> = Limit::on("acceleration", Derivative::Second).at_least(-0.7);
    /// assert_eq!((limit.weights[2], limit.bound), (-1.0, 0.7));
    /// ```
    pub fn on(name: impl Into<N::Limit>, side: impl Into<LeftSide>) -> Limited<N> {
        Limited {
            name: name.into(),
            side: side.into(),
        }
    }

    /// The limit with another scale for violations.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        self.scale = scale;
        self
    }

    /// The limit without permission to tighten it by a margin.
    #[must_use]
    pub fn exact(mut self) -> Self {
        self.has_room = false;
        self
    }

    /// The limit with the peak variable in place of its constant bound. The shape is unchanged.
    #[must_use]
    pub fn minimised(mut self) -> Self {
        self.bound = 0.0;
        self.extra[PEAK] = -1.0;
        self
    }

    /// Scale of an excess for the given bound `room`. It is the larger of `scale` and |`room`|. For a range of values with free position,
    /// it is `scale`, which is the width of the range.
    pub fn size(&self, room: f64) -> f64 {
        if self.is_window {
            self.scale
        } else {
            self.scale.max(room.abs())
        }
    }

    /// Order of the highest derivative in the left side.
    pub fn highest_order(&self) -> usize {
        self.weights.iter().rposition(|w| *w != 0.0).unwrap_or(0)
    }

    /// Whether the limit applies at an angle, rad.
    pub(crate) fn covers(&self, at: f64) -> bool {
        at >= self.domain.0 && at <= self.domain.1
    }

    /// The limit with an empty domain, so that it has no effect.
    pub(crate) fn idle(mut self) -> Self {
        self.extra = Values::NONE;
        self.is_window = false;
        self.domain = (f64::INFINITY, f64::INFINITY);
        self
    }

    /// Whether the domain of the limit is empty, so that it has no effect.
    pub(crate) fn is_idle(&self) -> bool {
        self.domain.0 == f64::INFINITY
    }

    /// Whether the limit contains only further variables.
    pub fn is_on_variables_alone(&self) -> bool {
        self.weights == [0.0; 5] && !self.extra.is_none()
    }

    /// Whether the bound of the limit contains the minimised peak.
    pub fn is_peak(&self) -> bool {
        self.extra[PEAK] != 0.0
    }

    /// Bound of the limit minus the terms of the further variables, for their values `extra`.
    pub fn room(&self, extra: &Values) -> f64 {
        self.bound - self.extra.dot(extra)
    }
}

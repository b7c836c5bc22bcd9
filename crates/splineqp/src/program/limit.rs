//! A linear limit on the law over a range of cam angles, and what its bound means to users.

use crate::Names;
use crate::basis::only;

/// Further variables (a peak, sizes, ends of ranges), by their index in `extra` arrays.
pub const EXTRAS: usize = 6;
/// A bound that is itself minimised: a peak objective, an elastic limit.
pub const PEAK: usize = 0;
/// Base radius of a flat-faced cam, prime radius Rp of a roller cam, m.
pub const RADIUS: usize = 1;
/// Height D of the roller centre above the cam centre at s = 0, m.
pub const RISE: usize = 2;
/// Offset e of the follower, m.
pub const OFFSET: usize = 3;
/// Lowest lift, m, where a stroke counts from there and not from the base circle.
pub const LOWEST: usize = 4;
/// Smallest velocity, m/rad: where a flat face of limited width begins.
pub const FACE_END: usize = 5;
/// Variables of the cam's size, which a cone ties together.
pub const SIZES: [usize; 3] = [RADIUS, RISE, OFFSET];

/// A linear limit on the law over a range of cam angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit<N: Names> {
    /// Name as users know it; both signs of a two-sided limit share it.
    pub name: N::Limit,
    /// Weights of s, v, a, j and the fourth derivative, by cam angle.
    pub weights: [f64; 5],
    /// Σ weights·svaj + Σ extra·y ≤ bound + shape(θ).
    pub bound: f64,
    /// Weights of the further variables.
    pub extra: [f64; EXTRAS],
    /// Index into the program's shapes of the part of the bound that varies with θ.
    pub shape: Option<usize>,
    /// The lift counts from the base circle, which the law touches at the program's `touching`.
    pub from_base_circle: bool,
    /// First and last cam angle at which it holds, rad.
    pub domain: (f64, f64),
    /// Size against which a violation counts: |bound| unless that is 0.
    pub scale: f64,
    /// What a change of the bound means to the user.
    pub meaning: Meaning,
}

impl<N: Names> Limit<N> {
    /// Σ weights·svaj ≤ bound over one turn.
    pub fn new(name: impl Into<N::Limit>, weights: [f64; 5], bound: f64, scale: f64) -> Self {
        Limit {
            name: name.into(),
            weights,
            bound,
            extra: [0.0; EXTRAS],
            shape: None,
            from_base_circle: false,
            domain: (0.0, std::f64::consts::TAU),
            scale,
            meaning: Meaning::Structure,
        }
    }

    /// The same, a violation counted as a part of the bound, or of `typical` where that is 0.
    pub fn relative(
        name: impl Into<N::Limit>,
        weights: [f64; 5],
        bound: f64,
        typical: f64,
    ) -> Self {
        let scale = if bound == 0.0 { typical } else { bound.abs() };
        Limit::new(name, weights, bound, scale)
    }

    /// A derivative within a range of the given width, from 0 on or from where a variable says.
    pub fn range(
        name: impl Into<N::Limit>,
        order: usize,
        width: f64,
        typical: f64,
        window: Option<usize>,
    ) -> Vec<Self> {
        let name = name.into();
        let mut top = Limit::relative(name, only(order, 1.0), width, typical);
        top.meaning = Meaning::times(1.0);
        let Some(variable) = window else {
            return vec![top];
        };
        top.extra[variable] = -1.0;
        let mut bottom = Limit::new(name, only(order, -1.0), 0.0, width);
        bottom.extra[variable] = 1.0;
        vec![top, bottom]
    }

    /// The same limit whose bound users read so.
    #[must_use]
    pub fn read_as(mut self, meaning: Meaning) -> Self {
        self.meaning = meaning;
        self
    }

    /// The same limit with its bound (beyond the shape) replaced by the peak variable.
    #[must_use]
    pub fn minimised(mut self) -> Self {
        self.bound = 0.0;
        self.extra[PEAK] = -1.0;
        self
    }

    /// Size against which an excess over the given room counts: a range is no longer for starting far off.
    pub fn size(&self, room: f64) -> f64 {
        if self.is_window() {
            self.scale
        } else {
            self.scale.max(room.abs())
        }
    }

    /// Whether it holds one end of a range of values whose place is free: a stroke, a face.
    pub fn is_window(&self) -> bool {
        self.extra[LOWEST] != 0.0 || self.extra[FACE_END] != 0.0
    }

    /// Highest derivative in its left side.
    pub fn highest_order(&self) -> usize {
        self.weights.iter().rposition(|w| *w != 0.0).unwrap_or(0)
    }

    /// Whether it holds at an angle, rad.
    pub(crate) fn covers(&self, at: f64) -> bool {
        at >= self.domain.0 && at <= self.domain.1
    }

    /// The same limit with an empty domain.
    pub(crate) fn idle(mut self) -> Self {
        self.extra = [0.0; EXTRAS];
        self.domain = (f64::INFINITY, f64::INFINITY);
        self
    }

    /// Whether it limits nothing.
    pub(crate) fn is_idle(&self) -> bool {
        self.domain.0 == f64::INFINITY
    }

    /// Whether it contains further variables only.
    pub fn is_on_size_alone(&self) -> bool {
        self.weights == [0.0; 5] && self.extra != [0.0; EXTRAS]
    }

    /// Whether its bound is minimised.
    pub fn is_peak(&self) -> bool {
        self.extra[PEAK] != 0.0
    }

    /// The bound less the terms of the further variables.
    pub(crate) fn room(&self, extra: &[f64; EXTRAS]) -> f64 {
        self.bound - (0..EXTRAS).map(|k| self.extra[k] * extra[k]).sum::<f64>()
    }
}

/// How a bound is read by users.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Meaning {
    /// Not a number of the scene: the base circle, a monotone flank, the objective.
    Structure,
    /// The scene's value is factor·bound + offset.
    Value {
        /// Factor.
        factor: f64,
        /// Offset.
        offset: f64,
    },
    /// A limit on a size that is itself a variable: nothing to relax.
    Sized,
    /// A pressure-angle limit on a given prime circle: bound = tan·D ± e, read as the prime radius.
    PrimeRadius {
        /// Tangent of the angle allowed.
        tan: f64,
        /// Offset of the follower with its sign in the bound, m.
        offset: f64,
    },
}

impl Meaning {
    /// The user's value is the bound times a factor.
    pub fn times(factor: f64) -> Meaning {
        Meaning::Value {
            factor,
            offset: 0.0,
        }
    }

    /// The user's value for a bound; `None` where there is none.
    pub fn value(self, bound: f64) -> Option<f64> {
        match self {
            Meaning::Structure | Meaning::Sized => None,
            Meaning::Value { factor, offset } => Some(factor * bound + offset),
            Meaning::PrimeRadius { tan, offset } => Some(((bound - offset) / tan).hypot(offset)),
        }
    }

    /// |d value / d bound|, for multipliers.
    pub fn slope(self, bound: f64) -> f64 {
        match self {
            Meaning::Structure | Meaning::Sized => 1.0,
            Meaning::Value { factor, .. } => factor.abs(),
            Meaning::PrimeRadius { tan, offset } => {
                let rise = (bound - offset) / tan;
                (rise / rise.hypot(offset)).abs() / tan
            }
        }
    }
}

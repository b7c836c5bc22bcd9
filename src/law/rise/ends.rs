//! Peaks of a rise, and its continuity with neighbouring segments.

use super::Rise;
use crate::error::Result;
use crate::law::Svaj;
use crate::wording::{self, Language};

impl Rise {
    /// Exact peak factors of a rise.
    ///
    /// # Errors
    ///
    /// Parameters are out of range.
    pub fn factors(&self) -> Result<Factors> {
        let law = self.law()?;
        let order = |k: usize| {
            let (low, high) = law.extremes(k);
            (low.value, high.value)
        };
        let (v, a, j) = (order(1), order(2), order(3));
        let largest = |p: (f64, f64)| p.0.abs().max(p.1.abs());
        let power = law
            .combination([0.0, 1.0, 0.0, 0.0], 0.0)
            .times(&law.combination([0.0, 0.0, 1.0, 0.0], 0.0))
            .extremes();
        let jumps = law.joints().iter().any(|joint| joint.jump.a.abs() > REST);
        Ok(Factors {
            cv: largest(v),
            ca: largest(a),
            cj: if jumps { f64::INFINITY } else { largest(j) },
            ct: largest((power.0.value, power.1.value)),
            v,
            a,
            j,
        })
    }

    /// Motion at both ends of the normalised rise. It determines the possible neighbours.
    ///
    /// # Errors
    ///
    /// Parameters are out of range.
    pub fn ends(&self) -> Result<Ends> {
        let law = self.law()?;
        let [start, end] = [(0, 0.0), (law.poly().pieces() - 1, 1.0)].map(|(piece, u)| End {
            at: law.svaj_on(piece, u),
        });
        Ok(Ends { start, end })
    }
}

/// Motion at one end of a normalised rise.
///
/// ```
/// use gaitcam::law::Rise;
///
/// // A parabolic rise meets a dwell in velocity, not in acceleration.
/// let start = Rise::Parabolic.ends()?.start;
/// assert!((start.at.a - 4.0).abs() < 1e-12);
/// assert_eq!(start.continuity_with_dwell(), 1);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End {
    /// Derivatives v, a and j at the end; s is 0 or 1.
    pub at: Svaj,
}

/// Motion at both ends of a normalised rise.
///
/// ```
/// use gaitcam::law::Rise;
///
/// // The quarter harmonic leaves with v = π/2.
/// let ends = Rise::SemiharmonicStart.ends()?;
/// assert!(ends.start.at.v.abs() < 1e-12);
/// assert!((ends.end.at.v - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ends {
    /// Motion at x = 0.
    pub start: End,
    /// Motion at x = 1.
    pub end: End,
}

/// Value of a derivative at an end below which the end is at rest.
const REST: f64 = 1e-9;

impl End {
    /// Order of the highest derivative that is continuous with a dwell at this end: 0 = only lift … 3 = jerk.
    pub fn continuity_with_dwell(&self) -> usize {
        [self.at.v, self.at.a, self.at.j]
            .iter()
            .position(|x| x.abs() > REST)
            .unwrap_or(3)
    }

    /// Kinds of neighbours at an end: at rest without and with acceleration, in motion without and with acceleration.
    pub const JOINS: [&'static str; 4] = [
        "dwell",
        "return of equal acceleration",
        "constant velocity",
        "nothing but a general polynomial",
    ];

    /// Kind of neighbour at this end for which v and a are continuous.
    pub fn joins(&self) -> &'static str {
        End::JOINS[self.kind()]
    }

    /// Letter of the end in VDI 2143: R rest, U reversal, G constant velocity, B motion.
    ///
    /// ```
    /// use gaitcam::law::Rise;
    ///
    /// let ends = Rise::SemicycloidalStart.ends()?;
    /// assert_eq!([ends.start.vdi(), ends.end.vdi()], ["R", "G"]);
    /// # Ok::<(), gaitcam::error::Error>(())
    /// ```
    pub fn vdi(&self) -> &'static str {
        ["R", "U", "G", "B"][self.kind()]
    }

    fn kind(&self) -> usize {
        let moves = usize::from(self.at.v.abs() > REST);
        let accelerates = usize::from(self.at.a.abs() > REST);
        2 * moves + accelerates
    }

    /// Name in a language of the neighbours that fit this end ([`End::joins`]).
    pub fn joins_in(&self, language: Language) -> String {
        wording::catalogue(language).text(&format!("joins-{}", self.joins().replace(' ', "-")))
    }
}

/// Peak values of a normalised rise, exact for the continuous law.
///
/// ```
/// use gaitcam::law::Rise;
///
/// // Cycloidal: Cv = 2, Ca = 2π, Cj = 4π².
/// let factors = Rise::Cycloidal.factors()?;
/// let pi = std::f64::consts::PI;
/// assert!((factors.cv - 2.0).abs() < 1e-6);
/// assert!((factors.ca - 2.0 * pi).abs() < 1e-6);
/// assert!((factors.cj - 4.0 * pi * pi).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors {
    /// Maximum of |v| for lift 1 in time 1.
    pub cv: f64,
    /// Maximum of |a| for lift 1 in time 1.
    pub ca: f64,
    /// Maximum of |j| for lift 1 in time 1; infinite if the acceleration jumps between the ends.
    pub cj: f64,
    /// Maximum of |a·v| for lift 1 in time 1.
    pub ct: f64,
    /// Minimum and maximum of v.
    pub v: (f64, f64),
    /// Minimum and maximum of a.
    pub a: (f64, f64),
    /// Minimum and maximum of j, if it exists.
    pub j: (f64, f64),
}

//! Peak factors of a rise, and its continuity with neighbouring segments.

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

    /// Motion at both ends of the normalised rise. It determines which segments can adjoin the rise.
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
    /// Lift (0 or 1) and derivatives v, a and j at the end.
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
    /// Motion at the start of the rise, x = 0.
    pub start: End,
    /// Motion at the end of the rise, x = 1.
    pub end: End,
}

/// Magnitude of a normalised derivative below which it counts as zero.
const REST: f64 = 1e-9;

impl End {
    /// Order of the highest derivative that is continuous if this end adjoins a dwell: 0 = only lift … 3 = jerk.
    pub fn continuity_with_dwell(&self) -> usize {
        [self.at.v, self.at.a, self.at.j]
            .iter()
            .position(|x| x.abs() > REST)
            .unwrap_or(3)
    }

    /// Segments that fit an end of a rise. The four entries are for an end without velocity and acceleration, with acceleration only, with velocity
    /// only, and with both.
    pub const JOINS: [&'static str; 4] = [
        "dwell",
        "return of equal acceleration",
        "constant velocity",
        "nothing but a general polynomial",
    ];

    /// Segment that can adjoin this end with continuous v and a, as an English phrase from [`End::JOINS`].
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

    /// Segment that fits this end ([`End::joins`]), as text in a language.
    pub fn joins_in(&self, language: Language) -> String {
        wording::catalogue(language).text(&format!("joins-{}", self.joins().replace(' ', "-")))
    }
}

/// Peak values of a normalised rise, exact for the continuous law. They refer to a rise by 1 over x from 0 to 1.
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
    /// Peak velocity Cv: maximum of |v|.
    pub cv: f64,
    /// Peak acceleration Ca: maximum of |a|.
    pub ca: f64,
    /// Peak jerk Cj: maximum of |j|. It is infinite if the acceleration jumps between the ends.
    pub cj: f64,
    /// Factor Ct of the inertia torque: maximum of |a·v|.
    pub ct: f64,
    /// Minimum and maximum velocity v.
    pub v: (f64, f64),
    /// Minimum and maximum acceleration a.
    pub a: (f64, f64),
    /// Minimum and maximum jerk inside the spans. Jumps of the acceleration are not included.
    pub j: (f64, f64),
}

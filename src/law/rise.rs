//! Catalogue of motions from one lift to another. They are normalised: s increases from 0 to 1 while x increases from 0 to 1.
//!
//! Peak factors (theory §7): a rise by h over the angle β has the peak velocity Cv·h/β, the peak acceleration Ca·h/β² and the peak jerk Cj·h/β³. The
//! factor Ct = max|a·v| scales the inertia torque.

mod ends;
mod formula;
mod shapes;
mod user;

pub use ends::{End, Ends, Factors};

use super::{Condition, Law, Svaj, hermite_birkhoff};
use crate::error::{Error, LawError, Result};
use crate::wording::{called_in_spanish, nearest_in_languages};
use std::f64::consts::PI;
use std::mem::discriminant;

/// A motion from one lift to another.
///
/// ```
/// use gaitcam::law::Rise;
///
/// assert_eq!(Rise::Cycloidal.name(), "cycloidal");
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Rise {
    /// A dwell: constant lift.
    #[default]
    Dwell,
    /// Constant velocity: a straight line.
    ConstantVelocity,
    /// Parabolic: constant acceleration, then constant deceleration.
    Parabolic,
    /// The cubic 3x² − 2x³.
    Cubic,
    /// Simple harmonic: ½(1 − cos πx).
    SimpleHarmonic,
    /// Double harmonic: ½[(1 − cos πx) − ¼(1 − cos 2πx)]. The acceleration vanishes only at the low end. A fall is the mirror image.
    DoubleHarmonic,
    /// Cycloidal: x − sin(2πx)/2π.
    Cycloidal,
    /// First quarter period of a harmonic: at rest at x = 0, v = π/2 at x = 1.
    SemiharmonicStart,
    /// Last quarter period of a harmonic: v = π/2 at x = 0, at rest at x = 1.
    SemiharmonicEnd,
    /// First half of a cycloid: at rest at x = 0, v = 2 at x = 1. CAM-DAS prints π/2, the value of the semiharmonic (theory §5).
    SemicycloidalStart,
    /// Second half of a cycloid: v = 2 at x = 0, at rest at x = 1.
    SemicycloidalEnd,
    /// Modified trapezoid: trapezoidal acceleration whose corners are rounded by sines.
    ModifiedTrapezoid,
    /// Modified sine: the acceleration consists of two sines with different periods.
    ModifiedSine,
    /// SCCA: the acceleration consists of sine, constant and cosine, with free fractions of the length, b + c + d = 1.
    Scca {
        /// Fraction b of the length: both sine parts together.
        b: f64,
        /// Fraction c of the length: both parts of constant acceleration together.
        c: f64,
        /// Fraction d of the length: the cosine part in the middle.
        d: f64,
    },
    /// Polynomial 3-4-5: 10x³ − 15x⁴ + 6x⁵.
    Poly345,
    /// Polynomial 4-5-6-7: 35x⁴ − 84x⁵ + 70x⁶ − 20x⁷.
    Poly4567,
    /// Polynomial 5-6-7-8-9: 126x⁵ − 420x⁶ + 540x⁷ − 315x⁸ + 70x⁹.
    Poly56789,
    /// A polynomial of degree 5 or 7 that continues the motion of its neighbours. Degree 5 matches s, v and a at both ends. Degree 7 also
    /// matches j. Between dwells it equals polynomial 3-4-5 or 4-5-6-7.
    Polynomial {
        /// Degree of the polynomial: 5 or 7.
        degree: usize,
    },
    /// Polynomial of Berzak: 12.1x³ − 25.5x⁴ + 24.9x⁵ − 14.7x⁶ + 4.2x⁷ (Bautista Morelos 2018).
    BerzakD,
    /// Gutman 1-3: x − (15/32π) sin 2πx − (1/96π) sin 6πx.
    Gutman13,
    /// Freudenstein 1-3 as commonly printed: x − (27/56π)(sin 2πx + sin(6πx)/54). Its velocity at both ends is −1/56, so it cannot join a dwell.
    /// [`Rise::Freudenstein13AtRest`] is the corrected form.
    Freudenstein13,
    /// Freudenstein 1-3, corrected to be at rest at both ends: x − (27/56π)(sin 2πx + sin(6πx)/81).
    Freudenstein13AtRest,
    /// Freudenstein 1-3-5: x − (α/2π)(sin 2πx + sin(6πx)/54 + sin(10πx)/1250), α = 1125/1192.
    Freudenstein135,
    /// Half a turn of an eccentric disc. A fall is the mirror image of a rise.
    Eccentric {
        /// (Disc radius + roller radius) / eccentricity; infinite for a flat face.
        ratio: f64,
    },
    /// A motion defined by the user as a table, see [`Rise::table`].
    User {
        /// Name of the table in messages.
        name: String,
        /// Text of the motion in a scene, in the form that [`Rise::from_name`] reads.
        written: String,
        /// The law over x from 0 to 1, with the lift from 0 to 1.
        law: Box<Law>,
        /// Rows (x, s) of the table, normalised so that x and s go from 0 to 1.
        rows: Vec<(f64, f64)>,
        /// Half a unit of the last decimal of the lifts, relative to the total lift. It is at most 0.001.
        rounding: f64,
    },
}

/// All motions that need no user data, with their names in a scene file. SCCA is included with b = c = ¼, d = ½, and the eccentric with an infinite
/// ratio.
#[rustfmt::skip]
static CATALOGUE: [(&str, Rise); 24] = [
    ("constant-velocity",        Rise::ConstantVelocity),
    ("parabolic",                Rise::Parabolic),
    ("cubic",                    Rise::Cubic),
    ("simple-harmonic",          Rise::SimpleHarmonic),
    ("double-harmonic",          Rise::DoubleHarmonic),
    ("cycloidal",                Rise::Cycloidal),
    ("semiharmonic-start",       Rise::SemiharmonicStart),
    ("semiharmonic-end",         Rise::SemiharmonicEnd),
    ("semicycloidal-start",      Rise::SemicycloidalStart),
    ("semicycloidal-end",        Rise::SemicycloidalEnd),
    ("modified-trapezoid",       Rise::ModifiedTrapezoid),
    ("modified-sine",            Rise::ModifiedSine),
    ("scca",                     Rise::Scca { b: 0.25, c: 0.25, d: 0.5 }),
    ("3-4-5",                    Rise::Poly345),
    ("4-5-6-7",                  Rise::Poly4567),
    ("5-6-7-8-9",                Rise::Poly56789),
    ("polynomial-5",             Rise::Polynomial { degree: 5 }),
    ("polynomial-7",             Rise::Polynomial { degree: 7 }),
    ("berzak-d",                 Rise::BerzakD),
    ("gutman-1-3",               Rise::Gutman13),
    ("freudenstein-1-3",         Rise::Freudenstein13),
    ("freudenstein-1-3-at-rest", Rise::Freudenstein13AtRest),
    ("freudenstein-1-3-5",       Rise::Freudenstein135),
    ("eccentric",                Rise::Eccentric { ratio: f64::INFINITY }),
];

impl Rise {
    /// All motions that need no user data. SCCA is included with b = c = ¼, d = ½, and the eccentric with an infinite ratio.
    pub fn catalogue() -> Vec<Rise> {
        CATALOGUE.iter().map(|row| row.1.clone()).collect()
    }

    /// Name of the motion in a scene file.
    pub fn name(&self) -> &str {
        match self {
            Rise::Dwell => "dwell",
            Rise::User { name, .. } => name,
            Rise::Polynomial { degree } if *degree != 5 => "polynomial-7",
            rise => (CATALOGUE.iter())
                .find(|row| discriminant(&row.1) == discriminant(rise))
                .map_or("", |row| row.0),
        }
    }

    /// Name of the motion with its parameters, in the form that [`Rise::from_name`] reads.
    pub fn written(&self) -> String {
        match self {
            Rise::Scca { b, c, d } => format!("scca {b} {c} {d}"),
            Rise::Eccentric { ratio } if ratio.is_finite() => format!("eccentric {ratio}"),
            Rise::User { written, .. } => written.clone(),
            other => other.name().to_string(),
        }
    }

    /// The motion with a name of the catalogue in English or Spanish, or `dwell`. The letters `R` and `G` denote rest and constant velocity, as in
    /// VDI 2143.
    ///
    /// Parameters can follow the name: `scca 0.25 0.25 0.5` (b, c, d), `eccentric 4` (ratio), or `table 0 0 0.5 0.3 1 1` (pairs of x and s, at rest
    /// at both ends).
    ///
    /// # Errors
    ///
    /// - The name is unknown. The error suggests the most similar name.
    /// - Parameters are not numbers, too many, or out of range.
    /// - A file is given instead of numbers. [`scene::with_motions`](crate::scene::with_motions) reads such files.
    pub fn from_name(text: &str) -> Result<Rise> {
        if let Some(file) = Rise::named_file(text) {
            let (motion, file) = ("table".to_string(), file.to_string());
            return Err(LawError::MotionFile { motion, file }.into());
        }
        let mut words = text
            .split(|c: char| c.is_whitespace() || c == ',')
            .filter(|w| !w.is_empty());
        let word = words.next().unwrap_or("").to_lowercase().replace('_', "-");
        let word = of_vdi(&word).map_or(word, str::to_string);
        let names = names();
        if word != "table" && !names.contains(&word.as_str()) {
            return match called_in_spanish(text, &names) {
                Some(own) => Rise::from_name(own),
                None => Err(unknown(text.trim()).into()),
            };
        }
        let fault = |w: &str| LawError::Parameter {
            word: w.to_string(),
            motion: word.clone(),
        };
        let numbers = words.map(|w| w.parse().map_err(|_| fault(w)));
        let numbers = numbers.collect::<std::result::Result<Vec<f64>, LawError>>()?;
        if word == "table" && !numbers.is_empty() {
            return Rise::of_numbers(&numbers);
        }
        let found = Rise::catalogue()
            .into_iter()
            .chain([Rise::Dwell])
            .find(|r| r.name() == word)
            .ok_or_else(|| Error::from(unknown(&word)))?;
        let rise = match (found, numbers.as_slice()) {
            (found, []) => found,
            (Rise::Scca { .. }, &[b, c, d]) => Rise::Scca { b, c, d },
            (Rise::Eccentric { .. }, &[ratio]) => Rise::Eccentric { ratio },
            (found, given) => {
                return Err(LawError::Parameters {
                    motion: found.name().to_string(),
                    given: given.len(),
                }
                .into());
            }
        };
        rise.law()?;
        Ok(rise)
    }

    /// The normalised law of the rise, from 0 to 1 over x ∈ [0, 1]. For a dwell, the lift is 0.
    ///
    /// # Errors
    ///
    /// Parameters are out of range.
    pub fn law(&self) -> Result<Law> {
        Ok(match self {
            Rise::Dwell => shapes::power(&[0.0]),
            Rise::ConstantVelocity => shapes::power(&[0.0, 1.0]),
            Rise::Parabolic => shapes::parabolic(),
            Rise::Cubic => shapes::power(&[0.0, 0.0, 3.0, -2.0]),
            Rise::SimpleHarmonic => shapes::simple_harmonic(),
            Rise::DoubleHarmonic => {
                shapes::line_and_waves(0.375, 0.0, &[(PI, -0.5, 0.0), (2.0 * PI, 0.125, 0.0)])
            }
            Rise::Cycloidal => shapes::sine_series(&[(1.0, 0.5 / PI)]),
            Rise::SemiharmonicStart => shapes::line_and_waves(1.0, 0.0, &[(0.5 * PI, -1.0, 0.0)]),
            Rise::SemiharmonicEnd => shapes::line_and_waves(0.0, 0.0, &[(0.5 * PI, 0.0, 1.0)]),
            Rise::SemicycloidalStart => shapes::line_and_waves(0.0, 1.0, &[(PI, 0.0, -1.0 / PI)]),
            Rise::SemicycloidalEnd => shapes::line_and_waves(0.0, 1.0, &[(PI, 0.0, 1.0 / PI)]),
            Rise::ModifiedTrapezoid => shapes::scca(0.25, 0.5, 0.25)?,
            Rise::ModifiedSine => shapes::scca(0.25, 0.0, 0.75)?,
            Rise::Scca { b, c, d } => shapes::scca(*b, *c, *d)?,
            Rise::Poly345 => shapes::power(&[0.0, 0.0, 0.0, 10.0, -15.0, 6.0]),
            Rise::Poly4567 => shapes::power(&[0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0]),
            Rise::Poly56789 => {
                shapes::power(&[0.0, 0.0, 0.0, 0.0, 0.0, 126.0, -420.0, 540.0, -315.0, 70.0])
            }
            Rise::Polynomial { degree } => {
                let rest = Svaj::default();
                let top = Svaj { s: 1.0, ..rest };
                Law::from_poly(joining(*degree, rest, top, 1.0)?, false)
            }
            Rise::BerzakD => shapes::power(&[0.0, 0.0, 0.0, 12.1, -25.5, 24.9, -14.7, 4.2]),
            Rise::Gutman13 => {
                shapes::sine_series(&[(1.0, 15.0 / (32.0 * PI)), (3.0, 1.0 / (96.0 * PI))])
            }
            Rise::Freudenstein13 => {
                let a = 27.0 / (56.0 * PI);
                shapes::sine_series(&[(1.0, a), (3.0, a / 54.0)])
            }
            Rise::Freudenstein13AtRest => {
                let a = 27.0 / (56.0 * PI);
                shapes::sine_series(&[(1.0, a), (3.0, a / 81.0)])
            }
            Rise::Freudenstein135 => {
                let a = 1125.0 / (2384.0 * PI);
                shapes::sine_series(&[(1.0, a), (3.0, a / 54.0), (5.0, a / 1250.0)])
            }
            Rise::Eccentric { ratio } => shapes::eccentric(*ratio)?,
            Rise::User { law, .. } => (**law).clone(),
        })
    }

    /// Whether a fall is the mirror image of the rise in x. Otherwise a fall is the rise multiplied by −1.
    pub(super) fn mirrors(&self) -> bool {
        matches!(self, Rise::DoubleHarmonic | Rise::Eccentric { .. })
    }

    /// Degree of a general polynomial, whose shape depends on its neighbours; `None` for other motions.
    pub(super) fn general_degree(&self) -> Option<usize> {
        match self {
            Rise::Polynomial { degree } => Some(*degree),
            _ => None,
        }
    }
}

/// Names of the motions in the catalogue, and `dwell`.
fn names() -> Vec<&'static str> {
    let catalogue = CATALOGUE.iter().map(|row| row.0);
    catalogue.chain(["dwell"]).collect()
}

/// Name of the motion for a segment that VDI 2143 denotes by one letter: R for rest, G for constant velocity.
fn of_vdi(word: &str) -> Option<&'static str> {
    match word {
        "r" => Some("dwell"),
        "g" => Some("constant-velocity"),
        _ => None,
    }
}

/// Names of the motions whose ends have the two letters of a word such as `R-U` (VDI 2143); `None` for other words.
fn between_ends(word: &str) -> Option<Vec<String>> {
    let letters: Vec<String> = (word.chars().filter(|c| !"-–_ ".contains(*c)))
        .map(|c| c.to_uppercase().to_string())
        .collect();
    let [start, end] = &letters[..] else {
        return None;
    };
    if !letters.iter().all(|l| "RGUB".contains(l.as_str())) {
        return None;
    }
    let fits = |rise: &Rise| {
        rise.ends()
            .is_ok_and(|ends| [ends.start.vdi(), ends.end.vdi()] == [start, end])
    };
    let laws = CATALOGUE.iter().filter(|row| fits(&row.1));
    Some(laws.map(|row| row.0.to_string()).collect())
}

fn unknown(word: &str) -> LawError {
    let motion = word.to_string();
    if let Some(laws) = between_ends(word) {
        return LawError::MotionType { motion, laws };
    }
    if word == "table" {
        return LawError::MotionNeedsPoints { motion };
    }
    let mut names = names();
    names.push("table");
    LawError::UnknownMotion {
        motion,
        nearest: nearest_in_languages(word, &names).map(str::to_string),
        catalogue: names.iter().map(|n| (*n).to_string()).collect(),
    }
}

/// Polynomial over [0, width] with prescribed s, v, a at both ends. For degree 7, j is also prescribed.
pub(super) fn joining(
    degree: usize,
    before: Svaj,
    after: Svaj,
    width: f64,
) -> Result<crate::poly::PiecewisePoly> {
    let orders = match degree {
        5 => 3,
        7 => 4,
        _ => return Err(LawError::GeneralDegree { degree }.into()),
    };
    let mut conditions = Vec::with_capacity(2 * orders);
    for (theta, at) in [(0.0, before), (width, after)] {
        let values = [at.s, at.v, at.a, at.j];
        conditions.extend((0..orders).map(|order| Condition {
            theta,
            order,
            value: values[order],
        }));
    }
    hermite_birkhoff(&conditions, 0.0, width)
}

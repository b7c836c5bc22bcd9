//! Keys for a population of walkers: objective over their force errors, and adjustment of the machine for each walker.

use std::str::FromStr;

use crate::error::{Error, SceneError, nearest};
use crate::units::{Dimension, parse};

/// Objective over the force errors of several walkers.
///
/// ```
/// use gaitcam::scene::Robust;
///
/// assert_eq!("cvar 0.9".parse::<Robust>()?, Robust::Tail(0.9));
/// assert_eq!(Robust::Worst.to_string(), "worst");
/// assert!("best".parse::<Robust>().is_err());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Robust {
    /// Mean square of the force errors of all walkers.
    #[default]
    Mean,
    /// Maximum force error over the walkers.
    Worst,
    /// Mean square force error of the worst walkers (conditional value at risk). The number is the fraction of the walkers that are not counted.
    Tail(f64),
}

impl std::fmt::Display for Robust {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Robust::Mean => f.write_str("mean"),
            Robust::Worst => f.write_str("worst"),
            Robust::Tail(part) => write!(f, "cvar {part}"),
        }
    }
}

impl FromStr for Robust {
    type Err = Error;

    fn from_str(typed: &str) -> Result<Robust, Error> {
        let plain = typed.trim().to_lowercase();
        let part = plain.strip_prefix("cvar").map(str::trim);
        let part = part.and_then(|p| {
            parse(p, Dimension::Percent)
                .or(parse(p, Dimension::Ratio))
                .ok()
        });
        match (plain.as_str(), part.filter(|p| (0.0..1.0).contains(p))) {
            ("mean", _) => Ok(Robust::Mean),
            ("worst", _) => Ok(Robust::Worst),
            (_, Some(part)) => Ok(Robust::Tail(part)),
            _ => {
                let typed = typed.to_string();
                Err(SceneError::NotRobust { typed }.into())
            }
        }
    }
}

/// Measure of the force errors of several walkers.
///
/// ```
/// use gaitcam::scene::ErrorMeasure;
///
/// assert_eq!(ErrorMeasure::ALL.map(ErrorMeasure::name), ["relative", "absolute"]);
/// assert_eq!(ErrorMeasure::Absolute.suffix(), "n");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum ErrorMeasure {
    /// Errors in percent of each walker's mean force.
    #[default]
    Relative,
    /// Errors in newtons, which give more weight to heavy walkers.
    Absolute,
}

impl ErrorMeasure {
    /// All measures, for keys and help texts.
    pub const ALL: [ErrorMeasure; 2] = [ErrorMeasure::Relative, ErrorMeasure::Absolute];

    /// Name of the measure in a scene file.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Suffix of column names for errors in this measure, which denotes the unit.
    pub fn suffix(self) -> &'static str {
        match self {
            ErrorMeasure::Relative => "percent",
            ErrorMeasure::Absolute => "n",
        }
    }
}

/// Quantities of the machine that are adjusted for each walker.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Adjust {
    /// Whether the moved mass is adjusted.
    pub mass: bool,
    /// Whether the speed of the cam is adjusted.
    pub speed: bool,
    /// Whether the phase of the walker's cycle at cam angle 0 is adjusted.
    pub phase: bool,
}

/// Names of the quantities that can be adjusted.
const ADJUSTED: [&str; 4] = ["mass", "speed", "phase", "none"];

impl Adjust {
    /// Reads the names of the adjusted quantities. The name `"none"` means that nothing is adjusted.
    ///
    /// # Errors
    ///
    /// A word is unknown.
    pub fn of(words: &[String]) -> Result<Adjust, Error> {
        let mut out = Adjust::default();
        for word in words.iter().flat_map(|w| w.split(',')).map(str::trim) {
            match word {
                "mass" => out.mass = true,
                "speed" => out.speed = true,
                "phase" => out.phase = true,
                "none" => {}
                _ => {
                    return Err(SceneError::UnknownWord {
                        word: word.to_string(),
                        nearest: nearest(word, ADJUSTED).map(str::to_string),
                        known: ADJUSTED.join(", "),
                    }
                    .into());
                }
            }
        }
        Ok(out)
    }

    /// Names of the adjusted quantities, as written in a scene.
    pub fn words(self) -> Vec<String> {
        let all = [
            (self.mass, "mass"),
            (self.speed, "speed"),
            (self.phase, "phase"),
        ];
        let words = all.into_iter().filter(|w| w.0).map(|w| w.1.to_string());
        let words: Vec<String> = words.collect();
        if words.is_empty() {
            vec!["none".to_string()]
        } else {
            words
        }
    }
}

/// Step frequencies of several walkers with the same load model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepFrequencies {
    /// First and last frequency, Hz, and number of equally spaced frequencies.
    Range(f64, f64, usize),
    /// Normal distribution with a mean and a standard deviation, Hz.
    Normal(f64, f64),
}

/// Number of frequencies that represent a normal distribution.
const POINTS: usize = 21;
const REACH: f64 = 2.5;
/// Maximum number of frequencies in a range.
const MOST_POINTS: usize = 2000;

impl StepFrequencies {
    /// Step frequencies, Hz, each with its weight. The weights are not normalised.
    pub fn points(self) -> Vec<(f64, f64)> {
        let place = |i: usize, n: usize| i as f64 / (n - 1) as f64;
        match self {
            StepFrequencies::Range(from, to, n) => {
                let at = |i| from + (to - from) * place(i, n);
                let mut all: Vec<(f64, f64)> = (0..n).map(|i| (at(i), 1.0)).collect();
                all[n - 1].0 = to;
                all
            }
            StepFrequencies::Normal(mean, deviation) => {
                let z = |i| REACH * (2.0 * place(i, POINTS) - 1.0);
                let of = |z: f64| (mean + z * deviation, libm::exp(-0.5 * z * z));
                (0..POINTS).map(|i| of(z(i))).collect()
            }
        }
    }

    /// Whether the text of the key denotes several step frequencies.
    pub fn is_meant(typed: &str) -> bool {
        typed.contains(':') || typed.trim_start().starts_with("normal")
    }
}

impl std::fmt::Display for StepFrequencies {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            StepFrequencies::Range(from, to, n) => write!(f, "{from} Hz:{to} Hz:{n}"),
            StepFrequencies::Normal(mean, deviation) => {
                write!(f, "normal {mean} Hz {deviation} Hz")
            }
        }
    }
}

impl FromStr for StepFrequencies {
    type Err = Error;

    fn from_str(typed: &str) -> Result<StepFrequencies, Error> {
        let hertz = |text: &str| {
            let value = parse(text.trim(), Dimension::Frequency).ok();
            value.filter(|x| *x > 0.0)
        };
        let parts: Vec<&str> = typed.split(':').collect();
        let read = match (parts.as_slice(), typed.trim().strip_prefix("normal")) {
            (_, Some(both)) => {
                let both = both.trim();
                // "1.87 Hz 0.19 Hz": the first quantity ends before the second number.
                let cut = both.match_indices(' ').map(|m| m.0).find(|i| {
                    let rest = both[*i..].trim_start();
                    *i > 0 && rest.starts_with(|c: char| c.is_ascii_digit())
                });
                cut.and_then(|i| {
                    Some(StepFrequencies::Normal(
                        hertz(&both[..i])?,
                        hertz(&both[i..])?,
                    ))
                })
            }
            ([from, to, n], None) => hertz(from).zip(hertz(to)).and_then(|(from, to)| {
                let n = n
                    .trim()
                    .parse()
                    .ok()
                    .filter(|n| (2..=MOST_POINTS).contains(n))?;
                (from < to).then_some(StepFrequencies::Range(from, to, n))
            }),
            _ => None,
        };
        read.ok_or_else(|| {
            let typed = typed.to_string();
            SceneError::NotFrequencies { typed }.into()
        })
    }
}

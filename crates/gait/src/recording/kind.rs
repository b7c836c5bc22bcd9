//! Kinds of recorded movement, and open questions about a recording.

use serde::Serialize;
use strum::{EnumString, IntoStaticStr, VariantArray, VariantNames};

use crate::error::{Error, ForceError, Result};

/// Kind of movement in a recording, such as walking or running.
///
/// ```
/// use gaitcam_gait::Kind;
///
/// assert_eq!("running".parse::<Kind>()?, Kind::Running);
/// assert_eq!(Kind::SitToStand.name(), "sit-to-stand");
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[derive(EnumString, IntoStaticStr, VariantArray, VariantNames)]
#[strum(serialize_all = "kebab-case", parse_err_ty = Error, parse_err_fn = unknown_kind)]
#[non_exhaustive]
pub enum Kind {
    /// Walking: the duty factor is 52 to 75 %, and at least one foot is always on the ground.
    Walking,
    /// Running: the duty factor is below one half, and there is a flight phase.
    Running,
    /// Standing: the force on the plates is almost equal to the weight all the time.
    Standing,
    /// Jumping: both feet leave the ground at the same time.
    Jumping,
    /// Sit-to-stand: rising from a seat, or sitting down. The force on the plates changes between a fraction of the weight and the whole
    /// weight.
    SitToStand,
    /// Any other movement, for which no mean cycle is computed.
    Other,
}

impl Kind {
    /// All kinds of movement, in the order of declaration.
    pub const ALL: &'static [Kind] = <Kind as VariantArray>::VARIANTS;

    /// Name of the kind in scenes, options and JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

fn unknown_kind(word: &str) -> Error {
    let word = word.to_string();
    ForceError::UnknownKind { word }.into()
}

/// Question about a recording that only the user can answer.
///
/// ```
/// use gaitcam_gait::OpenQuestion;
///
/// assert_eq!(OpenQuestion::list("mass, clock")?, [OpenQuestion::Mass, OpenQuestion::Clock]);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[derive(EnumString, IntoStaticStr, VariantNames)]
#[strum(serialize_all = "kebab-case", parse_err_ty = Error, parse_err_fn = unknown_question)]
pub enum OpenQuestion {
    /// Whether the kind of movement is correct.
    Kind,
    /// Whether the duration of a stride is correct.
    Clock,
    /// Whether the mass of the walker is correct, because the mass scales the forces.
    Mass,
    /// Whether the readings are clipped below the peaks of the force. A recording with this question cannot be accepted.
    Clipped,
}

impl OpenQuestion {
    /// Name of the question in scenes and JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Whether the user may accept a recording in which this question is open.
    pub fn is_acceptable(self) -> bool {
        self != OpenQuestion::Clipped
    }

    /// Parses a list of questions that may be accepted, such as `kind, clock, mass`.
    ///
    /// # Errors
    ///
    /// The list contains a word other than `kind`, `clock` and `mass`.
    pub fn list(words: &str) -> Result<Vec<OpenQuestion>> {
        let parts = words.split([',', ' ']).filter(|w| !w.is_empty());
        let accepted = |word: &str| {
            let question: OpenQuestion = word.parse()?;
            let accepted = question.is_acceptable().then_some(question);
            accepted.ok_or_else(|| unknown_question(word))
        };
        parts.map(accepted).collect()
    }
}

fn unknown_question(word: &str) -> Error {
    let word = word.to_string();
    ForceError::UnknownDoubt { word }.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_and_lists_of_doubts_are_read_and_others_refused() {
        for &kind in Kind::ALL {
            assert_eq!(kind.name().parse::<Kind>(), Ok(kind));
        }
        assert_eq!("sit-to-stand".parse(), Ok(Kind::SitToStand));
        assert!("dancing".parse::<Kind>().is_err());
        let all = OpenQuestion::list("kind, clock,mass").unwrap();
        let names: Vec<&str> = all.into_iter().map(OpenQuestion::name).collect();
        assert_eq!(names, OpenQuestion::VARIANTS[..3]);
        assert!(OpenQuestion::list("clipped").is_err());
        assert_eq!(OpenQuestion::list("").unwrap(), []);
        assert!(OpenQuestion::list("time").is_err());
    }
}

//! Faults in the input: what is wrong, where it is, and what would be right.
//!
//! An error is data: a place and a kind with fields. Each area of the library has a file here with its kinds;
//! their sentences stand in `wording/en/AREA.ftl`, the cure as the attribute `.help`. A bad cam is not an error but a [`Verdict`](crate::cam::Verdict), an impossible one is an
//! [`Infeasible`](crate::synth::Infeasible) answer, and a panic is our own bug.

mod cam;
mod dynamics;
mod file;
mod force;
mod law;
mod place;
mod read;
mod scene;
mod sweep;
mod synth;
mod units;
mod write;

use std::fmt;

use serde::Serialize;

use crate::wording::{self, Language};

pub use cam::{ArmFault, CamError, CamLength};
pub use dynamics::DynamicsError;
pub use file::FileError;
pub use force::ForceError;
pub use law::{JoinCure, LawError, SegmentName};
pub use place::{Place, Placed};
pub use read::{CycleColumn, FileKind, ReadError};
pub use scene::SceneError;
pub use sweep::SweepError;
pub use synth::SynthError;
pub use units::UnitsError;
pub use write::WriteError;

/// What kind of fault it is, with its data.
///
/// Each kind has a code (`law-uncovered`) that scripts and tests compare; sentences may change.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::error::ErrorKind;
/// use gaitcam::law::Law;
/// use gaitcam::wording::Language;
///
/// let follower = Follower::FlatTranslating { base_radius: -0.02 };
/// let error = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), follower).unwrap_err();
/// assert!(matches!(error.kind, ErrorKind::Cam(_)));
/// assert_eq!(error.kind.code(), "cam-not-positive");
/// assert!(!error.kind.sentence(Language::Es).is_empty());
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum ErrorKind {
    /// In a quantity with a unit.
    Units(UnitsError),
    /// In the lengths of a cam or its follower.
    Cam(CamError),
    /// In what a simulation is given.
    Dynamics(DynamicsError),
    /// In a file that is read or a folder of results.
    File(FileError),
    /// In a force curve, a load model or a mean cycle.
    Force(ForceError),
    /// In a motion, a programme or a polynomial of conditions.
    Law(LawError),
    /// In a file of force.
    Read(ReadError),
    /// In a scene file.
    Scene(SceneError),
    /// In a sweep.
    Sweep(SweepError),
    /// In what a design is asked for.
    Synth(SynthError),
    /// In a file that is written.
    Write(WriteError),
    /// Of a caller with sentences of its own.
    Own {
        /// The caller's code.
        code: String,
        /// What is wrong.
        what: String,
        /// What would be right.
        help: Option<String>,
    },
}

impl From<CamError> for Error {
    fn from(kind: CamError) -> Error {
        Error::from(ErrorKind::Cam(kind))
    }
}

impl From<DynamicsError> for Error {
    fn from(kind: DynamicsError) -> Error {
        Error::from(ErrorKind::Dynamics(kind))
    }
}

impl From<UnitsError> for Error {
    fn from(kind: UnitsError) -> Error {
        Error::from(ErrorKind::Units(kind))
    }
}

impl From<ForceError> for Error {
    fn from(kind: ForceError) -> Error {
        Error::from(ErrorKind::Force(kind))
    }
}

impl From<LawError> for Error {
    fn from(kind: LawError) -> Error {
        Error::from(ErrorKind::Law(kind))
    }
}

impl From<SweepError> for Error {
    fn from(kind: SweepError) -> Error {
        Error::from(ErrorKind::Sweep(kind))
    }
}

impl From<ReadError> for Error {
    fn from(kind: ReadError) -> Error {
        Error::from(ErrorKind::Read(kind))
    }
}

impl ErrorKind {
    /// What is wrong, in a language.
    pub fn sentence(&self, language: Language) -> String {
        match self {
            ErrorKind::Units(e) => wording::sentence(language, "units", e),
            ErrorKind::Cam(e) => wording::sentence(language, "cam", e),
            ErrorKind::Dynamics(e) => wording::sentence(language, "dynamics", e),
            ErrorKind::File(e) => wording::sentence(language, "file", e),
            ErrorKind::Force(e) => wording::sentence(language, "force", e),
            ErrorKind::Law(e) => wording::sentence(language, "law", e),
            ErrorKind::Read(e) => wording::sentence(language, "read", e),
            ErrorKind::Scene(e) => wording::sentence(language, "scene", e),
            ErrorKind::Sweep(e) => wording::sentence(language, "sweep", e),
            ErrorKind::Synth(e) => wording::sentence(language, "synth", e),
            ErrorKind::Write(e) => wording::sentence(language, "write", e),
            ErrorKind::Own { what, .. } => what.clone(),
        }
    }

    /// What would be right, in a language.
    pub fn help(&self, language: Language) -> Option<String> {
        match self {
            ErrorKind::Units(e) => wording::help(language, "units", e),
            ErrorKind::Cam(e) => wording::help(language, "cam", e),
            ErrorKind::Dynamics(e) => wording::help(language, "dynamics", e),
            ErrorKind::File(e) => wording::help(language, "file", e),
            ErrorKind::Force(e) => wording::help(language, "force", e),
            ErrorKind::Law(e) => wording::help(language, "law", e),
            ErrorKind::Read(e) => wording::help(language, "read", e),
            ErrorKind::Scene(e) => wording::help(language, "scene", e),
            ErrorKind::Sweep(e) => wording::help(language, "sweep", e),
            ErrorKind::Synth(e) => wording::help(language, "synth", e),
            ErrorKind::Write(e) => wording::help(language, "write", e),
            ErrorKind::Own { help, .. } => help.clone(),
        }
    }

    /// The code: area and variant in kebab-case.
    pub fn code(&self) -> String {
        match self {
            ErrorKind::Units(e) => wording::code("units", e),
            ErrorKind::Cam(e) => wording::code("cam", e),
            ErrorKind::Dynamics(e) => wording::code("dynamics", e),
            ErrorKind::File(e) => wording::code("file", e),
            ErrorKind::Force(e) => wording::code("force", e),
            ErrorKind::Law(e) => wording::code("law", e),
            ErrorKind::Read(e) => wording::code("read", e),
            ErrorKind::Scene(e) => wording::code("scene", e),
            ErrorKind::Sweep(e) => wording::code("sweep", e),
            ErrorKind::Synth(e) => wording::code("synth", e),
            ErrorKind::Write(e) => wording::code("write", e),
            ErrorKind::Own { code, .. } => code.clone(),
        }
    }
}

/// A fault in the input: where, and what kind.
///
/// Displays as one English line: `walk.csv line 41: time goes backwards (0.312 s after 0.318 s); …`.
///
/// ```
/// use gaitcam::error::{Error, Place};
/// use gaitcam::force::{Feet, model};
///
/// let error = model("yung", Some(1.85), 700.0, Feet::Both).unwrap_err();
/// assert_eq!((error.place.clone(), error.kind.code()), (Place::Unplaced, "force-misspelt-model".to_string()));
/// assert!(error.to_string().contains("young"));
/// // Callers may have faults of their own.
/// assert_eq!(Error::own("no-cam", "there is no cam").what(), "there is no cam");
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Error {
    /// Where the fault is.
    pub place: Place,
    /// What is wrong.
    pub kind: ErrorKind,
}

/// Result of everything that reads input.
///
/// ```
/// use gaitcam::error::Result;
/// use gaitcam::units::{Dimension, parse};
///
/// fn diameter(text: &str) -> Result<f64> {
///     Ok(2.0 * parse(text, Dimension::Length)?)
/// }
/// assert_eq!(diameter("20 mm")?, 0.04);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub type Result<T> = std::result::Result<T, Error>;

impl From<ErrorKind> for Error {
    fn from(kind: ErrorKind) -> Error {
        Error {
            place: Place::Unplaced,
            kind,
        }
    }
}

impl Error {
    /// A fault with a code and a sentence of the caller's own.
    pub fn own(code: impl Into<String>, what: impl Into<String>) -> Self {
        Error::from(ErrorKind::Own {
            code: code.into(),
            what: what.into(),
            help: None,
        })
    }

    /// Places the fault, unless a more exact place is already known.
    #[must_use]
    pub fn at(mut self, place: Place) -> Self {
        if self.place == Place::Unplaced {
            self.place = place;
        }
        self
    }

    /// Places the fault anew.
    #[must_use]
    pub fn placed(mut self, place: Place) -> Self {
        self.place = place;
        self
    }

    /// What would be right, in English.
    pub fn cure(&self) -> Option<String> {
        self.kind.help(Language::En)
    }

    /// What is wrong, without the place, in English.
    pub fn what(&self) -> String {
        self.kind.sentence(Language::En)
    }

    /// Place, fault and cure as one line.
    pub fn sentence(&self, language: Language) -> String {
        let what = self.kind.sentence(language);
        match self.kind.help(language) {
            None => format!("{}{what}", self.place),
            Some(help) => format!("{}{what}; {help}", self.place),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence(Language::En))
    }
}

impl std::error::Error for Error {}

/// The candidate nearest to `word` by edit distance, if one is within typing distance.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    candidates
        .into_iter()
        .map(|c| (strsim::damerau_levenshtein(word, c), c))
        .filter(|(d, c)| *d <= 1 + c.len().max(word.len()) / 3)
        .min_by_key(|(d, _)| *d)
        .map(|(_, c)| c)
}

//! Published load models, each with its formula, source and reliability.

use strum::IntoStaticStr;

/// Reliability of the coefficients of a load model, by the way in which they were obtained.
///
/// ```
/// use gaitcam_gait::{Status, catalogue};
///
/// let young = catalogue().iter().find(|model| model.name == "young").unwrap();
/// assert!([Status::Seen, Status::Recalled, Status::Mixed].contains(&young.status));
/// assert_eq!(Status::Seen.name(), "seen");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Status {
    /// The coefficients were read in the publication or in the source code of the model.
    Seen,
    /// The coefficients are quoted from memory and should be verified before they are cited.
    Recalled,
    /// Some coefficients were read, and others are quoted from memory. `ModelInfo::source` describes which.
    Mixed,
}

impl Status {
    /// Name of the reliability in tables: `seen`, `recalled` or `mixed`.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Load model in the catalogue: its name, formula, source, reliability and frequency range.
///
/// ```
/// use gaitcam_gait::catalogue;
///
/// // Li et al. (2010) describe the force of one foot, Young (2001) the sum of both feet.
/// let single = |name| catalogue().iter().find(|model| model.name == name).unwrap().single_foot;
/// assert!(single("li-2010") && !single("young"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelInfo {
    /// Name in scenes, for example `young`.
    pub name: &'static str,
    /// Formula with its coefficients. f is the step frequency, Hz, and G the body weight, N.
    pub formula: &'static str,
    /// Publication that describes the model.
    pub source: &'static str,
    /// Reliability of the coefficients.
    pub status: Status,
    /// Minimum and maximum step frequency for which gaitcam uses the model, Hz.
    pub frequency_hz: (f64, f64),
    /// Whether the model describes one foot (`true`) or both feet together (`false`).
    pub single_foot: bool,
}

pub(super) const CATALOGUE: &[ModelInfo] = &[
    ModelInfo {
        name: "blanchard",
        formula: "a1 = 0.257 (180 N at G = 700 N)",
        source: "Blanchard et al. 1977, BS 5400",
        status: Status::Recalled,
        frequency_hz: (0.5, 4.0),
        single_foot: false,
    },
    ModelInfo {
        name: "bachmann",
        formula: "a1 = 0.4 at 2.0 Hz rising to 0.5 at 2.4 Hz (held outside), a2 = a3 = 0.1, phi2 = phi3 = pi/2",
        source: "Bachmann & Ammann 1987; phases seen, amplitudes recalled",
        status: Status::Mixed,
        frequency_hz: (0.5, 4.0),
        single_foot: false,
    },
    ModelInfo {
        name: "setra",
        formula: "a1 = 0.4, a2 = a3 = 0.1, phi1 = 0, phi2 = phi3 = pi/2",
        source: "SETRA 2006, section 3.2.1",
        status: Status::Seen,
        frequency_hz: (0.5, 4.0),
        single_foot: false,
    },
    ModelInfo {
        name: "rebelo",
        formula: "a1 = 0.43 f - 0.38, a2 = 0.15 f - 0.125 above 1.5 Hz (0 below), a3 = 0.1; phases not given, taken as 0",
        source: "Rebelo et al. 2005, table 1; its quoting source warns that the values are very high",
        status: Status::Seen,
        frequency_hz: (1.0, 2.5),
        single_foot: false,
    },
    ModelInfo {
        name: "kerr",
        formula: "a1 = -0.2649 f^3 + 1.3206 f^2 - 1.7597 f + 0.7613, a2 = 0.07, a3 = 0.05; phases not given, taken as 0",
        source: "Kerr 1998",
        status: Status::Recalled,
        frequency_hz: (1.0, 2.8),
        single_foot: false,
    },
    ModelInfo {
        name: "young",
        formula: "a1 = 0.37 (f - 0.95) <= 0.5, a2 = 0.054 + 0.0044 (2f), a3 = 0.026 + 0.0050 (3f), a4 = 0.010 + 0.0051 (4f); phases not given, taken as those of sci-p354",
        source: "Young 2001 (Arup), mean values",
        status: Status::Recalled,
        frequency_hz: (1.0, 2.8),
        single_foot: false,
    },
    ModelInfo {
        name: "young-design",
        formula: "a1 = 0.41 (f - 0.95) <= 0.56, a2 = 0.069 + 0.0056 (2f), a3 = 0.033 + 0.0064 (3f), a4 = 0.013 + 0.0065 (4f); phases not given, taken as those of sci-p354",
        source: "Young 2001, CCIP-016, design values (25 % chance of exceedance); also in three public programs",
        status: Status::Recalled,
        frequency_hz: (1.0, 2.8),
        single_foot: false,
    },
    ModelInfo {
        name: "sci-p354",
        formula: "a1 = 0.436 (f - 0.95), a2 = 0.006 (2f + 12.3), a3 = 0.007 (3f + 5.2), a4 = 0.007 (4f + 2.0); added phases 0, -pi/2, pi, pi/2",
        source: "SCI P354, table 3.1 (two independent public implementations)",
        status: Status::Seen,
        frequency_hz: (1.0, 2.8),
        single_foot: false,
    },
    ModelInfo {
        name: "iso-10137",
        formula: "a1 = 0.37 (f - 1.0), a2 = 0.1, a3 = a4 = a5 = 0.06; phases not given, taken as 0",
        source: "ISO 10137:2007",
        status: Status::Recalled,
        frequency_hz: (1.0, 2.5),
        single_foot: false,
    },
    ModelInfo {
        name: "li-2010",
        formula: "F/G = sum An sin(n pi t / Te), Te = 1/(0.76 f); A1 = -0.0698 f + 1.211, A2 = 0.1052 f - 0.1284, A3 = 0.3002 f - 0.1534, A4 = 0.0416 f - 0.0288, A5 = -0.0275 f + 0.0608",
        source: "Li, Fan, Nie, Li, Chen 2010, J. Sound Vib. 329:4068; two feet carry 1.015-1.027 G on average for 1.6-2.2 Hz",
        status: Status::Recalled,
        frequency_hz: (1.3, 2.5),
        single_foot: true,
    },
    ModelInfo {
        name: "iso-22675",
        formula: "sixth-degree polynomial in t over one stance of 600 ms, divided by F1cmax (given as the body weight); without a step frequency one cycle lasts 1 s",
        source: "ISO 22675, as given in a public implementation that cites pages 32-33 of the standard",
        status: Status::Seen,
        frequency_hz: (0.5, 3.3),
        single_foot: true,
    },
];

/// All load models, each with formula, source and reliability.
pub fn catalogue() -> &'static [ModelInfo] {
    CATALOGUE
}

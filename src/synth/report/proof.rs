//! Whether a law is proved optimal within its family, and the reason if it is not.

use serde::Serialize;
use strum::VariantNames;

use crate::synth::qp::Certificate;
use crate::wording::{self, Language};

/// Reason why a law is not certified as the optimum.
///
/// ```
/// use gaitcam::synth::Doubt;
/// use gaitcam::wording::Language;
///
/// assert!(Doubt::Local.sentence(Language::En).contains("local"));
/// assert_eq!(serde_json::to_value(Doubt::TouchingAngle).unwrap(), "touching-angle");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Doubt {
    /// A limit is violated by more than the solver's tolerance.
    Limits,
    /// The duality gap or the gradient of the Lagrangian is above 1e-6.
    Gap,
    /// The touching angle on the base circle is the result of a search without a proof.
    TouchingAngle,
    /// A sequence of convex programs ends in a local optimum.
    Local,
    /// No law was found that satisfies the non-convex limits, so the law was computed without these limits.
    LeftOut,
    /// The motion of shaft or floor was fixed. Laws with other machine motions were not compared.
    FixedMotion,
}

impl Doubt {
    /// Clause of a message that describes the reason.
    pub fn sentence(self, language: Language) -> String {
        wording::sentence(language, "doubt", &self)
    }
}

/// Reason why a certificate does not prove that the law is optimal; `None` if it does.
pub fn doubt(certificate: &Certificate) -> Option<Doubt> {
    if !certificate.keeps_limits() {
        Some(Doubt::Limits)
    } else if certificate.proves_optimum() {
        None
    } else {
        Some(Doubt::Gap)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_is_proved_only_by_limits_gap_and_gradient_together() {
        let of = |violation: f64, relative_gap: f64, stationarity: f64| {
            doubt(&Certificate {
                duality_gap: relative_gap,
                relative_gap,
                global_gap: Some(relative_gap),
                size: 1.0,
                stationarity,
                violation,
            })
        };
        assert_eq!(of(4e-10, 1e-6, 1e-6), None);
        assert_eq!(of(5e-10, 0.0, 0.0), Some(Doubt::Limits));
        assert_eq!(of(5e-10, 1e-3, 1e-3), Some(Doubt::Limits));
        assert_eq!(of(0.0, 1.1e-6, 0.0), Some(Doubt::Gap));
        assert_eq!(of(0.0, 0.0, 1.1e-6), Some(Doubt::Gap));
    }

    #[test]
    fn every_doubt_has_its_own_clause() {
        let every = Doubt::VARIANTS.len();
        for language in [Language::En, Language::Es] {
            let of = |d: Doubt| d.sentence(language);
            let clauses = [
                of(Doubt::Limits),
                of(Doubt::Gap),
                of(Doubt::TouchingAngle),
                of(Doubt::Local),
                of(Doubt::LeftOut),
                of(Doubt::FixedMotion),
            ];
            let distinct: std::collections::HashSet<_> = clauses.iter().collect();
            assert!(distinct.len() == every && clauses.iter().all(|c| c.len() > 10));
        }
    }
}

//! Whether a law is proved optimal within its family, and if not, why.

use serde::Serialize;
use strum::VariantNames;

use crate::synth::qp::Certificate;
use crate::wording::{self, Language};

/// Why a law is not certified to be the optimum.
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
    /// A limit is exceeded by more than the solver's tolerance.
    Limits,
    /// The duality gap, or what the multipliers leave of the gradient, is above 1e-6.
    Gap,
    /// Where the law touches its base circle was searched for, not proved.
    TouchingAngle,
    /// A sequence of convex programs ends at a local optimum.
    Local,
    /// No law was found that keeps the limits that are not convex: they are left out.
    LeftOut,
    /// The motion of shaft or floor was held fixed: laws that give the machine another motion are not compared.
    FixedMotion,
}

impl Doubt {
    /// The reason as a clause.
    pub fn sentence(self, language: Language) -> String {
        wording::sentence(language, "doubt", &self)
    }
}

/// What stands between a certificate and a proof.
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

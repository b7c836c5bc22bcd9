//! Keys that are understood but count for nothing in this scene: they are said, not refused, so that a
//! sweep over families or followers can leave them standing.

use super::{Family, Scene};
use crate::cam::FollowerKind;

impl Scene {
    /// One remark for each key that changes nothing here.
    pub fn ignored(&self) -> Vec<String> {
        let law = &self.law;
        let family = law.family;
        let fitted = matches!(family, Family::Auto | Family::Ladder | Family::Spline);
        let polynomial = family == Family::Polynomial;
        let harmonic = matches!(family, Family::Auto | Family::Ladder | Family::Harmonic);
        let of_law = [
            ("law.spans", law.spans.is_some(), fitted),
            ("law.degree", law.degree.is_some(), fitted || polynomial),
            ("law.harmonics", law.harmonics.is_some(), harmonic),
            ("law.minimise", law.minimise.is_some(), fitted),
            ("law.monotone", law.monotone, fitted),
            ("law.point", !law.points.is_empty(), fitted || polynomial),
            ("law.dwell", !law.dwells.is_empty(), fitted),
            (
                "law.segment",
                !law.segments.is_empty(),
                family == Family::Program,
            ),
        ];
        let mut out: Vec<String> = of_law
            .into_iter()
            .filter(|(_, given, counts)| *given && !counts)
            .map(|(key, ..)| {
                format!(
                    "{key} changes nothing: a law of family {} has none",
                    family.name()
                )
            })
            .collect();
        if self.cam.follower == FollowerKind::FlatTranslating
            && self.cam.offset.is_some_and(|e| e != 0.0)
        {
            out.push(
                "cam.offset changes nothing: a flat face is the same on every line beside the cam's centre"
                    .to_string(),
            );
        }
        if self.rms.is_some() && self.gait.is_none() {
            out.push("accuracy.rms changes nothing: no force is wanted".to_string());
        }
        out
    }
}

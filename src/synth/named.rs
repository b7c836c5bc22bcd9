//! What the name of a limit or of a check stands for: its key in the scene, its dimension, its unit.

use crate::cam::{Measures, Unit};
use crate::scene::LimitKind;
use crate::scene::keys::{self, Key};
use crate::units::Dimension;

/// Checks of the second cam of a pair have its first cam's names behind this.
const SECOND: &str = "second_";

/// A check or row that is no limit of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::EnumString)]
#[strum(serialize_all = "snake_case")]
enum Beside {
    RmsError,
    Band,
    BaseCircle,
    Bore,
    Concave,
    Interference,
    UpperWall,
    LowerWall,
}

impl Beside {
    fn dimension(self, measures: Measures) -> Dimension {
        let oscillating = measures == Measures::Oscillating;
        match self {
            Beside::RmsError | Beside::Band if oscillating => Dimension::Torque,
            Beside::RmsError | Beside::Band => Dimension::Force,
            Beside::BaseCircle if oscillating => Dimension::Angle,
            Beside::BaseCircle
            | Beside::Bore
            | Beside::Concave
            | Beside::Interference
            | Beside::UpperWall
            | Beside::LowerWall => Dimension::Length,
        }
    }
}

/// The row behind the name of a limit, or behind a key.
fn row(name: &str) -> Option<&'static Key> {
    LimitKind::named(name)
        .and_then(keys::of_limit)
        .or_else(|| keys::find(key_of(name)))
}

/// The key that sets what a row or a relaxation is named after, as typed after `--set`; empty where none does.
pub fn key_of(name: &str) -> &'static str {
    if let Some(key) = LimitKind::named(name).and_then(keys::of_limit) {
        return key.path;
    }
    match name {
        "bore" => "cam.bore",
        "band" => "gait.band",
        "rms_error" => "accuracy.rms",
        path => keys::find(path).map_or("", |key| key.path),
    }
}

/// The name of a key among conflicts and relaxations: that of its limit where it sets one.
pub fn name_of(key: &Key) -> &'static str {
    match (key.limit, key.path) {
        (Some(kind), _) => kind.name(),
        (None, "cam.bore") => "bore",
        (None, path) => path,
    }
}

/// What a limit or check measures, by its name in `summary.json`; a plain number where the name is not known.
pub fn dimension(measures: Measures, name: &str) -> Dimension {
    let name = name.strip_prefix(SECOND).unwrap_or(name);
    if let Ok(beside) = name.parse::<Beside>() {
        return beside.dimension(measures);
    }
    row(name)
        .and_then(Key::measure)
        .map_or(Dimension::Ratio, |m| m.of(measures))
}

/// The unit in which people give a limit or check.
pub fn unit(measures: Measures, name: &str) -> Unit {
    Unit::of(dimension(measures, name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_limit_has_a_key_with_its_unit() {
        for &kind in LimitKind::ALL {
            let key = keys::of_limit(kind).unwrap_or_else(|| panic!("{kind:?} has no row"));
            assert_eq!(key.name(), kind.name());
            assert_eq!(key_of(kind.name()), key.path);
            assert!(key.relax.is_some(), "{kind:?} has no direction");
            assert_eq!(LimitKind::named(kind.name()), Some(kind));
            assert_ne!(
                unit(Measures::Translating, kind.name()).name,
                "",
                "{kind:?}"
            );
        }
        let limits = keys::KEYS.iter().filter(|k| k.limit.is_some()).count();
        assert_eq!(limits, LimitKind::ALL.len());
    }

    #[test]
    fn an_arm_has_angles_and_moments() {
        let shown = |m: Measures, name: &str, x: f64| {
            let u = unit(m, name);
            u.after(&format!("{:.4}", u.factor * x))
        };
        let ten = 10_f64.to_radians();
        let (arm, slide) = (Measures::Oscillating, Measures::Translating);
        assert_eq!(shown(arm, "stroke", ten), "10.0000°");
        assert_eq!(shown(slide, "stroke", 0.01), "10.0000 mm");
        assert_eq!(shown(arm, "jerk", 9.0), "9.0000 rad/s³");
        assert_eq!(shown(Measures::Straight, "jerk", 9.0), "9.0000 m/s³");
        assert_eq!(shown(arm, "force_min", 2.0), "2.0000 N·m");
        assert_eq!(shown(arm, "rms_error", 2.0), "2.0000 N·m");
        assert_eq!(shown(arm, "second_curvature", 2e-3), "2.0000 mm");
        assert_eq!(shown(arm, "cam.prime_radius", 2e-3), "2.0000 mm");
        assert_eq!(shown(slide, "bore", 2e-3), "2.0000 mm");
        assert_eq!(shown(slide, "accuracy.rms", 0.05), "5.0000 %");
        assert_eq!(shown(slide, "hertz_pressure", 5e8), "500.0000 MPa");
        assert_eq!(shown(slide, "pressure_angle_rise", ten), "10.0000°");
        assert_eq!(shown(slide, "spans", 8.0), "8.0000");
    }
}

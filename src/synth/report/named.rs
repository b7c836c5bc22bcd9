//! Key, dimension and unit of a criterion.

use crate::cam::{Criterion, LimitKind, Measures, Unit};
use crate::scene::keys::{self, Key};
use crate::units::Dimension;

/// Criteria that are not limits, with the keys of the scene that set their values.
const KEYS: [(Criterion, &str); 7] = [
    (Criterion::Bore, "cam.bore"),
    (Criterion::BaseRadius, "cam.base_radius"),
    (Criterion::GivenPrimeRadius, "cam.prime_radius"),
    (Criterion::Inertia, "machine.inertia"),
    (Criterion::Accuracy, "accuracy.rms"),
    (Criterion::RmsError, "accuracy.rms"),
    (Criterion::Band, "gait.band"),
];

/// Key of the scene that sets the value of a criterion, as used with `--set`; empty if there is no such key.
pub fn key_of(criterion: Criterion) -> &'static str {
    if let Some(key) = criterion.limit().and_then(keys::of_limit) {
        return key.path;
    }
    let found = KEYS.iter().find(|k| k.0 == criterion);
    found.map_or("", |k| k.1)
}

/// Criterion of a relaxable key in conflicts and suggested changes; `None` if the key has no criterion.
pub fn criterion_of(key: &Key) -> Option<Criterion> {
    let beside = || KEYS.iter().find(|k| k.1 == key.path).map(|k| k.0);
    key.limit.map(Criterion::Limit).or_else(beside)
}

/// Physical dimension of the value of a criterion. `measures` is the kind of motion.
pub fn dimension(measures: Measures, criterion: Criterion) -> Dimension {
    let oscillating = measures == Measures::Oscillating;
    let of_limit = |kind: LimitKind| {
        let measure = keys::of_limit(kind).and_then(Key::measure);
        measure.map_or(Dimension::Ratio, |m| m.of(measures))
    };
    match criterion {
        Criterion::Limit(kind) => of_limit(kind),
        Criterion::SecondCurvature => of_limit(LimitKind::Curvature),
        Criterion::SecondDiameter => of_limit(LimitKind::Diameter),
        Criterion::SecondPressureAngleRise | Criterion::SecondPressureAngleFall => Dimension::Angle,
        Criterion::RmsError | Criterion::Band if oscillating => Dimension::Torque,
        Criterion::RmsError | Criterion::Band => Dimension::Force,
        Criterion::BaseCircle if oscillating => Dimension::Angle,
        Criterion::BaseCircle
        | Criterion::Bore
        | Criterion::BaseOutsideBore
        | Criterion::BaseRadius
        | Criterion::GivenPrimeRadius
        | Criterion::Concave
        | Criterion::SecondConcave
        | Criterion::Interference
        | Criterion::SecondInterference
        | Criterion::UpperWall
        | Criterion::LowerWall => Dimension::Length,
        Criterion::Accuracy => Dimension::Percent,
        Criterion::Inertia => Dimension::Inertia,
        Criterion::Monotone | Criterion::Peak => Dimension::Ratio,
    }
}

/// Displayed unit of the value of a criterion.
pub fn unit(measures: Measures, criterion: Criterion) -> Unit {
    Unit::of(dimension(measures, criterion))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_limit_has_a_key_with_its_unit() {
        for &kind in LimitKind::ALL {
            let key = keys::of_limit(kind).unwrap_or_else(|| panic!("{kind:?} has no row"));
            assert_eq!(key.name(), kind.name());
            assert_eq!(key_of(kind.into()), key.path);
            assert!(key.relax.is_some(), "{kind:?} has no direction");
            assert_eq!(LimitKind::named(kind.name()), Some(kind));
            let unit = unit(Measures::Translating, kind.into());
            assert_ne!(unit.name, "", "{kind:?}");
        }
        let limits = keys::KEYS.iter().filter(|k| k.limit.is_some()).count();
        assert_eq!(limits, LimitKind::ALL.len());
    }

    #[test]
    fn every_key_that_may_be_relaxed_has_a_criterion() {
        for key in keys::relaxable() {
            let criterion = criterion_of(key).unwrap_or_else(|| panic!("{} has none", key.path));
            assert_eq!(key_of(criterion), key.path);
        }
    }

    #[test]
    fn an_arm_has_angles_and_moments() {
        let shown = |m: Measures, criterion: Criterion, x: f64| {
            let u = unit(m, criterion);
            u.after(&format!("{:.4}", u.factor * x))
        };
        let ten = 10_f64.to_radians();
        let (arm, slide) = (Measures::Oscillating, Measures::Translating);
        let limit = Criterion::Limit;
        assert_eq!(shown(arm, limit(LimitKind::Stroke), ten), "10.0000°");
        assert_eq!(shown(slide, limit(LimitKind::Stroke), 0.01), "10.0000 mm");
        assert_eq!(shown(arm, limit(LimitKind::Jerk), 9.0), "9.0000 rad/s³");
        let straight = shown(Measures::Straight, limit(LimitKind::Jerk), 9.0);
        assert_eq!(straight, "9.0000 m/s³");
        assert_eq!(shown(arm, limit(LimitKind::ForceMin), 2.0), "2.0000 N·m");
        assert_eq!(shown(arm, Criterion::RmsError, 2.0), "2.0000 N·m");
        assert_eq!(shown(arm, Criterion::SecondCurvature, 2e-3), "2.0000 mm");
        assert_eq!(shown(arm, Criterion::GivenPrimeRadius, 2e-3), "2.0000 mm");
        assert_eq!(shown(slide, Criterion::Bore, 2e-3), "2.0000 mm");
        assert_eq!(shown(slide, Criterion::Accuracy, 0.05), "5.0000 %");
        let pressure = shown(slide, limit(LimitKind::HertzPressure), 5e8);
        assert_eq!(pressure, "500.0000 MPa");
        let angle = shown(slide, limit(LimitKind::PressureAngleRise), ten);
        assert_eq!(angle, "10.0000°");
    }
}

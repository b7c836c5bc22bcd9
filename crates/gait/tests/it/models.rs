//! Check that the curves in data/gait_curves agree with their models, and that SOURCES.md agrees with the catalogue.

use std::path::{Path, PathBuf};

use gaitcam_gait::units::LBF;
use gaitcam_gait::{Feet, ReadOptions, catalogue, force_curve, model};

#[path = "../../examples/gait_curves.rs"]
#[allow(dead_code)]
mod gait_curves;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/gait_curves")
}

#[test]
fn owned_curves_read_back_as_their_models() {
    for (file, name, frequency, load, feet) in gait_curves::CURVES {
        let path = folder().join(file);
        let bytes = std::fs::read(&path).unwrap();
        let read = force_curve(&path, &bytes, &ReadOptions::default(), Feet::Both).unwrap();
        let made = model(name, *frequency, *load, *feet).unwrap();
        assert_eq!(read.period_s, made.period_s, "{file}");
        // The files hold every digit, so only another libm can differ.
        let pairs = read.force_n.iter().zip(&made.force_n);
        let worst = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(
            worst < 1e-9 && read.force_n.len() == made.force_n.len(),
            "{file}: {worst}"
        );
    }
}

#[test]
fn the_heel_tester_meets_its_critical_points() {
    // theory §2 (Vargas and León 2024): pounds at seconds, zero from 0.356 s to 0.500 s.
    let path = folder().join("heel_tester_critical_points.csv");
    let bytes = std::fs::read(&path).unwrap();
    let c = force_curve(&path, &bytes, &ReadOptions::default(), Feet::Both).unwrap();
    assert_eq!(c.period_s, 0.5);
    let n = c.force_n.len();
    let near = |t: f64| c.force_n[(t / 0.5 * n as f64).round() as usize % n] / LBF;
    // A sample lies within a quarter of a millisecond of the point, where the curve is level.
    let points = [
        (0.0, 0.0),
        (0.079, 110.282),
        (0.172, 79.338),
        (0.276, 106.667),
        (0.356, 0.0),
        (0.45, 0.0),
    ];
    for (t, f) in points {
        assert!((near(t) - f).abs() < 0.02, "{t}: {}", near(t));
    }
    let highest = 110.282 * LBF + 1e-9;
    assert!(c.force_n.iter().all(|f| (-1e-9..=highest).contains(f)));
}

#[test]
fn sources_md_repeats_every_model_with_its_status() {
    let text = std::fs::read_to_string(folder().join("SOURCES.md")).unwrap();
    for m in catalogue() {
        let row = format!(
            "| {} | {} | {} | {} |",
            m.name,
            m.formula,
            m.source,
            m.status.name()
        );
        assert!(text.contains(&row), "SOURCES.md lacks: {row}");
    }
}

//! A cycle that is written as an OpenSim file and read again is unchanged.

use std::path::Path;

use gaitcam_gait::{Feet, Foot, ReadOptions, force_curve, model};

#[test]
fn a_cycle_in_the_layout_of_opensim_reads_back_as_itself() {
    let path = Path::new("walk.mot");
    for (name, feet, foot) in [
        ("young", Feet::Both, None),
        ("li-2010", Feet::One, Some(Foot::Left)),
        ("iso-22675", Feet::One, Some(Foot::Right)),
    ] {
        let mut curve = model(name, Some(1.9), 700.0, feet).unwrap();
        curve.mass_kg = Some(71.4);
        curve.noise_n = Some(2.5);
        let text = curve.to_mot(foot, &["of a test"]);
        let rows = text
            .lines()
            .skip_while(|l| *l != "endheader")
            .skip(2)
            .count();
        assert!(
            text.contains(&format!("nRows={rows}\nnColumns=10\n")),
            "{text:.200}"
        );
        let side = foot.map_or("", |f| if f == Foot::Left { "_l" } else { "_r" });
        assert!(
            text.contains(&format!("\tground_force{side}_vy\t")),
            "{text:.400}"
        );
        let back = force_curve(path, text.as_bytes(), &ReadOptions::default(), Feet::Both).unwrap();
        assert!(back.force_n == curve.force_n, "{name}");
        assert!((back.period_s / curve.period_s - 1.0).abs() < 1e-12);
        assert_eq!((back.mass_kg, back.noise_n), (curve.mass_kg, curve.noise_n));
    }
}

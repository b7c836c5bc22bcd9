//! Chart (e): number of points against the error of the profile cut from them.

use super::Watch;
use crate::chart::{Across, Chart};
use gaitcam::cam::{Cam, Follower};
use gaitcam::error::Result;
use gaitcam::law::{Extent, Rise, Segment, program};
use gaitcam_cad::biarc;
use gaitcam_cad::dxf::FAITHFUL;

/// Number of points between two neighbours at which the chord is compared with the profile.
const BETWEEN: usize = 16;

/// Reference cam of theory §6: dwell-rise-dwell-fall with a roller.
fn cam() -> Result<Cam> {
    let quarter = |motion: Rise, lift: f64| Segment {
        motion,
        lift,
        angle: 0.25 * std::f64::consts::TAU,
    };
    let segments = [
        quarter(Rise::from_name("cycloidal")?, 0.02),
        quarter(Rise::Dwell, 0.0),
        quarter(Rise::from_name("cycloidal")?, -0.02),
        quarter(Rise::Dwell, 0.0),
    ];
    let follower = Follower::RollerTranslating {
        prime_radius: 0.05,
        offset: 0.0,
        roller_radius: 0.01,
    };
    Cam::new(program(&segments, Extent::TURN)?, follower)
}

/// Chart of polylines and arcs of one cam.
pub fn chart(watch: &Watch) -> Result<Chart> {
    let cam = cam()?;
    let mut rows = Vec::new();
    for n in [90, 180, 360, 720, 1440, 3600, 14_400] {
        let (_, timing) = watch.time(|| cam.profile(std::hint::black_box(n)));
        let mut row = timing.row("polyline", format!("{n} points"), chord_error(&cam, n));
        row.points = Some(n);
        if n == 1440 {
            row.note = "profile.csv and profile.svg".to_string();
        }
        rows.push(row);
    }
    for exponent in 3..=8 {
        let tolerance = if exponent == 7 {
            FAITHFUL
        } else {
            10f64.powi(-exponent)
        };
        let (arcs, timing) = watch.time(|| biarc::fit(&cam, std::hint::black_box(tolerance)));
        let Some(arcs) = arcs else { continue };
        let mut row = timing.row(
            "biarcs",
            format!("tolerance 1e-{exponent} m"),
            arcs.deviation,
        );
        row.points = Some(arcs.vertices.len());
        row.default = tolerance == FAITHFUL;
        if row.default {
            row.note = "profile.dxf".to_string();
        }
        rows.push(row);
    }
    Ok(Chart {
        file: "speed_accuracy_e".to_string(),
        title: "(e) Profile for the machine".to_string(),
        task: "Roller cam of 40 mm base radius, 20 mm cycloidal rise and fall: distance between the true profile and the path of the machine.".to_string(),
        error: "largest distance from the true profile, m".to_string(),
        across: Across::Points,
        levels: vec![
            (1e-5, "grinding, 10 µm".to_string()),
            (1e-6, "1 µm".to_string()),
        ],
        advice: "Use the arcs of profile.dxf. For 0.1 µm they need a tenth of the points of chords. Use the 1440 points of profile.csv only for a machine without arcs.".to_string(),
        rows,
    })
}

/// Maximum distance of the profile from the polyline of n points at equal angles.
fn chord_error(cam: &Cam, n: usize) -> f64 {
    let step = std::f64::consts::TAU / n as f64;
    let mut worst = 0.0_f64;
    for i in 0..n {
        let (a, b) = (cam.point(step * i as f64), cam.point(step * (i + 1) as f64));
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let length = dx.hypot(dy);
        for k in 1..BETWEEN {
            let p = cam.point(step * (i as f64 + k as f64 / BETWEEN as f64));
            worst = worst.max(((p.x - a.x) * dy - (p.y - a.y) * dx).abs() / length);
        }
    }
    worst
}
